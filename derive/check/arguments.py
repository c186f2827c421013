"""Sines, cosines and exponentials of sums: addition formulas over base angles.

Every term of an argument is a rational multiple of a base; the unit of a base is its largest common divisor over all
arguments, so that half and double angles meet. Angles that are inverse functions are algebraic.
"""

from __future__ import annotations

from collections.abc import Iterable
from math import lcm
from typing import TYPE_CHECKING, Any

import sympy as sp

if TYPE_CHECKING:
    from derive.check.tower import Tower

Pair = tuple[sp.Expr, sp.Expr]  # cosine and sine

CIRCULAR = (sp.sin, sp.cos, sp.tan, sp.cot, sp.sec, sp.csc)
HYPERBOLIC = (sp.exp, sp.sinh, sp.cosh, sp.tanh, sp.coth)
INVERSE: dict[Any, Any] = {
    sp.acos: lambda x: (x, sp.sqrt(1 - x**2)),
    sp.asin: lambda x: (sp.sqrt(1 - x**2), x),
    sp.atan: lambda x: (1 / sp.sqrt(1 + x**2), x / sp.sqrt(1 + x**2)),
}


def terms(argument: sp.Expr) -> dict[sp.Expr, sp.Rational]:
    """An argument as base → rational coefficient."""
    found: dict[sp.Expr, sp.Rational] = {}
    for term in sp.Add.make_args(sp.expand(argument)):
        coefficient, base = term.as_coeff_Mul(rational=True)
        if base.could_extract_minus_sign() and not base.is_Symbol:
            coefficient, base = -coefficient, -base
        found[base] = found.get(base, sp.Integer(0)) + coefficient
    return {base: value for base, value in found.items() if value != 0}


def angle_units(expressions: Iterable[sp.Expr]) -> dict[sp.Expr, int]:
    """base → common denominator of its coefficients in all arguments of circular functions and exponentials."""
    units: dict[sp.Expr, int] = {}
    for expr in expressions:
        for call in expr.atoms(sp.Function, sp.exp):
            if isinstance(call, CIRCULAR + HYPERBOLIC):
                for base, value in terms(call.args[0]).items():
                    base = base / sp.I if sp.I in sp.Mul.make_args(base) else base
                    units[base] = lcm(units.get(base, 1), int(value.q))
        for power in expr.atoms(sp.Pow):  # roots of 1 ± cos θ are sines and cosines of θ/2
            if not power.exp.is_Integer and power.exp.is_Rational:
                for call in power.base.atoms(sp.sin, sp.cos):
                    for base in terms(call.args[0]):
                        units[base] = lcm(units.get(base, 1), 2)
    return units


def _plus(a: Pair, b: Pair) -> Pair:
    return a[0] * b[0] - a[1] * b[1], a[1] * b[0] + a[0] * b[1]


def cosine_sine(tower: Tower, argument: sp.Expr) -> Pair:
    """cos and sin of any argument, in generators."""
    total: Pair = (sp.Integer(1), sp.Integer(0))
    for base, coefficient in terms(argument).items():
        unit = lcm(tower.units.get(base, 1), int(coefficient.q))
        step = _base(tower, base, unit)
        count = int(coefficient * unit)
        if count < 0:
            step, count = (step[0], -step[1]), -count
        for _ in range(count):
            total = _plus(total, step)
    return total


def _base(tower: Tower, base: sp.Expr, unit: int) -> Pair:
    """cos and sin of base/unit: algebraic for an inverse function, otherwise two generators with c² + s² = 1."""
    if base.func in INVERSE and unit in (1, 2):
        cosine, sine = INVERSE[base.func](base.args[0])
        if unit == 2:  # Re of acos is in [0, π], of the others in [−π/2, π/2]: Re cos of the half is ≥ 0
            half = sp.sqrt((1 + cosine) / 2)
            return tower.rewrite(half), tower.rewrite(sine / (2 * half))
        return tower.rewrite(cosine), tower.rewrite(sine)
    angle = base / unit
    cosine = _given(tower, sp.cos(angle)) or tower.generator(("cos", angle), sp.cos(angle))
    sine = _given(tower, sp.sin(angle)) or tower.generator(("sin", angle), sp.sin(angle), (2, 1 - cosine**2))
    return cosine, sine


def _given(tower: Tower, call: sp.Expr) -> sp.Expr | None:
    return tower.rewrite(tower.given[call]) if call in tower.given else None


def exponential(tower: Tower, argument: sp.Expr) -> sp.Expr:
    """exp of any argument: a product of powers of generators; of i·θ, the cosine and the sine."""
    result: sp.Expr = sp.Integer(1)
    for base, coefficient in terms(argument).items():
        unit = lcm(tower.units.get(base, 1), int(coefficient.q))
        if sp.I in sp.Mul.make_args(base):
            cosine, sine = cosine_sine(tower, coefficient * base / sp.I)
            result *= cosine + tower.rewrite(sp.I) * sine
        elif isinstance(base, sp.log):
            result *= tower.rewrite(base.args[0] ** coefficient)
        else:
            result *= tower.generator(("exp", base, unit), sp.exp(base / unit)) ** int(coefficient * unit)
    return result
