"""Carlson's integrals of the second and third kind, elementwise (DLMF 19.36(i); Carlson 1995; Johansson 2019)."""

from __future__ import annotations

from derive.emit.kernels.arithmetic import epsilon
from derive.emit.kernels.array_arithmetic import (
    each_abs,
    each_asinh,
    each_atan2,
    each_max,
    each_sqrt,
    each_where,
    largest,
)


def rc(x, y):
    """R_C(x, y) for x ≥ 0, y > 0 (DLMF 19.2.17)."""
    return rc_between(x, y, y - x)


def rc_between(x, y, gap):
    """R_C(x, y) with y − x = gap given: an inverse tangent or its hyperbolic sister (DLMF 19.2.18, 19.2.19)."""
    width = each_sqrt(each_where(gap == 0, y, each_abs(gap)))
    circular = each_atan2(width, each_sqrt(x)) / width
    hyperbolic = each_asinh(width / each_sqrt(y)) / width
    return each_where(gap == 0, 1 / each_sqrt(y), each_where(gap > 0, circular, hyperbolic))


def rd(x, y, z):
    """R_D(x, y, z) = R_J(x, y, z, z) for x, y ≥ 0, not both zero, z > 0, by duplication."""
    mean = (x + y + 3 * z) / 5
    a, b = mean - x, mean - y
    spread = each_max(each_max(each_abs(a), each_abs(b)), each_abs(mean - z))
    target = (epsilon() / 4) ** 0.125
    scale, total = 1, 0 * mean
    while largest(spread / mean) > target * scale:
        root_x, root_y, root_z = each_sqrt(x), each_sqrt(y), each_sqrt(z)
        shift = root_x * root_y + root_x * root_z + root_y * root_z
        total = total + 1 / (scale * root_z * (z + shift))
        x, y, z, mean = (x + shift) / 4, (y + shift) / 4, (z + shift) / 4, (mean + shift) / 4
        scale *= 4
    a, b = a / (scale * mean), b / (scale * mean)
    c = -(a + b) / 3
    return (1 + spread_series(a, b, c, c, c)) / (scale * mean * each_sqrt(mean)) + 3 * total


def rj(x, y, z, p):
    """R_J(x, y, z, p) for x, y, z ≥ 0, at most one zero, and p > 0, by duplication with R_C terms."""
    mean = (x + y + z + 2 * p) / 5
    a, b, c = mean - x, mean - y, mean - z
    spread = each_max(each_max(each_abs(a), each_abs(b)), each_max(each_abs(c), each_abs(mean - p)))
    target = (epsilon() / 4) ** 0.125
    scale, total = 1, 0 * mean
    gaps = (p - x, p - y, p - z)
    while largest(spread / mean) > target * scale:
        root_x, root_y, root_z, root_p = each_sqrt(x), each_sqrt(y), each_sqrt(z), each_sqrt(p)
        shift = root_x * root_y + root_x * root_z + root_y * root_z
        d_x, d_y, d_z = root_p + root_x, root_p + root_y, root_p + root_z
        e = gaps[0] / (scale * d_x * d_x) * (gaps[1] / (scale * d_y * d_y)) * (gaps[2] / (scale * d_z * d_z))
        # 1 + e as a product: p may be so small that the sum would cancel.
        end = 2 * root_p / d_x * ((p + shift) / (d_y * d_z))
        total = total + rc_between(1 + 0 * e, end, e) / (scale * d_x * d_y * d_z)
        x, y, z, p = (x + shift) / 4, (y + shift) / 4, (z + shift) / 4, (p + shift) / 4
        mean = (mean + shift) / 4
        scale *= 4
    a, b, c = a / (scale * mean), b / (scale * mean), c / (scale * mean)
    d = -(a + b + c) / 2
    return (1 + spread_series(a, b, c, d, d)) / (scale * mean * each_sqrt(mean)) + 6 * total


def spread_series(a, b, c, d, e):
    """Sum of the terms of degree 2 to 7 in the spread of five variables whose sum is zero (DLMF 19.36.2)."""
    s2 = (a * a + b * b + c * c + d * d + e * e) / 2
    s3 = (a**3 + b**3 + c**3 + d**3 + e**3) / 3
    s4 = (a**4 + b**4 + c**4 + d**4 + e**4) / 4
    s5 = (a**5 + b**5 + c**5 + d**5 + e**5) / 5
    # Elementary symmetric functions from the power sums (Newton's identities with e₁ = 0).
    e2, e3 = -s2, s3
    e4 = s2 * s2 / 2 - s4
    e5 = s5 - s2 * s3
    low = -3 * e2 / 14 + e3 / 6 + 9 * e2 * e2 / 88 - 3 * e4 / 22 - 9 * e2 * e3 / 52 + 3 * e5 / 26
    return (
        low - e2**3 / 16 + 3 * e3 * e3 / 40 + 3 * e2 * e4 / 20 + 45 * e2 * e2 * e3 / 272 - 9 * (e3 * e4 + e2 * e5) / 68
    )
