"""What an equilibrium carries for ``shape`` and other outputs: the fields that nothing reads leave with them."""

from __future__ import annotations

import ast
from collections.abc import Collection, Mapping

from derive.emit.backends import KNOWN_BY
from derive.emit.drop import drop_parameters
from derive.emit.pieces import Piece
from derive.emit.trees import walk


def drop_carried(pieces: Mapping[str, Piece], reached: Collection[str]) -> None:
    """Drop, in place, fields that a result only carries and that no reached piece reads."""
    read = {name for piece in reached for name in _read(pieces[piece].node)}
    drops = {
        name: tuple(field for field in pieces[name].parameters if field not in read | set(known))
        for name, known in KNOWN_BY.items()
        if name in reached
    }
    drops = {name: fields for name, fields in drops.items() if fields}
    if drops:
        drop_parameters(pieces, drops)


def _read(node: ast.AST) -> set[str]:
    """Attributes that are loaded, and keywords of calls of anything but the results themselves."""
    parts = walk(node)
    found = {n.attr for n in parts if isinstance(n, ast.Attribute) and isinstance(n.ctx, ast.Load)}
    for call in (n for n in parts if isinstance(n, ast.Call)):
        if not (isinstance(call.func, ast.Name) and call.func.id in KNOWN_BY):
            found |= {str(keyword.arg) for keyword in call.keywords}
    return found
