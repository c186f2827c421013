"""Pieces: what an emitted module is made of, and what each reaches.

A *piece* is one module-level thing of the module to be: a private copy of a kernel's syntax tree in which every global
name has its final form, or the function printed from a formula.
"""

from __future__ import annotations

import ast
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from typing import Any

from derive.emit.backends import FILE_SECTIONS, RESULTS, SECTIONS, External
from derive.emit.trees import walk
from derive.theory.claims import Formula


@dataclass
class Piece:
    """One module-level definition. ``parameters`` are those of the kernel's general form, before anything is folded."""

    name: str
    file: str
    kind: str
    node: Any  # the syntax tree
    lines: tuple[str, ...] = ()
    names: dict[str, str | External] = field(default_factory=dict)
    formula: Formula | None = None
    parameters: tuple[str, ...] = ()
    read: frozenset[str] = frozenset()

    @property
    def section(self) -> str:
        """The section of the module to which it belongs."""
        if self.kind == "constant":
            return "constants"
        if self.name in RESULTS:
            return "interface"
        # A class stands after its base, which is the solver's.
        return "solver" if isinstance(self.node, ast.ClassDef) else FILE_SECTIONS.get(self.file, "solver")

    def uses(self) -> list[str]:
        """The global names that it loads now, each once, in the order of the source."""
        parts = walk(self.node)
        loads = [n for n in parts if isinstance(n, ast.Name) and n.id in self.names]
        loads.sort(key=lambda n: (getattr(n, "lineno", 0), getattr(n, "col_offset", 0)))
        shadowed = bound_names(self.node, parts)
        return list(dict.fromkeys(n.id for n in loads if n.id not in shadowed))


def bound_names(node: ast.AST, parts: Iterable[ast.AST] | None = None) -> set[str]:
    """Names that a function binds: parameters, assignments, loop variables, nested definitions. None for a constant.

    parts: all nodes of it, where they are known.
    """
    if not isinstance(node, (ast.FunctionDef, ast.ClassDef)):
        return set()
    found: set[str] = set()
    for part in walk(node) if parts is None else parts:
        if isinstance(part, ast.Name):
            if isinstance(part.ctx, ast.Store):
                found.add(part.id)
        elif isinstance(part, ast.arg):
            found.add(part.arg)
        elif isinstance(part, ast.ExceptHandler | ast.FunctionDef) and part is not node:
            found |= {part.name} if part.name else set()
    return found


def parameters_of(node: ast.stmt) -> tuple[str, ...]:
    """Positional parameters of a function, or the fields by which a class is built."""
    if isinstance(node, ast.FunctionDef):
        return tuple(a.arg for a in (*node.args.posonlyargs, *node.args.args))
    if isinstance(node, ast.ClassDef):
        for line in node.body:
            if isinstance(line, ast.FunctionDef) and line.name == "__init__":
                return parameters_of(line)[1:]
        return tuple(n.target.id for n in node.body if isinstance(n, ast.AnnAssign) and isinstance(n.target, ast.Name))
    return ()


def sections(names: Iterable[str], pieces: Mapping[str, Piece]) -> list[tuple[str, list[Piece]]]:
    """The pieces in the sections of a module, empty sections left out."""
    ordered = [pieces[name] for name in names]
    grouped = [(title, [p for p in ordered if p.section == key]) for key, title in SECTIONS.items()]
    return [(title, members) for title, members in grouped if members]


def imports(names: Iterable[str], pieces: Mapping[str, Piece]) -> list[External]:
    """What the named pieces import from outside, each once."""
    found = {
        origin
        for name in names
        for used in pieces[name].uses()
        if isinstance(origin := pieces[name].names[used], External)
    }
    return sorted(found, key=lambda e: (e.module, e.name or "", e.alias))
