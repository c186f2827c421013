"""Folded values in syntax trees: exact numbers and truth values, and what the domain decides about them."""

from __future__ import annotations

import ast
import operator
from collections.abc import Callable
from typing import Any

import sympy
from sympy import Expr, Rational, S

from derive.emit.scene import PARAMETERS


class Exact(ast.expr):
    """A folded value in a syntax tree: an exact number or a truth value."""

    _fields = ("value",)

    def __init__(self, value: Any = None, **place: Any) -> None:
        super().__init__(**place)
        self.value = value


def exact(value: Any, like: ast.AST | None = None) -> Exact:
    """A node for ``value`` at the place of ``like``."""
    node = Exact(value=sympy.sympify(value) if isinstance(value, (bool, int)) else value)
    return ast.copy_location(node, like) if like is not None else node


_PLAIN: dict[type[ast.operator], Callable[[Any, Any], Any]] = {
    ast.Add: operator.add,
    ast.Sub: operator.sub,
    ast.Mult: operator.mul,
    ast.Div: operator.truediv,
}


def value_of(node: ast.AST) -> Any:
    """The exact value of a folded node, of a literal, of π, or of what these make up; else None."""
    if isinstance(node, Exact):
        return node.value
    if isinstance(node, ast.Constant) and isinstance(node.value, bool):
        return S.true if node.value else S.false
    if isinstance(node, ast.Constant) and isinstance(node.value, (int, float)):
        return Rational(str(node.value))
    if isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.USub):
        inner = value_of(node.operand)
        return -inner if isinstance(inner, Expr) else None
    if isinstance(node, ast.Name) and node.id == "pi":
        return sympy.pi
    if isinstance(node, ast.BinOp) and type(node.op) in _PLAIN:
        left, right = value_of(node.left), value_of(node.right)
        known = isinstance(left, Expr) and isinstance(right, Expr) and not (isinstance(node.op, ast.Div) and right == 0)
        return _PLAIN[type(node.op)](left, right) if known else None
    return None


_COMPARISONS: dict[type[ast.cmpop], Callable[[Any, Any], Any]] = {
    ast.Lt: operator.lt,
    ast.LtE: operator.le,
    ast.Gt: operator.gt,
    ast.GtE: operator.ge,
    ast.Eq: lambda a, b: sympy.sympify(sympy.Eq(a, b)),
    ast.NotEq: lambda a, b: sympy.sympify(sympy.Ne(a, b)),
}
_MIRRORED: dict[type[ast.cmpop], type[ast.cmpop]] = {ast.Lt: ast.Gt, ast.LtE: ast.GtE, ast.Gt: ast.Lt, ast.GtE: ast.LtE}


def sign(node: ast.AST) -> str:
    """'positive', 'nonnegative' or '' (nothing known) from the domains of the scene parameters."""
    value = value_of(node)
    if value is not None:
        return "positive" if value > 0 else "nonnegative" if value == 0 else ""
    if isinstance(node, ast.Name):
        return PARAMETERS.get(node.id, "").replace("real", "")
    if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id in ("sqrt", "abs"):
        return "nonnegative"
    if isinstance(node, ast.BinOp):
        sides = {sign(node.left), sign(node.right)}
        if "" in sides:
            return ""
        if isinstance(node.op, ast.Add):
            return "positive" if "positive" in sides else "nonnegative"
        if isinstance(node.op, (ast.Mult, ast.Div)):
            return "positive" if sides == {"positive"} else "nonnegative"
    return ""


def truth(node: Exact) -> Any:
    """Whether the value counts as true."""
    value = node.value
    return value if value in (S.true, S.false) else sympy.sympify(value != 0)


def decide(op: type[ast.cmpop], left: ast.AST, right: ast.AST) -> bool | None:
    """The outcome of a comparison, if the values or the domain settle it."""
    a, b = value_of(left), value_of(right)
    if a is not None and b is not None:
        outcome = _COMPARISONS[op](a, b) if op in _COMPARISONS else None
        return None if outcome is None else bool(outcome)
    if a is not None and op in (*_MIRRORED, ast.Eq, ast.NotEq):
        return decide(_MIRRORED.get(op, op), right, left)
    if b == 0 and (known := sign(left)):
        strict = known == "positive"
        table = {ast.Lt: False, ast.GtE: True, ast.LtE: False if strict else None, ast.Gt: True if strict else None}
        return table.get(op, {ast.Eq: False, ast.NotEq: True}.get(op) if strict else None)
    return None
