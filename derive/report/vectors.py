"""Vectors and tensors given in components, written as sums over the base vectors that a section has letters for."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace
from itertools import product
from typing import Any

from sympy import Matrix, MatrixBase, eye

from derive.check.meaning import Components
from derive.paper import tree as t
from derive.paper.conventions import Scope
from derive.paper.symbolic import Indices, member
from derive.report.tidy import SpellError

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
    written = {place: write(value[place]) for place in product(range(value.rows), range(value.cols))}
    given = {place: scalar for place, scalar in written.items() if scalar != t.Number(0)}
    if not given:
        return t.Name("zero", t.VECTOR) if value.cols == 1 and "zero" in scope.by_name else t.Number(0)
    base = base_vectors(reading, scope)
    terms = []
    for (row, column), scalar in given.items():
        terms.append(component(scalar, t.Outer(base[row], base[column]) if value.cols > 1 else base[row]))
    return terms[0] if len(terms) == 1 else t.Sum(tuple(terms))


def component(scalar: t.Node, vector: t.Node) -> t.Node:
    """One component times its base vector, or times the product of two; its sign before it."""
    match scalar:
        case t.Signed(sign="-"):
            return t.Signed("-", component(scalar.of, vector))
        case t.Number(value=1):
            return vector
        case t.Product():
            return t.Product((*scalar.factors, vector))
    return t.Product((scalar, vector))


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
