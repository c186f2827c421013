"""Differentials and what is written with them: integrals; and limits and the greatest of some quantities."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from lark import Token, Tree

from . import tree as t
from .factors import read_factor
from .scripts import Scripts, read_scripts

if TYPE_CHECKING:
    from .resolve import Resolver

Syntax = Any  # Tree[Token] | Token


def fraction_row(argument: Any) -> list[Syntax]:
    """The factors of a braced argument that is one unsigned row, else nothing."""
    inner = argument.children[0]
    if isinstance(inner, Tree) and inner.data == "sum" and len(inner.children) == 1:
        return list(inner.children[0].children)
    return []


def differential(row: Sequence[Syntax], resolver: Resolver) -> str:
    """``d`` or ``\\partial`` if the row begins with it and goes on, else nothing."""
    if len(row) < 2 or not isinstance(row[0], Tree) or len(row[0].children) != 1:
        return ""
    base: Any = row[0].children[0]
    while isinstance(base, Tree) and base.data in ("braces", "sum", "chain", "factor") and len(base.children) == 1:
        base = base.children[0]
    if base == "d" and "d" not in resolver.scope.by_spelling:
        return "d"
    return r"\partial" if base == r"\partial" else ""


def start(item: Syntax) -> int:
    """Where an item of a row begins."""
    return (item.start_pos or 0) if isinstance(item, Token) else int(item.meta.start_pos)


def end(item: Syntax) -> int:
    """Where an item of a row ends."""
    return (item.end_pos or 0) if isinstance(item, Token) else int(item.meta.end_pos)


def integral(items: Sequence[Syntax], resolver: Resolver) -> t.Node:
    """The integral with which a row ends: ``\\int``, its bounds, an integrand, and its differentials."""
    sign, *rest = items
    span = (sign.meta.start_pos, end(items[-1]))
    inside, differentials = _split(rest, span, resolver)
    node, left = _integrated(sign, inside, differentials, span, resolver)
    if left:
        raise resolver.error(left[0].span[0], "a differential without an integral")
    return node


def _split(rest: Sequence[Syntax], span: t.Span, resolver: Resolver) -> tuple[list[Syntax], list[t.Node]]:
    """The integrand and what is integrated by; ``\\frac{d x}{y}`` is 1/y integrated by x."""
    first = next((n for n in range(len(rest)) if differential(rest[n:], resolver) == "d"), None)
    if first is None:
        return _fraction_split(rest, span, resolver)
    found: list[t.Node] = []
    place = first
    while place < len(rest):
        if differential(rest[place:], resolver) != "d":
            raise resolver.error(start(rest[place]), "where does the integral end? write brackets around it")
        found.append(_variable(rest[place + 1], resolver))
        place += 2
    return list(rest[:first]), found


def _variable(item: Syntax, resolver: Resolver) -> t.Node:
    """What is integrated by: a scalar."""
    by = t.Number(0) if isinstance(item, Token) else read_factor(item, resolver).node(resolver)
    if isinstance(item, Token) or by.type != t.SCALAR:
        raise resolver.error(start(item), "an integral is taken by a scalar after d")
    return by


def _fraction_split(rest: Sequence[Syntax], span: t.Span, resolver: Resolver) -> tuple[list[Syntax], list[t.Node]]:
    last: Any = rest[-1] if rest else None
    fraction = last.children[0] if isinstance(last, Tree) and len(last.children) == 1 else None
    if not isinstance(fraction, Tree) or fraction.data != "fraction":
        raise resolver.error(span[0], "an integral needs a differential, as in \\int x \\, d x")
    row = fraction_row(fraction.children[1])
    first = next((n for n in range(len(row)) if differential(row[n:], resolver) == "d"), None)
    if first is None or first + 2 != len(row) or differential(fraction_row(fraction.children[2]), resolver):
        raise resolver.error(span[0], "an integral needs a differential, as in \\int x \\, d x")
    by = _variable(row[first + 1], resolver)
    above: Any = Tree("chain", row[:first], fraction.children[1].meta)
    one = Token("NUMBER", "1", start_pos=row[0].meta.start_pos, end_pos=row[0].meta.start_pos)
    if first == 0:
        above = Tree("chain", [Tree("factor", [one], fraction.children[1].meta)], fraction.children[1].meta)
    numerator = Tree("arg", [Tree("sum", [above], above.meta)], above.meta)
    rewritten = Tree("fraction", [fraction.children[0], numerator, fraction.children[2]], fraction.meta)
    return [*rest[:-1], Tree("factor", [rewritten], last.meta)], [by]


def _integrated(
    sign: Syntax, inside: list[Syntax], by: list[t.Node], span: t.Span, resolver: Resolver
) -> tuple[t.Node, list[t.Node]]:
    """The integral and the differentials left for the sign outside it."""
    scripts = read_bounds(sign, resolver)
    if inside and _base(inside[0]) == "INT":
        of, by = _integrated(inside[0], inside[1:], by, (inside[0].meta.start_pos, span[1]), resolver)
    elif inside:
        of = resolver.row(inside)
    else:
        of = t.Number(1, span=span)
    region, lower, upper = scripts
    if of.type not in (t.SCALAR, t.VECTOR, t.TENSOR):
        raise resolver.error(of.span[0], f"a {of.type} is not integrated")
    wanted = 1 if region is None else _dimension(region, resolver)
    own: list[t.Node] = []
    while by and wanted > 0:
        wanted -= _dimension(by[0], resolver)
        own.append(by.pop(0))
    if wanted:
        raise resolver.error(span[0], "the differentials do not fit what is integrated over")
    return t.Integral(of, tuple(own), lower, upper, region, span=span), by


def read_bounds(sign: Syntax, resolver: Resolver) -> tuple[t.Node | None, t.Node | None, t.Node | None]:
    """Region, lower and upper bound of an integral sign."""
    scripts: Scripts = read_scripts(list(sign.children[1:]), True, resolver)
    place = sign.meta.start_pos
    if scripts.primes or scripts.power is not None or scripts.named or scripts.transposed:
        raise resolver.error(place, "an integral sign has bounds only: a lower one, or both")
    if scripts.at is None:
        return None, None, None
    lower = scripts.at[1]
    if lower.type == t.REGION and scripts.upto is None:
        return lower, None, None
    if scripts.upto is None or scripts.at[0] is not None or scripts.upto[0] is not None:
        raise resolver.error(place, "an integral is over a region or between two values")
    upper = scripts.upto[1]
    if lower.type != t.SCALAR or upper.type != t.SCALAR:
        raise resolver.error(place, "the bounds of an integral are scalars")
    return None, lower, upper


def _dimension(node: t.Node, resolver: Resolver) -> int:
    match node:
        case t.RegionProduct():
            return _dimension(node.left, resolver) + _dimension(node.right, resolver)
        case t.Name() | t.Call():
            return resolver.scope.declared(node.name, node.index).dimension
    return 1


def _base(item: Syntax) -> str:
    base = item.children[0] if isinstance(item, Tree) else None
    return base.type if isinstance(base, Token) else ""


def limit(items: Sequence[Syntax], resolver: Resolver) -> t.Node:
    """The limit with which a row ends: ``\\lim_{x \\to a}`` and the rest of the row."""
    sign, *rest = items
    at = sign.children[1] if len(sign.children) == 2 else None
    if at is None or at.data != "at" or at.children[1] != r"\to" or not rest:
        raise resolver.error(sign.meta.start_pos, "a limit is written \\lim_{x \\to a} and what tends")
    variable, point = resolver.sum(at.children[0]), resolver.sum(at.children[2])
    if not isinstance(variable, t.Name) or variable.type != point.type:
        raise resolver.error(variable.span[0], "a symbol tends to a value of its type")
    span = (sign.meta.start_pos, end(rest[-1]))
    return t.Limit(resolver.row(rest), variable, point, span=span)


def maximum(sign: Any, over: Syntax, resolver: Resolver) -> t.Node:
    """``\\max_{x \\in A} \\{a, b\\}``; the index may be absent."""
    variable = region = None
    if len(sign.children) > 1:
        at = sign.children[1]
        if at.data != "at" or at.children[-2] != r"\in" or len(sign.children) > 2:
            raise resolver.error(sign.meta.start_pos, "the index of a maximum is written x \\in A")
        variable, region = resolver.sum(at.children[-3]), resolver.sum(at.children[-1])
        if not isinstance(variable, t.Name) or region.type != t.REGION:
            raise resolver.error(variable.span[0], "a symbol lies in a region")
    listing = read_factor(over, resolver).node(resolver)
    if not isinstance(listing, t.Listing) or any(item.type != t.SCALAR for item in listing.items):
        raise resolver.error(listing.span[0], "a maximum is taken of scalars in set brackets")
    return t.Maximum(listing.items, variable, region, span=(sign.meta.start_pos, over.meta.end_pos))
