"""SymPy expressions → typed trees, so that the printer can write them in the article's letters.

One row per operation. Whoever calls says which trees stand for which expressions; what is left over is a SpellError.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping
from dataclasses import dataclass, field
from typing import Any

import sympy as sp

from derive.paper import tree as t
from derive.report.tidy import SpellError, by_powers, negative, ordered
from derive.theory import functions as fn

Known = Mapping[Any, t.Node]  # expression → the tree that stands for it
# Functions of the theory and of SymPy: the name in the conventions, and the primes it carries.
FUNCTIONS: dict[Any, tuple[str, int]] = {
    sp.sin: ("sin", 0), sp.cos: ("cos", 0), sp.asin: ("asin", 0), sp.acosh: ("acosh", 0), sp.log: ("ln", 0),
    fn.wp: ("wp", 0), fn.wp_prime: ("wp", 1), fn.wzeta: ("wzeta", 0), fn.wsigma: ("wsigma", 0),
}  # fmt: skip


def no(*given: Any) -> bool:
    """Of nothing."""
    return False


@dataclass(frozen=True)
class Speller:
    """Writes expressions as trees.

    known: what has a letter. allowed: names of functions that the section has. signs: symbols of square one and the
    printed sign of each. moving: would a name take a bracket after it as its argument? powers: the letter by whose
    powers sums are ordered, if there is one.
    """

    known: Known
    allowed: Collection[str] = ()
    signs: Mapping[Any, str] = field(default_factory=dict)
    moving: Callable[[str], bool] = no
    powers: sp.Symbol | None = None

    def of(self, expr: Any) -> t.Node:
        """The tree of an expression."""
        if expr in self.known:
            return self.known[expr]
        for kind, row in _ROWS:
            if isinstance(expr, kind):
                return row(self, expr)
        raise SpellError(f"there is no letter for {expr}")

    def total(self, expr: sp.Add) -> t.Node:
        """Terms by the powers of the letter that orders them, else those with a plus first; each after its sign."""
        terms = by_powers(expr, self.powers) if self.powers is not None else []
        listed = terms or ordered(expr.as_ordered_terms())
        shown = tuple(self.term(part) for part in listed)
        return shown[0] if len(shown) == 1 else t.Sum(shown)

    def term(self, expr: Any) -> t.Node:
        """One term: its sign, then numerator over denominator."""
        for symbol, sign in self.signs.items():
            if symbol in sp.Mul.make_args(expr):
                return t.Signed(sign, self.of(expr / symbol))
        if expr in self.known:
            return self.known[expr]
        if negative(expr):
            return t.Signed("-", self.term(positive(expr)))
        above, below = sp.fraction(expr)
        return self.product(above) if below == 1 else t.Quotient(self.product(above), self.product(below))

    def product(self, expr: Any) -> t.Node:
        """Factors side by side, the number first, then letters before sums."""
        number, rest = expr.as_coeff_Mul()
        factors = [] if number == 1 and rest != 1 else [self.of(number)]
        parts = [part for part in rest.as_ordered_factors() if part != 1]
        factors += sorted((self.of(part) for part in parts), key=self._place)
        return factors[0] if len(factors) == 1 else t.Product(tuple(factors))

    def _place(self, factor: t.Node) -> int:
        """Letters, then sums in brackets, then letters that would take a bracket as an argument."""
        below = factor.base if isinstance(factor, t.Power) else factor
        if isinstance(below, t.Name | t.Primed):
            name = below if isinstance(below, t.Name) else below.of
            return 2 if isinstance(name, t.Name) and self.moving(name.name) else 0
        return 1

    def number(self, expr: Any) -> t.Node:
        """An exact number."""
        if expr < 0:
            return t.Signed("-", self.number(-expr))
        return t.Number(int(expr.p)) if expr.q == 1 else t.Quotient(t.Number(int(expr.p)), t.Number(int(expr.q)))

    def power(self, expr: sp.Pow) -> t.Node:
        """A root, a reciprocal or a power."""
        base, exponent = expr.args
        if exponent.is_negative:
            return t.Quotient(t.Number(1), self.of(1 / expr))
        if exponent == sp.Rational(1, 2):
            return t.Root(self.of(base))
        return t.Power(self.of(base), self.of(exponent))

    def modulus(self, expr: Any) -> t.Node:
        """An absolute value."""
        return t.Norm(self.of(expr.args[0]))

    def call(self, expr: Any) -> t.Node:
        """A function at its arguments."""
        name, primes = FUNCTIONS.get(expr.func, ("", 0))
        if name not in self.allowed:
            raise SpellError(f"there is no letter for the function {expr.func.__name__}")
        return t.Call(name, tuple(self.of(arg) for arg in expr.args), primes)


def positive(expr: Any) -> Any:
    """A negative expression without its sign; sums inside a product lose theirs one by one."""
    if not expr.is_Mul:
        return -expr
    parts = (-part if negative(part) else part for part in expr.args)
    return sp.Mul(*parts)


_ROWS: tuple[tuple[Any, Callable[[Speller, Any], t.Node]], ...] = (
    (sp.Rational, Speller.number),
    (sp.Add, Speller.total),
    (sp.Mul, Speller.term),
    (sp.Pow, Speller.power),
    (sp.Abs, Speller.modulus),
    (sp.Function, Speller.call),
)
