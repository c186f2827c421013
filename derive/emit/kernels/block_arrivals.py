"""Where motions from rest at a tip are after the length of a short rod, on arrays.

From a tip φ the motion is at φ + 2 arctan(b/(℘(σ) − c)) (`theory/oblique`), and ℘ follows from its series near 0 by
the duplication formula (DLMF 23.9.2, 23.10.7): no roots, no ranges.
"""

from __future__ import annotations

from typing import Any, NamedTuple

from numpy import ceil, float32, floor, log2, maximum, minimum, searchsorted, zeros

from derive.emit.kernels.arithmetic import pi
from derive.emit.kernels.array_arithmetic import each_atan2, each_cos, each_less_quarters, each_sin

SERIES_SLOW = 0.275  # σ√(β + η) up to which the series of ℘(σ) is right to rounding: 1.4π/16


class Load(NamedTuple):
    """What acts on rods, in units of their length, and the clamp angle less whole turns.

    reach: how far the tip may be from the clamp.
    """

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
    clamp = each_less_quarters(rods.clamp_angle, 4 * floor(rods.clamp_angle / (2 * pi) + 0.5))
    return Load(rods.beta * square, rods.eta * square, each_cos(twice), each_sin(twice), clamp, reach)


class Quartic(NamedTuple):
    """What a motion depends on, by its tip: b, c, and the invariants of ℘ (`theory/oblique_quartic`)."""

    b: Any
    c: Any
    g2: Any
    g3: Any


class Aim(NamedTuple):
    """A tip: the quartic, and cosine and sine of θ(ℓ) and of 2(θ(ℓ) − α)."""

    quartic: Quartic
    heading: Any


def quartic_of(load, offset):
    """The tip at an offset from the clamp angle."""
    tip = load.clamp_angle + offset
    sine, cosine = each_sin(tip), each_cos(tip)
    twice_sine, twice_cosine = 2 * sine * cosine, 1 - 2 * sine * sine
    double_sine = twice_sine * load.double_cosine - twice_cosine * load.double_sine
    double_cosine = twice_cosine * load.double_cosine + twice_sine * load.double_sine
    along, across, half = load.beta * cosine, load.beta * sine, 0.5 * load.eta * double_sine
    p, m, q = across + half, across - half, along + load.eta * double_cosine
    mp, c = m * p, q / 12
    g2 = q * c - mp / 4
    g3 = (mp / 4 - q * q / 18) * c - along * p * p / 16
    return Aim(Quartic(p / 4, c, g2, g3), (cosine, sine, double_cosine, double_sine))


def miss(load, share):
    """The angle after the rod's length less the clamp angle, for tips at a share of their reach from that."""
    offset = load.reach * share
    quartic = quartic_of(load, offset).quartic
    return offset + 2 * each_atan2(quartic.b, wp_of_one(quartic.g2, quartic.g3) - quartic.c)


def wp_of_one(g2, g3):
    """℘(1): the series at 1/4, or 1/16 in double precision, and the duplication formula."""
    rough = g2.dtype == float32
    square, doublings = (1 / 16, 2) if rough else (1 / 256, 4)
    value = wp_series(g2, g3, square, rough)
    for _ in range(doublings):
        value = wp_doubled(g2, g3, value)
    return value


def wp_along(g2, g3, place, slow):
    """℘ at places in (0, 1], a row for each, which go up. slow: the greatest ℓ√(β + η)."""
    doublings = maximum(ceil(log2(place * (slow / SERIES_SLOW))), 0).astype(int)
    start = place * 0.5**doublings
    value = wp_series(g2, g3, (start * start)[:, None], False)
    for k in range(doublings[-1]):
        first = int(searchsorted(doublings, k, side="right"))
        value[first:] = wp_doubled(g2, g3, value[first:])
    return value


def wp_series(g2, g3, square, rough):
    """℘(z) by z², to the rounding of single precision or of double precision."""
    a, b = g2 * (square * square / 20), g3 * (square * square * square / 28)
    series = a + b + a * a / 3 + a * b * (3 / 11)
    if not rough:
        series = series + (2 * a * a * a / 3 + b * b) / 13
    return (1 + series) / square


def wp_doubled(g2, g3, value):
    """℘(2z) by ℘(z)."""
    squared = value * value
    above = squared + g2 / 4
    return (above * above + 2 * g3 * value) / (value * (4 * squared - g2) - g3)
