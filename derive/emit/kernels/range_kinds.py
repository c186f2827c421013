"""Each kind of range of tip angles, by its ends: a hill, the level of the ridge, the clamp, or where rods turn."""

from __future__ import annotations

from derive.emit.kernels.arithmetic import larger, pick
from derive.emit.kernels.basins import basin_of, over_ridge, piece_of
from derive.emit.kernels.levels import fall, onward, reach, turn_to
from derive.emit.kernels.rests import pick_rest


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
