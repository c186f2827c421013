"""Ranges of tip angles in a landscape in which a ridge is nearly there: they end at the level of its shoulder.

V is nearly level about the shoulder, and a motion that turns there stays long. How long is told by how far the level of
the tip is from the shoulder's, which a place tells to all digits only if a range ends at that level.
"""

from __future__ import annotations

from derive.emit.kernels.arithmetic import ceil, cos, epsilon, larger, log, pick, sin, sqrt
from derive.emit.kernels.levels import fall, onward, reach, slope, turn_to
from derive.emit.kernels.rests import pick_rest


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
    distance = reach(eta, pick_rest(by_hill, basin.hill, basin.well), pick(by_hill, drop, above), down, 1 if by_hill else -1)
    level, start = (distance, distance) if by_hill else (down - distance, -distance)
    width = piece.width - level
    if piece.high_kind == "turn":
        clamp = clamp_beyond(piece)
        amount = shoulder_fall(eta, basin, 0, clamp)
        if clamp >= 0 or amount <= 0:
            return [piece]
        if 2 * abs(clamp) < piece.beyond_well:
            rest = pick_rest(by_hill, basin.hill, basin.well)
            width = onward(eta, rest, start, amount, width, True)
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
