"""Limits and orders proved: by continuity, L'Hôpital's rule or Taylor terms.

A limit is taken in a local parameter τ → 0+, x = point ± τ² or x = ±1/τ² (the square makes roots of the distance
rational). If no denominator vanishes at τ = 0, the expression is continuous there, and its value is compared by normal
form. Carlson integrals of arguments that grow without bound are scaled back by homogeneity; their arguments must stay
positive. Otherwise numerator and denominator, both zero at τ = 0, are differentiated.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import sympy as sp

from derive.check import carlson
from derive.check import prove as equality
from derive.check.approach import directions, entries
from derive.check.rational import NotNormalError
from derive.check.signs import Signs
from derive.check.tower import Tower
from derive.theory import functions as fn
from derive.theory.claims import Claim, Domain, Limit, Order

Sign = Callable[[sp.Expr], int | None]

ROUNDS = 4  # uses of L'Hôpital's rule


def prove(claim: Claim, sign: Sign) -> str:
    """Empty if a Limit or Order claim is proved, else the reason why not."""
    relation = claim.relation
    try:
        if isinstance(relation, Order):
            return next((reason for e in entries(relation) if (reason := _order(e, relation, claim))), "")
        assert isinstance(relation, Limit)
        return next((reason for way in directions(relation) if (reason := _limit(relation, way, claim))), "")
    except (NotNormalError, ZeroDivisionError, NotImplementedError) as reason:  # SymPy gave up: no proof
        return str(reason) or "a denominator vanishes identically"


def _order(expr: sp.Expr, relation: Order, claim: Claim) -> str:
    """Analytic at 0, and every derivative below the power vanishes there."""
    x, sign = relation.variable, Signs(_without(claim.domain, relation.variable), claim.given).sign
    if not _analytic(expr, x, sign):
        return f"not seen to be analytic at {x} = 0"
    term = expr
    for k in range(relation.power):
        reason = equality.equal(term.subs(x, 0), sp.Integer(0), claim.domain, claim.given, sign)
        if reason:
            return f"the Taylor coefficient of order {k}: {reason}"
        term = term.diff(x)
    return ""


def _without(domain: Domain, variable: sp.Symbol) -> Domain:
    ranges = {x: ends for x, ends in domain.ranges.items() if x != variable}
    ends = [sp.sympify(end, strict=True) for pair in ranges.values() for end in pair]
    if any(end.has(variable) for end in ends):
        return Domain({})
    return Domain(ranges, tuple(c for c in domain.conditions if not c.has(variable)))


def _analytic(expr: sp.Expr, x: sp.Symbol, sign: Sign) -> bool:
    """No denominator vanishes identically at x = 0, and roots and logarithms are of what is positive there."""
    smooth = (sp.sin, sp.cos, sp.exp, sp.sinh, sp.cosh, sp.atan)
    for node in sp.preorder_traversal(expr):
        if not node.has(x) or not node.args or node.is_Add or node.is_Mul or isinstance(node, smooth):
            continue
        if node.is_Pow and node.exp.is_Integer and node.exp > 0:
            continue
        inner = (
            node.base if node.is_Pow and node.exp.is_Rational else node.args[0] if isinstance(node, sp.log) else None
        )
        if inner is None:
            return False
        start = inner.subs(x, 0)
        if start.has(sp.nan, sp.zoo, sp.oo) or Tower([start], sign).is_zero(start):
            return False
        if not (node.is_Pow and node.exp.is_Integer) and sign(start) != 1 and start.is_positive is not True:
            return False
    return True


def _limit(relation: Limit, direction: Any, claim: Claim) -> str:
    """One side of a limit."""
    tau = sp.Dummy("tau", positive=True)
    at_point = _without(claim.domain, relation.variable)
    sign = Signs(at_point, claim.given).sign
    expr = relation.expr.subs(relation.variable, direction(tau**2))  # a square, for the roots of the distance
    infinite = relation.value in (sp.oo, -sp.oo)
    expr = _scaled(1 / expr if infinite else expr, tau, sign)
    found = _value(expr, tau, Near(tau, sign))
    if found is None:
        return "neither continuous at the point nor a quotient of zeros"
    reason = equality.equal(found, sp.Integer(0) if infinite else relation.value, at_point, claim.given, sign)
    return reason or (_infinite(claim) if infinite else "")


def _infinite(claim: Claim) -> str:
    relation = claim.relation
    assert isinstance(relation, Limit)
    wanted = 1 if relation.value == sp.oo else -1
    known = Signs(claim.domain, claim.given).sign(relation.expr)
    return "" if known == wanted else "the sign near the point is not proved"


def _scaled(expr: sp.Expr, tau: sp.Symbol, sign: Sign) -> sp.Expr:
    """Carlson integrals whose arguments are infinite at τ = 0, by homogeneity: C(a) = τ^{−kd} C(τᵏa) of degree d."""
    for call in sorted(expr.atoms(fn.RF, fn.RC, fn.RD, fn.RJ), key=sp.count_ops):
        for k in (1, 2):
            args = [sp.cancel(arg * tau**k) for arg in call.args]
            ends = [arg.subs(tau, 0) for arg in args]
            if all(not end.has(sp.nan, sp.zoo, sp.oo) and sign(end) == 1 for end in ends):
                degree = sp.Rational(1, 2) if isinstance(call, fn.RF | fn.RC) else sp.Rational(3, 2)
                expr = expr.xreplace({call: tau ** (k * degree) * call.func(*args)})
                break
    return expr


class Near:
    """Signs for all small τ > 0 (how small may depend on the other variables): those at τ = 0, where not zero."""

    def __init__(self, tau: sp.Symbol, sign: Sign) -> None:
        self.tau = tau
        self.at_zero = sign

    def sign(self, expr: sp.Expr) -> int | None:
        """+1 or −1 if the expression has that sign for all small τ."""
        if expr == self.tau:
            return 1
        start = _at_zero(expr, self.tau, self.at_zero)
        found = None if start is None else self.at_zero(start)
        return found or None

    def same(self, a: sp.Expr, b: sp.Expr) -> bool:
        """True if two expressions are proved equal."""
        return bool(a == b or Tower([a - b], self.sign).is_zero(a - b))


def _value(expr: sp.Expr, tau: sp.Symbol, near: Near) -> sp.Expr | None:
    """The limit of an expression as τ → 0+, None if it cannot be told."""
    top, below = _quotient(expr, near)
    # Factors without τ cannot vanish where the expression is defined; they wait outside.
    outside = sp.Mul(*(factor**times for factor, times in below.items() if not factor.has(tau)))
    bottom = sp.Mul(*(factor**times for factor, times in below.items() if factor.has(tau)))
    for _ in range(ROUNDS):
        ends = [_at_zero(part, tau, near.at_zero) for part in (top, bottom)]
        if ends[0] is None or ends[1] is None:
            return None
        if near.at_zero(ends[1]) in (1, -1):
            return ends[0] / ends[1] / outside
        if not all(end == 0 or Tower([end], near.at_zero).is_zero(end) for end in ends):
            return None
        quotient = carlson.differentiated(top, tau, near.same) / carlson.differentiated(bottom, tau, near.same)
        top, below = _quotient(quotient, near)
        bottom = sp.Mul(*(factor**times for factor, times in below.items()))
    return None


def _quotient(expr: sp.Expr, near: Near) -> tuple[sp.Expr, dict[sp.Expr, int]]:
    """Numerator and factors of the denominator, after cancellation over the generators."""
    tower = Tower([expr], near.sign)
    fraction = tower.fraction(expr)
    below: dict[sp.Expr, int] = {}
    for poly, times in fraction.den.items():
        for part, power in poly.factor_list()[1]:
            factor = tower.restored(part.as_expr())
            below[factor] = below.get(factor, 0) + times * power
    number = sp.Mul(*(_rational(poly.factor_list()[0]) ** times for poly, times in fraction.den.items()))
    return tower.restored(fraction.num.as_expr()) / number, below


def _at_zero(expr: sp.Expr, tau: sp.Symbol, sign: Sign) -> sp.Expr | None:
    """The value at τ = 0 of an expression that is continuous there, else None."""
    continuous = (sp.sin, sp.cos, sp.exp, sp.atan, sp.sinh, sp.cosh)
    for node in sp.preorder_traversal(expr):
        if not node.has(tau) or not node.args or node.is_Add or node.is_Mul or isinstance(node, continuous):
            continue
        if node.is_Pow and node.exp.is_Rational and node.exp > 0 and (node.exp.is_Integer or _is_real(node.base)):
            continue
        if node.is_Pow and node.exp.is_Rational and sign(node.base.subs(tau, 0)) in (1, -1):
            continue
        if isinstance(node, fn.RF | fn.RC | fn.RD | fn.RJ) and all(sign(a.subs(tau, 0)) == 1 for a in node.args):
            continue
        if isinstance(node, sp.log) and sign(node.args[0].subs(tau, 0)) == 1:
            continue
        return None
    value = expr.subs(tau, 0)
    return None if value.has(sp.nan, sp.zoo, sp.oo) else value


def _is_real(expr: sp.Expr) -> bool:
    """No i in it, and every symbol is real: a root of it does not cross its cut."""
    return not expr.has(sp.I) and all(x.is_extended_real for x in expr.free_symbols)


def _rational(number: Any) -> sp.Rational:
    return sp.Rational(int(number.numerator), int(number.denominator))
