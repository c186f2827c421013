"""What the main job computes, one small task at a time, each kept under a hash of what it depends on.

A task is a name, its dependencies and a function that gives plain data. The functions import what they need when they
run: with every result at hand, neither SymPy nor the theory is loaded.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import asdict, dataclass
from functools import cache
from pathlib import Path
from typing import Any

from derive.cache import digest
from derive.resources import templates_folder

HERE = Path(__file__).resolve().parent
THEORY = (HERE / "theory",)
CHECK = (*THEORY, HERE / "check")
PRINTED = (*CHECK, HERE / "paper")
PAPER = (HERE / "paper",)
# Decimal digits to which folded constants are handed to the references: more than any of them works with.
EXACT = 120
# The derived forms; how the page and the figures look does not change them.
REPORT = (*PRINTED, *sorted((HERE / "report").glob("*.py")))
EMIT = (*CHECK, HERE / "emit", HERE / "resources.py")


@dataclass(frozen=True)
class Task:
    """One piece of work. run(*inputs) gives plain data; paths are the sources it depends on."""

    stage: str
    label: str
    run: Callable[..., Any]
    inputs: tuple[Any, ...]
    paths: tuple[Path, ...]

    @property
    def key(self) -> str:
        """The name of its result in the cache."""
        return digest(f"{self.stage} {self.run.__name__}", (*self.paths, Path(__file__)), list(self.inputs))


@cache
def derived() -> tuple[Any, Any, str]:
    """The theory (None if the derivation broke off), its notebook as far as it came, and why it broke off."""
    from derive.theory.chain import derive_all
    from derive.theory.claims import Notebook

    book = Notebook()
    try:
        return derive_all(book=book), book, ""
    except Exception as error:  # a broken derivation is judged as far as it came
        return None, book, f"{type(error).__name__}: {error}"


def theory() -> Any:
    """The whole theory; DerivationError if it broke off."""
    found, _, reason = derived()
    if found is None:
        raise DerivationError(f"the derivation breaks off: {reason}")
    return found


class DerivationError(Exception):
    """The derivation breaks off."""


def list_claims() -> dict[str, Any]:
    """All claims of the derivation, and where it broke off, if it did."""
    _, book, reason = derived()
    claims = [{"id": c.id, "title": c.title, "steps": list(c.steps), "source": c.source} for c in book.claims.values()]
    return {"claims": claims, "broken": reason}


def judge_claim(name: str) -> dict[str, Any]:
    """The verdict on one claim of the derivation."""
    from derive.check.judge import judge

    claim = derived()[1].claims[name]
    return {"title": claim.title, **plain(judge(claim))}


def list_printed(source: str) -> list[dict[str, Any]]:
    """The printed formulas that can be judged, as data; source is a LaTeX text, or empty for the ledger."""
    from derive.paper.ledger import from_source, load_ledger

    known = load_ledger()
    return [plain(record) for record in (from_source(source, known) if source else known).values()]


def judge_printed(record: dict[str, Any]) -> dict[str, Any]:
    """The verdict on one printed formula."""
    from derive.check.printed import judge_formulas
    from derive.paper.ledger import Record

    formula = Record(**{**record, "given": tuple(record["given"])})
    (verdict,) = judge_formulas(theory(), {formula.id: formula})
    return plain(verdict)


def derive_forms(record: dict[str, Any]) -> dict[str, Any]:
    """The derived forms of the statements of one printed formula; "failure" says which of them is wrong."""
    from derive.paper.errors import ReadError
    from derive.paper.ledger import Record
    from derive.report.derived import ReadBackError, derived_forms

    formula = Record(**{**record, "given": tuple(record["given"])})
    try:
        return {"statements": [plain(one) for one in derived_forms(theory(), formula)], "failure": ""}
    except ReadError:  # its verdict says so
        return {"statements": [], "failure": ""}
    except ReadBackError as error:
        return {"statements": [], "failure": str(error)}


def list_text() -> list[dict[str, Any]]:
    """The claims of the running text, as data."""
    from derive.paper.text_claims import load_claims

    return [claim.to_json() for claim in load_claims().values()]


def judge_text(claim: dict[str, Any]) -> dict[str, Any]:
    """The verdict on one claim of the running text."""
    from derive.check.text.judge import judge_text
    from derive.paper.text_claims import from_json

    return plain(judge_text(theory(), from_json(claim)))


def scene_text(path: Path) -> str:
    """The text of a scene file; what is wrong with the file is said when it is read as a scene."""
    try:
        return path.read_text(encoding="utf-8")
    except (OSError, UnicodeDecodeError):
        return ""


def read_scene(text: str, label: str) -> dict[str, Any]:
    """What a scene file says."""
    from derive.emit.scene import load_scene, parse_scene

    scene = parse_scene(text, label) if text else load_scene(Path(label))
    return {"name": scene.name, "backends": list(scene.backends), "parameters": list(scene.parameters)}


def emit(scene_text: str, label: str, backend: str) -> dict[str, Any]:
    """One module, printed, read back and proved; "failure" says why it must not be written, if it must not."""
    from derive.emit.errors import EmitError
    from derive.emit.module import emit_module
    from derive.emit.proof import prove_module
    from derive.emit.scene import parse_scene

    scene = parse_scene(scene_text, label)
    found = {
        "name": f"{scene.name}_{backend}",
        "case": scene.case,
        "folded": {name: str(value.evalf(EXACT)) for name, value in scene.folded.items()},
        "functions": list(scene.functions),
        "backend": backend,
    }
    try:
        module = emit_module(theory(), scene, backend)
        proof = [plain(formula) for formula in prove_module(module)]  # the module is run by `comparison.agree`
    except EmitError as error:
        return {**found, "failure": str(error), "text": "", "proof": []}
    return {**found, "failure": "", "text": module.text, "proof": proof, "left_out": list(module.left_out)}


def explain_scene(scene_text: str, label: str, backend: str) -> dict[str, Any]:
    """What a module leaves out and why, with its text and that of the full module."""
    from derive.emit.left_out import explain_scene
    from derive.emit.scene import parse_scene

    return plain(explain_scene(theory(), parse_scene(scene_text, label), backend))


def emit_kernels() -> dict[str, str]:
    """The text of the kernel files that are emitted: the kernels' own formulas, and array instances."""
    from derive.emit.committed import emit_kernels

    return emit_kernels(theory())


def plain(record: Any) -> dict[str, Any]:
    """A record as plain data."""
    return dict(record.to_json()) if hasattr(record, "to_json") else asdict(record)


def emission_paths() -> tuple[Path, ...]:
    """What an emitted module depends on besides its scene."""
    return (*EMIT, *sorted(templates_folder().glob("*.py.jinja")))
