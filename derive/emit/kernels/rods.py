"""A rod, and its equilibria as they are given."""

from __future__ import annotations

from typing import NamedTuple

from derive.emit.kernels.arcs import Arc, Heading
from derive.emit.kernels.arithmetic import ldexp
from derive.emit.kernels.time_map import Stay


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


def length_of(rod):
    """The length of a rod in the user's units."""
    return ldexp(rod.length, -rod.scale)
