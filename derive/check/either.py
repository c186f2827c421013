"""± in a printed statement: one choice of the sign makes all its relations hold, found by trying both at points.

Where the theory leaves the sign open at each point of a domain, and one relation alone holds it, either sign may hold.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

from sympy import MatrixBase, zeros

from derive.check import refute
from derive.check.meaning import pm
from derive.check.prepare import prepared
from derive.theory.claims import Claim, Equal, Limit, NonNegative, Order, Positive

POINTS = 2  # at which a sign is tried
NAMES = {1: "+", -1: "−"}


def holds_sign(relation: Any) -> bool:
    """Does the relation hold the sign ±?"""
    return any(side.has(pm) for side in vars(relation).values() if hasattr(side, "has"))


def resolved(claims: Sequence[Claim]) -> tuple[list[Claim], int | None]:
    """The claims of one statement with a sign for ±, and that sign if only one of the two will do."""
    signed = [claim for claim in claims if holds_sign(claim.relation)]
    if not signed:
        return list(claims), None
    fitting = [sign for sign in (1, -1) if not any(_fails(_put(claim, sign)) for claim in signed)]
    if not fitting and len(signed) == 1 and isinstance(signed[0].relation, Equal):
        either = replace(signed[0], relation=_either(signed[0].relation))
        if not _fails(either):
            return [either if claim is signed[0] else claim for claim in claims], None
    sign = fitting[0] if fitting else 1
    return [_put(claim, sign) for claim in claims], sign if len(fitting) == 1 else None


def _either(relation: Equal) -> Equal:
    """That one of the two signs gives equality, at each point."""
    gap = relation.lhs - relation.rhs
    upper, lower = gap.subs(pm, 1), gap.subs(pm, -1)
    if not isinstance(gap, MatrixBase):
        return Equal(upper * lower, 0)
    return Equal(upper.vec() * lower.vec().T, zeros(len(upper), len(lower)))


def _put(claim: Claim, sign: int) -> Claim:
    relation = claim.relation
    if not holds_sign(relation):
        return claim
    values = {name: side.subs(pm, sign) if hasattr(side, "subs") else side for name, side in vars(relation).items()}
    return replace(claim, relation=replace(relation, **values))


def _fails(claim: Claim) -> bool:
    """Is there a counterexample among a few points? Limits and orders are left to the judge."""
    if isinstance(claim.relation, Limit | Order):
        return False
    assert isinstance(claim.relation, Equal | Positive | NonNegative)
    return refute.refute(prepared(claim), POINTS).counterexample is not None
