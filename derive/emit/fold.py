"""Constant folding on syntax trees: what a folded scene parameter makes constant, and nothing the author wrote.

Only an operation with a folded operand is folded, so 1 / 3 or 2.0**-52 in a kernel stay as they stand. Values are exact
SymPy numbers until the module is printed. A comparison is decided by the domain (beta, eta ≥ 0, length > 0) only
against a folded value: a kernel's own checks of its arguments survive.
"""

from __future__ import annotations

import ast
from collections.abc import Callable, Collection, Mapping
from typing import Any

import sympy
from sympy import Integer, S

from derive.emit.trees import OPERATIONS, Transformer, walk
from derive.emit.values import Exact, decide, exact, truth, value_of

# Functions that give back their last argument when it is a constant within its domain: real(name, value) and the like,
# and what takes a part of an array, or asks whether any element holds, where all are one and the same.
_CHECKS = ("real", "not_negative", "positive", "within_turns")
_IDENTITIES = (
    "float",
    "mpf",
    "slab",
    "element",
    "any_of",
    "each_any_of",
    "any",
    *_CHECKS,
    *(f"all_{check}" for check in _CHECKS),
)
_CHOICES = ("where", "pick", "each_pick")  # functions that give their second or third argument, by the first
_TRUTHS = (S.true, S.false)
_SCALINGS = ("ldexp",)  # functions that give back 0 for 0
# Functions that fold when their result is rational.
_FUNCTIONS: dict[str, Callable[[Any], Any]] = {
    name: getattr(sympy, name) for name in ("sqrt", "sin", "cos", "tan", "asin", "acos", "atan", "exp", "sinh", "cosh")
} | {"abs": sympy.Abs, "isfinite": lambda value: S.true}


class _Folder(Transformer):
    """Replaces folded names by their values and works out what follows."""

    def __init__(
        self,
        values: Mapping[str, Any],
        calls: Mapping[str, Any],
        modules: Collection[str],
        fields: Mapping[str, Any] | None = None,
    ) -> None:
        self.values = dict(values)  # names whose loads become values
        self.fields = fields or {}  # attributes whose loads do
        self.calls = calls  # functions whose calls are constant
        self.modules = modules  # names of imported modules: np.beta is not a scene parameter

    def visit_Name(self, node: ast.Name) -> ast.expr:
        folds = isinstance(node.ctx, ast.Load) and node.id in self.values
        return exact(self.values[node.id], node) if folds else node

    def visit_Attribute(self, node: ast.Attribute) -> ast.expr:
        of_module = isinstance(node.value, ast.Name) and node.value.id in self.modules
        if isinstance(node.ctx, ast.Load) and node.attr in self.fields and not of_module:
            return exact(self.fields[node.attr], node)
        self.generic_visit(node)
        return node

    def visit_UnaryOp(self, node: ast.UnaryOp) -> ast.expr:
        self.generic_visit(node)
        if isinstance(node.operand, Exact):
            if isinstance(node.op, ast.Not) or (isinstance(node.op, ast.Invert) and node.operand.value in _TRUTHS):
                return exact(sympy.Not(truth(node.operand)), node)
            if isinstance(node.op, (ast.USub, ast.UAdd)):
                return exact(-node.operand.value if isinstance(node.op, ast.USub) else node.operand.value, node)
        return node

    def visit_BinOp(self, node: ast.BinOp) -> ast.expr:
        self.generic_visit(node)
        left, right = node.left, node.right
        if not (isinstance(left, Exact) or isinstance(right, Exact)):
            return node
        a, b = value_of(left), value_of(right)
        if a is not None and b is not None and type(node.op) in OPERATIONS:
            return self._both(node, a, b)
        return _identity(node, a, b)

    def _both(self, node: ast.BinOp, a: Any, b: Any) -> ast.expr:
        if isinstance(node.op, ast.Div) and b == 0:
            return node  # left to fail, or to be cut off, where it stands
        result = OPERATIONS[type(node.op)](a, b)
        simple = result.is_Rational or isinstance(node.op, (ast.Add, ast.Sub, ast.Mult, ast.Div))
        return exact(result, node) if simple and result.is_finite else node

    def visit_Call(self, node: ast.Call) -> ast.expr:
        self.generic_visit(node)
        name = node.func.id if isinstance(node.func, ast.Name) else getattr(node.func, "attr", "")
        if name in self.calls and isinstance(node.func, ast.Name):
            return exact(self.calls[name], node)
        if name in _CHOICES and len(node.args) == 3 and isinstance(node.args[0], Exact):
            return node.args[1] if truth(node.args[0]) else node.args[2]
        if name in _SCALINGS and node.args and isinstance(node.args[0], Exact) and node.args[0].value == 0:
            return exact(0, node)
        if node.args and isinstance(node.args[-1], Exact) and not node.keywords:
            argument = node.args[-1].value
            if name in _IDENTITIES:
                return exact(argument, node)
            if name in _FUNCTIONS and len(node.args) == 1:
                result = _FUNCTIONS[name](argument)
                if result.is_Rational or result in (S.true, S.false):
                    return exact(result, node)
        return node

    def visit_Compare(self, node: ast.Compare) -> ast.expr:
        self.generic_visit(node)
        if len(node.ops) != 1 or not any(isinstance(side, Exact) for side in (node.left, node.comparators[0])):
            return self._chain(node)
        outcome = decide(type(node.ops[0]), node.left, node.comparators[0])
        return node if outcome is None else exact(outcome, node)

    def _chain(self, node: ast.Compare) -> ast.expr:
        """a < b < c: decided if one link is false; links known to be true at either end are dropped."""
        sides = [node.left, *node.comparators]
        links = [
            decide(type(op), a, b) if isinstance(a, Exact) or isinstance(b, Exact) else None
            for op, a, b in zip(node.ops, sides, sides[1:], strict=False)
        ]
        if False in links:
            return exact(False, node)
        if links and all(link is True for link in links):
            return exact(True, node)
        while len(node.ops) > 1 and links[0] is True:
            node.left, node.ops, node.comparators, links = (
                node.comparators[0],
                node.ops[1:],
                node.comparators[1:],
                links[1:],
            )
        while len(node.ops) > 1 and links[-1] is True:
            node.ops, node.comparators, links = node.ops[:-1], node.comparators[:-1], links[:-1]
        return node

    def visit_BoolOp(self, node: ast.BoolOp) -> ast.expr:
        self.generic_visit(node)
        absorbing = isinstance(node.op, ast.Or)
        kept: list[ast.expr] = []
        for value in node.values:
            if not isinstance(value, Exact):
                kept.append(value)
            elif bool(truth(value)) == absorbing:
                if all(map(_looks, kept)):
                    return exact(absorbing, node)
                kept.append(exact(absorbing, value))
                break
        if not kept:
            return exact(not absorbing, node)
        node.values = kept
        return kept[0] if len(kept) == 1 else node

    def visit_IfExp(self, node: ast.IfExp) -> ast.expr:
        self.generic_visit(node)
        body, orelse = node.body, node.orelse
        if isinstance(node.test, Exact):
            return body if truth(node.test) else orelse
        same = isinstance(body, Exact) and isinstance(orelse, Exact) and body.value == orelse.value
        return body if same and not any(isinstance(n, ast.NamedExpr) for n in walk(node.test)) else node


def fold(node: Any, values: Mapping[str, Any], fields: Mapping[str, Any], modules: Collection[str]) -> Any:
    """``node`` with loads of the names in ``values``, and of attributes in ``fields``, replaced and worked out."""
    return _Folder(values, {}, modules, fields).visit(node)


def fold_inside(node: Any, values: Mapping[str, Any], calls: Mapping[str, Any], modules: Collection[str]) -> None:
    """The same for the children of ``node``, in place."""
    _Folder(values, calls, modules).generic_visit(node)


def _looks(node: ast.expr) -> bool:
    """Whether an expression is a comparison that calls nothing, so that it is True or False and can be left out."""
    return isinstance(node, ast.Compare) and not any(isinstance(n, (ast.Call, ast.NamedExpr)) for n in walk(node))


def _identity(node: ast.BinOp, a: Any, b: Any) -> ast.expr:
    """0 + x, x − 0, 0·x, 1·x, x/1, 0/x, x**1; true and x, false or x, of masks as well."""
    zero, one = Integer(0), Integer(1)
    match node.op:
        case ast.BitAnd() if S.false in (a, b):
            return exact(False, node)
        case ast.BitOr() if S.true in (a, b):
            return exact(True, node)
        case ast.BitAnd() if S.true in (a, b):
            return node.right if a == S.true else node.left
        case ast.BitOr() if S.false in (a, b):
            return node.right if a == S.false else node.left
        case ast.Add():
            return node.right if a == zero else node.left if b == zero else node
        case ast.Sub() if b == zero:
            return node.left
        case ast.Sub() if a == zero:
            return ast.copy_location(ast.UnaryOp(ast.USub(), node.right), node)
        case ast.Mult():
            if zero in (a, b):
                return exact(zero, node)
            return node.right if a == one else node.left if b == one else node
        case ast.Div():
            return exact(zero, node) if a == zero else node.left if b == one else node
        case ast.Pow():
            return exact(one, node) if b == zero else node.left if b == one else node
    return node
