"""The whole derivation: from the energy of a particle to the formulas that solvers evaluate."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

from . import article, equilibrium, oblique, plane, quartic, shape, swing, tip, weierstrass
from .claims import Formula, Notebook
from .load_case import LoadCase
from .oblique import Oblique
from .plane import Plane
from .shape import Shape
from .swing import Swing
from .tip import Tip
from .weierstrass import Weierstrass

STEPS = ("plane", "quartic", "weierstrass", "shape", "tip", "article", "oblique", "swing")


@dataclass(frozen=True)
class Theory:
    """Everything that the energy leads to; mappings are by the name of the load case.

    section2: the vector equations of equilibrium. plane: the plane problem. cases: f, f̂ and their roots. weierstrass:
    the map to ℘. shapes: y(s) and z(s). tips: the solution from the tip. oblique: that at any field angle. swing: the
    motion between turning points, None for another energy than that of paramagnetic particles. formulas: those that
    emitted solvers evaluate. steps: formulas that others rest on, and those of the load cases one by one. book: what
    was derived, in order, with all claims.
    """

    section2: Any = field(repr=False)
    plane: Plane
    cases: Mapping[str, LoadCase]
    weierstrass: Mapping[str, Weierstrass]
    shapes: Mapping[str, Shape]
    tips: Mapping[str, Tip]
    oblique: Oblique
    swing: Swing | None
    formulas: tuple[Formula, ...]
    steps: tuple[Formula, ...]
    book: Notebook = field(repr=False)


def derive_all(energy: Any = None, book: Notebook | None = None) -> Theory:
    """Run all scripts in order, which takes some seconds.

    energy: an ``Energy``; that of paramagnetic particles unless another is given. book: the notebook to write in.
    NotElliptic, a ValueError, if the energy leads to no elliptic function; ValueError if it prefers a direction of
    space.
    """
    book = Notebook() if book is None else book
    section2 = equilibrium.derive_section2(energy=energy, book=book)
    return derive_section3(section2, book)


def derive_section3(section2: Any, book: Notebook, last: str = STEPS[-1]) -> Any:
    """Run the scripts of Section 3 from the vector equations of equilibrium.

    section2: those equations, from ``equilibrium.derive_section2``. book: the notebook to write in. last: the step to
    stop after, one of STEPS; what is given back is the result of that step, and after all of them the ``Theory``.
    """
    plane_problem = plane.derive(section2, book)
    if last == "plane":
        return plane_problem
    cases = quartic.derive(plane_problem, book)
    if last == "quartic":
        return cases
    functions = weierstrass.derive(cases, book)
    if last == "weierstrass":
        return functions
    shapes = shape.derive(cases, functions, book)
    if last == "shape":
        return shapes
    tips = tip.derive(cases, functions, book)
    if last == "tip":
        return tips
    literal = article.derive(cases, functions, shapes, book)
    if last == "article":
        return literal
    any_angle = oblique.derive(plane_problem, cases, functions, book)
    if last == "oblique":
        return any_angle
    motion = swing.derive(plane_problem, any_angle, book)
    steps = tuple(formula for one in tips.values() for formula in one.formulas)
    formulas = literal
    if motion:
        formulas, steps = formulas + motion.formulas, steps + motion.steps
    return Theory(section2, plane_problem, cases, functions, shapes, tips, any_angle, motion, formulas, steps, book)


def print_up_to(last: str, energy: Any = None) -> None:
    """Print the notebook of the derivation. last: the step to stop after; energy: as in ``derive_all``."""
    book = Notebook()
    derive_section3(equilibrium.derive_section2(energy=energy, book=book), book, last)
    for line in book.text():
        print(line)


def main() -> None:
    """Print the whole derivation."""
    print_up_to(STEPS[-1])


if __name__ == "__main__":
    main()
