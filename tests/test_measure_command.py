"""`derive measure` as it is called: runs that are broken off, solvers that are spoilt, mistakes, files."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest
from altered import altered

from derive import commands_measure
from derive.cli import main
from derive.measure.bench import again, methods, precision
from derive.measure.bench.store import FILE
from generated import parallel_numpy

QUICK = ("measure", "--quick")
AGAIN = ("T2", "T6", "stability")  # T5 is run twice besides
KILLED = """
import os, signal
from derive import commands_measure
from derive.cli import main
from derive.measure.bench.store import Store

put = Store.put

def put_or_die(self, record):
    if len(self.records) == 4:
        with self.path.open("a") as stream:
            stream.write('{"key": "tasks/T5-p/')
            stream.flush()
            os.kill(os.getpid(), signal.SIGKILL)
    put(self, record)

Store.put = put_or_die
main(["measure", "--quick", "--only", "T5", "--out", "OUT"])
"""


def records(folder: Path) -> list[dict[str, Any]]:
    """What a run kept, after its head."""
    return [json.loads(line) for line in (folder / FILE).read_text(encoding="utf-8").splitlines()[1:]]


@pytest.mark.long
def test_a_run_that_was_killed_goes_on_and_errors_are_the_same_to_the_digit(tmp_path: Path) -> None:
    folder, other = tmp_path / "killed", tmp_path / "whole"
    code = KILLED.replace("OUT", folder.as_posix())
    assert subprocess.run([sys.executable, "-c", code], capture_output=True).returncode < 0
    assert not (folder / FILE).read_bytes().endswith(b"\n")
    before = (folder / FILE).read_text(encoding="utf-8").splitlines()[:-1]
    assert main([*QUICK, "--only", "T5", "--out", str(folder)]) == 0
    assert (folder / FILE).read_text(encoding="utf-8").splitlines()[: len(before)] == before
    assert main([*QUICK, "--only", "T5", "--out", str(other), "--json", str(other / "again.json")]) == 0
    errors = [[(record["key"], record["errors"]) for record in records(place)] for place in (folder, other)]
    assert errors[0] == errors[1]
    assert len(errors[0]) >= 7  # with python-flint there are more
    found = json.loads((other / "again.json").read_text(encoding="utf-8"))
    assert found["records"]["tasks"] == records(other)
    assert {"machine", "versions", "commit", "mode", "sources"} == set(found["about"])
    names = [f"T5-{kind}.{ending}" for kind in ("p", "zeta", "sigma") for ending in ("svg", "png")]
    assert sorted(path.name for path in other.iterdir()) == sorted(
        [FILE, "measure.json", "measure.md", "again.json", *names]
    )
    text = (other / "measure.md").read_text(encoding="utf-8")
    assert all(f"| {record['method']} | {record['setting']} |" in text for record in records(other))


def test_a_spoilt_solver_fails_and_is_named(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(methods, "FILES", ("emitted",))
    assert main([*QUICK, "--only", "T6"]) == 0
    whole = parallel_numpy.folds

    def spoilt(*loads: Any, **options: Any) -> list[Any]:
        return [altered(fold, eta=fold.eta * (1 + 1e-12)) for fold in whole(*loads, **options)]

    monkeypatch.setattr(parallel_numpy, "folds", spoilt)
    capsys.readouterr()
    assert main([*QUICK, "--only", "T6"]) == 1
    told = capsys.readouterr().err
    assert "derive measure: tasks/T6/emitted, NumPy/all in a range: error 1.0e-12 is beyond its limit 1e-13" in told

    def broken(*_: Any, **__: Any) -> list[Any]:
        raise ArithmeticError("no fold today")

    monkeypatch.setattr(parallel_numpy, "folds", broken)
    assert main([*QUICK, "--only", "T6"]) == 1
    assert "tasks/T6/emitted, NumPy/all in a range: ArithmeticError: no fold today" in capsys.readouterr().err


def test_formulas_that_cannot_be_emitted_are_a_finding(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """And the run goes on."""

    def refuse(name: str) -> Any:
        raise RuntimeError(f"{name} cannot be emitted today")

    monkeypatch.setattr(commands_measure, "literal_modules", lambda options: refuse)
    monkeypatch.setattr(methods, "FILES", ("emitted", "article"))
    assert main([*QUICK, "--only", "T1"]) == 1
    told = capsys.readouterr()
    assert "article, NumPy/γ and tip given: RuntimeError: literal_numpy cannot be emitted today" in told.err
    assert "emitted, NumPy" in told.out


def test_an_interrupted_run_says_how_to_go_on(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    def interrupt(*_: Any) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr(precision, "measure", interrupt)
    assert main([*QUICK, "--only", "V", "--out", str(tmp_path)]) == 130
    assert f"what was measured is in {tmp_path}; the same command goes on from there" in capsys.readouterr().err


def test_mistakes_are_one_line(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    def told(*more: str) -> str:
        assert main(["measure", *more]) == 2
        (line,) = capsys.readouterr().err.splitlines()
        return line

    assert "no such part; did you mean 'T4'? there are T1, T2" in told("--only", "t4")
    used = tmp_path / "file"
    used.write_text("text\n", encoding="utf-8")
    assert "choose another folder with --out" in told("--out", str(used))
    (tmp_path / FILE).write_text("text\n", encoding="utf-8")
    assert "holds no records of a run" in told("--out", str(tmp_path))
    head = {"mode": "quick", "machine": {}, "versions": {}, "sources": ""}
    (tmp_path / FILE).write_text(json.dumps(head) + "\n", encoding="utf-8")
    assert "belongs to a run with another mode (quick there, full now)" in told("--out", str(tmp_path))


@pytest.mark.long
def test_the_quick_run_holds(tmp_path: Path) -> None:
    """Every method on every task, growth, tables and pictures; some once more, with the same errors to the digit."""
    other = tmp_path / "again"
    assert main([*QUICK, "--out", str(tmp_path)]) == 0
    assert main([*QUICK, *(word for part in AGAIN for word in ("--only", part)), "--out", str(other)]) == 0
    assert again.main([str(tmp_path), str(other)]) == 0
    kept = records(tmp_path)
    assert len(again.records_of(other)) >= 10
    assert len(kept) > 100
    drawn = {path.stem for path in tmp_path.glob("*.png")}
    maps = {f"atlas-{record['map']}" for record in kept if "map" in record}
    assert drawn == {record["problem"] for record in kept if "problem" in record} | maps | {"growth"}
    assert maps
