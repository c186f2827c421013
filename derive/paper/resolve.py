"""The typed pass: the syntax of a statement and the conventions of its section → the typed tree.

Here: statements, sums and compound factors. A row of factors is resolved in ``rows``, by declared types; sums over
repeated indices are found in ``indices``. What fits two readings, or none, is a ReadError.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

from lark import Token, Tree

from . import tree as t
from .conventions import Scope
from .differentials import differential, fraction_row
from .factors import read_factor
from .indices import contracted, one_set_of_free
from .rows import read_row
from .spelling import Complain

# Relations as printed, and the operators of a Statement; the first spelling is the one that is printed.
RELATIONS = {
    "=": "=", "<": "<", ">": ">", r"\to": "->", r"\le": "<=", r"\leq": "<=", r"\ge": ">=", r"\geq": ">=",
    r"\ne": "!=", r"\neq": "!=", r"\in": "in", r"\notin": "notin",
}  # fmt: skip
MEMBERSHIP = ("in", "notin")
MAX_COMPOSED = 40  # tensors applied or composed in one display; the article needs 10
Syntax = Any  # Tree[Token] | Token: lark's children are one or the other


class Resolver:
    """Resolves one statement in one scope; ``error(offset, message)`` makes its errors."""

    def __init__(self, scope: Scope, error: Complain) -> None:
        self.scope, self.error = scope, error
        self._counted = 0

    def count(self, node: t.Node) -> None:
        """Count what makes trees deeper without brackets."""
        self._counted += 1
        if self._counted > MAX_COMPOSED:
            raise self.error(node.span[0], f"more than {MAX_COMPOSED} tensors are applied in one display; split it")

    def statement(self, tree: Tree[Token]) -> t.Statement:
        """A chain of relations whose sides have one type (0 fits any)."""
        sides, operators = self._chain(tree.children)
        if not operators:
            raise self.error(tree.meta.start_pos, "a statement needs a relation; this is an expression only")
        sides = [contracted(side, self.error) for side in sides]
        one_set_of_free(sides, self.error)
        return t.Statement(tuple(sides), tuple(operators), span=_span(tree))

    def _chain(self, children: Sequence[Syntax]) -> tuple[list[t.Node], list[str]]:
        sides = [self.sum(part) for part in children if isinstance(part, Tree)]
        operators = [RELATIONS[part] for part in children if isinstance(part, Token)]
        *quantities, last = sides
        member = bool(operators) and operators[-1] in MEMBERSHIP
        quantities, regions = (quantities, [last]) if member else (sides, [])
        for side in sides:
            if (side.type == t.REGION) != any(side is region for region in regions):
                raise self.error(
                    side.span[0], f"a {side.type} cannot stand here; a region stands at the end, after \\in"
                )
        if any(operator in MEMBERSHIP for operator in operators[:-1]):
            raise self.error(last.span[0], "nothing follows the region after \\in")
        return self._fitted(quantities) + regions, operators

    def sum(self, tree: Syntax) -> t.Node:
        """Signed terms of one type."""
        terms: list[t.Node] = []
        sign: Token | None = None
        for child in tree.children:
            if isinstance(child, Token):
                sign = child
                continue
            term = read_row(child.children, self)
            if term.type in (t.REGION, t.LIST) and (sign is not None or len(tree.children) > 1):
                raise self.error(term.span[0], f"a {term.type} is no term of a sum")
            if sign is not None and not (sign == "+" and terms):
                term = t.Signed(str(sign), term, span=(sign.start_pos or 0, term.span[1]))
            terms.append(term)
        if len(terms) == 1:
            return terms[0]
        return t.Sum(tuple(self._fitted(terms)), span=_span(tree))

    def row(self, items: Sequence[Syntax]) -> t.Node:
        """One row of factors."""
        return read_row(items, self)

    def _fitted(self, nodes: Sequence[t.Node]) -> list[t.Node]:
        """Nodes of one type; 0 fits any as a side, and O(…) takes the type of what stands beside it."""
        typed = [node for node in nodes if not _is_order(node) and node != t.Number(0)] or list(nodes)
        for node in typed[1:]:
            if node.type != typed[0].type:
                raise self.error(node.span[0], f"a {node.type} stands beside a {typed[0].type}; check the types")
        return [_with_kind(node, typed[0].type) for node in nodes]

    def argument(self, tree: Syntax) -> t.Node:
        """The argument of a script, a fraction or a root: one token, or a formula in braces."""
        if tree.data == "sum":
            return self.sum(tree)
        inner = tree.children[0]
        if isinstance(inner, Tree) and inner.data == "sum":
            return self.sum(inner)
        return read_factor(Tree("factor", [inner], tree.meta), self).node(self)

    def norm(self, of: t.Node, span: t.Span) -> t.Node:
        """|of|."""
        if of.type not in (t.SCALAR, t.VECTOR):
            raise self.error(span[0], f"a {of.type} stands between bars")
        return t.Norm(of, span=span)

    def quotient(self, above: t.Node, below: t.Node) -> t.Node:
        """above / below, by a scalar."""
        if below.type != t.SCALAR or above.type in (t.REGION, t.LIST):
            raise self.error(below.span[0], f"a {above.type} is divided by a {below.type}")
        return t.Quotient(above, below, span=(above.span[0], below.span[1]))

    def fraction(self, tree: Any, span: t.Span) -> t.Node:
        """A quotient, or the derivative of one quantity by a symbol."""
        above, below = (fraction_row(part) for part in tree.children[1:])
        mark = differential(above[:2], self)
        if not mark:
            parts = (self.argument(part) for part in tree.children[1:])
            return replace(self.quotient(*parts), span=span)
        if differential(below[:2], self) != mark:
            message = f"{mark} stands above but not below; a derivative needs both"
            raise self.error(tree.children[2].meta.start_pos, message)
        of, by = (read_row(part[1:], self) for part in (above, below))
        if not isinstance(by, t.Name) or by.type != t.SCALAR:
            raise self.error(by.span[0], "a derivative is taken with respect to a scalar symbol")
        return t.Derivative(of, by, mark != "d", span=span)

    def rows_of(self, tree: Any, span: t.Span) -> t.Node:
        """A stack of quantities, or cases."""
        if tree.data == "stack":
            rows = self._fitted([self.sum(part) for part in tree.children if isinstance(part, Tree)])
            return t.Stack(tuple(rows), span=span)
        values, conditions = [], []
        for case in (part for part in tree.children if isinstance(part, Tree)):
            first, *chain = [part for part in case.children if not _is_mark(part)]
            sides, operators = self._chain(chain)
            values.append(self.sum(first))
            at = (chain[0].meta.start_pos, chain[-1].meta.end_pos)
            conditions.append(t.Condition(tuple(sides), tuple(operators), span=at))
        return t.Cases(tuple(self._fitted(values)), tuple(conditions), span=span)


def _is_mark(part: Syntax) -> bool:
    return isinstance(part, Token) and part.type != "RELATION"


def _is_order(node: t.Node) -> bool:
    return isinstance(node, t.BigO) or (isinstance(node, t.Signed) and _is_order(node.of))


def _with_kind(node: t.Node, kind: str) -> t.Node:
    if isinstance(node, t.Signed) and _is_order(node):
        return replace(node, of=_with_kind(node.of, kind))
    return replace(node, kind=kind) if isinstance(node, t.BigO) else node


def _span(tree: Tree[Token]) -> t.Span:
    return tree.meta.start_pos, tree.meta.end_pos
