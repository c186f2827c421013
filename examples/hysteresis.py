"""A field turns slowly to and fro over a clamped rod: where the tip jumps, and how much energy is lost.

python examples/hysteresis.py [FILE.csv]

The rod stays in the stable equilibrium in which it is as long as that exists; when it vanishes, the rod falls to one of
lower energy at the same field, and what it falls by is lost. FILE.csv: the loop, a row for each angle of the field.
"""

from __future__ import annotations

import sys
from collections.abc import Iterable
from math import degrees, pi
from pathlib import Path

import numpy as np

from generated.oblique_numpy import Equilibrium, equilibria

ROD = {"beta": 0.0002, "eta": 0.002, "length": 80.0, "clamp_angle": 3 * pi / 4}
ANGLES = np.linspace(-pi / 6, 2 * pi / 3, 151)  # of the field; the rod has one stable equilibrium at either end
FARTHEST = 0.5  # radians by which a tip may move from one angle of the field to the next without a jump


def followed(angles: Iterable[float], start: Equilibrium) -> list[Equilibrium]:
    """What a rod does that begins in an equilibrium: at each angle the stable one whose tip is nearest to the last."""
    path = [start]
    for angle in angles:
        stable = equilibria(**ROD, field_angle=angle, max_index=0)
        path.append(min(stable, key=lambda one: abs(one.tip_angle - path[-1].tip_angle)))
    return path[1:]


def jumps(angles: Iterable[float], path: list[Equilibrium]) -> list[tuple[float, float]]:
    """The angle of the field at each jump, and the energy over EI that is lost there."""
    moves = zip(angles, path, path[1:], strict=False)
    return [(angle, a.energy - b.energy) for angle, a, b in moves if abs(a.tip_angle - b.tip_angle) > FARTHEST]


def main(file: Path | None = None) -> None:
    """Print the jumps of one cycle."""
    first = min(equilibria(**ROD, field_angle=ANGLES[0], max_index=0), key=lambda one: one.energy)
    there = followed(ANGLES, first)
    back = followed(ANGLES[::-1], there[-1])
    print(f"it begins at θ(ℓ) = {there[0].tip_angle:.4f} and ends at {back[-1].tip_angle:.4f}")
    lost = 0.0
    for name, angles, path in (("forth", ANGLES, there), ("back", ANGLES[::-1], back)):
        for angle, energy in jumps(angles, path):
            print(f"{name}: a jump with the field at {degrees(angle):.1f}°, {energy:.4f} lost")
            lost += energy
    print(f"{lost:.4f} lost in a cycle, in units of EI over the unit of length")
    if file:
        rows = [(degrees(a), one.y, other.y) for a, one, other in zip(ANGLES, there, back[::-1], strict=True)]
        np.savetxt(file, rows, delimiter=",", header="field_angle_degrees,y_forth,y_back", comments="")


if __name__ == "__main__":
    main(Path(sys.argv[1]) if len(sys.argv) > 1 else None)
