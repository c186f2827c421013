"""The judges of the numerical statements: what ``examples`` certifies, as verdicts."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from itertools import pairwise
from typing import Any

from derive.check.counting import alone, count
from derive.check.report import RelationVerdict
from derive.check.shooting import Rod
from derive.check.text import examples
from derive.check.text.forms import Judge, Variants, open_verdict, refuted
from derive.check.verdicts import CERTIFIED, UNKNOWN
from derive.paper.text_claims import TextClaim

BALLS = "ball arithmetic"
REGIONS = [Fraction(k, 1000) for k in (1, 2, 4)]  # ends of regions tried for the first example
UNDECIDED = "the enclosures do not decide"


def _rod(claim: TextClaim, beta: str, *, across: bool = False) -> Rod:
    return Rod(Fraction(claim.data["length"]), Fraction(claim.data["clamp"]), Fraction(beta), across)


def _found(title: str, said: Any, found: Any, note: str = "") -> RelationVerdict:
    """A value that was certified, against what is said; nothing was certified if it is None or empty."""
    if found in (None, ""):
        return open_verdict(title, UNKNOWN, BALLS, UNDECIDED)
    if found != said:
        return refuted(title, BALLS, {"said": said, "found": found})
    return open_verdict(title, CERTIFIED, BALLS, note)


def judge_count(theory: Any, claim: TextClaim, decide: Judge) -> list[RelationVerdict]:
    """The number of equilibria."""
    found = count(_rod(claim, claim.data["beta"]), Fraction(claim.data["eta"]))
    title = f"equilibria at beta = {claim.data['beta']}, eta = {claim.data['eta']}"
    return [_found(title, claim.data["number"], found, "exactly this number")]


def vary_count(claim: TextClaim) -> Variants:
    """Other numbers; parameters of which the number is another."""
    for number in (1, 2, 4, 5):
        yield "number", claim.but(number=number)
    for name, factors in (("beta", ("3/4", "5/4")), ("eta", ("1/2", "3/4"))):
        for factor in factors:
            yield "value", claim.but(**{name: str(Fraction(claim.data[name]) * Fraction(factor))})


def judge_kinds(theory: Any, claim: TextClaim, decide: Judge) -> list[RelationVerdict]:
    """Each rod's kind."""
    return [
        _found(f"beta = {beta}: {said} the straight rod", said, examples.kind(_rod(claim, beta)))
        for said in ("through", "past")
        for beta in claim.data[said]
    ]


def vary_kinds(claim: TextClaim) -> Variants:
    """One rod of the other kind."""
    through, past = claim.data["through"], claim.data["past"]
    yield from _moved("through", through, "past", past, claim)
    yield from _moved("past", past, "through", through, claim)


def _moved(name: str, one: Sequence[str], other: str, many: Sequence[str], claim: TextClaim) -> Variants:
    for beta in one:
        yield "curve", claim.but(**{name: [b for b in one if b != beta], other: [*many, beta]})


def judge_transition(theory: Any, claim: TextClaim, decide: Judge) -> list[RelationVerdict]:
    """Through the straight rod at one end, past it at the other: between, the branches are exchanged."""
    return [
        _found(f"beta = {beta}: {said} the straight rod", said, examples.kind(_rod(claim, beta)))
        for said, beta in zip(("through", "past"), claim.data["between"], strict=True)
    ]


def vary_transition(claim: TextClaim) -> Variants:
    """The other intervals of the values that are given."""
    others = claim.data["others"]
    for pair in pairwise(others):
        if list(pair) != claim.data["between"]:
            yield "interval", claim.but(between=list(pair))
    yield "order", claim.but(between=claim.data["between"][::-1])


def judge_effect(theory: Any, claim: TextClaim, decide: Judge) -> list[RelationVerdict]:
    """Each rod's effect, as far as it is certified."""
    share = examples.SHORT if claim.data["effect"] == "increment" else examples.BEYOND
    note = f"for all fields up to {share} of the one in which the rod is straight"
    return [
        _found(f"beta = {beta}: {claim.data['effect']}", claim.data["effect"], examples.effect(_rod(claim, beta)), note)
        for beta in claim.data["betas"]
    ]


def vary_effect(claim: TextClaim) -> Variants:
    """The other effect; a rod that shows the other one."""
    first = "reduction, then inversion"
    yield "effect", claim.but(effect="increment" if claim.data["effect"] == first else first)
    for beta in ("0.0004",) if claim.data["effect"] == first else ("0.0002",):
        yield "curve", claim.but(betas=[*claim.data["betas"], beta])


def judge_bifurcations(theory: Any, claim: TextClaim, decide: Judge) -> list[RelationVerdict]:
    """A region that makes it true, or a pair of rods that makes it false for every region."""
    inside, outside = (tuple(_rod(claim, beta) for beta in claim.data[name]) for name in ("inside", "outside"))
    end = examples.region(inside, outside, 1 + 2 * claim.data["pairs"])
    title = "new equilibria inside the region, and none outside"
    if end is not None:
        note = f"the region is not printed: true of one that ends at eta = {float(end)}"
        return [open_verdict(title, CERTIFIED, BALLS, note)]
    against = examples.exchanged(inside, outside)
    if against is not None:
        return [refuted(title, BALLS, {"eta": float(against), "found": "new equilibria outside before those inside"})]
    numbers = {count(rod, examples.FIELDS[-1]) for rod in inside}
    if None not in numbers and numbers != {1 + 2 * claim.data["pairs"]}:
        return [refuted(title, BALLS, {"eta": float(examples.FIELDS[-1]), "numbers": sorted(map(str, numbers))})]
    return [open_verdict(title, UNKNOWN, BALLS, UNDECIDED)]


def vary_bifurcations(claim: TextClaim) -> Variants:
    """A rod inside exchanged for one outside, one of them the first or the last; another number of pairs."""
    inside, outside = claim.data["inside"], claim.data["outside"]
    for n, one in enumerate(inside):
        for m, other in enumerate(outside):
            if n and m + 1 < len(outside):
                continue
            swapped = {
                "inside": [*inside[:n], other, *inside[n + 1 :]],
                "outside": [*outside[:m], one, *outside[m + 1 :]],
            }
            yield "curve", claim.but(**swapped)
    yield "number", claim.but(pairs=claim.data["pairs"] + 1)


def judge_shrinks(theory: Any, claim: TextClaim, decide: Judge) -> list[RelationVerdict]:
    """The displacement falls with the field as far as it takes for the share."""
    share, found = Fraction(claim.data["share"]), []
    for beta in claim.data["betas"]:
        rod, title = _rod(claim, beta, across=True), f"beta = {beta}: the displacement falls to {share} of what it was"
        for eta in REGIONS:
            left = examples.share_left(rod, eta)
            if left is not None and left <= share:
                falls = alone(rod, Fraction(0), eta, sense=-1, tips=examples.QUARTER)
                note = f"of what it was at most {left:.4f} at eta = {float(eta)} (the fields are not printed)"
                found.append(open_verdict(title, CERTIFIED if falls else UNKNOWN, BALLS, note if falls else UNDECIDED))
                break
        else:
            found.append(refuted(title, BALLS, {"eta": float(REGIONS[-1]), "share": left}))
    return found


def vary_shrinks(claim: TextClaim) -> Variants:
    """A share that these fields do not reach."""
    yield "number", claim.but(share="1/50")
