"""Power series of a rod in the length from its tip, in bins along it, by the equation of equilibrium.

Lengths are the rod's own, in which β + η is of order one. A series is about the middle of its bin, where angle, slope
and place come from the closed form; it is as long as its last terms ask for.
"""

from __future__ import annotations

from math import floor, ldexp, log2, sqrt
from typing import Any, NamedTuple

import numpy as np

from derive.emit.kernels.shapes import angle_and_position, point_at
from derive.emit.kernels.swing import phase_at

SHORT = 128  # bins up to which none is looked for that is straight
AT_A_TIME = 16  # bins whose cells are computed together, so that they stay in the cache
COARSE = 8  # bins up to which a range is not divided to find straight ones in it
LONGEST = 48  # the longest series; where more terms are wanted, bins are halved


class State(NamedTuple):
    """What the series of a bin starts from: angle, its slope by the length from the tip, and y + iz."""

    angle: Any
    slope: Any
    place: Any


class Bins(NamedTuple):
    """Series of equal bins of which the first begins at ``start`` bins from the tip.

    angle, place: coefficients, by power and bin. straight: the bins in which θ is constant to rounding.
    """

    width: float
    start: int
    straight: Any
    angle: Any
    place: Any


def negligible():
    """What a term may be, in radians or lengths, to be left out: an eighth of the spacing of numbers just below 1."""
    return 2.0**-56


def quarter():
    """A quarter of the spacing of numbers at 1: how far a value may be from what the series of a bin gives."""
    return 2.0**-54


def period_of(equilibrium):
    """The period of θ in the length from the tip, and what y + iz changes by over it; 0 where the rod is shorter."""
    rod, swing = equilibrium.rod, equilibrium.swing
    if rod.length <= 2 * swing.length:
        return 0.0, 0.0
    length, heading = swing.length, swing.heading
    y, z = swing.arc.y + length * heading.cosine, swing.arc.z + length * heading.sine
    return 2 * length, -2 * ldexp(1.0, -rod.scale) * complex(y, rod.side * z)


def bins_of(equilibrium, position):
    """The bins of a rod: over its length, or over a period about the tip where the rod is longer than that.

    Their places are worth nothing without ``position``.
    """
    mirrored = period_of(equilibrium)[0] > 0
    reach = equilibrium.swing.length if mirrored else equilibrium.rod.length
    width, series = 0.5, None
    while series is None:
        count = int(reach / width) + 1
        state, straight = states(equilibrium, width, count, position)
        if mirrored:
            state, straight = with_mirror(equilibrium, state), np.concatenate((straight[::-1], straight))
        series = complete_series(equilibrium.rod, state, width / 2)
        found = width
        width /= 2
    return Bins(found, -count if mirrored else 0, straight, *series)


def complete_series(rod, state, half):
    """Series of which the last two terms are negligible up to half a bin from its middle; None if they are too long.

    What is left out decreases faster than by halves, so it is no more than these.
    """
    for degree in range(2 - int(56 / log2(half)), LONGEST + 1, 6):
        angle, place = series(rod, state, degree)
        last = abs(np.concatenate((degree * angle[-2:], ldexp(1.0, rod.scale) * place[-2:]), axis=1)).max(axis=1)
        if max(last[0] * half ** (degree - 1), last[1] * half**degree) <= negligible():
            return angle, place
    return None


def series(rod, state, degree):
    """The coefficients of θ and of y + iz about states: θ″ = β sin θ + (η/2) sin 2(θ − α), and y′ + iz′ = e^{iθ}."""
    shape = (degree + 1, len(state.angle))
    angle, turned = np.zeros(shape), np.zeros(shape)
    once, twice, place = (np.zeros(shape, dtype=complex) for _ in range(3))
    angle[0], angle[1], turned[1] = state.angle, state.slope, state.slope
    once[0] = np.exp(1j * state.angle)
    twice[0] = np.exp(2j * (state.angle - rod.side * rod.field_angle))
    place[0] = state.place
    for n in range(degree):
        if n:
            # d/dσ e^{iθ} = iθ′e^{iθ}, by powers.
            once[n] = 1j / n * (turned[1 : n + 1] * once[n - 1 :: -1]).sum(axis=0)
            twice[n] = 2j / n * (turned[1 : n + 1] * twice[n - 1 :: -1]).sum(axis=0)
        if n + 2 <= degree:
            turned[n + 2] = (rod.beta * once[n].imag + rod.eta / 2 * twice[n].imag) / (n + 1)
            angle[n + 2] = turned[n + 2] / (n + 2)
        place[n + 1] = -ldexp(1.0, -rod.scale) * once[n] / (n + 1)
    return angle, place


def with_mirror(equilibrium, state):
    """States on both sides of the tip: θ is even there, and the arc is odd."""
    tip = complex(equilibrium.y, equilibrium.z)
    return State(
        np.concatenate((state.angle[::-1], state.angle)),
        np.concatenate((-state.slope[::-1], state.slope)),
        np.concatenate((2 * tip - state.place[::-1], state.place)),
    )


def states(equilibrium, width, count, position):
    """The states in the middles of the bins, and which bins are straight: between the ends of straight ranges θ is
    constant, to rounding, and the place is linear."""
    known = {}

    def state_at(bins):
        if bins not in known:
            known[bins] = state_of(equilibrium, bins * width, position)
        return known[bins]

    middles = np.arange(count) + 0.5
    straight = np.zeros(count, dtype=bool)
    angle, slope, place = np.empty(count), np.zeros(count), np.empty(count, dtype=complex)
    for low, high in straight_ranges(state_at, count, equilibrium.swing.length / width) if count > SHORT else []:
        first, last, inside = state_at(low), state_at(high), slice(low, high)
        share = (middles[inside] - low) / (high - low)
        straight[inside], angle[inside] = True, (first.angle + last.angle) / 2
        place[inside] = first.place + share * (last.place - first.place)
    for bins in np.flatnonzero(~straight).tolist():
        angle[bins], slope[bins], place[bins] = state_at(bins + 0.5)
    return State(angle, slope, place), straight


def state_of(equilibrium, length, position):
    """The state at a length from the tip."""
    rod = equilibrium.rod
    angle, slope = angle_and_slope(rod, equilibrium.swing, length)
    if not position:
        return State(angle, slope, 0)
    _, _, y, z = angle_and_position(equilibrium, ldexp(rod.length - length, -rod.scale))
    return State(angle, slope, complex(y, z))


def angle_and_slope(rod, swing, length):
    """θ and its slope at a length from the tip; they cost much less than y and z."""
    stay, motion = swing.stay, swing.stay.motion
    count = floor(length / swing.length)
    within, sign = length - count * swing.length, rod.side
    if count % 2:
        within, sign = swing.length - within, -rod.side
    regular = swing.length - stay.tip - stay.middle - stay.far
    moving = within - min(within, stay.tip)
    before = min(moving, regular / 2 if stay.middle > 0 else regular)
    here = min(before + max(moving - before - stay.middle, 0), regular)
    if here <= 0:
        return rod.side * (motion.tip + 2 * np.pi * swing.turns), 0.0
    square, rest = phase_at(motion.end / 2, motion.middle / 2, here, regular - here)
    point, half, _ = point_at(motion, square, rest)
    cotangent = point.pole / point.strength
    slope = 4 * sqrt(point.one) * point.product / (point.strength * (1 + cotangent * cotangent))
    return rod.side * (motion.tip + 2 * half + 2 * np.pi * swing.turns), sign * slope


def straight_ranges(state_at, count, turn):
    """Ranges of bins at whose ends, and at turning points within, θ is the same to rounding: between them it is
    monotone, therefore constant."""
    ranges, todo = [], [(0, count)]
    while todo:
        low, high = todo.pop()
        angles = [state_at(bins).angle for bins in (low, turn, 2 * turn, high) if low <= bins <= high]
        if max(angles) - min(angles) <= 2.0**-53 * max(1.0, abs(angles[0])):
            ranges.append((low, high))
        elif high - low > COARSE:
            todo += [(low, (low + high) // 2), ((low + high) // 2, high)]
    return ranges


def divided(coefficients, half, cells, change=None):
    """Series about the middles of equal cells of bins, by power and cell, in a place between −1 and 1.

    half: half the width of a bin. change: a matrix for the terms of each cell, as many as it has columns; like those of
    x^k, what it makes of them has no terms beyond the k-th.
    """
    size, part = len(coefficients), half / cells
    terms = size if change is None else len(change)
    middles = (2 * np.arange(cells) + 1 - cells) * part
    powers = np.zeros((size, terms, cells))
    powers[0, 0] = 1
    for k in range(1, size):
        # (middle + part·x)^k, by powers of x.
        powers[k] = middles * powers[k - 1]
        powers[k, 1:] += part * powers[k - 1, :-1]
    if change is not None:
        powers = np.einsum("mn,knc->kmc", change, powers)
    count = coefficients.shape[1]
    found = np.empty((terms, count, cells))
    for first in range(0, count, AT_A_TIME):
        some = slice(first, first + AT_A_TIME)
        rows = np.zeros((len(coefficients[0, some]), terms * cells))
        # The smallest terms first; of x^k there are none beyond the k-th.
        for k in range(size - 1, -1, -1):
            filled = min(k + 1, terms) * cells
            rows[:, :filled] += coefficients[k, some, None] * powers[k].reshape(-1)[:filled]
        found[:, some] = rows.reshape(-1, terms, cells).transpose(1, 0, 2)
    return found.reshape(terms, -1)
