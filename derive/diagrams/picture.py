"""Equilibria of one rod in the laboratory frame: y, the direction of the force, is up, and z points to the right."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import cos, sin
from typing import Any

from derive.diagrams.plotting import COLOURS, figure, saved, settings

INK = "#333333"
LABELS = 12  # a legend with more lines than these hides the rods


@dataclass(frozen=True)
class Curve:
    """One equilibrium: its number in the table, index, tip angle, and the positions along it."""

    number: int
    index: int
    tip_angle: float
    y: Sequence[float]
    z: Sequence[float]


@dataclass(frozen=True)
class View:
    """What is drawn beside the curves.

    field_angle: None without a field. force: whether there is one. unit: of length. turn: of angles.
    """

    length: float
    clamp_angle: float
    field_angle: float | None
    force: bool
    unit: str
    turn: str


def drawn(curves: Sequence[Curve], view: View, suffix: str) -> bytes:
    """The picture as the bytes of a file."""
    with settings(**{"font.size": 11}):
        drawing = figure(figsize=(6.4, 6.4))
        axes = drawing.add_subplot()
        draw_clamp(axes, view)
        for order, curve in enumerate(curves):
            draw_curve(axes, curve, COLOURS[order % len(COLOURS)], view, label=order < LABELS)
        draw_field(axes, curves, view)
        finish(axes, view, more=len(curves) - LABELS)
        return saved(drawing, suffix, bbox_inches="tight")


def draw_clamp(axes: Any, view: View) -> None:
    """A hatched wall across the rod's first direction."""
    size, angle = view.length / 80, view.clamp_angle
    across, behind = (cos(angle), -sin(angle)), (-sin(angle), -cos(angle))  # as (z, y)
    zs, ys = ([-7 * size * part, 7 * size * part] for part in across)
    axes.plot(zs, ys, color=INK, lw=2.5)
    for step in range(-6, 7, 2):
        foot = [step * size * part for part in across]
        end = [f + 3 * size * b + 2 * size * a for f, b, a in zip(foot, behind, across, strict=True)]
        axes.plot([foot[0], end[0]], [foot[1], end[1]], color=INK, lw=0.9)


def arrow(axes: Any, start: tuple[float, float], along: tuple[float, float], text: str) -> None:
    """An arrow with a letter at its end."""
    end = (start[0] + along[0], start[1] + along[1])
    style = {"arrowstyle": "-|>", "lw": 1.6, "color": INK, "shrinkA": 0, "shrinkB": 0}
    axes.annotate("", end, start, arrowprops=style, annotation_clip=False)
    axes.annotate(text, end, (4, 3), textcoords="offset points", annotation_clip=False)
    axes.update_datalim([start, end])


def draw_curve(axes: Any, curve: Curve, colour: str, view: View, *, label: bool) -> None:
    """A rod: solid if stable, else dashed, with its number and the force at its tip."""
    state = "stable" if curve.index == 0 else f"unstable, index {curve.index}"
    name = f"{curve.number}: {state}, θ(ℓ) = {curve.tip_angle:.4g}{view.turn}" if label else None
    axes.plot(curve.z, curve.y, "-" if curve.index == 0 else "--", color=colour, lw=2.2, label=name)
    tip = (curve.z[-1], curve.y[-1])
    axes.annotate(str(curve.number), tip, (6, -11), textcoords="offset points", color=colour, fontweight="bold")
    if view.force:
        arrow(axes, tip, (0.0, 0.14 * view.length), "F")


def draw_field(axes: Any, curves: Sequence[Curve], view: View) -> None:
    """The field's arrow left of everything."""
    if view.field_angle is None:
        return
    size = 0.2 * view.length
    left = min([0.0, *(z for curve in curves for z in curve.z)]) - 0.3 * view.length
    ys = [0.0, *(y for curve in curves for y in curve.y)]
    along = (size * sin(view.field_angle), size * cos(view.field_angle))
    arrow(axes, (left - along[0] / 2, (min(ys) + max(ys) - along[1]) / 2), along, "h")


def finish(axes: Any, view: View, more: int) -> None:
    """Equal axes, their names, the legend."""
    axes.set_aspect("equal")
    axes.margins(0.08)
    axes.autoscale_view()
    unit = f" ({view.unit})" if view.unit else ""
    axes.set_xlabel(f"z{unit}")
    axes.set_ylabel(f"y{unit}")
    if axes.get_legend_handles_labels()[0]:
        title = f"and {more} more" if more > 0 else None
        axes.legend(loc="lower left", bbox_to_anchor=(0.0, 1.0), title=title)
