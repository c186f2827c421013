"""Wrong variants of claims: a checker must be seen to fail.

A mutant is a claim with one small change: a sign, a coefficient, an exponent, a term or factor dropped, two symbols
exchanged, another value, a wider bound. It is *killed* by a counterexample and by nothing else. A survivor that is
proved is *equivalent* to a true claim and counted apart. Anything else is a failure of the checker, and listed.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, replace
from itertools import pairwise
from typing import Any

import sympy as sp

from derive.check import pool
from derive.check.judge import judge
from derive.check.verdicts import PROVED, REFUTED, Verdict
from derive.theory.claims import Claim, Domain, Equal, Limit, NonNegative, Order, Positive

MUTANTS = 12  # at most so many for a claim, spread over all that there are
SECONDS = 10.0

Change = tuple[str, Any]


@dataclass(frozen=True)
class Mutant:
    """A changed claim, and what was changed."""

    change: str
    claim: Claim


@dataclass(frozen=True)
class Outcome:
    """What became of a mutant: 'killed', 'equivalent' or 'failed', with the verdict on it."""

    id: str
    change: str
    fate: str
    verdict: Verdict

    def to_json(self) -> dict[str, Any]:
        """A dictionary of plain values, for JSON."""
        return {"id": self.id, "change": self.change, "fate": self.fate, "verdict": self.verdict.to_json()}


def variants(expr: sp.Expr) -> Iterator[Change]:
    """All expressions with one change in one node, in a fixed order."""
    yield from _own(expr)
    if isinstance(expr, sp.Tuple) or (expr.is_Pow and expr.exp.is_number and expr.exp.is_Integer is None):
        return
    for k, arg in enumerate(expr.args):
        if isinstance(arg, sp.Expr) and not arg.is_Symbol and not _is_bound(expr, k):
            for change, new in variants(arg):
                yield change, expr.func(*expr.args[:k], new, *expr.args[k + 1 :])


def _is_bound(expr: sp.Expr, k: int) -> bool:
    """Variables of derivatives, integrals and substitutions, and −1 as exponent or factor, are left alone."""
    if isinstance(expr, sp.Derivative | sp.Integral | sp.Subs):
        return k > 0
    return bool((expr.is_Pow and k == 1) or expr.args[k] == -1)


def _own(expr: sp.Expr) -> Iterator[Change]:
    if expr.is_Rational:
        yield "number", expr + 1
    elif expr.is_Add:
        for k, term in enumerate(expr.args):
            yield "sign of a term", expr - 2 * term
            yield "term dropped", sp.Add(*expr.args[:k], *expr.args[k + 1 :])
    elif expr.is_Mul:
        for k, factor in enumerate(expr.args):
            if factor != -1:
                yield "factor dropped", sp.Mul(*expr.args[:k], *expr.args[k + 1 :])
    elif expr.is_Pow:
        yield "exponent", expr.base ** (expr.exp + 1)
    elif isinstance(expr, sp.sin | sp.cos):
        yield "sine for cosine", (sp.cos if isinstance(expr, sp.sin) else sp.sin)(expr.args[0])


def _of_side(side: Any) -> Iterator[Change]:
    """The changes of a scalar or a matrix, and of its sign and letters as a whole."""
    if isinstance(side, sp.MatrixBase):
        plain = sp.Matrix(side)
        for k, entry in enumerate(plain):
            for change, new in _of_side(entry):
                changed = plain.copy()
                changed[k] = new
                yield f"entry {k}: {change}", sp.ImmutableMatrix(changed)
        return
    side = sp.sympify(side, strict=True)
    if side != 0:
        yield "sign", -side
    yield "one more", side + 1
    yield from variants(side)
    letters = sorted(side.free_symbols, key=sp.default_sort_key)
    for a, b in pairwise(letters):
        if not side.has(sp.Derivative, sp.Subs, sp.Integral):
            yield f"{a} and {b} exchanged", side.xreplace({a: b, b: a})


def mutants(claim: Claim, limit: int | None = MUTANTS) -> list[Mutant]:
    """Mutants of a claim, without repetition and without the claim itself, at most `limit` of them."""
    claim = _frozen(claim)
    found: dict[Any, Mutant] = {}
    for change, mutant in _changes(claim):
        key = (mutant.relation, tuple(mutant.domain.ranges.items()))
        if key not in found and key != (claim.relation, tuple(claim.domain.ranges.items())) and not _broken(mutant):
            found[key] = Mutant(change, replace(mutant, id=f"{claim.id}~{len(found) + 1}"))
    every = list(found.values())
    if limit is None or len(every) <= limit:
        return every
    return [every[k * len(every) // limit] for k in range(limit)]


def _frozen(claim: Claim) -> Claim:
    """The same claim with immutable matrices."""
    parts = {k: v.as_immutable() for k, v in vars(claim.relation).items() if isinstance(v, sp.MatrixBase)}
    return replace(claim, relation=replace(claim.relation, **parts))


def _broken(claim: Claim) -> bool:
    """The change gave infinity, or a Weierstrass function at 0."""
    parts = [part for part in vars(claim.relation).values() if isinstance(part, sp.Basic | sp.MatrixBase)]
    bad = (sp.nan, sp.zoo) if isinstance(claim.relation, Limit) else (sp.nan, sp.zoo, sp.oo)
    return any(part.has(*bad) for part in parts)


def _changes(claim: Claim) -> Iterator[tuple[str, Claim]]:
    relation = claim.relation
    if isinstance(relation, Equal):
        names = ["rhs", "lhs"]
    elif isinstance(relation, Limit):
        # What tends to 0 still does after most changes: turn it over instead.
        yield "expr: turned over", replace(claim, relation=replace(relation, expr=1 / relation.expr))
        names = ["value"] if relation.value in (0, sp.oo, -sp.oo) else ["value", "expr"]
    elif isinstance(relation, Order):
        yield "power", replace(claim, relation=replace(relation, power=relation.power + 1))
        names = ["expr"]
    else:
        yield from _of_sign(claim, relation)
        return
    for name in names:
        for change, new in _of_side(getattr(relation, name)):
            yield f"{name}: {change}", replace(claim, relation=replace(relation, **{name: new}))


def _of_sign(claim: Claim, relation: Positive | NonNegative) -> Iterator[tuple[str, Claim]]:
    """The whole turned, a sign within it, a wider range."""
    yield "sign", replace(claim, relation=replace(relation, expr=-relation.expr))
    for change, new in variants(sp.sympify(relation.expr, strict=True)):
        if change == "sign of a term":
            yield change, replace(claim, relation=replace(relation, expr=new))
    for symbol, (lower, upper) in claim.domain.ranges.items():
        for wider in _wider(claim.domain, symbol, sp.sympify(lower, strict=True), sp.sympify(upper, strict=True)):
            ranges = {**claim.domain.ranges, symbol: wider}
            yield f"range of {symbol}", replace(claim, domain=Domain(ranges, claim.domain.conditions))


def _wider(domain: Domain, symbol: sp.Expr, lower: sp.Expr, upper: sp.Expr) -> Iterator[tuple[sp.Expr, sp.Expr]]:
    """Ranges beyond one end; none where other ranges lean on the symbol, or its assumptions are the end."""
    ends = [sp.sympify(end, strict=True) for pair in domain.ranges.values() for end in pair]
    if any(end.has(symbol) for end in ends):
        return
    if lower != -sp.oo and not (lower == 0 and symbol.is_nonnegative):
        yield (sp.Integer(0) if symbol.is_nonnegative else lower - abs(lower) - 1), upper
    if upper != sp.oo and not (upper == 0 and symbol.is_nonpositive):
        yield lower, upper + abs(upper) + 1


def tried(claim: Claim, limit: int | None = MUTANTS) -> list[Outcome]:
    """Judge the mutants of a claim."""
    found = []
    for mutant in mutants(claim, limit):
        verdict = judge(mutant.claim, SECONDS)
        fate = {REFUTED: "killed", PROVED: "equivalent"}.get(verdict.verdict, "failed")
        found.append(Outcome(claim.id, mutant.change, fate, verdict))
    return found


def mutate_all(
    claims: Iterable[Claim],
    jobs: int = 2,
    progress: Callable[[list[Outcome]], Any] | None = None,
    limit: int | None = MUTANTS,
) -> list[Outcome]:
    """The fates of the mutants of all claims, by several processes; progress is called once a claim."""
    done = pool.mapped(tried, [(claim, limit) for claim in claims], jobs, progress)
    return [outcome for outcomes in done for outcome in outcomes]
