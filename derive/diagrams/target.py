"""All values of a parameter at which the tip of an equilibrium is where it is wanted.

Two equilibria never share a tip angle: with it and θ′(ℓ) = 0 they would be the same. So between two values at which
their number changes they keep their order, and the k-th one moves smoothly. Each interval between such values is
sampled in an angle u, in which the parameter is a cosine: where two equilibria meet at an end they part as the
square root, and in u they are smooth. Sign changes are refined; so are extrema that could reach the target.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Any

from derive.diagrams.nearest import extrema
from derive.emit.kernels.roots import bracketed_root

SAMPLES = 33  # to begin with, on each interval
END = 1e-6  # how far in u from an end, which itself has two equilibria in one
DEPTH = 5  # how often an interval between samples is halved
STRAIGHT = 0.01  # how far, as a share of its whole range, a coordinate may miss the middle of its neighbours

Solver = Callable[[float], Sequence[Any]]  # parameter → equilibria, sorted by tip angle
Point = tuple[float, tuple[float, ...]]  # u, and the coordinate of each equilibrium


@dataclass(frozen=True)
class Hit:
    """A parameter, its equilibrium that reaches the target, and which one of all there it is."""

    parameter: float
    equilibrium: Any
    number: int
    of: int


@dataclass(frozen=True)
class Reach:
    """What was found: all hits by parameter, and the least and the greatest coordinate that any equilibrium has."""

    hits: list[Hit]
    low: float
    high: float


@dataclass(frozen=True)
class Stretch:
    """An interval of the parameter with one number of equilibria, and the coordinate that is wanted of each."""

    solve: Solver
    coordinate: str
    low: float
    high: float
    count: int

    def parameter(self, u: float) -> float:
        """The parameter at u in [0, 1]."""
        return self.low + (self.high - self.low) * math.sin(math.pi * u / 2) ** 2

    def values(self, u: float) -> tuple[float, ...]:
        """The coordinates of all equilibria."""
        found = self.solve(self.parameter(u))
        if len(found) != self.count:
            raise ChangeError(self.parameter(u))
        return tuple(float(getattr(one, self.coordinate)) for one in found)


class ChangeError(Exception):
    """Another number of equilibria than on the rest of the interval, at the parameter that is its argument."""


def reaching(solve: Solver, coordinate: str, goal: float, low: float, high: float, cuts: Sequence[float]) -> Reach:
    """Every parameter in [low, high] at which an equilibrium's coordinate is the goal.

    cuts: known places where the number of equilibria changes; others are found where samples differ.
    """
    hits: list[Hit] = []
    ends = [low, *sorted(cut for cut in set(cuts) if low < cut < high), high]
    todo = list(pairwise(ends))[::-1]
    least, most = math.inf, -math.inf
    while todo:
        start, stop = todo.pop()
        stretch = Stretch(solve, coordinate, start, stop, len(solve((start + stop) / 2)))
        try:
            points = sampled(stretch)
            found = [hit for k in range(stretch.count) for hit in hits_of(stretch, points, k, goal)]
        except ChangeError as change:
            place = changed(solve, (start + stop) / 2, change.args[0], stretch.count)
            # Too near an end to tell: what is there belongs to the neighbour.
            if min(place - start, stop - place) <= 1e-9 * (high - low):
                inner = 1e-9 * (high - low)
                if stop - start > 4 * inner:
                    todo.append((start + inner, stop - inner))
                continue
            todo += [(place, stop), (start, place)]
            continue
        hits += found
        seen = [value for _, values in points for value in values]
        least, most = min([least, *seen]), max([most, *seen])
    return Reach(sorted(unique(hits, high - low), key=lambda hit: (hit.parameter, hit.number)), least, most)


def unique(hits: Sequence[Hit], width: float) -> list[Hit]:
    """The hits, one that two neighbouring intervals share kept once."""
    kept: list[Hit] = []
    for hit in hits:
        same = (
            abs(hit.parameter - one.parameter) <= 1e-9 * width
            and abs(hit.equilibrium.tip_angle - one.equilibrium.tip_angle) <= 1e-6
            for one in kept
        )
        if not any(same):
            kept.append(hit)
    return kept


def changed(solve: Solver, inside: float, outside: float, count: int) -> float:
    """Where between two parameters the number of equilibria changes, by bisection."""
    for _ in range(60):
        middle = (inside + outside) / 2
        if middle in (inside, outside):
            break
        if len(solve(middle)) == count:
            inside = middle
        else:
            outside = middle
    return (inside + outside) / 2


def sampled(stretch: Stretch) -> list[Point]:
    """Samples along the interval, closer where a coordinate bends."""
    step = (1 - 2 * END) / (SAMPLES - 1)
    points = [(u, stretch.values(u)) for u in (END + k * step for k in range(SAMPLES))]
    for _ in range(DEPTH):
        spans = [max(values) - min(values) or 1.0 for values in zip(*(p[1] for p in points), strict=True)]
        bent = [k for k in range(1, len(points) - 1) if bends(points[k - 1], points[k], points[k + 1], spans)]
        sides = sorted({k + side for k in bent for side in (-1, 0)})
        if not sides:
            break
        middles = [(points[k][0] + points[k + 1][0]) / 2 for k in sides]
        points = sorted([*points, *((u, stretch.values(u)) for u in middles)])
    return points


def bends(before: Point, here: Point, after: Point, spans: Sequence[float]) -> bool:
    """Whether a coordinate is far from the straight line through its neighbours."""
    share = (here[0] - before[0]) / (after[0] - before[0])
    triples = zip(before[1], here[1], after[1], spans, strict=True)
    return any(abs(y - x - share * (z - x)) > STRAIGHT * span for x, y, z, span in triples)


def hits_of(stretch: Stretch, points: Sequence[Point], k: int, goal: float) -> list[Hit]:
    """The places at which the k-th equilibrium's coordinate is the goal."""

    def miss(u: float) -> float:
        return stretch.values(u)[k] - goal

    places = [(u, values[k] - goal) for u, values in points]
    places = sorted({*places, *extrema(miss, places)})
    found = [u for u, value in places if value == 0]
    for (u, value), (other, value_there) in pairwise(places):
        if value * value_there < 0:
            middle = (u + other) / 2
            found.append(bracketed_root(miss, (u, other, middle), (value, value_there, miss(middle)), 0.0))
    return [hit_at(stretch, u, k) for u in sorted(found)]


def hit_at(stretch: Stretch, u: float, k: int) -> Hit:
    """The equilibrium itself."""
    parameter = stretch.parameter(u)
    return Hit(parameter, stretch.solve(parameter)[k], k + 1, stretch.count)
