"""The kernels of ``range_kinds`` on arrays.

Emitted by `derive emit` from kernels/range_kinds.py: do not edit, change that file.

Digest of the inputs: sha256 dcfcece18836a26d26becb8d86c6a0cc671ee1745de9812fcc266a92baebc394
"""

from __future__ import annotations

from derive.emit.kernels.array_arithmetic import each_pick, larger
from derive.emit.kernels.basins_each import basin_of_each, over_ridge_each, piece_of_each
from derive.emit.kernels.levels_each import fall_each, onward_each, reach_each, turn_to_each
from derive.emit.kernels.rests_each import pick_rest_each


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
