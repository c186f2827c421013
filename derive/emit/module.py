"""A scene and a theory in, the text of a module out."""

from __future__ import annotations

import ast
import hashlib
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import Any

from sympy import srepr

from derive.emit.backends import BACKENDS, FUNCTIONS
from derive.emit.errors import EmitError
from derive.emit.head import case_text, domain_text, export_lines, fill, from_import, import_lines, public_names
from derive.emit.kernel_files import KernelFiles, read_kernels
from derive.emit.layout import lines_of
from derive.emit.lower import lower
from derive.emit.pieces import Piece, imports, sections
from derive.emit.printer import formula_function
from derive.emit.render import render
from derive.emit.scene import Scene
from derive.emit.slice import Slicer
from derive.emit.specialise import specialise
from derive.theory.claims import Formula

GENERAL_CASE = "oblique"  # the load case whose formulas have every argument; kernels call them in that form


@dataclass(frozen=True)
class EmittedModule:
    """A module to write. ``formulas``: those it evaluates, specialised; ``left_out``: definitions it does without."""

    name: str
    text: str
    scene: Scene
    backend: str
    formulas: tuple[Formula, ...]
    digest: str
    left_out: tuple[str, ...]

    @property
    def path(self) -> str:
        """The file's name inside the output folder."""
        return f"{self.name}.py"


def formulas_of(theory: Any, case: str) -> dict[str, Formula]:
    """The formulas of a load case by name; they must be unique."""
    found: dict[str, Formula] = {}
    for formula in theory.formulas:
        if formula.case == case:
            if formula.name in found:
                raise EmitError(f"the theory has two formulas '{formula.name}' for case '{case}'")
            found[formula.name] = formula
    return found


def emit_module(
    theory: Any, scene: Scene, backend: str, *, kernels: Mapping[str, str] | None = None, common: bool = False
) -> EmittedModule:
    """The module for ``scene`` on ``backend``; unproved (see ``proof``). ``common`` names repeated subexpressions."""
    sources = read_kernels() if kernels is None else dict(kernels)
    known = KernelFiles(sources, backend)
    formulas = formulas_of(theory, scene.case)
    if not formulas:
        raise EmitError(
            f"the theory has no formulas for case '{scene.case}' of scene '{scene.name}'; derive them first"
        )
    general = {f.name: tuple(s.name for s in f.arguments) for f in kernel_formulas(theory)}
    slicer = Slicer(known, formulas, general, scene.folded, common=common)
    for output in scene.outputs:
        if not isinstance(slicer.piece("api", output, f"scene '{scene.name}'"), str):
            raise EmitError(f"kernels/api.py only imports '{output}'; define it there")
    names = specialise(slicer, scene.outputs)
    lower(names, slicer.pieces, backend, scene.outputs)
    names = slicer.reach(scene.outputs)
    used = tuple(piece.formula for name in names if (piece := slicer.pieces[name]).formula)
    digest = _digest(scene, backend, used, [slicer.pieces[name] for name in names], sources)
    text = render("module.py.jinja", _context(scene, backend, slicer.pieces, names, used, digest))
    left_out = tuple(sorted({*slicer.pieces, *formulas} - set(names)))
    return EmittedModule(f"{scene.name}_{backend}", text, scene, backend, used, digest, left_out)


def _context(
    scene: Scene, backend: str, pieces: Mapping[str, Piece], names: list[str], used: Iterable[Formula], digest: str
) -> dict[str, Any]:
    """What the template needs, all of it text or lists of text."""
    twin = BACKENDS[backend]
    return {
        "title": scene.title,
        "arithmetic": twin.title,
        "scene": scene.name,
        "case": case_text(scene),
        "outputs": ", ".join(scene.outputs),
        "domain": domain_text(scene),
        "folded": ", ".join(f"{name} = {value}" for name, value in scene.constants.items()),
        "claims": fill(sorted({f"{f.name} ({f.source})" if f.source else f.name for f in used})),
        "digest": digest,
        "imports": import_lines(imports(names, pieces), twin.packages),
        "exports": export_lines(public_names(scene, pieces, names)),
        "sections": [
            (title, ["\n".join(lines_of(p.node, p.lines)) for p in members], _tight(members))
            for title, members in sections(names, pieces)
        ],
    }


def _tight(members: list[Piece]) -> bool:
    """Constants stand on lines next to each other."""
    return all(piece.kind == "constant" for piece in members)


def _digest(
    scene: Scene, backend: str, formulas: Iterable[Formula], pieces: Iterable[Piece], sources: Mapping[str, str]
) -> str:
    """sha256 of the scene, the formulas used and the kernel files used."""
    files = sorted({piece.file for piece in pieces})
    parts = [scene.canonical(), backend]
    parts += [f"{f.name}({', '.join(map(str, f.arguments))}) = {srepr(f.expression)}" for f in formulas]
    for file in files:
        parts += [sources[stem] for stem in (file, f"{file}_{backend}") if stem in sources]
    return hashlib.sha256("\n".join(parts).encode()).hexdigest()


def kernel_formulas(theory: Any, family: str = "") -> list[Formula]:
    """The formulas that kernels import as they stand, of one family or all: those of the general case.

    Of the article's own formulas, those that the general case does not have are taken from the first case that has.
    """
    found = dict(formulas_of(theory, GENERAL_CASE))
    for formula in theory.formulas:
        if formula.family == "article":
            found.setdefault(formula.name, formula)
    return [formula for formula in found.values() if family in ("", formula.family)]


def emit_kernel_formulas(theory: Any, family: str = "solver") -> str:
    """The text of ``kernels/formulas.py``, or of the file of another family (a key of FORMULA_FILES)."""
    formulas = kernel_formulas(theory, family)
    if not formulas:
        raise EmitError(f"the theory has no {family} formulas for case '{GENERAL_CASE}'; derive them first")
    nodes = [formula_function(formula) for formula in formulas]
    called = {n.id for node in nodes for n in ast.walk(node) if isinstance(n, ast.Name)}
    modules: dict[str, set[str]] = {}
    for file, name in FUNCTIONS.values():
        if name in called:
            modules.setdefault(file, set()).add(name)
    lines = [
        line for file in sorted(modules) for line in from_import(f"derive.emit.kernels.{file}", sorted(modules[file]))
    ]
    parts = [GENERAL_CASE, *(f"{f.name}({', '.join(map(str, f.arguments))}) = {srepr(f.expression)}" for f in formulas)]
    title = f"The formulas of the load case '{GENERAL_CASE}' as the theory derives them, nothing folded."
    if family == "article":
        title = f"The article's own formulas for the load case '{GENERAL_CASE}', and those that only another case has."
    context = {
        "title": title,
        "digest": hashlib.sha256("\n".join(parts).encode()).hexdigest(),
        "imports": lines,
        "functions": ["\n".join(lines_of(node, ())) for node in nodes],
    }
    return render("formulas.py.jinja", context)
