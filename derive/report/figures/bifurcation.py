"""The second example: eight diagrams over η, each for one force, with the points where solutions appear."""

from __future__ import annotations

from math import pi
from typing import Any

from derive.emit.kernels.folds import all_folds
from derive.report.figures import style
from derive.report.figures.diagrams import pieces
from generated.bifurcation_numpy import sweep

LENGTH, CLAMP = 80.0, 3 * pi / 4
FORCES = (0.0, 0.0001, 0.0002, 0.00025, 0.0003, 0.00035, 0.0004, 0.0005)
HIGHEST = 0.0011


def draw(figure: Any) -> None:
    """w of the tip; the curves bear the article's numbers."""
    figure.set_size_inches(7.4, 5.4)
    axes = figure.add_subplot()
    axes.axhline(0, color=style.GREY, lw=0.6)
    for number, (beta, colour) in enumerate(zip(FORCES, style.COLOURS, strict=True), start=1):
        folds = all_folds(beta, LENGTH, CLAMP, 0.0, 0.0, HIGHEST)
        found = pieces(sweep, beta, [fold.eta for fold in folds], 0.0, HIGHEST)
        for k, piece in enumerate(found):
            height = style.across(piece.y, piece.z, CLAMP)
            label = None if k else rf"{number}: $\beta = {beta:g}$"
            axes.plot(piece.eta, height, ls=style.line_of(piece.index), color=colour, label=label)
            if piece.eta[0] < 0.001 * HIGHEST:
                axes.annotate(
                    str(number), (piece.eta[0], height[0]), (4, 6) if number > 3 else (9, -3), **beside(colour)
                )
        for fold in folds:
            point = (fold.eta, style.across(fold.y, fold.z, CLAMP))
            axes.plot(*point, "o", ms=6, mfc="white", mec=colour, mew=1.6)
            axes.annotate(str(number), point, (-13, 0), **beside(colour))
    axes.plot([], [], "o", ms=6, mfc="white", mec=style.GREY, mew=1.6, label="bifurcation point")
    axes.plot([], [], ls=style.UNSTABLE, color=style.GREY, label="unstable")
    axes.set(xlabel=r"$\eta$", ylabel=r"$w_\ell$", xlim=(0, HIGHEST))
    axes.set_title(r"$\ell = 80$, $\vartheta_{\mathrm{o}} = 3\pi/4$, field parallel to the force", fontsize=10)
    figure.legend(*axes.get_legend_handles_labels(), loc="outside right center")


def beside(colour: str) -> dict[str, Any]:
    """How a number stands beside a point of its curve."""
    return {"textcoords": "offset points", "va": "center", "color": colour, "fontsize": 9}
