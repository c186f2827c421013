"""The shape of a rod at points in any order: a table of short power series, looked up and summed block by block."""

from __future__ import annotations

from math import ldexp
from typing import Any, NamedTuple

import numpy as np

from derive.emit.kernels.expansion import divided, middle_of, period_of, quarter
from derive.emit.kernels.shortening import cut

LOOKUP_BLOCK = 8192  # points at a time, so that what is gathered for them stays in the cache
ANGLE_DEGREE = 6  # of the short series: two gathers of up to four coefficients each
TERMS = 9  # of the series before what can be left out is left out
PLACE_DEGREE = 5  # the slope is not asked for, so it needs a degree less


class Table(NamedTuple):
    """Short power series in cells, for θ, y and z: four low coefficients by row, and the high ones.

    period: of θ in the length, or 0 where the cells cover the rod. advance: y + iz over a period.
    per_bin: first row and number of cells of each bin, where those differ; else None. slope: θ′ per change in a cell.
    last: what is added to the sums for θ.
    """

    cells: float
    per_bin: Any
    rows: tuple
    period: float
    advance: complex
    slope: float
    last: float


def by_lookup(equilibrium, bins, s, position):
    """θ, θ′, y and z at s; y and z are None without ``position``."""
    table = table_of(equilibrium, bins, position)
    results = [np.empty(s.size) for _ in range(4 if position else 2)]
    gathered, row = np.empty((LOOKUP_BLOCK, 4)), np.empty(LOOKUP_BLOCK, dtype=np.intp)
    spare = Spare(np.empty(LOOKUP_BLOCK), np.empty(LOOKUP_BLOCK), np.empty(LOOKUP_BLOCK), gathered, row)
    for first in range(0, s.size, LOOKUP_BLOCK):
        block = slice(first, min(first + LOOKUP_BLOCK, s.size))
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
    np.multiply(s, ldexp(1.0, rod.scale), out=within)
    if table.period:
        np.multiply(within, 1 / table.period, out=periods)
        np.floor(periods, out=periods)
        np.multiply(periods, table.period, out=whole)
        within -= whole
        np.maximum(within, 0, out=within)
    locate(table, within, whole, gathered, row)
    theta, curvature = results[:2]
    sum_gathered(table.rows[0], ANGLE_DEGREE, row, within, gathered, theta, curvature)
    curvature *= table.slope
    if table.last:
        theta += table.last
    for part, rows, advance in zip(results[2:], table.rows[1:], (table.advance.real, table.advance.imag), strict=False):
        sum_gathered(rows, PLACE_DEGREE, row, within, gathered, part, None)
        if table.period:
            np.multiply(periods, advance, out=whole)
            part += whole


def locate(table, within, whole, gathered, row):
    """From lengths from the clamp to the rows, and to places in the cells, between −½ and ½.

    Exact, for cells are powers of two wide.
    """
    within *= table.cells
    np.floor(within, out=whole)
    within -= whole
    np.copyto(row, whole, casting="unsafe")
    if table.per_bin is not None:
        ends = gather(table.per_bin, row, gathered)
        within *= ends[:, 1]
        np.floor(within, out=whole)
        within -= whole
        whole += ends[:, 0]
        np.copyto(row, whole, casting="unsafe")
    within -= 0.5


def sum_gathered(rows, degree, row, within, gathered, value, slope):
    """Horner's scheme for the value, and for the slope in the cell where it is wanted."""
    high, low = rows
    found, top = gather(high, row, gathered), degree - 4
    value[...] = found[:, top]
    if slope is not None:
        slope[...] = value
    value *= within
    value += found[:, top - 1]
    for k in range(degree - 2, -1, -1):
        if k == 3:
            found = gather(low, row, gathered)
        if slope is not None:
            slope *= within
            slope += value
        value *= within
        value += found[:, k % 4]


def gather(coefficients, row, gathered):
    """The coefficients of a row for each point, in the room for them."""
    columns = coefficients.shape[1]
    found = gathered.reshape(-1)[: len(row) * columns].reshape(-1, columns)
    return np.take(coefficients, row, axis=0, out=found, mode="clip")


def table_of(equilibrium, bins, position):
    """The table of an equilibrium, by its bins: as many cells in each as the short series need."""
    rod = equilibrium.rod
    cells, parts = 32, None
    while parts is None:
        cells *= 2
        parts = short_series(rod, bins, cells, position)
    uniform = not np.any(bins.straight)
    counts = np.where(bins.straight, 1, cells)
    period, advance = period_of(equilibrium)
    return Table(
        cells / bins.width if uniform else 1 / bins.width,
        None if uniform else np.stack((np.cumsum(counts) - counts, counts), axis=1).astype(float),
        tuple(halves(part * 2.0 ** np.arange(len(part))[:, None]) for part in parts),
        period,
        advance,
        ldexp(cells / bins.width, rod.scale),
        middle_of(equilibrium),
    )


def short_series(rod, bins, cells, position):
    """The series of all cells in a place between −1 and 1; None if they are not right to a quarter spacing."""
    angle, rest = in_cells(bins, bins.angle, cells, ANGLE_DEGREE)
    # In a straight cell, which is wider, the slope is right by the width of the others; θ there changes by nothing.
    angle[1:, np.repeat(bins.straight, np.where(bins.straight, 1, cells))] /= cells
    # The slope of T_n is at most n².
    orders = np.arange(ANGLE_DEGREE + 1, TERMS)
    if np.max(orders * orders @ rest) > quarter() * bins.width / (2 * cells):
        return None
    parts = [angle]
    for place in (bins.place.real, bins.place.imag) if position else ():
        part, rest = in_cells(bins, place, cells, PLACE_DEGREE)
        if np.max(rest.sum(axis=0)) > quarter() * ldexp(rod.length, -rod.scale):
            return None
        parts.append(part)
    return parts


def in_cells(bins, coefficients, cells, degree):
    """The series of all cells, and the largest parts that are left out of any; a straight bin is one cell."""
    change, bent = cut(TERMS, degree), ~bins.straight
    found = divided(coefficients[:, bent], bins.width / 2, cells, change)
    if not np.all(bent):
        whole = np.repeat(bins.straight, np.where(bins.straight, 1, cells))
        both = np.empty((TERMS, len(whole)))
        both[:, ~whole] = found
        both[:, whole] = divided(coefficients[:, bins.straight], bins.width / 2, 1, change)
        found = both
    return found[: degree + 1], abs(found[degree + 1 :])


def halves(coefficients):
    """The high and the low coefficients, by row, with room for two or four: what is gathered fastest."""
    high = np.zeros((coefficients.shape[1], 2 if len(coefficients) <= 6 else 4))
    high[:, : len(coefficients) - 4] = coefficients[4:].T
    return high, coefficients[:4].T.copy()
