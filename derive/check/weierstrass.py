"""℘, ℘′, ζ and σ in generators: addition theorems over base points, ℘′² = 4℘³ − g₂℘ − g₃ (DLMF 23.3.10, 23.10).

The base points of a lattice are chosen so that all arguments are sums of integer multiples of few of them: from
the arguments themselves, or from their terms, whichever needs fewer additions.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from functools import reduce
from typing import TYPE_CHECKING, Any

import sympy as sp

from derive.check.arguments import terms
from derive.theory import functions as fn

if TYPE_CHECKING:
    from derive.check.tower import Tower

KINDS = (fn.wp, fn.wp_prime, fn.wzeta, fn.wsigma)
Multiples = dict[sp.Expr, int]


@dataclass(frozen=True)
class Values:
    """℘, ℘′, ζ at one point, in generators."""

    p: sp.Expr
    slope: sp.Expr
    zeta: sp.Expr


def _negative(a: Values) -> Values:
    return Values(a.p, -a.slope, -a.zeta)


def _sum(a: Values, b: Values, chord: sp.Expr) -> Values:
    """The addition theorems, chord = (℘′(u) − ℘′(v))/(℘(u) − ℘(v)) or, for u = v, ℘″/℘′."""
    p = chord**2 / 4 - a.p - b.p
    return Values(p, -a.slope - chord * (p - a.p), a.zeta + b.zeta + chord / 2)


def _coordinates(vector: dict[sp.Expr, sp.Rational], basis: list[dict[sp.Expr, sp.Rational]]) -> list[int] | None:
    """Integers n with vector = Σ nᵢ basisᵢ, or None."""
    letters = sorted({k for v in (vector, *basis) for k in v}, key=sp.default_sort_key)
    columns = sp.Matrix([[v.get(k, 0) for v in basis] for k in letters])
    unknown = sp.symbols(f"n:{len(basis)}")
    solution = sp.linsolve((columns, sp.Matrix([vector.get(k, 0) for k in letters])), *unknown)
    if not solution:
        return None
    (values,) = solution
    return [int(n) for n in values] if all(n.is_Integer for n in values) else None


def _grown(vectors: list[dict[sp.Expr, sp.Rational]]) -> list[dict[sp.Expr, sp.Rational]]:
    """Base points among the arguments: each that is no integer combination of those before it."""
    basis: list[dict[sp.Expr, sp.Rational]] = []
    for vector in vectors:
        if not basis or _coordinates(vector, basis) is None:
            basis.append(vector)
    return basis


class Lattices:
    """The Weierstrass functions of a tower."""

    def __init__(self, tower: Tower, expressions: Iterable[sp.Expr]) -> None:
        self.tower = tower
        self.bases: dict[tuple[sp.Expr, sp.Expr], list[dict[sp.Expr, sp.Rational]]] = {}
        groups: dict[tuple[sp.Expr, sp.Expr], list[dict[sp.Expr, sp.Rational]]] = {}
        for expr in expressions:
            for call in expr.atoms(*KINDS):
                groups.setdefault(call.args[1:], []).append(terms(call.args[0]))
        self.groups = groups

    def _representative(self, g2: sp.Expr, g3: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
        """The first lattice that was met with these invariants."""
        for known in self.bases:
            if self.tower.same(known[0], g2) and self.tower.same(known[1], g3):
                return known
        vectors = [v for k, group in self.groups.items() if k == (g2, g3) or self._alike(k, g2, g3) for v in group]
        self.bases[g2, g3] = self._chosen(vectors)
        return g2, g3

    def _alike(self, known: tuple[sp.Expr, sp.Expr], g2: sp.Expr, g3: sp.Expr) -> bool:
        return self.tower.same(known[0], g2) and self.tower.same(known[1], g3)

    def _chosen(self, vectors: list[dict[sp.Expr, sp.Rational]]) -> list[dict[sp.Expr, sp.Rational]]:
        unique: list[dict[sp.Expr, sp.Rational]] = []
        for vector in sorted(vectors, key=lambda v: (len(v), sum(abs(n) for n in v.values()), str(v))):
            if vector and vector not in unique and {k: -n for k, n in vector.items()} not in unique:
                unique.append(vector)
        letters = sorted({k for v in unique for k in v}, key=sp.default_sort_key)
        units = {k: reduce(sp.gcd, [v[k] for v in unique if k in v]) for k in letters}
        atoms = [{k: units[k]} for k in letters]
        options = [option for option in (_grown(unique), atoms) if option]
        return min(options, key=lambda basis: self._cost(unique, basis), default=[])

    def _cost(self, vectors: list[dict[sp.Expr, sp.Rational]], basis: list[dict[sp.Expr, sp.Rational]]) -> int:
        total = len(basis)
        for vector in vectors:
            numbers = _coordinates(vector, basis)
            total += 1000 if numbers is None else sum(map(abs, numbers)) ** 2
        return total

    def value(self, expr: sp.Expr) -> sp.Expr:
        """One of the four functions at any argument."""
        u, g2, g3 = expr.args
        invariants = self._representative(g2, g3)
        numbers = self._multiples(terms(u), invariants)
        if expr.func is fn.wsigma:
            return self._sigma(numbers, invariants)
        values = self._at(numbers, invariants)
        return {fn.wp: values.p, fn.wp_prime: values.slope, fn.wzeta: values.zeta}[expr.func]

    def _multiples(self, vector: dict[sp.Expr, sp.Rational], key: tuple[sp.Expr, sp.Expr]) -> Multiples:
        basis = self.bases[key]
        numbers = _coordinates(vector, basis) if basis else None
        if numbers is None:
            basis.append(vector)
            numbers = [0] * (len(basis) - 1) + [1]
        points = [sp.Add(*(n * k for k, n in v.items())) for v in basis]
        return {point: n for point, n in zip(points, numbers, strict=True) if n}

    def _generators(self, point: sp.Expr, key: tuple[sp.Expr, sp.Expr]) -> Values:
        """The generators of a base point."""
        tower, args = self.tower, (point, *key)
        p = self._named(fn.wp, args)
        g2, g3 = (tower.rewrite(g) for g in key)
        return Values(p, self._named(fn.wp_prime, args, (2, 4 * p**3 - g2 * p - g3)), self._named(fn.wzeta, args))

    def _named(self, kind: Any, args: tuple[sp.Expr, ...], relation: tuple[int, sp.Expr] | None = None) -> sp.Expr:
        for old, new in self.tower.given.items():
            if isinstance(old, kind) and all(self.tower.same(a, b) for a, b in zip(old.args, args, strict=True)):
                return self.tower.rewrite(new)
        return self.tower.generator((kind, args), kind(*args), relation)

    def _at(self, numbers: Multiples, key: tuple[sp.Expr, sp.Expr]) -> Values:
        """The values at a sum of multiples of base points."""
        total: Values | None = None
        for point, count in numbers.items():
            part = self._times(self._generators(point, key), abs(count), key)
            part = part if count > 0 else _negative(part)
            if total is None:
                total = part
            else:
                total = _sum(total, part, (total.slope - part.slope) / (total.p - part.p))
        if total is None:
            raise ZeroDivisionError("a Weierstrass function at 0")
        return total

    def _times(self, a: Values, count: int, key: tuple[sp.Expr, sp.Expr]) -> Values:
        if count == 1:
            return a
        double = _sum(a, a, (6 * a.p**2 - self.tower.rewrite(key[0]) / 2) / a.slope)
        total = double
        for _ in range(count - 2):
            total = _sum(total, a, (total.slope - a.slope) / (total.p - a.p))
        return total

    def _sigma(self, numbers: Multiples, key: tuple[sp.Expr, sp.Expr]) -> sp.Expr:
        """σ(u − v) by σ(u + v), and σ(2u) by σ(u); other sums keep a generator of their own."""
        if not numbers:
            return sp.Integer(0)
        if next(iter(numbers.values())) < 0:
            return -self._sigma({k: -n for k, n in numbers.items()}, key)
        points = list(numbers)
        if list(numbers.values()) == [1, -1]:
            u, v = (self._sigma({k: 1}, key) for k in points)
            p, q = (self._generators(k, key).p for k in points)
            return -(u**2) * v**2 * (p - q) / self._sigma(dict.fromkeys(points, 1), key)
        if list(numbers.values()) == [2]:
            return -self._generators(points[0], key).slope * self._sigma({points[0]: 1}, key) ** 4
        argument = sp.Add(*(n * k for k, n in numbers.items()))
        return self._named(fn.wsigma, (argument, *key))
