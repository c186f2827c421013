"""The kernels of ``pieces`` on arrays.

Emitted by `derive emit` from kernels/pieces.py: do not edit, change that file.

Digest of the inputs: sha256 849b9a75752efbde1f597f9938d528c33239291d0fae4cdef6a64f03aec436e8
"""

from __future__ import annotations

from derive.emit.kernels.arithmetic import pi
from derive.emit.kernels.range_kinds_each import (
    first_clamp_each,
    first_turn_each,
    last_clamp_each,
    last_turn_each,
    level_clamp_each,
    level_turn_each,
    pass_clamp_each,
    pass_level_each,
    pass_turn_each,
)
from derive.emit.kernels.shoulders import with_shoulder_level


def pieces_each(eta, field_angle, ground):
    """All ranges of tip angles below the clamp angle, from low to high, one after the other as they are asked for."""
    found = (build(ground) for here, build in ranges_each(ground) if here)
    if field_angle == 0 or field_angle == pi / 2:
        return found
    return (part for piece in found for part in with_shoulder_level(eta, piece))


def ranges_each(ground):
    """Every range that a landscape of this kind can have: whether the rod has it, and its builder. From low to high."""
    at = ground.at
    if len(at) == 3:
        return in_basin_each(at, 0, at[0] > 0, (first_clamp_each, first_turn_each))
    if ground.scene.level:
        first = in_basin_each(at, 0, (at[0] > 0) & (at[2] < 0), (first_clamp_each, first_turn_each))
        return first + in_basin_each(at, 2, at[2] > 0, (last_clamp_each, last_turn_each))
    before, above = at[2] <= 0, at[0] <= ground.level
    last = (at[2] > 0) & (ground.height > 0)
    return [
        (before & above & (at[0] > 0), pass_clamp_each),
        (before & (at[0] > ground.level) | last, pass_level_each),
        ((at[2] > 0) & (ground.height <= 0), pass_turn_each),
        *in_basin_each(at, 0, (at[0] > ground.level) & (at[2] < 0), (level_clamp_each, level_turn_each)),
        *in_basin_each(at, 2, last, (last_clamp_each, last_turn_each)),
    ]


def in_basin_each(at, first, inside, builders):
    """The range of a clamp inside a basin: one before the well and at it, another beyond."""
    return [(inside & (at[first + 1] <= 0), builders[0]), (inside & (at[first + 1] > 0), builders[1])]
