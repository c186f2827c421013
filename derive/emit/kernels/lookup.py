"""The shape of a rod at points in any order: a table of short power series, looked up and summed block by block."""

from __future__ import annotations

from math import ldexp
from typing import Any, NamedTuple

import numpy as np

from derive.emit.kernels.expansion import cells_in_bin, period_of, series, state_within

BLOCK = 8192  # points at a time, so that what is gathered for them stays in the cache
DEGREE = 7  # of the short series: two gathers of four coefficients


class Table(NamedTuple):
    """Short power series in cells: two times four coefficients by row, for θ, y and z.

    period: of θ in the length from the tip, or 0 where the cells cover the rod. advance: y + iz over a period.
    per_bin: first row and number of cells of each bin, where those differ; else None. slope: θ′ per change in a cell.
    """

    start: float
    cells: float
    per_bin: Any
    rows: tuple
    period: float
    advance: complex
    slope: float


def by_lookup(equilibrium, bins, s, position):
    """θ, θ′, y and z at s; y and z are None without ``position``."""
    table = table_of(equilibrium, bins, position)
    results = [np.empty(s.size) for _ in range(4 if position else 2)]
    spare = Spare(*(np.empty(BLOCK) for _ in range(3)), np.empty((BLOCK, 4)), np.empty(BLOCK, dtype=np.intp))
    for first in range(0, s.size, BLOCK):
        block = slice(first, min(first + BLOCK, s.size))
        fill(equilibrium.rod, table, s[block], [part[block] for part in results], spare)
    return results if position else [*results, None, None]


class Spare(NamedTuple):
    """Room for a block: place within its cell, whole cells, periods, gathered coefficients, rows."""

    within: Any
    whole: Any
    periods: Any
    gathered: Any
    row: Any


def fill(rod, table, s, results, spare):
    """The values of a block of points."""
    within, whole, periods, gathered, row = (part[: s.size] for part in spare)
    np.multiply(s, -ldexp(1.0, rod.scale), out=within)
    within += rod.length
    if table.period:
        np.multiply(within, 1 / table.period, out=periods)
        np.rint(periods, out=periods)
        np.multiply(periods, table.period, out=whole)
        within -= whole
    locate(table, within, whole, gathered, row)
    theta, curvature = results[:2]
    sum_series(table.rows[0], row, within, gathered, theta, curvature)
    curvature *= table.slope
    for part, rows, advance in zip(results[2:], table.rows[1:], (table.advance.real, table.advance.imag), strict=False):
        sum_series(rows, row, within, gathered, part, None)
        if table.period:
            np.multiply(periods, advance, out=whole)
            part += whole


def locate(table, within, whole, gathered, row):
    """From lengths from the tip to the rows, and to places in the cells, between −½ and ½; exact, for cells are powers
    of two wide."""
    within *= table.cells
    np.floor(within, out=whole)
    within -= whole
    whole -= table.start
    np.copyto(row, whole, casting="unsafe")
    if table.per_bin is not None:
        ends = np.take(table.per_bin, row, axis=0, out=gathered[:, :2], mode="clip")
        within *= ends[:, 1]
        np.floor(within, out=whole)
        within -= whole
        whole += ends[:, 0]
        np.copyto(row, whole, casting="unsafe")
    within -= 0.5


def sum_series(rows, row, within, gathered, value, slope):
    """Horner's scheme for the value, and for the slope in the cell where it is wanted."""
    for part in (1, 0):
        np.take(rows[part], row, axis=0, out=gathered, mode="clip")
        for k in (3, 2, 1, 0):
            if part and k == 3:
                np.copyto(value, gathered[:, k])
                continue
            if slope is not None:
                if part and k == 2:
                    np.copyto(slope, value)
                else:
                    slope *= within
                    slope += value
            value *= within
            value += gathered[:, k]


def table_of(equilibrium, bins, position):
    """The table of an equilibrium, by its bins."""
    rod = equilibrium.rod
    cells = cells_in_bin(rod, bins, DEGREE)
    counts = np.where(bins.straight, 1, cells)
    which = np.repeat(np.arange(len(counts)), counts)
    firsts = np.cumsum(counts) - counts
    width = bins.width / counts[which]
    offset = (np.arange(len(which)) - firsts[which] + 0.5) * width - bins.width / 2
    angle, place = series(rod, state_within(bins, which, offset), DEGREE)
    uniform = not np.any(bins.straight)
    finest = bins.width / cells
    # In a straight cell, which is wider, the slope is right by the width of the others; θ there changes by nothing.
    angle[1:] *= finest * width ** np.arange(DEGREE)[:, None]
    place *= width ** np.arange(DEGREE + 1)[:, None]
    parts = [angle, place.real, place.imag] if position else [angle]
    return Table(
        bins.start * (cells if uniform else 1),
        cells / bins.width if uniform else 1 / bins.width,
        None if uniform else np.stack((firsts, counts), axis=1).astype(float),
        tuple((part[:4].T.copy(), part[4:].T.copy()) for part in parts),
        *period_of(equilibrium),
        -ldexp(1 / finest, rod.scale),
    )
