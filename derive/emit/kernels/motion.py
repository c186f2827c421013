"""The motion from a tip: its turning points, and the numbers of its Legendre form."""

from __future__ import annotations

from typing import NamedTuple

from derive.emit.kernels.arithmetic import cos, exp, floor, larger, pi, pick, sin, sqrt
from derive.emit.kernels.pieces import Piece, fall, onward, reach, slope


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
    skew: float  # far − near over 2 sin(half_width)


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
    rest = hill._replace(stiffness=stiffness, double_cosine=double_cosine, double_sine=double_sine)
    tip = pick(upper, hill.angle, well.angle) + offset
    near_moment = slope(eta, rest, offset)
    done = piece.clamp_gap + drop
    if basin.even:
        half_width = depth + (basin.axis.angle - well.angle)
        left = 2 * half_width - done if piece.high_kind != "turn" else drop
        far_moment, far_distance = near_moment, from_hill
    else:
        half_width, left, far_moment, far_distance = far_side(eta, piece, rise, drop, depth, done)
    # Where the motion is nearly a whole turn, what it lacks is told by the distances from the hills.
    whole_turn = basin.far.quarters - hill.quarters == 4 and basin.far.extra == hill.extra
    lack = (from_hill + far_distance) / 2 if whole_turn else pi - half_width
    sine = sin(pick(lack < half_width, lack, half_width))
    near, far = 2 * near_moment / sine, 2 * far_moment / sine
    skew = 0 if basin.even else eta * sin(2 * (tip + half_width - field_angle))
    end, middle = rates(beta, eta, field_angle, piece, tip, half_width, sine, near, far, drop, depth)
    half_cosine = sin(lack / 2)
    return Motion(tip, half_width, done, left, near_moment, far_moment, near, far, end, middle, sine, half_cosine, skew)


def far_side(eta, piece, rise, drop, depth, done):
    """Half the width of the motion, how far it goes on beyond the clamp, and the moment where it turns."""
    basin = piece.basin
    hill, well, far, far_well = basin.hill, basin.well, basin.far, basin.far_well
    down = far.angle - far_well.angle
    if piece.low_kind == "level":
        below = fall(eta, hill, piece.low_offset, rise)
    else:
        below = basin.far_rise + fall(eta, hill, 0, rise)
    if basin.passes:
        above = -fall(eta, far_well, 0, down) - below
    else:
        above = -fall(eta, well, 0, -depth)
    by_hill = below < above
    distance = reach_either(eta, far, far_well, by_hill, pick(by_hill, below, above), down)
    turn = pick(by_hill, down - distance, distance)  # far turning point − far_well
    clamp_turn = down - piece.far_gap  # clamp − far_well
    left = pick(by_hill, piece.far_gap - distance, distance - clamp_turn)
    if basin.passes:
        half_width = (turn + depth + (far_well.angle - well.angle)) / 2
    else:
        half_width = (turn + depth) / 2
    far_moment = pick(by_hill, slope(eta, far, -distance), slope(eta, far_well, distance)) * -1
    if piece.high_kind == "turn":
        left = beyond_clamp(eta, piece, drop, left)
    return half_width, left, far_moment, pick(by_hill, distance, down - distance)


def reach_either(eta, hill, well, by_hill, amount, most):
    """``reach`` down from the hill, or up from the well, whichever is asked for."""
    rest = hill._replace(
        stiffness=pick(by_hill, hill.stiffness, well.stiffness),
        double_cosine=pick(by_hill, hill.double_cosine, well.double_cosine),
        double_sine=pick(by_hill, hill.double_sine, well.double_sine),
    )
    return reach(eta, rest, amount, most, pick(by_hill, -1, 1))


def beyond_clamp(eta, piece, drop, rough):
    """How far the motion goes beyond the clamp, when the tip is ``drop`` below the one that turns there.

    V falls by the same amount on both sides. The rough value is as good as its difference to the clamp's distance
    from a hill or a well allows.
    """
    basin, rest, start = piece.basin, piece.clamp_rest, piece.clamp_offset
    high = -piece.high_depth
    amount = fall(eta, basin.well, high - drop, drop)
    return pick(rough > 0.25 * abs(start), rough, onward(eta, rest, start, -amount, rough))


def rates(beta, eta, field_angle, piece, tip, half_width, sine, near, far, drop, depth):
    """dχ/dσ at the ends and in the middle of the motion."""
    middle, cosine = tip + half_width, cos(half_width)
    double = 2 * (middle - field_angle)
    product = sqrt(near) * sqrt(far)
    excess = -(2 * beta * cos(middle) * cosine + eta * cos(double) * (1 + cosine * cosine))
    mean = -(2 * beta * cos(middle) + eta * cosine * cos(double))
    apart = mean - eta
    close = above_field(eta, piece, middle, half_width, field_angle, drop, depth)
    apart = pick(apart > 0.1 * eta, apart, close)
    together = product + excess
    split = sine * sine * apart * (mean + eta) / pick(excess < 0, product - excess, 1)
    square = pick(excess < 0, split, together) / 4
    return sqrt(product / 2), sqrt(larger(square, 0))


def above_field(eta, piece, middle, half_width, field_angle, drop, depth):
    """``mean`` less η where they are near each other: 2(V(tip) − V)/(cos(θ − middle) − cos(half_width)) at the θ at
    which it is least, which lies then near the ridge or the well."""
    basin = piece.basin
    well, axis = basin.well, basin.axis
    if basin.passes:
        high = -piece.high_depth
        height = fall(eta, well, high - drop, drop + piece.level_gap)
    else:
        height = fall(eta, well, -depth, depth)
    shift = wrapped(2 * (field_angle - middle))
    offset = wrapped(middle + shift - axis.angle)
    outer, inner = sin(half_width / 2), sin(shift / 2)
    return (height + fall(eta, axis, 0, offset)) / pick(
        outer * outer == inner * inner, 1, outer * outer - inner * inner
    )


def wrapped(angle):
    """The angle less whole turns, between −π and π."""
    return angle - 2 * pi * floor(angle / (2 * pi) + 0.5)
