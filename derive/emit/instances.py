"""Array instances of kernel files: the same code on NumPy arrays, written once on scalars.

In the instance of a file every name of ``arithmetic`` is taken from ``array_arithmetic`` (sqrt becomes each_sqrt), as
are the builtins abs, max and min; its functions, and those that it calls of other such files and of the formulas, get
the suffix ``_each``. Constants and classes are taken from the scalar file. A branch on an array fails when
it runs, as it must: such a kernel says ``where``.
"""

from __future__ import annotations

import ast
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field

from derive.emit.backends import ARRAY_INSTANCES, EACH, FORMULAS, SHARED, External
from derive.emit.errors import EmitError
from derive.emit.head import from_import
from derive.emit.kernel_files import Definition, KernelFile, parse_kernel
from derive.emit.layout import lines_of, stamp
from derive.emit.pieces import bound_names
from derive.emit.trees import copied, walk

_ARRAYS = "array_arithmetic"
_BUILTINS = ("abs", "max", "min")  # builtins that arithmetic uses as they are
_PREFIX = "each_"


@dataclass
class Instance:
    """An array instance: its definitions as text, and what it imports, (file, name) or from outside."""

    stem: str
    scalar: str
    definitions: list[str] = field(default_factory=list)
    imports: dict[str, tuple[str, str] | External] = field(default_factory=dict)

    def import_lines(self) -> list[list[str]]:
        """Import statements in groups: from outside, then from kernels."""
        outside = [e for e in self.imports.values() if isinstance(e, External)]
        groups = [list(_outside(outside)), []]
        files: dict[str, list[str]] = {}
        for origin in self.imports.values():
            if not isinstance(origin, External):
                files.setdefault(origin[0], []).append(origin[1])
        for file in sorted(files):
            names = sorted(set(files[file]), key=lambda name: (not name.isupper(), not name[0].isupper(), name))
            groups[1] += from_import(f"derive.emit.kernels.{file}", names)
        return [group for group in groups if group]


def _outside(found: list[External]) -> Iterator[str]:
    for external in sorted((e for e in found if e.name is None), key=lambda e: e.module):
        yield f"import {external.module}" + (f" as {external.alias}" if external.alias != external.module else "")
    for module in sorted({e.module for e in found if e.name}):
        yield from from_import(module, sorted(str(e.name) for e in found if e.module == module and e.name))


def instances(sources: Mapping[str, str], marked: Mapping[str, str] = ARRAY_INSTANCES) -> dict[str, Instance]:
    """The array instance of every marked kernel file, by its own name."""
    files = {stem: parse_kernel(stem, text) for stem, text in sources.items() if stem in (*marked, _ARRAYS)}
    lacking = sorted(set(marked) - set(files))
    if lacking:
        raise EmitError(f"kernels/{lacking[0]}.py is to have an array instance, and is not there")
    return {name: _Maker(files, marked, stem).instance() for stem, name in marked.items()}


class _Maker:
    """Makes the instance of one file."""

    def __init__(self, files: Mapping[str, KernelFile], marked: Mapping[str, str], stem: str) -> None:
        self.files, self.marked, self.kernel = files, marked, files[stem]
        arrays = files.get(_ARRAYS)
        self.elementwise = {*arrays.definitions, *arrays.imports} if arrays else set()
        self.result = Instance(marked[stem], stem)

    def instance(self) -> Instance:
        """The whole instance."""
        for definition in self.kernel.definitions.values():
            if isinstance(definition.node, ast.FunctionDef):
                self.result.definitions.append("\n".join(self.lines(definition)))
        return self.result

    def lines(self, definition: Definition) -> list[str]:
        """One definition, renamed, with the names that it uses imported."""
        node = copied(definition.node)
        stamp(node)
        names = {n.id for n in walk(node) if isinstance(n, ast.Name)} - bound_names(node)
        used = {name: self.target(name, node) for name in sorted(names)}
        renamed = {name: target for name, target in used.items() if target}
        for inner in walk(node):
            if isinstance(inner, ast.Name) and inner.id in renamed:
                inner.id = renamed[inner.id]
        if isinstance(node, ast.FunctionDef):
            node.name += EACH
        return lines_of(node, self.kernel.lines)

    def target(self, name: str, node: ast.stmt) -> str:
        """What the instance calls a global name of the scalar file; what it imports for it is recorded."""
        own = self.kernel.definitions.get(name)
        if own and isinstance(own.node, ast.FunctionDef):
            return name + EACH
        if own:
            return self.take(self.result.scalar, name)
        origin = self.kernel.imports.get(name)
        if origin is None:
            return self.array_name(name, node) if name in _BUILTINS else ""
        if isinstance(origin, External):
            self.result.imports[name] = origin
            return ""
        return self.imported(*origin, node)

    def imported(self, file: str, name: str, node: ast.stmt) -> str:
        """The counterpart of a name that the scalar file imports from a kernel file."""
        if file == "arithmetic":
            return self.take("arithmetic", name) if name in SHARED else self.array_name(name, node)
        if file == FORMULAS[0]:
            return self.take(FORMULAS[1], name + EACH)
        there = self.files[file].definitions.get(name) if file in self.marked else None
        if there and isinstance(there.node, ast.FunctionDef):
            return self.take(self.marked[file], name + EACH)
        return self.take(file, name)

    def array_name(self, name: str, node: ast.stmt) -> str:
        """The elementwise counterpart of a name of ``arithmetic``."""
        for candidate in (_PREFIX + name, name):
            if candidate in self.elementwise:
                return self.take(_ARRAYS, candidate)
        place = f"kernels/{self.result.scalar}.py:{node.lineno} ({getattr(node, 'name', '')})"
        raise EmitError(f"{place} uses {name}, which has no array form; add {_PREFIX}{name} to kernels/{_ARRAYS}.py")

    def take(self, file: str, name: str) -> str:
        """Import ``name`` from a kernel file."""
        self.result.imports[name] = (file, name)
        return name
