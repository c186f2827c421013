"""README and guides: the files that they name are there, and their tables are those of a run."""

from __future__ import annotations

import importlib
import re
from pathlib import Path
from types import ModuleType

import pytest
from pages import ROOT

GUIDES = [ROOT / "README.md", *sorted((ROOT / "docs").glob("*.md"))]


@pytest.fixture
def tables(monkeypatch: pytest.MonkeyPatch) -> ModuleType:
    monkeypatch.syspath_prepend(str(ROOT / "examples"))
    return importlib.import_module("verdict_tables")


@pytest.mark.parametrize("guide", GUIDES, ids=lambda guide: guide.stem)
def test_every_file_named_is_there(guide: Path) -> None:
    text = guide.read_text(encoding="utf-8")
    links = re.findall(r"\]\((?!https?:)([^)#]+)", text)
    for name in links:
        assert (guide.parent / name).exists(), name
    for name in re.findall(r"`((?:derive|docs|tests|examples|templates)/[\w./]+)`", text):
        assert (ROOT / name).exists(), name


def test_every_guide_is_found_from_the_index() -> None:
    index = (ROOT / "docs" / "index.md").read_text(encoding="utf-8")
    assert "(docs/index.md)" in (ROOT / "README.md").read_text(encoding="utf-8")
    for guide in GUIDES[1:]:
        assert guide.name == "index.md" or f"({guide.name})" in index, guide.name


def test_the_tables_are_filled(tables: ModuleType) -> None:
    for name in tables.PAGES:
        assert tables.table(name).count("\n|") >= 3, f"run examples/readme_tables.py for the table of {name}"


def test_a_table_is_put_where_it_stands(tables: ModuleType, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    page = tmp_path / "page.md"
    page.write_text("Above.\n<!-- hard -->\n| old |\n<!-- end hard -->\nBelow.\n", encoding="utf-8")
    monkeypatch.setitem(tables.PAGES, "hard", page)
    tables.put("hard", ["| new |", "| two |"])
    assert tables.table("hard") == "| new |\n| two |"
    assert page.read_text(encoding="utf-8").startswith("Above.\n<!-- hard -->\n| new |")
    monkeypatch.setitem(tables.PAGES, "measure", page)
    with pytest.raises(ValueError, match="no markers <!-- measure -->"):
        tables.put("measure", [])


def test_a_table_that_is_not_of_the_run_is_seen(tables: ModuleType) -> None:
    repair = {"latex": "a = b", "tried": 3, "changes": [["|b|", "b"]]}
    statement = {"verdict": "REFUTED", "printed": "a = |b|", "repair": repair}
    formula = {"id": "exsl1", "line": 9, "verdict": "REFUTED", "statements": [statement]}
    found = {"claims": {"PROVED": 2}, "formulas": [formula]}
    verdicts, errata = ("\n".join(table(found)) for table in (tables.verdict_table, tables.errata_table))
    right = {"verdicts": verdicts, "errata": errata}
    assert r"| exsl1 | 9 | `\|b\|` | `b` | 3 |" in errata
    assert tables.differing(found, right) == []
    assert tables.differing(found, {**right, "errata": errata.replace("| 3 |", "| 4 |")}) == ["errata"]
    assert tables.differing({**found, "claims": {"PROVED": 1}}, right) == ["verdicts"]


def test_the_table_of_scenes_has_the_sizes_of_the_modules(tables: ModuleType) -> None:
    scenes = importlib.import_module("scene_table")
    rows = [row for row in tables.table("scenes").splitlines() if row.startswith("| ") and row != scenes.HEAD]
    known = scenes.sizes(scenes.texts())
    assert len(rows) == 14
    assert [row[: len(one)] for row, one in zip(rows, known, strict=True)] == known, "run examples/scene_table.py"
