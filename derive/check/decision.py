"""The sign of an expression over positive variables: coefficients, factors, roots, discriminants, Sturm."""

from __future__ import annotations

from typing import Any

import sympy as sp

from derive.check.rational import NotNormalError, Poly
from derive.check.tower import Tower
from derive.theory import functions as fn

DEPTH = 24  # nested questions about polynomials
LARGE = 400  # terms beyond which a polynomial is not factored


def by_assumptions(expr: sp.Expr) -> int | None:
    """What SymPy knows from the assumptions of one symbol; of larger expressions it may take forever to say it."""
    if expr == 0:
        return 0
    if expr.is_Rational or expr.is_Symbol or expr.is_number:
        return 1 if expr.is_positive else -1 if expr.is_negative else None
    return None


def orthant_sign(expr: sp.Expr) -> int | None:
    """The sign of an expression whose symbols carry their signs as assumptions."""
    plain = by_assumptions(expr)
    if plain is not None:
        return plain
    try:
        return Decision(expr, []).sign()
    except (NotNormalError, ZeroDivisionError):
        return None


class Decision:
    """The sign of one expression over positive and nonnegative symbols, with facts that are > 0."""

    def __init__(self, expr: sp.Expr, facts: list[sp.Expr]) -> None:
        self.tower = Tower([expr, *facts], orthant_sign)
        self.fraction = self.tower.fraction(expr)
        self.facts = []
        for fact in facts:
            try:
                self.facts.append(self.tower.fraction(fact))
            except NotNormalError:
                continue
        self.fraction = self.tower.fraction(expr)  # in the final ring
        self.facts = [self.tower.fraction(fact) for fact in facts] if self.facts else []
        self.asked: dict[Poly, int | None] = {}
        self.kinds = [self._kind(g) for g in self.tower.generators]
        for fact in self.facts:
            self._learn(fact)

    def _kind(self, symbol: sp.Symbol) -> int | None:
        """1 for a positive generator, 0 for a nonnegative one, 2 for a real one, None for anything else."""
        meaning = self.tower.meaning[symbol]
        if meaning.is_positive or isinstance(meaning, sp.exp):
            return 1
        if meaning.is_Pow and self.tower.sign_of(self.tower.relations[symbol][1]) == 1:
            return 1
        if isinstance(meaning, fn.RF | fn.RC | fn.RD | fn.RJ):
            return 1 if all(orthant_sign(arg) == 1 for arg in meaning.args) else None
        if meaning.is_nonnegative:
            return 0
        return 2 if meaning.is_extended_real else None

    def _learn(self, fact: Any) -> None:
        """A fact with a denominator of known sign tells the sign of its numerator, and of one unknown factor."""
        sign = self._denominator(fact)
        if sign is None or not fact.num:
            return
        constant, parts = fact.num.factor_list()
        sign *= 1 if constant > 0 else -1
        open_parts = []
        for part, times in parts:
            known = self._poly(part, 1)
            if known is None:
                open_parts.append((part, times))
            else:
                sign *= known**times
        if len(open_parts) == 1 and open_parts[0][1] % 2 and sign:
            self.asked[open_parts[0][0].monic()] = sign * (1 if open_parts[0][0].LC > 0 else -1)

    def _denominator(self, fraction: Any) -> int | None:
        sign = 1
        for factor, times in fraction.den.items():
            known = self._poly(factor, 0) if times % 2 else 1
            if known is None:
                return None
            sign *= known
        return sign

    def sign(self) -> int | None:
        """The sign of the expression, None if undecided."""
        if not self.fraction.num:
            return 0
        below = self._denominator(self.fraction)
        above = self._poly(self.fraction.num, 0) if below else None
        return None if above is None or below is None else above * below

    def _poly(self, poly: Poly, depth: int) -> int | None:
        """The sign of a polynomial in the generators."""
        if not poly:
            return 0
        monic, lead = poly.monic(), 1 if poly.LC > 0 else -1
        if monic not in self.asked:
            self.asked[monic] = None
            self.asked[monic] = self._decide(monic, depth) if depth < DEPTH else None
        known = self.asked[monic]
        return None if known is None else known * lead

    def _decide(self, poly: Poly, depth: int) -> int | None:
        found = self._by_coefficients(poly)
        if found is None and len(poly) <= LARGE:
            found = self._by_factors(poly, depth)
        if found is None:
            found = self._by_root(poly, depth)
        if found is None:
            found = self._by_discriminant(poly, depth)
        return self._by_sturm(poly) if found is None else found

    def _by_coefficients(self, poly: Poly) -> int | None:
        """All terms of one sign, one of them never zero."""
        signs, strict = set(), False
        for monomial, coefficient in poly.items():
            sure = True
            for degree, kind in zip(monomial, self.kinds, strict=True):
                if degree and kind != 1:
                    sure = False
                    if kind is None or (kind == 2 and degree % 2):
                        return None
            strict = strict or sure
            signs.add(1 if coefficient > 0 else -1)
        return signs.pop() if len(signs) == 1 and strict else None

    def _by_factors(self, poly: Poly, depth: int) -> int | None:
        constant, parts = poly.factor_list()
        if len(parts) == 1 and parts[0][1] == 1:
            return None
        sign = 1 if constant > 0 else -1
        for part, times in parts:
            known = self._poly(part, depth + 1)
            if known is None:
                return None
            sign *= known**times
        return sign

    def _layers(self, poly: Poly, index: int) -> dict[int, Poly]:
        layers: dict[int, Poly] = {}
        for monomial, coefficient in poly.items():
            layer = layers.setdefault(monomial[index], poly.ring.zero)
            layer[(*monomial[:index], 0, *monomial[index + 1 :])] = coefficient
        return layers

    def _by_root(self, poly: Poly, depth: int) -> int | None:
        """p + q√r with √r > 0, by the signs of p, q and p² − q²r."""
        field = self.tower.field()
        for index in reversed(range(len(self.tower.generators))):
            symbol = self.tower.generators[index]
            if self.tower.relations.get(symbol, (0,))[0] != 2 or self.kinds[index] != 1 or poly.degree(index) != 1:
                continue
            layers = self._layers(poly, index)
            p, q = layers.get(0, field.ring.zero), layers[1]
            square = field.convert(self.tower.relations[symbol][1])
            if square.den:
                return None
            one, two = self._poly(p, depth + 1), self._poly(q, depth + 1)
            if one is not None and two is not None and (one == two or 0 in (one, two)):
                return one or two
            larger = self._poly(field.reduced(type(square)(p * p - q * q * square.num)).num, depth + 1)
            return one if larger == 1 else two if larger == -1 else None
        return None

    def _by_discriminant(self, poly: Poly, depth: int) -> int | None:
        """a x² + b x + c with 4ac > b² has the sign of a."""
        for index, symbol in enumerate(self.tower.generators):
            if symbol in self.tower.relations or poly.degree(index) != 2 or self.kinds[index] is None:
                continue
            layers = self._layers(poly, index)
            a, b, c = (layers.get(k, poly.ring.zero) for k in (2, 1, 0))
            lead = self._poly(a, depth + 1)
            if lead and self._poly(self._reduced(4 * a * c - b * b), depth + 1) == 1:
                return lead
        return None

    def _reduced(self, poly: Poly) -> Poly:
        field = self.tower.field()
        return field.reduced(type(self.fraction)(poly)).num

    def _by_sturm(self, poly: Poly) -> int | None:
        """In one variable: no roots in (0, ∞)."""
        used = [index for index, degree in enumerate(poly.degrees()) if degree > 0]
        if len(used) != 1 or self.kinds[used[0]] != 1 or self.tower.generators[used[0]] in self.tower.relations:
            return None
        variable = self.tower.generators[used[0]]
        single = sp.Poly(poly.as_expr(), variable)
        if single.eval(0) == 0 or single.count_roots(0, None):
            return None
        return 1 if single.eval(1) > 0 else -1
