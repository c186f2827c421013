"""Maps of the atlas as SVG inside the page: a square for each rod, a panel for each solver, failures crossed out."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import Any

from markupsafe import Markup

from derive.measure.atlas_points import TITLES
from derive.report.page.chart import text

SIDE, GAP, TOP, LINE = 16, 24, 22, 16  # of a square, between panels, above them, and a line of words
INSIDE = 4  # from the sides of a square to a cross in it
LEAST_PANEL = 190  # so that titles do not run into one another
LEAST_WIDTH = 840  # the page scales pictures to its width; squares should be alike in all
LOWEST, HIGHEST = -1.0, 16.0  # powers of ten of the error in bounds
# From dark blue to yellow by way of grey: the ends and the middle of cividis, which colour-blind readers tell apart.
RAMP = ((0, 34, 78), (124, 123, 120), (254, 232, 56))


def heat(records: Sequence[Mapping[str, Any]]) -> Markup:
    """A map: the errors of all its solvers side by side, the first row of rods at the bottom."""
    rows, columns = records[0]["shape"]
    solvers = [one["solver"] for one in records[0]["solvers"]]
    step = max(columns * SIDE, LEAST_PANEL) + GAP
    parts = []
    for number, solver in enumerate(solvers):
        parts.append(text(number * step, TOP - 8, TITLES.get(solver, solver)))
        for record in records:
            (one,) = [one for one in record["solvers"] if one["solver"] == solver]
            parts.append(square(record, one, number * step, TOP + (rows - 1 - record["row"]) * SIDE))
    across, up = records[0]["labels"]
    below = TOP + rows * SIDE + LINE
    parts.append(text(0, below, f"across: {across}{f'; up: {up}' if up else ''}"))
    parts.append(text(0, below + LINE, "dark: 0.1 bounds and less; yellow: no digit is right; crossed: a failure"))
    shape = Markup('<svg viewBox="0 0 {} {}" role="img" aria-label="errors of each solver, {}">{}</svg>')
    width = max(len(solvers) * step, LEAST_WIDTH)
    return shape.format(width, below + LINE + 6, records[0]["title"], Markup("").join(parts))


def square(record: Mapping[str, Any], one: Mapping[str, Any], left: float, top: float) -> Markup:
    """One rod; its title says where it is, the error and the failures."""
    x = left + record["column"] * SIDE
    error = "no value" if one["bounds"] is None else f"{one['bounds']:.2g} bounds"
    said = "; ".join([", ".join(record["at"]), error, *one["failures"]])
    shape = Markup('<g><rect x="{}" y="{}" width="{}" height="{}" fill="{}"/>{}<title>{}</title></g>')
    cross = Markup('<path class="cross" d="M{},{}l{},{}m0,-{}l-{},{}"/>')
    arm = SIDE - 1 - 2 * INSIDE
    crossed = cross.format(x + INSIDE, top + INSIDE, *[arm] * 5) if one["failures"] else Markup("")
    return shape.format(x, top, SIDE - 1, SIDE - 1, colour(one["bounds"]), crossed, said)


def colour(bounds: float | None) -> str:
    """That of an error; white where there is none."""
    if bounds is None:
        return "#ffffff"
    power = math.log10(max(bounds, 10**LOWEST))
    share = min(max((power - LOWEST) / (HIGHEST - LOWEST), 0.0), 1.0) * 2
    low, high = (RAMP[0], RAMP[1]) if share < 1 else (RAMP[1], RAMP[2])
    mixed = (round(a + (b - a) * (share % 1 if share < 2 else 1)) for a, b in zip(low, high, strict=True))
    return "#" + "".join(f"{part:02x}" for part in mixed)
