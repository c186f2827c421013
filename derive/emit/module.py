"""A scene and a theory in, the text of a module out."""

from __future__ import annotations

import ast
import hashlib
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from typing import Any

from derive.emit.backends import ARRAY_INSTANCES, BACKENDS
from derive.emit.committed import instance_text
from derive.emit.errors import DifferentValueError, EmitError
from derive.emit.formulas import formulas_of, kernel_formulas, spelled
from derive.emit.head import case_text, domain_text, export_lines, fill, import_lines, public_names
from derive.emit.instances import instances as make_instances
from derive.emit.kernel_files import KernelFiles, read_kernels
from derive.emit.layout import lines_of
from derive.emit.lower import DIGITS, lower
from derive.emit.pieces import Piece, imports, sections
from derive.emit.records import RECORD, as_records
from derive.emit.render import render
from derive.emit.scene import GENERAL_CASE, Scene
from derive.emit.slice import Slicer
from derive.emit.specialise import specialise
from derive.emit.written_out import write_out
from derive.theory.claims import Formula


@dataclass(frozen=True)
class EmittedModule:
    """A module to write.

    name: without ``.py``. text: the whole of it. scene, backend: what it was emitted for. formulas: those it evaluates,
    specialised. digest: sha256 of all that it was made from. left_out: definitions it does without.
    """

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


def emit_module(
    theory: Any,
    scene: Scene,
    backend: str,
    *,
    kernels: Mapping[str, str] | None = None,
    instances: Mapping[str, str] | None = None,
    formulas: Mapping[str, Formula] | None = None,
    common: bool = False,
) -> EmittedModule:
    """The module for ``scene`` on ``backend``; unproved (see ``proof``). EmitError where it cannot be emitted.

    theory: what ``derive_all`` gives. kernels: the kernel files by stem. instances: those that have an array instance,
    and its stem. formulas: those to use by name, else those of the load case, and for any field angle where it has
    none. common: name repeated subexpressions.
    """
    sources = read_kernels() if kernels is None else dict(kernels)
    if instances is None:
        instances = {stem: name for stem, name in ARRAY_INSTANCES.items() if kernels is None or stem in kernels}
    sources |= {stem: instance_text(made) for stem, made in make_instances(sources, instances).items()}
    known = KernelFiles(sources, backend, instances)
    formulas = formulas_of(theory, GENERAL_CASE, scene.case) if formulas is None else formulas
    if not formulas:
        raise EmitError(
            f"the theory has no formulas for case '{scene.case}' of scene '{scene.name}'; derive them first"
        )
    general = {name: tuple(s.name for s in f.arguments) for name, f in kernel_formulas(theory).items()}
    slicer, names = _specialised(
        lambda kept: Slicer(known, formulas, general, scene.folded, common=common, kept=kept), scene, backend
    )
    as_records(names, slicer.pieces)
    if not BACKENDS[backend].exact:
        write_out(names, slicer.pieces)
    lower(names, slicer.pieces, backend, scene.functions)
    names = slicer.reach(scene.functions)
    used = tuple(piece.formula for name in names if (piece := slicer.pieces[name]).formula)
    digest = _digest(scene, backend, used, [slicer.pieces[name] for name in names], sources)
    text = render("module.py.jinja", _context(scene, backend, slicer.pieces, names, used, digest))
    left_out = tuple(sorted({*slicer.pieces, *formulas} - set(names)))
    return EmittedModule(f"{scene.name}_{backend}", text, scene, backend, used, digest, left_out)


def _specialised(
    make: Callable[[set[tuple[str, str]]], Slicer], scene: Scene, backend: str
) -> tuple[Slicer, list[str]]:
    """The pieces of a scene, specialised, and the names of those reached.

    A parameter or field with the name of a folded constant is taken for it; where a call gives it something else (a
    length in other units, say) it is kept, and all is done again.
    """
    kept: set[tuple[str, str]] = set()
    while True:
        slicer = make(kept)
        public = _begin(slicer, scene)
        if BACKENDS[backend].exact:
            slicer.piece(*DIGITS, f"scene '{scene.name}'")
        if RECORD[0] in slicer.kernels.files:
            slicer.piece(*RECORD, f"scene '{scene.name}'")
        try:
            return slicer, specialise(slicer, scene.functions)
        except DifferentValueError as error:
            if error.pairs <= kept or error.pairs & public:
                raise
            kept |= error.pairs


def _begin(slicer: Slicer, scene: Scene) -> set[tuple[str, str]]:
    """Make the pieces that a scene reaches. The parameters of its outputs, which cannot be kept: (function, name)."""
    public: set[tuple[str, str]] = set()
    for name in scene.functions:
        if not isinstance(slicer.piece("api", name, f"scene '{scene.name}'"), str):
            raise EmitError(f"kernels/api.py only imports '{name}'; define it there")
        node = slicer.pieces[name].node
        if isinstance(node, ast.FunctionDef):
            public |= {(name, one.arg) for one in (*node.args.args, *node.args.kwonlyargs)}
    return public


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
        "outputs": ", ".join(scene.functions),
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
    parts += map(spelled, formulas)
    for file in files:
        parts += [sources[stem] for stem in (file, f"{file}_{backend}") if stem in sources]
    return hashlib.sha256("\n".join(parts).encode()).hexdigest()
