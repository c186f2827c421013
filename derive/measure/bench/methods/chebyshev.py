"""Chebyshev collocation, as in the books on spectral methods (Trefethen; Boyd).

Set up: θ at N + 1 Chebyshev points of [0, ℓ], the second derivative by the square of the differentiation matrix (its
diagonal by negative sums), the two ends as rows, Newton's method with the analytic Jacobian and dense LU until its
step no longer shrinks; the matrices are made once for each N. y and z by integrating the Chebyshev series of cos θ and
sin θ, shapes by Clenshaw's sum. A fold has the linearised equation beside it and η as an unknown.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from functools import cache

import numpy as np
from numpy.polynomial import chebyshev

from derive.measure.bench.methods.rod_solver import (
    Array,
    RodSolver,
    Solved,
    bend,
    by_number,
    couple,
    first_guess,
    stiffness,
)
from derive.measure.reference import Rod

MOST_ROUNDS = 20
SETTLED = 1e-12  # a Newton step below this is the last: the next one would be rounding
UNSETTLED = 1e-6  # and one that stays above this belongs to no solution


@cache
def matrices(n: int) -> tuple[Array, Array, Array, Array]:
    """Points x in [−1, 1] ascending, d/dx, d²/dx², and values to Chebyshev coefficients."""
    k = np.arange(n + 1)
    x = -np.cos(np.pi * k / n)
    weight = np.where((k == 0) | (k == n), 2.0, 1.0) * (-1.0) ** k
    apart = x[:, None] - x[None, :] + np.eye(n + 1)
    first = np.outer(weight, 1 / weight) / apart
    first -= np.diag(first.sum(axis=1))
    coefficients = np.linalg.inv(chebyshev.chebvander(x, n))
    return x, first, first @ first, coefficients


def newton(start: Array, system: Callable[[Array], tuple[Array, Array]]) -> Array | None:
    """Newton's method until its step no longer shrinks, None if it leads nowhere; system: residual and Jacobian."""
    at, before = start, np.inf
    for _ in range(MOST_ROUNDS):
        residual, jacobian = system(at)
        try:
            step = np.linalg.solve(jacobian, residual)
        except np.linalg.LinAlgError:
            return None
        at = at - step
        size = float(np.max(np.abs(step)))
        if size < SETTLED or (before < UNSETTLED and size > before / 2):
            return at
        before = size
    return None


def solve(rod: Rod, tip_angle: float, n: int) -> Solved | None:
    """The equilibrium that Newton's method reaches from the parabola to a tip angle, or None."""
    x, first, second, coefficients = matrices(n)
    square = (rod.length / 2) ** 2

    def system(theta: Array) -> tuple[Array, Array]:
        residual = second @ theta - square * couple(rod, theta)
        jacobian = second - np.diag(square * stiffness(rod, theta))
        residual[0], residual[-1] = theta[0] - rod.clamp_angle, first[-1] @ theta
        jacobian[0], jacobian[-1] = 0.0, first[-1]
        jacobian[0, 0] = 1.0
        return residual, jacobian

    theta = newton(first_guess(rod, tip_angle, (x + 1) / 2), system)
    return None if theta is None else with_position(rod, theta, coefficients)


def with_position(rod: Rod, theta: Array, coefficients: Array) -> Solved:
    """y and z by the integrals of the series of cos θ and sin θ."""
    series: list[Array] = [coefficients @ theta]
    for function in (np.cos, np.sin):
        series.append(rod.length / 2 * chebyshev.chebint(coefficients @ function(theta), lbnd=-1))

    def at(s: Array) -> tuple[Array, Array, Array]:
        x = 2 * s / rod.length - 1
        angle, y, z = (chebyshev.chebval(x, one) for one in series)
        return angle, y, z

    # At x = 1 every Chebyshev polynomial is 1.
    return Solved(float(theta[-1]), float(series[1].sum()), float(series[2].sum()), at)


def fold(rod: Rod, eta: float, tip_angle: float, n: int) -> tuple[float, float] | None:
    """η and the tip angle at the fold near them, or None; the unknowns are θ, h (1 at the tip) and η over the guess."""
    share = (matrices(n)[0] + 1) / 2
    start = np.concatenate([first_guess(rod, tip_angle, share), share * (2 - share), [1.0]])
    found = newton(start, lambda at: fold_system(rod, eta, n, at))
    return None if found is None else (eta * float(found[-1]), float(found[n]))


def fold_system(rod: Rod, eta: float, n: int, at: Array) -> tuple[Array, Array]:
    """Residual and Jacobian: the equation and the linearised one inside, five conditions in the rows of the ends."""
    _, first, second, _ = matrices(n)
    m, square, now = n + 1, (rod.length / 2) ** 2, replace(rod, eta=eta * at[-1])
    theta, h, angle = at[:m], at[m:-1], 2 * (at[:m] - rod.field_angle)
    curved, zero = second - np.diag(square * stiffness(now, theta)), np.zeros((m, m))
    residual = np.concatenate([second @ theta - square * couple(now, theta), curved @ h, [0.0]])
    jacobian = np.zeros((2 * m + 1, 2 * m + 1))
    jacobian[:-1, :-1] = np.block([[curved, zero], [np.diag(-square * bend(now, theta) * h), curved]])
    jacobian[:m, -1] = -square * eta / 2 * np.sin(angle)
    jacobian[m:-1, -1] = -square * eta * np.cos(angle) * h
    unit = np.eye(m)
    for row, columns, values, given in (
        (0, slice(0, m), unit[0], rod.clamp_angle),
        (m - 1, slice(0, m), first[-1], 0.0),
        (m, slice(m, 2 * m), unit[0], 0.0),
        (2 * m - 1, slice(m, 2 * m), first[-1], 0.0),
        (2 * m, slice(m, 2 * m), unit[-1], 1.0),
    ):
        jacobian[row], residual[row] = 0.0, values @ at[columns] - given
        jacobian[row, columns] = values
    return residual, jacobian


SOLVER = RodSolver(
    "Chebyshev",
    solve,
    settings=(8, 12, 16, 24, 32, 48),
    quick=(16, 32),
    spelled=by_number,
    limit=lambda n: max(10 ** (-0.1 * n), 1e-9),  # geometric in n, slow in long rods, down to some n⁴ roundings
    tasks=("T1", "T2", "T3", "T4", "T6"),
    fold=fold,
)
METHODS = (SOLVER.method(),)
