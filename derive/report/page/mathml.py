"""Formulas as MathML that browsers set by themselves, from the LaTeX that the article, the reports and SymPy write.

What is not in the tables of ``symbols`` is an UnsetError, never passed through: `mathml` then shows the text as it is.
"""

from __future__ import annotations

from functools import cache

from markupsafe import Markup

from derive.report.page import symbols as sy
from derive.report.page.commands import COMMANDS
from derive.report.page.elements import element, letter, operator, row, scripted, space
from derive.report.page.tokens import ENDS, Tokens, UnsetError

DEEPEST = 60  # groups and arguments in one another
EMPTY = element("mrow")


@cache
def mathml(latex: str, block: bool = False) -> Markup:
    """A formula as MathML, or as escaped text in ``<code>`` if it cannot be set."""
    try:
        inner = Setter(latex).whole()
    except UnsetError:
        return Markup('<code class="tex">{}</code>').format(latex)
    return element("math", inner, display="block") if block else element("math", inner)


class Setter(Tokens):
    """Sets one formula."""

    def __init__(self, latex: str) -> None:
        super().__init__(latex)
        self.depth = 0
        self.style = ""  # of letters

    def whole(self) -> Markup:
        """All of it."""
        parts = self.parts()
        if self.rest or not parts:
            raise UnsetError(self.next() or "nothing")
        return row(parts)

    def parts(self, closing: str = "") -> list[Markup]:
        """Factors up to the end of a group, a cell or a bracket, or to another token that closes them."""
        found, style = list[Markup](), self.style
        while self.next() and self.next() not in ENDS and not self.at(closing):
            if self.next() == r"\rm":
                self.style = sy.STYLES[self.take()[1:]]
            else:
                found.append(self.factor())
        self.style = style
        return found

    def factor(self) -> Markup:
        """One thing with its primes, index and power."""
        token = self.next()
        base = EMPTY if token in ("_", "^") else self.base(self.take())
        limits = token[1:] in sy.LIMITS
        while self.next() == r"\limits":
            self.take()
            limits = True
        below, above = list[Markup](), list[Markup]()
        while (mark := self.next()) in ("_", "^", "'"):
            self.take()
            (below if mark == "_" else above).append(operator("′") if mark == "'" else self.argument())
        return scripted(base, row(below) if below else None, row(above) if above else None, limits)

    def argument(self) -> Markup:
        """A group in braces, or one token; of a number its first digit."""
        token = self.take()
        if token[0].isdigit() and len(token) > 1:
            self.rest.append(token[1:])
            token = token[0]
        return self.base(token)

    def base(self, token: str) -> Markup:
        """What a token begins, however deep in others."""
        self.depth += 1
        if self.depth > DEEPEST:
            raise UnsetError("too deep")
        if token == "{":
            found = row(self.parts())
            self.take("}")
        else:
            found = self.command(token[1:]) if token.startswith("\\") else self.character(token)
        self.depth -= 1
        return found

    def character(self, token: str) -> Markup:
        """A number, a letter or a sign."""
        if token[0].isdigit():
            return element("mn", token)
        if token.isalpha():
            return letter(self.word(token), self.style)
        if token in "()[]|":
            return operator(token, stretchy="false")
        if token == "~":
            return space(sy.SPACES[token])
        if token in sy.SIGNS or token in "+=,;:./!":
            return operator(sy.SIGNS.get(token, token))
        raise UnsetError(token)

    def word(self, found: str) -> str:
        """A letter; where letters are upright, all that follow it."""
        while self.style == "rm" and self.rest and self.rest[-1].isalpha():
            found += self.rest.pop()
        return found

    def command(self, name: str) -> Markup:
        """What a command says."""
        for names, way in COMMANDS:
            if name in names:
                return way(self, name)
        raise UnsetError(f"\\{name}")
