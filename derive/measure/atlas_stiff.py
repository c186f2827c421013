"""Differential equation solvers beside ours on stiff rods: the stable equilibrium whose tip is nearest to the field.

Set-up, as one who knows them would. `solve_bvp`: s over ℓ in [0, 1] and θ′ in units of 1/ℓ, so that all unknowns are
of like size; analytic Jacobian; tolerance 1e-8, up to 100,000 nodes; started from the decay of the linear equation on
nodes that are closer where the rod bends. `Radau`: shooting from the tip (backwards, as the tip's curvature is known)
with rtol 1e-10, the logarithm of θ(ℓ) by brentq from the length at which the clamp angle is met; the tip of a long rod
is below every double, and the shot then fails.
"""

from __future__ import annotations

from collections.abc import Mapping
from math import exp, log, sqrt
from typing import Any

import numpy as np

from derive.measure.atlas_peers import PEERS, Peer, PeerError, named
from derive.measure.reference import FRACTIONS, Rod

TOLERANCE = 1e-8
SHOT_TOLERANCE = 1e-10
NODES = 100_000


def loads_of(rod: Rod) -> tuple[float, float]:
    """β and η in units of 1/ℓ²; PeerError unless the rod is of the kind that is started from its decay."""
    if rod.field_angle or not abs(rod.clamp_angle) < 3 or not rod.clamp_angle:
        raise PeerError("started only for a field along the force and a clamp off it by less than 3")
    return rod.beta * rod.length**2, rod.eta * rod.length**2


def bvp(rod: Rod, _: Any) -> Mapping[str, float]:
    """By scipy.integrate.solve_bvp."""
    from scipy.integrate import solve_bvp

    beta, eta = loads_of(rod)
    rate = sqrt(beta + eta)

    def right(x: Any, v: Any) -> Any:
        return np.vstack([v[1], beta * np.sin(v[0]) + eta / 2 * np.sin(2 * v[0]), np.cos(v[0]), np.sin(v[0])])

    def jacobian(x: Any, v: Any) -> Any:
        found = np.zeros((4, 4, x.size))
        found[0, 1], found[1, 0] = 1, beta * np.cos(v[0]) + eta * np.cos(2 * v[0])
        found[2, 0], found[3, 0] = -np.sin(v[0]), np.cos(v[0])
        return found

    def ends(left: Any, right: Any) -> Any:
        return np.array([left[0] - rod.clamp_angle, right[1], left[2], left[3]])

    def of_ends(left: Any, right: Any) -> Any:
        clamp, tip = np.zeros((4, 4)), np.zeros((4, 4))
        clamp[0, 0] = clamp[2, 2] = clamp[3, 3] = tip[1, 1] = 1
        return clamp, tip

    layer = min(1.0, 40 / rate)
    x = np.unique(np.concatenate([np.linspace(0, layer, 200), np.linspace(layer, 1, 50)]))
    decay = rod.clamp_angle * np.exp(-rate * x)
    start = np.vstack([decay, -rate * decay, x, 0 * x])
    found = solve_bvp(right, ends, x, start, fun_jac=jacobian, bc_jac=of_ends, tol=TOLERANCE, max_nodes=NODES)
    if found.status:
        raise PeerError(f"solve_bvp: {found.message}")
    theta, _, y, z = found.sol(np.array([*FRACTIONS, 1.0]))
    return named(theta, y * rod.length, z * rod.length)


def from_tip(beta: float, eta: float) -> tuple[Any, Any]:
    """Right side and Jacobian for θ, dθ/dσ and the place, lengths over ℓ."""

    def right(x: float, v: Any) -> Any:
        return [v[1], beta * np.sin(v[0]) + eta / 2 * np.sin(2 * v[0]), np.cos(v[0]), np.sin(v[0])]

    def jacobian(x: float, v: Any) -> Any:
        found = np.zeros((4, 4))
        found[0, 1], found[1, 0] = 1, beta * np.cos(v[0]) + eta * np.cos(2 * v[0])
        found[2, 0], found[3, 0] = -np.sin(v[0]), np.cos(v[0])
        return found

    return right, jacobian


def shooting(rod: Rod, _: Any) -> Mapping[str, float]:
    """By scipy.integrate.solve_ivp with Radau, from the tip."""
    from scipy.integrate import solve_ivp
    from scipy.optimize import brentq

    beta, eta = loads_of(rod)
    sign, rate = (1 if rod.clamp_angle > 0 else -1), sqrt(beta + eta)
    right, jacobian = from_tip(beta, eta)

    def shot(logarithm: float, furthest: float, stops: Any = None) -> Any:
        def arrives(x: float, v: Any) -> float:
            return float(abs(v[0]) - abs(rod.clamp_angle))

        arrives.terminal = stops is None  # type: ignore[attr-defined]  # how solve_ivp is told to stop
        tip = exp(logarithm)
        small = SHOT_TOLERANCE * np.array([tip, tip * rate, 1e-2, 1e-2])
        options = {"rtol": SHOT_TOLERANCE, "atol": small, "jac": jacobian, "events": arrives}
        return solve_ivp(right, (0, furthest), [sign * tip, 0, 0, 0], "Radau", stops, **options)

    def miss(logarithm: float) -> float:
        # The length at which the clamp angle is met is all but linear in the logarithm of the tip.
        found = shot(logarithm, 3.0)
        return float(found.t_events[0][0] if found.t_events[0].size else 3.0) - 1

    high = log(abs(rod.clamp_angle))
    low = high - rate - 3
    if low < log(1e-290):
        raise PeerError(f"shooting: the tip, about e^{low:.0f}, is below every double")
    logarithm = brentq(miss, low, high, xtol=1e-12)
    path = shot(logarithm, 1.0, [0.0, *(1 - f for f in reversed(FRACTIONS)), 1.0])
    if not path.success or path.y.shape[1] < len(FRACTIONS) + 2:
        raise PeerError(f"shooting: {path.message}")
    theta, _, y, z = path.y[:, ::-1]
    y, z = (y[0] - y) * rod.length, (z[0] - z) * rod.length
    return named(theta[1:], y[1:], z[1:])


STIFF_PEERS = {
    "solve_bvp": Peer("solve_bvp", f"solve_bvp, tolerance {TOLERANCE:.0e}", None, bvp, ("scipy",)),
    "Radau": Peer("Radau", f"shooting by Radau, {SHOT_TOLERANCE:.0e}", None, shooting, ("scipy",)),
}
ALL_PEERS = {**PEERS, **STIFF_PEERS}
