"""Equal forms of an expression, the shortest first; only the form changes, and whatever is written is proved again."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from itertools import combinations
from typing import Any

import sympy as sp

from derive.check.timing import TimeLimit, limited


class SpellError(ValueError):
    """An expression that the letters of the section cannot write; the message says which part."""


SECONDS = 2.0  # for one way
Letters = tuple[tuple[sp.Symbol, Any], ...]  # a letter, as a placeholder, and the value that it abbreviates


def _squares_of_cosines(expr: Any) -> Any:
    """sin² as 1 − cos²."""
    sines = expr.atoms(sp.sin)
    return sp.expand(expr).subs({call**2: 1 - sp.cos(call.args[0]) ** 2 for call in sines}) if sines else expr


def _gathered(expr: Any) -> Any:
    """Factors with (x − 1)(x + 1) multiplied out and a minus before all taken into a sum: (1 − x²)(…)."""
    found = sp.factor(_squares_of_cosines(expr))
    sums = [part for part in sp.Mul.make_args(found) if part.is_Add and len(part.args) == 2]
    for one, other in combinations(sums, 2):
        product = sp.expand(one * other)
        if product.is_Add and len(product.args) == 2:
            rest = found / (one * other)
            taken = -1 if rest.as_coeff_Mul()[0].is_negative else 1
            return sp.Mul(taken * rest, sp.expand(taken * product), evaluate=True)
    return found


_WAYS: tuple[Callable[[Any], Any], ...] = (
    sp.expand, sp.factor, sp.together, sp.trigsimp, sp.cancel, _squares_of_cosines, _gathered,
)  # fmt: skip


def ways(expr: Any, letters: Letters = ()) -> Iterator[Any]:
    """The expression in several equal forms, the shortest first."""
    found = list(dict.fromkeys((rooted(expr), expr, sp.expand_trig(expr))))
    found += [short for one in tuple(found) if (short := abbreviated(one, letters)) != one]
    for one in tuple(found):
        for way in _WAYS:
            try:
                with limited(SECONDS):
                    found.append(way(one))
            except (TimeLimit, sp.PolynomialError, NotImplementedError):
                continue
    yield from sorted(dict.fromkeys(found), key=lambda one: (size(one), str(one)))


def size(expr: Any) -> int:
    """How much there is to read."""
    return int(sp.count_ops(expr)) + sum(len(str(abs(number.p))) for number in expr.atoms(sp.Rational))


def rooted(expr: Any) -> Any:
    """Roots of factored radicands, so that the root of a square goes."""
    return expr.replace(
        lambda part: part.is_Pow and part.exp == sp.Rational(1, 2), lambda part: sp.sqrt(sp.factor(part.base))
    )


def abbreviated(expr: Any, letters: Letters) -> Any:
    """Letters in the place of their values, also where a value is a part of a sum."""
    for letter, value in letters:
        expr = expr.subs(value, letter)
        sums = [(letter * sign, value * sign) for sign in (1, -1)] if value.is_Add else []
        for signed, part in sums:
            expr = expr.replace(lambda node: node.is_Add, lambda node, s=signed, p=part: _without(node, s, p))
    return expr


def _without(node: Any, letter: Any, value: Any) -> Any:
    """A sum with the letter for the terms of its value, if that makes it shorter."""
    rest = sp.expand(node - value)
    return letter + rest if len(sp.Add.make_args(rest)) < len(node.args) - 1 or rest == 0 else node


def by_powers(expr: Any, letter: sp.Symbol) -> list[Any]:
    """The terms of a polynomial in a letter, the highest power first; empty if it is none."""
    if not expr.is_polynomial(letter) or not expr.has(letter):
        return []
    return [coefficient * letter**power for (power,), coefficient in sp.Poly(expr, letter).terms()]


def ordered(terms: Iterable[Any]) -> list[Any]:
    """Terms with a plus before those with a minus, otherwise in their order."""
    listed = list(terms)
    return [one for one in listed if not negative(one)] + [one for one in listed if negative(one)]


def negative(expr: Any) -> bool:
    """Is it written with a minus before it?"""
    if expr.is_Add:
        return all(negative(part) for part in expr.args)
    if expr.is_Mul:
        return sum(negative(part) for part in expr.args) % 2 == 1
    return bool(expr.as_coeff_Mul()[0].is_negative)
