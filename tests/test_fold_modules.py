"""Folds of emitted modules: the same as the kernels', compared with the references, refused where they are wrong."""

from __future__ import annotations

from dataclasses import replace
from math import pi
from types import SimpleNamespace
from typing import Any

import mpmath
import pytest
from altered import altered

from derive.emit.errors import SceneError
from derive.emit.kernel_files import read_kernels
from derive.emit.kernels.exchanges import all_exchanges
from derive.emit.kernels.folds import Fold, all_folds
from derive.emit.module import emit_module
from derive.emit.scene import load_scene, parse_scene
from derive.measure.agreement import ROUNDINGS, Agreement
from derive.measure.fold_agreement import enter_folds
from derive.measure.fold_references import FoldList, fold_references, refined
from derive.measure.loading import load
from derive.measure.reference import Rod
from derive.measure.rods import PAPER, rods
from derive.resources import shipped_scenes
from derive.stages import theory
from generated import (
    bifurcation_mpmath,
    bifurcation_numpy,
    field_only_numpy,
    force_only_numpy,
    oblique_numpy,
    orthogonal_numpy,
    parallel_numpy,
    remote_control_numpy,
)

HEAD = '[scene]\nname = "sample"\ncase = "CASE"\noutputs = ["equilibria", "folds"]\n[constants]\n'
SECOND_EXAMPLE = (80.0, 3 * pi / 4, 0)
FIELDS = ("eta", "tip_angle", "clamp_curvature", "y", "z")


def folds_scene(case: str = "parallel", constants: str = "") -> Any:
    return parse_scene(HEAD.replace("CASE", case) + constants, "my.toml")


# Scenes


@pytest.mark.parametrize(
    ("case", "constants", "says"),
    [
        ("force_only", "", "my.toml:4: case 'force_only' has no field, .* choose: parallel, orthogonal, field_only"),
        ("parallel", 'eta = "1/10"', "my.toml:6: eta = 1/10 is folded, .* drop it, or drop 'folds'"),
    ],
)
def test_folds_without_a_field_to_vary_are_refused(case: str, constants: str, says: str) -> None:
    with pytest.raises(SceneError, match=says):
        folds_scene(case, constants)


def test_exchanges_come_with_folds_where_the_force_varies() -> None:
    assert folds_scene().functions == ("equilibria", "folds", "exchanges")
    assert folds_scene(constants="beta = 1").functions == ("equilibria", "folds")
    assert folds_scene("field_only").functions == ("equilibria", "folds")
    assert not hasattr(force_only_numpy, "folds")
    assert not hasattr(remote_control_numpy, "folds")
    assert not hasattr(field_only_numpy, "exchanges")
    assert {"Exchange", "Fold", "exchanges", "folds"} <= set(parallel_numpy.__all__)


# What is emitted


def test_emitted_folds_are_those_of_the_kernels() -> None:
    (fold,) = bifurcation_numpy.folds(0.00035, eta=(0, 0.001))
    (known,) = all_folds(0.00035, *SECOND_EXAMPLE, 0.0, 0.001)
    assert str(fold) == str(known)
    assert fold.eta == pytest.approx(0.000468041915201637, rel=1e-15)
    assert str(parallel_numpy.folds(0.00035, 80, 3 * pi / 4, eta=(0, 0.001))) == str([known])


@pytest.mark.parametrize(
    ("module", "angle"),
    [(orthogonal_numpy, pi / 2), (oblique_numpy, 0.7), (field_only_numpy, 0.0)],
    ids=["orthogonal", "oblique", "field_only"],
)
def test_every_scene_has_the_folds_of_the_kernels(module: Any, angle: float) -> None:
    given = {"beta": 0.00035, "length": 80.0, "clamp_angle": 2.2, "field_angle": angle}
    names = module.folds.__code__.co_varnames[: module.folds.__code__.co_argcount]
    found = module.folds(**{name: given[name] for name in names}, eta=(1e-4, 4e-3))
    beta = given["beta"] if "beta" in names else 0.0
    known = all_folds(beta, 80.0, 2.2, angle, 1e-4, 4e-3)
    assert len(found) == len(known) > 0
    for one, other in zip(found, known, strict=True):
        assert (one.index, one.change, one.kind) == (other.index, other.change, other.kind)
        for name in FIELDS:
            assert getattr(one, name) == pytest.approx(getattr(other, name), rel=1e-12, abs=1e-12)


def test_emitted_exchanges_are_those_of_the_kernels() -> None:
    ranges = {"beta": (0.000306, 0.000308), "eta": (0.0004, 0.00046)}
    (found,) = bifurcation_numpy.exchanges(**ranges)
    (known,) = all_exchanges(*SECOND_EXAMPLE, *ranges["beta"], *ranges["eta"])
    assert str(found) == str(known)
    assert found.kind == "exchange"
    assert found.beta == pytest.approx(0.00030699014326016435, rel=1e-14)
    assert found.eta == pytest.approx(0.000430492438423967, rel=1e-14)


@pytest.mark.parametrize(
    ("given", "error", "says"),
    [
        ({"beta": -1, "eta": (0, 1)}, ValueError, "beta must not be negative"),
        ({"beta": 1, "eta": 1}, TypeError, "eta must be a pair"),
        ({"beta": 1, "eta": (1, 0)}, ValueError, "eta must be a range"),
        ({"beta": 1, "eta": (0, float("nan"))}, ValueError, "eta\\[1\\] must be finite"),
        ({"beta": 1j, "eta": (0, 1)}, TypeError, "beta must be a real number"),
    ],
)
@pytest.mark.parametrize("module", [bifurcation_numpy, bifurcation_mpmath], ids=["numpy", "mpmath"])
def test_bad_arguments_are_named(module: Any, given: Any, error: Any, says: str) -> None:
    with pytest.raises(error, match=says):
        module.folds(**given)


@pytest.mark.parametrize("module", [bifurcation_numpy, bifurcation_mpmath], ids=["numpy", "mpmath"])
def test_bad_ranges_of_exchanges_are_named(module: Any) -> None:
    with pytest.raises(ValueError, match="beta must be a range"):
        module.exchanges(beta=(1, 1), eta=(0, 1))
    with pytest.raises(ValueError, match="eta must be a pair"):
        module.exchanges(beta=(0, 1), eta=(0, 1, 2))


def test_the_twin_has_its_own_precision_and_leaves_the_callers() -> None:
    eta, tip_angle, before = 0.0005535593804020638, 2.203878534866223, mpmath.mp.dps
    (fold,) = bifurcation_mpmath.folds(0.0004, eta=(eta * 0.999, eta * 1.001), dps=25)
    assert mpmath.mp.dps == before
    with mpmath.workdps(45):
        exact = refined(Rod(0.0004, eta, 80.0, 3 * pi / 4), eta, tip_angle, {"clamp_angle": 3 * mpmath.pi / 4})
        for name in FIELDS:
            assert abs(getattr(fold, name) / exact.values[name] - 1) < mpmath.mpf(10) ** -23


# Against the references


@pytest.fixture(scope="module")
def known() -> FoldList:
    found = all_folds(PAPER.beta, PAPER.length, PAPER.clamp_angle, 0, 0.0, 0.0072)
    return FoldList(PAPER, 0.0072, tuple(refined(PAPER, one.eta, one.tip_angle) for one in found))


def folds_of(known: FoldList) -> list[Fold]:
    """The references, rounded."""
    return [Fold(*(float(one.values[name]) for name in FIELDS), one.index, one.change, one.kind) for one in known.folds]


def reasons(known: FoldList, change: Any) -> list[str]:
    """What is said against a module that knows the references, and what is changed in them."""

    def folds(beta: float, length: float, clamp_angle: float, *, eta: tuple[float, float]) -> list[Fold]:
        assert (beta, length, clamp_angle) == (known.rod.beta, known.rod.length, known.rod.clamp_angle)
        assert eta == (0.0, known.high)
        found: list[Fold] = change(folds_of(known))
        return found

    result = Agreement()
    enter_folds(result, SimpleNamespace(folds=folds), [known])  # type: ignore[arg-type]  # all that is looked at
    return result.reasons()


def test_references_survive_the_cache(known: FoldList) -> None:
    again = FoldList.from_json(known.to_json())
    assert again.to_json() == known.to_json()
    assert len(known.folds) > 1


def test_rounded_references_agree(known: FoldList) -> None:
    assert reasons(known, lambda folds: folds) == []


@pytest.mark.parametrize(
    ("change", "says"),
    [
        (lambda f: f[1:], "no fold at η = "),
        (lambda f: [*f, f[0]], "folds that are none, among those at η = "),
        (
            lambda f: [*f, altered(f[0], eta=f[0].eta / 3), altered(f[0], eta=f[0].eta / 3, change=-2)],
            "a fold that is none",
        ),
        (lambda f: [altered(f[0], index=3), *f[1:]], "index 3 instead of"),
        (lambda f: [altered(f[0], change=-f[0].change), *f[1:]], "change "),
        (lambda f: [altered(f[0], kind="pitchfork"), *f[1:]], "kind pitchfork instead of fold"),
        (lambda f: [altered(f[0], eta=f[0].eta * (1 + 1e-12)), *f[1:]], "fold eta is off by"),
        (lambda f: [altered(f[0], tip_angle=f[0].tip_angle + 1e-9), *f[1:]], "fold tip_angle is off by"),
        (lambda f: [altered(f[0], y=-f[0].y), *f[1:]], "fold y is off by"),
        (lambda f: [altered(f[0], z=float("nan")), *f[1:]], "z is nan at the fold"),
        (lambda f: f[0] / 0, "folds fail with TypeError"),
    ],
)
def test_wrong_folds_are_seen(known: FoldList, change: Any, says: str) -> None:
    assert any(says in line for line in reasons(known, change))


def test_two_folds_that_no_reference_has_are_refined(known: FoldList) -> None:
    """As if both lay between two samples: they are found to be true, and one more of them is not."""
    first, *rest = known.folds
    fewer = replace(known, folds=tuple(rest))
    found = [*folds_of(known), altered(folds_of(known)[0], change=-first.change)]
    said = reasons(fewer, lambda _: found)
    assert [line for line in said if "change" in line]
    assert not [line for line in said if "none" in line]


def test_pitchforks_are_among_the_references() -> None:
    rod = Rod(0.0, 0.0, 3.0, pi / 2)
    found = fold_references(rod)
    assert found is not None
    assert [one.kind for one in found.folds] == ["pitchfork"] * 3
    for k, one in enumerate(found.folds):
        assert float(one.values["eta"]) == pytest.approx(((k + 0.5) * pi / 3) ** 2, rel=1e-14)
    result = Agreement()
    enter_folds(result, field_only_numpy, [found])
    assert result.reasons() == []


def test_a_rod_too_stiff_to_count_is_left_out_and_no_comparison_is_a_fault() -> None:
    assert fold_references(replace(PAPER, length=8.0, beta=1.0)) is None
    result = Agreement()
    enter_folds(result, bifurcation_numpy, [])
    assert "its folds were compared with none" in result.reasons()[0]


def test_the_worst_fold_of_the_second_example_is_within_the_bound(known: FoldList) -> None:
    result = Agreement()
    enter_folds(result, parallel_numpy, [known])
    assert result.reasons() == []
    assert 0 < max(row.roundings for row in result.rows.values()) < ROUNDINGS


@pytest.mark.long
@pytest.mark.parametrize("case", ["parallel", "oblique"])
def test_counting_finds_the_folds_of_the_kernels(case: str) -> None:
    rod = rods(case)[2]
    found = fold_references(rod)
    assert found is not None
    known = all_folds(rod.beta, rod.length, rod.clamp_angle, rod.field_angle, 0.0, found.high)
    assert len(known) == len(found.folds) > 1
    for one, other in zip(found.folds, known, strict=True):
        assert float(one.values["eta"]) == pytest.approx(other.eta, rel=1e-14)


# Wrong kernels: file, what is changed, and why that is wrong.
MUTANTS = [
    ("folds", "ldexp(rod.eta, 2 * rod.scale)", "ldexp(rod.eta, rod.scale)", "a field in other units"),
    (
        "folds",
        "change = 2 if (mark.slope > 0) == top",
        "change = 2 if (mark.slope > 0) != top",
        "what vanishes appears",
    ),
    ("folds", "index = 2 * swings - (1", "index = 2 * swings + (1", "an index two too high"),
    (
        "folds",
        "-clamp_angle, reflected(field_angle), -1",
        "clamp_angle, reflected(field_angle), -1",
        "a mirror image not mirrored",
    ),
    ("folds", "first * first - soonest)", "4 * first * first)", "the first folds are skipped"),
    ("variations", "d_turn = (loads - motion", "d_turn = (loads + motion", "a sign in the turning pair's derivative"),
    ("extrema", "+ sign * item.arrival\n", "- sign * item.arrival\n", "the other branch"),
    ("tracking", "crossed += changes(low, high)", "crossed += changes(low, high) * 2", "each fold twice"),
]


def emitted(kernels: dict[str, str]) -> Any:
    scene = load_scene(shipped_scenes()["oblique"])
    return load(emit_module(theory(), replace(scene, outputs=("folds",)), "numpy", kernels=kernels).text)


@pytest.fixture(scope="module")
def oblique() -> FoldList:
    found = fold_references(rods("oblique")[2])
    assert found is not None
    return found


@pytest.mark.long
def test_the_true_kernels_are_not_refused(oblique: FoldList) -> None:
    result = Agreement()
    enter_folds(result, emitted(read_kernels()), [oblique])
    assert result.reasons() == []


@pytest.mark.long
@pytest.mark.parametrize(("file", "old", "new"), [pytest.param(*one[:3], id=one[3]) for one in MUTANTS])
def test_a_wrong_kernel_of_folds_is_refused(oblique: FoldList, file: str, old: str, new: str) -> None:
    kernels = read_kernels()
    assert kernels[file].count(old) == 1, "the kernel has changed: mend the mutant"
    result = Agreement()
    enter_folds(result, emitted({**kernels, file: kernels[file].replace(old, new)}), [oblique])
    assert result.reasons()
