"""What a slow loading does: the rod stays on a stable branch until that ends, and falls to the next stable one.

Along the tip angle minima of the energy and saddles alternate. At a fold a minimum and the saddle beside it vanish
together; the rod falls past where the saddle was, to the minimum behind it. At a pitchfork a minimum either splits in
two, or loses its two saddles and is one itself: the rod goes to either side.
"""

from __future__ import annotations

from dataclasses import dataclass

from derive.diagrams.branches import Diagram
from derive.diagrams.states import State
from derive.diagrams.tracker import Branch, Event


@dataclass(frozen=True)
class Jump:
    """At a value, in a direction of loading ('up' or 'down'), the rod leaves a branch for one of others.

    gap: by how much the tip angle changes at once, to the first of them.
    """

    value: float
    direction: str
    leaves: int
    reaches: tuple[int, ...]
    gap: float


def jumps(found: Diagram) -> list[Jump]:
    """Every jump, of loading upwards in the order of the parameter and then of loading downwards."""
    branches = {branch.number: branch for branch in found.branches}
    result = []
    for up in (True, False):
        for event in found.events if up else found.events[::-1]:
            here, there = (event.below, event.above) if up else (event.above, event.below)
            for number in here:
                branch = branches[number]
                if branch.index == 0 and number not in there:
                    targets = [branches[k] for k in reached(event, branches, number, here, there)]
                    result.append(jump(event, branch, targets, up))
    return result


def reached(
    event: Event, branches: dict[int, Branch], leaves: int, here: tuple[int, ...], there: tuple[int, ...]
) -> list[int]:
    """The stable branches on the other side to which the rod goes from one that ends."""
    at = here.index(leaves)
    new = [number for number in there if number not in here and branches[number].index == 0]
    if new:  # a pitchfork: it splits, or is what two become
        return new
    met = [k for k, number in enumerate(here) if number not in there]
    group = [k for k in met if abs(k - at) <= 2]
    found = []
    for step in (-1, 1):
        place = at + step
        if place not in group:
            continue  # nothing vanishes on this side: the energy rises there
        while 0 <= place < len(here) and (here[place] not in there or branches[here[place]].index):
            place += step
        if 0 <= place < len(here):
            found.append(here[place])
    return found


def jump(event: Event, branch: Branch, targets: list[Branch], up: bool) -> Jump:
    """The record of a jump."""
    gaps = [state_at(target, event.value).tip_angle - event.state.tip_angle for target in targets]
    reaches = tuple(target.number for target in targets)
    return Jump(event.value, "up" if up else "down", branch.number, reaches, gaps[0] if gaps else float("nan"))


def state_at(branch: Branch, value: float) -> State:
    """The state of a branch at the value nearest to this one."""
    place = min(range(len(branch.values)), key=lambda k: abs(branch.values[k] - value))
    return branch.states[place]
