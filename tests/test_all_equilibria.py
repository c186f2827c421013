"""Nothing is missing and nothing is false: random rods of all load cases, and rods with hundreds of equilibria.

What brute force counts (`measure.counts`, no formula shared) is what the kernels find; every shape solves the equation
of equilibrium and keeps to its first integral.
"""

from __future__ import annotations

from importlib import import_module
from math import atan, cos, isfinite, nextafter, pi, sin, sqrt, tan
from types import SimpleNamespace
from typing import Any, NamedTuple

import numpy as np
import pytest
from numpy.typing import NDArray

from derive.emit.kernels.equilibria import all_equilibria
from derive.emit.kernels.shapes import angle_and_position
from derive.measure.agreement import arguments
from derive.measure.chains import Guess
from derive.measure.counts import count
from derive.measure.hard import wrong_in_kind
from derive.measure.long_rods import refine
from derive.measure.reference import Rod
from generated import parallel_mpmath


class Fixed(NamedTuple):
    """What a scene fixes of a rod: shares of force and field, the field's angle, length, clamp; None is any."""

    shares: tuple[float, float] | None = None
    field_angle: float | None = None
    length: float | None = None
    clamp_angle: float | None = None


SCENES = {
    "field_only": Fixed((0.0, 1.0), 0.0),
    "force_only": Fixed((1.0, 0.0), 0.0),
    "parallel": Fixed(None, 0.0),
    "orthogonal": Fixed(None, pi / 2),
    "oblique": Fixed(),
    "remote_control": Fixed(None, pi / 2, 80.0, pi / 2),
    "bifurcation": Fixed(None, 0.0, 80.0, 3 * pi / 4),
}
LONGEST = 8.9  # of ℓ√(β + η): a little less than what can be counted
ULP = 2.0**-52
# What differences of a shape may be off by, of which each costs some roundings of θ over the step.
ROUNDINGS = 400.0
# Of a fourth-order difference with a step h of the scaled length; the sixth derivative is of order 10² at most.
STEP = 2.0**-8


def random_rods(number: int, seed: int) -> list[Rod]:
    """Rods of all scenes in turn: loads of any size, also lopsided ones, and any clamp."""
    rng = np.random.default_rng(seed)
    found = []
    for k in range(number):
        fixed = list(SCENES.values())[k % len(SCENES)]
        lopsided = 10 ** rng.uniform(-12, 0) if rng.uniform() < 0.3 else rng.uniform()
        shares = fixed.shares or ((lopsided, 1 - lopsided) if rng.uniform() < 0.5 else (1 - lopsided, lopsided))
        drawn_ones = 10 ** rng.uniform(-2, 3), rng.uniform(-7, 7), rng.uniform(-pi, pi)
        known = fixed.length, fixed.clamp_angle, fixed.field_angle
        length, clamp, angle = (a if b is None else b for a, b in zip(drawn_ones, known, strict=True))
        stiffness = (rng.uniform(0.05, LONGEST) / length) ** 2
        found.append(Rod(stiffness * shares[0], stiffness * shares[1], length, clamp, angle))
    return found


def scene_of(rod: Rod) -> str:
    """The narrowest scene that a rod is of."""

    def fits(fixed: Fixed) -> bool:
        shares, *rest = fixed
        loads = shares is None or [share == 0 for share in shares] == [rod.beta == 0, rod.eta == 0]
        values = rod.field_angle, rod.length, rod.clamp_angle
        return loads and all(known in (None, value) for known, value in zip(rest, values, strict=True))

    names = [name for name, fixed in SCENES.items() if fits(fixed)]
    return max(names, key=lambda name: sum(part is not None for part in SCENES[name]))


def astroid_rods(number: int, seed: int) -> list[Rod]:
    """Rods whose second hill and well merge, or all but: β/η on and beside Stoner and Wohlfarth's astroid.

    A third of the clamps is where they merge, a third near it.
    """
    rng = np.random.default_rng(seed)
    found = []
    for k in range(number):
        angle = [pi / 4, -pi / 4, rng.uniform(0.05, 1.5), -rng.uniform(0.05, 1.5), 0.01, pi / 2 - 1e-3][k % 6]
        ratio = (abs(sin(angle)) ** (2 / 3) + cos(angle) ** (2 / 3)) ** 1.5
        beside = rng.choice([0.0, 1e-16, 1e-15, 1e-13, 1e-11, 1e-9, 1e-6, 1e-3]) * rng.uniform(-3, 3)
        beta = 10 ** rng.uniform(-3, 1)
        eta = beta * ratio * (1 + beside)
        merged = pi + abs(angle) + atan(abs(tan(angle)) ** (1 / 3))
        clamp = [0.0, 10 ** rng.uniform(-16, -1) * rng.choice([-1, 1]), rng.uniform(-4, 4)][k % 3]
        clamp += merged * (1 if angle > 0 else -1)
        found.append(Rod(beta, eta, rng.uniform(0.3, LONGEST) / sqrt(beta + eta), clamp, angle))
    return found


def extreme_rods(number: int, seed: int) -> list[Rod]:
    """Loads from 0 and 1e-300 to 1e3, ℓ√(β + η) to 10⁴, clamps and fields at and a rounding off special directions."""
    rng = np.random.default_rng(seed)

    def load() -> float:
        tiny = [0.0, 1e-300, 10 ** rng.uniform(-300, 3), 10 ** rng.uniform(-30, 2), 10 ** rng.uniform(-3, 1)]
        return float(tiny[rng.integers(5)])

    def special() -> float:
        angle = float(rng.choice([-pi, -pi / 2, 0, pi / 4, pi / 2, pi, 3 * pi / 2, 2 * pi]))
        angle = nextafter(angle, float(rng.choice([-9, 9]))) if rng.uniform() < 0.5 else angle
        return angle + float(rng.choice([0, 0, 1e-15, -1e-12, 1e-8]))

    found = []
    for _ in range(number):
        beta, eta = load(), load()
        eta = eta if beta + eta > 0 else 1.0
        length = 10 ** rng.uniform(-6, rng.integers(1, 5)) / sqrt(beta + eta)
        clamp = special() if rng.uniform() < 0.5 else rng.uniform(-7, 7)
        angle = [0.0, pi / 2, special(), rng.uniform(-4, 4)][rng.integers(4)]
        found.append(Rod(beta, eta, length, clamp, angle))
    return found


def solved(rod: Rod) -> list[Any]:
    """All equilibria by the kernels."""
    found: list[Any] = all_equilibria(rod.beta, rod.eta, rod.length, rod.clamp_angle, rod.field_angle, None)
    return found


def emitted(rod: Rod) -> list[Any]:
    """The same by the emitted module of the narrowest scene that the rod is of."""
    module = import_module(f"generated.{scene_of(rod)}_numpy")
    found: list[Any] = module.equilibria(**arguments(module.equilibria, rod))
    return found


def drawn(equilibrium: Any, length: float) -> Guess:
    """θ and θ′ of an equilibrium along the rod."""

    def at(s: Any) -> tuple[Any, Any]:
        rows = [angle_and_position(equilibrium, min(float(part), length))[:2] for part in s]
        return np.array([row[0] for row in rows]), np.array([row[1] for row in rows])

    return at


def test_random_rods_have_the_counted_equilibria() -> None:
    check_counts(random_rods(250, 11))


def test_shapes_solve_the_equation() -> None:
    for rod in random_rods(25, 12):
        for equilibrium in solved(rod):
            check_shape(rod, equilibrium)


def test_rods_beside_the_astroid_have_the_counted_equilibria() -> None:
    counts = count(astroid_rods(150, 5))
    assert sum(counted.tips is None for counted in counts) <= len(counts) // 20
    for counted in counts:
        found = solved(counted.rod)
        assert not wrong_in_kind(found, counted.number), counted.rod
        assert counted.indices in (None, tuple(one.index for one in found)), counted.rod


def test_extreme_rods_have_equilibria() -> None:
    for rod in extreme_rods(400, 3):
        found = all_equilibria(rod.beta, rod.eta, rod.length, rod.clamp_angle, rod.field_angle, 3)
        assert found, rod
        for one in found:
            numbers = (one.tip_angle, one.clamp_curvature, one.gamma, one.y, one.z, one.energy)
            assert all(isfinite(number) for number in numbers), rod


def test_a_rod_as_long_as_its_half_swings() -> None:
    # The clamp is then a turning point, without curvature; it is found between the last sample and the end itself.
    for eta, tip in ((0.001694037927661754, pi - 2), (0.0067761517106470163, 2.0)):
        found = solved(Rod(0.0, eta, 80.0, 2.0, 0.0))
        (one,) = [one for one in found if abs(one.tip_angle - tip) < 1e-9 and abs(one.clamp_curvature) < 1e-12]
        assert isfinite(one.y + one.z + one.energy)
        assert not wrong_in_kind(found, None)


@pytest.mark.parametrize("beta", [1e-40, 2.3e-23, 1e-18, 1e-12])
def test_a_clamp_that_counts_as_a_ridge_is_as_far_from_the_hills(beta: float) -> None:
    """A rounding off it, too: a tip whose motion rests there was missing on one side."""
    clamps = (nextafter(pi, 0), pi, nextafter(pi, 9))
    found = [solved(Rod(beta, 9.3e-4, 7100.0, sign * clamp, 0.0)) for sign in (1, -1) for clamp in clamps]
    assert all(not wrong_in_kind(one, None) for one in found)
    assert len({len(one) for one in found}) == 1


@pytest.mark.parametrize("beta", [1.0, 3.0, 6.3, 10.0, 30.0])
def test_long_rods_that_all_but_rest_on_a_ridge(beta: float) -> None:
    # A motion passes the ridge by less than any rounding of the potential, and still by so much and no less.
    rod = Rod(beta, 1e4, 1.0, 3 * pi / 4, 0.0)
    found = solved(rod)
    assert not wrong_in_kind(found, None)


def test_a_force_that_all_but_vanishes_beside_a_long_field() -> None:
    # Each of these once ended in a division by zero: V of hill and ridge differ by less than any rounding.
    assert not wrong_in_kind(solved(Rod(1e-100, 1.0, 1000.0, 2.3, 0.3)), None)
    assert not wrong_in_kind(solved(Rod(1.0, 1.0, 265.0, -6.413092806963318, pi / 2)), None)
    assert len(solved(Rod(2.01e-22, 7.744, 0.105, 4e-323, pi - 1e-12))) == 1
    # Clamped within 1e-8 of a hill, from where the level of the ridge is told by the distance from the hill alone.
    found = solved(Rod(2.697960732202673e-22, 0.17354894293016032, 290.64056494266777, -3.141592643589793, 0.0))
    assert not wrong_in_kind(found, None)
    twins = parallel_mpmath.equilibria(
        2.697960732202673e-22, 0.17354894293016032, 290.64056494266777, -3.141592643589793, dps=60
    )
    assert [one.index for one in found] == [one.index for one in twins]
    assert [one.tip_angle for one in found] == pytest.approx([float(one.tip_angle) for one in twins], abs=1e-15)
    assert not wrong_in_kind(solved(Rod(4.88e-16, 0.00664, 1361.3, 1.5707963367948963, -1.5707963167948968)), None)


@pytest.mark.hours
def test_thousands_of_extreme_rods() -> None:
    for rod in astroid_rods(3000, 7) + extreme_rods(10000, 8):
        stiffness = rod.length * sqrt(rod.beta + rod.eta)
        most = None if stiffness < 300 else 4
        found = all_equilibria(rod.beta, rod.eta, rod.length, rod.clamp_angle, rod.field_angle, most)
        assert found, rod
        assert most is not None or not wrong_in_kind(found, None), rod


@pytest.mark.long
@pytest.mark.parametrize("seed", range(5))
def test_thousands_of_rods(seed: int) -> None:
    rods = random_rods(420, 100 + seed)
    assert {scene_of(rod) for rod in rods} == set(SCENES)
    check_counts(rods)
    for rod in rods:
        for equilibrium in solved(rod):
            check_shape(rod, equilibrium)


def check_counts(rods: list[Rod]) -> None:
    """Numbers, indices and tips are the counted ones, by kernels and by modules; what is left undecided is rare."""
    counts = count(rods)
    assert sum(counted.tips is None for counted in counts) <= len(rods) // 100
    for counted, found in ((counted, solver(counted.rod)) for counted in counts for solver in (solved, emitted)):
        assert not wrong_in_kind(found, counted.number), counted.rod
        if counted.tips is not None:
            assert tuple(one.index for one in found) == counted.indices, counted.rod
            assert [one.tip_angle for one in found] == pytest.approx(counted.tips, abs=1e-7), counted.rod


def check_shape(rod: Rod, equilibrium: Any) -> None:
    """θ(0), θ′(ℓ), θ″ against the right side, y′ and z′, and the first integral, all along the rod."""
    scale = max(sqrt(rod.beta + rod.eta), 1 / rod.length)
    step = STEP / scale
    middles = np.linspace(0.05, 0.95, 7) * (rod.length - 4 * step) + 2 * step
    at = np.add.outer(middles, np.arange(-2, 3) * step)
    theta, curvature, y, z = along(equilibrium, at)
    here = theta[:, 2]
    blur = ROUNDINGS * ULP * (1 + abs(rod.clamp_angle) + abs(equilibrium.tip_angle)) / STEP
    assert slope(curvature) / step == pytest.approx(moment(rod, here), abs=(blur + 1e-9) * scale**2)
    assert slope(theta) / step == pytest.approx(curvature[:, 2], abs=(blur + 1e-9) * scale)
    size = rod.length * scale
    assert slope(y) / step == pytest.approx(np.cos(here), abs=blur * size + 1e-9)
    assert slope(z) / step == pytest.approx(np.sin(here), abs=blur * size + 1e-9)
    ends = along(equilibrium, np.array([[0.0], [rod.length]]))
    assert ends[0].ravel() == pytest.approx([rod.clamp_angle, equilibrium.tip_angle], abs=blur * STEP * size)
    assert ends[1].ravel() == pytest.approx([equilibrium.clamp_curvature, 0], abs=blur * STEP * size * scale)
    assert [ends[2][1, 0], ends[3][1, 0]] == pytest.approx([equilibrium.y, equilibrium.z], abs=blur * STEP * rod.length)
    drift = curvature**2 + 2 * rod.beta * np.cos(theta) + rod.eta * np.cos(theta - rod.field_angle) ** 2
    assert drift == pytest.approx(equilibrium.gamma, abs=blur * STEP * size * scale**2)


def along(equilibrium: Any, at: NDArray[np.float64]) -> list[NDArray[np.float64]]:
    """θ, θ′, y and z at arc lengths."""
    rows = [angle_and_position(equilibrium, float(s)) for s in at.ravel()]
    return [np.array(column).reshape(at.shape) for column in zip(*rows, strict=True)]


def slope(values: NDArray[np.float64]) -> NDArray[np.float64]:
    """The derivative times the step, in the middle of five values, to the fourth order."""
    difference: NDArray[np.float64] = (8 * (values[:, 3] - values[:, 1]) - (values[:, 4] - values[:, 0])) / 12
    return difference


def moment(rod: Rod, theta: NDArray[np.float64]) -> NDArray[np.float64]:
    """θ″."""
    right_side: NDArray[np.float64] = rod.beta * np.sin(theta) + rod.eta / 2 * np.sin(2 * (theta - rod.field_angle))
    return right_side


def test_a_false_shape_is_seen() -> None:
    rod = Rod(0.35, 0.52, 6.0, 2.3, 0.7)
    for equilibrium in solved(rod):
        check_shape(rod, equilibrium)
        with pytest.raises(AssertionError):
            check_shape(Rod(0.35, 0.52 * (1 + 1e-6), 6.0, 2.3, 0.7), equilibrium)


def many(scaled_length: float) -> tuple[Rod, list[Any]]:
    """The field alone, a clamp at 3π/4."""
    rod = Rod(0.0, 1.0, scaled_length, 3 * pi / 4)
    return rod, solved(rod)


def test_five_hundred_and_thirty_nine_equilibria() -> None:
    rod, found = many(1000.0)
    assert len(found) == 539
    assert not wrong_in_kind(found, None)
    assert max(one.index for one in found) == 269
    check_first_integral(rod, found)


def check_first_integral(rod: Rod, found: list[Any]) -> None:
    """The curvature at the clamp and γ, which the tip angle decides."""
    for one in found:
        gamma = rod.eta * cos(one.tip_angle) ** 2
        assert one.gamma == pytest.approx(gamma, abs=1e-14)
        assert one.clamp_curvature**2 + rod.eta * cos(rod.clamp_angle) ** 2 == pytest.approx(gamma, abs=1e-13)


@pytest.mark.hours
def test_some_of_them_are_those_of_the_reference() -> None:
    rod, found = many(1000.0)
    offsets = []
    for one in found[::-108]:
        known = refine(rod, drawn(one, rod.length))
        assert known.reference.index == one.index
        for name in ("tip_angle", "clamp_curvature", "gamma", "y", "z", "energy"):
            size = rod.length if name in "yz" or name == "energy" else 1.0
            error = abs(float(known.reference.values[name] - getattr(one, name)))
            assert error <= 4 * ULP * (4 * size + known.reference.sensitivity[name]), name
        offsets.append(known.offset)
    assert len(set(offsets)) == len(offsets) == 5


@pytest.mark.long
def test_thousands_of_equilibria_of_one_rod() -> None:
    rod, found = many(1e4)
    assert len(found) == 5393
    assert not wrong_in_kind(found, None)
    check_first_integral(rod, found)
    # Each tip is a root of its own, also those that doubles do not tell apart.
    places = [(one.swing.stay.motion, one.swing.stay.tip, one.index, sin(one.tip_angle)) for one in found if one.swing]
    assert len(set(places)) == len(places)


def test_a_lost_equilibrium_is_seen() -> None:
    rod = Rod(0.35, 0.52, 6.0, 2.3, 0.7)
    (counted,) = count([rod])
    found = solved(rod)
    assert not wrong_in_kind(found, counted.number)
    assert wrong_in_kind(found[:-2], counted.number)
    assert wrong_in_kind([SimpleNamespace(tip_angle=one.tip_angle, index=0) for one in found], counted.number)
