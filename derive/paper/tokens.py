"""LaTeX formulas as tokens that keep their offsets.

Every character of the input belongs to a token or to declared trivia (spaces, comments, ``\\label``, ``\\nonumber``);
anything else is a ReadError. Brackets are paired here, so that their errors name both places and nesting is bounded.
"""

from __future__ import annotations

import re

from lark import Token

from .errors import ReadError, error_at

MAX_CHARACTERS = 20_000  # of one display: the article's longest has 900
MAX_DIGITS = 20  # of a number; the article needs 3
MAX_ACCENTS = 4  # on one letter without braces
MAX_DEPTH = 80  # of nested brackets and braces; the article needs 8

_PATTERN = re.compile(
    r"""
    (?P<TRIVIA>\s+ | ~ | %[^\n]* | \\[,;:!> ] | \\(?:quad|qquad|nonumber|notag)(?![A-Za-z]) | \\label\s*\{[^{}]*\})
  | (?P<ENV>\\(?:begin|end)\s*\{(?:split|aligned)\})
  | (?P<ALIGN>& | \\\\)
  | (?P<OPEN>(?:\\(?:left|[bB]igg?l?)(?![A-Za-z])\s*)?(?:\(|\[))
  | (?P<CLOSE>(?:\\(?:right|[bB]igg?r?)(?![A-Za-z])\s*)?(?:\)|\]))
  | (?P<COMMAND>\\[A-Za-z]+)
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
    r"\frac": "FRAC", r"\sqrt": "SQRT", r"\cdot": "CDOT", r"\times": "CROSS", r"\pm": "SIGN", r"\mp": "SIGN",
    r"\prime": "PRIME", r"\to": "RELATION", r"\le": "RELATION", r"\leq": "RELATION", r"\ge": "RELATION",
    r"\geq": "RELATION", r"\ne": "RELATION", r"\neq": "RELATION",
}  # fmt: skip
ACCENTS = ("hat", "overline", "bar", "tilde", "boldsymbol", "mathrm", "mathsf", "mathbbm", "mathscr", "mathcal")
_COMMANDS |= {"\\" + name: "ACCENT" for name in ACCENTS}
_BRACKETS = {"(": "LPAR", ")": "RPAR", "[": "LBRACKET", "]": "RBRACKET"}
_CLOSES = {"RPAR": "LPAR", "RBRACKET": "LBRACKET", "RBRACE": "LBRACE"}
_NEEDS_BRACES = ("SUB", "SUP", "FRAC", "SQRT")
PUNCTUATION = ("COMMA", "SEMICOLON", "DOT")


class Tokeniser:
    """Tokens of one formula. start: line and column of its first character in the whole source."""

    def __init__(self, text: str, start: tuple[int, int] = (1, 1)) -> None:
        self.text, self.start = text, start
        self.tokens: list[Token] = []
        self._open: list[Token] = []
        self._aligned = 0

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
            self._take(match)
            offset = match.end()
        if self._open:
            raise self.error(self._open[-1].start_pos or 0, f"'{self._open[-1]}' is never closed")
        if self._aligned:
            raise self.error(len(self.text), "an alignment is never ended")
        return self.tokens

    def _take(self, match: re.Match[str]) -> None:
        kind, text, offset = str(match.lastgroup), match.group(), match.start()
        if kind == "TRIVIA":
            return
        if kind == "ENV":
            self._aligned += 1 if text.startswith(r"\begin") else -1
            if self._aligned < 0:
                raise self.error(offset, f"'{text}' ends nothing")
            return
        if kind == "ALIGN":
            if self._aligned < 1 or self._open:
                raise self.error(offset, f"'{text}' outside an alignment; matrices and cases are not read")
            return
        self._add(_kind(kind, text), text, offset)

    def _add(self, kind: str, text: str, offset: int) -> None:
        """One token, if it may stand after those before it."""
        if kind == "NUMBER" and len(text) > 1 and self.tokens and self.tokens[-1].type in _NEEDS_BRACES:
            raise self.error(offset, f"TeX takes only the first digit of '{text}' here; write {{{text}}}")
        before = self.tokens[-MAX_ACCENTS:]
        if kind == "ACCENT" and len(before) == MAX_ACCENTS and all(token.type == kind for token in before):
            raise self.error(offset, f"more than {MAX_ACCENTS} accents on one letter")
        if kind == "NUMBER" and len(text) > MAX_DIGITS:
            raise self.error(offset, f"a number of {len(text)} digits; the limit is {MAX_DIGITS}")
        token = Token(kind, text, start_pos=offset, end_pos=offset + len(text))
        self._pair(token)
        self.tokens.append(token)

    def _pair(self, token: Token) -> None:
        """Match brackets; a ``\\left`` needs its ``\\right``."""
        offset = token.start_pos or 0
        if token.type in _CLOSES.values():
            self._open.append(token)
            if len(self._open) > MAX_DEPTH:
                raise self.error(offset, f"brackets nest deeper than {MAX_DEPTH}; write the formula in parts")
        elif token.type in _CLOSES:
            if not self._open or self._open[-1].type != _CLOSES[token.type]:
                expected = f"; '{self._open[-1]}' is open" if self._open else ""
                raise self.error(offset, f"'{token}' closes nothing{expected}")
            opened = self._open.pop()
            if opened.startswith(r"\left") != token.startswith(r"\right"):
                raise self.error(offset, f"'{opened}' and '{token}' do not belong together")


def _kind(found: str, text: str) -> str:
    """The grammar's name for a token of the pattern's."""
    if found == "COMMAND":
        return _COMMANDS.get(text, found)
    if found == "MARK":
        return _MARKS[text]
    return _BRACKETS[text[-1]] if found in ("OPEN", "CLOSE") else found


def tokenise(text: str, start: tuple[int, int] = (1, 1)) -> list[Token]:
    """The tokens of a formula; see Tokeniser."""
    return Tokeniser(text, start).run()
