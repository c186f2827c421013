"""The commands: exit codes, one clear line for every mistake, nothing half-written."""

from __future__ import annotations

import json
import os
import re
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from derive import output
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
        (["measure", "--out", str(ROOT / "pyproject.toml")], "is no folder; choose another folder with --out"),
        (["all", "--jobs", "-1"], "--jobs must be at least 1"),
        (["all", "--out", str(ROOT / "pyproject.toml")], "is no folder; choose another folder with --out"),
        (["emit", "--out", str(ROOT / "pyproject.toml" / "below")], "is no folder; choose another folder with --out"),
    ],
    ids=lambda value: "-".join(value)[:40] if isinstance(value, list) else "",
)
def test_a_mistake_is_one_clear_line(arguments: list[str], words: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(arguments) == 2
    out, err = capsys.readouterr()
    assert words in err
    assert err.startswith(f"derive {arguments[0]}: ")
    assert all(line.startswith("    ") for line in err.splitlines()[1:])  # the place in a source, if there is one
    assert "Traceback" not in out + err


def test_a_misspelt_key_names_its_line(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    scene = tmp_path / "mine.toml"
    scene.write_text('[scene]\nname = "mine"\ncase = "parallel"\noutputs = ["equilibria"]\nbackend = ["numpy"]\n')
    assert main(["emit", str(scene), "--out", str(tmp_path / "out")]) == 2
    assert f"{scene}:5: unknown key 'backend' in [scene]; did you mean 'backends'?" in capsys.readouterr().err
    assert not (tmp_path / "out").exists()


@pytest.mark.parametrize(
    ("constant", "words"),
    [
        ('beta = "-1/2"', "beta = -1/2 lies outside its domain beta >= 0"),
        ('length = "-80"', "length = -80 lies outside its domain length > 0"),
        ('length = "nan"', "'nan' at character 1"),
        ("length = nan", "is not exact"),
        ('lenght = "80"', "did you mean 'length'?"),
    ],
)
def test_a_bad_constant_names_its_line(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], constant: str, words: str
) -> None:
    scene = tmp_path / "mine.toml"
    scene.write_text(f'[scene]\nname = "mine"\ncase = "parallel"\noutputs = ["equilibria"]\n[constants]\n{constant}\n')
    for command in (["emit", str(scene), "--out", str(tmp_path / "out")], ["solve", str(scene), *ROD]):
        assert main(command) == 2
        err = capsys.readouterr().err
        assert f"{scene}:6: " in err
        assert words in err
        assert err.count("\n") == 1
    assert sorted(path.name for path in tmp_path.iterdir()) == ["mine.toml"]


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (["bogus"], "derive: argument COMMAND: invalid choice: 'bogus'"),
        (["check", "--bogus"], "derive check: '--bogus' is nothing that it knows; 'derive check --help'"),
        (["solve", "--max-index", "x"], "derive solve: argument --max-index: invalid int value: 'x'; 'derive solve"),
        (["sweep"], "derive sweep: the following arguments are required: SCENE; 'derive sweep --help'"),
    ],
    ids=lambda value: "-".join(value) if isinstance(value, list) else "",
)
def test_usage_errors_are_one_line_too(arguments: list[str], words: str, capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit) as caught:
        main(arguments)
    assert caught.value.code == 2
    err = capsys.readouterr().err
    assert err.startswith(words)
    assert err.count("\n") == 1


@pytest.mark.parametrize(
    "command",
    [[], ["all"], ["check"], ["emit"], ["explain"], ["solve"], ["measure"], ["sweep"], ["figures"], ["report"]],
)
def test_every_command_has_help(command: list[str], capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit) as caught:
        main([*command, "--help"])
    assert caught.value.code == 0
    assert "usage: derive" in capsys.readouterr().out


def test_solve_finds_the_three_equilibria(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["solve", "parallel", *ROD, "--json", str(tmp_path / "found.json")]) == 0
    found = json.loads((tmp_path / "found.json").read_text())
    assert [one["index"] for one in found["equilibria"]] == [0, 0, 1]
    assert found["equilibria"][2]["tip_angle"] == pytest.approx(1.7656361110, abs=1e-9)
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


@pytest.mark.hours
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


@pytest.mark.hours
def test_the_same_bytes_from_an_empty_cache_and_another_seed(checkout: Path, tmp_path: Path) -> None:
    for seed in ("1", "2"):
        found = run(
            "emit",
            "--out",
            str(tmp_path / seed),
            cwd=checkout,
            PYTHONHASHSEED=seed,
            DERIVE_CACHE=str(tmp_path / f"c{seed}"),
        )
        assert found.returncode == 0, found.stderr
    assert len(contents(tmp_path / "1")) > 4
    assert contents(tmp_path / "1") == contents(tmp_path / "2") == contents(checkout / "generated")


@pytest.mark.long
def test_drift_is_shown_with_a_diff(checkout: Path) -> None:
    module = checkout / "generated" / "parallel_numpy.py"
    text = module.read_text()
    try:
        changed = text.replace("beta + ", "beta - ", 1)
        module.write_text(changed)
        found = run("emit", "--check", cwd=checkout)
        assert found.returncode == 1
        removed, added = (
            [line[1:] for line in found.stdout.splitlines() if line[0] == sign and line[1:3] != sign * 2]
            for sign in "-+"
        )
        assert "+++ emitted: parallel_numpy.py" in found.stdout
        assert len(removed) == len(added) == 1
        assert removed[0].replace("beta - ", "beta + ", 1) == added[0]
        assert module.read_text() == changed
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
def test_a_wrong_kernel_is_refused_and_nothing_is_written(checkout: Path) -> None:
    kernel, before = checkout / "derive" / "emit" / "kernels" / "equilibria.py", contents(checkout / "generated")
    text = kernel.read_text()
    assert text.count("else swings + 1") == 1
    try:
        kernel.write_text(text.replace("else swings + 1", "else swings"))
        found = run("emit", "parallel", cwd=checkout)
    finally:
        kernel.write_text(text)
    assert found.returncode == 1
    given, wanted = re.findall(r"parallel_numpy: index (\d+) instead of (\d+)", found.stderr)[0]
    assert int(given) == int(wanted) - 1
    assert "no module was written" in found.stderr
    assert contents(checkout / "generated") == before


def test_an_unwritable_folder_is_a_mistake(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "file").write_text("")
    for command in ("emit", "all"):
        assert main([command, "--out", str(tmp_path / "file" / "below")]) == 2
        assert "choose another folder with --out" in capsys.readouterr().err
    assert (tmp_path / "file").read_text() == ""


# Writing, by itself


def test_all_files_are_written_or_none(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    old, new = tmp_path / "old.py", tmp_path / "folder" / "new.py"
    output.write_all({old: "old\n"})
    replace, left = os.replace, [1]

    def full_after_one(source: str, target: str) -> None:
        if Path(target) == new and left.pop():
            raise OSError(28, "No space left on device")
        replace(source, target)

    monkeypatch.setattr(os, "replace", full_after_one)
    with pytest.raises(output.OutputError, match=r"No space left on device.*--out"):
        output.write_all({old: "changed\n", new: "new\n"})
    assert [path.name for path in tmp_path.rglob("*") if path.is_file()] == ["old.py"]
    assert old.read_text() == "old\n"


def test_a_file_that_cannot_be_prepared_changes_nothing(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    with pytest.raises(output.OutputError, match="--out"):
        output.write_all({tmp_path / "a.py": "a\n", tmp_path / "file" / "below" / "b.py": "b\n"})
    assert [path.name for path in tmp_path.iterdir()] == ["file"]


def test_only_what_differs_is_written(tmp_path: Path) -> None:
    files = {tmp_path / "a.py": "a\n", tmp_path / "b.py": "b\n"}
    assert output.write_all(files) == list(files)
    assert output.drift(files, tmp_path, complete=True) == []
    assert output.write_all({**files, tmp_path / "b.py": "c\n"}) == [tmp_path / "b.py"]


def test_drift_shows_missing_changed_and_stale_modules(tmp_path: Path) -> None:
    (tmp_path / "changed.py").write_text("one\ntwo")
    (tmp_path / "stale.py").write_text(f'"""{output.MARK} from a scene."""\n')
    (tmp_path / "own.py").write_text('"""Written by hand."""\n')
    files = {tmp_path / "changed.py": "one\nthree\n", tmp_path / "missing.py": "new\n"}
    lines = output.drift(files, tmp_path, complete=True)
    assert all(line.endswith("\n") for line in lines)
    text = "".join(lines)
    assert "--- on disk: changed.py\n+++ emitted: changed.py\n@@ -1,2 +1,2 @@\n one\n-two\n\\ No newline" in text
    assert "@@ -0,0 +1 @@\n+new\n" in text
    assert "+++ emitted by no scene: remove it\n" in text
    assert "own.py" not in text
    assert "stale.py" not in "".join(output.drift(files, tmp_path, complete=False))


def test_drift_shows_an_emitted_kernel_that_nothing_gives_any_more(tmp_path: Path) -> None:
    kernels, modules = tmp_path / "kernels", tmp_path / "modules"
    for folder in (kernels, modules):
        folder.mkdir()
    (kernels / "old_each.py").write_text(f'"""{output.MARK} from kernels/old.py."""\n')
    (kernels / "written.py").write_text('"""Written by hand."""\n')
    files = {modules / "a.py": "a\n", kernels / "formulas.py": "b\n"}
    output.write_all(files)
    text = "".join(output.drift(files, modules, complete=True))
    assert "--- on disk: old_each.py\n+++ emitted by no scene: remove it\n" in text
    assert "written.py" not in text
