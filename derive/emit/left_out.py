"""What a module does without, and why: compared with the full module, which folds nothing and gives every output.

The reason is found by trying: modules are emitted for the outputs wanted with nothing folded, with one more output,
and with one constant folded at a time. What such a module still has, the step that was not taken took away.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import asdict, dataclass, replace
from typing import Any

from sympy import Expr

from derive.emit.backends import ARRAY_INSTANCES, BACKENDS
from derive.emit.contents import Item, Size, items, lacking, size
from derive.emit.errors import EmitError
from derive.emit.formulas import kernel_formulas
from derive.emit.kernel_files import KernelFiles, read_kernels
from derive.emit.module import EmittedModule, emit_module
from derive.emit.scene import CASES, GENERAL_CASE, OUTPUTS, Scene
from derive.emit.written_out import HELPERS


@dataclass(frozen=True)
class Absent:
    """Something that the full module or the kernels have and a module has not, and why."""

    kind: str
    name: str
    reason: str


@dataclass(frozen=True)
class Explanation:
    """A module, what is folded in it and by what, what it does without, and its size beside the full module's."""

    scene: str
    backend: str
    outputs: tuple[str, ...]
    folded: Mapping[str, Mapping[str, str]]
    absent: tuple[Absent, ...]
    size: Size
    full_size: Size
    text: str
    full_text: str

    def to_json(self) -> dict[str, Any]:
        """As plain data."""
        return asdict(self)


def explain_scene(
    theory: Any,
    scene: Scene,
    backend: str,
    *,
    kernels: Mapping[str, str] | None = None,
    instances: Mapping[str, str] = ARRAY_INSTANCES,
) -> Explanation:
    """What the module of a scene leaves out on a backend."""
    sources = read_kernels() if kernels is None else dict(kernels)
    module = emit_module(theory, scene, backend, kernels=sources, instances=instances)
    trials = _Trials(theory, scene, backend, sources, instances)
    full = trials.full()
    source = {name: "the load case" if name in CASES[scene.case] else "the scene" for name in scene.folded}
    folded = {name: {"value": str(value), "by": source[name]} for name, value in scene.folded.items()}
    absent = [Absent(*item, trials.reason(item)) for item in lacking(items(full.text), items(module.text))]
    absent += [Absent(*item, trials.unreached(item)) for item in _unreached(trials, full)]
    sizes = (size(module.text), size(full.text))
    return Explanation(
        scene.name, backend, scene.outputs, folded, tuple(absent), *sizes, text=module.text, full_text=full.text
    )


class _Trials:
    """Modules that take only some of the steps from the full module to a scene's, emitted when they are asked for."""

    def __init__(
        self, theory: Any, scene: Scene, backend: str, kernels: Mapping[str, str], instances: Mapping[str, str]
    ) -> None:
        self.theory, self.scene, self.backend = theory, scene, backend
        self.sources: dict[str, Any] = {"kernels": kernels, "instances": instances}
        self.files = KernelFiles(kernels, backend, instances)
        self.possible = tuple(output for output in OUTPUTS if self.files.lookup("api", output))
        self.known: dict[tuple[tuple[str, ...], tuple[str, ...]], set[Item] | None] = {}

    def full(self) -> EmittedModule:
        """The module that folds nothing and gives every output."""
        return self.emit(self.possible, {})

    def emit(self, outputs: tuple[str, ...], folded: Mapping[str, Expr]) -> EmittedModule:
        """A module of any field angle with some constants folded."""
        general = replace(self.scene, name="full", title="Any field angle, all outputs", case=GENERAL_CASE)
        scene = replace(general, outputs=outputs, constants=dict(folded))
        return emit_module(self.theory, scene, self.backend, formulas=kernel_formulas(self.theory), **self.sources)

    def has(self, item: Item, outputs: tuple[str, ...], folded: tuple[str, ...]) -> bool:
        """Whether such a module has the item; one that cannot be emitted is said to have everything."""
        key = (outputs, folded)
        if key not in self.known:
            try:
                text = self.emit(outputs, {name: self.scene.folded[name] for name in folded}).text
                self.known[key] = set(items(text))
            except EmitError:
                self.known[key] = None
        found = self.known[key]
        return found is None or item in found

    def unreached(self, item: Item) -> str:
        """Why not even the full module has an item."""
        if item[1] in HELPERS and not BACKENDS[self.backend].exact:
            return "what it computes stands in the place of its calls"
        return "no output reaches it"

    def reason(self, item: Item) -> str:
        """Why the scene's module does without an item that the full module has."""
        wanted, folded = self.scene.outputs, tuple(self.scene.folded)
        name = item[1].rstrip(")").replace("(", ".").split(".")[-1]
        if item[0] in ("parameter", "field") and name in folded:
            return f"folded: {self.value(name)}"
        if not self.has(item, wanted, ()):
            return self.unwanted(item)
        for one in folded:
            if not self.has(item, wanted, (one,)):
                return f"decided by {self.value(one)}"
        if not self.has(item, wanted, folded):
            return f"decided by {' and '.join(map(self.value, folded))} together"
        return f"the load case {self.scene.case} has formulas of its own that do without"

    def unwanted(self, item: Item) -> str:
        """Which output that is not wanted would bring the item."""
        wanted = self.scene.outputs
        others = [output for output in self.possible if output not in wanted]
        more = [o for o in others if self.has(item, tuple(p for p in OUTPUTS if p in (*wanted, o)), ())]
        return f"not wanted: output {' or '.join(more or others)}"

    def value(self, name: str) -> str:
        """A folded constant and its value."""
        return f"{name} = {self.scene.folded[name]}"


def _unreached(trials: _Trials, full: EmittedModule) -> list[Item]:
    """Definitions of the kernels and formulas of the theory that not even the full module has."""
    there = {name for _, name in items(full.text)}
    files = trials.files
    others = tuple(f"_{name}" for name in BACKENDS if name != trials.backend)
    defined = [
        (definition.kind, name)
        for stem in files.files
        for name, definition in files.files[stem].definitions.items()
        if not stem.endswith(others) and files.lookup(files.base(stem), name) is definition and name != "__all__"
    ]
    found = [*defined, *(("formula", name) for name in kernel_formulas(trials.theory))]
    return [item for item in dict.fromkeys(found) if item[1] not in there]
