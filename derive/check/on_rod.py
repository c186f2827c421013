"""A meaning along the rod from its clamp: brackets with limits, indefinite integrals, y(s) and z(s), values at points.

What accumulates along the rod (y, z, an indefinite integral) is a symbol with a rate; y and z start from 0 at the
clamp, an indefinite integral from anywhere.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

from sympy import Expr, Symbol, acosh, asin, log

from derive.check import continuation
from derive.check import meaning as m
from derive.check.meaning import Reading
from derive.paper import tree as t
from derive.paper.symbolic import Indices
from derive.theory import functions as fn
from derive.theory.symbols import xi

Y, Z = Symbol("y"), Symbol("z")  # the coordinates reached at s
INVERSE = {"ln": log, "asin": asin, "acosh": acosh}
LATTICE = {"wzeta": fn.wzeta, "wsigma": fn.wsigma}


@dataclass(frozen=True)
class OnRod(Reading):
    """A reading along the rod.

    hypotheses: as in Components. start: the moving symbols at the clamp. stretch: in words, on what part of a rod the
    reading holds. rods: the readings with u in its place in the plane, one for each case of the start u_o.
    accumulated: symbols that the formula needed, and their rates; integrals: those of indefinite integrals.
    """

    hypotheses: tuple[tuple[Expr, Expr], ...] = ()
    start: Mapping[Symbol, Expr] = field(default_factory=dict)
    stretch: str = ""
    rods: Callable[[], Iterable[OnRod]] = tuple
    accumulated: dict[Symbol, Expr] = field(default_factory=dict, compare=False)
    integrals: dict[t.Node, Symbol] = field(default_factory=dict, compare=False)

    def call(self, name: str, primes: int, args: Sequence[Any]) -> Any:
        """A function at its arguments."""
        if name in INVERSE and not primes:
            return INVERSE[name](*args)
        if name in LATTICE and not primes and self.invariants is not None:
            return LATTICE[name](*args, *self.invariants)
        if name in ("y", "z") and not primes and len(args) == 1:
            return self._coordinate(name, args[0])
        return super().call(name, primes, args)

    def _coordinate(self, name: str, point: Expr) -> Expr:
        """y or z where the reading is; 0 at the clamp; elsewhere some number, which does not move."""
        if point in self._here() or point == self.name("xi"):
            return self.name(name)
        if point == 0:
            return point
        self._still(name, point)
        return Symbol(f"{name}_at_{point}", real=True)

    def _on_rod(self, name: str, point: Expr) -> Expr:
        """ξ or ϰ at a point; in a reading without the elliptic solution ξ here, or another value that does not move."""
        if self.solution is not None or name != "xi":
            return super()._on_rod(name, point)
        if point in self._here():
            return self.name("xi")
        self._still(name, point)
        return self.start[xi] if point == 0 else Symbol(f"xi_at_{point}", real=True)

    def _here(self) -> tuple[Any, ...]:
        """The point of the reading, as an arc length and as u."""
        return m.s, self.values.get("u")

    def _still(self, name: str, point: Expr) -> None:
        """Only a point that does not move along the rod is another point."""
        if not point.free_symbols <= m.ARCS - {m.s}:
            raise self.absent(f"'{name}' at {point}")

    def _rate(self, of: Any) -> Any:
        """The derivative along the rod, of accumulated quantities too."""
        rates = {**self.rates, **self.accumulated}
        return sum((of.diff(q) * rates[q] for q in sorted(of.free_symbols & set(rates), key=str)), start=0 * m.s)

    def at(self, node: t.At, indices: Indices) -> Any:
        """of with the value in the place of the variable."""
        if node.variable is None:
            raise self.absent("a value at a point of nothing")
        if node.variable == t.Name("u") and isinstance(node.of, t.Call) and node.of.args == (node.variable,):
            return self._of_u(node.of.name, self.of(node.value, indices))
        return self.of(replaced(node.of, node.variable, node.value), indices)

    def _of_u(self, name: str, point: Expr) -> Expr:
        """ξ or ϰ as a function of u."""
        if name not in ("xi", "varkappa") or self.solution is None or self.invariants is None:
            raise self.absent(f"'{name}' as a function of u")
        value = fn.wp(point, *self.invariants)
        return self.solution(value) if name == "xi" else value

    def between(self, node: t.Between, indices: Indices) -> Any:
        """The difference of the values at the limits."""
        if node.variable is None:
            raise self.absent("a bracket without a variable")
        upper, lower = (self.of(replaced(node.of, node.variable, end), indices) for end in (node.upper, node.lower))
        return upper - lower

    def integral(self, node: t.Integral, indices: Indices) -> Any:
        """An indefinite integral: a symbol whose rate is the integrand times the rate of the variable."""
        if node.lower is not None or node.upper is not None or node.region is not None or len(node.by) != 1:
            raise self.absent("an integral between limits")
        if node in self.integrals:
            return self.integrals[node]
        primitive = self.integrals[node] = Symbol(f"integral_{len(self.integrals) + 1}")
        self.accumulated[primitive] = self.of(node.of, indices) * self.rate(self.of(node.by[0], indices), 1)
        return primitive

    def accumulates(self, *sides: Any) -> bool:
        """Does a side hold y, z or an indefinite integral?"""
        return any(side.free_symbols & {Y, Z, *self.accumulated} for side in sides)

    def at_clamp(self, value: Any) -> Any:
        """The value at the clamp, None if an integral leaves a constant open."""
        return None if value.free_symbols & set(self.accumulated) else value.xreplace(dict(self.start))

    def frontier(self, value: Any, end: Any) -> Any:
        """Of ξ: f, which is ≥ 0 on the rod and ends in its roots. Of s: what vanishes at the ends of the rod."""
        for sign in (1, -1):
            if value == sign * self.name("xi") and "f" in self.polynomials:
                return self.polynomials["f"].subs(xi, sign * end)
        if value == m.s:
            return end * (end - self.name("ell"))
        return super().frontier(value, end)

    def condition(self, sides: Sequence[t.Node]) -> str:
        """Whether logarithms have to be continued along the rod."""
        return continuation.condition(sides, self.rods())

    def sign_note(self, sign: str, title: str) -> str:
        """Of what accumulates, that the sign stands for a stretch of the rod, and for which."""
        return f"± is {sign} as long as {self.stretch}" if self.stretch and "along the rod" in title else ""


def replaced(node: t.Node, old: t.Node, new: t.Node) -> t.Node:
    """The tree with one node in the place of another."""
    if node == old:
        return new
    return node.with_parts(tuple(replaced(part, old, new) for part in node.parts()))
