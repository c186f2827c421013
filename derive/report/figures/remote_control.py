"""The first example: how far the tip of a rod that a force bends is drawn back by a field along the undeformed axis."""

from __future__ import annotations

from math import pi
from typing import Any

from derive.emit.kernels.folds import all_folds
from derive.report.figures import style
from derive.report.figures.diagrams import pieces
from generated.remote_control_numpy import sweep

LENGTH, CLAMP, FIELD = 80.0, pi / 2, pi / 2
FORCES = (0.0001, 0.0002, 0.0003, 0.0004, 0.0005)
HIGHEST = 0.005


def draw(figure: Any) -> None:
    """One curve for each force, named at its start."""
    figure.set_size_inches(6.2, 4.2)
    axes = figure.add_subplot()
    for beta, colour in zip(FORCES, style.COLOURS, strict=False):
        folds = [fold.eta for fold in all_folds(beta, LENGTH, CLAMP, FIELD, 0.0, HIGHEST)]
        for number, piece in enumerate(pieces(sweep, beta, folds, 0.0, HIGHEST)):
            label = None if number else rf"$\beta = {beta:.4f}$"
            axes.plot(piece.eta, piece.y, ls=style.line_of(piece.index), color=colour, label=label)
    axes.set(xlabel=r"$\eta$", ylabel=r"$y_\ell$", xlim=(0, HIGHEST), ylim=(0, None))
    axes.legend(reverse=True)
    axes.set_title(r"$\ell = 80$, $\vartheta_{\mathrm{o}} = \pi/2$, field orthogonal to the force", fontsize=10)
