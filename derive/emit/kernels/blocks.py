"""The equilibria of many rods at once: ``all_equilibria`` on arrays, in blocks that bound the memory."""

from __future__ import annotations

from math import prod

from numpy import (
    abs,
    arange,
    array,
    bincount,
    concatenate,
    errstate,
    flatnonzero,
    floor,
    frexp,
    full,
    inf,
    isin,
    ldexp,
    lexsort,
    repeat,
    sqrt,
    unique,
    where,
    zeros,
)

from derive.emit.kernels.arithmetic import epsilon, pi
from derive.emit.kernels.array_arithmetic import each_less_quarters
from derive.emit.kernels.block_dips import beside_shoulders
from derive.emit.kernels.block_pieces import Rods, groups
from derive.emit.kernels.block_records import element, joined, rows, slab
from derive.emit.kernels.block_search import tips
from derive.emit.kernels.block_short import short_rods
from derive.emit.kernels.block_shots import is_shot, shots_of
from derive.emit.kernels.block_tips import Columns, Tips, bent_rods, no_columns, straight_rods
from derive.emit.kernels.equilibria import all_equilibria

BLOCK = 8192  # rods at once
FEWEST = 16  # rods that are faster on arrays than one by one
SLOWEST = 250.0  # ℓ√(β + η) from which offsets would be too small for their squares


def sweep_arrays(beta, eta, length, clamp_angle, field_angle, grid, max_index):
    """Every equilibrium of every rod, sorted by rod and then by tip angle; all arguments broadcast to ``grid``.

    max_index: the largest index wanted, or None for all. The memory needed besides the result is that of one block, or
    of one column. Without ranks and places, which only put the tips of a block in order.
    """
    number, none = prod(grid), no_columns()
    columns = [[column] for column in none]
    for start in range(0, number, BLOCK):
        which = slice(start, min(start + BLOCK, number))
        found = block(
            slab(grid, which, beta),
            slab(grid, which, eta),
            slab(grid, which, length),
            slab(grid, which, clamp_angle),
            slab(grid, which, field_angle),
            which.stop - start,
            max_index,
        )
        found = found._replace(case=found.case + start, rank=none.rank, place=none.place)
        for parts, column in zip(columns, found, strict=True):
            parts.append(column)
    whole = []
    while columns:
        whole.append(concatenate(columns.pop(0)))
    return Columns(*whole)


def block(beta, eta, length, clamp_angle, field_angle, size, max_index):
    """The equilibria of one block: on arrays, and those of few rods, or where arrays leave a doubt, one by one."""
    most = inf if max_index is None else max_index
    found, lost = no_columns(), arange(size)
    if size >= FEWEST:
        with errstate(all="ignore"):
            found, lost = at_once(beta, eta, length, clamp_angle, field_angle, size, most)
    if lost.size:
        parts = [rows(found, ~isin(found.case, lost))]
        for case in lost.tolist():
            one = one_by_one(
                element(case, beta),
                element(case, eta),
                element(case, length),
                element(case, clamp_angle),
                element(case, field_angle),
                max_index,
            )
            parts.append(one._replace(case=one.case + case))
        found = joined(parts)
    return in_order_each(rows(found, lexsort((found.place, found.rank, found.case))))


def in_order_each(found):
    """``in_order`` on arrays: tips that are nearer than rounding as equal, where rounding would exchange them."""
    tip, alike = found.tip_angle, found.case[1:] == found.case[:-1]
    wrong = alike & (tip[1:] < tip[:-1])
    while wrong.any():
        tip = concatenate([tip[:1], where(wrong, tip[:-1], tip[1:])])
        wrong = alike & (tip[1:] < tip[:-1])
    return found._replace(tip_angle=tip)


def at_once(beta, eta, length, clamp_angle, field_angle, size, most):
    """The equilibria on arrays, and the rods that are left to the scalar solver."""
    scale = full(size, frexp(beta + eta)[1] // 2)
    force, magnet, extent = ldexp(beta, -2 * scale), ldexp(eta, -2 * scale), ldexp(length, scale)
    slow = extent * sqrt(force + magnet)
    clamp, field = full(size, clamp_angle), principal_each(field_angle)
    good = (slow < SLOWEST) & (slow > epsilon())
    rods = rows(Rods(arange(size), 1, scale, force, magnet, extent, clamp, field, slow), good)
    short, rods = short_and_others(rods, most)
    found, doubtful = on_arrays(both_sides_each(rods), most)
    found = joined([short, found])
    return found, unique(concatenate([flatnonzero(~good), doubtful, flatnonzero(incomplete(found, size, most))]))


def short_and_others(rods, most):
    """The equilibria of short rods, and the rods of which they are not sure or that are none."""
    shot = is_shot(rods)
    some = rows(rods, shot)
    shots, unsure = shots_of(some)
    shot[flatnonzero(shot)[unsure]] = False
    return short_rods(some, shots, most), rows(rods, ~shot)


def both_sides_each(rods):
    """The rods and after them their mirror images, for the tips above the clamp angle."""
    number = rods.case.size
    side, both = repeat(array([1, -1]), number), concatenate([arange(number), arange(number)])
    twice = rows(rods, both)
    return Rods(
        twice.case,
        side,
        twice.scale,
        twice.beta,
        twice.eta,
        twice.length,
        side * twice.clamp_angle,
        mirrored_each(twice.field_angle, side),
        twice.slow,
    )


def incomplete(found, size, most):
    """The rods of which an equilibrium is missing: those of even and of odd index differ by one in number (the degree
    of the equation is that of the rod without load), and the least energy has index 0.
    """
    if most < inf:
        return bincount(found.case, minlength=size) == 0
    return bincount(found.case, weights=1 - 2 * (found.index % 2), minlength=size) != 1


def principal_each(field_angle):
    """``principal`` on an array."""
    exact = (field_angle == 0) | (field_angle == pi / 2)
    half_turns = floor(field_angle / pi + 0.5)
    angle = each_less_quarters(field_angle, 2 * half_turns)
    blur = 2 * epsilon() * abs(field_angle)
    nearly = abs(angle) <= where(half_turns == 0, epsilon() ** 3, blur)
    return where(exact, field_angle, where(nearly, 0.0, where(pi / 2 - abs(angle) <= blur, pi / 2, angle)))


def mirrored_each(field_angle, side):
    """``reflected`` on an array, where the side is −1."""
    return where((field_angle == 0) | (field_angle == pi / 2), field_angle, side * field_angle)


def one_by_one(beta, eta, length, clamp_angle, field_angle, max_index):
    """The equilibria of one rod by the scalar solver."""
    found = all_equilibria(beta, eta, length, clamp_angle, field_angle, max_index)
    return Columns(
        zeros(len(found), dtype=int),
        arange(len(found)),
        zeros(len(found)),
        array([item.tip_angle for item in found], dtype=float),
        array([item.clamp_curvature for item in found], dtype=float),
        array([item.gamma for item in found], dtype=float),
        array([item.y for item in found], dtype=float),
        array([item.z for item in found], dtype=float),
        array([item.energy for item in found], dtype=float),
        array([item.index for item in found], dtype=int),
    )


def on_arrays(rods, most):
    """The equilibria of rods with tips below the clamp angle, the straight ones, and the cases left to the scalar
    solver."""
    found, straight, doubtful = groups(rods)
    known, left = [], [doubtful]
    for group in found:
        tip, lost = tips(group, most)
        left.append(group.rods.case[lost])
        for some in tip:
            rod, rank, turns = rows((group.rods, group.rank, group.turns), some.range)
            known.append(Tips(rod, rank, turns, some))
            left.append(beside_shoulders(group, some))
    parts = [no_columns(), *(straight_rods(some, most) for some in straight), *bent_rods(known, most)]
    return joined(parts), concatenate(left)
