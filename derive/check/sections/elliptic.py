"""Readings for ζ, σ, v, the half-periods and y(s): ξ and ϰ are the theory's functions of u.

- In any lattice: u and v are any points (the addition formula).
- On a line u = u_o + s with any start u_o, for any constant in its range: what holds there holds for every rod.
- On rods: u_o is where the theory lets the rod begin, for each case of it; the half-periods are where they are.

v is the point of the rectangle of half-periods where ℘ = c, with ℘′(v) as the theory has it on that side.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace
from typing import Any

from sympy import Expr, Integer, Rational, acos, sqrt

from derive.check import meaning as m
from derive.check.on_rod import OnRod, Y, Z
from derive.check.sections.letters import constants, g_2, g_3, named, omegas, v
from derive.theory import functions as fn
from derive.theory.claims import Domain
from derive.theory.load_case import LoadCase, xi_tip
from derive.theory.perimeter import SIDES, slope_by_field
from derive.theory.symbols import xi
from derive.theory.uo_cases import HALF_PERIODS, UoCase
from derive.theory.weierstrass import Expansion, Weierstrass

ANY_LATTICE = {"wp", "wzeta", "wsigma", "u", "v"}
NEAR = (Rational(1, 10), Rational(2, 10))  # ranges of u_o and ℓ, free of poles for every sample of the others


def any_lattice() -> OnRod:
    """u and v anywhere, any invariants."""
    ranges = {g_2: (3, 4), g_3: (Rational(1, 4), Rational(1, 2)), v: (Rational(1, 2), Rational(7, 10)), m.u: NEAR}
    values = {"u": m.u, "v": v, "g_2": g_2, "g_3": g_3}
    return OnRod("any u, v and invariants", values, Domain(ranges), invariants=(g_2, g_3))


def solution(functions: Weierstrass, at: Expansion) -> Callable[[Expr], Expr]:
    """ξ as a function of ℘: by the linear map where f is a cubic."""
    if functions.linear is None:
        return at.xi_at
    start, slope = functions.linear
    return lambda value: start + slope * value


def value_at(functions: Weierstrass, at: Expansion) -> Callable[[Expr], Expr]:
    """℘ as a function of ξ."""
    if functions.linear is None:
        return at.value_at
    start, slope = functions.linear
    return lambda root: (root - start) / slope


def on_line(case: LoadCase, functions: Weierstrass, at: Expansion, title: str) -> OnRod:
    """On u = u_o + s for any u_o."""
    here = m.u_o + m.s
    values = constants(case, functions, at)
    domain = case.domain(**{case.constant.name: case.ends}).with_range(m.u_o, *NEAR).with_range(m.ell, *NEAR)
    reading = OnRod(
        title=f"{case.name}, on a line{title}",
        values=values,
        domain=domain.with_range(m.s, 0, m.ell).with_range(m.varsigma, 0, m.ell),
        polynomials={"f": case.f, "f_hat": case.f_hat},
        invariants=(g_2, g_3),
        solution=solution(functions, at),
        hypotheses=(*named(case, functions, at), *_at_pole(case, functions, at)),
        start={Y: Integer(0), Z: Integer(0), m.s: Integer(0)},
        rods=lambda: on_rods(case, functions),
    )
    return _moving(reading, here)


def _moving(reading: OnRod, here: Expr) -> OnRod:
    """The names that move along the rod, with u = here, and their rates."""
    assert reading.solution is not None
    assert reading.invariants is not None
    value = fn.wp(here, *reading.invariants)
    cosine = reading.solution(value)
    curvature = sqrt(reading.polynomials["f_hat"].subs(xi, cosine))
    moving: dict[str, Any] = {"u": here, "u_o": here - m.s, "varkappa": value, "xi": cosine, "y": Y, "z": Z}
    moving |= {"theta": acos(cosine), "theta_o": acos(cosine.subs(m.s, 0)), "kappa_x": curvature, "k": curvature}
    rates = {m.s: Integer(1), Y: cosine, Z: sqrt(1 - cosine**2)}
    return replace(reading, values={**reading.values, **moving}, rates=rates)


def _at_pole(case: LoadCase, functions: Weierstrass, at: Expansion) -> tuple[tuple[Expr, Expr], ...]:
    """℘(v) = c; and ℘′(v), where v is on the same side of the rectangle for every rod (a = 1, e ∥ F)."""
    if not case.bends:
        return ()
    point = fn.perimeter_point(at.c, functions.g2, functions.g3), functions.g2, functions.g3
    value = (fn.wp(*point), at.c)
    sides = {one.pole for one in functions.uo_cases}
    if at != functions.at_one or len(sides) > 1:
        return (value,)
    slope = slope_by_field(SIDES[sides.pop()], abs(case.stiffness), at.b)
    return (value, (fn.wp_prime(*point), slope))


def on_rods(case: LoadCase, functions: Weierstrass) -> Iterator[OnRod]:
    """On every rod, from ω̄ − ℓ to the half-period ω̄ at the free end; a = 1."""
    line = on_line(case, functions, functions.at_one, "")
    for one in functions.uo_cases:
        yield on_rod(case, functions, line, one)


def on_rod(case: LoadCase, functions: Weierstrass, line: OnRod, one: UoCase) -> OnRod:
    """One case of the start, with the constant that the free end makes."""
    to_tip = {case.constant: case.tip_constant}

    def put(value: Any) -> Any:
        return value.subs(to_tip)

    at, start = functions.at_one, solution(functions, functions.at_one)
    values = {name: put(value) for name, value in line.values.items()}
    tip = omegas[HALF_PERIODS.index(one.half_period)]
    values |= {"omega_bar": tip, "gamma": put(case.gamma), **_roots(case, one)}
    reading = replace(
        line,
        title=f"{case.name}, {one.condition}",
        values=values,
        domain=one.domain.with_range(m.ell, *NEAR).with_range(m.s, 0, m.ell).with_range(m.varsigma, 0, m.ell),
        polynomials={name: put(value) for name, value in line.polynomials.items()},
        solution=lambda value: put(start(value)),
        at_tip=xi_tip,
        hypotheses=(
            *((old, put(new)) for old, new in named(case, functions, at)),
            *_at_corners(case, functions, one, at),
        ),
    )
    return _moving(reading, tip - m.ell + m.s)


def _roots(case: LoadCase, one: UoCase) -> dict[str, Expr]:
    """ξ_a and ξ_b by ξ(ℓ) and the other root."""
    if case.other_root is None:
        return {}
    pair = (xi_tip, case.other_root) if one.value == "xi_a" else (case.other_root, xi_tip)
    return dict(zip(("xi_a", "xi_b"), pair, strict=True))


def _at_corners(case: LoadCase, functions: Weierstrass, one: UoCase, at: Expansion) -> tuple[tuple[Expr, Expr], ...]:
    """℘ and ℘′ at the half-periods and at v."""
    to_tip = {case.constant: case.tip_constant}
    g2, g3 = functions.g2.subs(to_tip), functions.g3.subs(to_tip)
    value = value_at(functions, at)
    found = []
    for n, root in enumerate(one.roots, start=1):
        corner = (fn.half_period(n, g2, g3), g2, g3)
        found += [(fn.wp(*corner), value(root).subs(to_tip)), (fn.wp_prime(*corner), Integer(0))]
    if case.bends:
        c, b = at.c.subs(to_tip), at.b.subs(to_tip)
        point = (fn.perimeter_point(c, g2, g3), g2, g3)
        slope = slope_by_field(SIDES[one.pole], abs(case.stiffness), b)
        found += [(fn.wp(*point), c), (fn.wp_prime(*point), slope)]
    return tuple(found)
