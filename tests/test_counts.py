"""The counting of equilibria: its bounds hold, it agrees with the plain scan, with proofs, and with the solvers."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from math import pi

import numpy as np
import pytest

from derive.check.counting import count as proved_count
from derive.check.shooting import Rod as ExactRod
from derive.measure.counts import STIFFEST, Loads, bound, count, shoot
from derive.measure.folds import fold
from derive.measure.reference import Rod
from derive.measure.rods import PAPER, rods
from derive.measure.scan import brute_force
from derive.measure.taylor import integrate
from generated import parallel_numpy

MODERATE = [
    rod
    for case in ("parallel", "orthogonal", "oblique", "field_only", "force_only")
    for rod in rods(case)
    if rod.length * (rod.beta + rod.eta) ** 0.5 < STIFFEST
]


def random_rods(number: int, seed: int, field_angle: float | None = None) -> list[Rod]:
    rng = np.random.default_rng(seed)
    found = []
    for _ in range(number):
        scaled, share, length = rng.uniform(0.1, 8), rng.uniform(), 10 ** rng.uniform(-1, 2)
        stiffness = (scaled / length) ** 2
        angle = rng.uniform(0, pi) if field_angle is None else field_angle
        found.append(Rod(stiffness * share, stiffness * (1 - share), length, rng.uniform(-4, 4), angle))
    return found


@pytest.mark.long
def test_it_agrees_with_the_plain_scan() -> None:
    for found in count(MODERATE):
        assert found.tips is not None
        assert found.tips == pytest.approx(brute_force(found.rod), abs=1e-6)


def test_bounds_hold_within_cells() -> None:
    loads = Loads.of(random_rods(40, 3))
    rng = np.random.default_rng(4)
    tips, width = loads.clamp + rng.uniform(-6, 6, 40), 10 ** rng.uniform(-6, -1, 40)
    run = shoot(loads, tips, 36)
    spread, margin = bound(loads, run, width)
    assert np.sum(np.isfinite(spread)) > 20
    tightest = np.inf
    for part in np.linspace(-1, 1, 21):
        there = shoot(loads, tips + part * width, 36)
        assert np.all(np.abs(there.slope - run.slope) <= spread + margin)
        assert np.all(np.abs(there.miss - run.miss) <= width * (np.abs(run.slope) + spread) + margin)
        with np.errstate(divide="ignore"):
            tightest = min(tightest, np.nanmin(spread / np.abs(there.slope - run.slope)))
    assert tightest < 100  # bounds, not merely large numbers


def test_shots_are_those_of_the_taylor_reference() -> None:
    for rod in random_rods(5, 8):
        run = shoot(Loads.of([rod]), np.array([0.7]), 36)
        path = integrate(0.7, rod.beta, rod.eta, rod.field_angle, rod.length, 20)
        size = 1 + abs(float(path.clamp.h))
        assert run.miss[0] + rod.clamp_angle == pytest.approx(float(path.clamp.theta), abs=1e-12 * size)
        assert run.slope[0] == pytest.approx(float(path.clamp.h), abs=1e-11 * size**2)


def test_numbers_are_the_proved_ones() -> None:
    for eta in (Fraction(2, 10000), Fraction(52, 100000), Fraction(8, 10000)):
        exact = ExactRod(Fraction(80), Fraction(3, 4), Fraction(35, 100000))
        assert count([replace(PAPER, eta=float(eta))])[0].number == proved_count(exact, eta)


def test_solvers_find_as_many_with_these_indices() -> None:
    for found in count(random_rods(64, 5, field_angle=0.0)):
        rod = found.rod
        answers = parallel_numpy.equilibria(rod.beta, rod.eta, rod.length, rod.clamp_angle)
        assert found.indices == tuple(one.index for one in answers)
        assert found.tips == pytest.approx([one.tip_angle for one in answers], abs=1e-8)


def test_a_rod_at_a_fold_is_undecided_and_beside_it_decided() -> None:
    at = fold(PAPER, "eta", 0.00045, 2.2)
    numbers = [
        one.number for one in count([replace(PAPER, eta=float(at.value) * factor) for factor in (0.999, 1, 1.001)])
    ]
    assert numbers[1] is None
    assert None not in (numbers[0], numbers[2])
    assert abs((numbers[0] or 0) - (numbers[2] or 0)) == 2


def test_too_long_a_rod_is_refused() -> None:
    with pytest.raises(ValueError, match="this rod has more"):
        count([Rod(1.0, 1.0, 40.0, 1.0)])
