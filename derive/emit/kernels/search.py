"""All tips whose rod has the given length: every crossing of the branches of the time map.

A motion meets the clamp angle at the lengths 2nH + t and 2nH − t, with H the half-swing and t the first arrival. So
the tips wanted are those at which (ℓ − t)/(2H) or (ℓ + t)/(2H) is a whole number: two functions of the tip, smooth on a
piece, whose crossings of whole numbers are found from samples, and from the extrema that could reach one.
"""

from __future__ import annotations

from typing import NamedTuple

from derive.emit.kernels.arithmetic import ceil, deepest, epsilon, floor, inf, pi, sqrt
from derive.emit.kernels.motion import Motion, motion_at
from derive.emit.kernels.places import least_arrival, places
from derive.emit.kernels.roots import bracketed_root, dip
from derive.emit.kernels.swing import Phase, lengths, phase_of

SAFE = 1e-6  # bounds count where they hold by this much more than they must


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


class Sample(NamedTuple):
    """Half-swing and first arrival at a place of a piece, and of what they are: the motion and its phase at the clamp.

    The motion alone has the half-swing and the arrival without the lengths for which it stays anywhere.
    """

    place: float
    swing: float
    arrival: float
    stay: Stay
    phase: Phase
    regular: tuple[float, float]


class Crossing(NamedTuple):
    """A tip whose rod has the right length, on branch 2·turns·H + sign·t; ``rising``: the branch grows with the tip."""

    sample: Sample
    turns: int
    sign: int
    rising: bool


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
    motion = stay.motion
    phase = phase_of(motion)
    regular = swing, arrival = lengths(motion.end / 2, motion.middle / 2, phase.square, phase.rest)
    swing, arrival = swing + stay.tip + stay.middle + stay.far, arrival + stay.tip + stay.arrival
    return Sample(place, swing, arrival, stay, phase, regular)


def crossings(beta, eta, field_angle, length, piece, most):
    """Every crossing of the rod's length on a piece whose index can be at most ``most``, as a list of Crossing."""
    ends = delays(piece)

    def sample(place):
        return sample_at(beta, eta, field_angle, piece, ends, place)

    def too_low(place):
        return least_arrival(beta, eta, piece, place) > (1 + SAFE) * length

    if too_low(inf):
        return []
    # No half-swing is shorter than that of the stiffest pendulum.
    quarter = pi / 2 / sqrt(beta + eta)
    signs = (1,) if length < 2 * quarter else (1, -1)
    # A motion that arrives before the stiffest pendulum is down arrives the sooner, the nearer its tip (Sturm).
    soon = (1 - SAFE) * min(quarter, length) if len(signs) == 1 and piece.high_kind == "clamp" else 0
    samples = sampled(sample, places(beta, eta, field_angle, length, piece), too_low, soon)
    samples = refined(sample, samples, length)
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


def sampled(sample, places, too_low, soon):
    """Samples from the last place that is too low to the first one from which the motion arrives soon.

    Beyond both nothing is as long as the rod. One more is taken where the branches do not fall from there, or to there.
    """
    start = 0
    while start + 1 < len(places) and too_low(places[start + 1]):
        start += 1
    found = [sample(place) for place in places[start : start + 2]]
    for place in places[start + 2 :]:
        if found[-1].arrival < soon and found[-1].arrival < found[-2].arrival:
            break
        found.append(sample(place))
    while start > 0 and not falls(*found[:2]):
        start -= 1
        found.insert(0, sample(places[start]))
    return found


def falls(one, other):
    """Whether no branch is longer at the second one."""
    less, apart = one.swing - other.swing, one.arrival - other.arrival
    return apart >= 0 and 2 * less >= apart


def excess(item, turns, sign, length):
    """The length of a branch less the rod's."""
    return (2 * turns * item.swing if turns else 0) + sign * item.arrival - length


def crossing(sample, turns, sign, length, before, after, beside):
    """The crossing between two samples on either side of it; others beside them help to find it."""
    seen = {}

    def function(place):
        seen[place] = sample(place)
        return excess(seen[place], turns, sign, length)

    known = (before, after, *beside)
    values = [excess(item, turns, sign, length) for item in known]
    place = bracketed_root(function, [item.place for item in known], values, epsilon() * length)
    return Crossing(seen.get(place) or sample(place), turns, sign, values[1] > values[0])


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
        return last._replace(place=last.place + 1e3, arrival=0 * last.swing)
    if piece.high_kind == "turn":
        return last._replace(place=last.place + 1e3, arrival=last.swing)
    return None


def brackets(sample, samples, counts, length, sign):
    """(turns, sample, sample, others) for every whole number that the count crosses between the two samples."""
    found = []
    for k in range(1, len(samples)):
        found += between(samples, counts, k)
    for k in range(1, len(samples) - 1):
        before, here, after = counts[k - 1 : k + 2]
        if (before - here) * (after - here) > 0:
            found += at_extremum(sample, samples[k - 1 : k + 2], (before, here, after), length, sign)
    return found


def between(samples, counts, k):
    """The whole numbers from the lower count of a sample and that before it up to, but not at, the higher one."""
    low, high = (counts[k - 1], counts[k]) if counts[k - 1] < counts[k] else (counts[k], counts[k - 1])
    turns = range(max(ceil(low), 0), max(ceil(high), 0))
    if not turns:
        return []
    beside = [samples[j] for j in (k - 2, k + 1, k - 3, k + 2) if 0 <= j < len(samples)]
    return [(number, samples[k - 1], samples[k], beside) for number in turns]


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
    return [(goal, left, best, [right]), (goal, best, right, [left])]
