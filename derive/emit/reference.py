"""A reference for emitted solvers that shares no formula with them: the rod's differential equation by Taylor series.

θ″ = β sin θ + (η/2) sin 2(θ − α), y′ = cos θ, z′ = sin θ, energy density ½θ′² − ½η cos²(θ − α) − β cos θ.
"""

from __future__ import annotations

from typing import Any, NamedTuple

from mpmath import mp, mpf, workdps

_ORDER = 30
_STEP = 0.25  # of the shortest length over which the rod bends; the series then gains half a digit an order or more
_DIGITS = 40


class State(NamedTuple):
    """The rod at one point."""

    theta: Any
    curvature: Any
    y: Any
    z: Any
    energy: Any


def integrate(beta: Any, eta: Any, length: Any, clamp_angle: Any, curvature: Any, field_angle: Any = 0) -> State:
    """The state at ``length`` from the clamp, for a clamp curvature, to about 35 digits before amplification."""
    with workdps(_DIGITS):
        beta, eta, length = mpf(beta), mpf(eta), mpf(length)
        state = State(mpf(clamp_angle), mpf(curvature), mpf(0), mpf(0), mpf(0))
        speed = 1 + mp.sqrt(beta + eta) + abs(state.curvature)
        steps = int(mp.ceil(length * speed / _STEP))
        for _ in range(steps):
            state = _step(state, beta, eta, mpf(field_angle), length / steps)
        return state


def _step(state: State, beta: Any, eta: Any, alpha: Any, h: Any) -> State:
    """One step: coefficients of θ, sin, cos from each other, then all sums by Horner's rule."""
    theta, sine, cosine = [state.theta, state.curvature], [mp.sin(state.theta)], [mp.cos(state.theta)]
    double_sine, double_cosine = mp.sin(2 * alpha), mp.cos(2 * alpha)
    density: list[Any] = []
    for n in range(_ORDER):
        both = mp.fdot(sine, reversed(cosine))
        squares = mp.fdot(cosine, reversed(cosine)) - mp.fdot(sine, reversed(sine))
        bend = beta * sine[n] + eta / 2 * (2 * both * double_cosine - squares * double_sine)
        slopes = [(k + 1) * theta[k + 1] for k in range(n + 1)]
        # ½η cos²(θ − α) = ¼η (1 + cos 2(θ − α)), the constant left for the end.
        cos_double = squares * double_cosine + 2 * both * double_sine
        density.append(mp.fdot(slopes, reversed(slopes)) / 2 - eta / 4 * cos_double - beta * cosine[n])
        theta.append(bend / ((n + 1) * (n + 2)))
        sine.append(mp.fdot(slopes, reversed(cosine)) / (n + 1))
        cosine.append(-mp.fdot(slopes, reversed(sine[:-1])) / (n + 1))
    density[0] -= eta / 4
    slopes = [(k + 1) * value for k, value in enumerate(theta[1:])]
    return State(
        _sum(theta, h),
        _sum(slopes, h),
        state.y + _integral(cosine, h),
        state.z + _integral(sine, h),
        state.energy + _integral(density, h),
    )


def _sum(coefficients: list[Any], h: Any) -> Any:
    return mp.polyval(list(reversed(coefficients)), h)


def _integral(coefficients: list[Any], h: Any) -> Any:
    return h * _sum([value / (k + 1) for k, value in enumerate(coefficients)], h)
