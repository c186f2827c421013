"""Equilibria of a module as rows, for one rod or for many values of one parameter."""

from __future__ import annotations

import inspect
from collections.abc import Mapping, Sequence
from dataclasses import astuple, dataclass, fields
from types import ModuleType
from typing import Any


@dataclass(frozen=True, slots=True)
class State:
    """What an emitted module says of the tip of one equilibrium; see its ``Equilibrium``."""

    tip_angle: float
    clamp_curvature: float
    gamma: float
    y: float
    z: float
    energy: float
    index: int

    def numbers(self) -> tuple[float, ...]:
        """All but the index."""
        return astuple(self)[:-1]


FIELDS = tuple(one.name for one in fields(State))


def rows(module: ModuleType, parameter: str, values: Sequence[float], fixed: Mapping[str, float]) -> list[list[State]]:
    """All equilibria at each value of the parameter, in the order of their tip angles."""
    swept = module.sweep(**arguments(module.sweep, {**fixed, parameter: list(values)}))
    found: list[list[State]] = [[] for _ in values]
    columns = zip(*(getattr(swept, name).tolist() for name in FIELDS), strict=True)
    for case, column in zip(swept.case.tolist(), columns, strict=True):
        found[case].append(State(*column))
    return found


def arguments(function: Any, given: Mapping[str, Any]) -> dict[str, Any]:
    """Those of the given numbers that are parameters of a function of a module."""
    return {name: value for name, value in given.items() if name in inspect.signature(function).parameters}
