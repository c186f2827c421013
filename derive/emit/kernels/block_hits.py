"""To which ranges, and to which places there, the tips of short rods belong."""

from __future__ import annotations

from numpy import abs, arange, flatnonzero, log, repeat, sqrt, where, zeros

from derive.emit.kernels.arithmetic import pi
from derive.emit.kernels.array_arithmetic import each_cos, each_sin
from derive.emit.kernels.block_records import rows
from derive.emit.kernels.block_roots import Brackets, rough_times


def aimed(group, shots):
    """The tips on the ranges of a group: their ranges and branches as brackets, their places, and slopes there."""
    rods, piece = group.rods, group.piece
    key = 2 * rods.case + (rods.side < 0)
    number = shots.number[key]
    row = repeat(arange(key.size), number)
    tip = repeat(shots.first[key] - number.cumsum() + number, number) + arange(row.size)
    drop = -rods.side[row] * shots.offset[tip] - (piece.clamp_gap + 0 * rods.slow)[row]
    width = piece.width[row]
    inside = flatnonzero((drop > 0) & (drop < width))
    row, drop, width, tip = row[inside], drop[inside], width[inside], tip[inside]
    place, some = log((width - drop) / drop), rows(rods, row)
    speed = sqrt(2 * level_drop(some, some.side * shots.offset[tip]))
    slope = -shots.slope[tip] / speed * (width - drop) * drop / width
    back = turned_back(group, row, place)
    slope, sign = where(back, -slope, slope), where(back, -1, 1)
    return Brackets(row, back.astype(float), sign, place - 0.5, place + 0.5, -slope, slope), place, slope


def turned_back(group, row, place):
    """Whether the motions meet the clamp on their way back, on rods that are as long as half-swings may be."""
    long = flatnonzero(group.rods.slow[row] >= pi)
    back = zeros(row.shape, dtype=bool)
    if long.size:
        some = rows(group, row[long])
        swing, arrival = rough_times(some.rods, some.piece, place[long])
        back[long] = abs(2 * swing - arrival - some.rods.length) < abs(arrival - some.rods.length)
    return back


def level_drop(rods, offset):
    """V(tip) − V(clamp) by the tip's offset from the clamp angle."""
    middle, half = each_sin(rods.clamp_angle + offset / 2), each_sin(offset / 2)
    lean = rods.clamp_angle - rods.field_angle + offset / 2
    return -2 * half * (rods.beta * middle + rods.eta * each_cos(offset / 2) * each_sin(lean) * each_cos(lean))
