"""Readings for z(s): along a stretch of the rod on which the curvature has one sign and ξ is on one side of the roots.

There κ_x = ±√f̂(ξ), z′ = sin θ, which may have either sign, and ξ′ = −κ_x sin θ.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from sympy import Expr, Integer, Symbol, acos, oo, sqrt

from derive.check import meaning as m
from derive.check.on_rod import OnRod, Y, Z
from derive.check.sections import elliptic
from derive.check.sections.letters import constants, g_2, g_3, named
from derive.theory.claims import Domain
from derive.theory.load_case import COSINES, LoadCase, linear_root
from derive.theory.symbols import beta, theta, xi
from derive.theory.weierstrass import Weierstrass

xi_0 = Symbol("xi_0", real=True)  # ξ at the clamp
root = Symbol("root", positive=True)  # √Δ, of the discriminant of f̂
sine = Symbol("sin_theta", real=True)


@dataclass(frozen=True)
class Side:
    """A side of the roots of f̂. name: in words. tip: the root at which such a rod may end. free: what the constant of
    the first integral is traded for, of which ``known`` then vanishes. domain: where ξ and that are."""

    name: str
    tip: Expr
    known: Expr
    domain: Domain


def readings(case: LoadCase, functions: Weierstrass) -> Iterator[OnRod]:
    """One for each sign of the curvature, and each side of the roots on which the rod may be."""
    for side in _sides(case):
        for bent in (1, -1):
            yield _reading(case, functions, side, bent)


def _sides(case: LoadCase) -> list[Side]:
    """Between the roots any curvature k goes with any ξ; outside them, any √Δ that is less than |Hξ + B|."""
    if case.bends != -1:
        return [Side("", case.roots[-1], case.f_hat - m.k**2, case.domain(xi=COSINES).with_range(m.k, 0, oo))]
    discriminant, over = case.force**2 + case.stiffness * case.f_hat.subs(xi, 0), -case.stiffness * xi - case.force
    field = next(p for p in case.parameters if case.stiffness.has(p))
    middle = linear_root(over, beta)
    ranges = ({xi: (0, 1), beta: (0, middle)}, {xi: COSINES, beta: (middle, oo)})
    found = []
    for name, sense, tip, span in zip(("ξ > ξ_b", "ξ < ξ_a"), (1, -1), case.roots[::-1], ranges, strict=True):
        domain = Domain({field: (0, oo), **span, root: (0, sense * over)})
        found.append(Side(f" and {name}", tip, discriminant - root**2, domain))
    return found


def _reading(case: LoadCase, functions: Weierstrass, side: Side, bent: int) -> OnRod:
    """κ_x = ±√f̂(ξ) on one side of the roots."""
    values, curvature = constants(case, functions, functions.at_one), bent * sqrt(case.f_hat)
    values |= {"xi": xi, "y": Y, "z": Z, "theta": theta, "theta_o": acos(xi_0)}
    values |= {"kappa_x": curvature, "k": sqrt(case.f_hat), "u_o": m.u_o, "u": m.u_o + m.s}
    values |= {"varkappa": elliptic.value_at(functions, functions.at_one)(xi)}
    names = named(case, functions, functions.at_one)
    stretch = f"κ_x {'>' if bent == 1 else '<'} 0{side.name}"
    return OnRod(
        title=f"{case.name}, {stretch}",
        values=values,
        domain=side.domain.with_range(xi_0, *COSINES)
        .with_range(m.ell, 0, oo)
        .with_range(m.s, 0, m.ell)
        .with_range(m.varsigma, 0, m.ell),
        # ξ′ = −κ_x sin θ, and θ′ = κ_x.
        rates={xi: -curvature * sine, Y: xi, Z: sine, theta: curvature, sine: curvature * xi, m.s: Integer(1)},
        polynomials={"f": case.f, "f_hat": case.f_hat},
        invariants=(g_2, g_3),
        at_tip=side.tip,
        hypotheses=(*names, (case.constant, linear_root(side.known, case.constant)), (sine**2, 1 - xi**2)),
        start={Y: Integer(0), Z: Integer(0), xi: xi_0, m.s: Integer(0)},
        stretch=stretch,
    )
