"""The article's own formulas as they are evaluated: ξ(s), y(s), z(ξ) and their constants, in the four load cases.

They are what ``quartic``, ``weierstrass`` and ``shape`` have derived, with the constant γ or γ̄ as one argument and the
logarithms of σ-quotients as differences of ln σ, continued along the rod. The claims that stand for them are those of
the derivation; what is added here is that y with continued logarithms has the slope ξ, and which constant is meant.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from sympy import Expr, Integer, Matrix, Symbol, diff, sqrt

from .claims import Domain, Equal, Formula, Notebook
from .functions import wlog_sigma, wp, wp_prime, wsigma, wzeta
from .load_case import LoadCase
from .shape import WHERE, Shape, b, g2, g3, u_o
from .symbols import beta, eta, gamma, gamma_bar, s, u, v, xi
from .weierstrass import Weierstrass

constant = Symbol("constant", real=True)  # γ, or γ̄ in an orthogonal field
c = Symbol("c", real=True)  # ℘(v)


@dataclass
class Collector:
    """The formulas of one load case, with γ or γ̄ under one name."""

    case: LoadCase
    found: list[Formula] = field(default_factory=list)

    def add(self, name: str, arguments: tuple[Symbol, ...], value: Expr, claim: str, doc: str, source: str) -> None:
        """Record a formula; parameters that the case lacks are no arguments."""
        kept = tuple(a for a in arguments if a not in (beta, eta) or a in self.case.parameters)
        value = value.subs(self.case.constant, constant) if constant in arguments else value
        strange = value.free_symbols - set(kept)
        if strange:
            raise ValueError(f"{self.case.name}: the formula {name} holds {strange}, which are not among its arguments")
        label = self.case.source(source)
        self.found.append(Formula(f"article_{name}", kept, value, claim, doc, self.case.name, label, "article"))


def derive(
    cases: Mapping[str, LoadCase], functions: Mapping[str, Weierstrass], shapes: Mapping[str, Shape], book: Notebook
) -> tuple[Formula, ...]:
    """The article's formulas of all load cases."""
    book.say("Section 3. The article's formulas as they are evaluated")
    _claim_logarithm(book)
    found: list[Formula] = []
    for name, case in cases.items():
        collector = Collector(case)
        _constants(collector, functions[name], book)
        if functions[name].linear is None:
            _shape(collector, book)
        else:
            _linear_shape(collector, functions[name], shapes[name])
        _height(collector, shapes[name])
        found += collector.found
    return tuple(found)


def _constants(collector: Collector, functions: Weierstrass, book: Notebook) -> None:
    """The sense of the field, γ or γ̄, f̂ and its roots, b and c, g₂ and g₃."""
    case, add = collector.case, collector.add
    name, where = f"article.{case.name}", case.domain(gamma=(0, 1), xi=(-1, 1))
    # H = (sense)|H|: which of the article's cases are possible.
    sense = Equal(case.stiffness, case.bends * sqrt(case.stiffness**2))
    steps = case.ids("quartic.levels")
    title = "the sense of the field: 1 if it bends the rod, −1 if it straightens it, 0 without a field"
    claim = book.claim(f"{name}.sense", title, sense, domain=where, steps=steps, source=case.source("quartic"))
    add("sense", (), Integer(case.bends), claim.id, title, "quartic")
    # γ̄ = η − γ, else γ: f̂ with it is γ − 2βξ + 2ψ.
    meant = case.field_work.subs(xi, 0) - gamma if case.constant == gamma_bar else gamma
    levels = Equal(case.f_hat.subs(case.constant, meant), gamma - 2 * case.tip_force * xi - case.field_work)
    title = f"the constant of f̂: {'γ̄ = η − γ' if case.constant == gamma_bar else 'γ'}"
    claim = book.claim(
        f"{name}.constant", title, levels, domain=where, steps=case.ids("quartic.gamma"), source=case.source("quartic")
    )
    add("constant", (eta, gamma), meant, claim.id, title, "first integral")
    rod = (beta, eta, constant)
    add("levels", (*rod, xi), case.f_hat, *case.ids("quartic.gamma"), "f̂(ξ), the square of the curvature", "quartic")
    for letter, root in zip(case.letters, case.roots, strict=True):
        add(f"root_{letter}", rod, root, *case.ids(f"quartic.root_{letter}"), f"ξ_{letter}, a root of f̂", "roots")
    if functions.linear is None:
        at, (stands,) = functions.at_one, case.ids("weierstrass.constants")
        add("b", rod, at.b, stands, "b = f′(a)/4 at a = 1", "at one")
        add("c", rod, at.c, stands, "c = f″(a)/24 at a = 1, the value of ℘ at v", "at one")
    # exsl21: with D = B² + ΓH and m = (Γ + H)/6, g₂ = D + 3m² and g₃ = −m(D − m²).
    level = case.f_hat.subs(xi, 0)
    spread, mean = case.force**2 + level * case.stiffness, (level + case.stiffness) / 6
    g2_printed, g3_printed = spread + 3 * mean**2, -mean * (spread - mean**2)
    same = Equal(Matrix([g2_printed, g3_printed]), Matrix([functions.g2, functions.g3]))
    where, steps, source = case.domain(**{case.constant.name: (0, 1)}), case.ids("weierstrass.at_one"), "invariants"
    title = "g₂ and g₃ by the coefficients of f"
    claim = book.claim(
        f"{name}.invariants", title, same, domain=where, steps=steps, source=case.source("invariants")
    )
    add("g2", rod, g2_printed, claim.id, "g₂ by the coefficients of f", source)
    add("g3", rod, g3_printed, claim.id, "g₃ by the coefficients of f", source)


def _shape(collector: Collector, book: Notebook) -> None:
    """ξ = 1 + b/(℘ − c), and y by ζ(v) and the logarithm, continued (exsl22, exsl36, exhpf15)."""
    case = collector.case
    value = 1 + b / (wp(u, g2, g3) - c)
    solution, title = case.ids("weierstrass.solution"), "cos θ at u = u_o + s"
    collector.add("xi", (b, c, u, g2, g3), value, *solution, title, "solution")
    bending = case.bends == 1
    rate = -1 / sqrt(case.stiffness) if bending else b / wp_prime(v, g2, g3)
    y = (1 + 2 * rate * wzeta(v, g2, g3)) * s - rate * (_quotient(u_o + s) - _quotient(u_o))
    # ln σ has the slope ζ however it is continued, and the sum of ζ is that of exsl34.
    where = Domain({**WHERE.ranges, **case.domain(**{case.constant.name: case.ends}).ranges})
    rational = 1 + b / (wp(u_o + s, g2, g3) - wp(v, g2, g3))
    slope = Equal(diff(y, s), rational)
    given = ((b, -wp_prime(v, g2, g3) / sqrt(case.stiffness)),) if bending else ()
    steps = ("shape.xi", "article.logarithm", *solution, *case.ids("shape.slope" if bending else "weierstrass.slope"))
    title, name = "y at s, with ln σ continued along the rod", f"article.{case.name}"
    source = case.source("y")
    claim = book.claim(f"{name}.y", title, slope, domain=where, given=given, steps=steps, source=source)
    start = Equal(y.subs(s, 0), 0)
    book.claim(f"{name}.y_start", "y(0) = 0", start, domain=where, steps=(claim.id,), source=source)
    collector.add("y", (eta, b, v, u_o, s, g2, g3), y, claim.id, title, "y")


def _quotient(at: Expr) -> Expr:
    """ln σ(u + v) − ln σ(u − v), the logarithm of the article's quotient."""
    return wlog_sigma(at + v, g2, g3) - wlog_sigma(at - v, g2, g3)


def _claim_logarithm(book: Notebook) -> None:
    """ln σ has the derivative σ′/σ, that of any logarithm of σ."""
    same = Equal(diff(wlog_sigma(u, g2, g3), u), diff(wsigma(u, g2, g3), u) / wsigma(u, g2, g3))
    title = "(ln σ)′ = σ′/σ, wherever ln σ is continued to"
    book.claim("article.logarithm", title, same, domain=WHERE, source="DLMF 23.2.8")


def _linear_shape(collector: Collector, functions: Weierstrass, shape: Shape) -> None:
    """ξ linear in ℘, y by a difference of ζ (slch11, slch12)."""
    case, linear = collector.case, functions.linear
    assert linear is not None
    start, rate = linear
    claim, rod = case.ids("weierstrass.linear"), (beta, constant)
    value = start + rate * wp(u, g2, g3)
    collector.add("xi_linear", (*rod, u, g2, g3), value, *claim, "cos θ at u = u_o + s, linear in ℘", "linear")
    claim = case.ids("shape.y")
    collector.add("y_linear", (*rod, u_o, s, g2, g3), shape.y, *claim, "y at s, by a difference of ζ", "y")


def _height(collector: Collector, shape: Shape) -> None:
    """z as a function of ξ while the curvature is positive (exsl41, exhpf19, slch14)."""
    for side, z in shape.z.items():
        suffix = f"_{side}" if side else "" if collector.case.bends else "_linear"
        key = f"shape.z_{side}".rstrip("_")
        doc = "z as a function of ξ, up to a constant, where θ grows"
        collector.add(f"z{suffix}", (beta, eta, constant, xi), z, *collector.case.ids(key), doc, "z")


def main() -> None:
    """Print the derivation up to here."""
    from .chain import print_up_to

    print_up_to("article")


if __name__ == "__main__":
    main()
