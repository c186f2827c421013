"""A diagram as a picture: stable branches solid, others dashed, events marked, jumps as arrows."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from derive.diagrams.branches import Diagram
from derive.diagrams.jumps import jumps, state_at
from derive.diagrams.plotting import COLOURS, LETTERS, figure, saved, settings

SHOWN = {"y": "y(ℓ)", "z": "z(ℓ)", "tip_angle": "θ(ℓ)", "energy": "energy", "clamp_curvature": "θ′(0)"}
MARKS = {"fold": "o", "pitchfork": "D"}


def drawn(found: Sequence[Diagram], quantity: str, kind: str) -> bytes:
    """The diagrams of a family in one picture, each in its colour, as the bytes of a file."""
    with settings(**{"font.size": 11}):
        drawing = figure(figsize=(6.4, 4.8))
        draw(drawing.add_subplot(), found, quantity)
        return saved(drawing, kind, bbox_inches="tight")


def draw(axes: Any, found: Sequence[Diagram], quantity: str) -> None:
    """All curves, and what the lines mean."""
    changing = [name for name in found[0].fixed if len({one.fixed[name] for one in found}) > 1]
    for number, one in enumerate(found):
        colour = COLOURS[number % len(COLOURS)]
        label = ", ".join(f"{LETTERS[name]} = {one.fixed[name]:.6g}" for name in changing)
        draw_branches(axes, one, quantity, colour, label)
        if len(found) == 1:
            draw_jumps(axes, one, quantity)
    axes.set_xlabel(LETTERS[found[0].parameter])
    axes.set_ylabel(SHOWN[quantity])
    axes.ticklabel_format(axis="x", style="sci", scilimits=(-3, 4), useMathText=True)
    legend(axes, found)


def draw_branches(axes: Any, one: Diagram, quantity: str, colour: str, label: str) -> None:
    """The branches and events of one diagram."""
    for branch in one.branches:
        heights = [getattr(state, quantity) for state in branch.states]
        style = "-" if branch.index == 0 else "--" if branch.index == 1 else ":"
        axes.plot(branch.values, heights, style, color=colour, lw=1.8, label=label if branch.number == 1 else None)
    for event in one.events:
        height = getattr(event.state, quantity)
        axes.plot([event.value], [height], MARKS[event.kind], color=colour, mec="black", mew=0.8, ms=6, zorder=5)


def draw_jumps(axes: Any, one: Diagram, quantity: str) -> None:
    """Where a slow loading leaves a branch, and for which."""
    branches = {branch.number: branch for branch in one.branches}
    events = {event.value: event for event in one.events}
    for jump in jumps(one):
        start = getattr(events[jump.value].state, quantity)
        for target in jump.reaches:
            end = getattr(state_at(branches[target], jump.value), quantity)
            arrow = {"arrowstyle": "-|>", "color": "#777777", "lw": 1.2, "shrinkA": 4, "shrinkB": 2}
            axes.annotate("", (jump.value, end), (jump.value, start), arrowprops=arrow)


def legend(axes: Any, found: Sequence[Diagram]) -> None:
    """What the lines and marks mean, as far as they are there."""
    indices = {min(branch.index, 2) for one in found for branch in one.branches}
    for index, style, name in ((0, "-", "stable"), (1, "--", "unstable"), (2, ":", "index 2 and more")):
        if index in indices:
            axes.plot([], [], style, color="#333333", lw=1.8, label=name)
    for kind in sorted({event.kind for one in found for event in one.events}):
        axes.plot([], [], MARKS[kind], color="#bbbbbb", mec="black", mew=0.8, label=kind)
    axes.legend(fontsize=9, loc="upper left", bbox_to_anchor=(1.01, 1.0))
