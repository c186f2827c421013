"""LaTeX formulas as tokens that keep their offsets.

Every character of the input belongs to a token or to declared trivia (spaces, comments, ``\\label``, ``\\nonumber``,
a relation that is repeated where a line is broken); anything else is a ReadError. Brackets are paired in ``brackets``.
"""

from __future__ import annotations

import re

from lark import Token

from .brackets import CLOSES, OPENS, Brackets
from .errors import ReadError, error_at

MAX_CHARACTERS = 20_000  # of one display: the article's longest has 1200
MAX_DIGITS = 20  # of a number; the article needs 3
MAX_PREFIXES = 40  # integral signs, limits and variations in one display; the article needs 7
MAX_ACCENTS = 4  # on one letter without braces

_PATTERN = re.compile(
    r"""
    (?P<TRIVIA>\s+ | ~ | %[^\n]* | \\[,;:!> ] | \\(?:quad|qquad|nonumber|notag|limits)(?![A-Za-z])
      | \\label\s*\{[^{}]*\})
  | (?P<ENV>\\(?:begin|end)\s*\{(?:split|aligned|matrix)\})
  | (?P<ALIGN>& | \\\\)
  | (?P<IF>\\(?:mathrm|text|textrm)\s*\{\s*if\s*\})
  | (?P<OPEN>(?:\\(?:left|[bB]igg?l?)(?![A-Za-z])\s*)?(?:\(|\[|\\\{) | \\left\s*\.)
  | (?P<CLOSE>(?:\\(?:right|[bB]igg?r?)(?![A-Za-z])\s*)?(?:\)|\]|\\\}) | \\right\s*\.)
  | (?P<BAR>(?:\\(?:left|right|[bB]igg?[lr]?)(?![A-Za-z])\s*)?\|)
  | (?P<COMMAND>\\[A-Za-z]+ | \\\|)
  | (?P<NUMBER>[0-9]+)
  | (?P<LETTER>[A-Za-z])
  | (?P<MARK>[{}_^'+\-=<>/,;.])
    """,
    re.VERBOSE,
)

_MARKS = {
    "{": "LBRACE", "}": "RBRACE", "_": "SUB", "^": "SUP", "'": "TICK", "+": "SIGN", "-": "SIGN", "=": "RELATION",
    "<": "RELATION", ">": "RELATION", "/": "SLASH", ",": "COMMA", ";": "SEMICOLON", ".": "DOT",
}  # fmt: skip
_COMMANDS = {
    r"\frac": "FRAC", r"\sqrt": "SQRT", r"\cdot": "CDOT", r"\times": "CROSS", r"\otimes": "OUTER", r"\pm": "SIGN",
    r"\mp": "SIGN", r"\prime": "PRIME", r"\to": "RELATION", r"\le": "RELATION", r"\leq": "RELATION",
    r"\ge": "RELATION", r"\geq": "RELATION", r"\ne": "RELATION", r"\neq": "RELATION", r"\in": "RELATION",
    r"\notin": "RELATION", r"\int": "INT", r"\lim": "LIM", r"\max": "MAX", r"\delta": "VARIED", r"\partial": "PARTIAL",
}  # fmt: skip
ACCENTS = (
    "hat", "overline", "bar", "tilde", "boldsymbol", "mathrm", "mathsf", "mathbbm", "mathscr", "mathcal", "mathfrak",
)  # fmt: skip
_COMMANDS |= {"\\" + name: "ACCENT" for name in ACCENTS}
_BRACKETS = {"(": "LPAR", ")": "RPAR", "[": "LBRACKET", "]": "RBRACKET", "{": "LSET", "}": "RSET"}
_NEEDS_BRACES = ("SUB", "SUP", "FRAC", "SQRT")
PUNCTUATION = ("COMMA", "SEMICOLON", "DOT")


class Tokeniser:
    """Tokens of one formula. start: line and column of its first character in the whole source."""

    def __init__(self, text: str, start: tuple[int, int] = (1, 1)) -> None:
        self.text, self.start = text, start
        self.tokens: list[Token] = []
        self._brackets = Brackets(self.error)
        self._prefixes = 0
        self._broken = -1  # how many tokens stand before the last line break

    def error(self, offset: int, message: str) -> ReadError:
        """A ReadError at an offset of this formula."""
        return error_at(self.text, offset, message, self.start)

    def run(self) -> list[Token]:
        """All tokens in order; trivia is left out. Errors: size, foreign characters, unpaired brackets."""
        if len(self.text) > MAX_CHARACTERS:
            raise self.error(0, f"a formula of {len(self.text)} characters; the limit is {MAX_CHARACTERS}: split it")
        offset = 0
        while offset < len(self.text):
            match = _PATTERN.match(self.text, offset)
            if match is None:
                raise self.error(offset, f"unexpected character {self.text[offset]!r}; remove it or write it in LaTeX")
            self._take(str(match.lastgroup), match.group(), offset)
            offset = match.end()
        self._brackets.end(len(self.text))
        return self.tokens

    def _take(self, found: str, text: str, offset: int) -> None:
        before = self.tokens[-1] if self.tokens else None
        kind = found
        if found == "TRIVIA":
            return
        if found == "ALIGN":
            kind = self._brackets.align(text, offset)
            self._broken = len(self.tokens) if text != "&" else self._broken
        elif found == "ENV":
            kind = self._brackets.environment(text)
        elif found == "BAR":
            evaluates = re.compile(r"\s*_").match(self.text, offset + len(text)) is not None
            kind = self._brackets.bar(text, before, evaluates)
        elif found in ("OPEN", "CLOSE"):
            kind = self._brackets.square(text, before) or _bracket(found, text)
        elif found == "COMMAND":
            kind = _COMMANDS.get(text, found)
        elif found == "MARK":
            kind = _MARKS[text]
        repeated = kind == "RELATION" and before == text and self._broken == len(self.tokens)
        if kind and not repeated:
            self._add(Token(kind, text, start_pos=offset, end_pos=offset + len(text)))

    def _add(self, token: Token) -> None:
        """One token, if it may stand after those before it."""
        kind, text, offset = token.type, str(token), token.start_pos or 0
        if text == r"\rm" and self.tokens and self.tokens[-1].type == "LBRACE":  # {\rm u} is \mathrm{u}
            self.tokens.insert(-1, token.update(type="ACCENT", value=r"\mathrm"))
            return
        if kind == "NUMBER" and len(text) > 1 and self.tokens and self.tokens[-1].type in _NEEDS_BRACES:
            raise self.error(offset, f"TeX takes only the first digit of '{text}' here; write {{{text}}}")
        before = self.tokens[-MAX_ACCENTS:]
        if kind == "ACCENT" and len(before) == MAX_ACCENTS and all(token.type == kind for token in before):
            raise self.error(offset, f"more than {MAX_ACCENTS} accents on one letter")
        if kind == "NUMBER" and len(text) > MAX_DIGITS:
            raise self.error(offset, f"a number of {len(text)} digits; the limit is {MAX_DIGITS}")
        if kind in ("INT", "LIM", "VARIED"):
            self._prefixes += 1
            if self._prefixes > MAX_PREFIXES:
                raise self.error(
                    offset, f"more than {MAX_PREFIXES} integrals, limits and variations; split the formula"
                )
        self._brackets.pair(token)
        if kind not in ("SPLIT", "ENDSPLIT"):
            self.tokens.append(token)


def _bracket(found: str, text: str) -> str:
    if text[-1] == ".":
        return "LNONE" if found == "OPEN" else "RNONE"
    return _BRACKETS[text[-1]]


def tokenise(text: str, start: tuple[int, int] = (1, 1)) -> list[Token]:
    """The tokens of a formula; see Tokeniser."""
    return Tokeniser(text, start).run()


__all__ = ["ACCENTS", "CLOSES", "OPENS", "PUNCTUATION", "Tokeniser", "tokenise"]
