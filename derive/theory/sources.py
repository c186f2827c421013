"""Where the article writes what is derived for each load case: labels of its equations, by what they say.

One label stands for all load cases; else there is one for each, empty where the article has none. What the article
does not have at all carries the number of the formula in DLMF, or nothing.
"""

from __future__ import annotations

CASES = ("parallel", "orthogonal", "field_only", "force_only")

SOURCES: dict[str, str | tuple[str, str, str, str]] = {
    "moment": "exsl6",  # θ″, from the equation of moments
    "first integral": ("exsl8", "exhpf1", "exsl8", "slch5"),
    "motion": "exsl12",  # (ξ′)² = f(ξ)
    "angle": "exsl12a",  # ξ = cos θ
    "quartic": ("exsl13", "exhpf2", "slch1", "slch4"),  # f and f̂
    "roots": ("exsl14", "exhpf3", "slch2", "slch4"),  # of f̂; of the cubic, in the text after it
    "free end": ("exsl23", "exhpf12", "slch3", "slch6"),
    "double root": ("exsl24", "exhpf8", "slch3", "slch6"),  # the end of the range where f̂ has one
    "straight rod": ("exsl25", "exhpf8", "slch3", "slch6"),  # the other end
    "order": ("exsl24", "exhpf8", "slch3", "slch6"),  # real distinct roots, and where they lie
    "admissible": ("exsl15", "exhpf4", "exsl15", ""),  # ξ between the roots, or outside
    "at double root": ("exsl26", "exhpf9", "slch3", "slch6"),
    "at straight rod": ("exsl27", "exhpf10", "slch3", "slch6"),
    "expansion": "exsl16",  # ξ = a + b/(ϰ − c) at any root a
    "strength": "exsl17",  # b and c at any root a
    "at one": ("exsl18", "exhpf6", "exsl18", ""),  # the same for a = 1
    "substituted": "exsl19",  # (ξ′)² by (ϰ′)²
    "invariants": ("exsl21", "exhpf7", "exsl21", "slch10"),
    "solution": ("exsl22", "exhpf5", "exsl22", "exsl22"),
    "unknown": "exsl19a",  # ϰ is ℘
    "along the rod": "exsl20",  # with u = u_o + s
    "tip": "exsl30",  # ξ at u = ω̄
    "linear": "slch11",
    "slope at pole": ("exsl29", "exhpf11", "exsl29", "exsl29"),
    "start": ("exsl31", "exhpf12", "exsl31", "slch11"),  # u_o, in the text after it
    "slope on side": ("exsl33", "exhpf13bis", "exsl33", ""),  # ℘′(v), with its sign
    "real slope": "exsl33",
    "xi by zeta": ("exsl35", "exhpf14", "exsl35", ""),
    "y": ("exsl36", "exhpf15", "exsl36", "slch12"),
    "square completed": ("exsl39", "exhpf17", "exsl39", ""),
    "bending": ("exsl37", "", "exsl37", ""),  # ξ′ by z′
    "slope of z": ("exsl38", "exhpf16", "exsl38", "slch13"),
    "integrand": ("exsl40", "exhpf18", "exsl40", ""),  # of z, by the square completed
    "inverse cosine": ("", "exhpf18", "", ""),
    "z": ("exsl41", "exhpf19", "exsl41", "slch14"),
    "inextensible": "exsl4",
    "length": "DLMF 19.25.35",  # u = R_F(℘ − e₁, ℘ − e₂, ℘ − e₃)
    "reduction": "DLMF 19.29(ii)",  # of integrals to R_F, R_D, R_J
    "none": "",
}


def source(case: str, what: str) -> str:
    """The label under which the article says something about a load case."""
    label = SOURCES[what]
    return label if isinstance(label, str) else label[CASES.index(case)]
