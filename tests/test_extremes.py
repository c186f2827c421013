"""Extremes of doubles: every public function answers rightly, or one clear error says what to do, before any work."""

from __future__ import annotations

import importlib
import inspect
import math
from collections.abc import Iterator
from itertools import pairwise
from types import ModuleType
from typing import Any

import mpmath
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from spying import calls_of

from derive.cli import main
from derive.emit.kernels import api, bounds, dense, exchanges, time_map
from derive.resources import shipped_scenes

SCENES = sorted(shipped_scenes())
NAMES = ("beta", "eta", "length", "clamp_angle", "field_angle")
TIP = ("tip_angle", "clamp_curvature", "gamma", "y", "z", "energy")
HUGE, TINY = 1.7976931348623157e308, 5e-324
ENOUGH = 20  # ℓ√(β + η) from which only stable equilibria are asked for
EDGES = st.sampled_from([TINY, 1e-320, 2.3e-308, 1e-160, 1e-16, 1.0, 1e8, 1e150, 1e300, HUGE])
SIZES = EDGES | st.floats(TINY, HUGE) | st.builds(math.ldexp, st.floats(0.5, 1), st.integers(-1073, 1023))
ANGLES = st.floats(-7, 7) | st.builds(math.copysign, SIZES | st.just(0.0), st.sampled_from([1, -1]))
# A third of the rods are of moderate length, in any unit: ℓ, ℓ√(β + η), the share of β.
MODERATE = st.tuples(st.integers(-490, 490), st.floats(1e-9, 12), st.floats(0, 1))


def numpy_module(scene: str) -> ModuleType:
    return importlib.import_module(f"generated.{scene}_numpy")


@st.composite
def rods(draw: Any) -> dict[str, float]:
    beta, eta, length = draw(SIZES | st.just(0.0)), draw(SIZES | st.just(0.0)), draw(SIZES)
    if draw(st.integers(0, 2)) == 0:
        power, slow, share = draw(MODERATE)
        length = math.ldexp(1.0, power)
        beta, eta = (math.ldexp(slow * slow * part, -2 * power) for part in (share, 1 - share))
    return dict(zip(NAMES, (beta, eta, length, draw(ANGLES), draw(ANGLES)), strict=True))


def taken(function: Any, rod: dict[str, Any]) -> dict[str, Any]:
    """Those of a rod's numbers that are parameters of a function."""
    return {name: value for name, value in rod.items() if name in inspect.signature(function).parameters}


def tried(function: Any, **given: Any) -> Any:
    """What a function gives, or the error that it raises."""
    try:
        return function(**given)
    except ValueError as error:
        return error


def is_clear(error: Exception) -> bool:
    """One line that begins with an argument, and says how to mend it where something can be done."""
    text = str(error)
    return text.startswith((*NAMES, "max_index")) and "\n" not in text and ("choose" in text or "must" in text)


def must_be_sound(module: ModuleType, rod: dict[str, float], found: list[Any], *, whole: bool) -> None:
    """All numbers are finite, nothing is longer than the rod, and the indices of all are balanced."""
    assert found
    for one in found:
        assert all(math.isfinite(getattr(one, name)) for name in TIP)
        length = rod.get("length", 80.0)
        assert math.hypot(one.y / length, one.z / length) <= 1 + 1e-12 + TINY / length
    assert not whole or sum((-1) ** one.index for one in found) == 1
    for one in found[:2] if hasattr(module, "shape") else ():
        for s in (0.0, min(TINY, length), length / 3, [0.0, length], np.linspace(0, length, 100)):
            assert all(np.isfinite(part).all() for part in module.shape(one, s))


@pytest.mark.parametrize("scene", SCENES)
@settings(max_examples=25, deadline=None)
@given(rods())
def test_any_doubles_are_answered_or_refused(scene: str, rod: dict[str, float]) -> None:
    module = numpy_module(scene)
    mine = taken(module.equilibria, rod)
    load, length = mine.get("beta", 0.0) + mine.get("eta", 0.0), mine.get("length", 80.0)
    limit = None if length * math.sqrt(load) < ENOUGH else 0
    found = tried(module.equilibria, **mine, max_index=limit)
    swept = tried(module.sweep, **{name: [value] * 2 for name, value in mine.items()}, max_index=limit)
    if isinstance(found, ValueError):
        assert is_clear(found), found
        assert is_clear(swept), swept
        return
    must_be_sound(module, mine, found, whole=limit is None)
    assert swept.tip_angle.tolist() == 2 * [one.tip_angle for one in found]


@settings(max_examples=60, deadline=None)
@given(MODERATE, st.floats(-7, 7), st.floats(-2, 2), st.integers(-480, 480))
def test_units_of_powers_of_two_change_nothing(
    rod: tuple[int, float, float], clamp: float, field: float, power: int
) -> None:
    _, slow, share = rod
    loads = slow * slow * share, slow * slow * (1 - share)
    if any(0 < load < 1e-16 for load in loads):
        return  # underflow forbids it
    found = api.equilibria(*loads, 1.0, clamp, field)
    other = api.equilibria(*(math.ldexp(load, -2 * power) for load in loads), math.ldexp(1.0, power), clamp, field)
    powers = dict(zip(TIP, (0, -1, -2, 1, 1, -1), strict=True))
    for name in TIP:
        assert [math.ldexp(getattr(one, name), powers[name] * power) for one in found] == [
            getattr(one, name) for one in other
        ]


@pytest.mark.parametrize("unit", [1e-150, 3e-7, 0.3, 7e5, 1e150])
def test_other_units_change_roundings_only(unit: float) -> None:
    for beta, eta, clamp, field in ((2.0, 3.0, 2.0, 0.0), (3.0, 8.0, 2.5, 0.4), (0.0, 12.0, 1.0, 1.5)):
        found = api.equilibria(beta, eta, 1.0, clamp, field)
        other = api.equilibria(beta / unit / unit, eta / unit / unit, unit, clamp, field)
        assert len(found) == len(other)
        for one, two in zip(found, other, strict=True):
            assert two.tip_angle == pytest.approx(one.tip_angle, abs=1e-14)
            assert (two.y / unit, two.z / unit) == pytest.approx((one.y, one.z), abs=1e-14)
            assert two.clamp_curvature * unit == pytest.approx(one.clamp_curvature, abs=1e-13)


@pytest.mark.parametrize(
    "rod",
    [
        (TINY, 0.0, 1e162, 2.0, 0.0),
        (3 * TINY, 1e-322, 1e161, 2.0, 0.4),
        (1e-310, 7e-309, 2e154, 1.0, math.pi / 2),
        (TINY, TINY, 1e100, 2.0, 0.3),  # all but straight: loads that are hardly numbers
        (1e300, 2e300, 1.5e-150, 2.0, 0.0),
        (0.0, 1e307, 1e-153, 2.0, 0.4),
        (1e300, 1e-300, 2e-150, 2.0, 0.4),
        (1e-300, 1e300, 2e-150, 2.0, 0.0),
        (1e-200, 1e-200, 1e-200, 2.0, 0.1),
        (1.0, 2.0, 1.5, 1e-310, 0.4),
        (1.0, 2.0, 1.5, 2.0, TINY),
        (1.0, 2.0, 1.5, 6e7, -6e7),
    ],
)
def test_hardly_numbers_are_solved_as_the_twin_solves_them(rod: tuple[float, ...]) -> None:
    from generated import oblique_mpmath

    found, twin = api.equilibria(*rod), oblique_mpmath.equilibria(*rod, dps=40)
    load, length = rod[0] + rod[1], rod[2]
    sizes = (1.0, math.sqrt(load), load, length, length, load * length)
    blur = 1e-13 * max(1.0, abs(rod[3]), abs(rod[4]))  # a rounding of a large angle is many of one within a turn
    assert [one.index for one in found] == [one.index for one in twin]
    for one, other in zip(found, twin, strict=True):
        for name, size in zip(TIP, sizes, strict=True):
            value = getattr(other, name)
            assert abs(getattr(one, name) - value) <= blur * size + 2 * TINY, (name, getattr(one, name), value)


# What is refused


def refusals(backend: str) -> Iterator[tuple[str, tuple[Any, ...], dict[str, Any], str]]:
    """Function, arguments, options, and the error."""
    one = (1.0, 1.0, 1.0, 2.0, 0.3)
    if backend == "numpy":
        for rod in ((HUGE, HUGE, *one[2:]), (1.0, 1e308, *one[2:]), (1e200, 1.0, 1e200, *one[3:])):
            yield "equilibria", rod, {"max_index": 0}, r"beta = .*, eta = .*, length = .* too large .*another unit"
            yield "sweep", tuple([part, part] for part in rod), {}, r"beta = .*too large for a double"
        yield "equilibria", (1.0, 1.0, HUGE, 2.0, 0.0), {"max_index": 0}, r"beta = .*, length = 1.8e\+308: "
    for length in (1e6, 1e100):
        rod = (1.0, 1.0, length, *one[3:])
        for limit in (None, 10**7, 10**400):
            yield (
                "equilibria",
                rod,
                {"max_index": limit},
                r"max_index must be given here, and be less than \d+: .* some \S+ equi",
            )
            yield "sweep", (1.0, 1.0, [1.0, length], 2.0, 0.3), {"max_index": limit}, r"max_index must be given"
    for angle in (HUGE, -1e300) if backend == "numpy" else (HUGE,):
        yield "equilibria", (*one[:3], angle, 0.0), {}, r"clamp_angle must lie within .*leave out whole turns"
        yield "equilibria", (*one[:4], angle), {}, r"field_angle must lie within"
        yield "sweep", (*one[:3], [0.0, angle], 0.0), {}, r"clamp_angle\[1\] must lie within"
        yield "folds", (1.0, 1.0, angle, 0.0), {"eta": (0, 1)}, r"clamp_angle must lie within"
        yield "exchanges", (1.0, angle, 0.0), {"beta": (0, 1), "eta": (0, 1)}, r"clamp_angle must lie within"
    for high, length in ((1.0, 1e200), (1e300, 1.0)):
        yield "folds", (0.0, length, 2.0, 0.3), {"eta": (0, high)}, r"beta = 0.*, eta = 1.*the limit is 1000; choose"
        both = {"beta": (0, high), "eta": (0, high)}
        yield "exchanges", (length, 2.0, 0.3), both, r"beta = 1.*, eta = 1.*the limit is 100; choose a lower end"
    yield "equilibria", one, {"max_index": -1}, "max_index must not be negative"
    yield "equilibria", one, {"max_index": -(10**400)}, "max_index must not be negative"


@pytest.mark.parametrize("backend", ["numpy", "mpmath"])
def test_what_is_refused(backend: str) -> None:
    module = importlib.import_module(f"generated.oblique_{backend}")
    for name, arguments, options, says in refusals(backend):
        with pytest.raises(ValueError, match=rf"^{says}") as caught:
            getattr(module, name)(*arguments, **options)
        assert is_clear(caught.value), caught.value


def test_errors_name_only_what_a_scene_has() -> None:
    for scene, says in (("field_only", "eta"), ("force_only", "beta"), ("remote_control", "beta")):
        equilibria = numpy_module(scene).equilibria
        rod = taken(equilibria, dict(zip(NAMES, (1e308, 1e308, 1.0, 2.0, 0.0), strict=True)))
        with pytest.raises(ValueError, match=rf"^{says} = 1e\+308") as caught:
            equilibria(**rod)
        named = str(caught.value).split(":")[0]
        assert [part.split(" = ")[0] for part in named.split(", ")] == [n for n in rod if not n.endswith("angle")]


@pytest.mark.parametrize("angle", [2.0**26, -(2.0**26)])
def test_the_last_angles_that_are_told(angle: float) -> None:
    assert bounds.within_turns("clamp_angle", angle) == angle
    with pytest.raises(ValueError, match="leave out whole turns"):
        bounds.within_turns("clamp_angle", angle * (1 + 1e-15))


# Work


@pytest.mark.parametrize("length", [1e3, 1e6, 1e100])
@pytest.mark.parametrize(("beta", "eta", "field", "number"), [(1, 0, 0, 6), (0.3, 0.7, 0, 14), (0.3, 0.7, 0.4, 14)])
def test_an_index_limit_bounds_the_work(
    beta: float, eta: float, field: float, number: int, length: float, monkeypatch: pytest.MonkeyPatch
) -> None:
    calls = calls_of(monkeypatch, time_map, "motion_at")
    found = api.equilibria(beta, eta, length, 2.0, field, max_index=2)
    assert len(found) == number
    assert {one.index for one in found} == {0, 1, 2}
    assert len(calls) < 5e4


def test_few_points_of_a_long_rod_are_computed_one_by_one(monkeypatch: pytest.MonkeyPatch) -> None:
    calls = calls_of(monkeypatch, dense, "bins_of")
    (one, *_) = api.equilibria(1.0, 0.0, 1e5, 2.0, 0.0, max_index=0)
    shape = api.shape(one, np.linspace(0, 1e5, 1000))
    assert not calls
    assert shape.theta[-1] == one.tip_angle
    assert shape.y[-1] == pytest.approx(one.y, rel=1e-15)


@pytest.mark.parametrize(("low", "high", "field"), [(0.0, 1.0, 1e-300), (0.0, 1.0, 1e-3), (0.2, 0.9, 1.0)])
def test_forces_are_few_and_near_enough(low: float, high: float, field: float) -> None:
    loads = exchanges.forces(low, high, 10.0, field)
    assert loads[-1] == high
    assert loads == sorted({*loads})
    assert max((b + field) / (a + field) for a, b in pairwise(loads)) < 1.06
    assert len(loads) < 100


@pytest.mark.parametrize("scene", ["parallel", "bifurcation"])
def test_the_precision_of_the_caller_stays_when_the_work_fails(scene: str, monkeypatch: pytest.MonkeyPatch) -> None:
    module = importlib.import_module(f"generated.{scene}_mpmath")

    def fails(*rod: Any) -> None:
        assert mpmath.mp.dps == 77
        raise ArithmeticError(rod)

    for solver in ("all_equilibria", "all_folds", "all_exchanges"):
        monkeypatch.setattr(module, solver, fails)
    rod = dict(zip(NAMES, (1e-4, 1e-4, 80.0, 2.0, 0.3), strict=True))
    ranges = {"beta": (0, 1e-4), "eta": (0, 1e-4)}
    with mpmath.workprec(101):
        for name, ranged in (("equilibria", ()), ("sweep", ()), ("folds", ("eta",)), ("exchanges", ("beta", "eta"))):
            function = getattr(module, name)
            with pytest.raises(ArithmeticError):
                function(**taken(function, {**rod, **{one: ranges[one] for one in ranged}}), dps=77)
            assert mpmath.mp.prec == 101


# The command line

ROD = ["--beta", "1", "--eta", "1", "--length", "1", "--clamp-angle", "2"]


@pytest.mark.parametrize(
    ("command", "scene", "changes", "says"),
    [
        ("solve", "parallel", {"--length": "1e100"}, "--max-index must be given"),
        ("solve", "parallel", {"--length": "1e100", "--max-index": "99999999"}, "--max-index must be given"),
        ("solve", "parallel", {"--beta": "1e308"}, "beta = 1e+308, eta = 1, length = 1: "),
        ("solve", "parallel", {"--clamp-angle": "1e300"}, "--clamp-angle must lie within"),
        ("solve", "parallel", {"--eta": None, "--length": "1e-300", "--target": "y=1"}, "--range is needed"),
        ("solve", "parallel", {"--eta": None, "--length": "1e200", "--target": "y=1"}, "--range is needed"),
        ("solve", "parallel", {"--eta": None, "--target": "y=1", "--range": "0:1e300"}, "beta = 1, eta = 1e+300"),
        ("sweep", "parallel", {"--eta": "0:1e300:10"}, "beta = 1, eta = 1e+300, length = 1: "),
        ("sweep", "parallel", {"--beta": "0:1:9", "--length": "1e100"}, "beta = 0, eta = 1, length = 1e+100: "),
        ("sweep", "parallel", {"--clamp-angle": "-1e300:0:9"}, "--clamp-angle must lie within"),
    ],
)
def test_the_command_line_refuses(
    command: str, scene: str, changes: dict[str, str | None], says: str, capsys: pytest.CaptureFixture[str]
) -> None:
    given = {**dict(zip(ROD[::2], ROD[1::2], strict=True)), **changes}
    words = [word if name == word else f"{name}={word}" for name, word in given.items() if word is not None]
    assert main([command, scene, *words]) != 0
    out, err = capsys.readouterr()
    assert out == ""
    assert err.startswith(f"derive {command}: {says}")
    assert err.count("\n") == 1
