"""The kernels of ``swing`` on arrays.

Emitted by `derive emit` from kernels/swing.py: do not edit, change that file.

Digest of the inputs: sha256 06bdcf1df44235b9060604ae1a8efce07259ad8a348678b785efb34069454348
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
    back_below_each,
    back_below_rest_each,
    back_move_each,
    back_rest_each,
    back_square_each,
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
    return phase.delta * phase.whole / (motion.end * motion.sine) * each_sqrt(2 * motion.done_sine * motion.left_sine)


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


def phase_at_each(a, b, length, left):
    """sin²ψ and cos²ψ at lengths from the tip and from the half-swing's end: the transformation undone."""
    limit, gap = 2 * epsilon() ** 0.5, a - b
    steps = [(a, b, gap)]
    while each_any_of(each_abs(gap) > limit * a):
        a, b = (a + b) / 2, each_sqrt(a * b)
        gap = gauss_gap_each(gap, a + b)
        steps.append((a, b, gap))
    a, b = (a + b) / 2, each_sqrt(a * b)
    first = length <= left
    small = each_sin((a + b) / 2 * each_pick(first, length, left))
    small = small * small
    square, rest = each_pick(first, small, 1 - small), each_pick(first, 1 - small, small)
    for a, b, gap in reversed(steps):
        below = each_pick(gap > 0, back_below_each(a, b, square), back_below_rest_each(a, b, rest))
        # A small change rounds less than a product; a large one could cancel.
        move = back_move_each(a, gap, square, rest, below)
        little = each_abs(move) < 0.25 * each_pick(square < rest, square, rest)
        far, far_rest = back_square_each(a, square, below), back_rest_each(a, b, gap, rest, below)
        square, rest = each_pick(little, square + move, far), each_pick(little, rest - move, far_rest)
        # The larger one is told best by the smaller one, and its rounding would double in each step.
        square, rest = each_pick(rest < square, 1 - rest, square), each_pick(rest < square, rest, 1 - square)
    return square, rest
