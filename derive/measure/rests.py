"""Directions of rest of a rod, θ″ = 0, and the potential measured from them with full relative precision.

½θ_σ² + V(θ) is the same all along a rod, V = β cos θ + (η/2) cos²(θ − α). Over a direction of rest r and with
δ = θ − r, s = sin δ and v = 1 − cos δ, the constant of the motion is E = ½θ_σ² + W with

    W = V(r + δ) − V(r) = −β cos r · v − (η/2) cos 2(r − α) s² + (η/2) sin 2(r − α) s v,

for β sin r = −(η/2) sin 2(r − α). Long rods have E as small as e^{−2ℓ√η} over a direction they linger at, and over
another one at the same height: the differences of heights are found with so many digits that this is seen.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from math import ceil
from typing import Any

import numpy as np
from mpmath import mp, mpf

from derive.measure.segments import Load, sine_versine

# Digits of the heights for every unit of scaled length: e^{−2ℓ}, and those of the answer come on top.
DIGITS_PER_LENGTH = 0.87
# Per radian; pairs of directions of rest that are closer are missed, which only costs relative precision.
SAMPLES = 1000


@dataclass(frozen=True)
class Rest:
    """A direction of rest, dθ″/dθ there (positive: unstable), V there, and the coefficients of W."""

    angle: Any
    stiffness: Any
    height: Any
    versine: Any
    square: Any
    mixed: Any

    def rise_and_moment(self, delta: Any) -> tuple[Any, Any]:
        """W at δ, and θ″ = −dW/dδ."""
        s, v = sine_versine(delta)
        rise = -self.versine * v - self.square * s * s + self.mixed * s * v
        return rise, self.versine * s + 2 * self.square * s * (1 - v) - self.mixed * ((1 - v) * v + s * s)


def rests(load: Load, low: float, high: float) -> list[Rest]:
    """All between two angles, ascending, with heights good to e^{−2ℓ} besides the digits of the context."""
    digits = mp.dps + ceil(DIGITS_PER_LENGTH * float(load.length))
    samples = np.linspace(low, high, ceil((high - low) * SAMPLES) + 2)
    beta, eta, field_angle = float(load.beta), float(load.eta), float(load.field_angle)
    moments = beta * np.sin(samples) + eta / 2 * np.sin(2 * (samples - field_angle))
    changes = np.flatnonzero(np.signbit(moments[1:]) != np.signbit(moments[:-1]))
    with mp.workdps(digits):
        found = [rest_at(load, mpf(float(samples[k])), mpf(float(samples[k + 1]))) for k in changes]
    return [replace(rest, **{name: +value for name, value in vars(rest).items() if name != "height"}) for rest in found]


def rest_at(load: Load, low: Any, high: Any) -> Rest:
    """The one between two angles."""
    angle = bracketed_zero(load, low, high)
    if abs(angle) < mpf(10) ** (10 - mp.dps):
        angle = mpf(0)
    twice = 2 * (angle - load.field_angle)
    cosine, sine = mp.cos(twice), mp.sin(twice)
    force = load.beta * mp.cos(angle)
    height = force + load.eta * (1 + cosine) / 4
    return Rest(angle, force + load.eta * cosine, height, force, load.eta * cosine / 2, load.eta * sine / 2)


def bracketed_zero(load: Load, a: Any, b: Any) -> Any:
    """One zero of θ″: in its bracket with few digits, then Newton's method, twice for every doubling of the digits."""
    goal, digits = mp.dps, 30
    with mp.workdps(digits):
        rising = load.moment(b) > load.moment(a)
        for _ in range(digits * 4):  # a bit each
            middle = (a + b) / 2
            a, b = (a, middle) if (load.moment(middle) > 0) == rising else (middle, b)
        angle = (a + b) / 2
    while digits < goal:
        digits = min(2 * digits - 5, goal)
        with mp.workdps(digits + 5):
            for _ in range(2):
                slope = load.stiffness(angle)
                angle -= load.moment(angle) / slope if slope else 0
    return +angle
