"""How fast the phase of a motion runs at its ends and in its middle."""

from __future__ import annotations

from derive.emit.kernels.arithmetic import any_of, atan2, cos, epsilon, floor, larger, pi, pick, sin, spacing, sqrt
from derive.emit.kernels.formulas import end_above, end_excess, end_twist
from derive.emit.kernels.levels import fall


def rates(beta, eta, field_angle, basin, centre, half_width, sine, near, far, height, beside):
    """dχ/dσ at the ends and in the middle of the motion. centre: from the slowest direction to the middle; beside:
    the end that is beside a shoulder, if one is."""
    middle, cosine = basin.axis.angle + centre, cos(half_width)
    cos_middle, cos_double = cos(middle), cos(2 * (middle - field_angle))
    product = sqrt(near) * sqrt(far)
    excess = -(2 * beta * cos_middle * cosine + eta * cos_double * (1 + cosine * cosine))
    if beside is not None and any_of(field_angle != 0) and any_of(field_angle != pi / 2):
        # The same, for V at both ends is equal.
        excess = end_excess(far if beside.is_far else near, beside.stiffness, cosine)
    split, rate = excess < 0, sqrt(product + larger(excess, 0))
    if any_of(split):
        mean = -(2 * beta * cos_middle + eta * cosine * cos_double)
        apart = mean_less_field(eta, field_angle, basin, centre, half_width, near, far, height, beside, mean)
        rate = pick(split, sine * sqrt(apart * (mean + eta) / pick(split, product - excess, 1)), rate)
    return sqrt(product / 2), rate / 2


def mean_less_field(eta, field_angle, basin, centre, half_width, near, far, height, beside, mean):
    """``mean`` − η: as it stands, or by the end of the motion or the ridge or well that is near where V is nearest to
    level."""
    apart = mean - eta
    close = apart <= 0.3 * eta
    if beside is not None and any_of(field_angle != 0) and any_of(field_angle != pi / 2):
        rate = far if beside.is_far else near
        twist = end_twist(eta, rate, beside.stiffness, sin(half_width), cos(half_width))
        # The cosine is positive, for a₀ − η is, and that is P′ less η(1 − cosine).
        if rate < eta and abs(twist) < 0.7:
            above = end_above(eta, rate, twist, sqrt((1 - twist) * (1 + twist)))
            return larger(pick(close, above, apart), epsilon() * rate / 4)
    if any_of(close):
        # 2(axis − α), and 2(middle − α).
        axis = atan2(basin.axis.double_sine, basin.axis.double_cosine)
        double = wrapped(axis + 2 * centre)
        ahead, behind = sin((half_width + double) / 2), sin((half_width - double) / 2)
        by_far, by_near = far - 2 * eta * ahead * ahead, near - 2 * eta * behind * behind
        known = pick(2 * by_far > far, by_far, by_near)
        far_off = close & (2 * by_far <= far) & (2 * by_near <= near)
        if any_of(far_off):
            # Not from a well that is far from where V is nearly level: there V tells least.
            told, turn = pick(near < far, by_near, by_far), ahead * behind
            above = above_field(eta, basin, wrapped(-axis - centre), turn, height)
            known = pick(far_off, pick(height <= abs(turn) * eta * (abs(ahead) + abs(behind)), above, told), known)
        apart = pick(close, known, apart)
    # Over a ridge V(tip) − V is nowhere less than there; elsewhere only rounding makes it smaller than this.
    least = larger(height, epsilon() ** 19) if basin.passes else epsilon() * pick(near < far, near, far) / 4
    return larger(apart, least)


def above_field(eta, basin, offset, turn, height):
    """``mean`` less η where they are near each other: 2(V(tip) − V)/(cos(θ − middle) − cos(half_width)) at the θ at
    which it is least, which lies then near the ridge or the well, at an offset from it.

    turn: half of what it is divided by. height: V(tip) less that of the ridge or the well.
    """
    # As near the ridge as rounding it is nearer still: it is there to the second order in the height.
    offset = pick(abs(offset) < 32 * spacing(offset), 0, offset)
    return (height + fall(eta, basin.axis, 0, offset)) / pick(turn == 0, 1, turn)


def wrapped(angle):
    """The angle less whole turns, between −π and π."""
    return angle - 2 * pi * floor(angle / (2 * pi) + 0.5)
