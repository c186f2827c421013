"""Weierstrass functions of the checker against routes that share nothing with theta series."""

from __future__ import annotations

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from mpmath import mp

from derive.check import elliptic
from derive.check.elliptic import DegenerateError, PoleError, wp, wp_inverse, wp_prime, wsigma, wzeta

DIGITS = 30
CLOSE = mp.mpf(10) ** -26

# (g2, g3): discriminant positive, negative, nearly zero; one invariant zero; complex.
INVARIANTS = [
    (mp.mpf(7), mp.mpf(2)),
    (mp.mpf(1), mp.mpf(3)),
    (mp.mpf(-5), mp.mpf(1)),
    (mp.mpf(3), mp.mpf(1) - mp.mpf(10) ** -9),
    (mp.mpf(3), mp.mpf(1) + mp.mpf(10) ** -9),
    (mp.mpf(4), mp.mpf(0)),
    (mp.mpf(0), mp.mpf(-2)),
    (mp.mpc(1, 2), mp.mpc(-3, 1)),
]
POINTS = [mp.mpf("0.37"), mp.mpf("-2.9"), mp.mpc("0.4", "1.7"), mp.mpc("-8.3", "5.1")]


@pytest.fixture(autouse=True)
def _digits():
    with mp.workdps(DIGITS):
        yield


def near(a, b, scale=1):
    return abs(a - b) <= CLOSE * max(abs(a), abs(b), abs(scale))


def laurent(u, g2, g3):
    """℘, ℘′, ζ by Laurent series (DLMF 23.9) at u/2ⁿ and n duplications (DLMF 23.10.7-9)."""
    with mp.workdps(90):
        halvings = 0
        while abs(u) / 2**halvings > mp.mpf("0.02") / (1 + abs(g2) + abs(g3)) ** mp.mpf("0.25"):
            halvings += 1
        z = u / mp.mpf(2) ** halvings
        c = {2: g2 / 20, 3: g3 / 28}
        for n in range(4, 40):
            c[n] = 3 * mp.fsum(c[m] * c[n - m] for m in range(2, n - 1)) / ((2 * n + 1) * (n - 3))
        p = z**-2 + mp.fsum(c[n] * z ** (2 * n - 2) for n in c)
        d = -2 * z**-3 + mp.fsum((2 * n - 2) * c[n] * z ** (2 * n - 3) for n in c)
        zeta = 1 / z - mp.fsum(c[n] * z ** (2 * n - 1) / (2 * n - 1) for n in c)
        for _ in range(halvings):
            second = 6 * p * p - g2 / 2
            slope = second / d
            new = slope**2 / 4 - 2 * p
            zeta = 2 * zeta + slope / 2
            d = -d - slope * (new - p)
            p = new
    return +p, +d, +zeta


@pytest.mark.parametrize(("g2", "g3"), INVARIANTS)
@pytest.mark.parametrize("u", POINTS)
def test_series_and_duplication(u, g2, g3):
    p, d, zeta = laurent(u, g2, g3)
    assert near(wp(u, g2, g3), p)
    assert near(wp_prime(u, g2, g3), d)
    assert near(wzeta(u, g2, g3), zeta)


def test_lattice_sum():
    # ℘ = u⁻² + Σ′ [(u − w)⁻² − w⁻²] over a square of periods; the tail falls as 1/N².
    cell = elliptic.lattice(mp.mpf(4), mp.mpf(0))
    u = mp.mpc("0.3", "0.2")

    def partial(size):
        total = u**-2
        for m in range(-size, size + 1):
            for n in range(-size, size + 1):
                if (m, n) != (0, 0):
                    w = 2 * m * cell.omega1 + 2 * n * cell.omega3
                    total += (u - w) ** -2 - w**-2
        return total

    with mp.workdps(15):
        coarse, fine = partial(6), partial(12)
        exact = wp(u, mp.mpf(4), mp.mpf(0))
        assert abs(fine - exact) < 1e-3
        assert abs(fine - exact) < abs(coarse - exact) / 3


@pytest.mark.parametrize(("g2", "g3"), INVARIANTS)
@pytest.mark.parametrize("u", POINTS)
def test_differential_equation(u, g2, g3):
    p = wp(u, g2, g3)
    assert near(wp_prime(u, g2, g3) ** 2, 4 * p**3 - g2 * p - g3, 4 * abs(p) ** 3)


@pytest.mark.parametrize(("g2", "g3"), INVARIANTS)
def test_derivatives(g2, g3):
    u = mp.mpc("0.61", "0.27")
    slope = mp.diff(lambda x: wzeta(x, g2, g3), u)
    assert abs(slope + wp(u, g2, g3)) < mp.mpf(10) ** -20 * abs(slope)
    logarithmic = mp.diff(lambda x: wsigma(x, g2, g3), u) / wsigma(u, g2, g3)
    assert abs(logarithmic - wzeta(u, g2, g3)) < mp.mpf(10) ** -20 * abs(logarithmic)


@pytest.mark.parametrize(("g2", "g3"), INVARIANTS)
def test_addition_theorems(g2, g3):
    u, v = mp.mpc("0.7", "0.2"), mp.mpc("-0.3", "1.1")
    pu, pv, du, dv = wp(u, g2, g3), wp(v, g2, g3), wp_prime(u, g2, g3), wp_prime(v, g2, g3)
    chord = (du - dv) / (pu - pv)
    assert near(wp(u + v, g2, g3), chord**2 / 4 - pu - pv)
    assert near(wzeta(u + v, g2, g3), wzeta(u, g2, g3) + wzeta(v, g2, g3) + chord / 2)
    product = wsigma(u + v, g2, g3) * wsigma(u - v, g2, g3)
    assert near(product, -(wsigma(u, g2, g3) ** 2) * wsigma(v, g2, g3) ** 2 * (pu - pv))


@pytest.mark.parametrize(("g2", "g3"), INVARIANTS)
def test_periods(g2, g3):
    cell, u = elliptic.lattice(g2, g3), mp.mpc("0.31", "0.12")
    for omega, eta in ((cell.omega1, cell.eta1), (cell.omega3, cell.eta3)):
        assert near(wp(u + 2 * omega, g2, g3), wp(u, g2, g3))
        # η is ζ at the half-period: by the series, which knows no periods.
        assert near(laurent(omega, g2, g3)[2], eta)
        shifted = -mp.exp(2 * eta * (u + omega)) * wsigma(u, g2, g3)
        assert near(wsigma(u + 2 * omega, g2, g3), shifted)
        assert abs(wp_prime(omega, g2, g3)) < CLOSE * 100 * (1 + abs(g2) + abs(g3))
    assert near(cell.eta1 * cell.omega3 - cell.eta3 * cell.omega1, 1j * mp.pi / 2)


@settings(max_examples=15, deadline=None)
@given(st.complex_numbers(min_magnitude=0.3, max_magnitude=3), st.integers(0, len(INVARIANTS) - 1))
def test_homogeneity(scale, k):
    with mp.workdps(DIGITS):
        (g2, g3), t, u = INVARIANTS[k], mp.mpc(scale), mp.mpc("0.41", "0.33")
        scaled = (t * u, g2 / t**4, g3 / t**6)
        assert near(wp(*scaled), wp(u, g2, g3) / t**2)
        assert near(wp_prime(*scaled), wp_prime(u, g2, g3) / t**3)
        assert near(wzeta(*scaled), wzeta(u, g2, g3) / t)
        assert near(wsigma(*scaled), t * wsigma(u, g2, g3))


@pytest.mark.parametrize(("g2", "g3"), INVARIANTS)
def test_inverse(g2, g3):
    for c in (mp.mpf("0.9"), mp.mpc(-2, 1), mp.mpf(-3)):
        v = wp_inverse(c, None, g2, g3)
        slope = wp_prime(v, g2, g3)
        assert near(wp(v, g2, g3), c)
        assert near(wp_prime(wp_inverse(c, -slope, g2, g3), g2, g3), -slope)


def test_real_arguments_give_real_values():
    for g2, g3 in INVARIANTS[:-1]:
        assert isinstance(wp(mp.mpf(2), g2, g3), mp.mpf)


def test_degenerate_invariants_and_poles_are_refused():
    with pytest.raises(DegenerateError):
        wp(mp.mpf(1), mp.mpf(3), mp.mpf(1))
    with pytest.raises(DegenerateError):
        wp(mp.mpf(1), mp.mpf(0), mp.mpf(0))
    with pytest.raises(PoleError):
        wzeta(mp.mpf(0), mp.mpf(4), mp.mpf(1))
    assert wsigma(mp.mpf(0), mp.mpf(4), mp.mpf(1)) == 0
