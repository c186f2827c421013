"""All tips whose rod has the given length: every crossing of the branches of the time map.

A motion meets the clamp angle at the lengths 2nH + t and 2nH − t, with H the half-swing and t the first arrival. So
the tips wanted are those at which (ℓ − t)/(2H) or (ℓ + t)/(2H) is a whole number: two functions of the tip, smooth on a
piece, whose crossings of whole numbers are found from samples, and from the extrema that could reach one.
"""

from __future__ import annotations

from typing import NamedTuple

from derive.emit.kernels.arithmetic import ceil, deepest, epsilon, floor, log, pi, sqrt
from derive.emit.kernels.landscape import astroid_cusp, ridge_couple
from derive.emit.kernels.motion import Motion, motion_at
from derive.emit.kernels.pieces import fall, reach, slope
from derive.emit.kernels.swing import times


class Crossing(NamedTuple):
    """A tip whose rod has the right length, on branch 2·turns·H + sign·t; ``rising``: the branch grows with the tip."""

    place: float
    turns: int
    sign: int
    rising: bool


class Sample(NamedTuple):
    """Half-swing and first arrival at a place of a piece."""

    place: float
    swing: float
    arrival: float


class Delay(NamedTuple):
    """By how much a motion lasts longer when the place goes deeper by one, where that is all that changes.

    Near an end the rod is straight for long along the directions at which the motion nearly rests: at the tip, in the
    middle, and at the far turning point. arrival: the share of ``middle`` before the first arrival.
    """

    deepest: float
    tip: float
    middle: float
    far: float
    arrival: float


class Stay(NamedTuple):
    """A motion, and the lengths for which it stays near its tip, its middle, and its far turning point besides."""

    motion: Motion
    tip: float
    middle: float
    far: float
    arrival: float


def delays(piece):
    """The delays at both ends, beyond the depth at which squares of offsets would underflow."""
    basin, depth = piece.basin, deepest(piece.width)
    if basin.hill.stiffness < epsilon() ** 8:  # so flat that the moment is as the cube of the offset
        depth = 2 * depth / 3
    # With next to no moment at the clamp a rod is straight but for an offset whose square would underflow.
    straight = piece.high_kind == "clamp" and abs(piece.clamp_offset) < epsilon() ** 5
    far, none = slowness(basin.far), Delay(2 * depth if straight else depth, 0, 0, 0, 0)
    if piece.low_kind == "level":
        return Delay(depth, 0, 0, far / 2, 0), none
    low = Delay(depth, slowness(basin.hill), 0, far if basin.far_rise == 0 else 0, 0)
    if piece.high_kind != "level":
        return low, none
    ridge = slowness(basin.axis)
    behind = ridge_offset(piece)
    return low, Delay(depth, 0, ridge, 0, ridge if behind > 0 else ridge / 2 if behind == 0 else 0)


def slowness(hill):
    """Length per unit of the logarithm of the distance from a hill; a flat one is never come near enough to count."""
    return 1 / sqrt(hill.stiffness) if hill.stiffness > 0 else 0


def ridge_offset(piece):
    """Clamp less ridge, for a motion that passes the ridge."""
    ridge, rest = piece.basin.axis, piece.clamp_rest
    return piece.clamp_offset if rest.angle == ridge.angle else rest.angle - ridge.angle


def stay_at(beta, eta, field_angle, piece, ends, place):
    """The motion of the tip at a place, however deep."""
    low, high = ends
    delay = low if place < 0 else high
    depth = min(abs(place), delay.deepest)
    more = abs(place) - depth
    motion = motion_at(beta, eta, field_angle, piece, -depth if place < 0 else depth)
    return Stay(motion, more * delay.tip, more * delay.middle, more * delay.far, more * delay.arrival)


def sample_at(beta, eta, field_angle, piece, ends, place):
    """The sample at a place."""
    stay = stay_at(beta, eta, field_angle, piece, ends, place)
    swing, arrival = times(stay.motion)
    return Sample(place, swing + stay.tip + stay.middle + stay.far, arrival + stay.tip + stay.arrival)


def crossings(beta, eta, field_angle, length, piece, most):
    """Every crossing of the rod's length on a piece whose index can be at most ``most``, as a list of Crossing."""
    ends = delays(piece)

    def sample(place):
        return sample_at(beta, eta, field_angle, piece, ends, place)

    # No half-swing is shorter than that of the stiffest pendulum.
    signs = (1,) if length * sqrt(beta + eta) < pi else (1, -1)
    samples = refined(sample, [sample(place) for place in places(beta, eta, field_angle, length, piece)], length)
    end = end_sample(piece, samples[-1])
    if end is not None:
        samples.append(end)
    found = []
    for sign in signs:
        counts = [(length - sign * item.arrival) / (2 * item.swing) for item in samples]
        for turns, before, after, beside in brackets(sample, samples, counts, length, sign):
            # At least 2·turns − 1 conjugate points, or one more on the branch that has gone on.
            if (turns or sign > 0) and 2 * turns - (sign < 0) <= most:
                found.append(crossing(sample, turns, sign, length, before, after, beside))
    return found


def excess(item, turns, sign, length):
    """The length of a branch less the rod's."""
    return (2 * turns * item.swing if turns else 0) + sign * item.arrival - length


def crossing(sample, turns, sign, length, before, after, beside):
    """The crossing between two samples on either side of it; a third one beside them helps to start."""

    def function(place):
        return excess(sample(place), turns, sign, length)

    low, high = excess(before, turns, sign, length), excess(after, turns, sign, length)
    third = excess(beside, turns, sign, length)
    points = (before.place, after.place, beside.place), (low, high, third)
    place = bracketed_root(function, *points, epsilon() * length)
    return Crossing(place, turns, sign, high > low)


def places(beta, eta, field_angle, length, piece):
    """Places to begin with, closer around the level at which the motion meets a ridge that is not quite there."""
    found, basin = grid(beta, eta, length, piece), piece.basin
    if basin.even or basin.passes or piece.low_kind == "level" or basin.far.quarters - basin.hill.quarters != 4:
        return found
    angle = abs(field_angle)
    cusp = angle + pi + astroid_cusp(angle)
    # How far η is below the value at which the ridge would appear.
    missing = max(-ridge_couple(beta, eta, angle, astroid_cusp(angle)) / (beta + eta), epsilon())
    cusp = cusp if field_angle > 0 else 2 * pi - cusp
    down = basin.well.angle - basin.hill.angle
    rise = reach(eta, basin.hill, fall(eta, basin.hill, 0, cusp - basin.hill.angle), down, 1)
    if missing > 0.3 or not 0 < rise < piece.width:
        return found
    middle = log(rise / (piece.width - rise))
    # The range of tips that it slows down shrinks with the power 3/2.
    steps = [0.25**k for k in range(ceil(1.1 * log(1 / missing)) + 3)]
    around = [middle, *(middle - step for step in steps), *(middle + step for step in steps)]
    return sorted([*found, *(place for place in around if found[0] < place < found[-1])])


def grid(beta, eta, length, piece):
    """Places to begin with: near enough where the branches bend, and to where none of them is as short as the rod."""
    rounding = -log(epsilon())
    slow = length * sqrt(beta + eta)
    first = -2 * slow - 6 if piece.low_kind == "level" else -slow - 6
    first = min(first, -rounding) if piece.low_kind == "level" else first
    if piece.high_kind == "level":
        last = 2 * slow + rounding
    elif piece.high_kind == "turn":
        last = 2 * rounding
    elif piece.high_depth == 0:
        last = rounding
    else:
        # The tip of a stiff rod departs from the clamp angle by half the moment there times the length squared.
        moment = abs(slope(eta, piece.clamp_rest, piece.clamp_offset)) + epsilon() ** 20
        last = max(rounding, 4 + log(2 * piece.width) - log(moment) - 2 * log(length))
        last = min(last, 2 * deepest(piece.width))
    inner = [0.0]
    for side, end in ((-1, -first), (1, last)):
        inner += [side * place for place in (1.25, 2.5, 5.0, 10.0) if place < end]
        inner.append(side * end)
    return sorted(inner)


def refined(sample, samples, length):
    """More samples where half-swing or arrival bend between neighbours, as far as the rod's length is sensitive."""
    done, todo = [samples[0]], samples[:0:-1]
    while todo:
        before, after = done[-1], todo[-1]
        apart = after.place - before.place > 1.3
        beside = [(done[-2], before, after)] if len(done) > 1 else []
        beside += [(before, after, todo[-2])] if len(todo) > 1 else []
        if apart and any(bends(one, two, three, length) for one, two, three in beside):
            todo.append(sample((before.place + after.place) / 2))
        else:
            done.append(todo.pop())
    return done


def bends(first, second, third, length):
    """Whether the curves bend so much at the second sample that a count may reach a whole number unseen beside it.

    By how far the straight line through two samples misses the third.
    """
    share = (third.place - second.place) / (second.place - first.place)
    swing = third.swing - second.swing - share * (second.swing - first.swing)
    arrival = third.arrival - second.arrival - share * (second.arrival - first.arrival)
    least = min(first.swing, second.swing, third.swing)
    reach = (abs(arrival) + (length / least * abs(swing) if length > least else 0)) / (2 * least)
    for sign in (1, -1):
        for item in (first, second, third):
            count = (length - sign * item.arrival) / (2 * item.swing)
            whole = floor(count + 0.5)
            if abs(count - whole) < reach and (whole > 0 or (whole == 0 and sign > 0)):
                return True
    return False


def end_sample(piece, last):
    """The high end itself, where its times are known: arrival at once, or after the whole half-swing."""
    if piece.high_kind == "clamp" and piece.clamp_gap == 0 and piece.high_depth > 0:
        return Sample(last.place + 1e3, last.swing, 0 * last.swing)
    if piece.high_kind == "turn":
        return Sample(last.place + 1e3, last.swing, last.swing)
    return None


def brackets(sample, samples, counts, length, sign):
    """(turns, sample, sample, a third) for every whole number that the count crosses between the two samples."""
    found = []
    for k in range(1, len(samples)):
        beside = samples[k - 2] if k > 1 else samples[-1] if len(samples) == k + 1 else samples[k + 1]
        found += between(samples[k - 1], samples[k], counts[k - 1], counts[k], beside)
    for k in range(1, len(samples) - 1):
        before, here, after = counts[k - 1 : k + 2]
        if (before - here) * (after - here) > 0:
            found += at_extremum(sample, samples[k - 1 : k + 2], (before, here, after), length, sign)
    return found


def between(one, other, count_one, count_other, beside):
    """The whole numbers from the lower count up to, but not at, the higher one."""
    low, high = (count_one, count_other) if count_one < count_other else (count_other, count_one)
    return [(turns, one, other, beside) for turns in range(max(ceil(low), 0), max(ceil(high), 0))]


def at_extremum(sample, triple, counts, length, sign):
    """The two crossings beside an extremum of the count that reaches beyond a whole number its samples do not reach."""
    left, middle, right = triple
    before, here, after = counts
    top = here > before
    # The slope on either side, carried on over the other one, bounds an extremum of a curve that bends one way.
    share = (right.place - middle.place) / (middle.place - left.place)
    reachable = here + (1 if top else -1) * max(abs(before - here) * share, abs(after - here) / share)
    goal = ceil(here) if top else floor(here)
    if (top and (goal > reachable or here == goal)) or (not top and goal < reachable) or goal < 0:
        return []

    def short(item):
        count = (length - sign * item.arrival) / (2 * item.swing)
        return goal - count if top else count - goal

    best = dip(sample, short, left, middle, right)
    if short(best) >= 0:
        return []
    return [(goal, left, best, right), (goal, best, right, left)]


def dip(sample, short, left, middle, right):
    """The sample at which ``short`` is least between left and right by golden sections, or the first below zero."""
    golden = (3 - sqrt(5)) / 2
    value = short(middle)
    while right.place - left.place > 2 * sqrt(epsilon()) * (1 + abs(middle.place)):
        wide = right.place - middle.place > middle.place - left.place
        end = right if wide else left
        trial = sample(middle.place + golden * (end.place - middle.place))
        new = short(trial)
        if new < 0:
            return trial
        if new < value:
            left, right = (middle, right) if wide else (left, middle)
            middle, value = trial, new
        elif wide:
            right = trial
        else:
            left = trial
    return middle


def bracketed_root(function, places, values, blur):
    """A sign change of the function between the first two places, to rounding, by Chandrupatla's method (1997).

    The third place has a value, too. blur: a value that rounding may have made of zero.
    """
    (a, b, c), (value_a, value_b, value_c) = places, values
    fraction = interpolated(a, b, c, value_a, value_b, value_c)
    if not 0 < fraction < 1:
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
        if least > 0.5 or abs(value_best) <= blur:
            return best
        fraction = min(1 - least, max(least, interpolated(a, b, c, value_a, value_b, value_c)))


def interpolated(a, b, c, value_a, value_b, value_c):
    """Where on the way from a to b inverse quadratic interpolation puts the zero, or half way where it is unsafe."""
    if value_c in (value_a, value_b):
        return 0.5
    x, y = (a - b) / (c - b), (value_a - value_b) / (value_c - value_b)
    if x <= 0 or y * y >= x or (1 - y) * (1 - y) >= 1 - x:
        return 0.5
    share = value_a / (value_b - value_a) * value_c / (value_b - value_c)
    return share + (c - a) / (b - a) * value_a / (value_c - value_a) * value_b / (value_c - value_b)
