"""What the article prints anywhere: what looks likely in a formula, because it stands in another."""

from __future__ import annotations

from functools import cache

from derive.paper import tree as t
from derive.paper.errors import ReadError
from derive.paper.ledger import load_ledger
from derive.paper.reader import parse


@cache
def printed_parts() -> frozenset[t.Node]:
    """Everything that the ledger prints, down to single symbols."""
    found: set[t.Node] = set()
    for record in load_ledger().values():
        try:
            statements = parse(record.latex, str(record.scope)) if record.scope else []
        except ReadError:
            continue
        found |= {node for statement in statements for side in statement.sides for node in side.walk()}
    return frozenset(found)


@cache
def primed(kind: type[t.Name | t.Call]) -> frozenset[tuple[str, int]]:
    """The names, or the functions at arguments, that are printed with primes, each with the number of them."""
    if kind is t.Call:
        return frozenset((node.name, node.primes) for node in printed_parts() if isinstance(node, t.Call))
    named = (node for node in printed_parts() if isinstance(node, t.Primed))
    return frozenset((node.of.name, node.order) for node in named if isinstance(node.of, t.Name))
