"""What rounding can do to the angle at which a motion is after the length of a short rod: the bound of docs/solver.md.

Values carry how large they may be and how wrong; ``block_arrivals.ahead_at_clamp`` itself is run on them.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field, replace
from math import cos, cosh, pi, sin, tan
from typing import Any

import numpy as np

from derive.emit.kernels.block_arrivals import Quartic, ahead_at_clamp


@dataclass
class Doublings:
    """The duplications of ℘ to come, as (least |℘′|, most |℘| after it), and what rounding has cost so far.

    start: of the series. losses: of each numerator and of each denominator, over the least denominator.
    """

    ahead: Iterator[tuple[float, float]]
    start: float = 0.0
    losses: list[tuple[float, float]] = field(default_factory=list)


@dataclass
class Rounded:
    """A computed number: its greatest size, its greatest error, and the relative error of one operation."""

    most: float
    error: float
    unit: float
    dtype: Any
    doublings: Doublings

    def _new(self, most: float, error: float) -> Rounded:
        return replace(self, most=most, error=error + self.unit * (most + error))

    def __add__(self, other: Rounded | float) -> Rounded:
        if not isinstance(other, Rounded):
            return self._new(self.most + abs(other), self.error)
        return self._new(self.most + other.most, self.error + other.error)

    __radd__ = __sub__ = __rsub__ = __add__

    def __mul__(self, other: Rounded | float) -> Rounded:
        if not isinstance(other, Rounded):
            return self._new(self.most * abs(other), self.error * abs(other))
        cross = self.most * other.error + other.most * self.error + self.error * other.error
        return self._new(self.most * other.most, cross)

    __rmul__ = __mul__

    def __truediv__(self, other: Rounded | float) -> Rounded:
        if isinstance(other, Rounded):
            slope, most = next(self.doublings.ahead)
            assert other.error < slope * slope / 100
            self.doublings.losses.append((self.error / slope**2, other.error / slope**2))
            return replace(self, most=most, error=0.0)
        if other < 1:  # the series over z²: from here on ℘ as it stands is doubled
            self.doublings.start = (self.error + self.unit * self.most) / other
            return replace(self, most=self.most / other, error=0.0)
        return self._new(self.most / other, self.error / other)

    def within(self, most: float) -> Rounded:
        """The number, known to be no greater."""
        return replace(self, most=min(self.most, most))


def least_slope(slow: float, z: float) -> float:
    """|℘′(z)| = |δ′|p/(8 sin²(δ/2)) ≥ v/(2(∫v)²), v = δ′/p: v/∫v is least about a well, 1/∫v about a hill."""
    return slow**3 / (2 * tan(slow * z / 2) * (cosh(slow * z) - 1))


def most_ahead(slow: float, z: float) -> float:
    """|℘(z) − c| ≤ |p/4|/sin(δ/2), by δ ≥ p(1 − cos kz)/k² and δ/2 ≤ (kz)²/4."""
    turn = (slow * z) ** 2 / 4
    return slow**2 / (2 * (1 - cos(slow * z))) * turn / sin(turn)


def error_bound(slow: float, kind: Any) -> float:
    """By how much ``block_arrivals.miss`` may be wrong, in radians, on rods with ℓ√(β + η) up to ``slow``."""
    unit, soft, growth = float(np.finfo(kind).eps) / 2 * 1.001, slow**2, cosh(slow) - 1
    number = 2 if kind is np.float32 else 4
    places = [0.5**k for k in range(number, 0, -1)]
    ways = iter([(least_slope(slow, z), most_ahead(slow, min(2 * z, 0.5))) for z in places])
    doublings = Doublings(ways)
    p = Rounded(soft, 0.0, unit, np.dtype(kind), doublings)  # q, m and β cos φ are no greater
    quartic = Quartic(p / 4, p, (p * p).within(soft**2) / 4, (p * p * p).within(0.385 * soft**3) / 16)
    ahead_at_clamp(quartic)
    # What the series leaves out: the next terms, twice.
    z = places[0]
    a, b = soft**2 / 4 * z**4 / 20, (0.25 / 12 + 0.385 / 16) * soft**3 * z**6 / 28
    cut = (2 * a**3 / 3 + b * b) / 13 if number == 2 else a * a * b + a**4
    # An error of ℘(z) is one of the length by as much over ℘′(z), which is doubled up to 1; |θ_σ| ≤ 2k.
    total = 2 * slow * (doublings.start + 2 * cut / z**2) / least_slope(slow, z) / z
    for (above, below), z in zip(doublings.losses[:-1], places[1:], strict=True):
        wrong = above + most_ahead(slow, z) * (below + unit)
        total += 2 * slow * wrong / least_slope(slow, z) / z
    # The arc tangent, of p/4 and ℘ − c; the root of the sum of their squares is no less than this.
    above, below = doublings.losses[-1]
    total += 2 * (above * 2 * growth / soft + below + 2 * unit)
    # The tip as rounded is another tip; p, q, m and β cos φ as rounded are those of another rod.
    return 1.02 * total + unit * (24.3 * (growth + 1) + 30.7 * growth + 16 * pi)
