"""Vectors and tensors given in components, written as sums over the base vectors that a section has letters for."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace
from typing import Any

from sympy import Matrix, MatrixBase, eye

from derive.check.meaning import Components
from derive.paper import tree as t
from derive.paper.conventions import Scope
from derive.paper.symbolic import Indices, member
from derive.report.tidy import SpellError, negative

Write = Callable[[Any], t.Node]  # of a scalar


def instance(node: t.Node, indices: Indices) -> t.Node:
    """The tree for given values of its free indices: d_i′ with i = 2 is d_2′."""
    parts = tuple(instance(part, indices) for part in node.parts())
    node = node.with_parts(parts)
    if isinstance(node, t.Name | t.Call) and node.index in indices:
        return replace(node, name=member(node.name, node.index, indices), index="")
    return node


def spelled_vector(value: MatrixBase, reading: Components, scope: Scope, write: Write) -> t.Node:
    """A vector or tensor in components as a sum over base vectors; SpellError if there are no letters for it."""
    if value.is_zero_matrix:
        return t.Number(0)
    base = base_vectors(reading, scope)
    terms: list[t.Node] = []
    for row in range(value.rows):
        for column in range(value.cols):
            if value[row, column] != 0:
                terms.append(component(value[row, column], base[row], base[column] if value.cols > 1 else None, write))
    return terms[0] if len(terms) == 1 else t.Sum(tuple(terms))


def component(value: Any, left: t.Node, right: t.Node | None, write: Write) -> t.Node:
    """One component times its base vector, or times the product of two."""
    if negative(value):
        return t.Signed("-", component(-value, left, right, write))
    vector = left if right is None else t.Outer(left, right)
    if value == 1:
        return vector
    scalar = write(value)
    factors = scalar.factors if isinstance(scalar, t.Product) else (scalar,)
    return t.Product((*factors, vector))


def base_vectors(reading: Components, scope: Scope) -> list[t.Node]:
    """A letter for each of the three directions of the components."""
    found = dict(unit_vectors(reading, scope))
    if len(found) < 3:
        raise SpellError(f"the section has no letters for the base vectors ({reading.title})")
    return [found[n] for n in range(3)]


def unit_vectors(reading: Components, scope: Scope) -> Iterator[tuple[int, t.Node]]:
    """Direction and letter, for the declared vectors that are base vectors; of two letters the first declared."""
    for name, declared in reversed(list(scope.by_name.items())):
        if declared.kind == t.VECTOR:
            try:
                value = reading.name(name)
            except (ValueError, KeyError, AttributeError):
                continue
            for direction in range(3):
                if isinstance(value, MatrixBase) and Matrix(value) == eye(3)[:, direction]:
                    yield direction, t.Name(name, t.VECTOR)
