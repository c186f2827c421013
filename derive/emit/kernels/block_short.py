"""The equilibria of short rods by their tips alone: no directions of equilibrium, no ranges of tip angles.

From a tip φ the motion is at φ + δ, e^{iδ} = (℘ − c + ib)/(℘ − c − ib) (`theory/oblique`). Position and energy are
integrals of that and of its square along the rod; it is even in the arc length from the tip, so half the points of
Gauss and Legendre on the rod and its continuation beyond the tip serve.

The index is the number of zeros of h = ∂θ/∂θ(ℓ) along the rod. h″ = (dθ″/dθ)h, |dθ″/dθ| ≤ β + η, from 1 and 0 at the
tip: by Sturm the first zero is π/2 or more from there over √(β + η), the second π more. So a rod with ℓ√(β + η) < 3π/2
has one at most, and it has one where h < 0 at the clamp.
"""

from __future__ import annotations

from functools import cache
from math import ceil
from typing import Any, NamedTuple

from numpy import arange, argsort, cos, empty, ldexp, where

from derive.emit.kernels.arithmetic import pi
from derive.emit.kernels.block_arrivals import Quartic, ahead_along, aim_at, load_of, missed_by
from derive.emit.kernels.block_records import joined, rows
from derive.emit.kernels.block_tips import Columns, no_columns

POINTS_PER = 8.9  # points for each unit of ℓ√(β + η), and
POINTS_MORE = 2.8  # as many more, which leave out less than 2⁻⁵³ of the integral (docs/solver.md)
VALUES = 8192  # points of rods at once: arrays that stay in the cache
REFINED = 4  # Newton's steps to a root of a Legendre polynomial: of the last one the weight would show half the digits


class Bent(NamedTuple):
    """Integrals along a rod of length 1, δ = θ − θ(ℓ): of cos δ − 1, sin δ, cos 2δ − 1 and sin 2δ."""

    cosine: Any
    sine: Any
    double_cosine: Any
    double_sine: Any


def short_rods(rods, shots, most):
    """The equilibria of short rods, by their shots."""
    if not shots.rod.size:
        return no_columns()
    index = where(shots.rising, 0, 1)
    shots, index = rows((shots, index), index <= most)
    some = rows(rods, shots.rod)
    load = load_of(some)
    offset, tip = corrected(load, shots)
    bent = bent_along(tip.quartic, some.slow)
    beta, eta, length, unit = some.beta, some.eta, some.length, ldexp(1.0, some.scale)
    cosine, sine, double_cosine, double_sine = tip.heading
    cosine, sine = load.facing * cosine, load.facing * sine
    y, z = bent.cosine * cosine - bent.sine * sine, bent.cosine * sine + bent.sine * cosine
    gamma = 2 * beta * cosine + eta * (1 + double_cosine) / 2
    doubled = bent.double_cosine * double_cosine - bent.double_sine * double_sine
    turned = double_sine + bent.double_cosine * double_sine + bent.double_sine * double_cosine
    moment = beta * (sine + z) + eta / 2 * turned  # the mean of θ″ along the rod
    energy = -(gamma / 2 + 2 * beta * y + eta / 2 * doubled) * length
    return Columns(
        some.case,
        0 * index,
        offset,
        some.clamp_angle + offset,
        -moment * length * unit,
        gamma * unit * unit,
        (cosine + y) * length / unit,
        (sine + z) * length / unit,
        energy * unit,
        index,
    )


def corrected(load, shots):
    """The offsets and tips, nearer than numbers are to each other.

    At the clamp rounding of the tip angle shows up to cosh(ℓ√(β + η)) times. A last step of Newton's is therefore made
    in p, by q = dp/dθ(ℓ): that is far more exact next to a hill, where it matters. All else may be off by a rounding.
    """
    tip = aim_at(load, shots.offset)
    b, q, linear, last = tip.quartic
    step = -missed_by(tip.quartic, shots.offset) / shots.slope
    ratio = 1 + q * step / (4 * b)
    return shots.offset + step, tip._replace(quartic=Quartic(b * ratio, q, linear * ratio, last * ratio * ratio))


def bent_along(quartic, slow):
    """The integrals along rods, by their quartics and ℓ√(β + η): those of like length together."""
    order, start, parts = argsort(slow), 0, []
    while start < slow.size:
        # As many points as the longest of these needs.
        size = max(VALUES // points_for(slow[order[start]]), 1)
        some = order[start : start + size]
        parts.append(integrals(rows(quartic, some), slow[some[-1]]))
        start += size
    back = empty(order.size, dtype=int)
    back[order] = arange(order.size)
    return rows(joined(parts), back)


def points_for(slow):
    """How many points a rod needs, even numbers only."""
    return 2 * ceil((POINTS_PER * slow + POINTS_MORE) / 2)


def integrals(quartic, slow):
    """The integrals along rods of which ``slow`` is the greatest ℓ√(β + η)."""
    place, weight = half_of_gauss(points_for(slow))
    b, ahead = quartic.b, ahead_along(quartic, place, slow)
    share = 1 / (ahead * ahead + b * b)
    across = ahead * share
    # sin δ = 2b·across, 1 − cos δ = 2b²·share.
    first, second = weight @ across, weight @ share
    third, fourth = weight @ (across * across), weight @ (across * share)
    square = b * b
    return Bent(-2 * square * second, 2 * b * first, -8 * square * third, 4 * b * first - 8 * b * square * fourth)


@cache
def half_of_gauss(number):
    """The positive ones of twice as many points of Gauss and Legendre on [−1, 1], from the least up, and weights that
    add up to 1: Newton's method from Tricomi's approximations."""
    degree = 2 * number
    angle = (arange(number, 0, -1) - 0.25) / (degree + 0.5) * pi
    place = (1 - (degree - 1) / (8 * degree**3)) * cos(angle)
    for _ in range(REFINED):
        before, value = 1.0, place
        for k in range(2, degree + 1):
            before, value = value, ((2 * k - 1) * place * value - (k - 1) * before) / k
        slope = degree * (before - place * value) / (1 - place * place)
        place = place - value / slope
    weight = 1 / ((1 - place * place) * slope * slope)
    return place, weight / weight.sum()
