"""The equilibrium of a tip from which the motion meets the clamp angle after the length of the rod."""

from __future__ import annotations

from derive.emit.kernels.arcs import Arc, arc_from_far, arc_to, clamp_point, far_point, heading_of, sent_back
from derive.emit.kernels.arithmetic import cos, ldexp, plus_quarters, sin
from derive.emit.kernels.rods import Equilibrium, Swing
from derive.emit.kernels.swing import phase_of, speed_at


def bent_rod(rod, turns, piece, crossing, index):
    """The equilibrium of a tip on its branch."""
    beta, eta, length, side, scale = rod.beta, rod.eta, rod.length, rod.side, rod.scale
    motion, phase = crossing.sample.stay.motion, crossing.sample.phase
    heading = heading_of(rod.field_angle, motion)
    through = 2 * crossing.turns - (1 if crossing.sign < 0 else 0)
    whole, arc = arcs_of(rod, piece.basin, crossing, heading, through)
    gamma = 2 * beta * heading.cosine + eta * (1 + heading.double_cosine) / 2
    energy = -gamma * length / 2 - 2 * beta * arc.y - arc.square
    near = motion.done < abs(motion.tip)  # the clamp angle is exact
    tip = rod.clamp_angle - motion.done if near else plus_quarters(motion.tip, 4 * turns)
    return Equilibrium(
        side * tip,
        -side * crossing.sign * ldexp(speed_at(motion, phase), scale),
        ldexp(gamma, 2 * scale),
        ldexp(length * heading.cosine + arc.y, -scale),
        side * ldexp(length * heading.sine + arc.z, -scale),
        ldexp(energy, scale),
        index,
        rod,
        swing_of(length, turns, piece.basin, crossing, heading, whole, arc, through),
    )


def swing_of(length, turns, basin, crossing, heading, whole, arc, through):
    """The half-swing of a bent rod, for its shape. through: half-swings before the one at the clamp."""
    sample, both = crossing.sample, 2 * crossing.turns
    # The length of the rod is better known than that of a half-swing.
    half_swing = (length - crossing.sign * sample.arrival) / both if both else sample.swing
    return Swing(
        sample.stay,
        turns,
        half_swing,
        heading,
        whole,
        arc,
        basin.axis.angle,
        basin.far.angle,
        through,
        sample.arrival,
        sample.regular[1],
        sample.phase.square,
        sample.phase.rest,
    )


def arcs_of(rod, basin, crossing, heading, through):
    """The arc of a half-swing, which is not asked for within the first one, and that of the rod."""
    beta, eta = rod.beta, rod.eta
    stay, phase, (swing, arrival) = crossing.sample.stay, crossing.sample.phase, crossing.sample.regular
    motion = stay.motion
    if crossing.sign > 0:
        part = arc_to(beta, eta, heading, motion, clamp_point(motion, phase), phase.square, phase.rest, arrival)
        part = with_stays(rod, heading, part, basin, stay.arrival, 0)
    else:
        part = last_stretch(rod, heading, motion, swing - arrival)
        part = with_stays(rod, heading, part, basin, stay.middle - stay.arrival, stay.far)
    if through == 0:
        return Arc(0, 0, 0), part
    whole = arc_to(beta, eta, heading, motion, far_point(motion), 1, 0, swing)
    whole = with_stays(rod, heading, whole, basin, stay.middle, stay.far)
    return whole, Arc(*(float(through * a + b) for a, b in zip(whole, part, strict=True)))


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
