"""All tips whose rod has the given length: every crossing of the branches of the time map.

A motion meets the clamp angle at the lengths 2nH + t and 2nH − t, with H the half-swing and t the first arrival. So
the tips wanted are those at which (ℓ − t)/(2H) or (ℓ + t)/(2H) is a whole number: two functions of the tip, smooth on a
piece, whose crossings of whole numbers are found from samples, and from the extrema that could reach one.
"""

from __future__ import annotations

from typing import NamedTuple

from derive.emit.kernels.arithmetic import ceil, epsilon, floor, pi, sqrt
from derive.emit.kernels.roots import bracketed_root, dip
from derive.emit.kernels.sampling import samples_on
from derive.emit.kernels.time_map import Sample, delays, sample_at


class Crossing(NamedTuple):
    """A tip whose rod has the right length, on branch 2·turns·H + sign·t; ``rising``: the branch grows with the tip."""

    sample: Sample
    turns: int
    sign: int
    rising: bool


def crossings(beta, eta, field_angle, length, piece, most):
    """Every crossing of the rod's length on a piece whose index can be at most ``most``, as a list of Crossing."""
    ends = delays(piece)

    def sample(place):
        return sample_at(beta, eta, field_angle, piece, ends, place)

    # No half-swing is shorter than that of the stiffest pendulum.
    short = length * sqrt(beta + eta) < pi
    samples = samples_on(beta, eta, field_angle, length, piece, sample, short, (most + 1) / 2)
    found = []
    for sign in (1,) if short else (1, -1):
        counts = [(length - sign * item.arrival) / (2 * item.swing) for item in samples]
        # At least 2·turns − 1 conjugate points, or one more on the branch that has gone on.
        last = (most + (sign < 0)) / 2
        for turns, before, after, beside in brackets(sample, samples, counts, length, sign, last):
            if (turns or sign > 0) and turns <= last:
                found.append(crossing(sample, turns, sign, length, (before, after, *beside)))
    return found


def crossing(sample, turns, sign, length, known):
    """The crossing between the first two samples, on either side of it; those beside them help to start."""
    seen = {}

    def function(place):
        seen[place] = sample(place)
        return excess(seen[place], turns, sign, length)

    values = [excess(item, turns, sign, length) for item in known]
    place = bracketed_root(function, [item.place for item in known], values, epsilon() * length)
    return Crossing(seen.get(place) or sample(place), turns, sign, values[1] > values[0])


def excess(item, turns, sign, length):
    """The length of a branch less the rod's."""
    return (2 * turns * item.swing if turns else 0) + sign * item.arrival - length


def brackets(sample, samples, counts, length, sign, last):
    """(turns, sample, sample, those beside) for every whole number that the count crosses between the two samples.

    Those beyond the last are not wanted.
    """
    found = []
    for k in range(1, len(samples)):
        found += between(samples, counts, k, last)
    for k in range(1, len(samples) - 1):
        before, here, after = counts[k - 1 : k + 2]
        if (before - here) * (after - here) > 0 and here < last + 1:
            found += at_extremum(sample, samples[k - 1 : k + 2], (before, here, after), length, sign)
    return found


def between(samples, counts, k, last):
    """The whole numbers from the lower count of a sample and that before it up to, but not at, the higher one.

    None beyond the last, of which a long rod may have too many to list.
    """
    low, high = (counts[k - 1], counts[k]) if counts[k - 1] < counts[k] else (counts[k], counts[k - 1])
    turns = range(max(ceil(low), 0), max(ceil(min(high, last + 0.5)), 0))
    if not turns:
        return []
    near = 4 * (samples[k].place - samples[k - 1].place)
    beside = [samples[k - 2]] if k > 1 and samples[k - 1].place - samples[k - 2].place < near else []
    if k + 1 < len(samples) and samples[k + 1].place - samples[k].place < near:
        beside.append(samples[k + 1])
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
