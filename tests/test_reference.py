"""The references against what is known otherwise: SciPy, closed forms of the linear limit, the article's rod."""

from __future__ import annotations

from math import cos, cosh, pi, sin, sqrt

import numpy as np
import pytest
from mpmath import mp, mpf
from scipy.integrate import solve_ivp
from scipy.special import ellipk

from derive.measure.reference import NoEquilibriumError, Reference, Rod, solve
from derive.measure.rods import PAPER, rods
from derive.measure.scan import brute_force
from derive.measure.taylor import integrate

ROUND_TRIP = 1e-10  # what DOP853 reaches at rtol 1e-13 on these rods


def test_the_articles_rod() -> None:
    found = [solve(PAPER, tip) for tip in brute_force(PAPER)]
    assert [r.index for r in found] == [0, 1, 0]
    tips = [mp.nstr(r.values["tip_angle"], 18) for r in found]
    assert [t[:12] for t in tips] == ["0.8339812667", "1.7656361110", "2.4485976108"]
    assert [mp.nstr(r.values["y"], 15)[:11] for r in found] == ["14.79473275", "-31.6926079", "-59.8490905"]


def test_forty_digits_do_not_depend_on_the_order() -> None:
    one = integrate("1.7", 0.5, 0.5, 0.3, 20, 40, stops=[3, 11])
    two = integrate("1.7", 0.5, 0.5, 0.3, 20, 40, stops=[3, 7, 11], more_terms=17)
    assert one.index == two.index == 3
    for name in ("theta", "curvature", "y", "z", "energy"):
        assert abs(getattr(one.clamp, name) - getattr(two.clamp, name)) < mpf(10) ** -40


@pytest.mark.parametrize(
    "rod", [*rods("parallel")[:6], *rods("orthogonal")[:6], Rod(0.3, 0.8, 5.0, -1.0, 0.7)], ids=str
)
def test_against_scipy(rod: Rod) -> None:
    found = solve(rod, brute_force(rod)[0])
    field, start = rod.field_angle, [rod.clamp_angle, float(found.values["clamp_curvature"]), 0, 0, 0]

    def right_side(s: float, at: np.ndarray) -> list[float]:
        theta, rate = at[0], at[1]
        density = rate**2 / 2 - rod.eta / 2 * cos(theta - field) ** 2 - rod.beta * cos(theta)
        couple = rod.beta * sin(theta) + rod.eta / 2 * sin(2 * (theta - field))
        return [rate, couple, cos(theta), sin(theta), density]

    end = solve_ivp(right_side, (0, rod.length), start, method="DOP853", rtol=1e-13, atol=1e-14).y[:, -1]
    for name, value in zip(("tip_angle", "y", "z", "energy"), (end[0], end[2], end[3], end[4]), strict=True):
        assert float(found.values[name]) == pytest.approx(value, abs=ROUND_TRIP * (1 + rod.length) * 10)
    assert abs(end[1]) < ROUND_TRIP * 10


def test_small_deflections_are_those_of_the_linear_rod() -> None:
    # θ″ = κ²θ with κ² = β + η, θ(0) = a, θ′(ℓ) = 0 gives θ(ℓ) = a/cosh κℓ; the next term is cubic in a.
    a, beta, eta, length = 1e-8, 0.4, 0.5, 2.0
    found = solve(Rod(beta, eta, length, a), a / cosh(sqrt(beta + eta) * length))
    assert float(found.values["tip_angle"]) == pytest.approx(a / cosh(sqrt(beta + eta) * length), rel=1e-14)
    assert found.index == 0


def test_elastica_passes_the_quarter_period() -> None:
    # A pendulum released at rest 2 rad from the bottom is there after K(sin² 1)/√β.
    beta, tip = 0.7, pi - 2.0
    path = integrate(tip, beta, 0, 0, ellipk(sin(1.0) ** 2) / sqrt(beta), 25)
    assert float(path.clamp.theta) == pytest.approx(pi, abs=1e-14)


def test_index_counts_the_half_waves_of_a_straight_rod() -> None:
    # Pushed along its axis, h = cos(√β σ): one zero for every odd multiple of π/2.
    for length in (1.0, 2.0, 4.0, 5.0, 9.0):
        assert integrate(mp.pi, 1, 0, 0, length, 20).index == int((length + pi / 2) // pi)


@pytest.mark.parametrize(("scaled", "count"), [(5, 3), (10, 5), (20, 11)])
def test_number_of_equilibria_grows_with_the_length(scaled: float, count: int) -> None:
    assert len(brute_force(Rod(0.0, 1.0, scaled, 3 * pi / 4))) == count


def test_sensitivity_is_the_response_to_a_changed_input() -> None:
    rod = Rod(0.3, 0.8, 3.0, 2.0)
    found = solve(rod, brute_force(rod)[0])
    change, expected = 1e-7, 0.0
    for name in ("beta", "eta", "length", "clamp_angle"):
        moved = Rod(**{**vars(rod), name: getattr(rod, name) * (1 + change)})
        there = solve(moved, found.values["tip_angle"])
        expected += float(abs(there.values["y"] - found.values["y"]) / mpf(change))
    assert found.sensitivity["y"] == pytest.approx(expected, rel=1e-5)


def test_a_guess_that_belongs_to_no_equilibrium_is_refused() -> None:
    with pytest.raises(NoEquilibriumError, match="no equilibrium within"):
        solve(PAPER, 2.0)
    with pytest.raises(ValueError, match="brute force is for"):
        brute_force(Rod(1.0, 1.0, 40.0, 1.0))


def test_references_survive_json() -> None:
    found = solve(PAPER, 0.8339812667)
    again = Reference.from_json(found.to_json())
    assert again.rod == found.rod
    assert all(abs(again.values[name] - value) < mpf(10) ** -40 for name, value in found.values.items())
