"""The ranges of tip angles from which a rod can rise to its clamp angle, each with one kind of motion.

Seen from the tip, θ moves in the potential V from rest at φ; it reaches the clamp angle only if V(φ) is not below V
anywhere between. Those φ fill the ranges below. Everything here is for tips below the clamp angle: for those above,
the rod is looked at from the other side of the y axis.
"""

from __future__ import annotations

from derive.emit.kernels.arithmetic import pi
from derive.emit.kernels.range_kinds import (
    first_clamp,
    first_turn,
    last_clamp,
    last_turn,
    level_clamp,
    level_turn,
    pass_clamp,
    pass_level,
    pass_turn,
)
from derive.emit.kernels.shoulders import with_shoulder_level


def pieces(eta, field_angle, ground):
    """All ranges of tip angles below the clamp angle, from low to high, one after the other as they are asked for."""
    found = (build(ground) for here, build in ranges(ground) if here)
    if field_angle == 0 or field_angle == pi / 2:
        return found
    return (part for piece in found for part in with_shoulder_level(eta, piece))


def ranges(ground):
    """Every range that a landscape of this kind can have: whether the rod has it, and its builder. From low to high."""
    at = ground.at
    if len(at) == 3:
        return in_basin(at, 0, at[0] > 0, (first_clamp, first_turn))
    if ground.scene.level:
        first = in_basin(at, 0, (at[0] > 0) & (at[2] < 0), (first_clamp, first_turn))
        return first + in_basin(at, 2, at[2] > 0, (last_clamp, last_turn))
    before, above = at[2] <= 0, at[0] <= ground.level
    last = (at[2] > 0) & (ground.height > 0)
    return [
        (before & above & (at[0] > 0), pass_clamp),
        ((before & (at[0] > ground.level)) | last, pass_level),
        ((at[2] > 0) & (ground.height <= 0), pass_turn),
        *in_basin(at, 0, (at[0] > ground.level) & (at[2] < 0), (level_clamp, level_turn)),
        *in_basin(at, 2, last, (last_clamp, last_turn)),
    ]


def in_basin(at, first, inside, builders):
    """The range of a clamp inside a basin: one before the well and at it, another beyond."""
    return [(inside & (at[first + 1] <= 0), builders[0]), (inside & (at[first + 1] > 0), builders[1])]
