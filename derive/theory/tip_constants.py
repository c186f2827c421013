"""Formulas of the tip itself: γ, how fast the curvature leaves zero, f̂, and directions where orbits change kind."""

from __future__ import annotations

from sympy import Poly, cos, diff, expand, sin

from .claims import Equal
from .load_case import COSINES, LoadCase, xi_tip
from .symbols import beta, eta, gamma, gamma_bar, theta, xi
from .tip_names import Writer, drive, drop, gap, level, minus


def write_tip(case: LoadCase, writer: Writer) -> None:
    """Constants of the tip, and f̂."""
    meaning = writer.meaning
    at_tip = {theta: theta, xi_tip: cos(theta)}
    turning = case.angular_acceleration / sin(theta)
    where = case.domain(theta=(0, 3))
    writer.add(
        "tip_drive",
        (beta, eta, xi_tip),
        meaning[drive],
        "θ″(ℓ)/sin θ(ℓ): how fast the curvature leaves zero at the tip",
        lambda value: Equal(value.subs(at_tip), turning),
        where,
        steps=("plane.moment", "quartic.free_end"),
        source="moment",
        gives=drive,
    )
    writer.add(
        "tip_gap",
        (beta, eta, minus),
        writer.named(meaning[gap], minus),
        "−f̂(−1)/(1 + ξ(ℓ)): its sign tells whether the orbit stops before ξ = −1",
        lambda value: Equal(value * (1 + xi_tip), -case.at_tip.subs(xi, -1)),
        steps=("quartic.levels", "quartic.free_end"),
        source="quartic",
        gives=gap,
    )
    constant = {case.constant: case.tip_constant}
    writer.add(
        "tip_gamma",
        (beta, eta, xi_tip),
        expand(case.gamma.subs(constant)),
        "γ of the first integral, such that the curvature vanishes at the tip",
        lambda value: Equal(value, 2 * case.tip_force * xi_tip + case.field_work.subs(xi, xi_tip)),
        steps=("quartic.free_end", "quartic.gamma"),
        source="free end",
        gives=gamma,
    )
    if case.constant == gamma_bar:
        writer.add(
            "tip_gamma_bar",
            (beta, eta, xi_tip),
            case.tip_constant,
            "γ̄ = η − γ of the first integral",
            lambda value: Equal(case.f_hat.subs(xi, xi_tip).subs(gamma_bar, value), 0),
            steps=("quartic.free_end", "quartic.gamma_bar"),
            source="free end",
        )
    height = meaning[level]
    slope = diff(height, xi)
    rest = expand(height - slope * (xi + xi_tip))
    writer.add(
        "point_level",
        (beta, eta, xi_tip, xi),
        rest + slope * (xi + xi_tip),
        "f̂(ξ)/(ξ(ℓ) − ξ)",
        lambda value: Equal(value * (xi_tip - xi), case.at_tip),
        steps=("quartic.levels", "quartic.free_end"),
        source="quartic",
        gives=level,
    )
    squared = writer.named(case.at_tip, drop, level)
    along = {xi: cos(theta)}
    writer.add(
        "curvature_squared",
        (drop, level),
        squared,
        "θ′², the square of the curvature: f̂(ξ)",
        lambda value: Equal(diff(value.subs(meaning).subs(along), theta), 2 * case.angular_acceleration),
        case.domain(theta=(0, 3), xi_tip=COSINES),
        steps=("plane.first_integral", "quartic.gamma"),
        source="first integral",
    )
    free = Equal(squared.subs(meaning).subs(xi, xi_tip), 0)
    steps = ("tip.curvature_squared", "quartic.free_end")
    writer.claim("free_end", "the curvature vanishes at the tip", free, steps=steps, source="free end")


def write_directions(case: LoadCase, writer: Writer) -> None:
    """Directions at which the orbits change kind, and the stiffness of a straight rod."""
    if case.other_root is not None:
        mate = case.other_root
        writer.add(
            "cos_bottom",
            (beta, eta),
            expand(case.vertex),
            "cos θ at which force and field balance, θ″ = 0, off the straight directions",
            lambda value: Equal(diff(case.f_hat, xi).subs(xi, value), 0),
            steps=("quartic.levels", "quartic.motion"),
            source="at double root",
        )
        writer.add(
            "cos_level",
            (beta, eta),
            expand(mate.subs(xi_tip, -1)),
            "cos θ of the tip whose orbit has its other turning point at −1",
            lambda value: Equal(case.at_tip.subs(xi_tip, value).subs(xi, -1), 0),
            steps=("quartic.factors",),
            source="none",
        )
        writer.add(
            "cos_other",
            (beta, eta, xi),
            mate.subs(xi_tip, xi),
            "ξ_o, the other root of f̂ when ξ is one",
            lambda value: Equal(case.at_tip.subs(xi, value.subs(xi, xi_tip)), 0),
            steps=("quartic.factors",),
            source="roots",
        )
    # θ = θ₀ + h with sin θ₀ = 0: h″ = (dθ″/dθ)h.
    slope = Poly(expand(-diff(case.angular_acceleration, theta)), sin(theta))
    even = sum(value * (1 - cos(theta) ** 2) ** (power // 2) for (power,), value in slope.terms())
    second = diff(case.f_hat.subs(xi, cos(theta)), theta, 2) / 2
    writer.add(
        "straight_stiffness",
        (beta, eta, xi),
        expand(even).subs(cos(theta), xi),
        "the coefficient k of h″ + kh = 0 for small rotations h of a straight rod, cos θ = ξ = ±1",
        lambda value: Equal(value.subs(xi, cos(theta)), -second),
        case.domain(theta=(0, 3)),
        steps=("plane.moment", "quartic.motion"),
        source="none",
    )
