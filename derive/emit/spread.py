"""Values that spread through calls: a parameter or a field that every call gives as one and the same folded value.

So a field angle of 0 reaches a kernel that is called with ``field_angle`` and with ``-field_angle``, or that finds it
in a record. Only values that folding made count: a number that the author wrote in a call stays an argument.
"""

from __future__ import annotations

import ast
from collections import Counter
from collections.abc import Collection, Iterator, Mapping
from typing import Any

from derive.emit.backends import MODULE_ALIASES, RESULTS
from derive.emit.drop import drop_parameters
from derive.emit.fold import fold_inside
from derive.emit.pieces import Piece
from derive.emit.slice import Slicer
from derive.emit.trees import Transformer, walk
from derive.emit.values import Exact, exact

_MODULES = frozenset(MODULE_ALIASES.values())


def spread(slicer: Slicer, roots: Collection[str]) -> None:
    """Fold, in place, what every call gives as the same value, and drop it from signatures, fields and calls."""
    pieces, reached = slicer.pieces, slicer.reach(roots)
    fields = _fields(pieces, reached)
    drops: dict[str, tuple[str, ...]] = {}  # of functions, all at once: every drop looks at every call
    for name, given in _given(pieces, reached, roots).items():
        piece = pieces[name]
        same = {key: value for key, value in given.items() if key in piece.parameters}
        if piece.formula:
            _fix(slicer, name, same)
        elif piece.kind == "function":
            same = {key: value for key, value in same.items() if _is_read_only(piece.node, key)}
            fold_inside(piece.node, same, {}, _MODULES)
            drops[name] = tuple(same)
        elif piece.kind == "class":
            _fold_fields(pieces, reached, name, {key: v for key, v in same.items() if fields.get(key) == 1})
    if drops := {name: gone for name, gone in drops.items() if gone}:
        drop_parameters(pieces, drops)


def _given(pieces: Mapping[str, Piece], reached: Collection[str], roots: Collection[str]) -> dict[str, dict[str, Any]]:
    """For each piece that is only called, the parameters that all its calls give as one folded value."""
    calls: dict[str, list[dict[str, ast.expr]]] = {}
    other = set(roots)
    for piece in (pieces[name] for name in reached):
        called: set[int] = set()
        for call in _calls(piece.node, pieces):
            name = call.func.id  # type: ignore[attr-defined]  # _calls gives calls of names only
            called.add(id(call.func))
            if any(isinstance(a, ast.Starred) for a in call.args) or any(k.arg is None for k in call.keywords):
                other.add(name)
            given = dict(zip(pieces[name].parameters, call.args, strict=False))
            calls.setdefault(name, []).append(given | {str(k.arg): k.value for k in call.keywords})
        if piece.kind != "class":
            loads = (n for n in walk(piece.node) if isinstance(n, ast.Name) and id(n) not in called)
            other |= {n.id for n in loads if n.id in pieces and pieces[n.id].kind != "class"}
    return {name: _common(given) for name, given in calls.items() if name not in other}


def _calls(node: ast.AST, pieces: Mapping[str, Piece]) -> Iterator[ast.Call]:
    for call in walk(node):
        if isinstance(call, ast.Call) and isinstance(call.func, ast.Name) and call.func.id in pieces:
            yield call


def _common(calls: list[dict[str, ast.expr]]) -> dict[str, Any]:
    """What all calls give, as the same value."""
    values = {key: node.value for key, node in calls[0].items() if isinstance(node, Exact)}
    for call in calls[1:]:
        values = {k: v for k, v in values.items() if isinstance(one := call.get(k), Exact) and one.value == v}
    return values


def _fix(slicer: Slicer, name: str, values: dict[str, Any]) -> None:
    """Put values into a formula; where it has no value there, it must not be reached."""
    if not values:
        return
    if not slicer.is_finite(name, values):
        slicer.missing.add(name)
        return
    slicer.fix_formula(name, values)
    piece = slicer.pieces[name]
    kept = [symbol.name for symbol in piece.formula.arguments] if piece.formula else []
    drop_parameters(slicer.pieces, {name: tuple(p for p in piece.parameters if p not in kept)})


def _is_read_only(node: ast.AST, name: str) -> bool:
    """Whether a function's parameter is neither assigned in it nor hidden by a parameter of an inner function."""
    stores = any(isinstance(n, ast.Name) and n.id == name and not isinstance(n.ctx, ast.Load) for n in walk(node))
    return not stores and sum(isinstance(n, ast.arg) and n.arg == name for n in walk(node)) == 1


def _fields(pieces: Mapping[str, Piece], reached: Collection[str]) -> Counter[str]:
    """How many records have a field of each name; one that is a keyword of other calls counts as two."""
    found: Counter[str] = Counter()
    for name in reached:
        if pieces[name].kind == "class":
            found.update(pieces[name].parameters)
        for call in (n for n in walk(pieces[name].node) if isinstance(n, ast.Call)):
            if not (isinstance(call.func, ast.Name) and call.func.id in pieces):
                found.update(str(k.arg) for k in call.keywords)
    return found


def _fold_fields(pieces: Mapping[str, Piece], reached: Collection[str], name: str, values: Mapping[str, Any]) -> None:
    """Fold the fields of a data class (a tuple could be taken apart) whose names no other record has."""
    decorators = getattr(pieces[name].node, "decorator_list", [])
    if not values or name in RESULTS or not any("dataclass" in ast.unparse(one) for one in decorators):
        return
    for piece in (pieces[one] for one in reached):
        if piece.kind != "formula":
            piece.node = _Attributes(values).visit(piece.node)
    drop_parameters(pieces, {name: tuple(values)})


class _Attributes(Transformer):
    """Replaces loads of attributes by values."""

    def __init__(self, values: Mapping[str, Any]) -> None:
        self.values = values

    def visit_Attribute(self, node: ast.Attribute) -> ast.expr:
        self.generic_visit(node)
        of_module = isinstance(node.value, ast.Name) and node.value.id in _MODULES
        if isinstance(node.ctx, ast.Load) and node.attr in self.values and not of_module:
            return exact(self.values[node.attr], node)
        return node
