"""The folds of a module against references: as many, each where it is, and what else is told of it."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from math import isfinite, sqrt
from types import ModuleType
from typing import Any

from derive.measure.agreement import DOUBLE, Agreement, Row, arguments, off
from derive.measure.fold_references import QUANTITIES, FoldList, FoldReference, refined
from derive.measure.folds import NoFoldError
from derive.measure.reference import Rod

# The twins take seconds for a wide range: they are asked for one of this share around each fold.
WINDOW = 1 / 64
# How near a fold must be to one of the references, as a share of η, to be compared with it.
NEAR = 1e-4


def enter_folds(result: Agreement, module: ModuleType, known: Iterable[FoldList], unit: float = DOUBLE) -> None:
    """Enter how the folds of a module differ from the references; unit is the module's rounding."""
    for one in known:
        for low, high in windows(one, unit):
            result.folds += 1
            wanted = [fold for fold in one.folds if low <= fold.values["eta"] <= high]
            try:
                found = module.folds(**arguments(module.folds, one.rod) | {"eta": (low, high)})
                compare_folds(result, one.rod, found, wanted, unit)
            except Exception as error:  # whatever a module raises on a valid rod is its fault
                result.faults.append(f"folds fail with {type(error).__name__}: {error} at {where(one.rod)}")
    if not result.folds:
        result.faults.append("its folds were compared with none: no rod of the scene is moderate")


def windows(known: FoldList, unit: float) -> Iterator[tuple[float, float]]:
    """The ranges of η to ask for: all of it; for a twin, what is around each fold.

    A double within rounding of a direction of equilibrium is none to a twin, for which the straight rod bends a little.
    """
    if unit == DOUBLE:
        yield 0.0, known.high
        return
    for fold in (fold for fold in known.folds if fold.kind == "fold"):
        eta = float(fold.values["eta"])
        yield eta * (1 - WINDOW), min(eta * (1 + WINDOW), known.high)


def compare_folds(
    result: Agreement, rod: Rod, found: Sequence[Any], wanted: Sequence[FoldReference], unit: float
) -> None:
    """Compare each fold with the nearest reference; two that undo one another may be in none, and are refined."""
    rest = list(found)
    for reference in wanted:
        eta = reference.values["eta"]
        nearest = min(rest, key=lambda fold: abs(fold.eta - eta), default=None)
        if nearest is None or not abs(nearest.eta - eta) <= NEAR * eta:
            result.faults.append(f"no fold at η = {float(eta):.12g}, {where(rod)}")
            continue
        rest.remove(nearest)
        enter_fold(result, rod, nearest, reference, unit)
    if sum(fold.change for fold in rest):
        places = ", ".join(f"{float(fold.eta):.12g}" for fold in rest)
        result.faults.append(f"folds that are none, among those at η = {places}, {where(rod)}")
        return
    for fold in rest:
        try:
            enter_fold(result, rod, fold, refined(rod, float(fold.eta), float(fold.tip_angle)), unit)
        except NoFoldError as error:
            result.faults.append(f"a fold that is none: {error}")


def enter_fold(result: Agreement, rod: Rod, fold: Any, reference: FoldReference, unit: float) -> None:
    """Enter the errors of a fold where they are the worst so far, and what differs in kind."""
    at = f"the fold η = {float(reference.values['eta']):.12g}, {where(rod)}"
    sizes = {name: natural_size(name, rod, float(reference.values["eta"])) for name in QUANTITIES}
    enter_point(result, "fold", at, fold, reference, ("index", "change", "kind"), sizes, unit)


def enter_point(
    result: Agreement,
    what: str,
    at: str,
    found: Any,
    reference: Any,
    kinds: Sequence[str],
    sizes: Mapping[str, float],
    unit: float,
) -> None:
    """Enter a point of a diagram: what differs in kind, and the errors of its quantities where they are the worst.

    what: the kind of point. at: where it is, for who reads. sizes: below which a quantity is as good as zero, by name.
    """
    for name in kinds:
        if getattr(found, name) != getattr(reference, name):
            result.faults.append(f"{name} {getattr(found, name)} instead of {getattr(reference, name)} at {at}")
    for name, size in sizes.items():
        error = off(getattr(found, name), reference.values[name])
        roundings = error / (unit * (size + reference.sensitivity[name]))
        quantity, worst = f"{what} {name}", result.rows.get(f"{what} {name}")
        if not isfinite(error):
            result.faults.append(f"{name} is {getattr(found, name)} at {at}")
        elif worst is None or roundings > worst.roundings:
            result.rows[quantity] = Row(quantity, error, error / size, roundings, at)


def natural_size(name: str, rod: Rod, eta: float) -> float:
    """The size below which a quantity is as good as zero."""
    sizes = {"eta": eta, "tip_angle": 1.0, "clamp_curvature": sqrt(rod.beta + eta)}
    return sizes.get(name, rod.length)


def where(rod: Rod) -> str:
    """The rod in one line, without its own η."""
    field = f", α = {rod.field_angle:.6g}" if rod.field_angle else ""
    return f"β = {rod.beta:.6g}, ℓ = {rod.length:.6g}, clamp {rod.clamp_angle:.6g}{field}"
