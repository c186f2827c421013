"""Small changes of a printed tree, by kind: what a slip of the pen makes of it.

What a change makes is mostly false. Left alone is what says as much, or less, when it is changed: the variable of an
integral or a limit, the order of O(…) but for a higher one, the operands of · and of products of scalars. A
prime is added only to what the article prints with as many.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from derive.check.elsewhere import primed
from derive.check.lookalikes import difference, ranked
from derive.paper import tree as t
from derive.paper.conventions import Scope
from derive.paper.conventions import scope as conventions_of

Change = tuple[str, t.Node]
Path = tuple[int, ...]

LATIN, GREEK = ("i", "j", "k"), ("alpha", "beta")  # the letters of indices, in order
TURNED = {"<": ">", ">": "<", "<=": ">", ">=": "<", "!=": "=", "in": "notin", "notin": "in"}
OTHER_SIGN = {r"\pm": r"\mp", r"\mp": r"\pm"}
_BOUND = ("by", "variable")  # fields that bind a letter


def positions(node: t.Node) -> Iterator[tuple[Path, t.Node]]:
    """Every node that may be changed, from the top, with the way to it."""
    yield (), node
    bound = _bound(node)
    for n, part in enumerate(node.parts()):
        if part not in bound:
            for path, below in positions(part):
                yield (n, *path), below


def at(node: t.Node, path: Path) -> t.Node:
    """The node at the end of a way."""
    return at(node.parts()[path[0]], path[1:]) if path else node


def put(node: t.Node, path: Path, new: t.Node) -> t.Node:
    """The tree with another node at the end of a way."""
    if not path:
        return new
    parts = list(node.parts())
    parts[path[0]] = put(parts[path[0]], path[1:], new)
    return node.with_parts(tuple(parts))


def _bound(node: t.Node) -> tuple[t.Node, ...]:
    """The parts of a node that are left alone."""
    if isinstance(node, t.BigO):
        return (node.of,)
    held = [] if isinstance(node, t.Derivative) else [getattr(node, name, None) for name in _BOUND]
    return tuple(part for one in held for part in (one if isinstance(one, tuple) else (one,)) if part is not None)


def own_changes(node: t.Node, scope: str) -> Iterator[Change]:
    """The changes of a node itself but for exchanged symbols; its parts stay."""
    letters = conventions_of(scope)
    match node:
        case t.Number(value=value):
            yield "number", replace(node, value=value + 1)
        case t.Name():
            yield from _of_index(node, letters)
            if (node.name, 1) in primed(t.Name):
                yield "prime", t.Primed(node, 1)
        case t.Call():
            yield from _of_call(node, letters)
        case t.Sum() | t.Product() | t.Signed():
            yield from _of_row(node)
        case t.Primed(order=order, of=of):
            yield "prime", of if order == 1 else replace(node, order=order - 1)
            if isinstance(of, t.Name) and (of.name, order + 1) in primed(t.Name):
                yield "prime", replace(node, order=order + 1)
        case t.Cross(left=left, right=right) | t.Outer(left=left, right=right) | t.Compose(left=left, right=right):
            yield "operands", type(node)(right, left)
        case t.Quotient() | t.Power() | t.Root() | t.Transpose():
            yield from _of_operation(node)
        case t.Varied(of=of):
            yield "variation", of
        case _:
            yield from _of_range(node)


def exchanges(node: t.Node, scope: str) -> Iterator[Change]:
    """A symbol exchanged for others of its type, nearest first."""
    if isinstance(node, t.Name | t.Call):
        mine = conventions_of(scope).declared(node.name, node.index)
        for other in ranked(node.name, scope, node.index):
            yield difference(mine, other), replace(node, name=other.name)


def _of_index(node: t.Name | t.Call, letters: Scope) -> Iterator[Change]:
    """Another index: the next letter of its alphabet, and a number."""
    if not node.index:
        return
    alphabet = LATIN if node.index in LATIN else GREEK
    letter = alphabet[(alphabet.index(node.index) + 1) % len(alphabet)]
    if (node.name, letter) in letters.by_letter:
        yield "index", replace(node, index=letter)
    member = f"{node.name}_{t.values_of(node.index)[0]}"
    if member in letters.by_name:
        yield "index", replace(node, name=member, index="")


def _of_call(node: t.Call, letters: Scope) -> Iterator[Change]:
    mine = letters.declared(node.name, node.index)
    yield from _of_index(node, letters)
    if node.primes:
        yield "prime", replace(node, primes=node.primes - 1)
    if (node.name, node.primes + 1) in primed(t.Call):
        yield "prime", replace(node, primes=node.primes + 1)
    if mine.argument and len(node.args) == 1:
        arcs = [t.Name(one.name, one.kind) for one in letters.by_name.values() if one.sort == mine.argument]
        for arc in [*arcs[:2], t.Number(0)]:
            if arc not in node.args:
                yield "argument", replace(node, args=(arc,))


def _of_row(node: t.Sum | t.Product | t.Signed) -> Iterator[Change]:
    """Signs, terms, factors."""
    match node:
        case t.Signed(sign=sign, of=of):
            yield "sign", of
            if sign in OTHER_SIGN:
                yield "sign", replace(node, sign=OTHER_SIGN[sign])
        case t.Sum(terms=terms):
            for n, term in enumerate(terms):
                if not isinstance(term, t.BigO):
                    yield "sign", t.Sum((*terms[:n], turned(term), *terms[n + 1 :]))
                rest = (*terms[:n], *terms[n + 1 :])
                yield "term", rest[0] if len(rest) == 1 else t.Sum(rest)
        case t.Product(factors=factors):
            for n, factor in enumerate(factors):
                rest = (*factors[:n], *factors[n + 1 :])
                if factor.type == t.SCALAR:
                    yield "factor", rest[0] if len(rest) == 1 else t.Product(rest)


def _of_operation(node: t.Node) -> Iterator[Change]:
    match node:
        case t.Quotient(above=above, below=below):
            yield "factor", above
            if above.type == t.SCALAR and above != t.Number(1):
                yield "operands", t.Quotient(below, above)
        case t.Power(base=base) if base.type == t.SCALAR:
            yield "power", base
        case t.Power(base=base) if base.type == t.TENSOR:
            yield "inverse", base
        case t.Root(of=of):
            yield "root", of
        case t.Transpose(of=of):
            yield "transpose", of


def _of_range(node: t.Node) -> Iterator[Change]:
    """Bounds, orders, rows, cases, relations."""
    match node:
        case t.Integral(lower=lower, upper=upper) | t.Between(lower=lower, upper=upper) if lower and upper:
            yield "bounds", replace(node, lower=upper, upper=lower)
        case t.Interval(lower=lower, upper=upper):
            yield "bounds", replace(node, lower=upper, upper=lower)
            yield from (("bounds", one) for one in _opened(node))
        case t.BigO(of=of):
            yield "order", replace(node, of=_higher(of))
        case t.Maximum(of=of) if len(of) > 1:
            yield from (("term", replace(node, of=(*of[:n], *of[n + 1 :]))) for n in range(len(of)))
        case t.Stack(rows=rows):
            yield "rows", t.Stack(rows[::-1])
        case t.Listing(items=items) if len(items) > 1 and items[0].type != t.INDEX:
            yield "rows", t.Listing((*items[1:], items[0]))
        case t.Cases(values=values):
            for n in range(len(values) - 1):
                swapped = (*values[:n], values[n + 1], values[n], *values[n + 2 :])
                yield "cases", replace(node, values=swapped)
        case t.Condition(operators=operators):
            for n, operator in enumerate(operators):
                if operator in TURNED:
                    turned_ = (*operators[:n], TURNED[operator], *operators[n + 1 :])
                    yield "relation", replace(node, operators=turned_)


def _opened(node: t.Interval) -> Iterator[t.Interval]:
    """The interval without one of the ends that it has: that says more of what is in it."""
    if not node.left_open:
        yield replace(node, left_open=True)
    if not node.right_open:
        yield replace(node, right_open=True)


def _higher(of: t.Node) -> t.Node:
    """The next power of what is small."""
    if isinstance(of, t.Power) and isinstance(of.exponent, t.Number):
        return replace(of, exponent=t.Number(of.exponent.value + 1))
    return t.Power(of, t.Number(2))


def turned(term: t.Node) -> t.Node:
    """A term with the other sign."""
    if isinstance(term, t.Signed) and term.sign in OTHER_SIGN:
        return replace(term, sign=OTHER_SIGN[term.sign])
    return term.of if isinstance(term, t.Signed) and term.sign == "-" else t.Signed("-", term)
