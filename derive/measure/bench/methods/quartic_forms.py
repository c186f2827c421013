"""Forms that the emitter can print of one formula of the theory: expanded, Horner's, in factors; with and without CSE.

Set up: the formula is taken from the derivation of the load case `parallel`, rewritten by SymPy, and printed by the
emitter's own printer for arrays; the text is kept in the cache. The gap of ℘'s values is taken from g₂ and g₃ by the
cosine of a third of an angle, as the article's route has to, and from the roots of f, as emitted modules have it.
"""

from __future__ import annotations

import ast
from collections.abc import Callable, Iterator
from functools import cache, partial
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np

from derive.emit.kernels.weierstrass import half_period_values
from derive.measure.bench.cells import OURS, VARIANT, Cell, Method, Problem
from derive.measure.bench.families import Plan
from derive.measure.bench.known import kept
from derive.measure.loading import load

ROOT = Path(__file__).resolve().parents[3]
SOURCES = (Path(__file__), ROOT / "theory", ROOT / "emit" / "printer.py")
FORMS = ("factors", "expanded", "horner")
SAFE, LOSING = 1e-14, 1e3  # what is in factors keeps its digits; near a root the others lose all of theirs


def forms(plan: Plan) -> ModuleType:
    """A module with f in all its forms, the gap, and the article's g₂ and g₃."""
    return loaded(kept(plan.cache, "forms of the quartic", "", text, SOURCES))


@cache
def loaded(text: str) -> ModuleType:
    """The module of a text."""
    return load(text, "forms")


def text() -> str:
    """The text of that module, from the derivation."""
    from sympy import Symbol, diff, expand, factor, horner

    from derive.emit.formulas import formulas_of
    from derive.emit.printer import formula_function
    from derive.theory.chain import derive_all
    from derive.theory.claims import Formula
    from derive.theory.load_case import xi_tip
    from derive.theory.symbols import beta, eta, xi

    theory = derive_all()
    case, minus = theory.cases["parallel"], Symbol("minus")
    f = case.f.subs(case.constant, case.tip_constant)
    rewritten = {"factors": factor(f), "expanded": expand(f), "horner": horner(expand(f), xi)}
    arguments = (beta, eta, xi_tip, xi)
    functions = []
    for name in FORMS:
        for suffix, common in (("", False), ("_cse", True)):
            formula = Formula(name + suffix, arguments, rewritten[name], case.name, "f(ξ)")
            functions.append(formula_function(formula, common=common, elementwise=True))
    # ℘ − c = b/(ξ − ξ(ℓ)) at the roots −1 and ξ_o of f.
    strength = diff(f, xi).subs(xi, xi_tip) / 4
    apart = factor((strength / (case.other_root - xi_tip) - strength / (-1 - xi_tip)).subs(xi_tip, 1 - minus))
    functions.append(formula_function(Formula("gap", (beta, eta, minus), apart, case.name, "gap"), elementwise=True))
    article = formulas_of(theory, "parallel")
    for name in ("article_g2", "article_g3"):
        functions.append(formula_function(article[name], elementwise=True))
    module = ast.fix_missing_locations(ast.Module([*functions], []))
    return ast.unparse(module) + "\n"


def cells(name: str, limit: float, problem: Problem, plan: Plan) -> Iterator[Cell]:
    """f in one form, plain and with CSE."""
    if problem.id == "V-quartic":
        yield Cell("plain", evaluated(plan, name, problem), limit)
        yield Cell("CSE", evaluated(plan, f"{name}_cse", problem), limit)


def gap_cells(problem: Problem, plan: Plan) -> Iterator[Cell]:
    """The gap, as modules have it."""
    if problem.id == "V-gap":
        yield Cell("array", evaluated(plan, "gap", problem, abs), SAFE)


def invariant_cells(problem: Problem, plan: Plan) -> Iterator[Cell]:
    """The gap by the article's route, point by point."""
    if problem.id == "V-gap":
        yield Cell("point by point", partial(by_invariants, plan, problem), LOSING)


def evaluated(plan: Plan, name: str, problem: Problem, then: Callable[[Any], Any] = np.asarray) -> Any:
    """The preparation of a form on all points."""

    def prepare() -> Callable[[], Any]:
        function = getattr(forms(plan), name)
        return lambda: then(function(*problem.inputs))

    return prepare


def by_invariants(plan: Plan, problem: Problem) -> Callable[[], Any]:
    """The gap e₂ − e₃ or e₁ − e₂ that closes; nan where g₂, g₃ are no three real values to rounding."""
    beta, eta, minus = problem.inputs
    module = forms(plan)

    def one(rest: float) -> float:
        tip = 1 - rest
        constant = eta * tip * tip + 2 * beta * tip
        try:
            return min(
                half_period_values(module.article_g2(beta, eta, constant), module.article_g3(beta, eta, constant))[1:]
            )
        except ValueError:
            return float("nan")

    return lambda: [one(rest) for rest in minus.tolist()]


METHODS = (
    Method("f in factors", OURS, partial(cells, "factors", SAFE)),
    Method("f expanded", VARIANT, partial(cells, "expanded", LOSING)),
    Method("f by Horner's rule", VARIANT, partial(cells, "horner", LOSING)),
    Method("gap by roots", OURS, gap_cells),
    Method("gap by g₂, g₃", VARIANT, invariant_cells),
)
