"""The sweep of a module against its equilibria: the same rods must give the same equilibria, in the same places.

A sweep on arrays takes other ways to the same numbers (starting points, series in another order), so both are the
exact ones to a few roundings each, and differ by as many; rows and indices are the same.
"""

from __future__ import annotations

import inspect
from collections.abc import Mapping, Sequence
from types import ModuleType, SimpleNamespace
from typing import Any

FIELDS = ("tip_angle", "clamp_curvature", "gamma", "y", "z", "energy", "index")
# How far a sweep may be from the equilibria, in roundings: of the natural size, and by what one of the inputs moves it.
# Measured are 10 on moderate rods; a term that is missing or wrong is off by more than 1e6.
ALIKE = 100.0
MANY = 64  # rods at least, the same ones again and again: fewer are solved one by one, and no array is tried


def sweep_faults(
    module: ModuleType,
    given: Sequence[Mapping[str, Any]],
    found: Sequence[Sequence[Any]],
    rounding: Sequence[Sequence[Mapping[str, float]]],
) -> list[str]:
    """What differs between one sweep over all rods and the equilibria found for each; ``given`` are the arguments.

    rounding: for each equilibrium what one rounding amounts to, by the name of the quantity.
    """
    copies = 1 if "dps" in given[0] else -(-MANY // len(given))
    given, found, rounding = [*given] * copies, [*found] * copies, [*rounding] * copies
    try:
        got = swept(module, given)
    except Exception as error:  # whatever a module raises on valid rods is its fault
        return [f"sweep fails with {type(error).__name__}: {error}"]
    wanted = {"case": [case for case, rod in enumerate(found) for _ in rod]}
    wanted |= {name: [getattr(one, name) for rod in found for one in rod] for name in FIELDS}
    units = [one for rod in rounding for one in rod]
    return [line for name in wanted if (line := difference(name, got[name], wanted[name], units))]


def swept(module: ModuleType, given: Sequence[Mapping[str, Any]]) -> dict[str, list[Any]]:
    """The columns of a sweep over rods."""
    names = [name for name in inspect.signature(module.sweep).parameters if name in given[0] and name != "dps"]
    extra = {name: value for name, value in given[0].items() if name == "dps"}
    found = module.sweep(**{name: [rod[name] for rod in given] for name in names}, **extra)
    return {name: list(getattr(found, name)) for name in ("case", *FIELDS)}


def swept_alone(module: ModuleType, given: Mapping[str, Any]) -> list[Any]:
    """The equilibria of one rod by a module that has no function for it: its sweep over that rod."""
    columns = swept(module, [given])
    return [SimpleNamespace(**{name: columns[name][k] for name in FIELDS}) for k in range(len(columns["case"]))]


def difference(name: str, got: list[Any], wanted: list[Any], units: Sequence[Mapping[str, float]]) -> str:
    """The first place where a column of the sweep is not what the equilibria say."""
    if len(got) != len(wanted):
        return f"sweep: {name} has {len(got)} rows instead of {len(wanted)}"
    for k, (one, other) in enumerate(zip(got, wanted, strict=True)):
        allowed = ALIKE * units[k][name] if name in units[k] else 0
        if not abs(one - other) <= allowed:
            return f"sweep: {name}[{k}] is {one}, and equilibria gives {other}"
    return ""
