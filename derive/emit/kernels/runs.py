"""The shape of a rod at many points in order: runs of them lie in one bin, whose series has the same numbers for all."""

from __future__ import annotations

from math import ldexp
from typing import Any, NamedTuple

import numpy as np
from numpy.polynomial.chebyshev import cheb2poly, poly2cheb

from derive.emit.kernels.expansion import complete_series, negligible, period_of, state_within

ENOUGH = 1500  # points in a run, on average, from which runs are faster than looking up
BLOCK = 8192  # points at a time, so that they stay in the cache


class Run(NamedTuple):
    """Points first to last − 1, which lie in a cell, periods beyond the tip's. middle: length from the tip."""

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
    advances = (0.0, 0.0, advance.real, advance.imag)
    results = [np.empty(s.size) for _ in rows]
    spare = np.empty(BLOCK)
    for run in runs_of(equilibrium, bins, width, s):
        for first in range(run.first, run.last, BLOCK):
            block = slice(first, min(first + BLOCK, run.last))
            within = spare[: block.stop - first]
            np.multiply(s[block], -ldexp(2 / width, rod.scale), out=within)
            within += (rod.length - run.middle) * (2 / width)
            for result, row, step in zip(results, rows, advances, strict=False):
                sum_series(row[run.cell], run.periods * step, within, result[block])
    return results if position else [*results, None, None]


def sum_series(coefficients, shift, within, out):
    """Horner's scheme with the highest power first, and a shift."""
    np.multiply(within, coefficients[0], out=out)
    for coefficient in coefficients[1:-1]:
        out += coefficient
        out *= within
    out += coefficients[-1] + shift


def runs_of(equilibrium, bins, width, s):
    """The runs of points within a cell and a period."""
    rod, count = equilibrium.rod, round(len(bins.straight) * bins.width / width)
    start, period = bins.start * bins.width / width, period_of(equilibrium)[0]
    edges = (start + np.arange(count + 1)) * width
    reached = int(rod.length / period + 0.5) + 1 if period else 1
    if period:
        edges = np.clip(edges, -period / 2, period / 2)
    runs = []
    for periods in range(reached):
        # From the tip on, s falls.
        ends = np.searchsorted(s, np.ldexp(rod.length - period * periods - edges, -rod.scale), side="right").tolist()
        for cell in np.flatnonzero(np.diff(ends)).tolist():
            middle = period * periods + (start + cell + 0.5) * width
            runs.append(Run(ends[cell + 1], ends[cell], cell, periods, middle))
    return runs


def series_of(rod, bins, cells, position):
    """The coefficients by cell, highest power first, of θ, θ′, y and z in a place between −1 and 1."""
    half = bins.width / (2 * cells)
    count = len(bins.straight)
    which = np.repeat(np.arange(count), cells)
    offset = np.tile((2 * np.arange(cells) + 1 - cells) * half, count)
    angle, place = complete_series(rod, state_within(bins, which, offset), half)
    powers = np.arange(len(angle))[:, None]
    slope = -ldexp(1.0, rod.scale) * powers[1:] * angle[1:] * half ** powers[:-1]
    parts = [angle * half**powers, slope]
    scaled = place * half**powers
    parts += [scaled.real, scaled.imag] if position else []
    units = 1.0, ldexp(1.0, rod.scale), ldexp(1.0, -rod.scale), ldexp(1.0, -rod.scale)
    return [shortened(part, negligible() * unit)[::-1].T.tolist() for part, unit in zip(parts, units, strict=False)]


def shortened(coefficients, allowed):
    """Polynomials of least degree that differ from the given ones by no more than allowed between −1 and 1.

    Chebyshev polynomials are at most 1 there, so those of high degree go as long as their coefficients sum to less.
    """
    size = len(coefficients)
    powers = np.eye(size)
    to_chebyshev = np.array([np.resize(np.append(poly2cheb(row), np.zeros(size)), size) for row in powers])
    series = to_chebyshev.T @ coefficients
    tails = np.cumsum(abs(series[::-1]), axis=0).max(axis=1)
    kept = max(2, size - int(np.searchsorted(tails, allowed, side="right")))
    back = np.array([np.resize(np.append(cheb2poly(row), np.zeros(kept)), kept) for row in np.eye(kept)])
    return back.T @ series[:kept]
