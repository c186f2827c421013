"""Small edits of a printed formula that may undo a misprint; nothing here knows what this article misprints."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from derive.check.misprints import own_changes, turned, variants
from derive.paper import tree as t
from derive.paper.conventions import Declared, Scope
from derive.paper.conventions import scope as conventions_of

# From the likeliest misprint on; edits of a kind stand in printed order.
KINDS = (
    "sign", "argument", "prime", "bar or index", "symbol", "number", "relation", "power", "root", "operands", "factor", "term",
    "either sign", "missing factor", "missing term",
)  # fmt: skip
FACTORS = ("beta", "eta", "gamma", "xi")  # letters that may be missing as factors or terms
NUMBERS = tuple(map(t.Number, (2, 3, 4)))  # that may be missing as factors
TWICE = NUMBERS[0]
EITHER = {r"\pm": r"\mp", r"\mp": r"\pm"}


def edits(statement: t.Statement, scope: str) -> list[tuple[str, t.Statement]]:
    """All statements that one edit makes of this one, likeliest first, without repetition and without tautologies.

    The first side names what is said to equal the others, so that an edit of the others comes before one of it.
    """
    letters = conventions_of(scope)
    found: dict[t.Statement, str] = {}
    for kind, edited in (*variants(statement, lambda node: _own(node, letters)), *_either_sign(statement)):
        if edited != statement and not _empty(edited):
            found.setdefault(edited, kind)
    first = statement.sides[0]
    return sorted(
        ((kind, edited) for edited, kind in found.items()),
        key=lambda pair: (KINDS.index(pair[0]), pair[1].sides[0] != first),
    )


def _either_sign(statement: t.Statement) -> Iterator[tuple[str, t.Statement]]:
    sides = statement.sides
    for n, side in reversed(list(enumerate(sides))):  # a chain runs from what is named to what it comes to
        if n and side.type == t.SCALAR and not isinstance(side, t.Signed | t.Sum) and side != t.Number(0):
            new = (*sides[:n], t.Signed(r"\pm", side), *sides[n + 1 :])
            yield "either sign", replace(statement, sides=new)


def _empty(statement: t.Statement) -> bool:
    """Is a side said to equal one that reads the same, so that nothing is said?"""
    seen: list[t.Node] = []
    for side, operator in zip(statement.sides, ("", *statement.operators), strict=True):
        seen = seen if operator == "=" else []
        if side in seen:
            return True
        seen.append(side)
    return False


def _own(node: t.Node, letters: Scope) -> Iterator[tuple[str, t.Node]]:
    yield from own_changes(node, set(letters.by_name))
    match node:
        case t.Name():
            yield from _of_name(node, letters)
        case t.Call():
            yield from _of_call(node, letters)
        case t.Number(value=value):
            yield from (("number", t.Number(new)) for new in (value - 1, 2 * value, value // 2) if 0 < new != value)
        case t.Primed(of=of, order=order):
            yield "prime", t.Primed(of, order + 1)
        case t.Quotient(above=above, below=below) if above.type == t.SCALAR:
            yield "operands", t.Quotient(below, above)
        case t.Signed(sign=sign) if sign in EITHER:
            yield "sign", replace(node, sign=EITHER[sign])
        case t.Cross(left=left, right=right):
            yield "operands", t.Cross(right, left)
    if node.type == t.SCALAR and not isinstance(node, t.Signed | t.Number):
        yield from _longer(node, letters)


def _of_name(node: t.Name, letters: Scope) -> Iterator[tuple[str, t.Node]]:
    mine = letters.by_name[node.name]
    for other in letters.by_name.values():
        if other.kind == mine.kind and other.name != mine.name and other.kind != "function":
            alike = other.name.split("_")[0] == mine.name.split("_")[0]
            yield "bar or index" if alike else "symbol", replace(node, name=other.name)
    if mine.argument:
        yield from (("argument", t.Call(node.name, (arc,), 0, node.kind)) for arc in _arcs(mine, letters))
        yield "prime", t.Primed(node, 1)
    if node.type == t.SCALAR:
        yield "power", t.Power(node, TWICE)


def _of_call(node: t.Call, letters: Scope) -> Iterator[tuple[str, t.Node]]:
    mine = letters.by_name[node.name]
    if mine.argument:
        yield "argument", t.Name(node.name, node.kind)
        yield from (("argument", replace(node, args=(arc,))) for arc in _arcs(mine, letters))
    for other in letters.by_name.values():
        if other.kind == mine.kind == "function" and other.arity == mine.arity and other.name != mine.name:
            yield "symbol", replace(node, name=other.name)
    if mine.kind == "function" and not mine.prefix:
        yield "prime", replace(node, primes=node.primes + 1)
    yield "power", t.Power(node, TWICE)


def _arcs(mine: Declared, letters: Scope) -> Iterator[t.Node]:
    """What may stand as the argument of a symbol."""
    for other in letters.by_name.values():
        if other.sort == mine.argument:
            yield t.Name(other.name, other.kind)


def _longer(node: t.Node, letters: Scope) -> Iterator[tuple[str, t.Node]]:
    """A factor or a term more."""
    names = [t.Name(name) for name in FACTORS if name in letters.by_name]
    factors = node.factors if isinstance(node, t.Product) else (node,)
    if not isinstance(factors[0], t.Number):
        yield from (("missing factor", t.Product((number, *factors))) for number in NUMBERS)
    yield from (("missing factor", t.Quotient(node, number)) for number in NUMBERS)
    yield from (("missing factor", t.Product((*factors[:-1], name, factors[-1]))) for name in names)
    if isinstance(node, t.Sum):
        for term in (t.Number(1), *names, *(t.Product((TWICE, name)) for name in names)):
            yield "missing term", t.Sum((*node.terms, term))
            yield "missing term", t.Sum((*node.terms, turned(term)))
