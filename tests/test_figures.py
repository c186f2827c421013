"""The figures: what the article says of its examples holds in the data drawn; files whole, dated by nothing."""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np
import pytest

from derive.cli import main
from derive.diagrams.branches import diagram
from derive.diagrams.states import rows
from derive.report.figures import FIGURES, bifurcation, fold_set, remote_control, style


def second_example(number: int) -> tuple[list[float], list[tuple[np.ndarray, np.ndarray, int]]]:
    """Folds of a curve, and its branches as (η, w, index)."""
    found = bifurcation.curves(bifurcation.FORCES[number - 1])
    branches = [(np.array(one.values), np.array(bifurcation.heights(one)), one.index) for one in found.branches]
    return [event.value for event in found.events], branches


def test_the_field_draws_the_tip_back() -> None:
    for beta in (remote_control.FORCES[0], remote_control.FORCES[-1]):
        (branch,) = remote_control.curves(beta).branches
        y = np.array([state.y for state in branch.states])
        assert branch.index == 0
        assert (np.diff(y) < 0).all()
        assert y[-1] < 0.15 * y[0]


@pytest.mark.parametrize("number", [2, 5])
def test_a_weak_force_is_overcome(number: int) -> None:
    _, found = second_example(number)
    _, first, _ = found[0]
    top = max((w for eta, w, index in found if eta[-1] > 0.999 * bifurcation.HIGHEST), key=lambda w: w[-1])
    assert first[0] < 0 < top[-1]


@pytest.mark.parametrize("number", [6, 8])
def test_a_strong_force_is_helped(number: int) -> None:
    folds, found = second_example(number)
    assert len(folds) == 1
    lowest = [w for _, w, _ in found if w[0] < -45]
    assert lowest[0][-1] < lowest[0][0] < 0
    assert sorted(index for eta, _, index in found if eta[-1] > folds[0]) == [0, 0, 1]


def test_folds_of_the_first_two_curves_are_outside() -> None:
    assert [len(second_example(number)[0]) for number in (1, 2, 3)] == [0, 0, 1]


def test_a_fold_is_found_without_being_known() -> None:
    fixed = {"beta": 0.00035, "length": bifurcation.LENGTH, "clamp_angle": bifurcation.CLAMP}
    few = [0.0004, 0.0006]
    found = diagram("eta", few, lambda some: rows(bifurcation.bifurcation_numpy, "eta", some, fixed), fixed)
    assert [event.value for event in found.events] == pytest.approx(second_example(6)[0], rel=1e-13)


def test_curves_meet_at_their_fold() -> None:
    (fold,), fixed = second_example(6)[0], {"beta": bifurcation.FORCES[5]}
    (above,) = rows(bifurcation.bifurcation_numpy, "eta", [fold * (1 + 1e-9)], fixed)
    heights = sorted(style.across(state.y, state.z, bifurcation.CLAMP) for state in above)
    assert heights[2] - heights[1] < 0.02 < heights[1] - heights[0]


@pytest.mark.parametrize(("beta", "changes"), [(0.0003, [2]), (0.000303, [2, -2, 2]), (0.00031, [2])])
def test_two_kinds_of_diagrams_and_one_between(beta: float, changes: list[int]) -> None:
    assert [one.change for one in fold_set.folds_at(beta)] == changes


def test_files_depend_on_nothing_else(tmp_path: Path) -> None:
    pytest.importorskip("matplotlib")
    for folder in ("one", "two"):
        given = ["figures", "separate-loads", "--format", "svg,png,pdf", "--out", str(tmp_path / folder)]
        assert main(given) == 0
    names = sorted(path.name for path in (tmp_path / "one").iterdir())
    assert names == [f"separate-loads.{kind}" for kind in ("pdf", "png", "svg")]
    for name in names:
        assert (tmp_path / "one" / name).read_bytes() == (tmp_path / "two" / name).read_bytes()


@pytest.mark.parametrize(
    ("given", "said"),
    [(["figure-9"], f"'figure-9' is no figure; possible: {', '.join(FIGURES)}"), (["--format", "gif"], "'gif' is no")],
)
def test_a_wrong_name_is_one_line(given: list[str], said: str, tmp_path: Path, capsys: pytest.CaptureFixture) -> None:
    assert main(["figures", *given, "--out", str(tmp_path / "new")]) == 2
    error = capsys.readouterr().err
    assert said in error
    assert error.count("\n") == 1
    assert not (tmp_path / "new").exists()


def test_without_matplotlib(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture) -> None:
    monkeypatch.setitem(sys.modules, "matplotlib", None)
    assert main(["figures", "separate-loads", "--out", str(tmp_path / "new")]) == 2
    error = capsys.readouterr().err
    assert error == "derive figures: a picture needs matplotlib: pip install 'magnetic-rods[pictures]'\n"
    assert not (tmp_path / "new").exists()


def test_all_files_or_none(tmp_path: Path, capsys: pytest.CaptureFixture) -> None:
    pytest.importorskip("matplotlib")
    (tmp_path / "separate-loads.svg").mkdir()
    assert main(["figures", "separate-loads", "--format", "png,svg", "--out", str(tmp_path)]) == 2
    assert "cannot be written" in capsys.readouterr().err
    assert [path.name for path in tmp_path.iterdir()] == ["separate-loads.svg"]
