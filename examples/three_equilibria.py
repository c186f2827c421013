"""Draw the equilibria of one rod in the laboratory frame: docs/three-equilibria.svg (needs the extra `pictures`)."""

from __future__ import annotations

import sys
from math import cos, pi, sin
from pathlib import Path

import matplotlib

matplotlib.use("svg")
import matplotlib.pyplot as plt
import numpy as np

from generated.parallel_numpy import equilibria, shape

BETA, ETA, LENGTH, CLAMP = 0.00035, 0.00052, 80.0, 3 * pi / 4
COLOURS = ("#0072b2", "#d55e00", "#009e73")  # distinguishable without colour vision
ARROW = {"arrowstyle": "-|>", "lw": 1.6, "color": "#333333", "shrinkA": 0, "shrinkB": 0}


def draw_clamp(axes: plt.Axes) -> None:
    """A hatched wall across the rod's first direction."""
    across = np.array([cos(CLAMP), -sin(CLAMP)])  # (z, y) components, orthogonal to the tangent
    behind = -np.array([sin(CLAMP), cos(CLAMP)])
    ends = [7 * across, -7 * across]
    axes.plot(*zip(*ends, strict=True), color="#333333", lw=2.5, solid_capstyle="butt")
    for step in np.linspace(-6, 6, 7):
        foot = step * across
        axes.plot(*zip(foot, foot + 3 * behind + 2 * across, strict=True), color="#333333", lw=0.9)


def draw(path: Path) -> None:
    """One curve for each equilibrium: stable ones solid, unstable ones dashed."""
    plt.rcParams.update({"svg.hashsalt": "magnetic-rods", "font.size": 11, "svg.fonttype": "path"})
    figure, axes = plt.subplots(figsize=(6.0, 6.4))
    draw_clamp(axes)
    s = np.linspace(0, LENGTH, 241)
    for colour, one in zip(COLOURS, equilibria(BETA, ETA, LENGTH, CLAMP), strict=True):
        curve, name = shape(one, s), "stable" if one.index == 0 else "unstable"
        label = f"{name}, θ(ℓ) = {one.tip_angle:.3f}"
        axes.plot(curve.z, curve.y, "-" if one.index == 0 else "--", color=colour, lw=2.2, label=label)
        axes.annotate("", (one.z, one.y + 13), (one.z, one.y), arrowprops=ARROW)
        axes.text(one.z + 1.5, one.y + 9, "F", fontstyle="italic")
    axes.annotate("", (-9, -32), (-9, -50), arrowprops=ARROW)
    axes.text(-7.5, -43, "field", ha="left")
    axes.set_aspect("equal")
    axes.set_xlim(-14, 84)
    axes.set_ylim(-64, 31)
    axes.set_xlabel("z")
    axes.set_ylabel("y")
    axes.legend(loc="lower left", frameon=False, bbox_to_anchor=(0.0, 1.0))
    for side in ("top", "right"):
        axes.spines[side].set_visible(False)
    figure.savefig(path, bbox_inches="tight", metadata={"Date": None})


if __name__ == "__main__":
    draw(Path(sys.argv[1] if len(sys.argv) > 1 else "docs/three-equilibria.svg"))
