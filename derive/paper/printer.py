"""Typed trees → LaTeX that reads back as the same tree.

Brackets stand where the reader would otherwise see another tree, and nowhere else; a fraction is always ``\\frac``.
"""

from __future__ import annotations

from itertools import pairwise

from . import tree as t
from .conventions import Scope
from .conventions import scope as conventions_of
from .resolve import RELATIONS


def to_latex(statement: t.Statement | t.Node, scope: str) -> str:
    """LaTeX of a statement or of an expression, in the letters of a scope. KeyError for a name it does not have."""
    printer = _Printer(conventions_of(scope))
    if isinstance(statement, t.Node):
        return printer.sum(statement)
    first, *others = (printer.sum(side) for side in statement.sides)
    written = {operator: latex for latex, operator in reversed(RELATIONS.items())}
    operators = [written[operator] for operator in statement.operators]
    return " ".join([first, *(f"{op} {side}" for op, side in zip(operators, others, strict=True))])


class _Printer:
    def __init__(self, scope: Scope) -> None:
        self.scope = scope

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
            joined = isinstance(last, t.Dot | t.Cross) and all(factor.type == t.SCALAR for factor in before)
            shown = [self.factor(factor) for factor in before]
            shown.append(self.joined(last) if joined else self.factor(last))
            return self._side_by_side([*before, last], shown)
        return self.joined(node)

    def _side_by_side(self, nodes: list[t.Node], shown: list[str]) -> str:
        """Keep a symbol from taking the bracket after it as its argument."""
        for n, (node, other) in enumerate(pairwise(nodes)):
            if isinstance(node, t.Number) and isinstance(other, t.Number):
                raise ValueError("two numbers side by side cannot be printed; multiply them")
            if shown[n + 1].startswith(r"\left(") and self._open_ended(node):
                shown[n] = rf"\left( {shown[n]} \right)"
        return " ".join(shown)

    def _open_ended(self, node: t.Node) -> bool:
        """Would the reader try a bracket after this as its argument?"""
        if isinstance(node, t.Power | t.Primed):
            return self._open_ended(node.base if isinstance(node, t.Power) else node.of)
        return isinstance(node, t.Name) and self.scope.by_name[node.name].callable

    def joined(self, node: t.Node) -> str:
        """Where · and × may stand without brackets."""
        if isinstance(node, t.Dot):
            return rf"{self._crossed(node.left)} \cdot {self._crossed(node.right)}"
        return self._crossed(node)

    def _crossed(self, node: t.Node) -> str:
        if isinstance(node, t.Cross):
            return rf"{self.factor(node.left)} \times {self.factor(node.right)}"
        return self.factor(node)

    def factor(self, node: t.Node) -> str:
        """Where one factor may stand."""
        match node:
            case t.Number():
                return str(node.value)
            case t.Name():
                return self.scope.by_name[node.name].latex
            case t.Call():
                return self._call(node, "")
            case t.Primed(of=t.Name()):
                return f"{self.factor(node.of)}{_primes(node.order)}"
            case t.Primed():
                return f"{self.bracket(node.of)}{_primes(node.order)}"
            case t.Quotient():
                return rf"\frac{{{self.sum(node.above)}}}{{{self.sum(node.below)}}}"
            case t.Derivative():
                return rf"\frac{{d {self.row(node.of)}}}{{d {self.factor(node.by)}}}"
            case t.Power():
                return self._power(node)
            case t.Root():
                degree = "" if node.degree == 2 else f"[{node.degree}]"
                return rf"\sqrt{degree}{{{self.sum(node.of)}}}"
        return self.bracket(node)

    def bracket(self, node: t.Node) -> str:
        """In brackets."""
        return rf"\left( {self.sum(node)} \right)"

    def _power(self, node: t.Power) -> str:
        exponent = f"^{{{self.sum(node.exponent)}}}"
        if isinstance(node.base, t.Call) and not (node.base.primes or isinstance(node.exponent, t.Signed)):
            return self._call(node.base, exponent)
        if isinstance(node.base, t.Name | t.Number):
            return self.factor(node.base) + exponent
        return self.bracket(node.base) + exponent

    def _call(self, node: t.Call, power: str) -> str:
        head = self.scope.by_name[node.name].latex + (_primes(node.primes) if node.primes else "")
        first, *others = (self.sum(arg) for arg in node.args)
        inside = f"{first}; {', '.join(others)}" if others else first
        return rf"{head}{power} \left( {inside} \right)"


def _primes(order: int) -> str:
    return "^{" + " ".join([r"\prime"] * order) + "}"
