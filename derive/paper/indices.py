"""Repeated indices: where sums stand that are not printed, and which indices are free.

An index that is written more than once in a product is summed over its values, at the smallest node that holds all of
its places. If a part of a product is already summed over an index that another part has too, there are two readings:
an error. Written twice is the rule; ``overfull`` lists what is written more often.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from functools import reduce
from operator import add, or_

from . import tree as t
from .errors import ReadError

Complain = Callable[[int, str], ReadError]
_PRODUCTS = (t.Product, t.Quotient, t.Dot, t.Cross, t.Outer, t.Apply, t.Compose, t.Derivative)
_ALTERNATIVES = (t.Sum, t.Listing, t.Stack, t.Cases, t.Condition, t.Maximum, t.Interval)


@dataclass(frozen=True)
class _Read:
    """A node with its sums; how often each free index is written in it; the indices over which it is summed."""

    node: t.Node
    free: Counter[str]
    bound: frozenset[str] = frozenset()


def contracted(node: t.Node, complain: Complain) -> t.Node:
    """The node with all its sums over repeated indices, and with no others; ``complain(offset, message)``."""
    return _contracted(node, complain).node


def plain(node: t.Node) -> t.Node:
    """The node without its sums, as it is printed."""
    while isinstance(node, t.Contraction):
        node = node.of
    parts = node.parts()
    return node.with_parts(tuple(plain(part) for part in parts)) if parts else node


def overfull(nodes: Iterable[t.Node]) -> list[tuple[str, t.Span]]:
    """The indices that are summed although they are written more than twice, with the products where they are."""
    return [
        (sum_.index, sum_.span) for node in nodes for sum_ in node.walk()
        if isinstance(sum_, t.Contraction) and _written(sum_.of)[sum_.index] > 2
    ]  # fmt: skip


def one_set_of_free(nodes: Sequence[t.Node], complain: Complain) -> None:
    """ReadError if terms, or sides, have different free indices; 0 and O(…) fit all."""
    judged = [node for node in nodes if not _fits_all(node)]
    for node in judged[1:]:
        if odd := node.free_indices() ^ judged[0].free_indices():
            message = (
                f"the index {', '.join(sorted(odd))} is free here but not in the term or side before, or there only"
            )
            raise complain(node.span[0], message)


def _fits_all(node: t.Node) -> bool:
    while isinstance(node, t.Signed):
        node = node.of
    return isinstance(node, t.BigO) or node in (t.Number(0), t.Name("zero", t.VECTOR))


def _written(node: t.Node) -> Counter[str]:
    """How often each free index is written in a node; in a sum, in that of its terms where it is written most."""
    own = Counter([node.index] if isinstance(node, t.Name | t.Call) and node.index else [])
    parts = [_written(part) for part in node.parts()]
    found = reduce(or_ if isinstance(node, _ALTERNATIVES) else add, parts, own)
    if isinstance(node, t.Contraction):
        del found[node.index]
    return found


def _contracted(node: t.Node, complain: Complain) -> _Read:
    node = plain(node) if isinstance(node, t.Contraction) else node
    parts = [_contracted(part, complain) for part in node.parts()]
    whole = node.with_parts(tuple(part.node for part in parts)) if parts else node
    if isinstance(node, _ALTERNATIVES):
        return _alternatives(whole, parts, complain)
    own = Counter([node.index]) if isinstance(node, t.Name | t.Call) and node.index else Counter[str]()
    found = reduce(lambda one, other: one + other.free, parts, own)
    bound = frozenset[str]().union(*(part.bound for part in parts))
    _no_clash(parts, complain, isinstance(node, t.Quotient))
    repeated = [index for index, times in found.items() if times > 1]
    if not repeated:
        _no_power(node, found, complain)
        return _Read(whole, found, bound)
    if not isinstance(node, _PRODUCTS):
        raise complain(node.span[0], f"the index {repeated[0]} is repeated here, but not in a product")
    for index in reversed(repeated):
        whole = t.Contraction(index, whole, span=node.span)
    kept = Counter({index: times for index, times in found.items() if times == 1})
    return _Read(whole, kept, bound | set(repeated))


def _alternatives(whole: t.Node, parts: list[_Read], complain: Complain) -> _Read:
    """Terms of a sum: each may be summed over the same letter; all have the same free indices."""
    one_set_of_free([part.node for part in parts], complain)
    found = Counter(set().union(*(part.free for part in parts)))
    return _Read(whole, found, frozenset[str]().union(*(part.bound for part in parts)))


def _no_clash(parts: list[_Read], complain: Complain, apart: bool) -> None:
    """apart: above and below in a fraction each may have its own sum over the same letter."""
    written = [part for part in parts if part.bound or part.free]
    for place, part in enumerate(written):
        for other in written[:place]:
            shared = (part.bound & set(other.free)) | (other.bound & set(part.free))
            shared |= frozenset() if apart else part.bound & other.bound
            if shared:
                message = f"the index {min(shared)} is summed in one factor and written in another"
                raise complain(part.node.span[0], message)


def _no_power(node: t.Node, found: Counter[str], complain: Complain) -> None:
    if isinstance(node, t.Power) and found:
        raise complain(node.span[0], "a power of a quantity with a free index: write the product")
