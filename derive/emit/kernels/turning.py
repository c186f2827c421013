"""Where a motion turns back: at the clamp or beyond it, told by the level of V at the tip."""

from __future__ import annotations

from derive.emit.kernels.arithmetic import any_of, asin, atan2, cos, epsilon, larger, pi, pick, sin, sqrt
from derive.emit.kernels.levels import fall, further, reach, slope, tip_fall, turn_to
from derive.emit.kernels.shoulders import shoulder_side


def parallel_side(beta, eta, piece, rise, drop, from_hill, depth):
    """``far_side`` within a well for a field along the force: the cosines of the turning points add up to −2β/η."""
    basin = piece.basin
    if piece.low_kind == "level":
        low, high = sin(rise / 2) * sin(piece.low_offset + rise / 2), beta / eta + cos(from_hill / 2) ** 2
    else:
        low = sin(rise / 2) ** 2
        low, high = beta / eta + low, (eta - beta) / eta - low
    # sin² and cos² of half the distance from the far turning point to the far hill.
    low, high = sqrt(larger(low, 0)), sqrt(larger(high, 0))
    distance = 2 * atan2(low, high)
    down = turn_to(basin.far_well, basin.far)
    dip = sin(from_hill + depth / 2) * sin(depth / 2)
    up = 2 * asin(within(dip / sin((down + distance) / 2)))
    if piece.high_kind == "turn":
        share = sin(from_hill + drop / 2) * sin(drop / 2) / sin((piece.far_gap + distance) / 2)
        # The clamp's own distance from the hill is exact, the range's width is not.
        rough = piece.far_gap - distance
        left = pick(rough > 0.25 * piece.far_gap, rough, 2 * asin(within(share)))
    else:
        left = up + piece.high_depth
    return (up + depth) / 2, left, 4 * eta * dip * low * high, distance


def within(sine):
    """A sine that rounding may have brought beyond 1."""
    return pick(sine < 1, sine, 1)


def far_side(eta, field_angle, piece, rise, drop, depth, done, height):
    """Half the width of the motion, how far it goes on beyond the clamp, the moment where it turns, how far that is
    from the far hill, and what a shoulder tells."""
    basin = piece.basin
    hill, well, far, far_well = basin.hill, basin.well, basin.far, basin.far_well
    down = turn_to(far_well, far)
    if piece.low_kind == "level":
        below = -tip_fall(eta, piece, -rise, rise, drop)
    else:
        below = basin.far_rise + fall(eta, hill, 0, piece.low_offset + rise)
    if basin.passes:
        # Above the ridge by its height, and the ridge above the well behind it.
        above = height + fall(eta, basin.axis, 0, turn_to(basin.axis, far_well))
    else:
        above = -fall(eta, well, 0, -depth)
    by_hill = below < above
    distance = reach_either(eta, far, far_well, by_hill, pick(by_hill, below, above), down)
    turn = pick(by_hill, down - distance, distance)  # far turning point − far_well
    left = pick(by_hill, piece.far_gap - distance, distance - piece.beyond_well)
    if basin.shoulder is not None and any_of(field_angle != 0) and any_of(field_angle != pi / 2):
        return shoulder_side(eta, piece, rise, drop, done, left, by_hill, distance)
    if piece.high_kind == "turn":
        left = larger(beyond_clamp(eta, piece, rise, drop, left), 0)
    if basin.passes:
        half_width = (turn + depth + turn_to(well, far_well)) / 2
    else:
        half_width = (turn + depth) / 2
    far_moment = pick(by_hill, slope(eta, far, -distance), slope(eta, far_well, distance)) * -1
    far_moment = larger(far_moment, least_moment(basin) * distance)
    return half_width, left, far_moment, pick(by_hill, distance, down - distance), None


def least_moment(basin):
    """What rounding leaves at least of a moment, by the distance from the direction that tells it: where a hill and a
    well all but meet, and are not among the directions that are told, it would leave nothing, or less."""
    return epsilon() ** 2 if basin.passes or not basin.whole else 4 * epsilon()


def reach_either(eta, hill, well, by_hill, amount, most):
    """``reach`` down from the hill, or up from the well, whichever is asked for."""
    rest = hill._replace(
        stiffness=pick(by_hill, hill.stiffness, well.stiffness),
        double_cosine=pick(by_hill, hill.double_cosine, well.double_cosine),
        double_sine=pick(by_hill, hill.double_sine, well.double_sine),
    )
    return reach(eta, rest, amount, most, pick(by_hill, -1, 1))


def beyond_clamp(eta, piece, rise, drop, rough):
    """How far the motion goes beyond the clamp, when the tip is ``drop`` below the one that turns there.

    V falls by the same amount on both sides. The rough value is as good as its difference to the clamp's distance
    from a hill or a well allows.
    """
    far = rough > 0.25 * abs(piece.clamp_offset)
    amount = tip_fall(eta, piece, drop, rise, drop)
    return further(eta, piece.clamp_rest, piece.clamp_offset, amount, rough, far)
