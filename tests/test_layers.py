"""Imports run one way; emitted modules stand alone. Read from the syntax trees, so lazy imports count too."""

from __future__ import annotations

import ast
import re
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parent.parent
# A layer may import itself and those of a lower rank. Neither theory nor paper may import the other.
RANK = {
    "resources": 0,
    "cache": 0,
    "theory": 1,
    "paper": 1,
    "check": 2,
    "emit": 3,
    "measure": 4,
    "diagrams": 5,
    "report": 6,
    "stages": 7,
    "output": 7,
    "numbers": 4,
    "options": 4,
    "grounds": 7,
    "pdf": 8,
    "runner": 8,
    "comparison": 8,
    "pipeline": 9,
    "own_energy": 9,
    "explain": 9,
    "page_job": 10,
    "show": 10,
    "commands": 11,
    "commands_check": 12,
    "commands_emit": 12,
    "commands_explain": 12,
    "commands_report": 13,
    "commands_solve": 13,
    "commands_sweep": 13,
    "commands_measure": 13,
    "commands_figures": 13,
    "cli": 14,
    "__main__": 15,
    "__init__": 15,
}
ALLOWED_IN_GENERATED = {"numpy", "mpmath"} | set(sys.stdlib_module_names)


def imports(path: Path, package: tuple[str, ...] = ()) -> set[str]:
    """Full names of all that a file imports, relative imports resolved against its package."""
    found: set[str] = set()
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Import):
            found.update(alias.name for alias in node.names)
        elif isinstance(node, ast.ImportFrom):
            base = package[: len(package) - node.level + 1] if node.level else ()
            origin = ".".join([*base, *([node.module] if node.module else [])])
            found.update(f"{origin}.{alias.name}" for alias in node.names)
    return found


def layer(dotted: str) -> str:
    parts = dotted.split(".")
    return parts[1] if len(parts) > 1 else "__init__"


def backward(path: Path, root: Path) -> list[str]:
    """Imports of a file that its layer may not have."""
    parts = path.relative_to(root).with_suffix("").parts
    own = layer(".".join(parts))
    wrong = []
    for name in imports(path, parts[:-1]):
        if name.split(".")[0] == "derive" and layer(name) != own:
            other = layer(name)
            if other not in RANK:
                continue  # a name of the package itself, such as its version
            if RANK[other] >= RANK[own] and other != "__init__":
                wrong.append(f"{'/'.join(parts)}.py ({own}) imports {name} ({other})")
        if name.split(".")[0] == "generated" and RANK[own] < RANK["measure"]:
            wrong.append(f"{'/'.join(parts)}.py ({own}) imports {name}")
    return wrong


FILES = sorted((ROOT / "derive").rglob("*.py"))


def test_every_part_has_a_rank() -> None:
    parts = {layer(".".join(path.relative_to(ROOT).with_suffix("").parts)) for path in FILES}
    assert parts <= set(RANK), "give the new part its rank in RANK"


def test_no_arrow_runs_back() -> None:
    assert [line for path in FILES for line in backward(path, ROOT)] == []


def test_a_backward_arrow_is_seen(tmp_path: Path) -> None:
    (tmp_path / "derive" / "theory").mkdir(parents=True)
    file = tmp_path / "derive" / "theory" / "quartic.py"
    for line in ("from derive.paper import ledger", "from ..check import judge", "import derive.emit.scene"):
        file.write_text(f"def lazy():\n    {line}\n")
        assert len(backward(file, tmp_path)) == 1, line
    file.write_text("from .symbols import beta\nfrom derive.resources import scenes_folder\n")
    assert backward(file, tmp_path) == []


REFERENCES = ("taylor", "reference", "scan", "counts", "folds", "fold_references", "exchanges", "exchange_references")
LONG_REFERENCES = ("segments", "rests", "chains", "guesses", "long_rods")


def test_references_share_nothing_with_the_solver() -> None:
    for name in (*REFERENCES, *LONG_REFERENCES):
        found = imports(ROOT / "derive" / "measure" / f"{name}.py")
        assert not [one for one in found if one.startswith(("derive.emit", "derive.theory", "generated", "sympy"))]


# Parts of docs/architecture.md that are about a folder; the rest of the package is in "the main job".
SECTIONS = ("theory", "paper", "check", "emit", "measure", "diagrams", "report", "own_energy")


@pytest.mark.parametrize("section", [*SECTIONS, "the main job"])
def test_every_module_has_its_place_in_the_architecture(section: str) -> None:
    """Named in the part about its folder; or its own folder is, with a slash behind it."""
    text = (ROOT / "docs" / "architecture.md").read_text(encoding="utf-8")
    (part,) = re.findall(rf"^## {section}$(.*?)(?=^## |\Z)", text, re.MULTILINE | re.DOTALL)
    named = {name.rpartition("/")[2] for name in re.findall(r"`([\w/]+)`", part)}
    folders = set(re.findall(r"`([\w/]+)/`", part)) | {"kernels"}  # which have their formulas' table
    starts = tuple(name.removesuffix("*") for name in re.findall(r"`(\w+\*)`", part))
    root = ROOT / "derive" / section if section in SECTIONS else ROOT / "derive"
    files = root.rglob("*.py") if section in SECTIONS else root.glob("*.py")
    unnamed = [
        path.relative_to(root).as_posix()
        for path in files
        if not path.stem.startswith("__")
        and path.stem not in named
        and path.parent.name not in folders
        and not (starts and path.stem.startswith(starts))
    ]
    assert unnamed == []


@pytest.mark.parametrize("path", sorted((ROOT / "generated").glob("*.py")), ids=lambda path: path.stem)
def test_emitted_modules_stand_alone(path: Path) -> None:
    assert {name.split(".")[0] for name in imports(path)} <= ALLOWED_IN_GENERATED


def test_an_emitted_module_loads_no_algebra() -> None:
    code = "import sys; from generated.parallel_numpy import equilibria; print(*sys.modules)"
    run = subprocess.run([sys.executable, "-c", code], cwd=ROOT, capture_output=True, text=True, check=True)
    assert not {"sympy", "jinja2", "lark", "mpmath", "derive"} & set(run.stdout.split())
