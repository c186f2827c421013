"""How long a motion takes, by the arithmetic-geometric mean: the half-swing, the first arrival, and back."""

from __future__ import annotations

from typing import NamedTuple

from derive.emit.kernels.arithmetic import any_of, atan2, epsilon, hypot, pi, pick, sin, sqrt


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
    """The phase of the clamp, from χ by the duplication of an elliptic argument (DLMF 22.6(iii))."""
    near, far = sqrt(motion.near), sqrt(motion.far)
    done, left = far * motion.done_sine, near * motion.left_sine
    # left − done, where the motion is symmetric by the sines, and else by the difference of its ends.
    ahead = 2 * near * motion.half_cosine * sin((motion.left - motion.done) / 4)
    ahead = ahead - motion.uneven * motion.done_sine
    whole = done + left
    square, cosine = 4 * (done / whole) * (left / whole), ahead / whole
    a, b = motion.end, motion.middle
    delta = hypot(a * cosine, b * sqrt(square))
    first = cosine >= 0
    versine = pick(first, square / (1 + abs(cosine)), 1 - cosine)
    along = pick(first, delta + a * cosine, b * b * square / (delta + a * abs(cosine)))
    return Phase(a * versine / (a + delta), along / (a + delta), whole, delta)


def times(motion):
    """Half-swing, and the length from the tip to the clamp."""
    phase = phase_of(motion)
    return lengths(motion.end / 2, motion.middle / 2, phase.square, phase.rest)


def lengths(a, b, square, rest):
    """The complete and the incomplete integral of 1/√(a² cos²ψ + b² sin²ψ), by sin²ψ and cos²ψ.

    Gauss's transformation makes a and b equal (DLMF 19.8(i), 19.8(iii)); it is written in sums of positive terms only.
    """
    limit, more = 2 * epsilon() ** 0.5, True
    while more:
        more = any_of(abs(a - b) > limit * a)
        delta = sqrt(a * a * rest + b * b * square)
        total, below = a + b, a + delta
        inner = a + (a * a + b * b * square) / (delta + b * square)
        scale = below * below
        square, rest = total * total * square / scale, 2 * a * rest * inner / scale
        a, b = total / 2, sqrt(a * b)
    mean = (a + b) / 2
    return pi / (2 * mean), atan2(sqrt(square), sqrt(rest)) / mean


def second_kind(a, b, square, rest, arrival):
    """(b² − a²)∫sin²ψ over the same range as ``arrival``, the length, by the same transformation (DLMF 19.8.19)."""
    limit, more, weight, total = 2 * epsilon() ** 0.5, True, 1, 0
    while more:
        more = any_of(abs(a - b) > limit * a)
        delta = sqrt(a * a * rest + b * b * square)
        total = total - weight * (a - b) * (a + b) * (arrival / 2 - sqrt(square * rest) / (a + delta))
        sum_, below = a + b, a + delta
        inner = a + (a * a + b * b * square) / (delta + b * square)
        scale = below * below
        square, rest = sum_ * sum_ * square / scale, 2 * a * rest * inner / scale
        a, b, weight = sum_ / 2, sqrt(a * b), 2 * weight
    return total


def phase_at(a, b, length):
    """sin²ψ and cos²ψ at a length from the tip within the half-swing: the transformation undone."""
    limit = 2 * epsilon() ** 0.5
    steps = [(a, b)]
    while any_of(abs(a - b) > limit * a):
        a, b = (a + b) / 2, sqrt(a * b)
        steps.append((a, b))
    a, b = (a + b) / 2, sqrt(a * b)
    mean = (a + b) / 2
    quarter = pi / (2 * mean)
    first = 2 * length <= quarter
    small = sin(mean * pick(first, length, quarter - length))
    small = small * small
    square, rest = pick(first, small, 1 - small), pick(first, 1 - small, small)
    for a, b in reversed(steps):
        gap = a - b
        below = pick(gap > 0, a + b + gap * square, 2 * a - gap * rest)
        wide = 4 * a * b + gap * gap * rest
        square, rest = 4 * a * a * square / (below * below), rest * wide / (below * below)
    return square, rest
