"""Counting by ball arithmetic: its enclosures hold; its numbers are those of shooting and of the solvers."""

from __future__ import annotations

from dataclasses import replace
from math import pi, sqrt
from pathlib import Path
from typing import Any

import numpy as np
import pytest

flint = pytest.importorskip("flint")

from derive.cli import main  # noqa: E402
from derive.diagrams.problem import Problem  # noqa: E402
from derive.emit.kernels.equilibria import all_equilibria  # noqa: E402
from derive.measure import counts  # noqa: E402
from derive.measure.folds import fold  # noqa: E402
from derive.measure.reference import Rod  # noqa: E402
from derive.measure.rods import PAPER  # noqa: E402
from derive.measure.taylor import integrate  # noqa: E402
from derive.measure.verified.counting import count  # noqa: E402
from derive.measure.verified.lines import Line, lines  # noqa: E402
from derive.measure.verified.means import UndecidedError, carlson, first_order, gauss_mean  # noqa: E402
from derive.measure.verified.motion import ORDER, times  # noqa: E402
from derive.measure.verified.potential import Potential, rests, scaled  # noqa: E402

INCLINED = Rod(0.35, 0.52, 5.0, 2.3, 0.7)
GIVEN = ["--beta", "0.00035", "--eta", "0.00052", "--length", "80", "--clamp-angle", "3*pi/4"]
# What a clamp can be: before and beyond a well, below and above the ridge, a hill, a well and a ridge themselves.
CLAMPS = [
    (INCLINED, 3),
    (Rod(0.2, 0.8, 4.0, 2.2, 0.4), 3),
    (Rod(0.2, 0.8, 4.0, -0.6, 0.4), None),
    pytest.param(Rod(0.7, 1.2, 6.0, pi, 0.0), None, marks=pytest.mark.long),
    (Rod(1.7, 1.2, 3.0, pi, 0.0), None),
    (Rod(0.7, 1.2, 5.0, 0.0, pi / 2), None),
    (Rod(0.7, 1.2, 9.0, 0.0, 0.0), 1),
    pytest.param(Rod(0.0, 1.0, 20.0, 3 * pi / 4, 0.0), 11, marks=pytest.mark.long),
    (Rod(1.0, 0.0, 9.0, 0.0, 0.3), 1),
    (Rod(0.9, 0.1, 0.7, 1.0, 0.3), 1),
    (Rod(1.0, 1.0001, 4.0, 2.0, pi / 2), None),  # hills next to the well between them
]


@pytest.fixture(autouse=True)
def precision() -> Any:
    """Balls of 128 bits and two derivatives."""
    before = flint.ctx.prec, flint.ctx.cap
    flint.ctx.prec, flint.ctx.cap = 128, ORDER
    yield
    flint.ctx.prec, flint.ctx.cap = before


def solved(rod: Rod) -> int:
    return len(all_equilibria(rod.beta, rod.eta, rod.length, rod.clamp_angle, rod.field_angle, None))


def families(rod: Rod) -> tuple[Potential, list[Line]]:
    """V, as it is or mirrored, and the lines of motions."""
    potential, length, level = scaled(rod)
    potential = potential if potential.slope(flint.arb(0)) > 0 else potential.mirrored
    return potential, lines(potential, length, level=level)


@pytest.mark.parametrize(("rod", "number"), CLAMPS)
def test_every_kind_of_clamp(rod: Rod, number: int | None) -> None:
    found = count(rod)
    assert found == solved(rod)
    assert number in (None, found)
    assert (flint.ctx.prec, flint.ctx.cap) == (128, ORDER)


def test_the_numbers_are_those_of_shooting() -> None:
    rng, rods = np.random.default_rng(5), []
    for _ in range(2):
        share, slow = rng.uniform(), rng.uniform(4, 7)
        rods.append(
            Rod(slow**2 * share, slow**2 * (1 - share), 1.0, rng.uniform(-pi, pi), rng.uniform(-pi / 2, pi / 2))
        )
    assert [count(rod) for rod in rods] == [one.number for one in counts.count(rods)]


@pytest.mark.long
@pytest.mark.parametrize("seed", range(6))
def test_long_inclined_rods(seed: int) -> None:
    rng = np.random.default_rng(seed)
    share, slow = rng.uniform(), rng.uniform(10, 40)
    rod = Rod(slow**2 * share, slow**2 * (1 - share), 1.0, rng.uniform(-pi, pi), rng.uniform(-pi / 2, pi / 2))
    assert count(rod) == solved(rod)


@pytest.mark.long
def test_beside_a_fold_there_are_two_more_on_one_side() -> None:
    at = float(fold(PAPER, "eta", 0.00045, 2.2).value)
    assert [count(replace(PAPER, eta=at * factor)) for factor in (1 - 1e-12, 1 + 1e-12)] == [1, 3]
    # Once undecided, for both lengths change by more over a cell than the number does.
    rod = Rod(37.21666501337881, 69.11666359627493, 1.0, 1.8216008035157254, -0.7311818863926778)
    assert [count(replace(rod, clamp_angle=rod.clamp_angle + less)) for less in (-1e-10, 0)] == [5, 3]


def test_on_the_astroid_nothing_is_told() -> None:
    assert count(Rod(1.0, 2.0, 5.0, 1.0, pi / 4)) is None


def test_times_are_those_of_the_motion() -> None:
    """From the turning point ahead back to the clamp, and on to the other turning point, by Taylor integration."""
    for rod in (INCLINED, Rod(0.2, 0.8, 5.0, 2.2, 0.4)):
        _, found = families(rod)
        sense = 1 if scaled(rod)[0].slope(flint.arb(0)) > 0 else -1
        unit = sqrt(rod.beta + rod.eta)
        for line, place in ((line, place) for line in found for place in (-0.8, 0.4, 1.7)):
            arrival, swing = (abs(float(part[0])) / unit for part in times(line.well, line.path, place, place))
            turns = [rod.clamp_angle + sense * float(line.well.turning(line.path, place, side)) for side in (0, 1)]
            here, there = turns[line.path.up], turns[not line.path.up]
            for length, angle in ((arrival, rod.clamp_angle), (swing, there)):
                reached = integrate(here, rod.beta, rod.eta, rod.field_angle, length, 20).clamp
                assert float(reached.theta) == pytest.approx(angle, abs=1e-11)


def test_balls_of_times_hold_what_lies_between() -> None:
    widths = []
    for rod in (INCLINED, Rod(0.2, 0.8, 5.0, 2.2, 0.4)):
        for line in families(rod)[1]:
            for low in (-2.0, -0.01, 0.7, 3.0):
                high = low + 0.02
                whole = times(line.well, line.path, low, high)
                for place in np.linspace(low, high, 5):
                    for ball, point in zip(whole, times(line.well, line.path, place, place), strict=True):
                        assert ball[0].overlaps(point[0])
                        assert ball[1].overlaps(point[1])
                ends = [times(line.well, line.path, end, end) for end in (low, high)]
                for ball, first, last in zip(whole, *ends, strict=True):
                    assert ball[1].contains(((last[0] - first[0]) / 0.02).mid())
                    widths.append(float(ball[1].rad()) / (1 + abs(float(ball[1]))))
    assert np.median(widths) < 0.5  # bounds, not merely large numbers


def test_means_are_those_of_flint_and_wide_balls_hold_them() -> None:
    rng = np.random.default_rng(2)
    for _ in range(40):
        one, other = (flint.arb(float(10 ** rng.uniform(-6, 3))) for _ in range(2))
        exact = one.agm(other)
        assert gauss_mean(first_order(one), first_order(other))[0].overlaps(exact)
        wide = [first_order(flint.arb(float(part), 0.1 * float(part))) for part in (one, other)]
        assert gauss_mean(*wide)[0].contains(exact)
        y = flint.acb(float(10 ** rng.uniform(-4, 4)), float(rng.choice([0, 1, 30])))
        z = y.conjugate() if y.imag != 0 else flint.acb(float(10 ** rng.uniform(-4, 4)))
        product = (y * z).real
        root = (y + z).real + 2 * product.sqrt()
        exact = flint.acb.elliptic_rf(flint.acb(1), y, z).real
        found = carlson(first_order(root), first_order(product))[0]
        assert found.overlaps(exact)
        assert found.rad() < 1e-20 * exact
        assert carlson(*(first_order(flint.arb(part.mid(), 0.1 * part.mid())) for part in (root, product)))[0].contains(
            exact
        )


def test_derivatives_of_means_are_their_differences() -> None:
    step = flint.arb(2) ** -40
    for of, numbers in ((gauss_mean, (0.3, 2.0)), (carlson, (3.0, 0.7)), (carlson, (0.5, 40.0))):
        for slopes in ((1, 0), (0, 1)):
            shifted = [
                [first_order(x + sign * step * d) for x, d in zip(numbers, slopes, strict=True)] for sign in (-1, 1)
            ]
            difference = (of(*shifted[1])[0] - of(*shifted[0])[0]) / (2 * step)
            exact = of(*(first_order(x, d) for x, d in zip(numbers, slopes, strict=True)))[1]
            assert abs(float(exact - difference)) < 1e-15


def test_directions_without_moment_are_all_found() -> None:
    for rod, hills in ((INCLINED, 4), (Rod(0.2, 0.8, 5.0, 2.2, 0.4), 8), (Rod(0.0, 1.0, 1.0, 1.0, 0.2), 8)):
        found = rests(scaled(rod)[0])
        assert len(found) == 2 * sum(rest.hill for rest in found) == 2 * hills
    cusp = Rod(1.0, 2.0, 5.0, 1.0, pi / 4)  # on the astroid: a hill and a well meet
    with pytest.raises(UndecidedError):
        rests(scaled(cusp)[0])


def test_the_command_proves_the_number(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["solve", "parallel", *GIVEN, "--count"]) == 0
    assert "proved by ball arithmetic" in capsys.readouterr().out


def test_the_command_fails_where_one_is_lost(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    every = Problem.equilibria
    monkeypatch.setattr(Problem, "equilibria", lambda *given: every(*given)[1:])
    assert main(["solve", "parallel", *GIVEN, "--count"]) == 1
    (line,) = capsys.readouterr().err.splitlines()
    assert line == "derive solve: 2 found, but 3 proved to exist: a fault of the solver"


def test_the_command_refuses_what_does_not_go_together(capsys: pytest.CaptureFixture[str]) -> None:
    for more in (["--max-index", "0"], ["--target", "y=1"]):
        assert main(["solve", "parallel", *GIVEN, "--count", *more]) == 2
        assert "--count" in capsys.readouterr().err
