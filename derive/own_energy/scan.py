"""All equilibria of a moderate rod by its own law, by brute force in doubles; limits as in ``measure.scan``."""

from __future__ import annotations

from typing import Any

import numpy as np

from derive.measure.scan import LONGEST_STEP as STEP
from derive.measure.scan import ORDER, STIFFEST, Array, Curve, convolve, crossings, horner
from derive.own_energy.integration import size_of
from derive.own_energy.law import Trigonometric, at_loads, evaluate, slope


def brute_force(law: dict[str, Any], rod: Any) -> list[float]:
    """The tip angles of all equilibria, ascending, to about 1e-7; ValueError beyond the limits of doubles."""
    if rod.length * size_of(rod.loads) > STIFFEST * (1 + 1e-12):
        raise ValueError(f"brute force is for ℓ√(sum of loads) ≤ {STIFFEST}")
    at = [float(load) for load in rod.loads], float(np.cos(rod.field_angle)), float(np.sin(rod.field_angle)), float
    couple, density = at_loads(law["couple"], *at), at_loads(law["density"], *at)

    def along(part: Trigonometric) -> Curve:
        return lambda angle: np.asarray(evaluate(part, np.cos(angle), np.sin(angle)) + 0 * angle)

    return crossings(rod.clamp_angle, along(couple), along(density), lambda tips: shoot(couple, rod, tips))


def shoot(couple: Trigonometric, rod: Any, tips: Array) -> tuple[Array, Array]:
    """θ(0) and ∂θ(0)/∂θ(ℓ) for rods with the given tip angles, by Taylor steps on all of them at once."""
    scale = size_of(rod.loads)
    steps = max(1, int(np.ceil(rod.length * scale / STEP)))
    step = rod.length * scale / steps
    bend = {powers: value / scale**2 for powers, value in couple.items()}
    state = [tips, np.zeros_like(tips), np.cos(tips), np.sin(tips), np.ones_like(tips), np.zeros_like(tips)]
    for _ in range(steps):
        state = [horner(series, step) for series in expanded(bend, slope(bend), state)]
    return state[0], state[4]


def expanded(bend: Trigonometric, stiff: Trigonometric, state: list[Array]) -> Array:
    """Taylor coefficients of θ, θ_σ, cos θ, sin θ, h, h_σ about a state: a row for each order."""
    series = np.zeros((6, ORDER + 1, len(state[0])))
    series[:, 0] = state
    angle, rate, c, s, h, h_rate = series
    of: dict[tuple[int, int], Array] = {(1, 0): c, (0, 1): s}
    powers = sorted({(k, j) for i, j in (*bend, *stiff) for k in range(i + 1)} - set(of))
    of |= {at: np.zeros_like(c) for at in powers}
    stiffness = np.zeros_like(c)
    for k in range(ORDER):
        n = k + 1
        for i, j in powers:
            of[i, j][k] = convolve(of[i - 1, j], c, k) if i else k == 0
        stiffness[k] = sum((value * of[at][k] for at, value in stiff.items()), start=0 * state[0])
        couple = sum((value * of[at][k] for at, value in bend.items()), start=0 * state[0])
        turn_s, turn_c = convolve(c, rate, k), convolve(s, rate, k)
        angle[n], h[n], s[n], c[n], rate[n] = rate[k] / n, h_rate[k] / n, turn_s / n, -turn_c / n, couple / n
        h_rate[n] = convolve(stiffness, h, k) / n
    return series
