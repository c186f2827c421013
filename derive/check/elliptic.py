"""Weierstrass functions at any complex argument and any complex invariants, by theta series (DLMF 23.6, 20.2).

Roots of the cubic → half-periods by the complex arithmetic-geometric mean → basis reduced so that |q| ≤ e^{−π√3/2}
→ argument reduced to the cell around 0 → a handful of terms of θ₁. The lattice is certified by computing its
invariants back. Everything runs in the precision of the caller, with guard digits; errors are relative to the
largest term, a few units of the last digit. DegenerateError invariants (g₂³ = 27g₃²) are refused.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import lru_cache, wraps
from typing import Any

from mpmath import mp

GUARD = 20  # digits beyond the caller's
Number = Any  # mpf or mpc
Function = Callable[..., Number]


class DegenerateError(ArithmeticError):
    """The invariants have a vanishing discriminant: no lattice."""


class PoleError(ArithmeticError):
    """The argument is a lattice point, where ℘, ℘′ and ζ are infinite."""


@dataclass(frozen=True)
class Lattice:
    """Half-periods ω₁, ω₃ with Im(ω₃/ω₁) > 0 and reduced, η₁ = ζ(ω₁), η₃ = ζ(ω₃), and the nome q = e^{iπω₃/ω₁}."""

    omega1: Number
    omega3: Number
    eta1: Number
    eta3: Number
    q: Number


def roots(g2: Number, g3: Number) -> list[Number]:
    """The roots of 4x³ − g₂x − g₃ to full relative precision of the largest (Cardano, then Newton)."""
    p, q = -g2 / 4, -g3 / 4
    scale = max(mp.sqrt(abs(p)), mp.cbrt(abs(q)))
    if scale == 0 or abs(g2**3 - 27 * g3**2) < scale**6 * mp.mpf(10) ** (-mp.dps // 2):
        raise DegenerateError(f"degenerate invariants g2 = {mp.nstr(g2, 8)}, g3 = {mp.nstr(g3, 8)}")
    with mp.extradps(15):
        root = mp.sqrt(q * q / 4 + p**3 / 27)
        cube = -q / 2 + root if abs(-q / 2 + root) >= abs(-q / 2 - root) else -q / 2 - root
        first = mp.root(mp.mpc(cube), 3)
        found = [first * turn for turn in (1, mp.expjpi(mp.mpf(2) / 3), mp.expjpi(mp.mpf(-2) / 3))]
        found = [t - p / (3 * t) for t in found]
        for _ in range(2):
            found = [x - (x**3 + p * x + q) / (3 * x**2 + p) for x in found]
    return found


def _agm(a: Number, b: Number) -> Number:
    """The arithmetic-geometric mean with the right choice of every root (|a − b| ≤ |a + b|), its optimal value."""
    for _ in range(200):
        if abs(a - b) > abs(a + b):
            b = -b
        if abs(a - b) <= abs(a) * mp.eps * 8:
            return (a + b) / 2
        a, b = (a + b) / 2, mp.sqrt(a * b)
    raise DegenerateError("the arithmetic-geometric mean does not converge")


def _reduce_basis(w1: Number, w3: Number) -> tuple[Number, Number]:
    """A basis of the same lattice with τ = ω₃/ω₁ in the fundamental domain."""
    if mp.im(w3 / w1) < 0:
        w3 = -w3
    for _ in range(1000):
        w3 = w3 - mp.nint(mp.re(w3 / w1)) * w1
        if abs(w3) >= abs(w1) * (1 - mp.mpf(10) ** -10):
            return w1, w3
        w1, w3 = w3, -w1
    raise DegenerateError("the period lattice cannot be reduced")


def _theta(z: Number, q: Number) -> tuple[Number, Number, Number, Number]:
    """Σ(−1)ⁿ qⁿ⁽ⁿ⁺¹⁾ sin((2n+1)z), which is θ₁/(2q^{1/4}), and its first three derivatives (DLMF 20.2.1)."""
    totals = [mp.mpf(0)] * 4
    largest = [mp.mpf(0)] * 4
    turn = mp.expj(z)
    inverse, factor, n = 1 / turn, mp.mpf(1), 0
    up, down = turn, inverse
    while True:
        k = 2 * n + 1
        sine, cosine = (up - down) / 2j, (up + down) / 2
        for order, value in enumerate((sine, k * cosine, -(k**2) * sine, -(k**3) * cosine)):
            totals[order] += factor * value
            largest[order] = max(largest[order], abs(factor * value))
        if abs(factor) * k**3 * (abs(up) + abs(down)) < mp.eps * max(min(largest[0], largest[1]), mp.mpf(10) ** -200):
            return totals[0], totals[1], totals[2], totals[3]
        n += 1
        factor = -factor * q ** (2 * n)
        up, down = up * turn * turn, down * inverse * inverse


def invariants(lattice: Lattice) -> tuple[Number, Number]:
    """g₂ and g₃ of a lattice by Eisenstein series (DLMF 23.8, 23.10), the way back that certifies the periods."""
    square = lattice.q**2
    e4, e6, power, n = mp.mpf(1), mp.mpf(1), square, 1
    while abs(power) * n**5 > mp.eps:
        e4 += 240 * n**3 * power / (1 - power)
        e6 -= 504 * n**5 * power / (1 - power)
        n, power = n + 1, power * square
    unit = mp.pi / (2 * lattice.omega1)
    return unit**4 * 4 / 3 * e4, unit**6 * 8 / 27 * e6


@lru_cache(maxsize=512)
def _lattice(g2: Number, g3: Number, dps: int) -> Lattice:
    with mp.workdps(dps + GUARD):
        e1, e2, e3 = sorted(roots(g2, g3), key=lambda e: (-mp.re(e), -mp.im(e)))
        a, b, c = mp.sqrt(e1 - e3), mp.sqrt(e1 - e2), mp.sqrt(e2 - e3)
        w1, w3 = _reduce_basis(mp.pi / (2 * _agm(a, b)), 1j * mp.pi / (2 * _agm(a, c)))
        q = mp.exp(1j * mp.pi * w3 / w1)
        _, first, _, third = _theta(mp.mpf(0), q)
        eta1 = -(mp.pi**2) / (12 * w1) * third / first
        eta3 = (eta1 * w3 - 1j * mp.pi / 2) / w1  # Legendre's relation, DLMF 23.2.14
        lattice = Lattice(w1, w3, eta1, eta3, q)
        back2, back3 = invariants(lattice)
        size = max(mp.sqrt(abs(g2)), mp.cbrt(abs(g3)))
        if max(abs(back2 - g2) / size**2, abs(back3 - g3) / size**3) > mp.mpf(10) ** (-dps):
            raise DegenerateError("the periods do not give the invariants back")
    return lattice


def lattice(g2: Number, g3: Number) -> Lattice:
    """The lattice of invariants g₂, g₃ in the current precision."""
    return _lattice(mp.convert(g2), mp.convert(g3), mp.dps)


def _reduced(u: Number, cell: Lattice) -> tuple[Number, int, int]:
    """u − 2mω₁ − 2nω₃ in the cell around 0, with m and n."""
    ratio, tau = mp.mpc(u) / (2 * cell.omega1), cell.omega3 / cell.omega1
    n = int(mp.nint(mp.im(ratio) / mp.im(tau)))
    m = int(mp.nint(mp.re(ratio - n * tau)))
    return u - 2 * m * cell.omega1 - 2 * n * cell.omega3, m, n


def _logarithmic(u: Number, g2: Number, g3: Number) -> tuple[Lattice, Number, int, int, list[Number]]:
    """Lattice, reduced argument, its shifts, and θ₁ with three derivatives at πu/(2ω₁)."""
    cell = lattice(g2, g3)
    small, m, n = _reduced(u, cell)
    if abs(small) < abs(cell.omega1) * mp.mpf(10) ** (-mp.dps + GUARD // 2):
        raise PoleError("the argument is a lattice point")
    return cell, small, m, n, list(_theta(mp.pi * small / (2 * cell.omega1), cell.q))


def kept(function: Function) -> Function:
    """The function with its last values kept: the same points come again with each variant of a formula."""

    @lru_cache(maxsize=4096)
    def known(dps: int, *args: Number) -> Number:
        return function(*args)

    @wraps(function)
    def called(*args: Number) -> Number:
        return known(mp.dps, *args)

    return called


@kept
def wp(u: Number, g2: Number, g3: Number) -> Number:
    """℘(u; g₂, g₃) = −η₁/ω₁ − (ln θ₁)″ (DLMF 23.6.14 in logarithmic form)."""
    with mp.extradps(GUARD):
        cell, _, _, _, (t, t1, t2, _) = _logarithmic(u, g2, g3)
        value = -cell.eta1 / cell.omega1 + (mp.pi / (2 * cell.omega1)) ** 2 * ((t1 / t) ** 2 - t2 / t)
    return _plain(value, u, g2, g3)


@kept
def wp_prime(u: Number, g2: Number, g3: Number) -> Number:
    """℘′(u; g₂, g₃) = −(ln θ₁)‴."""
    with mp.extradps(GUARD):
        cell, _, _, _, (t, t1, t2, t3) = _logarithmic(u, g2, g3)
        value = -((mp.pi / (2 * cell.omega1)) ** 3) * (t3 / t - 3 * t1 * t2 / t**2 + 2 * (t1 / t) ** 3)
    return _plain(value, u, g2, g3)


@kept
def wzeta(u: Number, g2: Number, g3: Number) -> Number:
    """ζ(u; g₂, g₃) = η₁u/ω₁ + (ln θ₁)′ (DLMF 23.6.13), with its quasi-periods (DLMF 23.2.11)."""
    with mp.extradps(GUARD):
        cell, small, m, n, (t, t1, _, _) = _logarithmic(u, g2, g3)
        value = cell.eta1 * small / cell.omega1 + mp.pi / (2 * cell.omega1) * t1 / t
        value += 2 * m * cell.eta1 + 2 * n * cell.eta3
    return _plain(value, u, g2, g3)


@kept
def wsigma(u: Number, g2: Number, g3: Number) -> Number:
    """σ(u; g₂, g₃) (DLMF 23.6.9), with its quasi-periodicity (DLMF 23.2.15); 0 at lattice points."""
    with mp.extradps(GUARD):
        cell = lattice(g2, g3)
        small, m, n = _reduced(u, cell)
        t = _theta(mp.pi * small / (2 * cell.omega1), cell.q)[0]
        unit = _theta(mp.mpf(0), cell.q)[1]
        value = 2 * cell.omega1 / mp.pi * mp.exp(cell.eta1 * small**2 / (2 * cell.omega1)) * t / unit
        shift = (2 * m * cell.eta1 + 2 * n * cell.eta3) * (small + m * cell.omega1 + n * cell.omega3)
        value *= (-1) ** (m * n + m + n) * mp.exp(shift)
    return _plain(value, u, g2, g3)


def wp_inverse(c: Number, slope: Number | None, g2: Number, g3: Number) -> Number:
    """A point v with ℘(v) = c, by R_F of c less the roots (DLMF 23.6.36 with 19.25.35), and ℘′(v) nearest slope."""
    with mp.extradps(GUARD):
        e1, e2, e3 = roots(g2, g3)
        v = mp.elliprf(c - e1, c - e2, c - e3)
        if slope is not None and abs(wp_prime(v, g2, g3) - slope) > abs(wp_prime(v, g2, g3) + slope):
            v = -v
    return +v


def _plain(value: Number, *inputs: Number) -> Number:
    """The value rounded to the caller's precision, real if everything that went in is real."""
    if all(mp.im(x) == 0 for x in inputs):
        return +mp.re(value)
    return +value
