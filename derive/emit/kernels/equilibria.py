"""All equilibria of one rod."""

from __future__ import annotations

from typing import NamedTuple

from derive.emit.kernels.arcs import (
    Arc,
    Heading,
    arc_from_far,
    arc_to,
    clamp_point,
    far_point,
    heading_of,
    sent_back,
)
from derive.emit.kernels.arithmetic import (
    cos,
    epsilon,
    floor,
    frexp,
    inf,
    ldexp,
    less_quarters,
    pi,
    plus_quarters,
    sin,
    sqrt,
)
from derive.emit.kernels.ground import Clamp, clamp_in, ground_of, ridge_of
from derive.emit.kernels.hits import hits
from derive.emit.kernels.landscape import landscape, mirror_landscape
from derive.emit.kernels.pieces import pieces
from derive.emit.kernels.search import Stay, crossings
from derive.emit.kernels.shots import mirror_shots, tip_shots
from derive.emit.kernels.swing import phase_of, speed_at


class Rod(NamedTuple):
    """A rod in units in which β + η is of order one: lengths are 2**scale times the user's.

    field_angle: in (−π/2, π/2]; of the mirrored rod where ``side`` is −1.
    """

    beta: float
    eta: float
    length: float
    clamp_angle: float
    field_angle: float
    side: int
    scale: int


class Swing(NamedTuple):
    """A half-swing of a bent rod, for its shape: how it was found, its length, and its arc. turns: of the clamp.

    heading: the tip's direction. total: the arc of the whole rod.

    The clamp lies on the half-swing after ``whole`` of them, at the length ``arrival`` from where the motion is as at
    the tip, of which ``regular`` is not straight, and at the phase ψ with sin²ψ = square and cos²ψ = rest.
    """

    stay: Stay
    turns: int
    length: float
    heading: Heading
    arc: Arc
    total: Arc
    middle_angle: float
    far_angle: float
    whole: int
    arrival: float
    regular: float
    square: float
    rest: float


class Equilibrium(NamedTuple):
    """One equilibrium of a rod.

    tip_angle: θ(ℓ), continuous from θ(0) = clamp_angle, not wrapped. clamp_curvature: θ′(0). gamma: constant of
    the first integral. y, z: position of the tip. energy: ∫(½θ′² − ½η(d₃·e)²)ds − β·y, in units of EI. index:
    number of negative directions of the second variation; 0 means stable.
    rod: the rod it is an equilibrium of.
    swing: its half-swing, None if it is straight.
    """

    tip_angle: float
    clamp_curvature: float
    gamma: float
    y: float
    z: float
    energy: float
    index: int  # type: ignore[assignment]  # in the place of tuple.index
    rod: Rod
    swing: Swing | None


def all_equilibria(beta, eta, length, clamp_angle, field_angle, max_index):
    """Every equilibrium, sorted by tip angle: from the tips below the clamp angle, above it, and the straight rod."""
    if length * sqrt(beta + eta) <= epsilon():
        return [weak_rod(beta, eta, length, clamp_angle, field_angle)]
    most = inf if max_index is None else max_index
    scale = frexp(beta + eta)[1] // 2
    field = principal(field_angle)
    rod = Rod(ldexp(beta, -2 * scale), ldexp(eta, -2 * scale), ldexp(length, scale), clamp_angle, field, 1, scale)
    mirrored = Rod(rod.beta, rod.eta, rod.length, -clamp_angle, reflected(field), -1, scale)
    scene, other = landscapes(rod.beta, rod.eta, rod.field_angle)
    clamp = clamp_in(scene.rests, rod.clamp_angle)
    beyond = mirrored_clamp(scene, other, clamp, mirrored.clamp_angle)
    ridge = ridge_of(rod.beta, rod.eta, rod.field_angle, scene) if other is scene else None
    shots = tip_shots(rod.beta, rod.eta, rod.field_angle, rod.length, rod.clamp_angle)
    lower = below(rod, scene, clamp, ridge, most, shots)
    upper = below(mirrored, other, beyond, ridge, most, None if shots is None else mirror_shots(shots))
    return in_order([*lower, *straight(rod, scene, clamp, most), *upper[::-1]])


def landscapes(beta, eta, field_angle):
    """The landscape of a rod, and that of its mirror image."""
    if reflected(field_angle) == field_angle:
        scene = landscape(beta, eta, field_angle)
        return scene, scene
    scene = landscape(beta, eta, abs(field_angle))
    mirrored = mirror_landscape(scene)
    return (scene, mirrored) if field_angle > 0 else (mirrored, scene)


def mirrored_clamp(scene, other, clamp, mirrored):
    """The clamp seen from the other side of the y axis, in the landscape there; mirrored: the clamp angle there."""
    if clamp.offsets[0] > 0 and other.rests[0].angle == -scene.rests[0].angle:  # number by number the same
        return Clamp(-1 - clamp.turns, tuple([-offset for offset in clamp.offsets[::-1]]))
    return clamp_in(other.rests, mirrored)


def in_order(found):
    """The list with tips that are nearer than rounding given as equal, where rounding would exchange them."""
    for k in range(1, len(found)):
        if found[k].tip_angle < found[k - 1].tip_angle:
            found[k] = found[k]._replace(tip_angle=found[k - 1].tip_angle)
    return found


def principal(field_angle):
    """The field angle less half turns, in (−π/2, π/2]; one within rounding of a quarter turn is that."""
    if field_angle == 0 or field_angle == pi / 2:
        return field_angle
    half_turns = floor(field_angle / pi + 0.5)
    angle = less_quarters(field_angle, 2 * half_turns)
    blur = 2 * epsilon() * abs(field_angle)
    if abs(angle) <= (blur if half_turns else epsilon() ** 3):
        return 0 * angle
    return pi / 2 if pi / 2 - abs(angle) <= blur else angle


def reflected(field_angle):
    """The field angle seen from the other side of the y axis."""
    if field_angle == 0 or field_angle == pi / 2:
        return field_angle
    return -field_angle


def below(rod, scene, clamp, ridge, most, shots):
    """The equilibria with tips below the clamp angle, from the lowest up; tips may be nearer than rounding.

    ridge: that of the landscape, or None where it is not known yet. shots: all tips, roughly, or None.
    """
    tips = None if shots is None else [shot for shot in shots if shot.offset < 0]
    if tips == []:
        return []
    beta, eta, field_angle, length = rod.beta, rod.eta, rod.field_angle, rod.length
    ground = ground_of(eta, scene, clamp, ridge_of(beta, eta, field_angle, scene) if ridge is None else ridge)
    found = None
    if tips is not None:
        found = hits(beta, eta, field_angle, length, pieces(eta, field_angle, ground), tips)
    if found is None:
        found = []
        for piece in pieces(eta, field_angle, ground):
            if piece.width > 0:  # else the clamp angle is at the level of the ridge, to rounding
                here = crossings(beta, eta, field_angle, length, piece, most)
                found += [(piece, crossing) for crossing in sorted(here, key=lambda item: item.sample.place)]
    indexed = [(piece, crossing, index_of(crossing)) for piece, crossing in found]
    return [bent_rod(rod, clamp.turns, *item) for item in indexed if item[2] <= most]


def straight(rod, scene, clamp, most):
    """The straight equilibrium, if the clamp angle is a direction without moment."""
    if 0 not in clamp.offsets:
        return []
    found = [straight_rod(rod, rest) for rest, offset in zip(scene.rests, clamp.offsets, strict=True) if offset == 0]
    return [item for item in found if item.index <= most]


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


def index_of(crossing):
    """Number of conjugate points of the free end on the rod (Sturm: one in each half-swing, and a last one or none).

    h = ∂θ/∂θ_ℓ solves the second variation with h = 1, h′ = 0 at the tip; θ′ solves it too and vanishes once a
    half-swing, so h vanishes once in each. Whether it has vanished in the last, unfinished one is told by the sign
    of h at the clamp, which is against that of dθ/dσ times the slope of the branch.
    """
    swings = 2 * crossing.turns - (1 if crossing.sign < 0 else 0)
    positive = crossing.rising != (crossing.sign > 0)
    return swings if positive == (swings % 2 == 0) else swings + 1


def straight_rod(rod, rest):
    """The rod that stays straight, for its clamp angle is a direction without moment."""
    cosine, sine = direction(rest)
    along = cos(rest.angle - rod.field_angle)
    gamma = 2 * rod.beta * cosine + rod.eta * along * along
    soft = -rest.stiffness
    index = floor(rod.length * sqrt(soft) / pi + 0.5) if soft > 0 else 0
    energy = -(rod.beta * cosine + rod.eta * along * along / 2) * rod.length
    length = length_of(rod)
    return Equilibrium(
        rod.side * rod.clamp_angle,
        0 * length,
        ldexp(gamma, 2 * rod.scale),
        cosine * length,
        rod.side * sine * length,
        ldexp(energy, rod.scale),
        index,
        rod,
        None,
    )


def weak_rod(beta, eta, length, clamp_angle, field_angle):
    """The rod that is all but straight: θ″ is that of the clamp angle, to the square of rounding."""
    rod = Rod(beta, eta, length, clamp_angle, field_angle, 1, 0)
    lean = clamp_angle - field_angle
    moment = beta * sin(clamp_angle) + eta * sin(lean) * cos(lean)
    gamma = 2 * beta * cos(clamp_angle) + eta * cos(lean) * cos(lean)
    tip = clamp_angle - moment * length * length / 2
    y, z = length * cos(clamp_angle), length * sin(clamp_angle)
    return Equilibrium(tip, -moment * length, gamma, y, z, -gamma * length / 2, 0, rod, None)


def length_of(rod):
    """The length of a rod in the user's units."""
    return ldexp(rod.length, -rod.scale)


def direction(rest):
    """cos and sin of a direction, exact for whole quarter turns."""
    cosine, sine = cos(rest.extra), sin(rest.extra)
    for _ in range(rest.quarters % 4):
        cosine, sine = -sine, cosine
    return cosine, sine
