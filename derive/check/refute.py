"""Refutation: exact random points in the domain at which a claim fails, seen at 50 digits and again at 100.

A point where a side is undefined says nothing. A difference counts if it is larger than 10⁻³⁰ of the terms that make
the two sides up, and if doubling the digits leaves it as it is.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from typing import Any

import sympy as sp
from mpmath import mp

from derive.check.evaluate import UndefinedError, evaluate, magnitude
from derive.check.sample import ExactPoint, Sampler
from derive.theory.claims import Claim, Equal, NonNegative, Positive

DIGITS = 50
POINTS = 6
SIGN_POINTS = 40  # an inequality may fail in a small part of its domain
ZEROS = 4  # points tried for each symbol to meet a zero
MORE_POINTS = 60  # where no proof was found
TRIES = 18  # points drawn, at most, to have POINTS where both sides are defined
TOLERANCE = mp.mpf(10) ** -30
SAME = mp.mpf(10) ** -3  # relative change of the difference on doubling the digits


@dataclass(frozen=True)
class Trial:
    """The outcome: a counterexample or None, how many points were evaluated, and why others were not."""

    counterexample: dict[str, str] | None
    points: int
    reason: str = ""


def pairs(relation: Equal) -> Iterator[tuple[sp.Expr, sp.Expr]]:
    """The two sides of an equality, entry by entry."""
    if isinstance(relation.lhs, sp.MatrixBase) or isinstance(relation.rhs, sp.MatrixBase):
        left, right = sp.Matrix(relation.lhs), sp.Matrix(relation.rhs)
        if left.shape != right.shape:
            raise ValueError(f"matrices of shapes {left.shape} and {right.shape} are compared")
        yield from zip(left, right, strict=True)
    else:
        yield sp.sympify(relation.lhs, strict=True), sp.sympify(relation.rhs, strict=True)


def shown(point: ExactPoint, lhs: Any, rhs: Any) -> dict[str, str]:
    """A counterexample as text."""
    with mp.workdps(DIGITS):
        values = {str(symbol): _text(value, point) for symbol, value in point.items()}
        return {**values, "lhs": mp.nstr(lhs, 20), "rhs": mp.nstr(rhs, 20)}


def _text(value: sp.Expr, point: ExactPoint) -> str:
    return str(value) if value.is_number else mp.nstr(evaluate(value, point), 20)


def differ(lhs: sp.Expr, rhs: sp.Expr, point: ExactPoint, digits: int = DIGITS) -> tuple[Any, Any] | None:
    """Both values where the sides differ at the point, None where they agree; raises UndefinedError."""
    known: dict[sp.Expr, Any] = {}  # what the sides, and their terms, have in common is evaluated once
    left, right = evaluate(lhs, point, digits, known), evaluate(rhs, point, digits, known)
    with mp.workdps(digits):
        gap = left - right
        scale = magnitude(lhs, point, digits, known) + magnitude(rhs, point, digits, known)
        if abs(gap) <= TOLERANCE * scale:
            return None
    known = {}
    with mp.workdps(2 * digits):
        again = evaluate(lhs, point, 2 * digits, known) - evaluate(rhs, point, 2 * digits, known)
        return (left, right) if abs(again - gap) <= SAME * abs(again) else None


def _equal_at(entries: list[tuple[sp.Expr, sp.Expr]], point: ExactPoint) -> dict[str, str] | None:
    for lhs, rhs in entries:
        found = differ(lhs, rhs, point)
        if found:
            return shown(point, *found)
    return None


def _sign_fails(relation: Positive | NonNegative, point: ExactPoint) -> dict[str, str] | None:
    expr, may_vanish = relation.expr, isinstance(relation, NonNegative)
    known: dict[sp.Expr, Any] = {}
    value = evaluate(expr, point, DIGITS, known)
    if mp.im(value) != 0:
        return shown(point, value, mp.mpf(0)) if mp.im(evaluate(expr, point, 2 * DIGITS)) != 0 else None
    if value > TOLERANCE * magnitude(expr, point, DIGITS, known):
        return None
    known = {}
    again = evaluate(expr, point, 2 * DIGITS, known)
    with mp.workdps(2 * DIGITS):
        noise = TOLERANCE * magnitude(expr, point, 2 * DIGITS, known) if may_vanish else mp.mpf(0)
        return shown(point, value, mp.mpf(0)) if again < -noise or (again <= 0 and not may_vanish) else None


def refute(claim: Claim, points: int | None = None, seed: int = 1) -> Trial:
    """Look for a counterexample to an equality or a sign (its hypotheses already substituted in the relation)."""
    relation = claim.relation
    if isinstance(relation, Equal):
        entries = [pair for pair in pairs(relation) if pair[0] != pair[1]]
        expressions = [side for pair in entries for side in pair]
    elif isinstance(relation, Positive | NonNegative):
        entries, expressions = [], [relation.expr]
        points = points or SIGN_POINTS
    else:
        raise TypeError(f"no pointwise test for {type(relation).__name__}")
    points = points or POINTS
    sampler = Sampler(expressions, claim.domain, claim.given, seed)
    drawn = sampler.points(max(TRIES, 3 * points))
    if isinstance(relation, Equal):
        return tried(drawn, points, lambda point: _equal_at(entries, point))
    trial = tried(drawn, points, lambda point: _sign_fails(relation, point))
    if trial.counterexample is None and trial.points:
        for point in sampler.zeros([relation.expr], ZEROS):
            found = _sign_fails(relation, point)
            if found:
                return Trial(found, trial.points)
    return trial


def tried(drawn: Iterable[ExactPoint], points: int, test: Callable[[ExactPoint], dict[str, str] | None]) -> Trial:
    """A test at as many points as are asked for, of those at which it has a value; the first that fails ends it."""
    done, reason = 0, "the domain seems empty"
    for point in drawn:
        try:
            found = test(point)
        except UndefinedError as error:
            reason = str(error)
            continue
        done += 1
        if found:
            return Trial(found, done)
        if done == points:
            break
    return Trial(None, done, "" if done else f"no point can be evaluated: {reason}")
