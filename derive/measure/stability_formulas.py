"""Emitted formulas as functions that can be examined: in doubles, and to any precision with their condition number.

The exact side is the expression read back from the emitted code, which is proved to be the theory's, evaluated by
mpmath. An expression of n operations in doubles errs by some n·2⁻⁵³ times its condition number Σ|x ∂f/∂x|/|f|, if it
does what can be done; what it errs beyond that is its own fault, and called the excess.
"""

from __future__ import annotations

import ast
import inspect
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cache, partial
from math import inf, isfinite
from pathlib import Path
from typing import Any

import sympy as sp
from mpmath import mp, mpf

from derive.emit.kernels import formulas as emitted
from derive.emit.readback import read_formula, read_module

DIGITS = 100  # 50 of the result are wanted, and differences for derivatives take as many
NUDGE = 30  # digits of the step of a difference
UNIT = 2.0**-53
LEAST = 2.0**-960  # below, a double has lost digits to underflow
LABEL = "formulas.py"
EXACT_FUNCTIONS = {sp.sin: mp.sin, sp.cos: mp.cos}

Exact = Callable[[Sequence[Any]], Any]


@dataclass(frozen=True)
class Examined:
    """A formula: its emitted function, its exact value, and the number of operations in its code."""

    name: str
    arguments: tuple[str, ...]
    double: Callable[..., float]
    exact: Exact
    operations: int


@dataclass(frozen=True)
class Finding:
    """At one input: loss in roundings of the result, condition number, excess = loss/(operations·(1 + condition))."""

    excess: float
    loss: float
    condition: float
    arguments: tuple[float, ...]


@cache
def known_formulas() -> dict[str, Examined]:
    """All formulas of the kernels, in the order of the code."""
    module = read_module(Path(emitted.__file__).read_text(encoding="utf-8"), LABEL)
    own = {name: function for name, function in vars(emitted).items() if inspect.isfunction(function)}
    return {
        name: examined(name, function, partial(read_formula, module, name, label=LABEL))
        for name, function in own.items()
        if function.__module__ == emitted.__name__
    }


def examined(name: str, function: Callable[..., float], expression: Callable[[dict[str, Any]], Any]) -> Examined:
    """A function with its expression, which is given symbols of its arguments' names."""
    arguments = tuple(inspect.signature(function).parameters)
    letters = {argument: sp.Symbol(argument, real=True) for argument in arguments}
    exact = compiled(expression(letters), list(letters.values()))
    return Examined(name, arguments, function, exact, operations(function))


def operations(function: Callable[..., float]) -> int:
    """How many operations its code has that may round."""
    tree = ast.parse(inspect.getsource(function))
    return max(1, sum(isinstance(node, ast.BinOp | ast.Call) for node in ast.walk(tree)))


def compiled(expression: Any, letters: Sequence[Any]) -> Exact:
    """An expression of sums, products, powers, sines and cosines as a function of numbers of mpmath."""
    if expression in letters:
        place = list(letters).index(expression)
        return lambda values: values[place]
    if expression.is_Rational:
        above, below = int(expression.p), int(expression.q)
        return lambda values: mpf(above) / below
    parts = [compiled(part, letters) for part in expression.args]
    if expression.is_Add:
        return lambda values: mp.fsum(part(values) for part in parts)
    if expression.is_Mul:
        return lambda values: mp.fprod(part(values) for part in parts)
    if expression.is_Pow and expression.exp.is_Rational:
        return lambda values: mp.power(parts[0](values), parts[1](values))
    if expression.func in EXACT_FUNCTIONS:
        function = EXACT_FUNCTIONS[expression.func]
        return lambda values: function(parts[0](values))
    raise TypeError(f"no exact value is known of {expression.func.__name__} in a formula: {expression}")


def examine(formula: Examined, arguments: tuple[float, ...], above: float = 0.0) -> Finding | None:
    """What the formula loses at one input; None where it has no value, or one that underflows, or no excess above that.

    The condition number is the dear part, and spared where the loss is small without it.
    """
    with mp.workdps(DIGITS):
        values = [mpf(argument) for argument in arguments]
        exact = value_of(formula, values)
        if exact is None or 0 < abs(exact) < LEAST:
            return None
        try:
            double = float(formula.double(*arguments))
        except (ArithmeticError, ValueError):
            return Finding(inf, inf, 1.0, arguments)
        if double == exact:
            return None
        if not isfinite(double) or not exact:
            return Finding(inf, inf, 1.0, arguments)
        loss = float(abs(double - exact) / abs(exact)) / UNIT
        if loss <= formula.operations * above:
            return None
        condition = condition_at(formula, values, exact)
    return Finding(loss / (formula.operations * (1 + condition)), loss, condition, arguments)


def value_of(formula: Examined, values: Sequence[Any]) -> Any:
    """The exact value, None where there is none."""
    try:
        found = formula.exact(values)
    except (ZeroDivisionError, ValueError):
        return None
    return found if isinstance(found, mpf) and mp.isfinite(found) else None


def condition_at(formula: Examined, values: Sequence[Any], exact: Any) -> float:
    """Σ|x ∂f/∂x|/|f| by differences; those of a root at the end of its domain are taken inwards."""
    total, step = mpf(0), mpf(10) ** -NUDGE
    for place, value in enumerate(values):
        for nudge in (step, -step):
            there = value_of(formula, [*values[:place], value * (1 + nudge), *values[place + 1 :]])
            if there is not None:
                total += abs((there - exact) / step)
                break
    return float(total / abs(exact))
