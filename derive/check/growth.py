"""Counterexamples on the bench where a side accumulates along the rod: the rates of the two sides differ."""

from __future__ import annotations

from typing import Any

from mpmath import mp
from sympy import sympify

from derive.check.evaluate import evaluate, magnitude
from derive.check.meaning import pm
from derive.check.refute import SAME
from derive.check.values import Indices, Place
from derive.paper import tree as t

TOLERANCE = mp.mpf(10) ** -18  # relative difference of rates that counts as none


def differ(
    place: Place, sides: tuple[t.Node, ...], indices: Indices, signs: tuple[int, ...], digits: int
) -> dict[str, str] | None:
    """A counterexample if for each of the signs the rates differ."""
    rates = [place.rate(side, indices) for side in sides]
    place.sampler.extend(place.point, [rate.subs(pm, 1) for rate in rates])
    found = None
    for sign in signs:
        point = {**place.point, pm: sympify(sign, strict=True)}
        known, more = (place.values(n * digits, sign).evaluated for n in (1, 2))
        left, right = (evaluate(rate, point, digits, known) for rate in rates)
        with mp.workdps(digits):
            gap, size = left - right, sum(magnitude(rate, point, digits, known) for rate in rates)
        if abs(gap) <= TOLERANCE * size:
            return None
        with mp.workdps(2 * digits):
            first, second = (evaluate(rate, point, 2 * digits, more) for rate in rates)
            again: Any = first - second
            if abs(again - gap) > SAME * abs(again):
                return None
        shown = {str(symbol): str(value) for symbol, value in place.point.items() if value.is_number}
        found = {**shown, "lhs": mp.nstr(left, 20), "rhs": mp.nstr(right, 20)}
    return found
