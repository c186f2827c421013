"""Run the emitted modules on the hard suites: worst errors into docs/hard_rods.md, a row for each suite into README.

python examples/hard_table.py [most]

most: of a rod with more equilibria, only so many are refined to 40 digits (2 unless told, which takes some minutes).
Faults are printed, and the exit code is then 1.
"""

from __future__ import annotations

import sys
from importlib import import_module
from math import sqrt

from verdict_tables import put

from derive.measure.hard import Hardness, exact, hardness
from derive.measure.suites import SUITES, Case, suite

CASES = ("field_only", "force_only", "parallel", "orthogonal", "oblique")
SHOWN = ("tip_angle", "y", "z", "energy", "theta(s)", "curvature(s)", "y(s)", "z(s)")
PLACES = ("y", "z", "y(s)", "z(s)")
ANGLES = ("tip_angle", "theta(s)")
EACH = 12  # rods of a suite and load case, evenly chosen
LONGEST = 300.0  # ℓ√(β + η); a reference for more takes seconds


def chosen(name: str, case: str) -> list[Case]:
    """Some rods of a suite, evenly."""
    known = [one for one in suite(name, case) if one.rod.length * sqrt(one.rod.beta + one.rod.eta) <= LONGEST]
    return known[:: max(1, -(-len(known) // EACH))]


def measured(name: str, most: int) -> Hardness:
    """A suite over all load cases whose modules there are."""
    result = Hardness()
    for case in CASES:
        try:
            module = import_module(f"generated.{case}_numpy")
        except ModuleNotFoundError:
            print(f"{case}: no module; run `derive emit`", file=sys.stderr)
            continue
        result.take(hardness(module, chosen(name, case), most=most))
    return result


def summary(name: str, found: Hardness) -> str:
    """A row for a suite: its worst place in ulps of ℓ and in bounds, worst angle and energy, and where the place is."""
    place, angle, energy = (
        max((found.bounds[one] for one in names if one in found.bounds), key=lambda worst: worst.by)
        for names in (PLACES, ANGLES, ("energy",))
    )
    ulps = max(found.ulps[one].by for one in PLACES if one in found.ulps)
    numbers = f"{found.equilibria} | {ulps:.2g} | {place.by:.2g} | {angle.by:.2g} | {energy.by:.2g}"
    return f"| {name} | {numbers} | {place.name}: {exact(place.rod)} |"


def main(most: int) -> int:
    """Measure and write; 1 if anything is wrong in kind."""
    lines = ["| suite | quantity | worst error, ulps of its size | in bounds | where |", "|---|---|---|---|---|"]
    short = [
        "| suite | equilibria | worst place, ulps of ℓ | in bounds | angles, in bounds | energy, in bounds | where |",
        "|---|---|---|---|---|---|---|",
    ]
    faults = []
    for name in SUITES:
        found = measured(name, most)
        lines += found.rows(name, SHOWN)
        short.append(summary(name, found))
        faults += found.faults
    put("hard", lines)
    put("suites", short)
    for fault in faults:
        print(fault, file=sys.stderr)
    return 1 if faults else 0


if __name__ == "__main__":
    raise SystemExit(main(int(sys.argv[1]) if len(sys.argv) > 1 else 2))
