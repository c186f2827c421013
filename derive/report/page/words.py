"""The pieces of the page: text escaped, formulas as MathML, and names that can be linked to."""

from __future__ import annotations

import re
from collections.abc import Iterable

from markupsafe import Markup, escape

from derive.report import text as tex
from derive.report.page.mathml import mathml

NO_ANCHOR = re.compile(r"[^\w.-]", re.ASCII)


class Html:
    """Pieces of HTML, as of `derive.report.words.Words`."""

    def text(self, said: str) -> Markup:
        """Escaped."""
        return escape(said)

    def prose(self, said: str) -> Markup:
        """Escaped, but for names and numbers."""
        return self.join("", (mathml(part) if formula else escape(part) for formula, part in tex.pieces(said)))

    def inline(self, latex: str) -> Markup:
        """In the line."""
        return mathml(latex)

    def part(self, latex: str) -> Markup:
        """In the line, too."""
        return mathml(latex)

    def block(self, latex: str) -> Markup:
        """On lines of its own."""
        return mathml(latex, block=True)

    def join(self, between: str, parts: Iterable[str]) -> Markup:
        """One piece."""
        return escape(between).join(parts)


def anchor(*names: str) -> str:
    """The id of what has these names: for a label the label, for others what they are before their name."""
    return NO_ANCHOR.sub(lambda found: f"-{ord(found[0]):x}-", ".".join(name for name in names if name))
