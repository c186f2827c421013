"""The tips of rods that are shorter than any two half-swings, all at once: by where motions are after their length.

From a tip φ the motion is at φ + 2 arctan(b/(℘(σ) − c)) (`theory/oblique`), and ℘ follows from its series near 0 by
the duplication formula (DLMF 23.9.2, 23.10.7): no roots, no ranges. On a rod with ℓ√(β + η) < 2π, which no two
half-swings fit, that is a function of φ, whose slope is nowhere more than cosh(ℓ√(β + η)): even steps show its zeros.
"""

from __future__ import annotations

from typing import Any, NamedTuple

from numpy import (
    abs,
    arange,
    argsort,
    bincount,
    clip,
    concatenate,
    cosh,
    flatnonzero,
    float32,
    isfinite,
    linspace,
    maximum,
    minimum,
    nonzero,
    unique,
    where,
    zeros,
)

from derive.emit.kernels.arithmetic import pi
from derive.emit.kernels.array_arithmetic import each_atan2, each_cos, each_sin
from derive.emit.kernels.block_records import rounded_to, rows
from derive.emit.kernels.block_roots import approached

SHOT_SLOW = 1.2 * pi  # ℓ√(β + η) up to which this takes less time than samples of ranges
SHOTS = 512  # rods at once
EVEN = 2.0  # step between tips, over the steepest slope
STRAIGHT = 1e-9  # a couple at the clamp times the length squared from which rods are not nearly straight
FINE = 9  # tips about an extremum
LOOKS = 4  # each at so many tips nearer to it
AIMS = 4  # steps towards a zero
AGAIN = 4  # as often for those that are still far
AIM_SPREAD = 1e-6  # distance of two shares from which they tell a slope


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


class Shots(NamedTuple):
    """Tips, sorted by ``key``: twice the rod's number, and 1 more for a tip above the clamp angle.

    first, number: of those with a key; offset: tip less clamp angle; slope: ∂θ(0)/∂θ(ℓ).
    """

    first: Any
    number: Any
    offset: Any
    slope: Any


def load_of(rods):
    """The load of rods."""
    square = rods.length * rods.length
    twice = 2 * rods.field_angle + zeros(rods.case.shape)
    reach = minimum((rods.beta + rods.eta / 2) * square / 2, 2 * pi) * (1 + 1e-3)
    return Load(rods.beta * square, rods.eta * square, each_cos(twice), each_sin(twice), rods.clamp_angle, reach)


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


def is_shot(rods):
    """Which rods are short, and not nearly straight."""
    lean = rods.clamp_angle - rods.field_angle
    couple = rods.beta * each_sin(rods.clamp_angle) + rods.eta / 2 * each_sin(2 * lean)
    return (rods.slow < SHOT_SLOW) & (abs(couple) * rods.length * rods.length > STRAIGHT)


def shots_of(rods, size):
    """All tips of short rods, and the numbers of the rods of which they are not sure."""
    load = load_of(rods)
    crossed, turned, unsure = sampled_shots(load, rods.slow)
    beside, hard = beside_extrema(load, turned)
    which, left, right, before, after = (concatenate(pair) for pair in zip(crossed, beside, strict=True))
    some = rows(load, which)
    ends = left, right, before, after
    share, slope = approached(lambda trial, row: miss(rows(some, row), trial), *ends, AIMS, AIM_SPREAD, AGAIN)
    key = 2 * rods.case[which] + (share > 0)
    order = argsort(key, kind="stable")
    number = bincount(key, minlength=2 * size)
    offset, slope = (share * some.reach)[order], (slope / some.reach)[order]
    return Shots(number.cumsum() - number, number, offset, slope), unique(concatenate([unsure, hard]))


def sampled_shots(load, slow):
    """Brackets, extrema that may reach beyond zero, and the rods without values.

    Brackets have the rod, shares of its reach on either side and what is missed there; extrema have the rod, the
    shares beside, what is missed there, and on which side of zero they are.
    """
    rough, none = rounded_to(load, float32), zeros(0, dtype=int)
    brackets, turned, lost = [[none, *[zeros(0)] * 4]], [[none, *[zeros(0)] * 4, none]], [none]
    for start in range(0, slow.size, SHOTS):
        here = slice(start, start + SHOTS)
        steps = int(2 * (load.reach[here] * cosh(slow[here])).max() / EVEN)
        shares = linspace(-1, 1, 16 + steps)
        values = miss(rows(rough, here), shares.astype(float32)[:, None])
        lost.append(flatnonzero(~isfinite(values.sum(axis=0))) + start)
        row, which = nonzero((values[1:] > 0) != (values[:-1] > 0))
        brackets.append([which + start, shares[row], shares[row + 1], values[row, which], values[row + 1, which]])
        turned.append(turned_at(shares, values, start))
    parts = ([concatenate(part) for part in zip(*found, strict=True)] for found in (brackets, turned))
    return *parts, concatenate(lost)


def turned_at(shares, values, start):
    """The extrema among samples that may reach beyond zero between them."""
    grows = values[1:] > values[:-1]
    row, which = nonzero(grows[1:] != grows[:-1])
    before, middle, after = (values[row + k, which] for k in range(3))
    near = abs(middle) < maximum(abs(before - middle), abs(after - middle))
    near &= (abs(middle) <= abs(before)) & (abs(middle) <= abs(after))
    near &= ((middle > 0) == (before > 0)) & ((middle > 0) == (after > 0))
    row, which = row[near], which[near]
    return [which + start, shares[row], shares[row + 2], before[near], after[near], where(middle[near] > 0, 1, -1)]


def beside_extrema(load, turned):
    """Brackets beside extrema that reach beyond zero, and the rods of which that is not sure."""
    which, first, last, before, after, side = turned
    some, left, right = rows(load, which), first, last
    column, single = arange(which.size), True
    for _ in range(LOOKS):
        finer = left + (right - left) * linspace(0, 1, FINE)[:, None]
        value = side * miss(some, finer)
        single = single & (((value[1:] < 0) != (value[:-1] < 0)).sum(axis=0) <= 2)
        best = clip(value.argmin(axis=0), 1, FINE - 2)
        left, right = finer[best - 1, column], finer[best + 1, column]
    middle, least = finer[best, column], value[best, column]
    margin = 1e-9 * some.reach
    beyond = single & (least < -margin)
    hard = ~beyond & (2 * least <= maximum(value[best - 1, column], value[best + 1, column]) + margin)
    one = which, first, middle, before, side * least
    other = which, middle, last, side * least, after
    return [concatenate(pair)[concatenate([beyond, beyond])] for pair in zip(one, other, strict=True)], which[hard]
