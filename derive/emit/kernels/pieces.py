"""The ranges of tip angles from which a rod can rise to its clamp angle, each with one kind of motion.

Seen from the tip, θ moves in the potential V from rest at φ; it reaches the clamp angle only if V(φ) is not below V
anywhere between. Those φ fill the ranges below. Everything here is for tips below the clamp angle: for those above,
the rod is looked at from the other side of the y axis.
"""

from __future__ import annotations

from typing import NamedTuple

from derive.emit.kernels.arithmetic import any_of, asin, cos, epsilon, floor, larger, pi, pick, sin, spacing, sqrt
from derive.emit.kernels.formulas import rest_fall, rest_moment
from derive.emit.kernels.landscape import Landscape, Rest, offset_from, pick_rest
from derive.emit.kernels.potential import fall_from_rest, moment_from_rest


class Basin(NamedTuple):
    """What stops the rod and what it swings about: the hill that tips come from and the well below them, the hill
    that stops the motion and the last well before it, and the direction where it is slowest between its ends: the
    ridge that it passes, or the well.

    far_rise: V(far) − V(hill). even: the motion is symmetric about its middle. whole: far is the hill a turn on.
    shoulder, moment: of a landscape in which a ridge is nearly there.
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


class Clamp(NamedTuple):
    """The clamp angle in a landscape: whole turns, and its offset from each direction without moment."""

    turns: int
    offsets: tuple[float, ...]


def clamp_in(rests, angle):
    """Whole turns such that the clamp lies from the first hill up to, but not at, its like a turn on."""
    turns = floor((angle - rests[0].angle) / (2 * pi))
    for _ in range(3):
        offsets = tuple(offset_from(rest, angle, turns) for rest in rests)
        shift = pick(offsets[0] < 0, -1, pick(offsets[-1] >= 0, 1, 0))
        if not any_of(shift != 0):
            break
        turns = turns + shift
    return Clamp(turns, offsets)


def turn_to(start, end):
    """The angle from one direction without moment to another, however near they are to each other."""
    return (end.quarters - start.quarters) * (pi / 2) + (end.extra - start.extra)


def fall(eta, rest, start, change):
    """V(start) − V(start + change), from a start measured from a direction without moment."""
    half = change / 2
    return fall_from_rest(eta, rest.stiffness, rest.double_cosine, rest.double_sine, start + half, half)


def slope(eta, rest, offset):
    """θ″ at an offset from a direction without moment."""
    return moment_from_rest(eta, rest.stiffness, rest.double_cosine, rest.double_sine, offset)


def reach(eta, rest, amount, most, side):
    """The distance from a hill (or a well) at which V is lower (or higher) by ``amount``, to one side.

    most: the distance of the next well (or hill). Halley's method for the square root of the difference, which is
    nearly linear, from the pendulum's value.
    """
    amount = larger(amount, 0)  # of a hill and a well that nearly meet, rounding may give less
    share = amount / larger(abs(fall(eta, rest, 0, side * most)), epsilon() ** 20)
    near = most * asin(sqrt(pick(share < 1, share, 1))) * (2 / pi)
    goal = sqrt(amount)
    for _ in range(40):
        step, bent = step_to(eta, rest, side * near, goal)
        safe = abs(bent) < 0.5
        trial = near - step / pick(safe, 1 - bent, 1)
        trial = pick(trial > most, (near + most) / 2, pick(trial < 0, near / 2, trial))
        # The method cubes the error, and Newton's squares it: after steps this small the next would change nothing.
        small = pick(safe, spacing(trial) ** 0.45, spacing(trial) ** 0.6)
        moving, near = abs(trial - near) > small * near, trial
        if not any_of(moving):
            break
    return near


def step_to(eta, rest, offset, goal):
    """Newton's step to where the square root of the change of V from a direction without moment is ``goal``, and by
    how much its slope changes half way there, as a share of it."""
    small, large = sin(offset / 4), cos(offset / 4)
    sine, cosine = 2 * small * large, 1 - 2 * small * small
    level = rest_fall(eta, rest.stiffness, rest.double_cosine, rest.double_sine, small, large, small, large)
    force = abs(rest_moment(eta, rest.stiffness, rest.double_cosine, rest.double_sine, sine, cosine))
    here, force = sqrt(abs(level)), larger(force, epsilon() ** 20)
    whole_sine, whole_cosine = 2 * sine * cosine, 1 - 2 * sine * sine
    # dθ″/dθ, by β and α as the direction has them.
    turned = rest.double_cosine * (2 * whole_cosine * whole_cosine - 1 - whole_cosine)
    turned = turned - rest.double_sine * whole_sine * (2 * whole_cosine - 0.5)
    bend = (rest.stiffness * whole_cosine + eta * turned) * (here / force) * (here / force)
    share = (here - goal) / larger(here, epsilon() ** 20)
    return 2 * here * (here - goal) / force, share * (pick(level < 0, -bend, bend) - 0.5)


def onward(eta, rest, start, amount, rough, wanted, moment=0):
    """How far beyond ``start``, an offset from a direction of that moment, V has fallen by ``amount``.

    The rough value is good to rounding of the angles; where little of it is left, the slope of V at the start gives a
    better one. Newton's method does the rest, until all that are wanted are found.
    """
    steep = slope(eta, rest, start) + moment * cos(start)
    told = (abs(rough) > 1e-3 * abs(start)) | (steep == 0)
    distance = pick(told, rough, amount / pick(told, 1, steep))
    for _ in range(40):
        force = slope(eta, rest, start + distance) + moment * cos(start + distance)
        fallen = fall(eta, rest, start, distance) + 2 * moment * cos(start + distance / 2) * sin(distance / 2)
        step = (fallen - amount) / pick(force == 0, 1, force)
        away = abs(distance - step) > pi
        stuck = away & (distance == rough)
        distance = pick(away, rough, distance - step)
        if not any_of(wanted & (stuck == 0) & (abs(step) > spacing(distance) ** 0.6 * abs(distance))):
            break
    return distance


def ridge_fall(beta, eta, field_angle, hill, ridge):
    """V(hill) − V(ridge): the sine of half their distance times the slope of V between, as if it were a circle."""
    half, middle = (ridge.extra - hill.extra) / 2, pi / 2 + (hill.extra + ridge.extra) / 2
    return cos(half) * (2 * beta * sin(middle) - eta * sin(half) * sin(2 * (middle - field_angle)))


class Ground(NamedTuple):
    """What the ranges of a rod are told by: its landscape and the clamp's offsets from the directions there.

    drop: V(hill) − V(ridge); level: from the hill to the level of the ridge, depth: from there to the well; by_hill:
    level is told by the hill, depth by the well if not; height: V(ridge) − V(clamp). They are 0 where no ridge is lower
    than the hill.
    """

    eta: float
    scene: Landscape
    at: tuple[float, ...]
    drop: float
    level: float
    depth: float
    by_hill: bool
    height: float


def ground_of(beta, eta, field_angle, scene, clamp):
    """The ground of a rod."""
    rests, at = scene.rests, clamp.offsets
    if len(rests) == 3:
        return level_ground(eta, scene, at)
    drop = 0 if scene.level else ridge_fall(beta, eta, field_angle, rests[0], rests[2])
    # A ridge lower by less than this would be passed only from within its square root of the hill.
    if drop <= epsilon() ** 17 * (beta + eta):
        return level_ground(eta, scene._replace(level=True, even=True), at)
    return ridge_ground(eta, scene, at, drop)


def level_ground(eta, scene, at):
    """The ground without a ridge lower than the hill."""
    return Ground(eta, scene, at, 0, 0, 0, True, 0)


def ridge_ground(eta, scene, at, drop):
    """The ground with a lower ridge."""
    rests = scene.rests
    down, above = turn_to(rests[0], rests[1]), fall(eta, rests[2], 0, turn_to(rests[2], rests[1]))
    # Of a ridge that is next to its wells V tells at the hill nothing.
    by_hill = drop < above
    rest, amount = pick_rest(by_hill, rests[0], rests[1]), pick(by_hill, drop, above)
    distance = reach(eta, rest, amount, down, pick(by_hill, 1, -1))
    level, depth = pick(by_hill, distance, down - distance), pick(by_hill, down - distance, distance)
    # Near the far hill V says which is higher only by the distance from that hill.
    height = pick(at[2] < -at[4], fall(eta, rests[2], 0, at[2]), fall(eta, rests[4], 0, at[4]) - drop)
    return Ground(eta, scene, at, drop, level, depth, by_hill, height)


def pieces(beta, eta, field_angle, scene, clamp):
    """All ranges of tip angles below the clamp angle."""
    ground = ground_of(beta, eta, field_angle, scene, clamp)
    return [build(ground) for here, build in ranges(ground) if here]


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
    rise, beside = ground.drop if first else 0, (scene.shoulder, scene.moment)
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
    width = pick(below < above / 4, near, down - level - from_well)
    return piece_of(basin, "level", "turn", level, width, from_well, from_well + at[1], 0, at)


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
