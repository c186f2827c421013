"""A rod by the article's own formulas, with ω₁, ω₃, u_o, ζ and σ, for comparison with the solver's way.

Only γ and the tip angle of the equilibrium are used; all the rest follows as the article has it. What that costs:
θ = ±arccos ξ and z by inverse functions of ξ keep half of the digits where the rod is straight up or down, or the
curvature vanishes (as it does at the tip); g₂ and g₃ lose what separates two half-period values that are near, and
with it digits of the periods; in y terms cancel that grow with the rod. Where two roots of f meet there are no values.
"""

from __future__ import annotations

from typing import NamedTuple

from derive.emit.kernels.arithmetic import cos, floor, ldexp, pi
from derive.emit.kernels.array_arithmetic import each_floor, each_max, each_min, each_real, each_sqrt, each_where
from derive.emit.kernels.article_formulas import (
    article_b,
    article_c,
    article_constant,
    article_g2,
    article_g3,
    article_levels,
    article_logarithm,
    article_root_2,
    article_root_a,
    article_root_b,
    article_sense,
    article_xi,
    article_xi_linear,
    article_y,
    article_y_linear,
    article_z,
    article_z_above,
    article_z_below,
    article_z_linear,
)
from derive.emit.kernels.inverses import near_acos
from derive.emit.kernels.rods import length_of
from derive.emit.kernels.weierstrass import half_periods, perimeter_point


class Path(NamedTuple):
    """How u runs: it ends at a half-period, ω̄ = end[0]·ω₁ + end[1]·ω₃, where ξ is ``tip``; ω₁ before, ξ is ``far``."""

    end: tuple[int, int]
    tip: float
    far: float


class LiteralRod(NamedTuple):
    """A rod in the article's letters. ``constant``: γ or γ̄. ``whole``, ``branch``: θ(ℓ) = whole ± arccos ξ(ℓ)."""

    constant: float
    g2: float
    g3: float
    omega_1: float
    u_o: complex
    tip: float
    far: float
    whole: float
    branch: int


def path_of(beta, eta, constant, tip_angle):
    """The article's cases of u_o = ω̄ − ℓ (text after exsl31, exhpf12 and slch11)."""
    if article_sense() == 0:
        return Path((1, 1), article_root_2(beta, constant), -1)
    low, high = article_root_a(beta, eta, constant), article_root_b(beta, eta, constant)
    upper = 2 * cos(tip_angle) > low + high
    if article_sense() > 0:
        if low < -1:
            return Path((0, 1), high, -1)
        return Path((0, 1), high, low) if upper else Path((1, 1), low, high)
    if high > 1:
        return Path((0, 1), low, -1)
    return Path((1, 0), high, 1) if upper else Path((1, 1), low, -1)


def motion_of(beta, eta, length, gamma, tip_angle):
    """The constants of the rod; ValueError where the article's formulas have no values."""
    if article_sense() != 0 and eta == 0:
        raise ValueError("the article's formulas divide by the root of eta; without a field use the case 'force_only'")
    if article_sense() == 0 and beta == 0:
        raise ValueError("the article's formulas divide by beta; a rod without any load stays straight")
    constant = article_constant(eta, gamma)
    g2, g3 = article_g2(beta, eta, constant), article_g3(beta, eta, constant)
    omega_1, omega_3 = half_periods(g2, g3)
    end, tip, far = path_of(beta, eta, constant, tip_angle)
    u_o = end[0] * omega_1 - length + 1j * end[1] * omega_3
    whole = 2 * pi * floor(tip_angle / (2 * pi) + 0.5)
    return LiteralRod(constant, g2, g3, omega_1, u_o, tip, far, whole, 1 if tip_angle > whole else -1)


def angle_and_position_literally(equilibrium, s):
    """θ, θ′, y and z at arc lengths s from the clamp."""
    rod, length = equilibrium.rod, length_of(equilibrium.rod)
    beta, eta = ldexp(rod.beta, 2 * rod.scale), ldexp(rod.eta, 2 * rod.scale)
    motion = motion_of(beta, eta, length, equilibrium.gamma, equilibrium.tip_angle)
    xi = cosine_along(beta, eta, motion, s)
    angle, curvature = angle_and_curvature(beta, eta, motion, length - s, xi)
    whole = z_from_tip(beta, eta, motion, length, cosine_along(beta, eta, motion, 0))
    z = whole - z_from_tip(beta, eta, motion, length - s, xi)
    return angle, curvature, y_along(beta, eta, motion, s), z


def cosine_along(beta, eta, motion, s):
    """ξ at s (exsl22, exhpf5 or slch11), kept between its bounds."""
    u = motion.u_o + s
    if article_sense() == 0:
        xi = article_xi_linear(beta, motion.constant, u, motion.g2, motion.g3)
    else:
        b, c = article_b(beta, eta, motion.constant), article_c(beta, eta, motion.constant)
        xi = article_xi(b, c, u, motion.g2, motion.g3)
    low, high = min(motion.tip, motion.far), max(motion.tip, motion.far)
    return each_max(each_min(each_real(xi), high), low)


def y_along(beta, eta, motion, s):
    """y at s (exsl36, exhpf15 or slch12); its logarithm is continued from the clamp."""
    if article_sense() == 0:
        return each_real(article_y_linear(beta, motion.constant, motion.u_o, s, motion.g2, motion.g3))
    b, c = article_b(beta, eta, motion.constant), article_c(beta, eta, motion.constant)
    v = perimeter_point(c, motion.g2, motion.g3)
    logarithm = article_logarithm(v, motion.u_o, s, motion.g2, motion.g3)
    return each_real(article_y(eta, b, v, s, logarithm, motion.g2, motion.g3))


def goes_through(motion):
    """Whether θ goes on where ξ is furthest from the tip's, there being ±1, or turns over."""
    return abs(motion.far) == 1


def first_sense(motion):
    """The sense in which θ leaves the tip angle, seen from the tip: 1 if it grows."""
    return motion.branch if motion.far < motion.tip else -motion.branch


def waves_of(motion, arc):
    """Whole waves of ξ between the tip and the middle nearest to a point, and the side of it on which that lies."""
    waves = each_floor(arc / (2 * motion.omega_1) + 0.5)
    return waves, each_where(arc < 2 * motion.omega_1 * waves, -1, 1)


def angle_and_curvature(beta, eta, motion, arc, xi):
    """θ = ±arccos ξ and θ′ = ±√f̂(ξ), with the signs and the whole turns that continue the tip's along the rod."""
    angle = motion.whole + motion.branch * near_acos(xi)
    waves, side = waves_of(motion, arc)
    sign = first_sense(motion) * side
    if goes_through(motion):
        odd = waves % 2 != 0
        middle = motion.whole + (motion.branch * pi if motion.far < 0 else 0)
        angle = each_where(odd, 2 * middle - angle, angle)
        sign = each_where(odd, -sign, sign)
    return angle, -sign * each_sqrt(each_max(article_levels(beta, eta, motion.constant, xi), 0))


def z_from_tip(beta, eta, motion, arc, xi):
    """∫sin θ from the tip to the point where ξ is given, as a difference of z(ξ) on each stretch of one sign."""
    at_tip = z_of_cosine(beta, eta, motion, motion.tip)
    waves, side = waves_of(motion, arc)
    stretch = first_sense(motion) * (z_of_cosine(beta, eta, motion, xi) - at_tip)
    if goes_through(motion):
        return each_where(waves % 2 == 0, 1, -1) * side * stretch
    half = first_sense(motion) * (z_of_cosine(beta, eta, motion, motion.far) - at_tip)
    return side * stretch + 2 * waves * half


def z_of_cosine(beta, eta, motion, xi):
    """z(ξ) up to a constant, with the curvature positive: exsl41, exhpf19 or slch14."""
    if article_sense() > 0:
        return article_z(beta, eta, motion.constant, xi)
    if article_sense() == 0:
        return article_z_linear(beta, motion.constant, xi)
    if motion.far > 0:
        return article_z_above(beta, eta, motion.constant, xi)
    return article_z_below(beta, eta, motion.constant, xi)
