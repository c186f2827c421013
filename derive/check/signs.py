"""Signs proved on a domain: mapped to positive variables, decided by coefficients, factors, roots and splitting.

A polynomial in positive variables whose coefficients have one sign has that sign. Otherwise: its factors; for
p + q√r, the signs of p, q and p² − q²r; for a quadratic, its discriminant; in one variable, the number of its roots
(Sturm); and last, the domain is cut in pieces.
"""

from __future__ import annotations

from contextlib import suppress
from itertools import product as cartesian

import sympy as sp
from mpmath import mp

from derive.check import orthant
from derive.check.decision import Decision, by_assumptions, orthant_sign
from derive.check.evaluate import UndefinedError, evaluate
from derive.check.rational import NotNormalError
from derive.check.sample import Sampler
from derive.theory.claims import Domain

PROBES = 8  # points that rule out a sign before a proof is tried
PROBE_DIGITS = 30
CUTS = 3  # how often a domain is cut in two

Given = tuple[tuple[sp.Expr, sp.Expr], ...]


class Signs:
    """The sign oracle of a domain; answers are kept."""

    def __init__(self, domain: Domain, given: Given = ()) -> None:
        self.domain = domain
        self.given = given
        self.answers: dict[sp.Expr, int | None] = {}

    def sign(self, expr: sp.Expr) -> int | None:
        """+1, −1 or 0 if proved on the whole domain, else None."""
        plain = by_assumptions(expr)
        if plain is not None:
            return plain
        if expr not in self.answers:
            self.answers[expr] = None
            with suppress(NotNormalError, ZeroDivisionError, NotImplementedError):  # then the sign is not known
                self.answers[expr] = self._sign(expr)
        return self.answers[expr]

    def _sign(self, expr: sp.Expr) -> int | None:
        if expr.has(sp.I) or self._probe(expr) is None:
            return None
        ready = orthant.mapped(expr, self.domain, orthant_sign)
        if ready.complex or len(ready.free) > 2:
            return None
        found: set[int | None] = set()
        for values in cartesian(*(orthant.sides(x) for x in ready.free)):
            put = dict(zip(ready.free, values, strict=True))
            facts = [fact.xreplace(put) for fact in ready.facts]
            found.add(_cut(ready.expr.xreplace(put), facts, CUTS))
            if None in found or len(found) > 1:
                return None
        return found.pop()

    def _probe(self, expr: sp.Expr) -> int | None:
        """The sign at some points of the domain, None where they differ; exact zeros count as a difference."""
        seen = set()
        for point in Sampler([expr], self.domain, self.given).points(PROBES):
            try:
                value = evaluate(expr, point, PROBE_DIGITS)
            except UndefinedError:
                return None
            seen.add(None if mp.im(value) != 0 or value == 0 else 1 if value > 0 else -1)
        return seen.pop() if len(seen) == 1 else None


def _cut(expr: sp.Expr, facts: list[sp.Expr], cuts: int) -> int | None:
    """The sign over the orthant, cutting it at t = 1 for one variable after the other."""
    plain = by_assumptions(expr)
    if plain is not None:
        return plain
    found = Decision(expr, facts).sign()
    if found is not None or cuts == 0:
        return found
    for t in sorted((x for x in expr.free_symbols if x.is_positive), key=str):
        new = orthant.fresh(t.name)
        values = {_cut(expr.subs(t, part), [f.subs(t, part) for f in facts], cuts - 1) for part in (1, 1 + new)}
        if len(values) == 1 and None not in values:
            values.add(_cut(expr.subs(t, new / (1 + new)), [f.subs(t, new / (1 + new)) for f in facts], cuts - 1))
            if len(values) == 1:
                return values.pop()
    return None
