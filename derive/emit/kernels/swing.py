"""How long a motion takes, by the arithmetic-geometric mean: the half-swing, the first arrival, and back."""

from __future__ import annotations

from typing import NamedTuple

from derive.emit.kernels.arithmetic import any_of, arc_excess, atan2, epsilon, hypot, larger, pi, pick, sin, sqrt
from derive.emit.kernels.formulas import (
    chi_square,
    gauss_gap,
    gauss_rest,
    gauss_square,
    half_rest,
    half_rest_beyond,
    half_square,
    half_square_beyond,
    lag_step,
    phase_bend,
    phase_lead,
    phase_rate,
    phase_sum,
    turn_speed,
)


class Phase(NamedTuple):
    """Where on its half-swing the motion meets the clamp.

    The length from the tip is ∫dψ/√(a² cos²ψ + b² sin²ψ) from 0 to ψ, with a and b half of ``end`` and ``middle``; the
    half-swing ends at ψ = π/2. whole, delta: what the speed there follows from.
    """

    square: float  # sin²ψ
    rest: float  # cos²ψ
    whole: float
    delta: float


def phase_of(motion):
    """The phase of the clamp: χ by the half-angle sines, and ψ by χ."""
    near, far, end = sqrt(motion.near), sqrt(motion.far), motion.end
    done, left = motion.done_sine, motion.left_sine
    whole = phase_sum(near, far, done, left)
    gap = sin((motion.left - motion.done) / 4)
    behind, ahead = far * done / whole, near * left / whole
    lead = phase_lead(near, motion.half_cosine, motion.uneven, done, gap) / whole
    # Of two sums for the same that which has the smaller terms rounds less.
    cosine = pick(near * abs(left - done) + abs(motion.uneven) * done < whole, lead, ahead - behind)
    # Not zero: at the tip itself the motion has no point by ℘.
    square = larger(chi_square(behind, ahead), epsilon() ** 19)
    size, first = abs(cosine), cosine >= 0
    delta = hypot(end * cosine, motion.middle * sqrt(square))
    half = pick(first, half_square(end, square, size, delta), half_square_beyond(end, size, delta))
    rest = pick(first, half_rest(end, size, delta), half_rest_beyond(end, motion.middle, square, size, delta))
    return Phase(half, rest, whole, delta)


def speed_at(motion, phase):
    """|dθ/dσ| where the motion meets the clamp."""
    rate = phase.delta / motion.end
    return turn_speed(motion.sine, motion.done_sine, motion.left_sine, phase.whole, rate)


def lengths(a, b, square, rest):
    """The complete and the incomplete integral of 1/√(a² cos²ψ + b² sin²ψ), by sin²ψ and cos²ψ.

    Gauss's transformation makes a and b equal (DLMF 19.8(i), 19.8(iii)); it is written in sums of positive terms only.
    """
    limit, more = 2 * epsilon() ** 0.5, any_of(a > 0)
    while more:
        more = any_of(abs(a - b) > limit * a)
        delta = phase_rate(a, b, square, rest)
        total, below = a + b, a + delta
        square, rest = gauss_square(square, total, below), gauss_rest(a, b, square, rest, delta, below)
        a, b = total / 2, sqrt(a * b)
    mean = (a + b) / 2
    return pi / (2 * mean), atan2(sqrt(square), sqrt(rest)) / mean


def second_kind(a, b, square, rest, arrival):
    """∫sin²ψ over the same range as ``arrival``, the length, and by how much that exceeds sin ψ cos ψ/Δ.

    By the same transformation (DLMF 19.8.19). Both are small as the cube of a short length, without a difference.
    """
    limit, more, gap = epsilon() ** 0.5, any_of(a > 0), a - b
    delta, weight, weights, integral, excess = phase_rate(a, b, square, rest), 0.5, 0.0, 0, 0
    while more:
        more = any_of(abs(gap) > limit * a)
        total, below = a + b, a + delta
        square, rest = gauss_square(square, total, below), gauss_rest(a, b, square, rest, delta, below)
        share, first, second = gap / total, 2 * a / total, 2 * b / total
        a, b = total / 2, sqrt(a * b)
        delta = phase_rate(a, b, square, rest)
        bend = phase_bend(share, first, square, rest, sqrt(square * rest), delta)
        step = lag_step(bend, share, second, square, rest)
        integral = integral + weight * first * bend + weights * step
        weights, weight, excess = weights + weight, weight * share / 2, excess + step
        gap = gauss_gap(gap, a + b)  # a difference would lose what the weight brings out
    last = arc_excess((a + b) * arrival) / (a + b)
    return integral + (weights + weight) * last, excess + last
