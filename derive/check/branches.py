"""A printed statement as plain ones: its rows, cases and lists one by one, and each value of its free indices.

Rows that stand one above the other take the upper and the lower signs of ± and ∓; a case brings its condition as a
hypothesis; what is said of a list is said of each of its items.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from itertools import product

from derive.paper import tree as t
from derive.paper.symbolic import Indices

# The sign that each row of a stack takes.
SIGNS = ({r"\pm": "+", r"\mp": "-"}, {r"\pm": "-", r"\mp": "+"})


@dataclass(frozen=True)
class Branch:
    """One plain statement. title: which it is, empty if there is only one. given: what its case assumes."""

    title: str
    statement: t.Statement
    given: tuple[t.Statement, ...] = ()


def branches(statement: t.Statement) -> list[Branch]:
    """The plain statements of a printed one; ValueError if the numbers of rows or items do not fit."""
    found = [Branch("", statement)]
    for kind, split in ((t.Stack, _row), (t.Cases, _case), (t.Listing, _item)):
        count = _count(statement, kind)
        if count:
            found = [split(branch, n) for branch in found for n in range(count)]
    return found


def _count(statement: t.Statement, kind: type[t.Node]) -> int:
    """How many rows, cases or items there are; 0 if there is nothing of the kind."""
    counts = {len(node.parts()) for node in _nodes(statement) if isinstance(node, kind)}
    if kind is t.Cases:
        counts = {len(node.values) for node in _nodes(statement) if isinstance(node, t.Cases)}
    if len(counts) > 1:
        raise ValueError(f"lists of different lengths ({', '.join(map(str, sorted(counts)))}) are compared")
    if kind is t.Stack and counts and counts != {len(SIGNS)}:
        raise ValueError("a stack has two rows, one for each sign")
    return counts.pop() if counts else 0


def _nodes(statement: t.Statement) -> Iterator[t.Node]:
    for side in statement.sides:
        yield from side.walk()


def _row(branch: Branch, n: int) -> Branch:
    def put(node: t.Node) -> t.Node:
        if isinstance(node, t.Stack):
            return node.rows[n]
        if isinstance(node, t.Signed) and node.sign in SIGNS[n]:
            return replace(node, sign=SIGNS[n][node.sign])
        return node

    return replace(branch, title=_titled(branch, f"row {n + 1}"), statement=mapped(branch.statement, put))


def _case(branch: Branch, n: int) -> Branch:
    conditions: list[t.Statement] = []

    def put(node: t.Node) -> t.Node:
        if isinstance(node, t.Cases):
            condition = node.conditions[n]
            conditions.append(t.Statement(condition.sides, condition.operators, span=condition.span))
            return node.values[n]
        return node

    statement = mapped(branch.statement, put)
    return Branch(_titled(branch, f"case {n + 1}"), statement, (*branch.given, *conditions))


def _item(branch: Branch, n: int) -> Branch:
    def put(node: t.Node) -> t.Node:
        return node.items[n] if isinstance(node, t.Listing) else node

    return replace(branch, title=_titled(branch, f"item {n + 1}"), statement=mapped(branch.statement, put))


def _titled(branch: Branch, title: str) -> str:
    return f"{branch.title}, {title}" if branch.title else title


def mapped(statement: t.Statement, change: Callable[[t.Node], t.Node]) -> t.Statement:
    """The statement with every node changed, from below."""

    def of(node: t.Node) -> t.Node:
        return change(node.with_parts(tuple(of(part) for part in node.parts())))

    return replace(statement, sides=tuple(of(side) for side in statement.sides))


def index_values(statement: t.Statement) -> Iterator[Indices]:
    """Every choice of values for the free indices of a statement: all of their range, or those it names."""
    letters = sorted(set().union(*(side.free_indices() for side in statement.sides)))
    named = {
        said.sides[0].name: [part.value for part in said.sides[1].parts() if isinstance(part, t.Number)]
        for said in statement.where
        if isinstance(said.sides[0], t.Name) and isinstance(said.sides[1], t.Listing)
    }
    for values in product(*(named.get(letter, t.values_of(letter)) for letter in letters)):
        yield dict(zip(letters, values, strict=True))
