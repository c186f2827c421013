"""Section 2.1: any rod, bent and twisted before and after it is deformed (scope ``kirchhoff``).

Vectors are in components on the frame d of the deformed rod. The frame d^u of the undistorted one is turned from it by
any rotation, so that nothing of the one passes for the other. Names stand for what the theory derives; what it writes
on d^u is turned by that rotation. The orders of magnitude are the theory's: all of them come from ε.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from copy import copy
from functools import cached_property
from typing import Any

from sympy import Expr, Matrix, MatrixBase, Max, Symbol, zeros

from derive.check.meaning import Components
from derive.check.sections.moving import Turned, extent, inverse, unknown
from derive.check.sections.remembered import remembered
from derive.check.sections.rod_letters import FAMILIES, PHI, TURN, VALUES, solved, strain_energy
from derive.check.sections.turning import along, elsewhere
from derive.paper import tree as t
from derive.paper.symbolic import Indices, member, to_sympy
from derive.theory import frame, loads
from derive.theory.claims import Domain
from derive.theory.constraint import FORCE
from derive.theory.letters import X1, X2, e3, eps, vector_of
from derive.theory.symbols import s
from derive.theory.variation import Balance

SHAPES: dict[str, Any] = {t.SCALAR: s, t.VECTOR: zeros(3, 1), t.TENSOR: zeros(3, 3)}


class Rod(Components):
    """The reading. within: the order to which equalities hold, where the text drops what is smaller."""

    title = "any rod"
    domain = Domain({eps: (0, 1)})
    small = eps
    values: Mapping[str, Callable[[Any], Any]] = VALUES
    families: Mapping[str, Callable[[Any, int], Any]] = FAMILIES

    def __init__(self, balance: Balance) -> None:
        self.balance = balance
        self.rod = balance.couple.line.rod
        self.kappa = self.rod.frame.kappa
        self._known: dict[str, Any] = {}

    @cached_property
    def turned(self) -> Matrix:
        """The vectors d_i^u as columns: what takes components on d^u to those on d."""
        return TURN.matrix

    @cached_property
    def loaded(self) -> loads.Loaded:
        """The balances of force and moment under any loads."""
        return loads.loaded(self.rod)

    @cached_property
    def rates(self) -> dict[Any, Expr]:
        """Derivatives along the rod of what obeys a law."""
        x, x_u = vector_of("x"), vector_of("x_u")
        fixed = {x: e3, x_u: self.turned[:, 2], **self.uniform}
        found = dict(TURN.rates(self.turned * self.rod.kappa_u - self.kappa))
        for vector, slope in fixed.items():
            found |= dict(zip(vector.diff(s), slope - self.kappa.cross(vector), strict=True))
        found |= dict(zip(FORCE.diff(s), solved(self.loaded.force, FORCE.diff(s)), strict=True))
        return found | {PHI.diff(s): frame.axis(self.kappa).turn}

    def from_u(self, components: Matrix) -> Turned:
        """A vector of given components on d^u, or a tensor of given components on d ⊗ d^u."""
        return Turned.of(self.turned, components)

    @property
    def uniform(self) -> dict[Matrix, Matrix]:
        """Vectors that are functions of s only because the frame turns, with their derivatives, zero."""
        return {}

    def name(self, name: str) -> Any:
        """From the tables of the section."""
        if name not in self._known:
            family, _, number = name.rpartition("_")
            if name in self.values:
                self._known[name] = self.values[name](self)
            elif family in self.families and number.isdigit():
                self._known[name] = self.families[family](self, int(number))
            else:
                raise self.absent(f"'{name}'")
        return self._known[name]

    def call(self, name: str, primes: int, args: Sequence[Any]) -> Any:
        """A quantity at a place; the strain energy of a strain."""
        if name == "psi_e" and isinstance(args[0], MatrixBase):
            return strain_energy(self, args[0])
        value = self.rate(self.name(name), primes)
        if isinstance(args[0], MatrixBase):
            return value if args[0] == self.name("x_hat_u") else unknown(f"{name}_elsewhere", value)
        if len(args) == 3 and tuple(args[:2]) != (eps * X1, eps * X2):
            value = value.subs({X1: args[0] / eps, X2: args[1] / eps}, simultaneous=True)
        return elsewhere(value, args[-1])

    def rate(self, of: Any, order: int) -> Any:
        """The derivative along the rod."""
        for _ in range(order):
            of = self._rate(of)
        return of

    def _rate(self, of: Any) -> Any:
        # What is integrated up to here grows by its density.
        here = extent(s)
        if not of.has(here):
            return along(of, self.kappa, self.rates)
        density = of.diff(here)
        if density.has(here):
            raise self.absent("the derivative of a product of integrals")
        return density + along(of.subs(here, 0), self.kappa, self.rates)

    def ratio(self, node: t.Derivative, indices: Indices) -> Any:
        """Along the rod, or by a coordinate of the section; of anything else the derivative is not known."""
        of = to_sympy(node.of, self, indices)
        by = member(node.by.name, node.by.index, indices) if isinstance(node.by, t.Name) else ""
        if by == "s":
            return self.rate(of, 1)
        if by in ("X_1", "X_2"):
            return of.diff({"X_1": X1, "X_2": X2}[by]) / eps
        return unknown(f"derivative_by_{by}", of)

    def at(self, node: t.At, indices: Indices) -> Any:
        """At another place of the rod."""
        if node.variable is not None and node.variable != t.Name("s"):
            raise self.absent("a value where something else than s is given")
        return elsewhere(to_sympy(node.of, self, indices), to_sympy(node.value, self, indices))

    def inverse(self, of: Any) -> Any:
        """By the products of its rows."""
        return inverse(of)

    def order(self, node: t.BigO, indices: Indices) -> Any:
        """That power of ε times a quantity of which nothing is known."""
        return to_sympy(node.of, self, indices) * unknown(f"rest_{node.span[0]}", SHAPES[node.kind])

    def maximum(self, node: t.Maximum, indices: Indices) -> Any:
        """The greatest quantity: over the whole rod, that is at the point where it is greatest."""
        h = self.name("h")
        greatest = h * Max(*(to_sympy(part, self, indices) / h for part in node.of))
        whole = t.Interval(t.Number(0), t.Name("ell"), True, True)
        over_rod = node.variable == t.Name("s") and node.region == whole
        return greatest if over_rod else greatest * Symbol("greatest_elsewhere", positive=True)

    def to_order(self, given: Sequence[t.Statement]) -> Rod:
        """The same where the text drops what is of some order: it assumes O(εⁿ) = 0."""
        for statement in given:
            if isinstance(statement.sides[0], t.BigO):
                reading = copy(self)
                reading.within = int(self.of(statement.sides[0].of).as_coeff_exponent(eps)[1])
                return reading
        return self


@remembered
def rod_of(theory: Any) -> Rod:
    """The reading; its values are computed once."""
    return Rod(theory.section2.balance)


def readings(theory: Any, sides: tuple[t.Node, ...], given: tuple[t.Statement, ...]) -> Iterator[Components]:
    """One: any rod."""
    yield rod_of(theory).to_order(given)
