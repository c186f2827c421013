"""Balls hold exact results; the rod from its tip is enclosed; counts and branches agree with what is known exactly."""

from __future__ import annotations

from fractions import Fraction
from math import isfinite

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from mpmath import mp

from derive.check import balls
from derive.check.balls import Ball
from derive.check.counting import alone, barrier, count
from derive.check.rod_flow import integrate
from derive.check.shooting import Rod, gaps, shoot

NUMBERS = st.floats(-1e6, 1e6, allow_subnormal=False)
RADII = st.floats(0, 1e3, allow_subnormal=False)
SHARES = st.floats(-1, 1)


def ball(mid: float, rad: float) -> Ball:
    return Ball(np.array([mid]), np.array([rad]))


def inside(one: Ball, share: float) -> Fraction:
    """An exact number of a ball."""
    return Fraction(float(one.mid[0])) + Fraction(share) * Fraction(float(one.rad[0]))


def holds(one: Ball, number: Fraction) -> bool:
    return abs(number - Fraction(float(one.mid[0]))) <= Fraction(float(one.rad[0]))


@given(NUMBERS, RADII, NUMBERS, RADII, SHARES, SHARES)
def test_operations_hold_the_exact_result(a: float, r: float, b: float, q: float, x: float, y: float) -> None:
    one, other = ball(a, r), ball(b, q)
    p, s = inside(one, x), inside(other, y)
    assert holds(one + other, p + s)
    assert holds(one - other, p - s)
    assert holds(one * other, p * s)
    quotient = one / other
    if isfinite(quotient.rad[0]):
        assert holds(quotient, p / s)
    else:
        assert q >= abs(b) * (1 - 1e-12)


@given(st.lists(st.tuples(NUMBERS, RADII, SHARES), min_size=1, max_size=6))
def test_products_of_series_hold_the_exact_coefficient(terms: list[tuple[float, float, float]]) -> None:
    series = Ball(np.array([[m] for m, _, _ in terms]), np.array([[r] for _, r, _ in terms]))
    exact = [inside(series[n], share) for n, (_, _, share) in enumerate(terms)]
    whole = sum((p * q for p, q in zip(exact, exact[::-1], strict=True)), Fraction(0))
    assert holds(balls.series_product(series, series), whole)


@given(st.floats(-8, 8), st.floats(0, 0.1), SHARES)
def test_sines_are_enclosed(angle: float, rad: float, share: float) -> None:
    one = ball(angle, rad)
    with mp.workdps(40):
        at = mp.mpf(angle) + mp.mpf(share) * mp.mpf(rad)
        for found, exact in zip(balls.sine_cosine(one), (mp.sin(at), mp.cos(at)), strict=True):
            assert abs(exact - mp.mpf(float(found.mid[0]))) <= mp.mpf(float(found.rad[0]))


def test_pi_and_rationals_are_enclosed() -> None:
    with mp.workdps(40):
        assert abs(mp.pi - mp.mpf(float(balls.pi().mid))) <= mp.mpf(float(balls.pi().rad))
    third = balls.rational(Fraction(1, 3))
    assert abs(Fraction(1, 3) - Fraction(float(third.mid))) <= Fraction(float(third.rad))
    assert balls.rational(Fraction(1, 4)).rad == 0


def reference(tip: float, force: float, field: float) -> list[mp.mpf]:
    """θ, y and z at the clamp by mpmath's own integration."""
    with mp.workdps(18):
        solution = mp.odefun(
            lambda _, x: [x[1], mp.sin(x[0]) * (force + field * mp.cos(x[0])), mp.cos(x[0]), mp.sin(x[0])],
            0,
            [mp.mpf(tip), mp.mpf(0), mp.mpf(0), mp.mpf(0)],
        )
        theta, _, y, z = solution(1)
    return [theta, y, z]


@settings(deadline=None, max_examples=4)
@given(st.floats(0.1, 3), st.floats(0, 4), st.floats(-6, 6), st.floats(0, 0.02), SHARES)
def test_the_flow_is_enclosed(tip: float, force: float, field: float, rad: float, share: float) -> None:
    found = integrate(ball(tip, rad), balls.exactly(force), ball(field, rad), derivatives=False)
    exact = reference(tip + share * rad * 0.999, force, field - share * rad * 0.999)
    for one, value in zip((found.angle, found.y, found.z), exact, strict=True):
        assert abs(value - mp.mpf(float(one.mid[0]))) <= mp.mpf(float(one.rad[0]))


def test_derivatives_are_enclosed() -> None:
    step = 1e-5
    at, force = (1.1, 2.0), balls.exactly(1.5)
    found = integrate(balls.exactly([at[0]]), force, balls.exactly([at[1]]))
    for derivatives, tips, fields in (
        (found.by_tip, (at[0] - step, at[0] + step), (at[1], at[1])),
        (found.by_field, (at[0], at[0]), (at[1] - step, at[1] + step)),
    ):
        low, high = (reference(t, 1.5, f) for t, f in zip(tips, fields, strict=True))
        for name, one, other in zip(("angle", "y", "z"), low, high, strict=True):
            slope = float((other - one) / (2 * step))
            assert abs(slope - derivatives[name].mid[0]) < derivatives[name].rad[0] + 1e-8


def test_the_mean_value_form_holds_what_single_tips_give() -> None:
    rod = Rod(Fraction(80), Fraction(3, 4), Fraction(35, 100_000))
    boxes = balls.between(np.array([0.8, 1.7]), np.array([0.9, 1.8]))
    wide = shoot(rod, boxes, balls.exactly(np.array([3.0, 3.1])))
    for share in (-1.0, -0.3, 0.5, 1.0):
        single = gaps(rod, boxes.mid + share * boxes.rad * 0.999, balls.exactly(np.array([3.0, 3.1])))
        assert np.all(single.lower() >= wide.gap.lower())
        assert np.all(single.upper() <= wide.gap.upper())


def euler(load: str) -> Rod:
    """A rod clamped against its force (θ = π), ℓ = 1: it buckles at β = (π/2)²."""
    return Rod(Fraction(1), Fraction(1), Fraction(load))


@pytest.mark.parametrize(("load", "number"), [("2.4", 1), ("2.5", 3), ("20", 3)])
def test_the_buckling_load_of_euler(load: str, number: int) -> None:
    assert count(euler(load), Fraction(0)) == number


def test_what_cannot_be_decided_is_not_decided() -> None:
    assert count(Rod(Fraction(1), Fraction(1), Fraction(np.pi**2 / 4)), Fraction(0)) is None


def test_one_equilibrium_or_more_over_an_interval_of_fields() -> None:
    weak, strong = (Rod(Fraction(80), Fraction(3, 4), Fraction(beta)) for beta in ("0.0001", "0.0005"))
    assert alone(weak, Fraction(0), Fraction("0.0005"))
    assert alone(weak, Fraction(0), Fraction("0.0002"), sense=-1)
    assert not alone(weak, Fraction(0), Fraction("0.0002"), sense=1)
    assert not alone(strong, Fraction("0.0009"), Fraction("0.001"))


def test_a_barrier_is_no_equilibrium() -> None:
    rod = Rod(Fraction(80), Fraction(3, 4), Fraction("0.0005"))
    wall = barrier(rod, Fraction("0.0005"), (1.0, 2.3))
    assert wall is not None
    assert float(gaps(rod, np.array([wall]), rod.fields(Fraction("0.0003"), Fraction("0.0003"))).lower()[0]) > 0


def test_a_field_across_the_force_cannot_be_counted() -> None:
    with pytest.raises(ValueError, match="along the force"):
        count(Rod(Fraction(1), Fraction(1, 2), Fraction(1), across=True), Fraction(1))
