"""Properties of ℘ on the rectangle of half-periods, for the ℘ of a load case.

zeros    function = wp, wp_prime or wp_second, at: it vanishes at these points, where f does
pole     at: there ξ is infinite
falls    path: around the rectangle, along which ℘ falls from +∞ to −∞; and ξ is monotone in ℘
slope    segment = [from, to], is: the sign of ℘′ there, of its imaginary part if it is imaginary
"""

from __future__ import annotations

from itertools import pairwise
from typing import Any

from mpmath import mp
from sympy import Expr, oo

from derive.check import elliptic
from derive.check.report import RelationVerdict
from derive.check.text.forms import Judge, Variants, case_of, decided, exactly, refuted, samples, where
from derive.check.text.periods import CORNERS, value_at
from derive.check.verdicts import PROVED
from derive.paper.text_claims import TextClaim
from derive.theory.claims import Equal, Positive
from derive.theory.uo_cases import HALF_PERIODS, UoCase

DIGITS = 30
FUNCTIONS = ("wp", "wp_prime", "wp_second")
SIGNS = ("positive", "negative", "imaginary positive", "imaginary negative")


def _value(theory: Any, claim: TextClaim, kind: UoCase, place: str) -> Expr:
    """℘ at a corner of the rectangle, or at v."""
    if place == "v":
        case = case_of(theory, claim)
        return theory.weierstrass[claim.scope].at_one.c.subs(case.constant, case.tip_constant)
    return oo if place == "0" else value_at(theory, claim, kind.roots[HALF_PERIODS.index(place)])


def judge_zeros(theory: Any, claim: TextClaim, decide: Judge) -> list[RelationVerdict]:
    """The function at each point, by the value of ℘ there: ℘′² = 4℘³ − g₂℘ − g₃ and ℘″ = 6℘² − g₂/2."""
    case, functions, found = case_of(theory, claim), theory.weierstrass[claim.scope], []
    g2, g3 = (g.subs(case.constant, case.tip_constant) for g in (functions.g2, functions.g3))
    for kind in functions.uo_cases:
        for place in claim.data["at"]:
            title, value = f"{claim.data['function']} = 0 at {place}", _value(theory, claim, kind, place)
            if value == oo:
                found.append(refuted(title, "a pole", {place: "infinite"}))
                continue
            of = {"wp": value, "wp_prime": 4 * value**3 - g2 * value - g3, "wp_second": 6 * value**2 - g2 / 2}
            found.append(decided(decide, title, Equal(of[claim.data["function"]], 0), kind.domain))
    return found


def vary_zeros(claim: TextClaim) -> Variants:
    """Another function; another point."""
    for other in FUNCTIONS:
        if other != claim.data["function"]:
            yield "function", claim.but(function=other)
    at = claim.data["at"]
    for n in range(len(at)):
        for other in ("0", "v"):
            yield "half-period", claim.but(at=[*at[:n], other, *at[n + 1 :]])


def judge_pole(theory: Any, claim: TextClaim, decide: Judge) -> list[RelationVerdict]:
    """1/ξ = (℘ − c)/(a(℘ − c) + b) is 0 there."""
    case, at, found = case_of(theory, claim), theory.weierstrass[claim.scope].at_one, []
    b, c = (part.subs(case.constant, case.tip_constant) for part in (at.b, at.c))
    for kind in theory.weierstrass[claim.scope].uo_cases:
        value, title = _value(theory, claim, kind, claim.data["at"]), f"xi is infinite at {claim.data['at']}"
        if value == oo:
            found.append(refuted(title, "a value", {"xi": at.a}))
        else:
            found.append(decided(decide, title, Equal((value - c) / (at.a * (value - c) + b), 0), kind.domain))
    return found


def vary_pole(claim: TextClaim) -> Variants:
    """At another point."""
    yield from (("half-period", claim.but(at=other)) for other in CORNERS if other != claim.data["at"])


def judge_falls(theory: Any, claim: TextClaim, decide: Judge) -> list[RelationVerdict]:
    """℘ is real on the sides, and ℘′ ≠ 0 between corners: ℘ is monotone on each, in the sense of its ends."""
    case, path, found = case_of(theory, claim), claim.data["path"], []
    sides = [tuple(sorted((CORNERS.index(one), CORNERS.index(other)))) for one, other in pairwise(path)]
    around = set(sides) == {(0, 1), (1, 2), (2, 3), (0, 3)} and path[0] == path[-1] == "0"
    found.append(exactly("the path runs around the rectangle from 0 to 0", around, "enumeration", {"path": path}))
    for kind in theory.weierstrass[claim.scope].uo_cases:
        for one, other in pairwise(path):
            if "0" not in (one, other):
                gap = _value(theory, claim, kind, one) - _value(theory, claim, kind, other)
                found.append(decided(decide, f"wp falls from {one} to {other}", Positive(gap), kind.domain))
    at = theory.weierstrass[claim.scope].at_one
    tried = [decided(decide, "b has one sign", Positive(sign * at.b), where(case)) for sign in (1, -1)]
    return [*found, min(tried, key=lambda one: one.verdict.verdict != PROVED)]


def vary_falls(claim: TextClaim) -> Variants:
    """The other way round; neighbours exchanged."""
    path = claim.data["path"]
    yield "sense", claim.but(path=path[::-1])
    for n in range(1, len(path) - 2):
        yield "order", claim.but(path=[*path[:n], path[n + 1], path[n], *path[n + 2 :]])


def judge_slope(theory: Any, claim: TextClaim, decide: Judge) -> list[RelationVerdict]:
    """℘ falls around the rectangle: by how it goes, ℘′ is this; and its value in the middle at random points."""
    start, end = (CORNERS.index(corner) for corner in claim.data["segment"])
    along = "imaginary " if {start, end} in ({1, 2}, {0, 3}) else ""
    forward = (end - start) % 4 == 1
    # Real sides run to the right from 0 and to the left from ω₂; upright ones up from ω₁ and down from ω₃.
    rightward = {0: True, 1: True, 2: False, 3: False}[start if forward else end]
    # dξ to the right: ℘′ < 0 where ℘ falls to the right; upwards, d℘/dy = i℘′.
    by_order = along + ("positive" if bool(along) == rightward else "negative")
    title = f"wp' is {claim.data['is']} from {' to '.join(claim.data['segment'])}"
    found = [exactly(title, claim.data["is"] == by_order, "order of the half-period values", {"wp'": by_order})]
    functions = theory.weierstrass[claim.scope]
    for _, (g2, g3) in samples([functions.g2, functions.g3], where(case_of(theory, claim)), 3):
        seen = _seen(g2, g3, start, end)
        found.append(exactly(title, claim.data["is"] == seen, f"a value at {DIGITS} digits", {"wp'": seen}))
    return found


def _seen(g2: Any, g3: Any, start: int, end: int) -> str:
    """What ℘′ is in the middle of a side."""
    with mp.workdps(DIGITS):
        e1, e2, e3 = sorted((mp.re(root) for root in elliptic.roots(g2, g3)), reverse=True)
        real, upright = (mp.pi / (2 * mp.agm(mp.sqrt(e1 - e3), mp.sqrt(gap))) for gap in (e1 - e2, e2 - e3))
        corners = [mp.mpc(0), mp.mpc(real), mp.mpc(real, upright), mp.mpc(0, upright)]
        value = elliptic.wp_prime((corners[start] + corners[end]) / 2, g2, g3)
        imaginary = abs(mp.im(value)) > abs(mp.re(value))
        part = mp.im(value) if imaginary else mp.re(value)
        return ("imaginary " if imaginary else "") + ("positive" if part > 0 else "negative")


def vary_slope(claim: TextClaim) -> Variants:
    """The other signs; the other sides."""
    yield from (("sign", claim.but(**{"is": sign})) for sign in SIGNS if sign != claim.data["is"])
    for ends in zip(CORNERS, (*CORNERS[1:], CORNERS[0]), strict=True):
        if set(ends) != set(claim.data["segment"]):
            yield "segment", claim.but(segment=list(ends))
