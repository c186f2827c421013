"""Ranges, orders and monotony: signs of quantities of a load case over all parameters and all constants in their range.

always       cases = [[left, relation, right]]: each holds everywhere
possible     the same: each holds somewhere
monotone     names: each rises, or falls, all over the range of the constant; sense, if given, says which
extreme      members: the greatest, or smallest, root of f is always one of these, and each of them somewhere
"""

from __future__ import annotations

from itertools import chain
from typing import Any

from sympy import Expr, diff

from derive.check.report import RelationVerdict
from derive.check.text.forms import (
    RELATIONS,
    Judge,
    Variants,
    case_of,
    decided,
    proved,
    quantities,
    refuted,
    roots,
    samples,
    where,
)
from derive.check.verdicts import PROVED, REFUTED
from derive.paper.text_claims import TextClaim
from derive.theory.claims import Domain, Positive
from derive.theory.load_case import COSINES

SENSES = ("rises", "falls")


def _gap(values: dict[str, Expr], case: list[str]) -> Expr:
    """What is positive where the relation holds."""
    left, relation, right = (values.get(part, part) for part in case)
    return left - right if relation == ">" else right - left


def _domains(theory: Any, claim: TextClaim, names: list[str]) -> list[Domain]:
    """Everywhere; in terms of the tip, on both sides of the double root of f̂, which is excluded."""
    case = case_of(theory, claim)
    if "gamma_at_tip" not in names:
        return [where(case)]
    return [case.steep(xi_tip=(COSINES[0], case.vertex)), case.steep(xi_tip=(case.vertex, COSINES[1]))]


def judge_always(theory: Any, claim: TextClaim, decide: Judge) -> list[RelationVerdict]:
    """A sign each, everywhere."""
    values = quantities(theory, claim)
    return [
        decided(decide, " ".join(case), Positive(_gap(values, case)), domain)
        for case in claim.data["cases"]
        for domain in _domains(theory, claim, case)
    ]


def judge_possible(theory: Any, claim: TextClaim, decide: Judge) -> list[RelationVerdict]:
    """An example each; refuted where the opposite is proved."""
    values, domain, found = quantities(theory, claim), where(case_of(theory, claim)), []
    for case in claim.data["cases"]:
        title, gap = " ".join(case), _gap(values, case)
        if any(value > 0 for _, (value,) in samples([gap], domain)):
            found.append(proved(title, "an example"))
            continue
        opposite = decided(decide, title, Positive(-gap), domain)
        if opposite.verdict.verdict == PROVED:
            opposite = refuted(title, "the opposite is proved", {"never": title})
        found.append(opposite)
    return found


def vary_always(claim: TextClaim) -> Variants:
    """The relation turned; a bound beyond the true one."""
    for n, (left, relation, right) in enumerate(claim.data["cases"]):
        yield "relation", _with_case(claim, n, [left, RELATIONS[relation], right])
        bound = {("<", "1"): "-1", (">", "-1"): "1", (">", "0"): "1"}.get((relation, right))
        if bound:
            yield "bound", _with_case(claim, n, [left, relation, bound])


def vary_possible(claim: TextClaim) -> Variants:
    """Beyond the other end of the range of cosines; another quantity."""
    for n, (left, relation, right) in enumerate(claim.data["cases"]):
        if right == "-1":
            yield "bound", _with_case(claim, n, [left, RELATIONS[relation], "1"])
        if left == "b":
            yield "quantity", _with_case(claim, n, ["xi_b", "<", right])


def _with_case(claim: TextClaim, number: int, case: list[str]) -> TextClaim:
    cases = claim.data["cases"]
    return claim.but(cases=[*cases[:number], case, *cases[number + 1 :]])


def judge_monotone(theory: Any, claim: TextClaim, decide: Judge) -> list[RelationVerdict]:
    """The sign of a derivative each."""
    case, values, found = case_of(theory, claim), quantities(theory, claim), []
    for name in claim.data["names"]:
        slope = diff(values[name], case.constant)
        tried = {
            sense: decided(decide, f"{name} {sense} with {case.constant}", Positive(sign * slope), where(case))
            for sense, sign in zip(SENSES, (1, -1), strict=True)
            if claim.data.get("sense", sense) == sense
        }
        holds = [one for one in tried.values() if one.verdict.verdict == PROVED]
        found.append(holds[0] if holds else next(iter(tried.values())))
    return found


def vary_monotone(claim: TextClaim) -> Variants:
    """Another quantity in the place of each; all rising, all falling."""
    names = claim.data["names"]
    for n in range(len(names)):
        for other in ("g_2", "g_3"):
            yield "quantity", claim.but(names=[*names[:n], other, *names[n + 1 :]])
    for sense in SENSES:
        yield "sense", claim.but(sense=sense)


def judge_extreme(theory: Any, claim: TextClaim, decide: Judge) -> list[RelationVerdict]:
    """Every other root is on the other side of a member, and every member is beyond all others somewhere."""
    case, values = case_of(theory, claim), roots(theory, claim)
    sign, members = (1 if claim.data["which"] == "greatest" else -1), claim.data["members"]
    relation, found = ("<" if sign == 1 else ">"), []
    for other in values.keys() - set(members):
        tries = [
            decided(decide, f"{other} {relation} {one}", Positive(sign * (values[one] - values[other])), where(case))
            for one in members
        ]
        found.append(min(tries, key=lambda one: one.verdict.verdict != PROVED))
    names = sorted(values)
    best = {
        max(zip([sign * v for v in at], names, strict=True))[1]
        for _, at in samples([values[n] for n in names], where(case))
    }
    for one in members:
        title = f"{one} is the {claim.data['which']} somewhere"
        found.append(proved(title, "an example") if one in best else _never(decide, theory, claim, one, title))
    return found


def _never(decide: Judge, theory: Any, claim: TextClaim, one: str, title: str) -> RelationVerdict:
    """A member that is always on the wrong side of another root."""
    values, sign = roots(theory, claim), 1 if claim.data["which"] == "greatest" else -1
    tries = [
        decided(decide, title, Positive(sign * (values[other] - values[one])), where(case_of(theory, claim)))
        for other in values.keys() - {one}
    ]
    if any(one.verdict.verdict == PROVED for one in tries):
        return refuted(title, "another root is always beyond it", {"never": title})
    return min(tries, key=lambda one: one.verdict.verdict != REFUTED)


def vary_extreme(claim: TextClaim) -> Variants:
    """The other extreme; a member left out, or exchanged for another root."""
    which, members = claim.data["which"], claim.data["members"]
    yield "extreme", claim.but(which="smallest" if which == "greatest" else "greatest")
    if len(members) > 1:
        yield from (("root", claim.but(members=[*members[:n], *members[n + 1 :]])) for n in range(len(members)))
    for new in sorted({"1", "-1", "xi_a", "xi_b"} - set(chain(members))):
        yield "root", claim.but(members=[new, *members[1:]])
        yield "root", claim.but(members=[*members, new])
