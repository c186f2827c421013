"""Taylor integration of a rod from its tip to its clamp, to any precision, in integer arithmetic.

Nothing here knows a first integral or an elliptic function: the only inputs are the equilibrium equation
θ″ = β sin θ + (η/2) sin 2(θ − α), y′ = cos θ, z′ = sin θ, the energy density and the linearised equation
h″ = (β cos θ + η cos 2(θ − α)) h with h = 1, h′ = 0 at the tip.

Lengths are scaled by √(β + η), so that every coefficient is of order one and a number is an
integer times 2**-bits. With the angle φ = θ − α, P = cos φ, Q = sin φ, every right side is a product of two series.
σ = ℓ − s runs from the tip.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import ceil, exp, log, sqrt
from operator import mul
from typing import Any, NamedTuple

from mpmath import mp, mpf

# The steps end where the last Taylor term is about e**-2 per order; half of π (see `Path.index`) is never reached.
LONGEST_STEP = 0.75
# Digits carried beyond those asked for, against rounding in a few hundred steps of some 10⁴ operations.
GUARD_DIGITS = 8


class State(NamedTuple):
    """The rod at one point, by scaled numbers: φ, dφ/dσ, cos φ, sin φ, h, dh/dσ, ∫cos θ, ∫sin θ, ∫energy density."""

    angle: int
    rate: int
    cos: int
    sin: int
    h: int
    h_rate: int
    y: int
    z: int
    energy: int


@dataclass(frozen=True)
class Point:
    """The rod at arc length s from the clamp; y, z and energy belong to the piece from s to the tip."""

    s: Any
    theta: Any
    curvature: Any
    y: Any
    z: Any
    energy: Any
    h: Any


@dataclass(frozen=True)
class Path:
    """A rod integrated from its tip: its points from the tip to the clamp, and the number of negative directions.

    index: number of zeros of h in (0, ℓ). Two zeros of h are at least π apart in scaled length, for |h″/h| ≤ 1 there
    (Sturm), and steps are shorter: so sign changes from step to step miss none.
    """

    tip_angle: Any
    points: tuple[Point, ...]
    index: int
    steps: int

    @property
    def clamp(self) -> Point:
        """The end at s = 0."""
        return self.points[-1]


class Series:
    """Taylor coefficients of a State in σ, for one rod at one precision."""

    def __init__(self, beta: Any, eta: Any, field_angle: Any, bits: int, order: int) -> None:
        scale = sqrt(float(beta + eta)) or 1.0
        self.bits, self.order, self.scale = bits, order, mpf(scale)
        self.beta = fixed(beta / self.scale**2, bits)
        self.eta = fixed(eta / self.scale**2, bits)
        self.cos_field = fixed(mp.cos(field_angle), bits)
        self.sin_field = fixed(mp.sin(field_angle), bits)

    def expand(self, at: State) -> tuple[list[int], ...]:
        """Coefficients of the nine components about a point, up to the order."""
        bits, beta, eta, ca, sa = self.bits, self.beta, self.eta, self.cos_field, self.sin_field
        angle, rate, p, q, h, h_rate, y, z, energy = series = tuple([component] for component in at)
        stiffness: list[int] = []
        one = 1 << bits
        for k in range(self.order):
            square, n = product(p, p, k) >> bits, k + 1
            cos_theta, sin_theta = (p[k] * ca - q[k] * sa) >> bits, (q[k] * ca + p[k] * sa) >> bits
            stiffness.append((beta * cos_theta + eta * (2 * square - (one if k == 0 else 0))) >> bits)
            couple = beta * sin_theta + eta * (product(p, q, k) >> bits)
            density = (product(rate, rate, k) - eta * square) >> 1
            angle.append(rate[k] // n)
            h.append(h_rate[k] // n)
            y.append(cos_theta // n)
            z.append(sin_theta // n)
            turn_q, turn_p = product(p, rate, k), product(q, rate, k)
            rate.append((couple >> bits) // n)
            h_rate.append((product(stiffness, h, k) >> bits) // n)
            energy.append((density >> bits) // n)
            q.append((turn_q >> bits) // n)
            p.append(-(turn_p >> bits) // n)
        return series

    def step_length(self, series: Sequence[Sequence[int]]) -> float:
        """The scaled step at which the last two terms fall below the last bit (those of h relative to h)."""
        length = LONGEST_STEP
        size_h = max(abs(series[4][0]), abs(series[5][0]), 1 << self.bits)
        for number, coefficients in enumerate(series):
            size = size_h if number in (4, 5) else 1 << self.bits
            for k in (self.order - 1, self.order):
                if coefficients[k]:
                    logarithm = log2_ratio(size, abs(coefficients[k])) - self.bits
                    length = min(length, exp(logarithm * log(2) / k))
        return length

    def advance(self, series: Sequence[Sequence[int]], step: int) -> State:
        """The state one scaled step further, by Horner's rule."""
        bits, values = self.bits, []
        for coefficients in series:
            value = 0
            for coefficient in reversed(coefficients):
                value = ((value * step) >> bits) + coefficient
            values.append(value)
        return State(*values)


def product(a: Sequence[int], b: Sequence[int], k: int) -> int:
    """Coefficient k of the product of two series, not yet shifted back."""
    return sum(map(mul, a[: k + 1], b[k::-1]))


def fixed(x: Any, bits: int) -> int:
    """The integer nearest to x·2**bits."""
    return int(mp.nint(mp.ldexp(x, bits)))


def log2_ratio(a: int, b: int) -> float:
    """log₂(a/b) for positive integers of any size."""
    shift = max(a.bit_length() - 60, 0), max(b.bit_length() - 60, 0)
    return log((a >> shift[0]) / (b >> shift[1]), 2) + shift[0] - shift[1]


def working_digits(beta: Any, eta: Any, length: Any, digits: int) -> int:
    """Digits to carry: an error at the tip grows by at most e^{ℓ√(β+η)} on its way to the clamp."""
    return digits + GUARD_DIGITS + ceil(float(length) * sqrt(float(beta) + float(eta)) / log(10))


def integrate(
    tip_angle: Any,
    beta: Any,
    eta: Any,
    field_angle: Any,
    length: Any,
    digits: int = 40,
    *,
    stops: Sequence[Any] = (),
    more_terms: int = 0,
) -> Path:
    """Integrate from the tip to the clamp, stopping at the arc lengths `stops` (from the clamp).

    more_terms raises the order, and with it changes every step: the difference of two runs shows the error.
    """
    working = working_digits(beta, eta, length, digits)
    with mp.workdps(working + 5):
        beta, eta, field_angle, length = mpf(beta), mpf(eta), mpf(field_angle), mpf(length)
        bits = ceil(working * log(10, 2))
        rod = Series(beta, eta, field_angle, bits, order=ceil(1.15 * working) + more_terms)
        tip_angle = mpf(tip_angle)
        phi = tip_angle - field_angle
        one = 1 << bits
        start = State(fixed(phi, bits), 0, fixed(mp.cos(phi), bits), fixed(mp.sin(phi), bits), one, 0, 0, 0, 0)
        ends = sorted({mpf(s) for s in stops} | {mpf(0)}, reverse=True)
        if ends[0] > length or ends[-1] < 0:
            raise ValueError(f"stops must lie in [0, {length}]")
        return run(rod, start, tip_angle, length, ends, field_angle)


def run(rod: Series, state: State, tip_angle: Any, length: Any, ends: Sequence[Any], field_angle: Any) -> Path:
    """Step from the tip to each of the ends, counting the sign changes of h on the open rod."""
    points, index, steps, here = [], 0, 0, 0
    for s in ends:
        goal = fixed((length - s) * rod.scale, rod.bits)
        while here < goal:
            series = rod.expand(state)
            step = min(goal - here, fixed(mpf(rod.step_length(series)), rod.bits))
            before, state = state, rod.advance(series, step)
            here, steps = here + step, steps + 1
            index += (before.h < 0 <= state.h) or (before.h > 0 >= state.h)
        points.append(point(rod, state, s, field_angle))
    if state.h == 0:
        index -= 1
    return Path(tip_angle, tuple(points), int(index), steps)


def point(rod: Series, state: State, s: Any, field_angle: Any) -> Point:
    """The state in the rod's own units."""

    def number(value: int) -> Any:
        return mp.ldexp(mpf(value), -rod.bits)

    scale = rod.scale
    return Point(
        s,
        number(state.angle) + field_angle,
        -number(state.rate) * scale,
        number(state.y) / scale,
        number(state.z) / scale,
        number(state.energy) * scale,
        number(state.h),
    )
