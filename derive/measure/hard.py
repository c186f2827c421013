"""Run a module on hard rods: how far is it off, in ulps of the length and in units of the bound that is promised?

The bound on the tip's position is 4·2⁻⁵²·ℓ plus the condition number Σ|p ∂/∂p| times 2⁻⁵²; likewise for every other
quantity with its natural size in place of ℓ. Each equilibrium that the module finds is refined to 40 digits from its
own shape, so that the reference is of that very equilibrium; what is missing or found twice is seen by the checks in
kind: brute force counts moderate rods, indices alternate in parity from 0 on (so their number is odd), no two answers
refine to the same equilibrium.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from itertools import pairwise
from math import isfinite, isnan, sqrt
from types import ModuleType
from typing import Any

import numpy as np
from mpmath import mpf

from derive.measure.agreement import answers, arguments, natural_size, off, quantity_of
from derive.measure.chains import Guess
from derive.measure.counts import STIFFEST, count
from derive.measure.long_rods import Refined, refine
from derive.measure.reference import DIGITS, NoEquilibriumError, Rod, solve
from derive.measure.suites import Case
from derive.measure.taylor import integrate

ULP = 2.0**-52
SIZES = 4.0  # of ulps of the natural size that the bound allows
# A module answers for the equilibrium that its shape leads to if their tips agree to this.
SAME = 1e-6


@dataclass(frozen=True)
class Worst:
    """The worst error of one quantity, with the rod's name and inputs; by is in ulps or in bounds."""

    by: float
    name: str
    rod: Rod


@dataclass
class Hardness:
    """What a module does on a suite: by quantity the worst in ulps of its size and in bounds; what is wrong in kind."""

    ulps: dict[str, Worst] = field(default_factory=dict)
    bounds: dict[str, Worst] = field(default_factory=dict)
    faults: list[str] = field(default_factory=list)
    equilibria: int = 0

    def enter(self, case: Case, quantity: str, ulps: float, bounds: float) -> None:
        """Keep what is worse than so far; nan is worse than all, and stays."""
        _keep(self.ulps, quantity, Worst(ulps, case.name, case.rod))
        _keep(self.bounds, quantity, Worst(bounds, case.name, case.rod))

    def take(self, other: Hardness) -> None:
        """Keep what is worse in another result, all its faults and its number of equilibria."""
        for kept, found in ((self.ulps, other.ulps), (self.bounds, other.bounds)):
            for quantity, worst in found.items():
                _keep(kept, quantity, worst)
        self.faults += other.faults
        self.equilibria += other.equilibria

    def rows(self, title: str, quantities: Sequence[str] | None = None) -> list[str]:
        """Rows of a table: suite, quantity, worst in ulps of ℓ (or of its size) and in bounds, and where."""
        return [
            f"| {title} | {name} | {self.ulps[name].by:.2g} | {worst.by:.2g} | {worst.name}: {exact(worst.rod)} |"
            for name, worst in sorted(self.bounds.items())
            if quantities is None or name in quantities
        ]


def _keep(kept: dict[str, Worst], quantity: str, new: Worst) -> None:
    if quantity not in kept or not (new.by <= kept[quantity].by or isnan(kept[quantity].by)):
        kept[quantity] = new


def hardness(module: ModuleType, cases: Iterable[Case], *, most: int | None = None) -> Hardness:
    """Run all cases. most: of a rod with more equilibria, only that many are refined, evenly chosen."""
    result, known = Hardness(), list(cases)
    moderate = [case.rod for case in known if case.rod.length * sqrt(case.rod.beta + case.rod.eta) < STIFFEST]
    numbers = {counted.rod: counted.number for counted in count(moderate)}
    for case in known:
        try:
            found = module.equilibria(**arguments(module.equilibria, case.rod))
            enter(result, module, case, found, numbers.get(case.rod), most)
        except Exception as error:  # whatever a module raises on a valid rod is its fault
            result.faults.append(f"{case.name}: {type(error).__name__}: {error} at {exact(case.rod)}")
    return result


def enter(
    result: Hardness, module: ModuleType, case: Case, found: Sequence[Any], number: int | None, most: int | None
) -> None:
    """Enter what a module finds for one rod."""
    result.faults += [f"{case.name}: {fault} at {exact(case.rod)}" for fault in wrong_in_kind(found, number)]
    step = 1 if most is None else -(-len(found) // most)
    chosen, seen = list(found)[::step], list[Refined]()
    for equilibrium in chosen:
        result.equilibria += 1
        try:
            refined = reference(module, case.rod, equilibrium)
        except (NoEquilibriumError, ArithmeticError) as error:
            result.faults.append(f"{case.name}: {error}")
            continue
        tip = float(equilibrium.tip_angle)
        if any(same(refined, other) for other in seen):
            result.faults.append(
                f"{case.name}: the equilibrium with tip angle {tip!r} is given twice at {exact(case.rod)}"
            )
        if equilibrium.index != refined.reference.index:
            wrong = f"index {equilibrium.index} instead of {refined.reference.index}"
            result.faults.append(f"{case.name}: {wrong} at tip angle {tip!r}, {exact(case.rod)}")
        seen.append(refined)
        compare(result, case, refined, answers(module, equilibrium, case.rod))


def wrong_in_kind(found: Sequence[Any], number: int | None) -> list[str]:
    """What is wrong with the list as a whole."""
    faults = []
    if number is not None and len(found) != number:
        faults.append(f"{len(found)} equilibria instead of {number}")
    if len(found) % 2 == 0:
        faults.append(f"{len(found)} equilibria, an even number")
    tips = [equilibrium.tip_angle for equilibrium in found]
    if any(after < before for before, after in pairwise(tips)):
        faults.append("tip angles out of order")
    if any(equilibrium.index % 2 != k % 2 for k, equilibrium in enumerate(found)):
        faults.append(f"indices {[equilibrium.index for equilibrium in found]} do not alternate in parity")
    return faults


def reference(module: ModuleType, rod: Rod, equilibrium: Any) -> Refined:
    """The equilibrium that an answer stands for."""
    refined = refine(rod, shape_of(module, rod, equilibrium))
    gap = abs(float(refined.reference.values["tip_angle"] - mpf(equilibrium.tip_angle)))
    if not gap < SAME:
        raise NoEquilibriumError(f"the shape of tip angle {float(equilibrium.tip_angle)!r} leads {gap:.1e} away: {rod}")
    return refined


def shape_of(module: ModuleType, rod: Rod, equilibrium: Any) -> Guess:
    """θ and θ′ along a rod: from the module, or from a reference if its scene gives no shape."""
    if hasattr(module, "shape"):

        def drawn(s: Any) -> tuple[Any, Any]:
            shape = module.shape(equilibrium, np.minimum(s, rod.length))
            return shape.theta, shape.curvature

        return drawn
    return shot_from(rod, solve(rod, equilibrium.tip_angle).values["tip_angle"])


def shot_from(rod: Rod, tip: Any) -> Guess:
    """θ and θ′ along a moderate rod from its tip angle."""

    def drawn(s: Any) -> tuple[Any, Any]:
        stops = [mpf(float(part)) for part in s]
        path = integrate(tip, rod.beta, rod.eta, rod.field_angle, rod.length, stops=stops)
        at = {point.s: point for point in path.points}
        return [float(at[part].theta) for part in stops], [float(at[part].curvature) for part in stops]

    return drawn


def same(one: Refined, other: Refined) -> bool:
    """Whether two references are of one equilibrium: the same direction of rest, and offsets that agree."""
    if one.rest != other.rest:
        return False
    gap = abs(one.offset - other.offset)
    return bool(gap <= max(abs(one.offset), abs(other.offset)) * mpf(10) ** -(DIGITS - 5))


def compare(result: Hardness, case: Case, refined: Refined, values: dict[str, Any]) -> None:
    """Enter the errors of one equilibrium."""
    known = refined.reference
    for name, value in values.items():
        quantity, error = quantity_of(name), off(value, known.values[name])
        size = natural_size(quantity, case.rod)
        if not isfinite(error):
            result.faults.append(f"{case.name}: {name} is {value} at {exact(case.rod)}")
        result.enter(case, quantity, error / ULP / size, error / ULP / (SIZES * size + known.sensitivity[name]))


def exact(rod: Rod) -> str:
    """The inputs as they are, to be typed in again."""
    field_angle = f", field_angle={rod.field_angle!r}" if rod.field_angle else ""
    return f"beta={rod.beta!r}, eta={rod.eta!r}, length={rod.length!r}, clamp_angle={rod.clamp_angle!r}{field_angle}"
