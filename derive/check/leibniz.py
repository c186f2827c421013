"""Rates and variations of composite trees by the rules of sum and product, so that only those of symbols remain."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from derive.paper import tree as t

Change = Callable[[t.Node], t.Node]
BILINEAR = (t.Product, t.Dot, t.Cross, t.Outer, t.Apply, t.Compose)
LINEAR = (t.Sum, t.Contraction, t.Transpose)


def expanded(node: t.Node) -> t.Node | None:
    """A tree of the same value as a rate or a variation, with fewer operations under it; None if there is none."""
    if isinstance(node, t.Varied):
        return _of(node.of, t.Varied) or _inside(node)
    if isinstance(node, t.Primed):
        if node.order > 1 and not isinstance(node.of, t.Name | t.Call):
            return t.Primed(t.Primed(node.of, 1), node.order - 1)
        return _of(node.of, lambda part: t.Primed(part, node.order)) or _inside(node)
    return None


def _inside(node: t.Varied | t.Primed) -> t.Node | None:
    """The rate or variation of what is itself one, expanded."""
    inner = expanded(node.of)
    return None if inner is None else replace(node, of=inner)


def _of(node: t.Node, change: Change) -> t.Node | None:
    parts = node.parts()
    if isinstance(node, LINEAR) or (isinstance(node, t.Signed) and node.sign in "+-"):
        return node.with_parts(tuple(change(part) for part in parts))
    if isinstance(node, BILINEAR):
        changed = (node.with_parts((*parts[:n], change(part), *parts[n + 1 :])) for n, part in enumerate(parts))
        terms = tuple(term for n, term in enumerate(changed) if not isinstance(parts[n], t.Number))
        return t.Sum(terms) if len(terms) > 1 else terms[0]
    if isinstance(node, t.Quotient) and isinstance(node.below, t.Number):
        return t.Quotient(change(node.above), node.below)
    if isinstance(node, t.Power) and node.exponent == t.Number(2):
        return t.Product((t.Number(2), _product(node.base, change(node.base))))
    return None


def _product(one: t.Node, other: t.Node) -> t.Node:
    return t.Dot(one, other) if one.type == t.VECTOR else t.Product((one, other))
