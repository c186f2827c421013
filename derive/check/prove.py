"""Proof of equalities: the normal form of the difference of the two sides is zero."""

from __future__ import annotations

import sympy as sp

from derive.check import carlson
from derive.check.rational import NotNormalError
from derive.check.tower import Given, Sign, Tower, no_sign
from derive.theory.claims import Domain


def remainder(difference: sp.Expr, domain: Domain, given: Given = (), sign: Sign = no_sign) -> int:
    """How many terms the normal form of a difference keeps: 0 proves that it vanishes. Raises NotNormalError."""
    sides = carlson_free(difference, given, sign)
    tower = Tower([sides, *_old_and_new(given)], sign, given)
    return len(tower.fraction(sides).num)


def _old_and_new(given: Given) -> list[sp.Expr]:
    return [side for pair in given for side in pair]


def carlson_free(expr: sp.Expr, given: Given, sign: Sign) -> sp.Expr:
    """The expression with its derivatives of Carlson integrals carried out."""

    def same(a: sp.Expr, b: sp.Expr) -> bool:
        gap = a - b
        return gap == 0 or Tower([gap], sign, given).is_zero(gap)

    return carlson.resolved(expr, same)


def equal(lhs: sp.Expr, rhs: sp.Expr, domain: Domain, given: Given = (), sign: Sign = no_sign) -> str:
    """Empty if lhs = rhs is proved, else the reason why not."""
    if lhs == rhs:
        return ""
    try:
        left = remainder(lhs - rhs, domain, given, sign)
    except NotNormalError as reason:
        return str(reason)
    except ZeroDivisionError:
        return "a denominator vanishes identically"
    return f"the normal form of the difference keeps {left} terms" if left else ""
