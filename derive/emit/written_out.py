"""Helpers of one expression that a module says in its own words: a call of one takes longer than what it computes.

Kernels choose by ``pick`` and ask by ``any_of`` so that they can stand on arrays too; on Python's own numbers that is a
conditional expression, and a plain test. A direction that is picked number by number is then one or the other.
"""

from __future__ import annotations

import ast
import copy
from collections import Counter
from collections.abc import Iterable, Mapping
from typing import Any

from derive.emit.pieces import Piece
from derive.emit.trees import Transformer

HELPERS = ("any_of", "epsilon", "larger", "pick", "spacing")
_FILE = "arithmetic"
_WHOLE = ("pick_rest", "rests")  # picks the numbers of a record one by one


def write_out(names: Iterable[str], pieces: Mapping[str, Piece]) -> None:
    """Put what the helpers compute in the place of their calls, in place."""
    known = {name: pieces[name] for name in HELPERS if name in pieces and pieces[name].file == _FILE}
    helpers = {name: piece.node for name, piece in known.items() if _expression(piece.node) is not None}
    name, file = _WHOLE
    if name in pieces and pieces[name].file == file and "pick" in helpers:
        helpers[name] = helpers["pick"]
    for name in names:
        if name not in helpers:
            pieces[name].node = _Writer(helpers).visit(pieces[name].node)


def _expression(function: ast.FunctionDef) -> ast.expr | None:
    """What a function returns, if that is all it does."""
    last = function.body[-1]
    described = len(function.body) == 2 and isinstance(function.body[0], ast.Expr)
    return last.value if isinstance(last, ast.Return) and (described or len(function.body) == 1) else None


class _Writer(Transformer):
    """Replaces calls; one that would have to say an argument of some length twice is left."""

    def __init__(self, helpers: Mapping[str, ast.FunctionDef]) -> None:
        self.helpers = helpers

    def visit_Call(self, node: ast.Call) -> ast.expr:
        self.generic_visit(node)
        helper = self.helpers.get(node.func.id) if isinstance(node.func, ast.Name) else None
        if helper is None or node.keywords or len(node.args) != len(helper.args.args):
            return node
        given = dict(zip((one.arg for one in helper.args.args), node.args, strict=True))
        body: Any = copy.deepcopy(_expression(helper))
        for part in ast.walk(body):  # else its lines would be taken for those of the file where the call stands
            ast.copy_location(part, node)
        times = Counter(n.id for n in ast.walk(body) if isinstance(n, ast.Name))
        if any(times[name] > 1 and not _is_short(argument) for name, argument in given.items()):
            return node
        return _Filler(given).visit(body)

    def visit_UnaryOp(self, node: ast.UnaryOp) -> ast.expr:
        """``not any_of(x != 0)`` as x == 0."""
        self.generic_visit(node)
        test = node.operand
        if isinstance(node.op, ast.Not) and isinstance(test, ast.Compare) and [*map(type, test.ops)] == [ast.NotEq]:
            return ast.copy_location(ast.Compare(test.left, [ast.Eq()], test.comparators), node)
        return node


def _is_short(node: ast.expr) -> bool:
    """A name, a field, or a number."""
    if isinstance(node, ast.UnaryOp):
        return _is_short(node.operand)
    if isinstance(node, ast.Attribute):
        return _is_short(node.value)
    return isinstance(node, (ast.Name, ast.Constant))


class _Filler(Transformer):
    """Puts arguments in the place of parameters."""

    def __init__(self, given: Mapping[str, ast.expr]) -> None:
        self.given = given

    def visit_Name(self, node: ast.Name) -> ast.expr:
        return copy.deepcopy(self.given.get(node.id, node))
