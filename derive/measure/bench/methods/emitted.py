"""What this project emits: the NumPy modules and their mpmath twins, through their public functions alone.

Set up: as imported; no guess is given. For one equilibrium all stable ones are found, and the meant one is picked. A
module with nothing folded, the one for any field angle and, in the diagram, one with the rod folded are compared.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from functools import partial
from importlib import import_module
from types import ModuleType
from typing import Any

import numpy as np

from derive.measure.agreement import arguments
from derive.measure.bench.cells import OURS, Call, Cell, Method, Problem
from derive.measure.bench.families import Plan
from derive.measure.bench.tasks.fold import RANGE
from derive.measure.reference import Rod
from derive.measure.rods import PAPER

DOUBLES = 1e-13  # the limit of errors, some hundred roundings: wrong signs and terms are off by more
DIGITS = (15, 30, 50, 100, 200)
MANY = 30  # digits up to which the twin is asked for all equilibria of all rods
LOST = 1e3  # roundings of the twin's that are no fault


def generated(name: str) -> ModuleType:
    """A committed module."""
    return import_module(f"generated.{name}")


def found_by(module: ModuleType, rod: Rod, **options: Any) -> list[Any]:
    """All equilibria by an emitted module; a folded constant is no argument."""
    given = {name: value for name, value in arguments(module.equilibria, rod).items() if name != "dps"}
    return list(module.equilibria(**given, **options))


def tips(found: Sequence[Any]) -> list[tuple[Any, Any, Any]]:
    """What is judged."""
    return [(one.tip_angle, one.y, one.z) for one in found]


def nearest(found: Sequence[Any], tip: float) -> Any:
    """The one that was meant, of equilibria or folds."""
    return min(found, key=lambda one: abs(one.tip_angle - tip))


def ready(call: Call) -> Callable[[], Call]:
    """The preparation of what needs none."""
    return lambda: call


def one(problem: Problem, module: ModuleType, options: dict[str, Any]) -> Callable[[], Call]:
    """T1."""
    return ready(lambda: [tips([nearest(found_by(module, rod, **options), tip)]) for rod, tip in problem.inputs])


def every(problem: Problem, module: ModuleType, options: dict[str, Any]) -> Callable[[], Call]:
    """T2."""
    return ready(lambda: [tips(found_by(module, rod, **options)) for rod in problem.inputs[1]])


def shape(problem: Problem, module: ModuleType, options: dict[str, Any]) -> Callable[[], Call]:
    """T3, solving included."""
    rod, tip, s, _ = problem.inputs
    return ready(lambda: module.shape(nearest(found_by(module, rod, max_index=0), tip), s, **options))


def columns(problem: Problem, found: Any) -> list[Any]:
    """θ, y and z at the points that have references, None for what was not asked for."""
    sample, parts = problem.inputs[3], (found.theta, found.y, found.z)
    return [None if part is None else np.asarray(part)[sample].tolist() for part in parts]


def rows(problem: Problem, found: Any) -> list[Any]:
    """Of a sweep, the equilibria of the rods that have references."""
    case = np.asarray(found.case)
    picked = [np.flatnonzero(case == number) for number in problem.inputs.sample]
    return [[(found.tip_angle[k], found.y[k], found.z[k]) for k in here] for here in picked]


def folds(problem: Problem, module: ModuleType, options: dict[str, Any], most: int | None = None) -> Callable[[], Call]:
    """T6: all folds in a range of η."""
    loads = [(rod.beta, rod.length, rod.clamp_angle) for rod, _ in problem.inputs[:most]]
    return ready(lambda: [module.folds(*load, eta=RANGE, **options) for load in loads])


def meant(problem: Problem, found: Sequence[Any]) -> list[Any]:
    """The folds near the guesses."""
    picked = [nearest(row, tip) for row, (_, (_, tip)) in zip(found, problem.inputs, strict=False)]
    return [(fold.eta, fold.tip_angle) for fold in picked] + [None] * (len(problem.inputs) - len(picked))


def numpy_cells(problem: Problem, plan: Plan) -> Iterator[Cell]:
    """The NumPy modules."""
    exact = partial(Cell, limit=DOUBLES, all_found=True)
    parallel, oblique = generated("parallel_numpy"), generated("oblique_numpy")
    match problem.task:
        case "T1":
            yield exact("parallel, stable ones", one(problem, parallel, {"max_index": 0}))
            yield exact("parallel, all", one(problem, parallel, {}))
            yield exact("oblique, stable ones", one(problem, oblique, {"max_index": 0}))
        case "T2":
            yield exact(problem.inputs[0], every(problem, generated(f"{problem.inputs[0]}_numpy"), {}))
            if problem.inputs[0] == "parallel":
                yield exact("oblique", every(problem, oblique, {}))
        case "T3":
            judged = partial(columns, problem)
            yield exact("θ, y, z", shape(problem, parallel, {}), answers=judged)
            yield exact("θ alone", shape(problem, parallel, {"position": False}), answers=judged, whole=False)
        case "T4":
            given, judged = problem.inputs, partial(rows, problem)
            fixed = (PAPER.length, PAPER.clamp_angle)
            folded = partial(generated("bifurcation_numpy").sweep, given.beta, given.eta)
            yield exact("bifurcation (ℓ, clamp folded)", ready(folded), answers=judged)
            plain = partial(parallel.sweep, given.beta, given.eta, *fixed)
            yield exact("parallel (nothing folded)", ready(plain), answers=judged)
        case "T6":
            yield exact("all in a range", folds(problem, parallel, {}), answers=partial(meant, problem))


def mpmath_cells(problem: Problem, plan: Plan) -> Iterator[Cell]:
    """The twins; each setting is a number of digits."""
    twin = generated("parallel_mpmath")
    for digits in DIGITS[:2] if plan.quick else DIGITS:
        exact = partial(Cell, f"{digits} digits", limit=LOST * 10.0**-digits, all_found=True)
        options = {"dps": digits}
        if problem.task == "T1":
            yield exact(one(problem, twin, options | {"max_index": 0}))
        elif problem.task == "T2" and digits <= MANY:
            yield exact(every(problem, generated(f"{problem.inputs[0]}_mpmath"), options))
        elif problem.task == "T6" and digits <= MANY and not plan.quick:  # half a minute for one
            call, judged = folds(problem, twin, options, most=1), partial(meant, problem)
            yield Cell(f"{digits} digits", call, LOST * 10.0**-digits, judged, share=1 / len(problem.inputs))


METHODS = (Method("emitted, NumPy", OURS, numpy_cells), Method("emitted, mpmath", OURS, mpmath_cells))
