"""The shape of a rod along its length."""

from __future__ import annotations

from derive.emit.kernels.arcs import Arc, Point, arc_to
from derive.emit.kernels.arithmetic import atan2, cos, floor, ldexp, pi, pick, sin, sqrt
from derive.emit.kernels.formulas import (
    chi_cosine,
    chi_coversine,
    chi_rate,
    chi_scale,
    chi_versine,
    near_by_phase,
    pair_root,
    pair_root_sum,
    phase_rate,
    phase_sum,
    point_pole,
    point_speed,
    strength,
    turn_level,
    turn_over,
    turn_tilt,
    turn_tilt_apart,
    turn_under,
    unit_sine,
)
from derive.emit.kernels.swing import phase_at


def angle_and_position(equilibrium, s):
    """θ, θ′, y and z at an arc length s from the clamp."""
    rod, swing = equilibrium.rod, equilibrium.swing
    if swing is None:
        length = ldexp(rod.length, -rod.scale)
        share, left, bend = s / length, length - s, equilibrium.clamp_curvature
        angle = equilibrium.tip_angle - bend * left * (left / length) / 2
        return angle, bend * (left / length), equilibrium.y * share, equilibrium.z * share
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
    point, half, low = point_at(motion, square, rest)
    arc = arc_to(rod.beta, rod.eta, rod.field_angle, motion, point, square, rest, length)
    speed = point_speed(point.strength, low, point.one, point.product)
    return motion.tip + 2 * half, speed, arc


def point_at(motion, square, rest):
    """The point at ψ by sin²ψ and cos²ψ, and half the angle from the tip to it with its sine, by cos χ."""
    a, b, near, far = motion.end / 2, motion.middle / 2, sqrt(motion.near), sqrt(motion.far)
    flat = (b / a) * (b / a) * square
    scale = chi_scale(square, rest, flat)
    versine, coversine = chi_versine(square, rest, flat, scale), chi_coversine(rest, scale)
    level = turn_level(near, far, versine, coversine)
    # The difference of the roots where they are near each other, else that of the terms themselves.
    alike = turn_tilt(near, far, motion.uneven, chi_cosine(square, rest, flat, scale))
    apart = turn_tilt_apart(near, far, versine, coversine)
    tilt = pick(abs(motion.uneven) < 0.1 * (near + far), alike, apart)
    sine, cosine = sin(motion.half_width / 2), motion.half_cosine
    over, under = turn_over(near, sine, cosine, versine), turn_under(sine, cosine, level, tilt)
    left_over, left_under = turn_over(far, sine, cosine, coversine), turn_under(sine, cosine, level, -tilt)
    done = unit_sine(over, under)
    whole = phase_sum(near, far, done, unit_sine(left_over, left_under))
    delta, strong = phase_rate(a, b, square, rest), strength(motion.near_moment)
    point = Point(
        strong,
        point_pole(strong, over, under),
        near_by_phase(square, rest, a * a / delta),
        pair_root(near, done, whole, chi_rate(square, rest, flat, scale)),
        pair_root_sum(square, delta),
    )
    return point, atan2(over, under), done
