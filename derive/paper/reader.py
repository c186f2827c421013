"""The reader: LaTeX of a display, in the conventions of its section → typed statements."""

from __future__ import annotations

from collections.abc import Iterator

from lark import Token

from .conventions import scope as conventions_of
from .errors import ReadError
from .resolve import Resolver
from .syntax import syntax_tree
from .tokens import PUNCTUATION, Tokeniser
from .tree import Statement

__all__ = ["ReadError", "parse"]

_OPENING, _CLOSING = ("LPAR", "LBRACKET", "LBRACE"), ("RPAR", "RBRACKET", "RBRACE")


def parse(latex: str, scope: str, start: tuple[int, int] = (1, 1)) -> list[Statement]:
    """The statements of a display, in order.

    scope: a section of ``conventions.toml``. start: line and column of the first character in the whole source.
    ReadError for anything undeclared, ambiguous, ill-typed or left over, with its place; ValueError for a scope
    that does not exist.
    """
    source = Tokeniser(latex, start)
    resolver = Resolver(conventions_of(scope), source.error)
    tokens = source.run()
    if not tokens:
        raise source.error(0, "there is no formula here")
    return [resolver.statement(syntax_tree(part, source.error)) for part in _parts(tokens, source)]


def _parts(tokens: list[Token], source: Tokeniser) -> Iterator[list[Token]]:
    """Statements: what stands between punctuation outside all brackets; one mark may end the display."""
    depth, part = 0, list[Token]()
    for token in tokens:
        depth += (token.type in _OPENING) - (token.type in _CLOSING)
        if depth == 0 and token.type in PUNCTUATION:
            if not part:
                raise source.error(token.start_pos or 0, f"'{token}' follows no statement")
            yield part
            part = []
        else:
            part.append(token)
    if part:
        yield part
