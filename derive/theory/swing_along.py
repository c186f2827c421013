"""Integrals along the motion as claims, for both signs of the discriminant.

x = b cot(δ/2) falls from infinity at the tip to ê₁ at the far turning point; dσ = −dx/(2√X₁√X₂√X₃), X_i = x − ê_i. The
roots ê₂ and ê₃ are real, or conjugate.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass

from sympy import Derivative, Expr, Function, I, Integer, Poly, Symbol, oo, prod, sqrt, symbols

from .claims import Domain, Equal, Limit
from .functions import RJ
from .oblique_quartic import m, n, q
from .oblique_shape import b
from .swing_names import Writer
from .swing_points import x
from .tip_along import q as small
from .tip_along import scaled
from .tip_names import x_pole

e_1, e_2, e_3, f = symbols("e_1 e_2 e_3 f", real=True)  # ê₁, ê₂, ê₃; or ê₂, ê₃ = f ± ig
g = Symbol("g", positive=True)
FREE = {x: (-oo, oo), b: (0, oo)}
# R_J along the motion, with the fourth argument x − ib and with its conjugate; its real and imaginary part by both.
BELOW, OVER = Function("R_below")(x), Function("R_over")(x)
THIRD_KIND = (BELOW + OVER) / 2, (BELOW - OVER) / (2 * I)
# cos δ and sin δ by t = b/x.
COSINE, SINE = (x**2 - b**2) / (x**2 + b**2), 2 * b * x / (x**2 + b**2)


@dataclass(frozen=True)
class Kind:
    """One sign of the discriminant: the half-period values less c, and where they and x are."""

    name: str
    title: str
    roots: tuple[Expr, Expr, Expr]
    domain: Domain

    @property
    def letters(self) -> dict[Symbol, Expr]:
        """q, m, n of C by its roots."""
        square, linear, constant = Poly(4 * prod(x - root for root in self.roots), x).all_coeffs()[1:]
        return {q: square, m: linear / b, n: constant / b**2}

    @property
    def gaps(self) -> tuple[Expr, Expr, Expr]:
        """X₁, X₂, X₃."""
        first, second, third = (x - root for root in self.roots)
        return first, second, third

    @property
    def speed(self) -> Expr:
        """√(X₁X₂X₃) = −x_σ/2."""
        first, second, third = map(sqrt, self.gaps)
        return first * second * third

    @property
    def third_kind(self) -> tuple[tuple[Expr, Expr], ...]:
        """What R_J is with the fourth arguments x − ib and x + ib, where a claim has names for both."""
        return (BELOW, RJ(*self.gaps, x - I * b)), (OVER, RJ(*self.gaps, x + I * b))

    def slope(self, integral: Expr, integrand: Expr) -> Equal:
        """The integral differentiates back: along x it is the integrand times dσ/dx."""
        return Equal(Derivative(integral, x), -integrand / (2 * self.speed))

    def start(self, integral: Expr, domain: Domain) -> tuple[Limit, Domain]:
        """The integral vanishes at the tip, where x is infinite."""
        ranges = {symbol: ends for symbol, ends in domain.ranges.items() if symbol != x}
        zero = Limit(scaled(integral.subs(x, x_pole)), small, Integer(0), Integer(0), "+")
        return zero, Domain({**ranges, small: (0, 1)})


REAL = Domain({**dict.fromkeys((e_1, e_2, e_3), (-oo, oo)), **FREE}, (x - e_1, x - e_2, x - e_3))
TWO = Domain({e_1: (-oo, oo), f: (-oo, oo), g: (0, oo), **FREE}, (x - e_1,))
KINDS = (
    Kind("three", "three real roots", (e_1, e_2, e_3), REAL),
    Kind("pair", "a conjugate pair", (e_1, f + I * g, f - I * g), TWO),
)


def claim_integral(
    writer: Writer,
    name: str,
    what: str,
    integral: Callable[[Kind], Expr],
    integrand: Callable[[Kind], Expr],
    kinds: tuple[Kind, ...] = KINDS,
    *,
    more: Mapping[Symbol, tuple[Expr, Expr]] | None = None,
    steps: Iterable[str],
    source: str = "",
) -> None:
    """An integral along the motion, for each kind by its derivative and its value at the tip.

    more: ranges of further symbols in it.
    """
    for kind in kinds:
        where = Domain({**(more or {}), **kind.domain.ranges}, kind.domain.conditions)
        same, key = kind.slope(integral(kind), integrand(kind)), f"{name}_{kind.name}"
        title, given = f"{what}: {kind.title}", kind.third_kind
        writer.claim(key, title, same, where, given=given, steps=steps, source=source)
        zero, where = kind.start(integral(kind).subs(dict(given)), where)
        writer.claim(f"{key}_tip", f"{what}: the value at the tip", zero, where, steps=(key,), source=source)
