"""Which printed letters stand for which expressions of a reading: the meanings of the section, turned round."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import Any

from sympy import Derivative, Dummy, Expr, Poly, Symbol, expand
from sympy.core.function import AppliedUndef

from derive.check.meaning import Components, pm
from derive.paper import tree as t
from derive.paper.conventions import Scope
from derive.paper.symbolic import NONE, Indices
from derive.report.spell import Speller, SpellError
from derive.report.tidy import Letters, ways

ENDS = ("s", "ell")  # arguments at which a moving quantity has a value of its own
PRIMES = (1, 2, 3)
PRINTED = (t.Name, t.Call, t.Primed, t.Dot)  # what may stand for a value where the statement has it


class Writer:
    """Writes the values that a statement has in a reading, in the letters of its section."""

    def __init__(self, reading: Components, scope: Scope, statement: t.Statement, indices: Indices = NONE) -> None:
        self.reading, self.scope, self.statement, self.indices = reading, scope, statement, indices
        self.known, self.short = self._known()
        self.instead = dict(self._eliminated())

    def of(self, value: Any, powers: t.Node | None = None) -> t.Node:
        """The shortest form of a value, of those with the fewest names from elsewhere; SpellError if there is none.

        powers: the letter by whose powers a polynomial is ordered.
        """
        value = value.subs(self.instead)
        letter = next((found for found, node in self.known.items() if node == powers and is_letter(found)), None)
        functions = [name for name, one in self.scope.by_name.items() if one.kind == "function"]
        speller = Speller(self.known, functions, {pm: r"\pm"}, self._same, self._moving, letter)
        if letter is not None and value.is_polynomial(letter):
            return speller.of(expand(value))
        written, reasons = list[t.Node](), list[SpellError]()
        for form in ways(value, self.short):
            try:
                written.append(speller.of(form))
            except SpellError as error:
                reasons.append(error)
        if not written:
            raise reasons[0]
        own = names(*self.statement.sides)
        return min(written, key=lambda node: len(names(node) - own))

    def _known(self) -> tuple[dict[Any, t.Node], Letters]:
        """Trees for expressions without parts and for functions, and abbreviations of what the statement names."""
        printed, declared = list(self._inside()), list(self._declared())
        known: dict[Any, t.Node] = {}
        for node, value in self._valued([*printed, *declared]):
            if is_letter(value):
                own = isinstance(node, t.Name) and node.name == str(value)
                known = {**known, value: node} if own else {value: node, **known}
        short: dict[Any, Symbol] = {}
        for node, value in self._valued([*printed, *(node for node in declared if node not in self.statement.sides)]):
            if is_call(value):
                known.setdefault(value, node)
            elif node in printed and isinstance(node, t.Name | t.Dot) and worth_a_letter(value) and value not in short:
                short[value] = Dummy(real=True)
                known[short[value]] = node
        return known, tuple((letter, value) for value, letter in short.items())

    def _eliminated(self) -> Iterator[tuple[Any, Any]]:
        """The square of a letter that the statement does not have, by the one letter of it that rests on it: k² by γ."""
        own = names(*self.statement.sides)
        resting: dict[Any, list[tuple[Symbol, Any]]] = {}
        for letter, value in self.short:
            for other in value.free_symbols:
                node = self.known.get(other)
                if value.is_Add and isinstance(node, t.Name) and node.name not in own:
                    resting.setdefault(other, []).append((letter, value))
        for other, pairs in resting.items():
            letter, value = pairs[0]
            terms = dict(Poly(value, other).terms()) if value.is_polynomial(other) else {}
            if len(pairs) == 1 and set(terms) == {(0,), (2,)}:
                yield other**2, (letter - terms[(0,)]) / terms[(2,)]

    def _inside(self) -> Iterator[t.Node]:
        """The names, calls and primes in a statement; not what stands alone on a side."""
        for side in self.statement.sides:
            for node in side.walk():
                if isinstance(node, PRINTED) and node not in self.statement.sides:
                    if not node.free_indices() - set(self.indices):
                        yield node

    def _declared(self) -> Iterator[t.Node]:
        """The declared scalars, with primes and at the ends of the rod."""
        for name, declared in self.scope.by_name.items():
            if declared.kind == t.SCALAR:
                yield t.Name(name)
                if declared.argument:
                    yield from (t.Call(name, (t.Name(end),)) for end in ENDS if end in self.scope.by_name)
                    yield from (t.Primed(t.Name(name), order) for order in PRIMES)

    def _valued(self, nodes: Iterable[t.Node]) -> Iterator[tuple[t.Node, Any]]:
        """Trees with their values, as far as they have a meaning in the reading."""
        for node in nodes:
            try:
                yield node, self.reading.of(node, self.indices)
            except (ValueError, TypeError, KeyError, AttributeError):  # no meaning here
                continue

    def _moving(self, name: str) -> bool:
        return self.scope.by_name[name].callable

    def _same(self, node: t.Node, value: Any) -> bool:
        whole = value.subs(self.short)
        return any(found == whole for _, found in self._valued([node]))


def names(*nodes: t.Node) -> set[str]:
    """The names in trees."""
    return {below.name for node in nodes for below in node.walk() if isinstance(below, t.Name | t.Call)}


def is_letter(value: Any) -> bool:
    """Has it no parts: a symbol, an unknown function, a derivative of one?"""
    return isinstance(value, Symbol | AppliedUndef | Derivative) and value != pm


def is_call(value: Any) -> bool:
    """Is it one function at an argument, such as cos θ?"""
    return isinstance(value, Expr) and bool(value.is_Function) and not is_letter(value)


def worth_a_letter(value: Any) -> bool:
    """Is it a sum or a product for which a letter of the article stands?"""
    return isinstance(value, Expr) and bool(value.free_symbols) and bool(value.is_Add or value.is_Mul)
