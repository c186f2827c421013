"""The rectangle of half-periods 0, ω₁, ω₂, ω₃ in numbers: its corners, and the point of its perimeter where ℘ = c.

On the sides through 0, u = R_F(c − e₁, c − e₂, c − e₃) (DLMF 19.25.35), for c < e₃ turned by i. The two others are
those two moved by ω₁ and ω₃, where ℘(u + ω) = e + (e − e′)(e − e″)/(℘(u) − e) (DLMF 23.10(iii)).
"""

from __future__ import annotations

from functools import lru_cache
from typing import Any

from mpmath import mp

from derive.check import elliptic

Number = Any  # mpf or mpc


def half_values(g2: Number, g3: Number) -> list[Number]:
    """e₁ > e₂ > e₃; DegenerateError unless they are real and distinct."""
    if mp.im(g2) != 0 or mp.im(g3) != 0 or mp.re(g2) ** 3 <= 27 * mp.re(g3) ** 2:
        raise elliptic.DegenerateError("the half-period values are not real and distinct")
    return sorted((mp.re(e) for e in elliptic.roots(g2, g3)), reverse=True)


def half_period(n: Number, g2: Number, g3: Number) -> Number:
    """ωₙ: ω₁ = R_F(0, e₁ − e₂, e₁ − e₃), ω₃ = i R_F(0, e₂ − e₃, e₁ − e₃), ω₂ = ω₁ + ω₃."""
    corners = _corners(g2, g3, mp.dps)
    if n not in corners:
        raise elliptic.DegenerateError("there are three half-periods")
    return +corners[int(n)]


def perimeter_point(c: Number, g2: Number, g3: Number) -> Number:
    """The point of the perimeter where ℘ = c."""
    if mp.im(c) != 0:
        raise elliptic.DegenerateError("℘ is real on the rectangle")
    return +_found(mp.re(c), g2, g3, mp.dps)


@lru_cache(maxsize=512)
def _corners(g2: Number, g3: Number, dps: int) -> dict[int, Number]:
    with mp.workdps(dps + elliptic.GUARD):
        e1, e2, e3 = half_values(g2, g3)
        across, along = mp.elliprf(0, e1 - e2, e1 - e3), mp.mpc(0, mp.elliprf(0, e2 - e3, e1 - e3))
        return {1: across, 2: across + along, 3: along}


@lru_cache(maxsize=512)
def _found(c: Number, g2: Number, g3: Number, dps: int) -> Number:
    corners = _corners(g2, g3, dps)
    with mp.workdps(dps + elliptic.GUARD):
        e1, e2, e3 = e = half_values(g2, g3)
        if e3 < c <= e2:
            return corners[3] + _side(e3 + (e3 - e1) * (e3 - e2) / (c - e3), e)
        if e2 < c < e1:
            return corners[1] + _side(e1 + (e1 - e2) * (e1 - e3) / (c - e1), e)
        return _side(c, e)


def _side(c: Number, e: list[Number]) -> Number:
    """The point on a side that meets 0."""
    if c >= e[0]:
        return mp.elliprf(*(c - value for value in e))
    return mp.mpc(0, mp.elliprf(*(value - c for value in e)))
