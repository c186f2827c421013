"""Pairing of brackets, bars, sets, matrices and alignments while a formula is split into tokens.

Errors name both places, and nesting is bounded. What a bar or a square bracket is (opening, closing, evaluation, the
end of an interval) is decided here, by what stands before it and what is open.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from lark import Token

from .errors import ReadError

MAX_DEPTH = 32  # of nested brackets and braces; the article needs 8

CLOSES = {
    "RPAR": ("LPAR",), "RBRACKET": ("LBRACKET",), "RBRACE": ("LBRACE",), "RSET": ("LSET", "LNONE"),
    "RBAR": ("LBAR",), "RNONE": ("LSET",), "ENDMATRIX": ("MATRIX",), "ENDSPLIT": ("SPLIT",),
}  # fmt: skip
OPENS = ("LPAR", "LBRACKET", "LBRACE", "LSET", "LNONE", "LBAR", "MATRIX", "SPLIT")
_ENDS_OPERAND = (
    "RPAR", "RBRACKET", "RBRACE", "RSET", "RBAR", "NUMBER", "LETTER", "COMMAND", "TICK", "PRIME",
)  # fmt: skip
_BEFORE_INTERVAL = (r"\in", r"\notin", r"\times", "{")


@dataclass
class _Frame:
    """What is open: its token, whether it may be an interval, and the commas directly in it."""

    token: Token
    interval: bool = False
    commas: int = 0


class Brackets:
    """What is open at a place; ``error(offset, message)`` makes the errors."""

    def __init__(self, error: Callable[[int, str], ReadError]) -> None:
        self.error = error
        self._open: list[_Frame] = []
        self._interval = False

    def align(self, text: str, offset: int) -> str:
        """The kind of ``&`` or ``\\\\``: ROW between the rows of a matrix, empty in an alignment."""
        frames = list(self._open)
        if frames and frames[-1].token.type == "MATRIX" and text != "&":
            return "ROW"
        while frames and frames[-1].token.type in ("LPAR", "LBRACKET", "LSET") and r"\left" not in frames[-1].token:
            frames.pop()
        if not frames or frames[-1].token.type != "SPLIT":
            raise self.error(offset, f"'{text}' outside an alignment or a matrix of one column")
        return ""

    def environment(self, text: str) -> str:
        """The kind of the begin or end of an alignment or a matrix."""
        return ("END" if text.startswith(r"\end") else "") + ("MATRIX" if "matrix" in text else "SPLIT")

    def bar(self, text: str, before: Token | None, evaluates: bool) -> str:
        """The kind of a vertical bar: one before an index evaluates, the others pair within their bracket."""
        if text.startswith((r"\left", r"\right")):
            return "LBAR" if text.startswith(r"\left") else "RBAR"
        if evaluates:
            return "EVAL"
        opened = bool(self._open) and self._open[-1].token.type == "LBAR"
        return "RBAR" if opened and before is not None and before.type in _ENDS_OPERAND else "LBAR"

    def square(self, text: str, before: Token | None) -> str:
        """The kind of a bare square bracket that opens or ends an interval; empty for all other brackets."""
        self._interval = False
        if text not in ("[", "]"):
            return ""
        if self._open and self._open[-1].interval and self._open[-1].commas == 1:
            return "RBRACKET"
        self._interval = before is not None and str(before) in _BEFORE_INTERVAL
        return "LBRACKET" if self._interval else ""

    def pair(self, token: Token) -> None:
        """Open or close; a ``\\left`` needs its ``\\right``."""
        offset = token.start_pos or 0
        if token.type in OPENS:
            self._open.append(_Frame(token, self._interval and token.type == "LBRACKET"))
            if len(self._open) > MAX_DEPTH:
                raise self.error(offset, f"brackets nest deeper than {MAX_DEPTH}; write the formula in parts")
        elif token.type in CLOSES:
            if not self._open or self._open[-1].token.type not in CLOSES[token.type]:
                expected = f"; '{self._open[-1].token}' is open" if self._open else ""
                word = "ends" if token.type.startswith("END") else "closes"
                raise self.error(offset, f"'{token}' {word} nothing{expected}")
            opened = self._open.pop().token
            if opened.startswith(r"\left") != token.startswith(r"\right"):
                raise self.error(offset, f"'{opened}' and '{token}' do not belong together")
        elif token.type == "COMMA" and self._open:
            self._open[-1].commas += 1

    def end(self, offset: int) -> None:
        """The end of the formula: nothing may be open."""
        for frame in reversed(self._open):
            if frame.token.type in ("SPLIT", "MATRIX"):
                raise self.error(offset, "an alignment or matrix is never ended")
            raise self.error(frame.token.start_pos or 0, f"'{frame.token}' is never closed")
