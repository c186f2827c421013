"""Where the length of a branch is stationary in the tip angle: there two equilibria of a rod of that length meet."""

from __future__ import annotations

from typing import NamedTuple

from derive.emit.kernels.arithmetic import ceil, epsilon, exp, inf
from derive.emit.kernels.arrivals import least_arrival
from derive.emit.kernels.basins import Piece
from derive.emit.kernels.ground import clamp_in, ground_of, ridge_of
from derive.emit.kernels.landscape import landscape
from derive.emit.kernels.pieces import pieces
from derive.emit.kernels.places import about, grid
from derive.emit.kernels.rods import Rod
from derive.emit.kernels.roots import bracketed_root, dip
from derive.emit.kernels.time_map import delays, sample_at
from derive.emit.kernels.variations import Change, rates_of_times

# Branches whose extremum is further from the rod's length than this share of it are not looked at.
WINDOW = 0.5
# Between neighbouring samples the length is a cubic but for this share of the rod's, or they are nearer than the other.
ROUGH = 0.02
FINEST = 0.4


class Probe(NamedTuple):
    """Half-swing, first arrival, and their derivatives by the place."""

    place: float
    swing: float
    arrival: float
    swing_rate: float
    arrival_rate: float


class Mark(NamedTuple):
    """An extremum of a branch's length over the tip angle.

    key: side, piece, branch, and whether it is a maximum. group: what of it stays when it goes over to another piece.
    spot: what tells it from the others of its key, the place. height: the length there over the rod's, less 1. slope:
    the derivative of that by η.
    """

    key: tuple
    group: tuple
    spot: float
    place: float
    height: float
    slope: float
    rod: Rod
    turns: int
    piece: Piece


def marks(sides, wanted=None):
    """The extrema of all branches of a rod, given from both sides, by key; or only those of the key wanted."""
    found: dict[tuple, list[Mark]] = {}
    for rod in sides:
        stiff = rod.length * rod.length * (rod.beta + rod.eta) < 2  # nothing meets below (π/2)²
        if stiff or (wanted is not None and wanted[0] != rod.side):
            continue
        scene = landscape(rod.beta, rod.eta, rod.field_angle)
        clamp = clamp_in(scene.rests, rod.clamp_angle)
        ground = ground_of(rod.eta, scene, clamp, ridge_of(rod.beta, rod.eta, rod.field_angle, scene))
        for number, piece in enumerate(pieces(rod.eta, rod.field_angle, ground)):
            where = (rod.side, number, piece.low_kind, piece.high_kind, piece.basin.passes)
            if wanted is None or wanted[: len(where)] == where:
                for mark in marks_on(rod, clamp.turns, piece, where, wanted):
                    found.setdefault(mark.key, []).append(mark)
    return found


def marks_on(rod, turns, piece, where, wanted):
    """The extrema of the branches on a piece."""
    ends = delays(piece)

    def sample(place):
        return probe(rod, piece, ends, place)

    def too_low(place):
        return least_arrival(rod.beta, rod.eta, piece, *about(piece, place)) > (1 + WINDOW) * rod.length

    if too_low(inf):
        return
    places = grid(rod.beta, rod.eta, rod.length, piece)
    while len(places) > 2 and too_low(places[1]):
        places = places[1:]
    samples = dense(sample, [sample(place) for place in places], rod.length)
    branches = branches_near(samples, rod.length) if wanted is None else [wanted[len(where) : len(where) + 2]]
    for sign, swings in branches:
        for before, after in brackets_of(sample, samples, sign, swings, rod.length):
            top = rate(before, sign, swings) > 0
            key = (*where, sign, swings, top)
            if (wanted is None or key == wanted) and near(before, after, sign, swings, rod.length):
                yield mark_at(rod, turns, piece, sample, key, sign, swings, before, after)


def probe(rod, piece, ends, place):
    """The times at a place and their derivatives; in the deep, these are the delays."""
    item = sample_at(rod.beta, rod.eta, rod.field_angle, piece, ends, place)
    delay = ends[place >= 0]
    if abs(place) >= delay.deepest:
        side = -1 if place < 0 else 1
        rates = side * (delay.tip + delay.middle + delay.far), side * delay.arrival
        return Probe(place, item.swing, item.arrival, *rates)
    share = piece.width / ((1 + exp(place)) * (1 + exp(-place)))
    rates = rates_of_sample(rod, item, Change(share, 0, 0))
    return Probe(place, item.swing, item.arrival, *rates)


def rates_of_sample(rod, item, change):
    """The derivatives of half-swing and first arrival of a sample, but for the lengths for which it stays anywhere."""
    swing, arrival = item.regular
    motion = item.stay.motion
    return rates_of_times(rod.beta, rod.eta, rod.field_angle, motion, item.phase, swing, arrival, change)


def dense(sample, samples, length):
    """More samples where the trapezoidal rule for the derivatives misses the difference of the lengths."""
    done, todo = [samples[0]], samples[:0:-1]
    while todo:
        before, after = done[-1], todo[-1]
        width = after.place - before.place
        swing = after.swing - before.swing - width * (after.swing_rate + before.swing_rate) / 2
        arrival = after.arrival - before.arrival - width * (after.arrival_rate + before.arrival_rate) / 2
        least = min(before.swing, after.swing)
        miss = abs(arrival) + (length / least * abs(swing) if length > least else 0)
        out_of_reach = min(before.arrival, after.arrival) - abs(arrival) > (1 + WINDOW) * length
        if width > FINEST and miss > ROUGH * length and not out_of_reach:
            todo.append(sample((before.place + after.place) / 2))
        else:
            done.append(todo.pop())
    return done


def branch_length(item, sign, swings):
    """The length of a branch."""
    return (2 * swings * item.swing if swings else 0) + sign * item.arrival


def rate(item, sign, swings):
    """The derivative of the length of a branch by the place; 0 where it is within rounding of it."""
    value = (2 * swings * item.swing_rate if swings else 0) + sign * item.arrival_rate
    return value if abs(value) > 64 * epsilon() * (2 * swings * item.swing + item.arrival) else 0


def branches_near(samples, length):
    """(sign, swings) of every branch that is somewhere about as long as the rod."""
    shortest = min(item.swing for item in samples)
    last = ceil((1 + WINDOW) * length / (2 * shortest)) + 1
    return [(sign, swings) for sign in (1, -1) for swings in range(0 if sign > 0 else 1, last + 1)]


def near(before, after, sign, swings, length):
    """Whether one of two neighbours is about as long as the rod."""
    return any(abs(branch_length(item, sign, swings) / length - 1) < WINDOW for item in (before, after))


def brackets_of(sample, samples, sign, swings, length):
    """Pairs of samples between which the derivative changes sign, in the order of places."""
    seen = [item for item in samples if rate(item, sign, swings) != 0]
    values = [rate(item, sign, swings) for item in seen]
    found = []
    for k in range(1, len(seen)):
        if (values[k] > 0) != (values[k - 1] > 0):
            found.append((seen[k - 1], seen[k]))
        elif k + 1 < len(seen) and near(seen[k], seen[k], sign, swings, length):
            found += twice(sample, seen[k - 1 : k + 2], values[k - 1 : k + 2], sign, swings)
    return found


def twice(sample, triple, values, sign, swings):
    """The two sign changes beside the middle one of three samples, where the derivative may go beyond zero."""
    before, here, after = (abs(value) for value in values)
    facing = values[1] > 0
    if (values[2] > 0) != facing or not (here < before and here < after) or here > max(before - here, after - here):
        return []

    def short(item):
        value = rate(item, sign, swings)
        return value if facing else -value

    best = dip(sample, short, *triple)
    return [(triple[0], best), (best, triple[2])] if short(best) < 0 else []


def mark_at(rod, turns, piece, sample, key, sign, swings, before, after):
    """The extremum between two samples, to rounding of the place."""

    def function(place):
        item = sample(place)
        return (2 * swings * item.swing_rate if swings else 0) + sign * item.arrival_rate

    ends = before.place, after.place
    place = bracketed_root(function, ends, [function(end) for end in ends], 0)
    height = branch_length(sample(place), sign, swings) / rod.length - 1
    slope = slope_at(rod, piece, place, sign, swings, Change(0, 0, 1))
    return Mark(key, (rod.side, sign, swings, key[-1]), place, place, height, slope, rod, turns, piece)


def slope_at(rod, piece, place, sign, swings, change):
    """The derivative of the length of a branch by the loads, over the rod's length."""
    item = sample_at(rod.beta, rod.eta, rod.field_angle, piece, delays(piece), place)
    swing, arrival = rates_of_sample(rod, item, change)
    return ((2 * swings * swing if swings else 0) + sign * arrival) / rod.length
