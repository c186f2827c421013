"""What folding leaves behind: dead branches, code after a return, assignments that nothing reads any more."""

from __future__ import annotations

import ast
from collections import Counter
from collections.abc import Collection
from typing import Any

import sympy

from derive.emit.backends import MODULE_ALIASES
from derive.emit.trees import Transformer, walk
from derive.emit.values import Exact

_MODULES = frozenset(MODULE_ALIASES.values())
_ENDS = (ast.Return, ast.Raise, ast.Continue, ast.Break)


class _Pruner(Transformer):
    """Cuts branches whose test is decided, and what follows the end of a block."""

    def visit_If(self, node: ast.If) -> Any:
        self.generic_visit(node)
        node.body, node.orelse = _block(node.body), _cut(node.orelse)
        node.test = _settled(node.test)
        if isinstance(node.test, Exact):
            return node.body if node.test.value not in (sympy.false, 0) else node.orelse or None
        return node

    def visit_While(self, node: ast.While) -> Any:
        self.generic_visit(node)
        node.body = _block(node.body)
        return None if isinstance(node.test, Exact) and node.test.value in (sympy.false, 0) else node

    def visit_FunctionDef(self, node: ast.FunctionDef) -> Any:
        self.generic_visit(node)
        node.body = _block(node.body)
        return node

    def visit_For(self, node: ast.For) -> Any:
        self.generic_visit(node)
        node.body = _block(node.body)
        return node

    def visit_With(self, node: ast.With) -> Any:
        self.generic_visit(node)
        node.body = _block(node.body)
        return node

    def visit_Expr(self, node: ast.Expr) -> Any:
        return None if isinstance(node.value, Exact) else node


def _settled(test: ast.expr) -> ast.expr:
    """The test, or its outcome where the last part of an and/or settles it and the parts before only look."""
    if isinstance(test, ast.BoolOp) and isinstance(test.values[-1], Exact):
        looks = not any(isinstance(n, (ast.Call, ast.NamedExpr)) for value in test.values for n in walk(value))
        return test.values[-1] if looks else test
    return test


def prune(node: Any) -> Any:
    """``node`` without branches that folding has decided against."""
    return _Pruner().visit(node)


def sweep(node: Any, names: Collection[str], pure: Collection[str]) -> Any:
    """``node`` without assignments to ``names`` that call ``pure`` functions only."""
    return _Sweeper(names, pure).visit(node)


def _cut(body: list[ast.stmt]) -> list[ast.stmt]:
    """Statements up to the first that ends the block; a branch that returned at its end makes the rest unreachable."""
    for index, node in enumerate(body):
        if isinstance(node, _ENDS):
            return body[: index + 1]
    return body


def _block(body: list[ast.stmt]) -> list[ast.stmt]:
    return _cut(body) or [ast.Pass()]


def constant_locals(function: ast.AST) -> dict[str, Any]:
    """Locals that are assigned once in the whole function, to a folded value."""
    nodes = walk(function)
    stores = Counter(n.id for n in nodes if isinstance(n, ast.Name) and isinstance(n.ctx, ast.Store))
    taken = {n.arg for n in nodes if isinstance(n, ast.arg)}
    taken |= {name for n in nodes if isinstance(n, (ast.Global, ast.Nonlocal)) for name in n.names}
    found: dict[str, Any] = {}
    for node in nodes:
        if isinstance(node, ast.Assign):
            for target, value in _pairs(node):
                once = stores[target] == 1 and target not in taken
                if once and isinstance(value, Exact):
                    found[target] = value.value
    return found


def _pairs(node: ast.Assign) -> list[tuple[str, ast.expr]]:
    """(name, value) of a plain assignment, a = x or a, b = x, y."""
    target, value = node.targets[0], node.value
    if len(node.targets) == 1 and isinstance(target, ast.Name):
        return [(target.id, value)]
    if len(node.targets) == 1 and isinstance(target, ast.Tuple) and isinstance(value, ast.Tuple):
        pairs = zip(target.elts, value.elts, strict=False)
        return [(name.id, part) for name, part in pairs if isinstance(name, ast.Name)]
    return []


class _Sweeper(Transformer):
    """Removes assignments to ``names`` whose values have no effect of their own."""

    def __init__(self, names: Collection[str], pure: Collection[str]) -> None:
        self.names, self.pure = names, pure

    def visit_Assign(self, node: ast.Assign) -> Any:
        if len(node.targets) != 1:
            return node
        target = node.targets[0]
        if isinstance(target, ast.Name) and target.id in self.names:
            return self._gone(node, node.value)
        if isinstance(target, ast.Tuple) and any(isinstance(t, ast.Name) and t.id in self.names for t in target.elts):
            return self._from_tuple(node, target)
        return node

    def _from_tuple(self, node: ast.Assign, target: ast.Tuple) -> Any:
        if not isinstance(node.value, ast.Tuple) or len(node.value.elts) != len(target.elts):
            for item in target.elts:
                if isinstance(item, ast.Name) and item.id in self.names and not item.id.startswith("_"):
                    item.id = f"_{item.id}"
            return node
        pairs = [
            (name, value)
            for name, value in zip(target.elts, node.value.elts, strict=True)
            if not (isinstance(name, ast.Name) and name.id in self.names and self._free(value))
        ]
        if not pairs:
            return None
        if len(pairs) == 1:
            node.targets, node.value = [pairs[0][0]], pairs[0][1]
        else:
            target.elts, node.value.elts = [name for name, _ in pairs], [value for _, value in pairs]
        return node

    def visit_AnnAssign(self, node: ast.AnnAssign) -> Any:
        named = isinstance(node.target, ast.Name) and node.target.id in self.names
        return self._gone(node, node.value) if named and node.value is not None else node

    def _gone(self, node: ast.stmt, value: ast.expr) -> Any:
        return None if self._free(value) else node

    def _free(self, value: ast.expr) -> bool:
        """Whether leaving ``value`` out changes nothing else: it calls pure functions only."""
        calls = [n for n in walk(value) if isinstance(n, (ast.Call, ast.NamedExpr, ast.Yield, ast.Await))]
        return all(isinstance(n, ast.Call) and (_of_module(n.func) or self._is_pure(n.func)) for n in calls)

    def _is_pure(self, func: ast.expr) -> bool:
        return isinstance(func, ast.Name) and func.id in self.pure


def _of_module(func: ast.expr) -> bool:
    """Whether a function is one of NumPy's, which kernels use to compute only."""
    return isinstance(func, ast.Attribute) and isinstance(func.value, ast.Name) and func.value.id in _MODULES
