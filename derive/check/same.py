"""Does a changed statement say the same as the original? Proved side by side, in every reading, or not at all."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import Any

from sympy import Integer, MatrixBase

from derive.check.asserted import limit_of
from derive.check.branches import Branch, branches, index_values, mapped
from derive.check.judge import judge
from derive.check.meaning import Components, pm
from derive.check.readings import readings
from derive.check.relations import orders
from derive.check.verdicts import PROVED
from derive.paper import tree as t
from derive.paper.symbolic import Indices
from derive.theory.claims import Claim, Equal, Limit, Order

SECONDS = 10.0  # for one claim
FLIPPED = {r"\pm": r"\mp", r"\mp": r"\pm"}


class _OtherFormError(Exception):
    """The two statements have not the same relations, conditions or orders."""


def same_meaning(
    theory: Any, scope: str, original: t.Statement, mutant: t.Statement, given: tuple[t.Statement, ...] = ()
) -> bool:
    """Is the mutant proved to say what the original says?

    Row by row, case by case and side by side; where an order of magnitude is stated, up to that order. Equations with
    ± say the same with all signs turned: −A = ∓B is A = ±B, whichever of the signs holds.
    """
    if _same_sides(theory, scope, original, mutant, given):
        return True
    signed = any(isinstance(node, t.Signed) and node.sign in FLIPPED for side in original.sides for node in side.walk())
    equal = set(original.operators) == {"="}
    return signed and equal and _same_sides(theory, scope, original, _turned(mutant), given)


def _turned(statement: t.Statement) -> t.Statement:
    """−A = ∓B for A = ±B."""

    def flip(node: t.Node) -> t.Node:
        return replace(node, sign=FLIPPED[node.sign]) if isinstance(node, t.Signed) and node.sign in FLIPPED else node

    flipped = mapped(statement, flip)
    return replace(flipped, sides=tuple(t.Signed("-", side) for side in flipped.sides))


def _same_sides(
    theory: Any, scope: str, original: t.Statement, mutant: t.Statement, given: tuple[t.Statement, ...]
) -> bool:
    try:
        pairs = zip(branches(original), branches(mutant), strict=True)
        return all(_holds(claim) for one, other in pairs for claim in _claims(theory, scope, one, other, given))
    except (_OtherFormError, ValueError, ArithmeticError):
        return False


def _holds(claim: Claim) -> bool:
    return judge(claim, SECONDS).verdict == PROVED


def _claims(theory: Any, scope: str, one: Branch, other: Branch, given: tuple[t.Statement, ...]) -> Iterator[Claim]:
    """What must hold for two plain statements to say the same."""
    left, right = one.statement, other.statement
    if (left.operators, one.given, left.where) != (right.operators, other.given, right.where):
        raise _OtherFormError
    given = (*given, *one.given)
    both = t.Statement(left.sides + right.sides, left.operators, left.where)
    for reading in readings(theory, scope, both.sides, given):
        for indices in index_values(both):
            for n, (a, b) in enumerate(zip(left.sides, right.sides, strict=True)):
                if a != b and _read(left, n, reading):
                    power = _order(left, n, reading, indices)
                    if power != _order(right, n, reading, indices):
                        raise _OtherFormError
                    sides = reading.of(a, indices), reading.of(b, indices)
                    tends = left.operators[n : n + 1] == ("->",)
                    relation = _tends(*sides, reading, given) if tends else _same(*sides, power, reading)
                    yield Claim("same", "the same side", relation, reading.domain, reading.hypotheses)


def _read(statement: t.Statement, n: int, reading: Components) -> bool:
    """Is a relation beside a side read in the reading?"""
    beside = (k for k in (n - 1, n) if 0 <= k < len(statement.operators))
    return any(reading.reads(*statement.sides[k : k + 2]) for k in beside)


def _order(statement: t.Statement, n: int, reading: Components, indices: Indices) -> int | None:
    """Up to which order a side is stated; None if exactly."""
    beside = [k for k in (n - 1, n) if 0 <= k < len(statement.operators)]
    found = [orders(statement.sides[k : k + 2], reading, indices) for k in beside]
    return min(min(some) for some in found) if all(found) else None


def _same(left: Any, right: Any, power: int | None, reading: Components) -> Any:
    """Equal, up to an order if there is one; of sides with ±, that both stand for the same two values."""
    if power is not None and reading.small is not None:
        return Order(left - right, reading.small, power)
    if not isinstance(left, MatrixBase) and left.has(pm) and right.has(pm):
        upper = left.subs(pm, 1)
        return Equal((upper - right.subs(pm, 1)) * (upper - right.subs(pm, -1)), 0)
    return Equal(left, right)


def _tends(left: Any, right: Any, reading: Components, given: tuple[t.Statement, ...]) -> Limit:
    """Left of an arrow only the limit counts."""
    variable, point, side = limit_of(reading, given)
    return Limit(left - right, variable, point, Integer(0), side)
