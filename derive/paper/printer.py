"""Typed trees → LaTeX that reads back as the same tree.

Brackets stand where the reader would otherwise see another tree, and in products of vectors wherever they help the
eye; a fraction is always ``\\frac``. What is written in special ways (integrals, cases …) is in ``layouts``.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from itertools import pairwise

from . import tree as t
from .conventions import LETTERS, Scope
from .conventions import scope as conventions_of
from .indices import plain
from .layouts import LAYOUTS
from .resolve import RELATIONS

_WRITTEN = {operator: latex for latex, operator in reversed(RELATIONS.items())}
_SIGNS = {t.Dot: r"\cdot", t.Cross: r"\times", t.Outer: r"\otimes", t.RegionProduct: r"\times"}
_TO_THE_END = (t.Integral, t.Limit)  # what takes the rest of its row


def to_latex(statement: t.Statement | t.Node, scope: str) -> str:
    """LaTeX of a statement or of an expression, in the letters of a scope. KeyError for a name it does not have."""
    printer = Printer(conventions_of(scope))
    if isinstance(statement, t.Node):
        return printer.sum(plain(statement))
    said = [printer.where(other) for other in statement.where]
    return r" \,, \quad ".join([printer.chain(statement.sides, statement.operators), *said])


class Printer:
    """Prints trees in the letters of a scope; sums over repeated indices must be gone from them."""

    def __init__(self, scope: Scope) -> None:
        self.scope = scope

    def chain(self, sides: Sequence[t.Node], operators: Sequence[str]) -> str:
        """Sides and relations."""
        first, *others = (self.sum(plain(side)) for side in sides)
        return " ".join([first, *(f"{_WRITTEN[op]} {side}" for op, side in zip(operators, others, strict=True))])

    def where(self, said: t.Statement) -> str:
        """What is said of a letter."""
        letter, values = said.sides
        if isinstance(letter, t.Name) and letter.type == t.INDEX and isinstance(values, t.Listing):
            written = {name: latex for latex, name in LETTERS.items()}
            return f"{written[letter.name]} = {', '.join(self.sum(value) for value in values.items)}"
        return self.chain(said.sides, said.operators)

    def sum(self, node: t.Node) -> str:
        """Where any expression may stand."""
        terms = node.terms if isinstance(node, t.Sum) else (node,)
        first, *others = terms
        shown = [f"{first.sign} {self.row(first.of)}" if isinstance(first, t.Signed) else self.row(first)]
        for term in others:
            if isinstance(term, t.Signed) and term.sign != "+":
                shown.append(f"{term.sign} {self.row(term.of)}")
            else:
                shown.append(f"+ {self.row(term)}")
        return " ".join(shown)

    def row(self, node: t.Node) -> str:
        """Where a product may stand: a row of factors, its last one perhaps joined by · or ×."""
        if isinstance(node, t.Product):
            *before, last = node.factors
            scalars = all(factor.type == t.SCALAR for factor in before)
            joined = isinstance(last, t.Dot | t.Cross | t.Outer | t.Apply | _LAST) and scalars
            shown = [self.factor(factor) for factor in before]
            shown.append(self.joined(last) if joined else self.factor(last))
            return self.side_by_side([*before, last], shown)
        return self.joined(node)

    def joined(self, node: t.Node) -> str:
        """Where a row without scalars beside it may stand."""
        match node:
            case t.Dot() | t.Outer():
                return f"{self._operand(node.left)} {_SIGNS[type(node)]} {self._operand(node.right)}"
            case t.RegionProduct():
                return f"{self.joined(node.left)} {_SIGNS[type(node)]} {self.factor(node.right)}"
            case t.Cross():
                return f"{self.factor(node.left)} {_SIGNS[type(node)]} {self.factor(node.right)}"
            case t.Apply():
                return self._beside(node.tensor, node.vector)
            case t.Compose():
                return self._beside(node.left, node.right)
            case t.Integral() | t.Limit():
                return LAYOUTS[type(node)](self, node)
        return self.factor(node)

    def _operand(self, node: t.Node) -> str:
        return self.joined(node) if isinstance(node, t.Cross) else self.factor(node)

    def _beside(self, left: t.Node, right: t.Node) -> str:
        return self.side_by_side([left, right], [self.factor(left), self.factor(right)])

    def side_by_side(self, nodes: Sequence[t.Node], shown: Sequence[str]) -> str:
        """Keep a symbol from taking the bracket after it as its argument."""
        written = list(shown)
        for n, (node, other) in enumerate(pairwise(nodes)):
            if isinstance(node, t.Number) and isinstance(other, t.Number):
                raise ValueError("two numbers side by side cannot be printed; multiply them")
            if written[n + 1].startswith((r"\left(", r"\left[")) and self._open_ended(node):
                written[n] = rf"\left( {written[n]} \right)"
        return " ".join(written)

    def _open_ended(self, node: t.Node) -> bool:
        """Would the reader try a bracket after this as its argument?"""
        match node:
            case t.Power():
                return self._open_ended(node.base)
            case t.Primed() | t.Varied() | t.Transpose():
                return self._open_ended(node.of)
            case t.Name():
                return self.scope.declared(node.name, node.index).callable
        return isinstance(node, t.Derivative)

    def factor(self, node: t.Node) -> str:
        """Where one factor may stand."""
        match node:
            case t.Number():
                return str(node.value)
            case t.Name():
                return self.scope.declared(node.name, node.index).latex
            case t.Call():
                return self.call(node, "")
            case t.Primed(of=t.Name() as name):
                return f"{self._scripted(name)}{primes(node.order)}"
            case t.Primed():
                return f"{self.bracket(node.of)}{primes(node.order)}"
            case t.Power():
                return self._power(node)
            case t.Transpose(of=t.Name() as name):
                return rf"{self._scripted(name)}^{{\mathsf{{T}}}}"
            case t.Transpose():
                return rf"{self.bracket(node.of)}^{{\mathsf{{T}}}}"
        layout: Callable[[Printer, t.Node], str] | None = LAYOUTS.get(type(node))
        return self.bracket(node) if layout is None or isinstance(node, _TO_THE_END) else layout(self, node)

    def bracket(self, node: t.Node) -> str:
        """In brackets."""
        return rf"\left( {self.sum(node)} \right)"

    def _power(self, node: t.Power) -> str:
        exponent = f"^{{{self.sum(node.exponent)}}}"
        if isinstance(node.base, t.Call) and not node.base.primes and not isinstance(node.exponent, t.Signed):
            return self.call(node.base, exponent)
        if isinstance(node.base, t.Name):
            return self._scripted(node.base) + exponent
        if isinstance(node.base, t.Number | t.Norm):
            return self.factor(node.base) + exponent
        return self.bracket(node.base) + exponent

    def _scripted(self, node: t.Node) -> str:
        """The letter, ready for a superscript: in braces if it has one of its own."""
        assert isinstance(node, t.Name | t.Call)
        latex = self.scope.declared(node.name, node.index).latex
        return f"{{{latex}}}" if "^" in latex else latex

    def call(self, node: t.Call, power: str) -> str:
        """A function at its arguments."""
        declared = self.scope.declared(node.name, node.index)
        superscript = primes(node.primes) if node.primes else power
        head = (self._scripted(node) if superscript else declared.latex) + superscript
        first, *others = (self.sum(arg) for arg in node.args)
        mark = "," if " " in declared.argument else ";"  # coordinates, or an argument and parameters
        inside = f"{first}{mark} {', '.join(others)}" if others else first
        return rf"{head} \left( {inside} \right)"


_LAST = t.Integral | t.Limit | t.Compose


def primes(order: int) -> str:
    """The primes of a derivative."""
    return "^{" + " ".join([r"\prime"] * order) + "}"
