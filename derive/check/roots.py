"""Roots, moduli and logarithms: the functions whose rules depend on signs.

The argument is factored as a polynomial fraction. A factor proved positive, or negative, is split off with its sign;
what is of unknown sign stays together under one root. Nothing else is ever assumed.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import sympy as sp

from derive.check.rational import NotNormalError

if TYPE_CHECKING:
    from derive.check.tower import Tower

FACTOR_TERMS = 120  # larger polynomials are not factored


def factors(tower: Tower, expr: sp.Expr) -> tuple[sp.Rational, dict[sp.Expr, int]]:
    """A coefficient and irreducible factors (in generators) with their exponents."""
    fraction = tower.fraction(expr)
    if not fraction.num:
        return sp.Integer(0), {}
    found: dict[sp.Expr, int] = {}
    coefficient = sp.Integer(1)
    for poly, power in [(fraction.num, 1), *((poly, -times) for poly, times in fraction.den.items())]:
        constant, parts = poly.factor_list() if len(poly) <= FACTOR_TERMS else (1, [(poly, 1)])
        coefficient *= sp.Rational(int(constant.numerator), int(constant.denominator)) ** power
        for part, times in parts:
            found[part.as_expr()] = found.get(part.as_expr(), 0) + times * power
    return coefficient, _squares_of_sines(tower, {f: n for f, n in found.items() if n})


def _squares_of_sines(tower: Tower, found: dict[sp.Expr, int]) -> dict[sp.Expr, int]:
    """(1 − cos θ)(1 + cos θ) becomes sin²θ; signs of the factors are those of the irreducible polynomials."""
    for key, symbol in list(tower.named.items()):
        if not isinstance(key, tuple) or key[0] != "sin" or ("cos", key[1]) not in tower.named:
            continue
        cosine = tower.named["cos", key[1]]
        one, two = cosine - 1, cosine + 1
        if found.get(one, 0) * found.get(two, 0) <= 0:
            continue
        pairs = min(abs(found[one]), abs(found[two])) * (1 if found[one] > 0 else -1)
        # (c − 1)(c + 1) = −s²: with an even number of pairs the sign is lost, else it is kept as a factor −1.
        found[one], found[two] = found[one] - pairs, found[two] - pairs
        found[symbol] = found.get(symbol, 0) + 2 * pairs
        if pairs % 2:
            found[sp.Integer(-1)] = found.get(sp.Integer(-1), 0) + 1
    return {f: n for f, n in found.items() if n}


def split(tower: Tower, expr: sp.Expr) -> tuple[sp.Rational, dict[sp.Expr, int], dict[sp.Expr, int]]:
    """coefficient · Π positive · Π unknown: factors proved positive (signs turned where negative), and the rest."""
    coefficient, found = factors(tower, expr)
    positive: dict[sp.Expr, int] = {}
    unknown: dict[sp.Expr, int] = {}
    for factor, times in found.items():
        sign = factor if factor.is_Integer else tower.sign_of(factor)
        if factor == -1:
            coefficient = coefficient * (-1) ** (times % 2)
        elif sign == 1:
            positive[factor] = times
        elif sign == -1:
            positive[-factor] = times
            coefficient = coefficient * (-1) ** (times % 2)
        else:
            unknown[factor] = times
    return coefficient, positive, unknown


def root(tower: Tower, base: sp.Expr, q: int) -> sp.Expr:
    """base^(1/q), principal value, in generators."""
    if q % 2 == 0 and q > 2:  # arg/q = (arg/2)/(q/2): roots of roots are principal
        return root(tower, sp.sqrt(base), q // 2) if not base.is_Rational else _number_root(tower, base, q)
    coefficient, positive, unknown = split(tower, base)
    if coefficient == 0:
        return sp.Integer(0)
    result: sp.Expr = sp.Integer(1)
    for factor, times in positive.items():
        whole, rest = divmod(times, q)
        result *= factor**whole
        if rest:
            result *= _positive_root(tower, factor, q) ** rest
    if not unknown:
        return result * _number_root(tower, coefficient, q)
    if coefficient < 0:
        unknown = {sp.Integer(-1): 1, **unknown}
    inside = sp.Mul(*(factor**times for factor, times in unknown.items()))
    whole = sp.Mul(*(tower.restored(factor) ** times for factor, times in unknown.items()))
    hidden = tower.generator(("root", inside, q), sp.Pow(whole, sp.Rational(1, q)), (q, inside))
    return result * _number_root(tower, abs(coefficient), q) * hidden


def _positive_root(tower: Tower, factor: sp.Expr, q: int) -> sp.Expr:
    """The root of an irreducible factor that is positive: a generator, or by the root of its conjugate."""
    if ("root", factor, q) not in tower.named and q == 2:
        for symbol in reversed(tower.generators):
            if factor.has(symbol) and tower.relations.get(symbol, (0,))[0] == 2:
                mate = factor.subs(symbol, -symbol)
                for conjugate in (mate, sp.expand(-mate)):
                    if conjugate != factor and ("root", conjugate, 2) in tower.named:
                        # √f = √(f·g)/√g for f, g > 0; f·g is free of the root in them.
                        whole = root(tower, tower.restored(factor * conjugate), 2)
                        return whole / tower.named["root", conjugate, 2]
                break
    meaning = sp.Pow(tower.restored(factor), sp.Rational(1, q))
    return tower.generator(("root", factor, q), meaning, (q, factor))


def _number_root(tower: Tower, number: sp.Rational, q: int) -> sp.Expr:
    """The principal root of a rational number: roots of its primes, and i for √−1."""
    result: sp.Expr = sp.Integer(1)
    if number < 0:
        if q != 2:
            raise NotNormalError(f"a root of order {q} of a negative number")
        result = tower.rewrite(sp.I)
    for prime, times in sp.factorrat(abs(number)).items():
        whole, rest = divmod(times, q)
        result *= sp.Integer(prime) ** whole
        if rest:
            symbol = tower.generator(("root", prime, q), sp.Pow(prime, sp.Rational(1, q)), (q, sp.Integer(prime)))
            result *= symbol**rest
    return result


def modulus(tower: Tower, argument: sp.Expr) -> sp.Expr:
    """|x|, by the signs of the factors of x; where one is unknown, the root of the square of a real x."""
    coefficient, positive, unknown = split(tower, argument)
    result = abs(coefficient) * sp.Mul(*(factor**times for factor, times in positive.items()))
    for factor, times in unknown.items():
        meaning = tower.restored(factor)
        if meaning.is_extended_real is not True:
            raise NotNormalError("the modulus of an expression not known to be real")
        symbol = tower.generator(("modulus", factor), sp.Abs(meaning), (2, factor**2))
        result *= symbol**times
    return result


def logarithm(tower: Tower, argument: sp.Expr) -> sp.Expr:
    """ln x: the sum over factors if all are proved positive, else one generator."""
    coefficient, positive, unknown = split(tower, argument)
    if unknown or coefficient <= 0:
        return tower.call(sp.log, (argument,))
    total: sp.Expr = sp.Integer(0)
    for prime, times in sp.factorrat(coefficient).items():
        total += times * tower.generator(("log", prime), sp.log(prime))
    for factor, times in positive.items():
        total += times * tower.generator(("log", factor), sp.log(tower.restored(factor)))
    return total
