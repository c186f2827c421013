"""That no tip of a short rod is missed: the bounds of which the proof is made, and rods that are made to hide some."""

from __future__ import annotations

from math import pi
from typing import Any

import numpy as np
import pytest
from rounding import error_bound

from derive.emit.kernels import block_shots
from derive.emit.kernels.block_arrivals import Load, load_of, miss
from derive.emit.kernels.block_pieces import Rods
from derive.emit.kernels.block_records import rounded_to, rows
from derive.emit.kernels.block_shots import BLUR, ROUGH_BLUR, ROUGH_SHOT, SHOT_SLOW, WIDER, sag_of, shots_of
from derive.emit.kernels.blocks import sweep_arrays
from derive.measure import counts

COUNT = 300
STEP = 1e-4  # of the tip, between which second differences are taken


def rods_of(force: Any, slow: Any, clamp: Any, field: Any) -> Rods:
    """Rods of unit length, by the force's share of β + η."""
    soft = slow * slow
    return Rods(np.arange(slow.size), 1, 0, force * soft, (1 - force) * soft, 0 * slow + 1, clamp, field, slow)


def random_rods(seed: int, count: int = COUNT, least: float = 0.05) -> Rods:
    rng = np.random.default_rng(seed)
    slow, field = SHOT_SLOW * rng.uniform(least, 1, count), rng.uniform(-pi / 2, pi / 2, count)
    return rods_of(rng.random(count), slow, rng.uniform(-pi, pi, count), np.where(rng.random(count) < 0.3, 0, field))


def arrival(load: Load, tip: Any) -> Any:
    """The angle after the rod's length."""
    nothing = 0 * load.clamp_angle
    return miss(load._replace(clamp_angle=nothing, reach=1 + nothing), tip)


def bend(load: Load, tip: Any) -> Any:
    """Its second derivative by the tip's angle."""
    before, here, after = (arrival(load, tip + k * STEP) for k in (-1, 0, 1))
    return (before - 2 * here + after) / STEP**2


def beside_tangencies(seed: int, count: int) -> Rods:
    """Rods of which two tips are next to one another: the clamp angle is beside an extremum of the arrival."""
    rng, rods, tips = np.random.default_rng(seed), random_rods(seed, count, 0.5), np.linspace(-pi, pi, 2001)
    load = load_of(rods._replace(clamp_angle=0 * rods.slow))  # of which the tips are told by themselves
    there = arrival(load, tips[:, None])
    row, which = np.nonzero((there[2:] > there[1:-1]) != (there[1:-1] > there[:-2]))
    chosen = rng.permutation(row.size)[:count]
    some, tip = rows(load, which[chosen]), tips[1 + row[chosen]]
    for step in np.array([1, 1, 1 / 8, 1 / 64]) * (tips[1] - tips[0]):
        before, here, after = (arrival(some, tip + k * step) for k in (-1, 0, 1))
        tip = tip + step / 2 * (before - after) / (before - 2 * here + after)
    beside = arrival(some, tip) + np.sign(before - 2 * here + after) * 10 ** rng.uniform(-6.5, -4, count)
    return rows(rods, which[chosen])._replace(case=np.arange(count), clamp_angle=beside)


def numbers(rods: Rods) -> tuple[Any, Any]:
    """How many tips the rods have, and the rods of which that is not sure."""
    with np.errstate(all="ignore"):
        shots, unsure = shots_of(rods)
    return np.bincount(shots.rod, minlength=rods.case.size), unsure


def test_the_bound_of_the_second_derivative_is_never_passed_and_nearly_reached() -> None:
    """By climbing from random rods and tips towards the greatest share of the bound."""
    rng, best = np.random.default_rng(1), np.zeros(COUNT)
    at = rng.uniform([0, 0.1, -pi, -pi / 2], [1, 1, pi, pi / 2], (COUNT, 4))
    for turn in range(60):
        tried = at + rng.normal(size=at.shape) * rng.choice([0.3, 0.03], (COUNT, 1)) * (turn > 0)
        force, length = np.clip(tried[:, 0], 0, 1), np.clip(tried[:, 1], 0.1, 1)
        rods = rods_of(force, SHOT_SLOW * length, 0 * force, tried[:, 3])
        share = np.abs(bend(load_of(rods), tried[:, 2])) / (2 * sag_of(rods))
        at, best = np.where((share > best)[:, None], tried, at), np.maximum(share, best)
    assert best.max() < 1
    assert best.max() > 0.1  # no bound to spare that costs samples


@pytest.mark.parametrize(
    ("slow", "kind", "blur"),
    [
        (ROUGH_SHOT, np.float32, ROUGH_BLUR),
        (SHOT_SLOW, np.float32, WIDER * ROUGH_BLUR),
        (SHOT_SLOW, float, BLUR),
    ],
)
def test_what_is_missed_is_right_to_the_margins(slow: float, kind: Any, blur: float) -> None:
    proved = [error_bound(slow * part, kind) for part in (0.2, 0.5, 0.8, 1)]
    assert proved == sorted(proved)
    assert proved[-1] < blur / 2


def test_single_precision_is_within_the_bound_of_its_rounding() -> None:
    rods, share = random_rods(2, 2000, 0.9), np.linspace(-1, 1, 101, dtype=np.float32)[:, None]
    load = load_of(rods)
    errors = np.abs(miss(rounded_to(load, np.float32), share) - miss(load, share.astype(float))).max(axis=0)
    assert np.all(errors < error_bound(SHOT_SLOW, np.float32) / 10)
    short = rods.slow < 0.95 * SHOT_SLOW
    assert np.all(errors[short] < error_bound(0.95 * SHOT_SLOW, np.float32))
    assert errors.max() > 1e-6


def test_none_is_missed_beside_tangencies() -> None:
    rods = beside_tangencies(3, 60)
    found, unsure = numbers(rods)
    given = [tuple(float(part[k]) for part in rods[3:8]) for k in range(60)]
    proved = [one.number for one in counts.count([counts.Rod(*rod) for rod in given])]
    assert unsure.size < 3
    assert [number for k, number in enumerate(proved) if k not in unsure] == np.delete(found, unsure).tolist()
    assert np.mean(found >= 3) > 0.9
    sweep = sweep_arrays(*rods[3:8], rods.case.shape, None)
    assert np.delete(np.bincount(sweep.case, minlength=60), unsure).tolist() == np.delete(found, unsure).tolist()


@pytest.mark.parametrize("share", [0.0, 0.03])
def test_a_bound_that_is_too_low_misses_some(share: float, monkeypatch: pytest.MonkeyPatch) -> None:
    rods = beside_tangencies(4, 2 * COUNT)
    proved, _ = numbers(rods)
    monkeypatch.setattr(block_shots, "sag_of", lambda rods: share * sag_of(rods))
    found, _ = numbers(rods)
    assert np.sum(found < proved) > COUNT / 10


def with_tips_on_samples(seed: int, count: int) -> Rods:
    """Rods that have a tip at one of 17 samples, but for less than single precision tells."""
    rng, rods, tips = np.random.default_rng(seed), random_rods(seed, count, 0.4), np.linspace(-pi, pi, 401)
    load = load_of(rods._replace(clamp_angle=0 * rods.slow))
    offset = load.reach * rng.integers(-7, 8, count) / 8
    left = tips[:, None] - arrival(load, tips[:, None]) - offset
    row, which = np.nonzero((left[1:] > 0) != (left[:-1] > 0))
    which, chosen = np.unique(which, return_index=True)
    some, offset, low, high = rows(load, which), offset[which], tips[row[chosen]], tips[row[chosen] + 1]
    rises = left[row[chosen] + 1, which] > 0
    for _ in range(50):
        middle = (low + high) / 2
        above = (middle - arrival(some, middle) - offset > 0) == rises
        low, high = np.where(above, low, middle), np.where(above, middle, high)
    clamp = low - offset + rng.choice([-1, 1], which.size) * 10 ** rng.uniform(-10, -5, which.size)
    rods = rows(rows(rods, which)._replace(clamp_angle=clamp), np.abs(arrival(some, clamp) - clamp) > 1e-3)
    return rods._replace(case=np.arange(rods.case.size))


def test_a_sign_that_rounding_may_turn_decides_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    rods = with_tips_on_samples(5, 2000)
    elsewhere, unsure = numbers(rods)
    assert unsure.size == 0
    monkeypatch.setattr(block_shots, "EVEN", 1e9)
    found, unsure = numbers(rods)
    assert np.array_equal(np.delete(found, unsure), np.delete(elsewhere, unsure))
    assert unsure.size < found.size / 20
    monkeypatch.setattr(block_shots, "ROUGH_BLUR", 0.0)
    found, _ = numbers(rods)
    assert np.any(found != elsewhere)
