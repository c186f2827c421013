"""Run an emitted module against the references, and say how far it is off in units that mean something.

A solver in double precision cannot be better than its inputs: moving them by one rounding u = 2**-53 moves a quantity Q
by u·Σ|p ∂Q/∂p|, and writing Q down costs u times its natural size (1 for angles, ℓ for places, √(β+η) for curvatures,
(β+η)ℓ for energies, β+η for γ). Errors are given in multiples of the sum of both; 1 is as good as doubles can be.
"""

from __future__ import annotations

import inspect
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field
from math import isfinite, sqrt
from types import ModuleType
from typing import Any

from mpmath import mp, mpf

from derive.measure.reference import DIGITS, FRACTIONS, Reference, Rod
from derive.measure.sweeps import sweep_faults, swept_alone

DOUBLE = 2.0**-53
# Digits at which the mpmath twins are run; the references have 40.
TWIN_DIGITS = 30
# How many roundings a module may be off before it is not written. A wrong sign or term is off by more than 1e10;
# what is measured on moderate rods is 10 at most, and a rod near a fold may cost some more.
ROUNDINGS = 200.0

# Of an equilibrium, and of its shape at the arc lengths `FRACTIONS`.
QUANTITIES = ("tip_angle", "clamp_curvature", "gamma", "y", "z", "energy")
SHAPE = ("theta", "curvature", "y", "z")


@dataclass(frozen=True)
class Row:
    """The worst error of one quantity: absolute, over its natural size, in roundings, and where it was met."""

    quantity: str
    absolute: float
    relative: float
    roundings: float
    rod: str


@dataclass
class Agreement:
    """How a module compares: one row per quantity, and what is wrong in kind (missing equilibria, wrong index)."""

    rows: dict[str, Row] = field(default_factory=dict)
    faults: list[str] = field(default_factory=list)
    equilibria: int = 0
    folds: int = 0  # ranges of η in which they were compared

    @property
    def holds(self) -> bool:
        """Whether the module may be written."""
        within = all(row.roundings <= ROUNDINGS for row in self.rows.values())
        return within and bool(self.equilibria or self.folds) and not self.faults

    def reasons(self) -> list[str]:
        """What keeps the module from being written, one line each."""
        far = [row for row in self.rows.values() if not row.roundings <= ROUNDINGS]
        lines = [
            f"{row.quantity} is off by {row.absolute:.1e} ({row.roundings:.1e} roundings) at {row.rod}" for row in far
        ]
        none = [] if self.equilibria or self.folds else ["it was compared with no equilibrium at all"]
        return self.faults + lines + none


def agreement(module: ModuleType, references: Iterable[tuple[Rod, list[Reference]]], unit: float = DOUBLE) -> Agreement:
    """The worst errors of a module over some rods and all their equilibria; unit is the module's rounding."""
    result, given, found, rounding = Agreement(), [], [], []
    for rod, known in references if hasattr(module, "equilibria") or not hasattr(module, "folds") else ():
        try:
            with mp.workdps(TWIN_DIGITS):  # also where the scene makes no output of equilibria, and it takes no dps
                equilibria = solutions(module, rod)
            enter(result, module, equilibria, known, unit)
        except Exception as error:  # whatever a module raises on a valid rod is its fault
            result.faults.append(f"it fails with {type(error).__name__}: {error} at {rod}")
        else:
            given.append(rod)
            found.append(equilibria)
            rounding.append([roundings_of(one, unit) for one in known])
    if hasattr(module, "sweep") and given and not result.faults:
        result.faults += sweep_faults(module, [arguments(module.sweep, rod) for rod in given], found, rounding)
    return result


def solutions(module: ModuleType, rod: Rod) -> list[Any]:
    """The equilibria that a module gives for one rod."""
    if hasattr(module, "equilibria"):
        return list(module.equilibria(**arguments(module.equilibria, rod)))
    return swept_alone(module, arguments(module.sweep, rod))


def roundings_of(reference: Reference, unit: float) -> dict[str, float]:
    """What one rounding of the inputs and of the result makes of each quantity."""
    return {name: unit * (natural_size(name, reference.rod) + reference.sensitivity[name]) for name in QUANTITIES}


def enter(result: Agreement, module: ModuleType, found: list[Any], known: list[Reference], unit: float) -> None:
    """Enter what a module finds for one rod; there is always an equilibrium."""
    rod = known[0].rod
    if len(found) != len(known):
        result.faults.append(f"{len(found)} equilibria instead of {len(known)} at {rod}")
        return
    for equilibrium, reference in zip(found, known, strict=True):
        result.equilibria += 1
        if equilibrium.index != reference.index:
            place = f"tip angle {float(equilibrium.tip_angle):.10g}, {rod}"
            result.faults.append(f"index {equilibrium.index} instead of {reference.index} at {place}")
        compare(result, reference, answers(module, equilibrium, rod), unit)


def arguments(function: Callable[..., Any], rod: Rod) -> dict[str, Any]:
    """The parameters that a function of the module takes, from the rod; a folded or absent one is left out."""
    known = {**vars(rod), "dps": TWIN_DIGITS}
    return {name: known[name] for name in inspect.signature(function).parameters if name in known}


def answers(module: ModuleType, equilibrium: Any, rod: Rod) -> dict[str, Any]:
    """All quantities that the module gives for one equilibrium, by the references' names."""
    values = {name: getattr(equilibrium, name) for name in QUANTITIES}
    if hasattr(module, "shape"):
        digits = {name: value for name, value in arguments(module.shape, rod).items() if name == "dps"}
        for fraction in FRACTIONS:
            shape = module.shape(equilibrium, fraction * rod.length, **digits)
            for name in SHAPE:
                values[f"{name}({fraction}ℓ)"] = getattr(shape, name)
    return values


def compare(result: Agreement, reference: Reference, values: Mapping[str, Any], unit: float) -> None:
    """Enter the errors of one equilibrium where they are the worst so far."""
    rod = reference.rod
    for name, value in values.items():
        quantity, error = quantity_of(name), off(value, reference.values[name])
        size = natural_size(quantity, rod)
        roundings = error / (unit * (size + reference.sensitivity[name]))
        worst = result.rows.get(quantity)
        if not isfinite(error):
            result.faults.append(f"{quantity} is {value} at {rod}")
        elif worst is None or roundings > worst.roundings:
            result.rows[quantity] = Row(quantity, error, error / size, roundings, str(rod))


def quantity_of(name: str) -> str:
    """Whose value a name is, as θ(s) of θ(0.5ℓ): those of all places along a rod count as one."""
    return name.split("(")[0] + "(s)" if "(" in name else name


def off(value: Any, known: Any) -> float:
    """How far a value is from that of a reference, whose digits all count."""
    with mp.workdps(DIGITS + 5):
        return abs(float(mpf(value) - known))


def natural_size(quantity: str, rod: Rod) -> float:
    """The size below which a quantity is as good as zero."""
    stiffness = rod.beta + rod.eta
    match quantity.removesuffix("(s)"):
        case "tip_angle" | "theta":
            return 1.0
        case "curvature" | "clamp_curvature":
            return sqrt(stiffness) or 1.0
        case "gamma":
            return stiffness or 1.0
        case "energy":
            return stiffness * rod.length or 1.0
        case _:
            return rod.length
