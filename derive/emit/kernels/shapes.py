"""The shape of a rod along its length."""

from __future__ import annotations

from typing import NamedTuple

from derive.emit.kernels.arcs import Arc, Point, arc_from_far, arc_to, heading_of, phase_from_far, sent_back
from derive.emit.kernels.arithmetic import apart_by_quarters, atan2, cos, epsilon, floor, ldexp, pick, sin, sqrt
from derive.emit.kernels.formulas import (
    before_cosine,
    before_over,
    before_sine,
    chi_cosine,
    chi_coversine,
    chi_rate,
    chi_scale,
    chi_versine,
    near_by_phase,
    pair_root,
    pair_root_sum,
    phase_rate,
    phase_ratio,
    phase_sum,
    point_pole,
    strength,
    turn_level,
    turn_over,
    turn_speed,
    turn_tilt,
    turn_tilt_apart,
    turn_under,
    unit_sine,
)
from derive.emit.kernels.landen import phase_at


class Station(NamedTuple):
    """A point of the rod on its half-swing: lengths from the tip and from the far turning point.

    whole: half-swings between the tip and the one it lies on, which is run through backwards where that is odd.
    beside: the length from the clamp; away: 1 where the motion from the tip is beyond the clamp there, −1 where it is
    before it, 0 where a turning point lies between.
    """

    whole: int
    from_tip: float
    from_far: float
    beside: float
    away: int


def angle_and_position(equilibrium, s, position=True):
    """θ, θ′, y and z at an arc length s from the clamp; y and z are worth nothing without ``position``."""
    if equilibrium.swing is not None:
        anchor, turned, curvature, y, z = along_bent(equilibrium, s, position)
        return anchor + turned, curvature, y, z
    rod = equilibrium.rod
    length = ldexp(rod.length, -rod.scale)
    share, left, bend = s / length, length - s, equilibrium.clamp_curvature
    angle = equilibrium.tip_angle - bend * left * (left / length) / 2
    return angle, bend * (left / length), equilibrium.y * share, equilibrium.z * share


def along_bent(equilibrium, s, position):
    """θ in two parts, of which only the sum is rounded at the size of θ, and θ′, y and z, of a rod that is bent."""
    rod, swing = equilibrium.rod, equilibrium.swing
    station = station_of(rod, swing, ldexp(s, rod.scale))
    sign = -1 if station.whole % 2 == 1 else 1
    anchor, turned, speed, arc = on_swing(rod, swing, station, position)
    # Along the tip's direction the rod is as long as it is; only what it departs by from that has been computed.
    y = s * swing.heading.cosine + ldexp(swing.total.y - station.whole * swing.arc.y - arc.y, -rod.scale)
    z = s * swing.heading.sine + ldexp(swing.total.z - station.whole * swing.arc.z - arc.z, -rod.scale)
    return rod.side * anchor, rod.side * turned, -rod.side * sign * ldexp(speed, rod.scale), y, rod.side * z


def station_of(rod, swing, s):
    """The point at a length from the clamp, measured from the nearer end of the rod.

    The last digit of a long rod's length is many digits of θ where it bends beside the clamp.
    """
    towards_tip = swing.whole % 2 == 0
    ahead = swing.arrival if towards_tip else swing.length - swing.arrival
    if 2 * s >= rod.length:
        # The motion takes a rounding more or less than the rod is long.
        left = rod.length - s if swing.whole else (rod.length - s) * (swing.arrival / rod.length)
        whole = floor(left / swing.length)
        return station_at(swing, whole, whole % 2 == 0, left - whole * swing.length, s, 0)
    if s <= ahead:
        return station_at(swing, swing.whole, towards_tip, ahead - s, s, -1 if towards_tip else 1)
    turned = floor((s - ahead) / swing.length)
    over = s - ahead - turned * swing.length
    return station_at(swing, swing.whole - 1 - turned, towards_tip == (turned % 2 == 0), over, s, 0)


def station_at(swing, whole, from_tip, length, beside, away):
    """The station at a length from the tip, or from the far turning point."""
    other = swing.length - length
    near, far = (length, other) if from_tip else (other, length)
    return Station(whole, near, far, beside, away)


def on_swing(rod, swing, station, position):
    """θ in two parts, dθ/dσ and the arc from the last turning point, or from the tip, at a point of a half-swing."""
    stay = swing.stay
    regular = swing.length - stay.tip - stay.middle - stay.far
    _, here, middle, far = parts(station.from_tip, stay.tip, regular, stay.middle)
    first, left, behind, _ = parts(station.from_far, stay.far, regular, stay.middle)
    if station.whole % 2 == 1:
        middle, far = behind, first
    anchor, turned, speed, arc = regular_part(rod, swing, station, here, left, position)
    for straight, extent in ((swing.middle_angle, middle), (swing.far_angle, far)):
        if extent > 0:
            turned_y, turned_z = cos(straight) - swing.heading.cosine, sin(straight) - swing.heading.sine
            arc = Arc(arc.y + extent * turned_y, arc.z + extent * turned_z, arc.square)
    return anchor, turned, speed, arc


def parts(length, stay, regular, middle_stay):
    """A length from a turning point: straight there, of the motion itself, straight in its middle, and the rest.

    Where the motion stays near its tip, its middle or its far turning point, the rod is straight.
    """
    first = min(length, stay)
    rest = length - first
    before = min(rest, regular / 2) if middle_stay > 0 else min(rest, regular)
    middle = min(rest - before, middle_stay)
    here = min(before + max(rest - before - middle, 0), regular)
    return first, here, middle, max(rest - middle - here, 0)


def regular_part(rod, swing, station, here, left, position):
    """θ in two parts, dθ/dσ and the arc, at lengths of the motion alone from the tip and the far turning point."""
    motion, back, arc = swing.stay.motion, station.whole % 2 == 1, Arc(0, 0, 0)
    if here <= epsilon() * left:  # where the square of the phase may underflow
        if back and position:
            _, arc = way_back(rod, swing.heading, motion, (1, 0), left, position)
        return *apart_by_quarters(motion.tip, 4 * swing.turns), 0 * here, arc
    a, b = motion.end / 2, motion.middle / 2
    if next_to_clamp(swing, station, here, left):
        square, rest = phase_beside(a, b, swing.square, swing.rest, station, here + left)
    else:
        square, rest = phase_at(a, b, here, left)
    point, half, speed = point_at(motion, square, rest)
    # The clamp angle is exact: what is measured from there is told from there; what turned back, if that is near.
    anchor, turned = rod.clamp_angle, 2 * half - motion.done
    if station.away == 0 and motion.done > abs(motion.tip):
        anchor, turned = apart_by_quarters(motion.tip + 2 * half, 4 * swing.turns)
    if back or left < here:
        # So near the far turning point that cos²ψ underflows the lengths tell more.
        phase = phase_from_far(motion, square, rest) if rest > epsilon() ** 12 else phase_at(a, b, left, here)
        behind, arc = way_back(rod, swing.heading, motion, phase, left, position and back)
        if left < here:
            anchor, turned = rod.clamp_angle, motion.left - 2 * behind
    if position and not back:
        arc = arc_to(rod.beta, rod.eta, swing.heading, motion, point, square, rest, here)
    return anchor, turned, speed, arc


def way_back(rod, heading, motion, phase, extent, position):
    """Half the angle and the arc from the far turning point to a point, by sin²ψ and cos²ψ from there."""
    if extent == 0:
        return 0 * extent, Arc(0, 0, 0)
    back, (square, rest) = sent_back(motion), phase
    point, half, _ = point_at(back, square, rest)
    if not position:
        return half, Arc(0, 0, 0)
    there = heading_of(-rod.field_angle, back)
    arc = arc_to(rod.beta, rod.eta, there, back, point, square, rest, extent)
    return half, arc_from_far(rod.eta, heading, there, arc, extent)


def next_to_clamp(swing, station, here, left):
    """Whether a point is nearer to the clamp than to the turning point ahead, with nothing straight between."""
    stay = swing.stay
    if station.away == 0 or station.beside > (left if station.away > 0 else here):
        return False
    middle = (here + left) / 2
    same_half = (swing.regular - middle) * (here - middle) > 0 and stay.arrival in (0, stay.middle)
    return stay.middle == 0 or same_half


def phase_beside(a, b, square, rest, station, whole):
    """sin²ψ and cos²ψ of a point beside the clamp by those of the clamp; whole: the length of the half-swing."""
    length, back = station.beside, whole - station.beside
    if station.away < 0:
        return phase_before(a, b, square, rest, phase_at(a, b, length, back))
    # Seen from the far turning point.
    square, rest = phase_before(b, a, rest, square, phase_at(b, a, length, back))
    return rest, square


def phase_before(a, b, square, rest, by):
    """sin²ψ and cos²ψ at a length before a known phase; by: those at the length itself."""
    by_square, by_rest = by
    share = (b / a) * (b / a)
    ratio, by_ratio = phase_ratio(share, square, rest), phase_ratio(share, by_square, by_rest)
    fall = square - by_square if square < rest else by_rest - rest
    over = before_over(square, rest, by_ratio)
    sine = before_sine(square, rest, ratio, by_square, by_rest, by_ratio, fall)
    cosine = before_cosine(square, rest, ratio, by_square, by_rest, by_ratio, over)
    return sine * sine, cosine * cosine


def point_at(motion, square, rest):
    """The point at ψ by sin²ψ and cos²ψ, half the angle from the tip to it, and |dθ/dσ| there, by cos χ."""
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
    done, ahead = unit_sine(over, under), unit_sine(left_over, left_under)
    whole = phase_sum(near, far, done, ahead)
    rate = chi_rate(square, rest, flat, scale)
    delta, strong = phase_rate(a, b, square, rest), strength(motion.near_moment)
    point = Point(
        strong,
        point_pole(strong, over, under),
        near_by_phase(square, rest, a * a / delta),
        pair_root(near, done, whole, rate),
        pair_root_sum(square, delta),
    )
    return point, atan2(over, under), turn_speed(motion.sine, done, ahead, whole, rate)
