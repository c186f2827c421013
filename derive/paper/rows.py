"""One row of factors, resolved by declared types.

From the tightest: /, ×, ⊗, tensors applied or composed, ·, and scalars side by side. The left operand of an operator
is the vector just before it; the right one is the next vector with the scalars and tensors before it. What has no
reading, or two, is a ReadError.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from typing import TYPE_CHECKING, Any

from lark import Token

from . import tree as t
from .elements import Elements, read_elements

if TYPE_CHECKING:
    from .resolve import Resolver

_JOINED: dict[str, type[t.Cross | t.Outer | t.Dot]] = {"CROSS": t.Cross, "OUTER": t.Outer, "CDOT": t.Dot}
_QUANTITIES = (t.SCALAR, t.TENSOR)


def read_row(items: Sequence[Any], resolver: Resolver) -> t.Node:
    """The node of a row."""
    return _Fold(read_elements(items, resolver), resolver).read()


class _Fold:
    """A row whose operators are folded, one kind after the other."""

    def __init__(self, elements: Elements, resolver: Resolver) -> None:
        self.elements, self.resolver = elements, resolver
        self._made: list[t.Node] = []  # by the operator that is being folded, not in brackets

    def read(self) -> t.Node:
        """The row as one node."""
        self._check_operands()
        self._divide()
        self._fold("CROSS")
        self._fold("OUTER")
        self.elements = self._applied(self.elements)
        self._fold("CDOT")
        return self._product(self.elements)

    def _check_operands(self) -> None:
        for place, element in enumerate(self.elements):
            if isinstance(element, Token):
                around = self.elements[max(place - 1, 0) : place + 2]
                if len(around) < 3 or isinstance(around[0], Token) or isinstance(around[2], Token):
                    raise self.resolver.error(element.start_pos or 0, f"'{element}' needs an operand on both sides")

    def _divide(self) -> None:
        """Fold /: all that stands before it in its operand, over one factor."""
        while (place := self._find("SLASH")) is not None:
            start = max((n + 1 for n in range(place) if isinstance(self.elements[n], Token)), default=0)
            above = self.elements[start:place]
            if any(element is made for element in above for made in self._made):
                raise self.resolver.error(self.elements[place].start_pos, "two '/' in one product; write brackets")
            after = self.elements[place + 2] if place + 2 < len(self.elements) else None
            if isinstance(after, t.Node):
                message = "where does the denominator after '/' end? write brackets"
                raise self.resolver.error(after.span[0], message)
            made = self.resolver.quotient(self._product(self._applied(above)), self.elements[place + 1])
            self._put(made, start, place + 2)

    def _fold(self, kind: str) -> None:
        """Fold ×, ⊗ or ·, from the left."""
        self._made = []
        while (place := self._find(kind)) is not None:
            left, sign, first = self.elements[place - 1 : place + 2]
            if any(left is made for made in self._made):
                raise self.resolver.error(sign.start_pos, f"two '{sign}' in one product; write brackets")
            if left.type == first.type == t.REGION and kind == "CROSS":
                made: t.Node = t.RegionProduct(left, first, span=(left.span[0], first.span[1]))
                stop = place + 2
            else:
                self._check_left(place)
                right, stop = self._right(place)
                made = _JOINED[kind](left, right, span=(left.span[0], right.span[1]))
            self._put(made, place - 1, stop)

    def _put(self, made: t.Node, start: int, stop: int) -> None:
        self._made.append(made)
        self.elements[start:stop] = [made]

    def _find(self, kind: str) -> int | None:
        found = (n for n, element in enumerate(self.elements) if isinstance(element, Token) and element.type == kind)
        return next(found, None)

    def _check_left(self, place: int) -> None:
        left, sign = self.elements[place - 1 : place + 1]
        if left.type != t.VECTOR:
            raise self.resolver.error(left.span[0], f"the last factor before '{sign}' is no vector; write brackets")
        before = self.elements[place - 2] if place > 1 else None
        if isinstance(before, t.Node) and before.type == t.TENSOR and sign.type != "CDOT":
            message = f"is the tensor applied before or after '{sign}'? write brackets"
            raise self.resolver.error(before.span[0], message)

    def _right(self, place: int) -> tuple[t.Node, int]:
        """The operand on the right, and where it ends."""
        stop = place + 1
        while stop < len(self.elements) and self._is_node(stop) and self.elements[stop].type in _QUANTITIES:
            stop += 1
        if stop == len(self.elements) or not self._is_node(stop) or self.elements[stop].type != t.VECTOR:
            message = f"'{self.elements[place]}' joins vectors; write products of scalars side by side"
            raise self.resolver.error(self.elements[place + 1].span[0], message)
        return self._product(self._applied(self.elements[place + 1 : stop + 1])), stop + 1

    def _is_node(self, place: int) -> bool:
        return isinstance(self.elements[place], t.Node)

    def _applied(self, elements: Elements) -> Elements:
        """Tensors take the tensors and then the vector to the right of them."""
        made: Elements = []
        for element in elements:
            before = made[-1] if made else None
            if isinstance(element, t.Node) and isinstance(before, t.Node) and before.type == t.TENSOR:
                kind = {t.TENSOR: t.Compose, t.VECTOR: t.Apply}.get(element.type)
                if kind is not None:
                    self.resolver.count(element)
                    made[-1] = kind(before, element, span=(before.span[0], element.span[1]))
                    continue
            made.append(element)
        return made

    def _product(self, nodes: Sequence[t.Node]) -> t.Node:
        if len(nodes) == 1:
            return nodes[0]
        first, *more = [node for node in nodes if node.type != t.SCALAR] or [nodes[0]]
        if more:
            both = first.type == more[0].type == t.VECTOR
            hint = "two vectors side by side; write · or × between them"
            message = hint if both else f"a {first.type} and a {more[0].type} side by side"
            raise self.resolver.error(more[0].span[0], message)
        if first.type == t.REGION:
            raise self.resolver.error(first.span[0], "a region is no factor")
        for one, other in pairwise(nodes):
            if isinstance(one, t.Number) and isinstance(other, t.Number):
                raise self.resolver.error(other.span[0], "two numbers side by side; write brackets or one number")
        return t.Product(tuple(nodes), span=(nodes[0].span[0], nodes[-1].span[1]))
