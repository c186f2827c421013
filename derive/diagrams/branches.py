"""Complete branches of equilibria over one parameter: where they begin, end, and what happens there.

Two equilibria of one rod never share a tip angle: the tip angle and θ′(ℓ) = 0 determine the solution of the equation.
So between two events, at which equilibria are born or vanish, the one that is k-th in the order of the tip angles
stays the k-th, and is one smooth branch. Events are found from the numbers of equilibria: between neighbouring values
at which they differ, the interval is halved down to rounding. Two events between neighbouring values may cancel; those
over η are known beforehand (``folds``), others need values close enough.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import pairwise
from math import ulp

from derive.diagrams.states import State
from derive.emit.kernels.folds import all_folds

Rows = Callable[[Sequence[float]], list[list[State]]]
Point = tuple[float, list[State]]
ALIKE = 5.0  # gaps of tip angles that differ by less than this factor close together: three equilibria meet
RANGE = "range"
STEP, DEPTH = 0.1, 8  # radians between neighbours, unless the interval has been halved that often
BESIDE = 1e-9  # on both sides of a fold that is known, relative: the fold between, and no other
CLOSER = 8  # values beside an event, each four times as close to it as the last


@dataclass
class Branch:
    """Equilibria of one index over an interval of the parameter.

    starts, ends: 'range' at an end of the range, else 'fold' or 'pitchfork', of which the place is the end point.
    """

    number: int
    index: int
    starts: str
    ends: str = RANGE
    values: list[float] = field(default_factory=list)
    states: list[State] = field(default_factory=list)


@dataclass(frozen=True)
class Event:
    """Equilibria meet, and two of them are there on one side only.

    state: the one they become, with the lower of their indices. change: how many more there are above the value. below,
    above: numbers of the branches on both sides, in the order of tip angles.
    """

    value: float
    kind: str
    state: State
    change: int
    below: tuple[int, ...]
    above: tuple[int, ...]


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


class Tracker:
    """Branches as they grow from value to value."""

    def __init__(self) -> None:
        self.branches: list[Branch] = []
        self.events: list[Event] = []
        self.open: list[Branch] = []

    def begin(self, value: float, states: Sequence[State]) -> None:
        """The branches at the low end of the range."""
        self.open = [self.new(state.index, RANGE) for state in states]
        self.go_on(value, states)

    def new(self, index: int, starts: str) -> Branch:
        """One more branch."""
        branch = Branch(len(self.branches) + 1, index, starts)
        self.branches.append(branch)
        return branch

    def go_on(self, value: float, states: Sequence[State]) -> None:
        """One more value without an event before it."""
        for branch, state in zip(self.open, states, strict=True):
            if not branch.values or branch.values[-1] < value:
                branch.values.append(value)
                branch.states.append(state)

    def cross(self, low: Point, high: Point) -> None:
        """Pass an event: what meets ends or starts here, all else goes on."""
        grows = len(high[1]) > len(low[1])
        more, fewer = (high, low) if grows else (low, high)
        meeting = groups(more[1], (len(more[1]) - len(fewer[1])) // 2)
        before = list(self.open)
        value = more[0]
        for start, size in meeting:
            for branch in self.meeting(before, start, size, grows):
                state = middle(more[1][start : start + size], branch.index)
                close(branch, value, state, named(size))
        self.open = self.after(before, high[1], meeting, grows, more, value)
        ids = [tuple(branch.number for branch in side) for side in (before, self.open)]
        for start, size in meeting:
            lowest = min(state.index for state in more[1][start : start + size])
            state = middle(more[1][start : start + size], lowest)
            self.events.append(Event(value, named(size), state, 2 if grows else -2, ids[0], ids[1]))

    @staticmethod
    def meeting(before: list[Branch], start: int, size: int, grows: bool) -> list[Branch]:
        """The branches below the event that end at it."""
        if not grows:
            return before[start : start + size]
        return before[start : start + 1] if size == 3 else []

    def after(
        self,
        before: list[Branch],
        states: list[State],
        meeting: list[tuple[int, int]],
        grows: bool,
        more: Point,
        value: float,
    ) -> list[Branch]:
        """The branches above the event, those that start there among them."""
        found: list[Branch] = []
        rest, place = iter(before), 0
        for start, size in sorted(meeting):
            while place < start:
                found.append(next(rest))
                place += 1
            if not grows:
                for _ in range(size):
                    next(rest)
                place += size
            else:
                place += size
                if size == 3:
                    next(rest)
            for _ in range(size if grows else size - 2):
                branch = self.new(states[len(found)].index, named(size))
                branch.values.append(value)
                branch.states.append(middle(more[1][start : start + size], branch.index))
                found.append(branch)
        return found + list(rest)


def named(size: int) -> str:
    """The kind of an event at which so many equilibria meet."""
    return "fold" if size == 2 else "pitchfork"


def close(branch: Branch, value: float, state: State, kind: str) -> None:
    """End a branch at an event."""
    branch.ends = kind
    if branch.values[-1] < value:
        branch.values.append(value)
        branch.states.append(state)
    else:
        branch.states[-1] = state


def groups(states: Sequence[State], pairs: int) -> list[tuple[int, int]]:
    """Which neighbours meet: the place of the first and how many, two or three, of as many groups as pairs vanish."""
    gaps = [(b.tip_angle - a.tip_angle, k) for k, (a, b) in enumerate(pairwise(states))]
    found: list[tuple[int, int]] = []
    taken: set[int] = set()
    for gap, k in sorted(gaps):
        if len(found) == pairs:
            break
        if {k, k + 1} & taken:
            continue
        beside = [j for j in (k - 1, k + 1) if 0 <= j < len(gaps) and gaps[j][0] < ALIKE * gap]
        first, size = (min(k, beside[0]), 3) if beside else (k, 2)
        found.append((first, size))
        taken |= set(range(first, first + size))
    return sorted(found)


def middle(states: Sequence[State], index: int) -> State:
    """The equilibrium that some which meet become."""
    means = [sum(column) / len(states) for column in zip(*(state.numbers() for state in states), strict=True)]
    tip_angle, clamp_curvature, gamma, y, z, energy = means
    return State(tip_angle, clamp_curvature, gamma, y, z, energy, index)
