"""Weierstrass functions of real invariants with three real half-period values, by theta series (DLMF 23.6(i), 20.2).

The lattice has the half-periods ω₁ > 0 and ω₃ = i·(a positive number). Where |ω₃| < ω₁ it is turned by a right angle,
λ = i: ℘(u) = −℘̂(iu), ζ(u) = iζ̂(iu), σ(u) = −iσ̂(iu) (DLMF 23.10(iv)), so that the nome q is at most e^{−π} and a few
terms suffice. Arguments are reduced to the cell around 0, where |q^{2n}cos 2x| decreases like q^{2n−1}.
"""

from __future__ import annotations

from typing import NamedTuple

from derive.emit.kernels.agm import half_period
from derive.emit.kernels.arithmetic import atan2, ceil, cos, epsilon, exp, log, pi, sin, sqrt
from derive.emit.kernels.array_arithmetic import (
    each_cos,
    each_exp,
    each_floor,
    each_imag,
    each_log,
    each_real,
    each_sin,
    each_where,
)
from derive.emit.kernels.carlson import rf

LOST = 64  # a discriminant of so many roundings is no number that is known


class Lattice(NamedTuple):
    """The cell of the series: half-periods first and i·second, with first ≤ second, and ``turned`` if λ = i."""

    first: float
    second: float
    turned: bool
    zeta_first: float  # ζ̂(first)
    powers: tuple[float, ...]  # q², q⁴, … as far as they count


class Cell(NamedTuple):
    """An argument in the cell: w = λu less 2m·first + 2n·i·second, and x = πw/(2·first)."""

    w: complex
    x: complex
    m: float
    n: float


def half_period_values(g2, g3):
    """e₁ > e₂ > e₃ by the cosine of a third of an angle (DLMF 23.3(i), 1.11(iii)), and the gaps e₁ − e₂, e₂ − e₃.

    Raises ValueError where g₂³ − 27g₃² is not positive beyond its rounding errors: two values meet, and a period of ℘
    is infinite, or two are complex.
    """
    cube = g2**3
    discriminant = cube - 27 * g3**2
    if not discriminant > LOST * epsilon() * abs(cube):
        raise ValueError(f"the discriminant of g2 = {g2}, g3 = {g3} is not positive: two half-period values meet")
    size, root, real = sqrt(g2 / 3), sqrt(discriminant), sqrt(27) * g3
    # The angle and its distance from π/3, each precise where it is small.
    angle, rest = atan2(root, real) / 3, atan2(root, -real) / 3
    values = (size * cos(angle), size * cos(angle - 2 * pi / 3), size * cos(angle + 2 * pi / 3))
    return values, sqrt(3) * size * sin(rest), sqrt(3) * size * sin(angle)


def half_periods(g2, g3):
    """ω₁ and ω₃/i, by the arithmetic-geometric mean (DLMF 23.22(ii)); errors as in ``half_period_values``."""
    _, upper, lower = half_period_values(g2, g3)
    whole = sqrt(upper + lower)
    return half_period(whole, sqrt(upper)), half_period(whole, sqrt(lower))


def lattice_of(g2, g3):
    """The cell of the lattice of g₂, g₃."""
    omega_1, omega_3 = half_periods(g2, g3)
    turned = omega_3 < omega_1
    first, second = (omega_3, omega_1) if turned else (omega_1, omega_3)
    square = exp(-2 * pi * second / first)
    # The last term that counts is of the size of q^{2n−1}.
    count = ceil(log(epsilon()) / log(square) + 1.5)
    powers = tuple(square**n for n in range(1, count + 1))
    # DLMF 23.8.5 with q^{2n}/(1 − q^{2n})² summed by rows.
    total = sum(power / (1 - power) ** 2 for power in powers)
    return Lattice(first, second, turned, pi * pi / (12 * first) * (1 - 24 * total), powers)


def zeta_second(lattice):
    """ζ̂(i·second)/i, by Legendre's relation (DLMF 23.2.14)."""
    return (lattice.zeta_first * lattice.second - pi / 2) / lattice.first


def cell_of(u, lattice):
    """The argument u in the cell around 0, elementwise."""
    w = 1j * u if lattice.turned else u + 0j
    m = each_floor(each_real(w) / (2 * lattice.first) + 0.5)
    n = each_floor(each_imag(w) / (2 * lattice.second) + 0.5)
    w = w - 2 * lattice.first * m - 2j * lattice.second * n
    return Cell(w, pi / (2 * lattice.first) * w, m, n)


def wp(u, g2, g3):
    """℘(u; g₂, g₃) for complex u, elementwise (DLMF 23.8.1, its rows summed: 20.5(ii)).

    At a lattice point, where ℘ is infinite, a number so large that its inverse is 0 to rounding.
    """
    lattice = lattice_of(g2, g3)
    x = cell_of(u, lattice).x
    cosine, sine = each_cos(2 * x), each_sin(x)
    value = 1 / each_where(sine == 0, epsilon() ** 2, sine) ** 2
    for q in lattice.powers:
        below = 1 - 2 * q * cosine + q * q
        value = value - 8 * q * ((1 + q * q) * cosine - 2 * q) / below**2
    value = (pi / (2 * lattice.first)) ** 2 * value - lattice.zeta_first / lattice.first
    return -value if lattice.turned else value


def wp_prime(u, g2, g3):
    """℘′(u; g₂, g₃), by the derivative of the series of ``wp``."""
    lattice = lattice_of(g2, g3)
    x = cell_of(u, lattice).x
    cosine, sine = each_cos(2 * x), each_sin(2 * x)
    value = -2 * each_cos(x) / each_sin(x) ** 3
    for q in lattice.powers:
        below, even = 1 - 2 * q * cosine + q * q, 1 + q * q
        value = value + 16 * q * sine * (even**2 + 2 * q * even * cosine - 8 * q * q) / below**3
    value = (pi / (2 * lattice.first)) ** 3 * value
    return -1j * value if lattice.turned else value


def wzeta(u, g2, g3):
    """ζ(u; g₂, g₃) for complex u, elementwise (DLMF 23.8.2, its rows summed); no value at lattice points."""
    lattice = lattice_of(g2, g3)
    cell = cell_of(u, lattice)
    value = each_cos(cell.x) / each_sin(cell.x)
    for q in lattice.powers:
        value = value + 4 * q * each_sin(2 * cell.x) / (1 - 2 * q * each_cos(2 * cell.x) + q * q)
    value = pi / (2 * lattice.first) * value + lattice.zeta_first / lattice.first * cell.w
    value = value + 2 * lattice.zeta_first * cell.m + 2j * zeta_second(lattice) * cell.n
    return 1j * value if lattice.turned else value


def wsigma(u, g2, g3):
    """σ(u; g₂, g₃) for complex u, elementwise; large where u is many half-periods, and 0 at lattice points."""
    lattice = lattice_of(g2, g3)
    cell = cell_of(u, lattice)
    value = each_sin(cell.x)
    for q in lattice.powers:
        value = value * (1 - 2 * q * each_cos(2 * cell.x) + q * q) / (1 - q) ** 2
    parity = cell.m + cell.n + cell.m * cell.n
    sign = each_where(parity % 2 == 0, 1, -1)
    value = 2 * lattice.first / pi * sign * value * each_exp(gaussian(cell, lattice))
    return -1j * value if lattice.turned else value


def gaussian(cell, lattice):
    """The exponent of σ̂ before its theta series, w²η̂/(2·first) and what whole periods add to it (DLMF 23.2.15)."""
    eta_first, eta_second = lattice.zeta_first, 1j * zeta_second(lattice)
    shift = cell.w + lattice.first * cell.m + 1j * lattice.second * cell.n
    return eta_first / (2 * lattice.first) * cell.w**2 + 2 * (eta_first * cell.m + eta_second * cell.n) * shift


def wlog_sigma(u, g2, g3):
    """A logarithm of σ(u; g₂, g₃), continuous along every line parallel to the real axis that meets no zero of σ.

    In the cell the logarithms of the factors of the product have no jump (DLMF 20.5.1), with sin x as
    ±(i/2)e^{∓ix}(1 − e^{±2ix}) along the real axis. From cell to cell the phase of sin x turns by −π times the sign of
    Im x along that axis, and by π times the sign of Re x along the imaginary one, the way of u in a turned lattice.
    """
    lattice = lattice_of(g2, g3)
    cell = cell_of(u, lattice)
    m, n = cell.m, cell.n
    if lattice.turned:
        side = each_where(each_real(cell.x) < 0, -1, 1)
        value = each_log(side * each_sin(cell.x))
        turns = each_where(side < 0, 1, 0) + side * n + m * n + m - 0.5
    else:
        side = each_where(each_imag(cell.x) < 0, -1, 1)
        value = each_log(1 - each_exp(2j * side * cell.x)) - 1j * side * cell.x - log(2)
        turns = n - side * m - m * n + 0.5 * side
    for q in lattice.powers:
        value = value + each_log(1 - 2 * q * each_cos(2 * cell.x) + q * q) - 2 * log(1 - q)
    return value + gaussian(cell, lattice) + log(2 * lattice.first / pi) + 1j * pi * turns


def perimeter_point(c, g2, g3):
    """The point of the rectangle 0, ω₁, ω₂, ω₃ with ℘ = c, a real number; R_F on each side (DLMF 19.25.35)."""
    (e1, e2, e3), upper, lower = half_period_values(g2, g3)
    omega_1, omega_3 = half_periods(g2, g3)
    if c >= e1:
        return rf(c - e1, c - e2, c - e3) + 0j
    if c > e2:
        depth = upper * (upper + lower) / (e1 - c)
        return omega_1 + 1j * rf(depth, depth - upper, max(depth - upper - lower, 0))
    if c > e3:
        height = lower * (upper + lower) / (c - e3)
        return 1j * omega_3 + rf(max(height - upper - lower, 0), height - lower, height)
    return 1j * rf(e1 - c, e2 - c, e3 - c)
