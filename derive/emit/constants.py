"""Exact numbers in scene files: integers, decimals, fractions, π, and sums and products of these.

Grammar: sum = product {("+" | "-") product}; product = factor {("*" | "/") factor};
factor = ["+" | "-"] (number | "pi" | "(" sum ")"). Nothing is evaluated as Python.
"""

from __future__ import annotations

import re

from sympy import Expr, Integer, Rational, pi

_TOKEN = re.compile(
    r"\s*(?:(?P<number>\d+(?:\.\d*)?(?:[eE][+-]?\d+)?|\.\d+(?:[eE][+-]?\d+)?)|(?P<name>\w+|π)|(?P<op>.))"
)
_LONGEST = 200  # characters; a folded constant is a short thing
_LARGEST_EXPONENT = 400  # beyond it no double holds the number, and exact powers of ten become slow


def parse_constant(text: str | int) -> Expr:
    """The exact number that ``text`` writes; ValueError says what is wrong and at which character."""
    if isinstance(text, bool) or not isinstance(text, (str, int)):
        raise ValueError(f'{text!r} is not exact; write an integer, or the number as a string such as "3*pi/4"')
    if isinstance(text, int):
        return Integer(text)
    if len(text) > _LONGEST:
        raise ValueError(f"longer than {_LONGEST} characters")
    return _Parser(text).whole()


class _Parser:
    """Recursive descent over the tokens of one constant."""

    def __init__(self, text: str) -> None:
        self.text = text
        found = ((match, str(match.lastgroup)) for match in _TOKEN.finditer(text.rstrip()))
        self.tokens = [(kind, match[kind], match.start(kind)) for match, kind in found]
        self.at = 0

    def whole(self) -> Expr:
        value = self.sum()
        if self.at < len(self.tokens):
            raise self.error()
        return value

    def error(self) -> ValueError:
        if self.at >= len(self.tokens):
            return ValueError(f"'{self.text}' ends too early; a number, pi or '(' is missing")
        _, token, place = self.tokens[self.at]
        return ValueError(
            f"'{token}' at character {place + 1} of '{self.text}'; "
            "possible: integers, decimals, pi, + - * / and parentheses"
        )

    def take(self, *wanted: str) -> str | None:
        """The next token if it is one of those wanted."""
        if self.at < len(self.tokens) and self.tokens[self.at][1] in wanted:
            self.at += 1
            return self.tokens[self.at - 1][1]
        return None

    def sum(self) -> Expr:
        value = self.product()
        while sign := self.take("+", "-"):
            term = self.product()
            value = value + term if sign == "+" else value - term
        return value

    def product(self) -> Expr:
        value = self.factor()
        while sign := self.take("*", "/"):
            term = self.factor()
            if sign == "/" and term == 0:
                raise ValueError(f"'{self.text}' divides by zero")
            value = value * term if sign == "*" else value / term
        return value

    def factor(self) -> Expr:
        if sign := self.take("+", "-"):
            return self.factor() if sign == "+" else -self.factor()
        if self.take("("):
            value = self.sum()
            if not self.take(")"):
                raise self.error()
            return value
        if self.take("pi", "π"):
            return pi
        if self.at < len(self.tokens) and self.tokens[self.at][0] == "number":
            return self.number()
        raise self.error()

    def number(self) -> Expr:
        token = self.tokens[self.at][1]
        exponent = re.search(r"[eE]([+-]?\d+)$", token)
        if exponent and abs(int(exponent[1])) > _LARGEST_EXPONENT:
            raise ValueError(f"the exponent of '{token}' lies beyond ±{_LARGEST_EXPONENT}")
        self.at += 1
        return Rational(token)
