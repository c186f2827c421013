"""Where motions from rest at a tip are after the length of a short rod, on arrays.

From a tip φ the motion is at φ + 2 arctan(b/(℘(σ) − c)) (`theory/oblique`), and ℘ follows from its series near 0 by
the duplication formula (DLMF 23.9.2, 23.10.7, here of ℘ − c): no roots, no ranges.
"""

from __future__ import annotations

from typing import Any, NamedTuple

from numpy import ceil, float32, floor, log2, maximum, minimum, searchsorted, zeros

from derive.emit.kernels.arithmetic import pi
from derive.emit.kernels.array_arithmetic import each_atan2, each_cos, each_less_quarters, each_sin

SERIES_END = 0.3  # σ√(β + η) up to which the series of ℘(σ) is right to rounding: no less than 1.49π/16


class Load(NamedTuple):
    """What acts on rods, in units of their length, and the clamp angle less half turns: exact beside one.

    facing: −1 after an odd number of half turns, else 1, and β of that sign. reach: how far the tip may be from the
    clamp.
    """

    facing: Any
    beta: Any
    eta: Any
    double_cosine: Any
    double_sine: Any
    clamp_angle: Any
    reach: Any


def load_of(rods):
    """The load of rods."""
    square = rods.length * rods.length
    twice = 2 * rods.field_angle + zeros(rods.case.shape)
    reach = minimum((rods.beta + rods.eta / 2) * square / 2, 2 * pi) * (1 + 1e-3)
    half_turns = floor(rods.clamp_angle / pi + 0.5)
    clamp, facing = each_less_quarters(rods.clamp_angle, 2 * half_turns), 1 - 2 * (half_turns % 2)
    return Load(facing, facing * rods.beta * square, rods.eta * square, each_cos(twice), each_sin(twice), clamp, reach)


class Quartic(NamedTuple):
    """What a motion depends on, by its tip: b = p/4, and 4w³ + qw² + ``linear``·w + ``last``, the square of ℘′ by
    w = ℘ − c (`theory/oblique_quartic`). Beside a hill ℘ − c is small, and so would be what a difference leaves of it.
    """

    b: Any
    q: Any
    linear: Any
    last: Any


class Aim(NamedTuple):
    """A tip: the quartic, and cosine and sine of θ(ℓ), as the load faces, and of 2(θ(ℓ) − α)."""

    quartic: Quartic
    heading: Any


def aim_at(load, offset):
    """The tip at an offset from the clamp angle."""
    tip = load.clamp_angle + offset
    sine, cosine = each_sin(tip), each_cos(tip)
    twice_sine, twice_cosine = 2 * sine * cosine, 1 - 2 * sine * sine
    double_sine = twice_sine * load.double_cosine - twice_cosine * load.double_sine
    double_cosine = twice_cosine * load.double_cosine + twice_sine * load.double_sine
    along, across, half = load.beta * cosine, load.beta * sine, 0.5 * load.eta * double_sine
    p, m, q = across + half, across - half, along + load.eta * double_cosine
    b = p / 4
    return Aim(Quartic(b, q, m * b, along * b * b), (cosine, sine, double_cosine, double_sine))


def missed_by(quartic, offset):
    """The angle after the rod's length less the clamp angle."""
    return offset + 2 * each_atan2(quartic.b, ahead_at_clamp(quartic))


def miss(load, share):
    """The same for tips at a share of their reach from the clamp angle."""
    offset = load.reach * share
    return missed_by(aim_at(load, offset).quartic, offset)


def ahead_at_clamp(quartic):
    """℘(1) − c: the series at 1/4, or 1/16 in double precision, and the duplication formula."""
    rough = quartic.q.dtype == float32
    square, doublings = (1 / 16, 2) if rough else (1 / 256, 4)
    eighth = eighth_of(quartic)
    value = ahead_near_tip(quartic, square, rough)
    for _ in range(doublings):
        value = ahead_doubled(quartic, eighth, value)
    return value


def ahead_along(quartic, place, slow):
    """℘ − c at places in (0, 1], a row for each, which go up. slow: the greatest ℓ√(β + η)."""
    doublings = maximum(ceil(log2(place * (slow / SERIES_END))), 0).astype(int)
    start, eighth = place * 0.5**doublings, eighth_of(quartic)
    value = ahead_near_tip(quartic, (start * start)[:, None], False)
    for k in range(doublings[-1]):
        first = int(searchsorted(doublings, k, side="right"))
        value[first:] = ahead_doubled(quartic, eighth, value[first:])
    return value


def ahead_near_tip(quartic, square, rough):
    """℘(z) − c by z²: the series, to the rounding of single precision or of double precision."""
    c = quartic.q / 12
    g2 = quartic.q * c - quartic.linear
    g3 = (quartic.linear - quartic.q * quartic.q / 18) * c - quartic.last
    a, b = g2 * (square * square / 20), g3 * (square * square * square / 28)
    series = a + b + a * a / 3 + a * b * (3 / 11)
    if not rough:
        series = series + (2 * a * a * a / 3 + b * b) / 13
    return (1 + (series - c * square)) / square


def eighth_of(quartic):
    """What the duplication formula has beside the coefficients, b₈ of Weierstrass curves."""
    return (quartic.q * quartic.last - quartic.linear * quartic.linear / 4) / 4


def ahead_doubled(quartic, eighth, value):
    """℘(2z) − c by ℘(z) − c: Weierstrass curves are doubled so, with b₂ = q, 2b₄ = ``linear``, b₆ = ``last``."""
    squared = value * value
    above = squared * (squared - quartic.linear / 2) - (2 * quartic.last * value + eighth)
    return above / ((4 * value + quartic.q) * squared + (quartic.linear * value + quartic.last))
