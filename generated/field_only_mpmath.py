"""Clamped rod in a field along y, no force: mpmath, any precision.

Emitted by `derive emit` from the scene 'field_only': do not edit, change the scene, the theory or the kernels.

Gives: equilibria, shape, sweep.
Load case: field only, beta = 0. Valid for eta >= 0, length > 0, any clamp_angle.
Formulas, each proved equal to its derivation:
    arc_length (DLMF 19.25.35), arc_square (DLMF 19.29(ii)), arc_y (exsl36), arc_z (exsl41),
    curvature_squared (exsl8), drive_between (slch1), drop_at_level (slch1), drop_from_gaps (slch1),
    gap_below (slch1), gap_from_side (slch1), gap_minus_plus, gap_other_minus, gap_other_plus,
    level_above_gap (slch1), moment_from_side (exsl6), moment_from_top (exsl6), point_minus (exsl22),
    point_other (exsl22), point_plus (exsl22), rising_level (slch1), rod_energy (exsl8), side_moment (exsl6),
    straight_stiffness, tip_gamma (slch3), tip_gap (slch1)
Digest of the inputs: sha256 103e00aa345b54ce55fd37f947d8336878a25a8961a147142a909d39a333cecc
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from operator import index
from typing import Any, NamedTuple

from mpmath import asin, asinh, atan2, cos, eps, exp, isfinite, log, mp, mpf, pi, sin, sqrt, workdps
from mpmath import ceil as mpf_ceil
from mpmath import floor as each_floor
from mpmath import floor as mpf_floor

__all__ = ["Equilibrium", "Shape", "Sweep", "equilibria", "shape", "sweep"]

# Constants

FEWEST = 15  # decimal digits
MOST = 1000


# Special functions


def real(name, value):
    """A finite real number as an mpf, from a number or its decimal text; TypeError or ValueError names the argument."""
    numeric = getattr(getattr(value, "dtype", None), "kind", "f") in "fiu" and not getattr(value, "ndim", 0)
    try:
        if isinstance(value, (bool, bytes, complex)) or not numeric:
            raise TypeError(name)
        number = mpf(value)
    except (TypeError, ValueError, ZeroDivisionError):
        raise TypeError(f"{name} must be a real number, got {value!r}") from None
    if not isfinite(number):
        raise ValueError(f"{name} must be finite, got {value!r}")
    return number


def floor(x):
    """The greatest integer that is not above x."""
    return int(mpf_floor(x))


def epsilon():
    """The spacing of numbers just above 1."""
    return +eps


def ceil(x):
    """The least integer that is not below x."""
    return int(mpf_ceil(x))


def half_period(steps):
    """Real half-period ω₁ of ℘ from the mean's steps, started at a = √(e₁ − e₃), b = √(e₁ − e₂) (DLMF 23.6.34)."""
    return pi / (2 * steps[-1][0])


def agm(a, b):
    """Arithmetic-geometric mean of a ≥ b > 0, as the list of its steps (aₙ, bₙ); the last two agree to rounding."""
    steps = [(a, b)]
    while abs(a - b) > 4 * epsilon() ** 0.5 * a:
        a, b = (a + b) / 2, sqrt(a * b)
        steps.append((a, b))
    steps.append(((a + b) / 2, sqrt(a * b)))
    return steps


def rf(x, y, z):
    """R_F(x, y, z) for real x, y, z ≥ 0, at most one of them zero, by duplication.

    Each step takes a quarter of the spread; the last terms are the Taylor polynomial of degree 7 in the spread
    (DLMF 19.36.1), so the steps stop when its first omitted term is below rounding.
    """
    start = mean = (x + y + z) / 3
    reach = max(abs(mean - x), abs(mean - y), abs(mean - z)) / (3 * epsilon()) ** 0.125
    first, second = mean - x, mean - y
    scale = 1
    while reach > abs(mean) * scale:
        root_x, root_y, root_z = sqrt(x), sqrt(y), sqrt(z)
        shift = root_x * root_y + root_x * root_z + root_y * root_z
        x, y, z, mean = (x + shift) / 4, (y + shift) / 4, (z + shift) / 4, (mean + shift) / 4
        scale *= 4
    if start == mean and reach == 0:
        return 1 / sqrt(mean)
    a, b = first / (scale * mean), second / (scale * mean)
    c = -a - b
    e2, e3 = a * b - c * c, a * b * c
    series = (
        e2 * (e2 * (1 - 15 * e2 / 26) / 24 - 3 * e3 / 44) - e2 / 10 + e3 / 14 + 3 * e3 * e3 / 104 + e2 * e2 * e3 / 16
    )
    return (1 + series) / sqrt(mean)


def each_max(x, y):
    """The larger one."""
    return max(x, y)


def each_abs(x):
    """The absolute value."""
    return abs(x)


def largest(x):
    """The largest element: the element."""
    return x


def each_where(condition, yes, no):
    """``yes`` where the condition holds, else ``no``."""
    return yes if condition else no


def rc_between(x, y, gap):
    """R_C(x, y) with y − x = gap given: an inverse tangent or its hyperbolic sister (DLMF 19.2.18, 19.2.19)."""
    width = sqrt(each_where(gap == 0, y, each_abs(gap)))
    circular = atan2(width, sqrt(x)) / width
    hyperbolic = asinh(width / sqrt(y)) / width
    return each_where(gap == 0, 1 / sqrt(y), each_where(gap > 0, circular, hyperbolic))


def spread_series(a, b, c, d, e):
    """Sum of the terms of degree 2 to 7 in the spread of five variables whose sum is zero (DLMF 19.36.2)."""
    s2 = (a * a + b * b + c * c + d * d + e * e) / 2
    s3 = (a**3 + b**3 + c**3 + d**3 + e**3) / 3
    s4 = (a**4 + b**4 + c**4 + d**4 + e**4) / 4
    s5 = (a**5 + b**5 + c**5 + d**5 + e**5) / 5
    # Elementary symmetric functions from the power sums (Newton's identities with e₁ = 0).
    e2, e3 = -s2, s3
    e4 = s2 * s2 / 2 - s4
    e5 = s5 - s2 * s3
    low = -3 * e2 / 14 + e3 / 6 + 9 * e2 * e2 / 88 - 3 * e4 / 22 - 9 * e2 * e3 / 52 + 3 * e5 / 26
    return (
        low - e2**3 / 16 + 3 * e3 * e3 / 40 + 3 * e2 * e4 / 20 + 45 * e2 * e2 * e3 / 272 - 9 * (e3 * e4 + e2 * e5) / 68
    )


def rj(x, y, z, p):
    """R_J(x, y, z, p) for x, y, z ≥ 0, at most one zero, and p > 0, by duplication with R_C terms."""
    mean = (x + y + z + 2 * p) / 5
    a, b, c = mean - x, mean - y, mean - z
    spread = each_max(each_max(each_abs(a), each_abs(b)), each_max(each_abs(c), each_abs(mean - p)))
    target = (epsilon() / 4) ** 0.125
    scale, total = 1, 0 * mean
    gaps = (p - x, p - y, p - z)
    while largest(spread / mean) > target * scale:
        root_x, root_y, root_z, root_p = sqrt(x), sqrt(y), sqrt(z), sqrt(p)
        shift = root_x * root_y + root_x * root_z + root_y * root_z
        d_x, d_y, d_z = root_p + root_x, root_p + root_y, root_p + root_z
        e = gaps[0] / (scale * d_x * d_x) * (gaps[1] / (scale * d_y * d_y)) * (gaps[2] / (scale * d_z * d_z))
        # 1 + e as a product: p may be so small that the sum would cancel.
        end = 2 * root_p / d_x * ((p + shift) / (d_y * d_z))
        total = total + rc_between(1 + 0 * e, end, e) / (scale * d_x * d_y * d_z)
        x, y, z, p = (x + shift) / 4, (y + shift) / 4, (z + shift) / 4, (p + shift) / 4
        mean = (mean + shift) / 4
        scale *= 4
    a, b, c = a / (scale * mean), b / (scale * mean), c / (scale * mean)
    d = -(a + b + c) / 2
    return (1 + spread_series(a, b, c, d, d)) / (scale * mean * sqrt(mean)) + 6 * total


def rc(x, y):
    """R_C(x, y) for x ≥ 0, y > 0 (DLMF 19.2.17)."""
    return rc_between(x, y, y - x)


def rd(x, y, z):
    """R_D(x, y, z) = R_J(x, y, z, z) for x, y ≥ 0, not both zero, z > 0, by duplication."""
    mean = (x + y + 3 * z) / 5
    a, b = mean - x, mean - y
    spread = each_max(each_max(each_abs(a), each_abs(b)), each_abs(mean - z))
    target = (epsilon() / 4) ** 0.125
    scale, total = 1, 0 * mean
    while largest(spread / mean) > target * scale:
        root_x, root_y, root_z = sqrt(x), sqrt(y), sqrt(z)
        shift = root_x * root_y + root_x * root_z + root_y * root_z
        total = total + 1 / (scale * root_z * (z + shift))
        x, y, z, mean = (x + shift) / 4, (y + shift) / 4, (z + shift) / 4, (mean + shift) / 4
        scale *= 4
    a, b = a / (scale * mean), b / (scale * mean)
    c = -(a + b) / 3
    return (1 + spread_series(a, b, c, c, c)) / (scale * mean * sqrt(mean)) + 3 * total


def root_ratios(steps, u):
    """1/√(℘ − e₃), √((℘ − e₁)/(℘ − e₃)) and √((℘ − e₂)/(℘ − e₃)) at 0 ≤ u ≤ ω₁, elementwise in u.

    In Jacobi's letters sn/a, cn, dn. At the end of the mean they are circular; each step back is Gauss's
    transformation (DLMF 22.7(ii)) written without a difference of near numbers, so that cn keeps its relative
    precision where it is exponentially small; near u = 0, where its distance from 1 counts, it follows from sn.
    """
    mean = steps[-1][0]
    r, c = sin(mean * u) / mean, cos(mean * u)
    for (a, b), (a_next, _) in zip(steps[-2::-1], steps[:0:-1], strict=True):
        half_gap = (a - b) / 2
        below = c * c / (1 + a_next * r) + b * r
        scale = 1 + a_next * half_gap * r * r
        r, c = r / scale, c * sqrt(below * (1 + half_gap * r)) / scale
        sine = a * r
        c = each_where(sine < mpf("0.7"), sqrt((1 + sine) * each_max(1 - sine, 0)), c)
    b = steps[0][1]
    return r, c, sqrt(c * c + b * b * r * r)


# Formulas, as derived


def side_moment(eta):
    """θ″/sin θ towards θ = π.

    Equation exsl6; proved as tip.field_only.side_moment.
    """
    return -eta


def moment_from_side(eta, side, plus):
    """θ″/sin θ at the angle with offset 1 + cos θ.

    Equation exsl6; proved as tip.field_only.moment_from_side.
    """
    return side + eta * plus


def gap_from_side(eta, side, plus):
    """−f̂(−1)/(1 + ξ(ℓ)) from the offset 1 + ξ(ℓ).

    Equation slch1; proved as tip.field_only.gap_from_side.
    """
    return -eta * plus - 2 * side


def moment_from_top(eta, minus):
    """θ″/sin θ at the angle with offset 1 − cos θ.

    Equation exsl6; proved as tip.field_only.moment_from_top.
    """
    return eta - eta * minus


def tip_gap(eta, minus):
    """−f̂(−1)/(1 + ξ(ℓ)): its sign tells whether the orbit stops before ξ = −1.

    Equation slch1; proved as tip.field_only.tip_gap.
    """
    return eta * minus


def tip_gamma(eta, xi_tip):
    """γ of the first integral, such that the curvature vanishes at the tip.

    Equation slch3; proved as tip.field_only.tip_gamma.
    """
    return eta * xi_tip * xi_tip


def rod_energy(gamma, length, y, square):
    """Energy of the rod over EI: bending, field and force.

    Equation exsl8; proved as tip.field_only.rod_energy.
    """
    return 0.5 * gamma * length - square


def straight_stiffness(eta, xi):
    """The coefficient k of h″ + kh = 0 for small rotations h of a straight rod, cos θ = ξ = ±1.

    Proved as tip.field_only.straight_stiffness.
    """
    return eta - 2 * eta * xi * xi


def gap_minus_plus(drive):
    """e_minus − e_plus.

    Proved as tip.field_only.gap_minus_plus.
    """
    return drive


def gap_other_minus(minus, gap):
    """e_other − e_minus.

    Proved as tip.field_only.gap_other_minus.
    """
    return 0.25 * minus * gap


def gap_other_plus(eta, plus):
    """e_other − e_plus.

    Proved as tip.field_only.gap_other_plus.
    """
    return 0.25 * eta * plus * plus


def point_plus(plus, drive, one_minus, drop):
    """x_plus = ℘ − e_plus at the point where cos θ = ξ.

    Equation exsl22; proved as tip.field_only.point_plus.
    """
    return 0.5 * plus * drive * one_minus / drop


def point_minus(minus, drive, one_plus, drop):
    """x_minus = ℘ − e_minus at the point where cos θ = ξ.

    Equation exsl22; proved as tip.field_only.point_minus.
    """
    return 0.5 * minus * drive * one_plus / drop


def point_other(plus, minus, level, drop):
    """x_other = ℘ − e_other at the point where cos θ = ξ.

    Equation exsl22; proved as tip.field_only.point_other.
    """
    return 0.25 * plus * minus * level / drop


def arc_length(x_plus, x_minus, x_other):
    """σ, the length from the tip to the point.

    Equation DLMF 19.25.35; proved as tip.field_only.arc_length.
    """
    return rf(x_plus, x_minus, x_other)


def rising_level(eta, clamp_drive, drop):
    """f̂(ξ)/(ξ(ℓ) − ξ) of a tip near the clamp angle.

    Equation slch1; proved as tip.field_only.rising_level.
    """
    return eta * drop + 2 * clamp_drive


def drop_at_level(eta, clamp_drive, level):
    """ξ(ℓ) − ξ of an orbit that turns near the clamp.

    Equation slch1; proved as tip.field_only.drop_at_level.
    """
    return (level - 2 * clamp_drive) / eta


def drop_from_gaps(eta, clamp_gap, gap):
    """ξ(ℓ) − ξ of an orbit that just passes −1.

    Equation slch1; proved as tip.field_only.drop_from_gaps.
    """
    return (clamp_gap - gap) / eta


def gap_below(eta, clamp_gap, drop):
    """−f̂(−1)/(1 + ξ(ℓ)) of an orbit that passes −1.

    Equation slch1; proved as tip.field_only.gap_below.
    """
    return clamp_gap - eta * drop


def level_above_gap(eta, one_plus, gap):
    """f̂(ξ)/(ξ(ℓ) − ξ) of an orbit that passes −1.

    Equation slch1; proved as tip.field_only.level_above_gap.
    """
    return eta * one_plus - gap


def drive_between(eta, drop, level):
    """β + Hξ(ℓ) from f̂ at the clamp: the slope of f̂ at the tip is −2 times it.

    Equation slch1; proved as tip.field_only.drive_between.
    """
    return 0.5 * eta * drop + 0.5 * level


def arc_y(eta, plus, minus, drive, xi_tip, arc, x_plus, x_minus, x_other):
    """∫cos θ dσ from the tip to the point.

    Equation exsl36; proved as tip.field_only.arc_y.
    """
    return xi_tip * arc - plus * minus * drive * rj(x_plus, x_minus, x_other, x_other + 0.25 * eta * plus * minus) / 6


def arc_z(eta, plus, minus, sin_tip, x_other):
    """∫sin θ dσ from the tip to the point, before θ passes 0 or π.

    Equation exsl41; proved as tip.field_only.arc_z.
    """
    return sin_tip * rc(x_other, x_other + 0.25 * eta * plus * minus)


def arc_square(eta, plus, minus, drive, gap, xi_tip, arc, x_plus, x_minus, x_other):
    """−2∫ψ dσ = ∫(eta*xi**2) dσ from the tip to the point.

    Equation DLMF 19.29(ii); proved as tip.field_only.arc_square.
    """
    return (
        plus * drive * sqrt(x_minus) * sqrt(x_other) / ((x_other + 0.25 * eta * plus * minus) * sqrt(x_plus))
        + eta * drive * plus * plus * rd(x_minus, x_other, x_plus) / 6
        - drive * arc
    )


def curvature_squared(drop, level):
    """θ′², the square of the curvature: f̂(ξ).

    Equation exsl8; proved as tip.field_only.curvature_squared.
    """
    return drop * level


# Solver


def integer(name: str, value: Any) -> int:
    """An integer that is no truth value, or an error that names the argument."""
    try:
        number = None if isinstance(value, bool) else index(value)
    except TypeError:
        number = None
    if number is None:
        raise TypeError(f"{name} must be None or an integer, got {value!r}")
    return number


def digits(dps):
    """The decimal digits to work with: those that are asked for, else the caller's; from 15 to 1000."""
    wanted = mp.dps if dps is None else integer("dps", dps)
    if not FEWEST <= wanted <= MOST:
        whose = "dps" if dps is not None else "the precision of the caller, mp.dps,"
        raise ValueError(f"{whose} must be from {FEWEST} to {MOST} digits, got {wanted}")
    return wanted


@dataclass(frozen=True, slots=True)
class Rod:
    """What a shape needs beyond the tip: the rod, whole turns of the clamp angle, and how it was mirrored."""

    eta: mpf
    length: mpf
    turns: mpf
    mirrored: bool


class Tip(NamedTuple):
    """The free end, by what stays precise when it is near an equilibrium direction or a separatrix."""

    half_sine: mpf  # sin(θ_ℓ/2)
    half_cosine: mpf  # cos(θ_ℓ/2)
    gap: mpf  # η(1 − ξ_ℓ) − 2β
    drop: mpf  # ξ_ℓ − cos θ(0)
    level: mpf  # 2β + η(cos θ(0) + ξ_ℓ)
    drive: mpf  # β + ηξ_ℓ
    angle: mpf  # θ_ℓ in [0, 2π)
    passes: bool


class Given(NamedTuple):
    """The parameters of a rod as numbers, or of many as arrays of one length."""

    eta: Any
    length: Any
    clamp_angle: Any


def not_negative(name: str, value: object) -> mpf:
    """A real number ≥ 0, or an error that names the argument."""
    number = real(name, value)
    if number < 0:
        raise ValueError(f"{name} must not be negative, got {value!r}")
    return abs(number)  # no negative zero


def positive(name: str, value: object) -> mpf:
    """A real number > 0, or an error that names the argument."""
    number = real(name, value)
    if number <= 0:
        raise ValueError(f"{name} must be positive, got {value!r}")
    return number


def one_rod(eta, length, clamp_angle):
    """The parameters of one rod as numbers; TypeError or ValueError names the first that cannot be."""
    return Given(not_negative("eta", eta), positive("length", length), real("clamp_angle", clamp_angle))


def index_limit(max_index):
    """The largest index of equilibria that are wanted: None for no limit, or an integer ≥ 0."""
    if max_index is None:
        return None
    limit = integer("max_index", max_index)
    if limit < 0:
        raise ValueError(f"max_index must not be negative, got {max_index!r}")
    return limit


class Clamp(NamedTuple):
    """The clamp angle θ(0) in [0, 2π), and what stays precise near the special angles."""

    angle: mpf
    rest: mpf  # π − θ(0)
    fold: mpf  # the smaller of θ(0) and 2π − θ(0)
    one_plus: mpf  # 1 + cos θ(0)
    one_minus: mpf  # 1 − cos θ(0)
    drive: mpf  # β + η cos θ(0)
    gap: mpf  # η(1 − cos θ(0)) − 2β


def settled(value, eta, offset):
    """A value that changes with η cos θ(0), or 0 where no angle within rounding of the clamp angle tells it from 0."""
    return 0 if abs(value) <= 4 * epsilon() * eta * abs(sin(offset)) else value


def clamp_at(eta, angle, rest, offset, from_side):
    """The clamp at an offset from π (from_side) or from 0."""
    small, large = 2 * sin(offset / 2) ** 2, 2 * cos(offset / 2) ** 2
    if from_side:
        side = side_moment(eta)
        drive, gap = moment_from_side(eta, side, small), gap_from_side(eta, side, small)
        return Clamp(angle, rest, pi - offset, small, large, settled(drive, eta, offset), settled(gap, eta, offset))
    drive, gap = moment_from_top(eta, small), tip_gap(eta, small)
    return Clamp(angle, rest, offset, large, small, settled(drive, eta, offset), settled(gap, eta, offset))


def clamp_of(eta, clamp_angle):
    """Whole turns and the clamp within [0, 2π); an angle that rounds to a multiple of π is that multiple."""
    half_turns = floor(clamp_angle / pi + 0.5)
    rest = half_turns * pi - clamp_angle
    # Also an angle whose square would be lost: it bends the rod by less than any number here can tell.
    if abs(rest) <= max(epsilon() * abs(clamp_angle), epsilon() ** 3):
        rest = 0
    if half_turns % 2:
        return (half_turns - 1) / 2, clamp_at(eta, pi - rest, rest, abs(rest), True)
    if rest <= 0:
        return half_turns / 2, clamp_at(eta, -rest, pi + rest, -rest, False)
    return half_turns / 2 - 1, clamp_at(eta, 2 * pi - rest, rest - pi, rest, False)


def straight_index(eta, xi, length):
    """Number of conjugate points on a straight rod: zeros of cos(√k σ) on it, for h″ + kh = 0."""
    stiffness = straight_stiffness(eta, xi)
    if stiffness <= 0:
        return 0
    return floor(length * sqrt(stiffness) / pi + 0.5)


def straight_rod(eta, length, clamp_angle, turns, clamp):
    """The rod that stays straight: its clamp angle is an equilibrium direction, or nothing acts on it."""
    xi = clamp.one_plus - 1
    gamma = tip_gamma(eta, xi)
    sine = 0 if clamp.rest == 0 or clamp.angle == 0 else sin(clamp_angle)
    energy = rod_energy(gamma, length, xi * length, eta * xi * xi * length)
    rod = Rod(eta, length, turns, False)
    index = straight_index(eta, xi, length)
    return Equilibrium(clamp_angle, 0, gamma, xi * length, sine * length, energy, index, rod, None)


def mirror_image(clamp):
    """The clamp of the rod seen from the other side of the y axis."""
    return clamp._replace(angle=2 * pi - clamp.angle, rest=-clamp.rest)


class Piece(NamedTuple):
    """A range of tip angles below the clamp angle in which the rod's motion is of one kind.

    Seen from the tip, θ starts at rest at an angle between low and low + width, and rises to the clamp angle;
    ``passes`` tells whether it goes on through π. The kinds name the ends: 'top' (θ = 0, the direction of the
    force), 'side' (θ = π), 'level' (the orbit that just reaches π), 'clamp' (the clamp angle itself), 'turn' (the
    angle whose orbit turns at the clamp), 'rest' (the clamp, where that is an equilibrium direction).
    """

    low: mpf
    width: mpf
    high_rest: mpf  # π − high
    low_kind: str
    high_kind: str
    passes: bool


def double_well(eta, clamp):
    """The ranges when V has two wells and the clamp lies in one of them: over the ridge at π, and within the well."""
    level = 2 * atan2(mpf(0), sqrt(eta))
    # A force far below rounding parts off tips from which only a rod of length 150/√η or more comes back.
    outer: list[Piece] = []
    if clamp.rest == 0:
        return outer
    turn = 2 * atan2(sqrt(eta * clamp.one_plus), sqrt(clamp.gap))
    turn_rest = 2 * atan2(sqrt(clamp.gap), sqrt(eta * clamp.one_plus))
    if clamp.rest < 0 and clamp.drive <= 0:
        kind = "clamp" if clamp.drive < 0 else "rest"
        return [*outer, Piece(pi, -clamp.rest, clamp.rest, "side", kind, False)]
    if clamp.rest < 0:
        return [*outer, Piece(pi, turn_rest, -turn_rest, "side", "turn", False)]
    if clamp.drive >= 0:
        kind = "clamp" if clamp.drive > 0 else "rest"
        width = 2 * asin(clamp.gap / (2 * eta * sin((clamp.fold + level) / 2)))
        return [*outer, Piece(level, width, clamp.rest, "level", kind, False)]
    width = 2 * asin(clamp.one_plus / (2 * sin((turn + level) / 2)))
    return [*outer, Piece(level, width, turn_rest, "level", "turn", False)]


def pieces(eta, clamp):
    """All ranges of tip angles below the clamp angle from which the rod can rise to it.

    With V(θ) = β cos θ + ½η cos²θ, a tip at rest at φ reaches the clamp only if V(φ) is not below V anywhere
    between; those φ fill the ranges below. There is one well of V when η ≤ β and there are two, parted by θ = π,
    when η > β.
    """
    kind = "clamp" if clamp.rest > 0 else "turn" if clamp.rest < 0 else "rest"
    whole = Piece(0, clamp.fold, abs(clamp.rest), "top", kind, True)
    if eta <= mpf(0) or clamp.gap <= 0:
        return [whole]
    return double_well(eta, clamp)


def grid(eta, length, clamp, piece):
    """Places that part the branches finely: half a unit in the logarithm of the distance to either end.

    At the top and at the side the rod is too long beyond the first place. At the other ends one far place stands
    for the end itself: the branches tend to it steadily.
    """
    rounding = 2 - log(epsilon())
    slow = length * sqrt(eta)
    first = -slow - 4
    last = rounding
    if piece.high_kind == "level":
        last += slow
    elif piece.high_kind != "rest":
        # The tip of a stiff rod departs from the clamp angle by half the moment there times the length squared.
        moment = abs(clamp.drive) * sqrt(clamp.one_plus * clamp.one_minus)
        last = max(rounding, 4 + log(2 * piece.width) - log(moment) - 2 * log(length))
    places = [first + 0.5 * k for k in range(ceil(2 * (last - first)) + 1)]
    before = [first - 2 * rounding - slow] if piece.low_kind == "level" else []
    after = [places[-1] + 2 * rounding + slow] if piece.high_kind != "rest" else []
    return [*before, *places, *after]


class Roots(NamedTuple):
    """The values e₁ > e₂ ≥ e₃ of ℘ at its half-periods as gaps, and which roots of f they belong to.

    ``order`` has a letter for each of e₁, e₂, e₃: '+' for ξ = 1, '-' for ξ = −1, 'o' for the other root of f̂.
    """

    order: str
    long_gap: mpf  # e₁ − e₃
    short_gap: mpf  # e₁ − e₂


def apart(order, long_gap, short_gap):
    """The roots with e₁ > e₂: where they meet, on a separatrix, a gap far below rounding stands for none."""
    return Roots(order, long_gap, max(short_gap, long_gap * epsilon() ** 18))


def roots_of(eta, tip):
    """The gaps between e₁, e₂, e₃, each from the product of half-angles that does not cancel."""
    plus, minus = 2 * tip.half_cosine**2, 2 * tip.half_sine**2
    drive = tip.drive
    if eta <= mpf(0) or tip.passes:
        return apart("-o+", gap_minus_plus(drive), -gap_other_minus(minus, tip.gap))
    if drive > 0:
        return apart("o-+", gap_other_plus(eta, plus), gap_other_minus(minus, tip.gap))
    return apart("o+-", gap_other_minus(minus, tip.gap), gap_other_plus(eta, plus))


def half_period_of(roots):
    """Real half-period of ℘."""
    return half_period(agm(sqrt(roots.long_gap), sqrt(roots.short_gap)))


class Point(NamedTuple):
    """℘ − e₊, ℘ − e₋ and ℘ − e_o at a point of the rod."""

    plus: mpf
    minus: mpf
    other: mpf


def clamp_point(clamp, tip):
    """℘ − e₊, ℘ − e₋, ℘ − e_o where the rod reaches the clamp angle."""
    plus, minus = 2 * tip.half_cosine**2, 2 * tip.half_sine**2
    drive = tip.drive
    return Point(
        point_plus(plus, drive, clamp.one_minus, tip.drop),
        point_minus(minus, drive, clamp.one_plus, tip.drop),
        point_other(plus, minus, tip.level, tip.drop),
    )


class Timing(NamedTuple):
    """Lengths from the tip: to the other turning point, and to the first arrival at the clamp angle."""

    swing: mpf
    arrival: mpf


def timing_of(eta, clamp, tip):
    """Half-swing and first arrival of a tip."""
    roots = roots_of(eta, tip)
    half = half_period_of(roots)
    point = clamp_point(clamp, tip)
    direct = min(arc_length(point.plus, point.minus, point.other), half)
    if eta > mpf(0) and (not tip.passes):
        return Timing(half, direct)
    return Timing(2 * half, direct if clamp.rest >= 0 else 2 * half - direct)


def within_right_well(eta, clamp, piece, rise, fall):
    """drop and level of a tip between π and the clamp; both are negative there."""
    if piece.high_kind != "turn":
        drop = -2 * sin(piece.width - fall / 2) * sin(fall / 2)
        return drop, rising_level(eta, clamp.drive, drop)
    level = -2 * eta * sin(piece.width - fall / 2) * sin(fall / 2)
    return drop_at_level(eta, clamp.drive, level), level


def left_of_side(eta, clamp, piece, rise, fall):
    """gap, drop and level of a tip below π, each a sum of terms of one sign or a product of exact offsets."""
    # 2 sin(high − fall/2) sin(fall/2) is the difference of the cosines of the tip angle and of the high end.
    below_high = 2 * sin(piece.high_rest + fall / 2) * sin(fall / 2)
    if eta <= mpf(0) or piece.passes:
        if eta > mpf(0) and piece.high_kind == "level":
            gap = -eta * below_high
            drop = drop_from_gaps(eta, clamp.gap, gap)
        else:
            drop = below_high
            gap = gap_below(eta, clamp.gap, drop)
        return gap, drop, level_above_gap(eta, clamp.one_plus, gap)
    gap = 2 * eta * sin(piece.high_rest + piece.width - rise / 2) * sin(rise / 2)
    if piece.high_kind != "turn":
        drop = below_high
        return gap, drop, rising_level(eta, clamp.drive, drop)
    level = eta * below_high
    return gap, drop_at_level(eta, clamp.drive, level), level


def tip_at(eta, clamp, piece, place):
    """The tip at a place of a piece: −∞ is its low end, +∞ its high end, and offsets from both are exact."""
    rise, fall = piece.width / (1 + exp(-place)), piece.width / (1 + exp(place))
    high = pi - piece.high_rest
    angle = piece.low + rise if rise < fall else high - fall
    if eta > mpf(0) and piece.low_kind == "side":
        half_sine, half_cosine = cos(rise / 2), -sin(rise / 2)
        gap = gap_from_side(eta, side_moment(eta), 2 * half_cosine * half_cosine)
        drop, level = within_right_well(eta, clamp, piece, rise, fall)
    else:
        half_sine, half_cosine = sin(angle / 2), sin((piece.high_rest + fall) / 2)
        gap, drop, level = left_of_side(eta, clamp, piece, rise, fall)
    return Tip(half_sine, half_cosine, gap, drop, level, drive_between(eta, drop, level), angle, piece.passes)


def end_timing(piece, last):
    """The timing at the high end itself, where it is known: arrival at once, or after the whole half-swing."""
    if piece.high_kind == "clamp":
        return Timing(last.swing, 0)
    if piece.high_kind == "turn":
        return Timing(last.swing, last.swing)
    return last


def dip(function, left, middle, right, values):
    """The place nearest to zero between left and right by golden sections, or the first beyond zero."""
    best, positive = values[1], values[1] > 0
    if abs(best) > 4 * max(abs(values[0] - best), abs(values[2] - best)):
        return middle, best
    golden = (3 - sqrt(5)) / 2
    while abs(right - left) > 2 * sqrt(epsilon()) * (1 + abs(middle)):
        wide_right = right - middle > middle - left
        trial = middle + golden * (right - middle) if wide_right else middle - golden * (middle - left)
        value = function(trial)
        if (value > 0) != positive:
            return trial, value
        if abs(value) < abs(best):
            left, right = (middle, right) if wide_right else (left, middle)
            middle, best = trial, value
        elif wide_right:
            right = trial
        else:
            left = trial
    return middle, best


def brackets(places, values, function):
    """Pairs of places with values of opposite sign, those around an extremum between grid points included."""
    found = []
    for k in range(1, len(places)):
        if (values[k - 1] > 0) != (values[k] > 0):
            found.append((places[k - 1], places[k], values[k - 1], values[k]))
    for k in range(1, len(places) - 1):
        before, here, after = values[k - 1], values[k], values[k + 1]
        if (before > 0) == (here > 0) == (after > 0) and abs(here) <= min(abs(before), abs(after)):
            place, value = dip(function, places[k - 1], places[k], places[k + 1], values[k - 1 : k + 2])
            if (value > 0) != (here > 0):
                found.append((places[k - 1], place, before, value))
                found.append((place, places[k + 1], value, after))
    return found


def interpolated(a, b, c, value_a, value_b, value_c):
    """Where on the way from a to b inverse quadratic interpolation puts the zero, or half way where it is unsafe."""
    x, y = (a - b) / (c - b), (value_a - value_b) / (value_c - value_b)
    if y * y >= x or (1 - y) * (1 - y) >= 1 - x:
        return 0.5
    share = value_a / (value_b - value_a) * value_c / (value_b - value_c)
    return share + (c - a) / (b - a) * value_a / (value_c - value_a) * value_b / (value_c - value_b)


def bracketed_root(function, a, b, value_a, value_b):
    """A sign change of the function between a and b, to rounding, by Chandrupatla's method (1997)."""
    fraction = 0.5
    while True:
        trial = a + fraction * (b - a)
        value = function(trial)
        if (value > 0) == (value_a > 0):
            c, value_c = a, value_a
        else:
            c, value_c, b, value_b = b, value_b, a, value_a
        a, value_a = trial, value
        best, value_best = (a, value_a) if abs(value_a) < abs(value_b) else (b, value_b)
        least = 2 * epsilon() * (1 + abs(best)) / abs(b - a)
        if least > 0.5 or value_best == 0:
            return best
        fraction = min(1 - least, max(least, interpolated(a, b, c, value_a, value_b, value_c)))


class Crossing(NamedTuple):
    """A tip whose rod has the right length, on branch 2·turns·H + sign·t; ``rising``: the branch grows with the tip."""

    place: mpf
    turns: int
    sign: int
    rising: bool


def crossings(eta, length, clamp, piece):
    """Every crossing of the rod's length on a piece, as a list of Crossing."""
    places = grid(eta, length, clamp, piece)

    def timing(place):
        return timing_of(eta, clamp, tip_at(eta, clamp, piece, place))

    timings = [timing(place) for place in places]
    timings[-1] = end_timing(piece, timings[-1])
    found = []
    shortest = min(item.swing for item in timings)
    for turns in range(int(length / (2 * shortest)) + 2):
        for sign in (1, -1) if turns else (1,):

            def excess(item, turns=turns, sign=sign):
                return (2 * turns * item.swing if turns else 0) + sign * item.arrival - length

            values = [excess(item) for item in timings]
            for bracket in brackets(places, values, lambda place, f=excess: f(timing(place))):
                place = bracketed_root(lambda place, f=excess: f(timing(place)), *bracket)
                found.append(Crossing(place, turns, sign, bracket[3] > 0))
    return found


class Arc(NamedTuple):
    """A stretch of rod that starts at the tip: its length, ∫cos θ, ∫sin θ and η∫cos²θ."""

    extent: mpf
    y: mpf
    z: mpf
    square: mpf


def arc_to(eta, tip, point):
    """The arc from the tip to a point within the first half-period."""
    plus, minus = 2 * tip.half_cosine**2, 2 * tip.half_sine**2
    xi_tip = (tip.half_cosine - tip.half_sine) * (tip.half_cosine + tip.half_sine)
    drive = tip.drive
    arc = arc_length(point.plus, point.minus, point.other)
    y = arc_y(eta, plus, minus, drive, xi_tip, arc, point.plus, point.minus, point.other)
    z = arc_z(eta, plus, minus, 2 * tip.half_sine * tip.half_cosine, point.other)
    square = 0
    if eta > 0:
        square = arc_square(eta, plus, minus, drive, tip.gap, xi_tip, arc, point.plus, point.minus, point.other)
    return Arc(arc, y, z, square)


def half_period_point(eta, tip):
    """℘ − e₊, ℘ − e₋, ℘ − e_o at the half-period, where ℘ = e₁."""
    roots = roots_of(eta, tip)
    values = {roots.order[0]: 0, roots.order[1]: roots.short_gap, roots.order[2]: roots.long_gap}
    return Point(values["+"], values["-"], values["o"])


def swing_of(eta, tip, half):
    """The arc of a half-swing, from the arc of a half-period: through π it is two of them, mirror images in z."""
    if eta <= mpf(0) or tip.passes:
        return Arc(2 * half.extent, 2 * half.y, 0 * half.z, 2 * half.square)
    return half


def arrival_of(eta, tip, clamp, half, direct):
    """The arc to the first arrival, from the arc to the point of ℘: beyond π it comes back to the same ℘."""
    if (eta <= mpf(0) or tip.passes) and clamp.rest < 0:
        return Arc(2 * half.extent - direct.extent, 2 * half.y - direct.y, direct.z, 2 * half.square - direct.square)
    return direct


def whole_rod(eta, length, clamp, tip, crossing):
    """∫cos θ, ∫sin θ and η∫cos²θ over the rod that meets the clamp on the crossing's branch."""
    half = arc_to(eta, tip, half_period_point(eta, tip))
    direct = arc_to(eta, tip, clamp_point(clamp, tip))
    swing, arrival = swing_of(eta, tip, half), arrival_of(eta, tip, clamp, half, direct)
    turns, sign = 2 * crossing.turns, crossing.sign
    return Arc(
        length,
        mpf(turns * swing.y + sign * arrival.y),
        mpf(turns * swing.z + sign * arrival.z),
        mpf(turns * swing.square + sign * arrival.square),
    )


def index_of(crossing):
    """Number of conjugate points of the free end on the rod (Sturm: one in each half-swing, and a last one or none).

    h = ∂θ/∂θ_ℓ solves the second variation with h = 1, h′ = 0 at the tip; θ′ solves it too and vanishes once a
    half-swing, so h vanishes once in each. Whether it has vanished in the last, unfinished one is told by the sign
    of h at the clamp, which is against that of dθ/dσ times the slope of the branch.
    """
    swings = 2 * crossing.turns - (1 if crossing.sign < 0 else 0)
    positive = crossing.rising != (crossing.sign > 0)
    return swings if positive == (swings % 2 == 0) else swings + 1


def bent_rod(rod, clamp, tip, crossing):
    """The equilibrium of a tip on its branch."""
    arc = whole_rod(rod.eta, rod.length, clamp, tip, crossing)
    gamma = tip_gamma(rod.eta, (tip.half_cosine - tip.half_sine) * (tip.half_cosine + tip.half_sine))
    curvature = crossing.sign * sqrt(max(curvature_squared(tip.drop, tip.level), 0))
    return Equilibrium(
        2 * pi * (rod.turns + 1) - tip.angle if rod.mirrored else 2 * pi * rod.turns + tip.angle,
        curvature if rod.mirrored else -curvature,
        gamma,
        arc.y,
        -arc.z if rod.mirrored else arc.z,
        rod_energy(gamma, rod.length, arc.y, arc.square),
        index_of(crossing),
        rod,
        tip,
    )


def all_equilibria(eta, length, clamp_angle):
    """Every equilibrium, sorted by tip angle: from the tips below the clamp angle, above it, and the straight rod."""
    turns, clamp = clamp_of(eta, clamp_angle)
    if clamp.angle == 0 or eta == 0:
        return [straight_rod(eta, length, clamp_angle, turns, clamp)]
    found = []
    for mirrored, seen in ((False, clamp), (True, mirror_image(clamp))):
        rod = Rod(eta, length, turns, mirrored)
        for piece in pieces(eta, seen):
            for crossing in crossings(eta, length, seen, piece):
                tip = tip_at(eta, seen, piece, crossing.place)
                found.append(bent_rod(rod, seen, tip, crossing))
    if clamp.rest == 0 or clamp.drive == 0:
        found.append(straight_rod(eta, length, clamp_angle, turns, clamp))
    return sorted(found, key=lambda item: item.tip_angle)


def each_of(convert, name, values):
    """A number or a list, each converted under its own name."""
    if isinstance(values, (str, bytes)) or not isinstance(values, Iterable):
        return convert(name, values)
    return [convert(f"{name}[{place}]", value) for place, value in enumerate(values)]


def all_real(name, values):
    """A number, or a sequence of them as a list; TypeError or ValueError names the argument and the place."""
    return each_of(real, name, values)


def part_arc(eta, tip, sigma, r, ratios):
    """∫(cos θ − ξ_ℓ) and ∫sin θ from the tip to a point of the first half-period.

    The arguments of Carlson's integrals are (℘ − e)r², finite at the tip too; by homogeneity the integral of the
    third kind then takes a factor r³ and the elementary one a factor r.
    """
    plus, minus = 2 * tip.half_cosine**2, 2 * tip.half_sine**2
    scaled = [ratios[name] * ratios[name] + 0 * r for name in "+-o"]
    drive = tip.drive
    y = r**3 * arc_y(eta * r * r, plus, minus, drive, 0, 0, *scaled)
    z = r * arc_z(eta * r * r, plus, minus, 2 * tip.half_sine * tip.half_cosine, scaled[2])
    return y, z


def from_tip(eta, tip, sigma):
    """θ, dθ/dσ, ∫₀^σ cos θ and ∫₀^σ sin θ at arc lengths σ from the tip.

    tan(θ/2) is tan(θ_ℓ/2) times the square root of (℘ − e₊)/(℘ − e₋), so it is one ratio of cn, dn and 1.
    """
    roots = roots_of(eta, tip)
    passes = eta <= mpf(0) or tip.passes
    steps = agm(sqrt(roots.long_gap), sqrt(roots.short_gap))
    half = half_period(steps)
    waves = each_floor(sigma / (2 * half) + 0.5)
    within = sigma - 2 * half * waves
    r, cn, dn = root_ratios(steps, each_abs(within))
    ratios = {roots.order[0]: cn, roots.order[1]: dn, roots.order[2]: 1}
    side = each_where(within < 0, -1, 1)
    # Through π the motion of θ takes two periods of ℘: every other one is its mirror image.
    flip = each_where(waves % 2 == 0, 1, -1) if passes else 1
    up = tip.half_sine * ratios["+"]
    across = tip.half_cosine * ratios["-"] * flip
    swing = dn if passes else cn
    drive = tip.drive
    turning = 2 * tip.half_sine * tip.half_cosine * drive * r * swing * side * flip / (up * up + across * across)
    y, z = part_arc(eta, tip, sigma, r, ratios)
    whole = arc_to(eta, tip, half_period_point(eta, tip))
    xi_tip = (tip.half_cosine - tip.half_sine) * (tip.half_cosine + tip.half_sine)
    y = xi_tip * sigma + 2 * waves * (whole.y - xi_tip * half) + side * y
    z = flip * side * z + (0 if passes else 2 * waves * whole.z)
    return 2 * atan2(up, across), turning, y, z


def angle_and_position(equilibrium, s):
    """θ, θ′, y and z at arc lengths s from the clamp."""
    if equilibrium.tip is None:
        angle = equilibrium.tip_angle
        slope = s / equilibrium.rod.length
        return angle + 0 * s, 0 * s, equilibrium.y * slope, equilibrium.z * slope
    rod, tip = equilibrium.rod, equilibrium.tip
    angle, turning, y, z = from_tip(rod.eta, tip, rod.length - s)
    if rod.mirrored:
        return 2 * pi * (rod.turns + 1) - angle, turning, equilibrium.y - y, equilibrium.z + z
    return 2 * pi * rod.turns + angle, -turning, equilibrium.y - y, equilibrium.z - z


def all_not_negative(name, values):
    """Real numbers ≥ 0, or an error that names the argument and the index of the first that is none."""
    return each_of(not_negative, name, values)


def all_positive(name, values):
    """Real numbers > 0, or an error that names the argument and the index of the first that is none."""
    return each_of(positive, name, values)


def many_rods(eta, length, clamp_angle):
    """The parameters of many rods as lists of one length; numbers are repeated.

    TypeError or ValueError names the first argument that cannot be, and the index of its first bad value.
    """
    given = Given(all_not_negative("eta", eta), all_positive("length", length), all_real("clamp_angle", clamp_angle))
    lengths = {len(part) for part in given if isinstance(part, list)}
    if len(lengths - {1}) > 1:
        sizes = [
            f"{name} {len(part)}" for name, part in zip(given._fields, given, strict=True) if isinstance(part, list)
        ]
        raise ValueError(f"sequences must have one length: their lengths are {', '.join(sizes)}")
    rows = 1 if not lengths or lengths == {1} else max(lengths - {1})
    columns = [part if isinstance(part, list) else [part] for part in given]
    parts = [column * rows if len(column) == 1 else column for column in columns]
    return Given(*parts)


# Interface


@dataclass(frozen=True, slots=True)
class Equilibrium:
    """One equilibrium of a rod.

    tip_angle: θ(ℓ), continuous from θ(0) = clamp_angle, not wrapped. clamp_curvature: θ′(0). gamma: constant of
    the first integral. y, z: position of the tip. energy: ∫(½θ′² − ½η(d₃·e)²)ds − β·y, in units of EI. index:
    number of negative directions of the second variation; 0 means stable.
    rod: what ``shape`` needs beyond the tip.
    tip: where the rod starts from, None if it is straight.
    """

    tip_angle: mpf
    clamp_curvature: mpf
    gamma: mpf
    y: mpf
    z: mpf
    energy: mpf
    index: int
    rod: Rod
    tip: Tip | None


def equilibria(eta, length, clamp_angle, *, max_index=None, dps=None) -> list[Equilibrium]:
    """All equilibria of one rod, sorted by tip angle.

    eta: magnetic modulus over bending stiffness, η̃/(EI) ≥ 0.
    length: length of the rod, > 0.
    clamp_angle: θ(0), the angle from the y axis to the tangent at the clamp, in radians.
    max_index: the largest index that is wanted, 0 for stable equilibria only; None for all.

    All in one unit of length. Raises TypeError or ValueError, naming the argument, before any work.
    """
    with workdps(digits(dps)):
        rod, limit = one_rod(eta, length, clamp_angle), index_limit(max_index)
        found = all_equilibria(rod.eta, rod.length, rod.clamp_angle)
        return [item for item in found if limit is None or item.index <= limit]


@dataclass(frozen=True, slots=True)
class Shape:
    """A rod at the arc lengths asked for: theta (from y to the tangent), curvature θ′, and the position y, z."""

    theta: Any
    curvature: Any
    y: Any
    z: Any


def on_rod(equilibrium, s):
    """The arc lengths; TypeError or ValueError if the first is no equilibrium, or an s not on its rod."""
    if not isinstance(equilibrium, Equilibrium):
        raise TypeError(f"equilibrium must be one that equilibria gives, got {equilibrium!r}")
    places, length = all_real("s", s), equilibrium.rod.length
    for place, number in enumerate(places if isinstance(places, list) else [places]):
        if not 0 <= number <= length:
            where = f"s[{place}]" if isinstance(places, list) else "s"
            raise ValueError(f"{where} must lie in [0, {length}], the rod, got {number}")
    return places


def shape(equilibrium: Equilibrium, s, *, dps=None) -> Shape:
    """The shape of an equilibrium at arc lengths s from the clamp, a number or a sequence of them within [0, length].

    theta, curvature, y and z are numbers, or lists as long as s. Raises TypeError or ValueError where an s is not on
    the rod.
    """
    with workdps(digits(dps)):
        places = on_rod(equilibrium, s)
        if not isinstance(places, list):
            return Shape(*angle_and_position(equilibrium, places))
        rows = [angle_and_position(equilibrium, place) for place in places]
        return Shape(*([row[k] for row in rows] for k in range(4)))


@dataclass(frozen=True, slots=True)
class Sweep:
    """The equilibria of many rods, flat: case[k] is the index of the rod (in the order of the broadcast arrays)."""

    case: Any
    tip_angle: Any
    clamp_curvature: Any
    gamma: Any
    y: Any
    z: Any
    energy: Any
    index: Any


def sweep(eta, length, clamp_angle, *, max_index=None, dps=None) -> Sweep:
    """All equilibria of many rods: the arguments are numbers, or sequences of one length.

    max_index: the largest index that is wanted, 0 for stable equilibria only; None for all.

    Raises TypeError or ValueError, naming the argument and the index of a bad value, before any work.
    """
    with workdps(digits(dps)):
        given, limit = many_rods(eta, length, clamp_angle), index_limit(max_index)
        rods = list(zip(*given, strict=True))
        found = [(case, item) for case, rod in enumerate(rods) for item in equilibria(*rod, max_index=limit)]
        return Sweep(
            [case for case, _ in found],
            [item.tip_angle for _, item in found],
            [item.clamp_curvature for _, item in found],
            [item.gamma for _, item in found],
            [item.y for _, item in found],
            [item.z for _, item in found],
            [item.energy for _, item in found],
            [item.index for _, item in found],
        )
