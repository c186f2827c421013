"""The first example: how far the tip of a rod that a force bends is drawn back by a field along the undeformed axis."""

from __future__ import annotations

from math import pi
from typing import Any

import numpy as np

from derive.diagrams.branches import Diagram, beside_folds, diagram
from derive.diagrams.states import rows
from derive.report.figures import style
from generated import remote_control_numpy

LENGTH, CLAMP, FIELD = 80.0, pi / 2, pi / 2
FORCES = (0.0001, 0.0002, 0.0003, 0.0004, 0.0005)
HIGHEST = 0.005
SAMPLES = 61


def draw(figure: Any) -> None:
    """One curve for each force, named at its start."""
    figure.set_size_inches(6.2, 4.2)
    axes = figure.add_subplot()
    for beta, colour in zip(FORCES, style.COLOURS, strict=False):
        for branch in curves(beta).branches:
            label = None if branch.number > 1 else rf"$\beta = {beta:.4f}$"
            heights = [state.y for state in branch.states]
            axes.plot(branch.values, heights, ls=style.line_of(branch.index), color=colour, label=label)
    axes.set(xlabel=r"$\eta$", ylabel=r"$y_\ell$", xlim=(0, HIGHEST), ylim=(0, None))
    axes.legend(reverse=True)
    axes.set_title(r"$\ell = 80$, $\vartheta_{\mathrm{o}} = \pi/2$, field orthogonal to the force", fontsize=10)


def curves(beta: float) -> Diagram:
    """The diagram of a force."""
    fixed = {"beta": beta, "length": LENGTH, "clamp_angle": CLAMP}
    values = sorted({*np.linspace(0, HIGHEST, SAMPLES).tolist(), *beside_folds(fixed, FIELD, 0.0, HIGHEST)})
    return diagram("eta", values, lambda some: rows(remote_control_numpy, "eta", some, fixed), fixed)
