"""The mpmath twins at 15 to 1000 digits: what they give is right to 10^(2 − digits), against runs with more digits.

Numbers are random rods' of every shipped scene, in as many digits. Errors are relative to the size of a quantity: 1 for
angles, the length for places, √(β + η), β + η and ℓ(β + η) for curvature, γ and energy.
"""

from __future__ import annotations

import importlib
import inspect
import random
from functools import cache
from types import ModuleType
from typing import Any

import pytest
from mpmath import mp, mpf

from derive.emit.scene import load_scene
from derive.measure.rods import references, rods
from derive.resources import shipped_scenes

SCENES = sorted(shipped_scenes())
MORE = 30  # digits of the finer run beyond those tried
FINEST = 1100  # digits in which the rods are given
EXACT = 40  # digits of the references, by Taylor integration
DEEP = [(100, 2), (200, 1), (500, 1), (1000, 1)]  # digits, and rods of each scene


def twin(scene: str) -> ModuleType:
    return importlib.import_module(f"generated.{scene}_mpmath")


@cache
def scales(scene: str, number: int) -> tuple[dict[str, Any], dict[str, Any]]:
    """The arguments of a random rod, and the sizes of the quantities of its equilibria and shapes."""
    draw, folded = random.Random(f"{scene} {number}"), load_scene(shipped_scenes()[scene]).folded
    with mp.workdps(FINEST):
        length = mpf(int(folded["length"])) if "length" in folded else mpf(10) ** draw.uniform(-2, 3)
        share, stiffness = mpf(draw.random()), (mpf(draw.uniform(0.1, 9)) / length) ** 2
        loads = {"beta": stiffness * share, "eta": stiffness * (1 - share)}
        angles = {"clamp_angle": mpf(draw.uniform(-7, 7)) / 3, "field_angle": mpf(draw.uniform(-3, 3)) / 3}
        asked = inspect.signature(twin(scene).equilibria).parameters
        given = {name: value for name, value in {**loads, "length": length, **angles}.items() if name in asked}
        load = given.get("beta", 0) + given.get("eta", 0)
        bend = {"clamp_curvature": mp.sqrt(load), "gamma": load, "energy": load * length}
        return given, {"tip_angle": 1, "theta": 1, "curvature": mp.sqrt(load), "y": length, "z": length, **bend}


def worst(answers: Any, finer: Any, sizes: dict[str, Any], names: tuple[str, ...]) -> Any:
    """The largest difference of two answers, each relative to its size."""
    return max(abs(getattr(answers, name) - getattr(finer, name)) / sizes[name] for name in names)


TIP = ("tip_angle", "clamp_curvature", "gamma", "y", "z", "energy")


def check(scene: str, digits: int, number: int) -> None:
    """One rod: as many equilibria with the same indices, and every number of them and of their shapes."""
    module, before = twin(scene), mp.prec
    given, sizes = scales(scene, number)
    rough, fine = (module.equilibria(**given, dps=dps) for dps in (digits, digits + MORE))
    assert [one.index for one in rough] == [one.index for one in fine]
    assert mp.prec == before
    with mp.workdps(digits + MORE):
        bound = mpf(10) ** (2 - digits)
        for one, other in zip(rough, fine, strict=True):
            assert worst(one, other, sizes, TIP) <= bound
            for part in (0, mpf(1) / 7, mpf(2) / 3) if hasattr(module, "shape") else ():
                places = [module.shape(e, part * sizes["y"], dps=n) for e, n in ((one, digits), (other, digits + MORE))]
                assert worst(*places, sizes, ("theta", "curvature", "y", "z")) <= bound
        assert any(one.tip_angle != other.tip_angle for one, other in zip(rough, fine, strict=True))


@pytest.mark.parametrize("digits", [15, 30, 50])
@pytest.mark.parametrize("scene", SCENES)
def test_digits_asked_for_are_right(scene: str, digits: int) -> None:
    for number in range(2):
        check(scene, digits, number)


@pytest.mark.long
@pytest.mark.parametrize(("digits", "rods_of_each"), DEEP)
@pytest.mark.parametrize("scene", SCENES)
def test_up_to_a_thousand_digits(scene: str, digits: int, rods_of_each: int, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(twin(scene), "MOST", FINEST)  # for the finer run beside that with a thousand
    for number in range(rods_of_each):
        check(scene, digits, number)


@pytest.mark.parametrize("scene", SCENES)
def test_forty_digits_are_those_of_taylor_integration(scene: str) -> None:
    """References share no formula with the solver; the rods are doubles, folded constants exact."""
    plan = load_scene(shipped_scenes()[scene])
    rod = rods(plan.case, {name: float(value) for name, value in plan.folded.items()})[0]
    with mp.workdps(2 * EXACT):
        exact = {name: mpf(str(value.evalf(2 * EXACT))) for name, value in plan.folded.items()}
    known = references(rod, exact)
    module = twin(scene)
    asked = inspect.signature(module.equilibria).parameters
    given = {name: value for name, value in vars(rod).items() if name in asked}
    found = module.equilibria(**given, dps=EXACT + 5)
    assert [one.index for one in found] == [one.index for one in known]
    load = mpf(rod.beta + rod.eta)
    with mp.workdps(EXACT + 5):
        sizes = {"y": rod.length, "z": rod.length, "clamp_curvature": mp.sqrt(load), "gamma": load}
        sizes |= {"tip_angle": 1, "energy": load * rod.length}
        for one, other in zip(found, known, strict=True):
            for name in TIP:
                assert abs(getattr(one, name) - other.values[name]) <= mpf(10) ** (2 - EXACT) * sizes[name], name
