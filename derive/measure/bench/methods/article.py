"""The article's formulas as printed, repaired where they are refuted: ζ, σ and complex logarithms.

Set up: the scene output `literal`, which no shipped scene asks for, emitted now. The formulas need γ and the tip angle,
which the article leaves to a root finder; they are given ours, so only a rod's shape and tip position are theirs.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from functools import partial
from types import ModuleType
from typing import Any

from derive.measure.bench.cells import ARTICLE, Call, Cell, Method, Problem
from derive.measure.bench.families import Plan
from derive.measure.bench.methods.emitted import columns, found_by, nearest

DOUBLES = 1e-5  # inverse functions at the end of their domain halve the digits
EXACT, EXACT_DIGITS = 1e-25, 50  # and a logarithm of a quotient near 1 loses some more


def given_tip(problem: Problem, emitted: Callable[[], ModuleType], options: Mapping[str, Any]) -> Callable[[], Call]:
    """T1: y and z of the tip, γ and tip angle known."""

    def prepare() -> Call:
        module = emitted()
        known = [(nearest(found_by(module, rod, max_index=0, **options), tip), rod) for rod, tip in problem.inputs]

        def call() -> list[Any]:
            ends = [(one.tip_angle, module.literal(one, rod.length, **options)) for one, rod in known]
            return [[(tip, end.y, end.z)] for tip, end in ends]

        return call

    return prepare


def shape(problem: Problem, emitted: Callable[[], ModuleType]) -> Callable[[], Call]:
    """T3, with our solution of the rod."""
    rod, tip, s, _ = problem.inputs

    def prepare() -> Call:
        module = emitted()
        return lambda: module.literal(nearest(found_by(module, rod, max_index=0), tip), s)

    return prepare


def numpy_cells(problem: Problem, plan: Plan) -> Iterator[Cell]:
    """On arrays."""
    if plan.emitted and problem.task == "T1":
        call = given_tip(problem, partial(plan.emitted, "literal_numpy"), {})
        yield Cell("γ and tip given", call, DOUBLES, whole=False)
    if plan.emitted and problem.task == "T3":
        call = shape(problem, partial(plan.emitted, "literal_numpy"))
        yield Cell("our tip", call, DOUBLES, partial(columns, problem))


def mpmath_cells(problem: Problem, plan: Plan) -> Iterator[Cell]:
    """At many digits."""
    if plan.emitted and problem.task == "T1" and not plan.quick:
        call = given_tip(problem, partial(plan.emitted, "literal_mpmath"), {"dps": EXACT_DIGITS})
        yield Cell(f"{EXACT_DIGITS} digits", call, EXACT, whole=False)


METHODS = (Method("article, NumPy", ARTICLE, numpy_cells), Method("article, mpmath", ARTICLE, mpmath_cells))
