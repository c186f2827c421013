"""Rods that stay straight, and those that are too short, or too weakly loaded, to bend."""

from __future__ import annotations

from derive.emit.kernels.arithmetic import cos, floor, ldexp, pi, sin, sqrt
from derive.emit.kernels.rods import Equilibrium, Rod, length_of


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
    # Loads that are hardly numbers are numbers times the length.
    force, magnet = beta * length, eta * length
    bend = force * sin(clamp_angle) + magnet * sin(lean) * cos(lean)
    energy = -(force * cos(clamp_angle) + magnet * cos(lean) * cos(lean) / 2)
    gamma = 2 * beta * cos(clamp_angle) + eta * cos(lean) * cos(lean)
    y, z = length * cos(clamp_angle), length * sin(clamp_angle)
    return Equilibrium(clamp_angle - bend * length / 2, -bend, gamma, y, z, energy, 0, rod, None)


def direction(rest):
    """cos and sin of a direction, exact for whole quarter turns."""
    cosine, sine = cos(rest.extra), sin(rest.extra)
    for _ in range(rest.quarters % 4):
        cosine, sine = -sine, cosine
    return cosine, sine
