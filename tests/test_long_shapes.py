"""The shape of long rods: where they bend beside the clamp, no digit of their length is lost."""

from __future__ import annotations

import random
from math import pi, sqrt

import kernel_module
import pytest
from mpmath import mp, mpf

from derive.emit.kernels.landen import phase_at, swing_and_arrival
from derive.emit.kernels.shapes import phase_before
from derive.measure.hard import SIZES, ULP, reference
from derive.measure.reference import Rod, along, couple_of, quantities, solve, walk
from derive.measure.rods import PAPER

# ℓ√(β + η) = 100: an ulp of the length is some hundred of θ beside the clamp.
RODS = {
    "field along the force": (Rod(3e3, 7e3, 1.0, 2.0), 0),
    "field alone, several half-swings": (Rod(0.0, 1e4, 1.0, 3 * pi / 4), 20),
    "inclined field": (Rod(6e3, 4e3, 1.0, 3 * pi / 4, 0.7), 0),
}


@pytest.mark.parametrize(("rod", "which"), RODS.values(), ids=RODS)
def test_beside_the_clamp_only_the_arc_length_is_rounded(rod: Rod, which: int) -> None:
    one = kernel_module.equilibria(rod.beta, rod.eta, rod.length, rod.clamp_angle, rod.field_angle)[which]
    known, bends = reference(kernel_module, rod, one), 0.0
    for s, theta, curvature in zip(known.arc, known.theta, known.curvature, strict=True):
        if s * mpf(rod.beta + rod.eta) ** 0.5 > 6:
            break
        place, bends = float(s), max(bends, float(abs(curvature)))
        with mp.workdps(40):
            # The node itself is no double.
            there = theta + curvature * (mpf(place) - s)
            error = float(abs(mpf(float(kernel_module.shape(one, place).theta)) - there)) / ULP
        # s is given to a rounding; that of ℓ moves the bends of rods with half-swings by as much.
        assert error <= SIZES + 2 * place * float(abs(curvature))
    assert bends > sqrt(rod.beta + rod.eta) / 4


def test_the_clamp_itself_is_met() -> None:
    for rod, _ in RODS.values():
        for one in kernel_module.equilibria(rod.beta, rod.eta, rod.length, rod.clamp_angle, rod.field_angle)[::9]:
            assert kernel_module.shape(one, 0.0).theta == pytest.approx(rod.clamp_angle, abs=6 * ULP)


def test_a_phase_before_another_is_that_of_the_difference_of_lengths() -> None:
    rng = random.Random(4)
    for _ in range(300):
        a, b = 10 ** rng.uniform(-25, 0), 10 ** rng.uniform(-25, 0)
        whole, _ = swing_and_arrival(a, b, 1.0, 0.0)
        length = whole * rng.uniform(0.01, 0.99)
        short = length * rng.uniform(0, 0.5)
        square, rest = phase_at(a, b, length, whole - length)
        square, rest = phase_before(a, b, square, rest, phase_at(a, b, short, whole - short))
        _, met = swing_and_arrival(a, b, square, rest)
        assert met == pytest.approx(length - short, rel=1e-12)
        assert square + rest == pytest.approx(1, abs=1e-14)


def test_phases_of_short_lengths_lose_nothing_to_the_steps() -> None:
    # b ≪ a: ψ is the Gudermannian of aσ, but for b², and eight of Gauss's steps are undone.
    for a, short in ((0.4, 1e-3), (0.4, 1.0), (0.39, 5.0)):
        square, rest = phase_at(a, 1e-40, short, 200.0)
        with mp.workdps(30):
            assert abs(square / mp.tanh(mpf(a) * mpf(short)) ** 2 - 1) < 16 * ULP
            assert abs(rest * mp.cosh(mpf(a) * mpf(short)) ** 2 - 1) < 32 * ULP


def test_an_arc_length_is_an_input_by_itself() -> None:
    tip = solve(PAPER, 0.8351, furthest=0.5).values["tip_angle"]
    with mp.workdps(40):
        path = quantities(PAPER, walk(PAPER, tip, 30))
        own = along(path, PAPER.length, couple_of(PAPER))
        longer = solve(PAPER, tip).sensitivity
    assert float(own["y(0.5ℓ)"]) == pytest.approx(40 * float(mp.cos(path["theta(0.5ℓ)"])))
    assert float(own["theta(0.25ℓ)"]) == pytest.approx(20 * float(path["curvature(0.25ℓ)"]))
    assert own["y"] == own["tip_angle"] == 0
    assert all(longer[name] >= abs(float(own[name])) for name in own)
