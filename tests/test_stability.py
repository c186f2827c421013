"""Stability of formulas: a form that loses digits is seen, one with a large condition number is not blamed for it."""

from __future__ import annotations

import random
from math import pi, sqrt
from pathlib import Path
from typing import Any

import pytest
import sympy as sp
from mpmath import mp

from derive.cache import Cache
from derive.emit.kernels import formulas, swing
from derive.measure.bench import stability
from derive.measure.bench.families import Plan
from derive.measure.reference import Rod
from derive.measure.stability import main, record_of, table, worst_input
from derive.measure.stability_formulas import compiled, examine, examined, known_formulas, operations
from derive.measure.stability_rods import Genes, drawn, heard_on, kernels, listening
from derive.measure.stability_search import Boxes, over_arguments

ROD = Rod(0.5, 0.8, 5.0, 2.0, 0.3)


def root_less_one(x: float) -> float:
    """√(1 + x) − 1, which loses all digits of a small x."""
    return sqrt(1 + x) - 1


def tame_root(x: float) -> float:
    """The same without a difference."""
    return x / (sqrt(1 + x) + 1)


def difference(a: float, b: float) -> float:
    """a² − b² by its factors: exact to rounding, for a and b as they are."""
    return (a - b) * (a + b)


def test_a_form_that_cancels_is_blamed() -> None:
    bad = examined("root_less_one", root_less_one, lambda at: sp.sqrt(1 + at["x"]) - 1)
    good = examined("tame_root", tame_root, lambda at: at["x"] / (sp.sqrt(1 + at["x"]) + 1))
    found = examine(bad, (1.2345e-9,))
    assert found is not None
    assert found.condition == pytest.approx(1, rel=1e-6)
    assert found.excess > 1e5
    better = examine(good, (1.2345e-9,))
    assert better is None or better.excess < 1


def test_a_large_condition_number_is_no_fault() -> None:
    formula = examined("difference", difference, lambda at: at["a"] ** 2 - at["b"] ** 2)
    found = examine(formula, (1.1, 1.1 * (1 + 2.0**-40)))
    assert found is None or found.excess < 1
    close = examine(formula, (0.3, 0.1))
    assert close is None or close.condition == pytest.approx(2 * (0.09 + 0.01) / 0.08, rel=1e-6)


def test_failures_of_doubles_are_excesses() -> None:
    formula = examined("difference", difference, lambda at: at["a"] ** 2 - at["b"] ** 2)
    assert examine(formula, (1e200, 1.0)).excess == float("inf")  # type: ignore[union-attr]
    assert examine(formula, (1e-200, 0.0)) is None  # the result itself underflows
    root = examined("tame_root", tame_root, lambda at: at["x"] / (sp.sqrt(1 + at["x"]) + 1))
    assert examine(root, (-2.0,)) is None  # no real value


def test_every_formula_of_the_kernels_is_known_and_exact() -> None:
    known = known_formulas()
    assert len(known) > 45
    assert operations(formulas.strength) == 1
    x, y = sp.symbols("x y", real=True)
    with mp.workdps(30):
        value = compiled(3 * x**2 / y - sp.sqrt(y) + sp.Rational(1, 3), [x, y])([mp.mpf(2), mp.mpf(4)])
        assert value == pytest.approx(3 - 2 + 1 / 3)
        turned = compiled(sp.sin(x) * sp.cos(y), [x, y])([mp.mpf(2), mp.mpf(4)])
        assert turned == mp.sin(2) * mp.cos(4)
    with pytest.raises(TypeError, match="no exact value is known of tan"):
        compiled(sp.tan(x), [x])


def test_what_kernels_call_is_heard_and_nothing_stays_changed() -> None:
    before = swing.phase_sum
    heard = heard_on(ROD, "phase_sum")
    assert 0 < len(heard) <= 60
    assert all(len(arguments) == 4 and min(arguments) >= 0 for arguments in heard)
    assert swing.phase_sum is before
    with listening(["phase_sum"], {}):
        assert swing.phase_sum is not before
    assert swing.phase_sum is before
    # sin² and cos² belong together wherever they are called.
    assert all(abs(square + rest - 1) < 1e-14 for _, _, square, rest in heard_on(ROD, "phase_rate"))


def test_all_kernels_that_use_formulas_are_listened_to() -> None:
    folder = Path(formulas.__file__).parent
    using = {path.stem for path in folder.glob("*.py") if "kernels.formulas import" in path.read_text("utf-8")}
    with listening(list(known_formulas()), {}):
        deaf = {
            f"{module.__name__}.{name}"
            for module in kernels()
            for name in known_formulas()
            if vars(module).get(name) is getattr(formulas, name)
        }
    assert not deaf
    assert using <= {module.__name__.rpartition(".")[2] for module in kernels()}


def test_rods_are_rods_and_come_again() -> None:
    one, other = ([drawn(random.Random(5)).rod() for _ in range(2)] for _ in range(2))
    assert one == other
    for k in range(200):
        rod = drawn(random.Random(k)).rod()
        assert rod.beta > 0
        assert rod.eta > 0
        assert 0 < rod.length < 100
    exact = Genes(0.0, 0.0, 0.0, 1.0, -3.0, -1.0, pi / 2, -5.0, 0.0)
    assert exact.rod() == Rod(1.0, 1.0, 1.0, 1.0 - 1e-3, pi / 2)


def test_climbing_finds_the_worst_of_free_arguments() -> None:
    bad = examined("root_less_one", root_less_one, lambda at: sp.sqrt(1 + at["x"]) - 1)
    boxes = Boxes(1)
    for value in (1e-12, 1.0):
        boxes.enter((value,))
    found = over_arguments(bad, random.Random(1), boxes)
    assert found.excess > 1e7
    assert 1e-12 <= found.arguments[0] <= 1e-9


def test_the_search_comes_again_by_the_command_it_prints(capsys: pytest.CaptureFixture[str]) -> None:
    record = record_of("half_square", 3, 8)
    assert record["called"]["excess"] < 1
    python, dash, module, *rest = record["command"].split()
    assert [python, dash, module] == ["python", "-m", "derive.measure.stability"]
    assert main(rest) == 0
    text = capsys.readouterr().out
    assert "\n".join(table([record])) in text
    assert worst_input(record) in text
    assert "half_square(end=" in text


def test_a_part_of_measure_does_all_formulas() -> None:
    jobs = list(stability.jobs(Plan(Cache(enabled=False), quick=True)))
    assert [job.key for job in jobs] == [f"stability/{name}" for name in known_formulas()]
    records = [{"key": job.key, **job.work()} for job in jobs if job.key.endswith("half_rest")]
    assert not list(stability.wrong(records))
    assert any("again: `python -m derive.measure.stability half_rest" in line for line in stability.document(records))
    (line,) = stability.wrong([{**records[0], "defect": True}])
    assert line.startswith("stability/half_rest: loses ")


def test_a_defect_in_the_kernels_is_found(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    known: Any = known_formulas()
    right = known["half_rest"]
    # cos²ψ as 1 − sin²ψ: right to rounding of 1, and wrong where it is small.
    wrong = lambda end, tilt, delta: 1 - end * (1 - tilt) / (end + delta)  # noqa: E731
    monkeypatch.setitem(known, "half_rest", type(right)("half_rest", right.arguments, wrong, right.exact, 6))
    assert main(["half_rest", "--rods", "40"]) == 1
    assert "half_rest(end=" in capsys.readouterr().out


def test_mistakes_are_named(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["whole_rest"]) == 2
    assert "no kernel has a formula 'whole_rest'" in capsys.readouterr().err
    assert main(["half_rest", "--rods", "1"]) == 2
    assert "--rods must be at least 2" in capsys.readouterr().err


@pytest.mark.long
def test_no_formula_loses_more_than_its_condition_number_explains() -> None:
    records = [record_of(name, 1, 40) for name in known_formulas()]
    assert [one["name"] for one in records if one["defect"]] == []
    assert all(one["heard"] for one in records)
