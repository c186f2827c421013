"""Values of a statement, written in the letters of its section: of several equal forms the one that reads best."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from sympy import Dummy, Expr, Symbol, expand

from derive.check.meaning import Components, pm
from derive.paper import tree as t
from derive.paper.conventions import Scope
from derive.paper.symbolic import NONE, Indices
from derive.report.letters import Letters, names
from derive.report.spell import FUNCTIONS, Speller
from derive.report.tidy import SpellError, abbreviated, ways

INVARIANTS = 2  # the arguments of ℘, ζ, σ that are left out where they are understood


class Writer:
    """Writes the values that a statement has in a reading."""

    def __init__(self, reading: Components, scope: Scope, statement: t.Statement, indices: Indices = NONE) -> None:
        self.letters, self.scope = Letters(reading, scope, statement, indices), scope
        self.own = names(*statement.sides)

    def of(self, value: Any, powers: t.Node | None = None) -> t.Node:
        """The shortest form of a value, of those with the fewest names from elsewhere; SpellError if there is none.

        powers: the letter by whose powers a polynomial is ordered.
        """
        letter = self.letters.names_letter(powers)
        value, speller = self._frozen(value.subs(self.letters.instead), letter)
        if letter is not None and value.has(letter) and value.is_polynomial(letter):
            return speller.of(expand(value))
        written, reasons = list[t.Node](), list[SpellError]()
        for form in ways(value, self.letters.short):
            try:
                written.append(speller.of(form))
            except SpellError as error:
                reasons.append(error)
        if not written:
            raise reasons[0]
        return min(written, key=lambda node: (len(names(node) - self.own), sum(1 for _ in node.walk())))

    def _frozen(self, value: Any, letter: Symbol | None) -> tuple[Any, Speller]:
        """The value with placeholders for functions that have letters and for elliptic ones; a speller for them."""
        known = dict(self.letters.known)
        functions = [name for name, one in self.scope.by_name.items() if one.kind == "function"]
        speller = Speller(known, functions, {pm: r"\pm"}, self._moving, letter)
        named = [found for found in known if isinstance(found, Expr) and found.is_Function and value.has(found)]
        meant: dict[Any, Any] = {}  # placeholders and what they stand for
        for call in sorted(named, key=str):
            value = self._put(value, call, known[call], known, meant)
        elliptic = {call for head in FUNCTIONS for call in value.atoms(head) if len(call.args) > INVARIANTS}
        for call in sorted(elliptic, key=str):
            value = self._put(value, call, self._call(call, speller, meant), known, meant)
        return value, speller

    @staticmethod
    def _put(value: Any, call: Any, node: t.Node, known: dict[Any, t.Node], meant: dict[Any, Any]) -> Any:
        placeholder = Dummy(call.func.__name__)
        known[placeholder], meant[placeholder] = node, call
        return value.subs(call, placeholder)

    def _call(self, call: Any, speller: Speller, meant: Mapping[Any, Any]) -> t.Node:
        """℘, ζ or σ; without invariants, if it then still has the value."""
        name, primes = FUNCTIONS[call.func]
        if name not in self.scope.by_name:
            raise SpellError(f"there is no letter for the function {name}")
        arguments = tuple(speller.of(abbreviated(arg, self.letters.short)) for arg in call.args)
        short, whole = t.Call(name, arguments[:1], primes), call.subs(meant)
        if any(found == whole for _, found in self.letters.valued([short])):
            return short
        return t.Call(name, arguments, primes)

    def _moving(self, name: str) -> bool:
        return self.scope.by_name[name].callable
