"""How contents are written: what text, names in prose and formulas become in LaTeX; the page has the same in HTML."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Protocol

from derive.report import text as tex


class Words(Protocol):
    """Writes pieces of a report, each safe in its language whatever it holds."""

    def text(self, said: str) -> str:
        """Any text, as it stands."""

    def prose(self, said: str) -> str:
        """Text in which names of the theory and numbers are set as formulas."""

    def inline(self, latex: str) -> str:
        """A formula in a line of text."""

    def part(self, latex: str) -> str:
        """A part of a formula, set by itself."""

    def block(self, latex: str) -> str:
        """A formula on lines of its own."""

    def join(self, between: str, parts: Iterable[str]) -> str:
        """Pieces that are written already, with plain text between them."""


class Latex:
    """Pieces of a LaTeX document, whose template gives blocks and parts their place in mathematics."""

    def text(self, said: str) -> str:
        """Escaped."""
        return tex.text(said)

    def prose(self, said: str) -> str:
        """Escaped, but for names and numbers."""
        return tex.prose(said)

    def inline(self, latex: str) -> str:
        """Between dollar signs."""
        return f"${latex}$"

    def part(self, latex: str) -> str:
        """As it is."""
        return latex

    def block(self, latex: str) -> str:
        """As it is."""
        return latex

    def join(self, between: str, parts: Iterable[str]) -> str:
        """One string."""
        return between.join(parts)
