"""The claims and the formulas of the derivation as LaTeX in the letters of the theory, as plain records."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from functools import cache, partial
from typing import Any

import sympy as sp
from sympy.printing.latex import LatexPrinter

from derive.report import text as tex
from derive.theory.claims import Claim, Domain, Equal, Limit, NonNegative, Order, Positive, Relation, Remark

LONGEST = 900  # characters of LaTeX that anybody would look at; what is longer is shown as text
WORDS = re.compile(r"[A-Za-z]{2,}")
# Functions of the theory as they are written everywhere else.
HEADS = {
    "wp": r"\wp", "wp_prime": r"\wp^{\prime}", "wzeta": r"\zeta", "wsigma": r"\sigma", "RF": "R_{F}", "RJ": "R_{J}",
    "RC": "R_{C}", "RD": "R_{D}",
}  # fmt: skip
SPECIAL = {"sin", "cos", "tan", "sinh", "cosh", "tanh", "exp", "log", "atan", "asin", "acos", "Abs", "Max", "Min"}


class Printer(LatexPrinter):  # type: ignore[misc]
    """Names of one letter with their scripts; names of words as words."""

    def __init__(self) -> None:
        super().__init__({"ln_notation": True, "fold_short_frac": False})

    def _print_Symbol(self, expr: sp.Symbol, style: str = "plain") -> str:
        return named(expr.name)

    _print_Dummy = _print_Symbol

    def _print_Function(self, expr: Any, exp: Any = None) -> str:
        name = type(expr).__name__
        if name in SPECIAL:
            return str(super()._print_Function(expr, exp))
        head = HEADS.get(name) or named(name)
        power = rf"^{{{exp}}}" if exp is not None else ""
        arguments = ", ".join(self._print(arg) for arg in expr.args)
        return rf"{{{head}}}{power}\left( {arguments} \right)"


PRINTER = Printer()


def named(name: str) -> str:
    """A name of the theory as LaTeX: ``xi_tip`` by its letter, ``half_width`` as words."""
    base = name.split("_")[0]
    if WORDS.fullmatch(base) and base.lower() not in tex.GREEK and base not in ("EI", "GJ"):
        plain = re.fullmatch(r"([a-z])([a-z])?(\d?)", base) is None
        return rf"\text{{{name.replace('_', ' ')}}}" if plain else tex.symbol(name)
    return tex.symbol(name)


def latex(expression: Any) -> str:
    """An expression as LaTeX."""
    return _kept(expression) if isinstance(expression, sp.Basic) else str(PRINTER.doprint(expression))


@cache
def _kept(expression: Any) -> str:
    return str(PRINTER.doprint(expression))


def said(relation: Relation) -> str:
    """A relation as LaTeX."""
    match relation:
        case Equal(lhs, rhs):
            return f"{latex(lhs)} = {latex(rhs)}"
        case Positive(expr):
            return f"{latex(expr)} > 0"
        case NonNegative(expr):
            return rf"{latex(expr)} \ge 0"
        case Limit(expr, variable, point, value, side):
            sign = "" if side == "+-" or point.is_infinite else f"^{{{side}}}"
            under = rf"{latex(variable)} \to {{{latex(point)}}}{sign}"
            return rf"\lim_{{{under}}} \left( {latex(expr)} \right) = {latex(value)}"
        case Order(expr, variable, power):
            return rf"{latex(expr)} = O \left( {latex(variable**power)} \right)"
    raise TypeError(f"no relation: {relation}")


def plainly(relation: Relation) -> str:
    """A relation as text, as SymPy writes its sides."""
    match relation:
        case Equal(lhs, rhs):
            return f"{lhs} = {rhs}"
        case Positive(expr):
            return f"{expr} > 0"
        case NonNegative(expr):
            return f"{expr} >= 0"
        case Limit(expr, variable, point, value, side):
            return f"{expr} -> {value} as {variable} -> {point} ({side})"
        case Order(expr, variable, power):
            return f"{expr} = O({variable}**{power})"
    raise TypeError(f"no relation: {relation}")


def formula(text: str, instead: Callable[[], Any]) -> dict[str, str]:
    """A formula as a record: LaTeX, or what stands for it as text if it is too long to be read."""
    return {"latex": text, "text": ""} if len(text) <= LONGEST else {"latex": "", "text": str(instead())}


def where(domain: Domain) -> Iterator[str]:
    """The hypotheses of a domain as LaTeX."""
    for symbol, (lower, upper) in domain.ranges.items():
        low = "" if lower == -sp.oo else f"{latex(lower)} < "
        high = "" if upper == sp.oo else f" < {latex(upper)}"
        yield f"{low}{latex(symbol)}{high}" if low or high else rf"{latex(symbol)} \in \mathbb{{R}}"
    yield from (f"{latex(one)} > 0" for one in domain.conditions)


def claim_record(claim: Claim) -> dict[str, Any]:
    """What a claim says, as plain data."""
    given = (
        formula(rf"{latex(old)} \mapsto {latex(new)}", partial("{} ↦ {}".format, old, new)) for old, new in claim.given
    )
    return {
        "id": claim.id,
        "title": claim.title,
        "kind": type(claim.relation).__name__,
        "statement": formula(said(claim.relation), lambda: plainly(claim.relation)),
        "where": list(where(claim.domain)),
        "given": list(given),
        "steps": list(claim.steps),
        "source": claim.source,
    }


def remark_record(remark: Remark) -> dict[str, Any]:
    """A line of prose, or a named expression, as plain data."""
    if remark.expression is None:
        return {"text": remark.text, "expression": None}
    return {"text": remark.text, "expression": formula(latex(remark.expression), lambda: remark.expression)}


def derivation(theory: Any, lines: list[Any]) -> dict[str, Any]:
    """The lines of a notebook in their order, and the formulas that solvers evaluate."""
    written = [claim_record(line) if isinstance(line, Claim) else remark_record(line) for line in lines]
    formulas = [
        {
            "name": one.name,
            "case": one.case,
            "family": one.family,
            "doc": one.doc,
            "claim": one.claim,
            "source": one.source,
            "arguments": [argument.name for argument in one.arguments],
            "expression": formula(f"{named(one.name)} = {latex(one.expression)}", partial(str, one.expression)),
        }
        for one in theory.formulas
    ]
    return {"lines": written, "formulas": formulas}
