"""Clamped rod under a terminal force, no field: NumPy, double precision.

Emitted by `derive emit` from the scene 'force_only': do not edit, change the scene, the theory or the kernels.

Gives: equilibria, shape, sweep.
Load case: force only, eta = 0. Valid for beta >= 0, length > 0, any clamp_angle.
Formulas, each proved equal to its derivation:
    arc_kink (DLMF 19.29(ii)), arc_kink_each (DLMF 19.29(ii)), arc_kink_tip, arc_kink_tip_each,
    arc_square (DLMF 19.29(ii)), arc_square_each (DLMF 19.29(ii)), arc_y (exsl36), arc_y_each (exsl36),
    arc_z (exsl41), arc_z_each (exsl41), back_below (DLMF 19.8(iii)), back_below_rest (DLMF 19.8(iii)),
    back_rest (DLMF 19.8(iii)), back_square (DLMF 19.8(iii)), before_cosine (DLMF 22.8(i)),
    before_over (DLMF 22.8(i)), before_sine (DLMF 22.8(i)), chi_cosine (DLMF 22.6(iii)),
    chi_coversine (DLMF 22.6(iii)), chi_rate (DLMF 22.6(iii)), chi_scale (DLMF 22.6(iii)),
    chi_square (DLMF 4.21(iii)), chi_square_each (DLMF 4.21(iii)), chi_versine (DLMF 22.6(iii)), far_pair_root,
    far_pair_root_each, far_root, far_root_each, gauss_rest (DLMF 19.8(iii)), gauss_rest_each (DLMF 19.8(iii)),
    gauss_square (DLMF 19.8(iii)), gauss_square_each (DLMF 19.8(iii)), half_rest (DLMF 22.6(iii)),
    half_rest_beyond (DLMF 22.6(iii)), half_rest_beyond_each (DLMF 22.6(iii)), half_rest_each (DLMF 22.6(iii)),
    half_square (DLMF 22.6(iii)), half_square_beyond (DLMF 22.6(iii)), half_square_beyond_each (DLMF 22.6(iii)),
    half_square_each (DLMF 22.6(iii)), near_by_phase (DLMF 19.25.35), others_product, others_product_each,
    others_sum, others_sum_each, pair_lift, pair_lift_each, pair_root, pair_root_each,
    pair_root_sum (DLMF 19.26(iii)), pair_root_sum_each (DLMF 19.26(iii)), phase_lead, phase_lead_each,
    phase_rate (DLMF 19.2.4), phase_rate_each (DLMF 19.2.4), phase_sum, phase_sum_each, point_near,
    point_near_each, point_pole (exsl22), point_pole_each (exsl22), point_speed (exsl8), pole_gap, pole_gap_each,
    rest_fall, rest_fall_each, rest_moment, rest_moment_each, rest_stiffness, rest_stiffness_each,
    second_kind_step (DLMF 19.8.19), second_kind_step_each (DLMF 19.8.19), strength (exsl17),
    strength_each (exsl17), tip_cubic, tip_cubic_each, turn_level, turn_over (DLMF 4.21(iii)), turn_tilt,
    turn_tilt_apart, turn_under, unit_sine (DLMF 4.14.7), w_imag (DLMF 19.29(ii)), w_imag_each (DLMF 19.29(ii)),
    w_real (DLMF 19.29(ii)), w_real_each (DLMF 19.29(ii))
Digest of the inputs: sha256 b4623340336cedc48192fbbece5824c70b964c6b76304bb29107152800981cdb
"""

from __future__ import annotations

from cmath import log as complex_log
from cmath import sqrt as complex_sqrt
from dataclasses import dataclass, replace
from math import asin, atan2, ceil, cos, exp, floor, frexp, hypot, inf, isfinite, ldexp, log, log2, pi, prod, sin, sqrt
from operator import index
from typing import Any, NamedTuple

import numpy as np

__all__ = ["Equilibrium", "Shape", "Sweep", "equilibria", "shape", "sweep"]

# Constants

SAFE = 1e-9  # bounds count where they hold by this much more than they must
FEW = 64  # points up to which each is computed by itself
COARSE = 8  # bins up to which a range is not divided to find straight ones in it
SHORT = 128  # bins up to which none is looked for that is straight
LONGEST = 48  # the longest series; where more terms are wanted, bins are halved
ENOUGH = 1500  # points in a run, on average, from which runs are faster than looking up
AT_A_TIME = 16  # bins whose cells are computed together, so that they stay in the cache
RUN_BLOCK = 16384  # points at a time, so that they stay in the cache
TERMS = 9  # of the series before what can be left out is left out
ANGLE_DEGREE = 6  # of the short series: two gathers of up to four coefficients each
PLACE_DEGREE = 5  # the slope is not asked for, so it needs a degree less
LOOKUP_BLOCK = 8192  # points at a time, so that what is gathered for them stays in the cache
BLOCK = 8192  # rods at once
FEWEST = 16  # rods that are faster on arrays than one by one
SLOWEST = 250.0  # ℓ√(β + η) from which offsets would be too small for their squares
NEARLY = 0.3  # how far η may be below the value at which a ridge appears, and still slow motions down, over β + η
SHARP = 0.01  # the same from which on the dips are too narrow for the samples here
SURELY = 1e-6  # bounds count where they hold by this much more than they must
ROUGH_SLOW = 12  # ℓ√(β + η) up to which single precision holds the places of all tips but the most extreme
HALVINGS = 4  # of the stretch at the low end in which no motion arrives in time
LATEST = 12.0  # places beyond which a count is its limit, but for the doubts of a hundred thousandth of all ranges
ROUGH_DEPTH = 28.0  # places up to which squares of offsets are numbers in single precision
RANGES = 1024  # ranges at once: arrays that stay in the cache
AROUND = np.concatenate([-0.5 ** np.arange(13), [0], 0.5 ** np.arange(12, -1, -1)])  # places about a dip
STEPS = 3  # rough steps, after which most places are right to single precision
SPREAD = 2.0**-9  # distance of two places from which they tell the slope of a branch in single precision
WIDE = 0.75  # first step between samples
CLOSER = 0.25  # the same where those leave a doubt
LAST = 100  # beyond the rank of any range


# Special functions


def real(name: str, value: object) -> float:
    """A finite real number as a float; TypeError or ValueError names the argument that is none."""
    numeric = getattr(getattr(value, "dtype", None), "kind", "f") in "fiu" and not getattr(value, "ndim", 0)
    if isinstance(value, (str, bytes, bool, complex)) or not numeric or not hasattr(value, "__float__"):
        raise TypeError(f"{name} must be a real number, got {value!r}")
    try:
        number = float(value)
    except (TypeError, ValueError):
        raise TypeError(f"{name} must be a real number, got {value!r}") from None
    except OverflowError:
        raise ValueError(f"{name} must be finite, got a number too large for a double") from None
    if not isfinite(number):
        raise ValueError(f"{name} must be finite, got {value!r}")
    return number


def epsilon() -> float:
    """The spacing of numbers just above 1."""
    return 2.0**-52


def less_quarters(angle, quarters):
    """angle − quarters·π/2, with π/2 in two parts of which the first has 33 bits, so that nothing is lost."""
    return (angle - quarters * 1.5707963267341256) - quarters * 6.077100506506192e-11


def pick(condition, yes, no):
    """``yes`` where the condition holds, else ``no``."""
    return yes if condition else no


def any_of(condition):
    """Whether the condition holds anywhere."""
    return condition


def larger(x, y):
    """The larger one."""
    return x if x > y else y


def spacing(x):
    """The spacing of numbers just above 1, in the precision of x."""
    return 2.0**-52


def deepest(width):
    """How far down, in the logarithm of the share of a width, the square of an offset is still a number."""
    return max(40.0, 300 + log(width))


def complex_of(real, imaginary):
    """The complex number of a real and an imaginary part."""
    return complex(real, imaginary)


def arctan_share(z, end):
    """R_C(1, end) for complex end = 1 + z: arctan(√z)/√z, by its series where z is small (DLMF 19.2.18)."""
    if abs(z) < 1e-3:
        return 1 - z * (1 / 3 - z * (1 / 5 - z * (1 / 7 - z * (1 / 9 - z / 11))))
    root = complex_sqrt(-z)
    return complex_log((1 + root) * (1 + root) / end) / (2 * root)


def each_less_quarters(angle, quarters):
    """angle − quarters·π/2, with π/2 in two parts of which the first has 33 bits, so that nothing is lost."""
    return (angle - quarters * 1.5707963267341256) - quarters * 6.077100506506192e-11


def each_pick(condition, yes, no):
    """``yes`` where the condition holds, else ``no``; whole numbers take the precision of what they meet."""
    chosen = np.where(condition, yes, no)
    return chosen.astype(np.float32) if chosen.dtype.kind in "ib" else chosen


def each_spacing(x):
    """The each_spacing of numbers just above 1, in the precision of the array."""
    return float(np.finfo(x.dtype).eps)


def each_complex_of(real, imaginary):
    """The complex numbers of real and imaginary parts."""
    return real + 1j * imaginary


def each_arctan_share(z, end):
    """R_C(1, end) for complex end = 1 + z: arctan(√z)/√z, by its series where z is small (DLMF 19.2.18)."""
    share = 1 - z * (1 / 3 - z * (1 / 5 - z * (1 / 7 - z * (1 / 9 - z / 11))))
    far = np.abs(z) >= 0.001
    if np.any(far):
        root = np.sqrt(-z[far])
        share[far] = np.log((1 + root) * (1 + root) / end[far]) / (2 * root)
    return share


# Formulas, as derived


def rest_fall(stiffness, middle_sine, middle_cosine, half_sine, half_cosine):
    """V(rest + middle − half) − V(rest + middle + half), from a direction without moment.

    Proved as swing.rest_fall.
    """
    return 8 * stiffness * middle_sine * middle_cosine * half_sine * half_cosine


def rest_moment(stiffness, sine, cosine):
    """θ″ at an offset from a direction without moment, by the sine and cosine of half the offset.

    Proved as swing.rest_moment.
    """
    return 2 * stiffness * sine * cosine


def phase_sum(root_near, root_far, done_sine, left_sine):
    """√P′ sin(δ/2) + √P sin(D − δ/2).

    Proved as swing.phase_sum.
    """
    return root_near * left_sine + root_far * done_sine


def phase_lead(root_near, half_cosine, uneven, done_sine, gap_sine):
    """√P sin(D − δ/2) − √P′ sin(δ/2), with gap_sine = sin((D − δ)/2) and uneven = √P′ − √P.

    Proved as swing.phase_lead.
    """
    return 2 * root_near * half_cosine * gap_sine - uneven * done_sine


def chi_square(behind, ahead):
    """sin²χ, by the two parts of the phase's sum as shares of it.

    Equation DLMF 4.21(iii); proved as swing.chi_square.
    """
    return 4 * behind * ahead


def half_square(end, square, tilt, delta):
    """sin²ψ by sin²χ = square and cos χ = tilt ≥ 0: χ runs to π, ψ to π/2, with half the rates.

    Equation DLMF 22.6(iii); proved as swing.half_square.
    """
    return end * square / ((end + delta) * (1 + tilt))


def half_square_beyond(end, tilt, delta):
    """sin²ψ by cos χ = −tilt ≤ 0.

    Equation DLMF 22.6(iii); proved as swing.half_square_beyond.
    """
    return end * (1 + tilt) / (end + delta)


def half_rest(end, tilt, delta):
    """cos²ψ by cos χ = tilt ≥ 0.

    Equation DLMF 22.6(iii); proved as swing.half_rest.
    """
    return (delta + end * tilt) / (end + delta)


def half_rest_beyond(end, middle, square, tilt, delta):
    """cos²ψ by sin²χ = square and cos χ = −tilt ≤ 0.

    Equation DLMF 22.6(iii); proved as swing.half_rest_beyond.
    """
    return square * middle * middle / ((delta + end * tilt) * (end + delta))


def phase_rate(first, second, square, rest):
    """Δ = √(a² cos²ψ + b² sin²ψ), dψ/dσ.

    Equation DLMF 19.2.4; proved as swing.phase_rate.
    """
    return sqrt(rest * first * first + square * second * second)


def gauss_square(square, total, below):
    """sin²ψ′ of Gauss's step, which keeps the integral: a′ = (a + b)/2, b′ = √(ab); total = a + b, below = a + Δ.

    Equation DLMF 19.8(iii); proved as swing.gauss_square.
    """
    return square * total * total / (below * below)


def gauss_rest(first, second, square, rest, delta, below):
    """cos²ψ′ of Gauss's step, without a difference; below = a + Δ.

    Equation DLMF 19.8(iii); proved as swing.gauss_rest.
    """
    return (
        2
        * first
        * rest
        * (first + (first * first + square * second * second) / (delta + second * square))
        / (below * below)
    )


def far_root(near, cosine):
    """ê₁, the value of x at the far turning point, by P and cos D.

    Proved as swing.far_root.
    """
    return 0.125 * near * cosine


def pair_lift(root_near, root_far, uneven, half_cosine, square, rest):
    """x + √X₂√X₃ by the phase, with uneven = √P′ − √P.

    Proved as swing.pair_lift.
    """
    return 0.125 * root_near * (uneven + 2 * root_near * half_cosine * half_cosine + 2 * root_far * rest / square)


def w_real(b, rj_im):
    """The real part of W = (2ib/3)R_J(X₁, X₂, X₃, x − ib): ∫e^{iθ}dσ = e^{iφ}(σ + W).

    Equation DLMF 19.29(ii); proved as swing.w_real.
    """
    return -2 * b * rj_im / 3


def w_imag(b, rj_re):
    """The imaginary part of W = (2ib/3)R_J(X₁, X₂, X₃, x − ib): ∫e^{iθ}dσ = e^{iφ}(σ + W).

    Equation DLMF 19.29(ii); proved as swing.w_imag.
    """
    return 2 * b * rj_re / 3


def arc_y(sine, cosine, arc, w_re, w_im):
    """∫y′ dσ from the tip to the point, by sin φ and cos φ.

    Equation exsl36; proved as swing.arc_y.
    """
    return cosine * (arc + w_re) - sine * w_im


def arc_z(sine, cosine, arc, w_re, w_im):
    """∫z′ dσ from the tip to the point, by sin φ and cos φ.

    Equation exsl41; proved as swing.arc_z.
    """
    return sine * (arc + w_re) + cosine * w_im


def rest_stiffness(beta, cosine):
    """dθ″/dθ by cos θ and cos 2(θ − α), where small rotations h obey h″ = (dθ″/dθ)h; at the tip it is q.

    Proved as swing.rest_stiffness.
    """
    return beta * cosine


def tip_cubic(beta, sine):
    """m, the coefficient of t³ in the half-angle quartic at the tip, by sin φ and sin 2(φ − α).

    Proved as swing.tip_cubic.
    """
    return beta * sine


def others_sum(q, root):
    """ê₂ + ê₃ by ê₁.

    Proved as swing.others_sum.
    """
    return -0.25 * q - root


def pole_gap(pole, size, others_sum, others_product, pair_root):
    """x² − x√X₂√X₃, with size = |x|, x > 0.

    Proved as swing.pole_gap.
    """
    return pole * (pole * others_sum - others_product) / (size + pair_root)


def others_product(b, m, root, others_sum):
    """ê₂ê₃ by ê₁ and ê₂ + ê₃.

    Proved as swing.others_product.
    """
    return 0.25 * b * m - root * others_sum


def arc_kink(square, delta, across, b, pole, near_root, pair_root):
    """The part of ∫η cos²(θ − α)dσ without integral.

    Equation DLMF 19.29(ii); proved as swing.arc_kink.
    """
    return 4 * delta * across / square - 2 * near_root * (1 + pole * pair_root / (b * b + pole * pole))


def arc_kink_tip(first, second, delta, across, b, pole, near_root, gap):
    """The same where x is large, by x² − x√X₂√X₃.

    Proved as swing.arc_kink_tip.
    """
    return (
        across * (4 * second - 4 * first) * (first + second) / delta
        + 2 * near_root * (gap + b * b) / (b * b + pole * pole)
    )


def second_kind_step(first, second, square, rest, delta, arc):
    """2J′ − J for J = (b² − a²)∫sin²ψ dσ over a length, J′ the same after Gauss's step.

    Equation DLMF 19.8.19; proved as swing.second_kind_step.
    """
    return (first + second) * (first - second) * (0.5 * arc - sqrt(square * rest) / (first + delta))


def arc_square(beta, cosine, first, root, arc, y, kink, growth):
    """η∫cos²(θ − α)dσ from the tip to the point, by cos φ and cos(φ − α).

    Equation DLMF 19.29(ii); proved as swing.arc_square.
    """
    return beta * cosine * arc - beta * y - 2 * arc * (2 * first * first - 2 * root) - 2 * kink - 8 * growth


def strength(moment_there):
    """b of the expansion t = b/(℘ − c), by θ″ at the tip.

    Equation exsl17; proved as swing.strength.
    """
    return 0.25 * moment_there


def point_pole(b, sine, cosine):
    """x = ℘ − c by the sine and cosine of δ/2, or any two numbers in their ratio.

    Equation exsl22; proved as swing.point_pole.
    """
    return b * cosine / sine


def far_pair_root(end):
    """√X₂√X₃ at the far turning point, by the rate of χ there.

    Proved as swing.far_pair_root.
    """
    return 0.25 * end * end


def point_near(b, sine, done_sine, left_sine):
    """X₁ = x − ê₁ at a point, zero at the far turning point, by sin D, sin(δ/2) and sin(D − δ/2).

    Proved as swing.point_near.
    """
    return b * left_sine / (sine * done_sine)


def pair_root(root_near, done_sine, whole, rate):
    """√X₂√X₃ by the phase's sum and the rate of χ over that at the turning points.

    Proved as swing.pair_root.
    """
    return 0.125 * root_near * whole * rate / done_sine


def pair_root_sum(square, delta):
    """√X₂ + √X₃ by sin²ψ and Δ.

    Equation DLMF 19.26(iii); proved as swing.pair_root_sum.
    """
    return 2 * delta / sqrt(square)


def before_over(first, square, rest, by_delta):
    """What the cosine of a difference of lengths is divided by; by_delta is Δ at the length taken off.

    Equation DLMF 22.8(i); proved as swing.before_over.
    """
    return square * by_delta / first + first * rest / by_delta


def before_sine(first, square, rest, delta, by_square, by_rest, by_delta, fall):
    """sin ψ at the difference of two lengths from the tip, by the difference of their sin²ψ.

    Equation DLMF 22.8(i); proved as swing.before_sine.
    """
    return first * fall / ((sqrt(square * by_rest) + delta * sqrt(rest * by_square) / by_delta) * by_delta)


def before_cosine(first, square, rest, delta, by_square, by_rest, by_delta, over):
    """cos ψ at the difference of two lengths from the tip.

    Equation DLMF 22.8(i); proved as swing.before_cosine.
    """
    return (delta * sqrt(square * by_square) / first + first * sqrt(rest * by_rest) / by_delta) / over


def back_below(first, second, square):
    """2a(a + b)/(a + Δ) by sin²ψ′, for a > b: Gauss's step undone.

    Equation DLMF 19.8(iii); proved as swing.back_below.
    """
    return first + second + square * (first - second)


def back_below_rest(first, second, rest):
    """The same by cos²ψ′, for a < b: Gauss's step undone.

    Equation DLMF 19.8(iii); proved as swing.back_below_rest.
    """
    return 2 * first - rest * (first - second)


def back_square(first, square, below):
    """sin²ψ by sin²ψ′: Gauss's step undone.

    Equation DLMF 19.8(iii); proved as swing.back_square.
    """
    return 4 * square * first * first / (below * below)


def back_rest(first, second, gap, rest, below):
    """cos²ψ by cos²ψ′, with gap = a − b: Gauss's step undone.

    Equation DLMF 19.8(iii); proved as swing.back_rest.
    """
    return rest * (4 * first * second + rest * gap * gap) / (below * below)


def chi_scale(square, rest, flat):
    """What cos χ, 1 ± cos χ and the rate of χ are divided by, with flat = (b/a)² sin²ψ.

    Equation DLMF 22.6(iii); proved as swing.chi_scale.
    """
    return rest * (1 + square) + square * flat


def chi_versine(square, rest, flat, scale):
    """1 − cos χ by the phase.

    Equation DLMF 22.6(iii); proved as swing.chi_versine.
    """
    return 2 * square * (rest + flat) / scale


def chi_coversine(rest, scale):
    """1 + cos χ by the phase.

    Equation DLMF 22.6(iii); proved as swing.chi_coversine.
    """
    return 2 * rest / scale


def turn_level(root_near, root_far, versine, coversine):
    """√P(1 − cos χ) + √P′(1 + cos χ).

    Proved as swing.turn_level.
    """
    return root_near * versine + root_far * coversine


def turn_tilt(root_near, root_far, uneven, cosine):
    """√P′(1 + cos χ) − √P(1 − cos χ), with uneven = √P′ − √P.

    Proved as swing.turn_tilt.
    """
    return uneven + cosine * (root_near + root_far)


def chi_cosine(square, rest, flat, scale):
    """cos χ by the phase: it doubles the elliptic argument.

    Equation DLMF 22.6(iii); proved as swing.chi_cosine.
    """
    return (rest * rest - square * flat) / scale


def turn_tilt_apart(root_near, root_far, versine, coversine):
    """√P′(1 + cos χ) − √P(1 − cos χ) where P and P′ are far apart.

    Proved as swing.turn_tilt_apart.
    """
    return root_far * coversine - root_near * versine


def turn_over(root, half_sine, half_cosine, part):
    """sin D times √P(1 − cos χ), or √P′(1 + cos χ).

    Equation DLMF 4.21(iii); proved as swing.turn_over.
    """
    return 2 * root * half_sine * half_cosine * part


def turn_under(half_sine, half_cosine, level, tilt):
    """by which turn_over is divided for tan(δ/2); with −tilt for tan(D − δ/2).

    Proved as swing.turn_under.
    """
    return tilt * half_sine * half_sine + level * half_cosine * half_cosine


def unit_sine(over, under):
    """Sine of the angle in (0, π) whose tangent is over/under.

    Equation DLMF 4.14.7; proved as swing.unit_sine.
    """
    return over / sqrt(over * over + under * under)


def near_by_phase(square, rest, bend):
    """X₁ by sin²ψ, cos²ψ and bend = a²/Δ.

    Equation DLMF 19.25.35; proved as swing.near_by_phase.
    """
    return rest * bend * bend / square


def chi_rate(square, rest, flat, scale):
    """The rate of χ over that at the turning points, by the phase.

    Equation DLMF 22.6(iii); proved as swing.chi_rate.
    """
    return (rest * rest + flat * (1 + rest)) / scale


def point_speed(b, done_sine, x_near, pair_root):
    """|θ_σ| by X₁ and √X₂√X₃.

    Equation exsl8; proved as swing.point_speed.
    """
    return 4 * pair_root * done_sine * done_sine * sqrt(x_near) / b


def rest_fall_each(stiffness, middle_sine, middle_cosine, half_sine, half_cosine):
    """V(rest + middle − half) − V(rest + middle + half), from a direction without moment.

    Proved as swing.rest_fall.
    """
    return 8 * stiffness * middle_sine * middle_cosine * half_sine * half_cosine


def rest_moment_each(stiffness, sine, cosine):
    """θ″ at an offset from a direction without moment, by the sine and cosine of half the offset.

    Proved as swing.rest_moment.
    """
    return 2 * stiffness * sine * cosine


def phase_sum_each(root_near, root_far, done_sine, left_sine):
    """√P′ sin(δ/2) + √P sin(D − δ/2).

    Proved as swing.phase_sum.
    """
    return root_near * left_sine + root_far * done_sine


def phase_lead_each(root_near, half_cosine, uneven, done_sine, gap_sine):
    """√P sin(D − δ/2) − √P′ sin(δ/2), with gap_sine = sin((D − δ)/2) and uneven = √P′ − √P.

    Proved as swing.phase_lead.
    """
    return 2 * root_near * half_cosine * gap_sine - uneven * done_sine


def chi_square_each(behind, ahead):
    """sin²χ, by the two parts of the phase's sum as shares of it.

    Equation DLMF 4.21(iii); proved as swing.chi_square.
    """
    return 4 * behind * ahead


def half_square_each(end, square, tilt, delta):
    """sin²ψ by sin²χ = square and cos χ = tilt ≥ 0: χ runs to π, ψ to π/2, with half the rates.

    Equation DLMF 22.6(iii); proved as swing.half_square.
    """
    return end * square / ((end + delta) * (1 + tilt))


def half_square_beyond_each(end, tilt, delta):
    """sin²ψ by cos χ = −tilt ≤ 0.

    Equation DLMF 22.6(iii); proved as swing.half_square_beyond.
    """
    return end * (1 + tilt) / (end + delta)


def half_rest_each(end, tilt, delta):
    """cos²ψ by cos χ = tilt ≥ 0.

    Equation DLMF 22.6(iii); proved as swing.half_rest.
    """
    return (delta + end * tilt) / (end + delta)


def half_rest_beyond_each(end, middle, square, tilt, delta):
    """cos²ψ by sin²χ = square and cos χ = −tilt ≤ 0.

    Equation DLMF 22.6(iii); proved as swing.half_rest_beyond.
    """
    return square * middle * middle / ((delta + end * tilt) * (end + delta))


def phase_rate_each(first, second, square, rest):
    """Δ = √(a² cos²ψ + b² sin²ψ), dψ/dσ.

    Equation DLMF 19.2.4; proved as swing.phase_rate.
    """
    return np.sqrt(rest * first * first + square * second * second)


def gauss_square_each(square, total, below):
    """sin²ψ′ of Gauss's step, which keeps the integral: a′ = (a + b)/2, b′ = √(ab); total = a + b, below = a + Δ.

    Equation DLMF 19.8(iii); proved as swing.gauss_square.
    """
    return square * total * total / (below * below)


def gauss_rest_each(first, second, square, rest, delta, below):
    """cos²ψ′ of Gauss's step, without a difference; below = a + Δ.

    Equation DLMF 19.8(iii); proved as swing.gauss_rest.
    """
    return (
        2
        * first
        * rest
        * (first + (first * first + square * second * second) / (delta + second * square))
        / (below * below)
    )


def strength_each(moment_there):
    """b of the expansion t = b/(℘ − c), by θ″ at the tip.

    Equation exsl17; proved as swing.strength.
    """
    return 0.25 * moment_there


def point_near_each(b, sine, done_sine, left_sine):
    """X₁ = x − ê₁ at a point, zero at the far turning point, by sin D, sin(δ/2) and sin(D − δ/2).

    Proved as swing.point_near.
    """
    return b * left_sine / (sine * done_sine)


def pair_root_each(root_near, done_sine, whole, rate):
    """√X₂√X₃ by the phase's sum and the rate of χ over that at the turning points.

    Proved as swing.pair_root.
    """
    return 0.125 * root_near * whole * rate / done_sine


def pair_root_sum_each(square, delta):
    """√X₂ + √X₃ by sin²ψ and Δ.

    Equation DLMF 19.26(iii); proved as swing.pair_root_sum.
    """
    return 2 * delta / np.sqrt(square)


def point_pole_each(b, sine, cosine):
    """x = ℘ − c by the sine and cosine of δ/2, or any two numbers in their ratio.

    Equation exsl22; proved as swing.point_pole.
    """
    return b * cosine / sine


def far_root_each(near, cosine):
    """ê₁, the value of x at the far turning point, by P and cos D.

    Proved as swing.far_root.
    """
    return 0.125 * near * cosine


def pair_lift_each(root_near, root_far, uneven, half_cosine, square, rest):
    """x + √X₂√X₃ by the phase, with uneven = √P′ − √P.

    Proved as swing.pair_lift.
    """
    return 0.125 * root_near * (uneven + 2 * root_near * half_cosine * half_cosine + 2 * root_far * rest / square)


def w_real_each(b, rj_im):
    """The real part of W = (2ib/3)R_J(X₁, X₂, X₃, x − ib): ∫e^{iθ}dσ = e^{iφ}(σ + W).

    Equation DLMF 19.29(ii); proved as swing.w_real.
    """
    return -2 * b * rj_im / 3


def w_imag_each(b, rj_re):
    """The imaginary part of W = (2ib/3)R_J(X₁, X₂, X₃, x − ib): ∫e^{iθ}dσ = e^{iφ}(σ + W).

    Equation DLMF 19.29(ii); proved as swing.w_imag.
    """
    return 2 * b * rj_re / 3


def arc_y_each(sine, cosine, arc, w_re, w_im):
    """∫y′ dσ from the tip to the point, by sin φ and cos φ.

    Equation exsl36; proved as swing.arc_y.
    """
    return cosine * (arc + w_re) - sine * w_im


def arc_z_each(sine, cosine, arc, w_re, w_im):
    """∫z′ dσ from the tip to the point, by sin φ and cos φ.

    Equation exsl41; proved as swing.arc_z.
    """
    return sine * (arc + w_re) + cosine * w_im


def rest_stiffness_each(beta, cosine):
    """dθ″/dθ by cos θ and cos 2(θ − α), where small rotations h obey h″ = (dθ″/dθ)h; at the tip it is q.

    Proved as swing.rest_stiffness.
    """
    return beta * cosine


def tip_cubic_each(beta, sine):
    """m, the coefficient of t³ in the half-angle quartic at the tip, by sin φ and sin 2(φ − α).

    Proved as swing.tip_cubic.
    """
    return beta * sine


def others_sum_each(q, root):
    """ê₂ + ê₃ by ê₁.

    Proved as swing.others_sum.
    """
    return -0.25 * q - root


def pole_gap_each(pole, size, others_sum, others_product, pair_root):
    """x² − x√X₂√X₃, with size = |x|, x > 0.

    Proved as swing.pole_gap.
    """
    return pole * (pole * others_sum - others_product) / (size + pair_root)


def others_product_each(b, m, root, others_sum):
    """ê₂ê₃ by ê₁ and ê₂ + ê₃.

    Proved as swing.others_product.
    """
    return 0.25 * b * m - root * others_sum


def arc_kink_each(square, delta, across, b, pole, near_root, pair_root):
    """The part of ∫η cos²(θ − α)dσ without integral.

    Equation DLMF 19.29(ii); proved as swing.arc_kink.
    """
    return 4 * delta * across / square - 2 * near_root * (1 + pole * pair_root / (b * b + pole * pole))


def arc_kink_tip_each(first, second, delta, across, b, pole, near_root, gap):
    """The same where x is large, by x² − x√X₂√X₃.

    Proved as swing.arc_kink_tip.
    """
    return (
        across * (4 * second - 4 * first) * (first + second) / delta
        + 2 * near_root * (gap + b * b) / (b * b + pole * pole)
    )


def second_kind_step_each(first, second, square, rest, delta, arc):
    """2J′ − J for J = (b² − a²)∫sin²ψ dσ over a length, J′ the same after Gauss's step.

    Equation DLMF 19.8.19; proved as swing.second_kind_step.
    """
    return (first + second) * (first - second) * (0.5 * arc - np.sqrt(square * rest) / (first + delta))


def arc_square_each(beta, cosine, first, root, arc, y, kink, growth):
    """η∫cos²(θ − α)dσ from the tip to the point, by cos φ and cos(φ − α).

    Equation DLMF 19.29(ii); proved as swing.arc_square.
    """
    return beta * cosine * arc - beta * y - 2 * arc * (2 * first * first - 2 * root) - 2 * kink - 8 * growth


def far_pair_root_each(end):
    """√X₂√X₃ at the far turning point, by the rate of χ there.

    Proved as swing.far_pair_root.
    """
    return 0.25 * end * end


# Solver


class Rod(NamedTuple):
    """A rod in units in which β + η is of order one: lengths are 2**scale times the user's.


    """

    beta: float
    length: float
    clamp_angle: float
    side: int
    scale: int


class Motion(NamedTuple):
    """A motion from rest at the tip through the clamp angle to rest at the far turning point, and back.

    With χ from 0 at the tip to π at the far turning point, dσ = dχ/√(end² cos²χ + middle² sin²χ).
    """

    tip: float  # the tip angle, in the turn of the landscape
    half_width: float
    done: float  # clamp − tip
    left: float  # far turning point − clamp
    near_moment: float  # θ″ at the tip
    far_moment: float  # −θ″ at the far turning point
    near: float  # 2θ″/sin(half_width) at the tip
    far: float  # the same at the far turning point
    end: float
    middle: float
    sine: float  # sin(half_width)
    half_cosine: float  # cos(half_width/2)
    uneven: float  # √far − √near
    done_sine: float  # sin(done/2)
    left_sine: float  # sin(left/2)


class Stay(NamedTuple):
    """A motion, and the lengths for which it stays near its tip, its middle, and its far turning point besides."""

    motion: Motion
    tip: float
    middle: float
    far: float
    arrival: float


class Arc(NamedTuple):
    """A stretch of rod from the tip: ∫cos θ, ∫sin θ and η∫cos²(θ − α)."""

    y: float
    z: float
    square: float


class Swing(NamedTuple):
    """A half-swing of a bent rod, for its shape: how it was found, its length, and its arc. turns: of the clamp.

    The clamp lies on the half-swing after ``whole`` of them, at the length ``arrival`` from where the motion is as at
    the tip, of which ``regular`` is not straight, and at the phase ψ with sin²ψ = square and cos²ψ = rest.
    """

    stay: Stay
    turns: int
    length: float
    arc: Arc
    middle_angle: float
    far_angle: float
    whole: int
    arrival: float
    regular: float
    square: float
    rest: float


def not_negative(name: str, value: object) -> float:
    """A real number ≥ 0, or an error that names the argument."""
    number = real(name, value)
    if number < 0:
        raise ValueError(f"{name} must not be negative, got {value!r}")
    return abs(number)  # no negative zero


def positive(name: str, value: object) -> float:
    """A real number > 0, or an error that names the argument."""
    number = real(name, value)
    if number <= 0:
        raise ValueError(f"{name} must be positive, got {value!r}")
    return number


def weak_rod(beta, length, clamp_angle):
    """The rod that is all but straight: θ″ is that of the clamp angle, to the square of rounding."""
    rod = Rod(beta, length, clamp_angle, 1, 0)
    moment = beta * sin(clamp_angle)
    gamma = 2 * beta * cos(clamp_angle)
    tip = clamp_angle - moment * length * length / 2
    y, z = length * cos(clamp_angle), length * sin(clamp_angle)
    return Equilibrium(tip, -moment * length, gamma, y, z, -gamma * length / 2, 0, rod, None)


class Rest(NamedTuple):
    """A direction without moment: angle = quarters·π/2 + extra.

    stiffness: dθ″/dθ there, positive on a hill. double_cosine, double_sine: of 2(angle − α).
    """

    quarters: int
    extra: float
    angle: float
    stiffness: float
    double_cosine: float
    double_sine: float


class Landscape(NamedTuple):
    """The directions of one turn, from the highest hill to the same hill a turn on: hill, well(, ridge, well), hill.

    level: the ridge is as high as the hill. even: V is symmetric about every hill and well.
    """

    rests: tuple[Rest, ...]
    level: bool
    even: bool


def along(beta, quarters, sign):
    """A direction along or against the force, no field: what it is about the field is not asked."""
    return Rest(quarters, 0, quarters * (pi / 2), sign * beta, 1, 0)


def no_field(beta):
    """The force alone."""
    return Landscape((along(beta, 0, 1), along(beta, 2, -1), along(beta, 4, 1)), False, True)


def landscape(beta):
    """Hills and wells for a field angle in (−π/2, π/2]."""
    return no_field(beta)


def landscapes(beta):
    """The landscape of a rod, and that of its mirror image."""
    scene = landscape(beta)
    return scene, scene


def offset_from(rest, angle, turns):
    """angle − (rest + turns·2π), without cancellation; 0 where no angle within rounding of this tells them apart."""
    offset = less_quarters(angle, 4 * turns + rest.quarters) - rest.extra
    blur = epsilon() * (abs(angle) + abs(rest.extra))
    return pick((abs(offset) <= blur) | (abs(offset) < epsilon() ** 9), 0, offset)


class Clamp(NamedTuple):
    """The clamp angle in a landscape: whole turns, and its offset from each direction without moment."""

    turns: int
    offsets: tuple[float, ...]


def clamp_in(rests, angle):
    """Whole turns such that the clamp lies from the first hill up to, but not at, its like a turn on."""
    turns = floor((angle - rests[0].angle) / (2 * pi))
    for _ in range(3):
        offsets = tuple(offset_from(rest, angle, turns) for rest in rests)
        shift = pick(offsets[0] < 0, -1, pick(offsets[-1] >= 0, 1, 0))
        if not any_of(shift != 0):
            break
        turns = turns + shift
    return Clamp(turns, offsets)


class Ground(NamedTuple):
    """What the ranges of a rod are told by: its landscape and the clamp's offsets from the directions there.

    drop: V(hill) − V(ridge); level: from the hill to the level of the ridge; height: V(ridge) − V(clamp). They are 0
    where no ridge is lower than the hill.
    """

    scene: Landscape
    at: tuple[float, ...]
    drop: float
    level: float
    height: float


def level_ground(scene, at):
    """The ground without a ridge lower than the hill."""
    return Ground(scene, at, 0, 0, 0)


def ridge_fall(beta, hill, ridge):
    """V(hill) − V(ridge): the sine of half their distance times the slope of V between, as if it were a circle."""
    half, middle = (ridge.extra - hill.extra) / 2, pi / 2 + (hill.extra + ridge.extra) / 2
    return cos(half) * (2 * beta * sin(middle))


def fall_from_rest(stiffness, middle, half):
    """V(middle − half) − V(middle + half), with both angles measured from a direction without moment."""
    return rest_fall(stiffness, sin(middle / 2), cos(middle / 2), sin(half / 2), cos(half / 2))


def fall(rest, start, change):
    """V(start) − V(start + change), from a start measured from a direction without moment."""
    half = change / 2
    return fall_from_rest(rest.stiffness, start + half, half)


def pick_rest(condition, yes, no):
    """One or the other direction, number by number."""
    return Rest(*(pick(condition, *pair) for pair in zip(yes, no, strict=True)))


def step_to(rest, offset, goal):
    """Newton's step to where the square root of the change of V from a direction without moment is ``goal``, and by
    how much its slope changes half way there, as a share of it."""
    small, large = sin(offset / 4), cos(offset / 4)
    sine, cosine = 2 * small * large, 1 - 2 * small * small
    level = rest_fall(rest.stiffness, small, large, small, large)
    force = abs(rest_moment(rest.stiffness, sine, cosine))
    here, force = sqrt(abs(level)), larger(force, epsilon() ** 20)
    whole_sine, whole_cosine = 2 * sine * cosine, 1 - 2 * sine * sine
    # dθ″/dθ, by β and α as the direction has them.
    turned = rest.double_cosine * (2 * whole_cosine * whole_cosine - 1 - whole_cosine)
    turned = turned - rest.double_sine * whole_sine * (2 * whole_cosine - 0.5)
    bend = rest.stiffness * whole_cosine * (here / force) * (here / force)
    share = (here - goal) / larger(here, epsilon() ** 20)
    return 2 * here * (here - goal) / force, share * (pick(level < 0, -bend, bend) - 0.5)


def reach(rest, amount, most, side):
    """The distance from a hill (or a well) at which V is lower (or higher) by ``amount``, to one side.

    most: the distance of the next well (or hill). Halley's method for the square root of the difference, which is
    nearly linear, from the pendulum's value.
    """
    amount = larger(amount, 0)  # of a hill and a well that nearly meet, rounding may give less
    share = amount / larger(abs(fall(rest, 0, side * most)), epsilon() ** 20)
    near = most * asin(sqrt(pick(share < 1, share, 1))) * (2 / pi)
    goal = sqrt(amount)
    for _ in range(40):
        step, bent = step_to(rest, side * near, goal)
        safe = abs(bent) < 0.5
        trial = near - step / pick(safe, 1 - bent, 1)
        trial = pick(trial > most, (near + most) / 2, pick(trial < 0, near / 2, trial))
        # The method cubes the error, and Newton's squares it: after steps this small the next would change nothing.
        small = pick(safe, spacing(trial) ** 0.45, spacing(trial) ** 0.6)
        moving, near = abs(trial - near) > small * near, trial
        if not any_of(moving):
            break
    return near


def ridge_ground(scene, at, drop):
    """The ground with a lower ridge."""
    rests = scene.rests
    down, above = rests[1].angle - rests[0].angle, fall(rests[2], 0, rests[1].angle - rests[2].angle)
    # Of a ridge that is next to its wells V tells at the hill nothing.
    by_hill = drop < above
    rest, amount = pick_rest(by_hill, rests[0], rests[1]), pick(by_hill, drop, above)
    distance = reach(rest, amount, down, pick(by_hill, 1, -1))
    level = pick(by_hill, distance, down - distance)
    # Near the far hill V says which is higher only by the distance from that hill.
    height = pick(at[2] < -at[4], fall(rests[2], 0, at[2]), fall(rests[4], 0, at[4]) - drop)
    return Ground(scene, at, drop, level, height)


def ground_of(beta, scene, clamp):
    """The ground of a rod."""
    rests, at = scene.rests, clamp.offsets
    if len(rests) == 3:
        return level_ground(scene, at)
    drop = 0 if scene.level else ridge_fall(beta, rests[0], rests[2])
    # A ridge lower by less than this would be passed only from within its square root of the hill.
    if drop <= epsilon() ** 17 * beta:
        return level_ground(scene._replace(level=True, even=True), at)
    return ridge_ground(scene, at, drop)


def in_basin(at, first, inside, builders):
    """The range of a clamp inside a basin: one before the well and at it, another beyond."""
    return [(inside & (at[first + 1] <= 0), builders[0]), (inside & (at[first + 1] > 0), builders[1])]


class Basin(NamedTuple):
    """What stops the rod and what it swings about: the hill that tips come from and the well below them, the hill
    that stops the motion and the last well before it, and the direction where it is slowest between its ends: the
    ridge that it passes, or the well.

    far_rise: V(far) − V(hill). even: the motion is symmetric about its middle.
    """

    hill: Rest
    well: Rest
    far: Rest
    far_well: Rest
    axis: Rest
    far_rise: float
    passes: bool
    even: bool


class Piece(NamedTuple):
    """Tip angles from low to low + width in a basin; angles as differences, told without loss.

    low_kind: 'hill', or 'level', where V is that of the ridge. high_kind: 'clamp', the clamp angle itself; 'turn', the
    angle from which the rod turns back at the clamp angle; 'level'.
    """

    basin: Basin
    low_kind: str
    high_kind: str
    low_offset: float  # low − hill
    width: float
    high_depth: float  # well − high
    clamp_gap: float  # clamp − high
    level_gap: float  # the angle at the level of the ridge − high, of a motion that passes it
    clamp_rest: Rest  # the direction next to the clamp
    clamp_offset: float  # clamp − that direction
    far_gap: float  # far − clamp


def piece_of(basin, low_kind, high_kind, low_offset, width, high_depth, clamp_gap, level_gap, at):
    """The record of a range."""
    rests = (basin.hill, basin.well, basin.axis, basin.far_well, basin.far) if basin.passes else basin[:3]
    rest, offset = rests[0], at[0]
    for other, distance in zip(rests[1:], at[1:], strict=False):
        closer = abs(distance) < abs(offset)
        if any_of(closer):
            rest, offset = pick_rest(closer, other, rest), pick(closer, distance, offset)
    last = at[len(rests) - 1]
    return Piece(basin, low_kind, high_kind, low_offset, width, high_depth, clamp_gap, level_gap, rest, offset, -last)


def from_hill_to_clamp(basin, at):
    """From a hill to a clamp before the well."""
    return piece_of(basin, "hill", "clamp", 0, at[0], -at[1], 0, 0, at)


def basin_of(ground, first):
    """The basin between two neighbouring hills."""
    scene = ground.scene
    hill, well, far = scene.rests[first : first + 3]
    even = scene.even and (scene.level or len(scene.rests) == 3)
    return Basin(hill, well, far, well, well, ground.drop if first else 0, False, even)


def first_clamp(ground):
    """From the first hill to the clamp."""
    return from_hill_to_clamp(basin_of(ground, 0), ground.at[:3])


def from_hill_to_turn(basin, at):
    """From a hill to where the rod turns back at a clamp beyond the well."""
    down, depth = basin.well.angle - basin.hill.angle, at[1]
    width = -at[2]
    if not basin.even:
        above = -fall(basin.well, 0, at[1])
        below = fall(basin.far, 0, at[2]) - basin.far_rise
        from_top = reach(basin.hill, larger(below, 0), down, 1)
        from_well = reach(basin.well, above, down, -1)
        depth = pick(below < above, down - from_top, from_well)
        width = pick(below < above, from_top, down - from_well)
    return piece_of(basin, "hill", "turn", 0, width, depth, depth + at[1], 0, at)


def first_turn(ground):
    """From the first hill to where the rod turns back at the clamp."""
    return from_hill_to_turn(basin_of(ground, 0), ground.at[:3])


def last_clamp(ground):
    """From the second hill to the clamp."""
    return from_hill_to_clamp(basin_of(ground, 2), ground.at[2:])


def last_turn(ground):
    """From the second hill to where the rod turns back at the clamp."""
    return from_hill_to_turn(basin_of(ground, 2), ground.at[2:])


def over_ridge(ground):
    """What stops a motion that passes the ridge."""
    hill, well, ridge, second, far = ground.scene.rests
    return Basin(hill, well, far, second, ridge, 0, True, ground.scene.even)


def pass_clamp(ground):
    """From the highest hill to a clamp above the level of the ridge."""
    at = ground.at
    return piece_of(over_ridge(ground), "hill", "clamp", 0, at[0], -at[1], 0, ground.level - at[0], at)


def pass_level(ground):
    """From the highest hill to the level of the ridge."""
    over, level, at = over_ridge(ground), ground.level, ground.at
    return piece_of(over, "hill", "level", 0, level, over.well.angle - over.hill.angle - level, at[0] - level, 0, at)


def moment_from_rest(stiffness, offset):
    """θ″ = −V′ at an offset from a direction without moment."""
    return rest_moment(stiffness, sin(offset / 2), cos(offset / 2))


def slope(rest, offset):
    """θ″ at an offset from a direction without moment."""
    return moment_from_rest(rest.stiffness, offset)


def onward(rest, start, amount, rough, wanted):
    """How far beyond ``start``, an offset from a direction without moment, V has fallen by ``amount``.

    The rough value is good to rounding of the angles; where little of it is left, the slope of V at the start gives a
    better one. Newton's method does the rest, until all that are wanted are found.
    """
    steep = slope(rest, start)
    told = (abs(rough) > 1e-3 * abs(start)) | (steep == 0)
    distance = pick(told, rough, amount / pick(told, 1, steep))
    for _ in range(40):
        force = slope(rest, start + distance)
        step = (fall(rest, start, distance) - amount) / pick(force == 0, 1, force)
        away = abs(distance - step) > pi
        stuck = away & (distance == rough)
        distance = pick(away, rough, distance - step)
        if not any_of(wanted & (stuck == 0) & (abs(step) > spacing(distance) ** 0.6 * abs(distance))):
            break
    return distance


def pass_turn(ground):
    """From the highest hill to where the rod turns back at a clamp above the level of the ridge, beyond it."""
    over, level, at = over_ridge(ground), ground.level, ground.at
    down = over.well.angle - over.hill.angle
    width = -at[4] if over.even else reach(over.hill, fall(over.far, 0, at[4]), down, 1)
    # Towards the hill V is flat and tells little, but there the angles tell all.
    near = width >= level / 2
    gap = pick(near, -onward(over.hill, level, ground.height, width - level, near), level - width)
    return piece_of(over, "hill", "turn", 0, width, down - width, at[0] - width, gap, at)


def level_clamp(ground):
    """From the level of the ridge to the clamp."""
    level, at = ground.level, ground.at
    return piece_of(basin_of(ground, 0), "level", "clamp", level, at[0] - level, -at[1], 0, 0, at)


def level_turn(ground):
    """From the level of the ridge to where the rod turns back at the clamp, before the ridge."""
    basin, level, at = basin_of(ground, 0), ground.level, ground.at
    down = basin.well.angle - basin.hill.angle
    above, below = -fall(basin.well, 0, at[1]), fall(basin.far, 0, at[2])
    from_well = reach(basin.well, above, down, -1)
    # Towards the well V is flat and tells little, but there the angles tell all; towards the hill only V does.
    from_hill = reach(basin.hill, ground.drop + below, down, 1)
    near = onward(basin.hill, level, below, from_hill - level, True)
    width = pick(below < above / 4, near, down - level - from_well)
    return piece_of(basin, "level", "turn", level, width, from_well, from_well + at[1], 0, at)


def ranges(ground):
    """Every range that a landscape of this kind can have: whether the rod has it, and its builder. From low to high."""
    at = ground.at
    if len(at) == 3:
        return in_basin(at, 0, at[0] > 0, (first_clamp, first_turn))
    if ground.scene.level:
        first = in_basin(at, 0, (at[0] > 0) & (at[2] < 0), (first_clamp, first_turn))
        return first + in_basin(at, 2, at[2] > 0, (last_clamp, last_turn))
    before, above = at[2] <= 0, at[0] <= ground.level
    last = (at[2] > 0) & (ground.height > 0)
    return [
        (before & above & (at[0] > 0), pass_clamp),
        ((before & (at[0] > ground.level)) | last, pass_level),
        ((at[2] > 0) & (ground.height <= 0), pass_turn),
        *in_basin(at, 0, (at[0] > ground.level) & (at[2] < 0), (level_clamp, level_turn)),
        *in_basin(at, 2, last, (last_clamp, last_turn)),
    ]


def pieces(beta, scene, clamp):
    """All ranges of tip angles below the clamp angle."""
    ground = ground_of(beta, scene, clamp)
    return [build(ground) for here, build in ranges(ground) if here]


def slowness(hill):
    """Length per unit of the logarithm of the distance from a hill; a flat one is never come near enough to count."""
    return 1 / sqrt(hill.stiffness) if hill.stiffness > 0 else 0


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


def ridge_offset(piece):
    """Clamp less ridge, for a motion that passes the ridge."""
    ridge, rest = piece.basin.axis, piece.clamp_rest
    return piece.clamp_offset if rest.angle == ridge.angle else rest.angle - ridge.angle


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


def within(sine):
    """A sine that rounding may have brought beyond 1."""
    return pick(sine < 1, sine, 1)


def parallel_side(beta, piece, rise, drop, from_hill, depth):
    """``far_side`` within a well for a field along the force: the cosines of the turning points add up to −2β/η."""
    basin = piece.basin
    if piece.low_kind == "level":
        low, high = sin(rise / 2) * sin(piece.low_offset + rise / 2), beta / 0.0 + cos(from_hill / 2) ** 2
    else:
        low = sin(rise / 2) ** 2
        low, high = beta / 0.0 + low, -beta / 0.0 - low
    # sin² and cos² of half the distance from the far turning point to the far hill.
    low, high = sqrt(larger(low, 0)), sqrt(larger(high, 0))
    distance = 2 * atan2(low, high)
    down = basin.far.angle - basin.far_well.angle
    dip = sin(from_hill + depth / 2) * sin(depth / 2)
    up = 2 * asin(within(dip / sin((down + distance) / 2)))
    if piece.high_kind == "turn":
        share = sin(from_hill + drop / 2) * sin(drop / 2) / sin((piece.far_gap + distance) / 2)
        left = 2 * asin(within(share))
    else:
        left = up + piece.high_depth
    return (up + depth) / 2, left, 0.0, distance


def reach_either(hill, well, by_hill, amount, most):
    """``reach`` down from the hill, or up from the well, whichever is asked for."""
    rest = hill._replace(
        stiffness=pick(by_hill, hill.stiffness, well.stiffness),
        double_cosine=pick(by_hill, hill.double_cosine, well.double_cosine),
        double_sine=pick(by_hill, hill.double_sine, well.double_sine),
    )
    return reach(rest, amount, most, pick(by_hill, -1, 1))


def beyond_clamp(piece, drop, rough):
    """How far the motion goes beyond the clamp, when the tip is ``drop`` below the one that turns there.

    V falls by the same amount on both sides. The rough value is as good as its difference to the clamp's distance
    from a hill or a well allows.
    """
    basin, rest, start = piece.basin, piece.clamp_rest, piece.clamp_offset
    high = -piece.high_depth
    amount = fall(basin.well, high - drop, drop)
    far = rough > 0.25 * abs(start)
    better = onward(rest, start, -amount, rough, far == 0)
    # Newton's method leaves a place where V is nearly level for one far away.
    return pick(far | (abs(better - rough) > 0.01), rough, better)


def far_side(piece, rise, drop, depth, done):
    """Half the width of the motion, how far it goes on beyond the clamp, and the moment where it turns."""
    basin = piece.basin
    hill, well, far, far_well = basin.hill, basin.well, basin.far, basin.far_well
    down = far.angle - far_well.angle
    if piece.low_kind == "level":
        below = fall(hill, piece.low_offset, rise)
    else:
        below = basin.far_rise + fall(hill, 0, rise)
    if basin.passes:
        # Not below the ridge, however near it is to the well behind it.
        ridge = fall(basin.axis, 0, far_well.angle - basin.axis.angle)
        above = larger(-fall(far_well, 0, down) - below, ridge)
    else:
        above = -fall(well, 0, -depth)
    by_hill = below < above
    distance = reach_either(far, far_well, by_hill, pick(by_hill, below, above), down)
    turn = pick(by_hill, down - distance, distance)  # far turning point − far_well
    # clamp − far_well
    clamp_turn = down - piece.far_gap if basin.passes else piece.clamp_gap - piece.high_depth
    left = pick(by_hill, piece.far_gap - distance, distance - clamp_turn)
    if basin.passes:
        half_width = (turn + depth + (far_well.angle - well.angle)) / 2
    else:
        half_width = (turn + depth) / 2
    far_moment = pick(by_hill, slope(far, -distance), slope(far_well, distance)) * -1
    far_moment = larger(far_moment, 4 * epsilon() * distance)
    if piece.high_kind == "turn":
        left = larger(beyond_clamp(piece, drop, left), 0)
    return half_width, left, far_moment, pick(by_hill, distance, down - distance)


def unevenness(near, far):
    """√far − √near: by the roots where they are apart, else by far − near = 2η sin 2(middle − α) sin(half_width)."""
    apart = (8 * near < far) | (8 * far < near) | (near + far < 0.0)
    return pick(apart, sqrt(far) - sqrt(near), 0.0)


def wrapped(angle):
    """The angle less whole turns, between −π and π."""
    return angle - 2 * pi * floor(angle / (2 * pi) + 0.5)


def above_field(basin, middle, half_width, height):
    """``mean`` less η where they are near each other: 2(V(tip) − V)/(cos(θ − middle) − cos(half_width)) at the θ at
    which it is least, which lies then near the ridge or the well. height: from there to the tip."""
    shift = wrapped(2 * -middle)
    offset = wrapped(middle + shift - basin.axis.angle)
    # As near the ridge as rounding it is nearer still: it is there to the second order in the height.
    offset = pick(abs(offset) < 32 * spacing(offset), 0, offset)
    outer, inner = sin(half_width / 2), sin(shift / 2)
    turn = outer * outer - inner * inner
    return (height + fall(basin.axis, 0, offset)) / pick(turn == 0, 1, turn)


def mean_less_field(basin, middle, half_width, near, far, height, mean):
    """``mean`` − η: as it stands, or by the end of the motion or the ridge or well that is near where V is nearest to
    level."""
    apart = mean
    close = apart <= 0.0
    if any_of(close):
        by_far, by_near = far, near
        known = pick(2 * by_far > far, by_far, by_near)
        far_off = close & (2 * by_far <= far) & (2 * by_near <= near)
        if any_of(far_off):
            known = pick(far_off, above_field(basin, middle, half_width, height), known)
        apart = pick(close, known, apart)
    # Over a ridge V(tip) − V is nowhere less than there; elsewhere only rounding makes it smaller than this.
    least = larger(height, epsilon() ** 19) if basin.passes else epsilon() * pick(near < far, near, far) / 4
    return larger(apart, least)


def rates(beta, basin, tip, half_width, sine, near, far, height):
    """dχ/dσ at the ends and in the middle of the motion."""
    middle, cosine = tip + half_width, cos(half_width)
    cos_middle = cos(middle)
    product = sqrt(near) * sqrt(far)
    excess = -(2 * beta * cos_middle * cosine)
    split, rate = excess < 0, sqrt(product + larger(excess, 0))
    if any_of(split):
        mean = -(2 * beta * cos_middle)
        apart = mean_less_field(basin, middle, half_width, near, far, height, mean)
        rate = pick(split, sine * sqrt(apart * mean / pick(split, product - excess, 1)), rate)
    return sqrt(product / 2), rate / 2


def motion_at(beta, piece: Piece, place):
    """The motion of the tip at a place of a piece: −∞ is its low end, +∞ its high end."""
    basin = piece.basin
    rise, drop = piece.width / (1 + exp(-place)), piece.width / (1 + exp(place))
    from_hill, depth = piece.low_offset + rise, piece.high_depth + drop
    upper = from_hill < depth
    hill, well = basin.hill, basin.well
    offset = pick(upper, from_hill, -depth)
    stiffness = pick(upper, hill.stiffness, well.stiffness)
    tip = pick(upper, hill.angle, well.angle) + offset
    near_moment = moment_from_rest(stiffness, offset)
    # How far V falls from the tip to the well, or to the level of a ridge that the motion passes.
    change = (drop + piece.level_gap if basin.passes else depth) / 2
    height = fall_from_rest(stiffness, offset + change, change)
    done = piece.clamp_gap + drop
    if basin.even:
        half_width = depth + (basin.axis.angle - well.angle)
        left = 2 * half_width - done if piece.high_kind != "turn" else drop
        far_moment, far_distance = near_moment, from_hill
    elif not basin.passes:
        half_width, left, far_moment, far_distance = parallel_side(beta, piece, rise, drop, from_hill, depth)
    else:
        half_width, left, far_moment, far_distance = far_side(piece, rise, drop, depth, done)
        # Where a hill and a well nearly meet, rounding leaves nothing, or less, of a moment.
        near_moment = larger(near_moment, 4 * epsilon() * abs(offset))
    # Where the motion is nearly a whole turn, what it lacks is told by the distances from the hills.
    whole_turn = basin.far.quarters - hill.quarters == 4 and basin.far.extra == hill.extra
    lack = (from_hill + far_distance) / 2 if whole_turn else pi - half_width
    sine = sin(pick(lack < half_width, lack, half_width))
    near, far = 2 * near_moment / sine, 2 * far_moment / sine
    uneven = 0 if basin.even else unevenness(near, far)
    # done/2 + left/2 = half_width: near half a turn one follows from the other.
    done_sine = sin(pick(done > pi, lack + left / 2, done / 2))
    left_sine = sin(pick(left > pi, lack + done / 2, left / 2))
    half_cosine = sin(lack / 2)
    end, middle = rates(beta, basin, tip, half_width, sine, near, far, height)
    return Motion(
        tip,
        half_width,
        done,
        left,
        near_moment,
        far_moment,
        near,
        far,
        end,
        middle,
        sine,
        half_cosine,
        uneven,
        done_sine,
        left_sine,
    )


def stay_at(beta, piece, ends, place):
    """The motion of the tip at a place, however deep."""
    low, high = ends
    delay = low if place < 0 else high
    depth = min(abs(place), delay.deepest)
    more = abs(place) - depth
    motion = motion_at(beta, piece, -depth if place < 0 else depth)
    return Stay(motion, more * delay.tip, more * delay.middle, more * delay.far, more * delay.arrival)


class Phase(NamedTuple):
    """Where on its half-swing the motion meets the clamp.

    The length from the tip is ∫dψ/√(a² cos²ψ + b² sin²ψ) from 0 to ψ, with a and b half of ``end`` and ``middle``; the
    half-swing ends at ψ = π/2. whole, delta: what the speed there follows from.
    """

    square: float  # sin²ψ
    rest: float  # cos²ψ
    whole: float
    delta: float


def phase_of(motion):
    """The phase of the clamp: χ by the half-angle sines, and ψ by χ."""
    near, far, end = sqrt(motion.near), sqrt(motion.far), motion.end
    done, left = motion.done_sine, motion.left_sine
    whole = phase_sum(near, far, done, left)
    gap = sin((motion.left - motion.done) / 4)
    behind, ahead = far * done / whole, near * left / whole
    lead = phase_lead(near, motion.half_cosine, motion.uneven, done, gap) / whole
    cosine = pick(abs(ahead - behind) > 0.8, ahead - behind, lead)
    # Not zero: at the tip itself the motion has no point by ℘.
    square = larger(chi_square(behind, ahead), epsilon() ** 19)
    size, first = abs(cosine), cosine >= 0
    delta = hypot(end * cosine, motion.middle * sqrt(square))
    half = pick(first, half_square(end, square, size, delta), half_square_beyond(end, size, delta))
    rest = pick(first, half_rest(end, size, delta), half_rest_beyond(end, motion.middle, square, size, delta))
    return Phase(half, rest, whole, delta)


def lengths(a, b, square, rest):
    """The complete and the incomplete integral of 1/√(a² cos²ψ + b² sin²ψ), by sin²ψ and cos²ψ.

    Gauss's transformation makes a and b equal (DLMF 19.8(i), 19.8(iii)); it is written in sums of positive terms only.
    """
    limit, more = 2 * epsilon() ** 0.5, any_of(a > 0)
    while more:
        more = any_of(abs(a - b) > limit * a)
        delta = phase_rate(a, b, square, rest)
        total, below = a + b, a + delta
        square, rest = gauss_square(square, total, below), gauss_rest(a, b, square, rest, delta, below)
        a, b = total / 2, sqrt(a * b)
    mean = (a + b) / 2
    return pi / (2 * mean), atan2(sqrt(square), sqrt(rest)) / mean


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


def sample_at(beta, piece, ends, place):
    """The sample at a place."""
    stay = stay_at(beta, piece, ends, place)
    motion = stay.motion
    phase = phase_of(motion)
    regular = swing, arrival = lengths(motion.end / 2, motion.middle / 2, phase.square, phase.rest)
    swing, arrival = swing + stay.tip + stay.middle + stay.far, arrival + stay.tip + stay.arrival
    return Sample(place, swing, arrival, stay, phase, regular)


def least_arrival(beta, piece, place):
    """A length before which no motion from a place, or from a lower one, arrives.

    θ″ is nowhere more than β + η/2, and at an offset from the hill no more than β + η times that: a motion that has
    the lesser of these two gets ahead of it.
    """
    steep, most = beta, beta
    share = 1 / (1 + exp(-max(place, -deepest(piece.width))))
    offset = piece.low_offset + piece.width * share
    clamp = piece.low_offset + piece.width + piece.clamp_gap
    bend = min(clamp, most / steep)
    arrival, speed = 0.0, 0.0
    if offset < bend:
        ratio = bend / offset
        away = sqrt((ratio - 1) * (ratio + 1))
        arrival, speed = log(ratio + away) / sqrt(steep), sqrt(steep) * away * offset
    rest = clamp - max(offset, bend)
    return arrival + (2 * rest / (speed + sqrt(speed * speed + 2 * most * rest)) if rest > 0 else 0)


def fall_between(piece, one, other):
    """How far V falls from the tip at a place to that at a higher one."""
    rise, drop = piece.width / (1 + exp(-one)), piece.width / (1 + exp(one))
    further = piece.width / (1 + exp(-other)) - rise if one < 0 else drop - piece.width / (1 + exp(other))
    from_hill, depth = piece.low_offset + rise, piece.high_depth + drop
    if from_hill < depth:
        return fall(piece.basin.hill, from_hill, further)
    return fall(piece.basin.well, -depth, further)


def grid(beta, length, piece):
    """Places to begin with: near enough where the branches bend, and to where none of them is as short as the rod."""
    rounding = -log(epsilon())
    slow = length * sqrt(beta)
    first = -2 * slow - 6 if piece.low_kind == "level" else -slow - 6
    first = min(first, -rounding) if piece.low_kind == "level" else first
    if piece.high_kind == "level":
        last = 2 * slow + rounding
    elif piece.high_kind == "turn":
        last = 2 * rounding
    elif piece.high_depth == 0:
        last = rounding
    else:
        # The tip of a stiff rod departs from the clamp angle by half the moment there times the length squared.
        moment = abs(slope(piece.clamp_rest, piece.clamp_offset)) + epsilon() ** 20
        last = max(rounding, 4 + log(2 * piece.width) - log(moment) - 2 * log(length))
        last = min(last, 2 * deepest(piece.width))
    inner = [0.0]
    for side, end in ((-1, -first), (1, last)):
        inner += [side * place for place in (1.25, 2.5, 5.0, 10.0) if place < end]
        inner.append(side * end)
    return sorted(inner)


def places(beta, length, piece):
    """Places to begin with, closer around the level at which the motion meets a ridge that is not quite there."""
    found, basin = grid(beta, length, piece), piece.basin
    if basin.even or basin.passes or piece.low_kind == "level" or basin.far.quarters - basin.hill.quarters != 4:
        return found
    cusp = pi
    # How far η is below the value at which the ridge would appear.
    missing = max(0.0, epsilon())
    cusp = 2 * pi - cusp
    down = basin.well.angle - basin.hill.angle
    rise = reach(basin.hill, fall(basin.hill, 0, cusp - basin.hill.angle), down, 1)
    if missing > 0.3 or not 0 < rise < piece.width:
        return found
    middle = log(rise / (piece.width - rise))
    # The range of tips that it slows down shrinks with the power 3/2.
    steps = [0.25**k for k in range(ceil(1.1 * log(1 / missing)) + 3)]
    around = [middle, *(middle - step for step in steps), *(middle + step for step in steps)]
    return sorted([*found, *(place for place in around if found[0] < place < found[-1])])


def arrives_convexly(piece):
    """Whether the first arrival is a convex function of the energy V(tip): see docs/solver.md."""
    basin = piece.basin
    known = basin.even or basin.far_rise == 0
    return known and piece.clamp_gap > piece.high_depth


def convex_bound(found, gap, fallen):
    """What a convex arrival is nowhere less than in a gap between samples: the chords beside it, carried on."""
    one, other = found[gap], found[gap + 1]
    width, bound = fallen(one, other), -inf
    for near, far in ((gap, gap - 1), (gap + 1, gap + 2)):
        if 0 <= far < len(found):
            beside = fallen(found[min(near, far)], found[max(near, far)])
            if beside > 0:
                steep = (found[far].arrival - found[near].arrival) / beside
                bound = max(bound, found[near].arrival - max(steep * width, 0))
    return bound


def open_gap(found, fallen, length):
    """The wider gap beside the least sample in which a convex arrival may be no longer than the length, or None."""
    least = min(range(len(found)), key=lambda k: found[k].arrival)
    best, widest = None, 2 * sqrt(epsilon()) * (1 + abs(found[least].place))
    for gap in (least - 1, least):
        if 0 <= gap < len(found) - 1:
            width = found[gap + 1].place - found[gap].place
            if width > widest and convex_bound(found, gap, fallen) <= (1 + SAFE) * length:
                best, widest = gap, width
    return best


def inner(places, one, other, always):
    """The middle one of the places between two samples; where there is none, half way if ``always``, else None."""
    inside = [place for place in places if one.place < place < other.place]
    if inside:
        return inside[len(inside) // 2]
    return (one.place + other.place) / 2 if always else None


def valley(sample, places, fallen, length):
    """Samples on both sides of every crossing of a length that is shorter than a half-swing, for a convex arrival.

    Without a crossing there may be none. fallen(one, other): how far V falls from the tip of a sample to the next.
    """
    found = [sample(place) for place in sorted({places[0], places[len(places) // 2], places[-1]})]
    while min(item.arrival for item in found) > length:
        gap = open_gap(found, fallen, length)
        if gap is None:
            return []
        found.insert(gap + 1, sample(inner(places, found[gap], found[gap + 1], True)))
    done, todo = [found[0]], found[:0:-1]
    while todo:
        crossed = (done[-1].arrival > length) != (todo[-1].arrival > length)
        place = inner(places, done[-1], todo[-1], False) if crossed else None
        if place is None:
            done.append(todo.pop())
        else:
            todo.append(sample(place))
    return done


def bends(first, second, third, length):
    """Whether the curves bend so much at the second sample that a count may reach a whole number unseen beside it.

    By how far the straight line through two samples misses the third.
    """
    share = (third.place - second.place) / (second.place - first.place)
    swing = third.swing - second.swing - share * (second.swing - first.swing)
    arrival = third.arrival - second.arrival - share * (second.arrival - first.arrival)
    least = min(first.swing, second.swing, third.swing)
    reach = (abs(arrival) + (length / least * abs(swing) if length > least else 0)) / (2 * least)
    for sign in (1, -1):
        for item in (first, second, third):
            count = (length - sign * item.arrival) / (2 * item.swing)
            whole = floor(count + 0.5)
            if abs(count - whole) < reach and (whole > 0 or (whole == 0 and sign > 0)):
                return True
    return False


def refined(sample, samples, length):
    """More samples where half-swing or arrival bend between neighbours, as far as the rod's length is sensitive."""
    done, todo = [samples[0]], samples[:0:-1]
    while todo:
        before, after = done[-1], todo[-1]
        apart = after.place - before.place > 1.3
        beside = [(done[-2], before, after)] if len(done) > 1 else []
        beside += [(before, after, todo[-2])] if len(todo) > 1 else []
        if apart and any(bends(one, two, three, length) for one, two, three in beside):
            todo.append(sample((before.place + after.place) / 2))
        else:
            done.append(todo.pop())
    return done


def falls(one, other):
    """Whether no branch is longer at the second one."""
    less, apart = one.swing - other.swing, one.arrival - other.arrival
    return apart >= 0 and 2 * less >= apart


def sampled(sample, places, first, soon):
    """Samples from the first place on to one from which the motion arrives soon.

    Nothing before and after is as long as the rod. One more is taken where the branches do not fall from there, or to
    there.
    """
    found = [sample(place) for place in places[first : first + 2]]
    for place in places[first + 2 :]:
        if found[-1].arrival < soon and found[-1].arrival < found[-2].arrival:
            break
        found.append(sample(place))
    while first > 0 and not falls(*found[:2]):
        first -= 1
        found.insert(0, sample(places[first]))
    return found


def end_sample(piece, last):
    """The high end itself, where its times are known: arrival at once, or after the whole half-swing."""
    if piece.high_kind == "clamp" and piece.clamp_gap == 0 and piece.high_depth > 0:
        return last._replace(place=last.place + 1e3, arrival=0 * last.swing)
    if piece.high_kind == "turn":
        return last._replace(place=last.place + 1e3, arrival=last.swing)
    return None


def samples_on(beta, length, piece, sample, short):
    """Samples of a piece, near enough for all crossings; short: the rod is shorter than any half-swing."""

    def too_low(place):
        return least_arrival(beta, piece, place) > (1 + SAFE) * length

    def fallen(one, other):
        return fall_between(piece, one.place, other.place)

    if too_low(inf):
        return []
    wanted = places(beta, length, piece)
    first = 0
    while first + 2 < len(wanted) and too_low(wanted[first + 1]):
        first += 1
    if short and arrives_convexly(piece):
        return valley(sample, wanted[first:], fallen, length)
    # A motion that arrives before the stiffest pendulum is down arrives the sooner, the nearer its tip (Sturm).
    quarter = pi / 2 / sqrt(beta)
    soon = (1 - SAFE) * min(quarter, length) if short and piece.high_kind == "clamp" else 0
    samples = refined(sample, sampled(sample, wanted, first, soon), length)
    end = end_sample(piece, samples[-1])
    return samples if end is None else [*samples, end]


def between(samples, counts, k):
    """The whole numbers from the lower count of a sample and that before it up to, but not at, the higher one."""
    low, high = (counts[k - 1], counts[k]) if counts[k - 1] < counts[k] else (counts[k], counts[k - 1])
    turns = range(max(ceil(low), 0), max(ceil(high), 0))
    if not turns:
        return []
    beside = samples[k - 2] if k > 1 else samples[-1] if len(samples) == k + 1 else samples[k + 1]
    return [(number, samples[k - 1], samples[k], beside) for number in turns]


def dip(sample, short, left, middle, right):
    """The sample at which ``short`` is least between left and right by golden sections, or the first below zero."""
    golden = (3 - sqrt(5)) / 2
    value = short(middle)
    while right.place - left.place > 2 * sqrt(epsilon()) * (1 + abs(middle.place)):
        wide = right.place - middle.place > middle.place - left.place
        end = right if wide else left
        trial = sample(middle.place + golden * (end.place - middle.place))
        new = short(trial)
        if new < 0:
            return trial
        if new < value:
            left, right = (middle, right) if wide else (left, middle)
            middle, value = trial, new
        elif wide:
            right = trial
        else:
            left = trial
    return middle


def at_extremum(sample, triple, counts, length, sign):
    """The two crossings beside an extremum of the count that reaches beyond a whole number its samples do not reach."""
    left, middle, right = triple
    before, here, after = counts
    top = here > before
    # The slope on either side, carried on over the other one, bounds an extremum of a curve that bends one way.
    share = (right.place - middle.place) / (middle.place - left.place)
    reachable = here + (1 if top else -1) * max(abs(before - here) * share, abs(after - here) / share)
    goal = ceil(here) if top else floor(here)
    if (top and (goal > reachable or here == goal)) or (not top and goal < reachable) or goal < 0:
        return []

    def short(item):
        count = (length - sign * item.arrival) / (2 * item.swing)
        return goal - count if top else count - goal

    best = dip(sample, short, left, middle, right)
    if short(best) >= 0:
        return []
    return [(goal, left, best, right), (goal, best, right, left)]


def brackets(sample, samples, counts, length, sign):
    """(turns, sample, sample, a third) for every whole number that the count crosses between the two samples."""
    found = []
    for k in range(1, len(samples)):
        found += between(samples, counts, k)
    for k in range(1, len(samples) - 1):
        before, here, after = counts[k - 1 : k + 2]
        if (before - here) * (after - here) > 0:
            found += at_extremum(sample, samples[k - 1 : k + 2], (before, here, after), length, sign)
    return found


def excess(item, turns, sign, length):
    """The length of a branch less the rod's."""
    return (2 * turns * item.swing if turns else 0) + sign * item.arrival - length


def interpolated(a, b, c, value_a, value_b, value_c):
    """Where on the way from a to b inverse quadratic interpolation puts the zero, or half way where it is unsafe."""
    if value_c in (value_a, value_b):
        return 0.5
    x, y = (a - b) / (c - b), (value_a - value_b) / (value_c - value_b)
    if x <= 0 or y * y >= x or (1 - y) * (1 - y) >= 1 - x:
        return 0.5
    share = value_a / (value_b - value_a) * value_c / (value_b - value_c)
    share = share + (c - a) / (b - a) * value_a / (value_c - value_a) * value_b / (value_c - value_b)
    return share if 0 < share < 1 else 0.5


def bracketed_root(function, places, values, blur):
    """A sign change of the function between the first two places, to rounding, by Chandrupatla's method (1997).

    If there is a third place, it has a value, too. blur: a value that rounding may have made of zero.
    """
    (a, b, *third), (value_a, value_b, *value_third) = places, values
    fraction = interpolated(a, b, third[0], value_a, value_b, value_third[0]) if third else 0.5
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
        if least > 0.5 or abs(value_best) <= blur:
            return best
        fraction = min(1 - least, max(least, interpolated(a, b, c, value_a, value_b, value_c)))


class Crossing(NamedTuple):
    """A tip whose rod has the right length, on branch 2·turns·H + sign·t; ``rising``: the branch grows with the tip."""

    sample: Sample
    turns: int
    sign: int
    rising: bool


def crossing(sample, turns, sign, length, before, after, beside):
    """The crossing between two samples on either side of it; a third one beside them helps to start."""
    seen = {}

    def function(place):
        seen[place] = sample(place)
        return excess(seen[place], turns, sign, length)

    known = (before, after, beside)
    values = [excess(item, turns, sign, length) for item in known]
    place = bracketed_root(function, [item.place for item in known], values, epsilon() * length)
    return Crossing(seen.get(place) or sample(place), turns, sign, values[1] > values[0])


def crossings(beta, length, piece, most):
    """Every crossing of the rod's length on a piece whose index can be at most ``most``, as a list of Crossing."""
    ends = delays(piece)

    def sample(place):
        return sample_at(beta, piece, ends, place)

    # No half-swing is shorter than that of the stiffest pendulum.
    short = length * sqrt(beta) < pi
    samples = samples_on(beta, length, piece, sample, short)
    found = []
    for sign in (1,) if short else (1, -1):
        counts = [(length - sign * item.arrival) / (2 * item.swing) for item in samples]
        for turns, before, after, beside in brackets(sample, samples, counts, length, sign):
            # At least 2·turns − 1 conjugate points, or one more on the branch that has gone on.
            if (turns or sign > 0) and 2 * turns - (sign < 0) <= most:
                found.append(crossing(sample, turns, sign, length, before, after, beside))
    return found


def index_of(crossing):
    """Number of conjugate points of the free end on the rod (Sturm: one in each half-swing, and a last one or none).

    h = ∂θ/∂θ_ℓ solves the second variation with h = 1, h′ = 0 at the tip; θ′ solves it too and vanishes once a
    half-swing, so h vanishes once in each. Whether it has vanished in the last, unfinished one is told by the sign
    of h at the clamp, which is against that of dθ/dσ times the slope of the branch.
    """
    swings = 2 * crossing.turns - (1 if crossing.sign < 0 else 0)
    positive = crossing.rising != (crossing.sign > 0)
    return swings if positive == (swings % 2 == 0) else swings + 1


def rj_pair(x, product, root_sum, p, lift, less, twist):
    """R_J(x, y, z, p) by duplication, for x ≥ 0, complex p, and y and z by √y√z and √y + √z.

    lift, less, twist: p + √y√z, p − x and (p − x)(p − y)(p − z), which the rod gives without cancellation. Sums of
    positive terms only in x, y, z. Where √p and −√y are near each other, their sum follows from their difference.
    """
    pair = root_sum * root_sum - 2 * product
    mean = start = (x + pair + 2 * p) / 5
    one, two = start - x, 2 * start - pair
    both = start * start - start * pair + product * product
    reach = abs(one) + abs(start - p) + sqrt(abs(both))
    target = (epsilon() / 4) ** 0.125
    scale, total = 1, 0
    while any_of(reach > target * scale * abs(mean)):
        root, root_p = sqrt(x), complex_sqrt(p)
        side, across = root_p * root_sum, root * root_sum
        plus, minus = lift + side, lift - side
        cancels = (abs(plus) < abs(minus)) & (scale == 1)
        d = (root_p + root) * pick(cancels, twist / (less * pick(cancels, minus, 1)), plus)
        raised, lifted = lift + across, sqrt(x + product + across)
        end = 2 * root_p * raised / d
        total = total + arctan_share(twist / (scale * scale * scale * d * d), end) / (scale * d)
        pair = root_sum * (root_sum + 2 * root) / 4
        x, p = (x + product + across) / 4, raised / 4
        product, root_sum = root_sum * lifted / 4, sqrt(root_sum * (root_sum + 2 * root + 2 * lifted)) / 2
        lift, mean = p + product, (x + pair + 2 * p) / 5
        scale *= 4
    size = scale * mean
    a, b, c = one / size, two / size, both / (size * size)
    d = -(a + b) / 2
    e2 = a * b + c - 3 * d * d
    e3 = a * c + 2 * e2 * d + 4 * d * d * d
    e4 = (2 * a * c + e2 * d + 3 * d * d * d) * d
    e5 = a * c * d * d
    low = -3 * e2 / 14 + e3 / 6 + 9 * e2 * e2 / 88 - 3 * e4 / 22 - 9 * e2 * e3 / 52 + 3 * e5 / 26
    high = -e2 * e2 * e2 / 16 + 3 * e3 * e3 / 40 + 3 * e2 * e4 / 20 + 45 * e2 * e2 * e3 / 272
    high = high - 9 * (e3 * e4 + e2 * e5) / 68
    return (1 + low + high) / (scale * mean * complex_sqrt(mean)) + 6 * total


def shift(double_sine, double_cosine, motion, point, root, square, rest):
    """W as real and imaginary part: ∫e^{iθ} from the tip is e^{iφ}(σ + W)."""
    b, near, far = point.strength, sqrt(motion.near), sqrt(motion.far)
    twist = complex_of(0.0, 0.0)
    lift = pair_lift(near, far, motion.uneven, motion.half_cosine, square, rest)
    pole, lifted, less = complex_of(point.pole, -b), complex_of(lift, -b), complex_of(root, -b)
    third = rj_pair(point.one, point.product, point.root_sum, pole, lifted, less, twist)
    return w_real(b, third.imag), w_imag(b, third.real)


def kink_at(first, second, point, root, q, m, square, rest):
    """The part of η∫cos²(θ − α) without integral; towards the tip its terms are large and cancel in the first form."""
    b, x, product = point.strength, point.pole, point.product
    delta = larger(phase_rate(first, second, square, rest), second * sqrt(square))
    across, near_root = sqrt(square * rest), sqrt(point.one)
    others = others_sum(q, root)
    gap = pole_gap(x, abs(x), others, others_product(b, m, root, others), product)
    far = arc_kink(square, delta, across, b, x, near_root, product)
    return pick(x > 1, arc_kink_tip(first, second, delta, across, b, x, near_root, gap), far)


def second_kind(a, b, square, rest, arrival):
    """(b² − a²)∫sin²ψ over the same range as ``arrival``, the length, by the same transformation (DLMF 19.8.19)."""
    limit, more, weight, growth = 2 * epsilon() ** 0.5, any_of(a > 0), 1, 0
    while more:
        more = any_of(abs(a - b) > limit * a)
        delta = phase_rate(a, b, square, rest)
        growth = growth - weight * second_kind_step(a, b, square, rest, delta, arrival)
        total, below = a + b, a + delta
        square, rest = gauss_square(square, total, below), gauss_rest(a, b, square, rest, delta, below)
        a, b, weight = total / 2, sqrt(a * b), 2 * weight
    return growth


def arc_to(beta, motion, point, square, rest, extent):
    """The arc from the tip to a point, at ψ, of the given length."""
    sine, cosine, lean = sin(motion.tip), cos(motion.tip), motion.tip
    double_sine, double_cosine = sin(2 * lean), cos(2 * lean)
    root = far_root(motion.near, cos(motion.half_width))
    w_re, w_im = shift(double_sine, double_cosine, motion, point, root, square, rest)
    y, z = arc_y(sine, cosine, extent, w_re, w_im), arc_z(sine, cosine, extent, w_re, w_im)
    first, second = motion.end / 2, motion.middle / 2
    q, m = rest_stiffness(beta, cosine), tip_cubic(beta, sine)
    kink = kink_at(first, second, point, root, q, m, square, rest)
    growth = second_kind(first, second, square, rest, extent)
    return Arc(y, z, arc_square(beta, cosine, first, root, extent, y, kink, growth))


class Point(NamedTuple):
    """A point of a motion by ℘ − c = x and ℘ − e at its three half-period values.

    one: ℘ − e₁, with e₁ that of the far turning point. product, root_sum: √(℘ − e₂)√(℘ − e₃) and √(℘ − e₂) + √(℘ − e₃),
    real also where e₂ and e₃ are a complex pair.
    """

    strength: float  # b
    pole: float  # x
    one: float
    product: float
    root_sum: float


def far_point(motion):
    """The far turning point."""
    b = strength(motion.near_moment)
    pole = point_pole(b, motion.sine, cos(motion.half_width))
    return Point(b, pole, 0, far_pair_root(motion.end), motion.middle)


def with_stays(arc, stay, middle, far, basin):
    """An arc with the straight lengths along the directions at which the motion nearly rests."""
    y, z, square = arc
    for angle, extent in ((stay.motion.tip, stay.tip), (basin.axis.angle, middle), (basin.far.angle, far)):
        y, z, square = y + extent * cos(angle), z + extent * sin(angle), square
    return Arc(y, z, square)


def clamp_point(motion, phase):
    """The point where the motion meets the clamp."""
    b, done = strength(motion.near_moment), motion.done_sine
    one = point_near(b, motion.sine, done, motion.left_sine)
    product = pair_root(sqrt(motion.near), done, phase.whole, phase.delta / motion.end)
    delta = phase_rate(motion.end / 2, motion.middle / 2, phase.square, phase.rest)
    # 2Δ/sin ψ is no less than ``middle``, the square of which may underflow.
    root_sum = larger(pair_root_sum(phase.square, delta), motion.middle)
    return Point(b, point_pole(b, done, cos(motion.done / 2)), one, product, root_sum)


def bent_rod(rod, turns, piece, crossing, index):
    """The equilibrium of a tip on its branch."""
    beta, length = rod.beta, rod.length
    stay, phase, (swing, arrival) = crossing.sample.stay, crossing.sample.phase, crossing.sample.regular
    motion, basin = stay.motion, piece.basin
    whole = Arc(0, 0, 0)  # not asked for within the first half-swing
    if crossing.turns:
        whole = arc_to(beta, motion, far_point(motion), 1, 0, swing)
        whole = with_stays(whole, stay, stay.middle, stay.far, basin)
    part = arc_to(beta, motion, clamp_point(motion, phase), phase.square, phase.rest, arrival)
    part = with_stays(part, stay, stay.arrival, 0, basin)
    both, sign = 2 * crossing.turns, crossing.sign
    y, z, square = (float(both * a + sign * b) for a, b in zip(whole, part, strict=True))
    speed = phase.delta * phase.whole / (motion.end * motion.sine)
    speed = speed * sqrt(2 * motion.done_sine * motion.left_sine)
    gamma = 2 * beta * cos(motion.tip)
    energy = gamma * length / 2 - 2 * beta * y - square
    scale = rod.scale
    first = arrival + stay.tip + stay.arrival
    # The length of the rod is better known than that of a half-swing.
    half_swing = (length - sign * first) / both if both else swing + stay.tip + stay.middle + stay.far
    return Equilibrium(
        rod.side * (motion.tip + 2 * pi * turns),
        -rod.side * sign * ldexp(speed, scale),
        ldexp(gamma, 2 * scale),
        ldexp(y, -scale),
        rod.side * ldexp(z, -scale),
        ldexp(energy, scale),
        index,
        rod,
        Swing(
            stay,
            turns,
            half_swing,
            whole,
            basin.axis.angle,
            basin.far.angle,
            both if sign > 0 else both - 1,
            first,
            arrival,
            phase.square,
            phase.rest,
        ),
    )


def below(rod, scene, clamp, most):
    """The equilibria with tips below the clamp angle, from the lowest up; tips may be nearer than rounding."""
    beta = rod.beta
    found = []
    for piece in pieces(beta, scene, clamp):
        if not piece.width > 0:  # the clamp angle is at the level of the ridge, to rounding
            continue
        here = crossings(beta, rod.length, piece, most)
        for crossing in sorted(here, key=lambda item: item.sample.place):
            index = index_of(crossing)
            if index <= most:
                found.append(bent_rod(rod, clamp.turns, piece, crossing, index))
    return found


def in_order(found):
    """The list with tips that are nearer than rounding given as equal, where rounding would exchange them."""
    for k in range(1, len(found)):
        if found[k].tip_angle < found[k - 1].tip_angle:
            found[k] = replace(found[k], tip_angle=found[k - 1].tip_angle)
    return found


def direction(rest):
    """cos and sin of a direction, exact for whole quarter turns."""
    cosine, sine = cos(rest.extra), sin(rest.extra)
    for _ in range(rest.quarters % 4):
        cosine, sine = -sine, cosine
    return cosine, sine


def length_of(rod):
    """The length of a rod in the user's units."""
    return ldexp(rod.length, -rod.scale)


def straight_rod(rod, rest):
    """The rod that stays straight, for its clamp angle is a direction without moment."""
    cosine, sine = direction(rest)
    gamma = 2 * rod.beta * cosine
    soft = -rest.stiffness
    index = floor(rod.length * sqrt(soft) / pi + 0.5) if soft > 0 else 0
    energy = -(rod.beta * cosine) * rod.length
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


def straight(rod, scene, clamp, most):
    """The straight equilibrium, if the clamp angle is a direction without moment."""
    found = [straight_rod(rod, rest) for rest, offset in zip(scene.rests, clamp.offsets, strict=True) if offset == 0]
    return [item for item in found if item.index <= most]


def all_equilibria(beta, length, clamp_angle, max_index):
    """Every equilibrium, sorted by tip angle: from the tips below the clamp angle, above it, and the straight rod."""
    if length * sqrt(beta) <= epsilon():
        return [weak_rod(beta, length, clamp_angle)]
    most = inf if max_index is None else max_index
    scale = frexp(beta)[1] // 2
    rod = Rod(ldexp(beta, -2 * scale), ldexp(length, scale), clamp_angle, 1, scale)
    mirrored = Rod(rod.beta, rod.length, -clamp_angle, -1, scale)
    scene, other = landscapes(rod.beta)
    clamp = clamp_in(scene.rests, rod.clamp_angle)
    above = below(mirrored, other, clamp_in(other.rests, mirrored.clamp_angle), most)
    return in_order([*below(rod, scene, clamp, most), *straight(rod, scene, clamp, most), *above[::-1]])


def integer(name: str, value: Any) -> int:
    """An integer that is no truth value, or an error that names the argument."""
    try:
        number = None if isinstance(value, bool) else index(value)
    except TypeError:
        number = None
    if number is None:
        raise TypeError(f"{name} must be None or an integer, got {value!r}")
    return number


def index_limit(max_index):
    """The largest index of equilibria that are wanted: None for no limit, or an integer ≥ 0."""
    if max_index is None:
        return None
    limit = integer("max_index", max_index)
    if limit < 0:
        raise ValueError(f"max_index must not be negative, got {max_index!r}")
    return limit


class Station(NamedTuple):
    """A point of the rod on its half-swing: lengths from the tip and from the far turning point.

    whole: half-swings between the tip and the one it lies on, which is run through backwards where that is odd.
    beside: the length from the clamp; away: 1 where the motion from the tip is beyond the clamp there, −1 where it is
    before it, 0 where a turning point lies between.
    """

    whole: int
    from_tip: float
    from_far: float
    beside: float
    away: int


def station_at(swing, whole, from_tip, length, beside, away):
    """The station at a length from the tip, or from the far turning point."""
    other = swing.length - length
    near, far = (length, other) if from_tip else (other, length)
    return Station(whole, near, far, beside, away)


def station_of(rod, swing, s):
    """The point at a length from the clamp, measured from the nearer end of the rod.

    The last digit of a long rod's length is many digits of θ where it bends beside the clamp.
    """
    towards_tip = swing.whole % 2 == 0
    ahead = swing.arrival if towards_tip else swing.length - swing.arrival
    if s < 0 or 2 * s >= rod.length:  # series of bins begin before the clamp
        whole = floor((rod.length - s) / swing.length)
        return station_at(swing, whole, whole % 2 == 0, rod.length - s - whole * swing.length, s, 0)
    if s <= ahead:
        return station_at(swing, swing.whole, towards_tip, ahead - s, s, -1 if towards_tip else 1)
    turned = floor((s - ahead) / swing.length)
    over = s - ahead - turned * swing.length
    return station_at(swing, swing.whole - 1 - turned, towards_tip == (turned % 2 == 0), over, s, 0)


def parts(length, stay, regular, middle_stay):
    """A length from a turning point: straight there, of the motion itself, straight in its middle, and the rest.

    Where the motion stays near its tip, its middle or its far turning point, the rod is straight.
    """
    first = min(length, stay)
    rest = length - first
    before = min(rest, regular / 2) if middle_stay > 0 else min(rest, regular)
    middle = min(rest - before, middle_stay)
    here = min(before + max(rest - before - middle, 0), regular)
    return first, here, middle, max(rest - middle - here, 0)


def next_to_clamp(swing, station, here, left):
    """Whether a point is nearer to the clamp than to the turning point ahead, with nothing straight between."""
    stay = swing.stay
    if station.away == 0 or station.beside > (left if station.away > 0 else here):
        return False
    middle = (here + left) / 2
    same_half = (swing.regular - middle) * (here - middle) > 0 and stay.arrival in (0, stay.middle)
    return stay.middle == 0 or same_half


def phase_before(a, b, square, rest, by):
    """sin²ψ and cos²ψ at a length before a known phase; by: those at the length itself."""
    by_square, by_rest = by
    delta, by_delta = phase_rate(a, b, square, rest), phase_rate(a, b, by_square, by_rest)
    fall = square - by_square if square < rest else by_rest - rest
    over = before_over(a, square, rest, by_delta)
    sine = before_sine(a, square, rest, delta, by_square, by_rest, by_delta, fall)
    cosine = before_cosine(a, square, rest, delta, by_square, by_rest, by_delta, over)
    return sine * sine, cosine * cosine


def phase_at(a, b, length, left):
    """sin²ψ and cos²ψ at lengths from the tip and from the half-swing's end: the transformation undone."""
    limit = 2 * epsilon() ** 0.5
    steps = [(a, b)]
    while any_of(abs(a - b) > limit * a):
        a, b = (a + b) / 2, sqrt(a * b)
        steps.append((a, b))
    a, b = (a + b) / 2, sqrt(a * b)
    first = length <= left
    small = sin((a + b) / 2 * pick(first, length, left))
    small = small * small
    square, rest = pick(first, small, 1 - small), pick(first, 1 - small, small)
    for a, b in reversed(steps):
        gap = a - b
        below = pick(gap > 0, back_below(a, b, square), back_below_rest(a, b, rest))
        square, rest = back_square(a, square, below), back_rest(a, b, gap, rest, below)
        # The larger one is told best by the smaller one, and its rounding would double in each step.
        square, rest = pick(rest < square, 1 - rest, square), pick(rest < square, rest, 1 - square)
    return square, rest


def phase_beside(a, b, square, rest, station, whole):
    """sin²ψ and cos²ψ of a point beside the clamp by those of the clamp; whole: the length of the half-swing."""
    length, back = station.beside, whole - station.beside
    if station.away < 0:
        return phase_before(a, b, square, rest, phase_at(a, b, length, back))
    # Seen from the far turning point.
    square, rest = phase_before(b, a, rest, square, phase_at(b, a, length, back))
    return rest, square


def point_at(motion, square, rest):
    """The point at ψ by sin²ψ and cos²ψ, and half the angle from the tip to it with its sine, by cos χ."""
    a, b, near, far = motion.end / 2, motion.middle / 2, sqrt(motion.near), sqrt(motion.far)
    flat = (b / a) * (b / a) * square
    scale = chi_scale(square, rest, flat)
    versine, coversine = chi_versine(square, rest, flat, scale), chi_coversine(rest, scale)
    level = turn_level(near, far, versine, coversine)
    # The difference of the roots where they are near each other, else that of the terms themselves.
    alike = turn_tilt(near, far, motion.uneven, chi_cosine(square, rest, flat, scale))
    apart = turn_tilt_apart(near, far, versine, coversine)
    tilt = pick(abs(motion.uneven) < 0.1 * (near + far), alike, apart)
    sine, cosine = sin(motion.half_width / 2), motion.half_cosine
    over, under = turn_over(near, sine, cosine, versine), turn_under(sine, cosine, level, tilt)
    left_over, left_under = turn_over(far, sine, cosine, coversine), turn_under(sine, cosine, level, -tilt)
    done = unit_sine(over, under)
    whole = phase_sum(near, far, done, unit_sine(left_over, left_under))
    delta, strong = phase_rate(a, b, square, rest), strength(motion.near_moment)
    point = Point(
        strong,
        point_pole(strong, over, under),
        near_by_phase(square, rest, a * a / delta),
        pair_root(near, done, whole, chi_rate(square, rest, flat, scale)),
        pair_root_sum(square, delta),
    )
    return point, atan2(over, under), done


def regular_part(rod, swing, station, here, left):
    """θ, dθ/dσ and the arc by the motion alone, at its lengths from the tip and from the far turning point."""
    motion = swing.stay.motion
    if here <= epsilon() * left:  # where the square of the phase may underflow
        return motion.tip, 0 * here, Arc(0, 0, 0)
    a, b = motion.end / 2, motion.middle / 2
    if next_to_clamp(swing, station, here, left):
        square, rest = phase_beside(a, b, swing.square, swing.rest, station, here + left)
    else:
        square, rest = phase_at(a, b, here, left)
    point, half, low = point_at(motion, square, rest)
    arc = arc_to(rod.beta, motion, point, square, rest, here)
    speed = point_speed(point.strength, low, point.one, point.product)
    return motion.tip + 2 * half, speed, arc


def on_swing(rod, swing, station):
    """θ, dθ/dσ and the arc from the tip at a point of the first half-swing."""
    stay, motion = swing.stay, swing.stay.motion
    regular = swing.length - stay.tip - stay.middle - stay.far
    tip, here, middle, far = parts(station.from_tip, stay.tip, regular, stay.middle)
    _, left, _, _ = parts(station.from_far, stay.far, regular, stay.middle)
    angle, speed, arc = regular_part(rod, swing, station, here, left)
    for straight, extent in ((motion.tip, tip), (swing.middle_angle, middle), (swing.far_angle, far)):
        if extent > 0:
            arc = Arc(arc.y + extent * cos(straight), arc.z + extent * sin(straight), arc.square)
    return angle, speed, arc


def angle_and_position(equilibrium, s):
    """θ, θ′, y and z at an arc length s from the clamp."""
    rod, swing = equilibrium.rod, equilibrium.swing
    if swing is None:
        length = ldexp(rod.length, -rod.scale)
        share, left, bend = s / length, length - s, equilibrium.clamp_curvature
        angle = equilibrium.tip_angle - bend * left * (left / length) / 2
        return angle, bend * (left / length), equilibrium.y * share, equilibrium.z * share
    station = station_of(rod, swing, ldexp(s, rod.scale))
    back = station.whole % 2 == 1
    angle, speed, arc = on_swing(rod, swing, station)
    times = station.whole + 1 if back else station.whole
    sign = -1 if back else 1
    y = equilibrium.y - ldexp(times * swing.arc.y + sign * arc.y, -rod.scale)
    z = equilibrium.z - rod.side * ldexp(times * swing.arc.z + sign * arc.z, -rod.scale)
    return rod.side * (angle + 2 * pi * swing.turns), -rod.side * sign * ldexp(speed, rod.scale), y, z


def period_of(equilibrium):
    """The period of θ in the length from the tip, and what y + iz changes by over it; 0 where the rod is shorter."""
    rod, swing = equilibrium.rod, equilibrium.swing
    if rod.length <= 2 * swing.length:
        return 0.0, 0.0
    return 2 * swing.length, -2 * ldexp(1.0, -rod.scale) * complex(swing.arc.y, rod.side * swing.arc.z)


def angle_and_slope(rod, swing, length):
    """θ and its slope at a length from the tip; they cost much less than y and z."""
    stay, motion = swing.stay, swing.stay.motion
    count = floor(length / swing.length)
    within, sign = length - count * swing.length, rod.side
    if count % 2:
        within, sign = swing.length - within, -rod.side
    regular = swing.length - stay.tip - stay.middle - stay.far
    moving = within - min(within, stay.tip)
    before = min(moving, regular / 2 if stay.middle > 0 else regular)
    here = min(before + max(moving - before - stay.middle, 0), regular)
    if here <= 0:
        return rod.side * (motion.tip + 2 * np.pi * swing.turns), 0.0
    square, rest = phase_at(motion.end / 2, motion.middle / 2, here, regular - here)
    point, half, _ = point_at(motion, square, rest)
    cotangent = point.pole / point.strength
    slope = 4 * sqrt(point.one) * point.product / (point.strength * (1 + cotangent * cotangent))
    return rod.side * (motion.tip + 2 * half + 2 * np.pi * swing.turns), sign * slope


class State(NamedTuple):
    """What the series of a bin starts from: angle, its slope by the length from the tip, and y + iz."""

    angle: Any
    slope: Any
    place: Any


def state_of(equilibrium, length, position):
    """The state at a length from the tip."""
    rod = equilibrium.rod
    angle, slope = angle_and_slope(rod, equilibrium.swing, length)
    if not position:
        return State(angle, slope, 0)
    _, _, y, z = angle_and_position(equilibrium, ldexp(rod.length - length, -rod.scale))
    return State(angle, slope, complex(y, z))


def straight_ranges(state_at, count, turn):
    """Ranges of bins at whose ends, and at turning points within, θ is the same to rounding: between them it is
    monotone, therefore constant."""
    ranges, todo = [], [(0, count)]
    while todo:
        low, high = todo.pop()
        angles = [state_at(bins).angle for bins in (low, turn, 2 * turn, high) if low <= bins <= high]
        if max(angles) - min(angles) <= 2.0**-53 * max(1.0, abs(angles[0])):
            ranges.append((low, high))
        elif high - low > COARSE:
            todo += [(low, (low + high) // 2), ((low + high) // 2, high)]
    return ranges


def states(equilibrium, width, count, position):
    """The states in the middles of the bins, and which bins are straight: between the ends of straight ranges θ is
    constant, to rounding, and the place is linear."""
    known = {}

    def state_at(bins):
        if bins not in known:
            known[bins] = state_of(equilibrium, bins * width, position)
        return known[bins]

    middles = np.arange(count) + 0.5
    straight = np.zeros(count, dtype=bool)
    angle, slope, place = np.empty(count), np.zeros(count), np.empty(count, dtype=complex)
    for low, high in straight_ranges(state_at, count, equilibrium.swing.length / width) if count > SHORT else []:
        first, last, inside = state_at(low), state_at(high), slice(low, high)
        share = (middles[inside] - low) / (high - low)
        straight[inside], angle[inside] = True, (first.angle + last.angle) / 2
        place[inside] = first.place + share * (last.place - first.place)
    for bins in np.flatnonzero(~straight).tolist():
        angle[bins], slope[bins], place[bins] = state_at(bins + 0.5)
    return State(angle, slope, place), straight


def with_mirror(equilibrium, state):
    """States on both sides of the tip: θ is even there, and the arc is odd."""
    tip = complex(equilibrium.y, equilibrium.z)
    return State(
        np.concatenate((state.angle[::-1], state.angle)),
        np.concatenate((-state.slope[::-1], state.slope)),
        np.concatenate((2 * tip - state.place[::-1], state.place)),
    )


def series(rod, state, degree):
    """The coefficients of θ and of y + iz about states: θ″ = β sin θ + (η/2) sin 2(θ − α), and y′ + iz′ = e^{iθ}."""
    shape = (degree + 1, len(state.angle))
    angle, turned = np.zeros(shape), np.zeros(shape)
    once, twice, place = (np.zeros(shape, dtype=complex) for _ in range(3))
    angle[0], angle[1], turned[1] = state.angle, state.slope, state.slope
    once[0] = np.exp(1j * state.angle)
    twice[0] = np.exp(2j * state.angle)
    place[0] = state.place
    for n in range(degree):
        if n:
            # d/dσ e^{iθ} = iθ′e^{iθ}, by powers.
            once[n] = 1j / n * (turned[1 : n + 1] * once[n - 1 :: -1]).sum(axis=0)
            twice[n] = 2j / n * (turned[1 : n + 1] * twice[n - 1 :: -1]).sum(axis=0)
        if n + 2 <= degree:
            turned[n + 2] = rod.beta * once[n].imag / (n + 1)
            angle[n + 2] = turned[n + 2] / (n + 2)
        place[n + 1] = -ldexp(1.0, -rod.scale) * once[n] / (n + 1)
    return angle, place


def negligible():
    """What a term may be, in radians or lengths, to be left out: an eighth of the spacing of numbers just below 1."""
    return 2.0**-56


def complete_series(rod, state, half):
    """Series of which the last two terms are negligible up to half a bin from its middle; None if they are too long.

    What is left out decreases faster than by halves, so it is no more than these.
    """
    for degree in range(2 - int(56 / log2(half)), LONGEST + 1, 6):
        angle, place = series(rod, state, degree)
        last = abs(np.concatenate((degree * angle[-2:], ldexp(1.0, rod.scale) * place[-2:]), axis=1)).max(axis=1)
        if max(last[0] * half ** (degree - 1), last[1] * half**degree) <= negligible():
            return angle, place
    return None


class Bins(NamedTuple):
    """Series of equal bins of which the first begins at ``start`` bins from the tip.

    angle, place: coefficients, by power and bin. straight: the bins in which θ is constant to rounding.
    """

    width: float
    start: int
    straight: Any
    angle: Any
    place: Any


def bins_of(equilibrium, position):
    """The bins of a rod: over its length, or over a period about the tip where the rod is longer than that.

    Their places are worth nothing without ``position``.
    """
    mirrored = period_of(equilibrium)[0] > 0
    reach = equilibrium.swing.length if mirrored else equilibrium.rod.length
    width, series = 0.5, None
    while series is None:
        count = int(reach / width) + 1
        state, straight = states(equilibrium, width, count, position)
        if mirrored:
            state, straight = with_mirror(equilibrium, state), np.concatenate((straight[::-1], straight))
        series = complete_series(equilibrium.rod, state, width / 2)
        found = width
        width /= 2
    return Bins(found, -count if mirrored else 0, straight, *series)


def cells_for(equilibrium, bins, points):
    """Into how many cells bins may be divided for runs to be long enough; 0 where not even bins are."""
    if np.any(bins.straight):
        return 0
    average = points * bins.width / equilibrium.rod.length
    return max((cells for cells in (1, 2, 4) if average / cells >= ENOUGH * cells), default=0)


def divided(coefficients, half, cells, change=None):
    """Series about the middles of equal cells of bins, by power and cell, in a place between −1 and 1.

    half: half the width of a bin. change: a matrix for the terms of each cell, as many as it has columns; like those of
    x^k, what it makes of them has no terms beyond the k-th.
    """
    size, part = len(coefficients), half / cells
    terms = size if change is None else len(change)
    middles = (2 * np.arange(cells) + 1 - cells) * part
    powers = np.zeros((size, terms, cells))
    powers[0, 0] = 1
    for k in range(1, size):
        # (middle + part·x)^k, by powers of x.
        powers[k] = middles * powers[k - 1]
        powers[k, 1:] += part * powers[k - 1, :-1]
    if change is not None:
        powers = np.einsum("mn,knc->kmc", change, powers)
    count = coefficients.shape[1]
    found = np.empty((terms, count, cells))
    for first in range(0, count, AT_A_TIME):
        some = slice(first, first + AT_A_TIME)
        rows = np.zeros((len(coefficients[0, some]), terms * cells))
        # The smallest terms first; of x^k there are none beyond the k-th.
        for k in range(size - 1, -1, -1):
            filled = min(k + 1, terms) * cells
            rows[:, :filled] += coefficients[k, some, None] * powers[k].reshape(-1)[:filled]
        found[:, some] = rows.reshape(-1, terms, cells).transpose(1, 0, 2)
    return found.reshape(terms, -1)


def chebyshev(size):
    """Powers by Chebyshev polynomials and these by powers, a row for each (DLMF 18.9.1)."""
    of_powers, of_chebyshev = np.eye(size), np.eye(size)
    for n in range(1, size - 1):
        # xT_k = (T_{k+1} + T_{k−1})/2, and xT_0 = T_1.
        of_powers[n + 1] = 0
        of_powers[n + 1, 1:] = of_powers[n, :-1] / 2
        of_powers[n + 1, 1] += of_powers[n, 0] / 2
        of_powers[n + 1, :-1] += of_powers[n, 1:] / 2
        of_chebyshev[n + 1] = -of_chebyshev[n - 1]
        of_chebyshev[n + 1, 1:] += 2 * of_chebyshev[n, :-1]
    return of_powers, of_chebyshev


def shortened(coefficients, allowed):
    """Polynomials, a column each, of least degree that differ from the given ones by no more than allowed in [−1, 1].

    Chebyshev polynomials are at most 1 there, so those of high degree go as long as their coefficients sum to less.
    """
    of_powers, of_chebyshev = chebyshev(len(coefficients))
    parts = of_powers.T @ coefficients
    tails = np.cumsum(abs(parts[::-1]), axis=0).max(axis=1)
    kept = max(2, len(parts) - int(np.searchsorted(tails, allowed, side="right")))
    return of_chebyshev[:kept, :kept].T @ parts[:kept]


def quarter():
    """A quarter of the spacing of numbers at 1: how far a value may be from what the series of a bin gives."""
    return 2.0**-54


def series_of(rod, bins, cells, position):
    """The coefficients by cell, highest power first, of θ, θ′, y and z in a place between −1 and 1.

    They are right to a quarter of the spacing of numbers at 1, in rod lengths for y and z.
    """
    half = bins.width / 2
    places = (bins.place.real, bins.place.imag) if position else ()
    angle, *parts = (divided(part, half, cells) for part in (bins.angle, *places))
    slope = -ldexp(cells / half, rod.scale) * np.arange(1, len(angle))[:, None] * angle[1:]
    parts = [angle, slope, *parts]
    length = ldexp(max(1.0, rod.length), -rod.scale)
    units = 1.0, ldexp(1.0, rod.scale), length, length
    return [shortened(part, quarter() * unit)[::-1].T.tolist() for part, unit in zip(parts, units, strict=False)]


class Run(NamedTuple):
    """Points first to last − 1, which lie in a cell, periods beyond the tip's. middle: length from the tip."""

    first: int
    last: int
    cell: int
    periods: int
    middle: float


def runs_of(equilibrium, bins, width, s):
    """The runs of points within a cell and a period."""
    rod, count = equilibrium.rod, round(len(bins.straight) * bins.width / width)
    start, period = bins.start * bins.width / width, period_of(equilibrium)[0]
    edges = (start + np.arange(count + 1)) * width
    reached = int(rod.length / period + 0.5) + 1 if period else 1
    if period:
        edges = np.clip(edges, -period / 2, period / 2)
    runs = []
    for periods in range(reached):
        # From the tip on, s falls.
        ends = np.searchsorted(s, np.ldexp(rod.length - period * periods - edges, -rod.scale), side="right").tolist()
        for cell in np.flatnonzero(np.diff(ends)).tolist():
            middle = period * periods + (start + cell + 0.5) * width
            runs.append(Run(ends[cell + 1], ends[cell], cell, periods, middle))
    return runs


def sum_run(coefficients, shift, within, out):
    """Horner's scheme with the highest power first, and a shift."""
    np.multiply(within, coefficients[0], out=out)
    for coefficient in coefficients[1:-1]:
        out += coefficient
        out *= within
    out += coefficients[-1] + shift


def by_runs(equilibrium, bins, cells, s, position):
    """θ, θ′, y and z at s, which is in rising order; y and z are None without ``position``."""
    rod = equilibrium.rod
    width = bins.width / cells
    rows = series_of(rod, bins, cells, position)
    advance = period_of(equilibrium)[1]
    advances = (0.0, 0.0, advance.real, advance.imag)
    results = [np.empty(s.size) for _ in rows]
    spare = np.empty(RUN_BLOCK)
    for run in runs_of(equilibrium, bins, width, s):
        for first in range(run.first, run.last, RUN_BLOCK):
            block = slice(first, min(first + RUN_BLOCK, run.last))
            within = spare[: block.stop - first]
            np.multiply(s[block], -ldexp(2 / width, rod.scale), out=within)
            within += (rod.length - run.middle) * (2 / width)
            for result, row, step in zip(results, rows, advances, strict=False):
                sum_run(row[run.cell], run.periods * step, within, result[block])
    return results if position else [*results, None, None]


def cut(terms, degree):
    """The matrix by which a polynomial's terms become those of one of a degree near it in [−1, 1], and below them the
    coefficients of the Chebyshev polynomials by which the two differ."""
    of_powers, of_chebyshev = chebyshev(terms)
    kept = degree + 1
    return np.concatenate((of_chebyshev[:kept, :kept].T @ of_powers.T[:kept], of_powers.T[kept:]))


def in_cells(bins, coefficients, cells, degree):
    """The series of all cells, and the largest parts that are left out of any; a straight bin is one cell."""
    change, bent = cut(TERMS, degree), ~bins.straight
    found = divided(coefficients[:, bent], bins.width / 2, cells, change)
    if not np.all(bent):
        whole = np.repeat(bins.straight, np.where(bins.straight, 1, cells))
        both = np.empty((TERMS, len(whole)))
        both[:, ~whole] = found
        both[:, whole] = divided(coefficients[:, bins.straight], bins.width / 2, 1, change)
        found = both
    return found[: degree + 1], abs(found[degree + 1 :])


def short_series(rod, bins, cells, position):
    """The series of all cells in a place between −1 and 1; None if they are not right to a quarter spacing."""
    angle, rest = in_cells(bins, bins.angle, cells, ANGLE_DEGREE)
    # In a straight cell, which is wider, the slope is right by the width of the others; θ there changes by nothing.
    angle[1:, np.repeat(bins.straight, np.where(bins.straight, 1, cells))] /= cells
    # The slope of T_n is at most n².
    orders = np.arange(ANGLE_DEGREE + 1, TERMS)
    if np.max(orders * orders @ rest) > quarter() * bins.width / (2 * cells):
        return None
    parts = [angle]
    for place in (bins.place.real, bins.place.imag) if position else ():
        part, rest = in_cells(bins, place, cells, PLACE_DEGREE)
        if np.max(rest.sum(axis=0)) > quarter() * ldexp(max(1.0, rod.length), -rod.scale):
            return None
        parts.append(part)
    return parts


class Table(NamedTuple):
    """Short power series in cells, for θ, y and z: four low coefficients by row, and the high ones.

    period: of θ in the length from the tip, or 0 where the cells cover the rod. advance: y + iz over a period.
    per_bin: first row and number of cells of each bin, where those differ; else None. slope: θ′ per change in a cell.
    """

    start: float
    cells: float
    per_bin: Any
    rows: tuple
    period: float
    advance: complex
    slope: float


def halves(coefficients):
    """The high and the low coefficients, by row, with room for two or four: what is gathered fastest."""
    high = np.zeros((coefficients.shape[1], 2 if len(coefficients) <= 6 else 4))
    high[:, : len(coefficients) - 4] = coefficients[4:].T
    return high, coefficients[:4].T.copy()


def table_of(equilibrium, bins, position):
    """The table of an equilibrium, by its bins: as many cells in each as the short series need."""
    rod = equilibrium.rod
    cells, parts = 32, None
    while parts is None:
        cells *= 2
        parts = short_series(rod, bins, cells, position)
    uniform = not np.any(bins.straight)
    counts = np.where(bins.straight, 1, cells)
    period, advance = period_of(equilibrium)
    return Table(
        bins.start * (cells if uniform else 1),
        cells / bins.width if uniform else 1 / bins.width,
        None if uniform else np.stack((np.cumsum(counts) - counts, counts), axis=1).astype(float),
        tuple(halves(part * 2.0 ** np.arange(len(part))[:, None]) for part in parts),
        period,
        advance,
        -ldexp(cells / bins.width, rod.scale),
    )


class Spare(NamedTuple):
    """Room for a block: place within its cell, whole cells, periods, gathered coefficients, rows."""

    within: Any
    whole: Any
    periods: Any
    gathered: Any
    row: Any


def gather(coefficients, row, gathered):
    """The coefficients of a row for each point, in the room for them."""
    columns = coefficients.shape[1]
    found = gathered.reshape(-1)[: len(row) * columns].reshape(-1, columns)
    return np.take(coefficients, row, axis=0, out=found, mode="clip")


def locate(table, within, whole, gathered, row):
    """From lengths from the tip to the rows, and to places in the cells, between −½ and ½; exact, for cells are powers
    of two wide."""
    within *= table.cells
    np.floor(within, out=whole)
    within -= whole
    whole -= table.start
    np.copyto(row, whole, casting="unsafe")
    if table.per_bin is not None:
        ends = gather(table.per_bin, row, gathered)
        within *= ends[:, 1]
        np.floor(within, out=whole)
        within -= whole
        whole += ends[:, 0]
        np.copyto(row, whole, casting="unsafe")
    within -= 0.5


def sum_gathered(rows, degree, row, within, gathered, value, slope):
    """Horner's scheme for the value, and for the slope in the cell where it is wanted."""
    high, low = rows
    found, top = gather(high, row, gathered), degree - 4
    value[...] = found[:, top]
    if slope is not None:
        slope[...] = value
    value *= within
    value += found[:, top - 1]
    for k in range(degree - 2, -1, -1):
        if k == 3:
            found = gather(low, row, gathered)
        if slope is not None:
            slope *= within
            slope += value
        value *= within
        value += found[:, k % 4]


def fill(rod, table, s, results, spare):
    """The values of a block of points."""
    within, whole, periods, gathered, row = (part[: s.size] for part in spare)
    np.multiply(s, -ldexp(1.0, rod.scale), out=within)
    within += rod.length
    if table.period:
        np.multiply(within, 1 / table.period, out=periods)
        np.rint(periods, out=periods)
        np.multiply(periods, table.period, out=whole)
        within -= whole
    locate(table, within, whole, gathered, row)
    theta, curvature = results[:2]
    sum_gathered(table.rows[0], ANGLE_DEGREE, row, within, gathered, theta, curvature)
    curvature *= table.slope
    for part, rows, advance in zip(results[2:], table.rows[1:], (table.advance.real, table.advance.imag), strict=False):
        sum_gathered(rows, PLACE_DEGREE, row, within, gathered, part, None)
        if table.period:
            np.multiply(periods, advance, out=whole)
            part += whole


def by_lookup(equilibrium, bins, s, position):
    """θ, θ′, y and z at s; y and z are None without ``position``."""
    table = table_of(equilibrium, bins, position)
    results = [np.empty(s.size) for _ in range(4 if position else 2)]
    gathered, row = np.empty((LOOKUP_BLOCK, 4)), np.empty(LOOKUP_BLOCK, dtype=np.intp)
    spare = Spare(np.empty(LOOKUP_BLOCK), np.empty(LOOKUP_BLOCK), np.empty(LOOKUP_BLOCK), gathered, row)
    for first in range(0, s.size, LOOKUP_BLOCK):
        block = slice(first, min(first + LOOKUP_BLOCK, s.size))
        fill(equilibrium.rod, table, s[block], [part[block] for part in results], spare)
    return results if position else [*results, None, None]


def by_series(equilibrium, s, position):
    """``shape_at`` by power series in bins along the rod."""
    bins = bins_of(equilibrium, position)
    cells = cells_for(equilibrium, bins, s.size)
    if cells and np.all(s[1:] >= s[:-1]):
        return by_runs(equilibrium, bins, cells, s, position)
    return by_lookup(equilibrium, bins, s, position)


def shape_at(equilibrium, s, position=True):
    """θ, θ′, y and z at an array of arc lengths, each in the shape of s; y and z are None without ``position``."""
    flat = np.ravel(s)
    if equilibrium.swing is None:
        values = angle_and_position(equilibrium, flat)
    elif flat.size <= FEW:
        values = np.array([angle_and_position(equilibrium, place) for place in flat.tolist()]).reshape(-1, 4).T
    else:
        values = by_series(equilibrium, flat, position)
    theta, curvature, y, z = (None if part is None else np.reshape(part, np.shape(s)) for part in values)
    return (theta, curvature, y, z) if position else (theta, curvature, None, None)


def refuse(name, numbers, bad, why):
    """Raise ValueError at the first number that is bad."""
    if np.any(bad):
        place = int(np.argmax(bad))
        where = f"{name}[{place}]" if np.ndim(numbers) else name
        raise ValueError(f"{where} {why}, got {float(np.ravel(numbers)[place])!r}")


def all_real(name, values):
    """A number or an array of them as finite doubles; TypeError or ValueError names the argument and the place."""
    kind = getattr(getattr(values, "dtype", None), "kind", "")
    if kind and kind in "fiu":
        numbers = np.asarray(values, dtype=float)
        refuse(name, numbers, ~np.isfinite(numbers), "must be finite")
        return numbers
    # What is no array of numbers by its type is looked at one by one: lists, fractions, and what must be refused.
    try:
        items = np.asarray(values, dtype=object)
    except ValueError:
        raise ValueError(f"{name} must be a number or an array: its rows have different lengths") from None
    if not items.ndim:
        return np.asarray(real(name, values))
    flat = [real(f"{name}[{place}]", item) for place, item in enumerate(items.ravel().tolist())]
    return np.asarray(flat, dtype=float).reshape(items.shape)


def all_not_negative(name, values):
    """Real numbers ≥ 0, or an error that names the argument and the flat index of the first that is none."""
    numbers = all_real(name, values)
    refuse(name, numbers, numbers < 0, "must not be negative")
    return np.abs(numbers)  # no negative zero


def all_positive(name, values):
    """Real numbers > 0, or an error that names the argument and the flat index of the first that is none."""
    numbers = all_real(name, values)
    refuse(name, numbers, numbers <= 0, "must be positive")
    return numbers


def common_shape(given):
    """The shape to which all parameters broadcast; ValueError if there is none."""
    try:
        return np.broadcast_shapes(*(part.shape for part in given))
    except ValueError:
        shapes = ", ".join(f"{name} {part.shape}" for name, part in zip(given._fields, given, strict=True))
        raise ValueError(f"the arguments do not broadcast against one another: their shapes are {shapes}") from None


class Given(NamedTuple):
    """The parameters of many rods: numbers or arrays."""

    beta: Any
    length: Any
    clamp_angle: Any


class Columns(NamedTuple):
    """Equilibria, flat: the number of the rod, and what ``Equilibrium`` says of its tip.

    rank, place: they put the tips of a rod in order, also those that are nearer than rounding.
    """

    case: Any
    rank: Any
    place: Any
    tip_angle: Any
    clamp_curvature: Any
    gamma: Any
    y: Any
    z: Any
    energy: Any
    index: Any


def no_columns():
    """No equilibria."""
    whole, none = np.zeros(0, dtype=int), np.zeros(0)
    return Columns(whole, whole, none, none, none, none, none, none, none, whole)


def each_array(record, change):
    """The record with ``change`` made to every array in it."""
    if isinstance(record, np.ndarray):
        return change(record)
    if isinstance(record, tuple):
        parts = [each_array(part, change) for part in record]
        return type(record)(*parts) if hasattr(record, "_fields") else tuple(parts)
    return record


def rows(record, which):
    """The record of some of the rods, by their numbers, a mask or a slice."""
    return each_array(record, lambda array: array[which])


class Rods(NamedTuple):
    """Rods in their own units of length: see ``equilibria.Rod``. case: their number in the block; slow: ℓ√(β + η)."""

    case: Any
    side: Any
    scale: Any
    beta: Any
    length: Any
    clamp_angle: Any
    slow: Any


def both_sides_each(rods):
    """The rods and after them their mirror images, for the tips above the clamp angle."""
    number = rods.case.size
    side, both = np.repeat(np.array([1, -1]), number), np.concatenate([np.arange(number), np.arange(number)])
    twice = rows(rods, both)
    return Rods(twice.case, side, twice.scale, twice.beta, twice.length, side * twice.clamp_angle, twice.slow)


def chosen(rods, mask):
    """Some of the rods, by a mask, or by one truth value for all of them."""
    return rows(rods, np.flatnonzero(np.full(rods.case.shape, mask)))


def along_each(beta, quarters, sign):
    """A direction along or against the force, no field: what it is about the field is not asked."""
    return Rest(quarters, 0, quarters * (pi / 2), sign * beta, 1, 0)


def no_field_each(beta):
    """The force alone."""
    return Landscape((along_each(beta, 0, 1), along_each(beta, 2, -1), along_each(beta, 4, 1)), False, True)


def by_landscape(rods):
    """The rods in groups with landscapes of one kind, and those."""
    bare = chosen(rods, True)
    yield bare, no_field_each(bare.beta)


def offset_from_each(rest, angle, turns):
    """angle − (rest + turns·2π), without cancellation; 0 where no angle within rounding of this tells them apart."""
    offset = each_less_quarters(angle, 4 * turns + rest.quarters) - rest.extra
    blur = epsilon() * (np.abs(angle) + np.abs(rest.extra))
    return each_pick((np.abs(offset) <= blur) | (np.abs(offset) < epsilon() ** 9), 0, offset)


def clamp_in_each(rests, angle):
    """Whole turns such that the clamp lies from the first hill up to, but not at, its like a turn on."""
    turns = np.floor((angle - rests[0].angle) / (2 * pi))
    for _ in range(3):
        offsets = tuple(offset_from_each(rest, angle, turns) for rest in rests)
        shift = each_pick(offsets[0] < 0, -1, each_pick(offsets[-1] >= 0, 1, 0))
        if not np.any(shift != 0):
            break
        turns = turns + shift
    return Clamp(turns, offsets)


class Straight(NamedTuple):
    """Rods whose clamp angle is a direction without moment."""

    rods: Rods
    rest: Any


def numbered(rests):
    """The directions with a number for the rest of their angle: only whether two are alike is asked from here on."""
    last = len(rests) - 1
    return tuple(rest._replace(extra=k % last) for k, rest in enumerate(rests))


def level_ground_each(scene, at):
    """The ground without a ridge lower than the hill."""
    return Ground(scene, at, 0, 0, 0)


def ridge_fall_each(beta, hill, ridge):
    """V(hill) − V(ridge): the sine of half their distance times the slope of V between, as if it were a circle."""
    half, middle = (ridge.extra - hill.extra) / 2, pi / 2 + (hill.extra + ridge.extra) / 2
    return np.cos(half) * (2 * beta * np.sin(middle))


def fall_from_rest_each(stiffness, middle, half):
    """V(middle − half) − V(middle + half), with both angles measured from a direction without moment."""
    return rest_fall_each(stiffness, np.sin(middle / 2), np.cos(middle / 2), np.sin(half / 2), np.cos(half / 2))


def fall_each(rest, start, change):
    """V(start) − V(start + change), from a start measured from a direction without moment."""
    half = change / 2
    return fall_from_rest_each(rest.stiffness, start + half, half)


def pick_rest_each(condition, yes, no):
    """One or the other direction, number by number."""
    return Rest(*(each_pick(condition, *pair) for pair in zip(yes, no, strict=True)))


def step_to_each(rest, offset, goal):
    """Newton's step to where the square root of the change of V from a direction without moment is ``goal``, and by
    how much its slope changes half way there, as a share of it."""
    small, large = np.sin(offset / 4), np.cos(offset / 4)
    sine, cosine = 2 * small * large, 1 - 2 * small * small
    level = rest_fall_each(rest.stiffness, small, large, small, large)
    force = np.abs(rest_moment_each(rest.stiffness, sine, cosine))
    here, force = np.sqrt(np.abs(level)), np.maximum(force, epsilon() ** 20)
    whole_sine, whole_cosine = 2 * sine * cosine, 1 - 2 * sine * sine
    # dθ″/dθ, by β and α as the direction has them.
    turned = rest.double_cosine * (2 * whole_cosine * whole_cosine - 1 - whole_cosine)
    turned = turned - rest.double_sine * whole_sine * (2 * whole_cosine - 0.5)
    bend = rest.stiffness * whole_cosine * (here / force) * (here / force)
    share = (here - goal) / np.maximum(here, epsilon() ** 20)
    return 2 * here * (here - goal) / force, share * (each_pick(level < 0, -bend, bend) - 0.5)


def reach_each(rest, amount, most, side):
    """The distance from a hill (or a well) at which V is lower (or higher) by ``amount``, to one side.

    most: the distance of the next well (or hill). Halley's method for the square root of the difference, which is
    nearly linear, from the pendulum's value.
    """
    amount = np.maximum(amount, 0)  # of a hill and a well that nearly meet, rounding may give less
    share = amount / np.maximum(np.abs(fall_each(rest, 0, side * most)), epsilon() ** 20)
    near = most * np.arcsin(np.sqrt(each_pick(share < 1, share, 1))) * (2 / pi)
    goal = np.sqrt(amount)
    for _ in range(40):
        step, bent = step_to_each(rest, side * near, goal)
        safe = np.abs(bent) < 0.5
        trial = near - step / each_pick(safe, 1 - bent, 1)
        trial = each_pick(trial > most, (near + most) / 2, each_pick(trial < 0, near / 2, trial))
        # The method cubes the error, and Newton's squares it: after steps this small the next would change nothing.
        small = each_pick(safe, each_spacing(trial) ** 0.45, each_spacing(trial) ** 0.6)
        moving, near = np.abs(trial - near) > small * near, trial
        if not np.any(moving):
            break
    return near


def ridge_ground_each(scene, at, drop):
    """The ground with a lower ridge."""
    rests = scene.rests
    down, above = rests[1].angle - rests[0].angle, fall_each(rests[2], 0, rests[1].angle - rests[2].angle)
    # Of a ridge that is next to its wells V tells at the hill nothing.
    by_hill = drop < above
    rest, amount = pick_rest_each(by_hill, rests[0], rests[1]), each_pick(by_hill, drop, above)
    distance = reach_each(rest, amount, down, each_pick(by_hill, 1, -1))
    level = each_pick(by_hill, distance, down - distance)
    # Near the far hill V says which is higher only by the distance from that hill.
    height = each_pick(at[2] < -at[4], fall_each(rests[2], 0, at[2]), fall_each(rests[4], 0, at[4]) - drop)
    return Ground(scene, at, drop, level, height)


def ground_of_kind(rods, scene, clamp):
    """The ground of rods with one kind of landscape, and where a ridge is too near the hill's level to be told."""
    rests = scene.rests
    level = scene._replace(rests=numbered(rests))
    if len(rests) == 3 or scene.level:
        return level_ground_each(level, clamp.offsets), np.zeros(rods.case.shape, dtype=bool)
    drop = ridge_fall_each(rods.beta, rests[0], rests[2])
    low = drop <= epsilon() ** 17 * rods.beta
    return ridge_ground_each(level, clamp.offsets, drop), low


def in_basin_each(at, first, inside, builders):
    """The range of a clamp inside a basin: one before the well and at it, another beyond."""
    return [(inside & (at[first + 1] <= 0), builders[0]), (inside & (at[first + 1] > 0), builders[1])]


def piece_of_each(basin, low_kind, high_kind, low_offset, width, high_depth, clamp_gap, level_gap, at):
    """The record of a range."""
    rests = (basin.hill, basin.well, basin.axis, basin.far_well, basin.far) if basin.passes else basin[:3]
    rest, offset = rests[0], at[0]
    for other, distance in zip(rests[1:], at[1:], strict=False):
        closer = np.abs(distance) < np.abs(offset)
        if np.any(closer):
            rest, offset = pick_rest_each(closer, other, rest), each_pick(closer, distance, offset)
    last = at[len(rests) - 1]
    return Piece(basin, low_kind, high_kind, low_offset, width, high_depth, clamp_gap, level_gap, rest, offset, -last)


def from_hill_to_clamp_each(basin, at):
    """From a hill to a clamp before the well."""
    return piece_of_each(basin, "hill", "clamp", 0, at[0], -at[1], 0, 0, at)


def basin_of_each(ground, first):
    """The basin between two neighbouring hills."""
    scene = ground.scene
    hill, well, far = scene.rests[first : first + 3]
    even = scene.even and (scene.level or len(scene.rests) == 3)
    return Basin(hill, well, far, well, well, ground.drop if first else 0, False, even)


def first_clamp_each(ground):
    """From the first hill to the clamp."""
    return from_hill_to_clamp_each(basin_of_each(ground, 0), ground.at[:3])


def from_hill_to_turn_each(basin, at):
    """From a hill to where the rod turns back at a clamp beyond the well."""
    down, depth = basin.well.angle - basin.hill.angle, at[1]
    width = -at[2]
    if not basin.even:
        above = -fall_each(basin.well, 0, at[1])
        below = fall_each(basin.far, 0, at[2]) - basin.far_rise
        from_top = reach_each(basin.hill, np.maximum(below, 0), down, 1)
        from_well = reach_each(basin.well, above, down, -1)
        depth = each_pick(below < above, down - from_top, from_well)
        width = each_pick(below < above, from_top, down - from_well)
    return piece_of_each(basin, "hill", "turn", 0, width, depth, depth + at[1], 0, at)


def first_turn_each(ground):
    """From the first hill to where the rod turns back at the clamp."""
    return from_hill_to_turn_each(basin_of_each(ground, 0), ground.at[:3])


def last_clamp_each(ground):
    """From the second hill to the clamp."""
    return from_hill_to_clamp_each(basin_of_each(ground, 2), ground.at[2:])


def last_turn_each(ground):
    """From the second hill to where the rod turns back at the clamp."""
    return from_hill_to_turn_each(basin_of_each(ground, 2), ground.at[2:])


def over_ridge_each(ground):
    """What stops a motion that passes the ridge."""
    hill, well, ridge, second, far = ground.scene.rests
    return Basin(hill, well, far, second, ridge, 0, True, ground.scene.even)


def pass_clamp_each(ground):
    """From the highest hill to a clamp above the level of the ridge."""
    at = ground.at
    return piece_of_each(over_ridge_each(ground), "hill", "clamp", 0, at[0], -at[1], 0, ground.level - at[0], at)


def pass_level_each(ground):
    """From the highest hill to the level of the ridge."""
    over, level, at = over_ridge_each(ground), ground.level, ground.at
    return piece_of_each(
        over, "hill", "level", 0, level, over.well.angle - over.hill.angle - level, at[0] - level, 0, at
    )


def moment_from_rest_each(stiffness, offset):
    """θ″ = −V′ at an offset from a direction without moment."""
    return rest_moment_each(stiffness, np.sin(offset / 2), np.cos(offset / 2))


def slope_each(rest, offset):
    """θ″ at an offset from a direction without moment."""
    return moment_from_rest_each(rest.stiffness, offset)


def onward_each(rest, start, amount, rough, wanted):
    """How far beyond ``start``, an offset from a direction without moment, V has fallen by ``amount``.

    The rough value is good to rounding of the angles; where little of it is left, the slope of V at the start gives a
    better one. Newton's method does the rest, until all that are wanted are found.
    """
    steep = slope_each(rest, start)
    told = (np.abs(rough) > 0.001 * np.abs(start)) | (steep == 0)
    distance = each_pick(told, rough, amount / each_pick(told, 1, steep))
    for _ in range(40):
        force = slope_each(rest, start + distance)
        step = (fall_each(rest, start, distance) - amount) / each_pick(force == 0, 1, force)
        away = np.abs(distance - step) > pi
        stuck = away & (distance == rough)
        distance = each_pick(away, rough, distance - step)
        if not np.any(wanted & (stuck == 0) & (np.abs(step) > each_spacing(distance) ** 0.6 * np.abs(distance))):
            break
    return distance


def pass_turn_each(ground):
    """From the highest hill to where the rod turns back at a clamp above the level of the ridge, beyond it."""
    over, level, at = over_ridge_each(ground), ground.level, ground.at
    down = over.well.angle - over.hill.angle
    width = -at[4] if over.even else reach_each(over.hill, fall_each(over.far, 0, at[4]), down, 1)
    # Towards the hill V is flat and tells little, but there the angles tell all.
    near = width >= level / 2
    gap = each_pick(near, -onward_each(over.hill, level, ground.height, width - level, near), level - width)
    return piece_of_each(over, "hill", "turn", 0, width, down - width, at[0] - width, gap, at)


def level_clamp_each(ground):
    """From the level of the ridge to the clamp."""
    level, at = ground.level, ground.at
    return piece_of_each(basin_of_each(ground, 0), "level", "clamp", level, at[0] - level, -at[1], 0, 0, at)


def level_turn_each(ground):
    """From the level of the ridge to where the rod turns back at the clamp, before the ridge."""
    basin, level, at = basin_of_each(ground, 0), ground.level, ground.at
    down = basin.well.angle - basin.hill.angle
    above, below = -fall_each(basin.well, 0, at[1]), fall_each(basin.far, 0, at[2])
    from_well = reach_each(basin.well, above, down, -1)
    # Towards the well V is flat and tells little, but there the angles tell all; towards the hill only V does.
    from_hill = reach_each(basin.hill, ground.drop + below, down, 1)
    near = onward_each(basin.hill, level, below, from_hill - level, True)
    width = each_pick(below < above / 4, near, down - level - from_well)
    return piece_of_each(basin, "level", "turn", level, width, from_well, from_well + at[1], 0, at)


def ranges_each(ground):
    """Every range that a landscape of this kind can have: whether the rod has it, and its builder. From low to high."""
    at = ground.at
    if len(at) == 3:
        return in_basin_each(at, 0, at[0] > 0, (first_clamp_each, first_turn_each))
    if ground.scene.level:
        first = in_basin_each(at, 0, (at[0] > 0) & (at[2] < 0), (first_clamp_each, first_turn_each))
        return first + in_basin_each(at, 2, at[2] > 0, (last_clamp_each, last_turn_each))
    before, above = at[2] <= 0, at[0] <= ground.level
    last = (at[2] > 0) & (ground.height > 0)
    return [
        (before & above & (at[0] > 0), pass_clamp_each),
        (before & (at[0] > ground.level) | last, pass_level_each),
        ((at[2] > 0) & (ground.height <= 0), pass_turn_each),
        *in_basin_each(at, 0, (at[0] > ground.level) & (at[2] < 0), (level_clamp_each, level_turn_each)),
        *in_basin_each(at, 2, last, (last_clamp_each, last_turn_each)),
    ]


class Group(NamedTuple):
    """Ranges of one kind, one a rod. turns: whole turns of the clamp; rank: among the rod's ranges, from low to high.

    dip: the place around which a ridge that is not quite there slows the motion down, or None for all of them.
    """

    rods: Rods
    turns: Any
    rank: Any
    piece: Any
    dip: Any


def astroid_cusp_each():
    """Where the second pair is born: tan³x = tan α (Stoner and Wohlfarth's astroid).

    The pair lies at α + π + x with sin α/sin x + cos α/cos x = η/β: it is there when η/β is beyond the least value of
    the left side, taken at this x.
    """
    return np.arctan(0.0)


def ridge_couple_each(beta, x):
    """The couple on a rod that points along α + π + x."""
    return -(beta * np.sin(x))


def nearly_ridge(rods, piece):
    """How far η is below the value at which a ridge would appear, and the place at which the motion would meet it:
    see ``search.places``. No number where that is not on the range."""
    basin = piece.basin
    if basin.even or basin.passes or piece.low_kind == "level" or basin.far.quarters - basin.hill.quarters != 4:
        return np.full(rods.case.shape, np.inf), rods.slow
    beta = rods.beta
    side = astroid_cusp_each()
    missing = -ridge_couple_each(beta, side) / beta
    cusp = pi - side
    down = basin.well.angle - basin.hill.angle
    rise = reach_each(basin.hill, fall_each(basin.hill, 0, cusp - basin.hill.angle), down, 1)
    inside = (rise > 0) & (rise < piece.width)
    return np.where(inside, missing, np.inf), np.log(rise / (piece.width - rise))


def by_dips(group):
    """The ranges without and with a dip, and the cases left to the scalar solver, for their dip is too sharp."""
    missing, dip = nearly_ridge(group.rods, group.piece)
    plain, wide = missing > NEARLY, (missing <= NEARLY) & (missing >= SHARP)
    parts = [rows(group, plain)] if plain.any() else []
    if wide.any():
        parts.append(rows(group._replace(dip=dip), wide))
    return parts, group.rods.case[~plain & ~wide]


def least_arrival_each(rods, piece, offset):
    """A length before which no motion from an offset from the hill, or from a lower one, arrives.

    θ″ is nowhere more than β + η/2, and at an offset from the hill no more than β + η times that: a motion that has
    the lesser of these two gets ahead of it.
    """
    steep, most = rods.beta, rods.beta
    clamp = piece.low_offset + piece.width + piece.clamp_gap
    bend = np.minimum(clamp, most / steep)
    ratio = np.maximum(bend / np.maximum(offset, epsilon() ** 20), 1)
    arrival = np.arccosh(ratio) / np.sqrt(steep)
    speed = np.sqrt(steep * (ratio - 1) * (ratio + 1)) * offset
    rest = np.maximum(clamp - np.maximum(offset, bend), 0)
    return arrival + 2 * rest / (speed + np.sqrt(speed * speed + 2 * most * rest) + epsilon() ** 20)


def in_time(rods, piece):
    """Which ranges have a motion that may arrive in time."""
    return least_arrival_each(rods, piece, piece.low_offset + piece.width) <= (1 + SURELY) * rods.length


def groups(rods):
    """The ranges of tips below the clamp angle, the straight rods, and the cases that are left to the scalar solver."""
    found, straight, doubtful = [], [], [np.zeros(0, dtype=int)]
    for some, scene in by_landscape(rods):
        clamp = clamp_in_each(scene.rests, some.clamp_angle)
        for rest, offset in zip(scene.rests, clamp.offsets, strict=True):
            flat = np.flatnonzero((offset == 0) & (some.side > 0))
            if flat.size:
                straight.append(Straight(rows(some, flat), rows(rest, flat)))
        ground, low = ground_of_kind(some, scene, clamp)
        doubtful.append(some.case[low])
        for rank, (here, build) in enumerate(ranges_each(ground)):
            which = np.flatnonzero(here & ~low)
            if which.size:
                given, piece = rows(some, which), build(rows(ground, which))
                group = Group(given, clamp.turns[which], np.full(which.shape, rank), piece, None)
                parts, sharp = by_dips(rows(group, in_time(given, piece)))
                found += parts
                doubtful.append(sharp)
    return found, straight, np.concatenate(doubtful)


def ends(rods, piece):
    """The places of the deepest samples: see ``places.grid``."""
    rounding = -np.log(epsilon())
    first = np.minimum(-2 * rods.slow - 6, -rounding) if piece.low_kind == "level" else -rods.slow - 6
    late = first
    for k in range(1, HALVINGS + 1):
        trial = late - first * 0.5**k
        offset = piece.low_offset + piece.width / (1 + np.exp(-trial))
        late = np.where(least_arrival_each(rods, piece, offset) > (1 + SURELY) * rods.length, trial, late)
    if piece.high_kind == "level":
        last = 2 * rods.slow + rounding
    elif piece.high_kind == "turn":
        last = LATEST + 0 * rods.slow
    else:
        moment = np.abs(slope_each(piece.clamp_rest, piece.clamp_offset)) + epsilon() ** 20
        deeper = 4 + np.log(2 * piece.width) - np.log(moment) - 2 * np.log(rods.length)
        last = np.where(piece.high_depth == 0, rounding, np.maximum(LATEST, deeper))
    return late, last


def rounded_to(record, kind):
    """The record with its numbers in another precision, those that all rods share as well."""
    if isinstance(record, np.ndarray):
        return record.astype(kind)
    if isinstance(record, float):
        return kind(record)
    if isinstance(record, tuple):
        parts = [rounded_to(part, kind) for part in record]
        return type(record)(*parts) if hasattr(record, "_fields") else tuple(parts)
    return record


def spaced(deepest, step):
    """Places from 0 to the deepest one, as shares of it."""
    places, growth = [0.0], 1 + step / 3
    while places[-1] < deepest:
        places.append(places[-1] + step)
        step *= growth
    return np.array([*places[:-1], deepest]) / max(deepest, 1e-30)


def places_of(dip, here, first, last, step):
    """The places of samples, a column for each range: from the lowest up, and closer around dips."""
    below, above = spaced(-first.min(), step), spaced(last.max(), step)
    places = np.concatenate([first * below[:0:-1, None], last * above[:, None]])
    if dip is None:
        return places
    return np.sort(np.concatenate([places, np.clip(dip[here] + AROUND[:, None], first, last)]), axis=0)


def within_each(sine):
    """A sine that rounding may have brought beyond 1."""
    return each_pick(sine < 1, sine, 1)


def parallel_side_each(beta, piece, rise, drop, from_hill, depth):
    """``far_side`` within a well for a field along the force: the cosines of the turning points add up to −2β/η."""
    basin = piece.basin
    if piece.low_kind == "level":
        low, high = np.sin(rise / 2) * np.sin(piece.low_offset + rise / 2), beta / 0.0 + np.cos(from_hill / 2) ** 2
    else:
        low = np.sin(rise / 2) ** 2
        low, high = beta / 0.0 + low, -beta / 0.0 - low
    # sin² and cos² of half the distance from the far turning point to the far hill.
    low, high = np.sqrt(np.maximum(low, 0)), np.sqrt(np.maximum(high, 0))
    distance = 2 * np.arctan2(low, high)
    down = basin.far.angle - basin.far_well.angle
    dip = np.sin(from_hill + depth / 2) * np.sin(depth / 2)
    up = 2 * np.arcsin(within_each(dip / np.sin((down + distance) / 2)))
    if piece.high_kind == "turn":
        share = np.sin(from_hill + drop / 2) * np.sin(drop / 2) / np.sin((piece.far_gap + distance) / 2)
        left = 2 * np.arcsin(within_each(share))
    else:
        left = up + piece.high_depth
    return (up + depth) / 2, left, 0.0, distance


def reach_either_each(hill, well, by_hill, amount, most):
    """``reach`` down from the hill, or up from the well, whichever is asked for."""
    rest = hill._replace(
        stiffness=each_pick(by_hill, hill.stiffness, well.stiffness),
        double_cosine=each_pick(by_hill, hill.double_cosine, well.double_cosine),
        double_sine=each_pick(by_hill, hill.double_sine, well.double_sine),
    )
    return reach_each(rest, amount, most, each_pick(by_hill, -1, 1))


def beyond_clamp_each(piece, drop, rough):
    """How far the motion goes beyond the clamp, when the tip is ``drop`` below the one that turns there.

    V falls by the same amount on both sides. The rough value is as good as its difference to the clamp's distance
    from a hill or a well allows.
    """
    basin, rest, start = piece.basin, piece.clamp_rest, piece.clamp_offset
    high = -piece.high_depth
    amount = fall_each(basin.well, high - drop, drop)
    far = rough > 0.25 * np.abs(start)
    better = onward_each(rest, start, -amount, rough, far == 0)
    # Newton's method leaves a place where V is nearly level for one far away.
    return each_pick(far | (np.abs(better - rough) > 0.01), rough, better)


def far_side_each(piece, rise, drop, depth, done):
    """Half the width of the motion, how far it goes on beyond the clamp, and the moment where it turns."""
    basin = piece.basin
    hill, well, far, far_well = basin.hill, basin.well, basin.far, basin.far_well
    down = far.angle - far_well.angle
    if piece.low_kind == "level":
        below = fall_each(hill, piece.low_offset, rise)
    else:
        below = basin.far_rise + fall_each(hill, 0, rise)
    if basin.passes:
        # Not below the ridge, however near it is to the well behind it.
        ridge = fall_each(basin.axis, 0, far_well.angle - basin.axis.angle)
        above = np.maximum(-fall_each(far_well, 0, down) - below, ridge)
    else:
        above = -fall_each(well, 0, -depth)
    by_hill = below < above
    distance = reach_either_each(far, far_well, by_hill, each_pick(by_hill, below, above), down)
    turn = each_pick(by_hill, down - distance, distance)  # far turning point − far_well
    # clamp − far_well
    clamp_turn = down - piece.far_gap if basin.passes else piece.clamp_gap - piece.high_depth
    left = each_pick(by_hill, piece.far_gap - distance, distance - clamp_turn)
    if basin.passes:
        half_width = (turn + depth + (far_well.angle - well.angle)) / 2
    else:
        half_width = (turn + depth) / 2
    far_moment = each_pick(by_hill, slope_each(far, -distance), slope_each(far_well, distance)) * -1
    far_moment = np.maximum(far_moment, 4 * epsilon() * distance)
    if piece.high_kind == "turn":
        left = np.maximum(beyond_clamp_each(piece, drop, left), 0)
    return half_width, left, far_moment, each_pick(by_hill, distance, down - distance)


def unevenness_each(near, far):
    """√far − √near: by the roots where they are apart, else by far − near = 2η sin 2(middle − α) sin(half_width)."""
    apart = (8 * near < far) | (8 * far < near) | (near + far < 0.0)
    return each_pick(apart, np.sqrt(far) - np.sqrt(near), 0.0)


def wrapped_each(angle):
    """The angle less whole turns, between −π and π."""
    return angle - 2 * pi * np.floor(angle / (2 * pi) + 0.5)


def above_field_each(basin, middle, half_width, height):
    """``mean`` less η where they are near each other: 2(V(tip) − V)/(cos(θ − middle) − cos(half_width)) at the θ at
    which it is least, which lies then near the ridge or the well. height: from there to the tip."""
    shift = wrapped_each(2 * -middle)
    offset = wrapped_each(middle + shift - basin.axis.angle)
    # As near the ridge as rounding it is nearer still: it is there to the second order in the height.
    offset = each_pick(np.abs(offset) < 32 * each_spacing(offset), 0, offset)
    outer, inner = np.sin(half_width / 2), np.sin(shift / 2)
    turn = outer * outer - inner * inner
    return (height + fall_each(basin.axis, 0, offset)) / each_pick(turn == 0, 1, turn)


def mean_less_field_each(basin, middle, half_width, near, far, height, mean):
    """``mean`` − η: as it stands, or by the end of the motion or the ridge or well that is near where V is nearest to
    level."""
    apart = mean
    close = apart <= 0.0
    if np.any(close):
        by_far, by_near = far, near
        known = each_pick(2 * by_far > far, by_far, by_near)
        far_off = close & (2 * by_far <= far) & (2 * by_near <= near)
        if np.any(far_off):
            known = each_pick(far_off, above_field_each(basin, middle, half_width, height), known)
        apart = each_pick(close, known, apart)
    # Over a ridge V(tip) − V is nowhere less than there; elsewhere only rounding makes it smaller than this.
    least = np.maximum(height, epsilon() ** 19) if basin.passes else epsilon() * each_pick(near < far, near, far) / 4
    return np.maximum(apart, least)


def rates_each(beta, basin, tip, half_width, sine, near, far, height):
    """dχ/dσ at the ends and in the middle of the motion."""
    middle, cosine = tip + half_width, np.cos(half_width)
    cos_middle = np.cos(middle)
    product = np.sqrt(near) * np.sqrt(far)
    excess = -(2 * beta * cos_middle * cosine)
    split, rate = excess < 0, np.sqrt(product + np.maximum(excess, 0))
    if np.any(split):
        mean = -(2 * beta * cos_middle)
        apart = mean_less_field_each(basin, middle, half_width, near, far, height, mean)
        rate = each_pick(split, sine * np.sqrt(apart * mean / each_pick(split, product - excess, 1)), rate)
    return np.sqrt(product / 2), rate / 2


def motion_at_each(beta, piece: Piece, place):
    """The motion of the tip at a place of a piece: −∞ is its low end, +∞ its high end."""
    basin = piece.basin
    rise, drop = piece.width / (1 + np.exp(-place)), piece.width / (1 + np.exp(place))
    from_hill, depth = piece.low_offset + rise, piece.high_depth + drop
    upper = from_hill < depth
    hill, well = basin.hill, basin.well
    offset = each_pick(upper, from_hill, -depth)
    stiffness = each_pick(upper, hill.stiffness, well.stiffness)
    tip = each_pick(upper, hill.angle, well.angle) + offset
    near_moment = moment_from_rest_each(stiffness, offset)
    # How far V falls from the tip to the well, or to the level of a ridge that the motion passes.
    change = (drop + piece.level_gap if basin.passes else depth) / 2
    height = fall_from_rest_each(stiffness, offset + change, change)
    done = piece.clamp_gap + drop
    if basin.even:
        half_width = depth + (basin.axis.angle - well.angle)
        left = 2 * half_width - done if piece.high_kind != "turn" else drop
        far_moment, far_distance = near_moment, from_hill
    elif not basin.passes:
        half_width, left, far_moment, far_distance = parallel_side_each(beta, piece, rise, drop, from_hill, depth)
    else:
        half_width, left, far_moment, far_distance = far_side_each(piece, rise, drop, depth, done)
        # Where a hill and a well nearly meet, rounding leaves nothing, or less, of a moment.
        near_moment = np.maximum(near_moment, 4 * epsilon() * np.abs(offset))
    # Where the motion is nearly a whole turn, what it lacks is told by the distances from the hills.
    whole_turn = basin.far.quarters - hill.quarters == 4 and basin.far.extra == hill.extra
    lack = (from_hill + far_distance) / 2 if whole_turn else pi - half_width
    sine = np.sin(each_pick(lack < half_width, lack, half_width))
    near, far = 2 * near_moment / sine, 2 * far_moment / sine
    uneven = 0 if basin.even else unevenness_each(near, far)
    # done/2 + left/2 = half_width: near half a turn one follows from the other.
    done_sine = np.sin(each_pick(done > pi, lack + left / 2, done / 2))
    left_sine = np.sin(each_pick(left > pi, lack + done / 2, left / 2))
    half_cosine = np.sin(lack / 2)
    end, middle = rates_each(beta, basin, tip, half_width, sine, near, far, height)
    return Motion(
        tip,
        half_width,
        done,
        left,
        near_moment,
        far_moment,
        near,
        far,
        end,
        middle,
        sine,
        half_cosine,
        uneven,
        done_sine,
        left_sine,
    )


def phase_of_each(motion):
    """The phase of the clamp: χ by the half-angle sines, and ψ by χ."""
    near, far, end = np.sqrt(motion.near), np.sqrt(motion.far), motion.end
    done, left = motion.done_sine, motion.left_sine
    whole = phase_sum_each(near, far, done, left)
    gap = np.sin((motion.left - motion.done) / 4)
    behind, ahead = far * done / whole, near * left / whole
    lead = phase_lead_each(near, motion.half_cosine, motion.uneven, done, gap) / whole
    cosine = each_pick(np.abs(ahead - behind) > 0.8, ahead - behind, lead)
    # Not zero: at the tip itself the motion has no point by ℘.
    square = np.maximum(chi_square_each(behind, ahead), epsilon() ** 19)
    size, first = np.abs(cosine), cosine >= 0
    delta = np.hypot(end * cosine, motion.middle * np.sqrt(square))
    half = each_pick(first, half_square_each(end, square, size, delta), half_square_beyond_each(end, size, delta))
    rest = each_pick(
        first, half_rest_each(end, size, delta), half_rest_beyond_each(end, motion.middle, square, size, delta)
    )
    return Phase(half, rest, whole, delta)


def rough_times(rods, piece, place):
    """Half-swing and first arrival, to the square of a thousandth or the rounding of the numbers given."""
    motion = motion_at_each(rods.beta, piece, place)
    phase = phase_of_each(motion)
    a, b, square, rest = motion.end / 2, motion.middle / 2, phase.square, phase.rest
    more = True
    while more:
        more = (np.abs(a - b) > 0.001 * a).any()
        delta = np.sqrt(a * a * rest + b * b * square)
        total, below = a + b, a + delta
        ratio = total / below
        inner = a + (a * a + b * b * square) / (delta + b * square)
        square, rest = ratio * ratio * square, 2 * a / below * rest * (inner / below)
        a, b = total / 2, np.sqrt(a * b)
    mean = (a + b) / 2
    return pi / 2 / mean, np.arctan2(np.sqrt(square), np.sqrt(rest)) / mean


def end_arrival(piece, swing):
    """The first arrival at the high end itself, where it is known: at once, or after the whole half-swing."""
    if piece.high_kind == "clamp":
        return np.where((piece.clamp_gap == 0) & (piece.high_depth > 0), 0 * swing, np.nan)
    return swing if piece.high_kind == "turn" else None


class Brackets(NamedTuple):
    """Crossings to be found: the range, by its number in the group, the branch, places on either side, and there the
    length of the branch less the rod's."""

    range: Any
    turns: Any
    sign: Any
    left: Any
    right: Any
    value_left: Any
    value_right: Any


def surplus(swing, arrival, turns, sign, length):
    """The length of a branch less the rod's."""
    return 2 * turns * swing + sign * arrival - length


def joined(records):
    """Records of arrays, one after another; what all rods share is taken from the first."""
    first = records[0]
    if isinstance(first, np.ndarray):
        return np.concatenate(records)
    if isinstance(first, tuple):
        parts = [joined(list(column)) for column in zip(*records, strict=True)]
        return type(first)(*parts) if hasattr(first, "_fields") else tuple(parts)
    return first


def extrema(group, sign, places, swings, arrivals, counts):
    """Brackets beside the extrema that reach beyond a whole number, and the ranges where that is not sure."""
    before, here, after = counts[:-2], counts[1:-1], counts[2:]
    top = here > before
    gaps = np.maximum(places[1:] - places[:-1], 1e-30)
    share = gaps[1:] / gaps[:-1]
    reach = np.maximum(np.abs(before - here) * share, np.abs(after - here) / share)
    goal = np.where(top, np.ceil(here), np.floor(here))
    near = np.where(top, goal - here, here - goal)
    row, which = np.nonzero(((before - here) * (after - here) > 0) & (near <= reach) & (goal >= 0))
    goal, top = goal[row, which], top[row, which]
    left, right = places[row, which], places[row + 2, which]
    if not row.size:
        return Brackets(which, goal, np.full(which.shape, sign), left, right, left, right), which
    some = rows(group, which)
    length = some.rods.length
    finer = left + (right - left) * np.linspace(0, 1, 17).astype(left.dtype)[:, None]
    swings, arrivals = rough_times(some.rods, some.piece, finer)
    short = np.where(top, 1, -1) * (goal - (length - sign * arrivals) / (2 * swings))
    # Sure: well beyond, once; or so far from it that a curve that bends one way does not reach it.
    best = short.argmin(axis=0)
    column = np.arange(which.size)
    inner = np.clip(best, 1, 15)
    least, beside = short[best, column], np.maximum(short[inner - 1, column], short[inner + 1, column])
    margin = (0.0001 if left.dtype == np.float32 else 1e-09) * (1 + goal)
    changes = ((short[1:] < 0) != (short[:-1] < 0)).sum(axis=0)
    beyond = (least < -margin) & (changes == 2) & (best == inner)
    hard = ~beyond & (2 * least <= beside + margin)
    sure = np.flatnonzero(beyond)
    value = surplus(swings[:, sure], arrivals[:, sure], goal[sure], sign, length[sure])
    middle, column = finer[best[sure], sure], np.arange(sure.size)
    center = value[best[sure], column]
    found = Brackets(which[sure], goal[sure], np.full(sure.shape, sign), left[sure], middle, value[0], center)
    other = found._replace(left=middle, right=right[sure], value_left=center, value_right=value[-1])
    return joined([found, other]), which[hard]


def crossed(group, sign, places, swings, arrivals, capped, most):
    """Brackets of the whole numbers that the count of one branch crosses, and the ranges that are doubtful."""
    length, end = group.rods.length, end_arrival(group.piece, swings[-1])
    counts = (length - sign * arrivals) / (2 * swings)
    doubt = ~np.isfinite(counts).all(axis=0) | capped[0] & (counts[0] >= 1)
    beside, hard = extrema(group, sign, places, swings, arrivals, counts)
    if end is None:
        doubt |= capped[1] & (counts[-1] >= 1)
    else:
        # What lies deeper than the samples, towards the end itself.
        beyond = (length - sign * end) / (2 * swings[-1])
        doubt |= np.isfinite(beyond) & (np.ceil(np.maximum(beyond, 0)) != np.ceil(np.maximum(counts[-1], 0)))
        turn = np.isfinite(beyond) & ((counts[-1] > counts[-2]) != (beyond > counts[-1]))
        doubt |= turn & (np.abs(counts[-1] - np.floor(counts[-1] + 0.5)) < 2 * np.abs(beyond - counts[-2]))
    low, high = np.minimum(counts[1:], counts[:-1]), np.maximum(counts[1:], counts[:-1])
    low, high = np.maximum(np.ceil(low), 0), np.maximum(np.ceil(high), 0)
    row, which = np.nonzero(high > low)
    number = (high[row, which] - low[row, which]).astype(int)
    lowest = np.repeat(low[row, which], number)
    turns = lowest + np.arange(number.sum()) - np.repeat(number.cumsum() - number, number)
    row, which = np.repeat(row, number), np.repeat(which, number)
    ahead = [surplus(swings[k, which], arrivals[k, which], turns, sign, length[which]) for k in (row, row + 1)]
    near, far = places[row, which], places[row + 1, which]
    found = joined([Brackets(which, turns, np.full(which.shape, sign), near, far, ahead[0], ahead[1]), beside])
    wanted = (found.turns > 0) | (sign > 0)
    wanted &= 2 * found.turns - (sign < 0) <= most
    return rows(found, wanted), np.concatenate([np.flatnonzero(doubt), hard])


def bracketed(group, kind, step, most):
    """Brackets of all crossings of a group, and the ranges that are doubtful."""
    first, last = ends(group.rods, group.piece)
    deepest = ROUGH_DEPTH if kind is np.float32 else 600.0
    capped = first < -deepest, last > deepest
    first, last = np.maximum(first, -deepest), np.minimum(last, deepest)
    order = np.argsort(last - first)
    parts, doubts = [], []
    for start in range(0, order.size, RANGES):
        here = order[start : start + RANGES]
        some, deep = rounded_to(rows(group, here), kind), (capped[0][here], capped[1][here])
        places = places_of(group.dip, here, first[here], last[here], step).astype(kind)
        swings, arrivals = rough_times(some.rods, some.piece, places)
        for sign in (1, -1) if some.rods.slow.max() >= pi else (1,):
            found, doubt = crossed(some, sign, places, swings, arrivals, deep, most)
            parts.append(found._replace(range=here[found.range]))
            doubts.append(here[doubt])
    return joined(parts), np.concatenate(doubts)


def inverse_quadratic(a, b, c, value_a, value_b, value_c):
    """Where on the way from a to b inverse quadratic interpolation puts the zero, or half way where it is unsafe."""
    x, y = (a - b) / (c - b), (value_a - value_b) / (value_c - value_b)
    share = value_a / (value_b - value_a) * value_c / (value_b - value_c)
    share = share + (c - a) / (b - a) * value_a / (value_c - value_a) * value_b / (value_c - value_b)
    return np.where((y * y < x) & ((1 - y) * (1 - y) < 1 - x) & (share > 0) & (share < 1), share, a.dtype.type(0.5))


def approached(group, brackets):
    """Rough crossings by Chandrupatla's method (1997): places, and the slope of the branch there."""
    kind = brackets.left.dtype
    turns, sign = brackets.turns.astype(kind), brackets.sign.astype(kind)
    a, b, value_a, value_b = brackets.left, brackets.right, brackets.value_left, brackets.value_right
    slope = (value_a - value_b) / (a - b)
    fraction = np.full(a.shape, 0.5, dtype=kind)
    secant = value_a / (value_a - value_b)
    inside = (secant > 0.05) & (secant < 0.95)
    fraction[inside] = secant[inside]
    for _ in range(STEPS):
        trial = a + fraction * (b - a)
        swing, arrival = rough_times(group.rods, group.piece, trial)
        value = surplus(swing, arrival, turns, sign, group.rods.length)
        same = (value > 0) == (value_a > 0)
        c, value_c = np.where(same, a, b), np.where(same, value_a, value_b)
        b, value_b = np.where(same, b, a), np.where(same, value_b, value_a)
        a, value_a = trial, value
        near, value_near = (
            np.where(np.abs(a - b) < np.abs(a - c), b, c),
            np.where(np.abs(a - b) < np.abs(a - c), value_b, value_c),
        )
        slope = np.where(np.abs(near - a) > SPREAD, (value_near - value_a) / (near - a), slope)
        fraction = inverse_quadratic(a, b, c, value_a, value_b, value_c)
    return a + fraction * (b - a), slope


def lengths_each(a, b, square, rest):
    """The complete and the incomplete integral of 1/√(a² cos²ψ + b² sin²ψ), by sin²ψ and cos²ψ.

    Gauss's transformation makes a and b equal (DLMF 19.8(i), 19.8(iii)); it is written in sums of positive terms only.
    """
    limit, more = 2 * epsilon() ** 0.5, np.any(a > 0)
    while more:
        more = np.any(np.abs(a - b) > limit * a)
        delta = phase_rate_each(a, b, square, rest)
        total, below = a + b, a + delta
        square, rest = gauss_square_each(square, total, below), gauss_rest_each(a, b, square, rest, delta, below)
        a, b = total / 2, np.sqrt(a * b)
    mean = (a + b) / 2
    return pi / (2 * mean), np.arctan2(np.sqrt(square), np.sqrt(rest)) / mean


class Found(NamedTuple):
    """Tips: the range, place and branch, whether it grows with the tip, the motion with its phase and its times."""

    range: Any
    place: Any
    turns: Any
    sign: Any
    rising: Any
    motion: Any
    phase: Any
    swing: Any
    arrival: Any


def lost_ranges(brackets, parts):
    """The ranges of which not every crossing has been found."""
    wanted = np.bincount(brackets.range)
    return np.flatnonzero(wanted != np.bincount(np.concatenate([part.range for part in parts]), minlength=wanted.size))


def polished(group, brackets, kind):
    """The crossings to rounding, by secants from the rough ones, and the ranges in which one is not found so."""
    place, slope = approached(rounded_to(rows(group, brackets.range), kind), brackets)
    some = rows(group, brackets.range)
    place, slope, length = place.astype(float), slope.astype(float), some.rods.length
    least, most = np.minimum(brackets.left, brackets.right) - 0.01, np.maximum(brackets.left, brackets.right) + 0.01
    rising = (brackets.value_right > brackets.value_left) == (brackets.right > brackets.left)
    todo = np.flatnonzero((brackets.value_left > 0) != (brackets.value_right > 0))
    value, before = np.full(place.shape, np.nan), place.copy()
    parts = []
    for turn in range(8):
        here, branch = rows((some, brackets), todo) if todo.size < place.size else (some, brackets)
        motion = motion_at_each(here.rods.beta, here.piece, place[todo])
        phase = phase_of_each(motion)
        swing, arrival = lengths_each(motion.end / 2, motion.middle / 2, phase.square, phase.rest)
        now = surplus(swing, arrival, branch.turns, branch.sign, length[todo])
        if turn:
            change = place[todo] - before[todo]
            slope[todo] = np.where(change == 0, slope[todo], (now - value[todo]) / np.where(change == 0, 1, change))
        step = now / slope[todo]
        close = np.abs(step) <= 4 * epsilon() * (1 + np.abs(place[todo]))
        close |= np.abs(now) <= 4 * epsilon() * length[todo]
        done = todo[close]
        state, branch = rows((motion, phase, swing, arrival), close), rows(branch, close)
        parts.append(
            Found(
                branch.range,
                place[done],
                branch.turns,
                branch.sign,
                rising[done],
                state[0],
                state[1],
                state[2],
                state[3],
            )
        )
        value[todo], before[todo] = now, place[todo]
        place[todo] -= step
        todo = todo[~close & (place[todo] >= least[todo]) & (place[todo] <= most[todo])]
        if not todo.size:
            break
    return joined(parts), lost_ranges(brackets, parts)


def searched(group, which, kind, step, most):
    """The tips of some ranges, and the ranges of which there may be more or fewer."""
    part = rows(group, which)
    brackets, doubts = bracketed(part, kind, step, most)
    found, lost = polished(part, brackets, kind)
    doubtful = np.concatenate([doubts, lost])
    sure = rows(found, ~np.isin(found.range, doubtful))
    return sure._replace(range=which[sure.range]), which[doubtful]


def tips(group, most):
    """The tips of a group, a list of Found, and the ranges left to the scalar solver."""
    rough = group.rods.slow < ROUGH_SLOW
    found, again = [], [np.zeros(0, dtype=int)]
    for mask, kind in ((rough, np.float32), (~rough, float)):
        which = np.flatnonzero(mask)
        if which.size:
            sure, doubtful = searched(group, which, kind, WIDE, most)
            found.append(sure)
            again.append(doubtful)
    left = np.unique(np.concatenate(again))
    if left.size:
        sure, left = searched(group, left, float, CLOSER, most)
        found.append(sure)
    return found, left


def index_each(found):
    """``index_of`` on arrays."""
    swings = 2 * found.turns - (found.sign < 0)
    positive = found.rising != (found.sign > 0)
    return np.where(positive == (swings % 2 == 0), swings, swings + 1).astype(int)


def clamp_point_each(motion, phase):
    """The point where the motion meets the clamp."""
    b, done = strength_each(motion.near_moment), motion.done_sine
    one = point_near_each(b, motion.sine, done, motion.left_sine)
    product = pair_root_each(np.sqrt(motion.near), done, phase.whole, phase.delta / motion.end)
    delta = phase_rate_each(motion.end / 2, motion.middle / 2, phase.square, phase.rest)
    # 2Δ/sin ψ is no less than ``middle``, the square of which may underflow.
    root_sum = np.maximum(pair_root_sum_each(phase.square, delta), motion.middle)
    return Point(b, point_pole_each(b, done, np.cos(motion.done / 2)), one, product, root_sum)


def rj_pair_each(x, product, root_sum, p, lift, less, twist):
    """R_J(x, y, z, p) by duplication, for x ≥ 0, complex p, and y and z by √y√z and √y + √z.

    lift, less, twist: p + √y√z, p − x and (p − x)(p − y)(p − z), which the rod gives without cancellation. Sums of
    positive terms only in x, y, z. Where √p and −√y are near each other, their sum follows from their difference.
    """
    pair = root_sum * root_sum - 2 * product
    mean = start = (x + pair + 2 * p) / 5
    one, two = start - x, 2 * start - pair
    both = start * start - start * pair + product * product
    reach = np.abs(one) + np.abs(start - p) + np.sqrt(np.abs(both))
    target = (epsilon() / 4) ** 0.125
    scale, total = 1, 0
    while np.any(reach > target * scale * np.abs(mean)):
        root, root_p = np.sqrt(x), np.sqrt(p)
        side, across = root_p * root_sum, root * root_sum
        plus, minus = lift + side, lift - side
        cancels = (np.abs(plus) < np.abs(minus)) & (scale == 1)
        d = (root_p + root) * each_pick(cancels, twist / (less * each_pick(cancels, minus, 1)), plus)
        raised, lifted = (lift + across, np.sqrt(x + product + across))
        end = 2 * root_p * raised / d
        total = total + each_arctan_share(twist / (scale * scale * scale * d * d), end) / (scale * d)
        pair = root_sum * (root_sum + 2 * root) / 4
        x, p = (x + product + across) / 4, raised / 4
        product, root_sum = root_sum * lifted / 4, np.sqrt(root_sum * (root_sum + 2 * root + 2 * lifted)) / 2
        lift, mean = p + product, (x + pair + 2 * p) / 5
        scale *= 4
    size = scale * mean
    a, b, c = one / size, two / size, both / (size * size)
    d = -(a + b) / 2
    e2 = a * b + c - 3 * d * d
    e3 = a * c + 2 * e2 * d + 4 * d * d * d
    e4 = (2 * a * c + e2 * d + 3 * d * d * d) * d
    e5 = a * c * d * d
    low = -3 * e2 / 14 + e3 / 6 + 9 * e2 * e2 / 88 - 3 * e4 / 22 - 9 * e2 * e3 / 52 + 3 * e5 / 26
    high = -e2 * e2 * e2 / 16 + 3 * e3 * e3 / 40 + 3 * e2 * e4 / 20 + 45 * e2 * e2 * e3 / 272
    high = high - 9 * (e3 * e4 + e2 * e5) / 68
    return (1 + low + high) / (scale * mean * np.sqrt(mean)) + 6 * total


def shift_each(motion, point, root, square, rest):
    """W as real and imaginary part: ∫e^{iθ} from the tip is e^{iφ}(σ + W)."""
    b, near, far = point.strength, np.sqrt(motion.near), np.sqrt(motion.far)
    twist = each_complex_of(0.0, 0.0)
    lift = pair_lift_each(near, far, motion.uneven, motion.half_cosine, square, rest)
    pole, lifted, less = each_complex_of(point.pole, -b), each_complex_of(lift, -b), each_complex_of(root, -b)
    third = rj_pair_each(point.one, point.product, point.root_sum, pole, lifted, less, twist)
    return w_real_each(b, third.imag), w_imag_each(b, third.real)


def kink_at_each(first, second, point, root, q, m, square, rest):
    """The part of η∫cos²(θ − α) without integral; towards the tip its terms are large and cancel in the first form."""
    b, x, product = point.strength, point.pole, point.product
    delta = np.maximum(phase_rate_each(first, second, square, rest), second * np.sqrt(square))
    across, near_root = np.sqrt(square * rest), np.sqrt(point.one)
    others = others_sum_each(q, root)
    gap = pole_gap_each(x, np.abs(x), others, others_product_each(b, m, root, others), product)
    far = arc_kink_each(square, delta, across, b, x, near_root, product)
    return each_pick(x > 1, arc_kink_tip_each(first, second, delta, across, b, x, near_root, gap), far)


def second_kind_each(a, b, square, rest, arrival):
    """(b² − a²)∫sin²ψ over the same range as ``arrival``, the length, by the same transformation (DLMF 19.8.19)."""
    limit, more, weight, growth = 2 * epsilon() ** 0.5, np.any(a > 0), 1, 0
    while more:
        more = np.any(np.abs(a - b) > limit * a)
        delta = phase_rate_each(a, b, square, rest)
        growth = growth - weight * second_kind_step_each(a, b, square, rest, delta, arrival)
        total, below = a + b, a + delta
        square, rest = gauss_square_each(square, total, below), gauss_rest_each(a, b, square, rest, delta, below)
        a, b, weight = total / 2, np.sqrt(a * b), 2 * weight
    return growth


def arc_to_each(beta, motion, point, square, rest, extent):
    """The arc from the tip to a point, at ψ, of the given length."""
    sine, cosine = np.sin(motion.tip), np.cos(motion.tip)
    root = far_root_each(motion.near, np.cos(motion.half_width))
    w_re, w_im = shift_each(motion, point, root, square, rest)
    y, z = arc_y_each(sine, cosine, extent, w_re, w_im), arc_z_each(sine, cosine, extent, w_re, w_im)
    first, second = motion.end / 2, motion.middle / 2
    q, m = rest_stiffness_each(beta, cosine), tip_cubic_each(beta, sine)
    kink = kink_at_each(first, second, point, root, q, m, square, rest)
    growth = second_kind_each(first, second, square, rest, extent)
    return Arc(y, z, arc_square_each(beta, cosine, first, root, extent, y, kink, growth))


def far_point_each(motion):
    """The far turning point."""
    b = strength_each(motion.near_moment)
    pole = point_pole_each(b, motion.sine, np.cos(motion.half_width))
    return Point(b, pole, 0, far_pair_root_each(motion.end), motion.middle)


def positions(rods, found):
    """∫cos θ, ∫sin θ and η∫cos²(θ − α) along the rods; whole half-swings only for those that have any."""
    motion, phase = found.motion, found.phase
    beta = rods.beta
    point = clamp_point_each(motion, phase)
    part = arc_to_each(beta, motion, point, phase.square, phase.rest, found.arrival)
    columns = [found.sign * column for column in part]
    swung = np.flatnonzero(found.turns > 0)
    if swung.size:
        some, motion, swing, turns = rows((rods, found.motion, found.swing, found.turns), swung)
        one, none = np.full(swung.shape, 1.0), np.zeros(swung.size)
        far = far_point_each(motion)
        whole = arc_to_each(some.beta, motion, far, one, none, swing)
        for column, change in zip(columns, whole, strict=True):
            column[swung] += 2 * turns * change
    return columns


def bent(group, found, most):
    """The equilibria of tips on their branches."""
    index = index_each(found)
    wanted = np.flatnonzero(index <= most)
    if wanted.size < index.size:
        found, index = rows(found, wanted), index[wanted]
    some = rows(group, found.range)
    rods, motion, phase = some.rods, found.motion, found.phase
    beta = rods.beta
    cosine = np.cos(motion.tip)
    y, z, square = positions(rods, found)
    speed = phase.delta * phase.whole / (motion.end * motion.sine) * np.sqrt(2 * motion.done_sine * motion.left_sine)
    gamma = 2 * beta * cosine
    energy = gamma * rods.length / 2 - 2 * beta * y - square
    scale, side = rods.scale, rods.side
    return Columns(
        rods.case,
        side * (some.rank - LAST),
        side * found.place,
        side * (motion.tip + 2 * pi * some.turns),
        -side * found.sign * np.ldexp(speed, scale),
        np.ldexp(gamma, 2 * scale),
        np.ldexp(y, -scale),
        side * np.ldexp(z, -scale),
        np.ldexp(energy, scale),
        index,
    )


def straight_rods(straight, most):
    """The rods that stay straight."""
    rods, rest, length = straight.rods, straight.rest, straight.rods.length
    cosine, sine = np.cos(rest.extra) + 0 * length, np.sin(rest.extra) + 0 * length
    for _ in range(rest.quarters % 4):
        cosine, sine = -sine, cosine
    soft = -rest.stiffness
    index = np.where(soft > 0, np.floor(length * np.sqrt(np.abs(soft)) / pi + 0.5), 0).astype(int)
    energy = -(rods.beta * cosine) * length
    here = rods.scale
    extent = np.ldexp(length, -here)
    gamma = np.ldexp(2 * rods.beta * cosine, 2 * here)
    found = Columns(
        rods.case,
        0 * index,
        0 * extent,
        rods.clamp_angle,
        0 * extent,
        gamma,
        cosine * extent,
        sine * extent,
        np.ldexp(energy, here),
        index,
    )
    return rows(found, index <= most)


def on_arrays(rods, most):
    """The equilibria of rods with tips below the clamp angle, the straight ones, and the cases left to the scalar
    solver."""
    found, straight, doubtful = groups(rods)
    parts, left = [no_columns()], [doubtful]
    for group in found:
        tip, lost = tips(group, most)
        left.append(group.rods.case[lost])
        parts += [bent(group, some, most) for some in tip]
    parts += [straight_rods(some, most) for some in straight]
    return joined(parts), np.concatenate(left)


def short(found, size, most):
    """The rods of which an equilibrium is missing: those of even and of odd index differ by one in number (the
    degree of the equation is that of the rod without load), and the least energy has index 0."""
    if most < np.inf:
        return np.bincount(found.case, minlength=size) == 0
    return np.bincount(found.case, weights=1 - 2 * (found.index % 2), minlength=size) != 1


def at_once(beta, length, clamp_angle, size, most):
    """The equilibria on arrays, and the rods that are left to the scalar solver."""
    scale = np.full(size, np.frexp(beta)[1] // 2)
    force, extent = np.ldexp(beta, -2 * scale), np.ldexp(length, scale)
    slow = extent * np.sqrt(force)
    clamp = np.full(size, clamp_angle)
    good = (slow < SLOWEST) & (slow > epsilon())
    rods = both_sides_each(rows(Rods(np.arange(size), 1, scale, force, extent, clamp, slow), good))
    found, doubtful = on_arrays(rods, most)
    return found, np.unique(np.concatenate([np.flatnonzero(~good), doubtful, np.flatnonzero(short(found, size, most))]))


def one_by_one(beta, length, clamp_angle, max_index):
    """The equilibria of one rod by the scalar solver."""
    found = all_equilibria(beta, length, clamp_angle, max_index)
    return Columns(
        np.zeros(len(found), dtype=int),
        np.arange(len(found)),
        np.zeros(len(found)),
        np.array([item.tip_angle for item in found], dtype=float),
        np.array([item.clamp_curvature for item in found], dtype=float),
        np.array([item.gamma for item in found], dtype=float),
        np.array([item.y for item in found], dtype=float),
        np.array([item.z for item in found], dtype=float),
        np.array([item.energy for item in found], dtype=float),
        np.array([item.index for item in found], dtype=int),
    )


def element(case, values):
    """A parameter of one rod as a number; what is folded stays as it is."""
    return float(values[case])


def in_order_each(found):
    """``in_order`` on arrays: tips that are nearer than rounding as equal, where rounding would exchange them."""
    tip, alike = found.tip_angle, found.case[1:] == found.case[:-1]
    wrong = alike & (tip[1:] < tip[:-1])
    while wrong.any():
        tip = np.concatenate([tip[:1], np.where(wrong, tip[:-1], tip[1:])])
        wrong = alike & (tip[1:] < tip[:-1])
    return found._replace(tip_angle=tip)


def block(beta, length, clamp_angle, size, max_index):
    """The equilibria of one block: on arrays, and those of few rods, or where arrays leave a doubt, one by one."""
    most = np.inf if max_index is None else max_index
    found, lost = no_columns(), np.arange(size)
    if size >= FEWEST:
        with np.errstate(all="ignore"):
            found, lost = at_once(beta, length, clamp_angle, size, most)
    if lost.size:
        parts = [rows(found, ~np.isin(found.case, lost))]
        for case in lost.tolist():
            one = one_by_one(element(case, beta), element(case, length), element(case, clamp_angle), max_index)
            parts.append(one._replace(case=one.case + case))
        found = joined(parts)
    return in_order_each(rows(found, np.lexsort((found.place, found.rank, found.case))))


def slab(grid, which, values):
    """Some of a parameter's values, by a slice of their flat numbers in the grid; what is folded stays as it is."""
    return np.broadcast_to(values, grid).flat[which]


def sweep_arrays(beta, length, clamp_angle, grid, max_index):
    """Every equilibrium of every rod, sorted by rod and then by tip angle; all arguments broadcast to ``grid``.

    max_index: the largest index wanted, or None for all. The memory needed besides the result is that of one block.
    """
    number, parts = prod(grid), [no_columns()]
    for start in range(0, number, BLOCK):
        which = slice(start, min(start + BLOCK, number))
        found = block(
            slab(grid, which, beta),
            slab(grid, which, length),
            slab(grid, which, clamp_angle),
            which.stop - start,
            max_index,
        )
        parts.append(found._replace(case=found.case + start))
    return joined(parts)


# Interface


@dataclass(frozen=True, slots=True)
class Equilibrium:
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
    index: int
    rod: Rod
    swing: Swing | None


def equilibria(beta, length, clamp_angle, *, max_index=None) -> list[Equilibrium]:
    """All equilibria of one rod, sorted by tip angle.

    beta: terminal force over bending stiffness, F/(EI) ≥ 0.
    length: length of the rod, > 0.
    clamp_angle: θ(0), the angle from the y axis to the tangent at the clamp, in radians.
    max_index: the largest index that is wanted, 0 for stable equilibria only; None for all.

    All in one unit of length. Raises TypeError or ValueError, naming the argument, before any work.
    """
    beta, length = not_negative("beta", beta), positive("length", length)
    clamp_angle = real("clamp_angle", clamp_angle)
    return all_equilibria(beta, length, clamp_angle, index_limit(max_index))


@dataclass(frozen=True, slots=True)
class Shape:
    """A rod at the arc lengths asked for: theta (from y to the tangent), curvature θ′, and the position y, z."""

    theta: Any
    curvature: Any
    y: Any
    z: Any


def on_rod(equilibrium, s):
    """The arc lengths as doubles; TypeError or ValueError if the first is no equilibrium, or an s not on its rod."""
    if not isinstance(equilibrium, Equilibrium):
        raise TypeError(f"equilibrium must be one that equilibria gives, got {equilibrium!r}")
    places, length = all_real("s", s), length_of(equilibrium.rod)
    refuse("s", places, (places < 0) | (places > length), f"must lie in [0, {length!r}], the rod")
    return places


def shape(equilibrium: Equilibrium, s, *, position=True) -> Shape:
    """The shape of an equilibrium at arc lengths s from the clamp, a number or an array within [0, length].

    position: whether y and z are wanted; without them they are None, and θ takes a fraction of the time.

    theta, curvature, y and z have the shape of s. Raises TypeError or ValueError where an s is not on the rod.
    """
    found = shape_at(equilibrium, on_rod(equilibrium, s), position)
    return Shape(*(part if part is None else part[()] for part in found))


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


def sweep(beta, length, clamp_angle, *, max_index=None) -> Sweep:
    """All equilibria of many rods: the arguments are numbers or arrays, broadcast against one another.

    max_index: the largest index that is wanted, 0 for stable equilibria only; None for all.

    Raises TypeError or ValueError, naming the argument and the flat index of a bad value, before any work.
    """
    beta, length = all_not_negative("beta", beta), all_positive("length", length)
    clamp_angle = all_real("clamp_angle", clamp_angle)
    grid, limit = common_shape(Given(beta, length, clamp_angle)), index_limit(max_index)
    found = sweep_arrays(beta, length, clamp_angle, grid, limit)
    return Sweep(
        found.case,
        found.tip_angle,
        found.clamp_curvature,
        found.gamma,
        found.y,
        found.z,
        found.energy,
        found.index,
    )
