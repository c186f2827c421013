"""The typed tree of a formula. Spans are offsets in the LaTeX it was read from; they do not enter equality.

Every node has a type: ``scalar``, ``vector``, ``tensor``, ``region`` (a set of points), ``list`` or ``index``. Brackets
are not kept: the shape of the tree says what they said. Summation over a repeated index is a node of its own.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field, fields, replace
from typing import Any

Span = tuple[int, int]
NOWHERE: Span = (0, 0)
SCALAR, VECTOR, TENSOR, REGION, LIST, INDEX = "scalar", "vector", "tensor", "region", "list", "index"
LATIN, GREEK = range(1, 4), range(1, 3)  # the values of index letters


def values_of(letter: str) -> range:
    """The values over which an index letter runs: Latin letters over three directions, Greek ones over two."""
    return LATIN if len(letter) == 1 else GREEK


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

    def free_indices(self) -> set[str]:
        """The index letters in it over which it does not sum."""
        found = set().union(*(part.free_indices() for part in self.parts()))
        if isinstance(self, Name | Call) and self.index:
            found.add(self.index)
        return found - {self.index} if isinstance(self, Contraction) else found


def _is_nodes(value: object) -> bool:
    return isinstance(value, tuple) and bool(value) and all(isinstance(part, Node) for part in value)


@dataclass(frozen=True)
class Number(Node):
    """A printed non-negative integer."""

    value: int


@dataclass(frozen=True)
class Name(Node):
    """A declared symbol, by its normalised name.

    index: the letter of a member of a family, d_i, or empty. A member by number, d_3, is the name ``d_3``.
    """

    name: str
    kind: str = SCALAR
    index: str = ""

    @property
    def type(self) -> str:
        """As declared."""
        return self.kind


@dataclass(frozen=True)
class Call(Node):
    """A declared function, primed or not, at its arguments: f′(a), ℘(u; g₂, g₃), ξ(ℓ), d_i′(s); index as in Name."""

    name: str
    args: tuple[Node, ...]
    primes: int = 0
    kind: str = SCALAR
    index: str = ""

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
    """d of / d by, or with ∂, printed as a fraction."""

    of: Node
    by: Node
    partial: bool = False

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
    """Two or more factors side by side, scalars but for one at most, which gives the type."""

    factors: tuple[Node, ...]

    @property
    def type(self) -> str:
        """That of the factor that is no scalar."""
        return next((kind for factor in self.factors if (kind := factor.type) != SCALAR), SCALAR)


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
    """base^exponent; the square of a vector is the square of its length, the power −1 of a tensor its inverse."""

    base: Node
    exponent: Node

    @property
    def type(self) -> str:
        """A tensor for the inverse of one."""
        return TENSOR if self.base.type == TENSOR else SCALAR


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
class Outer(Node):
    """Tensor product ⊗ of two vectors."""

    left: Node
    right: Node

    @property
    def type(self) -> str:
        """A tensor."""
        return TENSOR


@dataclass(frozen=True)
class Apply(Node):
    """A tensor and, side by side, the vector to which it is applied."""

    tensor: Node
    vector: Node

    @property
    def type(self) -> str:
        """A vector."""
        return VECTOR


@dataclass(frozen=True)
class Compose(Node):
    """Two tensors side by side."""

    left: Node
    right: Node

    @property
    def type(self) -> str:
        """A tensor."""
        return TENSOR


@dataclass(frozen=True)
class Transpose(Node):
    """The transpose of a tensor."""

    of: Node

    @property
    def type(self) -> str:
        """A tensor."""
        return TENSOR


@dataclass(frozen=True)
class Norm(Node):
    """|of|: the length of a vector, the absolute value of a scalar."""

    of: Node


@dataclass(frozen=True)
class Contraction(Node):
    """The sum over the values of an index that is written twice in ``of``; nothing of it is printed but ``of``."""

    index: str
    of: Node

    @property
    def type(self) -> str:
        """That of what is summed."""
        return self.of.type


@dataclass(frozen=True)
class Varied(Node):
    """δ of: the variation."""

    of: Node

    @property
    def type(self) -> str:
        """That of what varies."""
        return self.of.type


@dataclass(frozen=True)
class BigO(Node):
    """O(of): anything of this order or smaller. kind: the type of the terms beside it."""

    of: Node
    kind: str = SCALAR

    @property
    def type(self) -> str:
        """As the terms beside it."""
        return self.kind


@dataclass(frozen=True)
class Integral(Node):
    """The integral of ``of`` by the variables ``by``, one sign: from lower to upper, over a region, or indefinite.

    by: symbols, or one expression (d of an expression). region: one region, or a region times an interval.
    """

    of: Node
    by: tuple[Node, ...]
    lower: Node | None = None
    upper: Node | None = None
    region: Node | None = None

    @property
    def type(self) -> str:
        """That of the integrand."""
        return self.of.type


@dataclass(frozen=True)
class Between(Node):
    """[of] from lower to upper: the difference of its values there; variable: if it is printed."""

    of: Node
    lower: Node
    upper: Node
    variable: Node | None = None

    @property
    def type(self) -> str:
        """That of what stands in the brackets."""
        return self.of.type


@dataclass(frozen=True)
class At(Node):
    """The value of ``of`` where variable = value: ξ(s)_{s=ℓ}, ξ(u)|_{u=0}; variable is None for (d of/d s)(s)."""

    of: Node
    value: Node
    variable: Node | None = None

    @property
    def type(self) -> str:
        """That of what is evaluated."""
        return self.of.type


@dataclass(frozen=True)
class Limit(Node):
    """lim of ``of`` as variable → point."""

    of: Node
    variable: Node
    point: Node

    @property
    def type(self) -> str:
        """That of what tends."""
        return self.of.type


@dataclass(frozen=True)
class Maximum(Node):
    """The greatest of some quantities over the values of a variable in a region (variable None: just the greatest)."""

    of: tuple[Node, ...]
    variable: Node | None = None
    region: Node | None = None


@dataclass(frozen=True)
class Interval(Node):
    """An interval; ``]a, b[`` and ``(a, b)`` are open."""

    lower: Node
    upper: Node
    left_open: bool = False
    right_open: bool = False

    @property
    def type(self) -> str:
        """A region."""
        return REGION


@dataclass(frozen=True)
class RegionProduct(Node):
    """Region × region."""

    left: Node
    right: Node

    @property
    def type(self) -> str:
        """A region."""
        return REGION


@dataclass(frozen=True)
class Listing(Node):
    """{a, b, c}: several quantities for which something holds one by one."""

    items: tuple[Node, ...]

    @property
    def type(self) -> str:
        """A list."""
        return LIST


@dataclass(frozen=True)
class Stack(Node):
    """Quantities one above the other on one side: the first takes the upper signs of ± and ∓, the second the lower."""

    rows: tuple[Node, ...]

    @property
    def type(self) -> str:
        """That of its rows."""
        return self.rows[0].type


@dataclass(frozen=True)
class Condition(Node):
    """A chain of relations under which a case holds; sides and operators as in a Statement."""

    sides: tuple[Node, ...]
    operators: tuple[str, ...]


@dataclass(frozen=True)
class Cases(Node):
    """A value for each of several conditions."""

    values: tuple[Node, ...]
    conditions: tuple[Condition, ...]

    @property
    def type(self) -> str:
        """That of its values."""
        return self.values[0].type


@dataclass(frozen=True)
class Statement:
    """A chain of relations: sides[0] operators[0] sides[1] operators[1] …

    Operators are ``=``, ``<``, ``>``, ``<=``, ``>=``, ``!=``, ``->`` (tends to), ``in`` and ``notin``. where: what is
    said after it of its letters, each a Statement of one ``in``: an index in a Listing of numbers, ``i = 1, 2, 3``, or
    a variable in an Interval. span: in the display's LaTeX.
    """

    sides: tuple[Node, ...]
    operators: tuple[str, ...]
    where: tuple[Statement, ...] = ()
    span: Span = field(default=NOWHERE, compare=False)
