"""The shape of a rod along its length."""

from __future__ import annotations

from derive.emit.kernels.arcs import Arc, Point, arc_to
from derive.emit.kernels.arithmetic import atan2, cos, floor, ldexp, pi, sin, sqrt
from derive.emit.kernels.swing import phase_at


def angle_and_position(equilibrium, s):
    """θ, θ′, y and z at an arc length s from the clamp."""
    rod, swing = equilibrium.rod, equilibrium.swing
    if swing is None:
        share = s / ldexp(rod.length, -rod.scale)
        return equilibrium.tip_angle + 0 * s, 0 * s, equilibrium.y * share, equilibrium.z * share
    sigma = rod.length - ldexp(s, rod.scale)
    count = floor(sigma / swing.length)
    within = sigma - count * swing.length
    back = count % 2 == 1
    angle, speed, arc = within_swing(rod, swing, swing.length - within if back else within)
    times = count + 1 if back else count
    sign = -1 if back else 1
    y = equilibrium.y - ldexp(times * swing.arc.y + sign * arc.y, -rod.scale)
    z = equilibrium.z - rod.side * ldexp(times * swing.arc.z + sign * arc.z, -rod.scale)
    return rod.side * (angle + 2 * pi * swing.turns), -rod.side * sign * ldexp(speed, rod.scale), y, z


def within_swing(rod, swing, length):
    """θ, dθ/dσ and the arc at a length from the tip within the first half-swing.

    Where the motion stays near its tip, its middle or its far turning point, the rod is straight.
    """
    stay, motion = swing.stay, swing.stay.motion
    regular = swing.length - stay.tip - stay.middle - stay.far
    tip = min(length, stay.tip)
    rest = length - tip
    before = min(rest, regular / 2) if stay.middle > 0 else min(rest, regular)
    middle = min(rest - before, stay.middle)
    here = min(before + max(rest - before - middle, 0), regular)
    far = max(rest - middle - here, 0)
    angle, speed, arc = regular_part(rod, motion, here)
    for straight, extent in ((motion.tip, tip), (swing.middle_angle, middle), (swing.far_angle, far)):
        if extent > 0:
            arc = Arc(arc.y + extent * cos(straight), arc.z + extent * sin(straight), arc.square)
    return angle, speed, arc


def regular_part(rod, motion, length):
    """θ, dθ/dσ and the arc by the motion alone."""
    if length <= 0:
        return motion.tip, 0 * length, Arc(0, 0, 0)
    square, rest = phase_at(motion.end / 2, motion.middle / 2, length)
    point, half = point_at(motion, square, rest)
    arc = arc_to(rod.beta, rod.eta, rod.field_angle, motion, point, square, rest, length)
    # dx/dσ = −2√X₁X₂X₃ and x = b cot(δ/2).
    low = sin(half)
    speed = 4 * sqrt(point.one) * point.product * low * low / point.strength
    return motion.tip + 2 * half, speed, arc


def point_at(motion, square, rest):
    """The point at ψ by sin²ψ and cos²ψ, and half the angle from the tip to it.

    By cos χ, from the duplication of the argument (DLMF 22.6(iii)), in forms that lose nothing where the motion is
    nearly a whole turn.
    """
    a, b = motion.end / 2, motion.middle / 2
    near, far = sqrt(motion.near), sqrt(motion.far)
    strength = motion.near_moment / 4
    delta = sqrt(a * a * rest + b * b * square)
    one = a * a * a * a * rest / (square * delta * delta)
    flat = (b / a) * (b / a) * square
    scale = rest * (1 + square) + flat * square
    turned = (rest * rest - flat * square) / scale
    versine = 2 * square * (rest + flat) / scale
    bent = (rest * rest + flat * (1 + rest)) / scale
    tilt = motion.uneven + turned * (near + far)
    sine, cosine = sin(motion.half_width / 2), motion.half_cosine
    level = near * versine + far * (1 + turned)
    first = 2 * sine * cosine * near * versine
    first_level = cosine * cosine * level + sine * sine * tilt
    second = 4 * sine * cosine * far * rest / scale
    second_level = cosine * cosine * level - sine * sine * tilt
    low = first / sqrt(first * first + first_level * first_level)
    high = second / sqrt(second * second + second_level * second_level)
    product = near * bent * (far * low + near * high) / (8 * low)
    pole = strength * first_level / first
    return Point(strength, pole, one, product, 2 * delta / sqrt(square)), atan2(first, first_level)
