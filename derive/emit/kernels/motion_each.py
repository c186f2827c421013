"""The kernels of ``motion`` on arrays.

Emitted by `derive emit` from kernels/motion.py: do not edit, change that file.

Digest of the inputs: sha256 42a76c51d57bed0b40d9fd712c53a9bb941900208dc9c6b0b70239954792cd35
"""

from __future__ import annotations

from derive.emit.kernels.arithmetic import epsilon, pi
from derive.emit.kernels.array_arithmetic import (
    each_abs,
    each_any_of,
    each_asin,
    each_atan2,
    each_cos,
    each_exp,
    each_floor,
    each_pick,
    each_sin,
    each_spacing,
    each_sqrt,
    larger,
)
from derive.emit.kernels.levels_each import fall_each, further_each, reach_each, slope_each, tip_fall_each, turn_to_each
from derive.emit.kernels.motion import Motion
from derive.emit.kernels.pieces import Piece
from derive.emit.kernels.potential_each import fall_from_rest_each, moment_from_rest_each
from derive.emit.kernels.shoulders import beside_shoulder, shoulder_side


def motion_at_each(beta, eta, field_angle, piece: Piece, place):
    """The motion of the tip at a place of a piece: −∞ is its low end, +∞ its high end."""
    basin = piece.basin
    rise, drop = piece.width / (1 + each_exp(-place)), piece.width / (1 + each_exp(place))
    from_hill, depth = piece.low_offset + rise, piece.high_depth + drop
    upper = from_hill < depth
    hill, well = basin.hill, basin.well
    offset = each_pick(upper, from_hill, -depth)
    stiffness = each_pick(upper, hill.stiffness, well.stiffness)
    double_cosine = each_pick(upper, hill.double_cosine, well.double_cosine)
    double_sine = each_pick(upper, hill.double_sine, well.double_sine)
    tip = each_pick(upper, hill.angle, well.angle) + offset
    near_moment = moment_from_rest_each(eta, stiffness, double_cosine, double_sine, offset)
    # How far V falls from the tip to the well, or to the level of a ridge that the motion passes.
    change = (drop + piece.level_gap if basin.passes else depth) / 2
    height = fall_from_rest_each(eta, stiffness, double_cosine, double_sine, offset + change, change)
    # Near the high end the clamp is told from there, else as the tip is: the clamp's own distances are exact.
    done, apart = piece.clamp_gap + drop, each_pick(upper, piece.past_hill - from_hill, piece.past_well + depth)
    done = each_pick(done < 0.5 * each_pick(upper, from_hill, each_abs(piece.past_well)), done, apart)
    depth = each_pick(upper, turn_to_each(hill, well) - from_hill, depth)
    there = None
    if basin.even:
        half_width = each_pick(
            upper, turn_to_each(hill, basin.axis) - from_hill, depth + turn_to_each(well, basin.axis)
        )
        left = 2 * half_width - done if piece.high_kind != "turn" else drop
        far_moment, far_distance = near_moment, from_hill
    elif each_any_of(field_angle == 0) and (not basin.passes):
        half_width, left, far_moment, far_distance = parallel_side_each(beta, eta, piece, rise, drop, from_hill, depth)
        half_width = (done + left) / 2 if piece.high_kind == "turn" else half_width
    else:
        side = far_side_each(eta, field_angle, piece, rise, drop, depth, done, height)
        half_width, left, far_moment, far_distance, there = side
        if basin.shoulder is not None:
            near_moment = beside_shoulder(eta, basin, from_hill, offset, near_moment)
        near_moment = larger(near_moment, least_moment_each(basin) * each_abs(offset))
    # Where the motion is nearly a whole turn, what it lacks is told by the distances from the hills.
    lack = (from_hill + far_distance) / 2 if basin.whole else pi - half_width
    sine = each_sin(each_pick(lack < half_width, lack, half_width))
    near, far = 2 * near_moment / sine, 2 * far_moment / sine
    uneven = 0 if basin.even else unevenness_each(eta, field_angle, tip + half_width, sine, near, far)
    # done/2 + left/2 = half_width: near half a turn one follows from the other.
    done_sine = each_sin(each_pick(done > pi, lack + left / 2, done / 2))
    left_sine = each_sin(each_pick(left > pi, lack + done / 2, left / 2))
    half_cosine = each_sin(lack / 2)
    centre = half_width - depth - turn_to_each(well, basin.axis)
    end, middle = rates_each(beta, eta, field_angle, basin, centre, half_width, sine, near, far, height, there)
    return Motion(
        tip,
        half_width,
        done,
        left,
        near_moment,
        far_moment,
        near,
        far,
        end,
        middle,
        sine,
        half_cosine,
        uneven,
        done_sine,
        left_sine,
    )


def unevenness_each(eta, field_angle, middle, sine, near, far):
    """√far − √near: by the roots where they are apart, else by far − near = 2η sin 2(middle − α) sin(half_width)."""
    by_turns = 2 * eta * each_sin(2 * (middle - field_angle)) * sine / (each_sqrt(near) + each_sqrt(far))
    apart = (8 * near < far) | (8 * far < near) | (near + far < 2 * eta * sine)
    return each_pick(apart, each_sqrt(far) - each_sqrt(near), by_turns)


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


def rates_each(beta, eta, field_angle, basin, centre, half_width, sine, near, far, height, there):
    """dχ/dσ at the ends and in the middle of the motion. centre: from the slowest direction to the middle; there: the
    far turning point, if it is beside a shoulder."""
    middle, cosine = basin.axis.angle + centre, each_cos(half_width)
    cos_middle, cos_double = each_cos(middle), each_cos(2 * (middle - field_angle))
    product = each_sqrt(near) * each_sqrt(far)
    excess = -(2 * beta * cos_middle * cosine + eta * cos_double * (1 + cosine * cosine))
    if there is not None:
        # The same: V at the ends of the motion is equal.
        bent = eta * (1 + 2 * cosine * cosine) * each_sin(2 * there.lean) * sine
        excess = far * sine * sine * cosine - 2 * there.stiffness * cosine * cosine - bent
    split, rate = excess < 0, each_sqrt(product + larger(excess, 0))
    if each_any_of(split):
        mean = -(2 * beta * cos_middle + eta * cosine * cos_double)
        apart = mean_less_field_each(eta, basin, centre, half_width, near, far, height, there, mean)
        rate = each_pick(split, sine * each_sqrt(apart * (mean + eta) / each_pick(split, product - excess, 1)), rate)
    return each_sqrt(product / 2), rate / 2


def mean_less_field_each(eta, basin, centre, half_width, near, far, height, there, mean):
    """``mean`` − η: as it stands, or by the end of the motion or the ridge or well that is near where V is nearest to
    level."""
    apart = mean - eta
    close = apart <= 0.1 * eta
    if there is not None:
        return larger(
            each_pick(close, far - 2 * eta * each_sin(there.lean) * each_sin(there.lean), apart), epsilon() * far / 4
        )
    if each_any_of(close):
        # 2(axis − α), and 2(middle − α).
        axis = each_atan2(basin.axis.double_sine, basin.axis.double_cosine)
        double = wrapped_each(axis + 2 * centre)
        ahead, behind = each_sin((half_width + double) / 2), each_sin((half_width - double) / 2)
        by_far, by_near = far - 2 * eta * ahead * ahead, near - 2 * eta * behind * behind
        known = each_pick(2 * by_far > far, by_far, by_near)
        far_off = close & (2 * by_far <= far) & (2 * by_near <= near)
        if each_any_of(far_off):
            # Not from a well that is far from where V is nearly level: there V tells least.
            told, turn = each_pick(near < far, by_near, by_far), ahead * behind
            above = above_field_each(eta, basin, wrapped_each(-axis - centre), turn, height)
            known = each_pick(
                far_off,
                each_pick(height <= each_abs(turn) * eta * (each_abs(ahead) + each_abs(behind)), above, told),
                known,
            )
        apart = each_pick(close, known, apart)
    # Over a ridge V(tip) − V is nowhere less than there; elsewhere only rounding makes it smaller than this.
    least = larger(height, epsilon() ** 19) if basin.passes else epsilon() * each_pick(near < far, near, far) / 4
    return larger(apart, least)


def above_field_each(eta, basin, offset, turn, height):
    """``mean`` less η where they are near each other: 2(V(tip) − V)/(cos(θ − middle) − cos(half_width)) at the θ at
    which it is least, which lies then near the ridge or the well, at an offset from it.

    turn: half of what it is divided by. height: V(tip) less that of the ridge or the well.
    """
    # As near the ridge as rounding it is nearer still: it is there to the second order in the height.
    offset = each_pick(each_abs(offset) < 32 * each_spacing(offset), 0, offset)
    return (height + fall_each(eta, basin.axis, 0, offset)) / each_pick(turn == 0, 1, turn)


def wrapped_each(angle):
    """The angle less whole turns, between −π and π."""
    return angle - 2 * pi * each_floor(angle / (2 * pi) + 0.5)
