"""Folds and exchanges: against Newton's method on Taylor integration, and against counts of equilibria."""

from __future__ import annotations

import importlib
import sys
from itertools import pairwise
from math import pi

import pytest
from mpmath import mp, mpf

from derive.emit.kernels import arithmetic_mpmath
from derive.emit.kernels.equilibria import all_equilibria
from derive.emit.kernels.exchanges import all_exchanges
from derive.emit.kernels.folds import all_folds
from derive.emit.kernels.spans import span
from derive.measure import folds as reference
from derive.measure.reference import Rod
from derive.measure.taylor import integrate

SECOND_EXAMPLE = (80.0, 3 * pi / 4, 0)
# Rounding of the inputs alone moves a fold by its condition, a few ε here; a tip near the ridge's level may lose two
# digits more (see ``extrema``).
ETA_ERROR, TIP_ERROR = 2e-14, 1e-12
# beta, length, clamp angle, field angle, highest eta: every kind of load, clamps on either side of hills and wells.
RODS = (
    (0.72, 4.1, 2.9, 0.0, 2.5),
    (0.9, 3.6, -2.2, pi / 2, 3.0),
    (0.65, 6.1, -3.8, 0.58, 1.27),
    (1.4, 4.5, 3.2, -0.9, 2.0),
    (0.0, 6.9, 3.7, 0.55, 1.41),
    (0.122500636315138, 5.430012755796118, 3.003929371585903, 0.0, 0.29125242160658854),
)


def kernels_in_mpmath():
    """The kernels of folds on mpmath, as the emitter would have them."""
    prefix = "derive.emit.kernels."
    saved = {name: module for name, module in sys.modules.items() if name.startswith(prefix)}
    for name in saved:
        del sys.modules[name]
    sys.modules[f"{prefix}arithmetic"] = arithmetic_mpmath
    try:
        return importlib.import_module(f"{prefix}folds")
    finally:
        for name in [name for name in sys.modules if name.startswith(prefix)]:
            del sys.modules[name]
        sys.modules.update(saved)


def check(fold, beta, length, clamp_angle, field_angle):
    """A fold against 40 digits."""
    exact = reference.fold(Rod(beta, fold.eta, length, clamp_angle, field_angle), "eta", fold.eta, fold.tip_angle)
    assert abs(fold.eta / exact.value - 1) < ETA_ERROR
    assert abs(fold.tip_angle - exact.tip_angle) < TIP_ERROR
    assert fold.change == 2 * exact.opens
    with mp.workdps(40):
        clamp = integrate(exact.tip_angle, beta, exact.value, field_angle, length).clamp
        assert abs(fold.y - clamp.y) < TIP_ERROR * length
        assert abs(fold.z - clamp.z) < TIP_ERROR * length
        assert abs(fold.clamp_curvature - clamp.curvature) < TIP_ERROR * (1 + abs(clamp.curvature))


@pytest.mark.parametrize("beta", [0.0002, 0.00025, 0.0003, 0.00035, 0.0004, 0.0005])
def test_the_second_example_has_one_fold_on_each_curve(beta):
    (fold,) = all_folds(beta, *SECOND_EXAMPLE, 0.0, 0.001)
    assert (fold.kind, fold.index, fold.change) == ("fold", 0, 2)
    check(fold, beta, *SECOND_EXAMPLE)


@pytest.mark.parametrize("beta", [0.0, 0.0001])
def test_the_folds_of_the_first_two_curves_are_beyond_the_figure(beta):
    assert all_folds(beta, *SECOND_EXAMPLE, 0.0, 0.0009) == []


@pytest.mark.parametrize("rod", RODS)
def test_folds_against_integration_and_counts(rod):
    *fixed, top = rod
    beta, length, clamp_angle, field_angle = fixed
    found = all_folds(*fixed, 0.0, top)

    def equilibria(eta):
        return all_equilibria(beta, eta, length, clamp_angle, field_angle, None)

    places = [top * (k + 0.5) / 40 for k in range(40)]
    for low, high in pairwise(places):
        inside = sum(fold.change for fold in found if low < fold.eta <= high)
        assert len(equilibria(high)) - len(equilibria(low)) == inside
    for fold in found:
        check(fold, *fixed)
        beside = equilibria(fold.eta * (1 + fold.change * 1e-7))
        nearest = sorted(beside, key=lambda item: abs(item.tip_angle - fold.tip_angle))[:2]
        assert sorted(item.index for item in nearest) == [fold.index, fold.index + 1]


def test_some_rod_has_folds_at_all():
    found = [fold for *rod, top in RODS for fold in all_folds(*rod, 0.0, top)]
    assert len(found) >= 6
    assert {fold.change for fold in found} == {2, -2}


@pytest.mark.parametrize(("beta", "clamp_angle", "field_angle"), [(1.0, pi, 0), (1.0, 0.0, pi / 2), (0.0, pi / 2, 0)])
def test_a_straight_rod_buckles_in_pitchforks(beta, clamp_angle, field_angle):
    length, top = 3.0, 9.0
    found = all_folds(beta, length, clamp_angle, field_angle, 0.0, top)
    forks = [fold for fold in found if fold.kind == "pitchfork"]
    assert forks
    for fork in forks:
        below, above = (
            all_equilibria(beta, fork.eta * (1 + side * 1e-6), length, clamp_angle, field_angle, None)
            for side in (-1, 1)
        )
        assert len(above) - len(below) == fork.change
        straight = [next(e.index for e in some if e.tip_angle == clamp_angle) for some in (below, above)]
        assert sorted(straight) == [fork.index, fork.index + 1]


def test_no_fold_is_doubled_where_another_extremum_appears():
    found = all_folds(0.6459873830048208, 6.146966792359469, -3.8142067697755664, 0.5817462157266542, 0.59, 0.61)
    assert len(found) == 1


def test_below_the_first_critical_length_nothing_meets():
    assert all_folds(0.5, 1.5, 2.0, 0.3, 0.0, 0.5) == []


def derivatives(beta, eta, tip_angle, length, clamp_angle):
    """F, ∂F/∂φ and ∂F/∂η by Taylor integration, the last one by differences."""
    step = mpf(10) ** -15
    low, here, high = (integrate(tip_angle, beta, eta * (1 + k * step), 0, length).clamp for k in (-1, 0, 1))
    return here.theta - mpf(clamp_angle), here.h, (high.theta - low.theta) / (2 * step)


def test_two_branches_of_the_second_example_exchange():
    (found,) = all_exchanges(*SECOND_EXAMPLE, 0.0003, 0.00035, 0.0, 0.001)
    assert found.kind == "exchange"
    with mp.workdps(40):
        unknowns = [mpf(found.beta), mpf(found.eta), mpf(found.tip_angle)]
        for _ in range(4):
            values = derivatives(*unknowns, *SECOND_EXAMPLE[:2])
            columns = []
            for k in range(3):
                moved = [u * (1 + mpf(10) ** -12) if j == k else u for j, u in enumerate(unknowns)]
                there = derivatives(*moved, *SECOND_EXAMPLE[:2])
                columns.append([(b - a) * mpf(10) ** 12 for a, b in zip(values, there, strict=True)])
            step = mp.lu_solve(mp.matrix(columns).T, mp.matrix(values))
            unknowns = [u * (1 - step[k]) for k, u in enumerate(unknowns)]
        assert max(abs(step[k]) for k in range(3)) < mpf(10) ** -20
        for got, exact in zip((found.beta, found.eta, found.tip_angle), unknowns, strict=True):
            assert abs(got / exact - 1) < ETA_ERROR


def test_two_folds_meet_at_the_exchange_from_one_side_of_it():
    """F ≈ aφ² − bη² + c(β − β*) about a saddle: its folds are at η = ±√(c(β − β*)/b), and on one side there is none."""
    (found,) = all_exchanges(*SECOND_EXAMPLE, 0.0003, 0.00035, 0.0, 0.001)
    distances = []
    for away in (1e-9, 4e-9):
        sides = []
        for side in (-1, 1):
            folds = all_folds(found.beta + side * away, *SECOND_EXAMPLE, 0.0, 0.001)
            sides.append([fold for fold in folds if abs(fold.eta / found.eta - 1) < 0.02])
        below, above = sides
        assert above == []
        first, second = below
        assert (first.change, second.change) == (-2, 2)
        assert first.eta < found.eta < second.eta
        distances.append(second.eta - first.eta)
    assert distances[1] / distances[0] == pytest.approx(2, rel=1e-2)


def test_the_twin_has_the_same_fold_to_its_own_precision():
    twin = kernels_in_mpmath()
    exact = reference.fold(Rod(0.0004, 5.5e-4, *SECOND_EXAMPLE[:2]), "eta", 0.0005535593804020638, 2.203878534866223)
    with mp.workdps(30):
        beta, length, clamp_angle = mpf(0.0004), mpf(80), mpf(SECOND_EXAMPLE[1])
        (fold,) = twin.all_folds(beta, length, clamp_angle, 0, mpf(5.4e-4), mpf(5.6e-4))
        assert abs(fold.eta / exact.value - 1) < mpf(10) ** -27
        assert abs(fold.tip_angle - exact.tip_angle) < mpf(10) ** -25


@pytest.mark.parametrize(
    ("ends", "error"),
    [
        (3.0, TypeError),
        ("01", TypeError),
        ((0.0,), ValueError),
        ((1.0, 0.5), ValueError),
        ((-1.0, 1.0), ValueError),
        ((0.0, float("inf")), ValueError),
        ((0.0, 1j), TypeError),
    ],
)
def test_bad_ranges_are_named(ends, error):
    with pytest.raises(error, match="eta"):
        span("eta", ends)
