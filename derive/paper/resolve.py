"""The typed pass: the syntax of a statement and the conventions of its section → the typed tree.

A row of factors is resolved by declared types. Application: only of a symbol declared to take arguments, and only if
the bracket's sort fits; × binds before ·; scalars come before the vector they multiply. What fits two readings, or
none, is a ReadError.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from typing import Any

from lark import Token, Tree

from . import tree as t
from .conventions import Declared, Scope
from .factors import Factor, read_factor
from .spelling import Complain

# Relations as printed, and the operators of a Statement; the first spelling is the one that is printed.
RELATIONS = {
    "=": "=", "<": "<", ">": ">", r"\to": "->", r"\le": "<=", r"\leq": "<=", r"\ge": ">=", r"\geq": ">=",
    r"\ne": "!=", r"\neq": "!=",
}  # fmt: skip
Syntax = Any  # Tree[Token] | Token: lark's children are one or the other


class Resolver:
    """Resolves one statement in one scope; ``error(offset, message)`` makes its errors."""

    def __init__(self, scope: Scope, error: Complain) -> None:
        self.scope, self.error = scope, error

    def statement(self, tree: Tree[Token]) -> t.Statement:
        """A chain of relations whose sides have one type (0 fits any)."""
        sides = tuple(self.sum(part) for part in tree.children if isinstance(part, Tree))
        operators = tuple(RELATIONS[part] for part in tree.children if isinstance(part, Token))
        if not operators:
            raise self.error(tree.meta.start_pos, "a statement needs a relation; this is an expression only")
        self._one_type([side for side in sides if side != t.Number(0)])
        return t.Statement(sides, operators, span=_span(tree))

    def sum(self, tree: Syntax) -> t.Node:
        """Signed terms of one type."""
        terms: list[t.Node] = []
        sign: Token | None = None
        for child in tree.children:
            if isinstance(child, Token):
                sign = child
                continue
            term = self.chain(child.children)
            if sign is not None and not (sign == "+" and terms):
                term = t.Signed(str(sign), term, span=(sign.start_pos or 0, term.span[1]))
            terms.append(term)
        self._one_type(terms)
        return terms[0] if len(terms) == 1 else t.Sum(tuple(terms), span=_span(tree))

    def _one_type(self, nodes: Sequence[t.Node]) -> None:
        for node in nodes[1:]:
            if node.type != nodes[0].type:
                raise self.error(node.span[0], f"a {node.type} stands beside a {nodes[0].type}; check the types")

    def chain(self, items: Sequence[Syntax]) -> t.Node:
        """One row of factors: split at ·, then at ×, then at /."""
        left, *right = _split(items, "CDOT", self.error)
        nodes = self._crossed(left)
        if right:
            *scalars, vector = self._last_vector(nodes)
            other = self._product(self._crossed(right[0]))
            if other.type != t.VECTOR:
                raise self.error(other.span[0], "· joins vectors; write products of scalars side by side")
            nodes = [*scalars, t.Dot(vector, other, span=(vector.span[0], other.span[1]))]
        return self._product(nodes)

    def _crossed(self, items: Sequence[Syntax]) -> list[t.Node]:
        left, *right = _split(items, "CROSS", self.error)
        nodes = self._divided(left)
        if right:
            *scalars, vector = self._last_vector(nodes)
            other = self._product(self._divided(right[0]))
            if other.type != t.VECTOR:
                raise self.error(other.span[0], "× joins vectors; write products of scalars side by side")
            nodes = [*scalars, t.Cross(vector, other, span=(vector.span[0], other.span[1]))]
        return nodes

    def _last_vector(self, nodes: list[t.Node]) -> list[t.Node]:
        if nodes[-1].type != t.VECTOR:
            raise self.error(nodes[-1].span[0], "the last factor before · or × is no vector; write brackets")
        return nodes

    def _divided(self, items: Sequence[Syntax]) -> list[t.Node]:
        left, *right = _split(items, "SLASH", self.error)
        nodes = self._applied(left)
        if right:
            below = self._applied(right[0])
            if len(below) > 1:
                raise self.error(below[1].span[0], "where does the denominator after '/' end? write brackets")
            nodes = [self.quotient(self._product(nodes), below[0])]
        return nodes

    def quotient(self, above: t.Node, below: t.Node) -> t.Node:
        """above / below, by a scalar."""
        if below.type != t.SCALAR:
            raise self.error(below.span[0], "a vector stands in a denominator")
        return t.Quotient(above, below, span=(above.span[0], below.span[1]))

    def _product(self, nodes: Sequence[t.Node]) -> t.Node:
        vectors = [node for node in nodes if node.type == t.VECTOR]
        if len(vectors) > 1:
            raise self.error(vectors[1].span[0], "two vectors side by side; write · or × between them")
        for one, other in pairwise(nodes):
            if isinstance(one, t.Number) and isinstance(other, t.Number):
                raise self.error(other.span[0], "two numbers side by side; write brackets or one number")
        span = (nodes[0].span[0], nodes[-1].span[1])
        return nodes[0] if len(nodes) == 1 else t.Product(tuple(nodes), span=span)

    def _applied(self, items: Sequence[Syntax]) -> list[t.Node]:
        """Side by side without operators: symbols take the arguments that fit."""
        rest = [read_factor(item, self) for item in items]
        nodes: list[t.Node] = []
        while rest:
            head = rest.pop(0)
            if head.declared is not None and head.declared.callable:
                nodes.append(self._call(head, head.declared, rest))
            else:
                nodes.append(head.node(self))
        return nodes

    def _call(self, head: Factor, declared: Declared, rest: list[Factor]) -> t.Node:
        if rest and rest[0].arguments is not None and self._fits(declared, rest[0]):
            return head.call(self, rest.pop(0))
        if declared.kind != "function":
            return head.node(self)
        if not declared.prefix or not rest:
            raise self.error(head.span[1], f"the function {declared.latex} needs an argument in brackets")
        bare = rest.pop(0)
        if bare.declared is not None and bare.declared.kind == "function":
            raise self.error(bare.span[0], f"write brackets around the argument of {declared.latex}")
        if rest and not (rest[0].declared is not None and rest[0].declared.kind == "function"):
            raise self.error(rest[0].span[0], f"where does the argument of {declared.latex} end? write brackets")
        return head.call(self, bare.as_argument(self))

    def _fits(self, declared: Declared, bracket: Factor) -> bool:
        """Is the bracket an argument of the symbol? ReadError if it may be one as well as a factor."""
        arguments = bracket.arguments or ()
        if declared.kind == "function":
            if len(arguments) not in declared.arity:
                allowed = " or ".join(map(str, declared.arity))
                raise self.error(bracket.span[0], f"{declared.latex} takes {allowed} arguments, not {len(arguments)}")
            return True
        sorts = {self._sort(node.name) for part in arguments for node in part.walk() if isinstance(node, t.Name)}
        if sorts == {declared.argument} or (not sorts and arguments == (t.Number(0),)):
            return True
        if declared.argument in sorts or not sorts:
            message = f"is this bracket the argument of {declared.latex} or a factor? write the product in brackets"
            raise self.error(bracket.span[0], message)
        return False

    def _sort(self, name: str) -> str:
        return self.scope.by_name[name].sort


def _span(tree: Tree[Token]) -> t.Span:
    return tree.meta.start_pos, tree.meta.end_pos


def _split(items: Sequence[Syntax], kind: str, error: Complain) -> list[Sequence[Syntax]]:
    """The items before and after the one operator of a kind; ReadError if there are two or one has no operand."""
    at = [n for n, item in enumerate(items) if isinstance(item, Token) and item.type == kind]
    if not at:
        return [items]
    if len(at) > 1:
        raise error(items[at[1]].start_pos or 0, f"two '{items[at[1]]}' in one product; write brackets")
    before, after = items[: at[0]], items[at[0] + 1 :]
    if not before or not after or any(isinstance(side, Token) for side in (before[-1], after[0])):
        raise error(items[at[0]].start_pos or 0, f"'{items[at[0]]}' needs an operand on both sides")
    return [before, after]
