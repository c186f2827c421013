"""The kernels of ``turning`` on arrays.

Emitted by `derive emit` from kernels/turning.py: do not edit, change that file.

Digest of the inputs: sha256 a6ba3449fd394d4b0471985b236cbb97abb6a74c08e67ba204aa5265b7d8f92b
"""

from __future__ import annotations

from derive.emit.kernels.arithmetic import epsilon, pi
from derive.emit.kernels.array_arithmetic import (
    each_abs,
    each_any_of,
    each_asin,
    each_atan2,
    each_cos,
    each_pick,
    each_sin,
    each_sqrt,
    larger,
)
from derive.emit.kernels.levels_each import fall_each, further_each, reach_each, slope_each, tip_fall_each, turn_to_each
from derive.emit.kernels.shoulders import shoulder_side


def parallel_side_each(beta, eta, piece, rise, drop, from_hill, depth):
    """``far_side`` within a well for a field along the force: the cosines of the turning points add up to −2β/η."""
    basin = piece.basin
    if piece.low_kind == "level":
        low, high = (
            each_sin(rise / 2) * each_sin(piece.low_offset + rise / 2),
            beta / eta + each_cos(from_hill / 2) ** 2,
        )
    else:
        low = each_sin(rise / 2) ** 2
        low, high = beta / eta + low, (eta - beta) / eta - low
    # sin² and cos² of half the distance from the far turning point to the far hill.
    low, high = each_sqrt(larger(low, 0)), each_sqrt(larger(high, 0))
    distance = 2 * each_atan2(low, high)
    down = turn_to_each(basin.far_well, basin.far)
    dip = each_sin(from_hill + depth / 2) * each_sin(depth / 2)
    up = 2 * each_asin(within_each(dip / each_sin((down + distance) / 2)))
    if piece.high_kind == "turn":
        share = each_sin(from_hill + drop / 2) * each_sin(drop / 2) / each_sin((piece.far_gap + distance) / 2)
        # The clamp's own distance from the hill is exact, the range's width is not.
        rough = piece.far_gap - distance
        left = each_pick(rough > 0.25 * piece.far_gap, rough, 2 * each_asin(within_each(share)))
    else:
        left = up + piece.high_depth
    return (up + depth) / 2, left, 4 * eta * dip * low * high, distance


def within_each(sine):
    """A sine that rounding may have brought beyond 1."""
    return each_pick(sine < 1, sine, 1)


def far_side_each(eta, field_angle, piece, rise, drop, depth, done, height):
    """Half the width of the motion, how far it goes on beyond the clamp, the moment where it turns, how far that is
    from the far hill, and what a shoulder tells."""
    basin = piece.basin
    hill, well, far, far_well = basin.hill, basin.well, basin.far, basin.far_well
    down = turn_to_each(far_well, far)
    if piece.low_kind == "level":
        below = -tip_fall_each(eta, piece, -rise, rise, drop)
    else:
        below = basin.far_rise + fall_each(eta, hill, 0, piece.low_offset + rise)
    if basin.passes:
        # Above the ridge by its height, and the ridge above the well behind it.
        above = height + fall_each(eta, basin.axis, 0, turn_to_each(basin.axis, far_well))
    else:
        above = -fall_each(eta, well, 0, -depth)
    by_hill = below < above
    distance = reach_either_each(eta, far, far_well, by_hill, each_pick(by_hill, below, above), down)
    turn = each_pick(by_hill, down - distance, distance)  # far turning point − far_well
    left = each_pick(by_hill, piece.far_gap - distance, distance - piece.beyond_well)
    if basin.shoulder is not None and each_any_of(field_angle != 0) and each_any_of(field_angle != pi / 2):
        return shoulder_side(eta, piece, rise, drop, done, left, by_hill, distance)
    if piece.high_kind == "turn":
        left = larger(beyond_clamp_each(eta, piece, rise, drop, left), 0)
    if basin.passes:
        half_width = (turn + depth + turn_to_each(well, far_well)) / 2
    else:
        half_width = (turn + depth) / 2
    far_moment = each_pick(by_hill, slope_each(eta, far, -distance), slope_each(eta, far_well, distance)) * -1
    far_moment = larger(far_moment, least_moment_each(basin) * distance)
    return half_width, left, far_moment, each_pick(by_hill, distance, down - distance), None


def least_moment_each(basin):
    """What rounding leaves at least of a moment, by the distance from the direction that tells it: where a hill and a
    well all but meet, and are not among the directions that are told, it would leave nothing, or less."""
    return epsilon() ** 2 if basin.passes or not basin.whole else 4 * epsilon()


def reach_either_each(eta, hill, well, by_hill, amount, most):
    """``reach`` down from the hill, or up from the well, whichever is asked for."""
    rest = hill._replace(
        stiffness=each_pick(by_hill, hill.stiffness, well.stiffness),
        double_cosine=each_pick(by_hill, hill.double_cosine, well.double_cosine),
        double_sine=each_pick(by_hill, hill.double_sine, well.double_sine),
    )
    return reach_each(eta, rest, amount, most, each_pick(by_hill, -1, 1))


def beyond_clamp_each(eta, piece, rise, drop, rough):
    """How far the motion goes beyond the clamp, when the tip is ``drop`` below the one that turns there.

    V falls by the same amount on both sides. The rough value is as good as its difference to the clamp's distance
    from a hill or a well allows.
    """
    far = rough > 0.25 * each_abs(piece.clamp_offset)
    amount = tip_fall_each(eta, piece, drop, rise, drop)
    return further_each(eta, piece.clamp_rest, piece.clamp_offset, amount, rough, far)
