"""Folded values put into formulas, with the order of the operations kept: what was no cancellation becomes none.

SymPy's own substitution evaluates every node anew: it multiplies 3·(a − b) out into 3a − 3b, which cancels, and splits
roots of numbers off products. Here a node is built anew only where a value goes in, and only what the value decides is
worked out: 0·x, 0 + x, 1·x, numbers with numbers, equal terms and equal factors taken together, and functions where
the value fixes them or shifts them by quarter turns, as in cos(θ − π/2) = sin θ.
"""

from __future__ import annotations

from collections.abc import Mapping

from sympy import Add, Expr, Function, Mul, Pow, S, Symbol, cos, nan, oo, pi, sin, zoo

from derive.emit.backends import FUNCTIONS


def substitute(expression: Expr, values: Mapping[Symbol, Expr]) -> Expr:
    """``expression`` with ``values`` for its symbols; where it has no value it holds zoo, nan or an infinity."""
    if expression in values:
        return values[expression]
    if not expression.free_symbols & set(values):
        return expression
    arguments = [substitute(argument, values) for argument in expression.args]
    if any(argument.has(zoo, nan, oo, -oo) for argument in arguments):
        return nan
    match expression:
        case Add():
            return Add(*arguments)
        case Mul():
            return _product(arguments)
        case Pow():
            return _power(*arguments)
    return _function(expression, arguments)


def _product(factors: list[Expr]) -> Expr:
    """The product of its number and the rest; the number is not multiplied into a sum."""
    number, rest = S.One, S.One
    for factor in factors:
        if factor.is_Rational:
            number *= factor
    if number == 0:
        return S.Zero
    rest = Mul(*(factor for factor in factors if not factor.is_Rational))
    return _times(number, rest)


def _times(number: Expr, rest: Expr) -> Expr:
    if number == 1:
        return rest
    return Mul(number, rest, evaluate=False) if isinstance(rest, Add) else number * rest


def _power(base: Expr, exponent: Expr) -> Expr:
    """The power; √(x/2) stays one root, where SymPy makes √2·√x/2 of it."""
    split = exponent.is_Rational and not exponent.is_Integer and isinstance(base, Mul)
    if split and any(factor.is_Rational and not (factor**exponent).is_Rational for factor in base.args):
        return Pow(base, exponent, evaluate=False)
    return Pow(base, exponent)


def _function(expression: Expr, arguments: list[Expr]) -> Expr:
    """The function at its new arguments, worked out where that gives functions that kernels have."""
    if isinstance(expression, (sin, cos)):
        arguments = [_shifted(arguments[0])]
    found = expression.func(*arguments)
    if found.has(zoo, nan, oo, -oo):
        return nan
    known = all(type(part).__name__ in FUNCTIONS for part in found.atoms(Function))
    return found if known else expression.func(*arguments, evaluate=False)


def _shifted(angle: Expr) -> Expr:
    """An angle with its multiple of π apart, so that quarter turns are seen: 2(θ − π/2) is 2θ − π."""
    if not angle.has(pi):
        return angle
    return Add(*(part for term in Add.make_args(angle) for part in _parts(term)))


def _parts(term: Expr) -> list[Expr]:
    if isinstance(term, Mul) and len(term.args) == 2 and term.args[0].is_Rational and isinstance(term.args[1], Add):
        return [term.args[0] * part for part in term.args[1].args]
    return [term]
