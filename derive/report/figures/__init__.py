"""The figures by name: those of the article's examples, and two of our own; `draw` gives the bytes of a file."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from derive.diagrams import plotting
from derive.diagrams.plotting import FORMATS
from derive.report.figures import bifurcation, deformed, fold_set, remote_control, style, turning_field

__all__ = ["FIGURES", "FORMATS", "draw"]

FIGURES: dict[str, Callable[[Any], None]] = {
    "remote-control": remote_control.draw,
    "bifurcation": bifurcation.draw,
    "deformed": deformed.draw,
    "separate-loads": deformed.draw_separate,
    "fold-set": fold_set.draw,
    "turning-field": turning_field.draw,
}


def draw(name: str, formats: tuple[str, ...]) -> dict[str, bytes]:
    """A figure in each of the formats; MistakeError where matplotlib is missing."""
    with plotting.settings(**style.SETTINGS):
        figure = plotting.figure(layout="constrained")
        FIGURES[name](figure)
        return {kind: plotting.saved(figure, kind) for kind in formats}
