"""Random exact points in the domain of a claim, deterministic for a seed.

Ranges may lean on symbols declared before them; conditions are met by rejection. Symbols without a range follow
their assumptions; without assumptions they are complex. UndefinedError functions and their derivatives are independent
real numbers. A hypothesis ℘(v) = c, or a² = E, fixes v, or a.
"""

from __future__ import annotations

import random
from collections.abc import Iterable, Iterator
from typing import Any

import sympy as sp
from mpmath import mp
from sympy.core.function import AppliedUndef

from derive.check.evaluate import UndefinedError, dyadic, evaluate, wp_inverse
from derive.theory import functions as fn
from derive.theory.claims import Domain

MEMBERSHIP_DIGITS = 20
DRAWING_DIGITS = 30  # more than the ends have, so that rounding does not carry a point onto an end
MARGIN = mp.mpf(10) ** -15  # relative distance that a point keeps from the ends of its ranges
ATTEMPTS = 400  # rejections before a domain is held to be empty

Given = tuple[tuple[sp.Expr, sp.Expr], ...]
ExactPoint = dict[sp.Expr, sp.Expr]


def unknowns(expressions: Iterable[sp.Expr]) -> list[sp.Expr]:
    """Symbols, applied undefined functions and their derivatives in the expressions, in a fixed order."""
    found: set[sp.Expr] = set()
    for expr in expressions:
        _collect(expr, found)
    return sorted(found, key=sp.default_sort_key)


def _collect(expr: sp.Basic, found: set[sp.Expr]) -> None:
    if isinstance(expr, sp.Symbol | AppliedUndef):
        found.add(expr)
        for arg in expr.args:
            _collect(arg, found)
    elif isinstance(expr, sp.Derivative | sp.Subs) and expr.has(AppliedUndef):
        found.add(expr)
    elif isinstance(expr, sp.Integral | sp.Subs):
        found.update(expr.free_symbols)
    else:
        for arg in expr.args:
            _collect(arg, found)


def hypotheses(given: Given) -> dict[sp.Expr, sp.Expr]:
    """What hypotheses fix: v → inverse of ℘ for ℘(v) = c (with ℘′(v) choosing the sign), a → √E for a² = E."""
    fixed: dict[sp.Expr, sp.Expr] = {}
    slopes = {old.args: new for old, new in given if isinstance(old, fn.wp_prime)}
    for old, new in given:
        if isinstance(old, fn.wp) and old.args[0].is_Symbol:
            v, g2, g3 = old.args
            fixed[v] = wp_inverse(new, slopes.get(old.args, sp.Integer(0)), g2, g3)
        elif old.is_Symbol:
            fixed[old] = new
        elif old.is_Pow and old.exp == 2 and (old.base.is_Symbol or isinstance(old.base, AppliedUndef | sp.Derivative)):
            fixed[old.base] = sp.sqrt(new)
    later = list(given)
    return {key: _substituted(value, later) for key, value in fixed.items()}


def _substituted(expr: sp.Expr, given: Iterable[tuple[sp.Expr, sp.Expr]]) -> sp.Expr:
    for old, new in given:
        expr = expr.subs(old, new)
    return expr


class Sampler:
    """Draws exact points for the unknowns of some expressions."""

    def __init__(self, expressions: Iterable[sp.Expr], domain: Domain, given: Given = (), seed: int = 0) -> None:
        self.domain = domain
        self.every = self.fixed = hypotheses(given)
        self.squared = {old.base for old, _ in given if old.is_Pow}
        ends = [end for pair in domain.ranges.values() for end in pair]
        everything = [*expressions, *domain.conditions, *map(sp.sympify, ends), *self.fixed.values()]
        free = [x for x in unknowns(everything) if x not in domain.ranges and x not in self.fixed]
        wanted = set(unknowns([*everything, *domain.ranges]))
        self.fixed = {x: value for x, value in self.fixed.items() if x in wanted}
        self.order = free + [x for x in domain.ranges if x not in self.fixed]
        self.random = random.Random(seed)

    def points(self, count: int) -> Iterator[ExactPoint]:
        """Up to so many points; fewer if the domain seems empty."""
        found = 0
        for _ in range(ATTEMPTS):
            if found == count:
                return
            point = self._draw()
            if point is not None:
                found += 1
                yield point

    def _draw(self) -> ExactPoint | None:
        point: ExactPoint = {}
        for symbol in self.order:
            value = self._value(symbol, point)
            if value is None:
                return None
            point[symbol] = value
        for symbol, value in self.fixed.items():
            point[symbol] = self._either(symbol, value)
        return point if all(self._positive(condition, point) for condition in self.domain.conditions) else None

    def extend(self, point: ExactPoint, expressions: Iterable[sp.Expr]) -> None:
        """Give values to the unknowns of the expressions that the point does not have yet, where they can be drawn."""
        for symbol in unknowns(expressions):
            if symbol not in point and symbol in self.every:
                self.extend(point, [self.every[symbol]])
                point[symbol] = self._either(symbol, self.every[symbol])
            elif symbol not in point and (value := self._value(symbol, point)) is not None:
                point[symbol] = value

    def _either(self, symbol: sp.Expr, value: sp.Expr) -> sp.Expr:
        """The value of what is fixed; of what only has a square, one of two."""
        return -value if symbol in self.squared and self.random.random() < 0.5 else value

    def inside(self, point: ExactPoint) -> bool:
        """True if a point is in the domain, and obeys the assumptions of the symbols."""
        for symbol, value in point.items():
            lower, upper = self._ends(symbol, point)
            if lower is None or upper is None or not value.is_extended_real:
                return False
            number = evaluate(value, {}, MEMBERSHIP_DIGITS)
            margin = MARGIN * (1 + abs(number))  # an end is not inside, for all its rounding
            if not lower + margin < number < upper - margin and not (number == 0 and symbol not in self.domain.ranges):
                return False
        return all(self._positive(condition, point) for condition in self.domain.conditions)

    def zeros(self, expressions: Iterable[sp.Expr], count: int) -> Iterator[ExactPoint]:
        """Points of the domain at which one of the expressions vanishes, by a factor that is linear in a symbol."""
        if self.fixed:
            return
        cases = [(f, x) for e in expressions for f in _linear_factors(e) for x in sorted(f.free_symbols, key=str)]
        for factor, symbol in cases:
            if symbol not in self.order or sp.degree(factor, symbol) != 1:
                continue
            for point in self.points(count):
                others = {x: value for x, value in point.items() if x != symbol}
                line = sp.Poly(factor.subs(others), symbol)
                if line.degree() == 1:
                    special = {**point, symbol: -line.nth(0) / line.nth(1)}
                    if self.inside(special):
                        yield special

    def _positive(self, condition: sp.Expr, point: ExactPoint) -> bool:
        try:
            value = evaluate(condition, point, MEMBERSHIP_DIGITS)
        except UndefinedError:
            return False
        return bool(mp.im(value) == 0 and mp.re(value) > 0)

    def _value(self, symbol: sp.Expr, point: ExactPoint) -> sp.Expr | None:
        lower, upper = self._ends(symbol, point)
        if lower is None or upper is None or lower >= upper:
            return None
        if symbol.is_integer:
            low = int(max(lower, -9)) + 1
            return sp.Integer(self.random.randint(low, max(low, int(min(upper, low + 9)))))
        if symbol not in self.domain.ranges and symbol.is_Symbol and symbol.is_extended_real is None:
            real, imaginary = self._between(-mp.inf, mp.inf), self._between(-mp.inf, mp.inf)
            return None if real is None or imaginary is None else real + sp.I * imaginary
        return self._between(lower, upper)

    def _ends(self, symbol: sp.Expr, point: ExactPoint) -> tuple[Any, Any]:
        lower, upper = self.domain.ranges.get(symbol, (-sp.oo, sp.oo))
        low, high = self._end(lower, point), self._end(upper, point)
        if low is not None and symbol.is_extended_nonnegative:
            low = max(low, mp.mpf(0))
        if high is not None and symbol.is_extended_nonpositive:
            high = min(high, mp.mpf(0))
        return low, high

    def _end(self, end: Any, point: ExactPoint) -> Any:
        end = sp.sympify(end, strict=True)
        if end in (sp.oo, -sp.oo):
            return mp.inf if end == sp.oo else -mp.inf
        try:
            value = evaluate(end, point, MEMBERSHIP_DIGITS)
        except UndefinedError:
            return None
        return value if mp.im(value) == 0 else None

    def _between(self, lower: Any, upper: Any) -> sp.Rational | None:
        """An exact number strictly inside: anywhere in a finite range, over several magnitudes in an infinite one."""
        step = mp.mpf(self.random.randint(1, 9998)) / 9999
        if self.random.random() < 0.3:  # near an end
            step = step**3 if step < 0.5 else 1 - (1 - step) ** 3
        size = mp.mpf(10) ** self.random.uniform(-1.3, 1.3)
        sign = self.random.choice((-1, 1)) if mp.isinf(lower) and mp.isinf(upper) else 0
        with mp.workdps(DRAWING_DIGITS):
            if sign:
                value = size * sign
            elif mp.isinf(upper):
                value = lower + size
            elif mp.isinf(lower):
                value = upper - size
            else:
                value = lower + (upper - lower) * step
            return _short(value, lower, upper)


def _short(value: Any, lower: Any, upper: Any) -> sp.Rational | None:
    """A short exact number near a value and between the ends; None if rounding leaves none that surely is."""
    for digits in (4, 8, 16):
        near = mp.mpf(mp.nstr(value, digits))
        margin = MARGIN * (1 + abs(value))
        if lower + margin < near < upper - margin:
            return sp.Rational(mp.nstr(value, digits))
    slack = MARGIN * sum(abs(end) for end in (lower, upper) if not mp.isinf(end))
    if not lower + slack < value < upper - slack:
        return None
    return dyadic(mp.mpf(value))


def _linear_factors(expr: sp.Expr) -> list[sp.Expr]:
    """Factors of the numerator of a rational expression; none of any other."""
    symbols = expr.free_symbols
    if not symbols or not expr.is_rational_function(*symbols):
        return []
    return [factor for factor, _ in sp.factor_list(sp.fraction(sp.together(expr))[0])[1]]
