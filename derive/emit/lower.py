"""The last step before printing: exact values and literals in the arithmetic of the backend."""

from __future__ import annotations

import ast
import copy
from collections.abc import Iterable, Mapping
from inspect import cleandoc
from typing import Any

import sympy
from sympy import Rational

from derive.emit.backends import BACKENDS, Backend, External
from derive.emit.errors import EmitError
from derive.emit.pieces import Piece, bound_names
from derive.emit.printer import Printer
from derive.emit.trees import Transformer
from derive.emit.values import Exact

DIGITS = ("arguments", "digits")  # the kernel that says to how many digits a public function works
PRECISION = "dps: decimal digits to work with, from 15 to 1000; None for those of the caller, mp.dps."
_LONGEST_EXACT_DECIMAL = 12  # digits; 0.015625 is exact in both twins, 0.1 is not


def lower(names: Iterable[str], pieces: Mapping[str, Piece], backend: str, public: Iterable[str]) -> None:
    """Write folded values and numbers as the backend needs them, in place; give public mpmath functions ``dps``."""
    twin = BACKENDS[backend]
    names = list(names)
    _inline_constants([pieces[name] for name in names], computed=twin.exact)
    for name in names:
        piece = pieces[name]
        lowered = _Lower(twin)
        piece.node = lowered.visit(piece.node)
        piece.names.update(lowered.names)
    if twin.exact:
        for name in public:
            if isinstance(pieces[name].node, ast.FunctionDef):
                _with_precision(pieces[name])


class _Lower(Transformer):
    """Prints Exact nodes, and in an exact twin every number that a double does not hold."""

    def __init__(self, backend: Backend) -> None:
        self.backend = backend
        self.names: dict[str, str | External] = {}

    def visit_Exact(self, node: Exact) -> ast.expr:
        return ast.copy_location(self.number(node.value), node)

    def number(self, value: Any) -> ast.expr:
        """The tree of an exact number or truth value."""
        if value in (sympy.true, sympy.false):
            return ast.Constant(bool(value))
        if value.is_Rational and not self.backend.exact:
            return _double(value)
        if value.is_Rational:
            return _quotient(self._wrap(ast.Constant(abs(int(value.p)))), value)
        tree = Printer(()).print(value)
        if any(isinstance(n, ast.Name) and n.id == "pi" for n in ast.walk(tree)):
            module = self.backend.packages[0] if self.backend.exact else "math"
            self.names["pi"] = External(module, "pi", "pi")
        return self.visit(tree) if self.backend.exact else tree

    def _wrap(self, literal: ast.Constant) -> ast.expr:
        name = self.backend.number
        self.names[name] = External(self.backend.packages[0], name, name)
        return ast.Call(ast.Name(name, ast.Load()), [literal], [])

    def visit_FormattedValue(self, node: ast.FormattedValue) -> ast.expr:
        if isinstance(node.value, Exact):
            return ast.Constant(str(node.value.value))
        self.generic_visit(node)
        return node

    def visit_Constant(self, node: ast.Constant) -> ast.expr:
        if not self.backend.exact or not isinstance(node.value, float):
            return node
        if _is_exact(node.value):
            return node
        return ast.copy_location(self._wrap(ast.Constant(repr(node.value))), node)

    def visit_BinOp(self, node: ast.BinOp) -> ast.expr:
        self.generic_visit(node)
        left, right = node.left, node.right
        if self.backend.exact and isinstance(node.op, ast.Div) and isinstance(right, ast.Constant):
            node.left = self._wrap(left) if isinstance(left, ast.Constant) and isinstance(left.value, int) else left
        return node


def _is_exact(value: float) -> bool:
    """Whether the decimal that was written is the double that Python reads."""
    return Rational(str(value)) == Rational(value) and len(str(value)) <= _LONGEST_EXACT_DECIMAL


def _double(value: Rational) -> ast.expr:
    whole: ast.expr = ast.Constant(float(abs(value)))
    if Rational(str(float(value))) != value:
        whole = ast.BinOp(ast.Constant(abs(int(value.p))), ast.Div(), ast.Constant(int(value.q)))
    return ast.UnaryOp(ast.USub(), whole) if value < 0 else whole


def _quotient(top: ast.expr, value: Rational) -> ast.expr:
    tree = top if value.q == 1 else ast.BinOp(top, ast.Div(), ast.Constant(int(value.q)))
    return ast.UnaryOp(ast.USub(), tree) if value < 0 else tree


def _inline_constants(pieces: list[Piece], *, computed: bool) -> None:
    """Write constants where they are used: records, which stand further down in the module, and computed numbers.

    computed: also numbers, which the module would freeze at the precision of its import.
    """
    values: dict[str, ast.expr] = {}
    for piece in pieces:
        if piece.kind == "constant" and not _is_literal(piece.node.value) and (computed or _is_record(piece)):
            if not _is_scalar(piece.node.value):
                raise EmitError(
                    f"kernels/{piece.file}.py ({piece.name}): a constant that holds computed or inexact numbers cannot "
                    "follow the caller's precision; make it a function"
                )
            values[piece.name] = _Inline(values).visit(copy.deepcopy(piece.node.value))
    if not values:
        return
    origins = {name: origin for piece in pieces if piece.name in values for name, origin in piece.names.items()}
    for piece in pieces:
        if piece.name not in values and set(piece.uses()) & set(values):
            piece.node = _Inline({k: v for k, v in values.items() if k not in bound_names(piece.node)}).visit(
                piece.node
            )
            piece.names.update({name: origin for name, origin in origins.items() if name not in piece.names})


def _is_record(piece: Piece) -> bool:
    """Whether the constant is built by a class or function of the module."""
    calls = [n.func for n in ast.walk(piece.node.value) if isinstance(n, ast.Call)]
    return any(isinstance(one, ast.Name) and isinstance(piece.names.get(one.id), str) for one in calls)


def _is_literal(node: ast.AST) -> bool:
    if isinstance(node, ast.Constant):
        return not isinstance(node.value, float) or _is_exact(node.value)
    if isinstance(node, (ast.Tuple, ast.List)):
        return all(_is_literal(item) for item in node.elts)
    return isinstance(node, (ast.Name, ast.Subscript, ast.Attribute))  # a type alias


def _is_scalar(node: ast.AST) -> bool:
    return not any(isinstance(n, (ast.Tuple, ast.List, ast.Dict, ast.Set, ast.ListComp)) for n in ast.walk(node))


class _Inline(Transformer):
    def __init__(self, values: Mapping[str, ast.expr]) -> None:
        self.values = values

    def visit_Name(self, node: ast.Name) -> ast.expr:
        if isinstance(node.ctx, ast.Load) and node.id in self.values:
            return copy.deepcopy(self.values[node.id])
        return node


def _with_precision(piece: Piece) -> None:
    """Add ``dps``: decimal digits to work with; by default the caller's precision."""
    node = piece.node
    if any(a.arg == "dps" for a in (*node.args.args, *node.args.kwonlyargs)):
        return
    head = node.body[:1] if isinstance(node.body[0], ast.Expr) and isinstance(node.body[0].value, ast.Constant) else []
    context = ast.parse(f"workdps({DIGITS[1]}(dps))", mode="eval").body
    if head:
        head = [ast.Expr(ast.Constant(_with_argument(head[0].value.value, PRECISION)))]
    node.args.kwonlyargs.append(ast.arg("dps"))
    node.args.kw_defaults.append(ast.Constant(None))
    node.body = [*head, ast.With([ast.withitem(context)], node.body[len(head) :])]
    piece.names.update({"workdps": External("mpmath", "workdps", "workdps"), DIGITS[1]: DIGITS[1]})


def _with_argument(docstring: str, line: str) -> str:
    """A docstring with the line on one more argument: below those on the others, before the last paragraph."""
    paragraphs = cleandoc(docstring).split("\n\n")
    if len(paragraphs) > 2:  # a summary, the arguments, the rest
        paragraphs[-2] += f"\n{line}"
    else:
        paragraphs.insert(1, line)
    return "\n\n".join(paragraphs)
