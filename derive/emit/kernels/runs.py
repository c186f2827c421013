"""The shape of a rod at many points in order: runs of them lie in one bin, and have one series."""

from __future__ import annotations

from math import ldexp
from typing import NamedTuple

import numpy as np

from derive.emit.kernels.expansion import divided, middle_of, period_of, quarter
from derive.emit.kernels.shortening import shortened

ENOUGH = 1500  # points in a run, on average, from which runs are faster than looking up
RUN_BLOCK = 16384  # points at a time, so that they stay in the cache


class Run(NamedTuple):
    """Points first to last − 1, which lie in a cell, periods beyond the clamp's. middle: length from the clamp."""

    first: int
    last: int
    cell: int
    periods: int
    middle: float


def cells_for(equilibrium, bins, points):
    """Into how many cells bins may be divided for runs to be long enough; 0 where not even bins are."""
    if np.any(bins.straight):
        return 0
    average = points * bins.width / equilibrium.rod.length
    return max((cells for cells in (1, 2, 4) if average / cells >= ENOUGH * cells), default=0)


def by_runs(equilibrium, bins, cells, s, position):
    """θ, θ′, y and z at s, which is in rising order; y and z are None without ``position``."""
    rod = equilibrium.rod
    width = bins.width / cells
    rows = series_of(rod, bins, cells, position)
    advance = period_of(equilibrium)[1]
    advances, last = (0.0, 0.0, advance.real, advance.imag), middle_of(equilibrium)
    results = [np.empty(s.size) for _ in rows]
    spare = np.empty(RUN_BLOCK)
    for run in runs_of(equilibrium, bins, width, s):
        for first in range(run.first, run.last, RUN_BLOCK):
            block = slice(first, min(first + RUN_BLOCK, run.last))
            within = spare[: block.stop - first]
            np.multiply(s[block], ldexp(2 / width, rod.scale), out=within)
            within -= run.middle * (2 / width)
            for result, row, step in zip(results, rows, advances, strict=False):
                sum_run(row[run.cell], run.periods * step, within, result[block])
            if last:
                results[0][block] += last
    return results if position else [*results, None, None]


def sum_run(coefficients, shift, within, out):
    """Horner's scheme with the highest power first, and a shift."""
    np.multiply(within, coefficients[0], out=out)
    for coefficient in coefficients[1:-1]:
        out += coefficient
        out *= within
    out += coefficients[-1] + shift


def runs_of(equilibrium, bins, width, s):
    """The runs of points within a cell and a period."""
    rod, count = equilibrium.rod, round(len(bins.straight) * bins.width / width)
    period = period_of(equilibrium)[0]
    edges = np.arange(count + 1) * width
    if period:
        edges = np.minimum(edges, period)
    else:
        edges[-1] = np.inf
    runs = []
    for periods in range(int(rod.length / period) + 1 if period else 1):
        ends = np.searchsorted(s, np.ldexp(period * periods + edges, -rod.scale)).tolist()
        for cell in np.flatnonzero(np.diff(ends)).tolist():
            runs.append(Run(ends[cell], ends[cell + 1], cell, periods, period * periods + (cell + 0.5) * width))
    return runs


def series_of(rod, bins, cells, position):
    """The coefficients by cell, highest power first, of θ, θ′, y and z in a place between −1 and 1.

    They are right to a quarter of the spacing of numbers at 1, in rod lengths for y and z.
    """
    half = bins.width / 2
    places = (bins.place.real, bins.place.imag) if position else ()
    angle, *parts = (divided(part, half, cells) for part in (bins.angle, *places))
    slope = ldexp(cells / half, rod.scale) * np.arange(1, len(angle))[:, None] * angle[1:]
    parts = [angle, slope, *parts]
    length = ldexp(rod.length, -rod.scale)
    units = 1.0, ldexp(1.0, rod.scale), length, length
    return [shortened(part, quarter() * unit)[::-1].T.tolist() for part, unit in zip(parts, units, strict=False)]
