"""Records: the NamedTuples of a module on a base of its own. Making their classes took most of the time of its import.

The kernels keep NamedTuple, which type checkers know. What is printed is a subclass of ``kernels/records.py: Record``,
whose values come as one tuple.
"""

from __future__ import annotations

import ast
import copy
from collections.abc import Iterable, Mapping

from derive.emit.errors import EmitError
from derive.emit.pieces import Piece
from derive.emit.trees import Transformer

RECORD = ("records", "Record")


def as_records(names: Iterable[str], pieces: Mapping[str, Piece]) -> None:
    """Make every NamedTuple among the pieces a record, in place, if there is a base for them, with calls to match."""
    if RECORD[1] not in pieces:
        return
    found = {name: piece for name in names if _is_named_tuple((piece := pieces[name]).node)}
    for piece in found.values():
        piece.node.bases = [ast.Name(RECORD[1], ast.Load())]
        if not all(isinstance(line, (ast.AnnAssign, ast.Expr)) for line in piece.node.body):
            raise EmitError(f"kernels/{piece.file}.py ({piece.name}): a record has no methods; make them functions")
        piece.node.body.insert(_is_described(piece.node), ast.parse("__slots__ = ()").body[0])
        piece.names[RECORD[1]] = RECORD[1]
    usual = {name: _without_defaults(piece.node) for name, piece in found.items()}
    for name in names:
        pieces[name].node = _Made(pieces[name], found, usual).visit(pieces[name].node)


def _is_named_tuple(node: ast.AST) -> bool:
    return isinstance(node, ast.ClassDef) and [ast.unparse(base) for base in node.bases] == ["NamedTuple"]


def _is_described(node: ast.ClassDef) -> bool:
    return isinstance(node.body[0], ast.Expr)


def _without_defaults(node: ast.ClassDef) -> dict[str, ast.expr]:
    """The defaults of a record's fields, which go into the calls."""
    defaults: dict[str, ast.expr] = {}
    for line in node.body:
        if isinstance(line, ast.AnnAssign) and line.value is not None:
            defaults[ast.unparse(line.target)], line.value = line.value, None
    return defaults


class _Made(Transformer):
    """Writes Point(x, y) as Point((x, y)), Point(*pair) as Point(pair), and type(point)(*pair) as type(point)(pair)."""

    def __init__(self, piece: Piece, records: Mapping[str, Piece], usual: Mapping[str, Mapping[str, ast.expr]]) -> None:
        self.piece, self.records, self.usual = piece, records, usual

    def visit_Call(self, node: ast.Call) -> ast.Call:
        self.generic_visit(node)
        lone = node.args[0] if len(node.args) == 1 and not node.keywords else None
        if isinstance(node.func, ast.Call) and isinstance(node.func.func, ast.Name) and node.func.func.id == "type":
            node.args = [lone.value] if isinstance(lone, ast.Starred) else node.args
        elif isinstance(node.func, ast.Name) and node.func.id in self.records:
            values = lone.value if isinstance(lone, ast.Starred) else ast.Tuple(self._values(node), ast.Load())
            node.args, node.keywords = [values], []
        return node

    def _values(self, node: ast.Call) -> list[ast.expr]:
        """The values in the order of the fields; EmitError if they are not one for each."""
        record = self.records[node.func.id]  # type: ignore[attr-defined]  # visit_Call has seen a Name
        fields, starred = record.parameters, any(isinstance(one, ast.Starred) for one in node.args)
        named = {str(keyword.arg): keyword.value for keyword in node.keywords}
        rest = () if starred else fields[len(node.args) :]
        usual = self.usual[record.name]
        named = {name: copy.deepcopy(usual[name]) for name in rest if name in usual} | named
        if set(named) != set(rest) or (not starred and len(node.args) > len(fields)):
            place = f"kernels/{self.piece.file}.py:{getattr(node, 'lineno', 0)} ({self.piece.name})"
            raise EmitError(f"{place}: {record.name} must be given each of {', '.join(fields)}, once")
        return [*node.args, *(named[name] for name in rest)]
