"""The Weierstrass functions of the emitted modules: against the checker's, against FLINT, and by identities."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from mpmath import mp

from derive.check import elliptic
from derive.emit.kernels import weierstrass as kernel

ULP = 2.0**-52
NAMES = ("wp", "wp_prime", "wzeta", "wsigma")
# Gaps e₁ − e₂ and e₂ − e₃ over twelve orders of magnitude; arguments in half-periods, off the lattice.
gaps = st.tuples(st.floats(-3, 3), st.floats(-3, 3)).map(lambda e: (10.0 ** e[0], 10.0 ** e[1]))
places = st.tuples(st.floats(-3, 3), st.floats(-3, 3)).filter(
    lambda p: abs(p[0] - 2 * round(p[0] / 2)) > 0.1 or abs(p[1] - 2 * round(p[1] / 2)) > 0.1
)


def invariants(upper, lower):
    """g₂ and g₃ from the gaps between the half-period values, and what share of g₂³ the discriminant is."""
    e1, e3 = (2 * upper + lower) / 3, -(upper + 2 * lower) / 3
    e2 = -e1 - e3
    g2, g3 = -4 * (e1 * e2 + e1 * e3 + e2 * e3), 4 * e1 * e2 * e3
    return g2, g3, 1 - 27 * g3**2 / g2**3


def point(place, g2, g3):
    omega_1, omega_3 = kernel.half_periods(g2, g3)
    return complex(place[0] * omega_1, place[1] * omega_3)


def quasi_periods(g2, g3):
    """η₁ = ζ(ω₁) and η₃/i = ζ(ω₃)/i."""
    lattice = kernel.lattice_of(g2, g3)
    if lattice.turned:
        return -kernel.zeta_second(lattice), -lattice.zeta_first
    return lattice.zeta_first, kernel.zeta_second(lattice)


@given(gaps, places)
@settings(max_examples=60, deadline=None)
def test_against_the_checker(sizes, place):
    """Off by a few roundings over the share of the discriminant: g₂ and g₃ know the small gap no better."""
    g2, g3, share = invariants(*sizes)
    u = point(place, g2, g3)
    for name in NAMES:
        with mp.workdps(30):
            exact = getattr(elliptic, name)(mp.mpc(u), mp.mpf(g2), mp.mpf(g3))
        value = getattr(kernel, name)(np.array([u]), g2, g3)[0]
        assert abs(value - complex(exact)) <= 2000 * ULP / share * (abs(complex(exact)) + size_of(name, g2))


def size_of(name, g2):
    """What a value near zero is compared with: the power of the half-period that it has the dimension of."""
    return g2 ** {"wp": 0.5, "wp_prime": 0.75, "wzeta": 0.25, "wsigma": -0.25}[name]


def test_against_flint():
    flint = pytest.importorskip("flint")
    rng = np.random.default_rng(5)
    for upper, lower in ((1.0, 1.0), (3.0, 0.2), (0.02, 1.5)):
        g2, g3, _ = invariants(upper, lower)
        omega_1, omega_3 = kernel.half_periods(g2, g3)
        tau = flint.acb(0, omega_3 / omega_1)
        for place in rng.uniform(0.2, 1.8, (5, 2)):
            u = point(place, g2, g3)
            z, whole = flint.acb(u.real, u.imag) / (2 * omega_1), 2 * omega_1
            assert abs(kernel.wp(u, g2, g3) - complex(z.elliptic_p(tau)) / whole**2) < 1e-13 * g2**0.5
            assert abs(kernel.wzeta(u, g2, g3) - complex(z.elliptic_zeta(tau)) / whole) < 1e-13 * g2**0.25
            exact = complex(z.elliptic_sigma(tau)) * whole
            assert abs(kernel.wsigma(u, g2, g3) - exact) < 1e-13 * abs(exact)
            assert abs(np.exp(kernel.wlog_sigma(u, g2, g3)) - exact) < 1e-13 * abs(exact)


@given(gaps, places)
@settings(max_examples=60, deadline=None)
def test_identities(sizes, place):
    """℘′² by ℘, Legendre's relation, ζ and σ over whole periods (DLMF 23.2.14, 23.2.15), e^(ln σ) = σ."""
    g2, g3, share = invariants(*sizes)
    u, loss = point(place, g2, g3), 4000 * ULP / share
    p, slope = kernel.wp(u, g2, g3), kernel.wp_prime(u, g2, g3)
    assert abs(slope**2 - (4 * p**3 - g2 * p - g3)) <= loss * (4 * abs(p) ** 3 + g2**1.5)
    (omega_1, omega_3), (eta_1, eta_3) = kernel.half_periods(g2, g3), quasi_periods(g2, g3)
    assert abs(eta_1 * omega_3 - eta_3 * omega_1 - np.pi / 2) < 8 * ULP * (1 + abs(eta_1 * omega_3))
    for period, turn in ((omega_1, eta_1), (1j * omega_3, 1j * eta_3)):
        here, there = kernel.wzeta(u, g2, g3), kernel.wzeta(u + 2 * period, g2, g3)
        assert abs(there - here - 2 * turn) <= loss * (abs(here) + abs(there) + abs(turn))
        sigma = kernel.wsigma(u, g2, g3)
        moved = -np.exp(2 * turn * (u + period)) * sigma
        assert abs(kernel.wsigma(u + 2 * period, g2, g3) - moved) <= loss * 10 * abs(moved)
        assert abs(np.exp(kernel.wlog_sigma(u, g2, g3)) - sigma) <= loss * 10 * abs(sigma)


def test_at_a_lattice_point_the_inverse_is_nothing():
    g2, g3, _ = invariants(1.0, 2.0)
    assert abs(1 / kernel.wp(np.array([0.0, 0.1]), g2, g3)[0]) < 1e-40


@given(gaps)
@settings(max_examples=40, deadline=None)
def test_half_periods_are_where_they_are_called(sizes):
    """℘ there is e₁, e₂, e₃, and ℘′ vanishes."""
    g2, g3, share = invariants(*sizes)
    omega_1, omega_3 = kernel.half_periods(g2, g3)
    values = kernel.half_period_values(g2, g3)[0]
    for u, value in zip((omega_1, omega_1 + 1j * omega_3, 1j * omega_3), values, strict=True):
        assert abs(kernel.wp(u, g2, g3) - value) < 100 * ULP / share * g2**0.5


@pytest.mark.parametrize("height", [0.3, -0.4, 1.0, 1.7, -1.2, 2.5])
@pytest.mark.parametrize("sizes", [(1.0, 1.0), (1e-4, 1.0), (1.0, 1e-4), (1.0, 3.0), (3.0, 1.0)])
def test_the_logarithm_has_no_jump(sizes, height):
    """Along a line parallel to the real axis, over seven periods, its slope is ζ; the principal value jumps there."""
    g2, g3, _ = invariants(*sizes)
    omega_1, omega_3 = kernel.half_periods(g2, g3)
    u = np.linspace(-7 * omega_1, 7 * omega_1, 4001) + 1j * height * omega_3
    value, slope = kernel.wlog_sigma(u, g2, g3), kernel.wzeta(u, g2, g3)
    step = (slope[1:] + slope[:-1]) / 2 * np.diff(u)
    assert np.abs(np.diff(value) - step).max() < 0.05


@given(gaps, st.floats(0.05, 0.95), st.integers(0, 3))
@settings(max_examples=60, deadline=None)
def test_perimeter_point(sizes, part, side):
    """On each side of the rectangle ℘ is the number that was given, and the point lies on that side."""
    g2, g3, share = invariants(*sizes)
    e1, e2, e3 = kernel.half_period_values(g2, g3)[0]
    size = g2**0.5
    c = (e1 + part * size, e2 + part * (e1 - e2), e3 + part * (e2 - e3), e3 - part * size)[side]
    v = kernel.perimeter_point(c, g2, g3)
    assert abs(kernel.wp(v, g2, g3) - c) < 1000 * ULP / share * size
    omega_1, omega_3 = kernel.half_periods(g2, g3)
    on = ((v.imag, 0), (v.real, omega_1), (v.imag, omega_3), (v.real, 0))[side]
    assert on[0] == on[1]


@pytest.mark.parametrize(("g2", "g3"), [(3.0, 1.0), (3.0, -1.0), (1.0, 1.0), (0.0, 1.0), (-1.0, 0.0)])
def test_values_that_meet_are_refused(g2, g3):
    with pytest.raises(ValueError, match="two half-period values meet"):
        kernel.half_periods(g2, g3)
