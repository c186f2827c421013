"""Every example runs in seconds, and shows what it says it shows."""

from __future__ import annotations

import importlib.util
from pathlib import Path
from types import ModuleType

import numpy as np
import pytest
from pages import ROOT

FOLDER = ROOT / "examples"
# Script, the file it writes, and lines that it prints.
EXAMPLES = {
    "fold_set": ("folds.csv", ["exchange at β = 0.000306990, η = 0.000430492"]),
    "hysteresis": ("loop.csv", ["it begins at θ(ℓ) = 2.5495 and ends at 2.5495", "0.1396 lost in a cycle"]),
    "load_map": ("map.svg", ["1111111111113333331111111111111111111111133333333", "3401 equilibria of 1225 rods"]),
    "precise_twin": ("", ["length 200: 5 equilibria by one, 5 by the other", "0.018725601456088107788388954"]),
}
# Those that measure for minutes, or write the tables of the documentation.
MEASURING = {"hard_table", "measure_table", "readme_tables", "scene_table", "speed_table", "verdict_tables"}
DERIVING = {"permanent_magnet"}  # run in test_own_energy_modules.py


def script(name: str) -> ModuleType:
    spec = importlib.util.spec_from_file_location(name, FOLDER / f"{name}.py")
    assert spec
    assert spec.loader
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


@pytest.mark.parametrize("name", EXAMPLES)
def test_an_example_runs(name: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file, lines = EXAMPLES[name]
    script(name).main(*([tmp_path / file] if file else []))
    printed = capsys.readouterr().out
    for line in lines:
        assert line in printed
    assert not file or (tmp_path / file).stat().st_size > 100


def test_the_example_of_hysteresis_closes_its_loop(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    module = script("hysteresis")
    monkeypatch.setattr(module, "ANGLES", module.ANGLES[::5])
    module.main(tmp_path / "loop.csv")
    angle, forth, back = np.loadtxt(tmp_path / "loop.csv", delimiter=",", skiprows=1, unpack=True)
    assert len(angle) == len(module.ANGLES)
    assert forth[0] == back[0]
    assert forth[-1] == back[-1]
    assert np.sum(np.abs(forth - back) > 1) > 10


def test_every_script_is_run_or_measures() -> None:
    scripts = {path.stem for path in FOLDER.glob("*.py")}
    assert scripts == set(EXAMPLES) | MEASURING | DERIVING
    index = (ROOT / "docs" / "index.md").read_text(encoding="utf-8")
    for name in scripts:
        assert f"(../examples/{name}.py)" in index, f"docs/index.md does not list {name}"
