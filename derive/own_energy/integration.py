"""Taylor integration of a rod by its own law, from the tip to the clamp, in integer arithmetic.

The steps, their length and the count of negative directions are those of ``measure.taylor``; what is put into the
series here is the law of ``law``: no resultant, no turned axes, no formula of the solver.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import ceil, log, sqrt
from typing import Any

from mpmath import mp, mpf

from derive.measure.taylor import Path, Series, State, fixed, product, run, working_digits
from derive.own_energy.law import Trigonometric, at_loads, slope


class OwnSeries(Series):
    """Taylor coefficients of a State in σ; its angle is θ itself. Lengths are scaled by the size of all loads."""

    def __init__(self, law: dict[str, Any], loads: list[Any], field_angle: Any, bits: int, order: int) -> None:
        self.bits, self.order, self.scale = bits, order, mpf(size_of(loads))
        scaled = [load / self.scale**2 for load in loads]
        at = scaled, mp.cos(field_angle), mp.sin(field_angle), mpf
        couple = at_loads(law["couple"], *at)
        self.parts = [couple, slope(couple), at_loads(law["density"], *at)]
        self.terms = [{powers: fixed(value, bits) for powers, value in part.items()} for part in self.parts]
        wanted = {powers for part in self.parts for powers in part}
        # A power is made from the one below it.
        self.powers = sorted({(k, j) for i, j in wanted for k in range(i + 1)})

    def expand(self, at: State) -> tuple[list[int], ...]:
        """Coefficients of the nine components about a point, up to the order."""
        bits = self.bits
        angle, rate, c, s, h, h_rate, y, z, energy = series = tuple([component] for component in at)
        of: dict[tuple[int, int], list[int]] = {powers: [] for powers in self.powers} | {(1, 0): c, (0, 1): s}
        stiffness: list[int] = []
        for k in range(self.order):
            n = k + 1
            for i, j in self.powers:
                if (i, j) not in ((1, 0), (0, 1)):
                    one = (1 << bits) if k == 0 else 0
                    of[i, j].append(product(of[i - 1, j], c, k) >> bits if i else one)
            couple, bend, density = (_combined(part, of, k) >> bits for part in self.terms)
            stiffness.append(bend)
            angle.append(rate[k] // n)
            h.append(h_rate[k] // n)
            y.append(c[k] // n)
            z.append(s[k] // n)
            turn_s, turn_c = product(c, rate, k), product(s, rate, k)
            energy.append((((product(rate, rate, k) >> bits) >> 1) + density) // n)
            rate.append(couple // n)
            h_rate.append((product(stiffness, h, k) >> bits) // n)
            s.append((turn_s >> bits) // n)
            c.append(-(turn_c >> bits) // n)
        return series


def _combined(part: Trigonometric, of: dict[tuple[int, int], list[int]], k: int) -> int:
    """Coefficient k of a polynomial in cos θ and sin θ, not yet shifted back."""
    return sum(value * of[powers][k] for powers, value in part.items())


def size_of(loads: Sequence[Any]) -> float:
    """√Σ|load|, the unit of curvature; in which θ″ and its slope are at most 1."""
    return sqrt(sum(abs(float(load)) for load in loads)) or 1.0


def integrate(
    law: dict[str, Any], rod: Any, tip_angle: Any, digits: int, *, stops: Sequence[Any] = (), more_terms: int = 0
) -> Path:
    """Integrate to the clamp, stopping at the arc lengths ``stops`` from it; see ``measure.taylor.integrate``.

    rod: its loads in the order of the law, field_angle and length. The energy of a point is ∫(½θ′² + ψ(w) − β cos θ).
    """
    total = sum(abs(float(load)) for load in rod.loads)
    working = working_digits(total, 0, rod.length, digits)
    with mp.workdps(working + 5):
        bits = ceil(working * log(10, 2))
        loads = [mpf(load) for load in rod.loads]
        series = OwnSeries(law, loads, mpf(rod.field_angle), bits, ceil(1.15 * working) + more_terms)
        theta, length, one = mpf(tip_angle), mpf(rod.length), 1 << bits
        start = State(fixed(theta, bits), 0, fixed(mp.cos(theta), bits), fixed(mp.sin(theta), bits), one, 0, 0, 0, 0)
        ends = sorted({mpf(stop) for stop in stops} | {mpf(0)}, reverse=True)
        return run(series, start, theta, length, ends, mpf(0))
