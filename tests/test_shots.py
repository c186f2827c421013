"""Short rods in sweeps: where their motions are after the rod's length, and the tips that follow from it."""

from __future__ import annotations

from math import pi
from typing import Any

import numpy as np
import pytest
from runge_kutta import angle_after
from spying import calls_of

from derive.emit.kernels import array_arithmetic as arrays
from derive.emit.kernels import blocks
from derive.emit.kernels.block_arrivals import load_of, miss
from derive.emit.kernels.block_pieces import Rods
from derive.emit.kernels.block_shots import SHOT_SLOW, shots_of
from derive.emit.kernels.blocks import sweep_arrays
from derive.emit.kernels.equilibria import all_equilibria

COUNT = 200


def short_rods(seed: int, count: int = COUNT, slowest: float = SHOT_SLOW) -> Rods:
    """Random rods that are short, in their own units."""
    rng = np.random.default_rng(seed)
    beta, eta = rng.random(count), rng.random(count)
    slow = slowest * rng.uniform(0.01, 1, count)
    length, clamp, field = slow / np.sqrt(beta + eta), rng.uniform(-4, 4, count), rng.uniform(-pi / 2, pi / 2, count)
    return Rods(np.arange(count), 1, 0, beta, eta, length, clamp, field, slow)


def integrated(rods: Rods, tip: np.ndarray) -> np.ndarray:
    """The angle after the rod's length from rest at the tip."""
    return angle_after(tip, rods.length, rods.beta, rods.eta, rods.field_angle)


@pytest.mark.parametrize(("kind", "tolerance"), [(float, 1e-8), (np.float32, 2e-3)])
def test_where_a_motion_is_after_the_length_of_the_rod(kind: Any, tolerance: float) -> None:
    rods = short_rods(1)
    load, share = load_of(rods), np.linspace(-1, 1, COUNT)
    tip = rods.clamp_angle + load.reach * share
    missed = miss(type(load)(*(part.astype(kind) for part in load)), share.astype(kind))
    assert missed.dtype == kind
    assert np.abs(missed - (integrated(rods, tip) - rods.clamp_angle)).max() < tolerance


def test_all_tips_of_short_rods() -> None:
    rods = short_rods(2)
    with np.errstate(all="ignore"):
        shots, unsure = shots_of(rods)
    assert unsure.size < 3
    for case in set(range(COUNT)) - set(unsure.tolist()):
        wanted = [item.tip_angle for item in all_equilibria(*(float(part[case]) for part in rods[3:8]), None)]
        found = rods.clamp_angle[case] + np.sort(shots.offset[shots.rod == case])
        assert np.allclose(found, wanted, rtol=0, atol=1e-12)


def test_short_rods_beside_the_astroid_are_not_left_to_the_scalar_solver(monkeypatch: pytest.MonkeyPatch) -> None:
    left = calls_of(monkeypatch, blocks, "one_by_one")
    angle = np.linspace(0.05, 1.5, COUNT)
    beta = 1 / (np.cos(angle) ** (2 / 3) + np.sin(angle) ** (2 / 3)) ** 1.5
    sweep_arrays(beta, np.full(COUNT, 1 + 1e-4), np.full(COUNT, 2.3), np.full(COUNT, 2.4), angle, angle.shape, None)
    assert len(left) < COUNT / 20


def test_functions_of_arrays_that_are_made_of_faster_ones() -> None:
    x = np.random.default_rng(3).uniform(-20, 20, 2000)
    z = x + 1j * x[::-1]
    for ours, theirs, at in (
        (arrays.each_sin, np.sin, x),
        (arrays.each_cos, np.cos, x),
        (arrays.each_complex_sqrt, np.sqrt, z),
        (lambda root: arrays.each_complex_atanh(root, 1 - root * root), np.arctanh, np.abs(x) / 9 + 1j * x[::-1]),
    ):
        assert np.abs(ours(at) - theirs(at)).max() < 2e-15
    assert np.all(np.abs(arrays.each_sin(x * 1e-200) / (x * 1e-200) - 1) < 1e-15)
    assert arrays.each_complex_sqrt(np.array([0j, -4 + 0j])).tolist() == [0j, 2j]
