"""Two symmetric integrals in balls, with their first derivatives: Gauss's mean and Carlson's R_F.

Both are reached by steps that only add, multiply and take roots of positive numbers, so a wide ball stays about as
narrow as what it holds. When the numbers of a step are all but equal is told by bounds that wide balls do not widen.
"""

from __future__ import annotations

from typing import Any

from flint import arb, arb_series

Series = Any  # arb_series: a value and its derivatives by the place, as Taylor coefficients
EQUAL = 1e-20  # numbers that differ by this share are told apart no more
SMALL = 1e-6  # of the differences of Carlson's arguments, as a share of their mean, at which his series ends
MOST = 400  # steps


class UndecidedError(ValueError):
    """Balls are too wide to tell."""


def first_order(value: Any, slope: Any = 0) -> Series:
    """A number and its derivative."""
    return arb_series([value, slope], 2)


def positive(*numbers: Series) -> None:
    """UndecidedError unless all values are."""
    if not all(number[0] > 0 for number in numbers):
        raise UndecidedError("a ball holds zero")


def gauss_mean(one: Series, other: Series) -> Series:
    """The arithmetic-geometric mean M.

    M lies between the two numbers of every step. A step takes their ratio k to 2√k/(1 + k), which grows with k: so the
    least ratio tells when all pairs in the balls are equal. Then ∂M/∂a and ∂M/∂b are within 3δ of ½ for k ≥ 1 − δ, as M
    is concave and homogeneous, and between the geometric and the arithmetic mean.
    """
    positive(one, other)
    ratio = min((other[0] / one[0]).lower(), (one[0] / other[0]).lower())
    for _ in range(MOST):
        if 1 - ratio < EQUAL:
            half = arb(0.5, 3 * EQUAL)
            mean = first_order(one[0].union(other[0]), half * one[1] + half * other[1])
            positive(mean)
            return mean
        if not ratio > 0:
            break
        product = one * other
        positive(product)
        one, other = (one + other) / 2, product.sqrt()
        ratio = (2 * ratio.sqrt() / (1 + ratio)).lower()
    raise UndecidedError("a mean's numbers are too far apart")


def carlson(root: Series, product: Series) -> Series:
    """R_F(1, Y, Z) by root = (√Y + √Z)² and product = YZ, for Y and Z real or conjugate (DLMF 19.26.18, 19.36.1).

    A step takes x, y, z to (x + λ)/4 …: the mean less x falls by 4, (mean − y)(mean − z) by 16, exactly. The series in
    E₂ and E₃ is that of (1 + E₂ − E₃)^(−1/2) with smaller coefficients: what is left out is no more than
    w³/(1 − w) + E₃², w = |E₂| + |E₃|, and its derivative no more than that of this.
    """
    positive(root, product)
    x, pair = first_order(1), root - 2 * product.sqrt()
    mean = (1 + pair) / 3
    ahead, others = mean - 1, mean * mean - mean * pair + product
    for _ in range(MOST):
        cross = x * root
        positive(cross)
        cross = cross.sqrt()
        pair, grown = (root + 2 * cross) / 4, x + cross + product.sqrt()
        x, product = grown / 4, root * grown / 16
        root = pair + 2 * product.sqrt()
        ahead, others, mean = ahead / 4, others / 16, (x + pair) / 3
        positive(mean, root, product)
        part, rest = ahead / mean, others / mean / mean
        if part[0].abs_upper() < SMALL and rest[0].abs_upper() < SMALL * SMALL:
            second, third = rest - part * part, part * rest
            series = 1 - second / 10 + third / 14 + second * second / 24 - 3 * second * third / 44
            return (series + _left_out(second, third)) / mean.sqrt()
    raise UndecidedError("an integral's numbers are too far apart")


def _left_out(second: Series, third: Series) -> Series:
    """What the series may lack, and its derivative."""
    size, cube = second[0].abs_upper() + third[0].abs_upper(), third[0].abs_upper()
    rate, cube_rate = second[1].abs_upper() + third[1].abs_upper(), third[1].abs_upper()
    lacks = size**3 / (1 - size) + cube * cube
    grows = (3 * size**2 / (1 - size) + size**3 / (1 - size) ** 2) * rate + 2 * cube * cube_rate
    return first_order(arb(0, lacks.upper()), arb(0, grows.upper()))
