"""The kernels of ``motion`` on arrays.

Emitted by `derive emit` from kernels/motion.py: do not edit, change that file.

Digest of the inputs: sha256 57ebc4b01e601a3df173bcc1a44486ca2772fc5cb2563c8b66ed3d2fc892a237
"""

from __future__ import annotations

from derive.emit.kernels.arithmetic import pi
from derive.emit.kernels.array_arithmetic import (
    each_abs,
    each_any_of,
    each_cos,
    each_exp,
    each_pick,
    each_sin,
    each_sqrt,
    larger,
)
from derive.emit.kernels.basins import Piece
from derive.emit.kernels.levels_each import turn_to_each
from derive.emit.kernels.motion import Motion
from derive.emit.kernels.potential_each import fall_from_rest_each, moment_from_rest_each
from derive.emit.kernels.rates_each import rates_each
from derive.emit.kernels.shoulders import beside_shoulder
from derive.emit.kernels.turning_each import far_side_each, least_moment_each, parallel_side_each


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
    beside = None
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
        half_width, left, far_moment, far_distance, beside = side
        if basin.shoulder is not None:
            near_moment, beside = beside_shoulder(eta, basin, from_hill, offset, near_moment, beside)
        near_moment = larger(near_moment, least_moment_each(basin) * each_abs(offset))
    # Where the motion is nearly a whole turn, what it lacks is told by the distances from the hills.
    lack = (from_hill + far_distance) / 2 if basin.whole else pi - half_width
    sine = each_sin(each_pick(lack < half_width, lack, half_width))
    near, far = 2 * near_moment / sine, 2 * far_moment / sine
    # done/2 + left/2 = half_width: near half a turn one follows from the other.
    done_sine = each_sin(each_pick(done > pi, lack + left / 2, done / 2))
    left_sine = each_sin(each_pick(left > pi, lack + done / 2, left / 2))
    half_cosine = each_sin(lack / 2)
    centre = halfway_each(hill, basin.far, basin.axis) + (from_hill - far_distance) / 2
    uneven = 0 if basin.even else unevenness_each(eta, basin.axis, centre, sine, near, far)
    end, middle = rates_each(beta, eta, field_angle, basin, centre, half_width, sine, near, far, height, beside)
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


def halfway_each(hill, far, axis):
    """The angle from an axis to the middle of two hills, in which whole turns between them are no rounding."""
    quarters = hill.quarters + far.quarters - 2 * axis.quarters
    return quarters * (pi / 4) + ((hill.extra - axis.extra) + (far.extra - axis.extra)) / 2


def unevenness_each(eta, axis, centre, sine, near, far):
    """√far − √near: by the roots where they are apart, else by far − near = 2η sin 2(middle − α) sin(half_width).

    centre: from the axis to the middle.
    """
    double = axis.double_sine * each_cos(2 * centre) + axis.double_cosine * each_sin(2 * centre)
    by_turns = 2 * eta * double * sine / (each_sqrt(near) + each_sqrt(far))
    apart = (8 * near < far) | (8 * far < near) | (near + far < 2 * eta * sine)
    return each_pick(apart, each_sqrt(far) - each_sqrt(near), by_turns)
