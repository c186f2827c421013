"""What is written on a symbol or a bracket: primes, powers, the sign of the transpose, values, bounds."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

from . import tree as t
from .spelling import is_label, is_transpose

if TYPE_CHECKING:
    from .resolve import Resolver

Syntax = Any  # Tree[Token] | Token
Place = tuple[t.Node | None, t.Node]  # a variable, if it is printed, and its value
INVERSE = t.Signed("-", t.Number(1))


@dataclass(frozen=True)
class Scripts:
    """primes, a power, the sign of the transpose; named: an index or a label; at and upto: lower and upper values."""

    primes: int = 0
    power: t.Node | None = None
    transposed: bool = False
    named: bool = False
    at: Place | None = None
    upto: Place | None = None

    @property
    def plain(self) -> bool:
        """Is nothing written there?"""
        return self == Scripts()

    @property
    def raised(self) -> bool:
        """Is there a power or the sign of the transpose?"""
        return self.power is not None or self.transposed

    @property
    def bounded(self) -> bool:
        """Is there a lower or an upper value?"""
        return self.at is not None or self.upto is not None

    def around(self, node: t.Node, span: t.Span, resolver: Resolver) -> t.Node:
        """The node with all of them but the primes, from the inside out."""
        if self.transposed:
            if node.type != t.TENSOR:
                raise resolver.error(span[0], "only a tensor has a transpose")
            node = t.Transpose(node, span=span)
        if self.power is not None:
            node = _raised(node, self.power, span, resolver)
        if self.upto is not None:
            return self._between(node, span, resolver)
        if self.at is None:
            return node
        variable, value = self.at
        if not isinstance(variable, t.Name) or value.type != variable.type:
            raise resolver.error(value.span[0], "a value is given to a variable of its type, as in s = 0")
        return t.At(node, value, variable, span=span)

    def _between(self, node: t.Node, span: t.Span, resolver: Resolver) -> t.Node:
        assert self.upto is not None
        if self.at is None or (self.at[0] != self.upto[0]):
            raise resolver.error(self.upto[1].span[0], "the value of one variable is given below and above")
        if self.power is not None or self.transposed:
            raise resolver.error(span[0], "a power and bounds on one bracket; write another bracket")
        return t.Between(node, self.at[1], self.upto[1], self.at[0], span=span)


def _raised(node: t.Node, power: t.Node, span: t.Span, resolver: Resolver) -> t.Node:
    allowed = {t.SCALAR: power.type == t.SCALAR, t.VECTOR: power == t.Number(2), t.TENSOR: power == INVERSE}
    if not allowed.get(node.type, False):
        raise resolver.error(power.span[0], "a vector has a square only, a tensor an inverse; exponents are scalars")
    return t.Power(node, power, span=span)


def read_scripts(scripts: list[Syntax], square: bool, resolver: Resolver) -> Scripts:
    """The scripts of a factor. square: it is a square bracket, whose indices are bounds."""
    bounds = square and any(script.data == "subscript" for script in scripts)
    found = Scripts()
    for script in scripts:
        found = _with(found, script, square, bounds, resolver)
    return found


def _with(found: Scripts, script: Syntax, square: bool, bounds: bool, resolver: Resolver) -> Scripts:
    """One script more."""
    place, kind = script.meta.start_pos, script.data
    if found.at is not None and kind not in ("upto", "superscript"):
        raise resolver.error(place, "nothing but an upper bound stands after a value; write brackets")
    if kind == "prime":
        if found.power is not None or found.transposed:
            raise resolver.error(place, "a prime after a power; write brackets")
        return replace(found, primes=found.primes + len(script.children))
    if kind == "at" or (kind == "subscript" and square):
        return replace(found, at=_place(script, resolver))
    if kind == "upto" or (kind == "superscript" and bounds):
        if found.upto is not None:
            raise resolver.error(place, "two upper bounds on one bracket")
        return replace(found, upto=_place(script, resolver))
    if kind == "subscript":
        return replace(found, named=True)
    transposed = is_transpose(script.children[0], resolver.error)
    if is_label(script.children[0]) and not transposed:
        return replace(found, named=True)
    if found.power is not None or found.transposed or found.at is not None:
        raise resolver.error(place, "two powers on one symbol; write brackets")
    if transposed:
        return replace(found, transposed=True)
    return replace(found, power=resolver.argument(script.children[0]))


def _place(script: Syntax, resolver: Resolver) -> Place:
    """A value, with its variable where it is printed."""
    if script.data in ("subscript", "superscript"):
        return None, resolver.argument(script.children[0])
    return _equation(script, resolver)


def _equation(script: Syntax, resolver: Resolver) -> Place:
    variable, relation, value = script.children[-3:]
    if relation != "=":
        raise resolver.error(relation.start_pos, "a value is given with '='")
    return resolver.sum(variable), resolver.sum(value)
