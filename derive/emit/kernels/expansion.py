"""Power series of a rod in the length from its tip, in bins along it, by the equation of equilibrium.

Lengths are the rod's own, in which β + η is of order one. A series is about the middle of its bin, where angle, slope
and place come from the closed form; it is as long as its last terms ask for.
"""

from __future__ import annotations

from math import comb, frexp, ldexp
from typing import Any, NamedTuple

import numpy as np

from derive.emit.kernels.shapes import angle_and_position

SHORT = 128  # bins up to which none is looked for that is straight
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


def period_of(equilibrium):
    """The period of θ in the length from the tip, and what y + iz changes by over it; 0 where the rod is shorter."""
    rod, swing = equilibrium.rod, equilibrium.swing
    if rod.length <= 2 * swing.length:
        return 0.0, 0.0
    return 2 * swing.length, -2 * ldexp(1.0, -rod.scale) * complex(swing.arc.y, rod.side * swing.arc.z)


def bins_of(equilibrium):
    """The bins of a rod: over its length, or over a period about the tip where the rod is longer than that."""
    mirrored = period_of(equilibrium)[0] > 0
    reach = equilibrium.swing.length if mirrored else equilibrium.rod.length
    width, series = 0.5, None
    while series is None:
        count = int(reach / width) + 1
        state, straight = states(equilibrium, width, count)
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
    for degree in range(16, LONGEST + 1, 6):
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


def states(equilibrium, width, count):
    """The states in the middles of the bins, and which bins are straight: between the ends of straight ranges θ is
    constant, to rounding, and the place is linear."""
    known = {}

    def state_at(bins):
        if bins not in known:
            rod = equilibrium.rod
            s = ldexp(rod.length - bins * width, -rod.scale)
            angle, curvature, y, z = angle_and_position(equilibrium, s)
            known[bins] = State(angle, -ldexp(curvature, -rod.scale), complex(y, z))
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


def straight_ranges(state_at, count, turn):
    """Ranges of bins at whose ends, and at turning points within, θ is the same to rounding: between them it is
    monotone, therefore constant."""
    ranges, todo = [], [(0, count)]
    while todo:
        low, high = todo.pop()
        angles = [state_at(bins).angle for bins in (low, turn, 2 * turn, high) if low <= bins <= high]
        if max(angles) - min(angles) <= 2.0**-53 * max(1.0, abs(angles[0])):
            ranges.append((low, high))
        elif high - low > 1:
            todo += [(low, (low + high) // 2), ((low + high) // 2, high)]
    return ranges


def cells_in_bin(rod, bins, degree):
    """In how many cells, a power of two, a bin is divided for series of the given degree.

    The first coefficient that is left out, anywhere in a bin, is at most Σ C(k, n)|c_k|r^{k−n}; the slope of the angle
    has the strictest demand.
    """
    n, half = degree + 1, bins.width / 2
    powers = range(n, len(bins.angle))
    place = bins.place * ldexp(1.0, rod.scale)
    sizes = np.array([comb(k, n) * half ** (k - n) for k in powers])[:, None]
    left_out = max(n * np.max((sizes * abs(bins.angle[n:])).sum(axis=0)), np.max((sizes * abs(place[n:])).sum(axis=0)))
    finest = (negligible() * 4 / max(left_out, negligible())) ** (1 / degree)
    return 2 ** max(0, frexp(half / finest)[1])


def state_within(bins, which, offset):
    """The states at offsets from the middles of bins, by their series."""
    angle, place = bins.angle[-1][which], bins.place[-1][which]
    slope = np.zeros(len(which))
    for angles, places in zip(bins.angle[-2::-1], bins.place[-2::-1], strict=True):
        slope = slope * offset + angle
        angle, place = angle * offset + angles[which], place * offset + places[which]
    return State(angle, slope, place)
