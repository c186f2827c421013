"""Where the rod and the pole of ξ lie on the rectangle of half-periods, and where the rod begins.

The theory knows the kinds of rods of a load case: the roots of f at ω₁, ω₂, ω₃ and the half-period at the tip, each
with its domain in ξ(ℓ) (``uo_cases``). A claim chooses kinds by conditions, and must hold for all that it chooses.

start     roots = {half-period: root}, tip = half-period: of the kinds chosen
segment   of = v (where ξ is infinite) or rod, segment = [end, end]
conditions: when = [[root, relation, number]], towards = increasing or decreasing (ξ towards the tip),
clamp = [above or below, root]: where cos θ(0) lies
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from sympy import Expr, Integer

from derive.check.report import RelationVerdict
from derive.check.text.forms import (
    RELATIONS,
    Judge,
    Variants,
    case_of,
    decided,
    exactly,
    refuted,
    samples,
    with_xi,
)
from derive.check.verdicts import PROVED
from derive.paper.text_claims import TextClaim
from derive.theory.claims import Equal, Positive
from derive.theory.load_case import LoadCase, xi_tip
from derive.theory.symbols import xi
from derive.theory.uo_cases import HALF_PERIODS, UoCase

CORNERS = ("0", *HALF_PERIODS)  # of the rectangle, in order


def value_at(theory: Any, claim: TextClaim, root: Expr) -> Expr:
    """℘ where ξ has a value, with the constant of the tip."""
    case, functions = case_of(theory, claim), theory.weierstrass[claim.scope]
    if functions.linear is None:
        value = functions.at_one.value_at(root)
    else:
        value = (root - functions.linear[0]) / functions.linear[1]
    return value.subs(case.constant, case.tip_constant)


def named(case: LoadCase, kind: UoCase) -> dict[str, Expr]:
    """The roots of f by name, in ξ(ℓ); which of the two of f̂ is the smaller, a random point of the kind tells."""
    names: dict[str, Expr] = {"1": Integer(1), "-1": Integer(-1)}
    if case.other_root is None:
        return names | {"xi_2": xi_tip}
    _, (tip, other) = next(samples([xi_tip, case.other_root], kind.domain, 1))
    pair = (xi_tip, case.other_root) if tip < other else (case.other_root, xi_tip)
    return names | dict(zip(("xi_a", "xi_b"), pair, strict=True))


def span(case: LoadCase, kind: UoCase) -> tuple[str, Expr]:
    """On which side of ξ(ℓ) the rod's ξ lies, and how far it may go: where f > 0, to the next root, within [−1, 1]."""
    values = named(case, kind)
    names = sorted(values)
    f = case.f.subs(case.constant, case.tip_constant)
    _, at = next(samples([values[name] for name in names], kind.domain, 1))
    tip = next(value for name, value in zip(names, at, strict=True) if values[name] == xi_tip)
    for side, sign in (("below", -1), ("above", 1)):
        beyond = sorted(
            (sign * (value - tip), name) for name, value in zip(names, at, strict=True) if sign * (value - tip) > 0
        )
        if not beyond:
            continue
        middle = (xi_tip + values[beyond[0][1]]) / 2
        (height, place), *_ = [value for _, value in samples([f.subs(xi, middle), middle], kind.domain, 1)]
        if height > 0 and abs(place) < 1:
            return side, values[beyond[0][1]]
    raise ValueError(f"no rod ends at the tip of '{kind.condition}'")


def kinds(theory: Any, claim: TextClaim, decide: Judge) -> Iterator[UoCase]:
    """The kinds of rods that meet the conditions of a claim."""
    case = case_of(theory, claim)
    for kind in theory.weierstrass[claim.scope].uo_cases:
        values, (side, _) = named(case, kind), span(case, kind)
        if claim.data.get("towards") not in (None, {"below": "increasing", "above": "decreasing"}[side]):
            continue
        if "clamp" in claim.data and (side, xi_tip) != (claim.data["clamp"][0], values[claim.data["clamp"][1]]):
            continue
        gaps = [
            (values[left] - values[right]) * (1 if relation == ">" else -1)
            for left, relation, right in claim.data.get("when", [])
        ]
        if all(decided(decide, "condition", Positive(gap), kind.domain).verdict.verdict == PROVED for gap in gaps):
            yield kind


def _each(theory: Any, claim: TextClaim, decide: Judge) -> list[UoCase] | RelationVerdict:
    found = list(kinds(theory, claim, decide))
    return found or refuted("the conditions", "enumeration of the rods", {"rods that meet the conditions": 0})


def judge_start(theory: Any, claim: TextClaim, decide: Judge) -> list[RelationVerdict]:
    """The half-period at the tip, and the roots at half-periods; that these are in their order is a sign each."""
    chosen = _each(theory, claim, decide)
    if isinstance(chosen, RelationVerdict):
        return [chosen]
    case, found = case_of(theory, claim), []
    for kind in chosen:
        if "tip" in claim.data:
            title, there = f"u_o = {claim.data['tip']} - l ({kind.condition})", {"half-period": kind.half_period}
            found.append(exactly(title, claim.data["tip"] == kind.half_period, "enumeration of the rods", there))
        for place, root in claim.data["roots"].items():
            title = f"xi is {root} at {place} ({kind.condition})"
            right = Equal(named(case, kind).get(root, Integer(0)), kind.roots[HALF_PERIODS.index(place)])
            found.append(decided(decide, title, right, kind.domain))
        values = [value_at(theory, claim, root) for root in kind.roots]
        for n in (0, 1):
            title = f"wp falls from {HALF_PERIODS[n]} to {HALF_PERIODS[n + 1]} ({kind.condition})"
            found.append(decided(decide, title, Positive(values[n] - values[n + 1]), kind.domain))
    return found


def judge_segment(theory: Any, claim: TextClaim, decide: Judge) -> list[RelationVerdict]:
    """℘ is real on the rectangle and falls around it: its value tells the segment."""
    chosen = _each(theory, claim, decide)
    if isinstance(chosen, RelationVerdict):
        return [chosen]
    case, found = case_of(theory, claim), []
    for kind in chosen:
        domain, value = kind.domain, theory.weierstrass[claim.scope].at_one.c
        if claim.data["of"] == "rod":
            side, end = span(case, kind)
            domain = with_xi(domain, *((end, xi_tip) if side == "below" else (xi_tip, end)))
            value = value_at(theory, claim, xi)
        value = value.subs(case.constant, case.tip_constant)
        for title, gap in _bounds(claim, [value_at(theory, claim, root) for root in kind.roots], value):
            found.append(decided(decide, f"{title} ({kind.condition})", Positive(gap), domain))
    return found


def _bounds(claim: TextClaim, corners: list[Expr], value: Expr) -> Iterator[tuple[str, Expr]]:
    """What must be positive for a value of ℘ to be taken on a segment."""
    places = sorted(CORNERS.index(end) for end in claim.data["segment"])
    upper, lower = (0, 1) if places == [0, 1] else (3, 4) if places == [0, 3] else tuple(places)
    if upper > 0:
        yield f"wp is below its value at {CORNERS[upper]}", corners[upper - 1] - value
    if lower < 4:
        yield f"wp is above its value at {CORNERS[lower]}", value - corners[lower - 1]


def _conditions(claim: TextClaim) -> Variants:
    """The opposite condition: of the sense, else of the clamp, else of the roots; the others may be idle beside it."""
    if "towards" in claim.data:
        yield "condition", claim.but(towards="increasing" if claim.data["towards"] == "decreasing" else "decreasing")
    elif "clamp" in claim.data:
        side, root = claim.data["clamp"]
        yield "condition", claim.but(clamp=["above" if side == "below" else "below", root])
    else:
        when = claim.data.get("when", [])
        for n, (left, relation, right) in enumerate(when):
            yield "condition", claim.but(when=[*when[:n], [left, RELATIONS[relation], right], *when[n + 1 :]])


def vary_start(claim: TextClaim) -> Variants:
    """The opposite condition; another half-period; another root."""
    if len(claim.data["roots"]) == 1:  # else two kinds may share what is said of their roots
        yield from _conditions(claim)
    for place in HALF_PERIODS:
        if place != claim.data.get("tip", place):
            yield "half-period", claim.but(tip=place)
    for place, root in claim.data["roots"].items():
        for other in ("1", "-1", "xi_a", "xi_b", "xi_2"):
            if other != root:
                yield "root", claim.but(roots={**claim.data["roots"], place: other})


def vary_segment(claim: TextClaim) -> Variants:
    """The other segments; the opposite condition where it decides."""
    for ends in zip(CORNERS, (*CORNERS[1:], CORNERS[0]), strict=True):
        if set(ends) != set(claim.data["segment"]):
            yield "segment", claim.but(segment=list(ends))
    yield from _conditions(claim)
