"""Rewriting an expression as a rational function of generators, each free or with gⁿ = E (see ``rational``).

Generators stand for symbols, undefined functions and their derivatives, roots, sines and cosines of base angles,
exponentials, logarithms, Weierstrass and Carlson functions. Two calls of a function are one generator if their
arguments are proved equal. Every relation that goes in is true on the whole domain: √(x²) = x is used only where x is
proved positive, a root of a product is split only off factors proved positive.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import Any

import sympy as sp
from sympy.core.function import AppliedUndef

from derive.check import arguments, roots, weierstrass
from derive.check.rational import Fraction, Fractions, NotNormalError
from derive.theory import functions as fn

Sign = Callable[[sp.Expr], int | None]  # +1, −1, 0 where proved on the domain, None where unknown
Given = tuple[tuple[sp.Expr, sp.Expr], ...]

PLAIN = (
    sp.log, sp.atan, sp.asin, sp.acos, sp.acosh, sp.asinh, sp.atanh, sp.Max, fn.RF, fn.RC, fn.RD, fn.RJ,
    fn.half_period, fn.perimeter_point,
)  # fmt: skip
TO_SINE = {
    sp.tan: lambda x: sp.sin(x) / sp.cos(x),
    sp.cot: lambda x: sp.cos(x) / sp.sin(x),
    sp.sec: lambda x: 1 / sp.cos(x),
    sp.csc: lambda x: 1 / sp.sin(x),
}
TO_EXP = {
    sp.sinh: lambda x: (sp.exp(x) - sp.exp(-x)) / 2,
    sp.cosh: lambda x: (sp.exp(x) + sp.exp(-x)) / 2,
    sp.tanh: lambda x: (sp.exp(2 * x) - 1) / (sp.exp(2 * x) + 1),
    sp.coth: lambda x: (sp.exp(2 * x) + 1) / (sp.exp(2 * x) - 1),
}


def no_sign(expr: sp.Expr) -> int | None:
    """The sign callback that knows only numbers."""
    return None if not expr.is_Rational else (expr > 0) - (expr < 0)


class Tower:
    """The generators of some expressions, which have to be announced first, and their relations."""

    def __init__(self, expressions: Iterable[sp.Expr] = (), sign: Sign = no_sign, given: Given = ()) -> None:
        self.sign = sign
        self.given = {old: new for old, new in given if old.is_Function or old.is_Derivative}
        self.generators: list[sp.Symbol] = []
        self.meaning: dict[sp.Symbol, sp.Expr] = {}
        self.relations: dict[sp.Symbol, tuple[int, sp.Expr]] = {}
        self.named: dict[Any, sp.Symbol] = {}
        self.rewritten: dict[sp.Expr, sp.Expr] = {}
        self.calls: dict[type, list[tuple[tuple[sp.Expr, ...], sp.Expr]]] = {}
        self.signs: dict[sp.Expr, int | None] = {}
        self.fractions = Fractions((), {})
        expressions = list(expressions)
        self.units = arguments.angle_units(expressions)
        self.lattices = weierstrass.Lattices(self, [*expressions, *self.given])

    # -- generators ----------------------------------------------------------------------------------------------

    def generator(self, key: Any, meaning: sp.Expr, relation: tuple[int, sp.Expr] | None = None) -> sp.Symbol:
        """The generator of a key, made on first use; a relation (n, E) says that its n-th power is E."""
        if key not in self.named:
            symbol = meaning if meaning.is_Symbol else sp.Dummy(f"g{len(self.generators)}")
            self.named[key] = symbol
            self.generators.append(symbol)
            self.meaning[symbol] = meaning
            if relation is not None:
                self.relations[symbol] = relation
        return self.named[key]

    def field(self) -> Fractions:
        """The arithmetic over the generators there are now."""
        if len(self.fractions.index) != len(self.generators):
            self.fractions = Fractions(self.generators, self.relations)
        return self.fractions

    def fraction(self, expr: sp.Expr) -> Fraction:
        """The reduced fraction of any expression."""
        rewritten = self.rewrite(expr)
        return self.field().convert(rewritten)

    def is_zero(self, expr: sp.Expr) -> bool:
        """True if the expression is proved to vanish wherever it is defined."""
        return not self.fraction(expr).num

    def restored(self, expr: sp.Expr) -> sp.Expr:
        """An expression in generators, written out."""
        for symbol in reversed(self.generators):
            if expr.has(symbol):
                expr = expr.xreplace({symbol: self.meaning[symbol]})
        return expr

    def sign_of(self, expr: sp.Expr) -> int | None:
        """The sign of an expression in generators, as far as it is known on the domain."""
        if expr not in self.signs:
            self.signs[expr] = None  # a question that leads back to itself has no answer
            self.signs[expr] = self.sign(self.restored(expr))
        return self.signs[expr]

    # -- rewriting -----------------------------------------------------------------------------------------------

    def rewrite(self, expr: sp.Expr) -> sp.Expr:
        """The expression with everything that is not rational replaced by generators."""
        if expr not in self.rewritten:
            self.rewritten[expr] = self._rewrite(expr)
        return self.rewritten[expr]

    def _rewrite(self, expr: sp.Expr) -> sp.Expr:
        if expr.is_Rational:
            return expr
        if expr.is_Symbol:
            return self.generator(expr, expr)
        if expr is sp.I:
            return self.generator(expr, expr, (2, sp.Integer(-1)))
        if expr in (sp.pi, sp.E, sp.EulerGamma):
            return self.generator(expr, expr)
        if expr.is_Add or expr.is_Mul:
            return expr.func(*(self.rewrite(arg) for arg in expr.args))
        if isinstance(expr, sp.exp):
            return arguments.exponential(self, expr.args[0])
        if expr.is_Pow:
            return self._power(expr.base, expr.exp)
        return self._function(expr)

    def _power(self, base: sp.Expr, exponent: sp.Expr) -> sp.Expr:
        if exponent.is_Integer:
            return self.rewrite(base) ** exponent
        if exponent.is_Rational:
            return roots.root(self, base, int(exponent.q)) ** int(exponent.p)
        if self.sign(base) == 1:
            return arguments.exponential(self, exponent * sp.log(base))
        raise NotNormalError(f"a power with exponent {exponent} of a base of unknown sign")

    def _function(self, expr: sp.Expr) -> sp.Expr:
        kind = expr.func
        if isinstance(expr, AppliedUndef | sp.Derivative | sp.Subs):
            if not expr.has(AppliedUndef):
                raise NotNormalError(f"no rule for {kind.__name__} of {expr.args[0].func.__name__}")
            return self.generator(expr, expr)
        if kind in (sp.sin, sp.cos):
            pair = arguments.cosine_sine(self, expr.args[0])
            return pair[0] if kind is sp.cos else pair[1]
        if kind in TO_SINE:
            return self.rewrite(TO_SINE[kind](expr.args[0]))
        if kind in TO_EXP:
            return self.rewrite(TO_EXP[kind](expr.args[0]))
        if kind is sp.Abs:
            return roots.modulus(self, expr.args[0])
        if kind is sp.log:
            return roots.logarithm(self, expr.args[0])
        if kind in (fn.wp, fn.wp_prime, fn.wzeta, fn.wsigma):
            return self.lattices.value(expr)
        if kind in PLAIN:
            return self.call(kind, expr.args)
        raise NotNormalError(f"no rule for {kind.__name__}")

    def call(self, kind: Any, args: tuple[sp.Expr, ...]) -> sp.Expr:
        """The generator of a function of given arguments, up to proved equality of the arguments."""
        for known, value in self.calls.setdefault(kind, []):
            if len(known) == len(args) and all(self.same(a, b) for a, b in zip(known, args, strict=True)):
                return value
        value = self._replaced(kind, args)
        if value is None:
            expr = kind(*args)
            value = self.generator(expr, expr) if isinstance(expr, kind) else self.rewrite(expr)
        self.calls[kind].append((args, value))
        return value

    def _replaced(self, kind: Any, args: tuple[sp.Expr, ...]) -> sp.Expr | None:
        """What a hypothesis says of this call."""
        for old, new in self.given.items():
            if isinstance(old, kind) and all(self.same(a, b) for a, b in zip(old.args, args, strict=True)):
                return self.rewrite(new)
        return None

    def same(self, a: sp.Expr, b: sp.Expr) -> bool:
        """True if two expressions are proved equal."""
        return bool(a == b or self.is_zero(a - b))
