"""The sweep of a module against its equilibria: the same rods must give the same numbers, in the same places."""

from __future__ import annotations

import inspect
from collections.abc import Mapping, Sequence
from types import ModuleType
from typing import Any

FIELDS = ("tip_angle", "clamp_curvature", "gamma", "y", "z", "energy", "index")


def sweep_faults(module: ModuleType, given: Sequence[Mapping[str, Any]], found: Sequence[Sequence[Any]]) -> list[str]:
    """What differs between one sweep over all rods and the equilibria found for each; ``given`` are the arguments."""
    names = [name for name in inspect.signature(module.sweep).parameters if name in given[0] and name != "dps"]
    extra = {name: value for name, value in given[0].items() if name == "dps"}
    try:
        swept = module.sweep(**{name: [rod[name] for rod in given] for name in names}, **extra)
        got = {name: list(getattr(swept, name)) for name in ("case", *FIELDS)}
    except Exception as error:  # whatever a module raises on valid rods is its fault
        return [f"sweep fails with {type(error).__name__}: {error}"]
    wanted = {"case": [case for case, rod in enumerate(found) for _ in rod]}
    wanted |= {name: [getattr(one, name) for rod in found for one in rod] for name in FIELDS}
    return [line for name in wanted if (line := difference(name, got[name], wanted[name]))]


def difference(name: str, got: list[Any], wanted: list[Any]) -> str:
    """The first place where a column of the sweep is not what the equilibria say."""
    if len(got) != len(wanted):
        return f"sweep: {name} has {len(got)} rows instead of {len(wanted)}"
    wrong = next((k for k, pair in enumerate(zip(got, wanted, strict=True)) if pair[0] != pair[1]), None)
    return "" if wrong is None else f"sweep: {name}[{wrong}] is {got[wrong]}, and equilibria gives {wanted[wrong]}"
