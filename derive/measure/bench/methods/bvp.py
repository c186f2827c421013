"""SciPy's `solve_bvp`: collocation at Lobatto points on a mesh that adapts.

Set up: s is scaled to [0, 1] and θ′ with it; the two states θ, θ′ alone, with analytic Jacobians of the right side and
of the ends; a mesh of 21 nodes to start and 6000 at most. What is no success counts as not found: at 1e-12 rounding
often keeps residuals above the tolerance. y and z follow by Gauss's rule on the mesh (of the order of the method),
between the nodes by cubic Hermite splines. A fold is the same problem with the linearised equation beside it and η as
an unknown parameter, normalised by h = 1 at the tip.
"""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np

from derive.measure.bench.methods.rod_solver import (
    Array,
    RodSolver,
    Solved,
    bend,
    by_tolerance,
    couple,
    first_guess,
    stiffness,
)
from derive.measure.reference import Rod

NODES = 21
MOST_NODES = 6000  # what converges at 1e-12 needs 5000; guesses that lead nowhere take all there are
GAUSS = np.polynomial.legendre.leggauss(3)


def solve(rod: Rod, tip_angle: float, tolerance: float) -> Solved | None:
    """The equilibrium that is reached from the parabola to a tip angle, or None."""
    from scipy.integrate import solve_bvp

    grid, square = np.linspace(0, 1, NODES), rod.length**2

    def right_side(_: Array, at: Array) -> Array:
        return np.array([at[1], square * couple(rod, at[0])])

    def slope(_: Array, at: Array) -> Array:
        zero, one = np.zeros_like(at[0]), np.ones_like(at[0])
        return np.array([[zero, one], [square * stiffness(rod, at[0]), zero]])

    def ends(a: Array, b: Array) -> Array:
        return np.array([a[0] - rod.clamp_angle, b[1]])

    def ends_slope(_: Array, __: Array) -> tuple[Array, Array]:
        return np.array([[1.0, 0.0], [0.0, 0.0]]), np.array([[0.0, 0.0], [0.0, 1.0]])

    theta = first_guess(rod, tip_angle, grid)
    guess = np.array([theta, 2 * (tip_angle - rod.clamp_angle) * (1 - grid)])
    found = solve_bvp(
        right_side, ends, grid, guess, fun_jac=slope, bc_jac=ends_slope, tol=tolerance, max_nodes=MOST_NODES
    )
    return with_position(rod, found) if found.success else None


def with_position(rod: Rod, found: object) -> Solved:
    """y and z at the nodes by quadrature, between them by splines."""
    from scipy.interpolate import CubicHermiteSpline

    nodes, solution = found.x, found.sol  # type: ignore[attr-defined]  # a Bunch of SciPy
    width = np.diff(nodes)
    inner = nodes[:-1, None] + width[:, None] * (GAUSS[0] + 1) / 2
    theta = solution(inner.ravel())[0].reshape(inner.shape)
    turned, splines = found.y[0], []  # type: ignore[attr-defined]
    for function in (np.cos, np.sin):
        parts = rod.length * width / 2 * (function(theta) @ GAUSS[1])
        splines.append(CubicHermiteSpline(nodes, np.append(0.0, np.cumsum(parts)), rod.length * function(turned)))

    def at(s: Array) -> tuple[Array, Array, Array]:
        share = s / rod.length
        return solution(share)[0], splines[0](share), splines[1](share)

    return Solved(float(turned[-1]), float(splines[0](1.0)), float(splines[1](1.0)), at)


def fold(rod: Rod, eta: float, tip_angle: float, tolerance: float) -> tuple[float, float] | None:
    """η and the tip angle at the fold near them, or None. The parameter is η over the guess, of order one."""
    from scipy.integrate import solve_bvp

    grid, turn = np.linspace(0, 1, NODES), tip_angle - rod.clamp_angle
    guess = np.array([first_guess(rod, tip_angle, grid), 2 * turn * (1 - grid), grid * (2 - grid), 2 * (1 - grid)])
    right_side, slope = fold_equations(rod, eta)

    def ends(a: Array, b: Array, _: Array) -> Array:
        return np.array([a[0] - rod.clamp_angle, b[1], a[2], b[3], b[2] - 1.0])

    found = solve_bvp(right_side, ends, grid, guess, p=[1.0], fun_jac=slope, tol=tolerance, max_nodes=MOST_NODES)
    return (eta * float(found.p[0]), float(found.y[0, -1])) if found.success else None


def fold_equations(rod: Rod, eta: float) -> tuple[Any, Any]:
    """Right side and Jacobians, by the state θ, θ′, h, h′ and by the parameter."""
    square = rod.length**2

    def right_side(_: Array, at: Array, p: Array) -> Array:
        now = replace(rod, eta=eta * float(p[0]))
        return np.array([at[1], square * couple(now, at[0]), at[3], square * stiffness(now, at[0]) * at[2]])

    def slope(_: Array, at: Array, p: Array) -> tuple[Array, Array]:
        now, angle = replace(rod, eta=eta * float(p[0])), 2 * (at[0] - rod.field_angle)
        by_state, by_parameter = np.zeros((4, 4, at.shape[1])), np.zeros((4, 1, at.shape[1]))
        by_state[0, 1] = by_state[2, 3] = 1.0
        by_state[1, 0] = by_state[3, 2] = square * stiffness(now, at[0])
        by_state[3, 0] = square * bend(now, at[0]) * at[2]
        by_parameter[1, 0] = square * eta / 2 * np.sin(angle)
        by_parameter[3, 0] = square * eta * np.cos(angle) * at[2]
        return by_state, by_parameter

    return right_side, slope


METHODS = (
    RodSolver(
        "solve_bvp",
        solve,
        settings=(1e-3, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12),
        quick=(1e-3, 1e-8),
        spelled=by_tolerance,
        limit=lambda tolerance: max(300 * tolerance, 1e-9),  # a tolerance of the residual is none of the error
        tasks=("T1", "T2", "T3", "T4", "T6"),
        fold=fold,
    ).method("scipy"),
)
