"""The equilibrium of a tip from which the motion meets the clamp angle after the length of the rod."""

from __future__ import annotations

from derive.emit.kernels.arcs import Arc, arc_from_far, arc_to, clamp_point, far_point, heading_of, sent_back
from derive.emit.kernels.arithmetic import cos, ldexp, plus_quarters, sin
from derive.emit.kernels.rods import Equilibrium, Swing
from derive.emit.kernels.swing import phase_of, speed_at


def bent_rod(rod, turns, piece, crossing, index):
    """The equilibrium of a tip on its branch."""
    beta, eta, length = rod.beta, rod.eta, rod.length
    stay, phase, (swing, arrival) = crossing.sample.stay, crossing.sample.phase, crossing.sample.regular
    motion, basin = stay.motion, piece.basin
    heading = heading_of(rod.field_angle, motion)
    whole = Arc(0, 0, 0)  # not asked for within the first half-swing
    if crossing.turns:
        whole = arc_to(beta, eta, heading, motion, far_point(motion), 1, 0, swing)
        whole = with_stays(rod, heading, whole, basin, stay.middle, stay.far)
    both, sign = 2 * crossing.turns, crossing.sign
    if sign > 0:
        part = arc_to(beta, eta, heading, motion, clamp_point(motion, phase), phase.square, phase.rest, arrival)
        part = with_stays(rod, heading, part, basin, stay.arrival, 0)
    else:
        part = last_stretch(rod, heading, motion, swing - arrival)
        part = with_stays(rod, heading, part, basin, stay.middle - stay.arrival, stay.far)
    through = both if sign > 0 else both - 1
    arc = part if through == 0 else Arc(*(float(through * a + b) for a, b in zip(whole, part, strict=True)))
    speed = speed_at(motion, phase)
    gamma = 2 * beta * heading.cosine + eta * (1 + heading.double_cosine) / 2
    energy = -gamma * length / 2 - 2 * beta * arc.y - arc.square
    scale = rod.scale
    first = arrival + stay.tip + stay.arrival
    # The length of the rod is better known than that of a half-swing.
    half_swing = (length - sign * first) / both if both else swing + stay.tip + stay.middle + stay.far
    return Equilibrium(
        rod.side * plus_quarters(motion.tip, 4 * turns),
        -rod.side * sign * ldexp(speed, scale),
        ldexp(gamma, 2 * scale),
        ldexp(length * heading.cosine + arc.y, -scale),
        rod.side * ldexp(length * heading.sine + arc.z, -scale),
        ldexp(energy, scale),
        index,
        rod,
        Swing(
            stay,
            turns,
            half_swing,
            heading,
            whole,
            arc,
            basin.axis.angle,
            basin.far.angle,
            through,
            first,
            arrival,
            phase.square,
            phase.rest,
        ),
    )


def last_stretch(rod, heading, motion, extent):
    """The arc from the last turning point to the clamp, of a rod that ends on its way back; extent: its length."""
    back = sent_back(motion)
    there, phase = heading_of(-rod.field_angle, back), phase_of(back)
    arc = arc_to(rod.beta, rod.eta, there, back, clamp_point(back, phase), phase.square, phase.rest, extent)
    return arc_from_far(rod.eta, heading, there, arc, extent)


def with_stays(rod, heading, arc, basin, middle, far):
    """An arc with the straight lengths along the ridge and the far hill, at which the motion nearly rests.

    Those along the tip's direction change nothing.
    """
    if middle == 0 and far == 0:
        return arc
    y, z, square = arc
    for angle, extent in ((basin.axis.angle, middle), (basin.far.angle, far)):
        turned = rod.eta * (cos(2 * (angle - rod.field_angle)) - heading.double_cosine) / 2
        y, z = y + extent * (cos(angle) - heading.cosine), z + extent * (sin(angle) - heading.sine)
        square = square + extent * turned
    return Arc(y, z, square)
