"""The README's example prints what the README says."""

from __future__ import annotations

import importlib
import json
import re
import subprocess
import sys
from pathlib import Path

import pytest

from derive.cli import main

ROOT = Path(__file__).resolve().parent.parent
README = (ROOT / "README.md").read_text(encoding="utf-8")


def test_the_example_prints_what_is_written() -> None:
    code, printed = re.search(r"```python\n(.*?)```\s+```\n(.*?)```", README, re.DOTALL).groups()
    run = subprocess.run([sys.executable, "-c", code], cwd=ROOT, capture_output=True, text=True, check=True)
    assert run.stdout == printed


def test_every_file_named_is_there() -> None:
    for name in re.findall(r"\]\(([\w./-]+)\)", README) + re.findall(r"`(derive/[\w./]+)`", README):
        assert (ROOT / name).exists(), name


def test_the_tables_are_filled() -> None:
    for name in ("verdicts", "errata", "mutants", "errors"):
        table = README.split(f"<!-- {name} -->")[1].split(f"<!-- end {name} -->")[0]
        assert table.count("\n|") >= 3, f"run examples/readme_tables.py for the table of {name}"


@pytest.mark.long
def test_verdicts_and_errata_are_those_of_a_run(tmp_path: Path) -> None:
    sys.path.insert(0, str(ROOT / "examples"))
    try:
        tables = importlib.import_module("verdict_tables")
    finally:
        sys.path.pop(0)
    file = tmp_path / "found.json"
    assert main(["check", "--json", str(file)]) == 0
    result = json.loads(file.read_text())
    for lines in (tables.verdict_table(result), tables.errata_table(result)):
        assert "\n".join(lines) in README, "run examples/readme_tables.py"
