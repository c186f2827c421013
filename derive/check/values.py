"""Numeric values of printed trees at a point of a reading, kept by subtree.

Where a meaning is in components, the value of a sum, a product or another operation is got from the values of its
parts in plain arithmetic; only what is below (a symbol, a derivative, an integral) goes through SymPy. Of a statement
with one small change, all but the way from the change to the root is then known already.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from functools import lru_cache
from operator import mul
from typing import Any

from mpmath import mp
from sympy import MatrixBase, nan, oo, sympify, zoo

from derive.check.components import Value, cross, dot, each, flat, norm, outer, summed
from derive.check.evaluate import GUARD, UndefinedError, evaluate
from derive.check.leibniz import expanded
from derive.check.meaning import Components, MeaningError, pm
from derive.check.sample import ExactPoint, Sampler
from derive.paper import tree as t

Indices = tuple[tuple[str, int], ...]
OPERATIONS = {
    t.Dot: "dot", t.Cross: "cross", t.Outer: "outer", t.Apply: "apply", t.Compose: "apply", t.Transpose: "transpose",
    t.Norm: "norm", t.Signed: "sign",
}  # fmt: skip


@lru_cache(maxsize=100_000)
def _letters(node: t.Node) -> frozenset[str]:
    return frozenset(node.free_indices())


@dataclass
class Place:
    """A point in the domain of a reading. symbolic: what SymPy gives of the smallest trees, for all its points."""

    reading: Components
    sampler: Sampler
    point: ExactPoint
    symbolic: dict[Any, Any]
    made: dict[Any, Values] = field(default_factory=dict)

    def values(self, digits: int, sign: int = 1, small: Any = None) -> Values:
        """The values there, for one of the signs ±, and for a small parameter if one is given."""
        if (digits, sign, small) not in self.made:
            special: ExactPoint = {pm: sympify(sign, strict=True)}
            if small is not None and self.reading.small is not None:
                special[self.reading.small] = small
            self.made[digits, sign, small] = Values(self, digits, special)
        return self.made[digits, sign, small]

    def whole(self, node: t.Node, indices: Indices) -> Any:
        """The SymPy value of a side."""
        key = ("whole", node, indices)
        if key not in self.symbolic:
            self.symbolic[key] = sympify(self.reading.of(node, dict(indices)), strict=True)
        return self.symbolic[key]

    def rate(self, node: t.Node, indices: Indices) -> Any:
        """Its derivative along the rod."""
        key = ("rate", node, indices)
        if key not in self.symbolic:
            self.symbolic[key] = sympify(self.reading.rate(self.whole(node, indices), 1), strict=True)
        return self.symbolic[key]

    def grows(self, sides: tuple[t.Node, ...], indices: Indices) -> bool:
        """Does a side hold what accumulates along the rod?"""
        if type(self.reading).accumulates is Components.accumulates:
            return False
        return self.reading.accumulates(*(self.whole(side, indices) for side in sides))


class Values:
    """The values of trees in a reading at one point of it, which grows by the unknowns that are met.

    special: what has another value than at the point: ±, a small parameter.
    """

    def __init__(self, place: Place, digits: int, special: ExactPoint) -> None:
        self.place, self.digits, self.special = place, digits, special
        self.reading = place.reading
        self.known: dict[Any, Value] = {}
        self.evaluated: dict[Any, Any] = {}  # of SymPy's expressions
        own = type(self.reading)
        self.plain = {kind for kind, name in OPERATIONS.items() if getattr(own, name) is getattr(Components, name)}

    def of(self, node: t.Node, indices: Indices = ()) -> Value:
        """The value; MeaningError or UndefinedError where there is none."""
        with mp.workdps(self.digits + GUARD):
            return self.part(node, indices)

    def part(self, node: t.Node, indices: Indices) -> Value:
        """The same, at the precision that is set."""
        if indices:
            free = _letters(node)
            indices = tuple(pair for pair in indices if pair[0] in free)
        key = (node, indices)
        if key not in self.known:
            self.known[key] = self._computed(node, indices)
        return self.known[key]

    def size(self, node: t.Node, indices: Indices = ()) -> Any:
        """The scale of the rounding errors of a value: the largest part of a term of it."""
        terms = node.terms if isinstance(node, t.Sum) else (node,)
        with mp.workdps(self.digits + GUARD):
            return max(abs(x) for term in terms for x in flat(self.part(term, indices)))

    def _computed(self, node: t.Node, indices: Indices) -> Value:
        longer = expanded(node)
        if longer is not None:
            return self.part(longer, indices)
        spread = self.reading.spread(node)
        if spread is not None:
            factor, of = self._numbers(spread[0])[0], self.part(spread[1], indices)
            return each(lambda x: factor * x, of)
        rule = _RULES.get(type(node))
        if rule is None or (type(node) in OPERATIONS and type(node) not in self.plain):
            return self._leaf(node, indices)
        if isinstance(node, t.Power) and node.base.type == t.TENSOR:
            return self._leaf(node, indices)
        try:
            return rule(self, node, indices)
        except (ZeroDivisionError, OverflowError, ValueError) as error:
            if isinstance(error, MeaningError):
                raise
            raise UndefinedError(str(error)) from error

    def _leaf(self, node: t.Node, indices: Indices) -> Value:
        key, symbolic = (node, indices), self.place.symbolic
        if key not in symbolic:
            symbolic[key] = self.reading.of(node, dict(indices))
        value = symbolic[key]
        numbers = self._numbers(value)
        if not isinstance(value, MatrixBase):
            return numbers[0]
        width = value.shape[1]
        rows = [tuple(numbers[n : n + width]) for n in range(0, len(numbers), width)]
        return tuple(numbers) if width == 1 else tuple(rows)

    def _numbers(self, value: Any) -> list[Any]:
        """The components of a value of SymPy's."""
        value = sympify(value, strict=True)
        if value.has(oo, -oo, zoo, nan):
            raise UndefinedError("a part is infinite or undefined")
        entries = list(value) if isinstance(value, MatrixBase) else [value]
        self.place.sampler.extend(self.place.point, entries)
        here = {**self.place.point, **self.special}
        return [evaluate(entry, here, self.digits, self.evaluated) for entry in entries]

    def parts(self, node: t.Node, indices: Indices) -> list[Value]:
        """The values of the parts of a node."""
        return [self.part(part, indices) for part in node.parts()]


def _number(values: Values, node: t.Number, indices: Indices) -> Value:
    return mp.mpf(node.value)


def _signed(values: Values, node: t.Signed, indices: Indices) -> Value:
    of = values.part(node.of, indices)
    if node.sign in "+-":
        return of if node.sign == "+" else each(lambda x: -x, of)
    sign = values.special[pm] * (1 if node.sign == r"\pm" else -1)
    return each(lambda x: int(sign) * x, of)


def _sum(values: Values, node: t.Sum, indices: Indices) -> Value:
    terms = values.parts(node, indices)
    zeros = [term for term in terms if isinstance(term, tuple)]
    if zeros and len(zeros) < len(terms):  # 0 beside a vector
        terms = zeros
    return each(lambda *parts: summed(list(parts)), *terms)


def _product(values: Values, node: t.Product, indices: Indices) -> Value:
    found: Value = mp.mpf(1)
    for part in values.parts(node, indices):
        found = each(mul, found, part)
    return found


def _quotient(values: Values, node: t.Quotient, indices: Indices) -> Value:
    above, below = values.parts(node, indices)
    if below == 0:
        raise UndefinedError("division by zero")
    return each(lambda x: x / below, above)


def _power(values: Values, node: t.Power, indices: Indices) -> Value:
    base, exponent = values.parts(node, indices)
    if isinstance(base, tuple):
        return dot(base, base)
    if base == 0 and mp.re(exponent) <= 0:
        raise UndefinedError("a power of zero")
    return base ** int(exponent) if exponent == int(mp.re(exponent)) else mp.power(base, exponent)


def _contraction(values: Values, node: t.Contraction, indices: Indices) -> Value:
    others = [pair for pair in indices if pair[0] != node.index]
    chosen = [tuple(sorted([*others, (node.index, value)])) for value in t.values_of(node.index)]
    terms = [values.part(node.of, one) for one in chosen]
    return each(lambda *parts: summed(list(parts)), *terms)


def _binary(operation: Callable[[Value, Value], Value]) -> Callable[[Values, t.Node, Indices], Value]:
    return lambda values, node, indices: operation(*values.parts(node, indices))


_RULES: Mapping[type[t.Node], Callable[[Values, Any, Indices], Value]] = {
    t.Number: _number,
    t.Signed: _signed,
    t.Sum: _sum,
    t.Product: _product,
    t.Quotient: _quotient,
    t.Power: _power,
    t.Root: lambda values, node, indices: mp.root(values.part(node.of, indices), node.degree),
    t.Dot: _binary(dot),
    t.Cross: _binary(cross),
    t.Outer: _binary(outer),
    t.Apply: _binary(dot),
    t.Compose: _binary(dot),
    t.Transpose: lambda values, node, indices: tuple(zip(*values.part(node.of, indices), strict=True)),
    t.Norm: lambda values, node, indices: norm(values.part(node.of, indices)),
    t.Contraction: _contraction,
}
