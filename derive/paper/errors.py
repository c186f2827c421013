"""What the reader says when it cannot read: the place, the reason and the mend, never a guess."""

from __future__ import annotations

_CONTEXT = 40  # characters of the line shown on either side of the caret


class ReadError(ValueError):
    """Input that was not read.

    line, column: where, counted from 1. message: what is wrong there and how to mend it. snippet: the line's
    neighbourhood, and below it a caret under the place.
    """

    def __init__(self, line: int, column: int, message: str, snippet: str = "") -> None:
        self.line, self.column, self.message, self.snippet = line, column, message, snippet
        super().__init__(f"line {line}, column {column}: {message}" + (f"\n{snippet}" if snippet else ""))

    def __reduce__(self) -> tuple[type[ReadError], tuple[int, int, str, str]]:
        """Errors travel between processes."""
        return type(self), (self.line, self.column, self.message, self.snippet)


def place(text: str, offset: int, start: tuple[int, int] = (1, 1)) -> tuple[int, int]:
    """Line and column of an offset in a text whose first character stands at ``start``."""
    offset = min(max(offset, 0), len(text))
    breaks = text.count("\n", 0, offset)
    if breaks:
        return start[0] + breaks, offset - text.rfind("\n", 0, offset)
    return start[0], start[1] + offset


def error_at(text: str, offset: int, message: str, start: tuple[int, int] = (1, 1)) -> ReadError:
    """A ReadError for the place ``offset`` of the text, with the line and a caret."""
    offset = min(max(offset, 0), len(text))
    first = max(text.rfind("\n", 0, offset) + 1, offset - _CONTEXT)
    stop = text.find("\n", offset)
    last = min(len(text) if stop < 0 else stop, offset + _CONTEXT)
    shown = "".join(c if c.isprintable() else " " for c in text[first:last])
    line, column = place(text, offset, start)
    return ReadError(line, column, message, f"    {shown}\n    {' ' * (offset - first)}^")
