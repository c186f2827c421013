"""Ranges of tip angles in a landscape in which a ridge is nearly there: they end at the level of its shoulder.

V is nearly level about the shoulder, and a motion that turns there stays long. How long is told by how far the level of
the tip is from the shoulder's, which a place tells to all digits only if a range ends at that level.
"""

from __future__ import annotations

from typing import NamedTuple

from derive.emit.kernels.arithmetic import ceil, cos, epsilon, larger, log, sin, sqrt
from derive.emit.kernels.levels import fall, further, onward, reach, slope, tip_fall, turn_to
from derive.emit.kernels.potential import stiffness_from_rest


class End(NamedTuple):
    """An end of a motion beside a shoulder: the far turning point or the tip, and dθ″/dθ there."""

    is_far: bool
    stiffness: float


def shoulder_moment(eta, basin, offset):
    """θ″ at an offset from the shoulder."""
    return basin.moment * cos(offset) + slope(eta, basin.shoulder, offset)


def shoulder_fall(eta, basin, start, change):
    """V(start) − V(start + change), from a start measured from the shoulder."""
    half = change / 2
    return fall(eta, basin.shoulder, start, change) + 2 * basin.moment * cos(start + half) * sin(half)


def clamp_beyond(piece):
    """Clamp less shoulder."""
    return piece.beyond_well - turn_to(piece.basin.far_well, piece.basin.shoulder)


def with_shoulder_level(eta, piece):
    """A range, or the two into which the level of the shoulder divides it where the motion turns about the shoulder."""
    basin = piece.basin
    if basin.shoulder is None or turn_to(basin.well, basin.shoulder) <= 0:
        return [piece]
    lower, upper = turn_to(basin.shoulder, basin.far), -turn_to(basin.well, basin.shoulder)
    drop = fall(eta, basin.far, 0, -lower)
    above = -fall(eta, basin.well, 0, -upper)
    down = turn_to(basin.hill, basin.well)
    by_hill = drop < above
    rest, amount, side = (basin.hill, drop, 1) if by_hill else (basin.well, above, -1)
    distance = reach(eta, rest, amount, down, side)
    level = distance if by_hill else down - distance
    width = piece.width - level
    if piece.high_kind == "turn":
        clamp = clamp_beyond(piece)
        amount = shoulder_fall(eta, basin, 0, clamp)
        if clamp >= 0 or amount <= 0:
            return [piece]
        if 2 * abs(clamp) < piece.beyond_well:
            width = onward(eta, rest, side * distance, amount, width, True)
    if width <= 0:
        return [piece]
    depth, gap = piece.high_depth + width, piece.clamp_gap + width
    first = piece._replace(high_kind="shoulder", width=level, high_depth=depth, clamp_gap=gap)
    return [first, piece._replace(low_kind="shoulder", low_offset=level, width=width)]


def beyond_shoulder(eta, basin, gap, rough):
    """How far from the shoulder V is above it by ``gap``, or below it by −gap; rough: the same where it is far."""
    size, moment = abs(gap), abs(basin.moment)
    # Near the shoulder θ″ = moment + bend·x²/2.
    bend = abs(basin.moment + 1.5 * eta * basin.shoulder.double_sine)
    near = (6 * size / bend) ** (1 / 3)
    near = near if near * moment < size else size / moment
    near = near if gap > 0 else -near
    return onward(eta, basin.shoulder, 0, -gap, near if abs(near) < 0.5 else rough, True, basin.moment)


def shoulder_side(eta, piece, rise, drop, done, left, by_hill, distance):
    """``motion.far_side`` where a ridge is nearly there: V may be so nearly level about its shoulder that only the
    level of the shoulder, or of the clamp, tells where the motion turns.

    left, distance: how far beyond the clamp, and from the hill or the well there, as far as V from those tells it.
    """
    basin, clamp = piece.basin, clamp_beyond(piece)
    beside = distance if by_hill else piece.beyond_well + left
    turn = clamp + left  # far turning point − shoulder
    near = 2 * abs(turn) < beside
    if near and "shoulder" in (piece.low_kind, piece.high_kind):
        change = -rise if piece.low_kind == "shoulder" else drop
        turn = beyond_shoulder(eta, basin, tip_fall(eta, piece, change, rise, drop), turn)
        left = turn - clamp
    # From the nearer of the two levels at which the range ends.
    if piece.high_kind == "turn" and (piece.low_kind != "shoulder" or 2 * left <= abs(clamp)):
        left = max(past_clamp(eta, piece, tip_fall(eta, piece, drop, rise, drop), left), 0)
        turn = clamp + left
    if near:
        moment = shoulder_moment(eta, basin, turn)
    else:
        well_offset = piece.beyond_well + left
        moment = slope(eta, basin.far, -distance) if by_hill else slope(eta, basin.far_well, well_offset)
        moment = min(moment, -4 * epsilon() * beside)
    far_distance = distance if by_hill and not near else piece.far_gap - left
    end = End(True, shoulder_stiffness(eta, basin, turn)) if near else None
    return (done + left) / 2, left, -moment, far_distance, end


def shoulder_stiffness(eta, basin, offset):
    """dθ″/dθ at an offset from the shoulder."""
    rest = basin.shoulder
    stiffness = stiffness_from_rest(eta, rest.stiffness, rest.double_cosine, rest.double_sine, offset)
    return stiffness - basin.moment * sin(offset)


def beside_shoulder(eta, basin, from_hill, offset, moment, end):
    """θ″ at the tip, and the end of the motion that is beside the shoulder, if the shoulder is nearer to the tip than
    the hill or well by whose offset it was told; else as they are given."""
    apart = from_hill - turn_to(basin.hill, basin.shoulder)
    if 2 * abs(apart) >= abs(offset):
        return moment, end
    return shoulder_moment(eta, basin, apart), End(False, shoulder_stiffness(eta, basin, apart))


def past_clamp(eta, piece, amount, rough):
    """``motion.beyond_clamp``, from the shoulder if that is nearer to the clamp than a hill or a well."""
    offset, apart = piece.clamp_offset, clamp_beyond(piece)
    if 2 * abs(apart) < abs(offset):
        basin = piece.basin
        return further(eta, basin.shoulder, apart, amount, rough, rough > 0.5 * abs(offset), basin.moment)
    return further(eta, piece.clamp_rest, offset, amount, rough, rough > 0.25 * abs(offset))


def beside_level(eta, piece):
    """Places, without their sign, from the middle of a range to where its motion turns at the level of the shoulder.

    The length of a motion changes with the logarithm of the level's distance from the shoulder's until there the moment
    is as good as the shoulder's own.
    """
    basin, level = piece.basin, piece.low_offset if piece.low_kind == "shoulder" else piece.width
    moment = larger(abs(basin.moment), epsilon() ** 2)
    bend = abs(basin.moment + 1.5 * eta * basin.shoulder.double_sine)
    steep = larger(abs(slope(eta, basin.hill, level)), epsilon() ** 2)
    flat = larger(log(steep * piece.width * sqrt(bend) / moment) - log(moment) / 2, 0)
    found = [flat * k / (ceil(flat / 3) + 1) for k in range(1, ceil(flat / 3) + 2)] if flat > 0 else []
    last = max([*found, flat])
    # At the last place the level is the shoulder's in all digits, and the next range begins with the same length.
    return [*found, last + 1.25, last + 2.5, last + 5, last + 10, last - log(epsilon()), last - 3 * log(epsilon())]
