"""The derivation from an energy of one's own up to the map on the solver's rod: what all later steps start from."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

from sympy import Expr, srepr

from derive.own_energy import checks
from derive.own_energy.curve import curve_of
from derive.own_energy.law import law_of
from derive.own_energy.reduction import Reduction, claim_reduction, reduce_plane
from derive.theory import equilibrium, plane
from derive.theory.claims import Notebook
from derive.theory.energy import Energy
from derive.theory.plane import Plane


@dataclass
class Derivation:
    """moduli: "tau" and "eta", as far as there, by the letters of the energy, 1/m². law: the equation as plain data."""

    energy: Energy
    book: Notebook = field(repr=False)
    plane: Plane
    reduction: Reduction
    moduli: Mapping[str, Expr]
    law: dict[str, Any]
    key: str
    complete: bool = False

    def finish(self, known: Plane) -> Notebook:
        """The notebook with the claims that the plane problem is ``known`` in turned axes."""
        if not self.complete:
            claim_reduction(self.reduction, self.plane, known, self.book)
            self.complete = True
        return self.book


def derive_own(energy: Energy) -> Derivation:
    """Derive from an energy; MistakeError, in one line, if it is one that the chain cannot take."""
    checks.check_energy(energy)
    book = Notebook()
    section2 = equilibrium.derive_section2(energy, book)
    problem = plane.derive(section2, book)
    checks.check_curve(energy, problem.energy_density, curve_of(problem))
    reduction = reduce_plane(problem, book)
    moduli = {letter.name: value for letter, value in section2.moduli.items()}
    law = law_of(reduction.density, reduction.acceleration, problem.alignment, ("beta", *reduction.present))
    return Derivation(energy, book, problem, reduction, moduli, law, key_of(energy))


def key_of(energy: Energy) -> str:
    """All that an energy says, as text: what results are kept under."""
    units = sorted(f"{letter}: {srepr(unit)}" for letter, unit in (energy.units or {}).items())
    return "\n".join([energy.name, srepr(checks.density_of(energy)), str(energy.units is None), *units])
