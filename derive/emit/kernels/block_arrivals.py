"""Where motions from rest at a tip are after the length of a short rod, on arrays.

From a tip φ the motion is at φ + 2 arctan(b/(℘(σ) − c)) (`theory/oblique`), and ℘ follows from its series near 0 by
the duplication formula (DLMF 23.9.2, 23.10.7): no roots, no ranges.
"""

from __future__ import annotations

from typing import Any, NamedTuple

from numpy import float32, floor, minimum, zeros

from derive.emit.kernels.arithmetic import pi
from derive.emit.kernels.array_arithmetic import each_atan2, each_cos, each_less_quarters, each_sin


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


def miss(load, share):
    """The angle after the rod's length less the clamp angle, for tips at a share of their reach from that."""
    offset = load.reach * share
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
    value = wp_of_one(g2, g3)
    return offset + 2 * each_atan2(p / 4, value - c)


def wp_of_one(g2, g3):
    """℘(1): the series at 1/4, or 1/16 in double precision, and the duplication formula."""
    rough = g2.dtype == float32
    square, doublings = (1 / 16, 2) if rough else (1 / 256, 4)
    a, b = g2 * (square * square / 20), g3 * (square * square * square / 28)
    series = a + b + a * a / 3 + a * b * (3 / 11)
    if not rough:
        series = series + (2 * a * a * a / 3 + b * b) / 13
    value = (1 + series) / square
    for _ in range(doublings):
        squared = value * value
        above = squared + g2 / 4
        value = (above * above + 2 * g3 * value) / (value * (4 * squared - g2) - g3)
    return value
