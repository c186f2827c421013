"""Complete branches of equilibria over one parameter: where they begin, end, and what happens there.

Two equilibria of one rod never share a tip angle: the tip angle and θ′(ℓ) = 0 determine the solution of the equation.
So between two events, at which equilibria are born or vanish, the one that is k-th in the order of the tip angles
stays the k-th, and is one smooth branch. Events are found from the numbers of equilibria: between neighbouring values
at which they differ, the interval is halved down to rounding. Two events between neighbouring values may cancel; those
over η are known beforehand (``folds``), others need values close enough.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise
from math import ulp

from derive.diagrams.states import State
from derive.diagrams.tracker import Branch, Event, Point, Tracker
from derive.emit.kernels.folds import all_folds

Rows = Callable[[Sequence[float]], list[list[State]]]
STEP, DEPTH = 0.1, 8  # radians between neighbours, unless the interval has been halved that often
BESIDE = 1e-9  # on both sides of a fold that is known, relative: the fold between, and no other
CLOSER = 8  # values beside an event, each four times as close to it as the last


@dataclass(frozen=True)
class Diagram:
    """All branches over the range of a parameter, and the events between them, in the order of the parameter."""

    parameter: str
    fixed: dict[str, float]
    branches: list[Branch]
    events: list[Event]


def diagram(parameter: str, values: Sequence[float], solve: Rows, fixed: dict[str, float]) -> Diagram:
    """The branches over the values, which ascend. solve: all equilibria at each of some values.

    Values are added beside each event, where a branch turns as a square root does, and where tips move fast.
    """
    tracker = Tracker()
    low: Point = (values[0], solve(values[:1])[0])
    tracker.begin(*low)
    for high in zip(values[1:], solve(values[1:]), strict=True):
        events = crossings(low, high, solve)
        between = beside([low[0], *(one[0][0] for one in events), high[0]]) if events else []
        line = sorted([*zip(between, solve(between), strict=True), *(point for pair in events for point in pair)])
        line = [low, *line, high]
        for one, other in pairwise([part for pair in pairwise(line) for part in closer(*pair, solve)] + [high]):
            if (one, other) in events:
                tracker.cross(one, other)
            elif not any(other in pair for pair in events):  # next to an event others have nothing to show
                tracker.go_on(*other)
        low = high
    return Diagram(parameter, fixed, tracker.branches, tracker.events)


def beside(ends: Sequence[float]) -> list[float]:
    """Values ever closer to each end of each interval."""
    found = []
    for low, high in pairwise(ends):
        for k in range(1, CLOSER):
            found += [low + (high - low) / 4**k, high - (high - low) / 4**k]
    return sorted(set(found))


def closer(low: Point, high: Point, solve: Rows, depth: int = DEPTH) -> list[Point]:
    """The first point, and others before the second one so that between neighbours no tip turns by more than STEP."""
    pairs = zip(low[1], high[1], strict=False)
    if not depth or kinds(low) != kinds(high) or all(abs(a.tip_angle - b.tip_angle) <= STEP for a, b in pairs):
        return [low]
    at = low[0] + (high[0] - low[0]) / 2
    middle = (at, solve([at])[0])
    return closer(low, middle, solve, depth - 1) + closer(middle, high, solve, depth - 1)


def beside_folds(rod: Mapping[str, float], field_angle: float, low: float, high: float) -> list[float]:
    """Values of η on both sides of every fold in a range, so that none hides between two others.

    rod: its beta, length and clamp_angle.
    """
    folds = all_folds(rod["beta"], rod["length"], rod["clamp_angle"], field_angle, low, high)
    found = (fold.eta * (1 + side * BESIDE) for fold in folds for side in (-1, 1))
    return [value for value in found if low < value < high]


def crossings(low: Point, high: Point, solve: Rows) -> list[tuple[Point, Point]]:
    """The events between two values, each as the neighbouring doubles, or nearly, on both sides."""
    if kinds(low) == kinds(high):
        return []
    middle = low[0] + (high[0] - low[0]) / 2
    if high[0] - low[0] <= 4 * ulp(max(abs(low[0]), abs(high[0]))) or middle in (low[0], high[0]):
        return [(low, high)]
    at = (middle, solve([middle])[0])
    return crossings(low, at, solve) + crossings(at, high, solve)


def kinds(point: Point) -> list[int]:
    """The indices in the order of the tip angles."""
    return [state.index for state in point[1]]
