"""Rods of a sweep that are refused: what differs from ``bounds``."""

from __future__ import annotations

from math import prod

from numpy import errstate, flatnonzero

from derive.emit.kernels.block_records import element, slab
from derive.emit.kernels.blocks import BLOCK
from derive.emit.kernels.bounds import must_have_answer, too_large, too_many


def all_must_have_answers(beta, eta, length, grid, most):
    """ValueError for the first rod of a sweep that is refused."""
    number = prod(grid)
    for start in range(0, number, BLOCK):
        which = slice(start, min(start + BLOCK, number))
        force, magnet, extent = slab(grid, which, beta), slab(grid, which, eta), slab(grid, which, length)
        with errstate(over="ignore", under="ignore"):
            bad = too_large(force, magnet, extent) | too_many(force, magnet, extent, most)
        for case in flatnonzero(bad)[:1].tolist():
            must_have_answer(element(case, force), element(case, magnet), element(case, extent), most)
