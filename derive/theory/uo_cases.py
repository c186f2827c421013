"""Where the rod begins in the plane of u: u_o = ω − ℓ, and the roots of f at the half-periods (after exsl31, exhpf12).

ω₁ is the real half-period, ω₃ the imaginary one, ω₂ = ω₁ + ω₃, so that ℘(ω₁) > ℘(ω₂) > ℘(ω₃).
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from itertools import pairwise

from sympy import Expr, Integer, factor, oo

from .claims import Domain, Equal, Notebook, Positive
from .load_case import COSINES, LoadCase, linear_root, xi_tip
from .perimeter import SIDES, slope_by_field
from .symbols import beta, xi

HALF_PERIODS = ("omega_1", "omega_2", "omega_3")
PLACES = {"(0, omega_1)": 0, "(omega_1, omega_2)": 1, "(omega_3, 0)": 3}  # of ℘(v) among the half-period values


@dataclass(frozen=True)
class UoCase:
    """One case of u_o = (half-period) − ℓ.

    condition: when it holds. roots: the roots of f at ω₁, ω₂, ω₃, in ξ(ℓ). half_period: the one at the tip, where
    ξ = ξ(ℓ). value: ξ(ℓ), by name of the root. pole: the segment on which v lies (ξ = ∞). domain: in ξ(ℓ).
    """

    condition: str
    roots: tuple[Expr, Expr, Expr]
    half_period: str
    value: str
    pole: str
    domain: Domain


def uo_cases(
    case: LoadCase,
    value_at: Callable[[Expr], Expr],
    pole: tuple[Expr, Expr] | None,
    cubic: Callable[[Expr], Expr],
    book: Notebook,
) -> tuple[UoCase, ...]:
    """All cases of a load case. value_at: ℘ at a root of f. pole: ℘(v) and b, if v ≠ 0. cubic: 4ϰ³ − g₂ϰ − g₃ at ϰ."""
    found = {1: _bending, 0: _without_field, -1: _straightening}[case.bends](case)
    for number, one in enumerate(found, start=1):
        name = f"weierstrass.{case.name}.start_{number}"
        source = case.source("start")
        rests = case.ids("weierstrass.roots") if case.bends else case.ids("weierstrass.linear", "quartic.free_end")
        to_tip = {case.constant: case.tip_constant}
        values = [value_at(root).subs(to_tip) for root in one.roots]
        for half_period, value in zip(HALF_PERIODS, values, strict=True):
            root = Equal(cubic(value).subs(to_tip), 0)
            title = f"{one.condition}: ℘ at {half_period}"
            book.claim(f"{name}_{half_period}", title, root, domain=one.domain, steps=rests, source=source)
        rests = tuple(f"{name}_{half_period}" for half_period in HALF_PERIODS)
        _claim_tip(case, one, values, name, value_at, book)
        # Down the real values of ℘ on the rectangle: ℘(ω₁) > ℘(ω₂) > ℘(ω₃), with ℘(v) on its segment.
        if pole is not None:
            _claim_slope(case, one, values, pole, name, rests, book)
            values.insert(PLACES[one.pole], pole[0].subs(to_tip))
        if pole is not None:
            rests += case.ids("weierstrass.slope")
        steps = [above - below for above, below in pairwise(values)]
        for place, step in enumerate(steps, start=1):
            title = f"{one.condition}: the order of the half-period values and ℘(v)"
            order = Positive(factor(step))
            book.claim(f"{name}_order_{place}", title, order, domain=one.domain, steps=rests, source=source)
        whole = Equal(sum(steps, start=values[-1]), values[0])
        title = f"{one.condition}: the steps lead from the first to the last"
        rests = tuple(f"{name}_order_{place}" for place, _ in enumerate(steps, start=1))
        book.claim(f"{name}_whole", title, whole, domain=one.domain, steps=rests, source=source)
        book.say(f"{one.condition}: ξ(ℓ) = {one.value}, u_o = {one.half_period} − ℓ")
    return tuple(found)


def _claim_slope(
    case: LoadCase,
    one: UoCase,
    halves: list[Expr],
    pole: tuple[Expr, Expr],
    name: str,
    rests: tuple[str, ...],
    book: Notebook,
) -> None:
    """℘′(v) with its sign, from the side on which v lies (text after exsl29, exhpf13bis)."""
    (place, strength), side = (value.subs({case.constant: case.tip_constant}) for value in pole), SIDES[one.pole]
    slope = Equal(
        side.slope(place, (halves[0], halves[1], halves[2])), slope_by_field(side, abs(case.stiffness), strength)
    )
    rests = (*rests, f"weierstrass.side_{one.pole.strip('()').replace(', ', '_')}", *case.ids("weierstrass.slope"))
    title, source = f"{one.condition}: ℘′(v) on {one.pole}", case.source("slope on side")
    book.claim(f"{name}_slope", title, slope, domain=one.domain, steps=rests, source=source)


def _claim_tip(
    case: LoadCase, one: UoCase, halves: list[Expr], name: str, value_at: Callable[[Expr], Expr], book: Notebook
) -> None:
    """ξ(u) at u = u_o + ℓ = ω̄ is ξ(ℓ): ℘ there is the value that belongs to the root ξ(ℓ) of f̂."""
    at_tip = HALF_PERIODS.index(one.half_period)
    to_tip = {case.constant: case.tip_constant}
    known = Equal(halves[at_tip], value_at(xi_tip).subs(to_tip))
    root = Equal(case.f_hat.subs(to_tip).subs(xi, one.roots[at_tip]), 0)
    title, source = f"{one.condition}: ξ(ω̄) is a root of f̂", case.source("tip")
    steps = (*case.ids("quartic.free_end"), f"{name}_{one.half_period}")
    book.claim(f"{name}_tip_root", title, root, domain=one.domain, steps=steps, source=source)
    title, steps = f"{one.condition}: ℘(ω̄) belongs to ξ(ℓ)", (f"{name}_tip_root",)
    book.claim(f"{name}_tip", title, known, domain=one.domain, steps=steps, source=source)


def _start(case: LoadCase, condition: str, order: str, value: str, pole: str, domain: Domain) -> UoCase:
    """A case from the order of the roots: letters p, m, t, o for 1, −1, ξ(ℓ) and the other root of f̂."""
    letters = {"p": Integer(1), "m": Integer(-1), "t": xi_tip, "o": case.other_root}
    roots = tuple(letters[letter] for letter in order)
    return UoCase(condition, roots, HALF_PERIODS[order.index("t")], value, pole, domain)


def _strong_force(case: LoadCase, gap: Expr) -> Domain:
    """ξ(ℓ) anywhere, and the force so large that the gap, which falls with it, is negative."""
    others = {p: (0, oo) for p in case.parameters if p != beta}
    return Domain({xi_tip: COSINES, **others, beta: (linear_root(gap, beta), oo)})


def _bending(case: LoadCase) -> list[UoCase]:
    """H > 0: 1 is the greatest root, b > 0, and ℘(v) = c is above all half-period values (text after exsl31)."""
    other, above = case.other_root, "(0, omega_1)"
    assert other is not None
    meets = linear_root(1 + other, xi_tip)
    upper, lower = case.steep(xi_tip=(case.vertex, meets)), case.steep(xi_tip=(COSINES[0], case.vertex))
    found = [
        _start(case, "ξ_a > −1, ξ increasing towards the tip", "mot", "xi_b", above, upper),
        _start(case, "ξ_a > −1, ξ decreasing towards the tip", "mto", "xi_a", above, lower),
    ]
    if case.tip_force != 0:
        found.insert(0, _start(case, "ξ_a < −1", "omt", "xi_b", above, _strong_force(case, 1 + other)))
    return found


def _straightening(case: LoadCase) -> list[UoCase]:
    """H < 0: −1 is the smallest root; v lies below or between the half-period values (text after exhpf12)."""
    other, below, amid = case.other_root, "(omega_3, 0)", "(omega_1, omega_2)"
    assert other is not None
    meets = linear_root(1 - other, xi_tip)
    upper, lower = case.steep(xi_tip=(case.vertex, 1)), case.steep(xi_tip=(meets, case.vertex))
    found = [
        _start(case, "ξ_b < 1, ξ(0) > ξ_b", "tom", "xi_b", below, upper),
        _start(case, "ξ_b < 1, ξ(0) < ξ_a", "otm", "xi_a", below, lower),
    ]
    if case.tip_force != 0:
        found.append(_start(case, "ξ_b > 1", "omt", "xi_a", amid, _strong_force(case, other - 1)))
    return found


def _without_field(case: LoadCase) -> list[UoCase]:
    """H = 0: the linear map keeps the order of the roots 1, ξ_2, −1; ξ is infinite at u = 0 (after slch11)."""
    return [_start(case, "−1 < ξ_2 < 1", "ptm", "xi_2", "0", case.domain(xi_tip=COSINES))]


__all__ = ["HALF_PERIODS", "UoCase", "uo_cases"]
