"""The figures by name: those of the article's examples, and two of our own; `draw` gives the bytes of a file."""

from __future__ import annotations

import io
from collections.abc import Callable
from typing import Any

from derive.report.figures import bifurcation, deformed, fold_set, remote_control, style, turning_field

FORMATS = ("svg", "png", "pdf")
# What a drawn file says about its making: nothing that changes from run to run.
_UNDATED: dict[str, dict[str, Any]] = {
    "svg": {"Date": None, "Creator": None},
    "png": {"Software": None},
    "pdf": {"CreationDate": None, "Creator": None, "Producer": None},
}

FIGURES: dict[str, Callable[[Any], None]] = {
    "remote-control": remote_control.draw,
    "bifurcation": bifurcation.draw,
    "deformed": deformed.draw,
    "separate-loads": deformed.draw_separate,
    "fold-set": fold_set.draw,
    "turning-field": turning_field.draw,
}


def draw(name: str, formats: tuple[str, ...]) -> dict[str, bytes]:
    """A figure in each of the formats; ImportError where matplotlib is missing."""
    import matplotlib
    from matplotlib.figure import Figure

    with matplotlib.rc_context():
        matplotlib.rcdefaults()
        matplotlib.rcParams.update(style.SETTINGS)
        figure = Figure(layout="constrained")
        FIGURES[name](figure)
        return {kind: _saved(figure, kind) for kind in formats}


def _saved(figure: Any, kind: str) -> bytes:
    stream = io.BytesIO()
    figure.savefig(stream, format=kind, dpi=160, metadata=_UNDATED[kind])
    return stream.getvalue()
