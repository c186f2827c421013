"""What measured records are made of: errors, times, fronts, exponents, references, methods, tables."""

from __future__ import annotations

import importlib
import json
import sys
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from mpmath import mp, mpf

from derive.cache import Cache
from derive.diagrams.front_picture import styles
from derive.measure.bench import again, fronts, growth, judged, known, precision, ratios, tables, timing
from derive.measure.bench.cells import ARTICLE, OURS, PEER, Cell, Method, Problem, measure
from derive.measure.bench.families import FAMILIES, Plan, families, parts
from derive.measure.bench.methods import at_once, methods
from derive.measure.bench.methods.chebyshev import solve as collocated
from derive.measure.bench.methods.outside import Outside
from derive.measure.bench.methods.rod_solver import RodSolver, Solved, all_found
from derive.measure.bench.tasks import TASKS, module_of
from derive.measure.reference import Rod
from derive.measure.rods import PAPER

ROOT = Path(__file__).resolve().parent.parent
GUIDE = (ROOT / "docs" / "measure.md").read_text(encoding="utf-8")
# The article's rod: tip angle, y and z of its first stable equilibrium, as in the README.
TIP, Y = 0.8339812667, 14.7947328


def a_record(method: str, seconds: float, worst: float | None, **more: Any) -> dict[str, Any]:
    """A record as `measure` makes it."""
    errors = {"worst": worst, "median": worst, "found": 0 if worst is None else 2, "of": 2, "spurious": 0}
    times = {"median": seconds, "low": seconds, "high": seconds, "runs": 3}
    plain = {"problem": "T1", "task": "T1", "title": "one", "unit": "rod", "units": 2, "method": method}
    plain |= {"group": PEER, "setting": "n = 1", "share": 1.0, "whole": True, "all_found": False, "limit": 1e-9}
    plain |= {"errors": errors, "seconds": times, "base_seconds": times, "ratio": times}
    return {"key": f"tasks/T1/{method}/n = 1", **plain, **more}


def test_every_family_task_and_method_is_whole() -> None:
    assert set(families()) == set(FAMILIES)
    for family in families().values():
        assert family.PARTS
        assert callable(family.jobs)
        assert callable(family.document)
        assert callable(family.wrong)
    assert set(TASKS) < set(parts())
    assert all(module_of(task).TITLE and module_of(task).NOTE and callable(module_of(task).problems) for task in TASKS)
    names = [method.name for method in methods()]
    assert len(set(names)) == len(names)


def test_the_guide_tells_of_every_task_and_method() -> None:
    assert [name for name in parts() if f"| {name} " not in GUIDE] == []
    assert [method.name for method in methods() if method.name not in GUIDE] == []


def test_errors_count_what_is_missing_and_what_is_none() -> None:
    rod, rows = Rod(0.1, 0.2, 4.0, 1.0), [[mpf(1), mpf(2), mpf(3)], [mpf(2), mpf(1), mpf(1)]]
    found = judged.of_equilibria([[(1.0, 2.0, 3.04), (7.0, 0.0, 0.0)]], [rod], [rows], 30)
    assert (found.found, found.of, found.spurious) == (1, 2, 1)
    assert found.worst == pytest.approx(0.01)  # a place counts over the length
    assert judged.of_equilibria([[]], [rod], [rows], 30) == judged.Errors(None, None, 0, 2)
    assert judged.of_values([float("nan"), 2.0, None], [mpf(1), mpf(4), mpf(1)], 30) == judged.Errors(0.5, 0.5, 1, 3)
    assert judged.of_folds([(1.001, 2.0), None, (3.0, 1.0)], [(mpf(1), mpf(2))] * 3, 30).found == 1
    shape = judged.of_shape([[0.5], None, [2.2]], [[mpf("0.5")], [mpf(1)], [mpf(2)]], 2.0, 30)
    assert shape.worst == pytest.approx(0.1)


def test_what_is_no_number_is_not_found() -> None:
    """Not an error of 0, whatever stands beside it."""
    rod, nan = Rod(0.1, 0.2, 4.0, 1.0), float("nan")
    found = judged.of_equilibria(
        [[(1.0, nan, 3.0), (2.0, 1.0, nan)]], [rod], [[[mpf(1)] * 3, [mpf(2), mpf(1), mpf(1)]]], 30
    )
    assert (found.worst, found.found, found.of) == (None, 0, 2)
    assert judged.of_shape([[nan], [1.0]], [[mpf(1)], [mpf(1)]], 2.0, 30) == judged.Errors(None, None, 0, 1)
    assert judged.of_shape([[1.0, 1.0], [1.0, nan]], [[mpf(1)] * 2] * 2, 2.0, 30) == judged.Errors(0.0, 0.0, 1, 2)
    assert judged.of_folds([(nan, 1.0)], [(mpf(1), mpf(1))], 30).found == 0


@given(st.lists(st.tuples(st.floats(1e-9, 1e3), st.floats(0, 1)), min_size=1, max_size=30))
def test_nothing_beats_the_front(points: list[tuple[float, float]]) -> None:
    records = [a_record(str(k), *point) for k, point in enumerate(points)]
    best = [fronts.point(record) for record in fronts.front(records)]
    assert best == sorted(best)
    for time, error in points:
        assert any(t <= time and e <= error for t, e in best)
    for time, error in best:
        assert not any(t <= time and e <= error and (t, e) != (time, error) for t, e in points)


def test_what_is_incomplete_is_on_no_front_and_where_others_win_is_said() -> None:
    ours = a_record("ours", 1.0, 1e-14, group=OURS)
    part = a_record("part", 0.1, 1e-16, whole=False)
    quick, exact = a_record("quick", 0.25, 1e-6), a_record("exact", 30.0, 1e-30)
    records = [ours, part, quick, exact, a_record("lost", 0.1, None)]
    assert fronts.front(records) == [quick, ours, exact]
    lines = fronts.wins(records)
    assert lines[0] == "quick (n = 1) is 4.0× faster, with an error of 1e-06"
    assert lines[1] == "exact (n = 1) errs by 1e-30 instead of 1e-14, and is 30.0× slower"
    assert len(lines) == 2


def test_what_solves_many_at_once_is_on_no_front_and_is_set_against_others() -> None:
    ours, many = a_record("ours", 1.0, 1e-15, group=OURS), a_record("many", 0.02, 2e-15, group=OURS, share=1000)
    theirs = a_record("solve_bvp", 5.0, 1e-11, setting="tol 1e-8", ratio={"median": 5.0})
    records = [ours | {"ratio": {"median": 1.0}}, many | {"ratio": {"median": 0.02}}, theirs]
    assert fronts.front(records) == records[:1]
    *_, alone, at_a_time = ratios.section(records)
    assert "| ours, n = 1 | solve_bvp, tol 1e-8 | 5 | 1e-15 and 1e-11 | 4.0 |" in alone
    assert "| many, n = 1 | solve_bvp, tol 1e-8 | 250 | 2e-15 and 1e-11 | 3.7 |" in at_a_time
    assert ratios.section(records[:2]) == []
    part = a_record("SciPy ellipj", 0.5, None, whole=False, ratio={"median": 0.5})
    assert "| 0.5 | 1e-15 and – | – |" in ratios.section([records[0], part])[-1]


def test_two_runs_are_compared(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Times may differ, and how far they do is told; any other number may not."""
    record = a_record("ours", 1.0, 1e-15)
    slower = a_record("ours", 3.0, 1e-15)
    other = a_record("ours", 1.0, 2e-15)
    for name, one in (("first", record), ("slower", slower), ("other", other)):
        (tmp_path / name).mkdir()
        (tmp_path / name / "records.jsonl").write_text(f"{{}}\n{json.dumps(one)}\n", encoding="utf-8")
    first = str(tmp_path / "first")
    assert again.main([first, str(tmp_path / "slower")]) == 0
    told = capsys.readouterr().out
    assert "1 records in both, 0 in one alone; 0 differ in more than times" in told
    assert "of 1 times 0 are within the spread of the first run, 0 spreads overlap" in told
    assert "3.00× (tasks/T1/ours/n = 1)" in told
    assert again.main([first, str(tmp_path / "other")]) == 1
    assert "tasks/T1/ours/n = 1: errors was" in capsys.readouterr().err
    assert again.main([first, str(tmp_path)]) == 2
    assert again.main([first]) == 2
    assert "holds no records of a run" in capsys.readouterr().err


def test_methods_of_others_are_told_apart_in_pictures() -> None:
    """By the same looks in all of them."""
    looks = styles([a_record(method.name, 1.0, 1e-9, group=method.group) for method in methods()])
    others = [looks[method.name] for method in methods() if method.group not in (OURS, ARTICLE)]
    assert len(set(others)) == len(others)
    assert not set(others) & {looks[method.name] for method in methods() if method.group in (OURS, ARTICLE)}


@given(st.floats(-1, 3), st.floats(1e-9, 1))
def test_an_exponent_is_found(power: float, start: float) -> None:
    rows = [
        {"series": "s", "variable": "n", "amount": n, "seconds": {"median": start * n**power}, "bytes": 8 * n**2}
        for n in (10, 100, 1000, 10_000)
    ]
    (row,) = growth.exponents(rows)
    assert row.time == pytest.approx(power, abs=1e-9)
    assert row.memory == pytest.approx(2, abs=1e-9)


def test_times_are_those_of_warm_calls_in_turn() -> None:
    order: list[str] = []
    found, own, other = timing.interleaved(lambda: order.append("own") or 7, lambda: order.append("base"), 0.0)
    assert found == 7
    assert len(own) == len(other) == timing.FEWEST
    assert order[:4] == ["own", "own", "base", "base"]
    assert timing.peak_memory(lambda: np.zeros(10**6)) >= 8 * 10**6


@pytest.mark.parametrize("kind", ["p", "zeta", "sigma"])
def test_references_of_weierstrass_functions(kind: str) -> None:
    """By theta functions of mpmath, which the references do not use."""
    g2, g3, u = 1.3, 0.1, [0.03, 1.5, 4.4]
    with mp.workdps(50):
        e1, e2, e3 = sorted((mp.re(x) for x in mp.polyroots([4, 0, -mpf(g2), -mpf(g3)])), reverse=True)
        m = (e2 - e3) / (e1 - e3)
        first = mp.ellipk(m) / mp.sqrt(e1 - e3)
        q = mp.exp(-mp.pi * mp.ellipk(1 - m) / mp.ellipk(m))
        eta = -(mp.pi**2) / (12 * first) * mp.jtheta(1, 0, q, 3) / mp.jtheta(1, 0, q, 1)

        def log_sigma(x: Any) -> Any:
            theta = mp.jtheta(1, mp.pi * x / (2 * first), q) / mp.jtheta(1, 0, q, 1)
            return eta * x * x / (2 * first) + mp.log(2 * first / mp.pi * theta)

        for x, value in zip(u, known.weierstrass(kind, u, g2, g3, 40), strict=True):
            wanted = {
                "sigma": lambda x=x: mp.re(mp.exp(log_sigma(mpf(x)))),
                "zeta": lambda x=x: mp.re(mp.diff(log_sigma, mpf(x))),
                "p": lambda x=x: -mp.re(mp.diff(log_sigma, mpf(x), 2)),
            }[kind]()
            assert abs(value / wanted - 1) < 1e-25  # numerical derivatives lose some


@pytest.mark.parametrize(
    "name", [m.name for m in methods() if isinstance(getattr(m.cells, "__self__", None), RodSolver)]
)
def test_solvers_of_others_find_the_article_s_rod(name: str) -> None:
    solver: RodSolver = next(m.cells.__self__ for m in methods() if m.name == name)  # type: ignore[attr-defined]
    setting = solver.quick[-1]
    found = solver.solve(PAPER, 0.8, setting)
    assert found is not None
    limit = 2 * solver.limit(setting) + 1e-9
    assert abs(found.tip_angle - TIP) < limit
    assert abs(found.y - Y) < PAPER.length * limit
    theta, y, _ = found.at(np.array([0.0, PAPER.length]))
    assert abs(theta[0] - PAPER.clamp_angle) < limit
    assert abs(y[0]) < PAPER.length * limit
    assert abs(y[1] - Y) < PAPER.length * limit


def test_a_batch_of_rods_is_what_one_by_one_gives() -> None:
    """And the rod itself stands in its midst, as given."""
    beta, eta = at_once.loads(PAPER)
    assert (beta[at_once.MANY // 2], eta[at_once.MANY // 2]) == (PAPER.beta, PAPER.eta)
    assert len(set(beta.tolist())) == at_once.MANY
    found = at_once.stacked(beta[:3], eta[:3], PAPER, 0.8, 24)
    for k, (tip, y, z) in enumerate(found.T):
        alone = collocated(replace(PAPER, beta=float(beta[k]), eta=float(eta[k])), 0.8, 24)
        assert alone is not None
        assert (tip, y, z) == pytest.approx((alone.tip_angle, alone.y, alone.z), abs=1e-11)
    n = 7
    assert at_once.integrals(n) == pytest.approx(
        [np.polynomial.chebyshev.chebint(row, lbnd=-1).sum() for row in np.eye(n + 1)]
    )


def test_a_batch_in_which_a_rod_does_not_settle_loses_that_rod_alone() -> None:
    beta, eta = np.array([PAPER.beta, 1e9]), np.array([PAPER.eta, 1e9])
    tips = at_once.stacked(beta, eta, PAPER, 0.8, 16)[0]
    assert abs(tips[0] - TIP) < 1e-3
    assert np.isnan(tips[1])


def test_guesses_that_lead_nowhere_are_no_equilibria() -> None:
    def solve(rod: Rod, tip: float) -> Solved | None:
        return Solved(round(tip), 0.0, 0.0, lambda s: (s, s, s)) if tip > 0 else None

    assert [tip for tip, _, _ in all_found(solve, replace(PAPER, clamp_angle=0.0))] == [1, 2, 3]


def test_a_record_beyond_its_limit_is_named() -> None:
    """The key, and how it is wrong: too large, not all found, nothing found, no number."""
    assert list(precision.wrong([a_record("good", 1.0, 1e-10)])) == []
    (line,) = precision.wrong([a_record("bad", 1.0, 1e-8)])
    assert line == "tasks/T1/bad/n = 1: error 1.0e-08 is beyond its limit 1e-09"
    few = {"worst": 0.0, "median": 0.0, "found": 1, "of": 2, "spurious": 0}
    assert "found 1 of 2" in next(precision.wrong([a_record("few", 1.0, 0.0, errors=few, all_found=True)]))
    assert "nothing was found" in next(precision.wrong([a_record("none", 1.0, None)]))
    assert list(precision.wrong([a_record("nan", 1.0, float("nan"))]))


def test_a_method_is_measured_beside_the_base_and_closed() -> None:
    closed: list[bool] = []

    class Call:
        def __call__(self) -> list[float]:
            return [2.0]

        def close(self) -> None:
            closed.append(True)

    def judge(found: Any) -> judged.Errors:
        return judged.of_values(found, [mpf(2)], 30)

    problem = Problem("P", "T1", "a problem", "rod", 4, None, judge)
    base = Cell("n = 1", lambda: lambda: None, 0.0)
    record = measure(problem, Method("m", PEER, lambda *_: iter(())), replace(base, prepare=Call, share=0.5), base, 0.0)
    assert record["errors"] == {"worst": 0.0, "median": 0.0, "found": 1, "of": 1, "spurious": 0}
    assert closed == [True]
    assert json.loads(json.dumps(record)) == record


def test_a_package_that_runs_apart() -> None:
    """One with a function of points and three numbers, and one that ends at once."""
    outside = Outside("operator", "mul", [2.0], [1.0, 3.0])
    assert outside() == [2.0, 6.0]
    assert outside() is None
    outside.close()
    with pytest.raises(RuntimeError, match="has ended"):
        Outside("no_such_package", "f", [2.0], [1.0])


def test_what_is_missing_is_said(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("derive.measure.packages.find_spec", lambda name: None)
    lines = precision.missing()
    assert any("scipy cannot be imported: solve_bvp, shooting" in line for line in lines)
    plan = Plan(Cache(), quick=True, only=("T6",))
    keys = [job.key for job in precision.jobs(plan)]
    assert keys == ["tasks/T6/emitted, NumPy/all in a range", *(f"tasks/T6/Chebyshev/n = {n}" for n in (16, 32))]


def test_tables_have_a_row_for_each_record() -> None:
    records = [a_record("ours", 1.0, 1e-14, group=OURS), a_record("theirs", 0.1, 1e-6), a_record("lost", 9.0, None)]
    lines = precision.document(records)
    assert sum(line.startswith("| ") for line in lines) == 1 + len(records)
    assert "| theirs | n = 1 | 1e-06 | 1e-06 | 2 of 2 | 100 ms | 100 ms … 100 ms | 0.1 | • |" in lines
    assert "- theirs (n = 1) is 10.0× faster, with an error of 1e-06" in lines
    assert tables.seconds(2.5e-7) == "250 ns"
    assert tables.seconds(12345.0) == "12,345 s"


def test_the_readme_s_table_is_written_from_a_full_run(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.syspath_prepend(str(ROOT / "examples"))
    script = importlib.import_module("measure_table")
    records = [
        a_record(
            method,
            1.0,
            1e-9,
            problem=problem,
            title=problem,
            setting=setting.replace("*", "n = 3"),
            group=OURS if method.startswith("emitted") else PEER,
        )
        for problem, method, setting in tables.README_ROWS
    ]
    source, readme, guide = tmp_path / "measure.json", tmp_path / "README.md", tmp_path / "measure.md"
    extremes = tmp_path / "extremes.md"
    for page, names in ((guide, ("ratios", "growth")), (extremes, ("atlas", "stability"))):
        page.write_text("".join(f"<!-- {name} -->\n<!-- end {name} -->\n" for name in names), encoding="utf-8")
    readme.write_text("before\n<!-- measure -->\nold\n<!-- end measure -->\nafter\n", encoding="utf-8")
    families = {"tasks": records, "growth": grown_records(), "atlas": [a_point()], "stability": [a_search()]}
    found = {"about": {"mode": "full"}, "records": families, "failed": {}}
    source.write_text(json.dumps(found), encoding="utf-8")
    (tmp_path / "T1.svg").write_text("<svg/>", encoding="utf-8")
    assert script.main(source, readme, tmp_path) == ""
    assert (tmp_path / "measure-T1.svg").read_text(encoding="utf-8") == "<svg/>"
    assert all((ROOT / "docs" / name).exists() for name in script.PICTURES.values())
    text = readme.read_text(encoding="utf-8")
    assert text.count("\n| ") == 1 + len(records)
    assert "| 1 |\n" in text  # ours over ours
    assert "| solve_bvp, tol 1e-8 |" in guide.read_text(encoding="utf-8")
    assert "| points^2.00 |" in guide.read_text(encoding="utf-8")
    assert "| tiny | scipy.special.ellipj | 1 |" in extremes.read_text(encoding="utf-8")
    assert "| half_rest | 5 | 2 | 3 | 0.5 | beta=1.0" in extremes.read_text(encoding="utf-8")
    assert text.startswith("before\n")
    assert "old" not in text
    source.write_text(json.dumps(found | {"records": families | {"tasks": records[1:], "atlas": []}}), encoding="utf-8")
    assert "lacks T1/emitted, NumPy/parallel, stable, atlas; run" in script.main(source, readme, tmp_path)
    guide.write_text("no markers\n", encoding="utf-8")
    source.write_text(json.dumps(found), encoding="utf-8")
    assert "measure.md: has no lines <!-- ratios -->" in script.main(source, readme, tmp_path)
    source.write_text("no JSON", encoding="utf-8")
    assert "no result of `derive measure`" in script.main(source, readme, tmp_path)


def a_point() -> dict[str, Any]:
    """A rod of a map, as the atlas keeps it."""
    solver = {"solver": "ellipj", "bounds": 2.0, "ulps": 9.0, "quantity": "y", "failures": ["missed: one"]}
    return {
        "key": "atlas/tiny/0/0",
        "map": "tiny",
        "rod": vars(PAPER),
        "solvers": [solver | {"solver": "ours"}, solver],
    }


def a_search() -> dict[str, Any]:
    """A formula at its worst input, as the searches keep it."""
    called = {"excess": 0.5, "loss": 2.0, "condition": 3.0, "arguments": [1.0]}
    return {"name": "half_rest", "operations": 5, "rod": {**vars(PAPER), "beta": 1.0}, "called": called}


def grown_records() -> list[dict[str, Any]]:
    """A series of which time and memory grow as the square."""
    about = {"series": "a shape", "variable": "points"}
    return [{**about, "amount": n, "seconds": {"median": n * n}, "bytes": n * n} for n in (1, 2, 4)]


@pytest.fixture(autouse=True)
def _no_examples_left() -> Iterator[None]:
    yield
    sys.modules.pop("measure_table", None)
