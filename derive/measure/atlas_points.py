"""One rod of the atlas: how far our module and its peers are off, and what fails.

Errors are in ulps (2⁻⁵²) of a quantity's natural size, and in bounds: over 4·2⁻⁵² of that size and 2⁻⁵² times the
condition number, what the inputs' last digits leave undecided. References are refined from our module's shapes to 40
digits by Taylor integration; a peer's rod is compared with the reference whose tip is nearest to its own.
"""

from __future__ import annotations

import time
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import asdict, dataclass, field
from importlib import import_module
from math import isfinite, sqrt
from types import ModuleType
from typing import Any

import numpy as np

from derive.measure.agreement import answers, arguments, natural_size, off, quantity_of
from derive.measure.atlas_maps import Map, rod_at
from derive.measure.atlas_peers import Peer
from derive.measure.atlas_stiff import ALL_PEERS
from derive.measure.counts import STIFFEST, count
from derive.measure.hard import SIZES, ULP, reference, same, wrong_in_kind
from derive.measure.long_rods import Refined
from derive.measure.packages import absent
from derive.measure.reference import Rod

OURS = "ours"
TITLES = {OURS: "ours", **{name: peer.title for name, peer in ALL_PEERS.items()}}
# A peer whose error is so many bounds has lost half of the digits.
HALF = 2.0**26
# Two equilibria are one tip to a peer if they are nearer than this.
APART = 1e-3
MOST_CONDITION = 1e300


@dataclass
class Record:
    """What one solver does on one rod of a map.

    number: equilibria found. compared: of them, those with a reference. ulps, bounds: the worst error, None if there is
    no value; quantity: whose. condition: the greatest condition number of what is compared, over its natural size; one
    that bounds nothing (beyond 1e300) does not count. formulas: which forms were used, where the answer tells.
    failures: "kind: what" each.
    """

    solver: str
    number: int | None = None
    compared: int = 0
    ulps: float | None = None
    bounds: float | None = None
    quantity: str = ""
    condition: float | None = None
    formulas: list[str] = field(default_factory=list)
    failures: list[str] = field(default_factory=list)
    seconds: float = 0.0

    def fail(self, kind: str, what: str) -> None:
        """Note a failure once."""
        line = f"{kind}: {what}" if what else kind
        if line not in self.failures:
            self.failures.append(line)

    def enter(self, known: Refined, values: Mapping[str, Any], rod: Rod) -> None:
        """The errors of one equilibrium."""
        self.compared += 1
        for name, value in values.items():
            quantity, error = quantity_of(name), off(value, known.reference.values[name]) / ULP
            size, sensitivity = natural_size(quantity, rod), known.reference.sensitivity[name]
            bounds = error / (SIZES * size + sensitivity)
            if not isfinite(error):
                self.fail("nan", f"{name} is {value}")
            elif self.bounds is None or bounds > self.bounds:
                self.bounds, self.quantity = bounds, quantity
            if sensitivity / size < MOST_CONDITION:
                self.condition = max(self.condition or 0.0, sensitivity / size)
            if isfinite(error):
                self.ulps = max(self.ulps or 0.0, error / size)


def places(chart: Map) -> Iterator[tuple[int, int]]:
    """All rows and columns of a map."""
    return ((row, column) for row in range(len(chart.rods)) for column in range(len(chart.rods[row])))


def measure_point(chart: Map, row: int, column: int, most: int) -> dict[str, Any]:
    """One rod of a map with what each solver does on it; at most so many equilibria are refined, evenly chosen."""
    rod, module = rod_at(chart, row, column), import_module(f"generated.{chart.case}_numpy")
    ours = Record(OURS)
    known, tips = our_module(ours, module, rod, chart, most)
    records = [ours]
    for name in chart.peers:
        if absent(ALL_PEERS[name]):
            continue
        record = Record(name)
        began = time.perf_counter()
        try:
            with np.errstate(all="ignore"):  # what overflows shows in the answer
                peer(record, ALL_PEERS[name], rod, known, tips if chart.whole else None)
        except (ValueError, ArithmeticError) as error:
            record.fail("no value", str(error))
        record.seconds = time.perf_counter() - began
        records.append(record)
    return {
        "map": chart.name,
        "title": chart.title,
        "labels": [chart.x_label, chart.y_label],
        "shape": [len(chart.ys), len(chart.xs)],
        "row": row,
        "column": column,
        "at": [chart.xs[column], chart.ys[row]],
        "rod": asdict(rod),
        "solvers": [asdict(record) for record in records],
    }


def our_module(
    record: Record, module: ModuleType, rod: Rod, chart: Map, most: int
) -> tuple[list[tuple[Any, Refined]], list[float]]:
    """Enter what our module finds; its equilibria with their references, and all its tips."""
    limit, began = {"max_index": 0} if chart.stable else {}, time.perf_counter()
    try:
        found = module.equilibria(**arguments(module.equilibria, rod), **limit)
    except Exception as error:  # whatever a module raises on a valid rod is its fault
        record.fail("raises", f"{type(error).__name__}: {error}")
        return [], []
    record.seconds, record.number = time.perf_counter() - began, len(found)
    record.formulas = sorted({formula_of(one) for one in found})
    if chart.stable:  # the one that ends along the field
        found = [min(found, key=lambda one: abs(one.tip_angle - rod.field_angle))]
    else:
        for fault in wrong_in_kind(found, brute_force(rod)):
            record.fail("wrong number" if "equilibria" in fault else "wrong kind", fault)
    known: list[tuple[Any, Refined]] = []
    for one in evenly(found, most):
        try:
            refined = reference(module, rod, one)
        except (ValueError, ArithmeticError) as error:
            record.fail("no reference", str(error))
            continue
        if any(same(refined, other) for _, other in known):
            record.fail("given twice", f"tip angle {one.tip_angle!r}")
        if one.index != refined.reference.index:
            record.fail("wrong index", f"{one.index} instead of {refined.reference.index} at {one.tip_angle!r}")
        record.enter(refined, answers(module, one, rod), rod)
        known.append((one, refined))
    return known, [one.tip_angle for one in found]


def brute_force(rod: Rod) -> int | None:
    """The number of equilibria of a moderate rod, by a way that shares nothing with the solver; None of others."""
    return count([rod])[0].number if rod.length * sqrt(rod.beta + rod.eta) < STIFFEST else None


def evenly(found: Sequence[Any], most: int) -> list[Any]:
    """At most so many, from the first to the last."""
    if len(found) <= most:
        return list(found)
    return [found[round(k * (len(found) - 1) / max(1, most - 1))] for k in range(most)]


def formula_of(equilibrium: Any) -> str:
    """Which form gave an equilibrium, as far as it tells."""
    if equilibrium.swing is None:
        return "straight" if equilibrium.clamp_curvature == 0 else "all but straight"
    stay = equilibrium.swing.stay
    if stay.tip or stay.middle or stay.far:
        return "straight stays"
    return "real roots" if stay.motion.middle >= stay.motion.end else "complex roots"


def peer(record: Record, one: Peer, rod: Rod, known: Sequence[tuple[Any, Refined]], tips: list[float] | None) -> None:
    """Enter what a peer finds. tips: those of all our equilibria, which the peer is to find too."""
    if one.tips is None:
        for equilibrium, refined in known:
            record.enter(refined, one.values(rod, equilibrium), rod)
    else:
        found = one.tips(rod)
        record.number = len(found)
        if tips is not None and len(found) != len(tips):
            record.fail("wrong number", f"{len(found)} equilibria instead of {len(tips)}")
        for equilibrium, refined in known:
            tip = min(found, key=lambda tip: abs(tip - equilibrium.tip_angle), default=None)
            if tip is None or abs(tip - equilibrium.tip_angle) > APART:
                record.fail("missed", f"the equilibrium with tip angle {equilibrium.tip_angle:.6g}")
            else:
                record.enter(refined, one.values(rod, tip), rod)
    if record.bounds is not None and record.bounds > HALF:
        record.fail("wrong digits", f"{record.quantity} is off by {record.bounds:.1e} bounds")
