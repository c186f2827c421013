"""Derivatives of Carlson's integrals along a variable, where the arguments move together.

If every argument has the derivative λ·argument + μ, homogeneity and the shift rule give the derivative
(DLMF 19.18.6, 19.18.8 and their like): for μ alone Σ∂R_F = −1/(2√(xyz)), Σ∂R_C = −1/(2y√x),
Σ∂R_D = −3/(2z√(xyz)), Σ∂R_J = −3/(2p√(xyz)); for λ the degree −½, −½, −3/2, −3/2 times the function.
Alone, each argument of R_F has ∂R_F/∂z = −R_D(x, y, z)/6 (DLMF 19.18.1 with 19.16).
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import sympy as sp

from derive.check.rational import NotNormalError
from derive.theory.functions import RC, RD, RF, RJ

KINDS = (RF, RC, RD, RJ)
Same = Callable[[sp.Expr, sp.Expr], bool]

SHIFT: dict[Any, Callable[..., sp.Expr]] = {
    RF: lambda x, y, z: -1 / (2 * sp.sqrt(x) * sp.sqrt(y) * sp.sqrt(z)),
    RC: lambda x, y: -1 / (2 * y * sp.sqrt(x)),
    RD: lambda x, y, z: -3 / (2 * z * sp.sqrt(x) * sp.sqrt(y) * sp.sqrt(z)),
    RJ: lambda x, y, z, p: -3 / (2 * p * sp.sqrt(x) * sp.sqrt(y) * sp.sqrt(z)),
}
DEGREE: dict[Any, sp.Rational] = {
    RF: sp.Rational(-1, 2),
    RC: sp.Rational(-1, 2),
    RD: sp.Rational(-3, 2),
    RJ: sp.Rational(-3, 2),
}


def resolved(expr: Any, same: Same | None = None) -> Any:
    """The expression with its derivatives carried out; those of Carlson's integrals only where `same` is given."""
    if isinstance(expr, sp.MatrixBase):
        return expr.applyfunc(lambda entry: resolved(entry, same))
    if not expr.args or not expr.has(sp.Derivative, sp.Subs, sp.Integral):
        return expr
    if not expr.has(*KINDS):
        return expr.doit()
    if isinstance(expr, sp.Derivative) and expr.expr.has(*KINDS):
        return _resolved_derivative(expr, same)
    if isinstance(expr, sp.Subs) and expr.has(*KINDS):
        if same is None:
            return expr
        return resolved(expr.expr, same).xreplace(dict(zip(expr.variables, expr.point, strict=True)))
    return expr.func(*(resolved(arg, same) for arg in expr.args))


def _resolved_derivative(expr: sp.Derivative, same: Same | None) -> sp.Expr:
    if same is None:
        return expr
    value = resolved(expr.expr, same)
    for variable, count in expr.variable_count:
        for _ in range(int(count)):
            value = differentiated(value, variable, same)
    return value


def differentiated(expr: sp.Expr, x: sp.Symbol, same: Same) -> sp.Expr:
    """d/dx by the usual rules, with each Carlson integral as an unknown function of x."""
    calls = sorted((call for call in expr.atoms(*KINDS) if call.has(x)), key=sp.count_ops)
    stand_ins = {call: sp.Function(f"carlson_{k}")(x) for k, call in enumerate(calls)}
    result = expr.xreplace(stand_ins).diff(x)
    for call, stand_in in stand_ins.items():
        result = result.xreplace({stand_in.diff(x): slope(call, x, same)})
    return result.xreplace({stand_in: call for call, stand_in in stand_ins.items()})


def slope(call: sp.Expr, x: sp.Symbol, same: Same) -> sp.Expr:
    """d/dx of one Carlson integral; refused unless its arguments move together or it is R_F."""
    args, slopes = call.args, [arg.diff(x) for arg in call.args]
    first = slopes[0]
    if all(same(first, other) for other in slopes[1:]):
        return first * SHIFT[call.func](*args)
    # Solve a′ = λ a + μ by two arguments that differ, and see whether the others follow.
    for k in range(1, len(args)):
        if not same(args[0], args[k]):
            scale = (slopes[0] - slopes[k]) / (args[0] - args[k])
            shift = slopes[0] - scale * args[0]
            if all(same(s, scale * a + shift) for s, a in zip(slopes, args, strict=True)):
                return DEGREE[call.func] * scale * call + shift * SHIFT[call.func](*args)
            break
    if call.func is RF:
        a, b, c = args
        rates = zip(((b, c, a), (a, c, b), (a, b, c)), slopes, strict=True)
        return sp.Add(*(-RD(*order) * rate / 6 for order, rate in rates))
    raise NotNormalError(f"the arguments of {call.func.__name__} do not move together")
