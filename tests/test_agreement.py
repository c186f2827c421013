"""The comparison with the references: a true module passes, and every kind of wrong one is seen.

At the end, wrong kernels and wrong formulas: each is refused by the proof or by the comparison.
"""

from __future__ import annotations

import ast
import re
from collections.abc import Collection
from dataclasses import dataclass, replace
from functools import cache
from math import cos, sqrt
from types import SimpleNamespace
from typing import Any

import pytest

from derive.emit.errors import EmitError
from derive.emit.kernel_files import read_kernels
from derive.emit.module import EmittedModule, emit_module
from derive.emit.proof import prove_formulas, prove_module
from derive.emit.scene import load_scene
from derive.measure.agreement import DOUBLE, QUANTITIES, ROUNDINGS, SHAPE, TWIN_DIGITS, agreement
from derive.measure.loading import load
from derive.measure.reference import FRACTIONS, Reference, Rod
from derive.measure.rods import PAPER, references, rods
from derive.measure.scan import STIFFEST
from derive.measure.sweeps import FIELDS
from derive.resources import shipped_scenes
from derive.stages import theory


@dataclass(frozen=True)
class Answer:
    """What an emitted module gives, here rounded from the reference."""

    tip_angle: float
    clamp_curvature: float
    gamma: float
    y: float
    z: float
    energy: float
    index: int
    known: Reference


@pytest.fixture(scope="module")
def known() -> list[tuple[Rod, list[Reference]]]:
    return [(PAPER, references(PAPER))]


def same(answers: Any) -> Any:
    return answers


def module(known: list[tuple[Rod, list[Reference]]], change: Any = same, swept: Any = same) -> Any:
    """A module that knows the answers for one rod, and what is changed in them and in the sweep of them."""

    def equilibria(beta: float, eta: float, length: float, clamp_angle: float) -> list[Answer]:
        assert (beta, eta, length, clamp_angle) == (PAPER.beta, PAPER.eta, PAPER.length, PAPER.clamp_angle)
        (_, found), *_ = known
        return change([Answer(*(float(r.values[name]) for name in QUANTITIES), r.index, r) for r in found])

    def shape(equilibrium: Answer, s: float) -> SimpleNamespace:
        fraction = next(f for f in FRACTIONS if f * PAPER.length == s)
        return SimpleNamespace(**{p: float(equilibrium.known.values[f"{p}({fraction}ℓ)"]) for p in SHAPE})

    def sweep(beta: Any, eta: Any, length: Any, clamp_angle: Any) -> SimpleNamespace:
        rods = enumerate(zip(beta, eta, length, clamp_angle, strict=True))
        rows = [(case, one) for case, rod in rods for one in equilibria(*rod)]
        columns = {name: [getattr(one, name) for _, one in rows] for name in FIELDS}
        return SimpleNamespace(**swept({"case": [case for case, _ in rows], **columns}))

    return SimpleNamespace(equilibria=equilibria, shape=shape, sweep=sweep)


def test_rounded_answers_agree_to_a_rounding(known: Any) -> None:
    found = agreement(module(known), known)
    assert found.holds
    assert found.equilibria == 3
    assert set(found.rows) == {*QUANTITIES, *(f"{name}(s)" for name in SHAPE)}
    assert max(row.roundings for row in found.rows.values()) <= 1


@pytest.mark.parametrize(
    ("change", "words"),
    [
        (lambda a: a[:2], "2 equilibria instead of 3"),
        (lambda a: [*a, a[-1]], "4 equilibria instead of 3"),
        (lambda a: [replace(a[0], index=1), *a[1:]], "index 1 instead of 0"),
        (lambda a: [replace(a[0], y=-a[0].y), *a[1:]], "y is off by"),
        (lambda a: [replace(a[0], gamma=a[0].gamma * (1 + 1e-10)), *a[1:]], "gamma is off by"),
        (lambda a: [*a[:2], replace(a[2], energy=a[2].energy * (1 + 1e-10))], "energy is off by"),
        (lambda a: [a[0] / 0], "it fails with TypeError"),
        (lambda a: [replace(a[0], tip_angle=float("nan")), *a[1:]], "tip_angle is nan"),
    ],
)
def test_wrong_answers_are_seen(known: Any, change: Any, words: str) -> None:
    found = agreement(module(known, change), known)
    assert not found.holds
    assert words in " ".join(found.reasons())


@pytest.mark.parametrize(
    ("swept", "words"),
    [
        (lambda s: {**s, "case": [case + 1 for case in s["case"]]}, "sweep: case[0] is 1, and equilibria gives 0"),
        (lambda s: {**s, "index": s["index"][:-1]}, "sweep: index has 191 rows instead of 192"),
        (lambda s: {**s, "y": s["z"]}, "sweep: y[0] is"),
        (lambda s: {**s, "gamma": [*s["gamma"][:-1], s["gamma"][-1] * (1 + 1e-12)]}, "sweep: gamma[191] is"),
        (lambda s: {**s, "index": [*s["index"][:-1], s["index"][-1] + 1]}, "sweep: index[191] is"),
        (lambda s: {**s, "energy": [*s["energy"][:-1], float("nan")]}, "sweep: energy[191] is nan"),
        (lambda s: {name: s[name] for name in s if name != "gamma"}, "has no attribute 'gamma'"),
        (lambda s: 1 / 0, "sweep fails with ZeroDivisionError"),
    ],
)
def test_a_sweep_says_what_equilibria_says(known: Any, swept: Any, words: str) -> None:
    found = agreement(module(known, swept=swept), known * 2)
    assert not found.holds
    assert words in " ".join(found.reasons())
    assert agreement(module(known), known * 2).holds


def test_gamma_is_that_of_the_first_integral_at_the_tip(known: Any) -> None:
    for _, found in known:
        for one in found:
            xi = cos(float(one.values["tip_angle"]))
            assert float(one.values["gamma"]) == pytest.approx(2 * PAPER.beta * xi + PAPER.eta * xi * xi, rel=1e-12)


def test_no_comparison_is_no_agreement(known: Any) -> None:
    assert not agreement(module(known), []).holds
    assert ROUNDINGS < 1e5


def test_rods_follow_the_case_and_the_scene() -> None:
    assert rods("parallel")[0] == PAPER
    assert all(rod.eta == 0 for rod in rods("force_only"))
    assert all(rod.beta == 0 and rod.eta > 0 for rod in rods("field_only"))
    assert {rod.length for rod in rods("parallel", {"length": 80.0})} == {80.0}
    assert [rod.eta for rod in rods("parallel", {"eta": 50.0})] == [50.0] * 8  # all but the article's are shortened
    assert all(rod.length * sqrt(rod.beta + rod.eta) <= STIFFEST for rod in rods("parallel", {"length": 500.0}))


# Mutants: kernel file, what is changed, and why that is wrong.
HOURS = pytest.mark.hours
KERNEL_MUTANTS = [
    pytest.param("landen", "gap = gauss_gap(gap,", "gap = gauss_gap(2 * gap,", id="a factor in Gauss's step"),
    pytest.param(
        "landen", "return asinh(whole) / mean", "return 2 * asinh(whole) / mean", id="a factor of the half-swing"
    ),
    pytest.param("landen", "(small, large) if first", "(large, small) if first", id="sine for cosine of the phase"),
    pytest.param("shapes", "station.whole % 2 == 1", "station.whole % 2 == 0", id="the parity of the half-swings"),
    pytest.param(
        "shapes", "ldexp(s, rod.scale))", "rod.length - ldexp(s, rod.scale))", id="lengths from the wrong end"
    ),
    pytest.param("shapes", "-rod.side * sign * ldexp(speed", "rod.side * sign * ldexp(speed", id="a sign of θ′"),
    pytest.param("equilibria", "else swings + 1", "else swings", id="an index one too low"),
    pytest.param("equilibria", "2 * crossing.turns - (1", "2 * crossing.turns + (1", id="an index two too high"),
    pytest.param("bent_rods", "2 * beta * arc.y - arc", "2 * beta * arc.y + arc", id="a sign in the energy"),
    pytest.param(
        "bent_rods", "side * ldexp(length * heading", "ldexp(length * heading", id="a mirror image not mirrored"
    ),
    pytest.param("bent_rods", "ldexp(gamma, 2 * scale)", "-ldexp(gamma, 2 * scale)", id="the sign of gamma"),
    pytest.param("bent_rods", "through * a + b", "through * a - b", id="an arc on the wrong side"),
    pytest.param("search", "else (1, -1):\n", "else (1,):\n", id="half of the branches"),
    pytest.param("search", "+ sign * item.arrival - length", "- sign * item.arrival - length", id="the other branch"),
    pytest.param("ground", "level = 2 * atan2(", "level = atan2(", id="the level of a ridge"),
    pytest.param("sides", "Clamp(-1 - clamp.turns", "Clamp(-clamp.turns", id="a turn too many on the other side"),
    pytest.param("symmetric_landscapes", "eta - beta", "eta + beta", id="wells in the wrong place"),
    pytest.param("blocks", "case=found.case + start", "case=found.case + 1", id="cases of a sweep one too high"),
    pytest.param("block_tips", "-side * found.sign", "found.sign", id="a sign in a sweep"),
    pytest.param("block_tips", "side * (length * heading", "(length * heading", id="no mirror image in a sweep"),
    pytest.param("block_tips", "= times * change", "= times / 2 * change", id="half of the swings in a sweep"),
    pytest.param("block_short", "-moment * length", "moment * length", id="a sign in a sweep of short rods"),
    pytest.param("block_short", "gamma / 2 + 2 * beta", "gamma / 2 - 2 * beta", id="an energy of a sweep"),
    pytest.param("block_short", "(sine + z) * length", "(sine - z) * length", id="a short rod of a sweep mirrored"),
    pytest.param("block_pieces", "turns[which]", "turns[which] + 1", id="a turn too many in a sweep"),
    pytest.param("block_tips", "* heading.cosine + y", "* heading.cosine - y", id="a place of a sweep mirrored"),
    pytest.param(
        "swing", "a, b = total / 2, sqrt(", "a, b = total / 4, sqrt(", id="a factor in Gauss's step of a sweep"
    ),
]


@pytest.fixture(scope="module")
def trial() -> list[tuple[Rod, list[Reference]]]:
    """Rods that bend both ways, turn round, and lie over the ridge."""
    chosen = rods("parallel")
    return [(rod, references(rod)) for rod in (chosen[0], chosen[2], chosen[5], chosen[6])]


def emitted(kernels: dict[str, str] | None = None) -> EmittedModule:
    """The shipped scene, or with other kernels what is compared of it: the folds have tests of their own."""
    scene = load_scene(shipped_scenes()["parallel"])
    scene = scene if kernels is None else replace(scene, outputs=("equilibria", "shape", "sweep"))
    return emit_module(theory(), scene, "numpy", kernels=kernels)


@cache
def true_module() -> EmittedModule:
    return emitted()


def with_kernel(file: str, old: str, new: str) -> EmittedModule:
    kernels = read_kernels()
    assert kernels[file].count(old) >= 1, "the kernel has changed: mend the mutant"
    return emitted({**kernels, file: kernels[file].replace(old, new)})


def refusals(module: EmittedModule, trial: Any) -> list[str]:
    """What the main job would say against writing a module."""
    try:
        prove_module(module)
    except EmitError as error:
        return [str(error)]
    return agreement(load(module.text), trial).reasons()


def test_the_true_module_is_not_refused(trial: Any) -> None:
    assert refusals(true_module(), trial) == []


@pytest.mark.parametrize(("backend", "unit"), [("numpy", DOUBLE), ("mpmath", 10.0**-TWIN_DIGITS)])
def test_a_scene_of_sweeps_alone_is_compared(trial: Any, backend: str, unit: float) -> None:
    scene = replace(load_scene(shipped_scenes()["parallel"]), outputs=("sweep",))
    module = emit_module(theory(), scene, backend)
    assert agreement(load(module.text), trial[:1], unit).reasons() == []
    wrong = re.sub(r"\[item\.y for _, item", "[item.z for _, item", module.text).replace(" found.y,", " found.z,")
    assert wrong != module.text
    assert any(
        line.startswith(("sweep: y[0]", "y is off")) for line in agreement(load(wrong), trial[:1], unit).reasons()
    )


@pytest.mark.parametrize(
    ("file", "old", "new"),
    [
        pytest.param(*one.values, id=one.id, marks=[] if k % 16 == 0 else pytest.mark.long if k % 4 == 0 else HOURS)
        for k, one in enumerate(KERNEL_MUTANTS)
    ],
)
def test_a_wrong_kernel_is_refused(trial: Any, file: str, old: str, new: str) -> None:
    assert refusals(with_kernel(file, old, new), trial)


@pytest.mark.long
def test_tips_of_a_sweep_left_rough_are_refused(trial: Any) -> None:
    """Where tips of short rods are aimed at less often, and then taken as they are."""
    kernels = read_kernels()
    changes = [
        ("block_shots", "AIMS = 4 ", "AIMS = 1 "),
        ("block_shots", "SETTLED = 2.0**-43 ", "SETTLED = 1.0 "),
        ("block_roots", "blur = epsilon()", "blur = 1e-3"),
    ]
    for file, old, rough in changes:
        assert kernels[file].count(old) == 1, "the kernel has changed: mend the mutant"
        kernels = {**kernels, file: kernels[file].replace(old, rough)}
    assert any(line.startswith("sweep") for line in refusals(emitted(kernels), trial))


def without_kernels(text: str, formulas: Collection[str]) -> str:
    """A module of which only the formulas are left: all that the proof reads of it, in a tenth of the text."""
    tree = ast.parse(text)
    tree.body = [node for node in tree.body if not isinstance(node, ast.FunctionDef) or node.name in formulas]
    return ast.unparse(tree)


@pytest.mark.long
def test_a_wrong_formula_is_refused() -> None:
    true = true_module()
    text = without_kernels(true.text, {formula.name for formula in true.formulas})
    assert prove_formulas(text, true.formulas, "right.py")
    for formula in true.formulas:
        for change in ("-({})", "({}) * 1.0000001", "({}) + 1e-9"):
            tree = ast.parse(text)
            node = next(n for n in tree.body if isinstance(n, ast.FunctionDef) and n.name == formula.name)
            last = node.body[-1]
            assert isinstance(last, ast.Return)
            last.value = ast.parse(change.format(ast.unparse(last.value or node)), mode="eval").body
            with pytest.raises(EmitError, match=f"'{formula.name}' is not proved equal to"):
                prove_formulas(ast.unparse(ast.fix_missing_locations(tree)), [formula], "wrong.py")


@pytest.mark.parametrize(
    ("formula", "old", "new"),
    [
        ("gauss_square", "return square * total * total /", "return square * total /"),
        ("gauss_square", "def gauss_square(square, total, below)", "def gauss_square(square, below, total)"),
        ("gauss_rest", "second * second) / (delta", "second * second) / (2 * delta"),
    ],
)
def test_a_dropped_factor_or_a_swapped_argument_is_refused(formula: str, old: str, new: str) -> None:
    true = true_module()
    assert old in true.text, "the formula has changed: mend the mutant"
    changed = [one for one in true.formulas if one.name == formula]
    assert prove_formulas(true.text, changed, "right.py")
    with pytest.raises(EmitError, match=formula):
        prove_formulas(true.text.replace(old, new), changed, "wrong.py")
