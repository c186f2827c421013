"""One short rod: its tips by where its motions are after its length, and that none is missing."""

from __future__ import annotations

from math import cos, isclose, pi, sin, sqrt
from typing import Any

import numpy as np
import pytest
from spying import calls_of
from test_shots import COUNT, short_rods

from derive.emit.kernels import equilibria as kernel
from derive.emit.kernels.block_arrivals import load_of, miss
from derive.emit.kernels.equilibria import all_equilibria
from derive.emit.kernels.shots import SHORT_SLOW, UNSURE, miss_of, samples_apart, tip_shots, zeros_between
from derive.measure.counts import count
from derive.measure.reference import Rod

# Two tips of each lie so near each other that samples of their range do not show them.
NEARLY_MET = (
    (0.5677739835398896, 0.35532297243574695, 3.3681820526332062, -3.6013855864187634, 0.3860879203116283, 5),
    (0.518521050809158, 0.8341296812024206, 1.9162189860980317, -1.9494942121751413, 0.3472472618443512, 3),
    (0.6756780879691183, 0.6958219443032294, 3.448167846823429, 3.407299663821737, -0.7241828787092756, 5),
)


def rods_beside_folds(number: int) -> list[Rod]:
    """Short rods with a clamp angle next to one at which two tips meet."""
    rng = np.random.default_rng(8)
    found: list[Rod] = []
    while len(found) < number:
        share, field = rng.random(), rng.choice([0, pi / 2, rng.uniform(-1.5, 1.5)])
        length = rng.uniform(1.6, SHORT_SLOW)

        arrived = miss_of(share * length**2, (1 - share) * length**2, float(field), 0.0, length)
        tips = np.linspace(-pi, pi, 400)
        angles = np.array([arrived(float(tip)) for tip in tips])
        turns = np.flatnonzero((angles[1:-1] - angles[:-2]) * (angles[2:] - angles[1:-1]) < 0) + 1
        for k in turns[:1]:
            before, here, after = angles[k - 1 : k + 2]
            top = here - (after - before) ** 2 / (8 * (before - 2 * here + after))
            clamp = top + rng.choice([-1, 1]) * 10 ** rng.uniform(-7, -2)
            found.append(Rod(share, 1 - share, length, float(clamp), float(field)))
    return found


def test_the_same_function_as_that_of_sweeps() -> None:
    rods = short_rods(1)
    load, share = load_of(rods), np.linspace(-1, 1, COUNT)
    for k, missed in enumerate(miss(load, share)):
        beta, eta, field = float(load.beta[k]), float(load.eta[k]), float(rods.field_angle[k])
        missed_by_one = miss_of(beta, eta, field, float(load.clamp_angle[k]), float(rods.slow[k]))
        found = missed_by_one(float(share[k] * load.reach[k]))
        assert isclose(found, missed, rel_tol=0, abs_tol=UNSURE / 100 * load.reach[k])


@pytest.mark.parametrize("rod", NEARLY_MET, ids=range(len(NEARLY_MET)))
def test_tips_that_nearly_meet_are_told_apart(rod) -> None:
    beta, eta, length, clamp, field, number = rod
    assert len(all_equilibria(beta, eta, length, clamp, field, None)) == number


def test_as_many_as_brute_force_beside_folds() -> None:
    rods = rods_beside_folds(40)
    counts = count(rods)
    assert sum(counted.tips is not None for counted in counts) > 35
    for rod, counted in zip(rods, counts, strict=True):
        if counted.tips is not None:
            found = all_equilibria(rod.beta, rod.eta, rod.length, rod.clamp_angle, rod.field_angle, None)
            assert [item.index for item in found] == list(counted.indices or ()), rod


def test_hardly_any_rod_is_left_to_the_search_by_ranges(monkeypatch: pytest.MonkeyPatch) -> None:
    """And those by it have the same equilibria."""
    left = calls_of(monkeypatch, kernel, "crossings")
    arguments = [tuple(float(part[k]) for part in short_rods(5, slowest=SHORT_SLOW)[3:8]) for k in range(COUNT)]

    def solved(rod: Any) -> list[Any]:
        return all_equilibria(rod[0], rod[1], rod[2], rod[3], rod[4], None)

    shot = [solved(rod) for rod in arguments]
    assert len(left) <= COUNT / 100
    monkeypatch.setattr(kernel, "tip_shots", lambda *rod: None)
    for rod, found in zip(arguments, shot, strict=True):
        wanted = solved(rod)
        assert [item.index for item in found] == [item.index for item in wanted]
        for one, other in zip(found, wanted, strict=True):
            assert isclose(one.tip_angle, other.tip_angle, rel_tol=0, abs_tol=1e-12)
            assert isclose(one.y, other.y, rel_tol=0, abs_tol=1e-12 * rod[2])


@pytest.mark.parametrize("level", [0.1, 0.3, 1 - 1e-3, 1 - 1e-8, -1 + 1e-6, 1 + 1e-6])
def test_every_zero_of_a_function_whose_bend_is_bounded(level) -> None:
    """sin 3x − level, |f″| ≤ 9: the zeros are known."""
    places, values = samples_apart(lambda x: sin(3 * x) - level, 2.0, 4.5)
    grid = np.sin(3 * np.linspace(-2, 2, 400_001)) > level
    found = zeros_between(lambda x: sin(3 * x) - level, places, values, 4.5, 2e-14)
    assert len(found) == np.count_nonzero(grid[1:] != grid[:-1])
    for shot in found:
        assert isclose(sin(3 * shot.offset), level, rel_tol=0, abs_tol=1e-13)
        assert isclose(shot.rate, 3 * cos(3 * shot.offset), rel_tol=0, abs_tol=1e-4)


def test_a_zero_at_which_the_function_does_not_change_its_sign_leaves_a_doubt() -> None:
    assert samples_apart(lambda x: sin(3 * x) - 1, 2.0, 4.5) is None


def test_a_rod_that_is_straight_or_long_is_not_shot() -> None:
    assert tip_shots(0.3, 0.7, 0.0, 2.0, 0.0) is None
    assert tip_shots(0.3, 0.7, 0.2, 1.01 * SHORT_SLOW, 1.0) is None
    assert tip_shots(0.3, 0.7, 0.2, 0.99 * SHORT_SLOW / sqrt(1.0), 1.0) is not None
