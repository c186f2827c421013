"""Functionals of fields on a rod, each represented by its density.

∫₀^ℓ f ds + [g]₀^ℓ stands for f + g′: two such functionals are equal for all fields, on rods of all lengths, if and only
if these densities are. An integral that ends at a place s on the rod takes its part of the density, as a bracket does:
``PART`` is 1 before s and 0 beyond it, and other places have parts of their own. What is said of functionals is linear
in these, so that they may be any numbers.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from sympy import Expr, Symbol

from derive.check.meaning import ell
from derive.check.sections.framed import Framed
from derive.paper import tree as t
from derive.paper.symbolic import Indices, to_sympy
from derive.theory.symbols import s

PART = Symbol("part", real=True)
ARCS = (t.Name("s"), t.Name("varsigma"))  # by which integrals along the rod run


@dataclass(frozen=True)
class OnRod(Framed):
    """A meaning in the moving frame in which integrals and brackets along the rod are densities.

    held: the ends are held where the formula is read, so that what stands in brackets vanishes there.
    """

    held: bool = False

    def integral(self, node: t.Integral, indices: Indices) -> Any:
        """∫ f ds between places on the rod, as a density."""
        if len(node.by) != 1 or node.by[0] not in ARCS or node.lower is None or node.upper is None:
            raise self.absent("an integral that is not along the rod")
        return self.part(node.lower, node.upper) * to_sympy(node.of, self, indices)

    def between(self, node: t.Between, indices: Indices) -> Any:
        """[g] between places on the rod, as a density."""
        part = 0 if self.held else self.part(node.lower, node.upper)
        return part * self.rate(to_sympy(node.of, self, indices), 1)

    def spread(self, node: t.Node) -> tuple[Any, t.Node] | None:
        """Integrals along the rod and brackets by their densities, and so the variations of them."""
        match node:
            case t.Integral(region=None, lower=lower, upper=upper, by=(by,)) if lower and upper and by in ARCS:
                return self.part(lower, upper), node.of
            case t.Between(lower=lower, upper=upper):
                return 0 * s if self.held else self.part(lower, upper), t.Primed(node.of, 1)
            case t.Varied(of=of) if (found := self.spread(of)) is not None:
                return found[0], t.Varied(found[1])
        return None

    def part(self, lower: t.Node, upper: t.Node) -> Expr:
        """1 where a point of the rod lies between two places, −1 if they are in the wrong order, else 0."""
        return self.before(to_sympy(upper, self)) - self.before(to_sympy(lower, self))

    def before(self, place: Any) -> Expr:
        """1 where a point of the rod lies before a place, else 0."""
        found = {0: 0 * s, ell: s**0, s: PART}
        return found[place] if place in found else Symbol(f"part_{place}", real=True)
