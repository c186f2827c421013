"""Shooting with SciPy's `solve_ivp` (DOP853, LSODA or Radau).

Set up: from the tip, where θ′ = 0, so that the tip angle alone is unknown; the linearised equation runs along, and
gives Newton's method its exact derivative; lengths are scaled by ℓ; rtol = atol = the tolerance, not below 1e-13;
Radau has the analytic Jacobian (DOP853 needs none, LSODA builds its own banded one cheaply). When Newton's steps are
below the tolerance, one more run carries y and z, with dense output. A fold is Newton's
method in two unknowns, the tip angle and η, with the equations for the second derivatives along.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from functools import partial
from typing import Any

import numpy as np

from derive.measure.bench.methods.rod_solver import Array, RodSolver, Solved, bend, by_tolerance, couple, stiffness
from derive.measure.reference import Rod

LEAST = 1e-13
MOST_ROUNDS = 14
FURTHEST = 1.0  # a Newton step of more than this is cut


def run(rod: Rod, start: Array, tolerance: float, method: str, right_side: Any, jacobian: Any, dense: bool) -> Any:
    """From the tip to the clamp."""
    from scipy.integrate import solve_ivp

    options = {"jac": jacobian} if method == "Radau" else {}
    limit = max(tolerance, LEAST)
    found = solve_ivp(
        right_side, (0.0, 1.0), start, method=method, rtol=limit, atol=limit, dense_output=dense, **options
    )
    return found if found.success else None


def linearised(rod: Rod) -> tuple[Any, Any]:
    """Right side and Jacobian for θ, dθ/dσ, h, dh/dσ with σ over ℓ."""
    square = rod.length**2

    def right_side(_: float, at: Array) -> list[float]:
        return [at[1], square * couple(rod, at[0]), at[3], square * stiffness(rod, at[0]) * at[2]]

    def jacobian(_: float, at: Array) -> Array:
        rate, change = square * stiffness(rod, at[0]), square * bend(rod, at[0]) * at[2]
        return np.array([[0, 1, 0, 0], [rate, 0, 0, 0], [0, 0, 0, 1], [change, 0, rate, 0]])

    return right_side, jacobian


def with_position(rod: Rod) -> tuple[Any, Any]:
    """Right side and Jacobian for θ, dθ/dσ and the position from the tip."""
    square, length = rod.length**2, rod.length

    def right_side(_: float, at: Array) -> list[float]:
        return [at[1], square * couple(rod, at[0]), length * np.cos(at[0]), length * np.sin(at[0])]

    def jacobian(_: float, at: Array) -> Array:
        rows = np.zeros((4, 4))
        rows[0, 1], rows[1, 0] = 1.0, square * stiffness(rod, at[0])
        rows[2, 0], rows[3, 0] = -length * np.sin(at[0]), length * np.cos(at[0])
        return rows

    return right_side, jacobian


def solve(method: str, rod: Rod, tip_angle: float, tolerance: float) -> Solved | None:
    """The equilibrium that Newton's method reaches from a tip angle, or None."""
    equations, tip = linearised(rod), tip_angle
    for _ in range(MOST_ROUNDS):
        end = run(rod, np.array([tip, 0.0, 1.0, 0.0]), tolerance, method, *equations, dense=False)
        if end is None or end.y[2, -1] == 0:
            return None
        step = float((end.y[0, -1] - rod.clamp_angle) / end.y[2, -1])
        tip -= float(np.clip(step, -FURTHEST, FURTHEST))
        if abs(step) < max(tolerance, LEAST):
            break
    else:
        return None
    path = run(rod, np.array([tip, 0.0, 0.0, 0.0]), tolerance, method, *with_position(rod), dense=True)
    if path is None:
        return None
    whole_y, whole_z = float(path.y[2, -1]), float(path.y[3, -1])

    def at(s: Array) -> tuple[Array, Array, Array]:
        theta, _, y, z = path.sol(1 - s / rod.length)
        return theta, whole_y - y, whole_z - z

    return Solved(tip, whole_y, whole_z, at)


def fold(method: str, rod: Rod, eta: float, tip_angle: float, tolerance: float) -> tuple[float, float] | None:
    """η and the tip angle at the fold near them: F = θ(0) − clamp angle and h(0) both 0, by Newton's method."""
    from scipy.integrate import solve_ivp

    limit, phi, level = max(tolerance, LEAST), tip_angle, eta
    start = np.zeros(10)
    for _ in range(MOST_ROUNDS):
        start[0], start[2] = phi, 1.0
        equations = second_order(replace(rod, eta=level))
        found = solve_ivp(equations, (0.0, 1.0), start, method=method, rtol=limit, atol=limit)
        if not found.success:
            return None
        miss, h, k, h_phi, h_eta = found.y[0::2, -1]
        try:
            step = np.linalg.solve([[h, k], [h_phi, h_eta]], [miss - rod.clamp_angle, h])
        except np.linalg.LinAlgError:
            return None
        phi, level = phi - float(step[0]), level - float(step[1])
        if abs(step[0]) < limit and abs(step[1]) < limit * eta:
            return level, phi
    return None


def second_order(rod: Rod) -> Callable[[float, Array], list[float]]:
    """θ, h = ∂θ/∂φ, k = ∂θ/∂η, ∂h/∂φ and ∂h/∂η, each with its slope: they give the exact matrix of Newton's method."""
    square = rod.length**2

    def right_side(_: float, at: Array) -> list[float]:
        angle = 2 * (at[0] - rod.field_angle)
        rate, change, sine, cosine = stiffness(rod, at[0]), bend(rod, at[0]), np.sin(angle), np.cos(angle)
        h, k = at[2], at[4]
        second = (
            couple(rod, at[0]),
            rate * h,
            rate * k + sine / 2,
            rate * at[6] + change * h * h,
            rate * at[8] + change * h * k + cosine * h,
        )
        return [part for slope, force in zip(at[1::2], second, strict=True) for part in (slope, square * force)]

    return right_side


TOLERANCES = (1e-3, 1e-6, 1e-9, 1e-12)


def _method(name: str, settings: tuple[float, ...], quick: tuple[float, ...], *tasks: str) -> RodSolver:
    return RodSolver(
        f"shooting, {name}",
        partial(solve, name),
        settings,
        quick,
        by_tolerance,
        limit=lambda tolerance: max(1000 * tolerance, 1e-9),  # of one step; errors add up along the rod
        tasks=tasks,
        fold=partial(fold, name),
    )


METHODS = (
    _method("DOP853", TOLERANCES, (1e-6,), "T1", "T2", "T3", "T4", "T6").method("scipy"),
    _method("LSODA", TOLERANCES, (1e-6,), "T1", "T3", "T6").method("scipy"),
    _method("Radau", TOLERANCES[:3], (1e-3,), "T1", "T3").method("scipy"),
)
