"""What all figures share: letters, colours, the clamp and the arrows."""

from __future__ import annotations

from math import cos, sin
from typing import Any

import numpy as np

# Okabe and Ito's colours, which readers without full colour vision tell apart; grey for what is not data.
COLOURS = ("#0072b2", "#d55e00", "#009e73", "#cc79a7", "#56b4e9", "#e69f00", "#000000", "#8c6d1f")
GREY = "#444444"
SETTINGS: Any = {"mathtext.fontset": "stix", "font.size": 10, "lines.linewidth": 1.8}
STABLE, UNSTABLE = "-", (0, (4, 2))


def line_of(index: int) -> Any:
    """The line style by the number of directions in which the energy falls: solid where there is none."""
    return STABLE if index == 0 else UNSTABLE


def across(y: Any, z: Any, clamp_angle: float) -> Any:
    """The component orthogonal to the straight rod, w: the article's transverse displacement, upwards."""
    return z * cos(clamp_angle) - y * sin(clamp_angle)


def along(y: Any, z: Any, clamp_angle: float) -> Any:
    """The component along the straight rod."""
    return y * cos(clamp_angle) + z * sin(clamp_angle)


def clamp(axes: Any, size: float) -> None:
    """A hatched wall at the origin, which the straight rod leaves to the right."""
    axes.plot([0, 0], [-size, size], color=GREY, lw=2, solid_capstyle="butt")
    for foot in np.linspace(-size, size, 6):
        axes.plot([0, -0.5 * size], [foot, foot - 0.5 * size], color=GREY, lw=0.8)


def arrow(axes: Any, start: tuple[float, float], angle: float, size: float, label: str, color: str = GREY) -> None:
    """An arrow from a place in a direction of the picture, its letter beyond its start."""
    end = (start[0] + size * cos(angle), start[1] + size * sin(angle))
    shape = {"arrowstyle": "-|>", "lw": 1.4, "color": color, "shrinkA": 0, "shrinkB": 0}
    axes.annotate("", end, start, arrowprops=shape)
    place = (start[0] - 0.25 * size * cos(angle), start[1] - 0.25 * size * sin(angle))
    axes.text(*place, label, ha="center", va="center", color=color)


def plane(axes: Any) -> None:
    """Equal scales, and the names of the two directions of the laboratory."""
    axes.set_aspect("equal")
    axes.set_xlabel("along the undeformed axis")
    axes.set_ylabel(r"$w$")
