"""Logarithms along a rod: does the principal value serve, or must the logarithm be continued from the clamp?

The argument is followed in small steps, so that its phase never jumps, on rods of every case of the start, some of
them longer than a period. Where the phase followed and that of the principal value part, the latter is wrong.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from itertools import pairwise
from typing import Any

import sympy as sp
from mpmath import mp

from derive.check import meaning as m
from derive.check.evaluate import UndefinedError, evaluate
from derive.check.sample import ExactPoint, Sampler
from derive.paper import tree as t
from derive.theory import functions as fn
from derive.theory.claims import Domain

DIGITS = 15
RODS = 2  # of each case of the start
LENGTH = sp.Rational(5, 2)  # of the rods, in real half-periods
STEPS = 8  # in a half-period
MUCH = 1  # radians in a step, which is then halved
HALVINGS = 6
STILL = mp.mpf(10) ** -8  # a phase that moves less stands still


@dataclass(frozen=True)
class Followed:
    """One logarithm along one rod. jump: the fraction of the rod after which the principal value is wrong, or None."""

    case: str
    point: ExactPoint
    jump: sp.Rational | None
    turns: bool


def condition(sides: Iterable[t.Node], rods: Iterable[m.Reading]) -> str:
    """What is to be said of the logarithms in the sides; empty if there are none."""
    found = [one for rod in rods for side in sides for one in _along(rod.of(side), rod)]
    if not found:
        return ""
    wrong = next((one for one in found if one.jump is not None), None)
    if wrong is None or wrong.jump is None:
        how = "turns, but not across the cut" if any(one.turns for one in found) else "keeps its phase"
        return f"the principal value of ln serves: its argument {how} on the {len(found)} rods that were followed"
    values = {x: value for x, value in wrong.point.items() if value.is_number}
    values |= {m.s: wrong.jump * wrong.point[m.ell]}
    place = ", ".join(f"{symbol} = {mp.nstr(evaluate(value, {}, DIGITS), 9)}" for symbol, value in values.items())
    return f"ln must be continued along the rod: its principal value is wrong at {place} ({wrong.case})"


def _along(value: Any, rod: m.Reading) -> Iterator[Followed]:
    """All logarithms that move, on some rods of one case."""
    logs = sorted((one for one in value.atoms(sp.log) if one.has(m.s)), key=sp.default_sort_key)
    if not logs or rod.invariants is None:
        return
    domain = Domain({x: ends for x, ends in rod.domain.ranges.items() if x not in m.ARCS}, rod.domain.conditions)
    half = fn.half_period(sp.Integer(1), *rod.invariants)
    for point in Sampler([half, *logs], domain, rod.hypotheses, seed=3).points(RODS):
        try:
            length = evaluate(half, point, DIGITS) * LENGTH.p / LENGTH.q
            whole = {**point, m.ell: sp.Rational(mp.nstr(length, 6))}
            for one in logs:
                yield _followed(one.args[0], rod.title, whole, int(STEPS * LENGTH))
        except UndefinedError:
            continue


def _followed(argument: sp.Expr, case: str, point: ExactPoint, steps: int) -> Followed:
    """The phase of the argument from the clamp to the end."""
    places = [sp.Rational(n, steps) for n in range(steps + 1)]
    start = before = _at(argument, point, places[0])
    phase, turns = mp.mpf(0), False
    for left, place in pairwise(places):
        value = _at(argument, point, place)
        phase += _turn(argument, point, (left, place), (before, value), HALVINGS)
        turns, before = turns or abs(phase) > STILL, value
        if abs(phase - (mp.arg(value) - mp.arg(start))) > mp.pi:
            return Followed(case, point, place, True)
    return Followed(case, point, None, turns)


def _at(argument: sp.Expr, point: ExactPoint, place: sp.Rational) -> Any:
    return evaluate(argument, {**point, m.s: point[m.ell] * place}, DIGITS)


def _turn(argument: sp.Expr, point: ExactPoint, places: tuple[Any, Any], values: tuple[Any, Any], halvings: int) -> Any:
    """By how much the phase changes on a step, which is halved while that is much."""
    change = mp.arg(values[1] / values[0])
    if abs(change) < MUCH or not halvings:
        return change
    middle = (places[0] + places[1]) / 2
    between = _at(argument, point, middle)
    first = _turn(argument, point, (places[0], middle), (values[0], between), halvings - 1)
    return first + _turn(argument, point, (middle, places[1]), (between, values[1]), halvings - 1)
