"""Lengths and phases of a motion are right to two roundings, however far apart its rates are."""

from __future__ import annotations

import random
from collections.abc import Iterator
from typing import Any

import pytest
from mpmath import mp, mpf

from derive.emit.kernels.landen import phase_at, swing_and_arrival
from derive.emit.kernels.swing import lengths

ULP = 2.0**-52
# In roundings of a length; the worst of thousands are 2.3 and 2.2.
LENGTHS, PHASES = 2.5, 2.5


def motions(number: int, seed: int) -> Iterator[tuple[float, float, float, float]]:
    """Rates a and b, near each other, apart and far apart, and sin²ψ and cos²ψ on both sides of the middle."""
    rng = random.Random(seed)
    for _ in range(number):
        a = 10 ** rng.uniform(-0.5, 0.5)
        b = a * 10 ** rng.choice([rng.uniform(-1, 1), rng.uniform(-4, 3), rng.uniform(-12, 6)])
        square = a / b * 100 ** rng.uniform(-1, 1)
        yield a, b, square / (1 + square), 1 / (1 + square)


def length_of(a: float, b: float, square: Any, rest: Any) -> Any:
    """The incomplete integral by its definition as F(ψ, m), in the current precision."""
    modulus = 1 - (mpf(b) / mpf(a)) ** 2
    return mp.ellipf(mp.atan2(mp.sqrt(mpf(square)), mp.sqrt(mpf(rest))), modulus) / mpf(a)


def test_lengths_are_right_to_two_roundings() -> None:
    for a, b, square, rest in motions(250, 1):
        swing, arrival = swing_and_arrival(a, b, square, rest)
        with mp.workdps(40):
            known, half = length_of(a, b, square, rest), length_of(a, b, 1, 0)
            assert abs(arrival / known - 1) < LENGTHS * ULP, (a, b, square)
            assert abs(swing / half - 1) < LENGTHS * ULP, (a, b)
        # Arrays take Gauss's steps however large they are.
        assert lengths(a, b, square, rest) == pytest.approx((swing, arrival), rel=6 * ULP)


def test_phases_are_right_to_two_roundings_of_the_length() -> None:
    for a, b, square, rest in motions(250, 2):
        with mp.workdps(40):
            length, half = float(length_of(a, b, square, rest)), length_of(a, b, 1, 0)
            left = float(half - mpf(length))
        sine, cosine = phase_at(a, b, length, left)
        # The smaller one tells: the larger one is 1 less it.
        with mp.workdps(40):
            told = (sine, 1 - mpf(sine)) if sine < cosine else (1 - mpf(cosine), cosine)
            met = length_of(a, b, *told)
            assert abs(met - mpf(length)) < PHASES * ULP * length, (a, b, length)


@pytest.mark.parametrize("b", [1e-9, 0.3, 0.71, 0.999, 1.0, 1.4, 40.0, 1e20])
@pytest.mark.parametrize("rest", [0.0, 1e-305, 4.8e-299, 1e-200, 1e-60])
def test_lengths_all_but_at_the_end_of_the_half_swing(b: float, rest: float) -> None:
    swing, arrival = swing_and_arrival(1.0, b, 1.0, rest)
    with mp.workdps(40):
        assert abs(arrival / length_of(1.0, b, 1, rest) - 1) < LENGTHS * ULP
    assert arrival <= swing * (1 + 2 * ULP)


def test_a_phase_at_the_end_of_the_half_swing() -> None:
    swing, arrival = swing_and_arrival(0.3, 2.0, 1.0, 0.0)
    assert arrival == swing
    assert phase_at(0.3, 2.0, swing, 0.0) == (1.0, 0.0)
    assert phase_at(0.3, 2.0, 0.0, swing) == (0.0, 1.0)
