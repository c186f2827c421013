"""Arithmetic of components: numbers, vectors as tuples of three, tensors as tuples of their three rows."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from mpmath import mp

from derive.check.evaluate import GUARD, LOST

Value = Any  # a number, a tuple of three numbers, or a tuple of three tuples of three


def each(function: Callable[..., Any], *values: Value) -> Value:
    """The function of the components; numbers that stand beside vectors or tensors are taken for each."""
    deep = next((value for value in values if isinstance(value, tuple)), None)
    if deep is None:
        return function(*values)
    columns = [value if isinstance(value, tuple) else (value,) * len(deep) for value in values]
    return tuple(each(function, *row) for row in zip(*columns, strict=True))


def flat(value: Value) -> list[Any]:
    """All components."""
    return [x for part in value for x in flat(part)] if isinstance(value, tuple) else [value]


def dot(one: Value, other: Value) -> Value:
    """Row by row, where the first is a tensor; column by column, where the second is."""
    if isinstance(one[0], tuple):
        return tuple(dot(row, other) for row in one)
    if isinstance(other[0], tuple):
        return tuple(dot(one, column) for column in zip(*other, strict=True))
    return summed([a * b for a, b in zip(one, other, strict=True)])


def cross(one: Value, other: Value) -> Value:
    """Vector product."""
    (a, b, c), (x, y, z) = one, other
    return summed([b * z, -c * y]), summed([c * x, -a * z]), summed([a * y, -b * x])


def summed(terms: list[Any]) -> Any:
    """The sum; zero where all but the last digits cancel."""
    total, size = mp.fsum(terms), max(map(abs, terms))
    return mp.mpf(0) if abs(total) < size * mp.mpf(10) ** (LOST + GUARD - mp.dps) else total


def norm(value: Value) -> Any:
    """Length, or absolute value."""
    return mp.sqrt(dot(value, value)) if isinstance(value, tuple) else abs(value)


def outer(one: Value, other: Value) -> Value:
    """Tensor product."""
    return tuple(tuple(a * b for b in other) for a in one)
