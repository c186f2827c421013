"""`derive sweep`: branches, events and jumps; files; stores, processes and clusters; mistakes."""

from __future__ import annotations

import csv
import json
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from itertools import pairwise
from math import pi
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from derive.cli import main
from derive.diagrams.blocks import Block, Store, blocks, results, solved
from derive.diagrams.branches import STEP, Diagram, diagram
from derive.diagrams.jumps import jumps
from derive.diagrams.states import State, rows
from derive.emit.kernels.folds import all_folds
from generated import oblique_numpy, parallel_numpy

LOADS = {"beta": 0.00035, "eta": 0.00052, "length": 80.0, "clamp_angle": 3 * pi / 4}
SWEEP = ["sweep", "bifurcation", "--eta", "0:0.001:30"]


def swept(parameter: str, low: float, high: float, number: int = 30, **changes: float) -> Diagram:
    fixed = {name: value for name, value in {**LOADS, **changes}.items() if name != parameter}
    values = np.linspace(low, high, number).tolist()
    return diagram(parameter, values, lambda some: rows(parallel_numpy, parameter, some, fixed), fixed)


def test_the_second_example_has_its_fold_and_its_jump() -> None:
    found = swept("eta", 0.0, 0.001)
    assert [(one.index, one.starts, one.ends) for one in found.branches] == [
        (0, "range", "range"),
        (1, "fold", "range"),
        (0, "fold", "range"),
    ]
    (event,), (jump,) = found.events, jumps(found)
    assert event.value == pytest.approx(0.000468041915201637, rel=1e-14)
    assert (event.below, event.above, event.change) == ((1,), (1, 2, 3), 2)
    assert (jump.direction, jump.leaves, jump.reaches, jump.value) == ("down", 3, (1,), event.value)


@pytest.mark.parametrize("beta", [0.0, 0.0002, 0.0003, 0.0004])
def test_events_over_the_field_are_the_folds_of_the_kernels(beta: float) -> None:
    found = swept("eta", 0.0, 0.01, 300, beta=beta)
    wanted = all_folds(beta, 80.0, 3 * pi / 4, 0.0, 0.0, 0.01)
    assert wanted
    assert [one.value for one in found.events] == pytest.approx([one.eta for one in wanted], rel=1e-13)
    assert [one.change for one in found.events] == [one.change for one in wanted]
    assert [one.state.index for one in found.events] == [one.index for one in wanted]
    # The two that meet are told apart by the root of rounding: that much is uncertain in the mean of both.
    assert [one.state.y for one in found.events] == pytest.approx([one.y for one in wanted], abs=80 * 2.0**-26)


def test_branches_are_complete_and_smooth() -> None:
    found = swept("clamp_angle", 0.0, 6.3, 64)
    assert len(found.events) == 4
    for value in (1.0, 2.4, 3.0, 3.9, 5.0):
        alive = [one for one in found.branches if one.values[0] <= value <= one.values[-1]]
        equilibria = parallel_numpy.equilibria(**{**LOADS, "clamp_angle": value})
        assert sorted(one.index for one in alive) == sorted(one.index for one in equilibria)
    for branch in found.branches:
        assert all(a < b for a, b in pairwise(branch.values))
        tips = [state.tip_angle for state in branch.states]
        assert max(abs(b - a) for a, b in pairwise(tips)) <= STEP
        # Neighbours are far enough apart that rounding does not show in the direction from one to the next.
        assert min(b - a for a, b in pairwise(branch.values)) > 1e-8
    ends = {event.value for event in found.events} | {0.0, 6.3}
    assert all({one.values[0], one.values[-1]} <= ends for one in found.branches)


def test_a_straight_rod_buckles_at_a_pitchfork() -> None:
    found = swept("eta", 0.0, 0.004, beta=0.003, clamp_angle=pi)
    (event,) = found.events
    (wanted,) = all_folds(0.003, 80.0, pi, 0.0, 0.0, 0.004)
    assert (event.kind, wanted.kind) == ("pitchfork", "pitchfork")
    assert event.value == pytest.approx(wanted.eta, rel=1e-13)
    (jump,) = jumps(found)
    assert jump.direction == "down"
    assert {found.branches[k - 1].index for k in jump.reaches} == {0}
    assert len(jump.reaches) == 2


def test_a_stable_branch_splits_at_a_soft_pitchfork() -> None:
    fixed = {"eta": 0.0, "length": 10.0, "clamp_angle": pi, "field_angle": pi / 2}
    found = diagram(
        "beta", np.linspace(0.0, 0.05, 20).tolist(), lambda some: rows(oblique_numpy, "beta", some, fixed), fixed
    )
    (event,) = found.events
    assert event.kind == "pitchfork"
    assert event.value == pytest.approx((pi / 20) ** 2, rel=1e-13)  # Euler's column
    (jump,) = [one for one in jumps(found) if one.direction == "up"]
    assert len(jump.reaches) == 2
    assert not [one for one in jumps(found) if one.direction == "down" and len(one.reaches) != 1]


def test_a_jump_is_where_a_damped_rod_goes() -> None:
    """Below the fold the rod that was on the branch that ends slides down the energy to the branch reached."""
    found = swept("eta", 0.0, 0.001)
    (jump,) = jumps(found)
    start = found.events[0].state
    value, number = jump.value * (1 - 0.05), 40
    step = LOADS["length"] / number
    # A chain of bars: θ at their joints, Σ(Δθ)²/2h − h Σ(β cos θ + ½η cos²θ), steepest descent.
    s = np.linspace(0, LOADS["length"], number + 1)
    near = min(
        parallel_numpy.equilibria(**{**LOADS, "eta": jump.value * (1 + 1e-12)}),
        key=lambda one: abs(one.tip_angle - start.tip_angle),
    )
    theta = parallel_numpy.shape(near, s).theta[1:]
    for _ in range(60000):
        padded = np.concatenate([[LOADS["clamp_angle"]], theta, theta[-1:]])
        force = np.diff(padded, 2) / step - step * (LOADS["beta"] * np.sin(theta) + value / 2 * np.sin(2 * theta))
        theta = theta + 0.2 * step * force
    reached = [state for state in rows(parallel_numpy, "eta", [value], found.fixed)[0] if state.index == 0]
    assert len(reached) == 1
    # Forty bars are that far from a rod; the branch that ended is twelve times farther.
    assert theta[-1] == pytest.approx(reached[0].tip_angle, abs=0.1)


def test_files_hold_every_point(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    pytest.importorskip("matplotlib")
    names = {kind: tmp_path / f"found.{kind}" for kind in ("csv", "npz", "json")}
    options = [part for kind, path in names.items() for part in (f"--{kind}", str(path))]
    pictures = [tmp_path / "found.svg", tmp_path / "found.png"]
    for picture in pictures:
        assert main([*SWEEP, "--beta", "0.0003,0.00035", *options, "--plot", str(picture)]) == 0
    assert "0.000468041915201637" in capsys.readouterr().out
    listed = list(csv.DictReader(names["csv"].read_text(encoding="utf-8").splitlines()))
    arrays, curves = np.load(names["npz"]), json.loads(names["json"].read_text(encoding="utf-8"))["curves"]
    assert len(listed) == len(arrays["y"]) == sum(len(one["values"]) for part in curves for one in part["branches"])
    assert [float(row["y"]) for row in listed] == arrays["y"].tolist()
    assert {row["beta"] for row in listed} == {"0.0003", "0.00035"}
    assert arrays["event_kind"].tolist() == ["fold", "fold"]
    assert curves[1]["jumps"][0]["reaches"] == [1]
    first = pictures[0].read_bytes()
    assert main([*SWEEP, "--beta", "0.0003,0.00035", "--plot", str(pictures[0])]) == 0
    assert pictures[0].read_bytes() == first


def some_blocks() -> list[Block]:
    return list(blocks("generated.bifurcation_numpy", "", "eta", np.linspace(0, 1e-3, 300).tolist(), {"beta": 0.00035}))


class StoppedError(Exception):
    """Stands for what ends a run."""


def test_an_interrupted_sweep_goes_on(tmp_path: Path) -> None:
    todo, seen = some_blocks(), []

    def stop(done: int, total: int) -> None:
        seen.append((done, total))
        if done == 2:
            raise StoppedError

    with pytest.raises(StoppedError):
        solved(todo, Store(tmp_path), None, stop)
    assert len(list(tmp_path.glob("*.json"))) == 2
    again: list[tuple[int, int]] = []
    found = solved(todo, Store(tmp_path), None, lambda *numbers: again.append(numbers))
    assert again == [(2, 3), (3, 3)]
    assert found == solved(todo, Store(None))
    spoilt = next(tmp_path.glob("*.json"))
    spoilt.write_text("[[[1", encoding="utf-8")
    assert solved(todo, Store(tmp_path)) == found
    assert Store(tmp_path).get(replace(todo[0], fixed=(("beta", 0.0003),))) is None


def test_processes_give_the_same(tmp_path: Path) -> None:
    for jobs in ("1", "2"):
        path = tmp_path / f"{jobs}.csv"
        assert (
            main(
                ["sweep", "bifurcation", "--eta", "0:0.001:300", "--beta", "0.0004", "--jobs", jobs, "--csv", str(path)]
            )
            == 0
        )
    assert (tmp_path / "1.csv").read_bytes() == (tmp_path / "2.csv").read_bytes()


class Losing(ThreadPoolExecutor):
    """An executor that has lost what it found."""

    def submit(self, fn: Any, /, *args: Any, **named: Any) -> Any:
        def lose() -> Any:
            fn(*args, **named)
            raise ValueError("too many values to unpack")

        return super().submit(lose)


def test_what_an_executor_lost_is_solved_here() -> None:
    todo = some_blocks()
    with Losing(2) as pool:
        assert dict(results(todo, pool)) == solved(todo, Store(None))


def test_an_error_of_a_block_is_not_hidden() -> None:
    spoilt = replace(some_blocks()[0], fixed=())
    with ThreadPoolExecutor(1) as pool, pytest.raises(TypeError, match="beta"):
        dict(results([spoilt], pool))


@pytest.mark.long
@pytest.mark.filterwarnings("default")
def test_a_cluster_loses_nothing_with_a_worker() -> None:
    distributed = pytest.importorskip("distributed")
    todo = some_blocks()
    with (
        distributed.LocalCluster(
            n_workers=2, threads_per_worker=1, host="127.0.0.1", dashboard_address=None, processes=True
        ) as cluster,
        distributed.Client(cluster) as client,
    ):
        pool = client.get_executor(retries=3)
        running = results(todo, pool)
        found = dict([next(running)])
        cluster.sync(next(iter(cluster.workers.values())).kill)
        found |= dict(running)
    assert found == solved(todo, Store(None))


@pytest.mark.long
def test_a_scene_file_is_swept(tmp_path: Path) -> None:
    scene, path = tmp_path / "mine.toml", tmp_path / "mine.csv"
    scene.write_text(
        '[scene]\nname = "mine"\ncase = "field_only"\noutputs = ["sweep"]\nbackends = ["numpy"]\n'
        '[constants]\nlength = "80"\nclamp_angle = "3*pi/4"\n',
        encoding="utf-8",
    )
    assert main(["sweep", str(scene), "--eta", "0:0.005:20", "--jobs", "2", "--csv", str(path)]) == 0
    assert {row["branch"] for row in csv.DictReader(path.read_text(encoding="utf-8").splitlines())} == {"1", "2", "3"}


MISTAKES: list[tuple[Sequence[str], str]] = [
    (["--eta", "0:0.001:30"], "--beta is missing"),
    (["--eta", "0.001", "--beta", "0.0003"], "one parameter must be a range"),
    (["--eta", "0:0.001:30", "--beta", "0:1:3"], "one parameter must be a range"),
    (["--eta", "0.001:0:30", "--beta", "0.0003"], "the range must ascend"),
    (["--eta", "0:0.001", "--beta", "0.0003"], "must be low:high:points"),
    (["--eta", "0:0.001:1", "--beta", "0.0003"], "points are possible"),
    (["--eta", "0:0.001:30", "--beta", "-1"], "--beta must be at least 0"),
    (["--eta", "0:0.001:30", "--beta", "0.0003", "--length", "80"], "--length is no parameter here"),
    (["--eta", "0:0.001:30", "--beta", "0.0003", "--plot", "picture.gif"], "must end in .svg"),
    (["--eta", "0:0.001:30", "--beta", "0.0003", "--csv", "/dev/null/x.csv"], "cannot be written"),
    (["--eta", "0:0.001:30", "--beta", "0.0003", "--store", "/dev/null/x"], "cannot be written"),
]


@pytest.mark.parametrize(("arguments", "words"), MISTAKES)
def test_mistakes_are_one_line(arguments: list[str], words: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["sweep", "bifurcation", *arguments]) == 2
    error = capsys.readouterr().err
    assert words in error
    assert error.count("\n") == 1


def test_a_state_is_all_that_a_module_says() -> None:
    (state,) = rows(parallel_numpy, "eta", [0.0001], {**LOADS, "beta": 0.0005})[0]
    (one,) = parallel_numpy.equilibria(0.0005, 0.0001, 80.0, 3 * pi / 4)
    assert state == State(one.tip_angle, one.clamp_curvature, one.gamma, one.y, one.z, one.energy, one.index)
