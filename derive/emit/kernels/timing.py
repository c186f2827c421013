"""How long a rod is from its tip to the clamp angle: the half-swing and the first arrival, for every tip."""

from __future__ import annotations

from typing import NamedTuple

from derive.emit.kernels.agm import agm, half_period
from derive.emit.kernels.arithmetic import epsilon, sqrt
from derive.emit.kernels.formulas import (
    arc_length,
    gap_minus_plus,
    gap_other_minus,
    gap_other_plus,
    point_minus,
    point_other,
    point_plus,
)


class Roots(NamedTuple):
    """The values e₁ > e₂ ≥ e₃ of ℘ at its half-periods as gaps, and which roots of f they belong to.

    ``order`` has a letter for each of e₁, e₂, e₃: '+' for ξ = 1, '-' for ξ = −1, 'o' for the other root of f̂.
    """

    order: str
    long_gap: float  # e₁ − e₃
    short_gap: float  # e₁ − e₂


class Point(NamedTuple):
    """℘ − e₊, ℘ − e₋ and ℘ − e_o at a point of the rod."""

    plus: float
    minus: float
    other: float


class Timing(NamedTuple):
    """Lengths from the tip: to the other turning point, and to the first arrival at the clamp angle."""

    swing: float
    arrival: float


def roots_of(beta, eta, tip):
    """The gaps between e₁, e₂, e₃, each from the product of half-angles that does not cancel."""
    plus, minus = 2 * tip.half_cosine**2, 2 * tip.half_sine**2
    drive = tip.drive
    if eta <= beta or tip.passes:
        return apart("-o+", gap_minus_plus(drive), -gap_other_minus(minus, tip.gap))
    if drive > 0:
        return apart("o-+", gap_other_plus(beta, eta, plus), gap_other_minus(minus, tip.gap))
    return apart("o+-", gap_other_minus(minus, tip.gap), gap_other_plus(beta, eta, plus))


def apart(order, long_gap, short_gap):
    """The roots with e₁ > e₂: where they meet, on a separatrix, a gap far below rounding stands for none."""
    return Roots(order, long_gap, max(short_gap, long_gap * epsilon() ** 18))


def half_period_of(roots):
    """Real half-period of ℘."""
    return half_period(agm(sqrt(roots.long_gap), sqrt(roots.short_gap)))


def clamp_point(clamp, tip):
    """℘ − e₊, ℘ − e₋, ℘ − e_o where the rod reaches the clamp angle."""
    plus, minus = 2 * tip.half_cosine**2, 2 * tip.half_sine**2
    drive = tip.drive
    return Point(
        point_plus(plus, drive, clamp.one_minus, tip.drop),
        point_minus(minus, drive, clamp.one_plus, tip.drop),
        point_other(plus, minus, tip.level, tip.drop),
    )


def timing_of(beta, eta, clamp, tip):
    """Half-swing and first arrival of a tip."""
    roots = roots_of(beta, eta, tip)
    half = half_period_of(roots)
    point = clamp_point(clamp, tip)
    direct = min(arc_length(point.plus, point.minus, point.other), half)
    if eta > beta and not tip.passes:
        return Timing(half, direct)
    return Timing(2 * half, direct if clamp.rest >= 0 else 2 * half - direct)
