"""What the peers that solve the boundary value problem share: what they are given and what they give."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from derive.measure.reference import Rod

Array = NDArray[np.floating[Any]]
# Turns from the clamp angle to the tip angle from which a user would start, who looks for all equilibria.
TURNS = np.linspace(-3.0, 3.0, 9)
APART = 1e-3  # tip angles nearer than this are taken for one


@dataclass(frozen=True)
class Solved:
    """One equilibrium: tip angle, tip position, and θ, y, z at arc lengths."""

    tip_angle: float
    y: float
    z: float
    at: Callable[[Array], tuple[Array, Array, Array]]


Solver = Callable[[Rod, float], "Solved | None"]


def couple(rod: Rod, theta: Any) -> Any:
    """θ″ at an angle."""
    return rod.beta * np.sin(theta) + rod.eta / 2 * np.sin(2 * (theta - rod.field_angle))


def stiffness(rod: Rod, theta: Any) -> Any:
    """dθ″/dθ."""
    return rod.beta * np.cos(theta) + rod.eta * np.cos(2 * (theta - rod.field_angle))


def first_guess(rod: Rod, tip_angle: float, share: Array) -> Array:
    """The parabola over s/ℓ that has the clamp angle at the clamp, and the tip angle and no curvature at the tip."""
    return np.asarray(rod.clamp_angle + (tip_angle - rod.clamp_angle) * share * (2 - share))


def all_found(solver: Solver, rod: Rod) -> list[Solved]:
    """What a solver finds from nine guesses, each equilibrium once, sorted by tip angle."""
    found: list[Solved] = []
    for turn in TURNS:
        one = solver(rod, rod.clamp_angle + float(turn))
        if one is not None and all(abs(one.tip_angle - other.tip_angle) > APART for other in found):
            found.append(one)
    return sorted(found, key=lambda one: one.tip_angle)
