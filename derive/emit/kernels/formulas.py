"""The formulas as the theory derives them, nothing folded.

Emitted by `derive emit`: do not edit, change the theory. Kernels import these by name; when a scene is emitted, they
are specialised to it, and a formula that its load case has of its own takes their place.

Digest of the inputs: sha256 bd5a6c19b639f4b16df50017edb08a20613a03136fc7182e51f8dcea1c5fdd4a
"""

from __future__ import annotations

from derive.emit.kernels.arithmetic import atan, sqrt
from derive.emit.kernels.carlson import rf
from derive.emit.kernels.carlson_each import rc, rd, rj


def tip_drive(beta, eta, xi_tip):
    """θ″(ℓ)/sin θ(ℓ): how fast the curvature leaves zero at the tip.

    Equation exsl6; proved as tip.parallel.tip_drive.
    """
    return beta + eta * xi_tip


def tip_gap(beta, eta, minus):
    """−f̂(−1)/(1 + ξ(ℓ)): its sign tells whether the orbit stops before ξ = −1.

    Equation exsl13; proved as tip.parallel.tip_gap.
    """
    return eta * minus - 2 * beta


def tip_gamma(beta, eta, xi_tip):
    """γ of the first integral, such that the curvature vanishes at the tip.

    Equation exsl23; proved as tip.parallel.tip_gamma.
    """
    return 2 * beta * xi_tip + eta * xi_tip * xi_tip


def point_level(beta, eta, xi_tip, xi):
    """f̂(ξ)/(ξ(ℓ) − ξ).

    Equation exsl13; proved as tip.parallel.point_level.
    """
    return 2 * beta + eta * (xi_tip + xi)


def curvature_squared(drop, level):
    """θ′², the square of the curvature: f̂(ξ).

    Equation exsl8; proved as tip.parallel.curvature_squared.
    """
    return drop * level


def pole_strength(plus, minus, drive):
    """b = f′(ξ(ℓ))/4: ξ = ξ(ℓ) + b/(℘ − c).

    Equation exsl17; proved as tip.parallel.pole_strength.
    """
    return -0.5 * plus * minus * drive


def root_plus(plus, drive):
    """The half-period value e_plus less c.

    Equation exsl16; proved as tip.parallel.root_plus.
    """
    return -0.5 * plus * drive


def root_minus(minus, drive):
    """The half-period value e_minus less c.

    Equation exsl16; proved as tip.parallel.root_minus.
    """
    return 0.5 * minus * drive


def root_other(eta, plus, minus):
    """The half-period value e_other less c.

    Equation exsl16; proved as tip.parallel.root_other.
    """
    return 0.25 * eta * plus * minus


def gap_minus_plus(drive):
    """e_minus − e_plus.

    Proved as tip.parallel.gap_minus_plus.
    """
    return drive


def gap_other_plus(beta, eta, plus):
    """e_other − e_plus.

    Proved as tip.parallel.gap_other_plus.
    """
    return 0.25 * plus * (2 * beta + eta * plus)


def gap_other_minus(minus, gap):
    """e_other − e_minus.

    Proved as tip.parallel.gap_other_minus.
    """
    return 0.25 * minus * gap


def point_plus(plus, drive, one_minus, drop):
    """x_plus = ℘ − e_plus at the point where cos θ = ξ.

    Equation exsl22; proved as tip.parallel.point_plus.
    """
    return 0.5 * plus * drive * one_minus / drop


def point_minus(minus, drive, one_plus, drop):
    """x_minus = ℘ − e_minus at the point where cos θ = ξ.

    Equation exsl22; proved as tip.parallel.point_minus.
    """
    return 0.5 * minus * drive * one_plus / drop


def point_other(plus, minus, level, drop):
    """x_other = ℘ − e_other at the point where cos θ = ξ.

    Equation exsl22; proved as tip.parallel.point_other.
    """
    return 0.25 * plus * minus * level / drop


def point_pole(plus, minus, drive, drop):
    """x_pole = ℘ − c at the point where cos θ = ξ.

    Equation exsl22; proved as tip.parallel.point_pole.
    """
    return 0.5 * plus * minus * drive / drop


def side_moment(beta, eta):
    """θ″/sin θ towards θ = π.

    Equation exsl6; proved as tip.parallel.side_moment.
    """
    return beta - eta


def moment_from_side(eta, side, plus):
    """θ″/sin θ at the angle with offset 1 + cos θ.

    Equation exsl6; proved as tip.parallel.moment_from_side.
    """
    return side + eta * plus


def moment_from_top(beta, eta, minus):
    """θ″/sin θ at the angle with offset 1 − cos θ.

    Equation exsl6; proved as tip.parallel.moment_from_top.
    """
    return beta + eta - eta * minus


def gap_from_side(eta, side, plus):
    """−f̂(−1)/(1 + ξ(ℓ)) from the offset 1 + ξ(ℓ).

    Equation exsl13; proved as tip.parallel.gap_from_side.
    """
    return -eta * plus - 2 * side


def drive_between(eta, drop, level):
    """β + Hξ(ℓ) from f̂ at the clamp: the slope of f̂ at the tip is −2 times it.

    Equation exsl13; proved as tip.parallel.drive_between.
    """
    return 0.5 * eta * drop + 0.5 * level


def level_above_gap(eta, one_plus, gap):
    """f̂(ξ)/(ξ(ℓ) − ξ) of an orbit that passes −1.

    Equation exsl13; proved as tip.parallel.level_above_gap.
    """
    return eta * one_plus - gap


def rising_level(eta, clamp_drive, drop):
    """f̂(ξ)/(ξ(ℓ) − ξ) of a tip near the clamp angle.

    Equation exsl13; proved as tip.parallel.rising_level.
    """
    return eta * drop + 2 * clamp_drive


def gap_below(eta, clamp_gap, drop):
    """−f̂(−1)/(1 + ξ(ℓ)) of an orbit that passes −1.

    Equation exsl13; proved as tip.parallel.gap_below.
    """
    return clamp_gap - eta * drop


def drop_from_gaps(eta, clamp_gap, gap):
    """ξ(ℓ) − ξ of an orbit that just passes −1.

    Equation exsl13; proved as tip.parallel.drop_from_gaps.
    """
    return (clamp_gap - gap) / eta


def drop_at_level(eta, clamp_drive, level):
    """ξ(ℓ) − ξ of an orbit that turns near the clamp.

    Equation exsl13; proved as tip.parallel.drop_at_level.
    """
    return (level - 2 * clamp_drive) / eta


def cos_bottom(beta, eta):
    """cos θ at which force and field balance, θ″ = 0, off the straight directions.

    Equation exsl26; proved as tip.parallel.cos_bottom.
    """
    return -beta / eta


def cos_level(beta, eta):
    """cos θ of the tip whose orbit has its other turning point at −1.

    Proved as tip.parallel.cos_level.
    """
    return 1 - 2 * beta / eta


def cos_other(beta, eta, xi):
    """ξ_o, the other root of f̂ when ξ is one.

    Equation exsl14; proved as tip.parallel.cos_other.
    """
    return -2 * beta / eta - xi


def straight_stiffness(beta, eta, xi):
    """The coefficient k of h″ + kh = 0 for small rotations h of a straight rod, cos θ = ξ = ±1.

    Proved as tip.parallel.straight_stiffness.
    """
    return eta - beta * xi - 2 * eta * xi * xi


def half_angle_squared(plus, minus, x_plus, x_minus):
    """tan²(θ/2) at the point.

    Equation exsl12a; proved as tip.parallel.half_angle_squared.
    """
    return minus * x_plus / (plus * x_minus)


def angle(plus, minus, x_plus, x_minus):
    """|θ| at the point, before θ passes 0 or π.

    Equation exsl12a; proved as tip.parallel.angle.
    """
    return 2 * atan(sqrt(minus) * sqrt(x_plus) / (sqrt(plus) * sqrt(x_minus)))


def arc_length(x_plus, x_minus, x_other):
    """σ, the length from the tip to the point.

    Equation DLMF 19.25.35; proved as tip.parallel.arc_length.
    """
    return rf(x_plus, x_minus, x_other)


def arc_y(eta, plus, minus, drive, xi_tip, arc, x_plus, x_minus, x_other):
    """∫cos θ dσ from the tip to the point.

    Equation exsl36; proved as tip.parallel.arc_y.
    """
    return xi_tip * arc - plus * minus * drive * rj(x_plus, x_minus, x_other, x_other + 0.25 * eta * plus * minus) / 6


def arc_z(eta, plus, minus, sin_tip, x_other):
    """∫sin θ dσ from the tip to the point, before θ passes 0 or π.

    Equation exsl41; proved as tip.parallel.arc_z.
    """
    return sin_tip * rc(x_other, x_other + 0.25 * eta * plus * minus)


def arc_square(beta, eta, plus, minus, drive, gap, xi_tip, arc, x_plus, x_minus, x_other):
    """−2∫ψ dσ = ∫(eta*xi**2) dσ from the tip to the point.

    Equation DLMF 19.29(ii); proved as tip.parallel.arc_square.
    """
    return (
        beta * plus * minus * drive * rj(x_plus, x_minus, x_other, x_other + 0.25 * eta * plus * minus) / 6
        + plus * drive * (2 * beta + eta * plus) * rd(x_minus, x_other, x_plus) / 6
        + arc * (eta - beta * plus - eta * plus)
        + plus * drive * sqrt(x_minus) * sqrt(x_other) / ((x_other + 0.25 * eta * plus * minus) * sqrt(x_plus))
    )


def rod_energy(beta, gamma, length, y, square):
    """Energy of the rod over EI: bending, field and force.

    Equation exsl8; proved as tip.parallel.rod_energy.
    """
    return 0.5 * gamma * length - 2 * beta * y - square
