"""The tips of many rods to rounding, from the samples on either side of each: ``search.crossing`` on arrays."""

from __future__ import annotations

from typing import Any, NamedTuple

from numpy import abs, arange, bincount, flatnonzero, full, maximum, minimum, nan, where, zeros

from derive.emit.kernels.arithmetic import epsilon, pi
from derive.emit.kernels.array_arithmetic import each_atan2, each_sqrt
from derive.emit.kernels.block_records import AT_ONCE, joined, put_rows, rounded_to, rows
from derive.emit.kernels.motion_each import motion_at_each
from derive.emit.kernels.swing_each import lengths_each, phase_of_each

STEPS = 3  # rough steps, after which most places are right to single precision
MOVING = 1e-6  # a step after which another one is not yet as small as rounding
NOISE = 3  # roundings of the length that the times may have of their own
TOLD = 1e-10  # change of a place from which the change of a length tells the slope
SECANTS = 2  # evaluations before any place is looked at for being right to rounding: next to none is
EASE = 2  # how often the rounding that is taken for none is doubled: times of long rods have more of it
SPREAD = 2.0**-9  # distance of two places from which they tell the slope of a branch in single precision


class Brackets(NamedTuple):
    """Crossings to be found: the range, by its number in the group, the branch, places on either side, and there the
    length of the branch less the rod's. All are of one precision but the first three."""

    range: Any
    turns: Any
    sign: Any
    left: Any
    right: Any
    value_left: Any
    value_right: Any


class Found(NamedTuple):
    """Tips: the range, place and branch, whether it grows with the tip, the motion with its phase and its times."""

    range: Any
    place: Any
    turns: Any
    sign: Any
    rising: Any
    motion: Any
    phase: Any
    swing: Any
    arrival: Any


class Times(NamedTuple):
    """A motion with its phase at the clamp, half-swing and first arrival."""

    motion: Any
    phase: Any
    swing: Any
    arrival: Any


def rough_times(rods, piece, place):
    """Half-swing and first arrival, to the square of a thousandth or the rounding of the numbers given."""
    motion = motion_at_each(rods.beta, rods.eta, rods.field_angle, piece, place)
    phase = phase_of_each(motion)
    a, b, square, rest = motion.end / 2, motion.middle / 2, phase.square, phase.rest
    more = True
    while more:
        more = (abs(a - b) > 1e-3 * a).any()
        delta = each_sqrt(a * a * rest + b * b * square)
        total, below = a + b, a + delta
        ratio = total / below
        inner = a + (a * a + b * b * square) / (delta + b * square)
        square, rest = ratio * ratio * square, 2 * a / below * rest * (inner / below)
        a, b = total / 2, each_sqrt(a * b)
    mean = (a + b) / 2
    return pi / 2 / mean, each_atan2(each_sqrt(square), each_sqrt(rest)) / mean


def surplus(swing, arrival, turns, sign, length):
    """The length of a branch less the rod's."""
    return 2 * turns * swing + sign * arrival - length


def approached(function, given, left, right, value_left, value_right, steps, spread, again=0):
    """Approximate zeros by Chandrupatla's method (1997): places, and the slopes there.

    function(given, places): the values, of the rows of a record. spread: the distance of two places from which they
    tell a slope. again: how often those that still move go through as many steps alone.
    """
    parts = []
    for start in range(0, max(left.size, 1), AT_ONCE):
        some = rows((given, left, right, value_left, value_right), slice(start, start + AT_ONCE))
        parts.append(nearer(function, some, steps, spread))
    place, slope, move, (left, right, value_left, value_right) = joined(parts)
    far = flatnonzero(abs(move) > MOVING) if again else zeros(0, dtype=int)
    if far.size:
        given, left, right, value_left, value_right = rows((given, left, right, value_left, value_right), far)
        again -= 1
        place[far], slope[far] = approached(function, given, left, right, value_left, value_right, steps, spread, again)
    return place, slope


def nearer(function, some, steps, spread):
    """``approached`` after some steps, of a record and ends: places, slopes, the last move, and the new ends."""
    given, a, b, value_a, value_b = some
    slope = (value_a - value_b) / (a - b)
    fraction = full(a.shape, 0.5, dtype=a.dtype)
    secant = value_a / (value_a - value_b)
    inside = (secant > 0.05) & (secant < 0.95)
    fraction[inside] = secant[inside]
    for _ in range(steps):
        trial = a + fraction * (b - a)
        value = function(given, trial)
        same = (value > 0) == (value_a > 0)
        c, value_c = where(same, a, b), where(same, value_a, value_b)
        b, value_b = where(same, b, a), where(same, value_b, value_a)
        a, value_a = trial, value
        near, value_near = where(abs(a - b) < abs(a - c), b, c), where(abs(a - b) < abs(a - c), value_b, value_c)
        slope = where(abs(near - a) > spread, (value_near - value_a) / (near - a), slope)
        fraction, safe = inverse_quadratic(a, b, c, value_a, value_b, value_c)
    # No half way at last: the latest place may be the zero itself.
    step = minimum(maximum(value_a / (slope * (a - b)), 0), 1)
    move = where(safe, fraction, where(value_a == 0, 0, step)) * (b - a)
    return a + move, slope, move, (a, b, value_a, value_b)


def inverse_quadratic(a, b, c, value_a, value_b, value_c):
    """Where on the way from a to b inverse quadratic interpolation puts the zero, half way where it is unsafe; is it
    safe."""
    x, y = (a - b) / (c - b), (value_a - value_b) / (value_c - value_b)
    share = value_a / (value_b - value_a) * value_c / (value_b - value_c)
    share = share + (c - a) / (b - a) * value_a / (value_c - value_a) * value_b / (value_c - value_b)
    safe = (y * y < x) & ((1 - y) * (1 - y) < 1 - x) & (share > 0) & (share < 1)
    return where(safe, share, a.dtype.type(0.5)), safe


def roughly_at(group, brackets, kind):
    """Rough crossings of a group with a row for each: places, and the slope of the branch there."""
    given = rounded_to(group, kind), brackets.turns.astype(kind), brackets.sign.astype(kind)
    ends = brackets.left, brackets.right, brackets.value_left, brackets.value_right
    place, slope = approached(rough_surplus, given, *ends, STEPS, SPREAD)
    return place.astype(float), slope.astype(float)


def rough_surplus(given, place):
    """The surplus of branches of a group at places."""
    some, turns, sign = given
    swing, arrival = rough_times(some.rods, some.piece, place)
    return surplus(swing, arrival, turns, sign, some.rods.length)


def polished(some, brackets, place, slope):
    """The crossings to rounding, by secants from rough ones, and the ranges in which one is not found so.

    some: the group with a row for each.
    """
    wanted, crossed = brackets.range, (brackets.value_left > 0) != (brackets.value_right > 0)
    some, brackets, place, slope = rows((some, brackets, place, slope), crossed)
    least, most = minimum(brackets.left, brackets.right) - 0.01, maximum(brackets.left, brackets.right) + 0.01
    value, before, todo = full(place.shape, nan), place.copy(), arange(place.size)
    settled, found = zeros(place.shape, dtype=bool), Times(None, None, None, None)
    for turn in range(8):
        here, branch = (some, brackets) if todo.size == place.size else rows((some, brackets), todo)
        at, times = place[todo], times_at(here, place[todo])
        found = put_rows(found, todo, times) if turn else times
        now = surplus(times.swing, times.arrival, branch.turns, branch.sign, here.rods.length)
        slope[todo] = steep = secant_slope(at, before[todo], now, value[todo], slope[todo])
        value[todo], before[todo], step = now, at, now / steep
        if turn >= SECANTS:
            blur = epsilon() * 2 ** min(turn - SECANTS, EASE)
            settled[todo] = close = (abs(step) <= blur * (1 + abs(at))) | (abs(now) <= blur * here.rods.length)
            # What is left time and again is rounding of the times themselves; half way leaves less of it.
            step = where(abs(now) <= NOISE * epsilon() * here.rods.length, step / 2, step)
            todo, at, step = todo[~close], at[~close], step[~close]
        place[todo] = at = at - step
        todo = todo[(at >= least[todo]) & (at <= most[todo])]
        if not todo.size:
            break
    rising = (brackets.value_right > brackets.value_left) == (brackets.right > brackets.left)
    tips = rows(Found(brackets.range, place, brackets.turns, brackets.sign, rising, *found), settled)
    return tips, lost_ranges(wanted, tips.range)


def secant_slope(at, before, value, value_before, slope):
    """The slope of a branch by two places, or the one known where they are too near each other."""
    change = at - before
    told = abs(change) > TOLD * (1 + abs(at))
    return where(told, (value - value_before) / where(told, change, 1), slope)


def times_at(group, place):
    """The motions of tips at places of a group, one on each range, and their times."""
    motion = motion_at_each(group.rods.beta, group.rods.eta, group.rods.field_angle, group.piece, place)
    motion = motion._replace(uneven=motion.uneven + 0 * place)  # of an even basin it is a number
    phase = phase_of_each(motion)
    return Times(motion, phase, *lengths_each(motion.end / 2, motion.middle / 2, phase.square, phase.rest))


def lost_ranges(wanted, found):
    """The ranges of which not every crossing has been found: as often as they are wanted."""
    number = bincount(wanted)
    return flatnonzero(number != bincount(found, minlength=number.size))
