"""The sweep on arrays gives what the scalar solver gives, rod by rod."""

from __future__ import annotations

import tracemalloc
from collections.abc import Sequence
from math import pi
from typing import Any

import numpy as np
import pytest
from mpmath import mpf
from runge_kutta import angle_after
from spying import calls_of

from derive.emit.kernels import blocks
from derive.emit.kernels.block_records import rows
from derive.emit.kernels.block_tips import Columns, no_columns
from derive.emit.kernels.blocks import sweep_arrays as sweep_grid
from derive.emit.kernels.equilibria import all_equilibria
from derive.measure.reference import Rod, solve

RODS = 40  # of each scene
# Many tips of these are nearer to another than rounding, and motions pass close by a ridge.
LONG_RODS = [
    (0.14415961271963373, 1.2469795110750008, 101.93823924318994, -4.070065403351004, -0.6),
    (0.027559113243068367, 0.1246991582997512, 354.681672938378, 1.4795640811798592, pi / 2),
    (0.5412268555474342, 1.7104539485741403, 146.86619902731087, 1.4255282686199102, -0.6),
]
# With a tip of each: their places were off by 1.2 to 1.8 times what is allowed.
ROUGH_RODS = [
    ((903.3, 30.79, 0.118, 1.745, 0.0), 4.539442119267078),
    ((31.49, 0.0, 0.687, -2.21, 0.0), -4.175230282113994),
    ((77.47, 88.83, 0.274, 2.272, -0.313), 5.276366242519344),
    ((0.17483553789762363, 0.8251644621023764, 4.372255993797518, -2.604356465229663, pi / 2), -4.7989351708965104),
    ((0.0, 1.0, 4.178383619792231, -1.9974801418839436, 0.0), -3.1020761336418405),
]
FIELDS = ("tip_angle", "clamp_curvature", "gamma", "y", "z", "energy", "index")


def sweep_arrays(rods: Sequence[np.ndarray], most: int | None = None) -> Columns:
    """The sweep over rods whose parameters are arrays of one length."""
    beta, eta, length, clamp_angle, field_angle = rods
    return sweep_grid(beta, eta, length, clamp_angle, field_angle, beta.shape, most)


def random_rods(scene: str, seed: int, count: int = RODS) -> list[np.ndarray]:
    """Rods of one scene: β, η, length, clamp angle, field angle; a quarter of the clamps are along special angles."""
    rng = np.random.default_rng(seed)
    beta, eta = rng.random(count), 2 * rng.random(count)
    oblique = rng.choice([0.3, 1.2, -0.6], count)
    field = {"parallel": 0 * beta, "orthogonal": 0 * beta + pi / 2}.get(scene, oblique)
    if scene == "force":
        eta, field = 0 * eta, 0 * field
    if scene == "field":
        beta = 0 * beta
    length = 10 ** rng.uniform(-1, 1.2, count)
    clamp = np.where(rng.random(count) < 0.25, rng.choice([0, pi / 2, pi, -pi], count), rng.uniform(-7, 7, count))
    return [beta, eta, length, clamp, field]


def scalar_rows(rods: list[np.ndarray], case: int, most: int | None = None) -> np.ndarray:
    """The scalar solver's equilibria of one rod, a row each."""
    found = all_equilibria(*(float(part[case]) for part in rods), most)
    return np.array([[getattr(item, name) for name in FIELDS] for item in found]).reshape(len(found), 7)


def table_rows(table: Columns, case: int) -> np.ndarray:
    """The sweep's equilibria of one rod, a row each."""
    return np.array([getattr(table, name) for name in FIELDS]).T[table.case == case]


def assert_alike(ours: np.ndarray, theirs: np.ndarray, length: float) -> None:
    """The same equilibria, to rounding: near folds the tips are as uncertain as the square root of rounding allows."""
    assert ours.shape == theirs.shape
    assert np.array_equal(ours[:, -1], theirs[:, -1])
    assert np.allclose(ours, theirs, rtol=1e-9, atol=1e-9 * (1 + length))


@pytest.mark.parametrize("scene", ["force", "field", "parallel", "orthogonal", "oblique"])
def test_same_equilibria_as_the_scalar_solver(scene: str) -> None:
    rods = random_rods(scene, 7)
    table = sweep_arrays(rods)
    assert table.case.size > RODS
    for case in range(RODS):
        assert_alike(table_rows(table, case), scalar_rows(rods, case), rods[2][case])


@pytest.mark.parametrize(("rod", "tip"), ROUGH_RODS)
def test_places_keep_their_bound(rod: tuple[float, ...], tip: float) -> None:
    """Four roundings of the length and what one rounding of the inputs makes, as the scalar solver does."""
    wanted = solve(Rod(*rod), tip, 25)
    table = sweep_arrays([np.full(blocks.FEWEST, part) for part in rod])
    row = np.abs(table.tip_angle - tip).argmin()
    for name, size in (("y", rod[2]), ("z", rod[2]), ("tip_angle", 1.0)):
        error = abs(float(mpf(float(getattr(table, name)[row])) - wanted.values[name]))
        assert error < 2.0**-52 * (4 * size + wanted.sensitivity[name])


def test_only_the_indices_asked_for() -> None:
    rods = random_rods("oblique", 8)
    everything, stable = sweep_arrays(rods), sweep_arrays(rods, 0)
    assert np.array_equal(stable.case, everything.case[everything.index == 0])
    # Secants stop at round-off of different size for different neighbours in an array: near folds, its square root.
    assert np.allclose(stable.tip_angle, everything.tip_angle[everything.index == 0], rtol=1e-9, atol=1e-9)


def test_blocks_do_not_change_the_result(monkeypatch: pytest.MonkeyPatch) -> None:
    rods = random_rods("parallel", 9)
    whole = sweep_arrays(rods)
    monkeypatch.setattr(blocks, "BLOCK", 7)
    parts = sweep_arrays(rods)
    assert np.array_equal(whole.case, parts.case)
    assert np.allclose(whole.tip_angle, parts.tip_angle, rtol=1e-12, atol=1e-12)


def test_every_rod_with_its_own_field_angle() -> None:
    rods = random_rods("oblique", 10, 6)
    rods[4] = np.linspace(-1, 1, 6)
    table = sweep_arrays(rods)
    for case in range(6):
        assert_alike(table_rows(table, case), scalar_rows(rods, case), rods[2][case])


def test_rods_on_which_nothing_acts_and_very_long_ones() -> None:
    rods = [np.array(column) for column in ([0.0, 0.0], [0.0, 1.0], [2.0, 300.0], [1.0, 2.0], [0.0, 0.0])]
    table = sweep_arrays(rods, 1)
    for case in range(2):
        assert_alike(table_rows(table, case), scalar_rows(rods, case, 1), rods[2][case])


def test_few_rods_are_left_to_the_scalar_solver(monkeypatch: pytest.MonkeyPatch) -> None:
    left = calls_of(monkeypatch, blocks, "one_by_one")
    eta = np.linspace(0, 0.001, 200)
    sweep_arrays([np.full(200, 0.00035), eta, np.full(200, 80.0), np.full(200, 3 * pi / 4), np.zeros(200)])
    assert len(left) < 10


def test_no_rods() -> None:
    assert sweep_arrays([np.zeros(0)] * 5).case.size == 0


def tips_by_integration(beta: float, eta: float, length: float, clamp: float, field: float) -> np.ndarray:
    """Tip angles between which the angle at the clamp passes the clamp angle."""
    tips = np.linspace(clamp - 2 * pi, clamp + 2 * pi, 6001)
    angle = angle_after(tips, length, beta, eta, field)
    passes = np.flatnonzero((angle[1:] > clamp) != (angle[:-1] > clamp))
    return (tips[passes] + tips[passes + 1]) / 2


def test_a_pair_of_tips_far_from_the_ends_of_a_range_is_found() -> None:
    rod = (0.7106467590526012, 1.366048108718744, 9.836250215206718, -2.7568992529771696, -0.9)
    # As many as are not left to the scalar solver.
    table = sweep_arrays([np.full(blocks.FEWEST, part) for part in rod])
    integrated = tips_by_integration(*rod)
    for case in range(blocks.FEWEST):
        found = table.tip_angle[table.case == case]
        assert found.shape == integrated.shape
        assert np.allclose(found, integrated, atol=4 * pi / 6000)


def test_no_wide_step_beside_a_narrow_one_hides_a_pair() -> None:
    rod = (1.1514166848626897, 1.1514166848626897, 17.461037970950017, 3.141592653589794, 0.3)
    tips = np.array([one.tip_angle for one in all_equilibria(*rod, None)])
    swept = sweep_arrays([np.full(blocks.FEWEST, part) for part in rod])
    for tip in tips_by_integration(*rod):
        assert min(abs(tips - tip)) < 4 * pi / 6000
    assert np.allclose(swept.tip_angle[swept.case == 3], tips)


def test_long_rods_keep_the_order_of_tips_that_are_nearer_than_rounding() -> None:
    rods = [np.array(column) for column in zip(*LONG_RODS * 6, strict=True)]
    table = sweep_arrays(rods)
    for case, rod in enumerate(LONG_RODS):
        assert_alike(table_rows(table, case), scalar_rows(rods, case), rod[2])


def test_memory_is_bounded_by_the_block(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(blocks, "BLOCK", 256)
    peaks = []
    for number in (2, 16):
        beta, eta = np.linspace(1, 2, number)[:, None], np.linspace(0.1, 4, 256)
        grid = np.broadcast_shapes(beta.shape, eta.shape)
        given = (np.broadcast_to(part, grid) if part is beta else part for part in (beta, eta))
        tracemalloc.start()
        table = sweep_grid(*given, np.array(1.5), np.array(1.0), np.array(0.0), grid, 0)
        peaks.append(tracemalloc.get_traced_memory()[1])
        tracemalloc.stop()
        # The result, and the parts of the column that is joined last.
        peaks[-1] -= sum(column.nbytes for column in table) + table.index.nbytes
    assert peaks[1] < 1.2 * peaks[0]


@pytest.mark.parametrize("most", [None, 0])
def test_a_rod_of_which_an_equilibrium_is_missing_is_left_to_the_scalar_solver(
    most: int | None, monkeypatch: pytest.MonkeyPatch
) -> None:
    rods = random_rods("parallel", 11)
    whole, on_arrays = sweep_arrays(rods, most), blocks.on_arrays

    def lacking(*given: Any) -> Any:
        found, left = on_arrays(*given)
        # The first of each rod is missing, or with it every one of index 0.
        return rows(found, found.index > 0 if most == 0 else all_but_first(found.case)), left

    monkeypatch.setattr(blocks, "on_arrays", lacking)
    table = sweep_arrays(rods, most)
    assert np.array_equal(table.case, whole.case)
    assert np.allclose(table.tip_angle, whole.tip_angle, rtol=1e-9, atol=1e-9)


def all_but_first(case: np.ndarray) -> np.ndarray:
    """All rows but the first of each rod."""
    return np.setdiff1d(np.arange(case.size), np.unique(case, return_index=True)[1])


def test_no_answer_at_all_is_asked_of_the_scalar_solver(monkeypatch: pytest.MonkeyPatch) -> None:
    rods = random_rods("oblique", 12)
    whole = sweep_arrays(rods)
    monkeypatch.setattr(blocks, "on_arrays", lambda *given: (no_columns(), np.zeros(0, dtype=int)))
    assert np.array_equal(sweep_arrays(rods).case, whole.case)
