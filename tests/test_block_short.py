"""Short rods of a sweep by their tips alone: how many points an integral takes, the index, what is left to others."""

from __future__ import annotations

from math import cosh, exp, pi, sqrt
from typing import Any

import numpy as np
import pytest
from runge_kutta import motion_after
from scipy.integrate import quad
from sympy import cancel, symbols
from test_shots import COUNT, short_rods

from derive.emit.kernels import block_short, block_shots, blocks
from derive.emit.kernels.block_arrivals import Load, Quartic, ahead_doubled, aim_at, eighth_of, load_of, miss
from derive.emit.kernels.block_records import rows
from derive.emit.kernels.block_short import half_of_gauss, integrals, points_for
from derive.emit.kernels.block_shots import SHOT_SLOW
from derive.emit.kernels.blocks import sweep_arrays

SHARES = np.linspace(0, 1, 21)  # of the force in β + η


def time_to(depth: float, force: float) -> float:
    """The least imaginary time in which the angle of a motion has an imaginary part of ``depth``, for β + η = 1.

    It starts no faster than √(4β + η), and what turns it is no more than β sinh ψ + (η/2) sinh 2ψ.
    """

    def slowness(psi: float) -> float:
        return 1 / sqrt(4 * force * cosh(psi / 2) ** 2 + (1 - force) * cosh(psi) ** 2)

    return quad(slowness, 0, depth, epsabs=1e-12)[0]


def left_out(slow: Any) -> Any:
    """A bound of what the points leave out of integrals of e^{2iδ} − 1 along rods of length 1, by ℓ√(β + η).

    It is analytic, and no more than 1 + e^{2ψ}, in an ellipse with foci at the ends of the rod and its continuation.
    """
    least, points = np.full(slow.shape, np.inf), np.array([points_for(float(one)) for one in slow])
    for depth in np.arange(0.5, 6, 0.25).tolist():
        across = min(time_to(depth, share) for share in SHARES.tolist()) / slow
        rho = across + np.sqrt(1 + across * across)
        least = np.minimum(least, 32 / 15 * (1 + exp(2 * depth)) * rho ** (-4.0 * points) / (1 - rho**-2))
    return least


def test_points_leave_out_less_than_rounding() -> None:
    bounds = left_out(np.linspace(0.002, SHOT_SLOW, 2000))
    assert bounds.max() < 2.0**-53
    assert bounds.max() > 2.0**-56


def test_no_motion_is_deeper_in_imaginary_time() -> None:
    """From anywhere on a rod, by Runge and Kutta's method."""
    rng, count = np.random.default_rng(4), 300
    force, field = rng.random(count), rng.uniform(-2, 2, count)
    tip, start = rng.uniform(-4, 4, count), rng.uniform(-4, 4, count)
    eta = 1 - force

    def potential(theta: Any) -> Any:
        return force * np.cos(theta) + eta / 2 * np.cos(theta - field) ** 2

    square = 2 * (potential(tip) - potential(start))
    there = square > 0
    for depth in (0.5, 1.0, 2.0):
        time = 1j * np.array([time_to(depth, float(share)) for share in force])
        angle = motion_after(start + 0j, np.sqrt(np.maximum(square, 0)) + 0j, time, force, eta, field)
        reached = np.abs(angle.imag[there])
        assert reached.max() < depth * (1 + 1e-6)
        assert reached.max() > 0.8 * depth


def test_the_curve_is_doubled_as_that_of_weierstrass() -> None:
    """℘(2z) by DLMF 23.10.7, with the invariants of `theory/oblique_quartic`, against ℘ − c."""
    p, m, q, n, ahead = symbols("p m q n ahead")
    c, wp = q / 12, ahead + q / 12
    g2 = q**2 / 12 - m * p / 4
    g3 = m * p * q / 48 - q**3 / 216 - n * p**2 / 16
    doubled = ((wp**2 + g2 / 4) ** 2 + 2 * g3 * wp) / (4 * wp**3 - g2 * wp - g3) - c
    quartic = Quartic(p / 4, q, m * p / 4, n * p**2 / 16)
    assert cancel(ahead_doubled(quartic, eighth_of(quartic), ahead) - doubled) == 0


@pytest.mark.parametrize("number", [4, 14, 46])
def test_points_of_gauss_and_legendre(number: int) -> None:
    place, weight = half_of_gauss(number)
    powers = np.arange(2 * number)
    assert np.allclose(weight @ place[:, None] ** (2 * powers), 1 / (2 * powers + 1), rtol=0, atol=2e-15)


def test_a_third_of_the_points_is_too_few(monkeypatch: pytest.MonkeyPatch) -> None:
    rods, rng = short_rods(3), np.random.default_rng(5)
    load = load_of(rods)
    quartic = aim_at(load, load.reach * rng.uniform(-1, 1, COUNT)).quartic
    most = float(rods.slow.max())
    enough = integrals(quartic, most)
    more = {"POINTS_PER": 2 * block_short.POINTS_PER, "POINTS_MORE": 2 * block_short.POINTS_MORE}
    for name, value in more.items():
        monkeypatch.setattr(block_short, name, value)
    exact = integrals(quartic, most)
    assert all(np.abs(one - other).max() < 1e-13 for one, other in zip(enough, exact, strict=True))
    for name, value in more.items():
        monkeypatch.setattr(block_short, name, value / 6)
    few = integrals(quartic, most)
    assert max(np.abs(one - other).max() for one, other in zip(few, exact, strict=True)) > 1e-9


def test_tips_that_do_not_settle_are_left_to_the_scalar_solver(monkeypatch: pytest.MonkeyPatch) -> None:
    rods = short_rods(6)
    some = rows(rods, np.arange(40))[3:8]
    wanted = sweep_arrays(*some, (40,), None)
    monkeypatch.setattr(block_shots, "AIMS", 1)
    monkeypatch.setattr(block_shots, "SETTLINGS", 1)
    left: list[Any] = []
    others = blocks.both_sides_each

    def counted(rods: Any) -> Any:
        left.append(rods.case.size)
        return others(rods)

    monkeypatch.setattr(blocks, "both_sides_each", counted)
    found = sweep_arrays(*some, (40,), None)
    assert left[0] > 10
    assert np.array_equal(found.case, wanted.case)
    assert np.array_equal(found.index, wanted.index)
    for name in ("tip_angle", "clamp_curvature", "y", "z", "energy"):
        one, other = getattr(found, name), getattr(wanted, name)
        assert np.allclose(one, other, rtol=1e-10, atol=1e-10 * (1 + some[2].max()))


def test_a_tip_that_another_has_led_to_is_not_taken_twice(monkeypatch: pytest.MonkeyPatch) -> None:
    """Each rod's tips are aimed at from its lowest one: secants then settle on that, or anywhere."""
    rods = short_rods(6, 40)
    wanted = sweep_arrays(*rods[3:8], (40,), None)
    aimed = block_shots.approached

    def lowest(function: Any, given: Any, *ends: Any) -> Any:
        share, slope = aimed(function, given, *ends)
        first = np.unique(given.clamp_angle, return_index=True, return_inverse=True)
        return share[first[1]][first[2]], slope[first[1]][first[2]]

    monkeypatch.setattr(block_shots, "approached", lowest)
    found = sweep_arrays(*rods[3:8], (40,), None)
    assert np.bincount(wanted.case).max() > 1
    assert np.array_equal(found.case, wanted.case)
    assert np.allclose(found.tip_angle, wanted.tip_angle, rtol=0, atol=1e-9)


@pytest.mark.parametrize(("slow", "most"), [(SHOT_SLOW, 1), (1.6 * pi, 2)])
def test_how_often_the_angle_at_the_clamp_ceases_to_change_with_the_tip(slow: float, most: int) -> None:
    """On rods from the tip up to a length: by differences. Pure fields about the well are the fastest."""
    rng, length = np.random.default_rng(7), np.linspace(0.02, 1, 200)[:, None] * slow
    force = np.where(rng.random(COUNT) < 0.5, rng.integers(0, 2, COUNT), rng.random(COUNT))
    field, tip = rng.uniform(-2, 2, COUNT), rng.uniform(-4, 4, COUNT)
    tip = np.where((rng.random(COUNT) < 0.3) & (force == 0), field + pi / 2 + 0.01, tip)
    square, nothing = length * length, 0 * length * tip
    load = Load(1, force * square, (1 - force) * square, np.cos(2 * field), np.sin(2 * field), nothing, 1 + nothing)
    change = miss(load, tip + 1e-5) - miss(load, tip - 1e-5)
    assert ((change[1:] > 0) != (change[:-1] > 0)).sum(axis=0).max() == most
