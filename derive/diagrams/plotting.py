"""What all pictures share: matplotlib if it is there, colours, and files that are written whole."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from derive.diagrams.files import write_whole
from derive.numbers import MistakeError

# Told apart without colour vision (Okabe and Ito).
COLOURS = ("#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#8c6d1f", "#555555")
FORMATS = ("svg", "png", "pdf")
SETTINGS: dict[Any, Any] = {
    "svg.hashsalt": "magnetic-rods",
    "font.size": 11,
    "svg.fonttype": "path",
    "pdf.compression": 6,
}
LETTERS = {"beta": "β", "eta": "η", "length": "ℓ", "clamp_angle": "θ(0)", "field_angle": "α"}


def canvas(path: Path, width: float = 6.4, height: float = 4.8) -> tuple[Any, Any]:
    """An empty figure and its axes; MistakeError if the file's format or matplotlib is missing."""
    format_of(path)
    try:
        import matplotlib
    except ModuleNotFoundError as error:
        raise MistakeError("a picture needs matplotlib: pip install 'magnetic-rods[pictures]'") from error
    matplotlib.use("agg")
    from matplotlib import pyplot

    pyplot.rcParams.update(SETTINGS)
    figure, axes = pyplot.subplots(figsize=(width, height))
    for side in ("top", "right"):
        axes.spines[side].set_visible(False)
    return figure, axes


def format_of(path: Path) -> str:
    """The format that the name of a picture's file asks for."""
    suffix = path.suffix[1:].lower()
    if suffix not in FORMATS:
        raise MistakeError(f"{path}: a picture's name must end in .{', .'.join(FORMATS)}")
    return suffix


def save(figure: Any, path: Path) -> None:
    """Write a figure, whole or not at all, the same bytes for the same figure."""
    from matplotlib import pyplot

    kind = format_of(path)
    metadata = {"svg": {"Date": None}, "pdf": {"CreationDate": None}, "png": {}}[kind]
    try:
        write_whole(
            path, lambda stream: figure.savefig(stream, format=kind, bbox_inches="tight", dpi=160, metadata=metadata)
        )
    except OSError as error:
        raise MistakeError(f"{path}: cannot be written ({error.strerror}); choose another file") from error
    finally:
        pyplot.close(figure)
