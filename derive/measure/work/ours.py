"""What this project makes, as methods: emitted modules, their twins, the article's own formulas, variants."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import partial
from importlib import import_module
from importlib.util import find_spec
from types import ModuleType
from typing import Any

import numpy as np

from derive.measure.agreement import arguments
from derive.measure.reference import Rod
from derive.measure.rods import PAPER
from derive.measure.work import arithmetic
from derive.measure.work.cells import ARTICLE, OURS, PEER, Cell
from derive.measure.work.problems import FOLD_RANGE, Diagram, Problem

NUMPY, TWIN, LITERAL, LITERAL_TWIN = "emitted, NumPy", "emitted, mpmath", "article's formulas", "article's, mpmath"
ARRAYS = "kernels on arrays"
Modules = Mapping[str, ModuleType]  # "literal_numpy" and "literal_mpmath", emitted for the purpose


def own_cells(problem: Problem, modules: Modules, *, quick: bool) -> Iterator[Cell]:
    """All that is ours on a problem; the first one is its base."""
    makers = {"T1": one, "T2": every, "T3": shapes, "T4": diagram, "T5": arithmetic.functions, "T6": folds}
    for number, cell in enumerate(makers[problem.task](problem, modules, quick)):
        yield Cell(**{**vars(cell), "base": number == 0})


def digits_of(quick: bool, most: int) -> tuple[int, ...]:
    """At which the twins are run."""
    return (15, 30) if quick else tuple(d for d in (15, 30, 50, 100, 200) if d <= most)


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
    """The equilibrium that was meant."""
    return min(found, key=lambda one: abs(one.tip_angle - tip))


def as_it_is(call: Callable[[], Any]) -> Callable[[], Any]:
    """What needs no preparation."""
    return call


def one(problem: Problem, modules: Modules, quick: bool) -> Iterator[Cell]:
    """T1. Ours needs no guess, and finds the other stable ones (or all) besides; the meant one is picked."""

    def call(module: ModuleType, **options: Any) -> Callable[[], Any]:
        return lambda: [tips([nearest(found_by(module, rod, **options), tip)]) for rod, tip in problem.inputs]

    for name, module, options in (
        ("stable ones", "parallel_numpy", {"max_index": 0}),
        ("all", "parallel_numpy", {}),
        ("any field angle", "oblique_numpy", {"max_index": 0}),
    ):
        yield Cell(problem, NUMPY, name, OURS, partial(call, generated(module), **options))
    for digits in digits_of(quick, 200):
        options = {"max_index": 0, "dps": digits}
        yield Cell(problem, TWIN, f"{digits} digits", OURS, partial(call, generated("parallel_mpmath"), **options))
    for key, method, more in (("literal_numpy", LITERAL, [{}]), ("literal_mpmath", LITERAL_TWIN, [{"dps": 50}])):
        for options in more if key in modules else ():
            setting = f"{options['dps']} digits" if options else "γ and tip given"
            yield Cell(
                problem, method, setting, ARTICLE, partial(literal_tips, problem, modules[key], options), whole=False
            )


def literal_tips(problem: Problem, module: ModuleType, options: Mapping[str, Any]) -> Callable[[], Any]:
    """The tip by the article's formulas, given γ and the tip angle of the equilibrium: only y and z are theirs."""
    known = [nearest(found_by(module, rod, max_index=0, **options), tip) for rod, tip in problem.inputs]

    def call() -> list[Any]:
        rows = []
        for (rod, _), equilibrium in zip(problem.inputs, known, strict=True):
            end = module.literal(equilibrium, rod.length, **options)
            rows.append([(equilibrium.tip_angle, end.y, end.z)])
        return rows

    return call


def every(problem: Problem, modules: Modules, quick: bool) -> Iterator[Cell]:
    """T2."""

    def call(module: ModuleType, **options: Any) -> Callable[[], Any]:
        return lambda: [tips(found_by(module, rod, **options)) for rod in problem.inputs]

    yield Cell(problem, NUMPY, "all", OURS, partial(call, generated("parallel_numpy")))
    yield Cell(problem, NUMPY, "any field angle", OURS, partial(call, generated("oblique_numpy")))
    for digits in digits_of(quick, 30):
        yield Cell(problem, TWIN, f"{digits} digits", OURS, partial(call, generated("parallel_mpmath"), dps=digits))


def shapes(problem: Problem, modules: Modules, quick: bool) -> Iterator[Cell]:
    """T3: solving, and θ, y and z at all points."""
    rod, tip, s, sample = problem.inputs

    def call(module: ModuleType, method: str) -> Callable[[], Any]:
        return lambda: getattr(module, method)(nearest(found_by(module, rod, max_index=0), tip), s)

    def columns(found: Any) -> list[Any]:
        return [np.asarray(getattr(found, name))[sample].tolist() for name in ("theta", "y", "z")]

    def angles(found: Any) -> list[Any]:
        return [found.theta[sample].tolist(), None, None]

    numpy = generated("parallel_numpy")
    yield Cell(problem, NUMPY, "θ, y, z", OURS, partial(call, numpy, "shape"), columns)

    def alone() -> Any:
        return numpy.shape(nearest(found_by(numpy, rod, max_index=0), tip), s, position=False)

    yield Cell(problem, NUMPY, "θ alone", OURS, lambda: alone, angles, whole=False)
    if "literal_numpy" in modules:
        yield Cell(problem, LITERAL, "θ, y, z", ARTICLE, partial(call, modules["literal_numpy"], "literal"), columns)
    if find_spec("scipy"):
        yield Cell(
            problem, "SciPy ellipj alone", "no rod", PEER, partial(jacobi, len(s)), lambda _: [None] * 3, whole=False
        )


def jacobi(number: int) -> Callable[[], Any]:
    """Jacobi's functions at as many points: what nothing that is built on them can be faster than."""
    from scipy.special import ellipj

    arguments = np.linspace(0.0, 3.0, number)
    return lambda: ellipj(arguments, 0.7)


def diagram(problem: Problem, modules: Modules, quick: bool) -> Iterator[Cell]:
    """T4."""
    from derive.emit.kernels.blocks import sweep_arrays

    given: Diagram = problem.inputs
    length, clamp = (np.full(len(given.beta), value) for value in (PAPER.length, PAPER.clamp_angle))
    arrays = (given.beta, given.eta, length, clamp, np.zeros_like(length), None)

    def rows(numbers: Sequence[int], found: Any) -> list[Any]:
        parts = []
        for number in given.sample:
            here = np.flatnonzero(np.asarray(found.case) == numbers.index(number))
            parts.append([(found.tip_angle[k], found.y[k], found.z[k]) for k in here])
        return parts

    whole, some = range(len(given.beta)), list(given.sample if quick else given.some)
    call = partial(sweep_arrays, *arrays)
    number = len(given.beta)
    yield Cell(problem, ARRAYS, f"all {number:,}", OURS, lambda: call, partial(rows, whole), number)
    beta, eta = given.beta[some], given.eta[some]
    for name, setting in (("bifurcation_numpy", "ℓ, clamp folded"), ("parallel_numpy", "nothing folded")):
        sweep = generated(name).sweep
        fixed = (PAPER.length, PAPER.clamp_angle) if name.startswith("parallel") else ()
        swept = partial(sweep, beta, eta, *fixed)
        yield Cell(problem, NUMPY, setting, OURS, partial(as_it_is, swept), partial(rows, some), len(some))


def folds(problem: Problem, modules: Modules, quick: bool) -> Iterator[Cell]:
    """T6: ours finds all folds in the range; the one near the guess is judged."""

    def call(module: ModuleType, options: Mapping[str, Any]) -> Callable[[], Any]:
        return lambda: [
            module.folds(rod.beta, rod.length, rod.clamp_angle, eta=FOLD_RANGE, **options) for rod, _ in problem.inputs
        ]

    def answers(found: Sequence[Any]) -> list[Any]:
        pairs = zip(found, problem.inputs, strict=True)
        meant = [nearest(row, tip) for row, (_, (_, tip)) in pairs]
        return [(fold.eta, fold.tip_angle) for fold in meant]

    yield Cell(problem, NUMPY, "all in a range", OURS, partial(call, generated("parallel_numpy"), {}), answers)
    for digits in () if quick else (15, 30):  # half a minute for a fold
        twin = partial(call, generated("parallel_mpmath"), {"dps": digits})
        yield Cell(problem, TWIN, f"{digits} digits", OURS, twin, answers)
