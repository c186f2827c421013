"""A claim made ready: derivatives carried out, hypotheses put in, in the relation and in the domain alike."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import sympy as sp

from derive.check import carlson
from derive.theory.claims import Claim, Domain, Equal, Limit, NonNegative, Order, Positive


def _put(expr: Any, claim: Claim) -> Any:
    expr = carlson.resolved(_exact(expr))
    for old, new in claim.given:
        expr = expr.subs(old, new)
    return carlson.resolved(expr)


def _exact(expr: Any) -> Any:
    if isinstance(expr, sp.MatrixBase):
        return sp.ImmutableMatrix(expr)
    return sp.sympify(expr, strict=True)


def prepared(claim: Claim) -> Claim:
    """The same claim with derivatives carried out and its hypotheses substituted."""
    relation = claim.relation
    if isinstance(relation, Equal):
        done: Any = Equal(_put(relation.lhs, claim), _put(relation.rhs, claim))
    elif isinstance(relation, Limit):
        sides = {name: _put(getattr(relation, name), claim) for name in ("expr", "point", "value")}
        done = replace(relation, **sides)
    elif isinstance(relation, Positive | NonNegative | Order):
        done = replace(relation, expr=_put(relation.expr, claim))
    else:
        raise TypeError(f"no rule for a relation of type {type(relation).__name__}")
    ranges = {x: tuple(_put(end, claim) for end in ends) for x, ends in claim.domain.ranges.items()}
    conditions = tuple(_put(condition, claim) for condition in claim.domain.conditions)
    return replace(claim, relation=done, domain=Domain(ranges, conditions))
