"""Kernel files that are emitted themselves: formulas, and array instances, for kernels to import as they stand."""

from __future__ import annotations

import ast
import hashlib
from collections.abc import Iterable, Mapping
from typing import Any

from sympy.core.function import Function

from derive.emit.backends import ARRAY_INSTANCES, EACH, EACH_FUNCTIONS, FORMULAS, FUNCTIONS
from derive.emit.errors import EmitError
from derive.emit.formulas import kernel_formulas, spelled
from derive.emit.head import from_import
from derive.emit.instances import Instance, instances
from derive.emit.kernel_files import read_kernels
from derive.emit.layout import lines_of
from derive.emit.printer import formula_function
from derive.emit.render import render
from derive.theory.claims import Formula


def emit_kernels(
    theory: Any, kernels: Mapping[str, str] | None = None, marked: Mapping[str, str] = ARRAY_INSTANCES
) -> dict[str, str]:
    """The text of every kernel file that is emitted, by its name."""
    sources = read_kernels() if kernels is None else dict(kernels)
    texts = {stem: formulas_text(theory, elementwise=stem != FORMULAS[0]) for stem in FORMULAS}
    return texts | {stem: instance_text(made) for stem, made in instances(sources, marked).items()}


def formulas_text(theory: Any, *, elementwise: bool = False) -> str:
    """The formulas in their general form, on scalars, or those that have one in their form on arrays."""
    table = EACH_FUNCTIONS if elementwise else FUNCTIONS
    formulas = [f for f in kernel_formulas(theory).values() if not elementwise or _printable(f, table)]
    nodes = [formula_function(formula, elementwise=elementwise) for formula in formulas]
    for node in nodes:
        node.name += EACH if elementwise else ""
    context = {
        "elementwise": elementwise,
        "digest": _digest(map(spelled, formulas)),
        "imports": _imports(nodes, table),
        "functions": ["\n".join(lines_of(node, ())) for node in nodes],
    }
    return render("formulas.py.jinja", context)


def _printable(formula: Formula, table: Mapping[str, Any]) -> bool:
    return all(type(part).__name__ in table for part in formula.expression.atoms(Function))


def _imports(nodes: Iterable[ast.FunctionDef], table: Mapping[str, tuple[str, str]]) -> list[str]:
    called = {n.id for node in nodes for n in ast.walk(node) if isinstance(n, ast.Name)}
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
