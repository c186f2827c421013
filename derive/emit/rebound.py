"""Names of folded constants that a kernel binds anew: from there on they stand for something else.

A kernel may check a parameter (``eta = real("eta", eta)``) or take it from a record (``eta = rod.eta``): that says the
folded value again. Anything else that is bound to its name, a length in other units or a running index, does not.
"""

from __future__ import annotations

import ast
import copy
from collections.abc import Collection, Iterator, Mapping
from typing import Any

from derive.emit.fold import fold
from derive.emit.values import Exact


def rebound(
    node: ast.AST, values: Mapping[str, Any], fields: Mapping[str, Any], modules: Collection[str]
) -> dict[str, int]:
    """The names in ``values`` that a function binds to something else, each with the first line where it does."""
    found: dict[str, int] = {}
    for part in ast.walk(node):
        for target, value in _bindings(part):
            for name in _stored(target):
                if name in values and not _says(value, name, values, fields, modules):
                    line = getattr(target, "lineno", 0)
                    found[name] = min(line, found.get(name, line))
    return found


def _bindings(node: ast.AST) -> Iterator[tuple[ast.AST, ast.expr | None]]:
    """Targets of an assignment, loop, or ``with``, each with its value; None where that is no single expression."""
    match node:
        case ast.Assign():
            for target in node.targets:
                yield from _pairs(target, node.value)
        case ast.AnnAssign() if node.value is not None:
            yield node.target, node.value
        case ast.NamedExpr():
            yield node.target, node.value
        case ast.AugAssign() | ast.For() | ast.comprehension():
            yield node.target, None
        case ast.withitem() if node.optional_vars is not None:
            yield node.optional_vars, None


def _pairs(target: ast.expr, value: ast.expr) -> Iterator[tuple[ast.expr, ast.expr | None]]:
    """a, b = x, y as a = x and b = y; what is taken out of a value that is no tuple as it is written has none."""
    if not isinstance(target, (ast.Tuple, ast.List)):
        yield target, value
        return
    matches = isinstance(value, (ast.Tuple, ast.List)) and len(value.elts) == len(target.elts)
    plain = not any(isinstance(item, ast.Starred) for item in (*target.elts, *getattr(value, "elts", ())))
    if matches and plain:
        for one, part in zip(target.elts, value.elts, strict=True):  # type: ignore[attr-defined]  # ``matches`` says so
            yield from _pairs(one, part)
    else:
        yield target, None


def _stored(target: ast.AST) -> Iterator[str]:
    """The names that a target binds; not the record or list of which it sets a part."""
    return (n.id for n in ast.walk(target) if isinstance(n, ast.Name) and isinstance(n.ctx, ast.Store))


def _says(
    value: ast.expr | None, name: str, values: Mapping[str, Any], fields: Mapping[str, Any], modules: Collection[str]
) -> bool:
    """Whether an expression is the folded value of ``name`` once folding has worked it out."""
    if value is None:
        return False
    known = fold(copy.deepcopy(value), values, fields, modules)
    return isinstance(known, Exact) and bool(known.value == values[name])
