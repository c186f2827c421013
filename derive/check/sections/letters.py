"""The letters of Section 3 that mean the same wherever a formula of a load case is read: all of them constants."""

from __future__ import annotations

from typing import Any

from sympy import Expr, I, Integer, Symbol

from derive.check import meaning as m
from derive.theory import functions as fn
from derive.theory.load_case import LoadCase
from derive.theory.symbols import beta, eta, gamma_bar, xi
from derive.theory.weierstrass import Expansion, Weierstrass

# Names for what is long to write out; ``named`` says what they stand for.
g_2, g_3 = Symbol("g_2", real=True), Symbol("g_3", real=True)
omegas = tuple(Symbol(f"omega_{n}") for n in (1, 2, 3))
v = Symbol("v")


def constants(case: LoadCase, functions: Weierstrass, at: Expansion) -> dict[str, Any]:
    """β, η (0 where the section has none), the constant and its range, the roots, and what belongs to the root a."""
    bar = "_bar" if case.constant == gamma_bar else ""
    values: dict[str, Any] = {"beta": 0 * beta, "eta": 0 * eta, **{p.name: p for p in case.parameters}}
    values |= {"gamma": case.gamma, "s": m.s, "ell": m.ell, "varsigma": m.varsigma, "i_unit": I}
    values |= {f"gamma{bar}": case.constant, f"gamma{bar}_1": case.ends[0], f"gamma{bar}_2": case.ends[1]}
    discriminant = case.force**2 + case.stiffness * case.f_hat.subs(xi, 0)
    if len(case.roots) == 2:
        values |= {"xi_a": case.roots[0], "xi_b": case.roots[1]}
    else:
        values |= {"xi_1": Integer(1), "xi_2": case.roots[0], "xi_3": Integer(-1)}
    values |= {"Delta": discriminant, "a": at.a, "b": at.b, "c": at.c, "g_2": g_2, "g_3": g_3}
    values |= {f"omega_{n}": omega for n, omega in enumerate(omegas, start=1)}
    if case.bends:
        values |= {"v": v, "u_bar": fn.perimeter_point(at.value_at(Integer(-1)), g_2, g_3)}
    return values | m.BASES


def named(case: LoadCase, functions: Weierstrass, at: Expansion) -> tuple[tuple[Expr, Expr], ...]:
    """What the symbols among these values stand for: v, the half-periods, and the invariants last."""
    found: list[tuple[Expr, Expr]] = [(v, fn.perimeter_point(at.c, g_2, g_3))] if case.bends else []
    found += [(omega, fn.half_period(n, g_2, g_3)) for n, omega in enumerate(omegas, start=1)]
    return (*found, (g_2, functions.g2), (g_3, functions.g3))
