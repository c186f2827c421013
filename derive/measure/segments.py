"""Taylor integration of short pieces of a rod, seen from a base direction, in scaled integers.

A long rod lies for most of its length exponentially near directions of rest, and a rod under a weak load near its
clamp angle. So a piece is described by δ = θ − base, and δ is stored over a power of two of its own size, ε: with
u = δ/ε, S = sin δ/ε, C = (1 − cos δ)/ε² and the moment F(θ) = β sin θ + (η/2) sin 2(θ − α),

    u″ = F(base)/ε + β(cos(base) S − ε sin(base) C) + η(cos 2(base − α) S(1 − ε²C) − ε sin 2(base − α) S²),
    S′ = (1 − ε²C) u′,  C′ = S u′,

a polynomial system in which nothing cancels however small δ is: e^{−10000} is as good as 1. F(base) is exactly 0 where
the base is a direction of rest. Beside it run two solutions of the linearised equation h″ = F′(θ) h, with (h, h′) =
(1, 0) and (0, 1) at the start of the piece. Nothing here knows a first integral or an elliptic function.

Lengths are scaled by max(√(β + η), 1/ℓ), so that |F|, |F′| ≤ 1 and a rod is at least 1 long; σ runs from the tip.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import ceil, exp, log, sqrt
from typing import Any

from mpmath import mp, mpf

from derive.measure.reference import Rod
from derive.measure.taylor import LONGEST_STEP, fixed, log2_ratio, product

# Terms per digit: the cheapest for poles of θ about 1.5 away (see `taylor.LONGEST_STEP`).
TERMS_PER_DIGIT = 1.15


@dataclass(frozen=True)
class Load:
    """A rod's scaled parameters: β/scale², η/scale², α, ℓ·scale, and the scale (1/length) itself."""

    beta: Any
    eta: Any
    field_angle: Any
    length: Any
    scale: Any

    @classmethod
    def of(cls, rod: Rod) -> Load:
        """At the precision of the caller's context."""
        scale = mpf(max(sqrt(rod.beta + rod.eta), 1 / rod.length))
        beta, eta = mpf(rod.beta) / scale**2, mpf(rod.eta) / scale**2
        return cls(beta, eta, mpf(rod.field_angle), mpf(rod.length) * scale, scale)

    def moment(self, theta: Any) -> Any:
        """θ″ at an angle."""
        return self.beta * mp.sin(theta) + self.eta / 2 * mp.sin(2 * (theta - self.field_angle))

    def stiffness(self, theta: Any) -> Any:
        """dθ″/dθ."""
        return self.beta * mp.cos(theta) + self.eta * mp.cos(2 * (theta - self.field_angle))


@dataclass(frozen=True)
class Piece:
    """What a piece does: (δ, δ′) at its end, its transfer matrix by rows, and ∫cos θ, ∫sin θ, ∫energy density."""

    end: tuple[Any, Any]
    matrix: tuple[Any, Any, Any, Any]
    y: Any
    z: Any
    energy: Any


class Base:
    """One base direction, and the integration of pieces seen from it."""

    def __init__(self, load: Load, angle: Any, at_rest: bool, digits: int, more_terms: int = 0) -> None:
        self.bits = bits = ceil(digits * log(10, 2))
        self.order = ceil(TERMS_PER_DIGIT * digits) + more_terms
        self.moment = mpf(0) if at_rest else load.moment(angle)
        twice = 2 * (angle - load.field_angle)
        self.cos, self.sin = fixed(mp.cos(angle), bits), fixed(mp.sin(angle), bits)
        self.cos_twice, self.sin_twice = fixed(mp.cos(twice), bits), fixed(mp.sin(twice), bits)
        beta, eta = fixed(load.beta, bits), fixed(load.eta, bits)
        self.beta_cos, self.beta_sin = (beta * self.cos) >> bits, (beta * self.sin) >> bits
        self.eta_cos, self.eta_sin = (eta * self.cos_twice) >> bits, (eta * self.sin_twice) >> bits
        # The energy of a weak load is small too, and is kept over a power of two of the load's size.
        self.weak = max(0, -int(mp.frexp(load.beta + load.eta)[1]))
        self.beta, self.eta = fixed(mp.ldexp(load.beta, self.weak), bits), fixed(mp.ldexp(load.eta, self.weak), bits)
        self._straight: dict[int, tuple[Any, Any, Any, Any]] = {}

    def piece(self, start: tuple[Any, Any], length: int) -> Piece:
        """Integrate from (δ, δ′), floating numbers of any size, over a scaled length in units of 2**-bits."""
        size = max(abs(start[0]), abs(start[1]), abs(self.moment))
        small = max(0, -int(mp.frexp(size)[1])) if size else None
        if small is None or (small > self.bits and not self.moment):
            return self._nearly_straight(start, length)
        return self._bent(start, length, small)

    def _nearly_straight(self, start: tuple[Any, Any], length: int) -> Piece:
        """Where δ² is below the last digit of δ, the linearised equation is all there is; pieces repeat."""
        if length not in self._straight:
            self._straight[length] = self._bent((mpf(0), mpf(0)), length, 2 * self.bits).matrix
        a, b, c, d = matrix = self._straight[length]
        end = (a * start[0] + b * start[1], c * start[0] + d * start[1])
        y, z = (mp.ldexp(part * length, -2 * self.bits) for part in (self.cos, self.sin))
        density = -((self.eta * ((1 << self.bits) + self.cos_twice)) >> (self.bits + 2))
        density -= (self.beta * self.cos) >> self.bits
        return Piece(end, matrix, y, z, mp.ldexp(density * length, -2 * self.bits - self.weak))

    def _bent(self, start: tuple[Any, Any], length: int, small: int) -> Piece:
        bits = self.bits
        one = 1 << bits
        u, rate = (fixed(mp.ldexp(part, small), bits) for part in start)
        sine, versine = sine_versine(start[0])
        bent = fixed(mp.ldexp(sine, small), bits), fixed(mp.ldexp(versine, 2 * small), bits)
        state = [u, rate, *bent, one, 0, 0, one, 0, 0, 0]
        push = fixed(mp.ldexp(self.moment, small), bits)
        here = 0
        while here < length:
            series = self._expand(state, small, push)
            step = fixed(mpf(self._longest(series)), bits)
            left = length - here
            step = -(-left // ceil(left / step)) if step < left else left
            step = min(step, left)
            state = [_horner(coefficients, step, bits) for coefficients in series]
            here += step

        def number(value: int, shift: int = 0) -> Any:
            return mp.ldexp(mpf(value), -bits - shift)

        h1, g1, h2, g2 = (number(value) for value in state[4:8])
        end = (number(state[0], small), number(state[1], small))
        return Piece(end, (h1, h2, g1, g2), number(state[8]), number(state[9]), number(state[10], self.weak))

    def _expand(self, state: list[int], small: int, push: int) -> list[list[int]]:
        """Coefficients of u, u′, S, C, the two h and h′, and the three integrals."""
        bits, k1, k2 = self.bits, small, 2 * small
        beta_cos, beta_sin, eta_cos, eta_sin = self.beta_cos, self.beta_sin, self.eta_cos, self.eta_sin
        u, rate, S, C, h1, g1, h2, g2, y, z, energy = series = [[component] for component in state]
        stiffness: list[int] = []
        one, flat = 1 << bits, k2 > bits + 8  # what is flat has no ε² to its last bit
        for k in range(self.order):
            n, now = k + 1, one if k == 0 else 0
            square = product(S, S, k) >> bits
            lean = S[k] if flat else S[k] - (product(S, C, k) >> (bits + k2))  # sin δ cos δ/ε
            upright = now - (C[k] >> k2)  # cos δ
            level = now - (square >> (k2 - 1) if k2 else 2 * square)  # cos 2δ
            tilt, tilts = S[k] >> k1, (2 * lean) >> k1  # sin δ and sin 2δ
            moment = beta_cos * S[k] - ((beta_sin * C[k]) >> k1) + eta_cos * lean - ((eta_sin * square) >> k1)
            stiffness.append((beta_cos * upright - beta_sin * tilt + eta_cos * level - eta_sin * tilts) >> bits)
            cos_theta = (self.cos * upright - self.sin * tilt) >> bits
            cos_squared = (now + ((self.cos_twice * level - self.sin_twice * tilts) >> bits)) >> 1
            speed = 0 if flat and not self.weak else (product(rate, rate, k) << self.weak) >> (bits + k2)
            density = (speed - ((self.eta * cos_squared) >> bits)) // 2 - ((self.beta * cos_theta) >> bits)
            turn, rise = 0 if flat else product(C, rate, k) >> (bits + k2), product(S, rate, k) >> bits
            u.append(rate[k] // n)
            S.append((rate[k] - turn) // n)
            C.append(rise // n)
            rate.append(((moment >> bits) + (push if k == 0 else 0)) // n)
            for h, g in ((h1, g1), (h2, g2)):
                bend = product(stiffness, h, k) >> bits
                h.append(g[k] // n)
                g.append(bend // n)
            y.append(cos_theta // n)
            z.append(((self.sin * upright + self.cos * tilt) >> bits) // n)
            energy.append(density // n)
        return series

    def _longest(self, series: list[list[int]]) -> float:
        """The step at which the last two terms fall below the last bit."""
        length = LONGEST_STEP
        sizes = [1 << self.bits] * len(series)
        for pair in ((4, 5), (6, 7)):
            size = max(abs(series[pair[0]][0]), abs(series[pair[1]][0]), sizes[0])
            sizes[pair[0]] = sizes[pair[1]] = size
        for size, coefficients in zip(sizes, series, strict=True):
            for k in (self.order - 1, self.order):
                if coefficients[k]:
                    length = min(length, exp((log2_ratio(size, abs(coefficients[k])) - self.bits) * log(2) / k))
        return length


def sine_versine(delta: Any) -> tuple[Any, Any]:
    """sin δ and 1 − cos δ, to the digits of the context however small δ is."""
    if delta and mp.frexp(delta)[1] < -mp.prec // 8:
        square = delta * delta
        sine = delta * (1 - square / 6 * (1 - square / 20 * (1 - square / 42)))
        return sine, square / 2 * (1 - square / 12 * (1 - square / 30 * (1 - square / 56)))
    cosine, sine = mp.cos_sin(delta / 2)
    return 2 * sine * cosine, 2 * sine * sine


def _horner(coefficients: list[int], step: int, bits: int) -> int:
    """The sum of a series at one step."""
    value = 0
    for coefficient in reversed(coefficients):
        value = ((value * step) >> bits) + coefficient
    return value
