"""Branches as they grow over the values of a parameter, and what becomes of them at an event."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from itertools import pairwise

from derive.diagrams.states import State

Point = tuple[float, list[State]]
ALIKE = 5.0  # gaps of tip angles that differ by less than this factor close together: three equilibria meet
RANGE = "range"


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
