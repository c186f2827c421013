"""Which printed letters stand for which expressions of a reading: the meanings of the section, turned round."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import Any

from sympy import Derivative, Dummy, Expr, I, Poly, Symbol
from sympy.core.function import AppliedUndef

from derive.check.meaning import Components, pm
from derive.paper import tree as t
from derive.paper.conventions import Scope
from derive.paper.symbolic import NONE, Indices
from derive.report.vectors import unit_vectors

ENDS = ("s", "ell")  # arguments at which a moving quantity has a value of its own
PRIMES = (1, 2, 3)
VECTORS = (t.Name, t.Call, t.Primed, t.Varied)  # vectors whose components may stand in a value
PRINTED = (t.Name, t.Call, t.Primed, t.Dot)  # what may stand for a value where the statement has it


class Letters:
    """What stands for what in one reading of a statement.

    known: expression → tree, for what has no parts, for functions, and for placeholders. short: placeholders and the
    values that they abbreviate. instead: what is replaced before anything is written.
    """

    def __init__(self, reading: Components, scope: Scope, statement: t.Statement, indices: Indices = NONE) -> None:
        self.reading, self.scope, self.statement, self.indices = reading, scope, statement, indices
        self.known: dict[Any, t.Node] = {}
        self.short: tuple[tuple[Symbol, Any], ...] = ()
        printed = list(self._inside())
        declared = [node for node in self._declared() if node not in printed]
        self._letters([*printed, *declared, *self._components()])
        alone = {name for side in statement.sides if isinstance(side, PRINTED) for name in names(side)}
        self._functions([*printed, *(node for node in declared if not names(node) & alone)])
        self._abbreviations(printed)
        self.instead = dict(self._eliminated())

    def valued(self, nodes: Iterable[t.Node]) -> Iterator[tuple[t.Node, Any]]:
        """Trees with their values, as far as they have a meaning in the reading."""
        for node in nodes:
            try:
                yield node, self.reading.of(node, self.indices)
            except (ValueError, TypeError, KeyError, AttributeError):  # no meaning here
                continue

    def names_letter(self, powers: t.Node | None) -> Symbol | None:
        """The letter of the theory for which a printed name stands, if there is one."""
        return next((found for found, node in self.known.items() if node == powers and is_letter(found)), None)

    def _letters(self, nodes: Iterable[t.Node]) -> None:
        """Trees for what has no parts: of two, the one with the letter's own name, else the first."""
        for node, value in self.valued(nodes):
            own = isinstance(node, t.Name) and node.name == str(value)
            if (is_letter(value) or value == I) and (own or value not in self.known):
                self.known[value] = node

    def _functions(self, nodes: Iterable[t.Node]) -> None:
        for node, value in self.valued(nodes):
            if isinstance(value, Expr) and value.is_Function and not is_letter(value):
                self.known.setdefault(value, node)

    def _abbreviations(self, nodes: Iterable[t.Node]) -> None:
        """Placeholders for sums and products that the statement names."""
        short: dict[Any, Symbol] = {}
        for node, value in self.valued(nodes):
            if isinstance(node, t.Name | t.Dot) and worth_a_letter(value) and value not in short:
                short[value] = Dummy(node.name if isinstance(node, t.Name) else f"dot_{len(short)}", real=True)
                self.known[short[value]] = node
        self.short = tuple((letter, value) for value, letter in short.items())

    def _eliminated(self) -> Iterator[tuple[Any, Any]]:
        """The square of a moving letter that the statement does not have, by the one that rests on it: k² by γ."""
        own = names(*self.statement.sides)
        resting: dict[Any, list[tuple[Symbol, Any]]] = {}
        for letter, value in self.short:
            for other in sorted(value.free_symbols, key=str):
                node = self.known.get(other)
                if value.is_Add and isinstance(node, t.Name) and node.name not in own and self._moves(node):
                    resting.setdefault(other, []).append((letter, value))
        for other, pairs in resting.items():
            letter, value = pairs[0]
            terms = dict(Poly(value, other).terms()) if value.is_polynomial(other) else {}
            if len(pairs) == 1 and set(terms) == {(0,), (2,)}:
                yield other**2, (letter - terms[(0,)]) / terms[(2,)]

    def _components(self) -> Iterator[t.Node]:
        """The components of the vectors of a statement, v · d₁ and so on."""
        base = dict(unit_vectors(self.reading, self.scope))
        for node in (below for side in self.statement.sides for below in side.walk()):
            if isinstance(node, VECTORS) and node.type == t.VECTOR and not node.free_indices():
                yield from (t.Dot(node, base[direction]) for direction in sorted(base))

    def _moves(self, node: t.Name) -> bool:
        return bool(self.scope.by_name[node.name].argument)

    def _inside(self) -> Iterator[t.Node]:
        """The names, calls, primes and products · in a statement; not what stands alone on a side."""
        for side in self.statement.sides:
            for node in side.walk():
                free = node.free_indices() - set(self.indices)
                if isinstance(node, PRINTED) and node not in self.statement.sides and not free:
                    yield node

    def _declared(self) -> Iterator[t.Node]:
        """The declared scalars, with primes and at the ends of the rod."""
        for name, declared in self.scope.by_name.items():
            if declared.kind == t.SCALAR:
                yield t.Name(name)
                if declared.argument:
                    yield t.Call(name, (t.Number(0),))
                    yield from (t.Call(name, (t.Name(end),)) for end in ENDS if end in self.scope.by_name)
                    yield from (t.Primed(t.Name(name), order) for order in PRIMES)


def names(*nodes: t.Node) -> set[str]:
    """The names in trees."""
    return {below.name for node in nodes for below in node.walk() if isinstance(below, t.Name | t.Call)}


def is_letter(value: Any) -> bool:
    """Has it no parts: a symbol, an unknown function, a derivative of one?"""
    return isinstance(value, Symbol | AppliedUndef | Derivative) and value != pm


def worth_a_letter(value: Any) -> bool:
    """Is it a sum or a product for which a letter of the article stands?"""
    return isinstance(value, Expr) and bool(value.free_symbols) and bool(value.is_Add or value.is_Mul)
