"""Kernel files that are emitted themselves: formulas, and array instances, for kernels to import as they stand."""

from __future__ import annotations

import ast
import hashlib
from collections.abc import Collection, Iterable, Mapping
from dataclasses import replace
from typing import Any

from derive.emit.backends import ARRAY_INSTANCES, EACH, EACH_FUNCTIONS, FORMULA_FILES, FORMULAS, FUNCTIONS
from derive.emit.errors import EmitError, choices
from derive.emit.formulas import kernel_formulas, spelled
from derive.emit.head import from_import
from derive.emit.instances import Instance, instances
from derive.emit.kernel_files import parse_kernel, read_kernels
from derive.emit.layout import lines_of
from derive.emit.printer import formula_function
from derive.emit.render import render
from derive.emit.trees import walk

_TITLES = {
    "solver": "The formulas as the theory derives them, nothing folded",
    "article": "The article's own formulas, of the first load case that has them",
}


def emit_kernels(
    theory: Any, kernels: Mapping[str, str] | None = None, marked: Mapping[str, str] = ARRAY_INSTANCES
) -> dict[str, str]:
    """The text of every kernel file that is emitted, by its name."""
    sources = read_kernels() if kernels is None else dict(kernels)
    texts = {stem: instance_text(made) for stem, made in instances(sources, marked).items()}
    wanted = imported_formulas(sources | texts)
    return texts | {stem: formulas_text(theory, stem, names) for stem, names in wanted.items()}


def imported_formulas(sources: Mapping[str, str]) -> dict[str, set[str]]:
    """The names that kernels import from each file of formulas, where they import any."""
    found: dict[str, set[str]] = {}
    for stem, text in sources.items():
        for origin in parse_kernel(stem, text).imports.values():
            if isinstance(origin, tuple) and origin[0] in FORMULA_FILES:
                found.setdefault(origin[0], set()).add(origin[1])
    return found


def formulas_text(theory: Any, stem: str = FORMULAS[0], names: Collection[str] | None = None) -> str:
    """The text of a file of formulas in their general form: those of the given names there, or all of its family."""
    family, elementwise = FORMULA_FILES[stem]
    suffix, table = EACH if stem == FORMULAS[1] else "", EACH_FUNCTIONS if elementwise else FUNCTIONS
    known = {name + suffix: f for name, f in kernel_formulas(theory).items() if f.family == family}
    lacking = sorted(set(names or ()) - set(known))
    if lacking:
        raise EmitError(f"the theory has no formula '{lacking[0]}', which a kernel imports{choices(lacking[0], known)}")
    chosen = {name: formula for name, formula in known.items() if names is None or name in names}
    nodes = [formula_function(replace(f, name=name), elementwise=elementwise) for name, f in chosen.items()]
    context = {
        "title": _TITLES[family] + (", on arrays." if stem == FORMULAS[1] else "."),
        "digest": _digest(map(spelled, chosen.values())),
        "imports": _imports(nodes, table),
        "functions": ["\n".join(lines_of(node, ())) for node in nodes],
    }
    return render("formulas.py.jinja", context)


def _imports(nodes: Iterable[ast.FunctionDef], table: Mapping[str, tuple[str, str]]) -> list[str]:
    called = {n.id for node in nodes for n in walk(node) if isinstance(n, ast.Name)}
    files: dict[str, set[str]] = {}
    for file, name in table.values():
        if file and name in called:
            files.setdefault(file, set()).add(name)
    return [line for file in sorted(files) for line in from_import(f"derive.emit.kernels.{file}", sorted(files[file]))]


def instance_text(made: Instance) -> str:
    """The text of an array instance."""
    if not made.definitions:
        raise EmitError(f"kernels/{made.scalar}.py defines nothing that an array instance could hold")
    context = {
        "scalar": made.scalar,
        "digest": _digest(made.definitions),
        "imports": made.import_lines(),
        "definitions": made.definitions,
    }
    return render("kernel_instance.py.jinja", context)


def _digest(parts: Iterable[str]) -> str:
    return hashlib.sha256("\n".join(parts).encode()).hexdigest()
