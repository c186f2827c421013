"""Around the rectangle of half-periods 0, ω₁, ω₂, ω₃: where on its sides ℘ has a real value c, and ℘′ there.

As u goes round from 0 by ω₁, ω₂, ω₃ back to 0, ℘ falls from +∞ to −∞ through e₁, e₂, e₃ at the corners. On each side u
is a real integral of c, times the direction of the side, and ℘′ is one over the derivative of that (DLMF 19.25.35, with
23.10(iii) for the sides that do not meet 0).
"""

from __future__ import annotations

from dataclasses import dataclass

from sympy import Derivative, Expr, I, S, Symbol, oo, sqrt

from .claims import Domain, Equal, Notebook
from .functions import RF

c, e1, e2, e3 = (Symbol(name, real=True) for name in ("c", "e_1", "e_2", "e_3"))


@dataclass(frozen=True)
class Side:
    """One side. phase: ℘′ over its modulus. above: how many of e₁, e₂, e₃ are greater than ℘ there."""

    phase: Expr
    above: int

    def slope(self, value: Expr, halves: tuple[Expr, Expr, Expr]) -> Expr:
        """℘′ where ℘ has the value, of the half-period values e₁ > e₂ > e₃, by positive roots."""
        result = 2 * self.phase
        for n, half in enumerate(halves):
            result = result * sqrt(half - value if n < self.above else value - half)
        return result


SIDES = {
    "(0, omega_1)": Side(S.NegativeOne, 0),
    "(omega_1, omega_2)": Side(I, 1),
    "(omega_3, omega_2)": Side(S.One, 2),
    "(omega_3, 0)": Side(-I, 3),
}


def claim_sides(book: Notebook) -> None:
    """℘′ on each side, for any half-period values."""
    book.say("The rectangle of half-periods: ℘′ on its sides")
    halves = (e1, e2, e3)
    order = Domain({e3: (-oo, oo), e2: (e3, oo), e1: (e2, oo)})
    ends = ((e1, oo), (e2, e1), (e3, e2), (-oo, e3))
    for (name, side), (lower, upper), run in zip(SIDES.items(), ends, _runs(), strict=True):
        turn = Equal(Derivative(run, c), 1 / side.slope(c, halves))
        title = f"℘′ on {name} is one over du/d℘"
        key = f"weierstrass.side_{name.strip('()').replace(', ', '_')}"
        book.claim(key, title, turn, domain=order.with_range(c, lower, upper), source="DLMF 19.25.35")


def _runs() -> tuple[Expr, ...]:
    """u less a corner on the four sides, as a function of ℘ = c."""

    def across(value: Expr) -> Expr:
        return RF(value - e1, value - e2, value - e3)

    def along(value: Expr) -> Expr:
        return I * RF(e1 - value, e2 - value, e3 - value)

    def moved(corner: Expr, one: Expr, other: Expr) -> Expr:
        return corner + (corner - one) * (corner - other) / (c - corner)

    return across(c), along(moved(e1, e2, e3)), across(moved(e3, e1, e2)), along(c)


def slope_by_field(side: Side, size: Expr, strength: Expr) -> Expr:
    """℘′(v) on a side, from ℘′(v)² = Hb²: its phase times √(|H|b²); size: |H|, strength: b."""
    return side.phase * sqrt(size * strength**2)
