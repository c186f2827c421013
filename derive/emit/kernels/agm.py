"""Elliptic functions on the real axis from the arithmetic-geometric mean (DLMF 19.8(i), 22.20(ii))."""

from __future__ import annotations

from derive.emit.kernels.arithmetic import epsilon, pi, sqrt
from derive.emit.kernels.array_arithmetic import each_cos, each_max, each_sin, each_sqrt, each_where


def agm(a, b):
    """Arithmetic-geometric mean of a ≥ b > 0, as the list of its steps (aₙ, bₙ); the last two agree to rounding."""
    steps = [(a, b)]
    while abs(a - b) > 4 * epsilon() ** 0.5 * a:
        a, b = (a + b) / 2, sqrt(a * b)
        steps.append((a, b))
    steps.append(((a + b) / 2, sqrt(a * b)))
    return steps


def half_period(steps):
    """Real half-period ω₁ of ℘ from the mean's steps, started at a = √(e₁ − e₃), b = √(e₁ − e₂) (DLMF 23.6.34)."""
    return pi / (2 * steps[-1][0])


def root_ratios(steps, u):
    """1/√(℘ − e₃), √((℘ − e₁)/(℘ − e₃)) and √((℘ − e₂)/(℘ − e₃)) at 0 ≤ u ≤ ω₁, elementwise in u.

    In Jacobi's letters sn/a, cn, dn. At the end of the mean they are circular; each step back is Gauss's
    transformation (DLMF 22.7(ii)) written without a difference of near numbers, so that cn keeps its relative
    precision where it is exponentially small; near u = 0, where its distance from 1 counts, it follows from sn.
    """
    mean = steps[-1][0]
    r, c = each_sin(mean * u) / mean, each_cos(mean * u)
    for (a, b), (a_next, _) in zip(steps[-2::-1], steps[:0:-1], strict=True):
        half_gap = (a - b) / 2
        below = c * c / (1 + a_next * r) + b * r
        scale = 1 + a_next * half_gap * r * r
        r, c = r / scale, c * each_sqrt(below * (1 + half_gap * r)) / scale
        sine = a * r
        c = each_where(sine < 0.7, each_sqrt((1 + sine) * each_max(1 - sine, 0)), c)
    b = steps[0][1]
    return r, c, each_sqrt(c * c + b * b * r * r)
