"""How long a motion takes: the half-swing and the first arrival, by the arithmetic-geometric mean."""

from __future__ import annotations

from derive.emit.kernels.arithmetic import any_of, atan2, epsilon, pi, pick, sin, sqrt


def times(motion):
    """Half-swing, and the length from the tip to the clamp.

    With tan(χ/2) at the clamp, Gauss's transformation makes end and middle equal (DLMF 19.8(i), 22.7(ii)), in sums of
    positive terms only. The half of the swing is taken in which the clamp lies.
    """
    near, far = sqrt(motion.near), sqrt(motion.far)
    done, left = far * sin(motion.done / 2), near * sin(motion.left / 2)
    # left − done, where the motion is symmetric by the sines, and else by the difference of its ends.
    ahead = 2 * near * motion.half_cosine * sin((motion.left - motion.done) / 4)
    ahead = ahead - 2 * motion.skew * motion.sine * sin(motion.done / 2) / (near + far)
    whole = (done + left) * (done + left)
    square, rest = 4 * done * left / whole, ahead * ahead / whole
    first = ahead >= 0
    a, b = motion.end, motion.middle
    limit = epsilon() ** 0.5
    while any_of(abs(a - b) > limit * a):
        delta = sqrt(a * a * rest + b * b * square)
        below = (a + delta) * (a + delta)
        square, rest = (
            (a + b) * (a + b) * square / below,
            2 * a * rest * (a + (a * a + b * b * square) / (delta + b * square)) / below,
        )
        a, b = (a + b) / 2, sqrt(a * b)
    delta = sqrt(a * a * rest + b * b * square)
    below = (a + delta) * (a + delta)
    square, rest = (
        (a + b) * (a + b) * square / below,
        2 * a * rest * (a + (a * a + b * b * square) / (delta + b * square)) / below,
    )
    mean = (a + b) / 2
    swing, part = pi / mean, atan2(sqrt(square), sqrt(rest)) / mean
    return swing, pick(first, part, swing - part)
