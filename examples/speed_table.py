"""The tables of docs/measure.md with the speed of each emitted NumPy module, and of shapes beside SciPy's ellipj.

python examples/speed_table.py

The rods are those of the article's second diagram: 8 forces up to 0.0007, 1,000 fields each up to 0.001 (fields or
forces alone: as many), length 80, clamped at 3π/4; in `oblique` the field is at 0.4 from the force. The long ones are
five times as long. Nothing else should run on the machine. Needs SciPy.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from importlib import import_module
from inspect import signature
from math import pi
from typing import Any

import numpy as np
from scipy.special import ellipj
from verdict_tables import put

from derive.measure.bench.timing import Times, alone, interleaved
from derive.resources import shipped_scenes

BETA, ETA = np.meshgrid(np.linspace(0, 7e-4, 8), np.linspace(0, 1e-3, 1000), indexing="ij")
GIVEN = {"beta": BETA, "eta": ETA, "length": np.full(1, 80.0), "clamp_angle": 3 * pi / 4, "field_angle": 0.4}
ONE = {"beta": 0.00035, "eta": 0.00052, "length": 80.0, "clamp_angle": 3 * pi / 4, "field_angle": 0.4}
ALONE = {"force_only": {"beta": np.linspace(0, 1.7e-3, 8000)}, "field_only": {"eta": np.linspace(0, 1e-3, 8000)}}
LONGER, MANY, BUDGET = 5, 10, 3.0  # times the length; times fewer of such rods; seconds for each time
POINTS = np.linspace(0, 80, 10**6)
SPEEDS = (
    "| module | equilibria of 8,000 rods | a second | from … to | one rod, equilibria | ms | of long rods, a second |"
)
SHAPES = "| at 10⁶ points | ms | ellipj, ms | ellipj over ours |"


def parameters(module: Any) -> list[str]:
    """What a module's sweep takes, in order."""
    return [name for name in signature(module.sweep).parameters if name in GIVEN]


def timed(call: Callable[[], Any]) -> tuple[Any, Times]:
    """What a call gives, and its times."""
    found, times = alone(call, BUDGET)
    return found, Times.of(times)


def speeds(scene: str) -> str:
    """A row of the first table."""
    module = import_module(f"generated.{scene}_numpy")
    names = parameters(module)
    rods = [(GIVEN | ALONE.get(scene, {}))[name] for name in names]
    found, times = timed(partial(module.sweep, *rods))
    number = len(found.case)
    rates = [f"{number / seconds:,.0f}" for seconds in (times.median, times.high, times.low)]
    row = f"| {scene} | {number:,} | {rates[0]} | {rates[1]} … {rates[2]} |"
    few, time = "–", "–"
    if hasattr(module, "equilibria"):
        one, single = timed(partial(module.equilibria, *(ONE[name] for name in names)))
        few, time = str(len(one)), f"{1e3 * single.median:.2f}"
    rate = "–"
    if "length" in names:
        thin = [values[..., ::MANY] if np.size(values) > 1 else values for values in rods]
        thin[names.index("length")] = LONGER * GIVEN["length"]
        more, long = timed(partial(module.sweep, *thin))
        rate = f"{len(more.case) / long.median:,.0f}"
    return f"{row} {few} | {time} | {rate} |"


def shapes() -> list[str]:
    """The rows of the second table, ellipj in turn with ours."""
    module = import_module("generated.parallel_numpy")
    one = module.equilibria(*(ONE[name] for name in parameters(module)))[0]
    rows = []
    for what, position in (("θ(s)", False), ("θ(s), θ′(s), y(s), z(s)", True)):
        _, ours, others = interleaved(
            partial(module.shape, one, POINTS, position=position), partial(ellipj, 3 / 80 * POINTS, 0.7), BUDGET
        )
        here, there = Times.of(ours).median, Times.of(others).median
        rows.append(f"| {what} | {1e3 * here:.1f} | {1e3 * there:.0f} | {there / here:.1f} |")
    return rows


def main() -> None:
    """Measure, and write the tables."""
    put("speeds", [SPEEDS, "|---|" + "---:|" * (SPEEDS.count("|") - 2), *(speeds(scene) for scene in shipped_scenes())])
    put("shapes", [SHAPES, "|---|" + "---:|" * (SHAPES.count("|") - 2), *shapes()])


if __name__ == "__main__":
    main()
