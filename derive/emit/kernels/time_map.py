"""The time map of a piece: half-swing and first arrival at its places, however deep."""

from __future__ import annotations

from typing import NamedTuple

from derive.emit.kernels.arithmetic import deepest, epsilon, sqrt
from derive.emit.kernels.landen import swing_and_arrival
from derive.emit.kernels.levels import turn_to
from derive.emit.kernels.motion import Motion, motion_at
from derive.emit.kernels.swing import Phase, phase_of


class Delay(NamedTuple):
    """By how much a motion lasts longer when the place goes deeper by one, where that is all that changes.

    Near an end the rod is straight for long along the directions at which the motion nearly rests: at the tip, in the
    middle, and at the far turning point. arrival: the share of ``middle`` before the first arrival.
    """

    deepest: float
    tip: float
    middle: float
    far: float
    arrival: float


class Stay(NamedTuple):
    """A motion, and the lengths for which it stays near its tip, its middle, and its far turning point besides."""

    motion: Motion
    tip: float
    middle: float
    far: float
    arrival: float


class Sample(NamedTuple):
    """Half-swing and first arrival at a place of a piece, and of what they are: the motion and its phase at the clamp.

    The motion alone has the half-swing and the arrival without the lengths for which it stays anywhere.
    """

    place: float
    swing: float
    arrival: float
    stay: Stay
    phase: Phase
    regular: tuple[float, float]


def delays(piece):
    """The delays at both ends, beyond the depth at which squares of offsets would underflow."""
    basin, depth = piece.basin, deepest(piece.width)
    if basin.hill.stiffness < epsilon() ** 8:  # so flat that the moment is as the cube of the offset
        depth = 2 * depth / 3
    # With next to no moment at the clamp a rod is straight but for an offset whose square would underflow.
    straight = piece.high_kind == "clamp" and abs(piece.clamp_offset) < epsilon() ** 5
    far, none = slowness(basin.far), Delay(2 * depth if straight else depth, 0, 0, 0, 0)
    if piece.low_kind == "level":
        return Delay(depth, 0, 0, far / 2, 0), none
    low = Delay(depth, slowness(basin.hill), 0, far if basin.far_rise == 0 else 0, 0)
    if piece.high_kind != "level":
        return low, none
    ridge = slowness(basin.axis)
    behind = ridge_offset(piece)
    return low, Delay(depth, 0, ridge, 0, ridge if behind > 0 else ridge / 2 if behind == 0 else 0)


def slowness(hill):
    """Length per unit of the logarithm of the distance from a hill; a flat one is never come near enough to count."""
    return 1 / sqrt(hill.stiffness) if hill.stiffness > 0 else 0


def ridge_offset(piece):
    """Clamp less ridge, for a motion that passes the ridge."""
    ridge, rest = piece.basin.axis, piece.clamp_rest
    return piece.clamp_offset if rest.angle == ridge.angle else turn_to(ridge, rest)


def stay_at(beta, eta, field_angle, piece, ends, place):
    """The motion of the tip at a place, however deep."""
    low, high = ends
    delay = low if place < 0 else high
    depth = min(abs(place), delay.deepest)
    more = abs(place) - depth
    motion = motion_at(beta, eta, field_angle, piece, -depth if place < 0 else depth)
    return Stay(motion, more * delay.tip, more * delay.middle, more * delay.far, more * delay.arrival)


def sample_at(beta, eta, field_angle, piece, ends, place):
    """The sample at a place."""
    return sample_of(place, stay_at(beta, eta, field_angle, piece, ends, place))


def sample_of(place, stay):
    """The sample of a motion."""
    motion = stay.motion
    phase = phase_of(motion)
    regular = swing, arrival = swing_and_arrival(motion.end / 2, motion.middle / 2, phase.square, phase.rest)
    swing, arrival = swing + stay.tip + stay.middle + stay.far, arrival + stay.tip + stay.arrival
    return Sample(place, swing, arrival, stay, phase, regular)
