"""The arithmetic-geometric mean, for the periods of ℘ (DLMF 19.8(i))."""

from __future__ import annotations

from derive.emit.kernels.arithmetic import epsilon, pi, sqrt


def agm(a, b):
    """Arithmetic-geometric mean of a ≥ b > 0."""
    while abs(a - b) > 4 * epsilon() ** 0.5 * a:
        a, b = (a + b) / 2, sqrt(a * b)
    return ((a + b) / 2 + sqrt(a * b)) / 2


def half_period(a, b):
    """Real half-period ω₁ of ℘ from a = √(e₁ − e₃) and b = √(e₁ − e₂) (DLMF 23.6.34)."""
    return pi / (2 * agm(a, b))
