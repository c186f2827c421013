"""Every public function of every emitted module: each wrong argument is one clear error that begins with its name."""

from __future__ import annotations

import importlib
import inspect
import math
from collections.abc import Callable, Iterator
from types import ModuleType
from typing import Any

import numpy as np
import pytest

from derive.resources import shipped_scenes

MODULES = [f"{scene}_{backend}" for scene in shipped_scenes() for backend in ("numpy", "mpmath")]
GOOD: dict[str, Any] = {"beta": 1.0, "eta": 1.0, "length": 2.0, "clamp_angle": 1.0, "field_angle": 0.5, "s": 0.5}
RANGED = {"folds": ("eta",), "exchanges": ("beta", "eta")}  # parameters that are ranges there
NO_NUMBERS = (1j, "two", None, True, [[1.0], "x"], object(), np.array([1j]))
NOT_FINITE = (math.nan, math.inf, -math.inf, np.float64("nan"))
NO_RANGES = (1.0, "ab", None, (1.0,), (0.0, 1.0, 2.0), (1.0, 0.5), (1.0, 1.0), (math.nan, 1.0), (0.0, math.inf))
NO_RANGES += ((-1.0, 1.0), (0.0, 1j), ("a", "b"), {0.0: 1.0})


def public(module: ModuleType) -> dict[str, Callable[..., Any]]:
    """Its functions by name."""
    return {name: found for name in module.__all__ if inspect.isfunction(found := getattr(module, name))}


def right(module: ModuleType, name: str, function: Callable[..., Any]) -> dict[str, Any]:
    """Arguments with which a function works."""
    asked = inspect.signature(function).parameters
    given = {one: (0.0, 1.0) if one in RANGED.get(name, ()) else GOOD[one] for one in asked if one in GOOD}
    if "equilibrium" in asked:
        (given["equilibrium"], *_) = module.equilibria(**right(module, "equilibria", module.equilibria))
    return given


def wrong(name: str, one: str) -> Iterator[Any]:
    """Values that are wrong for one parameter of a function."""
    if one in RANGED.get(name, ()):
        yield from NO_RANGES
        return
    yield from NO_NUMBERS
    yield from () if one == "equilibrium" else NOT_FINITE
    if one in ("beta", "eta", "length", "s"):
        yield -1e-300
    if one == "length":
        yield from (0, 0.0, -2)
    if name == "sweep" or one == "s":
        yield [GOOD[one], math.nan]
    elif one != "equilibrium":
        yield [GOOD[one], GOOD[one]]


@pytest.mark.parametrize("name", MODULES)
def test_a_wrong_argument_is_one_clear_error(name: str) -> None:
    module, tried = importlib.import_module(f"generated.{name}"), 0
    for called, function in public(module).items():
        given = right(module, called, function)
        for one in given:
            for value in wrong(called, one):
                with pytest.raises((TypeError, ValueError)) as caught:
                    function(**given | {one: value})
                assert str(caught.value).startswith(one), (called, one, value, str(caught.value))
                assert "\n" not in str(caught.value)
                tried += 1
    assert tried > 50


@pytest.mark.parametrize("name", MODULES)
def test_options_are_checked_too(name: str) -> None:
    module = importlib.import_module(f"generated.{name}")
    for called, function in public(module).items():
        given = right(module, called, function)
        for option, values in {"max_index": (-1, 1.5, True, "1"), "dps": (14, 1001, 30.0, True, "30")}.items():
            for value in values if option in inspect.signature(function).parameters else ():
                with pytest.raises((TypeError, ValueError), match=rf"^{option} must "):
                    function(**given, **{option: value})


@pytest.mark.parametrize("name", MODULES)
def test_arrays_that_do_not_fit_are_named(name: str) -> None:
    module = importlib.import_module(f"generated.{name}")
    given = right(module, "sweep", module.sweep)
    first, second, *_ = given
    with pytest.raises(ValueError, match=rf"(broadcast|one length).*{first} \(?2,?\)?, {second} \(?3,?\)?"):
        module.sweep(**given | {first: [1.0, 2.0], second: [1.0, 2.0, 3.0]})
