"""judge(claim) → Verdict: refute first, then prove; what agrees without a proof says why there is none."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterable
from typing import Any

from derive.check import approach, limits, pool, prove, refute, signs
from derive.check.prepare import prepared
from derive.check.timing import TimeLimit, limited
from derive.check.verdicts import AGREED, PROVED, REFUTED, UNKNOWN, VERDICTS, Verdict
from derive.theory.claims import Claim, Equal, Limit, NonNegative, Order, Positive

SECONDS = 30.0

METHODS = {
    Equal: "normal form",
    Positive: "sign analysis",
    NonNegative: "sign analysis",
    Limit: "limit",
    Order: "Taylor coefficients",
}

Answer = tuple[VERDICTS, str, dict[str, str] | None, str]


def judge(claim: Claim, seconds: float | None = SECONDS) -> Verdict:
    """The verdict on a claim, within so many seconds of the processor, None for no limit.

    At the limit it is UNKNOWN, or AGREED if it held at random points.
    """
    start = time.perf_counter()
    tried = refute.Trial(None, 0)
    try:
        with limited(seconds):
            ready = prepared(claim)
            tried = _refuted(ready)
            answer = _judged(ready, tried)
    except TimeLimit as limit:
        answer = _unproved(tried, str(limit))
    except RecursionError:
        answer = _unproved(tried, "the expression is nested too deeply")
    return Verdict(claim.id, *answer, time.perf_counter() - start)


def _refuted(claim: Claim, points: int | None = None) -> refute.Trial:
    if isinstance(claim.relation, Equal | Positive | NonNegative):
        return refute.refute(claim, points)
    return approach.refute(claim)


def _judged(claim: Claim, tried: refute.Trial) -> Answer:
    if tried.counterexample:
        return REFUTED, f"counterexample at {refute.DIGITS} digits", tried.counterexample, ""
    if not tried.points:
        return UNKNOWN, "random points", None, tried.reason
    reason = _why_unproved(claim)
    if not reason:
        return PROVED, _method(claim), None, ""
    more = _refuted(claim, refute.MORE_POINTS)  # what is not proved is tried harder
    if more.counterexample:
        return REFUTED, f"counterexample at {refute.DIGITS} digits", more.counterexample, ""
    return _unproved(more, reason)


def _unproved(tried: refute.Trial, reason: str) -> Answer:
    if not tried.points:
        return UNKNOWN, "none", None, reason
    return AGREED, f"{tried.points} points, {refute.DIGITS} digits", None, reason


def _why_unproved(claim: Claim) -> str:
    """Empty if the claim is proved."""
    relation, sign = claim.relation, signs.Signs(claim.domain, claim.given).sign
    if isinstance(relation, Equal):
        reasons = (prove.equal(a, b, claim.domain, claim.given, sign) for a, b in refute.pairs(relation))
        return next((reason for reason in reasons if reason), "")
    if isinstance(relation, Positive | NonNegative):
        wanted = (1,) if isinstance(relation, Positive) else (0, 1)
        return "" if sign(relation.expr) in wanted else "the signs of the coefficients do not decide"
    return limits.prove(claim, sign)


def _method(claim: Claim) -> str:
    return METHODS[type(claim.relation)]


def judge_all(
    claims: Iterable[Claim],
    jobs: int = 2,
    progress: Callable[[Verdict], Any] | None = None,
    seconds: float | None = SECONDS,
) -> list[Verdict]:
    """Verdicts of many claims in their order.

    jobs: how many processes. progress: called with each verdict as it is there. seconds: the time limit of each.
    """
    return pool.mapped(judge, [(claim, seconds) for claim in claims], jobs, progress)
