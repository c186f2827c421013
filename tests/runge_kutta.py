"""Where motions are after some length, by Runge and Kutta's method: a check that shares nothing with the solvers."""

from __future__ import annotations

from typing import Any

import numpy as np

STEPS = 400


def angle_after(tip: np.ndarray, length: Any, beta: Any, eta: Any, field_angle: Any) -> np.ndarray:
    """θ at a length from the tip, where motions are at rest; the arguments are broadcast."""
    return motion_after(tip, 0 * tip, length, beta, eta, field_angle)


def motion_after(
    angle: np.ndarray, speed: np.ndarray, length: Any, beta: Any, eta: Any, field_angle: Any
) -> np.ndarray:
    """θ at a length, which may be complex, from where it is ``angle`` and θ′ is ``speed``."""

    def moment(theta: np.ndarray) -> np.ndarray:
        found: np.ndarray = beta * np.sin(theta) + eta / 2 * np.sin(2 * (theta - field_angle))
        return found

    step = length / STEPS
    for _ in range(STEPS):
        first = moment(angle)
        second = moment(angle + step / 2 * speed)
        third = moment(angle + step / 2 * speed + step * step / 4 * first)
        fourth = moment(angle + step * speed + step * step / 2 * second)
        angle = angle + step * speed + step * step / 6 * (first + second + third)
        speed = speed + step / 6 * (first + 2 * second + 2 * third + fourth)
    return angle
