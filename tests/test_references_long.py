"""References for rods of any length: against plain shooting, against other precision, and by their own checks."""

from __future__ import annotations

from collections.abc import Callable
from math import pi
from typing import Any

import numpy as np
import pytest
from mpmath import mp, mpf

from derive.measure import chains
from derive.measure.chains import Chain, Guess
from derive.measure.folds import NoFoldError, fold, fold_between
from derive.measure.hard import shot_from
from derive.measure.long_rods import profile, refine
from derive.measure.reference import NoEquilibriumError, Rod, sensitivity, solve
from derive.measure.rests import rests
from derive.measure.rods import PAPER, rods
from derive.measure.scan import brute_force
from derive.measure.segments import Base, Load
from derive.measure.taylor import integrate
from generated import field_only_numpy, parallel_numpy

SOME = [
    rods("parallel")[5],
    rods("orthogonal")[5],
    rods("oblique")[6],
    rods("force_only")[4],
    Rod(0.3, 0.8, 5, -1, 0.7),
]


def test_the_conditioning_of_a_rod_next_to_straight_is_seen() -> None:
    # The clamp is an ulp from upside down: the rod bends by some 1e-14, in proportion to that.
    rod = Rod(0.8, 0.2, 6.0, 3.1415926535897927)
    straight = parallel_numpy.equilibria(rod.beta, rod.eta, rod.length, rod.clamp_angle)[1]
    known = refine(rod, drawn(parallel_numpy, straight, rod.length)).reference
    plain = solve(rod, straight.tip_angle)
    for name in ("tip_angle", "z", "z(0.5ℓ)", "theta(0.75ℓ)"):
        assert known.sensitivity[name] == pytest.approx(plain.sensitivity[name], rel=1e-6)
    assert known.sensitivity["z"] > 50


def drawn(module: Any, equilibrium: Any, length: float) -> Guess:
    def at(s: Any) -> tuple[Any, Any]:
        shape = module.shape(equilibrium, np.minimum(s, length))
        return shape.theta, shape.curvature

    return at


def lingering(rod: Rod, log_energy: float, near: float = 0.0) -> tuple[Rod, Guess]:
    """A rod whose tip has E = −e^{log_energy} over an unstable direction, cut at a bend, and its shape in doubles."""
    with mp.workdps(60):
        load = Load.of(rod)
        bases = rests(load, near - 8, near + 8)
        level = min(range(len(bases)), key=lambda k: abs(float(bases[k].angle) - near))
        count = 4 * int(np.ceil(float(load.length) / 4))
        chain = Chain(rod, load, count, bases, False, False, level, -mp.exp(log_energy), level, 0.0, 1)
        rows = np.array([[float(part) for part in row[:3]] for row in profile(chain, chain.shoot(24))])
    bent = np.abs(rows[:, 2]) > 0.1 * np.max(np.abs(rows[:, 2]))
    cut = next(k for k in range(0, count, 4) if bent[k])
    s, theta, curvature = rows[cut:, 0] - rows[cut, 0], rows[cut:, 1], rows[cut:, 2]
    there = Rod(rod.beta, rod.eta, float(s[-1]), float(theta[0]), rod.field_angle)
    return there, lambda at: (np.interp(at, s, theta), np.interp(at, s, curvature))


@pytest.mark.long
@pytest.mark.parametrize("rod", SOME, ids=str)
def test_it_is_what_plain_shooting_gives(rod: Rod) -> None:
    for tip in brute_force(rod):
        known = solve(rod, tip)
        found = refine(rod, shot_from(rod, known.values["tip_angle"]))
        assert found.reference.index == known.index
        assert found.residual < 1e-45
        expected = sensitivity(rod, known.values["tip_angle"], 34)
        for name, value in known.values.items():
            assert abs(found.reference.values[name] - value) < mpf(10) ** -39 * (1 + rod.length)
            assert found.reference.sensitivity[name] == pytest.approx(expected[name], rel=1e-6, abs=1e-12)
        clamp = integrate(known.values["tip_angle"], rod.beta, rod.eta, rod.field_angle, rod.length, 30).clamp
        assert abs(found.fold / clamp.h - 1) < 1e-20


def test_every_node_is_on_the_rod() -> None:
    known = solve(PAPER, 0.8339812667).values["tip_angle"]
    found = refine(PAPER, shot_from(PAPER, known))
    stops = list(found.arc)
    path = integrate(known, PAPER.beta, PAPER.eta, 0, PAPER.length, stops=stops)
    for point, s, theta, curvature in zip(reversed(path.points), found.arc, found.theta, found.curvature, strict=True):
        assert abs(point.s - s) < 1e-38
        assert abs(point.theta - theta) < 1e-38
        assert abs(point.curvature - curvature) < 1e-38


def test_a_tip_next_to_rest_is_known_to_forty_digits_of_its_distance() -> None:
    # Of the force alone an endless rod is θ = 4 arctan(tan(θ₀/4) e^{−s}); the tip at rest doubles what is left of it.
    rod = Rod(1.0, 0.0, 300.0, 2.0)
    start = float(mp.tan(mpf(rod.clamp_angle) / 4))

    def shape(s: Any) -> tuple[Any, Any]:
        ratio = start * np.exp(-s)
        return 4 * np.arctan(ratio), -4 * ratio / (1 + ratio**2)

    found = refine(rod, shape)
    with mp.workdps(50):
        expected = 8 * mp.tan(mpf(2) / 4) * mp.exp(-300)
        assert abs(found.offset / expected - 1) < mpf(10) ** -39
    assert found.rest == 0
    assert found.reference.index == 0


@pytest.mark.parametrize(
    ("rod", "log_energy", "index"),
    [
        pytest.param(Rod(0.0, 1.0, 400.0, 0.0), -780.0, 0, id="the tip e^-390 from rest"),
        pytest.param(Rod(0.3, 0.7, 300.0, 0.0, 0.4), -250.0, None, id="two stays, any angle"),
        pytest.param(
            Rod(0.0, 1.0, 2200.0, 0.0),
            -1500.0,
            None,
            id="a tip below all doubles, not the longest stay",
            marks=pytest.mark.long,
        ),
        pytest.param(Rod(0.0, 1.0, 70.0, 0.0), -17.0, None, id="many half-waves"),
    ],
)
def test_long_rods_do_not_depend_on_precision(rod: Rod, log_energy: float, index: int | None) -> None:
    rod, guess = lingering(rod, log_energy)
    found, better = refine(rod, guess), refine(rod, guess, 60)
    assert index in (None, found.reference.index)
    assert found.reference.index == better.reference.index
    assert abs(found.offset / better.offset - 1) < mpf(10) ** -40
    assert abs(found.fold / better.fold - 1) < mpf(10) ** -38
    for name, value in better.reference.values.items():
        assert abs(found.reference.values[name] - value) < mpf(10) ** -40 * rod.length
    assert found.residual < 1e-45
    assert float(abs(found.offset)) == pytest.approx(float(mp.exp(log_energy / 2) * mp.sqrt(2)), rel=0.2)


def test_the_index_counts_the_half_waves_of_a_long_rod() -> None:
    rod = Rod(0.0, 1.0, 30.0, 3 * pi / 4)
    for equilibrium in field_only_numpy.equilibria(rod.eta, rod.length, rod.clamp_angle)[::6]:
        found = refine(rod, drawn(field_only_numpy, equilibrium, rod.length))
        assert found.reference.index == equilibrium.index


@pytest.mark.parametrize("small", [0.0, 1e-300, 1e-150, 1e-12])
def test_weak_loads_are_those_of_the_first_order(small: float) -> None:
    # θ ≈ θ₀ + F(θ₀)(s²/2 − ℓs), exact but for the square of the load.
    rod = Rod(0.4 * small, 0.6 * small, 80.0, 2.0, 0.7)
    found = refine(rod, lambda s: (2.0 + 0 * s, 0 * s))
    with mp.workdps(40):
        push = mpf(rod.beta) * mp.sin(2) + mpf(rod.eta) / 2 * mp.sin(2 * (2 - mpf(rod.field_angle)))
        size = 6400 * push
        assert abs(found.offset + size / 2) <= abs(size) * (small * 1e5 + mpf(10) ** -38)
        assert abs(found.reference.values["clamp_curvature"] + 80 * push) <= abs(size) * (small * 1e4 + mpf(10) ** -38)
        straight = -(mpf(rod.beta) * mp.cos(2) + mpf(rod.eta) / 2 * mp.cos(2 - mpf(rod.field_angle)) ** 2) * 80
        assert abs(found.reference.values["energy"] - straight) <= abs(straight) * (small * 1e5 + mpf(10) ** -38)
    assert found.reference.index == 0


def test_straight_rods_are_straight() -> None:
    for rod, index in ((Rod(0.5, 0.5, 30.0, 0.0), 0), (Rod(0.0, 1.0, 7.0, 0.5, 0.5), 0), (Rod(0.5, 0.0, 20.0, 0.0), 0)):
        found = refine(rod, lambda s, rod=rod: (rod.clamp_angle + 0 * s, 0 * s))
        assert found.offset == 0
        assert found.reference.index == index
        assert abs(found.reference.values["y"] - rod.length * mp.cos(rod.clamp_angle)) < 1e-15
        assert abs(found.fold - mp.cosh(mp.sqrt(mpf(rod.beta) + mpf(rod.eta)) * rod.length)) < abs(found.fold) * 1e-15


def test_a_false_first_integral_is_seen(monkeypatch: pytest.MonkeyPatch) -> None:
    true: Callable[..., Any] = chains.Chain.energy
    monkeypatch.setattr(chains.Chain, "energy", lambda self, base: true(self, base) * (1 + mpf(10) ** -20))
    monkeypatch.setattr(Base, "piece", bent(Base.piece))
    with pytest.raises(ArithmeticError, match="miss the first integral"):
        refine(PAPER, shot_from(PAPER, mpf("0.83398126671")))


def bent(true: Callable[..., Any]) -> Callable[..., Any]:
    """Pieces that do not quite solve the equation."""

    def piece(self: Base, start: Any, length: int) -> Any:
        found = true(self, start, length)
        return type(found)((found.end[0], found.end[1] * (1 + mpf(10) ** -30)), *list(vars(found).values())[1:])

    return piece


def test_a_guess_of_another_rod_is_refused() -> None:
    with pytest.raises((NoEquilibriumError, ArithmeticError)):
        refine(PAPER, lambda s: (0.1 + 0 * s, 0.01 + 0 * s))


def test_folds_are_folds() -> None:
    at = fold(PAPER, "eta", 0.00045, 2.2)
    with mp.workdps(50):
        clamp = integrate(at.tip_angle, PAPER.beta, at.value, 0, PAPER.length, 45).clamp
        assert abs(clamp.theta - mpf(PAPER.clamp_angle)) < mpf(10) ** -39
        assert abs(clamp.h) < mpf(10) ** -38
    for distance in (1e-6, 1e-10):
        inside, outside = at.beside(distance * at.opens), at.beside(-distance * at.opens)
        found = parallel_numpy.equilibria(inside.beta, inside.eta, inside.length, inside.clamp_angle)
        assert len(found) == 3
        half = np.sqrt(at.bend * distance * float(at.value))
        gaps = [abs(one.tip_angle - float(at.tip_angle)) for one in found[1:]]
        assert gaps == pytest.approx([half, half], rel=3e-2)
        assert len(parallel_numpy.equilibria(outside.beta, outside.eta, outside.length, outside.clamp_angle)) == 1


def test_folds_are_looked_for_only_where_numbers_differ() -> None:
    rod = Rod(0.35, 0.52, 6.0, 2.0, 0.7)
    assert fold_between(rod, "length", 0.5, 0.6) is None
    found = fold_between(rod, "length", 1.0, 7.9)
    assert found is not None
    assert 1.0 < found.value < 7.9
    with pytest.raises(NoFoldError):
        fold(rod, "length", 1.0, 2.0)


@pytest.mark.hours
@pytest.mark.parametrize("length", [1000.0, 8000.0])
def test_very_long_rods(length: float) -> None:
    rod, guess = lingering(Rod(0.0, 1.0, length, 0.0), -1.5 * length)
    found = refine(rod, guess)
    with mp.workdps(50):
        # Of the field alone, 2θ is what θ is of the force alone; there is a single bend.
        expected = 4 * mp.tan(mpf(rod.clamp_angle) / 2) * mp.exp(-mpf(rod.length))
        assert abs(found.offset / expected - 1) < mpf(10) ** -38
