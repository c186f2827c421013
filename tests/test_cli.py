"""The commands: exit codes, one clear line for every mistake, nothing half-written."""

from __future__ import annotations

import json
import os
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from derive.cli import main

ROOT = Path(__file__).resolve().parent.parent
ROD = ["--beta", "0.00035", "--eta", "0.00052", "--length", "80", "--clamp-angle", "3*pi/4"]


def run(*arguments: str, cwd: Path = ROOT, **environment: str) -> subprocess.CompletedProcess[str]:
    """The command in a process of its own."""
    command = [sys.executable, "-m", "derive", *arguments]
    return subprocess.run(command, cwd=cwd, capture_output=True, text=True, env={**os.environ, **environment})


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (["solve", "parallel", "--beta", "nan", *ROD[2:]], "--beta must be a finite number"),
        (["solve", "parallel", "--beta", "-1e-3", *ROD[2:]], "--beta must be at least 0"),
        (["solve", "parallel", *ROD[:5], "-80", *ROD[6:]], "--length must be positive"),
        (["solve", "parallel", *ROD[:5], "inf", *ROD[6:]], "--length must be a finite number"),
        (["solve", "parallel", *ROD[:7], "3*tau/4"], "character 3"),
        (["solve", "parallel", *ROD[:6]], "--clamp-angle is missing"),
        (["solve", "force_only", *ROD], "--eta is no parameter here"),
        (["solve", "paralel", *ROD], "no scene 'paralel'"),
        (["emit", "nowhere.toml"], "nowhere.toml: cannot be read"),
        (["check", "--only", "exsl99"], "no formula 'exsl99'"),
        (["check", "--paper", "nowhere.tex"], "nowhere.tex: cannot be read"),
        (["check", "--paper", str(ROOT / "pyproject.toml")], "no 'equation' environment"),
        (["all", "--jobs", "-1"], "--jobs must be at least 1"),
    ],
    ids=lambda value: "-".join(value)[:40] if isinstance(value, list) else "",
)
def test_a_mistake_is_one_clear_line(arguments: list[str], words: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(arguments) == 2
    out, err = capsys.readouterr()
    assert words in err
    assert err.startswith(f"derive {arguments[0]}: ")
    assert "Traceback" not in out + err


def test_a_misspelt_key_names_its_line(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    scene = tmp_path / "mine.toml"
    scene.write_text('[scene]\nname = "mine"\ncase = "parallel"\noutputs = ["equilibria"]\nbackend = ["numpy"]\n')
    assert main(["emit", str(scene), "--out", str(tmp_path / "out")]) == 2
    assert f"{scene}:5: unknown key 'backend' in [scene]; did you mean 'backends'?" in capsys.readouterr().err
    assert not (tmp_path / "out").exists()


@pytest.mark.parametrize("arguments", [["bogus"], ["check", "--bogus"], ["solve"]])
def test_usage_errors_exit_with_2(arguments: list[str], capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit) as caught:
        main(arguments)
    assert caught.value.code == 2
    assert "usage:" in capsys.readouterr().err


@pytest.mark.parametrize("command", [[], ["all"], ["check"], ["emit"], ["explain"], ["solve"]])
def test_every_command_has_help(command: list[str], capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit) as caught:
        main([*command, "--help"])
    assert caught.value.code == 0
    assert "usage: derive" in capsys.readouterr().out


def test_solve_finds_the_three_equilibria(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["solve", "parallel", *ROD, "--json", str(tmp_path / "found.json")]) == 0
    found = json.loads((tmp_path / "found.json").read_text())
    assert [one["index"] for one in found["equilibria"]] == [0, 1, 0]
    assert found["equilibria"][1]["tip_angle"] == pytest.approx(1.7656361110, abs=1e-9)
    assert "0.8339812667" in capsys.readouterr().out


def test_json_that_cannot_be_written_is_a_mistake(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "file").write_text("")
    assert main(["solve", "parallel", *ROD, "--json", str(tmp_path / "file" / "found.json")]) == 2
    assert "choose another file" in capsys.readouterr().err


def test_interrupt_ends_with_130_and_one_line(tmp_path: Path) -> None:
    command = [sys.executable, "-m", "derive", "--no-cache", "--out", str(tmp_path / "out")]
    process = subprocess.Popen(command, cwd=ROOT, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    time.sleep(3)
    process.send_signal(signal.SIGINT)
    out, err = process.communicate(timeout=60)
    assert process.returncode == 130
    assert "interrupted" in err
    assert "Traceback" not in out + err
    assert not (tmp_path / "out").exists()


@pytest.fixture(scope="module")
def checkout(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A copy of the project to break."""
    place = tmp_path_factory.mktemp("checkout")
    for name in ("derive", "templates", "generated"):
        shutil.copytree(ROOT / name, place / name, ignore=shutil.ignore_patterns("__pycache__"))
    shutil.copy(ROOT / "pyproject.toml", place)
    return place


FLIP = ("gamma + 2 * potential", "gamma - 2 * potential")


def contents(folder: Path) -> dict[str, bytes]:
    return {path.name: path.read_bytes() for path in sorted(folder.glob("*.py"))}


@pytest.mark.long
def test_the_main_job_and_its_cache(checkout: Path) -> None:
    before = contents(checkout / "generated")
    first = run("--json", "result.json", cwd=checkout, PYTHONHASHSEED="1")
    assert first.returncode == 0, first.stderr
    start = time.perf_counter()
    again = run(cwd=checkout, PYTHONHASHSEED="2")
    assert again.returncode == 0, again.stderr
    assert time.perf_counter() - start < 30  # no derivation: it would take longer on a busy machine, too
    assert contents(checkout / "generated") == before
    assert "2.4485976108" in again.stdout or "2.4485976109" in again.stdout
    assert json.loads((checkout / "result.json").read_text())["holds"] is True


@pytest.mark.long
def test_drift_is_shown_with_a_diff(checkout: Path) -> None:
    module = checkout / "generated" / "parallel_numpy.py"
    text = module.read_text()
    try:
        module.write_text(text.replace("beta + ", "beta - ", 1))
        found = run("emit", "--check", cwd=checkout)
        assert found.returncode == 1
        assert "+++ emitted: parallel_numpy.py" in found.stdout
        assert module.read_text() != text
    finally:
        module.write_text(text)
    assert run("emit", "--check", cwd=checkout, PYTHONHASHSEED="7").returncode == 0


@pytest.mark.long
def test_a_flipped_sign_is_named_with_a_counterexample(checkout: Path) -> None:
    script, before = checkout / "derive" / "theory" / "plane.py", contents(checkout / "generated")
    text = script.read_text()
    line = next(line for line in text.splitlines() if FLIP[0] in line)
    try:
        script.write_text(text.replace(line, line.replace(*FLIP), 1))
        found = run("all", cwd=checkout)
    finally:
        script.write_text(text)
    assert found.returncode == 1
    assert "REFUTED claim plane.first_integral" in found.stderr
    assert "counterexample: " in found.stderr
    assert contents(checkout / "generated") == before


@pytest.mark.long
def test_an_unwritable_folder_is_a_mistake(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    found = run("emit", "--out", str(tmp_path / "file" / "below"))
    assert found.returncode == 2
    assert "choose another folder with --out" in found.stderr
    assert (tmp_path / "file").read_text() == ""
