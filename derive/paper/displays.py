"""The displayed equations of a LaTeX source."""

from __future__ import annotations

import re
from dataclasses import dataclass
from pathlib import Path

from .errors import ReadError, error_at, place

MAX_SOURCE = 5_000_000  # characters; the article has 80 000

_EDGE = re.compile(r"\\(begin|end)\{equation\*?\}")
_LABEL = re.compile(r"\\label\s*\{\s*([^{}\s]*)\s*\}")
_COMMENT = re.compile(r"(?<!\\)(?:\\\\)*%[^\n]*")
_CONTROL = re.compile(r"[\x00-\x08\x0b\x0e-\x1f\x7f]")


@dataclass(frozen=True)
class Display:
    """One displayed equation. line, column, offset: of the first character of ``latex`` in the source."""

    label: str
    line: int
    column: int
    offset: int
    latex: str


def read_source(path: str | Path) -> str:
    """The text of a LaTeX source; ReadError if it is no UTF-8 text, OSError if it cannot be opened."""
    data = Path(path).read_bytes()
    try:
        return data.decode("utf-8")
    except UnicodeDecodeError as error:
        before = data[: error.start]
        column = error.start - (before.rfind(b"\n") + 1) + 1
        message = "this is no UTF-8 text; give a LaTeX source"
        raise ReadError(before.count(b"\n") + 1, column, message) from None


def read_displays(text: str) -> list[Display]:
    """All ``equation`` environments of a source, in order.

    ReadError if there are none, if one is not closed, has no label or the label of another, or if the text is binary
    or too long.
    """
    if len(text) > MAX_SOURCE:
        raise error_at(text, 0, f"{len(text)} characters; the limit is {MAX_SOURCE}")
    if control := _CONTROL.search(text):
        raise error_at(text, control.start(), "a control character: this is no LaTeX text")
    visible = _COMMENT.sub(lambda match: " " * len(match.group()), text)
    displays: dict[str, Display] = {}
    opened: re.Match[str] | None = None
    for edge in _EDGE.finditer(visible):
        if (edge[1] == "begin") != (opened is None):
            raise error_at(text, edge.start(), "'equation' environments do not pair here")
        if opened is None:
            opened = edge
            continue
        display = _display(text, visible, opened.end(), edge.start())
        if display.label in displays:
            first = displays[display.label].line
            raise error_at(text, opened.start(), f"the label '{display.label}' is already used on line {first}")
        displays[display.label] = display
        opened = None
    if opened is not None:
        raise error_at(text, opened.start(), "this 'equation' is never closed")
    if not displays:
        raise error_at(text, 0, "there is no 'equation' environment in this text")
    return list(displays.values())


def _display(text: str, visible: str, start: int, stop: int) -> Display:
    labels = _LABEL.findall(visible, start, stop)
    if len(labels) != 1 or not labels[0]:
        raise error_at(text, start, f"a display needs one \\label, not {len(labels)}")
    line, column = place(text, start)
    return Display(labels[0], line, column, start, text[start:stop])
