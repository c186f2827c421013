"""`derive emit --explain` as a user runs it."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from derive.cli import main
from derive.output import default_folder

TIPS = """[scene]
name = "tips"
case = "force_only"
outputs = ["equilibria"]
backends = ["numpy"]
[constants]
length = "80"
"""


@pytest.fixture
def scene(tmp_path: Path) -> Path:
    path = tmp_path / "tips.toml"
    path.write_text(TIPS, encoding="utf-8")
    return path


@pytest.mark.hours
def test_what_is_left_out_is_said_and_written(scene: Path, capsys: pytest.CaptureFixture[str]) -> None:
    before = {path: path.read_bytes() for path in default_folder().glob("*.py")}
    result = scene.parent / "result.json"
    assert main(["emit", "--explain", str(scene), "--jobs", "1", "--json", str(result)]) == 0
    said = capsys.readouterr().out
    assert "length = 80, folded by the scene" in said
    assert "eta = 0, folded by the load case" in said
    assert "left out, not wanted: output shape" in said
    assert {path: path.read_bytes() for path in default_folder().glob("*.py")} == before
    modules = json.loads(result.read_text(encoding="utf-8"))["modules"]
    assert [module["backend"] for module in modules] == ["numpy"]
    for module in modules:
        reasons = {(one["kind"], one["name"]): one["reason"] for one in module["absent"]}
        assert reasons["function", "sweep"] == "not wanted: output sweep"
        assert reasons["field", "Equilibrium.rod"] == "not wanted: output shape or literal"
        assert reasons["parameter", "equilibria(length)"] == "folded: length = 80"
        assert reasons["function", "oblique_landscape"] == "decided by eta = 0"
        for key in ("functions", "lines", "bytes"):
            assert 0 < module["size"][key] < module["full_size"][key]
        times = module["size"]["import_ms"]
        assert 0 < times["least"] <= times["median"] <= times["most"]
        assert "text" not in module


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (["paralell"], "no scene 'paralell'; did you mean 'parallel'? possible: bifurcation, field_only, "),
        (["nowhere.toml"], "nowhere.toml: cannot be read"),
        (["parallel", "--check"], "--explain writes no module"),
        (["parallel", "--out", "here"], "--explain writes no module"),
    ],
)
def test_mistakes_are_one_clear_line(arguments: list[str], words: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["emit", "--explain", *arguments]) == 2
    assert words in capsys.readouterr().err


def test_a_wrong_scene_is_named_before_any_work(scene: Path, capsys: pytest.CaptureFixture[str]) -> None:
    scene.write_text(TIPS.replace("force_only", "obliqe"), encoding="utf-8")
    assert main(["emit", "--explain", str(scene)]) == 2
    assert f"{scene}:3: unknown case 'obliqe'; did you mean 'oblique'?" in capsys.readouterr().err
