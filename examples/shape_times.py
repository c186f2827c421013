"""How long a shape at a million points takes, beside the Jacobi functions of SciPy (needs the extra `bench`).

python examples/shape_times.py

Times are of the processor, in nanoseconds a point, the best of a few. Errors are against the closed form, in units in
the last place of a radian, and of the length for y and z; long rods follow ℓ − s no better than ℓ is known.
"""

from __future__ import annotations

import time
from collections.abc import Callable
from functools import partial
from math import pi
from typing import Any

import numpy as np
from scipy.special import ellipj

from derive.emit.kernels.dense import shape_at
from derive.emit.kernels.equilibria import all_equilibria
from derive.emit.kernels.shapes import angle_and_position

POINTS = 1_000_000
RODS = {
    "ℓ√(β+η) = 2.4": (0.00035, 0.00052, 80.0, 3 * pi / 4, 0.0, None),
    "ℓ√(β+η) = 10, oblique": (0.3, 0.7, 10.0, 2.0, 0.4, 4),
    "ℓ√(β+η) = 40, oblique": (0.3, 0.7, 40.0, 2.0, 0.4, 6),
    "ℓ√(β+η) = 1000": (0.0, 1.0, 1000.0, 3 * pi / 4, 0.0, 8),
}


def nanoseconds(call: Callable[[], Any], repeats: int = 5) -> float:
    """The best time of a few, a point."""
    times = []
    for _ in range(repeats):
        start = time.process_time()
        call()
        times.append(time.process_time() - start)
    return min(times) / POINTS * 1e9


def errors(equilibrium: Any, s: Any) -> list[float]:
    """The largest differences from the closed form at a few of the points."""
    some = np.random.default_rng(1).integers(0, len(s), 200)
    wanted = np.array([angle_and_position(equilibrium, place) for place in s[some].tolist()]).T
    units = 2.0**-52 * np.array([1.0, np.ldexp(1.0, equilibrium.rod.scale), np.max(s), np.max(s)])
    found = shape_at(equilibrium, s)
    return [float(np.max(np.abs(a[some] - b)) / unit) for a, b, unit in zip(found, wanted, units, strict=True)]


def main() -> None:
    """Print a row for each rod and each order of points."""
    arguments = np.linspace(0.0, 3.0, POINTS)
    print(f"SciPy ellipj: {nanoseconds(lambda: ellipj(arguments, 0.7)):.0f} ns a point")
    print("rod, points: θ and θ′; with y and z; errors of θ, θ′, y, z")
    for name, rod in RODS.items():
        equilibrium = [one for one in all_equilibria(*rod) if one.swing is not None][-1]
        ordered = np.linspace(0.0, rod[2], POINTS)
        for order, s in (("in order", ordered), ("shuffled", np.random.default_rng(2).permutation(ordered))):
            alone = nanoseconds(partial(shape_at, equilibrium, s, position=False))
            both = nanoseconds(partial(shape_at, equilibrium, s))
            seen = ", ".join(f"{error:.1f}" for error in errors(equilibrium, s))
            print(f"{name}, {order}: {alone:.1f}; {both:.1f}; {seen}")


if __name__ == "__main__":
    main()
