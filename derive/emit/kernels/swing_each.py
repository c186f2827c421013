"""The kernels of ``swing`` on arrays.

Emitted by `derive emit` from kernels/swing.py: do not edit, change that file.

Digest of the inputs: sha256 6ed6a9e83c498b495bc8e4a80750c024dad265be788adac7dc7921db468c6349
"""

from __future__ import annotations

from derive.emit.kernels.arithmetic import epsilon, pi
from derive.emit.kernels.array_arithmetic import (
    each_abs,
    each_any_of,
    each_arc_excess,
    each_atan2,
    each_hypot,
    each_pick,
    each_sin,
    each_sqrt,
    larger,
)
from derive.emit.kernels.formulas_each import (
    chi_square_each,
    gauss_gap_each,
    gauss_rest_each,
    gauss_square_each,
    half_rest_beyond_each,
    half_rest_each,
    half_square_beyond_each,
    half_square_each,
    lag_step_each,
    phase_bend_each,
    phase_lead_each,
    phase_rate_each,
    phase_sum_each,
    turn_speed_each,
)
from derive.emit.kernels.swing import Phase


def phase_of_each(motion):
    """The phase of the clamp: χ by the half-angle sines, and ψ by χ."""
    near, far, end = each_sqrt(motion.near), each_sqrt(motion.far), motion.end
    done, left = motion.done_sine, motion.left_sine
    whole = phase_sum_each(near, far, done, left)
    gap = each_sin((motion.left - motion.done) / 4)
    behind, ahead = far * done / whole, near * left / whole
    lead = phase_lead_each(near, motion.half_cosine, motion.uneven, done, gap) / whole
    # Of two sums for the same that which has the smaller terms rounds less.
    cosine = each_pick(near * each_abs(left - done) + each_abs(motion.uneven) * done < whole, lead, ahead - behind)
    # Not zero: at the tip itself the motion has no point by ℘.
    square = larger(chi_square_each(behind, ahead), epsilon() ** 19)
    size, first = each_abs(cosine), cosine >= 0
    delta = each_hypot(end * cosine, motion.middle * each_sqrt(square))
    half = each_pick(first, half_square_each(end, square, size, delta), half_square_beyond_each(end, size, delta))
    rest = each_pick(
        first, half_rest_each(end, size, delta), half_rest_beyond_each(end, motion.middle, square, size, delta)
    )
    return Phase(half, rest, whole, delta)


def speed_at_each(motion, phase):
    """|dθ/dσ| where the motion meets the clamp."""
    rate = phase.delta / motion.end
    return turn_speed_each(motion.sine, motion.done_sine, motion.left_sine, phase.whole, rate)


def lengths_each(a, b, square, rest):
    """The complete and the incomplete integral of 1/√(a² cos²ψ + b² sin²ψ), by sin²ψ and cos²ψ.

    Gauss's transformation makes a and b equal (DLMF 19.8(i), 19.8(iii)); it is written in sums of positive terms only.
    """
    limit, more = 2 * epsilon() ** 0.5, each_any_of(a > 0)
    while more:
        more = each_any_of(each_abs(a - b) > limit * a)
        delta = phase_rate_each(a, b, square, rest)
        total, below = a + b, a + delta
        square, rest = gauss_square_each(square, total, below), gauss_rest_each(a, b, square, rest, delta, below)
        a, b = total / 2, each_sqrt(a * b)
    mean = (a + b) / 2
    return pi / (2 * mean), each_atan2(each_sqrt(square), each_sqrt(rest)) / mean


def second_kind_each(a, b, square, rest, arrival):
    """∫sin²ψ over the same range as ``arrival``, the length, and by how much that exceeds sin ψ cos ψ/Δ.

    By the same transformation (DLMF 19.8.19). Both are small as the cube of a short length, without a difference.
    """
    limit, more, gap = epsilon() ** 0.5, each_any_of(a > 0), a - b
    delta, weight, weights, integral, excess = phase_rate_each(a, b, square, rest), 0.5, 0.0, 0, 0
    while more:
        more = each_any_of(each_abs(gap) > limit * a)
        total, below = a + b, a + delta
        square, rest = gauss_square_each(square, total, below), gauss_rest_each(a, b, square, rest, delta, below)
        share, first, second = gap / total, 2 * a / total, 2 * b / total
        a, b = total / 2, each_sqrt(a * b)
        delta = phase_rate_each(a, b, square, rest)
        bend = phase_bend_each(share, first, square, rest, each_sqrt(square * rest), delta)
        step = lag_step_each(bend, share, second, square, rest)
        integral = integral + weight * first * bend + weights * step
        weights, weight, excess = weights + weight, weight * share / 2, excess + step
        gap = gauss_gap_each(gap, a + b)  # a difference would lose what the weight brings out
    last = each_arc_excess((a + b) * arrival) / (a + b)
    return integral + (weights + weight) * last, excess + last
