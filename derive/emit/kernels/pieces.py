"""The ranges of tip angles from which a rod can rise to its clamp angle, each with one kind of motion.

Seen from the tip, θ moves in the potential V from rest at φ; it reaches the clamp angle only if V(φ) is not below V
anywhere between. Those φ fill the ranges below. Everything here is for tips below the clamp angle: for those above,
the rod is looked at from the other side of the y axis.
"""

from __future__ import annotations

from typing import NamedTuple

from derive.emit.kernels.arithmetic import any_of, asin, cos, epsilon, floor, larger, pi, pick, sin, sqrt
from derive.emit.kernels.landscape import Rest, offset_from
from derive.emit.kernels.potential import fall_from_rest, moment_from_rest


class Basin(NamedTuple):
    """What stops the rod and what it swings about: the hill that tips come from and the well below them, the hill
    that stops the motion and the last well before it, and the direction where it is slowest between its ends: the
    ridge that it passes, or the well.

    far_rise: V(far) − V(hill). even: the motion is symmetric about its middle.
    """

    hill: Rest
    well: Rest
    far: Rest
    far_well: Rest
    axis: Rest
    far_rise: float
    passes: bool
    even: bool


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


class Clamp(NamedTuple):
    """The clamp angle in a landscape: whole turns, and its offset from each direction without moment."""

    turns: int
    offsets: tuple[float, ...]


def clamp_in(rests, angle):
    """Whole turns such that the clamp lies from the first hill up to, but not at, its like a turn on."""
    start = floor((angle - rests[0].angle) / (2 * pi))
    for turns in (start, start - 1, start + 1):
        offsets = tuple(offset_from(rest, angle, turns) for rest in rests)
        if offsets[0] >= 0 > offsets[-1]:
            break
    return Clamp(turns, offsets)


def fall(eta, rest, start, change):
    """V(start) − V(start + change), from a start measured from a direction without moment."""
    half = change / 2
    return fall_from_rest(eta, rest.stiffness, rest.double_cosine, rest.double_sine, start + half, half)


def slope(eta, rest, offset):
    """θ″ at an offset from a direction without moment."""
    return moment_from_rest(eta, rest.stiffness, rest.double_cosine, rest.double_sine, offset)


def reach(eta, rest, amount, most, side):
    """The distance from a hill (or a well) at which V is lower (or higher) by ``amount``, to one side.

    most: the distance of the next well (or hill). Newton's method for the square root of the difference, which is
    nearly linear, from the pendulum's value.
    """
    share = amount / abs(fall(eta, rest, 0, side * most))
    near = most * asin(sqrt(pick(share < 1, share, 1))) * (2 / pi)
    goal, moving = sqrt(amount), True
    for _ in range(40):
        here = sqrt(abs(fall(eta, rest, 0, side * near)))
        force = larger(abs(slope(eta, rest, side * near)), epsilon() ** 20)
        trial = near - 2 * here * (here - goal) / force
        trial = pick(trial > most, (near + most) / 2, pick(trial < 0, near / 2, trial))
        moving, near = abs(trial - near) > 4 * epsilon() * near, trial
        if not any_of(moving):
            break
    return near


def onward(eta, rest, start, amount, rough):
    """How far beyond ``start``, an offset from a direction without moment, V has fallen by ``amount``.

    The rough value is good to rounding of the angles; where little of it is left, the slope of V at the start gives a
    better one. Newton's method does the rest.
    """
    distance = pick(abs(rough) > 1e-3 * abs(start), rough, amount / slope(eta, rest, start))
    for _ in range(40):
        force = slope(eta, rest, start + distance)
        step = (fall(eta, rest, start, distance) - amount) / pick(force == 0, 1, force)
        distance = pick(abs(distance - step) > pi, rough, distance - step)
        if not any_of(abs(step) > 4 * epsilon() * abs(distance)):
            break
    return distance


def ridge_fall(beta, eta, field_angle, hill, ridge):
    """V(hill) − V(ridge): the sine of half their distance times the slope of V between, as if it were a circle."""
    half, middle = (ridge.extra - hill.extra) / 2, pi / 2 + (hill.extra + ridge.extra) / 2
    return cos(half) * (2 * beta * sin(middle) - eta * sin(half) * sin(2 * (middle - field_angle)))


def pieces(beta, eta, field_angle, scene, clamp):
    """All ranges of tip angles below the clamp angle."""
    rests, at = scene.rests, clamp.offsets
    if len(rests) == 3:
        even = eta == 0 or field_angle == 0 or field_angle == pi / 2
        return in_basin(eta, local_basin(rests, 0, 0, even), at)
    if scene.level:
        first = 0 if at[2] < 0 else 2
        return in_basin(eta, local_basin(rests, first, 0, True), at[first:])
    drop = ridge_fall(beta, eta, field_angle, rests[0], rests[2])
    level = reach(eta, rests[0], drop, rests[1].angle - rests[0].angle, 1)
    over = Basin(rests[0], rests[1], rests[4], rests[3], rests[2], 0, True, field_angle == 0)
    if at[2] <= 0:
        return in_first_basin(eta, over, local_basin(rests, 0, 0, False), level, at)
    height = fall(eta, rests[2], 0, at[2])
    if height > 0:
        inner = in_basin(eta, local_basin(rests, 2, drop, False), at[2:])
        return [pass_level(over, level, at), *inner]
    return [pass_turn(eta, over, level, -height, at)]


def local_basin(rests, first, far_rise, even):
    """The basin between two neighbouring hills."""
    hill, well, far = rests[first : first + 3]
    return Basin(hill, well, far, well, well, far_rise, False, even)


def in_basin(eta, basin, at):
    """The range in a basin of its own, from its hill up."""
    if at[0] == 0:
        return []
    return [from_hill(eta, basin, at)]


def in_first_basin(eta, over, basin, level, at):
    """The ranges when the clamp lies before the ridge, or on it."""
    if at[0] == 0:
        return []
    if at[0] <= level:
        return [pass_clamp(over, level, at)]
    if at[2] == 0:
        return [pass_level(over, level, at)]
    return [pass_level(over, level, at), from_level(eta, basin, level, at)]


def from_hill(eta, basin, at):
    """From the hill to the clamp, or to where the rod turns back at it."""
    if at[1] <= 0:
        return piece_of(basin, "hill", "clamp", 0, at[0], -at[1], 0, 0, at)
    down, depth = basin.well.angle - basin.hill.angle, at[1]
    width = -at[2]
    if not basin.even:
        above = -fall(eta, basin.well, 0, at[1])
        below = fall(eta, basin.far, 0, at[2]) - basin.far_rise
        from_top = reach(eta, basin.hill, larger(below, 0), down, 1)
        from_well = reach(eta, basin.well, above, down, -1)
        depth = pick(below < above, down - from_top, from_well)
        width = pick(below < above, from_top, down - from_well)
    return piece_of(basin, "hill", "turn", 0, width, depth, depth + at[1], 0, at)


def from_level(eta, basin, level, at):
    """From the level of the ridge to the clamp, or to where the rod turns back at it, before the ridge."""
    if at[1] <= 0:
        return piece_of(basin, "level", "clamp", level, at[0] - level, -at[1], 0, 0, at)
    down = basin.well.angle - basin.hill.angle
    above, below = -fall(eta, basin.well, 0, at[1]), fall(eta, basin.far, 0, at[2])
    from_well = reach(eta, basin.well, above, down, -1)
    width = onward(eta, basin.hill, level, below, down - level - from_well)
    return piece_of(basin, "level", "turn", level, width, from_well, from_well + at[1], 0, at)


def pass_clamp(over, level, at):
    """From the highest hill to a clamp above the level of the ridge."""
    return piece_of(over, "hill", "clamp", 0, at[0], -at[1], 0, level - at[0], at)


def pass_level(over, level, at):
    """From the highest hill to the level of the ridge."""
    return piece_of(over, "hill", "level", 0, level, over.well.angle - over.hill.angle - level, at[0] - level, 0, at)


def pass_turn(eta, over, level, height, at):
    """From the highest hill to where the rod turns back at a clamp above the level of the ridge, beyond it."""
    down = over.well.angle - over.hill.angle
    width = -at[4] if over.even else reach(eta, over.hill, fall(eta, over.far, 0, at[4]), down, 1)
    gap = -onward(eta, over.hill, level, -height, width - level)
    return piece_of(over, "hill", "turn", 0, width, down - width, at[0] - width, gap, at)


def piece_of(basin, low_kind, high_kind, low_offset, width, high_depth, clamp_gap, level_gap, at):
    """The record of a range."""
    rests = (basin.hill, basin.well, basin.axis, basin.far_well, basin.far) if basin.passes else basin[:3]
    rest, offset = min(zip(rests, at, strict=False), key=lambda pair: abs(pair[1]))
    last = at[len(rests) - 1]
    return Piece(basin, low_kind, high_kind, low_offset, width, high_depth, clamp_gap, level_gap, rest, offset, -last)
