"""The figures: what the article says of its examples holds in the data drawn; files whole, dated by nothing."""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np
import pytest

from derive.cli import main
from derive.emit.kernels.folds import all_folds
from derive.report.figures import FIGURES, bifurcation, fold_set, remote_control, style
from derive.report.figures.diagrams import between, pieces


def second_example(number: int) -> tuple[list[float], list[tuple[np.ndarray, np.ndarray, int]]]:
    """Folds of a curve, and its pieces as (η, w, index)."""
    beta, clamp, highest = bifurcation.FORCES[number - 1], bifurcation.CLAMP, bifurcation.HIGHEST
    folds = [one.eta for one in all_folds(beta, bifurcation.LENGTH, clamp, 0.0, 0.0, highest)]
    found = pieces(bifurcation.sweep, beta, folds, 0.0, highest)
    return folds, [(one.eta, style.across(one.y, one.z, clamp), one.index) for one in found]


def test_the_field_draws_the_tip_back() -> None:
    for beta in (remote_control.FORCES[0], remote_control.FORCES[-1]):
        (piece,) = pieces(remote_control.sweep, beta, [], 0.0, remote_control.HIGHEST)
        assert piece.index == 0
        assert (np.diff(piece.y) < 0).all()
        assert piece.y[-1] < 0.15 * piece.y[0]


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
    assert sorted(index for eta, _, index in found if eta[0] >= folds[0]) == [0, 0, 1]


def test_folds_of_the_first_two_curves_are_outside() -> None:
    assert [len(second_example(number)[0]) for number in (1, 2, 3)] == [0, 0, 1]


def test_curves_meet_at_their_fold() -> None:
    folds, found = second_example(6)
    heights = sorted(w[0] for eta, w, _ in found if eta[0] >= folds[0])
    assert heights[2] - heights[1] < 0.02 < heights[1] - heights[0]


@pytest.mark.parametrize(("beta", "changes"), [(0.0003, [2]), (0.000303, [2, -2, 2]), (0.00031, [2])])
def test_two_kinds_of_diagrams_and_one_between(beta: float, changes: list[int]) -> None:
    assert [one.change for one in fold_set.folds_at(beta)] == changes


def test_a_fold_that_is_forgotten_is_seen() -> None:
    with pytest.raises(ArithmeticError, match="number of equilibria changes"):
        between(bifurcation.sweep, 0.00035, 0.0004, 0.0006)


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
    assert error == "derive figures: figures need matplotlib: pip install 'magnetic-rods[pictures]'\n"
    assert not (tmp_path / "new").exists()


def test_all_files_or_none(tmp_path: Path, capsys: pytest.CaptureFixture) -> None:
    pytest.importorskip("matplotlib")
    (tmp_path / "separate-loads.svg").mkdir()
    assert main(["figures", "separate-loads", "--format", "png,svg", "--out", str(tmp_path)]) == 2
    assert "cannot be written" in capsys.readouterr().err
    assert [path.name for path in tmp_path.iterdir()] == ["separate-loads.svg"]
