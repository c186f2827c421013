"""`derive solve`: rods in physical units, pictures, shapes, and settings that reach a target."""

from __future__ import annotations

import csv
import json
import math
import sys
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest

from derive.cli import main
from derive.diagrams import particle, picture, rod_file
from derive.diagrams.plotting import FORMATS
from derive.diagrams.target import reaching
from derive.emit.kernels.folds import all_folds
from generated import oblique_numpy, parallel_numpy

ROOT = Path(__file__).resolve().parent.parent
EXAMPLE = ROOT / "examples" / "rod.toml"
NUMBERS = {"beta": 0.00035, "eta": 0.00052, "length": 80.0, "clamp_angle": 3 * math.pi / 4}
ROD = ["--beta", "0.00035", "--eta", "0.00052", "--length", "80", "--clamp-angle", "3*pi/4"]
AIMED = ["solve", "parallel", *ROD[:2], *ROD[4:]]


def test_demagnetizing_factors_have_unit_trace_and_known_values() -> None:
    for aspect in (1.0, 1.001, 3.0, 10.0, 1e4):
        along, across = particle.demagnetizing(aspect)
        assert along + 2 * across == pytest.approx(1, abs=1e-14)
    assert particle.demagnetizing(1.0)[0] == pytest.approx(1 / 3, abs=1e-15)
    # The closed form with logarithms, another expression of the same factor.
    m = 10.0
    root = math.sqrt(m * m - 1)
    assert particle.demagnetizing(m)[0] == pytest.approx((m / root * math.acosh(m) - 1) / root**2, rel=1e-13)


def test_the_rod_file_becomes_the_dimensionless_rod() -> None:
    rod = rod_file.read_rod(EXAMPLE)
    n_along, n_across = particle.demagnetizing(10)
    chi = 1 / (1 / 1000 + n_along) - 1 / (1 / 1000 + n_across)
    bending = 1e6 * math.pi / 64 * 1e-12
    modulus = math.pi / 4 * 1e-6 * 0.1 * chi * 0.01**2 / particle.MU0
    values = rod.parameters()
    assert values["eta"] == pytest.approx(modulus / bending * 1e-6, rel=1e-12)
    assert values["beta"] == pytest.approx(0.05e-3 / bending * 1e-6, rel=1e-12)
    assert values["length"] == 40
    assert values["clamp_angle"] == pytest.approx(3 * math.pi / 4)
    assert rod.field_of(rod.eta(7.5)) == pytest.approx(7.5)
    assert rod.force_of(rod.beta(0.3)) == pytest.approx(0.3)


def test_units_do_not_change_the_rod(tmp_path: Path) -> None:
    text = EXAMPLE.read_text().replace("40 mm", "0.04 m").replace("135 degree", "2.356194490192345 rad")
    text = text.replace("10 mT", f"{0.01 / particle.MU0} A/m").replace("0.05 mN", "50 µN")
    (tmp_path / "rod.toml").write_text(text)
    one, other = rod_file.read_rod(EXAMPLE), rod_file.read_rod(tmp_path / "rod.toml")
    for name, power in (("eta", 2), ("beta", 2), ("length", -1)):
        assert other.parameters()[name] == pytest.approx(one.parameters()[name] * 1000**power, rel=1e-12)
    assert other.units["length"] == "meter"


MISTAKES = [
    ('length = "40 mm"', 'length = "5 kg"', ("length", "no length")),
    ('length = "40 mm"', "length = 40", ("length", "no unit")),
    ('length = "40 mm"', 'length = "40"', ("length", "no length")),
    ('length = "40 mm"', 'length = "-40 mm"', ("length", "positive")),
    ('length = "40 mm"', 'length = "nan mm"', ("length", "finite")),
    ('length = "40 mm"', 'length = "40 mmm("', ("length", "is no unit")),
    ('length = "40 mm"', 'length = "0.4 mm"', ("diameter", "longer")),
    ('length = "40 mm"', "", ("length is missing", "length = ")),
    ('length = "40 mm"', 'length = "40 mm"\nlenght = "4 mm"', ("lenght: unknown key", "possible")),
    ('length = "40 mm"', "length = ", ("no TOML",)),
    ("volume_fraction = 0.1", "volume_fraction = 10", ("volume_fraction", "between 0 and 1")),
    ("aspect_ratio = 10", "aspect_ratio = 0.5", ("aspect_ratio", "above 1")),
    ("susceptibility = 1000", "susceptibility = nan", ("susceptibility", "finite")),
    ("susceptibility = 1000", "susceptibility = -1", ("susceptibility", "positive")),
    ('force = "0.05 mN"', 'force = "-1 mN"', ("force", "along y")),
    ('field = "10 mT"', 'field = "10 Pa"', ("field", "no field")),
    ('clamp_angle = "135 degree"', 'clamp_angle = "135"', ("clamp_angle", "no unit")),
]


@pytest.mark.parametrize(("old", "new", "words"), MISTAKES)
def test_mistakes_in_a_rod_file_are_one_line(
    old: str, new: str, words: tuple[str, ...], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert old in EXAMPLE.read_text()
    (tmp_path / "rod.toml").write_text(EXAMPLE.read_text().replace(old, new))
    assert main(["solve", "--rod", str(tmp_path / "rod.toml")]) == 2
    err = capsys.readouterr().err
    assert err.count("\n") == 1
    assert all(word in err for word in ("rod.toml", *words))


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["solve"], "no rod is given"),
        (["solve", "parallel", "--rod", str(EXAMPLE)], "leave out the scene"),
        (["solve", "--rod", str(EXAMPLE), "--eta", "1"], "--eta is given by the file"),
        (["solve", "parallel", *ROD, "--plot", "rod.gif"], "must end in .svg, .png, .pdf"),
        (["solve", "parallel", *ROD, "--points", "1"], "--points must be at least 2"),
        (["solve", "parallel", *ROD, "--max-index", "-1"], "--max-index must be at least 0"),
        (["solve", "parallel", *ROD, "--target", "y=1"], "--eta is what is sought"),
        ([*AIMED, "--target", "x=1"], "is no target"),
        ([*AIMED, "--target", "y=one"], "--target y"),
        ([*AIMED, "--target", "y=200"], "the tip's y lies between"),
        ([*AIMED, "--target", "y=-20", "--range", "1:0"], "is empty"),
        ([*AIMED, "--target", "y=-20", "--range=-1:1"], "below 0"),
        ([*AIMED, "--target", "y=-20", "--range", "1"], "LOW:HIGH"),
        ([*AIMED, *ROD[2:4], "--target", "y=-20", "--vary", "field-angle"], "--field-angle is no parameter"),
    ],
)
def test_mistakes_in_options_are_one_line(
    arguments: list[str], message: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(arguments) == 2
    err = capsys.readouterr().err
    assert message in err
    assert err.count("\n") == 1


def test_files_hold_the_shapes_and_a_picture(tmp_path: Path) -> None:
    files = ["--csv", str(tmp_path / "a.csv"), "--points", "11", "--plot", str(tmp_path / "a.svg")]
    assert main(["solve", "parallel", *ROD, *files]) == 0
    rows = list(csv.DictReader((tmp_path / "a.csv").read_text().splitlines()))
    assert len(rows) == 33
    first = parallel_numpy.equilibria(**NUMBERS)[0]
    assert float(rows[10]["y"]) == pytest.approx(first.y)
    assert float(rows[10]["theta"]) == pytest.approx(first.tip_angle)
    assert (tmp_path / "a.svg").read_text().startswith("<?xml")


def test_a_scene_without_shapes_is_drawn_all_the_same(tmp_path: Path) -> None:
    command = ["solve", "bifurcation", *ROD[:4], "--csv", str(tmp_path / "a.csv"), "--points", "5"]
    assert main(command) == 0
    rows = list(csv.DictReader((tmp_path / "a.csv").read_text().splitlines()))
    found = parallel_numpy.equilibria(**NUMBERS)
    assert float(rows[4]["z"]) == pytest.approx(found[0].z, abs=1e-9)


@pytest.mark.parametrize("suffix", FORMATS)
def test_pictures_come_in_three_kinds(suffix: str) -> None:
    curve = picture.Curve(1, 1, 0.5, [0.0, 1.0], [0.0, 1.0])
    view = picture.View(1.5, 0.7, 1.0, True, "mm", "")
    start = {"svg": b"<?xml", "png": b"\x89PNG", "pdf": b"%PDF"}[suffix]
    assert picture.drawn([curve], view, suffix).startswith(start)


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="no device that is always full")
def test_a_full_disk_is_one_line(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["solve", "parallel", *ROD, "--csv", "/dev/full"]) == 2
    assert "/dev/full: cannot be written" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("package", "arguments"),
    [("matplotlib", ["parallel", *ROD, "--plot", "a.svg"]), ("pint", ["--rod", str(EXAMPLE)])],
)
def test_a_missing_package_is_named(
    package: str, arguments: list[str], monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    from derive.diagrams import units

    monkeypatch.setitem(sys.modules, package, None)
    units.registry.cache_clear()
    assert main(["solve", *arguments]) == 2
    assert "pip install 'magnetic-rods[" in capsys.readouterr().err
    units.registry.cache_clear()


def test_the_setting_found_brings_the_tip_there(tmp_path: Path) -> None:
    out = tmp_path / "a.json"
    assert main(["solve", "--rod", str(EXAMPLE), "--target", "y=-2 cm", "--json", str(out)]) == 0
    (found,) = json.loads(out.read_text())["solutions"]
    text = EXAMPLE.read_text().replace("10 mT", f"{found['field']!r} mT")
    (tmp_path / "rod.toml").write_text(text)
    assert main(["solve", "--rod", str(tmp_path / "rod.toml"), "--json", str(out)]) == 0
    ys = [one["y"] for one in json.loads(out.read_text())["equilibria"]]
    assert min(abs(y + 20) for y in ys) < 1e-9


def test_a_thick_rod_is_warned_about(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "rod.toml").write_text(EXAMPLE.read_text().replace('"1 mm"', '"9 mm"'))
    assert main(["solve", "--rod", str(tmp_path / "rod.toml")]) == 0
    assert "warning: ε is above" in capsys.readouterr().err


@pytest.mark.parametrize("vary", ["eta", "beta", "field_angle"])
def test_no_setting_is_missed(vary: str) -> None:
    """Against sign changes between many plain samples, on a rod with several folds."""
    base = {**NUMBERS, "eta": 0.004, "field_angle": 0.3}
    low, high = 0.0, {"eta": 0.008, "beta": 0.008, "field_angle": math.pi}[vary]

    def solve(value: float) -> list[oblique_numpy.Equilibrium]:
        return oblique_numpy.equilibria(**{**base, vary: value})

    cuts = []
    if vary == "eta":
        cuts = [fold.eta for fold in all_folds(base["beta"], 80.0, base["clamp_angle"], 0.3, low, high)]
    samples = [[one.y for one in solve(value)] for value in np.linspace(low, high, 101)]
    for goal in (-43.21, 5.37):
        found = reaching(solve, "y", goal, low, high, cuts)
        assert all(abs(hit.equilibrium.y - goal) < 1e-8 for hit in found.hits)
        seen = sum(
            (a - goal) * (b - goal) < 0
            for one, two in pairwise(samples)
            if len(one) == len(two)
            for a, b in zip(one, two, strict=True)
        )
        assert len(found.hits) >= seen > 0
