"""The README's example prints what the README says."""

from __future__ import annotations

import importlib
import re
import subprocess
import sys
from pathlib import Path

import pytest

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


def test_a_table_that_is_not_of_the_run_is_seen(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.syspath_prepend(str(ROOT / "examples"))
    tables = importlib.import_module("verdict_tables")
    repair = {"latex": "a = b", "tried": 3, "changes": [["|b|", "b"]]}
    statement = {"verdict": "REFUTED", "printed": "a = |b|", "repair": repair}
    formula = {"id": "exsl1", "line": 9, "verdict": "REFUTED", "statements": [statement]}
    found = {"claims": {"PROVED": 2}, "formulas": [formula]}
    right = "\n".join([*tables.verdict_table(found), *tables.errata_table(found)])
    assert r"| exsl1 | 9 | `\|b\|` | `b` | 3 |" in right
    assert tables.differing(found, right) == []
    assert tables.differing(found, right.replace("| 3 |", "| 4 |")) == ["errata"]
    assert tables.differing({**found, "claims": {"PROVED": 1}}, right) == ["verdicts"]
