"""Numeric value of a SymPy expression at a point, by a table-driven walk in mpmath arithmetic.

Nothing is compiled or parsed. Precision is local. A sum whose terms cancel to the last digits counts as zero, so that
division by a hidden zero is *undefined* and not a large number. UndefinedError functions and their derivatives take
their values from the point, as independent numbers.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

import mpmath
import sympy as sp
from mpmath import mp
from sympy.core.function import AppliedUndef

from derive.check import elliptic, rectangle
from derive.theory import functions as fn

GUARD = 15  # working digits beyond those asked for
LOST = 8  # a sum that loses all but so many digits is taken for zero

Point = Mapping[sp.Expr, sp.Expr]


class UndefinedError(ArithmeticError):
    """The expression has no finite value at the point; the message says where."""


class wp_inverse(sp.Function):  # noqa: N801 - named like its numeric twin
    """A point v with ℘(v) = c and ℘′(v) nearest to slope: wp_inverse(c, slope, g2, g3)."""

    nargs = 4


def _nonzero(x: Any) -> Any:
    if x == 0:
        raise UndefinedError("division by zero, or a logarithm of zero")
    return x


def _power(base: Any, exponent: Any) -> Any:
    if base == 0:
        if mp.re(exponent) < 0:
            raise UndefinedError("division by zero")
        return mp.mpf(0) if exponent != 0 else mp.mpf(1)
    return mp.power(base, exponent)


def _max(*values: Any) -> Any:
    if any(mp.im(v) != 0 for v in values):
        raise UndefinedError("maximum of complex numbers")
    return max(mp.re(v) for v in values)


def _sign(x: Any) -> Any:
    return mp.mpf(0) if x == 0 else x / abs(x)


TABLE: dict[type, Callable[..., Any]] = {
    sp.sin: mp.sin, sp.cos: mp.cos, sp.tan: mp.tan, sp.cot: mp.cot, sp.sec: mp.sec, sp.csc: mp.csc,
    sp.asin: mp.asin, sp.acos: mp.acos, sp.atan: mp.atan, sp.acot: mp.acot,
    sp.sinh: mp.sinh, sp.cosh: mp.cosh, sp.tanh: mp.tanh, sp.coth: mp.coth,
    sp.asinh: mp.asinh, sp.acosh: mp.acosh, sp.atanh: mp.atanh,
    sp.exp: mp.exp, sp.Abs: abs, sp.re: mp.re, sp.im: mp.im, sp.conjugate: mp.conj, sp.sign: _sign,
    sp.log: lambda x: mp.log(_nonzero(x)),
    sp.atan2: lambda y, x: mp.arg(_nonzero(mp.mpc(x, y))),
    sp.Max: _max, sp.Min: lambda *values: -_max(*(-v for v in values)),
    fn.wp: elliptic.wp, fn.wp_prime: elliptic.wp_prime, fn.wzeta: elliptic.wzeta, fn.wsigma: elliptic.wsigma,
    fn.RF: mp.elliprf, fn.RC: mp.elliprc, fn.RD: mp.elliprd, fn.RJ: mp.elliprj,
    wp_inverse: elliptic.wp_inverse,
    fn.half_period: rectangle.half_period, fn.perimeter_point: rectangle.perimeter_point,
}  # fmt: skip

CONSTANTS: dict[sp.Expr, Callable[[], Any]] = {
    sp.pi: lambda: +mp.pi,
    sp.E: lambda: +mp.e,
    sp.I: lambda: mp.mpc(0, 1),
    sp.EulerGamma: lambda: +mp.euler,
}


def dyadic(number: Any) -> sp.Rational:
    """A number of mpmath's, exactly. Its integers may be of a kind, gmpy2's, that SymPy does not take."""
    return sp.Rational(*map(int, mpmath.libmp.to_rational(number._mpf_)))


class _Walk:
    """One evaluation: the point, and the values found so far."""

    def __init__(self, point: Point, known: dict[sp.Expr, Any] | None = None) -> None:
        self.point = point
        self.known: dict[sp.Expr, Any] = {} if known is None else known

    def value(self, expr: sp.Expr) -> Any:
        """The finite value of an expression, computed once."""
        if expr not in self.known:
            result = self._compute(expr)
            if not mp.isfinite(result):
                raise UndefinedError(f"no finite value of {expr.func.__name__}")
            self.known[expr] = result
        return self.known[expr]

    def _compute(self, expr: sp.Expr) -> Any:
        if expr in self.point:
            return self.value(sp.sympify(self.point[expr], strict=True))
        if expr.is_Rational:
            return mp.mpf(int(expr.p)) / int(expr.q)
        if expr in CONSTANTS:
            return CONSTANTS[expr]()
        if expr.is_Float:
            return mp.mpf(expr._mpf_)
        if expr.is_Add:
            return self._sum([self.value(term) for term in expr.args])
        if expr.is_Mul:
            return mp.fprod(self.value(factor) for factor in expr.args)
        if expr.is_Pow:
            return _power(self.value(expr.base), self.value(expr.exp))
        return self._other(expr)

    def _sum(self, terms: list[Any]) -> Any:
        total, size = mp.fsum(terms), max(abs(term) for term in terms)
        return mp.mpf(0) if abs(total) < size * mp.mpf(10) ** (LOST + GUARD - mp.dps) else total

    def _other(self, expr: sp.Expr) -> Any:
        if isinstance(expr, sp.Derivative):
            return self._derivative(expr)
        if isinstance(expr, sp.Subs):
            inner = dict(zip(expr.variables, expr.point, strict=True))
            return _Walk({**self.point, **{k: self._exact(v) for k, v in inner.items()}}).value(expr.expr)
        if isinstance(expr, sp.Integral):
            return self._integral(expr)
        if isinstance(expr, sp.Piecewise):
            return self._piecewise(expr)
        rule = TABLE.get(expr.func)
        if rule is None or isinstance(expr, AppliedUndef):
            raise UndefinedError(f"no value is known for {expr}")
        try:
            return rule(*(self.value(arg) for arg in expr.args))
        except (ValueError, ZeroDivisionError, elliptic.DegenerateError, elliptic.PoleError, OverflowError) as error:
            raise UndefinedError(f"{expr.func.__name__}: {error}") from error

    def _exact(self, expr: sp.Expr) -> sp.Expr:
        """The value of an expression as an exact dyadic number, for use in another point."""
        value = self.value(expr)
        return dyadic(mp.re(value)) + sp.I * dyadic(mp.im(value))

    def _along(self, variable: sp.Symbol, expr: sp.Expr) -> Callable[[Any], Any]:
        """The expression as a function of one variable, the others as in the point."""

        def function(x: Any) -> Any:
            walk = _Walk(self.point)
            walk.known[variable] = mp.convert(x)
            return walk.value(expr)

        return function

    def _derivative(self, expr: sp.Derivative) -> Any:
        """A derivative that is left unevaluated (of a Carlson integral), by differences at doubled precision."""
        if len(expr.variable_count) != 1 or expr.expr.has(AppliedUndef):
            raise UndefinedError(f"no value is known for {expr}")
        variable, count = expr.variable_count[0]
        return mp.diff(self._along(variable, expr.expr), self.value(variable), int(count))

    def _integral(self, expr: sp.Integral) -> Any:
        if len(expr.limits) != 1 or len(expr.limits[0]) != 3:
            raise UndefinedError("only integrals over one interval have a value")
        variable, lower, upper = expr.limits[0]
        return mp.quad(self._along(variable, expr.function), [self.value(lower), self.value(upper)])

    def _piecewise(self, expr: sp.Piecewise) -> Any:
        for value, condition in expr.args:
            if condition == sp.true or self._holds(condition):
                return self.value(value)
        raise UndefinedError("no piece applies")

    def _holds(self, condition: Any) -> bool:
        if not isinstance(condition, sp.core.relational.Relational):
            raise UndefinedError(f"cannot decide {condition}")
        gap = self.value(condition.lhs) - self.value(condition.rhs)
        if mp.im(gap) != 0:
            raise UndefinedError("complex numbers are compared")
        tests = {"<": gap < 0, "<=": gap <= 0, ">": gap > 0, ">=": gap >= 0, "==": gap == 0, "!=": gap != 0}
        return bool(tests[condition.rel_op])


def evaluate(expr: Any, point: Point, digits: int = 50, known: dict[sp.Expr, Any] | None = None) -> Any:
    """The value (mpf or mpc) of an expression at a point, with about so many digits.

    The point maps symbols, applied undefined functions and their derivatives to exact numbers, or to expressions
    in the others. known: values at this point, to these digits, from before; new ones are added. Raises UndefinedError
    where there is no finite value.
    """
    with mp.workdps(digits + GUARD):
        try:
            return _clean(_Walk(point, known).value(sp.sympify(expr, strict=True)), digits)
        except (ValueError, ZeroDivisionError, OverflowError, mpmath.libmp.NoConvergence) as error:
            raise UndefinedError(str(error)) from error


def _clean(value: Any, digits: int) -> Any:
    """A complex value with an imaginary part of rounding size becomes real."""
    if isinstance(value, mp.mpc) and abs(value.imag) <= abs(value.real) * mp.mpf(10) ** -digits:
        return value.real
    return value


def magnitude(expr: Any, point: Point, digits: int = 50, known: dict[sp.Expr, Any] | None = None) -> Any:
    """The sum of the absolute values of the terms of an expression: the scale of its rounding errors."""
    with mp.workdps(digits):
        return mp.fsum(
            abs(evaluate(term, point, digits, known)) for term in sp.Add.make_args(sp.sympify(expr, strict=True))
        )
