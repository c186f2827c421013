"""T5 by others: mpmath at many digits, `ellipj`, python-flint, and packages from PyPI."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import partial
from importlib.util import find_spec
from types import ModuleType
from typing import Any

import numpy as np

from derive.emit.kernels import weierstrass
from derive.measure.work.cells import OURS, PEER, Cell
from derive.measure.work.peers import arb, outside
from derive.measure.work.problems import Lattice, Problem

DIGITS = (15, 30, 50, 100, 200)
# Module, functions by kind, and whether it takes half-periods (point by point) or half-period values (arrays).
PACKAGES: dict[str, tuple[str, Mapping[str, str], str]] = {
    "pyweierstrass": ("pyweierstrass.weierstrass", {"p": "wp", "zeta": "wzeta", "sigma": "wsigma"}, "half_periods"),
    "elliptic-functions": (
        "elliptic",
        {"p": "weierstrassP", "zeta": "weierstrassZeta", "sigma": "weierstrassSigma"},
        "values",
    ),
}
FEW = 100  # points for what goes one by one: the time for each is what counts


def functions(problem: Problem, modules: Mapping[str, ModuleType], quick: bool) -> Iterator[Cell]:
    """The q-series that the article's formulas are evaluated with, first; then all others."""
    given: Lattice = problem.inputs
    function = getattr(weierstrass, {"p": "wp", "zeta": "wzeta", "sigma": "wsigma"}[given.kind])
    series = partial(function, np.array(given.u), given.g2, given.g3)
    yield Cell(problem, "q-series, NumPy", "array", OURS, lambda: series, lambda found: found.real.tolist())
    yield from others(problem, modules, quick)


def others(problem: Problem, modules: Mapping[str, ModuleType], quick: bool) -> Iterator[Cell]:
    """The cells of a function, after the base."""
    given: Lattice = problem.inputs
    few = min(FEW, len(given.u))
    some = few_points(given, few)
    digits = DIGITS[:2] if quick else DIGITS
    name = {"p": "wp", "zeta": "wzeta"}.get(given.kind)
    if "literal_mpmath" in modules and name:  # the article's formulas need ln σ, not σ
        for d in digits:
            series = partial(twin, modules["literal_mpmath"], name, given, some, d)
            yield Cell(problem, "q-series, mpmath", f"{d} digits", OURS, series, partial(spread, given, some), few)
    if find_spec("scipy") and given.kind == "p":
        yield Cell(problem, "SciPy ellipj", "array", PEER, partial(jacobi, given), lambda found: found.tolist())
    if find_spec("flint"):
        for d in digits:
            exact = [given.u[k] for k in some]
            call = partial(partial, arb.values, given.kind, exact, given.exact, d)
            yield Cell(problem, "FLINT (Arb)", f"{d} digits", PEER, call, partial(balls, given, some, d), few)
    for package, (module, functions, lattice) in PACKAGES.items():
        if outside.installed(module):
            each = lattice == "half_periods"
            points = [given.u[k] for k in some] if each else given.u
            start = partial(outside.Outside, module, functions[given.kind], getattr(given, lattice), points)
            answers = partial(spread, given, some) if each else list
            yield Cell(problem, package, "doubles", PEER, start, answers, few if each else 0)


def few_points(given: Lattice, few: int) -> list[int]:
    """Some of the points, those with references among them."""
    step = max(1, len(given.u) // 24)
    first = list(range(0, len(given.u), step))
    rest = [k for k in range(len(given.u)) if k % step]
    return sorted([*first, *rest[: max(0, few - len(first))]])


def spread(given: Lattice, some: Sequence[int], found: Sequence[Any]) -> list[Any]:
    """Values at some of the points as a list for all."""
    answers: list[Any] = [None] * len(given.u)
    for k, value in zip(some, found, strict=True):
        answers[k] = value
    return answers


def balls(given: Lattice, some: Sequence[int], digits: int, found: Sequence[Any]) -> list[Any]:
    """Midpoints of balls as numbers of mpmath."""
    from mpmath import mp

    with mp.workdps(digits + 10):
        return spread(given, some, arb.as_numbers(found, digits))


def twin(module: ModuleType, name: str, given: Lattice, some: Sequence[int], digits: int) -> Callable[[], Any]:
    """The emitted twin's function at some points."""
    from mpmath import mp, mpf

    points = np.array([mpf(given.u[k]) for k in some], dtype=object)

    def call() -> list[Any]:
        with mp.workdps(digits):
            found = getattr(module, name)(points, mpf(given.g2), mpf(given.g3))
            return [mp.re(value) for value in found]

    return call


def jacobi(given: Lattice) -> Callable[[], Any]:
    """℘ by sn."""
    from derive.measure.work.peers import special

    points = np.array(given.u)
    return lambda: special.wp(points, given.values)
