"""Syntax trees walked and copied, faster than by the standard library.

Emitting a module looks at every node of some hundred definitions in every round of folding.
"""

from __future__ import annotations

import ast
import operator
from collections import deque
from collections.abc import Callable, Iterator
from typing import Any, TypeVar

Tree = TypeVar("Tree", bound=ast.AST)
# What an operator of the syntax does to two values.
OPERATIONS: dict[type[ast.operator], Callable[[Any, Any], Any]] = {
    ast.Add: operator.add,
    ast.Sub: operator.sub,
    ast.Mult: operator.mul,
    ast.Div: operator.truediv,
    ast.Pow: operator.pow,
}


def walk(node: ast.AST) -> Iterator[Any]:
    """The node and all below it, in the order of ``ast.walk``."""
    waiting = deque([node])
    while waiting:
        node = waiting.popleft()
        known = node.__dict__
        for name in node._fields:
            value = known.get(name)
            if isinstance(value, ast.AST):
                waiting.append(value)
            elif isinstance(value, list):
                waiting.extend([item for item in value if isinstance(item, ast.AST)])
        yield node


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
