"""Rational functions over a tower of generators, each free or with gⁿ = E in the generators before it.

A fraction is a numerator, a polynomial reduced by the relations, over a product of polynomials that are kept apart.
Zero is then plain to see, and proves that the expression vanishes wherever it is defined: every relation used is true.
The converse needs the tower to be a field, which nobody promises: a nonzero numerator proves nothing.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import sympy as sp
from sympy import QQ
from sympy.polys.orderings import lex
from sympy.polys.rings import PolyRing

Poly = Any  # sympy.polys.rings.PolyElement
TERM_LIMIT = 60000


class NotNormalError(Exception):
    """The expression has no normal form here; the message is the reason for the reader."""


@dataclass(frozen=True)
class Fraction:
    """num / Π factor**exponent."""

    num: Poly
    den: dict[Poly, int] = field(default_factory=dict)


class Fractions:
    """Arithmetic of fractions over given generators and relations {generator: (n, E)}."""

    def __init__(self, generators: Sequence[sp.Symbol], relations: Mapping[sp.Symbol, tuple[int, sp.Expr]]) -> None:
        self.ring = PolyRing(list(generators) or [sp.Dummy("none")], QQ, lex)
        self.index = {g: i for i, g in enumerate(generators)}
        self.known: dict[sp.Expr, Fraction] = {}
        self.relations: list[tuple[int, int, Fraction]] = []
        for g in generators:
            if g in relations:
                power, value = relations[g]
                self.relations.append((self.index[g], power, self.convert(value)))

    def convert(self, expr: sp.Expr) -> Fraction:
        """The fraction of an expression that is rational in the generators."""
        if expr not in self.known:
            self.known[expr] = self._convert(expr)
        return self.known[expr]

    def _convert(self, expr: sp.Expr) -> Fraction:
        if expr.is_Rational:
            return Fraction(self.ring.ground_new(QQ(int(expr.p), int(expr.q))))
        if expr in self.index:
            return Fraction(self.ring.gens[self.index[expr]])
        if expr.is_Add:
            return self.sum([self.convert(term) for term in expr.args])
        if expr.is_Mul:
            result = Fraction(self.ring.one)
            for factor in expr.args:
                result = self.product(result, self.convert(factor))
            return result
        if expr.is_Pow and expr.exp.is_Integer:
            return self.power(self.convert(expr.base), int(expr.exp))
        raise NotNormalError(f"no rule for {expr.func.__name__}")

    def sum(self, terms: Sequence[Fraction]) -> Fraction:
        """Over the least common product of the denominators."""
        common: dict[Poly, int] = {}
        for term in terms:
            for factor, power in term.den.items():
                common[factor] = max(power, common.get(factor, 0))
        total = self.ring.zero
        for term in terms:
            part = term.num
            for factor, power in common.items():
                missing = power - term.den.get(factor, 0)
                if missing:
                    part = self._checked(part * factor**missing)
            total += part
        return self.reduced(Fraction(total, common))

    def product(self, a: Fraction, b: Fraction) -> Fraction:
        """The product, reduced."""
        den = dict(a.den)
        for factor, power in b.den.items():
            den[factor] = den.get(factor, 0) + power
        left, den = self._cancelled(a.num, den)
        right, den = self._cancelled(b.num, den)
        if len(left) * len(right) > 20 * TERM_LIMIT:
            raise NotNormalError("the normal form grows too large")
        return self.reduced(Fraction(self._checked(left * right), den))

    def power(self, a: Fraction, n: int) -> Fraction:
        """a**n for any integer n."""
        if n < 0:
            a, n = self.inverse(a), -n
        result = Fraction(self.ring.one)
        for _ in range(n):
            result = self.product(result, a)
        return result

    def inverse(self, a: Fraction) -> Fraction:
        """1/a; the numerator becomes a factor, its monomial content and its leading coefficient split off."""
        if not a.num:
            raise NotNormalError("a denominator vanishes identically")
        num = self.ring.one
        for factor, power in a.den.items():
            num = self._checked(num * factor**power)
        den: dict[Poly, int] = {}
        content = tuple(min(degrees) for degrees in zip(*a.num, strict=True))
        rest = self._divided(a.num, self.ring({content: self.ring.domain.one}))
        assert rest is not None  # a common factor of all terms divides
        for g, power in zip(self.ring.gens, content, strict=True):
            if power:
                den[g] = power
        if not rest.is_ground:
            den[rest.monic()] = 1
        return self.reduced(Fraction(num.mul_ground(1 / rest.LC), den))

    def reduced(self, a: Fraction) -> Fraction:
        """The same fraction with a numerator of least degree in every generator that has a relation."""
        for index, power, value in reversed(self.relations):
            a = self._lowered(a, index, power, value)
        if not a.num:
            return Fraction(self.ring.zero)
        return Fraction(*self._cancelled(a.num, a.den))

    def _lowered(self, a: Fraction, index: int, power: int, value: Fraction) -> Fraction:
        """Replace g**(n·k + r) by Eᵏ gʳ in the numerator."""
        highest = max((monomial[index] for monomial in a.num), default=0)
        if highest < power:
            return a
        layers: dict[int, Poly] = {}
        for monomial, coefficient in a.num.items():
            turns, rest = divmod(monomial[index], power)
            layer = layers.setdefault(turns, self.ring.zero)
            layer[(*monomial[:index], rest, *monomial[index + 1 :])] = coefficient
        top = max(layers)
        below = self.ring.one
        for factor, times in value.den.items():
            below = below * factor**times
        total = self.ring.zero
        for turns, layer in layers.items():
            total += self._checked(layer * value.num**turns * below ** (top - turns))
        den = dict(a.den)
        for factor, times in value.den.items():
            den[factor] = den.get(factor, 0) + times * top
        return Fraction(total, den)

    def _cancelled(self, num: Poly, den: dict[Poly, int]) -> tuple[Poly, dict[Poly, int]]:
        """Cancel factors of the denominator that divide the numerator as polynomials."""
        if not num or num.is_ground:
            return num, den
        left: dict[Poly, int] = {}
        for factor, power in den.items():
            while power:
                quotient = self._divided(num, factor)
                if quotient is None:
                    break
                num, power = quotient, power - 1
            if power:
                left[factor] = power
        return num, left

    def _divided(self, num: Poly, factor: Poly) -> Poly | None:
        """num / factor if it is exact, given up at the first term that does not divide."""
        if len(factor) == 1:
            ((gone, coefficient),) = factor.items()
            if any(m < g for monomial in num for m, g in zip(monomial, gone, strict=True)):
                return None
            result = self.ring.zero
            for monomial, value in num.items():
                result[tuple(m - g for m, g in zip(monomial, gone, strict=True))] = value / coefficient
            return result
        lead, rest, quotient = factor.LM, num.copy(), self.ring.zero
        if any(m < g for m, g in zip((max(d) for d in zip(*num, strict=True)), lead, strict=True)):
            return None
        while rest:
            step = tuple(m - g for m, g in zip(rest.LM, lead, strict=True))
            if min(step) < 0:
                return None
            term = self.ring({step: rest.LC / factor.LC})
            quotient += term
            rest -= term * factor
        return quotient

    def _checked(self, poly: Poly) -> Poly:
        if len(poly) > TERM_LIMIT:
            raise NotNormalError("the normal form grows too large")
        return poly

    def expression(self, a: Fraction) -> sp.Expr:
        """The fraction as an expression in the generators."""
        below = sp.Mul(*(factor.as_expr() ** power for factor, power in a.den.items()))
        return a.num.as_expr() / below
