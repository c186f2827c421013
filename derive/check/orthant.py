"""Domains mapped to positive numbers: every bounded variable becomes a Möbius function of one that runs over (0, ∞).

Angles within (−π, π) become tangents of their halves. Hypotheses and conditions that are linear in a variable bound it.
Where a bound cannot be used, it is left out: what is proved on a larger set holds on the domain.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

import sympy as sp

from derive.check import arguments
from derive.check.tower import Tower
from derive.theory.claims import Domain

SignOf = Callable[[sp.Expr], int | None]


@dataclass
class Mapped:
    """Expressions over positive, nonnegative and free real variables; facts are expressions > 0."""

    expr: sp.Expr
    facts: list[sp.Expr]
    free: list[sp.Symbol] = field(default_factory=list)
    complex: bool = False

    def put(self, old: sp.Expr, new: sp.Expr) -> None:
        """Substitute in the expression and in the facts."""
        self.expr = self.expr.subs(old, new)
        self.facts = [fact.subs(old, new) for fact in self.facts]


def fresh(name: str = "t", weak: bool = False) -> sp.Symbol:
    """A new positive variable; nonnegative if weak."""
    return sp.Dummy(name, nonnegative=True) if weak else sp.Dummy(name, positive=True)


def mapped(expr: sp.Expr, domain: Domain, positive: SignOf) -> Mapped:
    """The expression and the facts of the domain over the orthant; `positive` decides signs there."""
    result = Mapped(expr, list(domain.conditions))
    for symbol, (lower, upper) in reversed(list(domain.ranges.items())):
        low, high = sp.sympify(lower, strict=True), sp.sympify(upper, strict=True)
        _map_range(result, symbol, *_with_assumptions(symbol, low, high))
    rest = result.expr.free_symbols.union(*(fact.free_symbols for fact in result.facts))
    for symbol in sorted(rest, key=sp.default_sort_key):
        _map_free(result, symbol)
    _use_facts(result, positive)
    return result


def _with_assumptions(symbol: sp.Expr, low: sp.Expr, high: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
    """Ends narrowed by a symbol's own sign, where the comparison is plain."""
    if symbol.is_extended_nonnegative and (low == -sp.oo or low.is_extended_nonpositive):
        low = sp.Integer(0)
    if symbol.is_extended_nonpositive and (high == sp.oo or high.is_extended_nonnegative):
        high = sp.Integer(0)
    return low, high


def _map_range(result: Mapped, symbol: sp.Expr, low: sp.Expr, high: sp.Expr) -> None:
    """One bounded variable."""
    if not (result.expr.has(symbol) or any(fact.has(symbol) for fact in result.facts)):
        if low != -sp.oo and high != sp.oo and not (high - low).is_number:
            result.facts.append(high - low)
        return
    if _is_angle(result.expr, symbol) and _map_angle(result, symbol, low, high):
        return
    t = fresh(str(symbol))
    if low == -sp.oo and high == sp.oo:
        free = sp.Dummy(str(symbol), real=True)
        result.put(symbol, free)
        result.free.append(free)
    elif high == sp.oo:
        result.put(symbol, low + t)
    elif low == -sp.oo:
        result.put(symbol, high - t)
    else:
        result.put(symbol, (low + high * t) / (1 + t))
        if not (high - low).is_number:
            result.facts.append(high - low)


def _is_angle(expr: sp.Expr, symbol: sp.Expr) -> bool:
    return any(call.has(symbol) for call in expr.atoms(sp.sin, sp.cos, sp.tan, sp.cot, sp.sec, sp.csc))


def _map_angle(result: Mapped, symbol: sp.Expr, low: sp.Expr, high: sp.Expr) -> bool:
    """An angle within (−π, π) that occurs in circular functions only: the tangent of half of it, or of its parts."""
    if not (low.is_number and high.is_number and low >= -sp.pi and high <= sp.pi):
        return False
    unit = arguments.angle_units([result.expr]).get(symbol, 1)
    t = sp.Dummy("tan", real=True)
    values = {
        sp.cos(symbol / unit): (1 - t**2) / (1 + t**2),
        sp.sin(symbol / unit): 2 * t / (1 + t**2),
    }

    def expanded(expr: sp.Expr) -> sp.Expr:
        calls = [call for call in expr.atoms(sp.Function) if _is_angle(call, symbol) and call.args[0].has(symbol)]
        tower = Tower(calls)
        tower.units[symbol] = unit
        return expr.xreplace({call: tower.restored(tower.rewrite(call)).subs(values) for call in calls})

    expr, facts = expanded(result.expr), [expanded(fact) for fact in result.facts]
    if expr.has(symbol) or any(fact.has(symbol) for fact in facts):
        return False
    result.expr, result.facts = expr, facts
    ends = [sp.tan(end / (2 * unit)) if abs(end) != sp.pi * unit else sp.sign(end) * sp.oo for end in (low, high)]
    _map_range(result, t, *ends)
    return True


def _map_free(result: Mapped, symbol: sp.Symbol) -> None:
    """A variable without a range: by its assumptions."""
    if isinstance(symbol, sp.Dummy):
        return
    if symbol.is_positive or symbol.is_nonnegative:
        result.put(symbol, fresh(symbol.name, weak=not symbol.is_positive))
    elif symbol.is_negative or symbol.is_nonpositive:
        result.put(symbol, -fresh(symbol.name, weak=not symbol.is_negative))
    elif symbol.is_extended_real:
        free = sp.Dummy(symbol.name, real=True)
        result.put(symbol, free)
        result.free.append(free)
    elif result.expr.has(symbol):
        result.complex = True


def _use_facts(result: Mapped, positive: SignOf) -> None:
    """Facts that are linear in a variable bound it; they are used one at a time, then tried again."""
    for _ in range(4):
        progress = False
        for fact in list(result.facts):
            top, bottom = sp.fraction(sp.together(fact))
            if bottom.is_positive is not True and not bottom.is_number:
                sign = positive(bottom)
                if sign is None:
                    continue
                top = top * sign
            progress = _bound(result, fact, sp.expand(top), positive) or progress
        if not progress:
            return


def _bound(result: Mapped, fact: sp.Expr, top: sp.Expr, positive: SignOf) -> bool:
    """Bound a variable by top > 0, which is A·t + B > 0."""
    variables = sorted(top.free_symbols, key=lambda x: (x not in result.free, str(x)))
    for t in variables:
        if not (t.is_positive or t in result.free) or not top.is_polynomial(t) or sp.degree(top, t) != 1:
            continue
        slope, rest = sp.factor(top.coeff(t, 1)), sp.factor(top.coeff(t, 0))
        rising, start = positive(slope), positive(rest)
        if rising is None or (t.is_positive and start is None):
            continue
        new = fresh(t.name)
        if t in result.free:
            result.free.remove(t)
            value = -rest / slope + rising * new
        elif rising == 1 and start == -1:
            value = -rest / slope + new
        elif rising == -1 and start == 1:
            value = -rest / slope * new / (1 + new)
        else:
            continue
        result.facts.remove(fact)
        result.put(t, value)
        return True
    return False


def sides(value: Any) -> tuple[Any, Any, Any]:
    """The three values that a free variable is replaced by: t, −t, 0."""
    t = fresh(value.name)
    return t, -t, sp.Integer(0)
