"""A meaning in the moving frame of a rod: components that change along the rod and under variation.

Vectors are components on (d₁, d₂, d₃), which turns along the rod with κ and, when the rod varies, with δq. So the
derivative of a vector of components v is v_s + κ × v, its variation is δ(v) + δq × v with δ(v) that of the components,
and those of a tensor T take K T − T K in the place of the product. The components are expressions in functions of s:
some are free, others turn in a known way (a fixed vector, a second frame), and their derivatives are known.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

from sympy import Abs, Derivative, Dummy, Expr, ImmutableMatrix, MatrixBase, cancel, sqrt
from sympy.core.function import AppliedUndef

from derive.check.meaning import Components
from derive.check.sections.turning import Rates, along, elsewhere, turned
from derive.paper import tree as t
from derive.paper.symbolic import NONE, Indices, to_sympy
from derive.theory.claims import Domain
from derive.theory.symbols import s

State = Sequence[Mapping[Expr, Expr]]  # replacements, one set after the other
NOTHING = (t.Number(0), t.Name("zero", t.VECTOR))
HIGHEST = 2  # order of the derivatives that a law replaces; the article prints none beyond


@dataclass(frozen=True)
class Framed(Components):
    """A meaning in components on the moving frame.

    title, domain, small: as in Components. values: of names; of a family, by its members. kappa: κ. rates: derivatives
    of functions of s that are known. variations: what functions vary by; those that are absent do not vary. turn: δq.
    state: what holds where the formula is read, put into the values at the end, so that it may be a law that a
    derivative or a variation does not keep. units: unit vectors; a multiple of one has the modulus of its factor.
    at_ends: what some functions are at 0 and at ℓ. laws: read only relations with 0 on a side, which are laws (True),
    or only the others (False), or all (None). turns: the parameters of rotations; what is made of them alone is
    brought to lowest terms when it varies.
    """

    title: str
    domain: Domain
    values: Mapping[str, Any]
    kappa: ImmutableMatrix
    rates: Rates = field(default_factory=dict)
    variations: Mapping[Expr, Expr] = field(default_factory=dict)
    turn: ImmutableMatrix | None = None
    state: State = ()
    units: Sequence[Any] = ()
    at_ends: Mapping[Expr, Mapping[Expr, Expr]] = field(default_factory=dict)
    laws: bool | None = None
    turns: Sequence[Expr] = ()
    known: dict[Any, Any] = field(default_factory=dict, compare=False, repr=False)

    def of(self, node: t.Node, indices: Indices = NONE) -> Any:
        """The value of a printed tree where the state holds."""
        return self.here(to_sympy(node, self, indices))

    def reads(self, left: t.Node, right: t.Node) -> bool:
        """Is a relation between these sides read here?"""
        return self.laws is None or self.laws == any(side in NOTHING for side in (left, right))

    def name(self, name: str) -> Any:
        """A symbol, or a member of a family."""
        if name not in self.values:
            raise self.absent(f"'{name}'")
        return self.values[name]

    def call(self, name: str, primes: int, args: Sequence[Any]) -> Any:
        """A symbol at a place on the rod, in the frame at s."""
        (place,) = args
        value = self.rate(self.name(name), primes)
        return value if place == s else elsewhere(self.here(value).xreplace(dict(self.at_ends.get(place, {}))), place)

    def here(self, value: Any) -> Any:
        """The value where the state holds."""
        for put in self.state:
            value = value.xreplace(put)
        return value

    def rate(self, of: Any, order: int) -> Any:
        """The derivative along the rod."""
        for _ in range(order):
            of = self._once("rate", of, self._rate)
        return of

    def vary(self, of: Any) -> Any:
        """The variation of a value."""
        return self._once("vary", of, self._vary)

    def varied(self, node: t.Varied, indices: Indices) -> Any:
        """The variation of a value, before the state is put in."""
        if self.turn is None:
            raise self.absent("a variation")
        return self.vary(to_sympy(node.of, self, indices))

    def norm(self, of: Any) -> Any:
        """Of a multiple of a unit vector the modulus of its factor, else the root of the square."""
        if not isinstance(of, MatrixBase):
            return Abs(of)
        for unit in self.units:
            place = next(i for i in range(3) if unit[i] != 0)
            factor = cancel(of[place] / unit[place])
            if (of - factor * unit).applyfunc(cancel).is_zero_matrix:
                return Abs(factor)
        return sqrt(of.dot(of))

    def _once(self, kind: str, of: Any, change: Callable[[Any], Any]) -> Any:
        """A change of a value, computed once."""
        of = ImmutableMatrix(of) if isinstance(of, MatrixBase) else of
        if (kind, of) not in self.known:
            self.known[kind, of] = change(of)
        return self.known[kind, of]

    def _rate(self, of: Any) -> Any:
        return along(of, self.kappa, self.rates)

    def _vary(self, of: Any) -> Any:
        if isinstance(of, MatrixBase) and of.atoms(AppliedUndef) <= set(self.turns):
            return self._changed(of.applyfunc(cancel)).applyfunc(cancel)
        return self._changed(of)

    def _changed(self, of: Any) -> Any:
        small = Dummy()
        moved = {}
        for atom in of.atoms(AppliedUndef, Derivative):
            function, order = (atom.expr, atom.derivative_count) if isinstance(atom, Derivative) else (atom, 0)
            if function in self.variations:
                moved[atom] = atom + small * self.rate(self.variations[function], order)
        change = of.xreplace(moved).diff(small).subs(small, 0)
        return change + turned(self.turn, of) if isinstance(of, MatrixBase) else change


def derivatives(law: Mapping[Expr, Expr], known: Rates) -> dict[Expr, Expr]:
    """The derivatives of functions whose first derivatives a law gives, as function → derivative.

    known: derivatives of other functions in the law.
    """
    first = {**known, **{function.diff(s): rate for function, rate in law.items()}}
    found: dict[Expr, Expr] = {}
    for function, rate in law.items():
        for order in range(1, HIGHEST + 1):
            found[function.diff(s, order)] = rate
            rate = rate.diff(s).xreplace(first)
    return found
