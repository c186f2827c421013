"""Power series of a rod in the length from its clamp, in bins along it, by the equation of equilibrium.

Lengths are the rod's own, in which β + η is of order one. A series is about the middle of its bin, where angle, slope
and place come from the closed form; it is as long as its last terms ask for. What is asked for is a length from the
clamp, so that it is not rounded: where a long rod bends, the last digit of one from its tip is many digits of θ.
"""

from __future__ import annotations

from math import floor, frexp, ldexp, log2, pi
from typing import Any, NamedTuple

import numpy as np

from derive.emit.kernels.shapes import along_bent

SHORT = 128  # bins up to which none is looked for that is straight
AT_A_TIME = 16  # bins whose cells are computed together, so that they stay in the cache
COARSE = 8  # bins up to which a range is not divided to find straight ones in it
LARGE = 4.0  # an angle beyond which a rounding more would show
LONGEST = 48  # the longest series; where more terms are wanted, bins are halved


class State(NamedTuple):
    """What the series of a bin starts from: angle less ``middle_of`` the rod, its slope by the length, and y + iz."""

    angle: Any
    slope: Any
    place: Any


class Bins(NamedTuple):
    """Series of equal bins of which the first begins at the clamp.

    angle, place: coefficients, by power and bin, of the angle less ``middle_of`` the rod and of y + iz. straight: the
    bins in which θ is constant to rounding.
    """

    width: float
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
    """The period of θ in the length, and what y + iz changes by over it; 0 where the rod is shorter."""
    rod, swing = equilibrium.rod, equilibrium.swing
    if rod.length <= 2 * swing.length:
        return 0.0, 0.0
    length, heading = swing.length, swing.heading
    y, z = swing.arc.y + length * heading.cosine, swing.arc.z + length * heading.sine
    return 2 * length, 2 * ldexp(1.0, -rod.scale) * complex(y, rod.side * z)


def middle_of(equilibrium):
    """A whole number about which the angles lie, or 0 where none is large.

    Large ones are measured from there, and it is added last: so their sums are rounded only once at their size.
    """
    rod, swing = equilibrium.rod, equilibrium.swing
    motion, turned = swing.stay.motion, 2 * pi * swing.turns
    low = motion.tip + turned
    high = low + 2 * motion.half_width
    return rod.side * float(floor((low + high) / 2 + 0.5)) if max(abs(low), abs(high)) > LARGE else 0.0


def bins_of(equilibrium, position):
    """The bins of a rod: over its length, or over a period where the rod is longer than that.

    Their places are worth nothing without ``position``.
    """
    reach = period_of(equilibrium)[0] or equilibrium.rod.length
    width, series, middle = min(0.5, ldexp(1.0, frexp(reach)[1])), None, middle_of(equilibrium)
    while series is None:
        count = int(reach / width) + 1
        state, straight = states(equilibrium, width, count, position)
        series = complete_series(equilibrium.rod, middle, state, width / 2)
        found = width
        width /= 2
    return Bins(found, straight, *series)


def complete_series(rod, middle, state, half):
    """Series of which the last two terms are negligible up to half a bin from its middle; None if they are too long.

    What is left out decreases faster than by halves, so it is no more than these.
    """
    for degree in range(2 - int(56 / log2(half)), LONGEST + 1, 6):
        angle, place = series(rod, middle, state, degree)
        last = abs(np.concatenate((degree * angle[-2:], ldexp(1.0, rod.scale) * place[-2:]), axis=1)).max(axis=1)
        if max(last[0] * half ** (degree - 1), last[1] * half**degree / min(1.0, rod.length)) <= negligible():
            return angle, place
    return None


def series(rod, middle, state, degree):
    """The coefficients of θ and of y + iz about states: θ″ = β sin θ + (η/2) sin 2(θ − α), and y′ + iz′ = e^{iθ}."""
    shape = (degree + 1, len(state.angle))
    angle, turned = np.zeros(shape), np.zeros(shape)
    once, twice, place = (np.zeros(shape, dtype=complex) for _ in range(3))
    angle[0], angle[1], turned[1] = state.angle, state.slope, state.slope
    once[0] = np.exp(1j * state.angle) * np.exp(1j * middle)
    twice[0] = np.exp(2j * state.angle) * np.exp(2j * (middle - rod.side * rod.field_angle))
    place[0] = state.place
    for n in range(degree):
        if n:
            # d/ds e^{iθ} = iθ′e^{iθ}, by powers.
            once[n] = 1j / n * (turned[1 : n + 1] * once[n - 1 :: -1]).sum(axis=0)
            twice[n] = 2j / n * (turned[1 : n + 1] * twice[n - 1 :: -1]).sum(axis=0)
        if n + 2 <= degree:
            turned[n + 2] = (rod.beta * once[n].imag + rod.eta / 2 * twice[n].imag) / (n + 1)
            angle[n + 2] = turned[n + 2] / (n + 2)
        place[n + 1] = ldexp(1.0, -rod.scale) * once[n] / (n + 1)
    return angle, place


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
    for low, high in straight_ranges(state_at, count, turns_of(equilibrium, width)) if count > SHORT else []:
        first, last, inside = state_at(low), state_at(high), slice(low, high)
        share = (middles[inside] - low) / (high - low)
        straight[inside], angle[inside] = True, (first.angle + last.angle) / 2
        place[inside] = first.place + share * (last.place - first.place)
    for bins in np.flatnonzero(~straight).tolist():
        angle[bins], slope[bins], place[bins] = state_at(bins + 0.5)
    return State(angle, slope, place), straight


def state_of(equilibrium, length, position):
    """The state at a length from the clamp; beyond the tip θ is even and the arc odd about it."""
    rod = equilibrium.rod
    beyond = length > rod.length
    within = 2 * rod.length - length if beyond else length
    anchor, turned, slope, y, z = along_bent(equilibrium, ldexp(within, -rod.scale), position)
    angle = (anchor - middle_of(equilibrium)) + turned
    slope, place = ldexp(slope, -rod.scale), complex(y, z)
    if beyond:
        slope, place = -slope, 2 * complex(equilibrium.y, equilibrium.z) - place
    return State(angle, slope, place)


def turns_of(equilibrium, width):
    """The first turning points from the clamp on, in bins."""
    rod, swing = equilibrium.rod, equilibrium.swing
    first = rod.length - floor(rod.length / swing.length) * swing.length
    return [(first + number * swing.length) / width for number in range(3)]


def straight_ranges(state_at, count, turns):
    """Ranges of bins at whose ends, and at turning points within, θ is the same to rounding: between them it is
    monotone, therefore constant."""
    ranges, todo = [], [(0, count)]
    while todo:
        low, high = todo.pop()
        angles = [state_at(bins).angle for bins in (low, *turns, high) if low <= bins <= high]
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
