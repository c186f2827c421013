"""The kernels by themselves: elliptic integrals and functions against mpmath, and the solver against brute force."""

from __future__ import annotations

import cmath
import math

import mpmath as mp
import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from derive.emit.kernels import arithmetic
from derive.emit.kernels.agm import half_period
from derive.emit.kernels.api import equilibria, shape, sweep
from derive.emit.kernels.arcs import rj_pair
from derive.emit.kernels.arithmetic_mpmath import arctan_share
from derive.emit.kernels.array_arithmetic import each_arctan_share
from derive.emit.kernels.carlson import rf
from derive.emit.kernels.landen import phase_at, swing_and_arrival
from derive.emit.kernels.roots import bracketed_root
from derive.measure.reference import Rod, solve
from derive.measure.scan import brute_force

ULP = 2.0**-52
PARALLEL = 0.0  # the field angle of all rods here
sizes = st.floats(-6, 6).map(lambda exponent: 10.0**exponent)
angles = st.floats(-6.5, 6.5)


def relative(value, exact):
    return float(abs((mp.mpf(float(value)) - exact) / exact))


@given(sizes | st.just(0.0), sizes, sizes)
@settings(max_examples=150, deadline=None)
def test_carlson_against_mpmath(x, y, z):
    """To a few units in the last place, over twelve orders of magnitude."""
    with mp.workdps(30):
        assert relative(rf(x, y, z), mp.elliprf(x, y, z)) < 4 * ULP


@given(sizes, st.floats(-3, 3), st.floats(0.01, 3), st.floats(0.05, 3), st.floats(-3, 3))
@settings(max_examples=150, deadline=None)
def test_the_integral_of_the_third_kind_with_a_pair(x, real, imaginary, p_imaginary, p_real):
    """R_J for a complex pair, by its product and sum of roots, and a complex p, against mpmath."""
    with mp.workdps(40):
        pair, p = mp.mpc(real, imaginary), mp.mpc(p_real, -p_imaginary)
        exact = mp.elliprj(x, pair, mp.conj(pair), p)
        product, root_sum = float(abs(pair)), float(2 * mp.re(mp.sqrt(pair)))
        twist = complex((p - x) * (p - pair) * (p - mp.conj(pair)))
        assume(abs(exact) * max(x, 1) ** 1.5 > 1e-6)
        value = rj_pair(x, product, root_sum, complex(p), complex(p + abs(pair)), complex(p - x), twist)
        assert abs(mp.mpc(value) - exact) < 1e-12 * abs(exact)


@given(st.floats(-14, 0), st.floats(0.001, 0.999), st.booleans())
@settings(max_examples=150, deadline=None)
def test_lengths_and_phases(exponent, part, swapped):
    """The incomplete integral against mpmath's, and the phase undone to the length that it came from."""
    a, b = (10.0**exponent, 1.0) if swapped else (1.0, 10.0**exponent)
    with mp.workdps(40):
        sine = mp.sin(part * mp.pi / 2) ** 2
        whole, length = swing_and_arrival(a, b, float(sine), float(1 - sine))
        exact = mp.ellipf(mp.pi * part / 2, 1 - (mp.mpf(b) / a) ** 2) / a
        assert relative(length, exact) < 16 * ULP * max(1, 1 / part) * max(1, 1 / (1 - part))
    square, rest = phase_at(a, b, length, whole - length)
    again = swing_and_arrival(a, b, square, rest)[1]
    assert abs(again - length) < 64 * ULP * whole


@given(st.integers(0, 140), st.floats(-3.1, 3.1), st.sampled_from([15, 50, 200, 400]))
def test_the_twin_s_arctangent_keeps_all_digits(exponent, phase, digits):
    """mpmath's own complex arctangent loses those that a small argument has less than 1."""
    with mp.workdps(digits + 200):
        z = mp.mpf(10) ** -exponent * mp.expjpi(phase / math.pi) / 2
        wanted = mp.atan(mp.sqrt(z)) / mp.sqrt(z)
    with mp.workdps(digits):
        found = arctan_share(z, 1 + z)
    with mp.workdps(digits + 200):
        assert abs(found / wanted - 1) < mp.mpf(10) ** (2 - digits)


@given(st.floats(-12, 3), st.floats(-3, 3))
def test_the_arctangent_of_numbers_keeps_its_digits(exponent, phase):
    """A logarithm of a number near 1 lost forty roundings of it."""
    z = 10.0**exponent * cmath.exp(1j * phase)
    with mp.workdps(40):
        root, end = mp.sqrt(mp.mpc(z)), complex(1 + mp.mpc(z))
        wanted = mp.atan(root) / root
        for found in (arithmetic.arctan_share(z, end), each_arctan_share(np.array([z]), np.array([end]))[0]):
            assert abs(mp.mpc(found) / wanted - 1) < 6 * ULP


@given(st.floats(-14, 0))
def test_half_period_is_the_complete_integral(exponent):
    b = 10.0**exponent
    with mp.workdps(40):
        assert relative(half_period(1.0, b), mp.elliprf(0, mp.mpf(b) ** 2, 1)) < 4 * ULP


def test_bracketed_root_finds_a_sign_change_to_rounding():
    for power in (1, 3, 9):
        values = ((-4 / 3) ** power, (5 / 3) ** power, (8 / 3) ** power)
        root = bracketed_root(lambda x, n=power: (x - 1 / 3) ** n, (-1.0, 2.0, 3.0), values, 0.0)
        assert abs(root - 1 / 3) < 1e-15


@given(st.lists(st.floats(-1, 1), min_size=5, max_size=5), st.floats(0.05, 0.95), st.integers(2, 5))
def test_bracketed_root_needs_few_values(coefficients, wanted, count):
    """Of a gently bent function; what is known of it besides saves further ones."""
    asked = []

    def function(x):
        asked.append(x)
        bend = sum(one * x ** (k + 2) for k, one in enumerate(coefficients)) / 40
        return x + bend - wanted - sum(one * wanted ** (k + 2) for k, one in enumerate(coefficients)) / 40

    places = (0.0, 1.0, 2.0, -1.0, 1.5)[:count]
    values = [function(place) for place in places]
    asked.clear()
    assert abs(bracketed_root(function, places, values, 0.0) - wanted) < 1e-14
    assert len(asked) <= 9


@pytest.mark.parametrize("jump", [1e-300, 1.0, 1e300])
def test_bracketed_root_halves_where_a_curve_tells_nothing(jump):
    """A step, wherever it is."""
    asked = []

    def function(x):
        asked.append(x)
        return jump if x > 0.7123 else -1.0

    assert abs(bracketed_root(function, (0.0, 1.0, 2.0), (-1.0, jump, jump), 0.0) - 0.7123) < 2e-15
    assert len(asked) < 160


@st.composite
def rods(draw, stiffest=12.0):
    """Moderate rods of every kind: field alone, force alone, both, short and long."""
    length = draw(st.floats(0.1, 100.0))
    stiffness = (draw(st.floats(0.05, stiffest)) / length) ** 2
    share = draw(st.floats(0, 1) | st.sampled_from([0.0, 1.0, 0.5]))
    return stiffness * share, stiffness * (1 - share), length, draw(angles)


@pytest.mark.parametrize(
    "rod",
    [
        (0.135039179399444, 0.13503917939945298, 5.702702710100172, -3.1415926535897922),
        (0.0301950610069599, 0.030195061006963675, 2.0857750943235094, 3.141592663589793),
    ],
)
def test_a_ridge_next_to_its_wells(rod):
    """η is above β by some roundings only: V is flat from well to well, and the rod is next to that with η = β."""
    beta, _, *rest = rod
    found, at_birth = equilibria(*rod, PARALLEL), equilibria(beta, beta, *rest, PARALLEL)
    assert [one.index for one in found] == [one.index for one in at_birth]
    assert [one.tip_angle for one in found] == pytest.approx([one.tip_angle for one in at_birth], abs=1e-6)


@given(rods())
@settings(max_examples=120, deadline=None)
def test_the_shape_satisfies_the_boundary_conditions(rod):
    """θ(0) is the clamp angle, θ′(ℓ) = 0, the ends lie where the equilibrium says; the number of solutions is odd."""
    beta, eta, length, clamp = rod
    found = equilibria(*rod, PARALLEL)
    assert len(found) % 2 == 1
    assert [one.tip_angle for one in found] == sorted(one.tip_angle for one in found)
    for one in found:
        ends = shape(one, [0.0, length])
        assert ends.theta == pytest.approx([clamp, one.tip_angle], abs=1e-12)
        assert ends.curvature[0] == pytest.approx(one.clamp_curvature, abs=1e-12 * math.sqrt(beta + eta))
        assert abs(ends.curvature[1]) < 1e-12 / length
        assert ends.y == pytest.approx([0, one.y], abs=1e-13 * length)
        assert ends.z == pytest.approx([0, one.z], abs=1e-13 * length)


@given(rods())
@settings(max_examples=60, deadline=None)
def test_the_first_integral_is_constant_and_the_rod_inextensible(rod):
    """κ² + 2β cos θ + η cos²θ = γ along the rod, and the chord between near points is the arc."""
    beta, eta, length, _ = rod
    for one in equilibria(*rod, PARALLEL):
        s = np.linspace(0, length, 400)
        bend = shape(one, s)
        xi = np.cos(bend.theta)
        drift = bend.curvature**2 + 2 * beta * xi + eta * xi**2 - one.gamma
        assert np.max(np.abs(drift)) < 1e-12 * (beta + eta)
        chords = np.hypot(np.diff(bend.y), np.diff(bend.z))
        steps = np.diff(s)
        bound = steps**3 * np.max(bend.curvature**2) / 12 + 1e-13 * length
        assert np.all(np.abs(chords - steps) < bound)


@given(rods(stiffest=6.0))
@settings(max_examples=8, deadline=None)
def test_no_equilibrium_is_missing(rod):
    """As many as brute force finds, at the same tip angles."""
    found = equilibria(*rod, PARALLEL)
    gaps = np.diff([one.tip_angle for one in found])
    assume(len(gaps) == 0 or gaps.min() > 1e-3)  # at a fold brute force counts as it likes
    assert [one.tip_angle for one in found] == pytest.approx(brute_force(Rod(*rod)), abs=1e-6)


@pytest.mark.long
@given(rods(stiffest=20.0))
@settings(max_examples=150, deadline=None)
def test_no_equilibrium_is_missing_in_many_rods(rod):
    found = equilibria(*rod, PARALLEL)
    gaps = np.diff([one.tip_angle for one in found])
    assume(len(gaps) == 0 or gaps.min() > 1e-4)
    assert [one.tip_angle for one in found] == pytest.approx(brute_force(Rod(*rod)), abs=1e-6)


HARD = {
    "clamp at the side, one well": (1.3, 0.4, 4.0, math.pi),
    "clamp at the side, two wells": (0.4, 1.3, 6.0, math.pi),
    "clamp at the side, wells about to part": (1.0, 1.0, 6.0, math.pi),
    "clamp near the side": (17.8, 37.2, 2.05, math.pi + 7e-9),
    "clamp near the side from below": (7.38, 2.08, 2.41, math.pi - 1e-11),
    "clamp at the bottom of a well": (0.0, 1.0, 13.7, math.pi / 2),
    "clamp near the bottom of a well": (0.0, 1.0, 13.7, math.pi / 2 + 1e-10),
    "clamp on the level": ((4 / 80) ** 2 / 3, 2 * (4 / 80) ** 2 / 3, 80.0, math.pi / 2),
    "clamp near the level": ((4 / 80) ** 2 / 3, 2 * (4 / 80) ** 2 / 3, 80.0, math.pi / 2 + 1e-13),
    "clamp near the top": (1.0, 0.5, 5.0, 1e-9),
    "clamp near the top from the other side": (1.0, 0.5, 5.0, -1e-9),
    "clamp several turns on": (1.0, 0.5, 5.0, 3 * math.pi / 4 + 8 * math.pi),
    "long rod under a field": (0.0, 1.0, 20.0, 3 * math.pi / 4),
    "long rod under a force": (1.0, 0.0, 20.0, 2.0),
    "short rod": (1.0, 1.0, 1e-6, 2.0),
    "weak force beside a field": (1e-9, 1.0, 9.0, 2.2),
    "weak field beside a force": (1.0, 1e-9, 9.0, 2.2),
}


@pytest.mark.parametrize("name", HARD)
def test_hard_rods_close_on_the_clamp(name):
    """Each solution of a hard rod starts at its clamp, in angle and in place."""
    beta, eta, length, clamp = HARD[name]
    found = equilibria(beta, eta, length, clamp, PARALLEL)
    assert len(found) % 2 == 1
    for one in found:
        ends = shape(one, np.array([0.0, length]))
        assert ends.theta[0] == pytest.approx(clamp, abs=1e-11 * max(1, clamp))
        assert ends.y[0] == pytest.approx(0, abs=1e-13 * length)
        assert ends.z[0] == pytest.approx(0, abs=1e-13 * length)


@pytest.mark.parametrize("count", [(5.0, 3), (10.0, 5), (20.0, 11)], ids=lambda pair: str(pair[0]))
def test_the_number_of_solutions_grows_with_the_length(count):
    """Known numbers for a field alone and a clamp at 3π/4."""
    length, wanted = count
    assert len(equilibria(0.0, 1.0, length, 3 * math.pi / 4, PARALLEL)) == wanted


def test_a_rod_without_loads_is_straight():
    (only,) = equilibria(0.0, 0.0, 3.0, 0.7, PARALLEL)
    assert (only.tip_angle, only.index, only.energy) == (0.7, 0, 0.0)
    bend = shape(only, 1.5)
    assert (float(bend.theta), float(bend.curvature)) == (0.7, 0.0)
    assert (bend.y, bend.z) == pytest.approx((1.5 * math.cos(0.7), 1.5 * math.sin(0.7)), rel=1e-15)


def test_buckling_under_a_push_follows_the_critical_loads():
    """Against the force (clamp π) the straight rod loses stability at ℓ√β = (k + ½)π, each time by two solutions."""
    for k in range(4):
        critical = (k + 0.5) * math.pi
        below, above = (equilibria(1.0, 0.0, critical * scale, math.pi, PARALLEL) for scale in (0.999, 1.001))
        assert (len(below), len(above)) == (2 * k + 1, 2 * k + 3)
        straight = [one for one in above if one.tip_angle == math.pi]
        assert [one.index for one in straight] == [k + 1]


def test_stability_against_the_reference():
    """The index counts the conjugate points of an integrated variation."""
    rod = Rod(0.3, 1.1, 9.0, 2.4)
    for one in equilibria(rod.beta, rod.eta, rod.length, rod.clamp_angle, PARALLEL):
        assert one.index == solve(rod, one.tip_angle).index


def test_sweep_is_the_flat_list_of_the_rods():
    eta = np.linspace(0, 0.001, 7)
    flat = sweep(0.00035, eta, 80.0, 3 * math.pi / 4, PARALLEL)
    rods = [equilibria(0.00035, float(value), 80.0, 3 * math.pi / 4, PARALLEL) for value in eta]
    assert flat.case.tolist() == [case for case, found in enumerate(rods) for _ in found]
    for name in ("tip_angle", "clamp_curvature", "gamma", "y", "z", "energy", "index"):
        assert getattr(flat, name).tolist() == [getattr(one, name) for found in rods for one in found]
