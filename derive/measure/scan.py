"""All equilibria of a moderate rod by brute force in double precision; shares no formula with the solvers.

Every tip angle is tried: a rod integrated from each of some ten thousand of them reaches the clamp at θ(0), and an
equilibrium lies where θ(0) crosses the clamp angle. Between two neighbours the crossings are separated by the extrema
of θ(0), and those are the zeros of h(0) = ∂θ(0)/∂θ(ℓ), which are found too.

Limits: doubles lose e^{ℓ√(β+η)}, so ℓ√(β+η) ≤ 20 (`STIFFEST`); two extrema of θ(0) between neighbouring tip angles are
missed; a pair of equilibria closer than 1e-7 (a rod at a fold) counts as none or two.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from derive.measure.reference import Rod

Array = NDArray[np.float64]
Curve = Callable[[Array], Array]
Arrive = Callable[[Array], tuple[Array, Array]]
STIFFEST = 20.0
ORDER = 14
LONGEST_STEP = 0.25  # in scaled length: the singularities are about 1.5 away, so a step errs by some (1/6)**15
GRID = 3001
# Brackets are cut into so many parts at once, for many rods take hardly longer than one; so often that what is left is
# refined by `reference.solve`.
PARTS, ROUNDS = 32, 7
NOISE = 1e-12  # crossings closer than this are one, crossed back and forth by rounding
OFFSETS = np.geomspace(1e-14, 0.3, 150)


def brute_force(rod: Rod) -> list[float]:
    """The tip angles of all equilibria, ascending, to about 1e-7; ValueError beyond the limits of doubles."""
    if rod.length * np.sqrt(rod.beta + rod.eta) > STIFFEST * (1 + 1e-12):
        raise ValueError(f"brute force is for ℓ√(β+η) ≤ {STIFFEST}; this rod has more: {rod}")

    def couple(angle: Array) -> Array:
        return rod.beta * np.sin(angle) + rod.eta / 2 * np.sin(2 * (angle - rod.field_angle))

    def potential(angle: Array) -> Array:
        return rod.beta * np.cos(angle) + rod.eta / 2 * np.cos(angle - rod.field_angle) ** 2

    return crossings(rod.clamp_angle, couple, potential, lambda tips: shoot(rod, tips))


def crossings(clamp_angle: float, couple: Curve, potential: Curve, arrive: Arrive) -> list[float]:
    """The tip angles, ascending, at which θ(0) crosses the clamp angle.

    couple, potential: θ″ at an angle, and what it is the falling slope of. arrive: θ(0) and h(0) of tip angles.
    """
    tips = candidates(clamp_angle, couple, potential)
    _, h = arrive(tips)
    turn = np.flatnonzero(np.signbit(h[1:]) != np.signbit(h[:-1]))
    extrema = cut(lambda tip: arrive(tip)[1], tips[turn], tips[turn + 1])
    found = zeros(lambda tip: arrive(tip)[0] - clamp_angle, np.unique(np.concatenate([tips, extrema])))
    found = np.unique(found)
    return [float(tip) for tip in found[np.diff(found, prepend=-np.inf) > NOISE]]


def candidates(clamp_angle: float, couple: Curve, potential: Curve) -> Array:
    """Tip angles to try: an even grid, and offsets in geometric progression from every critical tip.

    A tip at rest cannot be a whole turn away from the clamp. Critical are the directions of equilibrium (a long rod
    leaves them exponentially slowly) and the tips at the level of one of the unstable ones (the rod lingers there).
    """
    low, high = clamp_angle - 2 * np.pi, clamp_angle + 2 * np.pi
    grid = np.linspace(low, high, GRID)
    rest = zeros(couple, np.linspace(low - 7, high + 7, 3 * GRID))

    def same_level(level: float) -> Array:
        return zeros(lambda angle: potential(angle) - level, grid)

    critical = np.concatenate([rest, *map(same_level, potential(rest))])
    near = np.concatenate([critical[:, None] + OFFSETS, critical[:, None] - OFFSETS]).ravel()
    tips = np.unique(np.concatenate([grid, critical, near]))
    return tips[(tips >= low) & (tips <= high)]


def zeros(function: Curve, grid: Array) -> Array:
    """Where a function changes sign on a grid."""
    values = function(grid)
    at = np.flatnonzero(np.signbit(values[1:]) != np.signbit(values[:-1]))
    return cut(function, grid[at], grid[at + 1])


def cut(function: Curve, low: Array, high: Array) -> Array:
    """One zero in each of many brackets at once."""
    if not low.size:
        return low
    sign, each = np.signbit(function(low)), np.arange(low.size)
    for _ in range(ROUNDS):
        places = np.linspace(low, high, PARTS + 1, axis=1)
        beyond = np.signbit(function(places[:, 1:-1].ravel())).reshape(low.size, -1) != sign[:, None]
        last = np.where(beyond.any(axis=1), beyond.argmax(axis=1), PARTS - 1)  # the part before the first place beyond
        low, high = places[each, last], places[each, last + 1]
    return (low + high) / 2


def shoot(rod: Rod, tips: Array) -> tuple[Array, Array]:
    """θ(0) and h(0) for rods with the given tip angles, by Taylor steps on all of them at once."""
    scale = np.sqrt(rod.beta + rod.eta) or 1.0
    length = rod.length * scale
    steps = max(1, int(np.ceil(length / LONGEST_STEP)))
    beta, eta, step = rod.beta / scale**2, rod.eta / scale**2, length / steps
    ca, sa = np.cos(rod.field_angle), np.sin(rod.field_angle)
    angle, rate = tips - rod.field_angle, np.zeros_like(tips)
    h, h_rate = np.ones_like(tips), np.zeros_like(tips)
    a, r, g, g_rate, p, q, stiffness = np.zeros((7, ORDER + 1, len(tips)))
    for _ in range(steps):
        a[0], r[0], g[0], g_rate[0], p[0], q[0] = angle, rate, h, h_rate, np.cos(angle), np.sin(angle)
        for k in range(ORDER):
            n = k + 1
            couple = beta * (q[k] * ca + p[k] * sa) + eta * convolve(p, q, k)
            stiffness[k] = beta * (p[k] * ca - q[k] * sa) + eta * (2 * convolve(p, p, k) - (k == 0))
            turn_q, turn_p = convolve(p, r, k), convolve(q, r, k)
            a[n], g[n], r[n], q[n], p[n] = r[k] / n, g_rate[k] / n, couple / n, turn_q / n, -turn_p / n
            g_rate[n] = convolve(stiffness, g, k) / n
        angle, rate, h, h_rate = (horner(series, step) for series in (a, r, g, g_rate))
    return angle + rod.field_angle, h


def convolve(a: Array, b: Array, k: int) -> Array:
    """Coefficient k of the product of two series, whose coefficients are rows."""
    total: Array = np.einsum("in,in->n", a[: k + 1], b[k::-1])
    return total


def horner(series: Array, step: float) -> Array:
    """The sum of a series at one step."""
    value = series[-1]
    for coefficient in series[-2::-1]:
        value = value * step + coefficient
    return value
