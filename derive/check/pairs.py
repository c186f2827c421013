"""Pairs of edits that may mend a statement, found without trying all pairs.

At a point, each edit changes the difference of two sides by some amount. Edits of separate terms change it by the sum
of theirs; of edits of one term each multiplies the term, mostly. So for each edit it is known what the other must
bring, and that is looked up among all edits. What is found is only likely: it has to be tried.
"""

from __future__ import annotations

import random
from bisect import bisect_left
from collections import Counter
from collections.abc import Iterator, Sequence
from typing import Any

from mpmath import mp
from sympy import Rational

from derive.check.bench import DIGITS, Bench
from derive.check.changes import Path, positions, put
from derive.check.components import each, flat
from derive.check.edits import KINDS, Edit
from derive.check.misprints import with_side
from derive.check.values import Indices, Place
from derive.paper import tree as t

CLOSE = mp.mpf(10) ** -9  # of the difference to be undone: how far amounts may miss it
SMALL = Rational(1, 10**20)  # a small parameter, so small that only the leading orders count
NONSENSE = (ValueError, ArithmeticError, LookupError, TypeError, NotImplementedError)  # from a bad edit


def pairs(bench: Bench, statement: t.Statement, once: Sequence[Edit]) -> list[tuple[Edit, Edit]]:
    """Pairs of edits that undo the difference of two sides at a point, and the inner edit of each first.

    First come those that do so for the most relations that are wrong, in the most readings; of these, the likeliest.
    """
    wrong = [
        _Amounts(statement, n, place, indices, once)
        for n, operator in enumerate(statement.operators)
        if operator == "="
        for place, indices in bench.wrong(statement, n)
    ]
    found = Counter(pair for amounts in wrong for pair in dict.fromkeys(amounts.pairs()))
    for pair in found:
        found[pair] += sum(amounts.undone_by_one(pair) for amounts in wrong)
    chosen = sorted(found, key=lambda pair: (-found[pair], sum(KINDS.index(once[k].kind) for k in pair)))
    return [_inner_first(once[a], once[b]) for a, b in chosen]


def _inner_first(one: Edit, other: Edit) -> tuple[Edit, Edit]:
    return (one, other) if len(one.path) >= len(other.path) else (other, one)


class _Amounts:
    """What edits do to the difference of the sides n and n + 1 at a point, weighed to one number."""

    def __init__(self, statement: t.Statement, n: int, place: Place, indices: Indices, once: Sequence[Edit]) -> None:
        self.statement, self.n, self.once = statement, n, once
        sides = statement.sides[n : n + 2]
        small = place.reading.within is not None or any(isinstance(x, t.BigO) for side in sides for x in side.walk())
        self.values = place.values(3 * DIGITS, 1, SMALL) if small else place.values(DIGITS)
        self.indices = indices
        self.weights = [mp.mpf(x) for x in random.Random(5).sample(range(1000, 9999), 9)]
        self.gap = self._gap(statement)
        self.amounts: dict[int, Any] = {}
        for number, edit in enumerate(once):
            amount = self._amount(edit.of(statement)) if edit.side in (n, n + 1) else None
            if amount is not None:
                self.amounts[number] = amount

    def _gap(self, statement: t.Statement) -> Any:
        left, right = (self.values.of(side, self.indices) for side in statement.sides[self.n : self.n + 2])
        with mp.workdps(self.values.digits):
            gaps = flat(each(lambda a, b: a - b, left, right))
            return mp.fsum(weight * gap for weight, gap in zip(self.weights, gaps, strict=False))

    def _amount(self, changed: t.Statement) -> Any:
        try:
            with mp.workdps(self.values.digits):
                return self._gap(changed) - self.gap
        except NONSENSE:
            return None

    def undone_by_one(self, pair: tuple[int, int]) -> bool:
        """Does one edit of a pair undo the difference, and the other leave it alone?"""
        inside = [self.amounts[k] for k in pair if k in self.amounts]
        return len(inside) == 1 and abs(inside[0] + self.gap) <= CLOSE * abs(self.gap)

    def pairs(self) -> Iterator[tuple[int, int]]:
        """Numbers of edits that together undo the difference."""
        with mp.workdps(self.values.digits):
            yield from self._pairs()

    def _pairs(self) -> Iterator[tuple[int, int]]:
        close = CLOSE * abs(self.gap)
        yield from _matching(self.amounts, lambda amount: -self.gap - amount, close)
        for side, path, dropped in self._terms():
            size = -dropped
            if size == 0:
                continue
            inside = {
                k: 1 + amount / size
                for k, amount in self.amounts.items()
                if self.once[k].side == side and self.once[k].path[: len(path)] == path
            }
            wanted = 1 - self.gap / size
            ratios = {k: ratio for k, ratio in inside.items() if ratio != 0}
            yield from _matching(ratios, lambda ratio, wanted=wanted: wanted / ratio, close / abs(size))

    def _terms(self) -> Iterator[tuple[int, Path, Any]]:
        """Whole sides and terms of sums, with what the difference loses when they are 0."""
        for n in (self.n, self.n + 1):
            side = self.statement.sides[n]
            for path, node in positions(side):
                if isinstance(node, t.Sum):
                    for k in range(len(node.terms)):
                        without = with_side(self.statement, n, put(side, path, _without(node, k)))
                        lost = self._amount(without)
                        if lost is not None:
                            yield n, (*path, k), lost
            lost = self._lost(n, side)
            if lost is not None:
                yield n, (), lost

    def _lost(self, n: int, side: t.Node) -> Any:
        """What the difference loses without a side."""
        whole = flat(self.values.of(side, self.indices))
        sign = -1 if n == self.n else 1
        with mp.workdps(self.values.digits):
            return sign * mp.fsum(weight * x for weight, x in zip(self.weights, whole, strict=False))


def _matching(known: dict[int, Any], wanted: Any, close: Any) -> Iterator[tuple[int, int]]:
    """Pairs of keys where the second value is, closely, what the first wants."""
    real = {k: mp.re(value) for k, value in known.items()}
    order = sorted(real, key=lambda k: real[k])
    values = [real[k] for k in order]
    for k, value in known.items():
        target = mp.re(wanted(value))
        start = bisect_left(values, target - close)
        while start < len(order) and values[start] <= target + close:
            if order[start] > k:
                yield k, order[start]
            start += 1


def _without(node: t.Sum, k: int) -> t.Node:
    rest = (*node.terms[:k], *node.terms[k + 1 :])
    return rest[0] if len(rest) == 1 else t.Sum(rest)
