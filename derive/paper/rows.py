"""One row of factors, resolved by declared types.

Application: only of a symbol declared to take arguments, and only if the bracket's sort fits. Then, from the tightest:
/, ×, ⊗, tensors applied or composed, ·, and scalars side by side. The left operand of an operator is the vector just
before it; the right one is the next vector with the scalars before it.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from typing import TYPE_CHECKING, Any

from lark import Token, Tree

from . import differentials as d
from . import tree as t
from .conventions import Declared
from .factors import Factor, read_factor

if TYPE_CHECKING:
    from .resolve import Resolver

Syntax = Any  # Tree[Token] | Token
Elements = list[Any]  # t.Node | Token
_JOINED: dict[str, type[t.Cross | t.Outer | t.Dot]] = {"CROSS": t.Cross, "OUTER": t.Outer, "CDOT": t.Dot}


def read_row(items: Sequence[Syntax], resolver: Resolver) -> t.Node:
    """The node of a row."""
    return _Row(items, resolver).read()


class _Row:
    def __init__(self, items: Sequence[Syntax], resolver: Resolver) -> None:
        self.items, self.resolver = list(items), resolver
        self.rest = list(items)
        self.joined: list[t.Node] = []  # made by an operator in this row, not in brackets

    def read(self) -> t.Node:
        elements: Elements = []
        while self.rest:
            elements.append(self.rest.pop(0) if isinstance(self.rest[0], Token) else self._element())
        self._operands(elements)
        elements = self._divided(elements)
        for kind in ("CROSS", "OUTER"):
            elements = self._folded(elements, kind)
        elements = self._folded(self._applied(elements), "CDOT")
        return self._product(elements)

    # Elements: symbols take the arguments that fit; integrals and limits take the rest of the row.

    def _element(self) -> t.Node:
        item = self.rest[0]
        base = item.children[0]
        kind = base.type if isinstance(base, Token) else ""
        if kind in ("INT", "LIM"):
            rest, self.rest = self.rest, []
            return (d.integral if kind == "INT" else d.limit)(rest, self.resolver)
        del self.rest[0]
        if kind == "MAX":
            return d.maximum(item, self._next(item), self.resolver)
        if kind == "VARIED":
            if len(item.children) > 1 or not self.rest or isinstance(self.rest[0], Token):
                raise self.resolver.error(item.meta.start_pos, "δ stands before what varies")
            of = self._element()
            return t.Varied(of, span=(item.meta.start_pos, of.span[1]))
        head = read_factor(item, self.resolver)
        if head.declared is not None and head.declared.callable:
            return self._call(head, head.declared)
        node = head.node(self.resolver)
        return self._evaluated(node) if isinstance(node, t.Derivative) else node

    def _next(self, item: Syntax) -> Syntax:
        if not self.rest or isinstance(self.rest[0], Token):
            raise self.resolver.error(item.meta.end_pos, "something is missing here")
        return self.rest.pop(0)

    def _bracket(self) -> Factor | None:
        """The bracket that comes next in the row, if one does."""
        item = self.rest[0] if self.rest else None
        if not isinstance(item, Tree) or not isinstance(item.children[0], Tree) or item.children[0].data != "group":
            return None
        bracket = read_factor(item, self.resolver)
        return bracket if bracket.arguments is not None else None

    def _call(self, head: Factor, declared: Declared) -> t.Node:
        bracket = self._bracket()
        if bracket is not None and self._fits(declared, bracket):
            del self.rest[0]
            return head.call(self.resolver, bracket)
        if declared.kind not in ("function", "order"):
            return head.node(self.resolver)
        if not declared.prefix or not self.rest or isinstance(self.rest[0], Token):
            raise self.resolver.error(head.span[1], f"the function {declared.latex} needs an argument in brackets")
        bare = read_factor(self.rest.pop(0), self.resolver)
        if bare.declared is not None and bare.declared.kind == "function":
            raise self.resolver.error(bare.span[0], f"write brackets around the argument of {declared.latex}")
        if self.rest and not isinstance(self.rest[0], Token):
            after = read_factor(self.rest[0], self.resolver)
            if after.declared is None or after.declared.kind != "function":
                message = f"where does the argument of {declared.latex} end? write brackets"
                raise self.resolver.error(after.span[0], message)
        return head.call(self.resolver, bare.as_argument(self.resolver))

    def _evaluated(self, node: t.Derivative) -> t.Node:
        """A derivative at a place: a bracket after it whose sort is that of its variable."""
        bracket = self._bracket()
        by = self.resolver.scope.declared(node.by.name, node.by.index) if isinstance(node.by, t.Name) else None
        if bracket is None or by is None or not by.sort or not self._sorted((by.sort,), "the derivative", bracket):
            return node
        del self.rest[0]
        span = (node.span[0], bracket.span[1])
        assert bracket.arguments is not None
        if bracket.scripts.primes or bracket.scripts.power is not None or bracket.scripts.at is not None:
            raise self.resolver.error(bracket.span[0], "scripts after a derivative's argument; write brackets")
        return t.At(node, bracket.arguments[0], span=span)

    def _fits(self, declared: Declared, bracket: Factor) -> bool:
        """Is the bracket an argument of the symbol? ReadError if it may be one as well as a factor."""
        arguments = bracket.arguments or ()
        if declared.kind in ("function", "order"):
            if len(arguments) not in declared.arity:
                allowed = " or ".join(map(str, declared.arity))
                message = f"{declared.latex} takes {allowed} arguments, not {len(arguments)}"
                raise self.resolver.error(bracket.span[0], message)
            return True
        return self._sorted((declared.argument, *declared.alternatives), declared.latex, bracket)

    def _sorted(self, allowed: tuple[str, ...], who: str, bracket: Factor) -> bool:
        arguments = bracket.arguments or ()
        sorts = [_sorts(argument, self.resolver) for argument in arguments]
        for wanted in (choice.split() for choice in allowed):
            if len(wanted) == len(sorts) and all(
                found == {want} or (not found and argument == t.Number(0))
                for want, found, argument in zip(wanted, sorts, arguments, strict=True)
            ):
                return True
        every = {word for choice in allowed for word in choice.split()}
        if len(arguments) == 1 and (not sorts[0] or sorts[0] & every):
            message = f"is this bracket the argument of {who} or a factor? write the product in brackets"
            raise self.resolver.error(bracket.span[0], message)
        return False

    # Operators.

    def _operands(self, elements: Elements) -> None:
        for place, element in enumerate(elements):
            if isinstance(element, Token):
                around = (elements[place - 1] if place else None, *elements[place + 1 : place + 2])
                if len(around) < 2 or not all(isinstance(one, t.Node) for one in around):
                    raise self.resolver.error(element.start_pos or 0, f"'{element}' needs an operand on both sides")

    def _divided(self, elements: Elements) -> Elements:
        """Fold /: all that stands before it in its operand, over one factor."""
        while (place := _find(elements, "SLASH")) is not None:
            start = max((n + 1 for n in range(place) if isinstance(elements[n], Token)), default=0)
            if any(element is made for element in elements[start:place] for made in self.joined):
                raise self.resolver.error(elements[place].start_pos, "two '/' in one product; write brackets")
            after = elements[place + 2] if place + 2 < len(elements) else None
            if isinstance(after, t.Node):
                message = "where does the denominator after '/' end? write brackets"
                raise self.resolver.error(after.span[0], message)
            above = self._product(self._applied(elements[start:place]))
            made = self.resolver.quotient(above, elements[place + 1])
            self.joined.append(made)
            elements = [*elements[:start], made, *elements[place + 2 :]]
        self.joined.clear()
        return elements

    def _folded(self, elements: Elements, kind: str) -> Elements:
        """Fold ×, ⊗ or ·."""
        self.joined.clear()
        while (place := _find(elements, kind)) is not None:
            left, sign = elements[place - 1], elements[place]
            if any(left is made for made in self.joined):
                raise self.resolver.error(sign.start_pos, f"two '{sign}' in one product; write brackets")
            if left.type == t.REGION and kind == "CROSS":
                made, stop = self._region_product(left, elements[place + 1]), place + 2
            else:
                self._left(elements, place)
                right, stop = self._right(elements, place)
                made = _JOINED[kind](left, right, span=(left.span[0], right.span[1]))
            self.joined.append(made)
            elements = [*elements[: place - 1], made, *elements[stop:]]
        return elements

    def _left(self, elements: Elements, place: int) -> None:
        left, sign = elements[place - 1], elements[place]
        if left.type != t.VECTOR:
            raise self.resolver.error(left.span[0], f"the last factor before '{sign}' is no vector; write brackets")
        before = elements[place - 2] if place > 1 else None
        if isinstance(before, t.Node) and before.type == t.TENSOR and sign.type != "CDOT":
            message = f"is the tensor applied before or after '{sign}'? write brackets"
            raise self.resolver.error(before.span[0], message)

    def _right(self, elements: Elements, place: int) -> tuple[t.Node, int]:
        """The operand on the right, and where it ends."""
        stop = place + 1
        while (
            stop < len(elements) and isinstance(elements[stop], t.Node) and elements[stop].type in (t.SCALAR, t.TENSOR)
        ):
            stop += 1
        if stop == len(elements) or isinstance(elements[stop], Token) or elements[stop].type != t.VECTOR:
            first = elements[place + 1]
            raise self.resolver.error(first.span[0], f"'{elements[place]}' joins vectors; write products side by side")
        return self._product(self._applied(elements[place + 1 : stop + 1])), stop + 1

    def _region_product(self, left: t.Node, right: t.Node) -> t.Node:
        if right.type != t.REGION:
            raise self.resolver.error(right.span[0], "a region is multiplied by a region")
        return t.RegionProduct(left, right, span=(left.span[0], right.span[1]))

    def _applied(self, elements: Elements) -> Elements:
        """Tensors take the tensors and then the vector to the right of them."""
        made: Elements = []
        for element in elements:
            before = made[-1] if made else None
            if isinstance(element, t.Node) and isinstance(before, t.Node) and before.type == t.TENSOR:
                kind = {t.TENSOR: t.Compose, t.VECTOR: t.Apply}.get(element.type)
                if kind is not None:
                    made[-1] = kind(before, element, span=(before.span[0], element.span[1]))
                    continue
            made.append(element)
        return made

    def _product(self, nodes: Sequence[t.Node]) -> t.Node:
        others = [node for node in nodes if node.type != t.SCALAR]
        if len(others) > 1:
            one, other = others[0].type, others[1]
            message = f"a {one} and a {other.type} side by side"
            hint = "two vectors side by side; write · or × between them"
            both = one == other.type == t.VECTOR
            raise self.resolver.error(other.span[0], hint if both else message)
        for one_number, other_number in pairwise(nodes):
            if isinstance(one_number, t.Number) and isinstance(other_number, t.Number):
                raise self.resolver.error(
                    other_number.span[0], "two numbers side by side; write brackets or one number"
                )
        span = (nodes[0].span[0], nodes[-1].span[1])
        return nodes[0] if len(nodes) == 1 else t.Product(tuple(nodes), span=span)


def _find(elements: Elements, kind: str) -> int | None:
    found = (n for n, element in enumerate(elements) if isinstance(element, Token) and element.type == kind)
    return next(found, None)


def _sorts(node: t.Node, resolver: Resolver) -> set[str]:
    """The sorts of the symbols in a bracket; of an applied symbol its own."""
    if isinstance(node, t.Name | t.Call):
        return {resolver.scope.declared(node.name, node.index).sort}
    return {sort for part in node.parts() for sort in _sorts(part, resolver)}
