"""All tips whose rod has the given length: every sign change of every branch of the time map.

From a tip at rest the rod swings between the tip angle and the other turning point. It meets the clamp angle at
the lengths 2nH + t and 2nH − t, with H the half-swing and t the first arrival: a branch for each n and sign. On a
piece each branch is a smooth function of the tip that tends to known values at the ends, so its crossings of the
rod's length are found from a grid fine in the logarithm of the distance to both ends, and from the extrema that
could touch the length between grid points.
"""

from __future__ import annotations

from typing import NamedTuple

from derive.emit.kernels.arithmetic import ceil, epsilon, log, sqrt
from derive.emit.kernels.timing import Timing, timing_of
from derive.emit.kernels.tips import tip_at


class Crossing(NamedTuple):
    """A tip whose rod has the right length, on branch 2·turns·H + sign·t; ``rising``: the branch grows with the tip."""

    place: float
    turns: int
    sign: int
    rising: bool


def crossings(beta, eta, length, clamp, piece):
    """Every crossing of the rod's length on a piece, as a list of Crossing."""
    places = grid(beta, eta, length, clamp, piece)

    def timing(place):
        return timing_of(beta, eta, clamp, tip_at(beta, eta, clamp, piece, place))

    timings = [timing(place) for place in places]
    timings[-1] = end_timing(piece, timings[-1])
    found = []
    shortest = min(item.swing for item in timings)
    for turns in range(int(length / (2 * shortest)) + 2):
        for sign in (1, -1) if turns else (1,):

            def excess(item, turns=turns, sign=sign):
                return (2 * turns * item.swing if turns else 0) + sign * item.arrival - length

            values = [excess(item) for item in timings]
            for bracket in brackets(places, values, lambda place, f=excess: f(timing(place))):
                place = bracketed_root(lambda place, f=excess: f(timing(place)), *bracket)
                found.append(Crossing(place, turns, sign, bracket[3] > 0))
    return found


def grid(beta, eta, length, clamp, piece):
    """Places that part the branches finely: half a unit in the logarithm of the distance to either end.

    At the top and at the side the rod is too long beyond the first place. At the other ends one far place stands
    for the end itself: the branches tend to it steadily.
    """
    rounding = 2 - log(epsilon())
    slow = length * sqrt(beta + eta)
    first = -slow - 4
    last = rounding
    if piece.high_kind == "level":
        last += slow
    elif piece.high_kind != "rest":
        # The tip of a stiff rod departs from the clamp angle by half the moment there times the length squared.
        moment = abs(clamp.drive) * sqrt(clamp.one_plus * clamp.one_minus)
        last = max(rounding, 4 + log(2 * piece.width) - log(moment) - 2 * log(length))
    places = [first + 0.5 * k for k in range(ceil(2 * (last - first)) + 1)]
    before = [first - 2 * rounding - slow] if piece.low_kind == "level" else []
    after = [places[-1] + 2 * rounding + slow] if piece.high_kind != "rest" else []
    return [*before, *places, *after]


def end_timing(piece, last):
    """The timing at the high end itself, where it is known: arrival at once, or after the whole half-swing."""
    if piece.high_kind == "clamp":
        return Timing(last.swing, 0)
    if piece.high_kind == "turn":
        return Timing(last.swing, last.swing)
    return last


def brackets(places, values, function):
    """Pairs of places with values of opposite sign, those around an extremum between grid points included."""
    found = []
    for k in range(1, len(places)):
        if (values[k - 1] > 0) != (values[k] > 0):
            found.append((places[k - 1], places[k], values[k - 1], values[k]))
    for k in range(1, len(places) - 1):
        before, here, after = values[k - 1], values[k], values[k + 1]
        if (before > 0) == (here > 0) == (after > 0) and abs(here) <= min(abs(before), abs(after)):
            place, value = dip(function, places[k - 1], places[k], places[k + 1], values[k - 1 : k + 2])
            if (value > 0) != (here > 0):
                found.append((places[k - 1], place, before, value))
                found.append((place, places[k + 1], value, after))
    return found


def dip(function, left, middle, right, values):
    """The place nearest to zero between left and right by golden sections, or the first beyond zero."""
    best, positive = values[1], values[1] > 0
    if abs(best) > 4 * max(abs(values[0] - best), abs(values[2] - best)):
        return middle, best
    golden = (3 - sqrt(5)) / 2
    while abs(right - left) > 2 * sqrt(epsilon()) * (1 + abs(middle)):
        wide_right = right - middle > middle - left
        trial = middle + golden * (right - middle) if wide_right else middle - golden * (middle - left)
        value = function(trial)
        if (value > 0) != positive:
            return trial, value
        if abs(value) < abs(best):
            left, right = (middle, right) if wide_right else (left, middle)
            middle, best = trial, value
        elif wide_right:
            right = trial
        else:
            left = trial
    return middle, best


def bracketed_root(function, a, b, value_a, value_b):
    """A sign change of the function between a and b, to rounding, by Chandrupatla's method (1997)."""
    fraction = 0.5
    while True:
        trial = a + fraction * (b - a)
        value = function(trial)
        if (value > 0) == (value_a > 0):
            c, value_c = a, value_a
        else:
            c, value_c, b, value_b = b, value_b, a, value_a
        a, value_a = trial, value
        best, value_best = (a, value_a) if abs(value_a) < abs(value_b) else (b, value_b)
        least = 2 * epsilon() * (1 + abs(best)) / abs(b - a)
        if least > 0.5 or value_best == 0:
            return best
        fraction = min(1 - least, max(least, interpolated(a, b, c, value_a, value_b, value_c)))


def interpolated(a, b, c, value_a, value_b, value_c):
    """Where on the way from a to b inverse quadratic interpolation puts the zero, or half way where it is unsafe."""
    x, y = (a - b) / (c - b), (value_a - value_b) / (value_c - value_b)
    if y * y >= x or (1 - y) * (1 - y) >= 1 - x:
        return 0.5
    share = value_a / (value_b - value_a) * value_c / (value_b - value_c)
    return share + (c - a) / (b - a) * value_a / (value_c - value_a) * value_b / (value_c - value_b)
