"""The kernels of ``pieces`` on arrays.

Emitted by `derive emit` from kernels/pieces.py: do not edit, change that file.

Digest of the inputs: sha256 3cffeb4a735b4a998de80a4a7370766d3b11d91c20d21391edf39f8544a4d015
"""

from __future__ import annotations

from derive.emit.kernels.arithmetic import epsilon, pi
from derive.emit.kernels.array_arithmetic import (
    any_of,
    each_abs,
    each_asin,
    each_cos,
    each_floor,
    each_pick,
    each_sin,
    each_spacing,
    each_sqrt,
    larger,
)
from derive.emit.kernels.formulas_each import rest_fall_each, rest_moment_each
from derive.emit.kernels.landscape_each import offset_from_each, pick_rest_each
from derive.emit.kernels.pieces import Basin, Clamp, Ground, Piece
from derive.emit.kernels.potential_each import fall_from_rest_each, moment_from_rest_each


def clamp_in_each(rests, angle):
    """Whole turns such that the clamp lies from the first hill up to, but not at, its like a turn on."""
    turns = each_floor((angle - rests[0].angle) / (2 * pi))
    for _ in range(3):
        offsets = tuple(offset_from_each(rest, angle, turns) for rest in rests)
        shift = each_pick(offsets[0] < 0, -1, each_pick(offsets[-1] >= 0, 1, 0))
        if not any_of(shift != 0):
            break
        turns = turns + shift
    return Clamp(turns, offsets)


def turn_to_each(start, end):
    """The angle from one direction without moment to another, however near they are to each other."""
    return (end.quarters - start.quarters) * (pi / 2) + (end.extra - start.extra)


def fall_each(eta, rest, start, change):
    """V(start) − V(start + change), from a start measured from a direction without moment."""
    half = change / 2
    return fall_from_rest_each(eta, rest.stiffness, rest.double_cosine, rest.double_sine, start + half, half)


def slope_each(eta, rest, offset):
    """θ″ at an offset from a direction without moment."""
    return moment_from_rest_each(eta, rest.stiffness, rest.double_cosine, rest.double_sine, offset)


def reach_each(eta, rest, amount, most, side):
    """The distance from a hill (or a well) at which V is lower (or higher) by ``amount``, to one side.

    most: the distance of the next well (or hill). Halley's method for the square root of the difference, which is
    nearly linear, from the pendulum's value.
    """
    amount = larger(amount, 0)  # of a hill and a well that nearly meet, rounding may give less
    share = amount / larger(each_abs(fall_each(eta, rest, 0, side * most)), epsilon() ** 20)
    near = most * each_asin(each_sqrt(each_pick(share < 1, share, 1))) * (2 / pi)
    goal = each_sqrt(amount)
    for _ in range(40):
        step, bent = step_to_each(eta, rest, side * near, goal)
        safe = each_abs(bent) < 0.5
        trial = near - step / each_pick(safe, 1 - bent, 1)
        trial = each_pick(trial > most, (near + most) / 2, each_pick(trial < 0, near / 2, trial))
        # The method cubes the error, and Newton's squares it: after steps this small the next would change nothing.
        small = each_pick(safe, each_spacing(trial) ** 0.45, each_spacing(trial) ** 0.6)
        moving, near = each_abs(trial - near) > small * near, trial
        if not any_of(moving):
            break
    return near


def step_to_each(eta, rest, offset, goal):
    """Newton's step to where the square root of the change of V from a direction without moment is ``goal``, and by
    how much its slope changes half way there, as a share of it."""
    small, large = each_sin(offset / 4), each_cos(offset / 4)
    sine, cosine = 2 * small * large, 1 - 2 * small * small
    level = rest_fall_each(eta, rest.stiffness, rest.double_cosine, rest.double_sine, small, large, small, large)
    force = each_abs(rest_moment_each(eta, rest.stiffness, rest.double_cosine, rest.double_sine, sine, cosine))
    here, force = each_sqrt(each_abs(level)), larger(force, epsilon() ** 20)
    whole_sine, whole_cosine = 2 * sine * cosine, 1 - 2 * sine * sine
    # dθ″/dθ, by β and α as the direction has them.
    turned = rest.double_cosine * (2 * whole_cosine * whole_cosine - 1 - whole_cosine)
    turned = turned - rest.double_sine * whole_sine * (2 * whole_cosine - 0.5)
    bend = (rest.stiffness * whole_cosine + eta * turned) * (here / force) * (here / force)
    share = (here - goal) / larger(here, epsilon() ** 20)
    return 2 * here * (here - goal) / force, share * (each_pick(level < 0, -bend, bend) - 0.5)


def onward_each(eta, rest, start, amount, rough, wanted, moment=0):
    """How far beyond ``start``, an offset from a direction of that moment, V has fallen by ``amount``.

    The rough value is good to rounding of the angles; where little of it is left, the slope of V at the start gives a
    better one. Newton's method does the rest, until all that are wanted are found.
    """
    steep = slope_each(eta, rest, start) + moment * each_cos(start)
    told = (each_abs(rough) > 0.001 * each_abs(start)) | (steep == 0)
    distance = each_pick(told, rough, amount / each_pick(told, 1, steep))
    for _ in range(40):
        force = slope_each(eta, rest, start + distance) + moment * each_cos(start + distance)
        fallen = (
            fall_each(eta, rest, start, distance)
            + 2 * moment * each_cos(start + distance / 2) * each_sin(distance / 2)
        )
        step = (fallen - amount) / each_pick(force == 0, 1, force)
        away = each_abs(distance - step) > pi
        stuck = away & (distance == rough)
        distance = each_pick(away, rough, distance - step)
        if not any_of(wanted & (stuck == 0) & (each_abs(step) > each_spacing(distance) ** 0.6 * each_abs(distance))):
            break
    return distance


def ridge_fall_each(beta, eta, field_angle, hill, ridge):
    """V(hill) − V(ridge): the sine of half their distance times the slope of V between, as if it were a circle."""
    half, middle = (ridge.extra - hill.extra) / 2, pi / 2 + (hill.extra + ridge.extra) / 2
    return each_cos(half) * (2 * beta * each_sin(middle) - eta * each_sin(half) * each_sin(2 * (middle - field_angle)))


def ground_of_each(beta, eta, field_angle, scene, clamp):
    """The ground of a rod."""
    rests, at = scene.rests, clamp.offsets
    if len(rests) == 3:
        return level_ground_each(eta, scene, at)
    drop = 0 if scene.level else ridge_fall_each(beta, eta, field_angle, rests[0], rests[2])
    # A ridge lower by less than this would be passed only from within its square root of the hill.
    if drop <= epsilon() ** 17 * (beta + eta):
        return level_ground_each(eta, scene._replace(level=True, even=True), at)
    return ridge_ground_each(eta, scene, at, drop)


def level_ground_each(eta, scene, at):
    """The ground without a ridge lower than the hill."""
    return Ground(eta, scene, at, 0, 0, 0, True, 0)


def ridge_ground_each(eta, scene, at, drop):
    """The ground with a lower ridge."""
    rests = scene.rests
    down, above = turn_to_each(rests[0], rests[1]), fall_each(eta, rests[2], 0, turn_to_each(rests[2], rests[1]))
    # Of a ridge that is next to its wells V tells at the hill nothing.
    by_hill = drop < above
    rest, amount = pick_rest_each(by_hill, rests[0], rests[1]), each_pick(by_hill, drop, above)
    distance = reach_each(eta, rest, amount, down, each_pick(by_hill, 1, -1))
    level, depth = each_pick(by_hill, distance, down - distance), each_pick(by_hill, down - distance, distance)
    # Near the far hill V says which is higher only by the distance from that hill.
    height = each_pick(at[2] < -at[4], fall_each(eta, rests[2], 0, at[2]), fall_each(eta, rests[4], 0, at[4]) - drop)
    return Ground(eta, scene, at, drop, level, depth, by_hill, height)


def pieces_each(beta, eta, field_angle, scene, clamp):
    """All ranges of tip angles below the clamp angle."""
    ground = ground_of_each(beta, eta, field_angle, scene, clamp)
    return [build(ground) for here, build in ranges_each(ground) if here]


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
    rise, beside = ground.drop if first else 0, (scene.shoulder, scene.moment)
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
    width = each_pick(below < above / 4, near, down - level - from_well)
    return piece_of_each(basin, "level", "turn", level, width, from_well, from_well + at[1], 0, at)


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
        if any_of(closer):
            rest, offset = pick_rest_each(closer, other, rest), each_pick(closer, distance, offset)
    beyond, last = at[len(rests) - 2 : len(rests)]
    ends = low_kind, high_kind, low_offset, width, high_depth, clamp_gap, level_gap
    return Piece(basin, *ends, rest, offset, -last, beyond, at[0], at[1])
