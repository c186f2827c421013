"""The kernels of ``pieces`` on arrays.

Emitted by `derive emit` from kernels/pieces.py: do not edit, change that file.

Digest of the inputs: sha256 6845cd39e8093e64831ff9a2d7194c143ef42a3ff0d231d4dcaeb7b36b7aa3de
"""

from __future__ import annotations

from derive.emit.kernels.arithmetic import pi
from derive.emit.kernels.array_arithmetic import each_abs, each_any_of, each_pick, larger
from derive.emit.kernels.levels_each import fall_each, onward_each, reach_each, turn_to_each
from derive.emit.kernels.pieces import Basin, Piece
from derive.emit.kernels.rests_each import pick_rest_each
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


def first_clamp_each(ground):
    """From the first hill to the clamp."""
    return from_hill_to_clamp_each(basin_of_each(ground, 0), ground.at[:3])


def first_turn_each(ground):
    """From the first hill to where the rod turns back at the clamp."""
    return from_hill_to_turn_each(ground.eta, basin_of_each(ground, 0), ground.at[:3])


def last_clamp_each(ground):
    """From the second hill to the clamp."""
    return from_hill_to_clamp_each(basin_of_each(ground, 2), ground.at[2:])


def last_turn_each(ground):
    """From the second hill to where the rod turns back at the clamp."""
    return from_hill_to_turn_each(ground.eta, basin_of_each(ground, 2), ground.at[2:])


def from_hill_to_clamp_each(basin, at):
    """From a hill to a clamp before the well."""
    return piece_of_each(basin, "hill", "clamp", 0, at[0], -at[1], 0, 0, at)


def from_hill_to_turn_each(eta, basin, at):
    """From a hill to where the rod turns back at a clamp beyond the well."""
    down, depth = turn_to_each(basin.hill, basin.well), at[1]
    width = -at[2]
    if not basin.even:
        above = -fall_each(eta, basin.well, 0, at[1])
        below = fall_each(eta, basin.far, 0, at[2]) - basin.far_rise
        from_top = reach_each(eta, basin.hill, larger(below, 0), down, 1)
        from_well = reach_each(eta, basin.well, above, down, -1)
        depth = each_pick(below < above, down - from_top, from_well)
        width = each_pick(below < above, from_top, down - from_well)
    return piece_of_each(basin, "hill", "turn", 0, width, depth, depth + at[1], 0, at)


def level_clamp_each(ground):
    """From the level of the ridge to the clamp."""
    level, at = ground.level, ground.at
    return piece_of_each(basin_of_each(ground, 0), "level", "clamp", level, at[0] - level, -at[1], 0, 0, at)


def level_turn_each(ground):
    """From the level of the ridge to where the rod turns back at the clamp, before the ridge."""
    eta, basin, level, at = ground.eta, basin_of_each(ground, 0), ground.level, ground.at
    down = turn_to_each(basin.hill, basin.well)
    above, below = -fall_each(eta, basin.well, 0, at[1]), fall_each(eta, basin.far, 0, at[2])
    from_well = reach_each(eta, basin.well, above, down, -1)
    # Towards the well V is flat and tells little, but there the angles tell all; towards the hill only V does.
    from_hill = reach_each(eta, basin.hill, ground.drop + below, down, 1)
    near = onward_each(eta, basin.hill, level, below, from_hill - level, True)
    by_level = below < above / 4
    width, depth = (
        each_pick(by_level, near, ground.depth - from_well),
        each_pick(by_level, ground.depth - near, from_well),
    )
    return piece_of_each(basin, "level", "turn", level, width, depth, depth + at[1], 0, at)


def pass_clamp_each(ground):
    """From the highest hill to a clamp above the level of the ridge."""
    at = ground.at
    return piece_of_each(over_ridge_each(ground), "hill", "clamp", 0, at[0], -at[1], 0, ground.level - at[0], at)


def pass_level_each(ground):
    """From the highest hill to the level of the ridge."""
    level, depth, at = ground.level, ground.depth, ground.at
    gap = each_pick(ground.by_hill, at[0] - level, at[1] + depth)
    return piece_of_each(over_ridge_each(ground), "hill", "level", 0, level, depth, gap, 0, at)


def pass_turn_each(ground):
    """From the highest hill to where the rod turns back at a clamp above the level of the ridge, beyond it."""
    eta, over, level, at = ground.eta, over_ridge_each(ground), ground.level, ground.at
    down, below = turn_to_each(over.hill, over.well), fall_each(eta, over.far, 0, at[4])
    # V of the clamp above the first well: above the ridge, and the ridge above the well.
    above = fall_each(eta, over.axis, 0, turn_to_each(over.axis, over.well)) - ground.height
    by_hill = below < above
    rest, amount = pick_rest_each(by_hill, over.hill, over.well), each_pick(by_hill, below, above)
    distance = reach_each(eta, rest, amount, down, each_pick(by_hill, 1, -1))
    width, depth = each_pick(by_hill, distance, down - distance), each_pick(by_hill, down - distance, distance)
    if over.even:
        width = -at[4]
    # Towards the hill V is flat and tells little, but there the angles tell all.
    near, apart = width >= level / 2, each_pick(by_hill, level - width, depth - ground.depth)
    start = each_pick(ground.by_hill, level, -ground.depth)
    rest = pick_rest_each(ground.by_hill, over.hill, over.well)
    gap = each_pick(near, -onward_each(eta, rest, start, ground.height, -apart, near), apart)
    return piece_of_each(
        over, "hill", "turn", 0, width, depth, each_pick(by_hill, at[0] - width, at[1] + depth), gap, at
    )


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
