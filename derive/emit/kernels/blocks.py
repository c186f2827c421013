"""The equilibria of many rods at once: ``all_equilibria`` on arrays, in blocks that bound the memory."""

from __future__ import annotations

from typing import Any, NamedTuple

from numpy import (
    abs,
    arange,
    array,
    concatenate,
    cos,
    errstate,
    flatnonzero,
    floor,
    frexp,
    full,
    inf,
    isin,
    ldexp,
    lexsort,
    sin,
    sqrt,
    unique,
    where,
    zeros,
)

from derive.emit.kernels.arcs_each import arc_to_each, clamp_point_each, far_point_each
from derive.emit.kernels.arithmetic import epsilon, pi
from derive.emit.kernels.array_arithmetic import less_quarters
from derive.emit.kernels.block_pieces import Rods, groups
from derive.emit.kernels.block_records import rows
from derive.emit.kernels.block_search import tips
from derive.emit.kernels.equilibria import all_equilibria

BLOCK = 8192  # rods at once
FEWEST = 8  # rods of one field angle that are faster on arrays than one by one
SLOWEST = 250.0  # ℓ√(β + η) from which offsets would be too small for their squares


class Table(NamedTuple):
    """Equilibria, flat: the number of the rod, and what ``Equilibrium`` says of its tip."""

    case: Any
    tip_angle: Any
    clamp_curvature: Any
    gamma: Any
    y: Any
    z: Any
    energy: Any
    index: Any


def sweep_arrays(beta, eta, length, clamp_angle, field_angle, max_index):
    """Every equilibrium of every rod, given as flat arrays of floats, sorted by rod and then by tip angle.

    max_index: the largest index wanted, or None for all. The memory needed besides the result is that of one block.
    """
    given = (beta, eta, length, clamp_angle, field_angle)
    starts = range(0, max(beta.size, 1), BLOCK)
    parts = [block([part[start : start + BLOCK] for part in given], max_index) for start in starts]
    parts = [part._replace(case=part.case + start) for start, part in zip(starts, parts, strict=True)]
    return Table(*(concatenate(column) for column in zip(*parts, strict=True)))


def block(given, max_index):
    """The equilibria of one block."""
    beta, eta, length, clamp_angle, field_angle = given
    most = inf if max_index is None else max_index
    with errstate(all="ignore"):
        scale = frexp(beta + eta)[1] // 2
        loads = ldexp(beta, -2 * scale), ldexp(eta, -2 * scale)
        own = ldexp(length, scale)
        slow = own * sqrt(loads[0] + loads[1])
        field = principal_each(field_angle)
        rods = Rods(arange(beta.size), *loads, own, clamp_angle, field, slow)
        good = (slow < SLOWEST) & (slow > 0) & in_groups(field)
        fit, left = flatnonzero(good), flatnonzero(~good)
        mirrored = rods._replace(
            clamp_angle=-clamp_angle, field_angle=where((field == 0) | (field == pi / 2), field, -field)
        )
        parts = [one_side(rows(rods, fit), 1, scale, most)]
        parts.append(one_side(rows(mirrored, fit), -1, scale, most))
    lost = unique(concatenate([left] + [doubtful for _, doubtful in parts]))
    table = Table(*(concatenate(column) for column in zip(*(found for found, _ in parts), strict=True)))
    if lost.size:
        table = rows(table, ~isin(table.case, lost))
        scalar = [one_by_one([part[case] for part in given], case, max_index) for case in lost.tolist()]
        table = Table(*(concatenate(column) for column in zip(table, *scalar, strict=True)))
    return rows(table, lexsort((table.tip_angle, table.case)))


def in_groups(field_angle):
    """Whether so many rods share the field angle that they are worth a group of their own."""
    _, which, number = unique(field_angle, return_inverse=True, return_counts=True)
    return number[which] >= FEWEST


def principal_each(field_angle):
    """``principal`` on an array."""
    half_turns = floor(field_angle / pi + 0.5)
    angle = less_quarters(field_angle, 2 * half_turns)
    blur = 2 * epsilon() * abs(field_angle)
    angle = where(pi / 2 - abs(angle) <= blur, pi / 2, angle)
    return where(abs(angle) <= where(half_turns == 0, epsilon() ** 3, blur), 0.0, angle)


def one_by_one(rod, case, max_index):
    """The equilibria of one rod by the scalar solver."""
    found = all_equilibria(*(float(part) for part in rod), max_index)
    columns = [[getattr(item, name) for item in found] for name in Table._fields[1:-1]]
    return Table(
        full(len(found), case),
        *(array(column, dtype=float) for column in columns),
        array([item.index for item in found], dtype=int),
    )


def one_side(rods, side, scale, most):
    """The equilibria with tips on one side of the clamp angle, the straight ones with the first side, and the rods
    left to the scalar solver."""
    found, straight, doubtful = groups(rods)
    tables, left = [nothing()], [doubtful]
    for group in found:
        tip, lost = tips(group, most)
        left.append(group.rods.case[lost])
        tables += [bent(group, some, side, scale, most) for some in tip]
    if side > 0:
        tables += [straight_rods(some, scale, most) for some in straight]
    return Table(*(concatenate(column) for column in zip(*tables, strict=True))), concatenate(left)


def nothing():
    """No equilibria."""
    whole = zeros(0, dtype=int)
    return Table(whole, *(zeros(0) for _ in range(6)), whole)


def index_each(found):
    """``index_of`` on arrays."""
    swings = 2 * found.turns - (found.sign < 0)
    positive = found.rising != (found.sign > 0)
    return where(positive == (swings % 2 == 0), swings, swings + 1).astype(int)


def bent(group, found, side, scale, most):
    """The equilibria of tips on their branches: ``bent_rod`` on arrays."""
    index = index_each(found)
    wanted = flatnonzero(index <= most)
    if wanted.size < index.size:
        found, index = rows(found, wanted), index[wanted]
    some = rows(group, found.range)
    rods, motion, phase = some.rods, found.motion, found.phase
    beta, eta, field_angle = rods.beta, rods.eta, rods.field_angle
    cosine, aligned = cos(motion.tip), cos(motion.tip - field_angle)
    y, z, square = positions(rods, found)
    speed = phase.delta * phase.whole / (motion.end * motion.sine) * sqrt(2 * motion.done_sine * motion.left_sine)
    gamma = 2 * beta * cosine + eta * aligned * aligned
    energy = gamma * rods.length / 2 - 2 * beta * y - square
    scale = scale[rods.case]
    return Table(
        rods.case,
        side * (motion.tip + 2 * pi * some.turns),
        -side * found.sign * ldexp(speed, scale),
        ldexp(gamma, 2 * scale),
        ldexp(y, -scale),
        side * ldexp(z, -scale),
        ldexp(energy, scale),
        index,
    )


def positions(rods, found):
    """∫cos θ, ∫sin θ and η∫cos²(θ − α) along the rods; whole half-swings only for those that have any."""
    motion, phase = found.motion, found.phase
    load = rods.beta, rods.eta, rods.field_angle
    part = arc_to_each(*load, motion, clamp_point_each(motion, phase), phase.square, phase.rest, found.arrival)
    columns = [found.sign * column for column in part]
    swung = flatnonzero(found.turns > 0)
    if swung.size:
        load, motion, swing, turns = rows((load, motion, found.swing, found.turns), swung)
        one = full(swung.shape, 1.0)
        whole = arc_to_each(*load, motion, far_point_each(motion), one, 0 * one, swing)
        for column, change in zip(columns, whole, strict=True):
            column[swung] += 2 * turns * change
    return columns


def straight_rods(straight, scale, most):
    """The rods that stay straight: ``straight_rod`` on arrays."""
    rods, rest = straight
    cosine, sine = cos(rest.extra) + 0 * rods.beta, sin(rest.extra) + 0 * rods.beta
    for _ in range(rest.quarters % 4):
        cosine, sine = -sine, cosine
    aligned = cos(rest.angle - rods.field_angle)
    soft = -rest.stiffness
    index = where(soft > 0, floor(rods.length * sqrt(abs(soft)) / pi + 0.5), 0).astype(int)
    energy = -(rods.beta * cosine + rods.eta * aligned * aligned / 2) * rods.length
    here = scale[rods.case]
    length = ldexp(rods.length, -here)
    gamma = ldexp(2 * rods.beta * cosine + rods.eta * aligned * aligned, 2 * here)
    table = Table(
        rods.case, rods.clamp_angle, 0 * length, gamma, cosine * length, sine * length, ldexp(energy, here), index
    )
    return rows(table, index <= most)
