"""The kernels of ``rates`` on arrays.

Emitted by `derive emit` from kernels/rates.py: do not edit, change that file.

Digest of the inputs: sha256 b49f861d8ab87339a4455c73ba30b495562f4c63951af2e6f829d8ac1d4fd59d
"""

from __future__ import annotations

from derive.emit.kernels.arithmetic import epsilon, pi
from derive.emit.kernels.array_arithmetic import (
    each_abs,
    each_any_of,
    each_atan2,
    each_cos,
    each_floor,
    each_pick,
    each_sin,
    each_spacing,
    each_sqrt,
    larger,
)
from derive.emit.kernels.formulas_each import end_above_each, end_excess_each, end_twist_each
from derive.emit.kernels.levels_each import fall_each


def rates_each(beta, eta, field_angle, basin, centre, half_width, sine, near, far, height, beside):
    """dχ/dσ at the ends and in the middle of the motion. centre: from the slowest direction to the middle; beside:
    the end that is beside a shoulder, if one is."""
    middle, cosine = basin.axis.angle + centre, each_cos(half_width)
    cos_middle, cos_double = each_cos(middle), each_cos(2 * (middle - field_angle))
    product = each_sqrt(near) * each_sqrt(far)
    excess = -(2 * beta * cos_middle * cosine + eta * cos_double * (1 + cosine * cosine))
    if beside is not None and each_any_of(field_angle != 0) and each_any_of(field_angle != pi / 2):
        # The same, for V at both ends is equal.
        excess = end_excess_each(far if beside.is_far else near, beside.stiffness, cosine)
    split, rate = excess < 0, each_sqrt(product + larger(excess, 0))
    if each_any_of(split):
        mean = -(2 * beta * cos_middle + eta * cosine * cos_double)
        apart = mean_less_field_each(eta, field_angle, basin, centre, half_width, near, far, height, beside, mean)
        rate = each_pick(split, sine * each_sqrt(apart * (mean + eta) / each_pick(split, product - excess, 1)), rate)
    return each_sqrt(product / 2), rate / 2


def mean_less_field_each(eta, field_angle, basin, centre, half_width, near, far, height, beside, mean):
    """``mean`` − η: as it stands, or by the end of the motion or the ridge or well that is near where V is nearest to
    level."""
    apart = mean - eta
    close = apart <= 0.3 * eta
    if beside is not None and each_any_of(field_angle != 0) and each_any_of(field_angle != pi / 2):
        rate = far if beside.is_far else near
        twist = end_twist_each(eta, rate, beside.stiffness, each_sin(half_width), each_cos(half_width))
        # The cosine is positive, for a₀ − η is, and that is P′ less η(1 − cosine).
        if rate < eta and each_abs(twist) < 0.7:
            above = end_above_each(eta, rate, twist, each_sqrt((1 - twist) * (1 + twist)))
            return larger(each_pick(close, above, apart), epsilon() * rate / 4)
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
