"""Points of the rod by p = ℘ − c at the tip's expansion, and integrals along the rod as claims.

ξ = ξ(ℓ) + b/p, and dσ = −dp/(2√x₊√x₋√x_o), from σ = 0 at p = ∞.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from sympy import Derivative, Expr, Pow, Rational, Symbol, expand, oo, sqrt

from .claims import Domain, Equal, Limit
from .functions import RC, RD, RF, RJ
from .load_case import COSINES, LoadCase
from .tip_names import Writer, arc, sin_tip, x_minus, x_other, x_plus, x_pole
from .weierstrass import Expansion

X = {"plus": x_plus, "minus": x_minus, "other": x_other}
q = Symbol("q", positive=True)  # 1/p


class Along:
    """Points of the rod by p = ℘ − c, for one load case."""

    def __init__(self, case: LoadCase, at: Expansion, roots: Mapping[str, Expr], writer: Writer) -> None:
        self.case, self.at, self.roots, self.writer = case, at, roots, writer
        self.x = {X[side]: x_pole - root for side, root in roots.items()}
        self.domain = Domain(
            {**case.domain(xi_tip=COSINES).ranges, sin_tip: (0, 1), x_pole: (0, oo)},
            tuple(self.x.values()),
        )
        self.xi = at.a + at.b / x_pole
        # dσ/dp, from ℘′ = −2√x₊√x₋√x_o: p falls from infinity as σ grows.
        self.rate = Rational(-1, 2) / (sqrt(x_plus) * sqrt(x_minus) * sqrt(x_other))

    def plain(self, expression: Expr) -> Expr:
        """The expression in the parameters, ξ(ℓ) and p; σ is R_F."""
        plain = expression.subs(arc, RF(*X.values())).subs({**self.x, **self.writer.meaning})
        for carlson in (RF, RC, RD, RJ):
            plain = plain.replace(carlson, lambda *a, carlson=carlson: carlson(*map(expand, a)))
        return plain

    def slope(self, integral: Expr, integrand: Expr) -> Equal:
        """The integral differentiates back: along p it is the integrand times dσ/dp."""
        return Equal(Derivative(self.plain(integral), x_pole), self.plain(integrand * self.rate))

    def at_start(self, integral: Expr) -> Limit:
        """The integral vanishes at the tip, p = 1/q → ∞, by homogeneity of its terms."""
        return Limit(scaled(self.plain(integral)), q, q * 0, q * 0, "+")

    def add(
        self,
        name: str,
        arguments: tuple[Symbol, ...],
        integral: Expr,
        doc: str,
        integrand: Expr,
        *,
        steps: Iterable[str] = (),
        source: str,
        gives: Symbol | None = None,
    ) -> None:
        """A formula for an integral along the rod from the tip; every one rests on the motion, which gives dσ/dp."""
        self.writer.add(
            name,
            arguments,
            integral,
            doc,
            lambda value: self.slope(value, integrand),
            self.domain,
            steps=("tip.motion", *steps),
            source=source,
            gives=gives,
        )
        where = Domain({**self.case.domain(xi_tip=COSINES).ranges, sin_tip: (0, 1), q: (0, 1)})
        start, title = self.at_start(integral), f"{name} is zero at the tip"
        self.writer.claim(f"{name}_tip", title, start, where, steps=(f"tip.{name}",), source=source)


def scaled(expression: Expr) -> Expr:
    """p = 1/q taken out of roots and of Carlson's integrals, which are homogeneous (DLMF 19.16, below 19.16.9)."""

    def taken(argument: Expr) -> Expr:
        return expand(argument.subs(x_pole, 1 / q) * q)

    half, third = sqrt(q), q ** Rational(3, 2)
    expression = expression.replace(RF, lambda *a: half * RF(*map(taken, a)))
    expression = expression.replace(RC, lambda *a: half * RC(*map(taken, a)))
    expression = expression.replace(RD, lambda *a: third * RD(*map(taken, a)))
    expression = expression.replace(RJ, lambda *a: third * RJ(*map(taken, a)))
    expression = expression.replace(
        lambda e: isinstance(e, Pow) and e.exp.is_Rational and e.has(x_pole),
        lambda e: taken(e.base) ** e.exp * q ** (-e.exp),
    )
    return expression.subs(x_pole, 1 / q)
