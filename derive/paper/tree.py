"""The typed tree of a formula. Spans are offsets in the LaTeX it was read from; they do not enter equality.

Every node has a type, ``scalar`` or ``vector``. Brackets are not kept: the shape of the tree says what they said.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field, fields, replace
from typing import Any

Span = tuple[int, int]
NOWHERE: Span = (0, 0)
SCALAR, VECTOR = "scalar", "vector"


@dataclass(frozen=True)
class Node:
    """Any node; ``span`` is where it stands in the source."""

    span: Span = field(default=NOWHERE, compare=False, repr=False, kw_only=True)

    @property
    def type(self) -> str:
        """``scalar`` unless a node says otherwise."""
        return SCALAR

    def parts(self) -> tuple[Node, ...]:
        """The nodes directly below, in printed order."""
        found: list[Node] = []
        for item in fields(self):
            value = getattr(self, item.name)
            found += [value] if isinstance(value, Node) else value if _is_nodes(value) else []
        return tuple(found)

    def with_parts(self, parts: tuple[Node, ...]) -> Node:
        """The same node over other parts, as many as ``parts()`` gives."""
        rest: list[Node] = list(parts)
        changes: dict[str, Any] = {}
        for item in fields(self):
            value = getattr(self, item.name)
            if isinstance(value, Node):
                changes[item.name] = rest.pop(0)
            elif _is_nodes(value):
                changes[item.name] = tuple(rest.pop(0) for _ in value)
        return replace(self, **changes)

    def walk(self) -> Iterator[Node]:
        """This node and all below it, from the top."""
        yield self
        for part in self.parts():
            yield from part.walk()


def _is_nodes(value: object) -> bool:
    return isinstance(value, tuple) and bool(value) and all(isinstance(part, Node) for part in value)


@dataclass(frozen=True)
class Number(Node):
    """A printed non-negative integer."""

    value: int


@dataclass(frozen=True)
class Name(Node):
    """A declared symbol, by its normalised name."""

    name: str
    kind: str = SCALAR

    @property
    def type(self) -> str:
        """As declared."""
        return self.kind


@dataclass(frozen=True)
class Call(Node):
    """A declared function, primed or not, at its arguments: f′(a), ℘(u; g₂, g₃), ξ(ℓ)."""

    name: str
    args: tuple[Node, ...]
    primes: int = 0
    kind: str = SCALAR

    @property
    def type(self) -> str:
        """As declared."""
        return self.kind


@dataclass(frozen=True)
class Primed(Node):
    """Derivative with respect to arc length, of a given order: y″, (d₃ × d₃′)′."""

    of: Node
    order: int

    @property
    def type(self) -> str:
        """That of what is differentiated."""
        return self.of.type


@dataclass(frozen=True)
class Derivative(Node):
    """d of / d by, printed as a fraction."""

    of: Node
    by: Node

    @property
    def type(self) -> str:
        """That of what is differentiated."""
        return self.of.type


@dataclass(frozen=True)
class Signed(Node):
    """A term with its sign, one of ``-``, ``+``, ``\\pm``, ``\\mp``."""

    sign: str
    of: Node

    @property
    def type(self) -> str:
        """That of the term."""
        return self.of.type


@dataclass(frozen=True)
class Sum(Node):
    """Two or more terms; a plus before any but the first is understood."""

    terms: tuple[Node, ...]

    @property
    def type(self) -> str:
        """That of its terms."""
        return self.terms[0].type


@dataclass(frozen=True)
class Product(Node):
    """Two or more factors side by side, at most one of them a vector."""

    factors: tuple[Node, ...]

    @property
    def type(self) -> str:
        """Vector if one factor is."""
        return VECTOR if any(factor.type == VECTOR for factor in self.factors) else SCALAR


@dataclass(frozen=True)
class Quotient(Node):
    """above / below, printed as a fraction or with a slash."""

    above: Node
    below: Node

    @property
    def type(self) -> str:
        """That of the numerator."""
        return self.above.type


@dataclass(frozen=True)
class Power(Node):
    """base^exponent; the square of a vector is the square of its length."""

    base: Node
    exponent: Node


@dataclass(frozen=True)
class Root(Node):
    """The root of a radicand; degree 2 is not printed."""

    of: Node
    degree: int = 2


@dataclass(frozen=True)
class Dot(Node):
    """Scalar product of two vectors."""

    left: Node
    right: Node


@dataclass(frozen=True)
class Cross(Node):
    """Vector product of two vectors."""

    left: Node
    right: Node

    @property
    def type(self) -> str:
        """A vector."""
        return VECTOR


@dataclass(frozen=True)
class Statement:
    """A chain of relations: sides[0] operators[0] sides[1] operators[1] …

    Operators are ``=``, ``<``, ``>``, ``<=``, ``>=``, ``!=`` and ``->`` (tends to). span: in the display's LaTeX.
    """

    sides: tuple[Node, ...]
    operators: tuple[str, ...]
    span: Span = field(default=NOWHERE, compare=False)
