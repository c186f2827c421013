"""All equilibria of one rod."""

from __future__ import annotations

from dataclasses import dataclass

from derive.emit.kernels.arithmetic import pi, sin, sqrt
from derive.emit.kernels.formulas import curvature_squared, rod_energy, tip_gamma
from derive.emit.kernels.rods import index_of, straight_index, whole_rod
from derive.emit.kernels.search import crossings
from derive.emit.kernels.tips import Tip, clamp_of, mirror_image, pieces, tip_at


@dataclass(frozen=True, slots=True)
class Rod:
    """What a shape needs beyond the tip: the rod, whole turns of the clamp angle, and how it was mirrored."""

    beta: float
    eta: float
    length: float
    turns: float
    mirrored: bool


@dataclass(frozen=True, slots=True)
class Equilibrium:
    """One equilibrium of a rod.

    tip_angle: θ(ℓ), continuous from θ(0) = clamp_angle, not wrapped. clamp_curvature: θ′(0). gamma: constant of
    the first integral. y, z: position of the tip. energy: ∫(½θ′² − ½η(d₃·e)²)ds − β·y, in units of EI. index:
    number of negative directions of the second variation; 0 means stable.
    rod: what ``shape`` needs beyond the tip.
    tip: where the rod starts from, None if it is straight.
    """

    tip_angle: float
    clamp_curvature: float
    gamma: float
    y: float
    z: float
    energy: float
    index: int
    rod: Rod
    tip: Tip | None


def all_equilibria(beta, eta, length, clamp_angle):
    """Every equilibrium, sorted by tip angle: from the tips below the clamp angle, above it, and the straight rod."""
    turns, clamp = clamp_of(beta, eta, clamp_angle)
    if clamp.angle == 0 or beta + eta == 0:
        return [straight_rod(beta, eta, length, clamp_angle, turns, clamp)]
    found = []
    for mirrored, seen in ((False, clamp), (True, mirror_image(clamp))):
        rod = Rod(beta, eta, length, turns, mirrored)
        for piece in pieces(beta, eta, seen):
            for crossing in crossings(beta, eta, length, seen, piece):
                tip = tip_at(beta, eta, seen, piece, crossing.place)
                found.append(bent_rod(rod, seen, tip, crossing))
    if clamp.rest == 0 or clamp.drive == 0:
        found.append(straight_rod(beta, eta, length, clamp_angle, turns, clamp))
    return sorted(found, key=lambda item: item.tip_angle)


def bent_rod(rod, clamp, tip, crossing):
    """The equilibrium of a tip on its branch."""
    arc = whole_rod(rod.beta, rod.eta, rod.length, clamp, tip, crossing)
    gamma = tip_gamma(rod.beta, rod.eta, (tip.half_cosine - tip.half_sine) * (tip.half_cosine + tip.half_sine))
    curvature = crossing.sign * sqrt(max(curvature_squared(tip.drop, tip.level), 0))
    return Equilibrium(
        2 * pi * (rod.turns + 1) - tip.angle if rod.mirrored else 2 * pi * rod.turns + tip.angle,
        curvature if rod.mirrored else -curvature,
        gamma,
        arc.y,
        -arc.z if rod.mirrored else arc.z,
        rod_energy(rod.beta, gamma, rod.length, arc.y, arc.square),
        index_of(crossing),
        rod,
        tip,
    )


def straight_rod(beta, eta, length, clamp_angle, turns, clamp):
    """The rod that stays straight: its clamp angle is an equilibrium direction, or nothing acts on it."""
    xi = clamp.one_plus - 1
    gamma = tip_gamma(beta, eta, xi)
    sine = 0 if clamp.rest == 0 or clamp.angle == 0 else sin(clamp_angle)
    energy = rod_energy(beta, gamma, length, xi * length, eta * xi * xi * length)
    rod = Rod(beta, eta, length, turns, False)
    index = straight_index(beta, eta, xi, length)
    return Equilibrium(clamp_angle, 0, gamma, xi * length, sine * length, energy, index, rod, None)
