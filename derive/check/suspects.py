"""Which sides of a chain are wrong: those that disagree with the most."""

from __future__ import annotations

from derive.check.bench import Bench
from derive.paper import tree as t


def suspects(bench: Bench, statement: t.Statement) -> set[int]:
    """The sides outside the largest group that agree with each other, at the points of a bench; all, if none do."""
    count = len(statement.sides)
    every = set(range(count))
    if count < 3 or set(statement.operators) != {"="}:
        return every
    group = list(range(count))
    for one in range(count):
        for other in range(one):
            if _agree(bench, statement, one, other):
                group = [group[other] if g == group[one] else g for g in group]
    largest = max(group.count(g) for g in group)
    if largest == 1:
        return every
    sound = next(g for g in group if group.count(g) == largest)
    return {n for n in every if group[n] != sound} or every


def _agree(bench: Bench, statement: t.Statement, one: int, other: int) -> bool:
    pair = t.Statement((statement.sides[other], statement.sides[one]), ("=",), statement.where)
    try:
        return bench.counterexample(pair) is None
    except (ValueError, ArithmeticError, LookupError, TypeError, NotImplementedError):  # without meaning is not agreed
        return False
