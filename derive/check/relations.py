"""What a printed relation between values says, as relations of the theory.

- ``A = B``: equality. If a side holds what accumulates along the rod (y, z, or an indefinite integral), the rates along
  the rod must be equal, and, unless a constant is left open, the values at the clamp.
- ``A = B + O(εⁿ)``: the difference of the two is of that order; what A itself leaves open is any quantity of its order.
- ``A < B``, ``A ≤ B`` and the like: a sign, everywhere in the domain.
- ``x ∈ [A, B]``, ``x ∉ ]A, B[``: signs; and the ends are those of the values that x can take.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from sympy import MatrixBase, zeros

from derive.check.meaning import Components, MeaningError
from derive.paper import tree as t
from derive.paper.symbolic import Indices
from derive.theory.claims import Equal, NonNegative, Order, Positive, Relation

Said = tuple[str, Relation]  # what of the printed relation it is, empty if it is all of it
SIGNS: dict[str, tuple[type[Positive] | type[NonNegative], int]] = {
    "<": (Positive, -1),
    ">": (Positive, 1),
    "<=": (NonNegative, -1),
    ">=": (NonNegative, 1),
}


def said(operator: str, left: Any, right: Any, reading: Components) -> Iterator[Said]:
    """The relations of the theory that ``left operator right`` stands for."""
    if operator == "=":
        yield from _equal(left, right, reading)
    elif operator in SIGNS:
        kind, sense = SIGNS[operator]
        yield "", kind(sense * (left - right))
    else:
        raise MeaningError(f"the relation '{operator}' is not judged yet")


def _equal(left: Any, right: Any, reading: Components) -> Iterator[Said]:
    vector = next((side for side in (left, right) if isinstance(side, MatrixBase)), None)
    if vector is not None:
        left, right = (zeros(*vector.shape) if side == 0 else side for side in (left, right))
    if vector is not None or not reading.accumulates(left, right):
        yield "", Equal(left, right)
        return
    yield "along the rod", Equal(reading.rate(left, 1), reading.rate(right, 1))
    starts = [reading.at_clamp(side) for side in (left, right)]
    if None not in starts:
        yield "at the clamp", Equal(*starts)


def membership(
    operator: str, value: Any, ends: tuple[Any, Any], node: t.Interval, reading: Components
) -> Iterator[Said]:
    """x ∈ interval or x ∉ interval. An end that x can reach must be inside, or outside; an end is one of a range."""
    (lower, upper), opens = ends, (node.left_open, node.right_open)
    if operator == "in":
        for name, gap, is_open in zip(("lower", "upper"), (value - lower, upper - value), opens, strict=True):
            yield f"{name} end", (Positive if is_open else NonNegative)(gap)
    else:
        yield "outside", NonNegative((value - lower) * (value - upper))
        for end, is_open in zip(ends, opens, strict=True):
            if not is_open:
                yield "not at an end", Positive((value - end) ** 2)
    yield "its ends in order", Positive(upper - lower)
    for name, end in zip(("lower", "upper"), ends, strict=True):
        yield f"{name} end of a range", Equal(reading.frontier(value, end), 0)


def orders_in(sides: tuple[t.Node, ...]) -> list[t.BigO]:
    """The O(εⁿ) of the right side, or else those of the left: what is O(ε²) is not O(ε³)."""
    found = ([node for node in side.walk() if isinstance(node, t.BigO)] for side in reversed(sides))
    return next((some for some in found if some), [])


def orders(sides: tuple[t.Node, ...], reading: Components, indices: Indices) -> list[int]:
    """The powers of the small parameter in the O(εⁿ) that count, and the one that the text drops."""
    found = orders_in(sides)
    if found and reading.small is None:
        raise MeaningError(f"O(…) has no meaning where the formula is read ({reading.title})")
    factors = [reading.of(node.of, indices).as_coeff_exponent(reading.small) for node in found]
    if any(coefficient.has(reading.small) or not exponent.is_Integer for coefficient, exponent in factors):
        raise MeaningError(f"an O(…) must hold a power of {reading.small}")
    dropped = [] if reading.within is None else [reading.within]
    return [int(exponent) for _, exponent in factors] + dropped


def order(left: Any, right: Any, reading: Components, power: int, side: t.Node) -> Order:
    """left − right = O(εⁿ). A quantity that is only said to be small is squared first, so that roots go."""
    assert reading.small is not None
    if isinstance(side, t.BigO) and not isinstance(left, MatrixBase):
        return Order((left**2).expand(), reading.small, 2 * power)
    return Order(left - right, reading.small, power)
