"""Which formulas a scene evaluates, and in which form: those of its load case, or those for any field angle."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

from sympy import Expr, srepr

from derive.emit.backends import EACH, FORMULAS
from derive.emit.errors import EmitError
from derive.emit.scene import GENERAL_CASE
from derive.emit.substitute import substitute
from derive.theory.claims import Formula


def specialise_formula(formula: Formula, folded: Mapping[str, Expr]) -> Formula:
    """The formula with the folded parameters replaced by their values, without the arguments that leaves unread."""
    fixed = {symbol: folded[symbol.name] for symbol in formula.arguments if symbol.name in folded}
    if not fixed:
        return formula
    expression = substitute(formula.expression, fixed)
    gone = formula.expression.free_symbols - expression.free_symbols | set(fixed)
    arguments = tuple(symbol for symbol in formula.arguments if symbol not in gone)
    return replace(formula, arguments=arguments, expression=expression)


def formulas_of(theory: Any, *cases: str) -> dict[str, Formula]:
    """The formulas of load cases by name, unique in each; a later case stands before an earlier one."""
    found: dict[str, Formula] = {}
    for case in cases:
        own: dict[str, Formula] = {}
        for formula in (f for f in theory.formulas if f.case == case):
            if formula.name in own:
                raise EmitError(f"the theory has two formulas '{formula.name}' for case '{case}'")
            own[formula.name] = formula
        found |= own
    return found


def kernel_formulas(theory: Any) -> dict[str, Formula]:
    """The formulas in the form in which kernels call them.

    Of the article's own formulas, those that the general case does not have are taken from the first case that has.
    """
    found = formulas_of(theory, GENERAL_CASE)
    for formula in theory.formulas:
        if formula.family == "article":
            found.setdefault(formula.name, formula)
    if not found:
        raise EmitError(f"the theory has no formulas for case '{GENERAL_CASE}'; derive them first")
    return found


def spelled(formula: Formula) -> str:
    """All that a formula says, for the digest of a module."""
    return f"{formula.name}({', '.join(map(str, formula.arguments))}) = {srepr(formula.expression)}"


def base_name(file: str, name: str) -> str:
    """The theory's name of a formula that a kernel takes from ``file``."""
    return name.removesuffix(EACH) if file == FORMULAS[1] else name
