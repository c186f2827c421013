"""The kernels of ``basins`` on arrays.

Emitted by `derive emit` from kernels/basins.py: do not edit, change that file.

Digest of the inputs: sha256 f3311e2bd51c9994a40f606cc79c52886593980c1021a2b3199a936c1b8118c9
"""

from __future__ import annotations

from derive.emit.kernels.array_arithmetic import each_abs, each_any_of, each_pick
from derive.emit.kernels.basins import Basin, Piece
from derive.emit.kernels.rests_each import pick_rest_each


def basin_of_each(ground, first):
    """The basin between two neighbouring hills."""
    scene = ground.scene
    hill, well, far = scene.rests[first : first + 3]
    whole = len(scene.rests) == 3
    even = scene.even and (scene.level or whole)
    rise, beside = ground.drop if first else 0, (scene.shoulder, scene.moment, 0.0)
    return Basin(hill, well, far, well, well, rise, False, even, whole, *beside)


def over_ridge_each(ground):
    """What stops a motion that passes the ridge."""
    hill, well, ridge, second, far = ground.scene.rests
    return Basin(hill, well, far, second, ridge, 0, True, ground.scene.even, True)


def piece_of_each(basin, low_kind, high_kind, low_offset, width, high_depth, clamp_gap, level_gap, at):
    """The record of a range."""
    rests = (basin.hill, basin.well, basin.axis, basin.far_well, basin.far) if basin.passes else basin[:3]
    rest, offset = rests[0], at[0]
    for other, distance in zip(rests[1:], at[1:], strict=False):
        closer = each_abs(distance) < each_abs(offset)
        if each_any_of(closer):
            rest, offset = pick_rest_each(closer, other, rest), each_pick(closer, distance, offset)
    beyond, last = at[len(rests) - 2 : len(rests)]
    ends = low_kind, high_kind, low_offset, width, high_depth, clamp_gap, level_gap
    return Piece(basin, *ends, rest, offset, -last, beyond, at[0], at[1])
