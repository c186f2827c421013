"""The tips of a rod that is shorter than any two half-swings, by where its motions are after its length.

From a tip φ the motion is at φ + 2 arctan(b/(℘(σ) − c)) (``theory/oblique``), and ℘ follows from its series near 0 by
the duplication formula (DLMF 23.9.2, 23.10.7): no roots, no ranges. On a rod with ℓ√(β + η) < 2π, which no two
half-swings fit, that is one function of the tip angle, and what bounds its second derivative tells how many zeros lie
between two samples.
"""

from __future__ import annotations

from typing import NamedTuple

from derive.emit.kernels.arithmetic import atan2, cos, exp, floor, less_quarters, pi, sin, sqrt
from derive.emit.kernels.formulas import shot_bend
from derive.emit.kernels.roots import smooth_root

SHORT_SLOW = 1.4 * pi  # ℓ√(β + η) up to which this takes less time than samples of ranges
LEVEL = 1e-9  # a couple at the clamp times the length squared from which rods are not nearly straight
CLOSEST = 2.0**-26  # least distance of samples, as a share of how far a tip may be from the clamp angle
UNSURE = 1e-10  # as a share of the same, what is missed of which the hundredth part may be wrong
SLACK = 0.02  # by how much more than the bound samples must be apart for that
REACH = 1e-3  # by how much more than a bound tips are looked for
ALIKE = 4e-16  # as ``UNSURE``, what rounding may have made of zero
SHOT_SERIES_SLOW = 0.6  # ℓ√(β + η) up to which the series of ℘ is right to 3e-13


class Shot(NamedTuple):
    """A tip, by its offset from the clamp angle; rate: ∂θ(0)/∂θ(ℓ)."""

    offset: float
    rate: float


def tip_shots(beta, eta, field_angle, length, clamp_angle):
    """All tips of a short rod, as Shots from the lowest up; None if it is not short, or samples leave a doubt."""
    slow, square = length * sqrt(beta + eta), length * length
    if slow > SHORT_SLOW:
        return None
    beta, eta = beta * square, eta * square
    clamp = less_quarters(clamp_angle, 4 * floor(clamp_angle / (2 * pi) + 0.5))
    if abs(beta * sin(clamp) + eta / 2 * sin(2 * (clamp - field_angle))) < LEVEL:
        return None
    missed = miss_of(beta, eta, field_angle, clamp, slow)
    # θ″ is nowhere more than β + η/2, and no motion is wider than a turn.
    reach = (1 + REACH) * min((beta + eta / 2) / 2, 2 * pi)
    sag = shot_bend(beta, eta, (exp(slow / 2) - exp(-slow / 2)) ** 2 / 2) / 2
    samples = samples_apart(missed, reach, sag)
    return None if samples is None else zeros_between(missed, samples[0], samples[1], sag, ALIKE * reach)


def mirror_shots(shots):
    """The tips of the rod seen from the other side of the y axis."""
    return [Shot(-shot.offset, shot.rate) for shot in shots[::-1]]


def miss_of(beta, eta, field_angle, clamp_angle, slow):
    """The angle at arc length 0 of a motion from a tip, less the clamp angle: a function of the tip's offset from it.

    The rod's length is 1; slow: √(β + η).
    """
    # ℘ by its series on a part of the rod, and by as many doublings as make that the whole.
    doublings, share = 0, 1.0
    while slow * share > SHOT_SERIES_SLOW:
        doublings, share = doublings + 1, share / 2
    force, field, steps = beta * share * share, eta * share * share, range(doublings)

    def missed(offset):
        tip = clamp_angle + offset
        double = 2 * (tip - field_angle)
        across, half = force * sin(tip), field / 2 * sin(double)
        along, p, quarter = force * cos(tip), across + half, (across - half) * (across + half) / 4
        c = (along + field * cos(double)) / 12
        square = c * c
        g2, g3 = 12 * square - quarter, (quarter - 8 * square) * c - along * p * p / 16
        a, b, fourth, twice = g2 / 20, g3 / 28, g2 / 4, 2 * g3
        value = 1 + a * (1 + a * (1 / 3 + a * (2 / 39)) + b * (3 / 11 + a * (2 / 33))) + b * (1 + b / 13)
        for _ in steps:
            squared = value * value
            above = squared + fourth
            value = (above * above + twice * value) / (value * (4 * squared - g2) - g3)
        return offset + 2 * atan2(p / 4, value - c)

    return missed


def samples_apart(function, reach, sag):
    """Places and the values there, such that one zero or none lies between two; None where there is a doubt.

    The function is above the chord between two places by no more than sag·width²/4. Where its values are on one side
    of zero it has none between if the sum of their square roots is more than the width times √sag; and where their
    sum is more than sag·width² it rises or falls all the way.
    """
    before, start, bound = -reach, function(-reach), (1 + SLACK) * sag
    places, values, todo = [before], [start], [(reach, function(reach)), (0, function(0))]
    while todo:
        place, value = todo[-1]
        width, both = place - before, value * start
        apart = abs(value - start) if both < 0 else abs(value + start) + 2 * sqrt(both)
        if apart > bound * width * width:
            places.append(place)
            values.append(value)
            before, start = todo.pop()
        elif width < CLOSEST * reach:
            return None
        else:
            middle = place - width / 2
            todo.append((middle, function(middle)))
    return None if min(abs(value) for value in values) < UNSURE * reach else (places, values)


def zeros_between(function, places, values, sag, blur):
    """The zeros between the places, as Shots; sag: as in ``samples_apart``. blur: what rounding may make of zero."""
    found = []
    for k in range(1, len(places)):
        if (values[k] > 0) != (values[k - 1] > 0):
            beside = k + 1 if k + 1 < len(places) else k - 2
            near = (k - 1, k, beside) if abs(values[k - 1]) < abs(values[k]) else (k, k - 1, beside)
            known = [places[i] for i in near], [values[i] for i in near]
            found.append(Shot(*smooth_root(function, *known, sag, blur)))
    return found
