"""What a range of tip angles is told by: its basin, its ends, and the clamp's distances from what stops the rod."""

from __future__ import annotations

from typing import NamedTuple

from derive.emit.kernels.arithmetic import any_of, pick
from derive.emit.kernels.rests import Rest, pick_rest


class Basin(NamedTuple):
    """What stops the rod and what it swings about: the hill that tips come from and the well below them, the hill
    that stops the motion and the last well before it, and the direction where it is slowest between its ends: the
    ridge that it passes, or the well.

    far_rise: V(far) − V(hill). even: the motion is symmetric about its middle. whole: far is the hill a turn on.
    shoulder, moment: of a landscape in which a ridge is nearly there; lean: see ``shoulders.level_lean``.
    """

    hill: Rest
    well: Rest
    far: Rest
    far_well: Rest
    axis: Rest
    far_rise: float
    passes: bool
    even: bool
    whole: bool
    shoulder: Rest | None = None
    moment: float = 0.0
    lean: float = 0.0


class Piece(NamedTuple):
    """Tip angles from low to low + width in a basin; angles as differences, told without loss.

    low_kind: 'hill', or 'level', where V is that of the ridge. high_kind: 'clamp', the clamp angle itself; 'turn', the
    angle from which the rod turns back at the clamp angle; 'level'.
    """

    basin: Basin
    low_kind: str
    high_kind: str
    low_offset: float  # low − hill
    width: float
    high_depth: float  # well − high
    clamp_gap: float  # clamp − high
    level_gap: float  # the angle at the level of the ridge − high, of a motion that passes it
    clamp_rest: Rest  # the direction next to the clamp
    clamp_offset: float  # clamp − that direction
    far_gap: float  # far − clamp
    beyond_well: float  # clamp − far_well
    past_hill: float  # clamp − hill
    past_well: float  # clamp − well


def basin_of(ground, first):
    """The basin between two neighbouring hills."""
    scene = ground.scene
    hill, well, far = scene.rests[first : first + 3]
    whole = len(scene.rests) == 3
    even = scene.even and (scene.level or whole)
    rise, beside = ground.drop if first else 0, (scene.shoulder, scene.moment, 0.0)
    return Basin(hill, well, far, well, well, rise, False, even, whole, *beside)


def over_ridge(ground):
    """What stops a motion that passes the ridge."""
    hill, well, ridge, second, far = ground.scene.rests
    return Basin(hill, well, far, second, ridge, 0, True, ground.scene.even, True)


def piece_of(basin, low_kind, high_kind, low_offset, width, high_depth, clamp_gap, level_gap, at):
    """The record of a range."""
    rests = (basin.hill, basin.well, basin.axis, basin.far_well, basin.far) if basin.passes else basin[:3]
    rest, offset = rests[0], at[0]
    for other, distance in zip(rests[1:], at[1:], strict=False):
        closer = abs(distance) < abs(offset)
        if any_of(closer):
            rest, offset = pick_rest(closer, other, rest), pick(closer, distance, offset)
    beyond, last = at[len(rests) - 2 : len(rests)]
    ends = low_kind, high_kind, low_offset, width, high_depth, clamp_gap, level_gap
    return Piece(basin, *ends, rest, offset, -last, beyond, at[0], at[1])
