"""The motion from a tip: its turning points, and the numbers of its Legendre form."""

from __future__ import annotations

from typing import NamedTuple

from derive.emit.kernels.arithmetic import any_of, cos, exp, larger, pi, pick, sin, sqrt
from derive.emit.kernels.basins import Piece
from derive.emit.kernels.levels import turn_to
from derive.emit.kernels.potential import fall_from_rest, moment_from_rest
from derive.emit.kernels.rates import rates
from derive.emit.kernels.shoulders import beside_shoulder
from derive.emit.kernels.turning import far_side, least_moment, parallel_side


class Motion(NamedTuple):
    """A motion from rest at the tip through the clamp angle to rest at the far turning point, and back.

    With χ from 0 at the tip to π at the far turning point, dσ = dχ/√(end² cos²χ + middle² sin²χ).
    """

    tip: float  # the tip angle, in the turn of the landscape
    half_width: float
    done: float  # clamp − tip
    left: float  # far turning point − clamp
    near_moment: float  # θ″ at the tip
    far_moment: float  # −θ″ at the far turning point
    near: float  # 2θ″/sin(half_width) at the tip
    far: float  # the same at the far turning point
    end: float
    middle: float
    sine: float  # sin(half_width)
    half_cosine: float  # cos(half_width/2)
    uneven: float  # √far − √near
    done_sine: float  # sin(done/2)
    left_sine: float  # sin(left/2)


def motion_at(beta, eta, field_angle, piece: Piece, place):
    """The motion of the tip at a place of a piece: −∞ is its low end, +∞ its high end."""
    basin = piece.basin
    rise, drop = piece.width / (1 + exp(-place)), piece.width / (1 + exp(place))
    from_hill, depth = piece.low_offset + rise, piece.high_depth + drop
    upper = from_hill < depth
    hill, well = basin.hill, basin.well
    offset = pick(upper, from_hill, -depth)
    stiffness = pick(upper, hill.stiffness, well.stiffness)
    double_cosine = pick(upper, hill.double_cosine, well.double_cosine)
    double_sine = pick(upper, hill.double_sine, well.double_sine)
    tip = pick(upper, hill.angle, well.angle) + offset
    near_moment = moment_from_rest(eta, stiffness, double_cosine, double_sine, offset)
    # How far V falls from the tip to the well, or to the level of a ridge that the motion passes.
    change = (drop + piece.level_gap if basin.passes else depth) / 2
    height = fall_from_rest(eta, stiffness, double_cosine, double_sine, offset + change, change)
    # Near the high end the clamp is told from there, else as the tip is: the clamp's own distances are exact.
    done, apart = piece.clamp_gap + drop, pick(upper, piece.past_hill - from_hill, piece.past_well + depth)
    done = pick(done < 0.5 * pick(upper, from_hill, abs(piece.past_well)), done, apart)
    depth = pick(upper, turn_to(hill, well) - from_hill, depth)
    beside = None
    if basin.even:
        half_width = pick(upper, turn_to(hill, basin.axis) - from_hill, depth + turn_to(well, basin.axis))
        left = 2 * half_width - done if piece.high_kind != "turn" else drop
        far_moment, far_distance = near_moment, from_hill
    elif any_of(field_angle == 0) and not basin.passes:
        half_width, left, far_moment, far_distance = parallel_side(beta, eta, piece, rise, drop, from_hill, depth)
        half_width = (done + left) / 2 if piece.high_kind == "turn" else half_width
    else:
        side = far_side(eta, field_angle, piece, rise, drop, depth, done, height)
        half_width, left, far_moment, far_distance, beside = side
        if basin.shoulder is not None:
            near_moment, beside = beside_shoulder(eta, basin, from_hill, offset, near_moment, beside)
        near_moment = larger(near_moment, least_moment(basin) * abs(offset))
    # Where the motion is nearly a whole turn, what it lacks is told by the distances from the hills.
    lack = (from_hill + far_distance) / 2 if basin.whole else pi - half_width
    sine = sin(pick(lack < half_width, lack, half_width))
    near, far = 2 * near_moment / sine, 2 * far_moment / sine
    # done/2 + left/2 = half_width: near half a turn one follows from the other.
    done_sine = sin(pick(done > pi, lack + left / 2, done / 2))
    left_sine = sin(pick(left > pi, lack + done / 2, left / 2))
    half_cosine = sin(lack / 2)
    centre = halfway(hill, basin.far, basin.axis) + (from_hill - far_distance) / 2
    uneven = 0 if basin.even else unevenness(eta, basin.axis, centre, sine, near, far)
    end, middle = rates(beta, eta, field_angle, basin, centre, half_width, sine, near, far, height, beside)
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


def halfway(hill, far, axis):
    """The angle from an axis to the middle of two hills, in which whole turns between them are no rounding."""
    quarters = hill.quarters + far.quarters - 2 * axis.quarters
    return quarters * (pi / 4) + ((hill.extra - axis.extra) + (far.extra - axis.extra)) / 2


def unevenness(eta, axis, centre, sine, near, far):
    """√far − √near: by the roots where they are apart, else by far − near = 2η sin 2(middle − α) sin(half_width).

    centre: from the axis to the middle.
    """
    double = axis.double_sine * cos(2 * centre) + axis.double_cosine * sin(2 * centre)
    by_turns = 2 * eta * double * sine / (sqrt(near) + sqrt(far))
    apart = (8 * near < far) | (8 * far < near) | (near + far < 2 * eta * sine)
    return pick(apart, sqrt(far) - sqrt(near), by_turns)
