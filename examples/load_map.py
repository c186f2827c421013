"""How many equilibria a rod has, over the plane of force and field: many rods in one call, arrays in and out.

python examples/load_map.py [PICTURE.png]

Rows are fields, columns are forces. PICTURE (svg, png or pdf; needs the extra `pictures`): the place of the lowest
stable tip over the same plane.
"""

from __future__ import annotations

import sys
from math import pi
from pathlib import Path
from typing import Any

import numpy as np

from generated.parallel_numpy import Sweep, sweep

LENGTH, CLAMP = 80.0, 3 * pi / 4
FORCES, FIELDS = np.linspace(0.0, 0.0012, 49), np.linspace(0.0, 0.003, 25)


def lowest(found: Sweep, number: int) -> Any:
    """The least y of a stable tip of each rod."""
    least, stable = np.full(number, np.inf), found.index == 0
    np.minimum.at(least, found.case[stable], found.y[stable])
    return least


def draw(places: Any, file: Path) -> None:
    """The picture."""
    import matplotlib

    matplotlib.use("agg")
    import matplotlib.pyplot as plt

    figure, axes = plt.subplots(figsize=(6.4, 4.2), layout="constrained")
    mesh = axes.pcolormesh(FORCES, FIELDS, places, cmap="viridis", shading="nearest")
    figure.colorbar(mesh, label="lowest stable y of the tip")
    axes.set_xlabel("β")
    axes.set_ylabel("η")
    figure.savefig(file)


def main(file: Path | None = None) -> None:
    """Print the map of numbers."""
    beta, eta = np.meshgrid(FORCES, FIELDS)
    found = sweep(beta, eta, LENGTH, CLAMP)
    numbers = np.bincount(found.case, minlength=beta.size).reshape(beta.shape)
    for row in numbers[::-1]:
        print("".join(map(str, row)))
    print(f"{len(found.case)} equilibria of {beta.size} rods")
    if file:
        draw(lowest(found, beta.size).reshape(beta.shape), file)


if __name__ == "__main__":
    main(Path(sys.argv[1]) if len(sys.argv) > 1 else None)
