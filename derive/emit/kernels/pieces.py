"""The ranges of tip angles from which a rod can rise to its clamp angle, each with one kind of motion.

Seen from the tip, θ moves in the potential V from rest at φ; it reaches the clamp angle only if V(φ) is not below V
anywhere between. Those φ fill the ranges below. Everything here is for tips below the clamp angle: for those above,
the rod is looked at from the other side of the y axis.
"""

from __future__ import annotations

from typing import NamedTuple

from derive.emit.kernels.arithmetic import any_of, larger, pi, pick
from derive.emit.kernels.levels import fall, onward, reach, turn_to
from derive.emit.kernels.rests import Rest, pick_rest
from derive.emit.kernels.shoulders import with_shoulder_level


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


def first_clamp(ground):
    """From the first hill to the clamp."""
    return from_hill_to_clamp(basin_of(ground, 0), ground.at[:3])


def first_turn(ground):
    """From the first hill to where the rod turns back at the clamp."""
    return from_hill_to_turn(ground.eta, basin_of(ground, 0), ground.at[:3])


def last_clamp(ground):
    """From the second hill to the clamp."""
    return from_hill_to_clamp(basin_of(ground, 2), ground.at[2:])


def last_turn(ground):
    """From the second hill to where the rod turns back at the clamp."""
    return from_hill_to_turn(ground.eta, basin_of(ground, 2), ground.at[2:])


def from_hill_to_clamp(basin, at):
    """From a hill to a clamp before the well."""
    return piece_of(basin, "hill", "clamp", 0, at[0], -at[1], 0, 0, at)


def from_hill_to_turn(eta, basin, at):
    """From a hill to where the rod turns back at a clamp beyond the well."""
    down, depth = turn_to(basin.hill, basin.well), at[1]
    width = -at[2]
    if not basin.even:
        above = -fall(eta, basin.well, 0, at[1])
        below = fall(eta, basin.far, 0, at[2]) - basin.far_rise
        from_top = reach(eta, basin.hill, larger(below, 0), down, 1)
        from_well = reach(eta, basin.well, above, down, -1)
        depth = pick(below < above, down - from_top, from_well)
        width = pick(below < above, from_top, down - from_well)
    return piece_of(basin, "hill", "turn", 0, width, depth, depth + at[1], 0, at)


def level_clamp(ground):
    """From the level of the ridge to the clamp."""
    level, at = ground.level, ground.at
    return piece_of(basin_of(ground, 0), "level", "clamp", level, at[0] - level, -at[1], 0, 0, at)


def level_turn(ground):
    """From the level of the ridge to where the rod turns back at the clamp, before the ridge."""
    eta, basin, level, at = ground.eta, basin_of(ground, 0), ground.level, ground.at
    down = turn_to(basin.hill, basin.well)
    above, below = -fall(eta, basin.well, 0, at[1]), fall(eta, basin.far, 0, at[2])
    from_well = reach(eta, basin.well, above, down, -1)
    # Towards the well V is flat and tells little, but there the angles tell all; towards the hill only V does.
    from_hill = reach(eta, basin.hill, ground.drop + below, down, 1)
    near = onward(eta, basin.hill, level, below, from_hill - level, True)
    by_level = below < above / 4
    width, depth = pick(by_level, near, ground.depth - from_well), pick(by_level, ground.depth - near, from_well)
    return piece_of(basin, "level", "turn", level, width, depth, depth + at[1], 0, at)


def pass_clamp(ground):
    """From the highest hill to a clamp above the level of the ridge."""
    at = ground.at
    return piece_of(over_ridge(ground), "hill", "clamp", 0, at[0], -at[1], 0, ground.level - at[0], at)


def pass_level(ground):
    """From the highest hill to the level of the ridge."""
    level, depth, at = ground.level, ground.depth, ground.at
    gap = pick(ground.by_hill, at[0] - level, at[1] + depth)
    return piece_of(over_ridge(ground), "hill", "level", 0, level, depth, gap, 0, at)


def pass_turn(ground):
    """From the highest hill to where the rod turns back at a clamp above the level of the ridge, beyond it."""
    eta, over, level, at = ground.eta, over_ridge(ground), ground.level, ground.at
    down, below = turn_to(over.hill, over.well), fall(eta, over.far, 0, at[4])
    # V of the clamp above the first well: above the ridge, and the ridge above the well.
    above = fall(eta, over.axis, 0, turn_to(over.axis, over.well)) - ground.height
    by_hill = below < above
    rest, amount = pick_rest(by_hill, over.hill, over.well), pick(by_hill, below, above)
    distance = reach(eta, rest, amount, down, pick(by_hill, 1, -1))
    width, depth = pick(by_hill, distance, down - distance), pick(by_hill, down - distance, distance)
    if over.even:
        width = -at[4]
    # Towards the hill V is flat and tells little, but there the angles tell all.
    near, apart = width >= level / 2, pick(by_hill, level - width, depth - ground.depth)
    start = pick(ground.by_hill, level, -ground.depth)
    rest = pick_rest(ground.by_hill, over.hill, over.well)
    gap = pick(near, -onward(eta, rest, start, ground.height, -apart, near), apart)
    return piece_of(over, "hill", "turn", 0, width, depth, pick(by_hill, at[0] - width, at[1] + depth), gap, at)


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
