"""Shapes at many points: the same as point by point, and right by Taylor integration."""

from __future__ import annotations

from functools import lru_cache
from math import pi

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from derive.emit.kernels import dense, expansion, lookup, runs
from derive.emit.kernels.equilibria import all_equilibria
from derive.emit.kernels.shapes import angle_and_position
from derive.emit.kernels.shortening import chebyshev, cut, shortened
from derive.measure.reference import Rod, refine, sensitivity
from derive.measure.taylor import integrate

ULP = 2.0**-52

# beta, eta, length, clamp angle, field angle, most negative directions: few swings, many, long ones.
RODS = {
    "field only": (0.0, 1.0, 12.0, 3 * pi / 4, 0.0, None),
    "force only": (1.0, 0.0, 9.0, 2.5, 0.0, None),
    "oblique": (0.3, 0.7, 10.0, 2.0, 0.4, None),
    "orthogonal": (0.2, 1.3, 15.0, -1.0, pi / 2, None),
    "other units": (0.00035, 0.00052, 80.0, 3 * pi / 4, 0.0, None),
    "beyond a turn": (0.3, 0.7, 10.0, 9.0, 0.4, None),
    "many swings": (0.0, 1.0, 60.0, 3 * pi / 4, 0.0, None),
    "straight stretches": (0.0, 1.0, 1000.0, 3 * pi / 4, 0.0, 3),
    "over the ridge": (0.1, 1.0, 60.0, 3.0, 0.0, 3),
    "all but straight": (1e-30, 1e-30, 80.0, 3 * pi / 4, 0.0, None),
    "short": (0.8, 0.2, 2e-6, 3 * pi / 4, pi / 2, None),
}


@lru_cache
def bent(*rod):
    """The bent equilibria of a rod."""
    return [one for one in all_equilibria(*rod) if one.swing is not None]


def allowed(equilibrium, s):
    """Roundings of θ, θ′, y and z: each way has those of its values and of s, which θ and θ′ follow."""
    rod, length = equilibrium.rod, np.ldexp(equilibrium.rod.length, -equilibrium.rod.scale)
    rate = np.ldexp(1.5, rod.scale)
    angle = 8 * max(1.0, abs(equilibrium.tip_angle), abs(rod.clamp_angle)) + 6 * rate * s
    return [ULP * part for part in (angle, angle * rate, 6 * length, 6 * length)]


def one_by_one(equilibrium, s):
    """The values by the closed form."""
    return np.array([angle_and_position(equilibrium, place) for place in s.tolist()]).T


def assert_near(equilibrium, s, values, wanted):
    for value, want, bound in zip(values, wanted, allowed(equilibrium, s), strict=True):
        assert np.all(np.abs(value - want) <= bound)


@pytest.mark.parametrize("name", RODS)
def test_every_way_gives_what_the_closed_form_gives(name):
    """Sorted points by runs, any points by looking up: both to rounding, at the ends too."""
    rod = RODS[name]
    rng = np.random.default_rng(5)
    s = np.sort(np.concatenate(([0.0, rod[2]], rng.random(60) * rod[2])))
    found = bent(*rod)
    assert found
    for equilibrium in found[:: max(1, len(found) // 4)]:
        wanted = one_by_one(equilibrium, s)
        bins = expansion.bins_of(equilibrium, True)
        assert_near(equilibrium, s[::-1], lookup.by_lookup(equilibrium, bins, s[::-1], True), wanted[:, ::-1])
        for cells in () if np.any(bins.straight) else (1, 4):
            assert_near(equilibrium, s, runs.by_runs(equilibrium, bins, cells, s, True), wanted)


@pytest.mark.parametrize("name", RODS)
def test_angles_alone(name):
    """Without positions θ and θ′ are the same to rounding, and y and z are None."""
    rod = RODS[name]
    s = np.linspace(0.0, rod[2], 200)
    equilibrium = bent(*rod)[0]
    theta, curvature, y, z = dense.shape_at(equilibrium, s, position=False)
    wanted = dense.shape_at(equilibrium, s)
    angle, slope, _, _ = allowed(equilibrium, s)
    assert y is None
    assert z is None
    assert np.all(np.abs(theta - wanted[0]) <= angle)
    assert np.all(np.abs(curvature - wanted[1]) <= slope)


@pytest.mark.parametrize("name", ["field only", "force only", "oblique", "orthogonal", "other units"])
def test_against_taylor_integration(name):
    """θ, y and z within four roundings and what the inputs leave open, by integration."""
    *numbers, _ = RODS[name]
    rod = Rod(*numbers)
    rng = np.random.default_rng(7)
    s = np.sort(rng.random(8)) * rod.length
    for equilibrium in bent(*RODS[name])[::2]:
        tip = refine(rod, equilibrium.tip_angle, 24, 1e-3)
        points = integrate(tip, rod.beta, rod.eta, rod.field_angle, rod.length, 24, stops=s.tolist()).points
        clamp, wanted = points[-1], points[-2::-1]
        moved = sensitivity(rod, tip)
        bins = expansion.bins_of(equilibrium, True)
        for values in (
            lookup.by_lookup(equilibrium, bins, s, True),
            runs.by_runs(equilibrium, bins, 4, s, True),
        ):
            for k, want in enumerate(wanted):
                angle = 4 * max(1.0, abs(float(want.theta))) + largest(moved, "theta")
                assert abs(values[0][k] - want.theta) <= ULP * angle
                assert abs(values[2][k] - (clamp.y - want.y)) <= ULP * (4 * rod.length + largest(moved, "y"))
                assert abs(values[3][k] - (clamp.z - want.z)) <= ULP * (4 * rod.length + largest(moved, "z"))


def largest(moved, name):
    """How much a quantity moves with the inputs, where on the rod it moves most."""
    return max(
        value for key, value in moved.items() if key.startswith((name, "tip_angle" if name == "theta" else name))
    )


@given(
    st.floats(0.01, 1) | st.just(0.0), st.floats(0.01, 2), st.floats(0.5, 25), st.floats(-7, 7), st.floats(-1.5, 1.5)
)
@settings(max_examples=25)
def test_any_rod(beta, eta, length, clamp_angle, field_angle):
    """The first and the last bent equilibrium of any rod, by the public function, against the closed form."""
    found = bent(beta, eta, length, clamp_angle, field_angle, None)
    s = np.linspace(0.0, length, 90)
    for equilibrium in found[:1] + found[1:][-1:]:
        assert_near(equilibrium, s, dense.shape_at(equilibrium, s), one_by_one(equilibrium, s))


def test_the_order_of_points_does_not_matter():
    """Enough points for runs, and the same shuffled, for which there are none."""
    equilibrium = bent(*RODS["oblique"])[0]
    s = np.linspace(0.0, 10.0, 60_000)
    bins = expansion.bins_of(equilibrium, True)
    assert runs.cells_for(equilibrium, bins, s.size)
    order = np.random.default_rng(3).permutation(s.size)
    shuffled = dense.shape_at(equilibrium, s[order])
    assert_near(equilibrium, s[order], shuffled, np.array(dense.shape_at(equilibrium, s))[:, order])


def test_equal_points_and_all_at_one_end():
    equilibrium = bent(*RODS["oblique"])[0]
    for place in (0.0, 3.0, 10.0):
        s = np.full(20_000, place)
        assert_near(equilibrium, s, dense.shape_at(equilibrium, s), one_by_one(equilibrium, s[:1]))


@pytest.mark.parametrize("shape", [(), (0,), (1,), (64,), (65,), (5, 40), (2, 0, 3)])
def test_results_have_the_shape_of_s(shape):
    equilibrium = bent(*RODS["oblique"])[0]
    s = np.full(shape, 2.5)
    wanted = angle_and_position(equilibrium, 2.5)
    for value, want, bound in zip(dense.shape_at(equilibrium, s), wanted, allowed(equilibrium, s), strict=True):
        assert np.shape(value) == shape
        assert np.all(np.abs(value - want) <= bound)
    assert np.shape(dense.shape_at(equilibrium, s, position=False)[0]) == shape


@pytest.mark.parametrize("rod", [(0.0, 0.0, 3.0, 1.0, 0.0, None), (0.5, 0.25, 3.0, 0.0, 0.0, None)])
def test_straight_rods(rod):
    """Rods without load, and those along a direction without moment."""
    (equilibrium,) = [one for one in all_equilibria(*rod) if one.swing is None]
    s = np.linspace(0.0, 3.0, 100)
    theta, curvature, y, z = dense.shape_at(equilibrium, s)
    assert np.all(theta == rod[3])
    assert np.all(curvature == 0)
    assert y == pytest.approx(s * np.cos(rod[3]), abs=4 * ULP)
    assert z == pytest.approx(s * np.sin(rod[3]), abs=4 * ULP)


def test_long_rods_have_straight_bins_and_few_cells():
    """Where θ is constant to rounding a bin is one cell."""
    equilibrium = bent(*RODS["straight stretches"])[-1]
    bins = expansion.bins_of(equilibrium, False)
    assert np.any(bins.straight)
    table = lookup.table_of(equilibrium, bins, False)
    counts = table.per_bin[:, 1]
    assert np.all((counts == 1) == bins.straight)


def test_a_series_that_does_not_end_is_refused():
    """Bins so wide that the terms grow: the error bound must see it."""
    equilibrium = bent(*RODS["oblique"])[0]
    state, _ = expansion.states(equilibrium, 0.5, 20, True)
    assert expansion.complete_series(equilibrium.rod, 0.0, state, 0.25) is not None
    assert expansion.complete_series(equilibrium.rod, 0.0, state, 0.98) is None


def test_cells_that_are_too_wide_are_refused():
    """The short series of wide cells leave out more than they may, and this is seen."""
    equilibrium = bent(*RODS["oblique"])[0]
    bins = expansion.bins_of(equilibrium, True)
    assert lookup.short_series(equilibrium.rod, bins, 4, True) is None
    assert lookup.short_series(equilibrium.rod, bins, 256, True) is not None


def test_shortened_polynomials_differ_by_no_more_than_allowed():
    coefficients = np.array([[1.0, -2.0], [0.5, 0.3], [0.1, 0.2], [1e-3, -1e-3], [1e-5, 1e-5], [1e-9, 0.0]])
    x = np.linspace(-1, 1, 201)
    full = np.polynomial.polynomial.polyval(x, coefficients)
    for bound in (1e-2, 1e-4, 1e-7):
        part = shortened(coefficients, bound)
        assert len(part) < len(coefficients)
        assert np.max(np.abs(np.polynomial.polynomial.polyval(x, part) - full)) <= bound


def test_a_cut_tells_what_it_leaves_out():
    """The terms that are kept and the Chebyshev polynomials that are not make up the whole."""
    coefficients = np.random.default_rng(2).random(9)
    changed = cut(9, 5) @ coefficients
    x = np.linspace(-1, 1, 21)
    rest = np.polynomial.chebyshev.chebval(x, np.concatenate((np.zeros(6), changed[6:])))
    whole = np.polynomial.polynomial.polyval(x, changed[:6]) + rest
    assert whole == pytest.approx(np.polynomial.polynomial.polyval(x, coefficients), abs=16 * ULP)


def test_chebyshev_polynomials_by_their_definition():
    """T_n(cos t) = cos nt, and powers by them."""
    of_powers, of_chebyshev = chebyshev(12)
    t = np.linspace(0, pi, 9)
    powers = np.cos(t) ** np.arange(12)[:, None]
    waves = np.cos(np.arange(12)[:, None] * t)
    assert of_chebyshev @ powers == pytest.approx(waves, abs=1e-11)
    assert of_powers @ waves == pytest.approx(powers, abs=1e-14)
