"""The atlas of extremes: its maps are what they say, its peers are right where they can be, and failures are seen."""

from __future__ import annotations

from dataclasses import asdict, replace
from math import pi, sqrt
from types import SimpleNamespace
from typing import Any

import kernel_module
import numpy as np
import pytest
from altered import altered

from derive.cache import Cache
from derive.measure import atlas_points
from derive.measure.atlas_forms import by_ellipj, by_invariants, jacobi
from derive.measure.atlas_maps import MAPS, Map, angles, gamma_ends, loads, powers, stiff
from derive.measure.atlas_peers import PEERS
from derive.measure.atlas_points import OURS, Record, evenly, formula_of, measure_point, peer
from derive.measure.atlas_stiff import bvp, shooting
from derive.measure.bench import atlas
from derive.measure.bench.families import Plan
from derive.measure.hard import hardness
from derive.measure.reference import Rod, solve
from derive.measure.rods import PAPER
from derive.measure.suites import suite
from derive.measure.taylor import integrate
from generated import oblique_numpy, parallel_numpy

TINY = Map(
    "tiny", "two rods", "parallel", "β", "η", ("1", "2"), ("1",), ((PAPER, replace(PAPER, beta=0.0)),), ("ellipj",)
)


# Maps


def test_maps_hold_the_extremes() -> None:
    chart = loads(5)
    assert {0.0, 1e-300} <= {round(rod.beta, 301) for row in chart.rods for rod in row}
    assert max(rod.length * sqrt(rod.eta) for row in chart.rods for rod in row) == pytest.approx(100)
    assert {rod.field_angle for row in loads(3, "oblique").rods for rod in row} == {0.7}
    turned = angles(3)
    assert [rod.clamp_angle for rod in turned.rods[0]] == pytest.approx([-pi, 0, pi])
    assert [row[0].field_angle for row in turned.rods] == pytest.approx([-pi / 2, 0, pi / 2])
    assert stiff(3).rods[0][-1].eta == pytest.approx(1e8)
    assert powers(6, -1) == pytest.approx([-0.1, -(10**-7.5), -1e-14, 1e-14, 10**-7.5, 0.1])


def test_tips_of_the_gamma_map_are_beside_rest() -> None:
    chart = gamma_ends(4)
    rod = chart.rods[0][0]
    assert float(solve(rod, -0.1).values["tip_angle"]) == pytest.approx(-0.1, abs=1e-12)


def test_a_job_is_a_rod(monkeypatch: pytest.MonkeyPatch) -> None:
    quick = list(atlas.jobs(Plan(Cache(enabled=False), quick=True)))
    assert {job.key.split("/")[1] for job in quick} == set(atlas.QUICK) <= set(MAPS)
    assert len({job.key for job in quick}) == len(quick) < 30
    monkeypatch.setattr(atlas, "MAPS", {"tiny": lambda size: TINY})
    whole = list(atlas.jobs(Plan(Cache(enabled=False))))
    assert [job.key for job in whole] == ["atlas/tiny/0/0", "atlas/tiny/0/1"]


# Peers


@pytest.mark.parametrize("form", [by_ellipj, by_invariants])
@pytest.mark.parametrize(("beta", "eta"), [(0.5, 0.8), (0.9, 0.3), (0.1, 1.2), (1.0, 0.0), (0.0, 1.0)])
def test_closed_forms_agree_with_taylor_integration(form: Any, beta: float, eta: float) -> None:
    for tip in (-2.5, 0.4, 1.5, 3.0, 7.0):
        path = integrate(tip, beta, eta, 0.0, 3.0, 20)
        found = form(Rod(beta, eta, 3.0, 0.0), np.array([tip]), 3.0)
        assert found[0] == pytest.approx(float(path.clamp.theta), abs=1e-11)


def test_the_form_by_invariants_knows_any_field() -> None:
    for tip, angle in ((0.3, 0.7), (2.0, -1.1), (-3.0, 1.4)):
        path = integrate(tip, 0.6, 0.9, angle, 2.5, 20)
        found = by_invariants(Rod(0.6, 0.9, 2.5, 0.0, angle), np.array([tip]), 2.5)
        assert found[0] == pytest.approx(float(path.clamp.theta), abs=1e-11)


def test_jacobi_functions_of_m_one_are_hyperbolic() -> None:
    u = np.linspace(0.1, 5, 7)
    sn, cn, _ = jacobi(u, np.ones(7), np.zeros(7))
    assert sn == pytest.approx(np.tanh(u), abs=1e-13)
    assert cn == pytest.approx(1 / np.cosh(u), abs=1e-13)


@pytest.mark.parametrize("name", ["ellipj", "invariants"])
def test_peers_find_all_equilibria_of_the_article_s_rod(name: str) -> None:
    found = PEERS[name].tips
    assert found is not None
    tips, ours = found(PAPER), parallel_numpy.equilibria(PAPER.beta, PAPER.eta, PAPER.length, PAPER.clamp_angle)
    assert tips == pytest.approx([one.tip_angle for one in ours], abs=1e-12)
    values = PEERS[name].values(PAPER, tips[1])
    middle = parallel_numpy.shape(ours[1], 40.0)
    assert (values["y"], values["z(0.5ℓ)"]) == pytest.approx((ours[1].y, middle.z), abs=1e-10)
    assert values["theta(0.25ℓ)"] == pytest.approx(parallel_numpy.shape(ours[1], 20.0).theta, abs=1e-12)


def test_peers_for_stiff_rods_solve_moderate_ones() -> None:
    rod = stiff(2, 3.0).rods[0][1]
    ours = min(parallel_numpy.equilibria(0.0, rod.eta, 1.0, 1.0), key=lambda one: abs(one.tip_angle))
    for solver, near in ((bvp, 1e-6), (shooting, 1e-7)):
        values = solver(rod, None)
        assert (values["tip_angle"], values["y"], values["z"]) == pytest.approx(
            (ours.tip_angle, ours.y, ours.z), abs=near
        )
    with pytest.raises(ValueError, match="below every double"):
        shooting(Rod(0.0, 1e6, 1.0, 1.0), None)
    with pytest.raises(ValueError, match="started only for"):
        bvp(replace(PAPER, field_angle=0.3), None)


# Records


def test_our_module_is_near_its_bound_on_the_article_s_rod() -> None:
    ours, other = measure_point(TINY, 0, 0, 3)["solvers"]
    assert (ours["solver"], ours["number"], ours["compared"]) == (OURS, 3, 3)
    assert 0 < ours["bounds"] < atlas.LIMIT
    assert 1 < ours["ulps"] < 1000
    assert not ours["failures"]
    assert not other["failures"]
    assert ours["condition"] > 1
    assert set(ours["formulas"]) <= {"real roots", "complex roots"}


CHANGES: list[Any] = [
    (lambda found: found[:-1], "wrong number: 2 equilibria instead of 3"),
    (lambda found: [altered(found[0], index=2), *found[1:]], "wrong index: 2 instead of 0"),
    (lambda found: [found[0], found[0], found[2]], "given twice"),
    (lambda found: [altered(found[0], y=float("nan")), *found[1:]], "nan: y is nan"),
    (lambda found: [altered(found[0], tip_angle=found[0].tip_angle + 1e-3), *found[1:]], "no reference"),
    (lambda found: found / 0, "raises: TypeError"),
]


@pytest.mark.parametrize(("change", "words"), CHANGES)
def test_what_fails_is_named(change: Any, words: str, monkeypatch: pytest.MonkeyPatch) -> None:
    wrong = SimpleNamespace(
        equilibria=lambda beta, eta, length, clamp_angle: change(
            parallel_numpy.equilibria(beta, eta, length, clamp_angle)
        ),
        shape=parallel_numpy.shape,
    )
    monkeypatch.setattr(atlas_points, "import_module", lambda _: wrong)
    record = {"key": "atlas/tiny/0/0", **measure_point(replace(TINY, peers=()), 0, 0, 3)}
    assert any(failure.startswith(words) for failure in record["solvers"][0]["failures"])
    (line,) = atlas.wrong([record])
    assert line.startswith("atlas/tiny/0/0: ")
    assert words in line
    assert "beta=0.0" in line


def test_what_a_peer_misses_is_named() -> None:
    ours = parallel_numpy.equilibria(PAPER.beta, PAPER.eta, PAPER.length, PAPER.clamp_angle)
    refined = atlas_points.reference(parallel_numpy, PAPER, ours[0])
    known, record = [(ours[0], refined)], Record("ellipj")
    far = replace(PEERS["ellipj"], tips=lambda rod: [ours[2].tip_angle])
    peer(record, far, PAPER, known, [one.tip_angle for one in ours])
    assert record.failures[0] == "wrong number: 1 equilibria instead of 3"
    assert record.failures[1].startswith("missed: the equilibrium with tip angle 0.83")
    rough = replace(PEERS["ellipj"], tips=lambda rod: [ours[0].tip_angle + 1e-5])
    record = Record("ellipj")
    peer(record, rough, PAPER, known, None)
    assert record.failures[0].startswith("wrong digits: ")


def test_forms_are_told() -> None:
    assert formula_of(parallel_numpy.equilibria(0.0, 0.0, 1.0, 1.0)[0]) == "straight"
    assert formula_of(parallel_numpy.equilibria(1e-200, 0.0, 1.0, 1.0)[0]) == "all but straight"
    long_rod = oblique_numpy.equilibria(0.0, 1e8, 1.0, 2.0, 0.3)
    assert "straight stays" in {formula_of(one) for one in long_rod}
    assert evenly(list("abcdefg"), 3) == ["a", "d", "g"]
    assert evenly(["a"], 3) == ["a"]


@pytest.mark.parametrize("beta", [6.309573444801944, 1.0])
def test_rods_at_the_level_of_a_ridge_have_an_odd_number(beta: float) -> None:
    found = parallel_numpy.equilibria(beta, 1e4, 1.0, 3 * pi / 4)
    assert all(one.index % 2 == k % 2 for k, one in enumerate(found))


# What is shown


def made(name: str, shape: tuple[int, int], failures: list[list[str]]) -> list[dict[str, Any]]:
    """Records of a map of which each rod fails in its own way, and errs more than the one before."""
    records = []
    for k, failure in enumerate(failures):
        row, column = divmod(k, shape[1])
        solvers = [
            asdict(Record(solver, 3, 3, 1.0, 10.0**k, "y", 1.0, ["straight"], failure, 0.1))
            for solver in (OURS, "ellipj")
        ]
        about = {"key": f"atlas/{name}/{row}/{column}", "map": name, "title": name, "labels": ["β", "η"]}
        place = {"shape": shape, "row": row, "column": column, "at": [f"{column + 1}", f"{row + 1}"]}
        records.append({**about, **place, "rod": vars(PAPER), "solvers": solvers})
    return records


def test_tables_name_failures_and_rods_beyond_the_bound() -> None:
    lines = atlas.document(made("tiny", (1, 3), [[], ["no value: none"], ["wrong number: 1", "wrong number: 2"]]))
    assert "| tiny | ours | 3 | 10 | 1e+02 | 1 | no value 1, wrong number 1 |" in lines
    assert "We err by more than the bound on 2 of 3 rods." in lines
    assert lines[-2].startswith("- tiny: y errs by 1e+02 bounds; wrong number: 1; wrong number: 2 at beta=")


def test_peers_that_are_not_installed_are_left_out_and_named(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("derive.measure.packages.find_spec", lambda name: None)
    found = measure_point(TINY, 0, 0, 1)
    assert [one["solver"] for one in found["solvers"]] == [OURS]
    assert atlas.document([found])[-1].startswith("- left out, for scipy cannot be imported: ellipj, invariants, solve")


def test_pictures_show_failures() -> None:
    pytest.importorskip("matplotlib")
    from derive.diagrams.atlas_picture import pictures

    failures = [[], ["no value: none"], ["wrong number: 1"], ["odd: it is"]]
    records = made("square", (2, 2), failures) + made("tiny", (1, 4), failures)
    for kind in ("svg", "png"):
        found = dict(pictures(records, kind))
        assert list(found) == ["atlas-square", "atlas-tiny"]
        assert found == dict(pictures(records, kind))
    assert "wrong number of equilibria" in signs_of(records)


def signs_of(records: list[dict[str, Any]]) -> set[str]:
    """What the legend of a map says of failures."""
    from derive.diagrams.atlas_picture import mark, of

    shown: dict[str, str] = {}
    mark(SimpleNamespace(plot=lambda *place, **style: None), of(records, OURS), shown)
    return set(shown)


@pytest.mark.long
@pytest.mark.parametrize("case", ["parallel", "oblique"])
def test_the_worst_points_of_the_atlas_are_within_its_limit(case: str) -> None:
    """Those that it named once, in the suites ever since."""
    found = hardness(kernel_module, suite("atlas", case), most=3)
    assert not found.faults
    assert {name: worst for name, worst in found.bounds.items() if not worst.by <= atlas.LIMIT} == {}
