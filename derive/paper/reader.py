"""The reader: LaTeX of a display, in the conventions of its section → typed statements."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from lark import Token

from . import tree as t
from .brackets import CLOSES, OPENS
from .conventions import LETTERS
from .conventions import scope as conventions_of
from .errors import ReadError
from .resolve import Resolver
from .syntax import syntax_tree
from .tokens import PUNCTUATION, Tokeniser
from .tree import Statement

__all__ = ["ReadError", "parse"]


def parse(latex: str, scope: str, start: tuple[int, int] = (1, 1)) -> list[Statement]:
    """The statements of a display, in order.

    latex: what stands between its ``\\begin`` and ``\\end``. scope: a section of ``conventions.toml``. start: line and
    column of the first character in the whole source. What is said of the letters of a statement after it, i = 1, 2, 3
    or s ∈ (0, ℓ), is in its ``where``. ReadError for anything undeclared, ambiguous, ill-typed or left over, with its
    place; ValueError for a scope that does not exist.
    """
    source = Tokeniser(latex, start)
    resolver = Resolver(conventions_of(scope), source.error)
    tokens = source.run()
    if not tokens:
        raise source.error(0, "there is no formula here")
    statements: list[Statement] = []
    parts = list(_parts(tokens, source))
    while parts:
        part = parts.pop(0)
        said = _index_range(part, parts, statements, source)
        if said is None:
            statement = resolver.statement(syntax_tree(part, source.error))
            if not _is_qualifier(statement, statements, resolver):
                statements.append(statement)
                continue
            said = statement
        statements[-1] = replace(statements[-1], where=(*statements[-1].where, said))
    return statements


def _parts(tokens: list[Token], source: Tokeniser) -> Iterator[list[Token]]:
    """Statements: what stands between punctuation outside all brackets; one mark may end the display."""
    depth, part = 0, list[Token]()
    for token in tokens:
        depth += (token.type in OPENS) - (token.type in CLOSES)
        if depth == 0 and token.type in PUNCTUATION:
            if not part:
                raise source.error(token.start_pos or 0, f"'{token}' follows no statement")
            yield part
            part = []
        else:
            part.append(token)
    if part:
        yield part


def _index_range(
    part: list[Token], rest: list[list[Token]], before: list[Statement], source: Tokeniser
) -> Statement | None:
    """``i = 1, 2, 3`` after a statement where i is free; the parts after it that belong to it are taken from rest."""
    if len(part) != 3 or not before or part[0] not in LETTERS or part[1] != "=" or part[2].type != "NUMBER":
        return None
    letter = LETTERS[part[0]]
    if not any(letter in side.free_indices() for side in before[-1].sides):
        return None
    numbers = [part[2]]
    while rest and len(rest[0]) == 1 and rest[0][0].type == "NUMBER":
        numbers += rest.pop(0)
    if [int(number) for number in numbers] != list(t.values_of(letter)):
        said = ", ".join(map(str, t.values_of(letter)))
        raise source.error(part[2].start_pos or 0, f"the index {part[0]} takes the values {said}")
    values = tuple(t.Number(int(number), span=_span(number, number)) for number in numbers)
    name = t.Name(letter, t.INDEX, span=_span(part[0], part[0]))
    listing = t.Listing(values, span=_span(numbers[0], numbers[-1]))
    return Statement((name, listing), ("in",), span=_span(part[0], numbers[-1]))


def _is_qualifier(said: Statement, before: list[Statement], resolver: Resolver) -> bool:
    """Is this membership said of an arc length in the statement before it, as in s ∈ (0, ℓ)?"""
    first = said.sides[0]
    if said.operators != ("in",) or not isinstance(first, t.Name) or not before:
        return False
    written = (node for side in before[-1].sides for node in side.walk())
    return resolver.scope.declared(first.name, first.index).sort == "arc" and first in written


def _span(first: Token, last: Token) -> t.Span:
    return first.start_pos or 0, last.end_pos or 0
