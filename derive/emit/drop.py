"""Dropping parameters: from signatures, from fields, from every call, by position and by keyword."""

from __future__ import annotations

import ast
import re
from collections.abc import Callable, Collection, Mapping
from typing import Any

from derive.emit.errors import DifferentValueError, EmitError
from derive.emit.pieces import Piece, bound_names
from derive.emit.trees import Transformer, walk
from derive.emit.values import value_of


def drop_parameters(
    pieces: Mapping[str, Piece],
    drops: Mapping[str, Collection[str]],
    everywhere: Callable[[Piece], Collection[str]] = lambda piece: (),
    folded: Mapping[str, Any] | None = None,
) -> None:
    """Drop ``drops[name]`` from each function or class and its calls, ``everywhere`` from methods and inner functions.

    folded: the values of folded parameters: an argument that is dropped for one of them must be that value, or
    DifferentValueError names all that are not. Positional arguments are matched against
    ``Piece.parameters``, which are brought up to date.
    """
    different: dict[tuple[str, str], str] = {}
    losing = {name for name, gone in drops.items() if gone}
    for piece in pieces.values():
        known = () if piece.kind == "formula" else everywhere(piece)
        if piece.kind != "formula" and (known or drops.get(piece.name) or _names_one_of(piece.node, losing)):
            _Definitions(piece, set(drops.get(piece.name, ())), set(known)).visit(piece.node)
            _Calls(piece, pieces, drops, known, folded or {}, different).visit(piece.node)
    if different:
        raise DifferentValueError(next(iter(different.values())), different)
    for name, gone in drops.items():
        pieces[name].parameters = tuple(p for p in pieces[name].parameters if p not in gone)


def _names_one_of(node: ast.AST, names: Collection[str]) -> bool:
    return any(isinstance(part, ast.Name) and part.id in names for part in walk(node))


class _Definitions(Transformer):
    """Removes parameters and fields from definitions."""

    def __init__(self, piece: Piece, own: set[str], everywhere: set[str]) -> None:
        self.piece, self.own, self.everywhere = piece, own, everywhere

    def visit_FunctionDef(self, node: ast.FunctionDef) -> ast.AST:
        gone = self.own | self.everywhere if node is self.piece.node else self.everywhere
        _remove(node.args, gone)
        _undescribe(node, gone)
        self.generic_visit(node)
        return node

    def visit_Lambda(self, node: ast.Lambda) -> ast.AST:
        _remove(node.args, self.everywhere)
        self.generic_visit(node)
        return node

    def visit_ClassDef(self, node: ast.ClassDef) -> ast.AST:
        gone = self.own | self.everywhere
        node.body = [line for line in node.body if not _declares(line, gone)] or [ast.Pass()]
        _undescribe(node, gone)
        self.generic_visit(node)
        return node


def _undescribe(node: ast.FunctionDef | ast.ClassDef, gone: Collection[str]) -> None:
    """Remove from a docstring what it says about names that are gone.

    Kernels describe a parameter or field on a line of its own, ``name: what it is``; lines indented deeper belong to
    it.
    """
    first = node.body[0]
    if not (isinstance(first, ast.Expr) and isinstance(first.value, ast.Constant) and gone):
        return
    entry = re.compile(rf"^( *)(?:{'|'.join(map(re.escape, sorted(gone)))}): .*(?:\n\1 +\S.*)*\n", re.MULTILINE)
    text = str(first.value.value)
    found = entry.sub("", text)
    if found != text:
        first.value = ast.Constant(found)


def _declares(line: ast.stmt, names: Collection[str]) -> bool:
    return isinstance(line, ast.AnnAssign) and isinstance(line.target, ast.Name) and line.target.id in names


def _remove(arguments: ast.arguments, gone: Collection[str]) -> None:
    """Remove parameters with their defaults."""
    positional = [*arguments.posonlyargs, *arguments.args]
    defaults = [None] * (len(positional) - len(arguments.defaults)) + list(arguments.defaults)
    kept = [(arg, default) for arg, default in zip(positional, defaults, strict=True) if arg.arg not in gone]
    only = sum(arg.arg not in gone for arg in arguments.posonlyargs)
    arguments.posonlyargs = [arg for arg, _ in kept[:only]]
    arguments.args = [arg for arg, _ in kept[only:]]
    arguments.defaults = [default for _, default in kept if default is not None]
    pairs = zip(arguments.kwonlyargs, arguments.kw_defaults, strict=True)
    rest = [(arg, default) for arg, default in pairs if arg.arg not in gone]
    arguments.kwonlyargs, arguments.kw_defaults = [a for a, _ in rest], [d for _, d in rest]


class _Calls(Transformer):
    """Removes arguments from calls."""

    def __init__(
        self,
        piece: Piece,
        pieces: Mapping[str, Piece],
        drops: Mapping[str, Collection[str]],
        everywhere: Collection[str],
        folded: Mapping[str, Any],
        different: dict[tuple[str, str], str],
    ) -> None:
        self.piece, self.pieces, self.drops, self.everywhere = piece, pieces, drops, everywhere
        self.folded, self.different = folded, different
        parts = walk(piece.node)
        self.bound = bound_names(piece.node, parts)  # what a local name hides
        self.inner = {
            node.name: tuple(a.arg for a in node.args.args)
            for node in parts
            if isinstance(node, ast.FunctionDef) and node is not piece.node
        }

    def error(self, node: ast.AST, message: str) -> EmitError:
        return EmitError(f"kernels/{self.piece.file}.py:{getattr(node, 'lineno', 0)} ({self.piece.name}): {message}")

    def visit_Call(self, node: ast.Call) -> ast.AST:
        skip = 0
        func: ast.expr = node.func
        if isinstance(func, ast.Name) and func.id == "partial" and node.args:
            func, skip = node.args[0], 1
        if isinstance(func, ast.Name) and func.id in self.pieces:
            self._remove(node, func.id, self.pieces[func.id].parameters, self.drops.get(func.id, ()), skip)
        elif isinstance(func, ast.Name) and func.id in self.inner:
            self._remove(node, "", self.inner[func.id], self.everywhere, skip)
        else:
            node.keywords = [k for k in node.keywords if k.arg not in self.everywhere]
        node.args = [self.visit(argument) if not _named(argument, func) else argument for argument in node.args]
        node.keywords = [ast.copy_location(ast.keyword(k.arg, self.visit(k.value)), k) for k in node.keywords]
        if not isinstance(node.func, ast.Name):
            node.func = self.visit(node.func)
        return node

    def _remove(
        self, node: ast.Call, callee: str, parameters: tuple[str, ...], gone: Collection[str], skip: int
    ) -> None:
        if not gone:
            return
        first, rest = node.args[:skip], node.args[skip:]
        positions = {index for index, name in enumerate(parameters) if name in gone}
        starred = next((index for index, argument in enumerate(rest) if isinstance(argument, ast.Starred)), len(rest))
        only = rest[0] if len(rest) == 1 and all(k.arg and k.arg not in gone for k in node.keywords) else None
        if isinstance(only, ast.Starred) and isinstance(only.value, ast.Name):
            return  # f(*rod): the tuple has lost the same members, or the run of the module fails
        if starred < len(rest) and any(index >= starred for index in positions):
            raise self.error(node, f"a call with *arguments hides which of {sorted(gone)} to drop; write them out")
        given = [(name, argument) for name, argument in zip(parameters, rest, strict=False)]
        for name, argument in [*given, *((str(k.arg), k.value) for k in node.keywords)]:
            if name in gone and name in self.folded and value_of(argument) != self.folded[name]:
                text = f"gives '{name}' something else than the folded {name} = {self.folded[name]}"
                error = self.error(node, f"{text}; give that parameter or field of the kernel another name")
                if not callee or self.pieces[callee].formula:
                    raise error
                self.different.setdefault((callee, name), str(error))
        node.args = first + [argument for index, argument in enumerate(rest) if index not in positions]
        node.keywords = [k for k in node.keywords if k.arg not in gone]

    def visit_Name(self, node: ast.Name) -> ast.AST:
        target = self.pieces.get(node.id) if node.id not in self.bound else None
        if isinstance(node.ctx, ast.Load) and target and target.kind != "class" and self.drops.get(node.id):
            message = (
                f"'{node.id}' loses {sorted(self.drops[node.id])} and is passed on as a value; call it in a lambda"
            )
            raise self.error(node, message)
        return node


def _named(argument: ast.expr, func: ast.expr) -> bool:
    return argument is func
