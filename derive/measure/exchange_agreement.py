"""The exchanges of a module against references: as many, each where it is, and what else is told of it."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from math import sqrt
from types import ModuleType
from typing import Any

from derive.measure.agreement import DOUBLE, Agreement, arguments
from derive.measure.exchange_references import ExchangeList
from derive.measure.exchanges import QUANTITIES, ExchangeReference, refined
from derive.measure.fold_agreement import WINDOW, enter_point
from derive.measure.folds import NoFoldError
from derive.measure.reference import Rod

# How near an exchange must be to one of the references, as a share of β + η, to be compared with it.
NEAR = 1e-4
KINDS = ("index", "kind")
Range = tuple[float, float]


def enter_exchanges(result: Agreement, module: ModuleType, known: Iterable[ExchangeList], unit: float = DOUBLE) -> None:
    """Enter how the exchanges of a module differ from the references; unit is the module's rounding."""
    for one in known:
        for forces, fields in windows(one, unit):
            wanted = [point for point in one.exchanges if inside(point, forces, fields)]
            try:
                found = module.exchanges(**arguments(module.exchanges, one.rod) | {"beta": forces, "eta": fields})
                compare_exchanges(result, one.rod, found, wanted, unit)
            except Exception as error:  # whatever a module raises on a valid rod is its fault
                result.faults.append(f"exchanges fail with {type(error).__name__}: {error} at {where(one.rod)}")


def windows(known: ExchangeList, unit: float) -> Iterator[tuple[Range, Range]]:
    """The ranges of β and η to ask for: all of them; for a twin, which takes minutes for these, what is around each."""
    if unit == DOUBLE:
        yield (0.0, known.beta), (0.0, known.eta)
        return
    for point in known.exchanges:
        beta, eta = float(point.values["beta"]), float(point.values["eta"])
        yield (beta * (1 - WINDOW), beta * (1 + WINDOW)), (eta * (1 - WINDOW), eta * (1 + WINDOW))


def inside(point: ExchangeReference, forces: Range, fields: Range) -> bool:
    """Whether an exchange is in these ranges."""
    return all(low <= point.values[name] <= high for name, (low, high) in (("beta", forces), ("eta", fields)))


def compare_exchanges(
    result: Agreement, rod: Rod, found: Sequence[Any], wanted: Sequence[ExchangeReference], unit: float
) -> None:
    """Compare each exchange with the nearest reference; one that no reference has is refined."""
    rest = list(found)
    for reference in wanted:
        nearest = min(rest, key=lambda point: distance(point, reference), default=None)
        if nearest is None or not distance(nearest, reference) <= NEAR:
            result.faults.append(f"no {place(reference.values)}, {where(rod)}")
            continue
        rest.remove(nearest)
        enter_exchange(result, rod, nearest, reference, unit)
    for point in rest:
        try:
            near = refined(rod, float(point.beta), float(point.eta), float(point.tip_angle))
            enter_exchange(result, rod, point, near, unit)
        except NoFoldError as error:
            result.faults.append(f"an exchange that is none: {error}")


def distance(point: Any, reference: ExchangeReference) -> float:
    """By how much the loads differ, as a share of them."""
    beta, eta = reference.values["beta"], reference.values["eta"]
    return float((abs(point.beta - beta) + abs(point.eta - eta)) / (beta + eta))


def enter_exchange(result: Agreement, rod: Rod, point: Any, reference: ExchangeReference, unit: float) -> None:
    """Enter the errors of an exchange where they are the worst so far, and what differs in kind."""
    beta, eta = (float(reference.values[name]) for name in ("beta", "eta"))
    sizes = dict.fromkeys(QUANTITIES, rod.length) | {"beta": beta + eta, "eta": beta + eta}
    sizes |= {"tip_angle": 1.0, "clamp_curvature": sqrt(beta + eta)}
    enter_point(result, "exchange", f"{place(reference.values)}, {where(rod)}", point, reference, KINDS, sizes, unit)


def place(values: Any) -> str:
    """An exchange in a few words."""
    return f"exchange at β = {float(values['beta']):.12g}, η = {float(values['eta']):.12g}"


def where(rod: Rod) -> str:
    """The rod in one line, without its own loads."""
    field = f", α = {rod.field_angle:.6g}" if rod.field_angle else ""
    return f"ℓ = {rod.length:.6g}, clamp {rod.clamp_angle:.6g}{field}"
