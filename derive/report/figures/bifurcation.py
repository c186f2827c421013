"""The second example: eight diagrams over η, each for one force, with the points where solutions appear."""

from __future__ import annotations

from math import pi
from typing import Any

import numpy as np

from derive.diagrams.branches import Diagram, beside_folds, diagram
from derive.diagrams.states import rows
from derive.diagrams.tracker import RANGE, Branch
from derive.report.figures import style
from generated import bifurcation_numpy

LENGTH, CLAMP = 80.0, 3 * pi / 4
FORCES = (0.0, 0.0001, 0.0002, 0.00025, 0.0003, 0.00035, 0.0004, 0.0005)
HIGHEST = 0.0011
SAMPLES = 61


def draw(figure: Any) -> None:
    """w of the tip; the curves bear the article's numbers."""
    figure.set_size_inches(7.4, 5.4)
    axes = figure.add_subplot()
    axes.axhline(0, color=style.GREY, lw=0.6)
    for number, (beta, colour) in enumerate(zip(FORCES, style.COLOURS, strict=True), start=1):
        found = curves(beta)
        for branch in found.branches:
            height = heights(branch)
            label = None if branch.number > 1 else rf"{number}: $\beta = {beta:g}$"
            axes.plot(branch.values, height, ls=style.line_of(branch.index), color=colour, label=label)
            if branch.starts == RANGE:
                at = (branch.values[0], height[0])
                axes.annotate(str(number), at, (4, 6) if number > 3 else (9, -3), **beside(colour))
        for event in found.events:
            point = (event.value, style.across(event.state.y, event.state.z, CLAMP))
            axes.plot(*point, "o", ms=6, mfc="white", mec=colour, mew=1.6)
            axes.annotate(str(number), point, (-13, 0), **beside(colour))
    axes.plot([], [], "o", ms=6, mfc="white", mec=style.GREY, mew=1.6, label="bifurcation point")
    axes.plot([], [], ls=style.UNSTABLE, color=style.GREY, label="unstable")
    axes.set(xlabel=r"$\eta$", ylabel=r"$w_\ell$", xlim=(0, HIGHEST))
    axes.set_title(r"$\ell = 80$, $\vartheta_{\mathrm{o}} = 3\pi/4$, field parallel to the force", fontsize=10)
    figure.legend(*axes.get_legend_handles_labels(), loc="outside right center")


def curves(beta: float) -> Diagram:
    """The diagram of a force, and values beside each of its folds so that none is missed."""
    fixed = {"beta": beta, "length": LENGTH, "clamp_angle": CLAMP}
    values = sorted({*np.linspace(0, HIGHEST, SAMPLES).tolist(), *beside_folds(fixed, 0.0, 0.0, HIGHEST)})
    return diagram("eta", values, lambda some: rows(bifurcation_numpy, "eta", some, fixed), fixed)


def heights(branch: Branch) -> list[float]:
    """w of the tip along a branch."""
    return [style.across(state.y, state.z, CLAMP) for state in branch.states]


def beside(colour: str) -> dict[str, Any]:
    """How a number stands beside a point of its curve."""
    return {"textcoords": "offset points", "va": "center", "color": colour, "fontsize": 9}
