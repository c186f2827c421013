"""Limits and orders seen numerically: the values on the way to the point, at high precision.

A limit is missed if the values settle away from it or run away; an order, if the measured one falls short. Slow
approach is no counterexample.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial
from itertools import pairwise
from typing import Any

import sympy as sp
from mpmath import mp

from derive.check.evaluate import UndefinedError, evaluate, magnitude
from derive.check.refute import Trial, shown, tried
from derive.check.sample import ExactPoint, Sampler
from derive.theory.claims import Claim, Domain, Limit, Order

POINTS = 4
STEPS = (8, 14, 20, 26)  # distances 10⁻⁸, 10⁻¹⁴, … from the limit point
DIGITS = 140
NEAR = mp.mpf(10) ** -40  # relative error that counts as none
STALLED = 0.9  # ratio of successive errors beyond which they do not fall
SLACK = 0.2  # how far a measured order may fall short


def refute(claim: Claim) -> Trial:
    """Look for points at which the expression does not approach the value, or not at the stated order."""
    relation, domain = claim.relation, claim.domain
    if isinstance(relation, Limit):
        expressions = [relation.expr, relation.point, relation.value]
        tests = [partial(_misses, relation, way) for way in directions(relation)]
    else:
        assert isinstance(relation, Order)
        expressions = entries(relation)
        tests = [partial(_falls_short, relation, entry) for entry in expressions]
        domain = Domain({x: ends for x, ends in domain.ranges.items() if x != relation.variable})
    sampler = Sampler(expressions, domain, claim.given, seed=2)
    trial = tried(
        sampler.points(3 * POINTS), POINTS, lambda point: next((text for test in tests if (text := test(point))), None)
    )
    if trial.counterexample is None and trial.points and isinstance(relation, Limit):
        return Trial(_special(relation, sampler, tests), trial.points)
    return trial


def _special(relation: Limit, sampler: Sampler, tests: Sequence[Any]) -> dict[str, str] | None:
    """Look where the denominator vanishes at the limit point: there the limit may be another."""
    if relation.point in (sp.oo, -sp.oo):
        return None
    bottom = sp.fraction(sp.together(relation.expr))[1].subs(relation.variable, relation.point)
    for point in sampler.zeros([bottom], 2):
        for test in tests:
            try:
                found = test(point)
            except UndefinedError:
                continue
            if found:
                return found
    return None


def entries(relation: Order) -> list[sp.Expr]:
    """The scalars of which an order is asserted."""
    return list(relation.expr) if isinstance(relation.expr, sp.MatrixBase) else [relation.expr]


def directions(relation: Limit) -> list[Callable[[sp.Expr], sp.Expr]]:
    """Local parametrisations of the variable, τ → 0+."""
    if relation.point in (sp.oo, -sp.oo):
        return [lambda tau: sp.sign(relation.point) / tau]
    sides = {"+": [1], "-": [-1], "+-": [1, -1]}[relation.side]
    return [partial(_beside, relation.point, side) for side in sides]


def _beside(point: sp.Expr, side: int, tau: sp.Expr) -> sp.Expr:
    return point + side * tau


def _misses(relation: Limit, direction: Any, point: ExactPoint) -> dict[str, str] | None:
    """A counterexample if the values settle away from the limit, or run away."""
    local = {k: v for k, v in point.items() if k != relation.variable}
    infinite = relation.value in (sp.oo, -sp.oo)
    errors, values = [], []
    target = mp.mpf(0) if infinite else evaluate(relation.value, local, DIGITS)
    place = local
    for step in STEPS:
        place = {**local, relation.variable: direction(sp.Rational(1, 10**step)).subs(_plain(local))}
        value = evaluate(relation.expr, place, DIGITS)
        values.append(value)
        with mp.workdps(DIGITS):
            errors.append(abs(1 / value if infinite else value - target) if value != 0 or not infinite else mp.inf)
    wrong_side = infinite and (mp.im(values[-1]) != 0 or (values[-1] > 0) != (relation.value == sp.oo))
    scale = max(mp.mpf(1), abs(target)) if abs(target) > 0 else max(mp.mpf(1), abs(values[0]))
    if wrong_side or (errors[-1] > NEAR * scale and errors[-1] > STALLED * errors[-2]):
        return shown(place, values[-1], mp.mpf("inf") if infinite else target)
    return None


def _plain(point: ExactPoint) -> dict[sp.Expr, sp.Expr]:
    return {k: v for k, v in point.items() if v.is_number}


def _falls_short(relation: Order, expr: sp.Expr, point: ExactPoint) -> dict[str, str] | None:
    """A counterexample if |expr| falls more slowly than variable**power, seen between each two steps."""
    variable, power = relation.variable, relation.power
    sizes, place = [], point
    for step in STEPS[:3]:
        place = {**point, variable: sp.Rational(1, 10**step)}
        digits = DIGITS + step * power
        value = evaluate(expr, place, digits)
        with mp.workdps(digits):
            noise = magnitude(expr, place, digits) * mp.mpf(10) ** (10 - digits)
            sizes.append(mp.mpf(0) if abs(value) <= noise else abs(value))
    if 0 in sizes:
        return None
    spans = [b - a for a, b in pairwise(STEPS[:3])]
    orders = [mp.log10(a / b) / span for (a, b), span in zip(pairwise(sizes), spans, strict=True)]
    if max(orders) < power - SLACK:
        return {**shown(place, sizes[-1], mp.mpf(0)), "order": mp.nstr(orders[-1], 5)}
    return None
