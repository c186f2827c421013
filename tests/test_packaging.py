"""The wheel: it holds templates and scenes, and works away from the checkout."""

from __future__ import annotations

import shutil
import subprocess
import sys
import tomllib
import venv
import zipfile
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parent.parent


def test_the_wheel_is_told_to_hold_templates_and_modules() -> None:
    target = tomllib.loads((ROOT / "pyproject.toml").read_text())["tool"]["hatch"]["build"]["targets"]["wheel"]
    assert target["packages"] == ["derive", "generated"]
    assert target["force-include"]["templates"] == "derive/templates"


@pytest.fixture(scope="module")
def wheel(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The wheel, built from a copy so that nothing is left in the checkout."""
    place = tmp_path_factory.mktemp("source")
    ignored = shutil.ignore_patterns(".*", "__pycache__", "build", "dist")
    shutil.copytree(ROOT, place / "project", ignore=ignored)
    command = [sys.executable, "-m", "pip", "wheel", "--quiet", "--no-deps", "-w", str(place), str(place / "project")]
    subprocess.run(command, check=True, timeout=600)
    (found,) = place.glob("*.whl")
    return found


@pytest.mark.long
def test_the_wheel_is_complete(wheel: Path) -> None:
    names = set(zipfile.ZipFile(wheel).namelist())
    data = [*(ROOT / "derive").rglob("*.toml"), *(ROOT / "derive").rglob("*.lark"), *(ROOT / "generated").glob("*.py")]
    assert {str(path.relative_to(ROOT)) for path in data} <= names
    assert {f"derive/templates/{path.name}" for path in (ROOT / "templates").glob("*.jinja")} <= names
    assert not [name for name in names if name.startswith(("tests/", "templates/", "examples/"))]


@pytest.mark.hours
def test_an_installed_wheel_emits_the_same_modules(wheel: Path, tmp_path: Path) -> None:
    venv.create(tmp_path / "venv", with_pip=True)
    binaries = tmp_path / "venv" / ("Scripts" if sys.platform == "win32" else "bin")
    subprocess.run([binaries / "python", "-m", "pip", "install", "--quiet", str(wheel)], check=True, timeout=900)
    subprocess.run([binaries / "derive", "emit", "--out", "modules"], cwd=tmp_path, check=True, timeout=600)
    for path in (ROOT / "generated").glob("*_*py.py"):
        assert (tmp_path / "modules" / path.name).read_text() == path.read_text()
