"""Counterexamples to variants of one statement, found cheaply: two points, and only what was changed is computed.

The points lie in the domains of the readings, as those of ``refute``; a counterexample is seen at some digits, and
again at twice as many. What finds none here has still to be judged: nothing is proved. Arrows are left to the judge.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import suppress
from typing import Any

from mpmath import mp
from sympy import Rational

from derive.check import growth
from derive.check.branches import Branch, branches, index_values
from derive.check.components import each, flat
from derive.check.evaluate import GUARD, UndefinedError
from derive.check.meaning import Components, pm
from derive.check.readings import readings
from derive.check.refute import SAME
from derive.check.relations import orders_in
from derive.check.sample import Sampler
from derive.check.values import Indices, Place, Values
from derive.paper import tree as t

DIGITS = 30
POINTS = 2
TRIES = 8  # points drawn, at most, to have POINTS with values
TOLERANCE = mp.mpf(10) ** -18  # relative difference that counts as none
SMALL = (8, 14)  # orders of magnitude are measured between 10⁻⁸ and 10⁻¹⁴
SLACK = 0.2  # how far a measured order may fall short
SIGNS = {"<": -1, ">": 1, "<=": -1, ">=": 1}

Counterexample = dict[str, str]


class Bench:
    """Where variants of the statements of one formula are tried.

    Readings are kept for all statements with the same symbols, applied functions and kinds of operation.
    """

    def __init__(self, theory: Any, scope: str, given: tuple[t.Statement, ...]) -> None:
        self.theory, self.scope, self.given = theory, scope, given
        self._places: dict[Any, list[list[Place]]] = {}
        self._of_reading: dict[int, list[Place]] = {}

    def counterexample(self, statement: t.Statement) -> Counterexample | None:
        """A point at which the statement fails, or None. ValueError where it has no meaning."""
        for branch in branches(statement):
            for places in self._of(branch):
                for indices in index_values(branch.statement):
                    here = tuple(sorted(indices.items()))
                    found = self._at(branch.statement, [p for p in places if _applies(p, branch, here)], here)
                    if found:
                        return found
        return None

    def wrong(self, statement: t.Statement, n: int) -> Iterator[tuple[Place, Indices]]:
        """A point where the n-th relation of a statement fails, with the indices; none of stacks, cases, lists."""
        found = branches(statement)
        for places in self._of(found[0]) if len(found) == 1 else ():
            for indices in index_values(statement):
                here = tuple(sorted(indices.items()))
                for place in places[:POINTS]:
                    with suppress(UndefinedError):
                        if _fails(place, statement.operators[n], statement.sides[n : n + 2], here):
                            yield place, here
                            return

    def _of(self, branch: Branch) -> list[list[Place]]:
        """The places of each reading of a branch."""
        sides, given = branch.statement.sides, (*self.given, *branch.given)
        key = (_vocabulary(sides), given)
        if key not in self._places:
            found = readings(self.theory, self.scope, sides, given)
            self._places[key] = [self._in(reading) for reading in found]
        return self._places[key]

    def _in(self, reading: Components) -> list[Place]:
        """The places of a reading; one that a section gives for several statements keeps its own."""
        if id(reading) not in self._of_reading:  # its places hold the reading, so that no other has its id
            self._of_reading[id(reading)] = list(_places(reading))
        return self._of_reading[id(reading)]

    def _at(self, statement: t.Statement, places: list[Place], indices: Indices) -> Counterexample | None:
        done = 0
        for place in places:
            try:
                for n, operator in enumerate(statement.operators):
                    found = _fails(place, operator, statement.sides[n : n + 2], indices)
                    if found:
                        return found
            except UndefinedError:
                continue
            done += 1
            if done == POINTS:
                break
        return None


def _applies(place: Place, branch: Branch, indices: Indices) -> bool:
    """Does nothing that a case assumes fail at the point?"""
    for given in branch.given:
        for n, operator in enumerate(given.operators):
            if operator != "->" and _fails(place, operator, given.sides[n : n + 2], indices):
                return False
    return True


def _vocabulary(sides: tuple[t.Node, ...]) -> frozenset[Any]:
    """The symbols, applied functions and kinds of operation in the sides: what readings may depend on."""
    nodes = [node for side in sides for node in side.walk()]
    return frozenset(node if isinstance(node, t.Name | t.Call) else type(node) for node in nodes)


def _places(reading: Components) -> Iterator[Place]:
    sampler = Sampler([], reading.domain, reading.hypotheses, seed=3)
    symbolic: dict[Any, Any] = {}
    for point in sampler.points(TRIES):
        yield Place(reading, sampler, point, symbolic)


def _fails(place: Place, operator: str, sides: tuple[t.Node, ...], indices: Indices) -> Counterexample | None:
    """A counterexample to one relation at one point, if it is read there."""
    if not place.reading.reads(*sides):
        return None
    if operator == "=":
        orders = orders_in(sides)
        compared = orders or place.reading.within is not None
        return _order_fails(place, sides, orders, indices) if compared else _differ(place, sides, indices)
    return _unordered(place, SIGNS[operator], sides, indices) if operator in SIGNS else None


def _differ(place: Place, sides: tuple[t.Node, ...], indices: Indices) -> Counterexample | None:
    """With ± on a side, one choice of the sign must make them equal; a vector has one sign for all its components."""
    signs = (1, -1) if _has_sign(place, sides, indices) else (1,)
    if place.grows(sides, indices):
        return growth.differ(place, sides, indices, signs, DIGITS)
    found = None
    for sign in signs:
        gap, size = _gap(place.values(DIGITS, sign), sides, indices)
        if gap <= TOLERANCE * size:
            return None
        again, _ = _gap(place.values(2 * DIGITS, sign), sides, indices)
        if abs(again - gap) > SAME * again:
            return None
        found = _shown(place.values(DIGITS, sign), sides, indices)
    return found


def _has_sign(place: Place, sides: tuple[t.Node, ...], indices: Indices) -> bool:
    for side in sides:
        place.values(DIGITS).of(side, indices)
    printed = any(isinstance(node, t.Signed) and node.sign not in "+-" for side in sides for node in side.walk())
    return printed or any(value.has(pm) for value in place.symbolic.values())


def _gap(values: Values, sides: tuple[t.Node, ...], indices: Indices) -> tuple[Any, Any]:
    """The largest difference of the components of two sides, and the scale of their values."""
    left, right = (values.of(side, indices) for side in sides)
    with mp.workdps(values.digits + GUARD):
        gaps = flat(each(lambda a, b: abs(a - b), left, right))
        return max(gaps), max(values.size(side, indices) for side in sides)


def _order_fails(
    place: Place, sides: tuple[t.Node, ...], orders: list[t.BigO], indices: Indices
) -> Counterexample | None:
    """A counterexample if the difference falls more slowly than the order says."""
    if place.reading.small is None:
        return None
    sizes = []
    for step in SMALL:
        values = place.values(2 * DIGITS + 2 * step, 1, Rational(1, 10**step))
        gap, size = _gap(values, sides, indices)
        if gap <= size * mp.mpf(10) ** (-2 * DIGITS):
            return None
        powers = [_exponent(values, node, indices, step) for node in orders]
        power = min([*powers, *([] if place.reading.within is None else [place.reading.within])])
        sizes.append(gap)
    measured = mp.log10(sizes[0] / sizes[1]) / (SMALL[1] - SMALL[0])
    if measured >= power - SLACK:
        return None
    return {**_shown(values, sides, indices), "order": mp.nstr(measured, 5)}


def _exponent(values: Values, node: t.BigO, indices: Indices, step: int) -> Any:
    """The power of the small parameter in O(…)."""
    return -mp.log10(abs(values.of(node.of, indices))) / step


def _unordered(place: Place, sign: int, sides: tuple[t.Node, ...], indices: Indices) -> Counterexample | None:
    values = place.values(DIGITS)
    left, right = (values.of(side, indices) for side in sides)
    gap, size = sign * (left - right), max(values.size(side, indices) for side in sides)
    real = mp.im(gap) == 0
    return _shown(values, sides, indices) if real and gap < -TOLERANCE * size else None


def _shown(values: Values, sides: tuple[t.Node, ...], indices: Indices) -> Counterexample:
    """The point and both sides as text."""
    here = {**values.place.point, **{symbol: value for symbol, value in values.special.items() if symbol != pm}}
    point = {str(symbol): str(value) for symbol, value in here.items() if value.is_number}
    left, right = (", ".join(mp.nstr(x, 20) for x in flat(values.of(side, indices))) for side in sides)
    return {**point, **{letter: str(value) for letter, value in indices}, "lhs": left, "rhs": right}
