"""To which ranges, and to which places there, the tips of short rods belong; and these to rounding."""

from __future__ import annotations

from derive.emit.kernels.arithmetic import epsilon, log, pi, sqrt
from derive.emit.kernels.motion import motion_at
from derive.emit.kernels.search import Crossing, excess
from derive.emit.kernels.swing import speed_at
from derive.emit.kernels.time_map import Stay, sample_of

NEAR = 0.5  # how far a tip may be from where it was aimed, as a difference of places
DEEP = 30  # places beyond which tips are told by other means
TRIES = 24
WITHIN = 2  # spacings of the length to which time maps are right


def hits(beta, eta, field_angle, length, ranges, shots):
    """All (range, crossing) from Shots below the clamp angle, from the lowest up; None where one is not found."""
    found: list[tuple] = []
    long = length * sqrt(beta + eta) >= pi
    for piece in ranges:
        for shot in shots[len(found) :]:
            drop = -shot.offset - piece.clamp_gap
            if not 0 < drop < piece.width:
                break
            crossing = tip_on(beta, eta, field_angle, length, piece, drop, shot.rate, long)
            if crossing is None:
                return None
            found.append((piece, crossing))
        if len(found) == len(shots):
            return found
    return None


def tip_on(beta, eta, field_angle, length, piece, drop, rate, long):
    """The crossing of a tip below the high end of a range; None where there is none near it.

    rate: ∂θ(0)/∂θ(ℓ) for a rod of this length. long: half-swings may fit the rod.
    """
    rise = piece.width - drop
    place = log(rise / drop)
    if not abs(place) < DEEP:
        return None

    def sample(there):
        # No place is so deep that the rod is straight for a part of its length.
        return sample_of(there, Stay(motion_at(beta, eta, field_angle, piece, there), 0, 0, 0, 0))

    return crossing_near(sample, place, rate * rise * drop / piece.width, length, long)


def crossing_near(sample, start, rate, length, long):
    """The crossing near a place by secants; None where there is none. rate: ∂θ(0)/∂place, for a rod of this length.

    long: half-swings may fit the rod.
    """
    item, place = sample(start), start
    back = long and abs(2 * item.swing - item.arrival - length) < abs(item.arrival - length)
    turns, sign = (1, -1) if back else (0, 1)
    slope, value = -sign * rate / speed_at(item.stay.motion, item.phase), excess(item, turns, sign, length)
    rising, blur = slope > 0, WITHIN * epsilon() * length
    for _ in range(TRIES):
        step = value / slope
        if abs(value) <= blur or (abs(step) < epsilon() * (1 + abs(place)) and abs(value) < 8 * blur):
            return Crossing(item, turns, sign, rising)
        trial = place - step
        if not abs(trial - start) < NEAR:
            return None
        new = sample(trial)
        missed = excess(new, turns, sign, length)
        if 2 * abs(missed) > abs(value) and abs(value) < 8 * blur:  # what is left is rounding
            return Crossing(new if abs(missed) < abs(value) else item, turns, sign, rising)
        if abs(step) > epsilon() ** 0.75 * (1 + abs(place)):
            slope = (missed - value) / (trial - place)
        item, place, value = new, trial, missed
    return None
