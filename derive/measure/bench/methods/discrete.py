"""A discrete elastic rod: energy minimisation over the angles of straight segments, with `scipy.optimize`.

Set up: n segments of equal length, their angles unknown; bending energy at the joints, half a joint at the clamp
(second order in 1/n); analytic gradient; either L-BFGS with many corrections, or the trust-region method of Newton and
conjugate gradients with the exact product by the Hessian, which is tridiagonal. Energies are scaled by ℓ so that
gradients are of order one. A minimiser finds stable equilibria only, and its error is that of the segments.
"""

from __future__ import annotations

from functools import partial

import numpy as np

from derive.measure.bench.methods.rod_solver import Array, RodSolver, Solved, by_number, couple, first_guess, stiffness
from derive.measure.reference import Rod

GRADIENT = 1e-8  # energies lose the differences that show a smaller one


def solve(method: str, rod: Rod, tip_angle: float, segments: int) -> Solved | None:
    """The minimum that is reached from the parabola to a tip angle, or None."""
    from scipy.optimize import minimize

    width = 1.0 / segments
    joint = np.full(segments, 1 / width)
    joint[0] = 2 / width
    middles = (np.arange(segments) + 0.5) * width
    load = rod.length**2 * width

    def energy(theta: Array) -> tuple[float, Array]:
        turn = np.diff(theta, prepend=rod.clamp_angle)
        moment = joint * turn
        potential = rod.beta * np.cos(theta) + rod.eta / 2 * np.cos(theta - rod.field_angle) ** 2
        gradient = moment + load * couple(rod, theta)
        gradient[:-1] -= moment[1:]
        return float(turn @ moment / 2 - load * potential.sum()), gradient

    def curved(theta: Array, change: Array) -> Array:
        moment = joint * np.diff(change, prepend=0.0)
        product = moment + load * stiffness(rod, theta) * change
        product[:-1] -= moment[1:]
        return np.asarray(product)

    start = first_guess(rod, tip_angle, middles)
    if method == "L-BFGS":
        options = {"maxcor": 40, "maxiter": 20_000, "maxfun": 40_000, "gtol": GRADIENT, "ftol": 1e-15}
        found = minimize(energy, start, jac=True, method="L-BFGS-B", options=options)
    else:
        options = {"gtol": GRADIENT, "maxiter": 400}
        found = minimize(energy, start, jac=True, hessp=curved, method="trust-ncg", options=options)
    # Rounding of the energy stops both before a gradient so small is reached; what counts is that it is small.
    if not np.max(np.abs(energy(found.x)[1])) < 1e-5:
        return None
    return shaped(rod, found.x)


def shaped(rod: Rod, theta: Array) -> Solved:
    """The polygon. The tip has the last angle extended by a parabola that has no curvature there."""
    n = len(theta)
    step = rod.length / n
    corners = np.arange(n + 1) * step
    y, z = (np.append(0.0, np.cumsum(step * part(theta))) for part in (np.cos, np.sin))
    tip = float(theta[-1] + (theta[-1] - theta[-2]) / 8)
    places = np.concatenate([[0.0], corners[:-1] + step / 2, [rod.length]])
    angles = np.concatenate([[rod.clamp_angle], theta, [tip]])

    def at(s: Array) -> tuple[Array, Array, Array]:
        return np.interp(s, places, angles), np.interp(s, corners, y), np.interp(s, corners, z)

    return Solved(tip, float(y[-1]), float(z[-1]), at)


def _method(name: str, *, settings: tuple[int, ...], tasks: tuple[str, ...]) -> RodSolver:
    return RodSolver(
        f"discrete rod, {name}",
        partial(solve, name),
        settings,
        quick=(20,),
        spelled=by_number,
        limit=lambda n: 1 / n**2,
        tasks=tasks,
    )


METHODS = (
    _method("L-BFGS", settings=(20, 80), tasks=("T1",)).method("scipy"),
    _method("trust-ncg", settings=(20, 80, 320, 1280), tasks=("T1", "T3")).method("scipy"),
)
