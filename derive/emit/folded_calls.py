"""Folded parameters leave formulas, signatures and calls: the first step of specialising."""

from __future__ import annotations

import ast
from collections.abc import Mapping

from sympy import Expr

from derive.emit.drop import drop_parameters
from derive.emit.errors import EmitError
from derive.emit.pieces import Piece
from derive.emit.slice import Slicer
from derive.emit.trees import walk
from derive.emit.values import value_of


def fix_formulas(slicer: Slicer) -> None:
    """Specialise formulas to the folded arguments that every call gives as they are."""
    for name, fixed in _fixed_arguments(slicer).items():
        if slicer.is_finite(name, fixed):
            slicer.fix_formula(name, fixed)
        else:
            slicer.missing.add(name)


def drop_folded(slicer: Slicer) -> None:
    """Drop folded parameters everywhere, and from formulas what they leave unread or their load case lacks."""
    pieces = slicer.pieces
    drop_parameters(pieces, {name: _unread(slicer, piece) for name, piece in pieces.items() if piece.formula})
    drops = {name: _drops(piece, slicer.constants(piece)) for name, piece in pieces.items()}
    drop_parameters(pieces, drops, slicer.constants, slicer.folded)
    _check_order(slicer)


def _drops(piece: Piece, folded: Mapping[str, Expr]) -> tuple[str, ...]:
    """Parameters of the general form that the piece loses: folded ones, and what its load case's formula lacks."""
    if piece.formula:
        kept = [symbol.name for symbol in piece.formula.arguments]
        extra = [name for name in kept if name not in piece.parameters]
        if extra:
            raise EmitError(
                f"formula '{piece.name}' of case '{piece.formula.case}' takes {extra}, which its general form "
                f"({', '.join(piece.parameters)}) lacks; kernels cannot call it"
            )
        return tuple(name for name in piece.parameters if name not in kept)
    keywords = [a.arg for a in piece.node.args.kwonlyargs] if isinstance(piece.node, ast.FunctionDef) else []
    return tuple(name for name in (*piece.parameters, *keywords) if name in folded)


def _unread(slicer: Slicer, piece: Piece) -> tuple[str, ...]:
    """Arguments of a formula that its fixed values leave unread, whatever calls give for them."""
    arguments = [] if piece.formula is None else [symbol.name for symbol in piece.formula.arguments]
    own = [symbol.name for symbol in slicer.formula(piece.name).arguments]
    return tuple(name for name in own if name not in arguments and name not in slicer.fixed.get(piece.name, {}))


def _fixed_arguments(slicer: Slicer) -> dict[str, dict[str, Expr]]:
    """For each formula, the folded arguments that every call gives as they are (not scaled, say)."""
    fixed = {
        name: {key: value for key, value in slicer.folded.items() if key in piece.parameters}
        for name, piece in slicer.pieces.items()
        if piece.formula
    }
    for piece in slicer.pieces.values():
        for call in (n for n in walk(piece.node) if isinstance(n, ast.Call)):
            name = call.func.id if isinstance(call.func, ast.Name) else ""
            if name in fixed:
                given = dict(zip(slicer.pieces[name].parameters, call.args, strict=False))
                given |= {str(k.arg): k.value for k in call.keywords}
                fixed[name] = {k: v for k, v in fixed[name].items() if k in given and value_of(given[k]) == v}
    return fixed


def _check_order(slicer: Slicer) -> None:
    """A formula's arguments must keep the order of its general form."""
    for piece in slicer.pieces.values():
        if piece.formula and tuple(s.name for s in piece.formula.arguments) != piece.parameters:
            raise EmitError(
                f"formula '{piece.name}' of case '{piece.formula.case}' must take {piece.parameters} in this order"
            )
