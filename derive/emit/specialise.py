"""Partial evaluation: a folded scene parameter leaves signatures, fields and calls, and its value spreads.

Rounds of folding, pruning and sweeping go on until nothing changes; what is then no longer reached is left out by
slicing again. The result says the same as the general kernels at the folded values.
"""

from __future__ import annotations

import ast
from collections.abc import Collection, Mapping, Sequence
from typing import Any

from derive.emit.backends import MODULE_ALIASES, External
from derive.emit.carried import drop_carried
from derive.emit.drop import drop_parameters
from derive.emit.errors import DifferentValueError, EmitError
from derive.emit.fold import fold, fold_inside
from derive.emit.folded_calls import drop_folded, fix_formulas
from derive.emit.kernel_files import Definition
from derive.emit.pieces import Piece, bound_names
from derive.emit.rebound import rebound
from derive.emit.slice import Slicer
from derive.emit.spread import spread
from derive.emit.tidy import constant_locals, prune, sweep
from derive.emit.trees import form, walk
from derive.emit.values import Exact

_ROUNDS = 50  # far more than any kernel needs


def specialise(slicer: Slicer, roots: Sequence[str]) -> list[str]:
    """Fold the slicer's constants into its pieces, in place; the names still reached, in order."""
    pieces = slicer.pieces
    kernels = {name: piece for name, piece in pieces.items() if piece.kind != "formula"}
    settler = _Settler(kernels, pieces)
    _fold(slicer, kernels.values())
    if slicer.folded:
        settler.settle()
    fix_formulas(slicer)
    if slicer.folded:
        settler.settle()
    drop_folded(slicer)
    before = _forms(pieces)
    for _ in range(_ROUNDS):
        settler.settle(before)
        drop_carried(pieces, slicer.reach(roots))
        _drop_unused(pieces, roots)
        spread(slicer, roots)
        _take_in(slicer, kernels)
        after = _forms(pieces)
        if after == before:
            break
        before = after
    return _checked(slicer, slicer.reach(roots))


class _Settler:
    """Works out what the values in the pieces decide. A piece that neither changed nor uses a change is left alone."""

    def __init__(self, kernels: Mapping[str, Piece], pieces: Mapping[str, Piece]) -> None:
        self.kernels, self.pieces = kernels, pieces
        self.forms: dict[str, Any] = {}  # of the settled kernels
        self.known: dict[str, Any] = {}

    def settle(self, now: Mapping[str, Any] | None = None) -> None:
        """Go on until nothing changes. now: the forms of all pieces, where they are known."""
        # Other steps change pieces in place between two calls.
        now = _forms({name: self.kernels[name] for name in self.forms}) if now is None else now
        self.forms = {name: said for name, said in self.forms.items() if now[name] == said}
        for _ in range(_ROUNDS):
            self._unsettle()
            if len(self.forms) == len(self.kernels):
                return
            for name in [name for name in self.kernels if name not in self.forms]:
                before = form(self.kernels[name].node)
                _round(self.kernels[name], self.known, self.pieces)
                if form(self.kernels[name].node) == before:
                    self.forms[name] = before

    def _unsettle(self) -> None:
        """Find the functions that give one value each, and take up again what uses one of which that changed."""
        found = {name: value for name, piece in self.pieces.items() if (value := _constant(piece)) is not None}
        changed = {name for name in found.keys() | self.known.keys() if found.get(name) != self.known.get(name)}
        self.known = found
        if changed:
            for name in [name for name in self.forms if changed & _names(self.kernels[name].node)]:
                del self.forms[name]


def _names(node: ast.AST) -> set[str]:
    return {inner.id for inner in walk(node) if isinstance(inner, ast.Name)}


def _constant(piece: Piece) -> Any:
    """What every call of a formula or function gives, where it is one and the same folded value."""
    if piece.formula:
        return piece.formula.expression if piece.formula.expression.is_number else None
    body = piece.node.body[1:] if isinstance(piece.node, ast.FunctionDef) else []
    lone = body[0] if len(body) == 1 and isinstance(body[0], ast.Return) else None
    return lone.value.value if lone and isinstance(lone.value, Exact) else None


def _take_in(slicer: Slicer, kernels: dict[str, Piece]) -> None:
    """Fold the kernels that only a specialised formula calls."""
    for name, piece in slicer.pieces.items():
        if piece.kind != "formula" and name not in kernels:
            kernels[name] = piece
            _fold(slicer, [piece])


def _forms(pieces: Mapping[str, Piece]) -> dict[str, Any]:
    return {name: form(piece.node) for name, piece in pieces.items()}


def _fold(slicer: Slicer, pieces: Collection[Piece]) -> None:
    """Put the folded values into pieces, which must not bind their names to something else."""
    kept = slicer.kept_fields()
    fields = {name: value for name, value in slicer.folded.items() if name not in kept}
    refused: dict[tuple[str, str], str] = {}
    for piece in pieces:
        values = slicer.constants(piece)
        imported = {one for one, origin in piece.names.items() if isinstance(origin, External) and origin.name is None}
        modules = imported | set(MODULE_ALIASES.values())
        if isinstance(piece.node, ast.FunctionDef):
            for name, line in rebound(piece.node, values, fields, modules).items():
                refused[piece.name, name] = _refusal(slicer, piece, name, line)
            # What says a folded value again (eta = float(eta)) goes before its loads are replaced.
            piece.node = sweep(piece.node, bound_names(piece.node) & set(values), _pure(slicer.pieces))
        piece.node = fold(piece.node, values, fields, modules)
    if refused:
        raise DifferentValueError(next(iter(refused.values())), refused)


def _refusal(slicer: Slicer, piece: Piece, name: str, line: int) -> str:
    found = slicer.kernels.lookup(piece.file, piece.name)
    file = found.file if isinstance(found, Definition) else piece.file
    return (
        f"kernels/{file}.py:{line} ({piece.name}): '{name}' is bound to something else than the folded "
        f"{name} = {slicer.folded[name]}; an output must give that another name"
    )


_PURE = frozenset(
    ("float", "int", "abs", "min", "max", "sum", "len", "range", "tuple", "list", "zip", "mpf", "real", "isfinite")
    + ("sqrt", "exp", "log", "sin", "cos", "tan", "asin", "acos", "atan", "atan2", "floor", "ceil", "hypot")
)


def _pure(pieces: Mapping[str, Piece]) -> frozenset[str]:
    """Functions whose call can be left out with its result: kernels have no effects."""
    return _PURE | {name for name, piece in pieces.items() if piece.kind != "constant"}


def _round(piece: Piece, constant: Mapping[str, Any], pieces: Mapping[str, Piece]) -> None:
    """One round on one kernel piece."""
    for function in [n for n in walk(piece.node) if isinstance(n, ast.FunctionDef)] or [piece.node]:
        known = constant_locals(function) if isinstance(function, ast.FunctionDef) else {}
        fold_inside(function, known, constant, set(MODULE_ALIASES.values()))
    piece.node = prune(piece.node)
    _sweep(piece, pieces)


def _sweep(piece: Piece, pieces: Mapping[str, Piece]) -> None:
    """Remove assignments that folding has left unread; what the author left unread stays."""
    if not isinstance(piece.node, ast.FunctionDef):
        return
    names = [n for n in walk(piece.node) if isinstance(n, ast.Name)]
    loaded = {n.id for n in names if isinstance(n.ctx, ast.Load)}
    unread = ({n.id for n in names if isinstance(n.ctx, ast.Store)} - loaded) & piece.read
    if unread:
        piece.node = sweep(piece.node, unread, _pure(pieces))
        piece.node.body = piece.node.body or [ast.Pass()]


def _drop_unused(pieces: Mapping[str, Piece], roots: Sequence[str]) -> None:
    """Parameters that folding has left unread, where every use of the function is a plain call."""
    passed_on = _passed_on(pieces)
    drops: dict[str, tuple[str, ...]] = {}
    for name, piece in pieces.items():
        if piece.kind == "function" and name not in roots and name not in passed_on:
            loaded = {n.id for n in walk(piece.node) if isinstance(n, ast.Name) and isinstance(n.ctx, ast.Load)}
            gone = tuple(p for p in piece.parameters if p in piece.read and p not in loaded)
            if gone:
                drops[name] = gone
    if drops:
        drop_parameters(pieces, drops)


def _passed_on(pieces: Mapping[str, Piece]) -> set[str]:
    """Functions that are used otherwise than by a call with plain arguments."""
    found: set[str] = set()
    for piece in pieces.values():
        parts = walk(piece.node)
        called = {id(n.func) for n in parts if isinstance(n, ast.Call) and not _starred(n)}
        loads = (n for n in parts if isinstance(n, ast.Name) and isinstance(n.ctx, ast.Load))
        found |= {n.id for n in loads if id(n) not in called}
    return found


def _starred(node: ast.Call) -> bool:
    return any(isinstance(a, ast.Starred) for a in node.args) or any(k.arg is None for k in node.keywords)


def _checked(slicer: Slicer, names: list[str]) -> list[str]:
    """Refuse a slice that still calls what the load case does not have."""
    for name in names:
        lacking = [used for used in slicer.pieces[name].uses() if used in slicer.missing]
        if lacking:
            piece = slicer.pieces[name]
            place = f"kernels/{piece.file}.py ({name})"
            folded = ", ".join(f"{key} = {value}" for key, value in slicer.folded.items()) or "nothing"
            raise EmitError(
                f"{place} calls {', '.join(lacking)}, which the load case does not have, with {folded} folded; "
                "guard the call by a test that folding decides"
            )
    return names
