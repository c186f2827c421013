"""Measure, and write the tables of README.md and docs/checks.md between their markers (needs the extra `bench`).

derive --json result.json && derive check --mutants --json mutants.json
python examples/readme_tables.py result.json mutants.json
"""

from __future__ import annotations

import json
import sys
import time
from collections.abc import Callable
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np
from scipy.integrate import solve_bvp
from verdict_tables import errata_table, mutant_table, put, verdict_table

from derive.measure.agreement import TWIN_DIGITS, arguments
from derive.measure.reference import Reference, Rod
from derive.measure.rods import references, rods
from generated import (
    field_only_mpmath,
    field_only_numpy,
    force_only_mpmath,
    force_only_numpy,
    parallel_mpmath,
    parallel_numpy,
)

Known = list[tuple[Rod, list[Reference]]]
GUESSES = np.linspace(-3.0, 3.0, 9)  # tip angles from the clamp angle; what a user would try


def timed(call: Callable[[], Any], repeats: int = 3) -> float:
    """The best time of a few, in milliseconds."""
    times = []
    for _ in range(repeats):
        start = time.perf_counter()
        call()
        times.append(time.perf_counter() - start)
    return 1000 * min(times)


def worst_error(found: list[Any], known: list[Reference]) -> tuple[int, float]:
    """How many of the known tip angles are found to 1e-4, and the worst error among those."""
    errors = [min((abs(float(tip - r.values["tip_angle"])) for tip in found), default=1.0) for r in known]
    hits = [error for error in errors if error < 1e-4]
    return len(hits), max(hits, default=float("nan"))


def measure(name: str, solve: Callable[[Rod], list[Any]], known: Known) -> str:
    """One row: equilibria found, worst error of the tip angle, time for one rod."""
    hits, errors, times = 0, [], []
    for rod, answers in known:
        times.append(timed(lambda rod=rod: solve(rod)))
        count, error = worst_error(solve(rod), answers)
        hits += count
        errors.append(error)
    total = sum(len(answers) for _, answers in known)
    return f"| {name} | {hits} of {total} | {np.nanmax(errors):.0e} | {np.median(times):.2f} | {max(times):.2f} |"


def emitted(module: ModuleType) -> Callable[[Rod], list[Any]]:
    """Tip angles by an emitted module."""
    return lambda rod: [one.tip_angle for one in module.equilibria(**arguments(module.equilibria, rod))]


def collocation(rod: Rod) -> list[float]:
    """Tip angles by solve_bvp (s in [0, 1], analytic Jacobian, tol 1e-10) from nine arcs of constant curvature."""

    def right_side(_: np.ndarray, at: np.ndarray) -> np.ndarray:
        couple = rod.beta * np.sin(at[0]) + rod.eta / 2 * np.sin(2 * (at[0] - rod.field_angle))
        return np.array([at[1], couple * rod.length**2])

    def slope(_: np.ndarray, at: np.ndarray) -> np.ndarray:
        rate = rod.beta * np.cos(at[0]) + rod.eta * np.cos(2 * (at[0] - rod.field_angle))
        zero, one = np.zeros_like(rate), np.ones_like(rate)
        return np.array([[zero, one], [rate * rod.length**2, zero]])

    def ends(a: np.ndarray, b: np.ndarray) -> np.ndarray:
        return np.array([a[0] - rod.clamp_angle, b[1]])

    found: list[float] = []
    grid = np.linspace(0, 1, 41)
    for turn in GUESSES:
        guess = np.array([rod.clamp_angle + turn * grid, np.full_like(grid, turn)])
        result = solve_bvp(right_side, ends, grid, guess, fun_jac=slope, tol=1e-10, max_nodes=20000)
        if result.success:
            found.append(float(result.y[0, -1]))
    return found


def error_table() -> list[str]:
    """Rows for both load cases."""
    head = "| solver | equilibria found | worst error of θ(ℓ) | time, ms (median rod) | (slowest rod) |"
    lines = [head, "|---|---|---|---|---|"]
    cases = {
        "parallel": (parallel_numpy, parallel_mpmath),
        "field_only": (field_only_numpy, field_only_mpmath),
        "force_only": (force_only_numpy, force_only_mpmath),
    }
    for case, (double, exact) in cases.items():
        known: Known = [(rod, references(rod)) for rod in rods(case)]
        lines.append(measure(f"`{case}_numpy`", emitted(double), known))
        lines.append(measure(f"`{case}_mpmath`, {TWIN_DIGITS} digits", emitted(exact), known))
        lines.append(measure(f"SciPy `solve_bvp`, nine guesses, {case}", collocation, known))
    return lines


if __name__ == "__main__":
    result, mutants = (json.loads(Path(name).read_text(encoding="utf-8")) for name in sys.argv[1:3])
    put("verdicts", verdict_table(result))
    put("errata", errata_table(result))
    put("mutants", mutant_table(mutants))
    put("errors", error_table())
