"""The equilibria of tips that have been found: ``bent_rod`` and ``straight_rod`` on arrays."""

from __future__ import annotations

from typing import Any, NamedTuple

from numpy import abs, cos, flatnonzero, floor, full, ldexp, sin, sqrt, where, zeros

from derive.emit.kernels.arcs import Heading
from derive.emit.kernels.arcs_each import (
    arc_from_far_each,
    arc_to_each,
    clamp_point_each,
    far_point_each,
    sent_back_each,
)
from derive.emit.kernels.arithmetic import pi
from derive.emit.kernels.block_records import AT_ONCE, joined, rows
from derive.emit.kernels.swing_each import phase_of_each


class Columns(NamedTuple):
    """Equilibria, flat: the number of the rod, and what ``Equilibrium`` says of its tip.

    rank, place: they put the tips of a rod in order, also those that are nearer than rounding.
    """

    case: Any
    rank: Any
    place: Any
    tip_angle: Any
    clamp_curvature: Any
    gamma: Any
    y: Any
    z: Any
    energy: Any
    index: Any


class Tips(NamedTuple):
    """Tips that have been found: their rods, ranks of ranges, whole turns of the clamp, and motions."""

    rods: Any
    rank: Any
    turns: Any
    found: Any


LAST = 100  # beyond the rank of any range


def no_columns():
    """No equilibria."""
    whole, none = zeros(0, dtype=int), zeros(0)
    return Columns(whole, whole, none, none, none, none, none, none, none, whole)


def index_each(found):
    """``index_of`` on arrays."""
    swings = 2 * found.turns - (found.sign < 0)
    positive = found.rising != (found.sign > 0)
    return where(positive == (swings % 2 == 0), swings, swings + 1).astype(int)


def bent_rods(known, most):
    """The equilibria of tips on their branches, a list of Columns: those of short lists together."""
    few = [tips for tips in known if 2 * tips.rank.size < AT_ONCE]
    many = [tips for tips in known if 2 * tips.rank.size >= AT_ONCE]
    parts = []
    for tips in [*many, joined(few)] if few else many:
        index = index_each(tips.found)
        some = rows((tips, index), index <= most)
        for stretch, sign in ((first_stretches, 1), (last_stretches, -1)):
            there = rows(some, some[0].found.sign == sign)
            for start in range(0, there[1].size, AT_ONCE):
                parts.append(bent(rows(there, slice(start, start + AT_ONCE)), stretch))
    return parts


def bent(some, stretch):
    """The equilibria of tips, given with their indices, from which the clamp is reached by stretches of one kind."""
    tips, index = some
    rods, found = tips.rods, tips.found
    motion, phase = found.motion, found.phase
    beta, eta, length = rods.beta, rods.eta, rods.length
    heading = heading_at(rods.field_angle, motion)
    y, z, square = departures(rods, heading, found, stretch)
    speed = phase.delta * phase.whole / (motion.end * motion.sine) * sqrt(2 * motion.done_sine * motion.left_sine)
    gamma = 2 * beta * heading.cosine + eta * (1 + heading.double_cosine) / 2
    energy = -gamma * length / 2 - 2 * beta * y - square
    unit, side = ldexp(1.0, rods.scale), rods.side
    return Columns(
        rods.case,
        side * (tips.rank - LAST),
        side * found.place,
        side * (motion.tip + 2 * pi * tips.turns),
        -side * found.sign * speed * unit,
        gamma * unit * unit,
        (length * heading.cosine + y) / unit,
        side * (length * heading.sine + z) / unit,
        energy * unit,
        index,
    )


def heading_at(field_angle, motion):
    """``heading_of`` by NumPy's own sine and cosine: a rounding of them is one of the tip's place."""
    double = 2 * (motion.tip - field_angle)
    return Heading(cos(motion.tip), sin(motion.tip), cos(double), sin(double))


def departures(rods, heading, found, stretch):
    """The arcs of the rods, less those of straight ones: of whole half-swings, and of the last stretch."""
    columns = stretch(rods, heading, found)
    motion, swing, through = found.motion, found.swing, 2 * found.turns - (found.sign < 0)
    swung = flatnonzero(found.turns > 0)
    if swung.size:
        some, there, motion, swing, times = rows((rods, heading, motion, swing, through), swung)
        one, none = full(swung.shape, 1.0), zeros(swung.size)
        whole = arc_to_each(some.beta, some.eta, there, motion, far_point_each(motion), one, none, swing)
        for column, change in zip(columns, whole, strict=True):
            column[swung] += times * change
    return columns


def first_stretches(rods, heading, found):
    """The arcs from the tip, or from where the motion is as there, to the clamp."""
    motion, phase = found.motion, found.phase
    point = clamp_point_each(motion, phase)
    return arc_to_each(rods.beta, rods.eta, heading, motion, point, phase.square, phase.rest, found.arrival)


def last_stretches(rods, heading, found):
    """The arcs from the last turning point to the clamp, of rods that end on their way back."""
    back, extent = sent_back_each(found.motion), found.swing - found.arrival
    there, phase = heading_at(-rods.field_angle, back), phase_of_each(back)
    point = clamp_point_each(back, phase)
    arc = arc_to_each(rods.beta, rods.eta, there, back, point, phase.square, phase.rest, extent)
    return arc_from_far_each(rods.eta, heading, there, arc, extent)


def straight_rods(straight, most):
    """The rods that stay straight."""
    rods, rest, length = straight.rods, straight.rest, straight.rods.length
    cosine, sine = cos(rest.extra) + 0 * length, sin(rest.extra) + 0 * length
    for _ in range(rest.quarters % 4):
        cosine, sine = -sine, cosine
    aligned = cos(rest.angle - rods.field_angle)
    soft = -rest.stiffness
    index = where(soft > 0, floor(length * sqrt(abs(soft)) / pi + 0.5), 0).astype(int)
    energy = -(rods.beta * cosine + rods.eta * aligned * aligned / 2) * length
    here = rods.scale
    extent = ldexp(length, -here)
    gamma = ldexp(2 * rods.beta * cosine + rods.eta * aligned * aligned, 2 * here)
    found = Columns(
        rods.case,
        0 * index,
        0 * extent,
        rods.clamp_angle,
        0 * extent,
        gamma,
        cosine * extent,
        sine * extent,
        ldexp(energy, here),
        index,
    )
    return rows(found, index <= most)
