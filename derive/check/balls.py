"""Balls: midpoints and radii in double precision, arrays of them, rounded outward.

A ball stands for every real number within its radius of its midpoint. Each operation gives a ball that holds the
exact result for all numbers in its arguments. IEEE arithmetic to nearest errs by at most UNIT times the result; the
radius is made larger by that, and by what its own computation may have lost. Underflow loses less than TINY.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from math import factorial
from typing import Any

import numpy as np
from numpy.typing import NDArray

UNIT = 2.0**-53  # relative error of one rounding
TINY = 2.0**-1000  # more than all underflows of one operation together
Array = NDArray[np.float64]
# Around computations in which a radius may become infinite: that is no error, only nothing is decided then.
unbounded = np.errstate(over="ignore", invalid="ignore")


@dataclass(frozen=True)
class Ball:
    """An array of balls: midpoints and radii of one shape."""

    mid: Array
    rad: Array

    def __add__(self, other: Ball) -> Ball:
        """The sum."""
        return _rounded(self.mid + other.mid, self.rad + other.rad)

    def __sub__(self, other: Ball) -> Ball:
        """The difference."""
        return _rounded(self.mid - other.mid, self.rad + other.rad)

    def __mul__(self, other: Ball) -> Ball:
        """The product."""
        spread = np.abs(self.mid) * other.rad + self.rad * (np.abs(other.mid) + other.rad)
        return _rounded(self.mid * other.mid, spread)

    def __truediv__(self, other: Ball) -> Ball:
        """The quotient; an infinite radius where the divisor may be 0."""
        low = np.abs(other.mid) - other.rad
        with np.errstate(divide="ignore", invalid="ignore"):
            mid = self.mid / other.mid
            spread = (self.rad + np.abs(mid) * other.rad) / (low * (1 - 4 * UNIT))
            found = _rounded(mid, spread)
        sure = (low > 0) & np.isfinite(found.mid) & np.isfinite(found.rad)
        return Ball(np.where(sure, found.mid, 0.0), np.where(sure, found.rad, np.inf))

    def __neg__(self) -> Ball:
        """The negative, which is exact."""
        return Ball(-self.mid, self.rad)

    def __getitem__(self, key: Any) -> Ball:
        """Some of the balls."""
        return Ball(self.mid[key], self.rad[key])

    def scaled(self, power: float) -> Ball:
        """Times a power of two, which is exact."""
        return Ball(self.mid * power, self.rad * abs(power))

    def wider(self, by: Array | float) -> Ball:
        """With a larger radius."""
        return _rounded(self.mid, self.rad + by, exact=True)

    def upper(self) -> Array:
        """No number of the ball is greater."""
        return np.nextafter(self.mid + self.rad, np.inf)

    def lower(self) -> Array:
        """No number of the ball is smaller."""
        return np.nextafter(self.mid - self.rad, -np.inf)

    def size(self) -> Array:
        """No number of the ball has a greater modulus."""
        return np.nextafter(np.abs(self.mid) + self.rad, np.inf)

    def sign(self) -> NDArray[np.int8]:
        """1 or −1 where all numbers of the ball have that sign, else 0."""
        return (self.lower() > 0).astype(np.int8) - (self.upper() < 0).astype(np.int8)


def _rounded(mid: Array, rad: Array, *, exact: bool = False) -> Ball:
    """The ball with room for the rounding of its midpoint (unless that is exact) and of its radius."""
    error = 0.0 if exact else np.abs(mid) * UNIT
    return Ball(mid, (rad + error) * (1 + 16 * UNIT) + TINY)


def exactly(value: Any) -> Ball:
    """Floats or arrays of floats, as they are."""
    mid = np.asarray(value, dtype=np.float64)
    return Ball(mid, np.zeros_like(mid))


def rational(value: Fraction | int) -> Ball:
    """A rational number, rounded."""
    mid = np.asarray(float(value))
    return Ball(mid, np.asarray(0.0 if Fraction(float(value)) == value else abs(float(value)) * 2 * UNIT))


def between(low: Array, high: Array) -> Ball:
    """The ball around the numbers from low to high."""
    mid = low + (high - low) / 2
    return Ball(mid, np.nextafter(np.maximum(high - mid, mid - low), np.inf))


def pi() -> Ball:
    """π: its double is off by less than 2⁻⁵²."""
    return Ball(np.asarray(np.pi), np.asarray(2.0**-52))


def series_product(a: Ball, b: Ball) -> Ball:
    """Σ aᵢ b_{k−i}, the last coefficient of a product of two power series, along the first axis."""
    turned = b[::-1]
    sizes = np.abs(a.mid), np.abs(turned.mid)
    mid = np.einsum("k...,k...->...", a.mid, turned.mid)
    whole = np.einsum("k...,k...->...", *sizes)
    rad = np.einsum("k...,k...->...", sizes[0], turned.rad)
    rad = rad + np.einsum("k...,k...->...", a.rad, sizes[1] + turned.rad)
    terms = len(a.mid) + 2  # a sum of n products errs by less than n units of the sum of their moduli
    return Ball(mid, (rad + 1.01 * terms * UNIT * whole) * (1 + 4 * terms * UNIT) + TINY)


def sine_cosine(angle: Ball) -> tuple[Ball, Ball]:
    """sin and cos of angles up to 8: their Taylor series at an eighth of the midpoint, and three doublings."""
    if np.max(np.abs(angle.mid), initial=0.0) > 8:
        raise ValueError("angles beyond 8 are not needed here")
    x = exactly(angle.mid / 8)
    sine, cosine, power = exactly(np.zeros_like(x.mid)), exactly(np.zeros_like(x.mid)), exactly(np.ones_like(x.mid))
    order = 22
    for n in range(order):
        term = power * rational(Fraction((-1) ** (n // 2), factorial(n)))
        sine, cosine = (sine + term, cosine) if n % 2 else (sine, cosine + term)
        power = power * x
    rest = 2 / factorial(order)  # |x| ≤ 1, and both series alternate with falling terms
    sine, cosine = sine.wider(rest), cosine.wider(rest)
    for _ in range(3):
        sine, cosine = (sine * cosine).scaled(2.0), rational(1) - (sine * sine).scaled(2.0)
    return sine.wider(angle.rad), cosine.wider(angle.rad)  # both change no faster than the angle
