"""A module with folded constants gives what the full one gives at their values, as far as the rod's condition allows.

The condition is how much an answer changes with its inputs: with each load and the length relatively, with the angles
absolutely, by differences of the full module's own answers.
"""

from __future__ import annotations

import importlib
import inspect
import random
from math import pi, sqrt
from typing import Any

import pytest
from mpmath import mp, mpf

from derive.emit.scene import load_scene
from derive.resources import shipped_scenes
from generated import oblique_mpmath, oblique_numpy

FULL = "oblique"
SPECIAL = sorted(set(shipped_scenes()) - {FULL})
NUMBERS = ("tip_angle", "clamp_curvature", "gamma", "y", "z", "energy")
LOADS = ("beta", "eta", "length")
ULP, DIGITS = 2.0**-52, 30
STEP = 1e-7  # of the inputs, for the condition
ROUNDINGS = 8  # by which two ways to round may differ, each in some ten operations that count


def rods(scene: str, count: int) -> list[dict[str, float]]:
    """All five parameters of random rods of a scene."""
    draw, folded, found = random.Random(scene), load_scene(shipped_scenes()[scene]).folded, []
    for _ in range(count):
        length = float(folded.get("length", 10 ** draw.uniform(-2, 2)))
        share, stiffness = draw.random(), (draw.uniform(0.1, 7) / length) ** 2
        rod = {"beta": stiffness * share, "eta": stiffness * (1 - share), "length": length}
        rod |= {"clamp_angle": draw.uniform(-2 * pi, 2 * pi), "field_angle": draw.uniform(-pi, pi)}
        found.append(rod | {name: float(value) for name, value in folded.items()})
    return found


def own(module: Any, rod: dict[str, Any]) -> dict[str, Any]:
    """The parameters that a module has."""
    return {name: rod[name] for name in inspect.signature(module.equilibria).parameters if name in rod}


def sizes(rod: dict[str, float]) -> dict[str, float]:
    load, length = rod["beta"] + rod["eta"], rod["length"]
    units = {"clamp_curvature": sqrt(load), "gamma": load, "y": length, "z": length, "energy": load * length}
    return {"tip_angle": 2 * pi, **units}


def conditions(rod: dict[str, float], found: list[Any]) -> list[dict[str, float]] | None:
    """How each number of each equilibrium changes with the inputs; None where one of them is about to vanish."""
    total = [dict.fromkeys(NUMBERS, 0.0) for _ in found]
    for name, value in rod.items():
        moved = oblique_numpy.equilibria(**rod | {name: value * (1 + STEP) if name in LOADS else value + STEP})
        if [one.index for one in moved] != [one.index for one in found]:
            return None
        for sums, one, other in zip(total, found, moved, strict=True):
            for number in NUMBERS:
                sums[number] += abs(getattr(one, number) - getattr(other, number)) / STEP
    return total


@pytest.mark.parametrize("scene", SPECIAL)
def test_they_agree_to_the_last_digits(scene: str) -> None:
    module, compared = importlib.import_module(f"generated.{scene}_numpy"), 0
    for rod in rods(scene, 60):
        full, special = oblique_numpy.equilibria(**rod), module.equilibria(**own(module, rod))
        assert [one.index for one in special] == [one.index for one in full], rod
        condition, unit = conditions(rod, full), sizes(rod)
        for one, other, of in zip(special, full, condition or (), strict=condition is not None):
            for name in NUMBERS:
                off = abs(getattr(one, name) - getattr(other, name))
                assert off <= ROUNDINGS * ULP * (unit[name] + of[name]), (name, off / ULP / unit[name], rod)
        compared += condition is not None
    assert compared > 50


@pytest.mark.parametrize("scene", SPECIAL)
def test_the_twins_agree_to_the_last_digits(scene: str) -> None:
    """With constants folded exactly, π/2 too."""
    module, folded = importlib.import_module(f"generated.{scene}_mpmath"), load_scene(shipped_scenes()[scene]).folded
    (rod,) = rods(scene, 1)
    with mp.workdps(DIGITS + 5):
        exact = rod | {name: mpf(str(value.evalf(DIGITS + 5))) for name, value in folded.items()}
        full, special = oblique_mpmath.equilibria(**exact), module.equilibria(**own(module, rod))
        assert [one.index for one in special] == [one.index for one in full]
        condition, unit = conditions(rod, oblique_numpy.equilibria(**rod)), sizes(rod)
        for one, other, of in zip(special, full, condition or (), strict=True):
            for name in NUMBERS:
                off = abs(getattr(one, name) - getattr(other, name))
                assert off <= mpf(10) ** -DIGITS * (unit[name] + of[name]), name
