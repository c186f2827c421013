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

from sympy import Abs, Derivative, Dummy, Expr, Function, ImmutableMatrix, MatrixBase, Rational, cancel, eye, sqrt
from sympy.core.function import AppliedUndef

from derive.check.meaning import Components
from derive.paper import tree as t
from derive.paper.symbolic import NONE, Indices, to_sympy
from derive.theory.claims import Domain
from derive.theory.letters import e1, e2, e3
from derive.theory.symbols import s

State = Sequence[Mapping[Expr, Expr]]  # replacements, one set after the other
NOTHING = (t.Number(0), t.Name("zero", t.VECTOR))
HIGHEST = 2  # order of the derivatives that a law replaces; the article prints none beyond


def skew(v: Any) -> ImmutableMatrix:
    """The tensor v × of a vector."""
    return ImmutableMatrix.hstack(*(v.cross(e) for e in (e1, e2, e3)))


@dataclass(frozen=True)
class Rotation:
    """A rotation by three parameters g that vary along the rod: the vector along its axis with length tan(angle/2)."""

    parameters: ImmutableMatrix

    @property
    def matrix(self) -> ImmutableMatrix:
        """Its matrix, rational in the parameters."""
        turn = skew(self.parameters)
        return ImmutableMatrix(eye(3) + 2 * (turn + turn * turn) / (1 + self.parameters.dot(self.parameters)))

    def turned(self, spin: Any) -> dict[Expr, Expr]:
        """The change of each parameter when the rotation R changes by spin × R."""
        g = self.parameters
        return dict(zip(g, (spin + spin.cross(g) + g * g.dot(spin)) / 2, strict=True))


def rotation(name: str) -> Rotation:
    """Any rotation but half-turns, by three functions of s."""
    return Rotation(ImmutableMatrix([Function(f"{name}_{i}", real=True)(s) for i in (1, 2, 3)]))


@dataclass(frozen=True)
class Framed(Components):
    """A meaning in components on the moving frame.

    title, domain, small: as in Components. values: of names; of a family, by its members. kappa: κ. rates: what the
    derivatives of functions of s are, where they are known. variations: what the functions vary by; those that are
    absent do not vary. turn: δq. state: what holds where the formula is read, put into the values at the end, so that
    it may be a law that a derivative or a variation does not keep. units: unit vectors; a multiple of one has the
    modulus of its factor. at_ends: values of names at 0 and at ℓ. laws: read only relations with 0 on a side, which are
    laws (True), or only the others (False), or all (None).
    """

    title: str
    domain: Domain
    values: Mapping[str, Any]
    kappa: ImmutableMatrix
    rates: Mapping[Expr, Expr] = field(default_factory=dict)
    variations: Mapping[Expr, Expr] = field(default_factory=dict)
    turn: ImmutableMatrix | None = None
    state: State = ()
    units: Sequence[Any] = ()
    at_ends: Mapping[Expr, Callable[[str], Any]] = field(default_factory=dict)
    laws: bool | None = None
    known: dict[Any, Any] = field(default_factory=dict, compare=False, repr=False)

    def of(self, node: t.Node, indices: Indices = NONE) -> Any:
        """The value of a printed tree where the state holds."""
        value = to_sympy(node, self, indices)
        for put in self.state:
            value = value.xreplace(put)
        return value

    def reads(self, left: t.Node, right: t.Node) -> bool:
        """Is a relation between these sides read here?"""
        return self.laws is None or self.laws == any(side in NOTHING for side in (left, right))

    def name(self, name: str) -> Any:
        """A symbol, or a member of a family."""
        if name not in self.values:
            raise self.absent(f"'{name}'")
        return self.values[name]

    def call(self, name: str, primes: int, args: Sequence[Any]) -> Any:
        """A symbol at a place: any, s, or an end."""
        (place,) = args
        if place == self.values.get("s"):
            return self.rate(self.name(name), primes)
        if place not in self.at_ends or primes:
            raise self.absent(f"'{name}' at {place}")
        return self.at_ends[place](name)

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
        known = {function.diff(s): rate for function, rate in self.rates.items()}
        return of.diff(s).xreplace(known) + _turning(self.kappa, of)

    def _vary(self, of: Any) -> Any:
        small = Dummy()
        moved = {}
        for atom in of.atoms(AppliedUndef, Derivative):
            function, order = (atom.expr, atom.derivative_count) if isinstance(atom, Derivative) else (atom, 0)
            if function in self.variations:
                moved[atom] = atom + small * self.rate(self.variations[function], order)
        return of.xreplace(moved).diff(small).subs(small, 0) + _turning(self.turn, of)


def _turning(spin: Any, of: Any) -> Any:
    """What a turn of the frame adds to the change of components."""
    if not isinstance(of, MatrixBase):
        return Rational(0)
    turn = skew(spin)
    return turn * of if of.shape == (3, 1) else turn * of - of * turn


def derivatives(law: Mapping[Expr, Expr], known: Mapping[Expr, Expr]) -> dict[Expr, Expr]:
    """The derivatives of functions whose first derivatives a law gives.

    law: function → its derivative. known: the same of other functions in the law.
    """
    first = {function.diff(s): rate for function, rate in {**known, **law}.items()}
    found: dict[Expr, Expr] = {}
    for function, rate in law.items():
        for order in range(1, HIGHEST + 1):
            found[function.diff(s, order)] = rate
            rate = rate.diff(s).xreplace(first)
    return found
