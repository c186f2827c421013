"""Readings for z(s): along a stretch of the rod on which the curvature has one sign and ξ is on one side of the roots.

There κ_x = ±k with k² = f̂(ξ), z′ = sin θ, which may have either sign, and ξ′ = −κ_x sin θ.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from sympy import Expr, Integer, Symbol, acos, diff, oo

from derive.check import meaning as m
from derive.check.on_rod import OnRod, Y, Z
from derive.check.sections import elliptic
from derive.check.sections.letters import constants
from derive.theory.claims import Domain
from derive.theory.load_case import COSINES, LoadCase, linear_root
from derive.theory.symbols import theta, xi
from derive.theory.weierstrass import Weierstrass

xi_0 = Symbol("xi_0", real=True)  # ξ at the clamp
sine = Symbol("sin_theta", real=True)


def readings(case: LoadCase, functions: Weierstrass) -> Iterator[OnRod]:
    """One for each sign of the curvature, and each side of the roots on which the rod may be."""
    for where, side, tip in _sides(case):
        for bent in (1, -1):
            yield _reading(case, functions, f"κ_x {'>' if bent == 1 else '<'} 0{where}", bent, side, tip)


def _sides(case: LoadCase) -> list[tuple[str, Expr, Expr]]:
    """In words, what is > 0 on that side of the roots, and the root at which such a rod may end."""
    if case.bends != -1:
        return [("", Integer(1), case.roots[-1])]
    over = xi - case.vertex
    return [(" and ξ > ξ_b", over, case.roots[1]), (" and ξ < ξ_a", -over, case.roots[0])]


def _reading(
    case: LoadCase, functions: Weierstrass, stretch: str, bent: int, side: Expr, tip: Expr
) -> OnRod:
    """κ_x = ±k; the constant is what the first integral makes it of ξ and k, so that f̂(ξ) is k²."""
    constant = linear_root(case.f_hat - m.k**2, case.constant)
    letters = constants(case, functions, functions.at_one)

    def put(value: Any) -> Any:
        return value.subs(case.constant, constant)

    values = {name: put(value) for name, value in letters.items()}
    values |= {"xi": xi, "y": Y, "z": Z, "theta": theta, "theta_o": acos(xi_0), "kappa_x": bent * m.k, "k": m.k}
    values |= {"u_o": m.u_o, "u": m.u_o + m.s, "varkappa": put(elliptic.value_at(functions, functions.at_one)(xi))}
    turn = -bent * m.k * sine  # ξ′
    conditions = tuple(condition for condition in (side, put(letters["Delta"])) if case.bends)
    domain = Domain({**case.domain(xi=COSINES).ranges, m.k: (0, oo), xi_0: COSINES, m.ell: (0, oo)}, conditions)
    return OnRod(
        title=f"{case.name}, {stretch}",
        values=values,
        domain=domain.with_range(m.s, 0, m.ell),
        rates={
            xi: turn,
            m.k: put(diff(case.f_hat, xi)) / (2 * m.k) * turn,
            Z: sine,
            Y: xi,
            theta: bent * m.k,
            sine: bent * m.k * xi,
            m.s: Integer(1),
        },
        polynomials={"f": put(case.f), "f_hat": put(case.f_hat)},
        invariants=(put(functions.g2), put(functions.g3)),
        at_tip=put(tip),
        hypotheses=((sine**2, 1 - xi**2),),
        start={Y: Integer(0), Z: Integer(0), xi: xi_0, m.s: Integer(0)},
        stretch=stretch,
    )
