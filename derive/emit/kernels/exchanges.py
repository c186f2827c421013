"""Where two branches of a diagram over η exchange as β grows."""

from __future__ import annotations

from itertools import pairwise
from typing import NamedTuple

from derive.emit.kernels.arithmetic import ceil, frexp, ldexp, log, pi
from derive.emit.kernels.extrema import Mark, marks, slope_at
from derive.emit.kernels.folds import both_sides, rod_of, steps
from derive.emit.kernels.roots import bracketed_root
from derive.emit.kernels.sides import principal
from derive.emit.kernels.tracking import follow, matched, nearest, zeros
from derive.emit.kernels.variations import Change

# How near, as a share of the loads, an exchange may lie to where its branch's extremum itself appears.
CLOSE = 1e-3
FORCES = 20  # forces in a range by whose ends loads differ by a factor e


class Exchange(NamedTuple):
    """At this β and η the two folds of a diagram over η meet: it changes its aspect as β goes by.

    With F = θ(0) − clamp angle as a function of the tip angle φ and of η: F = ∂F/∂φ = ∂F/∂η = 0. kind: 'exchange',
    where two branches cross (F has a saddle) and their halves are joined otherwise on either side of β; 'isolated',
    where a closed branch shrinks to a point and vanishes (F has an extremum). tip_angle, clamp_curvature, y, z: of
    the rod there. index: the lower of the two indices that meet.
    """

    beta: float
    eta: float
    tip_angle: float
    clamp_curvature: float
    y: float
    z: float
    index: int  # type: ignore[assignment]  # in the place of tuple.index
    kind: str


def all_exchanges(length, clamp_angle, field_angle, low_beta, high_beta, low, high):
    """Every point with β and η in these ranges at which two folds meet, sorted by β and η."""
    scale = frexp(high_beta + high)[1] // 2
    field = principal(field_angle)
    low_beta, high_beta, low, high = (ldexp(load, -2 * scale) for load in (low_beta, high_beta, low, high))
    length = ldexp(length, scale)
    places = steps(low_beta, high_beta, length, low, high)
    if not places:
        return []

    def at(beta, key):
        def extrema(eta, kept):
            return marks(both_sides(beta, eta, length, clamp_angle, field, scale), kept)

        return stationary(extrema, places, -beta, key)

    loads = forces(low_beta, high_beta, length, high)
    found = [exchange_of(at, mark) for mark in zeros(at, loads, -high, CLOSE)]
    return sorted(found, key=lambda item: (item.beta, item.eta))


def forces(low, high, length, field):
    """The β to look at first, each larger than the last by the same share of β and the largest field.

    As long as ℓ²(β + η) < (π/2)² nothing meets.
    """
    first = pi / 2 / length
    start = max(low, first * first - field)
    ratio = (high + field) / (start + field)
    count = ceil(FORCES * log(ratio)) + 3
    inner = [(start + field) * ratio ** (k / count) - field for k in range(1, count)]
    return [start, *(beta for beta in inner if start < beta < high), high]


def stationary(at, places, origin, key):
    """The extrema of branches whose length is stationary in η too, by key; or only those of the key wanted."""

    def near(eta, _):
        return at(eta, None if key is None else key[:-1])

    rows = follow(near, places, origin, CLOSE)
    found: dict[tuple, list[Mark]] = {}
    for low, high in pairwise(rows):
        for name, before, after in matched(low, high):
            top = before.slope > 0
            if top != (after.slope > 0) and (key is None or key[-1] == top):
                best = level_point(at, name, low.place, high.place, before, after)
                if best is not None:
                    found.setdefault((*name, top), []).append(
                        best._replace(key=(*name, top), group=(*best.group, top), spot=best.rod.eta)
                    )
    return found


def level_point(at, name, low, high, before, after):
    """The extremum between two rows at which the length is stationary in η; None if it is not there all the way."""

    def mark_at(eta):
        spot = before.spot + (eta - low) / (high - low) * (after.spot - before.spot)
        return nearest(at(eta, name), name, spot)

    def function(eta):
        mark = mark_at(eta)
        return before.slope if mark is None else mark.slope

    return mark_at(bracketed_root(function, (low, high), (before.slope, after.slope), 0))


def exchange_of(at, mark):
    """The exchange of a doubly stationary length that is the rod's; a step of Newton's method sharpens β."""
    _, sign, swings, top, over = mark.group
    slope = slope_at(mark.rod, mark.piece, mark.place, sign, swings, Change(0, 1, 0))
    mark = nearest(at(mark.rod.beta - mark.height / slope, mark.key), mark.key, mark.spot) or mark
    rod, found = mark.rod, rod_of(mark._replace(group=mark.group[:-1]))
    loads = ldexp(rod.beta, 2 * rod.scale), ldexp(rod.eta, 2 * rod.scale)
    kind = "isolated" if top == over else "exchange"
    return Exchange(*loads, found.tip_angle, found.clamp_curvature, found.y, found.z, found.index, kind)
