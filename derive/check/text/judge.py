"""judge_text(theory, claim) → the verdict on a claim of the running text, with a repair where one is proved.

A repair is sought among the wrong variants of the claim's own form, one change before two: those that are made to show
that the judge can fail are what a misprint may have come from.
"""

from __future__ import annotations

import time
from collections.abc import Iterator, Mapping
from dataclasses import replace
from typing import Any

from derive.check.judge import judge
from derive.check.printed import judge_formula
from derive.check.report import FormulaVerdict, StatementVerdict, formula_verdict, statement_verdict
from derive.check.text import bodies, numbers, periods, polynomials, properties, ranges
from derive.check.text.forms import Form, Variants
from derive.check.verdicts import CERTIFIED, PROVED, REFUTED, Verdict
from derive.paper.text_claims import FORMULA, TextClaim
from derive.theory.claims import Claim

SECONDS = 20.0  # for one part of a claim
CANDIDATES = 400  # of repairs

FORMS: Mapping[str, Form] = {
    "always": Form(ranges.judge_always, ranges.vary_always),
    "possible": Form(ranges.judge_possible, ranges.vary_possible),
    "monotone": Form(ranges.judge_monotone, ranges.vary_monotone),
    "extreme": Form(ranges.judge_extreme, ranges.vary_extreme),
    "sign": Form(polynomials.judge_sign, polynomials.vary_sign),
    "coefficient": Form(polynomials.judge_coefficient, polynomials.vary_coefficient),
    "roots": Form(polynomials.judge_roots, polynomials.vary_monomials),
    "discriminant": Form(polynomials.judge_discriminant, polynomials.vary_monomials),
    "range": Form(polynomials.judge_range, polynomials.vary_monomials),
    "growth": Form(polynomials.judge_growth, polynomials.vary_growth),
    "degree": Form(polynomials.judge_degree, polynomials.vary_degree),
    "start": Form(periods.judge_start, periods.vary_start),
    "segment": Form(periods.judge_segment, periods.vary_segment),
    "zeros": Form(properties.judge_zeros, properties.vary_zeros),
    "pole": Form(properties.judge_pole, properties.vary_pole),
    "falls": Form(properties.judge_falls, properties.vary_falls),
    "slope": Form(properties.judge_slope, properties.vary_slope),
    "dimension": Form(bodies.judge_dimension, bodies.vary_dimension),
    "units": Form(bodies.judge_units, bodies.vary_units),
    "immaterial": Form(bodies.judge_immaterial, bodies.vary_immaterial),
    "conserved": Form(bodies.judge_conserved, bodies.vary_conserved),
    "planar": Form(bodies.judge_planar, bodies.vary_planar),
    "sides": Form(bodies.judge_sides, bodies.vary_sides),
    "count": Form(numbers.judge_count, numbers.vary_count),
    "kinds": Form(numbers.judge_kinds, numbers.vary_kinds),
    "transition": Form(numbers.judge_transition, numbers.vary_transition),
    "effect": Form(numbers.judge_effect, numbers.vary_effect),
    "bifurcations": Form(numbers.judge_bifurcations, numbers.vary_bifurcations),
    "shrinks": Form(numbers.judge_shrinks, numbers.vary_shrinks),
}


def judge_text(theory: Any, claim: TextClaim, *, mend: bool = True) -> FormulaVerdict:
    """The verdict on a claim, as on a display with one statement."""
    if claim.form == FORMULA:
        return judge_formula(theory, claim.record, _decide, mend=mend)
    start = time.perf_counter()
    said = _judged(theory, claim)
    if mend and said.verdict == REFUTED:
        said = replace(said, repair=_repair(theory, claim))
    record = replace(claim.record, latex=claim.printed)
    return formula_verdict(record, [said], time.perf_counter() - start)


def _decide(claim: Claim) -> Verdict:
    return judge(claim, SECONDS)


def _judged(theory: Any, claim: TextClaim) -> StatementVerdict:
    start = time.perf_counter()
    relations = FORMS[claim.form].judge(theory, claim, _decide)
    said = statement_verdict(claim.printed, relations, time.perf_counter() - start, None)
    notes = dict.fromkeys(one.verdict.reason for one in relations if one.verdict.verdict == CERTIFIED)
    return said if said.verdict != CERTIFIED else replace(said, reason="; ".join(note for note in notes if note))


def variants(claim: TextClaim) -> Variants:
    """All wrong variants of a claim that is no formula, each with the kind of its change; none twice."""
    seen = [claim]
    if claim.form == FORMULA:
        return
    for kind, variant in FORMS[claim.form].variants(claim):
        if variant not in seen:
            seen.append(variant)
            yield kind, variant


def _repair(theory: Any, claim: TextClaim) -> dict[str, Any] | None:
    """The first variant, of one change or of two, that holds."""
    for tried, (kinds, candidate) in enumerate(_candidates(claim), start=1):
        if tried > CANDIDATES:
            return None
        found = _judged(theory, candidate)
        if found.verdict in (PROVED, CERTIFIED):
            return {
                "latex": told(claim, candidate),
                "verdict": str(found.verdict),
                "edits": list(kinds),
                "tried": tried,
            }
    return None


def _candidates(claim: TextClaim) -> Iterator[tuple[tuple[str, ...], TextClaim]]:
    once = list(variants(claim))
    yield from (((kind,), one) for kind, one in once)
    for first, one in once:
        yield from (((first, second), two) for second, two in variants(one) if two != claim)


def mended(theory: Any, claim: TextClaim) -> TextClaim | None:
    """The claim itself if it holds, else its repair; None if there is none."""
    if _judged(theory, claim).verdict in (PROVED, CERTIFIED):
        return claim
    tried = (one for _, one in _candidates(claim))
    return next((one for one in tried if _judged(theory, one).verdict in (PROVED, CERTIFIED)), None)


def told(claim: TextClaim, candidate: TextClaim) -> str:
    """What a repair changes, in LaTeX: each datum that differs, and its new value."""
    parts = [
        rf"\text{{{name.replace('_', ' ')}}}: {_shown(value)}"
        for name, value in candidate.data.items()
        if value != claim.data.get(name)
    ]
    return r" \,, \quad ".join(parts)


SYMBOLS = {
    "wp": r"\wp",
    "wp_prime": r"\wp^\prime",
    "wp_second": r"\wp^{\prime \prime}",
    **{f"omega_{n}": rf"\omega_{n}" for n in (1, 2, 3)},
    **{f"xi_{letter}": rf"\xi_{letter}" for letter in "ab2"},
}


def _shown(value: Any) -> str:
    if isinstance(value, Mapping):
        return " ".join(rf"\text{{{name}}}^{{{power}}}" for name, power in value.items() if power)
    if isinstance(value, list):
        return " ".join(_shown(one) for one in value)
    return SYMBOLS.get(
        str(value), rf"\text{{{str(value).replace('_', ' ')}}}" if isinstance(value, str) else str(value)
    )
