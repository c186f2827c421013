"""The tokens of a formula in LaTeX, read from left to right."""

from __future__ import annotations

import re

from derive.report.page import symbols as sy

TOKEN = re.compile(r"\\[A-Za-z]+|\\.|\d+(?:\.\d+)?|\s+|.", re.DOTALL)
LONGEST = 6_000  # characters of LaTeX that anybody would set
ENDS = {"}", "&", r"\\", r"\end", r"\right"}  # a group, a cell, a bracket
DEEPER, HIGHER = ("{", r"\begin", r"\left"), ("}", r"\end", r"\right")
SIZED = r"\big)"  # what closes a bracket of a size, whichever


class UnsetError(ValueError):
    """The formula cannot be set; the message says at what it stopped."""


class Tokens:
    """What is left of a formula; rest: the last token first."""

    def __init__(self, latex: str) -> None:
        if len(latex) > LONGEST:
            raise UnsetError("too long")
        self.rest = TOKEN.findall(latex)[::-1]

    def next(self) -> str:
        """The token that comes next, behind any space; empty at the end."""
        while self.rest and self.rest[-1].isspace():
            self.rest.pop()
        return self.rest[-1] if self.rest else ""

    def take(self, wanted: str = "") -> str:
        """The next token, which must be the one that is wanted."""
        found = self.next()
        if not found or (wanted and found != wanted):
            raise UnsetError(f"{found or 'the end'} where {wanted or 'something'} must stand")
        return self.rest.pop()

    def bracket(self) -> str:
        """The character of the next bracket; empty for the one that is not seen."""
        token = self.take()
        if token not in sy.FENCES:
            raise UnsetError(f"{token} is no bracket")
        return sy.FENCES[token]

    def at(self, closing: str) -> bool:
        """Does that come next? SIZED is any closing bracket of a size."""
        if closing != SIZED:
            return self.next() == closing
        return self.next()[1:] in sy.SIZES and len(self.rest) > 1 and self.rest[-2] in sy.CLOSING

    def closes(self) -> bool:
        """Is a bracket of a size that was opened closed by another, in the same group and cell?"""
        depth, open_ones, before = 0, 1, ""
        for token in reversed(self.rest):
            depth += (token in DEEPER) - (token in HIGHER)
            if depth < 0 or (depth == 0 and token in ("&", r"\\")):
                return False
            if depth == 0 and before[1:] in sy.SIZES:
                open_ones += (token in sy.OPENING) - (token in sy.CLOSING)
            if open_ones == 0:
                return True
            before = token
        return False

    def plain(self) -> str:
        """Text in braces as it stands."""
        self.take("{")
        found = ""
        while self.rest and self.rest[-1] != "}":
            found += self.rest.pop()
        self.take("}")
        return found
