"""Slicing: from the outputs that a scene wants, everything they reach, and nothing else."""

from __future__ import annotations

import ast
from collections.abc import Iterable, Mapping
from dataclasses import replace

from sympy import Expr, nan, oo, zoo

from derive.emit.backends import EACH_FUNCTIONS, FORMULA_FILES, FUNCTIONS, MODULE_ALIASES, External
from derive.emit.errors import EmitError, choices
from derive.emit.formulas import base_name, specialise_formula
from derive.emit.kernel_files import Definition, KernelFiles
from derive.emit.layout import stamp
from derive.emit.pieces import Piece, bound_names, parameters_of
from derive.emit.printer import formula_function
from derive.emit.trees import Transformer, copied, walk
from derive.theory.claims import Formula


class Slicer:
    """Makes pieces on demand, each once, and finds which are reached."""

    def __init__(
        self,
        kernels: KernelFiles,
        formulas: Mapping[str, Formula],
        general: Mapping[str, tuple[str, ...]],
        folded: Mapping[str, Expr],
        *,
        common: bool = False,
        kept: Iterable[tuple[str, str]] = (),
    ) -> None:
        self.kernels, self.formulas, self.general, self.folded, self.common = kernels, formulas, general, folded, common
        self.pieces: dict[str, Piece] = {}
        self.kept = frozenset(kept)
        self.missing: set[str] = set()
        self.fixed: dict[str, dict[str, Expr]] = {}  # the arguments that every call of a formula gives as one value

    def piece(self, file: str, name: str, wanted_by: str) -> str | External:
        """The piece for ``name`` of a kernel file, made if need be: its final name, or where outside it comes from."""
        file, name = self.kernels.instance(file, name)
        if file in FORMULA_FILES:
            return self._formula(file, name)
        found = self.kernels.lookup(file, name)
        if found is None:
            raise EmitError(
                f"kernels/{file}.py has no '{name}', which {wanted_by} needs{choices(name, self._names(file))}"
            )
        if isinstance(found, External):
            return found
        known = self.pieces.get(name)
        if known and known.file != self.kernels.base(found.file):
            raise EmitError(f"kernels {known.file} and {found.file} both define '{name}'; rename one")
        return name if known else self._make(found)

    def _names(self, file: str) -> Iterable[str]:
        stems = [stem for stem in (file, f"{file}_{self.kernels.backend.name}") if stem in self.kernels.files]
        return [name for stem in stems for name in self.kernels.files[stem].definitions]

    def _formula(self, file: str, name: str) -> str:
        if base_name(file, name) not in self.formulas:
            self.missing.add(name)
            return name
        if name in self.pieces:
            return name
        piece = Piece(name, file, "formula", None)
        self.pieces[name] = piece
        formula = self.formula(name)
        piece.parameters = self.general.get(base_name(file, name), tuple(symbol.name for symbol in formula.arguments))
        self.fix_formula(name, {})
        return name

    def formula(self, name: str) -> Formula:
        """The formula of a piece as the theory gives it, under the piece's name."""
        return replace(self.formulas[base_name(self.pieces[name].file, name)], name=name)

    def constants(self, piece: Piece) -> dict[str, Expr]:
        """The folded constants that names in a piece stand for: all but parameters that are given something else.

        kept: such parameters and fields, (function or record, name). Where a record keeps a field, variables of its
        name that a function takes from somewhere are kept too.
        """
        own = {name for owner, name in self.kept if owner == piece.name}
        stored = {n.id for n in walk(piece.node) if isinstance(n, ast.Name) and isinstance(n.ctx, ast.Store)}
        own |= self.kept_fields() & (stored - set(piece.parameters)) if piece.kind != "class" else set()
        return {name: value for name, value in self.folded.items() if name not in own}

    def kept_fields(self) -> set[str]:
        """Fields that have the name of a folded constant, and are given something else."""
        return {name for owner, name in self.kept if owner in self.pieces and self.pieces[owner].kind == "class"}

    def is_finite(self, name: str, values: dict[str, Expr]) -> bool:
        """Whether the formula has a value there: −β/η has none for η = 0."""
        return not specialise_formula(self.formula(name), self.fixed.get(name, {}) | values).expression.has(
            zoo, nan, oo, -oo
        )

    def fix_formula(self, name: str, values: dict[str, Expr]) -> None:
        """Print a piece's formula anew, with further ``values`` for arguments that every call gives in the same way."""
        piece = self.pieces[name]
        self.fixed[name] = self.fixed.get(name, {}) | values
        piece.formula = specialise_formula(self.formula(name), self.fixed[name])
        _, elementwise = FORMULA_FILES[piece.file]
        piece.node = formula_function(piece.formula, common=self.common, elementwise=elementwise)
        piece.names = {}
        table = EACH_FUNCTIONS if elementwise else FUNCTIONS
        self._resolve(piece, {row[1]: row for row in table.values() if row[0]})

    def _make(self, found: Definition) -> str:
        kernel = self.kernels.files[found.file]
        node = copied(found.node)
        stamp(node)
        piece = Piece(found.name, self.kernels.base(found.file), found.kind, node, kernel.lines)
        piece.parameters = parameters_of(node)
        loads = [n for n in walk(node) if isinstance(n, ast.Name)]
        piece.read = frozenset(n.id for n in loads if isinstance(n.ctx, ast.Load))
        self.pieces[found.name] = piece
        names = {n.id for n in loads}
        origins = {name: origin for name in names if (origin := self.kernels.origin(found.file, name))}
        self._resolve(piece, origins)
        return found.name

    def _resolve(self, piece: Piece, origins: Mapping[str, tuple[str, str] | External]) -> None:
        """Give every global name of ``piece`` its final form, making the pieces that it names."""
        shadowed = bound_names(piece.node)
        final: dict[str, str | External] = {}
        for node in walk(piece.node):
            if isinstance(node, ast.Name) and node.id not in shadowed and node.id not in final:
                origin = origins.get(node.id) or self.kernels.backend.builtins.get(node.id)
                if origin:
                    target = origin if isinstance(origin, External) else self.piece(*origin, piece.name)
                    final[node.id] = self._plain(target) if isinstance(target, External) else target
        _Renamer(final).visit(piece.node)
        for target in final.values():
            name = target if isinstance(target, str) else _written(target)
            piece.names[name] = target if isinstance(target, str) else _imported(target)

    def _plain(self, external: External) -> External:
        """The import without its alias, unless its own name means something else in a kernel, or in another module."""
        name = external.name
        taken = any(name in kernel.definitions for kernel in self.kernels.files.values())
        taken = taken or len(self.kernels.modules.get(name or "", ())) > 1
        return external if taken or name is None else External(external.module, name, name)

    def reach(self, roots: Iterable[str]) -> list[str]:
        """Names of the pieces that ``roots`` reach, what is needed before what needs it."""
        order: dict[str, None] = {}

        def visit(name: str) -> None:
            if name in self.missing and name not in self.pieces:
                return
            if name in order or name in active:
                return
            active.add(name)
            for used in self.pieces[name].uses():
                if isinstance(self.pieces[name].names[used], str):
                    visit(used)
            order[name] = None

        active: set[str] = set()
        for root in roots:
            visit(root)
        return list(order)


def _written(external: External) -> str:
    """The name that the text holds for ``external`` (the module's alias where it is qualified)."""
    return MODULE_ALIASES[external.module] if external.qualified else external.alias


def _imported(external: External) -> External:
    return External(external.module, None, MODULE_ALIASES[external.module]) if external.qualified else external


class _Renamer(Transformer):
    """Writes global names in their final form."""

    def __init__(self, final: Mapping[str, str | External]) -> None:
        self.final = final

    def visit_Name(self, node: ast.Name) -> ast.expr:
        target = self.final.get(node.id)
        if isinstance(target, str):
            node.id = target
        elif isinstance(target, External) and target.qualified:
            alias, attribute = target.qualified.split(".")
            place = {key: getattr(node, key) for key in ("lineno", "col_offset") if hasattr(node, key)}
            return ast.Attribute(ast.Name(alias, ast.Load(), **place), attribute, ast.Load(), **place)
        elif isinstance(target, External):
            node.id = target.alias
        return node
