"""What all pictures share: matplotlib if it is there, colours, and the bytes of a file."""

from __future__ import annotations

import io
from pathlib import Path
from typing import Any

from derive.numbers import MistakeError

# Told apart without colour vision (Okabe and Ito).
COLOURS = ("#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#8c6d1f", "#555555")
# What a drawn file says about its making: nothing that changes from run to run.
UNDATED: dict[str, dict[str, Any]] = {
    "svg": {"Date": None, "Creator": None},
    "png": {"Software": None},
    "pdf": {"CreationDate": None, "Creator": None, "Producer": None},
}
FORMATS = tuple(UNDATED)
SETTINGS: dict[Any, Any] = {
    "svg.hashsalt": "magnetic-rods",
    "svg.fonttype": "path",
    "pdf.fonttype": 42,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "legend.frameon": False,
}
LETTERS = {"beta": "β", "eta": "η", "length": "ℓ", "clamp_angle": "θ(0)", "field_angle": "α"}


def format_of(path: Path) -> str:
    """The format that the name of a picture's file asks for."""
    suffix = path.suffix[1:].lower()
    if suffix not in FORMATS:
        raise MistakeError(f"{path}: a picture's name must end in .{', .'.join(FORMATS)}")
    return suffix


def library() -> Any:
    """Matplotlib; MistakeError where it is missing."""
    try:
        import matplotlib
    except ModuleNotFoundError as error:
        raise MistakeError("a picture needs matplotlib: pip install 'magnetic-rods[pictures]'") from error
    return matplotlib


def settings(**more: Any) -> Any:
    """A context in which matplotlib has our settings and no others, and what is saved depends on nothing else."""
    matplotlib = library()
    return matplotlib.rc_context({**matplotlib.rcParamsDefault, **SETTINGS, **more})


def figure(**options: Any) -> Any:
    """An empty figure, without a screen."""
    library()
    from matplotlib.figure import Figure

    return Figure(**options)


def saved(drawn: Any, kind: str, **options: Any) -> bytes:
    """A figure as the bytes of a file."""
    stream = io.BytesIO()
    drawn.savefig(stream, format=kind, dpi=160, metadata=UNDATED[kind], **options)
    return stream.getvalue()
