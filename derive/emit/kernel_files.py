"""The kernels as syntax trees: what each file defines, and what every name in it means."""

from __future__ import annotations

import ast
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path

from derive.emit.backends import (
    ARRAY_INSTANCES,
    BACKENDS,
    EACH,
    FORMULA_FILES,
    FORMULAS,
    Backend,
    External,
)
from derive.emit.errors import EmitError
from derive.resources import kernels_folder

_PACKAGE = "derive.emit.kernels."


@dataclass(frozen=True)
class Definition:
    """A module-level function, class or constant of a kernel file."""

    name: str
    file: str
    kind: str
    node: ast.stmt


@dataclass
class KernelFile:
    """One parsed kernel file: its definitions, its imports, its text."""

    stem: str
    lines: tuple[str, ...]
    definitions: dict[str, Definition] = field(default_factory=dict)
    imports: dict[str, tuple[str, str] | External] = field(default_factory=dict)


def read_kernels(folder: Path | None = None) -> dict[str, str]:
    """The text of every kernel file by stem, without those that are emitted themselves."""
    paths = sorted((folder or kernels_folder()).glob("*.py"))
    emitted = ("__init__", *FORMULA_FILES, *ARRAY_INSTANCES.values())
    return {path.stem: path.read_text(encoding="utf-8") for path in paths if path.stem not in emitted}


def parse_kernel(stem: str, text: str) -> KernelFile:
    """Parse one kernel file; a statement that is neither definition, import nor docstring is an error."""
    try:
        tree = ast.parse(text)
    except SyntaxError as error:
        raise EmitError(f"kernels/{stem}.py:{error.lineno}: {error.msg}; mend the kernel") from error
    kernel = KernelFile(stem, tuple(text.splitlines()))
    for node in tree.body:
        if isinstance(node, (ast.Import, ast.ImportFrom)):
            kernel.imports.update(_imports(node, stem))
        elif isinstance(node, ast.If) and ast.unparse(node.test).endswith("TYPE_CHECKING"):
            for line in node.body:
                kernel.imports.update(_imports(line, stem))
        elif definition := _definition(node, stem):
            kernel.definitions[definition.name] = definition
        elif not (isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant)):
            raise EmitError(
                f"kernels/{stem}.py:{node.lineno}: kernels do no work when imported; move it into a function"
            )
    return kernel


def _imports(node: ast.stmt, stem: str) -> dict[str, tuple[str, str] | External]:
    found: dict[str, tuple[str, str] | External] = {}
    if isinstance(node, ast.Import):
        for alias in node.names:
            found[alias.asname or alias.name] = External(alias.name, None, alias.asname or alias.name)
    elif isinstance(node, ast.ImportFrom) and node.module != "__future__":
        for alias in node.names:
            local = alias.asname or alias.name
            module = node.module or ""
            if module.startswith(_PACKAGE):
                found[local] = (module.removeprefix(_PACKAGE), alias.name)
            elif module.startswith("derive") or node.level:
                raise EmitError(
                    f"kernels/{stem}.py:{node.lineno}: kernels import only kernels, NumPy, mpmath and stdlib"
                )
            else:
                found[local] = External(module, alias.name, local)
    return found


def _definition(node: ast.stmt, stem: str) -> Definition | None:
    if isinstance(node, ast.FunctionDef):
        return Definition(node.name, stem, "function", node)
    if isinstance(node, ast.ClassDef):
        return Definition(node.name, stem, "class", node)
    target: ast.expr | None = None
    if isinstance(node, ast.Assign) and len(node.targets) == 1:
        target = node.targets[0]
    elif isinstance(node, ast.AnnAssign) and node.value is not None:
        target = node.target
    return Definition(target.id, stem, "constant", node) if isinstance(target, ast.Name) else None


class KernelFiles:
    """All kernel files as one backend sees them; ``instances``: the files that have an array instance, and its name."""

    def __init__(
        self, sources: Mapping[str, str], backend: str, instances: Mapping[str, str] = ARRAY_INSTANCES
    ) -> None:
        self.backend: Backend = BACKENDS[backend]
        self.scalar = {file: stem for stem, file in {**instances, FORMULAS[0]: FORMULAS[1]}.items()}
        self.files = {stem: parse_kernel(stem, text) for stem, text in sorted(sources.items())}

        # From which modules each name is imported in this backend that is not written with its module.
        self.modules: dict[str, set[str]] = {}
        others = tuple(f"_{name}" for name in BACKENDS if name != backend)
        for stem in (stem for stem in self.files if not stem.endswith(others)):
            for local, origin in self.files[stem].imports.items():
                outside = isinstance(origin, External) and self.lookup(self.base(stem), local) == origin
                if isinstance(origin, External) and outside and origin.name and not origin.qualified:
                    self.modules.setdefault(origin.name, set()).add(origin.module)

    def instance(self, file: str, name: str) -> tuple[str, str]:
        """Where ``name`` of ``file`` is taken from: without arrays, an array instance is the scalar one."""
        if self.backend.elementwise or file not in self.scalar:
            return file, name
        return self.scalar[file], name.removesuffix(EACH)

    def lookup(self, file: str, name: str) -> Definition | External | None:
        """What ``name`` of kernel file ``file`` is; None if there is no such name."""
        stems = [stem for stem in (f"{file}_{self.backend.name}", file) if stem in self.files]
        for stem in stems:
            if name in self.files[stem].definitions:
                return self.files[stem].definitions[name]
            outside = self.files[stem].imports.get(name)
            if isinstance(outside, External):
                return outside
        for stem in stems:
            origin = self.files[stem].imports.get(name)
            if isinstance(origin, tuple) and origin[0] not in (file, stem):
                return self.lookup(*origin)
        return None

    def origin(self, stem: str, name: str) -> tuple[str, str] | External | None:
        """Where the global ``name`` of the file ``stem`` comes from: (kernel file, name), outside, or nowhere."""
        kernel = self.files[stem]
        if name in kernel.definitions:
            return (self.base(stem), name)
        return kernel.imports.get(name)

    def base(self, stem: str) -> str:
        """The file for which ``stem`` stands in: ``api`` for ``api_numpy``."""
        return stem.removesuffix(f"_{self.backend.name}")
