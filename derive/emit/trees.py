"""Syntax trees walked, copied, compared and changed, faster than by the standard library.

Emitting a module looks at every node of some hundred definitions in every round of folding. Contexts and operators,
which hold nothing themselves, are passed over: they are a third of all nodes.
"""

from __future__ import annotations

import ast
import operator
from collections.abc import Callable
from functools import cache
from typing import Any, ClassVar, TypeVar

Tree = TypeVar("Tree", bound=ast.AST)
# What an operator of the syntax does to two values.
OPERATIONS: dict[type[ast.operator], Callable[[Any, Any], Any]] = {
    ast.Add: operator.add,
    ast.Sub: operator.sub,
    ast.Mult: operator.mul,
    ast.Div: operator.truediv,
    ast.Pow: operator.pow,
}

_WITHOUT_NODES = frozenset(
    ("ctx", "op", "ops", "id", "attr", "arg", "name", "asname", "module", "level", "kind", "type_comment", "simple")
)
_SAYS_NOTHING = frozenset(("ctx", "kind", "type_comment", "type_ignores"))


@cache
def _below(kind: type[ast.AST]) -> tuple[str, ...]:
    """The fields of a kind of node in which there may be nodes."""
    return () if kind is ast.Constant else tuple(name for name in kind._fields if name not in _WITHOUT_NODES)


@cache
def _telling(kind: type[ast.AST]) -> tuple[str, ...]:
    """The fields of a kind of node that say something."""
    return tuple(name for name in kind._fields if name not in _SAYS_NOTHING)


def walk(node: ast.AST) -> list[Any]:
    """The node and all below it, in the order of ``ast.walk``; no contexts and no operators."""
    found: list[Any] = [node]
    for one in found:  # which grows
        known = one.__dict__
        for name in _below(one.__class__):
            value = known.get(name)
            if value.__class__ is list:
                found += [item for item in value if isinstance(item, ast.AST)]
            elif isinstance(value, ast.AST):
                found.append(value)
    return found


def copied(node: Tree) -> Tree:
    """A tree of new nodes; what is no node, such as a mark or a value, is shared."""
    new = node.__class__.__new__(node.__class__)
    for name, value in node.__dict__.items():
        if isinstance(value, ast.AST):
            value = copied(value)
        elif isinstance(value, list):
            value = [copied(item) if isinstance(item, ast.AST) else item for item in value]
        new.__dict__[name] = value
    return new


def form(node: Any) -> Any:
    """What a tree says, to be compared: equal for trees that ``ast.dump`` writes alike, contexts left aside."""
    kind = node.__class__
    if kind is list:
        return tuple([form(item) for item in node])
    if kind is ast.Name:
        return ast.Name, node.id
    if kind is ast.Constant:
        return ast.Constant, repr(node.value)  # for 1 == 1.0 == True, and 0.0 == -0.0
    if not isinstance(node, ast.AST):
        return node
    known = node.__dict__
    return (kind, *[form(known.get(name)) for name in _telling(kind)])


class Transformer:
    """Changes trees like ``ast.NodeTransformer``: a method visit_Name for nodes of that name, None to leave one out."""

    _visitors: ClassVar[dict[str, Callable[[Any, Any], Any]]] = {}

    def __init_subclass__(cls) -> None:
        """Look up the methods of a class once, not for every node."""
        names = [name for name in dir(cls) if name.startswith("visit_")]
        cls._visitors = {name.removeprefix("visit_"): getattr(cls, name) for name in names}

    def visit(self, node: Any) -> Any:
        """What stands in the place of a node: another, several as a list, or None."""
        visitor = self._visitors.get(node.__class__.__name__)
        return visitor(self, node) if visitor else self.generic_visit(node)

    def generic_visit(self, node: Any) -> Any:
        """The node itself, its children changed."""
        known = node.__dict__
        for name in _below(node.__class__):
            value = known.get(name)
            if value.__class__ is list:
                value[:] = self._members(value)
            elif isinstance(value, ast.AST):
                known[name] = self.visit(value)
        return node

    def _members(self, nodes: list[Any]) -> list[Any]:
        found: list[Any] = []
        for node in nodes:
            new = self.visit(node) if isinstance(node, ast.AST) else node
            if isinstance(new, list):
                found += new
            elif new is not None or node is None:
                found.append(new)
        return found
