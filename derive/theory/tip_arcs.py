"""Lengths and integrals along the rod from the tip, as Carlson's integrals of x = ℘ − e (DLMF 19.16, 19.25, 19.29).

The variable is p = ℘ − c: ξ = ξ(ℓ) + b/p, and dσ = −dp/(2√x₊√x₋√x_o), from σ = 0 at p = ∞. All forms hold up to and at
the next point where the curvature vanishes or the rod is straight up or down: there one x is 0, and no term is
infinite.
"""

from __future__ import annotations

from collections.abc import Mapping

from sympy import Expr, atan, cancel, diff, expand, sqrt

from .claims import Equal
from .functions import RC, RD, RF, RJ
from .load_case import COSINES, LoadCase, xi_tip
from .symbols import beta, eta, gamma, xi
from .tip_along import Along, X
from .tip_names import (
    Writer,
    arc,
    drive,
    gap,
    length,
    minus,
    plus,
    sin_tip,
    square,
    x_minus,
    x_other,
    x_plus,
    x_pole,
    y_tip,
)
from .weierstrass import Expansion


def write_arcs(case: LoadCase, at: Expansion, roots: Mapping[str, Expr], writer: Writer) -> None:
    """arc_length, arc_y, arc_z, arc_square, the angle and the energy of one load case."""
    along = Along(case, at, roots, writer)
    pole = _pole(along)
    _claim_motion(along, pole)
    _write_angle(along)
    along.add(
        "arc_length",
        (x_plus, x_minus, x_other),
        RF(x_plus, x_minus, x_other),
        "σ, the length from the tip to the point",
        x_pole / x_pole,
        source="length",
        gives=arc,
    )
    # y = ∫ξ dσ with ξ = ξ(ℓ) + b/p, and ∫dσ/p = R_J/3.
    inverse = RJ(x_plus, x_minus, x_other, pole) / 3
    strength = writer.named(at.b, plus, minus, drive)
    along.add(
        "arc_y",
        (eta, plus, minus, drive, xi_tip, arc, x_plus, x_minus, x_other),
        xi_tip * arc + strength * inverse,
        "∫cos θ dσ from the tip to the point",
        along.xi,
        steps=("tip.pole", "tip.pole_strength"),
        source="y",
        gives=y_tip,
    )
    # z = ∫ sin θ dσ with sin θ = sin θ(ℓ) √x₊√x₋/p: the roots cancel, and R_C is left.
    other = x_other + writer.named(roots["other"], plus, minus)
    along.add(
        "arc_z",
        (eta, plus, minus, sin_tip, x_other),
        sin_tip * RC(x_other, other),
        "∫sin θ dσ from the tip to the point, before θ passes 0 or π",
        sin_tip * sqrt(x_plus) * sqrt(x_minus) / x_pole,
        steps=("tip.sine", "tip.root_other"),
        source="z",
    )
    if case.bends:
        _write_square(along, inverse, pole)
    _write_energy(case, writer)


def _pole(along: Along) -> Expr:
    """p without cancellation: from x_o if e_o > c, else as the mean of x₊ and x₋ that is free of their roots."""
    if along.case.bends >= 0:
        return x_other + along.writer.named(along.roots["other"], plus, minus)
    # (1 − ξ(ℓ))e₊ + (1 + ξ(ℓ))e₋ = 2c.
    return (minus * x_plus + plus * x_minus) / 2


def _claim_motion(along: Along, pole: Expr) -> None:
    """p is what it is called, (dξ/dσ)² = f, and sin θ by half-angles."""
    writer, case = along.writer, along.case
    sides = tuple(f"tip.root_{side}" for side in X)
    mean = Equal(along.plain(pole), x_pole)
    writer.claim("pole", "℘ − c from the x", mean, along.domain, steps=sides, source="none")
    speed = (diff(along.xi, x_pole) / along.plain(along.rate)) ** 2
    moves = Equal(speed, (case.at_tip * (1 - xi**2)).subs(xi, along.xi))
    steps = ("quartic.motion", "weierstrass.at_tip", "tip.pole_strength", *sides)
    writer.claim("motion", "(dξ/dσ)² = f(ξ)", moves, along.domain, steps=steps, source="motion")
    sine = along.plain(plus * minus * x_plus * x_minus / x_pole**2)
    half_angles, steps = Equal(sine, 1 - along.xi**2), ("tip.pole_strength", *sides[:2])
    writer.claim("sine", "1 − ξ² by x₊ and x₋", half_angles, along.domain, steps=steps, source="none")


def _write_angle(along: Along) -> None:
    """tan²(θ/2) = (1 − ξ)/(1 + ξ), well-conditioned at ξ = ±1, and θ itself."""
    writer = along.writer
    ratio = cancel((1 - along.xi) / (1 + along.xi) * (x_pole - along.roots["minus"]) / (x_pole - along.roots["plus"]))
    tangent = writer.named(ratio, minus, plus) * x_plus / x_minus
    writer.add(
        "half_angle_squared",
        (plus, minus, x_plus, x_minus),
        tangent,
        "tan²(θ/2) at the point",
        lambda value: Equal(along.plain((1 - value) / (1 + value)), along.xi),
        along.domain,
        steps=("tip.pole_strength", "tip.root_plus", "tip.root_minus"),
        source="angle",
    )
    # θ = 2 arctan √(tan²(θ/2)) on the branch from θ(ℓ): its square speed is f̂.
    writer.add(
        "angle",
        (plus, minus, x_plus, x_minus),
        2 * atan(sqrt(tangent)),
        "|θ| at the point, before θ passes 0 or π",
        lambda value: Equal(
            (diff(along.plain(value), x_pole) / along.plain(along.rate)) ** 2, along.case.at_tip.subs(xi, along.xi)
        ),
        along.domain,
        steps=("tip.half_angle_squared", "tip.motion", "tip.curvature_squared"),
        source="angle",
    )


def _write_square(along: Along, inverse: Expr, pole: Expr) -> None:
    """−2∫ψ dσ = ∫W(ξ) dσ with W = W(ξ(ℓ)) + W′b/p + Hb²/p², and Hb² = ℘′(v)² = −4(e₊ − c)(e₋ − c)(e_o − c).

    d/dσ of √x_j√x_k/(p√x_i) removes 1/p²; of the three roots, i is the one that no point of the rod reaches.
    """
    writer, case, at, r = along.writer, along.case, along.at, along.roots
    i, j, k = ("plus", "minus", "other") if case.bends == 1 else ("other", "plus", "minus")
    work = case.field_work
    pairs = r[i] * r[j] + r[j] * r[k] + r[k] * r[i]
    # With r = e − c and P = r_ir_j + r_jr_k + r_kr_i:
    # ∫Hb²/p² dσ = −2r_i√x_j√x_k/(p√x_i) + 2r_iσ + 2(e_i − e_j)(e_i − e_k)R_D/3 − 2P·R_J/3.
    of_arc = cancel(work.subs(xi, xi_tip) + 2 * r[i])
    of_inverse = cancel(diff(work, xi).subs(xi, xi_tip) * at.b - 2 * pairs)
    of_second = cancel(2 * (r[i] - r[j]) * (r[i] - r[k]))
    second = RD(X[j], X[k], X[i]) / 3
    edge = sqrt(X[j]) * sqrt(X[k]) / (pole * sqrt(X[i]))

    def named(value: Expr) -> Expr:
        return writer.named(value, plus, minus, drive, gap)

    integral = named(of_arc) * arc + named(of_inverse) * inverse + named(of_second) * second - named(2 * r[i]) * edge
    along.add(
        "arc_square",
        (beta, eta, plus, minus, drive, gap, xi_tip, arc, x_plus, x_minus, x_other),
        integral,
        f"−2∫ψ dσ = ∫({work}) dσ from the tip to the point",
        work.subs(xi, along.xi),
        steps=("tip.pole", "tip.pole_strength", *(f"tip.root_{side}" for side in X), "quartic.gamma"),
        source="reduction",
        gives=square,
    )


def _write_energy(case: LoadCase, writer: Writer) -> None:
    """∫(½θ′² + ψ − βξ)dσ by θ′² = γ − 2βξ + 2ψ."""
    bending = (gamma * length - 2 * case.tip_force * y_tip - square) / 2
    total = expand(bending - square / 2 - case.tip_force * y_tip)
    work = case.field_work
    total, arguments = (total, (square,)) if case.bends else (total.subs(square, 0), ())
    local = {length: 1, y_tip: xi, square: work, gamma: case.gamma}
    density = case.f_hat / 2 - work / 2 - case.tip_force * xi
    writer.add(
        "rod_energy",
        (beta, gamma, length, y_tip, *arguments),
        total,
        "energy of the rod over EI: bending, field and force",
        lambda value: Equal(value.subs(local), density),
        case.domain(xi=COSINES, **{case.constant.name: (0, 1)}),
        steps=("plane.energy", "quartic.gamma"),
        source="first integral",
    )
