"""Folds to 40 digits: where two equilibria meet as one input changes, by Newton's method on Taylor integration.

The tip angle φ and the input p are the unknowns of θ(0; φ, p) = θ₀ and h(0; φ, p) = 0. The derivatives are differences
at twice the digits, so that the convergence is Newton's own.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from itertools import pairwise
from typing import Any

from mpmath import mp, mpf

from derive.measure.counts import count
from derive.measure.reference import DIGITS, MOST_ROUNDS, Rod
from derive.measure.taylor import integrate

HALVINGS = 17


class NoFoldError(ValueError):
    """Newton's method does not settle near what it was given."""


@dataclass(frozen=True)
class Fold:
    """A rod with one input moved to a fold: the input's value and the tip angle there, to 40 digits.

    opens: the sign of p − value on the side where the two equilibria are. bend: their tips are at ±√(bend·|p − value|)
    from it.
    """

    rod: Rod
    parameter: str
    value: Any
    tip_angle: Any
    opens: int
    bend: float

    def beside(self, relative: float) -> Rod:
        """The rod with the input moved from the fold by a share of its value, rounded to a double."""
        with mp.workdps(DIGITS + 10):
            return replace(self.rod, **{self.parameter: float(self.value * (1 + mpf(relative)))})


def fold(rod: Rod, parameter: str, value: float, tip_angle: float, digits: int = DIGITS) -> Fold:
    """The fold near an input's value and a tip angle; parameter: beta, eta, length, clamp_angle or field_angle."""
    with mp.workdps(2 * digits + 20):
        p, tip, delta = mpf(value), mpf(tip_angle), mpf(10) ** -(digits // 2 + 5)
        for _ in range(MOST_ROUNDS):
            miss, h = _at(rod, parameter, p, tip, digits)
            miss_p, h_p = (
                (there - here) / delta
                for there, here in zip(_at(rod, parameter, p + delta, tip, digits), (miss, h), strict=True)
            )
            h_tip = (_at(rod, parameter, p, tip + delta, digits)[1] - h) / delta
            determinant = h * h_p - miss_p * h_tip
            if not determinant:
                raise NoFoldError(f"no simple fold of {parameter} near {value:g} for {rod}")
            step_tip, step_p = (miss * h_p - miss_p * h) / determinant, (h * h - miss * h_tip) / determinant
            tip, p = tip - step_tip, p - step_p
            if abs(p - value) > abs(value) / 2 or abs(tip - tip_angle) > 1:
                raise NoFoldError(f"no fold of {parameter} near {value:g}, tip angle {tip_angle:g}, for {rod}")
            if max(abs(step_tip), abs(step_p) / abs(p)) < mpf(10) ** -(digits + 2):
                break
        else:
            raise NoFoldError(f"Newton's method does not settle at a fold of {parameter} near {value:g} for {rod}")
        # miss ≈ miss_p (p − value) + h_tip (φ − tip)²/2
        bend = -2 * miss_p / h_tip
        return Fold(rod, parameter, +p, +tip, 1 if bend > 0 else -1, float(abs(bend)))


def fold_between(rod: Rod, parameter: str, low: float, high: float) -> Fold | None:
    """A fold between two values of an input, where a moderate rod has different numbers of equilibria, or None.

    Halving by brute force, to 1e-5 of the interval, and then `fold`.
    """
    first = _tips(rod, parameter, low)
    if len(first) == len(_tips(rod, parameter, high)):
        return None
    for _ in range(HALVINGS):
        middle = (low + high) / 2
        low, high = (middle, high) if len(_tips(rod, parameter, middle)) == len(first) else (low, middle)
    tips = max(_tips(rod, parameter, low), _tips(rod, parameter, high), key=len)
    gap, k = min((after - before, k) for k, (before, after) in enumerate(pairwise(tips)))
    return fold(rod, parameter, (low + high) / 2, tips[k] + gap / 2)


def _tips(rod: Rod, parameter: str, value: float) -> tuple[float, ...]:
    counted = count([replace(rod, **{parameter: value})])[0]
    if counted.tips is None:
        raise NoFoldError(f"at a fold already: {counted.rod}")
    return counted.tips


def _at(rod: Rod, parameter: str, value: Any, tip: Any, digits: int) -> tuple[Any, Any]:
    """θ(0) − θ₀ and h(0), where the input may have more digits than a double."""
    inputs = {name: mpf(number) for name, number in vars(rod).items()} | {parameter: value}
    clamp_angle = inputs.pop("clamp_angle")
    clamp = integrate(tip, **inputs, digits=digits + digits // 2 + 10).clamp
    return clamp.theta - clamp_angle, clamp.h
