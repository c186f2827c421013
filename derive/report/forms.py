"""The derived statement for a printed one in one reading: which side is valued, and by what."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import Any

from sympy import MatrixBase

from derive.check.meaning import Components
from derive.paper import tree as t
from derive.paper.conventions import scope as conventions_of
from derive.paper.symbolic import Indices, to_sympy
from derive.report.letters import names, worth_a_letter
from derive.report.vectors import instance, spelled_vector
from derive.report.writer import Writer


class SilentError(ValueError):
    """The values say no more than what is printed."""


def form_in(
    reading: Components, scope: str, statement: t.Statement, given: tuple[t.Statement, ...], indices: Indices
) -> tuple[t.Statement, bool]:
    """``side operator value``: the first side, unless its value says nothing of the others.

    Then the constant of integration that the statement names, by its value. Of an inequality, the second side is
    valued. SilentError if there is nothing to say.

    The second answer: is the value that of a printed side other than the first?
    """
    operator = statement.operators[0]
    valued = Valued(reading, scope, statement, given, indices)
    if operator not in ("=", "->"):
        return t.Statement((valued.instance(statement.sides[0]), valued.of(statement.sides[1])), (operator,)), True
    first, other = valued.instance(statement.sides[0]), names(*statement.sides[1:])
    for number, side in enumerate(linked(statement)):
        value = valued.of(side)
        if not same(value, first, scope) and (len(names(value)) != 1 or names(value) & other):
            return t.Statement((first, value), (operator,)), number > 0
    for name in valued.compound(other):
        named = replace(statement, sides=(name, *statement.sides))
        return t.Statement((name, Valued(reading, scope, named, given, indices).of(name)), (operator,)), False
    raise SilentError("an identity of its letters: the difference of its sides reduces to zero")


def linked(statement: t.Statement) -> Iterator[t.Node]:
    """The first side, and those that are said to equal it (or to be what it tends to)."""
    yield statement.sides[0]
    for side, operator in zip(statement.sides[1:], statement.operators, strict=True):
        if operator not in ("=", "->"):
            return
        yield side


def same(one: t.Node, other: t.Node, scope: str) -> bool:
    """Are they the same formula, but for the order of terms and factors?"""
    return one == other or bool(to_sympy(one, scope) == to_sympy(other, scope))


class Valued:
    """The values of the parts of a statement, written as trees."""

    def __init__(
        self,
        reading: Components,
        scope: str,
        statement: t.Statement,
        given: tuple[t.Statement, ...],
        indices: Indices,
    ) -> None:
        self.reading, self.scope, self.given, self.indices = reading, conventions_of(scope), given, indices
        self.operator = statement.operators[0]
        self.writer = Writer(reading, self.scope, statement, indices)

    def instance(self, side: t.Node) -> t.Node:
        """The side for the values of the indices."""
        return instance(side, self.indices)

    def of(self, side: t.Node) -> t.Node:
        """The value of a side; of an arrow, at the limit that the text assumes."""
        value = self.reading.of(side, self.indices)
        if self.operator == "->":
            value = value.subs(*self.limit())
        if isinstance(value, MatrixBase):
            return spelled_vector(value, self.reading, self.scope, self.writer.of)
        ordering = side.args[0] if isinstance(side, t.Call) else None
        return self.writer.of(value, ordering)

    def limit(self) -> tuple[Any, Any]:
        """Variable and point of the one arrow among the hypotheses."""
        (arrow,) = (statement for statement in self.given if statement.operators == ("->",))
        variable, point = (self.reading.of(side) for side in arrow.sides)
        return variable, point

    def compound(self, among: set[str]) -> Iterator[t.Name]:
        """The names of scalars whose value in the reading is no letter."""
        for name in sorted(among):
            declared = self.scope.by_name.get(name)
            constant = declared is not None and declared.kind == t.SCALAR and not declared.argument
            if constant and worth_a_letter(self.reading.of(t.Name(name))):
                yield t.Name(name)
