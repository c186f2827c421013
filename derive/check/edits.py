"""Small edits of a printed formula that may undo a misprint; nothing here knows what this article misprints.

The order in which edits are tried: those of a first side that is a symbol last, for it names what is said to equal the
others; then by kind, the likeliest misprints first; of a kind, exchanged symbols by their likeness; then those that
give a part as the article prints it elsewhere; then those of other sides than the first; then in printed order.
Exchanged operands of × come even before signs if the article prints the product more often the other way round: −a × b
and b × a say the same.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from functools import cache
from itertools import chain

from derive.check.changes import Path, at, exchanges, own_changes, positions, put, turned
from derive.check.elsewhere import printed_parts
from derive.check.misprints import relations, with_side
from derive.paper import tree as t
from derive.paper.conventions import Declared, Scope
from derive.paper.conventions import scope as conventions_of

# From the likeliest misprint on.
KINDS = (
    "order of factors", "sign", "argument", "bar", "prime", "index", "symbol", "number", "coefficient", "relation",
    "power", "root", "operands", "transpose", "inverse", "variation", "bounds", "rows", "cases", "factor",
    "term", "either sign", "missing factor", "missing term", "order",
)  # fmt: skip
NUMBERS = tuple(map(t.Number, (2, 3, 4)))  # that may be missing as factors
ZERO, TWICE = t.Number(0), NUMBERS[0]
LINEAR = (t.Product, t.Dot, t.Cross, t.Outer, t.Apply, t.Compose, t.Norm)  # a factor of a part is one of the whole


@dataclass(frozen=True)
class Edit:
    """A new node for an old one at a place of a side, or other relations (side −1); kind: what was changed."""

    kind: str
    side: int
    path: Path
    old: t.Node
    new: t.Node
    likeness: int = 0
    operators: tuple[str, ...] = ()

    def of(self, statement: t.Statement) -> t.Statement:
        """The edited statement; what was edited before within the old node is edited in the new one."""
        if self.operators:
            return replace(statement, operators=self.operators)
        side = statement.sides[self.side]
        new = _transplanted(self.old, at(side, self.path), self.new)
        return with_side(statement, self.side, put(side, self.path, new))


def _transplanted(old: t.Node, now: t.Node, new: t.Node) -> t.Node:
    """``new`` was made of ``old``, which has become ``now`` by a change in one place: make that change in ``new``."""
    if old == now:
        return new
    if len(old.parts()) == len(now.parts()) and type(old) is type(now):
        differing = [(a, b) for a, b in zip(old.parts(), now.parts(), strict=True) if a != b]
        if len(differing) == 1:
            before, after = differing[0]
            place = next((path for path, node in positions(new) if node == before), None)
            return _transplanted(before, after, new) if place is None else put(new, place, after)
    return new


def edits(statement: t.Statement, scope: str, sides: set[int] | None = None) -> list[Edit]:
    """The edits of the sides (of all, if None), likeliest first, without repetition and without tautologies."""
    found: dict[t.Statement, Edit] = {}
    chosen = sides if sides is not None else range(len(statement.sides))
    turned_ = (Edit("relation", -1, (), ZERO, ZERO, 0, operators) for operators in relations(statement))
    for edit in chain(turned_, *(_of_side(statement, n, scope) for n in chosen)):
        edited = edit.of(statement)
        if edited != statement and not _empty(edited):
            found.setdefault(edited, edit)
    named = isinstance(statement.sides[0], t.Name | t.Call | t.Primed)
    return sorted(found.values(), key=lambda edit: (named and edit.side == 0, *_rank(edit)))


def _rank(edit: Edit) -> tuple[int, ...]:
    return KINDS.index(edit.kind), edit.likeness, edit.new not in printed_parts(), edit.side == 0


def _empty(statement: t.Statement) -> bool:
    """Is a side said to equal one that reads the same, so that nothing is said?"""
    seen: list[t.Node] = []
    for side, operator in zip(statement.sides, ("", *statement.operators), strict=True):
        seen = seen if operator == "=" else []
        if side in seen:
            return True
        seen.append(side)
    return False


def _of_side(statement: t.Statement, n: int, scope: str) -> Iterator[Edit]:
    side = statement.sides[n]
    above: dict[Path, t.Node] = {}
    for path, node in positions(side):
        above[path] = node
        for kind, new in own_changes(node, scope):
            yield Edit(_kind(kind, node, new), n, path, node, new)
        for likeness, (kind, new) in enumerate(exchanges(node, scope)):
            yield Edit(kind, n, path, node, new, likeness)
        longer = () if path and isinstance(above[path[:-1]], LINEAR) else _longer(node, scope)
        for kind, new in (*_restored(node, conventions_of(scope)), *longer):
            yield Edit(kind, n, path, node, new)
    plain = side.type in (t.SCALAR, t.VECTOR, t.TENSOR) and not isinstance(side, t.Signed)
    if plain and side != ZERO:
        yield Edit("sign", n, (), side, t.Signed("-", side))
        if n and side.type == t.SCALAR and not isinstance(side, t.Sum):
            yield Edit("either sign", n, (), side, t.Signed(r"\pm", side))


def _kind(kind: str, node: t.Node, new: t.Node) -> str:
    """Exchanged operands are likeliest where the article prints the product more often the other way round."""
    ordered = kind == "operands" and isinstance(node, t.Cross | t.Outer | t.Compose)
    if ordered and printed_parts()[new] > printed_parts()[node]:
        return "order of factors"
    return kind


def _restored(node: t.Node, letters: Scope) -> Iterator[tuple[str, t.Node]]:
    """Arguments and squares that may have been left out, other numbers and other bounds."""
    match node:
        case t.Name():
            yield from _of_name(node, letters)
        case t.Call():
            yield from _of_call(node, letters)
        case t.Number(value=value):
            yield from (("number", t.Number(new)) for new in (value - 1, 2 * value, value // 2) if 0 < new != value)
        case t.Integral() | t.Between() if node.lower is not None and node.upper is not None:
            ends = [ZERO, *(t.Name(one.name) for one in letters.by_name.values() if one.sort == "arc")]
            yield from (("bounds", replace(node, lower=end)) for end in ends if end != node.lower)
            yield from (("bounds", replace(node, upper=end)) for end in ends if end != node.upper)


def _of_name(node: t.Name, letters: Scope) -> Iterator[tuple[str, t.Node]]:
    mine = letters.declared(node.name, node.index)
    if mine.argument:
        for arc in _arcs(mine, letters):
            yield "argument", t.Call(node.name, (arc,), 0, node.kind, node.index)
    if node.type == t.SCALAR:
        yield "power", t.Power(node, TWICE)
    if node.index:
        members = (f"{node.name}_{value}" for value in t.LATIN)
        yield from (("index", replace(node, name=name, index="")) for name in members if name in letters.by_name)
        letters_ = (letter for name, letter in letters.by_letter if name == node.name)
        yield from (("index", replace(node, index=letter)) for letter in letters_)


def _of_call(node: t.Call, letters: Scope) -> Iterator[tuple[str, t.Node]]:
    mine = letters.declared(node.name, node.index)
    if mine.argument:
        yield "argument", t.Name(node.name, node.kind, node.index)
        yield from (("argument", replace(node, args=(arc,))) for arc in _arcs(mine, letters))
    if node.type == t.SCALAR:
        yield "power", t.Power(node, TWICE)


def _arcs(mine: Declared, letters: Scope) -> Iterator[t.Node]:
    """What may stand as the argument of a symbol."""
    for other in letters.by_name.values():
        if other.sort == mine.argument:
            yield t.Name(other.name, other.kind)


def _longer(node: t.Node, scope: str) -> Iterator[tuple[str, t.Node]]:
    """A factor or a term more."""
    if node.type not in (t.SCALAR, t.VECTOR, t.TENSOR) or isinstance(node, t.Signed | t.Number | t.BigO):
        return
    names = constants(scope)
    for number in NUMBERS:
        yield "coefficient", _times(number, node)
        yield "coefficient", t.Quotient(node, number)
    yield from (("missing factor", _times(factor, node)) for factor in names)
    if isinstance(node, t.Sum) and node.type == t.SCALAR:
        for term in (t.Number(1), *names, *(t.Product((TWICE, name)) for name in names)):
            yield from (("missing term", t.Sum((*node.terms, signed))) for signed in (term, turned(term)))


def _times(factor: t.Node, node: t.Node) -> t.Node:
    """The product; of numbers there is one, and it stands first."""
    factors = node.factors if isinstance(node, t.Product) else (node,)
    if not isinstance(factors[0], t.Number):
        return t.Product((factor, *factors))
    if isinstance(factor, t.Number):
        return t.Product((t.Number(factor.value * factors[0].value), *factors[1:]))
    return t.Product((factors[0], factor, *factors[1:]))


@cache
def constants(scope: str) -> tuple[t.Name, ...]:
    """The scalars that may be missing as factors or terms."""
    declared = conventions_of(scope).by_name.values()
    return tuple(t.Name(one.name) for one in declared if one.kind == "scalar" and not one.sort and not one.argument)
