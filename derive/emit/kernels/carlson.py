"""Carlson's symmetric integral of the first kind for one set of real arguments (DLMF 19.36(i))."""

from __future__ import annotations

from derive.emit.kernels.arithmetic import epsilon, sqrt


def rf(x, y, z):
    """R_F(x, y, z) for real x, y, z ≥ 0, at most one of them zero, by duplication.

    Each step takes a quarter of the spread; the last terms are the Taylor polynomial of degree 7 in the spread
    (DLMF 19.36.1), so the steps stop when its first omitted term is below rounding.
    """
    start = mean = (x + y + z) / 3
    reach = max(abs(mean - x), abs(mean - y), abs(mean - z)) / (3 * epsilon()) ** 0.125
    first, second = mean - x, mean - y
    scale = 1
    while reach > abs(mean) * scale:
        root_x, root_y, root_z = sqrt(x), sqrt(y), sqrt(z)
        shift = root_x * root_y + root_x * root_z + root_y * root_z
        x, y, z, mean = (x + shift) / 4, (y + shift) / 4, (z + shift) / 4, (mean + shift) / 4
        scale *= 4
    if start == mean and reach == 0:
        return 1 / sqrt(mean)
    a, b = first / (scale * mean), second / (scale * mean)
    c = -a - b
    e2, e3 = a * b - c * c, a * b * c
    series = (
        e2 * (e2 * (1 - 15 * e2 / 26) / 24 - 3 * e3 / 44) - e2 / 10 + e3 / 14 + 3 * e3 * e3 / 104 + e2 * e2 * e3 / 16
    )
    return (1 + series) / sqrt(mean)
