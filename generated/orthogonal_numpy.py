"""Clamped rod, field orthogonal to the terminal force: NumPy, double precision.

Emitted by `derive emit` from the scene 'orthogonal': do not edit, change the scene, the theory or the kernels.

Gives: equilibria, shape, sweep, folds, exchanges.
Load case: orthogonal. Valid for beta >= 0, eta >= 0, length > 0, any clamp_angle.
Formulas, each proved equal to its derivation:
    arc_kink (DLMF 19.29(ii)), arc_kink_each (DLMF 19.29(ii)), arc_kink_tip, arc_kink_tip_each,
    arc_square (DLMF 19.29(ii)), arc_square_each (DLMF 19.29(ii)), arc_y (exsl36), arc_y_each (exsl36),
    arc_z (exsl41), arc_z_each (exsl41), before_cosine (DLMF 22.8(i)), before_over (DLMF 22.8(i)),
    before_sine (DLMF 22.8(i)), chi_cosine (DLMF 22.6(iii)), chi_coversine (DLMF 22.6(iii)),
    chi_rate (DLMF 22.6(iii)), chi_scale (DLMF 22.6(iii)), chi_square (DLMF 4.21(iii)),
    chi_square_each (DLMF 4.21(iii)), chi_versine (DLMF 22.6(iii)), far_cosine (DLMF 22.4(iii)), far_pair_root,
    far_pair_root_each, far_root, far_root_each, far_sine (DLMF 22.4(iii)), gauss_gap (DLMF 19.8(i)),
    gauss_gap_each (DLMF 19.8(i)), gauss_less (DLMF 19.8(iii)), gauss_more (DLMF 19.8(iii)),
    gauss_rest (DLMF 19.8(iii)), gauss_rest_each (DLMF 19.8(iii)), gauss_square (DLMF 19.8(iii)),
    gauss_square_each (DLMF 19.8(iii)), half_rest (DLMF 22.6(iii)), half_rest_beyond (DLMF 22.6(iii)),
    half_rest_beyond_each (DLMF 22.6(iii)), half_rest_each (DLMF 22.6(iii)), half_square (DLMF 22.6(iii)),
    half_square_beyond (DLMF 22.6(iii)), half_square_beyond_each (DLMF 22.6(iii)),
    half_square_each (DLMF 22.6(iii)), lag_step (DLMF 19.8(iii)), lag_step_each (DLMF 19.8(iii)),
    landen_less (DLMF 19.8(ii)), landen_more (DLMF 19.8(ii)), landen_root (DLMF 19.2.4),
    landen_tangent (DLMF 19.8(ii)), near_by_phase (DLMF 19.25.35), others_product, others_product_each,
    others_sum, others_sum_each, pair_lift, pair_lift_each, pair_root, pair_root_each,
    pair_root_sum (DLMF 19.26(iii)), pair_root_sum_each (DLMF 19.26(iii)), phase_bend (DLMF 19.8(iii)),
    phase_bend_each (DLMF 19.8(iii)), phase_lead, phase_lead_each, phase_rate (DLMF 19.2.4),
    phase_rate_each (DLMF 19.2.4), phase_ratio (DLMF 19.2.4), phase_sum, phase_sum_each, point_near,
    point_near_each, point_pole (exsl22), point_pole_each (exsl22), rest_fall, rest_fall_each, rest_moment,
    rest_moment_each, rest_stiffness, rest_stiffness_each, rj_delta_imag (DLMF 19.26(iii)),
    rj_delta_imag_each (DLMF 19.26(iii)), rj_delta_real (DLMF 19.26(iii)), rj_delta_real_each (DLMF 19.26(iii)),
    shot_bend, shot_bend_each, stiffness_beside, strength (exsl17), strength_each (exsl17),
    tangent_exchanged (DLMF 22.17(i)), tip_cubic, tip_cubic_each, turn_level, turn_over (DLMF 4.21(iii)),
    turn_speed (exsl8), turn_tilt, turn_tilt_apart, turn_under, unit_sine (DLMF 4.14.7), w_imag (DLMF 19.29(ii)),
    w_imag_each (DLMF 19.29(ii)), w_real (DLMF 19.29(ii)), w_real_each (DLMF 19.29(ii))
Digest of the inputs: sha256 d77d63bf5d90407108bf7961fbdb67fc8d3ac7467c0c5cd63dc7f22cac394f5e
"""

from __future__ import annotations

from cmath import atanh
from cmath import log as complex_log
from cmath import sqrt as complex_sqrt
from collections import namedtuple
from collections.abc import Iterable
from functools import cache
from itertools import pairwise
from math import (
    asin,
    asinh,
    atan,
    atan2,
    ceil,
    cos,
    exp,
    floor,
    frexp,
    hypot,
    inf,
    isfinite,
    ldexp,
    log,
    log2,
    pi,
    prod,
    sin,
    sinh,
    sqrt,
    tan,
)
from operator import index
from typing import Any

import numpy as np

__all__ = ["Equilibrium", "Exchange", "Fold", "Shape", "Sweep", "equilibria", "exchanges", "folds", "shape", "sweep"]

# Constants

COUNTED = 2**53  # an index beyond is none that a rod has, and no double
LARGEST = 2.0**1020
MANY = 100_000  # equilibria of one rod: half a minute, and half a gigabyte
SHORT_SLOW = 1.4 * pi  # ℓ√(β + η) up to which this takes less time than samples of ranges
LEVEL = 1e-9  # a couple at the clamp times the length squared from which rods are not nearly straight
SHOT_SERIES_SLOW = 0.6  # ℓ√(β + η) up to which the series of ℘ is right to 3e-13
REACH = 1e-3  # by how much more than a bound tips are looked for
SLACK = 0.02  # by how much more than the bound samples must be apart for that
CLOSEST = 2.0**-26  # least distance of samples, as a share of how far a tip may be from the clamp angle
UNSURE = 1e-10  # as a share of the same, what is missed of which the hundredth part may be wrong
ALIKE = 4e-16  # as ``UNSURE``, what rounding may have made of zero
DEEP = 30  # places beyond which tips are told by other means
APART = 0.7  # the quotient of the rates below which Landen's steps are the smaller ones: 1/√2
WITHIN = 2  # spacings of the length to which time maps are right
TRIES = 24
NEAR = 0.5  # how far a tip may be from where it was aimed, as a difference of places
TINIEST = 1e-300  # instead of less, where it is divided by
SAFE = 1e-9  # bounds count where they hold by this much more than they must
NEAREST = 0.3  # about the least distance of places between which a branch may have two extrema, 0.6 seen
FEW = 64  # points up to which each is computed by itself
SHORTEST = 2  # bins in a unit of a rod's own length, at least: of a long rod with few points most would have none
LARGE = 4.0  # an angle beyond which a rounding more would show
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
BLURRED = 4  # roundings of the clamp angle within which directions are taken for it
SHOT_SLOW = 1.49 * pi  # ℓ√(β + η) up to which the index is known (``block_short``); soon samples are too many
STRAIGHT = 1e-9  # a couple at the clamp times the length squared from which rods are not nearly straight
ROUGH_BLUR = 5e-4  # what is missed is right to half of that in single precision (docs/solver.md)
ROUGH_SHOT = 1.2 * pi  # ℓ√(β + η) from which only to
WIDER = 16.0  # times as much
ROUGH_HALVINGS = 2  # of spans in single precision
BLUR = 1.5e-11  # the same in double precision, on all
SPAN_HALVINGS = 18  # of the rest
EVEN = 3.0  # step between tips, over the steepest slope
SHOTS = 512  # rods at once
FEWEST_SPANS = 16
AT_ONCE = 2048  # rows at once where there are many arrays: they stay in the cache, and in memory that is there already
MOVING = 1e-6  # a step after which another one is not yet as small as rounding
AIMS = 4  # steps towards a zero
AIM_SPREAD = 1e-6  # distance of two shares from which they tell a slope
AGAIN = 4  # as often for those that are still far
SETTLINGS = 8  # steps to rounding; of most tips the first two suffice
SECANT_SPREAD = 1e-9  # distance of two shares from which they tell a slope better than it is known already
SETTLED = 2.0**-43  # as a share of the reach, what is missed where two more steps leave nothing but rounding
VALUES = 8192  # points of rods at once: arrays that stay in the cache
POINTS_PER = 8.9  # points for each unit of ℓ√(β + η), and
POINTS_MORE = 2.8  # as many more, which leave out less than 2⁻⁵³ of the integral (docs/solver.md)
REFINED = 4  # Newton's steps to a root of a Legendre polynomial: of the last one the weight would show half the digits
SERIES_END = 0.3  # σ√(β + η) up to which the series of ℘(σ) is right to rounding: no less than 1.49π/16
NEARLY = 0.3  # how far η may be below the value at which a ridge appears, and still slow motions down, over β + η
SHARP = 0.01  # the same from which on the dips are too narrow for the samples here
SURELY = 1e-5  # bounds count where they hold by this much more than they must
ROUGH_SLOW = 12  # ℓ√(β + η) up to which single precision holds the places of all tips but the most extreme
HALVINGS = 4  # of the stretch at the low end in which no motion arrives in time
LATEST = 12.0  # places beyond which a count is its limit, but for the doubts of a hundred thousandth of all ranges
SMALLEST = 1e-30  # instead of less, where it is divided by
ROUGH_DEPTH = 28.0  # places up to which squares of offsets are numbers in single precision
RANGES = 1024  # ranges at once: arrays that stay in the cache
AROUND = np.concatenate([-0.5 ** np.arange(13), [0], 0.5 ** np.arange(12, -1, -1)])  # places about a dip
FINER = np.linspace(0, 1, 17)  # shares of the way from one sample to the next but one
STEPS = 3  # rough steps, after which most places are right to single precision
SPREAD = 2.0**-9  # distance of two places from which they tell the slope of a branch in single precision
TOLD = 1e-10  # change of a place from which the change of a length tells the slope
SECANTS = 2  # evaluations before any place is looked at for being right to rounding: next to none is
EASE = 2  # how often the rounding that is taken for none is doubled: times of long rods have more of it
NOISE = 3  # roundings of the length that the times may have of their own
WIDE = 0.75  # first step between samples
CLOSER = 0.25  # the same where those leave a doubt
RESTING = 0.07  # θ″ over β + η up to which a motion that ends there loses more than a few roundings without that
ASIDE = 0.7  # how far from a shoulder the end of a motion may be and be told better from there
LAST = 100  # beyond the rank of any range
FOLDS_SLOWEST = 1000  # ℓ√(β + η) to which folds are searched for: hundreds of them, in minutes
WINDOW = 0.5
FINEST = 0.4
ROUGH = 0.02
FURTHEST = 3
LEAP = 1e-5
LEAST = 1e-12
EXCHANGES_SLOWEST = 100  # the same for exchanges, a search for folds at each of many forces
CLOSE = 1e-3
FORCES = 20  # forces in a range by whose ends loads differ by a factor e


# Special functions


def in_a_line(value):
    """The text of a value for an error, which is one line."""
    return " ".join(repr(value).split())


def real(name: str, value: object) -> float:
    """A finite real number as a float; TypeError or ValueError names the argument that is none."""
    numeric = getattr(getattr(value, "dtype", None), "kind", "f") in "fiu" and not getattr(value, "ndim", 0)
    masked = hasattr(value, "mask")
    if masked or isinstance(value, (str, bytes, bool, complex)) or not numeric or not hasattr(value, "__float__"):
        raise TypeError(f"{name} must be a real number, got {in_a_line(value)}")
    try:
        number = float(value)
    except (TypeError, ValueError):
        raise TypeError(f"{name} must be a real number, got {in_a_line(value)}") from None
    except OverflowError:
        raise ValueError(f"{name} must be finite, got a number too large for a double") from None
    if not isfinite(number):
        raise ValueError(f"{name} must be finite, got {value!r}")
    return number


def less_quarters(angle, quarters):
    """angle − quarters·π/2, with π/2 in two parts of which the first has 33 bits, so that nothing is lost."""
    return (angle - quarters * 1.5707963267341256) - quarters * 6.077100506506192e-11


def larger(x, y):
    """The larger one."""
    return x if x > y else y


def deepest(width):
    """How far down, in the logarithm of the share of a width, the square of an offset is still a number."""
    return max(40.0, 300 + log(width))


def complex_of(real, imaginary):
    """The complex number of a real and an imaginary part."""
    return complex(real, imaginary)


def arctan_share(z, end):
    """R_C(1, end) for complex end = 1 + z: arctan(√z)/√z (DLMF 19.2.18), by its series where z is small.

    The logarithm is of a number near 1 unless z is large, and then its last digits are few.
    """
    size = abs(z)
    if size < 1e-3:
        return 1 - z * (1 / 3 - z * (1 / 5 - z * (1 / 7 - z * (1 / 9 - z / 11))))
    root = complex_sqrt(-z)
    if size < 0.5:
        return atanh(root) / root
    return complex_log((1 + root) * (1 + root) / end) / (2 * root)


def arc_excess(x):
    """x − sin x, by its series where x is small."""
    if x > 1:
        return x - sin(x)
    square, share = x * x, 1.0
    for number in (272, 210, 156, 110, 72, 42, 20):
        share = 1 - square / number * share
    return x * square / 6 * share


def plus_quarters(angle, quarters):
    """angle + quarters·π/2, rounded once where the sum is large."""
    return (angle + quarters * 6.077100506506192e-11) + quarters * 1.5707963267341256


def apart_by_quarters(angle, quarters):
    """Two numbers that add up to angle + quarters·π/2, of which only the sum is rounded at its size."""
    return quarters * 1.5707963267341256, angle + quarters * 6.077100506506192e-11


def in_doubles(x):
    """Whether this is an array of doubles."""
    return isinstance(x, np.ndarray) and x.dtype.char == "d"


def each_sin(x):
    """sin x. Of doubles by the tangent of x/2, which takes a fraction of the time of NumPy's sine, to 1.3 spacings."""
    if not in_doubles(x):
        return np.sin(x)
    tangent = np.tan(x / 2)
    below = tangent * tangent
    below += 1
    tangent += tangent
    tangent /= below
    return tangent


def each_less_quarters(angle, quarters):
    """angle − quarters·π/2, with π/2 in two parts of which the first has 33 bits, so that nothing is lost."""
    return (angle - quarters * 1.5707963267341256) - quarters * 6.077100506506192e-11


def each_cos(x):
    """cos x, likewise; to as much of 1."""
    if not in_doubles(x):
        return np.cos(x)
    tangent = np.tan(x / 2)
    below, above = tangent * tangent, 1 - tangent
    below += 1
    tangent += 1
    above *= tangent
    above /= below
    return above


def each_any_of(condition):
    """Whether it holds anywhere, in a fifth of the time of NumPy's function for that."""
    return np.logical_or.reduce(condition, axis=None)


def each_pick(condition, yes, no):
    """``yes`` where the condition holds, else ``no``; whole numbers take the precision of what they meet."""
    chosen = np.where(condition, yes, no)
    return chosen.astype(np.float32) if chosen.dtype.kind in "ib" else chosen


def each_spacing(x):
    """The each_spacing of numbers just above 1, in the precision of the array."""
    return float(np.finfo(x.dtype).eps)


def each_hypot(x, y):
    """√(x² + y²) of numbers whose squares are none too small."""
    return np.sqrt(x * x + y * y)


def each_complex_of(real, imaginary):
    """The complex numbers of real and imaginary parts."""
    result = np.empty(np.maximum(real, imaginary).shape, dtype=complex)
    result.real, result.imag = real, imaginary
    return result


def each_complex_sqrt(z):
    """The principal √z by real roots, in a third of the time of NumPy's."""
    real, imaginary = z.real, z.imag
    larger_part = np.sqrt((np.abs(z) + np.abs(real)) / 2)
    smaller_part = imaginary / (2 * np.maximum(larger_part, 1e-300))
    right = real >= 0
    if right.all():
        return each_complex_of(larger_part, smaller_part)
    return each_complex_of(
        np.where(right, larger_part, np.abs(smaller_part)),
        np.where(right, smaller_part, np.copysign(larger_part, imaginary)),
    )


def each_complex_atanh(root, end):
    """artanh r for Re r ≥ 0 and end = 1 − r², by real functions: no digits are lost where r is small, or near 1."""
    x, y, left, below = root.real, root.imag, end.real, end.imag
    ahead, less, more, small = 1 + root, 1 - x, 1 + x, x < 0.5
    # 1/|1 − r|², and the argument of (1 + r)/(1 − r): by its tangent 2 Im r/(1 − |r|²), or of (1 + r)²/end.
    share = np.where(small, 1 / (less * less + y * y), (more * more + y * y) / (left * left + below * below))
    turned = ahead * ahead * end.conjugate()
    angle = np.arctan2(np.where(small, 2 * y, turned.imag), np.where(small, left - 2 * y * y, turned.real))
    return each_complex_of(np.log1p(4 * x * share) / 4, angle / 2)


def each_arctan_share(z, end):
    """R_C(1, end) for complex end = 1 + z: arctan(√z)/√z, by its series where z is small (DLMF 19.2.18)."""
    size = np.abs(z)
    far = size >= 1e-3
    if far.all():
        root = each_complex_sqrt(-z)
        return each_complex_atanh(root, end) / root
    if not each_any_of(size >= 3e-6):
        return 1 - z * (1 / 3 - z / 5)
    share = 1 - z * (1 / 3 - z * (1 / 5 - z * (1 / 7 - z * (1 / 9 - z / 11))))
    if each_any_of(far):
        share[far] = each_arctan_share(z[far], end[far])
    return share


def each_arc_excess(x):
    """x − sin x, by its series where x is small."""
    square = x * x
    share = 1.0
    for number in (272, 210, 156, 110, 72, 42, 20):
        share = 1 - square / number * share
    return np.where(x > 1, x - each_sin(x), x * square / 6 * share)


def roughly(work):
    """What some work gives, where a few digits of it will do: doubles have no fewer."""
    return work()


# Formulas, as derived


def rest_fall(eta, stiffness, double_cosine, double_sine, middle_sine, middle_cosine, half_sine, half_cosine):
    """V(rest + middle − half) − V(rest + middle + half), from a direction without moment.

    Proved as swing.rest_fall.
    """
    return (
        4
        * half_sine
        * half_cosine
        * (
            2
            * middle_sine
            * middle_cosine
            * (
                stiffness
                - 2
                * eta
                * double_cosine
                * (middle_sine * middle_sine + (1 - 2 * middle_sine * middle_sine) * half_sine * half_sine)
            )
            - eta
            * double_sine
            * (
                (3 - 4 * middle_sine * middle_sine) * middle_sine * middle_sine
                + (1 - 8 * middle_sine * middle_sine * middle_cosine * middle_cosine) * half_sine * half_sine
            )
        )
    )


def rest_moment(eta, stiffness, double_cosine, double_sine, sine, cosine):
    """θ″ at an offset from a direction without moment, by the sine and cosine of half the offset.

    Proved as swing.rest_moment.
    """
    return (
        2
        * sine
        * (
            cosine * (stiffness - 2 * eta * double_cosine * sine * sine)
            - 0.5 * eta * double_sine * sine * (3 - 4 * sine * sine)
        )
    )


def shot_bend(beta, eta, growth):
    """a bound of |∂²θ(0)/∂θ(ℓ)²| for every tip, by cosh(ℓ√(β + η)) − 1: it solves G″ = (β + η)G + (β + 2η)cosh².

    Proved as swing.shot_bend.
    """
    return growth * (beta + 2 * eta) * (3 + growth) / (3 * beta + 3 * eta)


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


def tangent_exchanged(first, second, tan_phase):
    """Tan ψ of the same length where a and b are exchanged.

    Equation DLMF 22.17(i); proved as swing.tangent_exchanged.
    """
    return second * tan_phase / first


def gauss_gap(gap, total):
    """a′ − b′ after Gauss's step, by gap = a − b and total = a′ + b′.

    Equation DLMF 19.8(i); proved as swing.gauss_gap.
    """
    return 0.25 * gap * gap / total


def gauss_less(share, root, other_root):
    """by what share tan²ψ is less after Gauss's step, by root = √(1 + tan²ψ) and other_root = √(1 + (b/a)² tan²ψ).

    Equation DLMF 19.8(iii); proved as swing.gauss_less.
    """
    return (
        0.5
        * share
        * (
            1
            + root
            * (2 - share)
            * ((1 - share) ** 2 + other_root * other_root)
            / ((other_root + root * (1 - share) ** 2) * (1 + root * other_root))
        )
    )


def landen_root(bent):
    """√(a² + b² tan²ψ)/a.

    Equation DLMF 19.2.4; proved as swing.landen_root.
    """
    return sqrt(1 + bent * bent)


def landen_less(share, bent, root):
    """by what share tan ψ is less after Landen's step.

    Equation DLMF 19.8(ii); proved as swing.landen_less.
    """
    return (share + bent * bent / (1 + root)) / (1 + root)


def landen_tangent(share, tan_phase, root):
    """Tan ψ after Landen's step.

    Equation DLMF 19.8(ii); proved as swing.landen_tangent.
    """
    return tan_phase * (2 - share) / (1 + root)


def stiffness_beside(eta, stiffness, double_cosine, double_sine, sine, cosine):
    """dθ″/dθ at an offset from a direction without moment, by the sine and cosine of half the offset.

    Proved as swing.stiffness_beside.
    """
    return (
        stiffness * (1 - 2 * sine * sine)
        - eta * sine * (2 * double_cosine * sine * (3 - 4 * sine * sine) + double_sine * cosine * (3 - 8 * sine * sine))
    )


def turn_speed(sine, done_sine, left_sine, whole, rate):
    """|θ_σ| by the phase's sum and the rate of χ over that at the turning points.

    Equation exsl8; proved as swing.turn_speed.
    """
    return whole * rate * sqrt(2) * sqrt(done_sine * left_sine) / sine


def far_root(near, cosine):
    """ê₁, the value of x at the far turning point, by P and cos D.

    Proved as swing.far_root.
    """
    return 0.125 * near * cosine


def rj_delta_real(eta, b, double_cosine):
    """The real part of (p − X₁)(p − X₂)(p − X₃), p = x − ib, for the duplication of R_J, by cos 2(φ − α).

    Equation DLMF 19.26(iii); proved as swing.rj_delta_real.
    """
    return 0.25 * eta * double_cosine * b * b


def rj_delta_imag(eta, b, double_sine):
    """The imaginary part of (p − X₁)(p − X₂)(p − X₃), p = x − ib, for the duplication of R_J, by sin 2(φ − α).

    Equation DLMF 19.26(iii); proved as swing.rj_delta_imag.
    """
    return 0.25 * eta * double_sine * b * b


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


def arc_y(sine, cosine, w_re, w_im):
    """∫y′ dσ from the tip to the point less what it is along the tip's direction, by sin φ and cos φ.

    Equation exsl36; proved as swing.arc_y.
    """
    return cosine * w_re - sine * w_im


def arc_z(sine, cosine, w_re, w_im):
    """∫z′ dσ from the tip to the point less what it is along the tip's direction, by sin φ and cos φ.

    Equation exsl41; proved as swing.arc_z.
    """
    return sine * w_re + cosine * w_im


def rest_stiffness(beta, eta, cosine, double_cosine):
    """dθ″/dθ by cos θ and cos 2(θ − α), where small rotations h obey h″ = (dθ″/dθ)h; at the tip it is q.

    Proved as swing.rest_stiffness.
    """
    return beta * cosine + eta * double_cosine


def tip_cubic(beta, eta, sine, double_sine):
    """m, the coefficient of t³ in the half-angle quartic at the tip, by sin φ and sin 2(φ − α).

    Proved as swing.tip_cubic.
    """
    return beta * sine - 0.5 * eta * double_sine


def phase_rate(first, second, square, rest):
    """Δ = √(a² cos²ψ + b² sin²ψ), dψ/dσ.

    Equation DLMF 19.2.4; proved as swing.phase_rate.
    """
    return sqrt(rest * first * first + square * second * second)


def others_sum(q, root):
    """ê₂ + ê₃ by ê₁.

    Proved as swing.others_sum.
    """
    return -0.25 * q - root


def others_product(b, m, root, others_sum):
    """ê₂ê₃ by ê₁ and ê₂ + ê₃.

    Proved as swing.others_product.
    """
    return 0.25 * b * m - root * others_sum


def arc_kink(first, square, delta, across, b, pole, root, near_root, pair_root):
    """The part of ∫η cos²(θ − α)dσ without integral.

    Equation DLMF 19.29(ii); proved as swing.arc_kink.
    """
    return (
        across * (2 * first * first - 2 * root) / delta
        + 4 * delta * across / square
        - 2 * near_root * (1 + pole * pair_root / (b * b + pole * pole))
    )


def arc_kink_tip(first, delta, across, b, pole, root, others_sum, others_product, lift):
    """The same towards the tip, with lift = x + √X₂√X₃: it is small as σ³, and so are its terms.

    Proved as swing.arc_kink_tip.
    """
    return (
        across
        * (
            (lift + first * first - root - others_sum) * b * b
            + pole * (first * first - root) * (pole * others_sum - others_product) / lift
            - pole * others_product
        )
        / (delta * (b * b + pole * pole))
    )


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


def phase_bend(share, first_share, square, rest, across, delta):
    """kS′τ′/(1 + kS′) after Gauss's step, by k = (a − b)/(a + b) and 1 + k; τ = sin ψ cos ψ/Δ.

    Equation DLMF 19.8(iii); proved as swing.phase_bend.
    """
    return share * square * across / ((rest + first_share * square) * delta)


def lag_step(bend, share, second_share, square, rest):
    """τ′ − τ for τ = sin ψ cos ψ/Δ, τ′ the same after Gauss's step, by ``phase_bend``, k and 1 − k.

    Equation DLMF 19.8(iii); proved as swing.lag_step.
    """
    return bend * share * rest / (rest + second_share * square)


def arc_square(beta, first, second, root, y_apart, kink, turned, lag):
    """η∫cos²(θ − α)dσ from the tip to the point less what it is along the tip's direction, by the same of y.

    Equation DLMF 19.29(ii); proved as swing.arc_square.
    """
    return (
        -beta * y_apart
        - 8 * turned * (second - first) * (first + second)
        - 2 * lag * (2 * first * first - 2 * root)
        - 2 * kink
    )


def strength(moment_there):
    """b of the expansion t = b/(℘ − c), by θ″ at the tip.

    Equation exsl17; proved as swing.strength.
    """
    return 0.25 * moment_there


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


def chi_rate(square, rest, flat, scale):
    """The rate of χ over that at the turning points, by the phase.

    Equation DLMF 22.6(iii); proved as swing.chi_rate.
    """
    return (rest * rest + flat * (1 + rest)) / scale


def near_by_phase(square, rest, bend):
    """X₁ by sin²ψ, cos²ψ and bend = a²/Δ.

    Equation DLMF 19.25.35; proved as swing.near_by_phase.
    """
    return rest * bend * bend / square


def phase_ratio(share, square, rest):
    """Δ/a by share = (b/a)².

    Equation DLMF 19.2.4; proved as swing.phase_ratio.
    """
    return sqrt(rest + share * square)


def before_over(square, rest, by_ratio):
    """What the cosine of a difference of lengths is divided by; by_ratio is Δ/a at the length taken off.

    Equation DLMF 22.8(i); proved as swing.before_over.
    """
    return rest + square * by_ratio * by_ratio


def before_sine(square, rest, ratio, by_square, by_rest, by_ratio, fall):
    """sin ψ at the difference of two lengths from the tip, by the difference of their sin²ψ.

    Equation DLMF 22.8(i); proved as swing.before_sine.
    """
    return fall / (by_ratio * sqrt(square * by_rest) + ratio * sqrt(rest * by_square))


def before_cosine(square, rest, ratio, by_square, by_rest, by_ratio, over):
    """cos ψ at the difference of two lengths from the tip.

    Equation DLMF 22.8(i); proved as swing.before_cosine.
    """
    return (ratio * by_ratio * sqrt(square * by_square) + sqrt(rest * by_rest)) / over


def gauss_more(share, tan_square):
    """by what share tan²ψ is more before Gauss's step than after it.

    Equation DLMF 19.8(iii); proved as swing.gauss_more.
    """
    return share * (4 + 4 * tan_square - share) / ((2 - share) ** 2 + tan_square * (4 - 4 * share))


def landen_more(share, tan_phase):
    """by what share tan ψ is more before Landen's step than after it.

    Equation DLMF 19.8(ii); proved as swing.landen_more.
    """
    return share * (1 + tan_phase * tan_phase) / (2 - share * (1 + tan_phase * tan_phase))


def far_sine(first, rest, delta):
    """sin ψ of the same point by the length from the far turning point.

    Equation DLMF 22.4(iii); proved as swing.far_sine.
    """
    return first * sqrt(rest) / delta


def far_cosine(second, square, delta):
    """cos ψ of the same point by the length from the far turning point.

    Equation DLMF 22.4(iii); proved as swing.far_cosine.
    """
    return second * sqrt(square) / delta


def shot_bend_each(beta, eta, growth):
    """a bound of |∂²θ(0)/∂θ(ℓ)²| for every tip, by cosh(ℓ√(β + η)) − 1: it solves G″ = (β + η)G + (β + 2η)cosh².

    Proved as swing.shot_bend.
    """
    return growth * (beta + 2 * eta) * (3 + growth) / (3 * beta + 3 * eta)


def rest_fall_each(eta, stiffness, double_cosine, double_sine, middle_sine, middle_cosine, half_sine, half_cosine):
    """V(rest + middle − half) − V(rest + middle + half), from a direction without moment.

    Proved as swing.rest_fall.
    """
    return (
        4
        * half_sine
        * half_cosine
        * (
            2
            * middle_sine
            * middle_cosine
            * (
                stiffness
                - 2
                * eta
                * double_cosine
                * (middle_sine * middle_sine + (1 - 2 * middle_sine * middle_sine) * half_sine * half_sine)
            )
            - eta
            * double_sine
            * (
                (3 - 4 * middle_sine * middle_sine) * middle_sine * middle_sine
                + (1 - 8 * middle_sine * middle_sine * middle_cosine * middle_cosine) * half_sine * half_sine
            )
        )
    )


def rest_moment_each(eta, stiffness, double_cosine, double_sine, sine, cosine):
    """θ″ at an offset from a direction without moment, by the sine and cosine of half the offset.

    Proved as swing.rest_moment.
    """
    return (
        2
        * sine
        * (
            cosine * (stiffness - 2 * eta * double_cosine * sine * sine)
            - 0.5 * eta * double_sine * sine * (3 - 4 * sine * sine)
        )
    )


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


def rj_delta_real_each(eta, b, double_cosine):
    """The real part of (p − X₁)(p − X₂)(p − X₃), p = x − ib, for the duplication of R_J, by cos 2(φ − α).

    Equation DLMF 19.26(iii); proved as swing.rj_delta_real.
    """
    return 0.25 * eta * double_cosine * b * b


def rj_delta_imag_each(eta, b, double_sine):
    """The imaginary part of (p − X₁)(p − X₂)(p − X₃), p = x − ib, for the duplication of R_J, by sin 2(φ − α).

    Equation DLMF 19.26(iii); proved as swing.rj_delta_imag.
    """
    return 0.25 * eta * double_sine * b * b


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


def arc_y_each(sine, cosine, w_re, w_im):
    """∫y′ dσ from the tip to the point less what it is along the tip's direction, by sin φ and cos φ.

    Equation exsl36; proved as swing.arc_y.
    """
    return cosine * w_re - sine * w_im


def arc_z_each(sine, cosine, w_re, w_im):
    """∫z′ dσ from the tip to the point less what it is along the tip's direction, by sin φ and cos φ.

    Equation exsl41; proved as swing.arc_z.
    """
    return sine * w_re + cosine * w_im


def rest_stiffness_each(beta, eta, cosine, double_cosine):
    """dθ″/dθ by cos θ and cos 2(θ − α), where small rotations h obey h″ = (dθ″/dθ)h; at the tip it is q.

    Proved as swing.rest_stiffness.
    """
    return beta * cosine + eta * double_cosine


def tip_cubic_each(beta, eta, sine, double_sine):
    """m, the coefficient of t³ in the half-angle quartic at the tip, by sin φ and sin 2(φ − α).

    Proved as swing.tip_cubic.
    """
    return beta * sine - 0.5 * eta * double_sine


def others_sum_each(q, root):
    """ê₂ + ê₃ by ê₁.

    Proved as swing.others_sum.
    """
    return -0.25 * q - root


def others_product_each(b, m, root, others_sum):
    """ê₂ê₃ by ê₁ and ê₂ + ê₃.

    Proved as swing.others_product.
    """
    return 0.25 * b * m - root * others_sum


def arc_kink_each(first, square, delta, across, b, pole, root, near_root, pair_root):
    """The part of ∫η cos²(θ − α)dσ without integral.

    Equation DLMF 19.29(ii); proved as swing.arc_kink.
    """
    return (
        across * (2 * first * first - 2 * root) / delta
        + 4 * delta * across / square
        - 2 * near_root * (1 + pole * pair_root / (b * b + pole * pole))
    )


def arc_kink_tip_each(first, delta, across, b, pole, root, others_sum, others_product, lift):
    """The same towards the tip, with lift = x + √X₂√X₃: it is small as σ³, and so are its terms.

    Proved as swing.arc_kink_tip.
    """
    return (
        across
        * (
            (lift + first * first - root - others_sum) * b * b
            + pole * (first * first - root) * (pole * others_sum - others_product) / lift
            - pole * others_product
        )
        / (delta * (b * b + pole * pole))
    )


def phase_bend_each(share, first_share, square, rest, across, delta):
    """kS′τ′/(1 + kS′) after Gauss's step, by k = (a − b)/(a + b) and 1 + k; τ = sin ψ cos ψ/Δ.

    Equation DLMF 19.8(iii); proved as swing.phase_bend.
    """
    return share * square * across / ((rest + first_share * square) * delta)


def lag_step_each(bend, share, second_share, square, rest):
    """τ′ − τ for τ = sin ψ cos ψ/Δ, τ′ the same after Gauss's step, by ``phase_bend``, k and 1 − k.

    Equation DLMF 19.8(iii); proved as swing.lag_step.
    """
    return bend * share * rest / (rest + second_share * square)


def gauss_gap_each(gap, total):
    """a′ − b′ after Gauss's step, by gap = a − b and total = a′ + b′.

    Equation DLMF 19.8(i); proved as swing.gauss_gap.
    """
    return 0.25 * gap * gap / total


def arc_square_each(beta, first, second, root, y_apart, kink, turned, lag):
    """η∫cos²(θ − α)dσ from the tip to the point less what it is along the tip's direction, by the same of y.

    Equation DLMF 19.29(ii); proved as swing.arc_square.
    """
    return (
        -beta * y_apart
        - 8 * turned * (second - first) * (first + second)
        - 2 * lag * (2 * first * first - 2 * root)
        - 2 * kink
    )


def far_pair_root_each(end):
    """√X₂√X₃ at the far turning point, by the rate of χ there.

    Proved as swing.far_pair_root.
    """
    return 0.25 * end * end


# Solver


class Record(tuple):
    """A tuple whose fields have names: the annotations of its class, in order. Made from a tuple of all its values."""

    __slots__ = ()
    _fields: tuple[str, ...]
    _places = namedtuple("_places", "a b c d e f g h i j k l m n o p")  # no record has more fields

    def __init_subclass__(cls):
        """Give every field its place; what reads a place is taken from one named tuple."""
        cls._fields = tuple(cls.__annotations__)
        for name, place in zip(cls._fields, cls._places._fields, strict=False):
            setattr(cls, name, getattr(cls._places, place))

    def __repr__(self):
        """The class and the fields by name."""
        fields = ", ".join(f"{name}={value!r}" for name, value in zip(self._fields, self, strict=True))
        return f"{type(self).__name__}({fields})"

    def _replace(self, **changed):
        """The same with some other values."""
        return type(self)([changed.get(name, value) for name, value in zip(self._fields, self, strict=True)])


class Rod(Record):
    """A rod in units in which β + η is of order one: lengths are 2**scale times the user's.


    """

    __slots__ = ()

    beta: float
    eta: float
    length: float
    clamp_angle: float
    side: int
    scale: int


class Motion(Record):
    """A motion from rest at the tip through the clamp angle to rest at the far turning point, and back.

    With χ from 0 at the tip to π at the far turning point, dσ = dχ/√(end² cos²χ + middle² sin²χ).
    """

    __slots__ = ()

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


class Stay(Record):
    """A motion, and the lengths for which it stays near its tip, its middle, and its far turning point besides."""

    __slots__ = ()

    motion: Motion
    tip: float
    middle: float
    far: float
    arrival: float


class Heading(Record):
    """The tip's direction: cos and sin of φ, and of 2(φ − α)."""

    __slots__ = ()

    cosine: float
    sine: float
    double_cosine: float
    double_sine: float


class Arc(Record):
    """A stretch of rod from the tip, less what it would be if it were straight along the tip's direction.

    ∫cos θ, ∫sin θ and η∫cos²(θ − α), with cos θ − cos φ for cos θ and likewise.
    """

    __slots__ = ()

    y: float
    z: float
    square: float


class Swing(Record):
    """A half-swing of a bent rod, for its shape: how it was found, its length, and its arc. turns: of the clamp.

    heading: the tip's direction. total: the arc of the whole rod.

    The clamp lies on the half-swing after ``whole`` of them, at the length ``arrival`` from where the motion is as at
    the tip, of which ``regular`` is not straight, and at the phase ψ with sin²ψ = square and cos²ψ = rest.
    """

    __slots__ = ()

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


def briefly(number):
    """A number in a few digits."""
    return f"{float(number):.3g}"


def within_turns(name, value):
    """A real number that tells an angle to half the digits that there are, or an error that names the argument."""
    number, widest = real(name, value), 1 / sqrt(2.0**-52)
    if abs(number) > widest:
        turns = "fewer than half of the digits tell where in its turn an angle lies; leave out whole turns"
        raise ValueError(f"{name} must lie within ±{briefly(widest)}, got {value!r}: beyond, {turns}")
    return number


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
    return min(limit, COUNTED)


def too_large(beta, eta, length):
    """Whether γ, the energy or a place is too large: of numbers or of arrays."""
    load = beta + eta
    return (load > LARGEST) | (load * length > LARGEST) | (length / LARGEST > 1)


def refused(loads, why):
    """The error of a rod that is refused."""
    given = ", ".join(f"{name} = {briefly(value)}" for name, value in zip(loads._fields, loads, strict=True))
    return ValueError(f"{given}: {why}")


class Loads(Record):
    """What tells how long a rod is for its stiffness."""

    __slots__ = ()

    beta: Any
    eta: Any
    length: Any


def must_be_finite(beta, eta, length):
    """ValueError where γ, the energy or a place would be too large for a number."""
    if too_large(beta, eta, length):
        why = "γ, the energy or a place is too large for a double; choose another unit of length"
        raise refused(Loads((beta, eta, length)), why)


def too_many(beta, eta, length, most):
    """Whether more equilibria are wanted than are found at once: of numbers or of arrays.

    No index is more than ℓ√(β + η)/π by more than one (Sturm), and about two equilibria have the same.
    """
    half, least = MANY / 2, pi * MANY / 2
    return ((beta + eta) * length * length > least * least) & (most is None or most >= half)


def must_have_answer(beta, eta, length, most):
    """ValueError where numbers of the answer would be too large, or there are too many equilibria to find them all.

    most: the largest index that is wanted, or None for all.
    """
    must_be_finite(beta, eta, length)
    if too_many(beta, eta, length, most):
        slow = length * sqrt(beta + eta)
        why = f"ℓ√(β + η) = {briefly(slow)}, so some {briefly(2 * slow / pi)} equilibria have indices up to half that"
        raise ValueError(f"max_index must be given here, and be less than {MANY // 2}: {why}")


def weak_rod(beta, eta, length, clamp_angle):
    """The rod that is all but straight: θ″ is that of the clamp angle, to the square of rounding."""
    rod = Rod((beta, eta, length, clamp_angle, 1, 0))
    lean = clamp_angle - 0.5 * pi
    # Loads that are hardly numbers are numbers times the length.
    force, magnet = beta * length, eta * length
    bend = force * sin(clamp_angle) + magnet * sin(lean) * cos(lean)
    energy = -(force * cos(clamp_angle) + magnet * cos(lean) * cos(lean) / 2)
    gamma = 2 * beta * cos(clamp_angle) + eta * cos(lean) * cos(lean)
    y, z = length * cos(clamp_angle), length * sin(clamp_angle)
    return Equilibrium((clamp_angle - bend * length / 2, -bend, gamma, y, z, energy, 0, rod, None))


class Rest(Record):
    """A direction without moment: angle = quarters·π/2 + extra.

    stiffness: dθ″/dθ there, positive on a hill. double_cosine, double_sine: of 2(angle − α).
    """

    __slots__ = ()

    quarters: int
    extra: float
    angle: float
    stiffness: float
    double_cosine: float
    double_sine: float


class Landscape(Record):
    """The directions of one turn, from the highest hill to the same hill a turn on: hill, well(, ridge, well), hill.

    level: the ridge is as high as the hill. even: V is symmetric about every hill and well. shoulder: where a ridge is
    nearly there, the direction at which the couple, ``moment``, is nearest to zero; None where that is not asked for.
    """

    __slots__ = ()

    rests: tuple[Rest, ...]
    level: bool
    even: bool
    shoulder: Rest | None
    moment: float


def along(beta, quarters, sign):
    """A direction along or against the force, no field: what it is about the field is not asked."""
    return Rest((quarters, 0, quarters * (pi / 2), sign * beta, 1, 0))


def no_field(beta):
    """The force alone."""
    return Landscape(((along(beta, 0, 1), along(beta, 2, -1), along(beta, 4, 1)), False, True, None, 0.0))


def orthogonal_double(beta, eta):
    """The field across a weaker force: two hills of the same height beside 0."""
    lean = atan2(sqrt((eta - beta) * (eta + beta)), beta)
    stiffness = (eta - beta) * (eta + beta) / eta
    cosine = 1 - 2 * (beta / eta) * (beta / eta)
    sine = -2 * (beta / eta) * sqrt((eta - beta) * (eta + beta)) / eta
    low = Rest((0, -lean, -lean, stiffness, cosine, -sine))
    high, again = Rest((0, lean, lean, stiffness, cosine, sine)), low._replace(quarters=4, angle=2 * pi - lean)
    top, bottom = Rest((0, 0, 0, beta - eta, -1, 0)), Rest((2, 0, pi, -beta - eta, -1, 0))
    return Landscape(((low, top, high, bottom, again), True, True, None, 0.0))


def orthogonal_single(beta, eta):
    """The field across a force that is not weaker: one hill, at 0."""
    top, again = (Rest((quarters, 0, quarters * (pi / 2), beta - eta, -1, 0)) for quarters in (0, 4))
    return Landscape(((top, Rest((2, 0, pi, -beta - eta, -1, 0)), again), False, True, None, 0.0))


def landscape(beta, eta):
    """Hills and wells for a field angle in (−π/2, π/2]."""
    if eta == 0:
        return no_field(beta)
    return orthogonal_double(beta, eta) if eta > beta else orthogonal_single(beta, eta)


def landscapes(beta, eta):
    """The landscape of a rod, and that of its mirror image."""
    scene = landscape(beta, eta)
    return scene, scene


def offset_from(rest, angle, turns):
    """angle − (rest + turns·2π), without cancellation; 0 where no angle within rounding of this tells them apart."""
    offset = less_quarters(angle, 4 * turns + rest.quarters) - rest.extra
    blur = 2.0**-52 * (abs(angle) + abs(rest.extra))
    return 0 if (abs(offset) <= blur) | (abs(offset) < (2.0**-52) ** 9) else offset


def turn_to(start, end):
    """The angle from one direction without moment to another, however near they are to each other."""
    return (end.quarters - start.quarters) * (pi / 2) + (end.extra - start.extra)


class Clamp(Record):
    """The clamp angle in a landscape: whole turns, and its offset from each direction without moment."""

    __slots__ = ()

    turns: int
    offsets: tuple[float, ...]


def clamp_in(rests, angle):
    """Whole turns such that the clamp lies from the first hill up to, but not at, its like a turn on."""
    turns = floor((angle - rests[0].angle) / (2 * pi))
    for _ in range(3):
        offsets = tuple(offset_from(rest, angle, turns) for rest in rests)
        shift = -1 if offsets[0] < 0 else 1 if offsets[-1] >= 0 else 0
        if shift == 0:
            break
        turns = turns + shift
    # One that counts as a direction without moment is as far from the others as that is.
    for there, met in zip(rests, offsets, strict=True):
        if met == 0:
            apart = zip(rests, offsets, strict=True)
            offsets = tuple(turn_to(rest, there) if met == 0 else offset for rest, offset in apart)
    return Clamp((turns, offsets))


def mirrored_clamp(scene, other, clamp, mirrored):
    """The clamp seen from the other side of the y axis, in the landscape there; mirrored: the clamp angle there."""
    if clamp.offsets[0] > 0 and other.rests[0].angle == -scene.rests[0].angle:  # number by number the same
        return Clamp((-1 - clamp.turns, tuple([-offset for offset in clamp.offsets[::-1]])))
    return clamp_in(other.rests, mirrored)


def ridge_fall(beta, eta, hill, ridge):
    """V(hill) − V(ridge): the sine of half their distance times the slope of V between, as if it were a circle."""
    half, middle = (ridge.extra - hill.extra) / 2, pi / 2 + (hill.extra + ridge.extra) / 2
    return cos(half) * (2 * beta * sin(middle) - eta * sin(half) * sin(2 * (middle - 0.5 * pi)))


class Ridge(Record):
    """A ridge that is lower than the hill; all are 0 where none is.

    drop: V(hill) − V(ridge). level: from the hill to the level of the ridge, depth: from there to the well; by_hill:
    level is told by the hill, depth by the well if not.
    """

    __slots__ = ()

    drop: float
    level: float
    depth: float
    by_hill: bool


def fall_from_rest(eta, stiffness, double_cosine, double_sine, middle, half):
    """V(middle − half) − V(middle + half), with both angles measured from a direction without moment."""
    return rest_fall(
        eta,
        stiffness,
        double_cosine,
        double_sine,
        sin(middle / 2),
        cos(middle / 2),
        sin(half / 2),
        cos(half / 2),
    )


def fall(eta, rest, start, change):
    """V(start) − V(start + change), from a start measured from a direction without moment."""
    half = change / 2
    return fall_from_rest(eta, rest.stiffness, rest.double_cosine, rest.double_sine, start + half, half)


def step_to(eta, rest, offset, goal):
    """Newton's step to where the square root of the change of V from a direction without moment is ``goal``, and by
    how much its slope changes half way there, as a share of it."""
    small, large = sin(offset / 4), cos(offset / 4)
    sine, cosine = 2 * small * large, 1 - 2 * small * small
    level = rest_fall(eta, rest.stiffness, rest.double_cosine, rest.double_sine, small, large, small, large)
    force = abs(rest_moment(eta, rest.stiffness, rest.double_cosine, rest.double_sine, sine, cosine))
    here, force = sqrt(abs(level)), larger(force, (2.0**-52) ** 20)
    whole_sine, whole_cosine = 2 * sine * cosine, 1 - 2 * sine * sine
    # dθ″/dθ, by β and α as the direction has them.
    turned = rest.double_cosine * (2 * whole_cosine * whole_cosine - 1 - whole_cosine)
    turned = turned - rest.double_sine * whole_sine * (2 * whole_cosine - 0.5)
    bend = (rest.stiffness * whole_cosine + eta * turned) * (here / force) * (here / force)
    share = (here - goal) / larger(here, (2.0**-52) ** 20)
    return 2 * here * (here - goal) / force, share * ((-bend if level < 0 else bend) - 0.5)


def reach(eta, rest, amount, most, side):
    """The distance from a hill (or a well) at which V is lower (or higher) by ``amount``, to one side.

    most: the distance of the next well (or hill). Halley's method for the square root of the difference, which is
    nearly linear, from the pendulum's value.
    """
    amount = amount if amount > 0 else 0  # of a hill and a well that nearly meet, rounding may give less
    share = amount / larger(abs(fall(eta, rest, 0, side * most)), (2.0**-52) ** 20)
    near = most * asin(sqrt(share if share < 1 else 1)) * (2 / pi)
    goal = sqrt(amount)
    for _ in range(40):
        step, bent = step_to(eta, rest, side * near, goal)
        safe = abs(bent) < 0.5
        trial = near - step / (1 - bent if safe else 1)
        trial = (near + most) / 2 if trial > most else near / 2 if trial < 0 else trial
        # The method cubes the error, and Newton's squares it: after steps this small the next would change nothing.
        small = (2.0**-52) ** 0.45 if safe else (2.0**-52) ** 0.6
        moving, near = abs(trial - near) > small * near, trial
        if not moving:
            break
    return near


def ridge_at(eta, rests, drop):
    """The ridge that is lower by ``drop`` than the hill."""
    down, above = turn_to(rests[0], rests[1]), fall(eta, rests[2], 0, turn_to(rests[2], rests[1]))
    # Of a ridge that is next to its wells V tells at the hill nothing.
    by_hill = drop < above
    rest, amount = rests[0] if by_hill else rests[1], drop if by_hill else above
    distance = reach(eta, rest, amount, down, 1 if by_hill else -1)
    level, depth = distance if by_hill else down - distance, down - distance if by_hill else distance
    return Ridge((drop, level, depth, by_hill))


def ridge_of(beta, eta, scene):
    """The ridge of a landscape, seen from its first hill."""
    drop = 0
    if len(scene.rests) != 3 and not scene.level:
        drop = ridge_fall(beta, eta, scene.rests[0], scene.rests[2])
    # A ridge lower by less than this would be passed only from within its square root of the hill.
    if drop <= (2.0 ** (-52)) ** 17 * (beta + eta):
        return Ridge((0, 0, 0, True))
    return ridge_at(eta, scene.rests, drop)


def miss_of(beta, eta, clamp_angle, slow):
    """The angle at arc length 0 of a motion from a tip, less the clamp angle: a function of the tip's offset from it.

    The rod's length is 1; slow: √(β + η).
    """
    # ℘ by its series on a part of the rod, and by as many doublings as make that the whole.
    doublings, share = 0, 1.0
    while slow * share > SHOT_SERIES_SLOW:
        doublings, share = doublings + 1, share / 2
    force, field, steps = beta * share * share, eta * share * share, range(doublings)

    def missed(offset):
        tip = clamp_angle + offset
        double = 2 * (tip - 0.5 * pi)
        across, half = force * sin(tip), field / 2 * sin(double)
        along, p, quarter = force * cos(tip), across + half, (across - half) * (across + half) / 4
        c = (along + field * cos(double)) / 12
        square = c * c
        g2, g3 = 12 * square - quarter, (quarter - 8 * square) * c - along * p * p / 16
        a, b, fourth, twice = g2 / 20, g3 / 28, g2 / 4, 2 * g3
        value = 1 + a * (1 + a * (1 / 3 + a * (2 / 39)) + b * (3 / 11 + a * (2 / 33))) + b * (1 + b / 13)
        for _ in steps:
            squared = value * value
            above = squared + fourth
            value = (above * above + twice * value) / (value * (4 * squared - g2) - g3)
        return offset + 2 * atan2(p / 4, value - c)

    return missed


def samples_apart(function, reach, sag):
    """Places and the values there, such that one zero or none lies between two; None where there is a doubt.

    The function is above the chord between two places by no more than sag·width²/4. Where its values are on one side
    of zero it has none between if the sum of their square roots is more than the width times √sag; and where their
    sum is more than sag·width² it rises or falls all the way.
    """
    before, start, bound = -reach, function(-reach), (1 + SLACK) * sag
    places, values, todo = [before], [start], [(reach, function(reach)), (0, function(0))]
    while todo:
        place, value = todo[-1]
        width, both = place - before, value * start
        apart = abs(value - start) if both < 0 else abs(value + start) + 2 * sqrt(both)
        if apart > bound * width * width:
            places.append(place)
            values.append(value)
            before, start = todo.pop()
        elif width < CLOSEST * reach:
            return None
        else:
            middle = place - width / 2
            todo.append((middle, function(middle)))
    return None if min(abs(value) for value in values) < UNSURE * reach else (places, values)


class Shot(Record):
    """A tip, by its offset from the clamp angle; rate: ∂θ(0)/∂θ(ℓ)."""

    __slots__ = ()

    offset: float
    rate: float


def smooth_root(function, places, values, sag, blur):
    """A zero of a function that rises or falls all the way between the first two places, and its slope there.

    By the zero of the parabola through the last three; where the function is cheap and all but straight that takes less
    time than ``bracketed_root``. sag: half of what |f″| is nowhere more than. blur: a value that rounding may have made
    of zero, or a chord too, so that a look would tell nothing.
    """
    (place, before, third), (value, value_before, value_third) = places, values
    low, high = (place, before) if place < before else (before, place)
    rising = (value > 0) == (place == high)
    while True:
        chord = (value - value_before) / (place - before)
        twist = ((value_before - value_third) / (before - third) - chord) / (third - place)
        slope = chord - twist * (before - place)
        bent = slope * slope - twist * value
        step = value * slope / bent if bent != 0 else high - low
        trial = place - step
        if not low < trial < high:
            if abs(value) <= blur:
                return place, slope
            trial = (low + high) / 2
            if not low < trial < high:
                return place, slope
        elif abs(value) <= blur or sag * abs(step * (trial - before)) <= blur:
            return trial, slope
        third, value_third, before, value_before = before, value_before, place, value
        place, value = trial, function(trial)
        if (value > 0) == rising:
            high = place
        else:
            low = place


def zeros_between(function, places, values, sag, blur):
    """The zeros between the places, as Shots; sag: as in ``samples_apart``. blur: what rounding may make of zero."""
    found = []
    for k in range(1, len(places)):
        if (values[k] > 0) != (values[k - 1] > 0):
            beside = k + 1 if k + 1 < len(places) else k - 2
            near = (k - 1, k, beside) if abs(values[k - 1]) < abs(values[k]) else (k, k - 1, beside)
            known = [places[i] for i in near], [values[i] for i in near]
            found.append(Shot(smooth_root(function, *known, sag, blur)))
    return found


def tip_shots(beta, eta, length, clamp_angle):
    """All tips of a short rod, as Shots from the lowest up; None if it is not short, or samples leave a doubt."""
    slow, square = length * sqrt(beta + eta), length * length
    if slow > SHORT_SLOW:
        return None
    beta, eta = beta * square, eta * square
    clamp = less_quarters(clamp_angle, 4 * floor(clamp_angle / (2 * pi) + 0.5))
    if abs(beta * sin(clamp) + eta / 2 * sin(2 * (clamp - 0.5 * pi))) < LEVEL:
        return None
    missed = miss_of(beta, eta, clamp, slow)
    # θ″ is nowhere more than β + η/2, and no motion is wider than a turn.
    reach = (1 + REACH) * min((beta + eta / 2) / 2, 2 * pi)
    sag = shot_bend(beta, eta, (exp(slow / 2) - exp(-slow / 2)) ** 2 / 2) / 2
    samples = samples_apart(missed, reach, sag)
    return None if samples is None else zeros_between(missed, samples[0], samples[1], sag, ALIKE * reach)


class Ground(Record):
    """What the ranges of a rod are told by: its landscape, the clamp's offsets from its directions, and the ridge.

    drop, level, depth, by_hill: see ``Ridge``; height: V(ridge) − V(clamp), or 0 where no ridge is lower than the hill.
    """

    __slots__ = ()

    eta: float
    scene: Landscape
    at: tuple[float, ...]
    drop: float
    level: float
    depth: float
    by_hill: bool
    height: float


def ridge_ground(eta, scene, at, ridge):
    """The ground with a lower ridge."""
    rests = scene.rests
    # Near the far hill V says which is higher only by the distance from that hill.
    height = fall(eta, rests[2], 0, at[2]) if at[2] < -at[4] else fall(eta, rests[4], 0, at[4]) - ridge.drop
    return Ground((eta, scene, at, ridge.drop, ridge.level, ridge.depth, ridge.by_hill, height))


def level_ground(eta, scene, at):
    """The ground without a ridge lower than the hill."""
    return Ground((eta, scene, at, 0, 0, 0, True, 0))


def ground_of(eta, scene, clamp, ridge):
    """The ground of a rod."""
    if ridge.drop > 0:
        return ridge_ground(eta, scene, clamp.offsets, ridge)
    if len(scene.rests) != 3 and not scene.level:
        scene = scene._replace(level=True, even=True)
    return level_ground(eta, scene, clamp.offsets)


class Phase(Record):
    """Where on its half-swing the motion meets the clamp.

    The length from the tip is ∫dψ/√(a² cos²ψ + b² sin²ψ) from 0 to ψ, with a and b half of ``end`` and ``middle``; the
    half-swing ends at ψ = π/2. whole, delta: what the speed there follows from.
    """

    __slots__ = ()

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
    # Of two sums for the same that which has the smaller terms rounds less.
    cosine = lead if near * abs(left - done) + abs(motion.uneven) * done < whole else ahead - behind
    # Not zero: at the tip itself the motion has no point by ℘.
    square = larger(chi_square(behind, ahead), (2.0**-52) ** 19)
    size, first = abs(cosine), cosine >= 0
    delta = hypot(end * cosine, motion.middle * sqrt(square))
    half = half_square(end, square, size, delta) if first else half_square_beyond(end, size, delta)
    rest = half_rest(end, size, delta) if first else half_rest_beyond(end, motion.middle, square, size, delta)
    return Phase((half, rest, whole, delta))


def small_steps(a, b):
    """What each step takes from the larger one of two numbers to their mean, twice, as shares of it; and the mean.

    The two are a and b for Gauss's steps, a and √(a² − b²) for Landen's, which go on until nothing is left of b.
    """
    ratio = b / a
    if ratio > APART:
        gap, least = a - b, 2.0**-52 / 8
    else:
        gap, least = b * (b / (a + sqrt((a - b) * (a + b)))), 2.0**-52 * ratio * ratio / 8
    shares, large, less = [gap / a], a, gap / 2
    while True:
        next_one = large - gap / 2
        gap = gauss_gap(gap, next_one + sqrt(large * (large - gap)))
        if gap <= least * large:
            return shares, a - less
        shares.append(gap / next_one)
        large, less = next_one, less + gap / 2


def descended(tangent, shares, ratio):
    """tan ψ after Landen's steps. ratio: of the rates before them."""
    for share in shares:
        bent = ratio * tangent
        root = landen_root(bent)
        less = landen_less(share, bent, root)
        tangent = tangent - tangent * less if less < 0.25 else landen_tangent(share, tangent, root)
        ratio = share / (2 - share)
    return tangent


def swing_and_arrival(a, b, square, rest):
    """The complete and the incomplete integral of 1/√(a² cos²ψ + b² sin²ψ), by sin²ψ and cos²ψ."""
    tangent = sqrt(square / (rest if rest > 0 else (2.0**-52) ** 19))
    if a < b:
        a, b, tangent = b, a, tangent_exchanged(a, b, tangent)
    shares, mean = small_steps(a, b)
    ratio = b / a
    if ratio > APART:
        # Beyond this ψ is a right angle to rounding, and cubes of the tangent may overflow.
        tangent = min(tangent, (2.0**-52) ** (-2))
        square = tangent * tangent
        for share in shares:
            root, other_root = sqrt(1 + square), sqrt(1 + (1 - share) * (1 - share) * square)
            square = square - square * gauss_less(share, root, other_root)
        return pi / (2 * mean), atan(sqrt(square)) / mean
    first = shares[0]
    # The half-swing ends where the tangent is infinite: after a step it is not.
    whole = descended((2 - first) / ratio, shares[1:], first / (2 - first))
    return asinh(whole) / mean, asinh(descended(tangent, shares, ratio)) / mean


class Sample(Record):
    """Half-swing and first arrival at a place of a piece, and of what they are: the motion and its phase at the clamp.

    The motion alone has the half-swing and the arrival without the lengths for which it stays anywhere.
    """

    __slots__ = ()

    place: float
    swing: float
    arrival: float
    stay: Stay
    phase: Phase
    regular: tuple[float, float]


def sample_of(place, stay):
    """The sample of a motion."""
    motion = stay.motion
    phase = phase_of(motion)
    regular = swing, arrival = swing_and_arrival(motion.end / 2, motion.middle / 2, phase.square, phase.rest)
    swing, arrival = swing + stay.tip + stay.middle + stay.far, arrival + stay.tip + stay.arrival
    return Sample((place, swing, arrival, stay, phase, regular))


class Basin(Record):
    """What stops the rod and what it swings about: the hill that tips come from and the well below them, the hill
    that stops the motion and the last well before it, and the direction where it is slowest between its ends: the
    ridge that it passes, or the well.

    far_rise: V(far) − V(hill). even: the motion is symmetric about its middle. whole: far is the hill a turn on.
    shoulder, moment: of a landscape in which a ridge is nearly there; lean: see ``shoulders.level_lean``.
    """

    __slots__ = ()

    hill: Rest
    well: Rest
    far: Rest
    far_well: Rest
    axis: Rest
    far_rise: float
    passes: bool
    even: bool
    whole: bool
    shoulder: Rest | None
    moment: float
    lean: float


class Piece(Record):
    """Tip angles from low to low + width in a basin; angles as differences, told without loss.

    low_kind: 'hill', or 'level', where V is that of the ridge. high_kind: 'clamp', the clamp angle itself; 'turn', the
    angle from which the rod turns back at the clamp angle; 'level'.
    """

    __slots__ = ()

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
    beyond_well: float  # clamp − far_well
    past_hill: float  # clamp − hill
    past_well: float  # clamp − well


def moment_from_rest(eta, stiffness, double_cosine, double_sine, offset):
    """θ″ = −V′ at an offset from a direction without moment."""
    return rest_moment(eta, stiffness, double_cosine, double_sine, sin(offset / 2), cos(offset / 2))


def tip_fall(eta, piece, change, rise, drop):
    """V(tip) − V(tip + change), for a tip that is told from the low and the high end of its range."""
    from_hill, depth = piece.low_offset + rise, piece.high_depth + drop
    upper = from_hill < depth
    return fall(eta, piece.basin.hill if upper else piece.basin.well, from_hill if upper else -depth, change)


def reach_either(eta, hill, well, by_hill, amount, most):
    """``reach`` down from the hill, or up from the well, whichever is asked for."""
    rest = hill._replace(
        stiffness=hill.stiffness if by_hill else well.stiffness,
        double_cosine=hill.double_cosine if by_hill else well.double_cosine,
        double_sine=hill.double_sine if by_hill else well.double_sine,
    )
    return reach(eta, rest, amount, most, -1 if by_hill else 1)


def slope(eta, rest, offset):
    """θ″ at an offset from a direction without moment."""
    return moment_from_rest(eta, rest.stiffness, rest.double_cosine, rest.double_sine, offset)


def onward(eta, rest, start, amount, rough, wanted, moment=0):
    """How far beyond ``start``, an offset from a direction of that moment, V has fallen by ``amount``.

    The rough value is good to rounding of the angles; where little of it is left, the slope of V at the start gives a
    better one. Newton's method does the rest, until all that are wanted are found.
    """
    steep = slope(eta, rest, start) + moment * cos(start)
    told = (abs(rough) > 1e-3 * abs(start)) | (steep == 0)
    distance = rough if told else amount / (1 if told else steep)
    for _ in range(40):
        force = slope(eta, rest, start + distance) + moment * cos(start + distance)
        fallen = fall(eta, rest, start, distance) + 2 * moment * cos(start + distance / 2) * sin(distance / 2)
        step = (fallen - amount) / (1 if force == 0 else force)
        away = abs(distance - step) > pi
        stuck = away & (distance == rough)
        distance = rough if away else distance - step
        if not wanted & (stuck == 0) & (abs(step) > (2.0 ** (-52)) ** 0.6 * abs(distance)):
            break
    return distance


def further(eta, rest, start, amount, rough, far, moment=0):
    """How far beyond ``start`` V has risen by ``amount``: ``onward`` where the rough value is not told well enough."""
    better = onward(eta, rest, start, -amount, rough, far == 0, moment)
    # Newton's method leaves a place where V is nearly level for one far away.
    return rough if far | (abs(better - rough) > 0.01) else better


def beyond_clamp(eta, piece, rise, drop, rough):
    """How far the motion goes beyond the clamp, when the tip is ``drop`` below the one that turns there.

    V falls by the same amount on both sides. The rough value is as good as its difference to the clamp's distance
    from a hill or a well allows.
    """
    far = rough > 0.25 * abs(piece.clamp_offset)
    amount = tip_fall(eta, piece, drop, rise, drop)
    return further(eta, piece.clamp_rest, piece.clamp_offset, amount, rough, far)


def least_moment(basin):
    """What rounding leaves at least of a moment, by the distance from the direction that tells it: where a hill and a
    well all but meet, and are not among the directions that are told, it would leave nothing, or less."""
    return (2.0**-52) ** 2 if basin.passes or not basin.whole else 4 * 2.0**-52


def far_side(eta, piece, rise, drop, depth, height):
    """Half the width of the motion, how far it goes on beyond the clamp, the moment where it turns, how far that is
    from the far hill, and what a shoulder tells."""
    basin = piece.basin
    hill, well, far, far_well = basin.hill, basin.well, basin.far, basin.far_well
    down = turn_to(far_well, far)
    if piece.low_kind == "level":
        below = -tip_fall(eta, piece, -rise, rise, drop)
    else:
        below = basin.far_rise + fall(eta, hill, 0, piece.low_offset + rise)
    if basin.passes:
        # Above the ridge by its height, and the ridge above the well behind it.
        above = height + fall(eta, basin.axis, 0, turn_to(basin.axis, far_well))
    else:
        above = -fall(eta, well, 0, -depth)
    by_hill = below < above
    distance = reach_either(eta, far, far_well, by_hill, below if by_hill else above, down)
    turn = down - distance if by_hill else distance  # far turning point − far_well
    left = piece.far_gap - distance if by_hill else distance - piece.beyond_well
    if piece.high_kind == "turn":
        left = larger(beyond_clamp(eta, piece, rise, drop, left), 0)
    if basin.passes:
        half_width = (turn + depth + turn_to(well, far_well)) / 2
    else:
        half_width = (turn + depth) / 2
    far_moment = (slope(eta, far, -distance) if by_hill else slope(eta, far_well, distance)) * -1
    far_moment = larger(far_moment, least_moment(basin) * distance)
    return half_width, left, far_moment, distance if by_hill else down - distance, None


def shoulder_moment(eta, basin, offset):
    """θ″ at an offset from the shoulder."""
    return basin.moment * cos(offset) + slope(eta, basin.shoulder, offset)


class End(Record):
    """An end of a motion beside a shoulder: the far turning point or the tip, and dθ″/dθ there."""

    __slots__ = ()

    is_far: bool
    stiffness: float


def stiffness_from_rest(eta, stiffness, double_cosine, double_sine, offset):
    """dθ″/dθ at an offset from a direction without moment."""
    return stiffness_beside(eta, stiffness, double_cosine, double_sine, sin(offset / 2), cos(offset / 2))


def shoulder_stiffness(eta, basin, offset):
    """dθ″/dθ at an offset from the shoulder."""
    rest = basin.shoulder
    stiffness = stiffness_from_rest(eta, rest.stiffness, rest.double_cosine, rest.double_sine, offset)
    return stiffness - basin.moment * sin(offset)


def beside_shoulder(eta, basin, from_hill, offset, moment, end):
    """θ″ at the tip, and the end of the motion that is beside the shoulder, if the shoulder is nearer to the tip than
    the hill or well by whose offset it was told; else as they are given."""
    apart = from_hill - turn_to(basin.hill, basin.shoulder)
    if 2 * abs(apart) >= abs(offset):
        return moment, end
    return shoulder_moment(eta, basin, apart), End((False, shoulder_stiffness(eta, basin, apart)))


def halfway(hill, far, axis):
    """The angle from an axis to the middle of two hills, in which whole turns between them are no rounding."""
    quarters = hill.quarters + far.quarters - 2 * axis.quarters
    return quarters * (pi / 4) + ((hill.extra - axis.extra) + (far.extra - axis.extra)) / 2


def unevenness(eta, axis, centre, sine, near, far):
    """√far − √near: by the roots where they are apart, else by far − near = 2η sin 2(middle − α) sin(half_width).

    centre: from the axis to the middle.
    """
    double = axis.double_sine * cos(2 * centre) + axis.double_cosine * sin(2 * centre)
    by_turns = 2 * eta * double * sine / (sqrt(near) + sqrt(far))
    apart = (8 * near < far) | (8 * far < near) | (near + far < 2 * eta * sine)
    return sqrt(far) - sqrt(near) if apart else by_turns


def wrapped(angle):
    """The angle less whole turns, between −π and π."""
    return angle - 2 * pi * floor(angle / (2 * pi) + 0.5)


def above_field(eta, basin, offset, turn, height):
    """``mean`` less η where they are near each other: 2(V(tip) − V)/(cos(θ − middle) − cos(half_width)) at the θ at
    which it is least, which lies then near the ridge or the well, at an offset from it.

    turn: half of what it is divided by. height: V(tip) less that of the ridge or the well.
    """
    # As near the ridge as rounding it is nearer still: it is there to the second order in the height.
    offset = 0 if abs(offset) < 32 * 2.0**-52 else offset
    return (height + fall(eta, basin.axis, 0, offset)) / (1 if turn == 0 else turn)


def mean_less_field(eta, basin, centre, half_width, near, far, height, mean):
    """``mean`` − η: as it stands, or by the end of the motion or the ridge or well that is near where V is nearest to
    level."""
    apart = mean - eta
    close = apart <= 0.3 * eta
    if close:
        # 2(axis − α), and 2(middle − α).
        axis = atan2(basin.axis.double_sine, basin.axis.double_cosine)
        double = wrapped(axis + 2 * centre)
        ahead, behind = sin((half_width + double) / 2), sin((half_width - double) / 2)
        by_far, by_near = far - 2 * eta * ahead * ahead, near - 2 * eta * behind * behind
        known = by_far if 2 * by_far > far else by_near
        far_off = close & (2 * by_far <= far) & (2 * by_near <= near)
        if far_off:
            # Not from a well that is far from where V is nearly level: there V tells least.
            told, turn = by_near if near < far else by_far, ahead * behind
            above = above_field(eta, basin, wrapped(-axis - centre), turn, height)
            known = (above if height <= abs(turn) * eta * (abs(ahead) + abs(behind)) else told) if far_off else known
        apart = known if close else apart
    # Over a ridge V(tip) − V is nowhere less than there; elsewhere only rounding makes it smaller than this.
    least = larger(height, (2.0**-52) ** 19) if basin.passes else 2.0**-52 * (near if near < far else far) / 4
    return apart if apart > least else least


def rates(beta, eta, basin, centre, half_width, sine, near, far, height, beside):
    """dχ/dσ at the ends and in the middle of the motion. centre: from the slowest direction to the middle; beside:
    the end that is beside a shoulder, if one is."""
    middle, cosine = basin.axis.angle + centre, cos(half_width)
    cos_middle, cos_double = cos(middle), cos(2 * (middle - 0.5 * pi))
    product = sqrt(near) * sqrt(far)
    excess = -(2 * beta * cos_middle * cosine + eta * cos_double * (1 + cosine * cosine))
    split, rate = excess < 0, sqrt(product + (excess if excess > 0 else 0))
    if split:
        mean = -(2 * beta * cos_middle + eta * cosine * cos_double)
        apart = mean_less_field(eta, basin, centre, half_width, near, far, height, mean)
        rate = sine * sqrt(apart * (mean + eta) / (product - excess if split else 1)) if split else rate
    return sqrt(product / 2), rate / 2


def motion_at(beta, eta, piece: Piece, place):
    """The motion of the tip at a place of a piece: −∞ is its low end, +∞ its high end."""
    basin = piece.basin
    rise, drop = piece.width / (1 + exp(-place)), piece.width / (1 + exp(place))
    from_hill, depth = piece.low_offset + rise, piece.high_depth + drop
    upper = from_hill < depth
    hill, well = basin.hill, basin.well
    offset = from_hill if upper else -depth
    stiffness = hill.stiffness if upper else well.stiffness
    double_cosine = hill.double_cosine if upper else well.double_cosine
    double_sine = hill.double_sine if upper else well.double_sine
    tip = (hill.angle if upper else well.angle) + offset
    near_moment = moment_from_rest(eta, stiffness, double_cosine, double_sine, offset)
    # How far V falls from the tip to the well, or to the level of a ridge that the motion passes.
    change = (drop + piece.level_gap if basin.passes else depth) / 2
    height = fall_from_rest(eta, stiffness, double_cosine, double_sine, offset + change, change)
    # Near the high end the clamp is told from there, else as the tip is: the clamp's own distances are exact.
    done, apart = piece.clamp_gap + drop, piece.past_hill - from_hill if upper else piece.past_well + depth
    done = done if done < 0.5 * (from_hill if upper else abs(piece.past_well)) else apart
    depth = turn_to(hill, well) - from_hill if upper else depth
    beside = None
    if basin.even:
        half_width = turn_to(hill, basin.axis) - from_hill if upper else depth + turn_to(well, basin.axis)
        left = 2 * half_width - done if piece.high_kind != "turn" else drop
        far_moment, far_distance = near_moment, from_hill
    else:
        side = far_side(eta, piece, rise, drop, depth, height)
        half_width, left, far_moment, far_distance, beside = side
        if basin.shoulder is not None:
            near_moment, beside = beside_shoulder(eta, basin, from_hill, offset, near_moment, beside)
        near_moment = larger(near_moment, least_moment(basin) * abs(offset))
    # Where the motion is nearly a whole turn, what it lacks is told by the distances from the hills.
    lack = (from_hill + far_distance) / 2 if basin.whole else pi - half_width
    sine = sin(lack if lack < half_width else half_width)
    near, far = 2 * near_moment / sine, 2 * far_moment / sine
    # done/2 + left/2 = half_width: near half a turn one follows from the other.
    done_sine = sin(lack + left / 2 if done > pi else done / 2)
    left_sine = sin(lack + done / 2 if left > pi else left / 2)
    half_cosine = sin(lack / 2)
    centre = halfway(hill, basin.far, basin.axis) + (from_hill - far_distance) / 2
    uneven = 0 if basin.even else unevenness(eta, basin.axis, centre, sine, near, far)
    end, middle = rates(beta, eta, basin, centre, half_width, sine, near, far, height, beside)
    return Motion(
        (
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
    )


def speed_at(motion, phase):
    """|dθ/dσ| where the motion meets the clamp."""
    rate = phase.delta / motion.end
    return turn_speed(motion.sine, motion.done_sine, motion.left_sine, phase.whole, rate)


def excess(item, turns, sign, length):
    """The length of a branch less the rod's."""
    return (2 * turns * item.swing if turns else 0) + sign * item.arrival - length


class Crossing(Record):
    """A tip whose rod has the right length, on branch 2·turns·H + sign·t; ``rising``: the branch grows with the tip."""

    __slots__ = ()

    sample: Sample
    turns: int
    sign: int
    rising: bool


def crossing_near(sample, start, rate, length, long):
    """The crossing near a place by secants; None where there is none. rate: ∂θ(0)/∂place, for a rod of this length.

    long: half-swings may fit the rod.
    """
    item, place = sample(start), start
    back = long and abs(2 * item.swing - item.arrival - length) < abs(item.arrival - length)
    turns, sign = (1, -1) if back else (0, 1)
    slope, value = -sign * rate / speed_at(item.stay.motion, item.phase), excess(item, turns, sign, length)
    rising, blur = slope > 0, WITHIN * 2.0**-52 * length
    for _ in range(TRIES):
        step = value / slope
        if abs(value) <= blur or (abs(step) < 2.0 ** (-52) * (1 + abs(place)) and abs(value) < 8 * blur):
            return Crossing((item, turns, sign, rising))
        trial = place - step
        if not abs(trial - start) < NEAR:
            return None
        new = sample(trial)
        missed = excess(new, turns, sign, length)
        if 2 * abs(missed) > abs(value) and abs(value) < 8 * blur:  # what is left is rounding
            return Crossing((new if abs(missed) < abs(value) else item, turns, sign, rising))
        if abs(step) > (2.0 ** (-52)) ** 0.75 * (1 + abs(place)):
            slope = (missed - value) / (trial - place)
        item, place, value = new, trial, missed
    return None


def tip_on(beta, eta, length, piece, drop, rate, long):
    """The crossing of a tip below the high end of a range; None where there is none near it.

    rate: ∂θ(0)/∂θ(ℓ) for a rod of this length. long: half-swings may fit the rod.
    """
    rise = piece.width - drop
    place = log(rise / drop)
    if not abs(place) < DEEP:
        return None

    def sample(there):
        # No place is so deep that the rod is straight for a part of its length.
        return sample_of(there, Stay((motion_at(beta, eta, piece, there), 0, 0, 0, 0)))

    return crossing_near(sample, place, rate * rise * drop / piece.width, length, long)


def hits(beta, eta, length, ranges, shots):
    """All (range, crossing) from Shots below the clamp angle, from the lowest up; None where one is not found."""

    found: list[tuple] = []
    long = length * sqrt(beta + eta) >= pi
    for piece in ranges:
        for shot in shots[len(found) :]:
            drop = -shot.offset - piece.clamp_gap
            if not 0 < drop < piece.width:
                break
            crossing = tip_on(beta, eta, length, piece, drop, shot.rate, long)
            if crossing is None:
                return None
            found.append((piece, crossing))
        if len(found) == len(shots):
            return found
    return None


def in_basin(at, first, inside, builders):
    """The range of a clamp inside a basin: one before the well and at it, another beyond."""
    return [(inside & (at[first + 1] <= 0), builders[0]), (inside & (at[first + 1] > 0), builders[1])]


def piece_of(basin, low_kind, high_kind, low_offset, width, high_depth, clamp_gap, level_gap, at):
    """The record of a range."""
    rests = (basin.hill, basin.well, basin.axis, basin.far_well, basin.far) if basin.passes else basin[:3]
    rest, offset = rests[0], at[0]
    for other, distance in zip(rests[1:], at[1:], strict=False):
        closer = abs(distance) < abs(offset)
        if closer:
            rest, offset = other if closer else rest, distance if closer else offset
    beyond, last = at[len(rests) - 2 : len(rests)]
    ends = low_kind, high_kind, low_offset, width, high_depth, clamp_gap, level_gap
    return Piece((basin, *ends, rest, offset, -last, beyond, at[0], at[1]))


def from_hill_to_clamp(basin, at):
    """From a hill to a clamp before the well."""
    return piece_of(basin, "hill", "clamp", 0, at[0], -at[1], 0, 0, at)


def basin_of(ground, first):
    """The basin between two neighbouring hills."""
    scene = ground.scene
    hill, well, far = scene.rests[first : first + 3]
    whole = len(scene.rests) == 3
    even = scene.even and (scene.level or whole)
    rise, beside = ground.drop if first else 0, (scene.shoulder, scene.moment, 0.0)
    return Basin((hill, well, far, well, well, rise, False, even, whole, *beside))


def first_clamp(ground):
    """From the first hill to the clamp."""
    return from_hill_to_clamp(basin_of(ground, 0), ground.at[:3])


def from_hill_to_turn(eta, basin, at):
    """From a hill to where the rod turns back at a clamp beyond the well."""
    down, depth = turn_to(basin.hill, basin.well), at[1]
    width = -at[2]
    if not basin.even:
        above = -fall(eta, basin.well, 0, at[1])
        below = fall(eta, basin.far, 0, at[2]) - basin.far_rise
        from_top = reach(eta, basin.hill, below if below > 0 else 0, down, 1)
        from_well = reach(eta, basin.well, above, down, -1)
        depth = down - from_top if below < above else from_well
        width = from_top if below < above else down - from_well
    return piece_of(basin, "hill", "turn", 0, width, depth, depth + at[1], 0, at)


def first_turn(ground):
    """From the first hill to where the rod turns back at the clamp."""
    return from_hill_to_turn(ground.eta, basin_of(ground, 0), ground.at[:3])


def last_clamp(ground):
    """From the second hill to the clamp."""
    return from_hill_to_clamp(basin_of(ground, 2), ground.at[2:])


def last_turn(ground):
    """From the second hill to where the rod turns back at the clamp."""
    return from_hill_to_turn(ground.eta, basin_of(ground, 2), ground.at[2:])


def over_ridge(ground):
    """What stops a motion that passes the ridge."""
    hill, well, ridge, second, far = ground.scene.rests
    return Basin((hill, well, far, second, ridge, 0, True, ground.scene.even, True, None, 0.0, 0.0))


def pass_clamp(ground):
    """From the highest hill to a clamp above the level of the ridge."""
    at = ground.at
    return piece_of(over_ridge(ground), "hill", "clamp", 0, at[0], -at[1], 0, ground.level - at[0], at)


def pass_level(ground):
    """From the highest hill to the level of the ridge."""
    level, depth, at = ground.level, ground.depth, ground.at
    gap = at[0] - level if ground.by_hill else at[1] + depth
    return piece_of(over_ridge(ground), "hill", "level", 0, level, depth, gap, 0, at)


def pass_turn(ground):
    """From the highest hill to where the rod turns back at a clamp above the level of the ridge, beyond it."""
    eta, over, level, at = ground.eta, over_ridge(ground), ground.level, ground.at
    down, below = turn_to(over.hill, over.well), fall(eta, over.far, 0, at[4])
    # V of the clamp above the first well: above the ridge, and the ridge above the well.
    above = fall(eta, over.axis, 0, turn_to(over.axis, over.well)) - ground.height
    by_hill = below < above
    rest, amount = over.hill if by_hill else over.well, below if by_hill else above
    distance = reach(eta, rest, amount, down, 1 if by_hill else -1)
    width, depth = distance if by_hill else down - distance, down - distance if by_hill else distance
    if over.even:
        width = -at[4]
    # Towards the hill V is flat and tells little, but there the angles tell all.
    near, apart = width >= level / 2, level - width if by_hill else depth - ground.depth
    start = level if ground.by_hill else -ground.depth
    rest = over.hill if ground.by_hill else over.well
    gap = -onward(eta, rest, start, ground.height, -apart, near) if near else apart
    return piece_of(over, "hill", "turn", 0, width, depth, at[0] - width if by_hill else at[1] + depth, gap, at)


def level_clamp(ground):
    """From the level of the ridge to the clamp."""
    level, at = ground.level, ground.at
    return piece_of(basin_of(ground, 0), "level", "clamp", level, at[0] - level, -at[1], 0, 0, at)


def level_turn(ground):
    """From the level of the ridge to where the rod turns back at the clamp, before the ridge."""
    eta, basin, level, at = ground.eta, basin_of(ground, 0), ground.level, ground.at
    down = turn_to(basin.hill, basin.well)
    above, below = -fall(eta, basin.well, 0, at[1]), fall(eta, basin.far, 0, at[2])
    from_well = reach(eta, basin.well, above, down, -1)
    # Towards the well V is flat and tells little, but there the angles tell all; towards the hill only V does.
    from_hill = reach(eta, basin.hill, ground.drop + below, down, 1)
    near = onward(eta, basin.hill, level, below, from_hill - level, True)
    by_level = below < above / 4
    width, depth = near if by_level else ground.depth - from_well, ground.depth - near if by_level else from_well
    return piece_of(basin, "level", "turn", level, width, depth, depth + at[1], 0, at)


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


def pieces(ground):
    """All ranges of tip angles below the clamp angle, from low to high, one after the other as they are asked for."""
    found = (build(ground) for here, build in ranges(ground) if here)
    return found


def slowness(hill):
    """Length per unit of the logarithm of the distance from a hill; a flat one is never come near enough to count."""
    return 1 / sqrt(hill.stiffness) if hill.stiffness > 0 else 0


class Delay(Record):
    """By how much a motion lasts longer when the place goes deeper by one, where that is all that changes.

    Near an end the rod is straight for long along the directions at which the motion nearly rests: at the tip, in the
    middle, and at the far turning point. arrival: the share of ``middle`` before the first arrival.
    """

    __slots__ = ()

    deepest: float
    tip: float
    middle: float
    far: float
    arrival: float


def ridge_offset(piece):
    """Clamp less ridge, for a motion that passes the ridge."""
    ridge, rest = piece.basin.axis, piece.clamp_rest
    return piece.clamp_offset if rest.angle == ridge.angle else turn_to(ridge, rest)


def delays(piece):
    """The delays at both ends, beyond the depth at which squares of offsets would underflow."""
    basin, depth = piece.basin, deepest(piece.width)
    if basin.hill.stiffness < (2.0 ** (-52)) ** 8:  # so flat that the moment is as the cube of the offset
        depth = 2 * depth / 3
    # With next to no moment at the clamp a rod is straight but for an offset whose square would underflow.
    straight = piece.high_kind == "clamp" and abs(piece.clamp_offset) < (2.0**-52) ** 5
    far, none = slowness(basin.far), Delay((2 * depth if straight else depth, 0, 0, 0, 0))
    if piece.low_kind == "level":
        return Delay((depth, 0, 0, far / 2, 0)), none
    low = Delay((depth, slowness(basin.hill), 0, far if basin.far_rise == 0 else 0, 0))
    if piece.high_kind != "level":
        return low, none
    ridge = slowness(basin.axis)
    behind = ridge_offset(piece)
    return low, Delay((depth, 0, ridge, 0, ridge if behind > 0 else ridge / 2 if behind == 0 else 0))


def stay_at(beta, eta, piece, ends, place):
    """The motion of the tip at a place, however deep."""
    low, high = ends
    delay = low if place < 0 else high
    depth = min(abs(place), delay.deepest)
    more = abs(place) - depth
    motion = motion_at(beta, eta, piece, -depth if place < 0 else depth)
    return Stay((motion, more * delay.tip, more * delay.middle, more * delay.far, more * delay.arrival))


def sample_at(beta, eta, piece, ends, place):
    """The sample at a place."""
    return sample_of(place, stay_at(beta, eta, piece, ends, place))


def least_arrival(beta, eta, piece, offset, left):
    """A length before which no motion from an offset from the hill, or from a lower one, arrives.

    θ″ is nowhere more than β + η/2, and at an offset from the hill no more than β + η times that, or than its stiffness
    times that where the field is along it: a motion that has the lesser of these two gets ahead of it. left: from
    there to the clamp.
    """
    hill = piece.basin.hill
    # β + η cos u and η cos u − β by sin u: both are largest at u = 0.
    steep, most = hill.stiffness if hill.double_cosine == 1 else beta + eta, beta + eta / 2
    clamp = piece.low_offset + piece.width + piece.clamp_gap
    rest = min(left, max(clamp - min(clamp, most / steep), 0))
    # Up to the offset from which on the other bound is the lesser: by the share that is left of the way there.
    share = (left - rest) / max(offset, TINIEST)
    away, steepness = sqrt(share) * sqrt(2 + share), sqrt(steep)
    growth = share + away
    # Neither is more than ln(1 + x).
    logarithm = 2 * growth / (2 + growth) if growth < 0.001 else log(1 + growth)
    speed = steepness * away * offset
    return logarithm / steepness + 2 * rest / (speed + sqrt(speed * speed + 2 * most * rest) + TINIEST)


def about(piece, place):
    """How far a place of a piece is from the hill and from the clamp."""
    place = max(place, -deepest(piece.width))
    from_hill = piece.low_offset + piece.width / (1 + exp(-place))
    return from_hill, piece.clamp_gap + (piece.width / (1 + exp(place)) if place < deepest(piece.width) else 0)


def fall_between(eta, piece, one, other):
    """How far V falls from the tip at a place to that at a higher one."""
    rise, drop = piece.width / (1 + exp(-one)), piece.width / (1 + exp(one))
    further = piece.width / (1 + exp(-other)) - rise if one < 0 else drop - piece.width / (1 + exp(other))
    from_hill, depth = piece.low_offset + rise, piece.high_depth + drop
    if from_hill < depth:
        return fall(eta, piece.basin.hill, from_hill, further)
    return fall(eta, piece.basin.well, -depth, further)


def beside_level(eta, piece):
    """Places, without their sign, from the middle of a range to where its motion turns at the level of the shoulder.

    The length of a motion changes with the logarithm of the level's distance from the shoulder's until there the moment
    is as good as the shoulder's own.
    """
    basin, level = piece.basin, piece.low_offset if piece.low_kind == "shoulder" else piece.width
    moment = larger(abs(basin.moment), (2.0**-52) ** 2)
    bend = abs(basin.moment + 1.5 * eta * basin.shoulder.double_sine)
    steep = larger(abs(slope(eta, basin.hill, level)), (2.0**-52) ** 2)
    flat = larger(log(steep * piece.width * sqrt(bend) / moment) - log(moment) / 2, 0)
    found = [flat * k / (ceil(flat / 3) + 1) for k in range(1, ceil(flat / 3) + 2)] if flat > 0 else []
    last = max([*found, flat])
    # At the last place the level is the shoulder's in all digits, and the next range begins with the same length.
    return [*found, last + 1.25, last + 2.5, last + 5, last + 10, last - log(2.0**-52), last - 3 * log(2.0**-52)]


def grid(beta, eta, length, piece):
    """Places to begin with: near enough where the branches bend, and to where none of them is as short as the rod."""
    rounding = -log(2.0**-52)
    slow = (1 + 16 * 2.0**-52) * length * sqrt(beta + eta)  # of a very long rod rounding is more than the 6 below
    first = -2 * slow - 6 if piece.low_kind == "level" else -slow - 6
    first = min(first, -rounding) if piece.low_kind == "level" else first
    if piece.high_kind == "level":
        last = 2 * slow + rounding
    elif piece.high_kind != "clamp":
        last = 2 * rounding
    elif piece.high_depth == 0:
        last = rounding
    else:
        # The tip of a stiff rod departs from the clamp angle by half the moment there times the length squared.
        moment = abs(slope(eta, piece.clamp_rest, piece.clamp_offset)) + (2.0**-52) ** 20
        last = max(rounding, 4 + log(2 * piece.width) - log(moment) - 2 * log(length))
        last = min(last, 2 * deepest(piece.width))
    inner = [0.0]
    for side, end, kind in ((-1, -first, piece.low_kind), (1, last, piece.high_kind)):
        if kind == "shoulder":
            inner += [side * place for place in beside_level(eta, piece)]
            continue
        inner += [side * place for place in (1.25, 2.5, 5.0, 10.0) if place < end]
        inner.append(side * end)
    return sorted(inner)


def astroid_cusp(field_angle):
    """Where the second pair is born: tan³x = tan α (Stoner and Wohlfarth's astroid).

    The pair lies at α + π + x with sin α/sin x + cos α/cos x = η/β: it is there when η/β is beyond the least value of
    the left side, taken at this x.
    """
    return atan((sin(field_angle) / larger(cos(field_angle), 2.0**-52)) ** (1 / 3))


def twist(eta, x):
    """The couple of the field on a rod turned by x from it."""
    return eta * sin(x) * cos(x)


def ridge_couple(beta, eta, field_angle, x):
    """The couple on a rod that points along α + π + x."""
    return twist(eta, x) - beta * sin(field_angle + x)


def places(beta, eta, length, piece):
    """Places to begin with, closer around the level at which the motion meets a ridge that is not quite there."""
    found, basin = grid(beta, eta, length, piece), piece.basin
    divided = "shoulder" in (piece.low_kind, piece.high_kind)
    if basin.even or basin.passes or piece.low_kind == "level" or not basin.whole or divided:
        return found
    angle = abs(0.5 * pi)
    cusp = angle + pi + astroid_cusp(angle)
    # How far η is below the value at which the ridge would appear.
    missing = max(-ridge_couple(beta, eta, angle, astroid_cusp(angle)) / (beta + eta), 2.0**-52)
    cusp = cusp
    down = turn_to(basin.hill, basin.well)
    rise = reach(eta, basin.hill, fall(eta, basin.hill, 0, cusp - basin.hill.angle), down, 1)
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
    known = basin.even
    return known and piece.clamp_gap > piece.high_depth


def ends_of(found, places, gap):
    """The places between which a gap lies: before the sample of its number, or behind the last."""
    return found[gap - 1].place if gap > 0 else places[0], found[gap].place if gap < len(found) else places[-1]


def convex_bound(found, gap, width, fallen):
    """What a convex arrival is nowhere less than in a gap before a sample: the chords beside it, carried on.

    width: how far V falls from one end of the gap to the other.
    """
    bound = -inf
    for near, far in ((gap - 1, gap - 2), (gap, gap + 1)):
        if min(near, far) >= 0 and max(near, far) < len(found):
            beside = abs(fallen(found[near].place, found[far].place))
            if beside > 0:
                steep = (found[far].arrival - found[near].arrival) / beside
                bound = max(bound, found[near].arrival - max(steep * width, 0))
    return bound


def open_gap(found, places, fallen, length):
    """The gap beside the least sample in which a convex arrival may be least and no longer than the length, or None."""
    least = min(range(len(found)), key=lambda k: found[k].arrival)
    best, bound = None, (1 + SAFE) * length
    for gap in (least, least + 1):
        low, high = ends_of(found, places, gap)
        if high - low > 2 * sqrt(2.0 ** (-52)) * (1 + abs(found[least].place)):
            lowest = convex_bound(found, gap, fallen(low, high), fallen)
            if lowest <= bound:
                best, bound = gap, lowest
    return best


def inside(places, low, high):
    """The middle one of the places in a gap; where there is none, half way, or its end if that is one of all."""
    within = [place for place in places if low < place < high]
    if within:
        return within[len(within) // 2]
    return (low + high) / 2


def valley(sample, places, fallen, length):
    """Samples on both sides of every crossing of a length that is shorter than a half-swing, for a convex arrival.

    Without a crossing there may be none. fallen(low, high): how far V falls between the tips at two places.
    """
    last = len(places) - 1
    found = [sample(places[k]) for k in sorted({last // 4, last // 2, last - last // 4})]
    while min(item.arrival for item in found) > length:
        gap = open_gap(found, places, fallen, length)
        if gap is None:
            return []
        found.insert(gap, sample(inside(places, *ends_of(found, places, gap))))
    while found[0].arrival <= length and found[0].place > places[0]:
        found.insert(0, sample(max(place for place in places if place < found[0].place)))
    while found[-1].arrival <= length and found[-1].place < places[-1]:
        found.append(sample(min(place for place in places if place > found[-1].place)))
    return found


def bends(first, second, third, length, last):
    """Whether the curves bend so much at the second sample that a count may reach a whole number unseen beside it.

    Those beyond the last are not wanted. By how far the straight line through two samples misses the third.
    """
    share = (third.place - second.place) / (second.place - first.place)
    swing = third.swing - second.swing - share * (second.swing - first.swing)
    arrival = third.arrival - second.arrival - share * (second.arrival - first.arrival)
    least = min(first.swing, second.swing, third.swing)
    reach = (abs(arrival) + (length / least * abs(swing) if length > least else 0)) / (2 * least)
    for sign in (1, -1):
        for item in (first, second, third):
            count = (length - sign * item.arrival) / (2 * item.swing)
            whole = min(floor(count + 0.5), last)
            if abs(count - whole) < reach and (whole > 0 or (whole == 0 and sign > 0)):
                return True
    return False


def refined(sample, samples, length, last):
    """More samples where half-swing or arrival bend between neighbours, as far as the rod's length is sensitive."""
    done, todo = [samples[0]], samples[:0:-1]
    while todo:
        before, after = done[-1], todo[-1]
        apart = after.place - before.place > max(NEAREST, 8 * 2.0**-52 * abs(before.place))
        beside = [(done[-2], before, after)] if len(done) > 1 else []
        beside += [(before, after, todo[-2])] if len(todo) > 1 else []
        if apart and any(bends(one, two, three, length, last) for one, two, three in beside):
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


def samples_on(beta, eta, length, piece, sample, short, last):
    """Samples of a piece, near enough for all crossings of whole numbers up to the last.

    short: the rod is shorter than any half-swing.
    """

    def too_low(place):
        return least_arrival(beta, eta, piece, *about(piece, place)) > (1 + SAFE) * length

    def fallen(one, other):
        return fall_between(eta, piece, one, other)

    if too_low(inf):
        return []
    wanted = places(beta, eta, length, piece)
    first = 0
    while first + 2 < len(wanted) and too_low(wanted[first + 1]):
        first += 1
    if short and arrives_convexly(piece):
        return valley(sample, wanted[first:], fallen, length)
    # A motion that arrives before the stiffest pendulum is down arrives the sooner, the nearer its tip (Sturm).
    quarter = pi / 2 / sqrt(beta + eta)
    soon = (1 - SAFE) * min(quarter, length) if short and piece.high_kind == "clamp" else 0
    samples = refined(sample, sampled(sample, wanted, first, soon), length, last)
    end = end_sample(piece, samples[-1])
    return samples if end is None else [*samples, end]


def between(samples, counts, k, last):
    """The whole numbers from the lower count of a sample and that before it up to, but not at, the higher one.

    None beyond the last, of which a long rod may have too many to list.
    """
    low, high = (counts[k - 1], counts[k]) if counts[k - 1] < counts[k] else (counts[k], counts[k - 1])
    turns = range(max(ceil(low), 0), max(ceil(min(high, last + 0.5)), 0))
    if not turns:
        return []
    near = 4 * (samples[k].place - samples[k - 1].place)
    beside = [samples[k - 2]] if k > 1 and samples[k - 1].place - samples[k - 2].place < near else []
    if k + 1 < len(samples) and samples[k + 1].place - samples[k].place < near:
        beside.append(samples[k + 1])
    return [(number, samples[k - 1], samples[k], beside) for number in turns]


def dip(sample, short, left, middle, right):
    """The sample at which ``short`` is least between left and right by golden sections, or the first below zero."""
    golden = (3 - sqrt(5)) / 2
    value = short(middle)
    while right.place - left.place > 2 * sqrt(2.0 ** (-52)) * (1 + abs(middle.place)):
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
    return [(goal, left, best, [right]), (goal, best, right, [left])]


def brackets(sample, samples, counts, length, sign, last):
    """(turns, sample, sample, those beside) for every whole number that the count crosses between the two samples.

    Those beyond the last are not wanted.
    """
    found = []
    for k in range(1, len(samples)):
        found += between(samples, counts, k, last)
    for k in range(1, len(samples) - 1):
        before, here, after = counts[k - 1 : k + 2]
        if (before - here) * (after - here) > 0 and here < last + 1:
            found += at_extremum(sample, samples[k - 1 : k + 2], (before, here, after), length, sign)
    return found


def with_node(nodes, parts, place, value):
    """The places of a polynomial and its divided differences, with one more place in front, and no more than five."""
    found = [value]
    for k in range(min(len(nodes), 4)):
        value = (value - parts[k]) / (place - nodes[k])
        found.append(value)
    return [place, *nodes[:4]], found


def zero_near(nodes, parts):
    """A zero of a polynomial near its first place; any number where there is none."""
    last, before, third, fourth = (nodes + 2 * nodes[-1:])[:4]
    value, slope, bend, twist, rest = (*parts, 0, 0, 0)[:5]
    zero = last
    for _ in range(3):
        steep = slope + (zero - before) * (bend + (zero - third) * (twist + (zero - fourth) * rest))
        if steep == 0:
            break
        zero = last - value / steep
    return zero


def bracketed_root(function, places, values, blur):
    """A sign change of the function between the first two places, to rounding.

    By the zero of the polynomial through the last five places at which the function is known, or by halving where that
    gains little. More places may be known than two. blur: a value that rounding may have made of zero.
    """

    nodes: list[float] = []
    parts: list[float] = []
    for k in range(len(places) - 1, -1, -1):
        nodes, parts = with_node(nodes, parts, places[k], values[k])
    (a, b, *_), (value_a, value_b, *_) = places, values
    halve = False
    while True:
        if abs(value_b) < abs(value_a):
            a, b, value_a, value_b = b, a, value_b, value_a
        least, width = 2 * 2.0**-52 * (1 + abs(a)), abs(b - a)
        if 2 * least > width or abs(value_a) <= blur:
            return a
        share = 0.5 if halve else (zero_near(nodes, parts) - a) / (b - a)
        if 2 * abs(share) * width < least and abs(value_a) < 16 * blur:
            return a
        if -0.05 < share < 0:  # rounding of the values puts the zero on the wrong side
            share = -2 * share
        share = max(least / width, share) if 0 <= share < 1 else 0.5
        trial = a + min(1 - least / width, share) * (b - a)
        value = function(trial)
        nodes, parts = with_node(nodes, parts, trial, value)
        little = 4 * abs(value) > abs(value_a)
        if (value > 0) == (value_a > 0):
            a, value_a = trial, value
        else:
            b, value_b = trial, value
        halve = little and 2 * abs(b - a) > width


def crossing(sample, turns, sign, length, known):
    """The crossing between the first two samples, on either side of it; those beside them help to start."""
    seen = {}

    def function(place):
        seen[place] = sample(place)
        return excess(seen[place], turns, sign, length)

    values = [excess(item, turns, sign, length) for item in known]
    place = bracketed_root(function, [item.place for item in known], values, 2.0**-52 * length)
    return Crossing((seen.get(place) or sample(place), turns, sign, values[1] > values[0]))


def crossings(beta, eta, length, piece, most):
    """Every crossing of the rod's length on a piece whose index can be at most ``most``, as a list of Crossing."""
    ends = delays(piece)

    def sample(place):
        return sample_at(beta, eta, piece, ends, place)

    # No half-swing is shorter than that of the stiffest pendulum.
    short = length * sqrt(beta + eta) < pi
    samples = samples_on(beta, eta, length, piece, sample, short, (most + 1) / 2)
    found = []
    for sign in (1,) if short else (1, -1):
        counts = [(length - sign * item.arrival) / (2 * item.swing) for item in samples]
        # At least 2·turns − 1 conjugate points, or one more on the branch that has gone on.
        last = (most + (sign < 0)) / 2
        for turns, before, after, beside in brackets(sample, samples, counts, length, sign, last):
            if (turns or sign > 0) and turns <= last:
                found.append(crossing(sample, turns, sign, length, (before, after, *beside)))
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


def heading_of(field_angle, motion):
    """The direction of a motion's tip."""
    double = 2 * (motion.tip - field_angle)
    return Heading((cos(motion.tip), sin(motion.tip), cos(double), sin(double)))


def rj_pair(x, product, root_sum, p, lift, less, twist):
    """R_J(x, y, z, p) by duplication, for x ≥ 0, complex p, and y and z by √y√z and √y + √z.

    lift, less, twist: p + √y√z, p − x and (p − x)(p − y)(p − z), which the rod gives without cancellation. Sums of
    positive terms only in x, y, z. Where √p and −√y are near each other, their sum follows from their difference.
    """
    pair = root_sum * root_sum - 2 * product
    fivefold = x + pair + (p + p)
    start = fivefold / 5
    one, two = start - x, 2 * start - pair
    both = start * start - start * pair + product * product
    reach = 5 * (abs(one) + abs(start - p) + sqrt(abs(both)))
    # Twice that of the largest departure from the mean, for these are added up.
    target = 2 * (2.0**-52 / 4) ** 0.125
    scale, total = 1, 0
    while reach > target * scale * abs(fivefold):
        root, root_p = sqrt(x), complex_sqrt(p)
        side, across = root_p * root_sum, root * root_sum
        plus = lift + side
        if scale == 1:
            minus = lift - side
            cancels = abs(plus) < abs(minus)
            plus = twist / (less * (minus if cancels else 1)) if cancels else plus
        share = 1 / ((root_p + root) * plus)  # one quotient of complex numbers, which take longer than products
        raised, lifted = lift + across, sqrt(x + product + across)
        end = (root_p + root_p) * raised * share
        total = total + arctan_share(twist * share * share, end) * share / scale
        pair = root_sum * (root_sum + 2 * root) / 4
        x, p = (x + product + across) / 4, raised * 0.25
        product, root_sum = root_sum * lifted / 4, sqrt(root_sum * (root_sum + 2 * root + 2 * lifted)) / 2
        lift, fivefold, twist = p + product, x + pair + (p + p), twist * 0.015625
        scale *= 4
    mean = fivefold / 5
    size = scale * mean
    a, b, c = one / size, two / size, both / (size * size)
    d = -(a + b) / 2
    e2 = a * b + c - 3 * d * d
    e3 = a * c + 2 * e2 * d + 4 * d * d * d
    e4 = (2 * a * c + e2 * d + 3 * d * d * d) * d
    e5 = a * c * d * d
    bent = e2 * (9 / 88 - e2 * (1 / 16) + e3 * (45 / 272)) - e3 * (9 / 52) + e4 * (3 / 20) - e5 * (9 / 68) - 3 / 14
    series = 1 + e2 * bent + e3 * (1 / 6 + e3 * (3 / 40) - e4 * (9 / 68)) - e4 * (3 / 22) + e5 * (3 / 26)
    return series / (scale * mean * complex_sqrt(mean)) + 6 * total


def shift(eta, heading, motion, point, root, square, rest):
    """W as real and imaginary part: ∫e^{iθ} from the tip is e^{iφ}(σ + W)."""
    b, near, far = point.strength, sqrt(motion.near), sqrt(motion.far)
    twist = complex_of(rj_delta_real(eta, b, heading.double_cosine), rj_delta_imag(eta, b, heading.double_sine))
    lift = pair_lift(near, far, motion.uneven, motion.half_cosine, square, rest)
    pole, lifted, less = complex_of(point.pole, -b), complex_of(lift, -b), complex_of(root, -b)
    third = rj_pair(point.one, point.product, point.root_sum, pole, lifted, less, twist)
    return w_real(b, third.imag), w_imag(b, third.real)


def kink_at(motion, first, second, point, root, q, m, square, rest):
    """The part of η∫cos²(θ − α) without integral; towards the tip its terms are large and cancel in the first form."""
    b, x, product = point.strength, point.pole, point.product
    delta = larger(phase_rate(first, second, square, rest), second * sqrt(square))
    across, others = sqrt(square * rest), others_sum(q, root)
    both = others_product(b, m, root, others)
    lift = pair_lift(sqrt(motion.near), sqrt(motion.far), motion.uneven, motion.half_cosine, square, rest)
    far = arc_kink(first, square, delta, across, b, x, root, sqrt(point.one), product)
    # Beyond the middle the lift may be as good as nothing to divide by, and the square of the pole, too.
    towards_tip = lift > 0.15
    lift, there = lift if towards_tip else 1, x if towards_tip else 1
    return arc_kink_tip(first, delta, across, b, there, root, others, both, lift) if towards_tip else far


def second_kind(a, b, square, rest, arrival):
    """∫sin²ψ over the same range as ``arrival``, the length, and by how much that exceeds sin ψ cos ψ/Δ.

    By the same transformation (DLMF 19.8.19). Both are small as the cube of a short length, without a difference.
    """
    limit, more, gap = (2.0**-52) ** 0.5, a > 0, a - b
    delta, weight, weights, integral, excess = phase_rate(a, b, square, rest), 0.5, 0.0, 0, 0
    while more:
        more = abs(gap) > limit * a
        total, below = a + b, a + delta
        square, rest = gauss_square(square, total, below), gauss_rest(a, b, square, rest, delta, below)
        share, first, second = gap / total, 2 * a / total, 2 * b / total
        a, b = total / 2, sqrt(a * b)
        delta = phase_rate(a, b, square, rest)
        bend = phase_bend(share, first, square, rest, sqrt(square * rest), delta)
        step = lag_step(bend, share, second, square, rest)
        integral = integral + weight * first * bend + weights * step
        weights, weight, excess = weights + weight, weight * share / 2, excess + step
        gap = gauss_gap(gap, a + b)  # a difference would lose what the weight brings out
    last = arc_excess((a + b) * arrival) / (a + b)
    return integral + (weights + weight) * last, excess + last


def arc_to(beta, eta, heading, motion, point, square, rest, extent):
    """The arc from the tip to a point, at ψ, of the given length."""
    root = far_root(motion.near, cos(motion.half_width))
    w_re, w_im = shift(eta, heading, motion, point, root, square, rest)
    y, z = arc_y(heading.sine, heading.cosine, w_re, w_im), arc_z(heading.sine, heading.cosine, w_re, w_im)
    first, second = motion.end / 2, motion.middle / 2
    q = rest_stiffness(beta, eta, heading.cosine, heading.double_cosine)
    m = tip_cubic(beta, eta, heading.sine, heading.double_sine)
    kink = kink_at(motion, first, second, point, root, q, m, square, rest)
    turned, lag = second_kind(first, second, square, rest, extent)
    return Arc((y, z, arc_square(beta, first, second, root, y, kink, turned, lag)))


class Point(Record):
    """A point of a motion by ℘ − c = x and ℘ − e at its three half-period values.

    one: ℘ − e₁, with e₁ that of the far turning point. product, root_sum: √(℘ − e₂)√(℘ − e₃) and √(℘ − e₂) + √(℘ − e₃),
    real also where e₂ and e₃ are a complex pair.
    """

    __slots__ = ()

    strength: float  # b
    pole: float  # x
    one: float
    product: float
    root_sum: float


def clamp_point(motion, phase):
    """The point where the motion meets the clamp."""
    b, done = strength(motion.near_moment), motion.done_sine
    one = point_near(b, motion.sine, done, motion.left_sine)
    product = pair_root(sqrt(motion.near), done, phase.whole, phase.delta / motion.end)
    delta = phase_rate(motion.end / 2, motion.middle / 2, phase.square, phase.rest)
    # 2Δ/sin ψ is no less than ``middle``, the square of which may underflow.
    root_sum = larger(pair_root_sum(phase.square, delta), motion.middle)
    return Point((b, point_pole(b, done, cos(motion.done / 2)), one, product, root_sum))


def with_stays(rod, heading, arc, basin, middle, far):
    """An arc with the straight lengths along the ridge and the far hill, at which the motion nearly rests.

    Those along the tip's direction change nothing.
    """
    if middle == 0 and far == 0:
        return arc
    y, z, square = arc
    for angle, extent in ((basin.axis.angle, middle), (basin.far.angle, far)):
        turned = rod.eta * (cos(2 * (angle - 0.5 * pi)) - heading.double_cosine) / 2
        y, z = y + extent * (cos(angle) - heading.cosine), z + extent * (sin(angle) - heading.sine)
        square = square + extent * turned
    return Arc((y, z, square))


def sent_back(motion):
    """The motion from its far turning point back to the tip, as the mirror at the y axis shows it.

    A clamp at the turning point itself, where the motion has no point by ℘, is a little before it.
    """
    return motion._replace(
        tip=-(motion.tip + 2 * motion.half_width),
        done=motion.left,
        left=motion.done,
        near_moment=motion.far_moment,
        far_moment=motion.near_moment,
        near=motion.far,
        far=motion.near,
        uneven=-motion.uneven,
        done_sine=larger(motion.left_sine, (2.0**-52) ** 6),
        left_sine=motion.done_sine,
    )


def arc_from_far(eta, heading, there, arc, extent):
    """The arc of a motion turned back, whose heading is ``there``, as what departs from the tip's direction."""
    y, z = arc.y + extent * (there.cosine - heading.cosine), arc.z + extent * (there.sine + heading.sine)
    return Arc((y, -z, arc.square + extent * eta * (there.double_cosine - heading.double_cosine) / 2))


def last_stretch(rod, heading, motion, extent):
    """The arc from the last turning point to the clamp, of a rod that ends on its way back; extent: its length."""
    back = sent_back(motion)
    there, phase = heading_of(-0.5 * pi, back), phase_of(back)
    arc = arc_to(rod.beta, rod.eta, there, back, clamp_point(back, phase), phase.square, phase.rest, extent)
    return arc_from_far(rod.eta, heading, there, arc, extent)


def far_point(motion):
    """The far turning point."""
    b = strength(motion.near_moment)
    pole = point_pole(b, motion.sine, cos(motion.half_width))
    return Point((b, pole, 0, far_pair_root(motion.end), motion.middle))


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
        return Arc((0, 0, 0)), part
    whole = arc_to(beta, eta, heading, motion, far_point(motion), 1, 0, swing)
    whole = with_stays(rod, heading, whole, basin, stay.middle, stay.far)
    return whole, Arc(float(through * a + b) for a, b in zip(whole, part, strict=True))


def swing_of(length, turns, basin, crossing, heading, whole, arc, through):
    """The half-swing of a bent rod, for its shape. through: half-swings before the one at the clamp."""
    sample, both = crossing.sample, 2 * crossing.turns
    # The length of the rod is better known than that of a half-swing.
    half_swing = (length - crossing.sign * sample.arrival) / both if both else sample.swing
    return Swing(
        (
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
    )


def bent_rod(rod, turns, piece, crossing, index):
    """The equilibrium of a tip on its branch."""
    beta, eta, length, side, scale = rod.beta, rod.eta, rod.length, rod.side, rod.scale
    motion, phase = crossing.sample.stay.motion, crossing.sample.phase
    heading = heading_of(0.5 * pi, motion)
    through = 2 * crossing.turns - (1 if crossing.sign < 0 else 0)
    whole, arc = arcs_of(rod, piece.basin, crossing, heading, through)
    gamma = 2 * beta * heading.cosine + eta * (1 + heading.double_cosine) / 2
    energy = -gamma * length / 2 - 2 * beta * arc.y - arc.square
    near = motion.done < abs(motion.tip)  # the clamp angle is exact
    tip = rod.clamp_angle - motion.done if near else plus_quarters(motion.tip, 4 * turns)
    return Equilibrium(
        (
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
    )


def below(rod, scene, clamp, ridge, most, shots):
    """The equilibria with tips below the clamp angle, from the lowest up; tips may be nearer than rounding.

    ridge: that of the landscape, or None where it is not known yet. shots: all tips, roughly, or None.
    """
    tips = None if shots is None else [shot for shot in shots if shot.offset < 0]
    if tips == []:
        return []
    beta, eta, length = rod.beta, rod.eta, rod.length
    ground = ground_of(eta, scene, clamp, ridge_of(beta, eta, scene) if ridge is None else ridge)
    found = None
    if tips is not None:
        found = hits(beta, eta, length, pieces(ground), tips)
    if found is None:
        found = []
        for piece in pieces(ground):
            if piece.width > 0:  # else the clamp angle is at the level of the ridge, to rounding
                here = crossings(beta, eta, length, piece, most)
                found += [(piece, crossing) for crossing in sorted(here, key=lambda item: item.sample.place)]
    indexed = [(piece, crossing, index_of(crossing)) for piece, crossing in found]
    return [bent_rod(rod, clamp.turns, *item) for item in indexed if item[2] <= most]


def mirror_shots(shots):
    """The tips of the rod seen from the other side of the y axis."""
    return [Shot((-shot.offset, shot.rate)) for shot in shots[::-1]]


def in_order(found):
    """The list with tips that are nearer than rounding given as equal, where rounding would exchange them."""
    for k in range(1, len(found)):
        if found[k].tip_angle < found[k - 1].tip_angle:
            found[k] = found[k]._replace(tip_angle=found[k - 1].tip_angle)
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
    along = cos(rest.angle - 0.5 * pi)
    gamma = 2 * rod.beta * cosine + rod.eta * along * along
    soft = -rest.stiffness
    index = floor(rod.length * sqrt(soft) / pi + 0.5) if soft > 0 else 0
    energy = -(rod.beta * cosine + rod.eta * along * along / 2) * rod.length
    length = length_of(rod)
    return Equilibrium(
        (
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
    )


def straight(rod, scene, clamp, most):
    """The straight equilibrium, if the clamp angle is a direction without moment."""
    if 0 not in clamp.offsets:
        return []
    found = [straight_rod(rod, rest) for rest, offset in zip(scene.rests, clamp.offsets, strict=True) if offset == 0]
    return [item for item in found if item.index <= most]


def all_equilibria(beta, eta, length, clamp_angle, max_index):
    """Every equilibrium, sorted by tip angle: from the tips below the clamp angle, above it, and the straight rod."""
    if length * sqrt(beta + eta) <= 2.0 ** (-52):
        return [weak_rod(beta, eta, length, clamp_angle)]
    most = inf if max_index is None else max_index
    scale = frexp(beta + eta)[1] // 2
    rod = Rod((ldexp(beta, -2 * scale), ldexp(eta, -2 * scale), ldexp(length, scale), clamp_angle, 1, scale))
    mirrored = Rod((rod.beta, rod.eta, rod.length, -clamp_angle, -1, scale))
    scene, other = landscapes(rod.beta, rod.eta)
    clamp = clamp_in(scene.rests, rod.clamp_angle)
    beyond = mirrored_clamp(scene, other, clamp, mirrored.clamp_angle)
    ridge = ridge_of(rod.beta, rod.eta, scene) if other is scene else None
    shots = tip_shots(rod.beta, rod.eta, rod.length, rod.clamp_angle)
    lower = below(rod, scene, clamp, ridge, most, shots)
    upper = below(mirrored, other, beyond, ridge, most, None if shots is None else mirror_shots(shots))
    return in_order([*lower, *straight(rod, scene, clamp, most), *upper[::-1]])


class Station(Record):
    """A point of the rod on its half-swing: lengths from the tip and from the far turning point.

    whole: half-swings between the tip and the one it lies on, which is run through backwards where that is odd.
    beside: the length from the clamp; away: 1 where the motion from the tip is beyond the clamp there, −1 where it is
    before it, 0 where a turning point lies between.
    """

    __slots__ = ()

    whole: int
    from_tip: float
    from_far: float
    beside: float
    away: int


def station_at(swing, whole, from_tip, length, beside, away):
    """The station at a length from the tip, or from the far turning point."""
    other = swing.length - length
    near, far = (length, other) if from_tip else (other, length)
    return Station((whole, near, far, beside, away))


def station_of(rod, swing, s):
    """The point at a length from the clamp, measured from the nearer end of the rod.

    The last digit of a long rod's length is many digits of θ where it bends beside the clamp.
    """
    towards_tip = swing.whole % 2 == 0
    ahead = swing.arrival if towards_tip else swing.length - swing.arrival
    if 2 * s >= rod.length:
        # The motion takes a rounding more or less than the rod is long.
        left = rod.length - s if swing.whole else (rod.length - s) * (swing.arrival / rod.length)
        whole = floor(left / swing.length)
        return station_at(swing, whole, whole % 2 == 0, left - whole * swing.length, s, 0)
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


def point_at(motion, square, rest):
    """The point at ψ by sin²ψ and cos²ψ, half the angle from the tip to it, and |dθ/dσ| there, by cos χ."""
    a, b, near, far = motion.end / 2, motion.middle / 2, sqrt(motion.near), sqrt(motion.far)
    flat = (b / a) * (b / a) * square
    scale = chi_scale(square, rest, flat)
    versine, coversine = chi_versine(square, rest, flat, scale), chi_coversine(rest, scale)
    level = turn_level(near, far, versine, coversine)
    # The difference of the roots where they are near each other, else that of the terms themselves.
    alike = turn_tilt(near, far, motion.uneven, chi_cosine(square, rest, flat, scale))
    apart = turn_tilt_apart(near, far, versine, coversine)
    tilt = alike if abs(motion.uneven) < 0.1 * (near + far) else apart
    sine, cosine = sin(motion.half_width / 2), motion.half_cosine
    over, under = turn_over(near, sine, cosine, versine), turn_under(sine, cosine, level, tilt)
    left_over, left_under = turn_over(far, sine, cosine, coversine), turn_under(sine, cosine, level, -tilt)
    done, ahead = unit_sine(over, under), unit_sine(left_over, left_under)
    whole = phase_sum(near, far, done, ahead)
    rate = chi_rate(square, rest, flat, scale)
    delta, strong = phase_rate(a, b, square, rest), strength(motion.near_moment)
    point = Point(
        (
            strong,
            point_pole(strong, over, under),
            near_by_phase(square, rest, a * a / delta),
            pair_root(near, done, whole, rate),
            pair_root_sum(square, delta),
        )
    )
    return point, atan2(over, under), turn_speed(motion.sine, done, ahead, whole, rate)


def way_back(rod, heading, motion, phase, extent, position):
    """Half the angle and the arc from the far turning point to a point, by sin²ψ and cos²ψ from there."""
    if extent == 0:
        return 0 * extent, Arc((0, 0, 0))
    back, (square, rest) = sent_back(motion), phase
    point, half, _ = point_at(back, square, rest)
    if not position:
        return half, Arc((0, 0, 0))
    there = heading_of(-0.5 * pi, back)
    arc = arc_to(rod.beta, rod.eta, there, back, point, square, rest, extent)
    return half, arc_from_far(rod.eta, heading, there, arc, extent)


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
    share = (b / a) * (b / a)
    ratio, by_ratio = phase_ratio(share, square, rest), phase_ratio(share, by_square, by_rest)
    fall = square - by_square if square < rest else by_rest - rest
    over = before_over(square, rest, by_ratio)
    sine = before_sine(square, rest, ratio, by_square, by_rest, by_ratio, fall)
    cosine = before_cosine(square, rest, ratio, by_square, by_rest, by_ratio, over)
    return sine * sine, cosine * cosine


def tangent_at(a, b, length):
    """tan ψ at a length up to the middle of the half-swing."""
    if a < b:
        return tangent_exchanged(b, a, tangent_at(b, a, length))
    shares, mean = small_steps(a, b)
    if b > APART * a:
        tangent = tan(mean * length)
        square = tangent * tangent
        for share in reversed(shares):
            square = square + square * gauss_more(share, square)
        return sqrt(square)
    tangent = sinh(mean * length)
    for share in reversed(shares):
        tangent = tangent + tangent * landen_more(share, tangent)
    return tangent


def phase_at(a, b, length, left):
    """sin²ψ and cos²ψ at lengths from the tip and from the half-swing's end, by the nearer one of them."""
    first = length <= left
    tangent = tangent_at(a, b, length) if first else tangent_at(b, a, left)
    square = tangent * tangent
    small, large = square / (1 + square), 1 / (1 + square)
    return (small, large) if first else (large, small)


def phase_beside(a, b, square, rest, station, whole):
    """sin²ψ and cos²ψ of a point beside the clamp by those of the clamp; whole: the length of the half-swing."""
    length, back = station.beside, whole - station.beside
    if station.away < 0:
        return phase_before(a, b, square, rest, phase_at(a, b, length, back))
    # Seen from the far turning point.
    square, rest = phase_before(b, a, rest, square, phase_at(b, a, length, back))
    return rest, square


def phase_from_far(motion, square, rest):
    """sin²ψ and cos²ψ of a point as the motion turned back has them."""
    first, second = motion.end / 2, motion.middle / 2
    # The square of b may underflow.
    delta = larger(phase_rate(first, second, square, rest), second * sqrt(square))
    sine, cosine = far_sine(first, rest, delta), far_cosine(second, square, delta)
    return larger(sine * sine, (2.0**-52) ** 12), cosine * cosine


def regular_part(rod, swing, station, here, left, position):
    """θ in two parts, dθ/dσ and the arc, at lengths of the motion alone from the tip and the far turning point."""
    motion, back, arc = swing.stay.motion, station.whole % 2 == 1, Arc((0, 0, 0))
    if here <= 2.0 ** (-52) * left:  # where the square of the phase may underflow
        if back and position:
            _, arc = way_back(rod, swing.heading, motion, (1, 0), left, position)
        return *apart_by_quarters(motion.tip, 4 * swing.turns), 0 * here, arc
    a, b = motion.end / 2, motion.middle / 2
    if next_to_clamp(swing, station, here, left):
        square, rest = phase_beside(a, b, swing.square, swing.rest, station, here + left)
    else:
        square, rest = phase_at(a, b, here, left)
    point, half, speed = point_at(motion, square, rest)
    # The clamp angle is exact: what is measured from there is told from there; what turned back, if that is near.
    anchor, turned = rod.clamp_angle, 2 * half - motion.done
    if station.away == 0 and motion.done > abs(motion.tip):
        anchor, turned = apart_by_quarters(motion.tip + 2 * half, 4 * swing.turns)
    if back or left < here:
        # So near the far turning point that cos²ψ underflows the lengths tell more.
        phase = phase_from_far(motion, square, rest) if rest > (2.0**-52) ** 12 else phase_at(a, b, left, here)
        behind, arc = way_back(rod, swing.heading, motion, phase, left, position and back)
        if left < here:
            anchor, turned = rod.clamp_angle, motion.left - 2 * behind
    if position and not back:
        arc = arc_to(rod.beta, rod.eta, swing.heading, motion, point, square, rest, here)
    return anchor, turned, speed, arc


def on_swing(rod, swing, station, position):
    """θ in two parts, dθ/dσ and the arc from the last turning point, or from the tip, at a point of a half-swing."""
    stay = swing.stay
    regular = swing.length - stay.tip - stay.middle - stay.far
    _, here, middle, far = parts(station.from_tip, stay.tip, regular, stay.middle)
    first, left, behind, _ = parts(station.from_far, stay.far, regular, stay.middle)
    if station.whole % 2 == 1:
        middle, far = behind, first
    anchor, turned, speed, arc = regular_part(rod, swing, station, here, left, position)
    for straight, extent in ((swing.middle_angle, middle), (swing.far_angle, far)):
        if extent > 0:
            turned_y, turned_z = cos(straight) - swing.heading.cosine, sin(straight) - swing.heading.sine
            arc = Arc((arc.y + extent * turned_y, arc.z + extent * turned_z, arc.square))
    return anchor, turned, speed, arc


def along_bent(equilibrium, s, position):
    """θ in two parts, of which only the sum is rounded at the size of θ, and θ′, y and z, of a rod that is bent."""
    rod, swing = equilibrium.rod, equilibrium.swing
    station = station_of(rod, swing, ldexp(s, rod.scale))
    sign = -1 if station.whole % 2 == 1 else 1
    anchor, turned, speed, arc = on_swing(rod, swing, station, position)
    # Along the tip's direction the rod is as long as it is; only what it departs by from that has been computed.
    y = s * swing.heading.cosine + ldexp(swing.total.y - station.whole * swing.arc.y - arc.y, -rod.scale)
    z = s * swing.heading.sine + ldexp(swing.total.z - station.whole * swing.arc.z - arc.z, -rod.scale)
    return rod.side * anchor, rod.side * turned, -rod.side * sign * ldexp(speed, rod.scale), y, rod.side * z


def angle_and_position(equilibrium, s, position=True):
    """θ, θ′, y and z at an arc length s from the clamp; y and z are worth nothing without ``position``."""
    if equilibrium.swing is not None:
        anchor, turned, curvature, y, z = along_bent(equilibrium, s, position)
        return anchor + turned, curvature, y, z
    rod = equilibrium.rod
    length = ldexp(rod.length, -rod.scale)
    share, left, bend = s / length, length - s, equilibrium.clamp_curvature
    angle = equilibrium.tip_angle - bend * left * (left / length) / 2
    return angle, bend * (left / length), equilibrium.y * share, equilibrium.z * share


def period_of(equilibrium):
    """The period of θ in the length, and what y + iz changes by over it; 0 where the rod is shorter."""
    rod, swing = equilibrium.rod, equilibrium.swing
    if rod.length <= 2 * swing.length:
        return 0.0, 0.0
    length, heading = swing.length, swing.heading
    y, z = swing.arc.y + length * heading.cosine, swing.arc.z + length * heading.sine
    return 2 * length, 2 * ldexp(1.0, -rod.scale) * complex(y, rod.side * z)


def middle_of(equilibrium):
    """A whole number about which the angles lie, or 0 where none is large.

    Large ones are measured from there, and it is added last: so their sums are rounded only once at their size.
    """
    rod, swing = equilibrium.rod, equilibrium.swing
    motion, turned = swing.stay.motion, 2 * pi * swing.turns
    low = motion.tip + turned
    high = low + 2 * motion.half_width
    return rod.side * float(floor((low + high) / 2 + 0.5)) if max(abs(low), abs(high)) > LARGE else 0.0


class State(Record):
    """What the series of a bin starts from: angle less ``middle_of`` the rod, its slope by the length, and y + iz."""

    __slots__ = ()

    angle: Any
    slope: Any
    place: Any


def state_of(equilibrium, length, position):
    """The state at a length from the clamp; beyond the tip θ is even and the arc odd about it."""
    rod = equilibrium.rod
    beyond = length > rod.length
    within = 2 * rod.length - length if beyond else length
    anchor, turned, slope, y, z = along_bent(equilibrium, ldexp(within, -rod.scale), position)
    angle = (anchor - middle_of(equilibrium)) + turned
    slope, place = ldexp(slope, -rod.scale), complex(y, z)
    if beyond:
        slope, place = -slope, 2 * complex(equilibrium.y, equilibrium.z) - place
    return State((angle, slope, place))


def straight_ranges(state_at, count, turns):
    """Ranges of bins at whose ends, and at turning points within, θ is the same to rounding: between them it is
    monotone, therefore constant."""
    ranges, todo = [], [(0, count)]
    while todo:
        low, high = todo.pop()
        angles = [state_at(bins).angle for bins in (low, *turns, high) if low <= bins <= high]
        if max(angles) - min(angles) <= 2.0**-53 * max(1.0, abs(angles[0])):
            ranges.append((low, high))
        elif high - low > COARSE:
            todo += [(low, (low + high) // 2), ((low + high) // 2, high)]
    return ranges


def turns_of(equilibrium, width):
    """The first turning points from the clamp on, in bins."""
    rod, swing = equilibrium.rod, equilibrium.swing
    first = rod.length - floor(rod.length / swing.length) * swing.length
    return [(first + number * swing.length) / width for number in range(3)]


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
    for low, high in straight_ranges(state_at, count, turns_of(equilibrium, width)) if count > SHORT else []:
        first, last, inside = state_at(low), state_at(high), slice(low, high)
        share = (middles[inside] - low) / (high - low)
        straight[inside], angle[inside] = True, (first.angle + last.angle) / 2
        place[inside] = first.place + share * (last.place - first.place)
    for bins in np.flatnonzero(~straight).tolist():
        angle[bins], slope[bins], place[bins] = state_at(bins + 0.5)
    return State((angle, slope, place)), straight


def series(rod, middle, state, degree):
    """The coefficients of θ and of y + iz about states: θ″ = β sin θ + (η/2) sin 2(θ − α), and y′ + iz′ = e^{iθ}."""
    shape = (degree + 1, len(state.angle))
    angle, turned = np.zeros(shape), np.zeros(shape)
    once, twice, place = (np.zeros(shape, dtype=complex) for _ in range(3))
    angle[0], angle[1], turned[1] = state.angle, state.slope, state.slope
    once[0] = np.exp(1j * state.angle) * np.exp(1j * middle)
    twice[0] = np.exp(2j * state.angle) * np.exp(2j * (middle - rod.side * (0.5 * pi)))
    place[0] = state.place
    for n in range(degree):
        if n:
            # d/ds e^{iθ} = iθ′e^{iθ}, by powers.
            once[n] = 1j / n * (turned[1 : n + 1] * once[n - 1 :: -1]).sum(axis=0)
            twice[n] = 2j / n * (turned[1 : n + 1] * twice[n - 1 :: -1]).sum(axis=0)
        if n + 2 <= degree:
            turned[n + 2] = (rod.beta * once[n].imag + rod.eta / 2 * twice[n].imag) / (n + 1)
            angle[n + 2] = turned[n + 2] / (n + 2)
        place[n + 1] = ldexp(1.0, -rod.scale) * once[n] / (n + 1)
    return angle, place


def negligible():
    """What a term may be, in radians or lengths, to be left out: an eighth of the spacing of numbers just below 1."""
    return 2.0**-56


def complete_series(rod, middle, state, half):
    """Series of which the last two terms are negligible up to half a bin from its middle; None if they are too long.

    What is left out decreases faster than by halves, so it is no more than these.
    """
    for degree in range(2 - int(56 / log2(half)), LONGEST + 1, 6):
        angle, place = series(rod, middle, state, degree)
        last = abs(np.concatenate((degree * angle[-2:], ldexp(1.0, rod.scale) * place[-2:]), axis=1)).max(axis=1)
        if max(last[0] * half ** (degree - 1), last[1] * half**degree / min(1.0, rod.length)) <= negligible():
            return angle, place
    return None


class Bins(Record):
    """Series of equal bins of which the first begins at the clamp.

    angle, place: coefficients, by power and bin, of the angle less ``middle_of`` the rod and of y + iz. straight: the
    bins in which θ is constant to rounding.
    """

    __slots__ = ()

    width: float
    straight: Any
    angle: Any
    place: Any


def bins_of(equilibrium, position):
    """The bins of a rod: over its length, or over a period where the rod is longer than that.

    Their places are worth nothing without ``position``.
    """
    reach = period_of(equilibrium)[0] or equilibrium.rod.length
    width, series, middle = min(0.5, ldexp(1.0, frexp(reach)[1])), None, middle_of(equilibrium)
    while series is None:
        count = int(reach / width) + 1
        state, straight = states(equilibrium, width, count, position)
        series = complete_series(equilibrium.rod, middle, state, width / 2)
        found = width
        width /= 2
    return Bins((found, straight, *series))


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
    The constant terms stay apart: they are large, and would be rounded with every sum.
    """
    of_powers, of_chebyshev = chebyshev(len(coefficients))
    parts = of_powers[1:].T @ coefficients[1:]
    tails = np.cumsum(abs(parts[::-1]), axis=0).max(axis=1)
    kept = max(2, len(parts) - int(np.searchsorted(tails, allowed, side="right")))
    short = of_chebyshev[:kept, :kept].T @ parts[:kept]
    short[0] += coefficients[0]
    return short


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
    slope = ldexp(cells / half, rod.scale) * np.arange(1, len(angle))[:, None] * angle[1:]
    parts = [angle, slope, *parts]
    length = ldexp(rod.length, -rod.scale)
    units = 1.0, ldexp(1.0, rod.scale), length, length
    return [shortened(part, quarter() * unit)[::-1].T.tolist() for part, unit in zip(parts, units, strict=False)]


class Run(Record):
    """Points first to last − 1, which lie in a cell, periods beyond the clamp's. middle: length from the clamp."""

    __slots__ = ()

    first: int
    last: int
    cell: int
    periods: int
    middle: float


def runs_of(equilibrium, bins, width, s):
    """The runs of points within a cell and a period."""
    rod, count = equilibrium.rod, round(len(bins.straight) * bins.width / width)
    period = period_of(equilibrium)[0]
    edges = np.arange(count + 1) * width
    if period:
        edges = np.minimum(edges, period)
    else:
        edges[-1] = np.inf
    runs = []
    for periods in range(int(rod.length / period) + 1 if period else 1):
        ends = np.searchsorted(s, np.ldexp(period * periods + edges, -rod.scale)).tolist()
        for cell in np.flatnonzero(np.diff(ends)).tolist():
            runs.append(Run((ends[cell], ends[cell + 1], cell, periods, period * periods + (cell + 0.5) * width)))
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
    advances, last = (0.0, 0.0, advance.real, advance.imag), middle_of(equilibrium)
    results = [np.empty(s.size) for _ in rows]
    spare = np.empty(RUN_BLOCK)
    for run in runs_of(equilibrium, bins, width, s):
        for first in range(run.first, run.last, RUN_BLOCK):
            block = slice(first, min(first + RUN_BLOCK, run.last))
            within = spare[: block.stop - first]
            np.multiply(s[block], ldexp(2 / width, rod.scale), out=within)
            within -= run.middle * (2 / width)
            for result, row, step in zip(results, rows, advances, strict=False):
                sum_run(row[run.cell], run.periods * step, within, result[block])
            if last:
                results[0][block] += last
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
        if np.max(rest.sum(axis=0)) > quarter() * ldexp(rod.length, -rod.scale):
            return None
        parts.append(part)
    return parts


class Table(Record):
    """Short power series in cells, for θ, y and z: four low coefficients by row, and the high ones.

    period: of θ in the length, or 0 where the cells cover the rod. advance: y + iz over a period.
    per_bin: first row and number of cells of each bin, where those differ; else None. slope: θ′ per change in a cell.
    last: what is added to the sums for θ.
    """

    __slots__ = ()

    cells: float
    per_bin: Any
    rows: tuple
    period: float
    advance: complex
    slope: float
    last: float


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
        (
            cells / bins.width if uniform else 1 / bins.width,
            None if uniform else np.stack((np.cumsum(counts) - counts, counts), axis=1).astype(float),
            tuple(halves(part * 2.0 ** np.arange(len(part))[:, None]) for part in parts),
            period,
            advance,
            ldexp(cells / bins.width, rod.scale),
            middle_of(equilibrium),
        )
    )


class Spare(Record):
    """Room for a block: place within its cell, whole cells, periods, gathered coefficients, rows."""

    __slots__ = ()

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
    """From lengths from the clamp to the rows, and to places in the cells, between −½ and ½.

    Exact, for cells are powers of two wide.
    """
    within *= table.cells
    np.floor(within, out=whole)
    within -= whole
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
    np.multiply(s, ldexp(1.0, rod.scale), out=within)
    if table.period:
        np.multiply(within, 1 / table.period, out=periods)
        np.floor(periods, out=periods)
        np.multiply(periods, table.period, out=whole)
        within -= whole
        np.maximum(within, 0, out=within)
    locate(table, within, whole, gathered, row)
    theta, curvature = results[:2]
    sum_gathered(table.rows[0], ANGLE_DEGREE, row, within, gathered, theta, curvature)
    curvature *= table.slope
    if table.last:
        theta += table.last
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
    spare = Spare((np.empty(LOOKUP_BLOCK), np.empty(LOOKUP_BLOCK), np.empty(LOOKUP_BLOCK), gathered, row))
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
    elif flat.size <= max(FEW, SHORTEST * (period_of(equilibrium)[0] or equilibrium.rod.length)):
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
    if hasattr(values, "mask"):
        raise TypeError(f"{name} must be a number or an array without a mask, got {in_a_line(values)}")
    kind = getattr(getattr(values, "dtype", None), "kind", "")
    if kind and kind in "fiu":
        numbers = np.asarray(values, dtype=float)
        finite = np.isfinite(numbers)
        if not np.all(finite):
            refuse(name, numbers, ~finite, "must be finite")
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


def all_within_turns(name, values):
    """Real numbers that tell angles, or an error that names argument and flat index of the first that does not."""
    numbers = all_real(name, values)
    for place in np.flatnonzero(np.abs(numbers) > 1 / sqrt(2.0 ** (-52)))[:1].tolist():
        within_turns(f"{name}[{place}]" if numbers.ndim else name, float(numbers.flat[place]))
    return numbers


def common_shape(given):
    """The shape to which all parameters broadcast; ValueError if there is none."""
    try:
        return np.broadcast_shapes(*(part.shape for part in given))
    except ValueError:
        shapes = ", ".join(f"{name} {part.shape}" for name, part in zip(given._fields, given, strict=True))
        raise ValueError(f"the arguments do not broadcast against one another: their shapes are {shapes}") from None


class Given(Record):
    """The parameters of many rods: numbers or arrays."""

    __slots__ = ()

    beta: Any
    eta: Any
    length: Any
    clamp_angle: Any


def slab(grid, which, values):
    """Some of a parameter's values, by a slice of their flat numbers in the grid; what is folded stays as it is."""
    return np.broadcast_to(values, grid).flat[which]


def element(case, values):
    """A parameter of one rod as a number; what is folded stays as it is."""
    return float(values[case])


def all_must_have_answers(beta, eta, length, grid, most):
    """ValueError for the first rod of a sweep that is refused."""
    number = prod(grid)
    for start in range(0, number, BLOCK):
        which = slice(start, min(start + BLOCK, number))
        force, magnet, extent = slab(grid, which, beta), slab(grid, which, eta), slab(grid, which, length)
        with np.errstate(over="ignore", under="ignore"):
            bad = too_large(force, magnet, extent) | too_many(force, magnet, extent, most)
        for case in np.flatnonzero(bad)[:1].tolist():
            must_have_answer(element(case, force), element(case, magnet), element(case, extent), most)


class Columns(Record):
    """Equilibria, flat: the number of the rod, and what ``Equilibrium`` says of its tip.

    rank, place: they put the tips of a rod in order, also those that are nearer than rounding.
    """

    __slots__ = ()

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
    return Columns((whole, whole, none, none, none, none, none, none, none, whole))


def each_array(record, change, done=None):
    """The record with ``change`` made to every array in it, once to each: directions stand in it more than once."""
    done = {} if done is None else done
    parts = []
    for part in record:
        if isinstance(part, (np.ndarray, tuple)):
            key = id(part)
            changed = done.get(key)
            if changed is None:
                done[key] = changed = change(part) if isinstance(part, np.ndarray) else each_array(part, change, done)
            part = changed
        parts.append(part)
    return tuple.__new__(type(record), parts)


def rows(record, which):
    """The record of some of the rods, by their numbers, a mask or a slice: the record itself for a mask of all."""
    if isinstance(which, slice):
        return each_array(record, lambda array: array[which])
    if which.dtype == bool:
        size, which = which.size, np.flatnonzero(which)
        if which.size == size:
            return record
    return each_array(record, lambda array: array.take(which))


class Rods(Record):
    """Rods in their own units of length: see ``equilibria.Rod``. case: their number in the block; slow: ℓ√(β + η)."""

    __slots__ = ()

    case: Any
    side: Any
    scale: Any
    beta: Any
    eta: Any
    length: Any
    clamp_angle: Any
    slow: Any


def is_shot(rods):
    """Which rods are short, and not nearly straight."""
    lean = rods.clamp_angle - 0.5 * pi
    couple = rods.beta * each_sin(rods.clamp_angle) + rods.eta / 2 * each_sin(2 * lean)
    # No angle within rounding of the clamp's may be a direction without couple.
    blur = BLURRED * 2.0**-52 * (np.abs(rods.clamp_angle) + 2) * (rods.beta + rods.eta)
    return (rods.slow < SHOT_SLOW) & (np.abs(couple) * rods.length * rods.length > STRAIGHT) & (np.abs(couple) > blur)


class Load(Record):
    """What acts on rods, in units of their length, and the clamp angle less half turns: exact beside one.

    facing: −1 after an odd number of half turns, else 1, and β of that sign. reach: how far the tip may be from the
    clamp.
    """

    __slots__ = ()

    facing: Any
    beta: Any
    eta: Any
    double_cosine: Any
    double_sine: Any
    clamp_angle: Any
    reach: Any


def load_of(rods):
    """The load of rods."""
    square = rods.length * rods.length
    twice = pi + np.zeros(rods.case.shape)
    reach = np.minimum((rods.beta + rods.eta / 2) * square / 2, 2 * pi) * (1 + 0.001)
    half_turns = np.floor(rods.clamp_angle / pi + 0.5)
    clamp, facing = each_less_quarters(rods.clamp_angle, 2 * half_turns), 1 - 2 * (half_turns % 2)
    return Load(
        (facing, facing * rods.beta * square, rods.eta * square, each_cos(twice), each_sin(twice), clamp, reach)
    )


def sag_of(rods):
    """By how much |∂²θ(0)/∂θ(ℓ)²| may bend what is missed over a span of 1, for tips measured in radians."""
    half = np.sinh(rods.slow / 2)
    return shot_bend_each(rods.beta, rods.eta, 2 * half * half) / 2


def eighth_of(quartic):
    """What the duplication formula has beside the coefficients, b₈ of Weierstrass curves."""
    return (quartic.q * quartic.last - quartic.linear * quartic.linear / 4) / 4


def ahead_near_tip(quartic, square, rough):
    """℘(z) − c by z²: the series, to the rounding of single precision or of double precision."""
    c = quartic.q / 12
    g2 = quartic.q * c - quartic.linear
    g3 = (quartic.linear - quartic.q * quartic.q / 18) * c - quartic.last
    a, b = g2 * (square * square / 20), g3 * (square * square * square / 28)
    series = a + b + a * a / 3 + a * b * (3 / 11)
    if not rough:
        series = series + (2 * a * a * a / 3 + b * b) / 13
    return (1 + (series - c * square)) / square


def ahead_doubled(quartic, eighth, value):
    """℘(2z) − c by ℘(z) − c: Weierstrass curves are doubled so, with b₂ = q, 2b₄ = ``linear``, b₆ = ``last``."""
    squared = value * value
    above = squared * (squared - quartic.linear / 2) - (2 * quartic.last * value + eighth)
    return above / ((4 * value + quartic.q) * squared + (quartic.linear * value + quartic.last))


def ahead_at_clamp(quartic):
    """℘(1) − c: the series at 1/4, or 1/16 in double precision, and the duplication formula."""
    rough = quartic.q.dtype == np.float32
    square, doublings = (1 / 16, 2) if rough else (1 / 256, 4)
    eighth = eighth_of(quartic)
    value = ahead_near_tip(quartic, square, rough)
    for _ in range(doublings):
        value = ahead_doubled(quartic, eighth, value)
    return value


def missed_by(quartic, offset):
    """The angle after the rod's length less the clamp angle."""
    return offset + 2 * np.arctan2(quartic.b, ahead_at_clamp(quartic))


class Quartic(Record):
    """What a motion depends on, by its tip: b = p/4, and 4w³ + qw² + ``linear``·w + ``last``, the square of ℘′ by
    w = ℘ − c (`theory/oblique_quartic`). Beside a hill ℘ − c is small, and so would be what a difference leaves of it.
    """

    __slots__ = ()

    b: Any
    q: Any
    linear: Any
    last: Any


class Aim(Record):
    """A tip: the quartic, and cosine and sine of θ(ℓ), as the load faces, and of 2(θ(ℓ) − α)."""

    __slots__ = ()

    quartic: Quartic
    heading: Any


def aim_at(load, offset):
    """The tip at an offset from the clamp angle."""
    tip = load.clamp_angle + offset
    sine, cosine = each_sin(tip), each_cos(tip)
    twice_sine, twice_cosine = 2 * sine * cosine, 1 - 2 * sine * sine
    double_sine = twice_sine * load.double_cosine - twice_cosine * load.double_sine
    double_cosine = twice_cosine * load.double_cosine + twice_sine * load.double_sine
    along, across, half = load.beta * cosine, load.beta * sine, 0.5 * load.eta * double_sine
    p, m, q = across + half, across - half, along + load.eta * double_cosine
    b = p / 4
    return Aim((Quartic((b, q, m * b, along * b * b)), (cosine, sine, double_cosine, double_sine)))


def miss(load, share):
    """The same for tips at a share of their reach from the clamp angle."""
    offset = load.reach * share
    return missed_by(aim_at(load, offset).quartic, offset)


def joined(records):
    """Records of arrays, one after another; what all rods share is taken from the first."""
    first = records[0]
    if len(records) == 1:
        return first
    if isinstance(first, np.ndarray):
        return np.concatenate(records)
    if isinstance(first, tuple):
        parts = [joined(list(column)) for column in zip(*records, strict=True)]
        return type(first)(parts) if hasattr(first, "_fields") else tuple(parts)
    return first


def halved(load, spans):
    """The halves of spans."""
    width, some = spans.width / 2, rows(load, spans.rod)
    middle = spans.first + width
    value = miss(some, middle.astype(some.reach.dtype)).astype(float)
    first = spans._replace(width=width, after=value)
    return joined([first, spans._replace(first=middle, width=width, before=value)])


def parted(load, sag, blur, spans, times):
    """The spans that hold one tip, of these and of those that come of the others by halving, and what is left of them.

    blur: by how much what is missed may be wrong. Over a span it departs from its chord by no more than sag·width²/4.
    Where it has one sign at both ends, and the sum of their roots is more than the width times √sag, it has no zero
    between; where the sum of what is missed is more than sag·width², it has one if the signs differ, and else none.
    """
    found = []
    for turn in range(times + 1):
        before, after = (np.maximum(np.abs(end) - blur[spans.rod], 0) for end in (spans.before, spans.after))
        crossed = (spans.before > 0) != (spans.after > 0)
        width = spans.width * load.reach[spans.rod]
        sum_, both = before + after, before * after
        sure = (sum_ + np.where(crossed, 0, 2 * np.sqrt(both)) > sag[spans.rod] * width * width) & (both > 0)
        found.append(rows(spans, sure & crossed))
        spans = rows(spans, ~sure)
        if turn == times or not spans.rod.size:
            break
        spans = halved(load, spans)
    return joined(found), spans


def told_apart(load, sag, blur, rough, spans):
    """The spans with one tip each, and the rods of which a span as small as any leaves a doubt."""
    first, spans = parted(rough, sag, blur, spans, ROUGH_HALVINGS)
    some = rows(load, spans.rod)
    before, after = miss(some, spans.first), miss(some, spans.first + spans.width)
    spans = spans._replace(before=before, after=after)
    second, spans = parted(load, sag, np.full(sag.size, BLUR), spans, SPAN_HALVINGS)
    return joined([first, second]), spans.rod


def rounded_to(record, kind):
    """The record with its arrays in another precision; numbers that all rods share take that of what they meet."""
    return each_array(record, lambda array: array.astype(kind, copy=False))


class Spans(Record):
    """Of tips: the rod, the share of its reach at one end, that to the other end, what is missed at both."""

    __slots__ = ()

    rod: Any
    first: Any
    width: Any
    before: Any
    after: Any


def no_spans():
    """None."""
    none = np.zeros(0)
    return Spans((np.zeros(0, dtype=int), none, none, none, none))


def sampled_spans(load, sag, blur, slow):
    """The load in single precision, and the spans between samples over which what is missed changes its sign, or may
    have zeros without."""
    rough, parts = rounded_to(load, np.float32), [no_spans()]
    steps = 2 / EVEN * load.reach * np.cosh(slow)
    order = np.argsort(steps)
    for start in range(0, slow.size, SHOTS):
        here = order[start : start + SHOTS]
        number = FEWEST_SPANS + int(steps[here[-1]])
        shares = np.linspace(-1, 1, number + 1)
        values = miss(rows(rough, here), shares.astype(np.float32)[:, None])
        above, size = values > 0, np.abs(values)
        size[size <= blur[here].astype(np.float32)] = -np.inf
        step = 2 / number * load.reach[here]
        needed = (sag[here] * step * step + 2 * blur[here]).astype(np.float32)
        # What is not a number is not sure either.
        held = (above[1:] != above[:-1]) | ~(size[1:] + size[:-1] > needed)
        row, which = divmod(np.flatnonzero(held), held.shape[1])
        before, after = (values[row + k, which].astype(float) for k in (0, 1))
        parts.append(Spans((here[which], shares[row], np.full(row.size, 2 / number), before, after)))
    return rough, joined(parts)


def inverse_quadratic(a, b, c, value_a, value_b, value_c):
    """Where on the way from a to b inverse quadratic interpolation puts the zero, half way where it is unsafe; is it
    safe."""
    x, y = (a - b) / (c - b), (value_a - value_b) / (value_c - value_b)
    share = value_a / (value_b - value_a) * value_c / (value_b - value_c)
    share = share + (c - a) / (b - a) * value_a / (value_c - value_a) * value_b / (value_c - value_b)
    safe = (y * y < x) & ((1 - y) * (1 - y) < 1 - x) & (share > 0) & (share < 1)
    return np.where(safe, share, a.dtype.type(0.5)), safe


def nearer(function, some, steps, spread):
    """``approached`` after some steps, of a record and ends: places, slopes, the last move, and the new ends."""
    given, a, b, value_a, value_b = some
    slope = (value_a - value_b) / (a - b)
    fraction = np.full(a.shape, 0.5, dtype=a.dtype)
    secant = value_a / (value_a - value_b)
    inside = (secant > 0.05) & (secant < 0.95)
    fraction[inside] = secant[inside]
    for _ in range(steps):
        trial = a + fraction * (b - a)
        value = function(given, trial)
        same = (value > 0) == (value_a > 0)
        c, value_c = np.where(same, a, b), np.where(same, value_a, value_b)
        b, value_b = np.where(same, b, a), np.where(same, value_b, value_a)
        a, value_a = trial, value
        near, value_near = (
            np.where(np.abs(a - b) < np.abs(a - c), b, c),
            np.where(np.abs(a - b) < np.abs(a - c), value_b, value_c),
        )
        slope = np.where(np.abs(near - a) > spread, (value_near - value_a) / (near - a), slope)
        fraction, safe = inverse_quadratic(a, b, c, value_a, value_b, value_c)
    # No half way at last: the latest place may be the zero itself.
    step = np.minimum(np.maximum(value_a / (slope * (a - b)), 0), 1)
    move = np.where(safe, fraction, np.where(value_a == 0, 0, step)) * (b - a)
    return a + move, slope, move, (a, b, value_a, value_b)


def approached(function, given, left, right, value_left, value_right, steps, spread, again=0):
    """Approximate zeros by Chandrupatla's method (1997): places, and the slopes there.

    function(given, places): the values, of the rows of a record. spread: the distance of two places from which they
    tell a slope. again: how often those that still move go through as many steps alone.
    """
    parts = []
    for start in range(0, max(left.size, 1), AT_ONCE):
        some = rows((given, left, right, value_left, value_right), slice(start, start + AT_ONCE))
        parts.append(nearer(function, some, steps, spread))
    place, slope, move, (left, right, value_left, value_right) = joined(parts)
    far = np.flatnonzero(np.abs(move) > MOVING) if again else np.zeros(0, dtype=int)
    if far.size:
        given, left, right, value_left, value_right = rows((given, left, right, value_left, value_right), far)
        again -= 1
        place[far], slope[far] = approached(function, given, left, right, value_left, value_right, steps, spread, again)
    return place, slope


def settled_shares(load, share, slope):
    """The zeros of what is missed, all but to rounding, by secants from nearly there; the slopes; and the numbers of
    those not found so."""
    todo, before, value_before = np.arange(share.size), share, np.full(share.shape, np.inf)
    for _ in range(SETTLINGS):
        here = rows(load, todo) if todo.size < share.size else load
        at = share[todo]
        value, change = miss(here, at), at - before
        told = np.abs(change) > SECANT_SPREAD
        steep = np.where(told, (value - value_before) / np.where(told, change, 1), slope[todo])
        slope[todo], share[todo] = steep, at - value / steep
        left = np.flatnonzero(~(np.abs(value) <= SETTLED * here.reach))
        todo, before, value_before = todo[left], at[left], value[left]
        if not left.size:
            break
    return share, slope, todo


class Shots(Record):
    """Tips of short rods.

    rod: the number among those given; offset: tip less clamp angle; slope: ∂θ(0)/∂θ(ℓ), nearly; rising: whether that
    is positive.
    """

    __slots__ = ()

    rod: Any
    offset: Any
    slope: Any
    rising: Any


def shots_of(rods):
    """All tips of short rods, and the numbers among these of the rods of which they are not sure: they have none."""
    load, sag, blur = load_of(rods), sag_of(rods), ROUGH_BLUR * np.where(rods.slow < ROUGH_SHOT, 1.0, WIDER)
    spans, unsure = told_apart(load, sag, blur, *sampled_spans(load, sag, blur, rods.slow))
    if unsure.size:
        spans = rows(spans, ~np.isin(spans.rod, unsure))
    which, ends = spans.rod, (spans.first, spans.first + spans.width, spans.before, spans.after)
    some = rows(load, which)
    share, slope = approached(miss, some, *ends, AIMS, AIM_SPREAD, AGAIN)
    share, slope, lost = settled_shares(some, share, slope)
    found = Shots((which, share * some.reach, slope / some.reach, spans.after > 0))
    # A secant may lead to the tip of another span.
    lost = np.concatenate([lost, np.flatnonzero(~((share > ends[0]) & (share < ends[1])))])
    if lost.size:
        unsure = np.concatenate([unsure, which[lost]])
        found = rows(found, ~np.isin(which, unsure))
    return found, np.unique(unsure)


def corrected(load, shots):
    """The offsets and tips, nearer than numbers are to each other.

    At the clamp rounding of the tip angle shows up to cosh(ℓ√(β + η)) times. A last step of Newton's is therefore made
    in p, by q = dp/dθ(ℓ): that is far more exact next to a hill, where it matters. All else may be off by a rounding.
    """
    tip = aim_at(load, shots.offset)
    b, q, linear, last = tip.quartic
    step = -missed_by(tip.quartic, shots.offset) / shots.slope
    ratio = 1 + q * step / (4 * b)
    return shots.offset + step, tip._replace(quartic=Quartic((b * ratio, q, linear * ratio, last * ratio * ratio)))


def points_for(slow):
    """How many points a rod needs, even numbers only."""
    return 2 * ceil((POINTS_PER * slow + POINTS_MORE) / 2)


@cache
def half_of_gauss(number):
    """The positive ones of twice as many points of Gauss and Legendre on [−1, 1], from the least up, and weights that
    add up to 1: Newton's method from Tricomi's approximations."""
    degree = 2 * number
    angle = (np.arange(number, 0, -1) - 0.25) / (degree + 0.5) * pi
    place = (1 - (degree - 1) / (8 * degree**3)) * np.cos(angle)
    for _ in range(REFINED):
        before, value = 1.0, place
        for k in range(2, degree + 1):
            before, value = value, ((2 * k - 1) * place * value - (k - 1) * before) / k
        slope = degree * (before - place * value) / (1 - place * place)
        place = place - value / slope
    weight = 1 / ((1 - place * place) * slope * slope)
    return place, weight / weight.sum()


def ahead_along(quartic, place, slow):
    """℘ − c at places in (0, 1], a row for each, which go up. slow: the greatest ℓ√(β + η)."""
    doublings = np.maximum(np.ceil(np.log2(place * (slow / SERIES_END))), 0).astype(int)
    start, eighth = place * 0.5**doublings, eighth_of(quartic)
    value = ahead_near_tip(quartic, (start * start)[:, None], False)
    for k in range(doublings[-1]):
        first = int(np.searchsorted(doublings, k, side="right"))
        value[first:] = ahead_doubled(quartic, eighth, value[first:])
    return value


class Bent(Record):
    """Integrals along a rod of length 1, δ = θ − θ(ℓ): of cos δ − 1, sin δ, cos 2δ − 1 and sin 2δ."""

    __slots__ = ()

    cosine: Any
    sine: Any
    double_cosine: Any
    double_sine: Any


def integrals(quartic, slow):
    """The integrals along rods of which ``slow`` is the greatest ℓ√(β + η)."""
    place, weight = half_of_gauss(points_for(slow))
    b, ahead = quartic.b, ahead_along(quartic, place, slow)
    share = 1 / (ahead * ahead + b * b)
    across = ahead * share
    # sin δ = 2b·across, 1 − cos δ = 2b²·share.
    first, second = weight @ across, weight @ share
    third, fourth = weight @ (across * across), weight @ (across * share)
    square = b * b
    return Bent((-2 * square * second, 2 * b * first, -8 * square * third, 4 * b * first - 8 * b * square * fourth))


def bent_along(quartic, slow):
    """The integrals along rods, by their quartics and ℓ√(β + η): those of like length together."""
    order, start, parts = np.argsort(slow), 0, []
    while start < slow.size:
        # As many points as the longest of these needs.
        size = max(VALUES // points_for(slow[order[start]]), 1)
        some = order[start : start + size]
        parts.append(integrals(rows(quartic, some), slow[some[-1]]))
        start += size
    back = np.empty(order.size, dtype=int)
    back[order] = np.arange(order.size)
    return rows(joined(parts), back)


def short_rods(rods, shots, most):
    """The equilibria of short rods, by their shots."""
    if not shots.rod.size:
        return no_columns()
    index = np.where(shots.rising, 0, 1)
    shots, index = rows((shots, index), index <= most)
    some = rows(rods, shots.rod)
    load = load_of(some)
    offset, tip = corrected(load, shots)
    bent = bent_along(tip.quartic, some.slow)
    beta, eta, length, unit = some.beta, some.eta, some.length, np.ldexp(1.0, some.scale)
    cosine, sine, double_cosine, double_sine = tip.heading
    cosine, sine = load.facing * cosine, load.facing * sine
    y, z = bent.cosine * cosine - bent.sine * sine, bent.cosine * sine + bent.sine * cosine
    gamma = 2 * beta * cosine + eta * (1 + double_cosine) / 2
    doubled = bent.double_cosine * double_cosine - bent.double_sine * double_sine
    turned = double_sine + bent.double_cosine * double_sine + bent.double_sine * double_cosine
    moment = beta * (sine + z) + eta / 2 * turned  # the mean of θ″ along the rod
    energy = -(gamma / 2 + 2 * beta * y + eta / 2 * doubled) * length
    return Columns(
        (
            some.case,
            0 * index,
            offset,
            some.clamp_angle + offset,
            -moment * length * unit,
            gamma * unit * unit,
            (cosine + y) * length / unit,
            (sine + z) * length / unit,
            energy * unit,
            index,
        )
    )


def short_and_others(rods, most):
    """The equilibria of short rods, and the rods of which they are not sure or that are none."""
    shot = is_shot(rods)
    some = rows(rods, shot)
    shots, unsure = shots_of(some)
    shot[np.flatnonzero(shot)[unsure]] = False
    return short_rods(some, shots, most), rows(rods, ~shot)


def numbered(rods, mask):
    """The numbers of some of the rods, and those, by a mask or by one truth value for all of them."""
    which = np.flatnonzero(np.full(rods.case.shape, mask))
    return which, rows(rods, which)


def chosen(rods, mask):
    """Some of the rods, by a mask, or by one truth value for all of them."""
    return numbered(rods, mask)[1]


def along_each(beta, quarters, sign):
    """A direction along or against the force, no field: what it is about the field is not asked."""
    return Rest((quarters, 0, quarters * (pi / 2), sign * beta, 1, 0))


def no_field_each(beta):
    """The force alone."""
    return Landscape(
        ((along_each(beta, 0, 1), along_each(beta, 2, -1), along_each(beta, 4, 1)), False, True, None, 0.0)
    )


def orthogonal_double_each(beta, eta):
    """The field across a weaker force: two hills of the same height beside 0."""
    lean = np.arctan2(np.sqrt((eta - beta) * (eta + beta)), beta)
    stiffness = (eta - beta) * (eta + beta) / eta
    cosine = 1 - 2 * (beta / eta) * (beta / eta)
    sine = -2 * (beta / eta) * np.sqrt((eta - beta) * (eta + beta)) / eta
    low = Rest((0, -lean, -lean, stiffness, cosine, -sine))
    high, again = Rest((0, lean, lean, stiffness, cosine, sine)), low._replace(quarters=4, angle=2 * pi - lean)
    top, bottom = Rest((0, 0, 0, beta - eta, -1, 0)), Rest((2, 0, pi, -beta - eta, -1, 0))
    return Landscape(((low, top, high, bottom, again), True, True, None, 0.0))


def orthogonal_single_each(beta, eta):
    """The field across a force that is not weaker: one hill, at 0."""
    top, again = (Rest((quarters, 0, quarters * (pi / 2), beta - eta, -1, 0)) for quarters in (0, 4))
    return Landscape(((top, Rest((2, 0, pi, -beta - eta, -1, 0)), again), False, True, None, 0.0))


def by_landscape(rods):
    """The rods in groups with landscapes of one kind, and those."""
    beta, eta = rods.beta, rods.eta
    free, strong = eta == 0, eta > beta
    across = ~free
    if each_any_of(free):
        bare = chosen(rods, free)
        yield bare, no_field_each(bare.beta)
    if each_any_of(across & strong):
        double = chosen(rods, across & strong)
        yield double, orthogonal_double_each(double.beta, double.eta)
    if each_any_of(across & ~strong):
        single = chosen(rods, across & ~strong)
        yield single, orthogonal_single_each(single.beta, single.eta)


def offset_from_each(rest, angle, turns):
    """angle − (rest + turns·2π), without cancellation; 0 where no angle within rounding of this tells them apart."""
    offset = each_less_quarters(angle, 4 * turns + rest.quarters) - rest.extra
    blur = 2.0**-52 * (np.abs(angle) + np.abs(rest.extra))
    return each_pick((np.abs(offset) <= blur) | (np.abs(offset) < (2.0**-52) ** 9), 0, offset)


def turn_to_each(start, end):
    """The angle from one direction without moment to another, however near they are to each other."""
    return (end.quarters - start.quarters) * (pi / 2) + (end.extra - start.extra)


def clamp_in_each(rests, angle):
    """Whole turns such that the clamp lies from the first hill up to, but not at, its like a turn on."""
    turns = np.floor((angle - rests[0].angle) / (2 * pi))
    for _ in range(3):
        offsets = tuple(offset_from_each(rest, angle, turns) for rest in rests)
        shift = each_pick(offsets[0] < 0, -1, each_pick(offsets[-1] >= 0, 1, 0))
        if not each_any_of(shift != 0):
            break
        turns = turns + shift
    # One that counts as a direction without moment is as far from the others as that is.
    for there, met in zip(rests, offsets, strict=True):
        if each_any_of(met == 0):
            apart = zip(rests, offsets, strict=True)
            offsets = tuple(each_pick(met == 0, turn_to_each(rest, there), offset) for rest, offset in apart)
    return Clamp((turns, offsets))


class Straight(Record):
    """Rods whose clamp angle is a direction without moment."""

    __slots__ = ()

    rods: Rods
    rest: Any


def level_ground_each(eta, scene, at):
    """The ground without a ridge lower than the hill."""
    return Ground((eta, scene, at, 0, 0, 0, True, 0))


def ridge_fall_each(beta, eta, hill, ridge):
    """V(hill) − V(ridge): the sine of half their distance times the slope of V between, as if it were a circle."""
    half, middle = (ridge.extra - hill.extra) / 2, pi / 2 + (hill.extra + ridge.extra) / 2
    return each_cos(half) * (2 * beta * each_sin(middle) - eta * each_sin(half) * each_sin(2 * (middle - 0.5 * pi)))


def fall_from_rest_each(eta, stiffness, double_cosine, double_sine, middle, half):
    """V(middle − half) − V(middle + half), with both angles measured from a direction without moment."""
    return rest_fall_each(
        eta,
        stiffness,
        double_cosine,
        double_sine,
        each_sin(middle / 2),
        each_cos(middle / 2),
        each_sin(half / 2),
        each_cos(half / 2),
    )


def fall_each(eta, rest, start, change):
    """V(start) − V(start + change), from a start measured from a direction without moment."""
    half = change / 2
    return fall_from_rest_each(eta, rest.stiffness, rest.double_cosine, rest.double_sine, start + half, half)


def pick_rest_each(condition, yes, no):
    """One or the other direction, number by number."""
    return Rest(each_pick(condition, *pair) for pair in zip(yes, no, strict=True))


def step_to_each(eta, rest, offset, goal):
    """Newton's step to where the square root of the change of V from a direction without moment is ``goal``, and by
    how much its slope changes half way there, as a share of it."""
    small, large = each_sin(offset / 4), each_cos(offset / 4)
    sine, cosine = 2 * small * large, 1 - 2 * small * small
    level = rest_fall_each(eta, rest.stiffness, rest.double_cosine, rest.double_sine, small, large, small, large)
    force = np.abs(rest_moment_each(eta, rest.stiffness, rest.double_cosine, rest.double_sine, sine, cosine))
    here, force = np.sqrt(np.abs(level)), np.maximum(force, (2.0**-52) ** 20)
    whole_sine, whole_cosine = 2 * sine * cosine, 1 - 2 * sine * sine
    # dθ″/dθ, by β and α as the direction has them.
    turned = rest.double_cosine * (2 * whole_cosine * whole_cosine - 1 - whole_cosine)
    turned = turned - rest.double_sine * whole_sine * (2 * whole_cosine - 0.5)
    bend = (rest.stiffness * whole_cosine + eta * turned) * (here / force) * (here / force)
    share = (here - goal) / np.maximum(here, (2.0**-52) ** 20)
    return 2 * here * (here - goal) / force, share * (each_pick(level < 0, -bend, bend) - 0.5)


def reach_each(eta, rest, amount, most, side):
    """The distance from a hill (or a well) at which V is lower (or higher) by ``amount``, to one side.

    most: the distance of the next well (or hill). Halley's method for the square root of the difference, which is
    nearly linear, from the pendulum's value.
    """
    amount = np.maximum(amount, 0)  # of a hill and a well that nearly meet, rounding may give less
    share = amount / np.maximum(np.abs(fall_each(eta, rest, 0, side * most)), (2.0**-52) ** 20)
    near = most * np.arcsin(np.sqrt(each_pick(share < 1, share, 1))) * (2 / pi)
    goal = np.sqrt(amount)
    for _ in range(40):
        step, bent = step_to_each(eta, rest, side * near, goal)
        safe = np.abs(bent) < 0.5
        trial = near - step / each_pick(safe, 1 - bent, 1)
        trial = each_pick(trial > most, (near + most) / 2, each_pick(trial < 0, near / 2, trial))
        # The method cubes the error, and Newton's squares it: after steps this small the next would change nothing.
        small = each_pick(safe, each_spacing(trial) ** 0.45, each_spacing(trial) ** 0.6)
        moving, near = np.abs(trial - near) > small * near, trial
        if not each_any_of(moving):
            break
    return near


def ridge_at_each(eta, rests, drop):
    """The ridge that is lower by ``drop`` than the hill."""
    down, above = turn_to_each(rests[0], rests[1]), fall_each(eta, rests[2], 0, turn_to_each(rests[2], rests[1]))
    # Of a ridge that is next to its wells V tells at the hill nothing.
    by_hill = drop < above
    rest, amount = pick_rest_each(by_hill, rests[0], rests[1]), each_pick(by_hill, drop, above)
    distance = reach_each(eta, rest, amount, down, each_pick(by_hill, 1, -1))
    level, depth = each_pick(by_hill, distance, down - distance), each_pick(by_hill, down - distance, distance)
    return Ridge((drop, level, depth, by_hill))


def ridge_ground_each(eta, scene, at, ridge):
    """The ground with a lower ridge."""
    rests = scene.rests
    # Near the far hill V says which is higher only by the distance from that hill.
    height = each_pick(
        at[2] < -at[4], fall_each(eta, rests[2], 0, at[2]), fall_each(eta, rests[4], 0, at[4]) - ridge.drop
    )
    return Ground((eta, scene, at, ridge.drop, ridge.level, ridge.depth, ridge.by_hill, height))


def ground_of_kind(rods, scene, clamp):
    """The ground of rods with one kind of landscape, and where a ridge is too near the hill's level to be told."""
    rests = scene.rests
    if len(rests) == 3 or scene.level:
        return level_ground_each(rods.eta, scene, clamp.offsets), np.zeros(rods.case.shape, dtype=bool)
    drop = ridge_fall_each(rods.beta, rods.eta, rests[0], rests[2])
    low = drop <= (2.0**-52) ** 17 * (rods.beta + rods.eta)
    ridge = ridge_at_each(rods.eta, rests, drop)
    return ridge_ground_each(rods.eta, scene, clamp.offsets, ridge), low


def in_basin_each(at, first, inside, builders):
    """The range of a clamp inside a basin: one before the well and at it, another beyond."""
    return [(inside & (at[first + 1] <= 0), builders[0]), (inside & (at[first + 1] > 0), builders[1])]


def piece_of_each(basin, low_kind, high_kind, low_offset, width, high_depth, clamp_gap, level_gap, at):
    """The record of a range."""
    rests = (basin.hill, basin.well, basin.axis, basin.far_well, basin.far) if basin.passes else basin[:3]
    rest, offset = rests[0], at[0]
    for other, distance in zip(rests[1:], at[1:], strict=False):
        closer = np.abs(distance) < np.abs(offset)
        if each_any_of(closer):
            rest, offset = pick_rest_each(closer, other, rest), each_pick(closer, distance, offset)
    beyond, last = at[len(rests) - 2 : len(rests)]
    ends = low_kind, high_kind, low_offset, width, high_depth, clamp_gap, level_gap
    return Piece((basin, *ends, rest, offset, -last, beyond, at[0], at[1]))


def from_hill_to_clamp_each(basin, at):
    """From a hill to a clamp before the well."""
    return piece_of_each(basin, "hill", "clamp", 0, at[0], -at[1], 0, 0, at)


def basin_of_each(ground, first):
    """The basin between two neighbouring hills."""
    scene = ground.scene
    hill, well, far = scene.rests[first : first + 3]
    whole = len(scene.rests) == 3
    even = scene.even and (scene.level or whole)
    rise, beside = ground.drop if first else 0, (scene.shoulder, scene.moment, 0.0)
    return Basin((hill, well, far, well, well, rise, False, even, whole, *beside))


def first_clamp_each(ground):
    """From the first hill to the clamp."""
    return from_hill_to_clamp_each(basin_of_each(ground, 0), ground.at[:3])


def from_hill_to_turn_each(eta, basin, at):
    """From a hill to where the rod turns back at a clamp beyond the well."""
    down, depth = turn_to_each(basin.hill, basin.well), at[1]
    width = -at[2]
    if not basin.even:
        above = -fall_each(eta, basin.well, 0, at[1])
        below = fall_each(eta, basin.far, 0, at[2]) - basin.far_rise
        from_top = reach_each(eta, basin.hill, np.maximum(below, 0), down, 1)
        from_well = reach_each(eta, basin.well, above, down, -1)
        depth = each_pick(below < above, down - from_top, from_well)
        width = each_pick(below < above, from_top, down - from_well)
    return piece_of_each(basin, "hill", "turn", 0, width, depth, depth + at[1], 0, at)


def first_turn_each(ground):
    """From the first hill to where the rod turns back at the clamp."""
    return from_hill_to_turn_each(ground.eta, basin_of_each(ground, 0), ground.at[:3])


def last_clamp_each(ground):
    """From the second hill to the clamp."""
    return from_hill_to_clamp_each(basin_of_each(ground, 2), ground.at[2:])


def last_turn_each(ground):
    """From the second hill to where the rod turns back at the clamp."""
    return from_hill_to_turn_each(ground.eta, basin_of_each(ground, 2), ground.at[2:])


def over_ridge_each(ground):
    """What stops a motion that passes the ridge."""
    hill, well, ridge, second, far = ground.scene.rests
    return Basin((hill, well, far, second, ridge, 0, True, ground.scene.even, True, None, 0.0, 0.0))


def pass_clamp_each(ground):
    """From the highest hill to a clamp above the level of the ridge."""
    at = ground.at
    return piece_of_each(over_ridge_each(ground), "hill", "clamp", 0, at[0], -at[1], 0, ground.level - at[0], at)


def pass_level_each(ground):
    """From the highest hill to the level of the ridge."""
    level, depth, at = ground.level, ground.depth, ground.at
    gap = each_pick(ground.by_hill, at[0] - level, at[1] + depth)
    return piece_of_each(over_ridge_each(ground), "hill", "level", 0, level, depth, gap, 0, at)


def moment_from_rest_each(eta, stiffness, double_cosine, double_sine, offset):
    """θ″ = −V′ at an offset from a direction without moment."""
    return rest_moment_each(eta, stiffness, double_cosine, double_sine, each_sin(offset / 2), each_cos(offset / 2))


def slope_each(eta, rest, offset):
    """θ″ at an offset from a direction without moment."""
    return moment_from_rest_each(eta, rest.stiffness, rest.double_cosine, rest.double_sine, offset)


def onward_each(eta, rest, start, amount, rough, wanted, moment=0):
    """How far beyond ``start``, an offset from a direction of that moment, V has fallen by ``amount``.

    The rough value is good to rounding of the angles; where little of it is left, the slope of V at the start gives a
    better one. Newton's method does the rest, until all that are wanted are found.
    """
    steep = slope_each(eta, rest, start) + moment * each_cos(start)
    told = (np.abs(rough) > 0.001 * np.abs(start)) | (steep == 0)
    distance = each_pick(told, rough, amount / each_pick(told, 1, steep))
    for _ in range(40):
        force = slope_each(eta, rest, start + distance) + moment * each_cos(start + distance)
        fallen = (
            fall_each(eta, rest, start, distance)
            + 2 * moment * each_cos(start + distance / 2) * each_sin(distance / 2)
        )
        step = (fallen - amount) / each_pick(force == 0, 1, force)
        away = np.abs(distance - step) > pi
        stuck = away & (distance == rough)
        distance = each_pick(away, rough, distance - step)
        if not each_any_of(wanted & (stuck == 0) & (np.abs(step) > each_spacing(distance) ** 0.6 * np.abs(distance))):
            break
    return distance


def pass_turn_each(ground):
    """From the highest hill to where the rod turns back at a clamp above the level of the ridge, beyond it."""
    eta, over, level, at = ground.eta, over_ridge_each(ground), ground.level, ground.at
    down, below = turn_to_each(over.hill, over.well), fall_each(eta, over.far, 0, at[4])
    # V of the clamp above the first well: above the ridge, and the ridge above the well.
    above = fall_each(eta, over.axis, 0, turn_to_each(over.axis, over.well)) - ground.height
    by_hill = below < above
    rest, amount = pick_rest_each(by_hill, over.hill, over.well), each_pick(by_hill, below, above)
    distance = reach_each(eta, rest, amount, down, each_pick(by_hill, 1, -1))
    width, depth = each_pick(by_hill, distance, down - distance), each_pick(by_hill, down - distance, distance)
    if over.even:
        width = -at[4]
    # Towards the hill V is flat and tells little, but there the angles tell all.
    near, apart = width >= level / 2, each_pick(by_hill, level - width, depth - ground.depth)
    start = each_pick(ground.by_hill, level, -ground.depth)
    rest = pick_rest_each(ground.by_hill, over.hill, over.well)
    gap = each_pick(near, -onward_each(eta, rest, start, ground.height, -apart, near), apart)
    return piece_of_each(
        over, "hill", "turn", 0, width, depth, each_pick(by_hill, at[0] - width, at[1] + depth), gap, at
    )


def level_clamp_each(ground):
    """From the level of the ridge to the clamp."""
    level, at = ground.level, ground.at
    return piece_of_each(basin_of_each(ground, 0), "level", "clamp", level, at[0] - level, -at[1], 0, 0, at)


def level_turn_each(ground):
    """From the level of the ridge to where the rod turns back at the clamp, before the ridge."""
    eta, basin, level, at = ground.eta, basin_of_each(ground, 0), ground.level, ground.at
    down = turn_to_each(basin.hill, basin.well)
    above, below = -fall_each(eta, basin.well, 0, at[1]), fall_each(eta, basin.far, 0, at[2])
    from_well = reach_each(eta, basin.well, above, down, -1)
    # Towards the well V is flat and tells little, but there the angles tell all; towards the hill only V does.
    from_hill = reach_each(eta, basin.hill, ground.drop + below, down, 1)
    near = onward_each(eta, basin.hill, level, below, from_hill - level, True)
    by_level = below < above / 4
    width, depth = (
        each_pick(by_level, near, ground.depth - from_well),
        each_pick(by_level, ground.depth - near, from_well),
    )
    return piece_of_each(basin, "level", "turn", level, width, depth, depth + at[1], 0, at)


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


class Group(Record):
    """Ranges of one kind, one a rod. turns: whole turns of the clamp; rank: among the rod's ranges, from low to high.

    dip: the place around which a ridge that is not quite there slows the motion down, or None for all of them.
    """

    __slots__ = ()

    rods: Rods
    turns: Any
    rank: Any
    piece: Any
    dip: Any


def has_no_shoulder(piece):
    """Whether V has two hills a turn, or is symmetric."""
    basin = piece.basin
    return basin.even or basin.passes or piece.low_kind == "level" or not basin.whole


def astroid_cusp_each(field_angle):
    """Where the second pair is born: tan³x = tan α (Stoner and Wohlfarth's astroid).

    The pair lies at α + π + x with sin α/sin x + cos α/cos x = η/β: it is there when η/β is beyond the least value of
    the left side, taken at this x.
    """
    return np.arctan((each_sin(field_angle) / np.maximum(each_cos(field_angle), 2.0**-52)) ** (1 / 3))


def twist_each(eta, x):
    """The couple of the field on a rod turned by x from it."""
    return eta * each_sin(x) * each_cos(x)


def ridge_couple_each(beta, eta, field_angle, x):
    """The couple on a rod that points along α + π + x."""
    return twist_each(eta, x) - beta * each_sin(field_angle + x)


def missing_ridge(rods):
    """How far η is below the value at which a ridge would appear, over β + η, and where it would."""
    beta, eta, angle = rods.beta, rods.eta, np.abs(0.5 * pi)
    side = astroid_cusp_each(angle)
    missing = -ridge_couple_each(beta, eta, angle, side) / (beta + eta)
    return missing, angle + pi + side


def nearly_ridge(rods, piece):
    """How far η is below the value at which a ridge would appear, and the place at which the motion would meet it:
    see ``places.places``. No number where that is not on the range."""
    if has_no_shoulder(piece):
        return np.full(rods.case.shape, np.inf), rods.slow
    eta, basin = rods.eta, piece.basin
    missing, cusp = missing_ridge(rods)
    down = turn_to_each(basin.hill, basin.well)
    rise = reach_each(eta, basin.hill, fall_each(eta, basin.hill, 0, cusp - basin.hill.angle), down, 1)
    inside = (rise > 0) & (rise < piece.width)
    return np.where(inside, missing, np.inf), np.log(rise / (piece.width - rise))


def by_dips(group, wanted):
    """The ranges that are wanted, without and with a dip, and the cases left to the scalar solver, for their dip is
    too sharp."""
    missing, dip = nearly_ridge(group.rods, group.piece)
    plain, wide = wanted & (missing > NEARLY), wanted & (missing <= NEARLY) & (missing >= SHARP)
    parts = [rows(group, plain)] if plain.any() else []
    if wide.any():
        parts.append(rows(group._replace(dip=dip), wide))
    return parts, group.rods.case[wanted & ~plain & ~wide]


def least_arrival_each(beta, eta, piece, offset, left):
    """A length before which no motion from an offset from the hill, or from a lower one, arrives.

    θ″ is nowhere more than β + η/2, and at an offset from the hill no more than β + η times that, or than its stiffness
    times that where the field is along it: a motion that has the lesser of these two gets ahead of it. left: from
    there to the clamp.
    """
    hill = piece.basin.hill
    # β + η cos u and η cos u − β by sin u: both are largest at u = 0.
    steep, most = each_pick(hill.double_cosine == 1, hill.stiffness, beta + eta), beta + eta / 2
    clamp = piece.low_offset + piece.width + piece.clamp_gap
    rest = np.minimum(left, np.maximum(clamp - np.minimum(clamp, most / steep), 0))
    # Up to the offset from which on the other bound is the lesser: by the share that is left of the way there.
    share = (left - rest) / np.maximum(offset, TINIEST)
    away, steepness = np.sqrt(share) * np.sqrt(2 + share), np.sqrt(steep)
    growth = share + away
    # Neither is more than ln(1 + x).
    logarithm = each_pick(growth < 0.001, 2 * growth / (2 + growth), np.log(1 + growth))
    speed = steepness * away * offset
    return logarithm / steepness + 2 * rest / (speed + np.sqrt(speed * speed + 2 * most * rest) + TINIEST)


def in_time(rods, piece):
    """Which ranges have a motion that may arrive in time."""
    first = least_arrival_each(rods.beta, rods.eta, piece, piece.low_offset + piece.width, piece.clamp_gap)
    return first <= (1 + SURELY) * rods.length


def groups(rods):
    """The ranges of tips below the clamp angle, the straight rods, and the cases that are left to the scalar solver."""
    found, straight, doubtful = [], [], [np.zeros(0, dtype=int)]
    for some, scene in by_landscape(rods):
        clamp = clamp_in_each(scene.rests, some.clamp_angle)
        for rest, offset in zip(scene.rests, clamp.offsets, strict=True):
            flat = np.flatnonzero((offset == 0) & (some.side > 0))
            if flat.size:
                straight.append(Straight((rows(some, flat), rows(rest, flat))))
        ground, low = ground_of_kind(some, scene, clamp)
        doubtful.append(some.case[low])
        for rank, (here, build) in enumerate(ranges_each(ground)):
            which = np.flatnonzero(here & ~low)
            if which.size:
                given, piece = rows(some, which), build(rows(ground, which))
                group = Group((given, clamp.turns[which], np.full(which.shape, rank), piece, None))
                parts, sharp = by_dips(group, in_time(given, piece))
                found += parts
                doubtful.append(sharp)
    return found, straight, np.concatenate(doubtful)


def moved(group):
    """The group without what motions do not depend on."""
    rods = group.rods._replace(case=0, side=0, scale=0, clamp_angle=0)
    return group._replace(rods=rods, turns=0, rank=0)


def ends(rods, piece):
    """The places of the deepest samples: see ``places.grid``."""
    rounding = -np.log(2.0**-52)
    first = np.minimum(-2 * rods.slow - 6, -rounding) if piece.low_kind == "level" else -rods.slow - 6
    late = first
    for k in range(1, HALVINGS + 1):
        trial = late - first * 0.5**k
        offset = piece.low_offset + piece.width / (1 + np.exp(-trial))
        left = piece.clamp_gap + piece.width / (1 + np.exp(trial))
        least = least_arrival_each(rods.beta, rods.eta, piece, offset, left)
        late = np.where(least > (1 + SURELY) * rods.length, trial, late)
    if piece.high_kind == "level":
        last = 2 * rods.slow + rounding
    elif piece.high_kind == "turn":
        last = LATEST + 0 * rods.slow
    else:
        moment = np.abs(slope_each(rods.eta, piece.clamp_rest, piece.clamp_offset)) + SMALLEST
        deeper = 4 + np.log(2 * piece.width) - np.log(moment) - 2 * np.log(rods.length)
        last = np.where(piece.high_depth == 0, rounding, np.maximum(LATEST, deeper))
    return late, last


def spaced(deepest, step):
    """Places from 0 to the deepest one, as shares of it."""
    places, growth = [0.0], 1 + step / 3
    while places[-1] < deepest:
        places.append(places[-1] + step)
        step *= growth
    return np.array([*places[:-1], deepest]) / max(deepest, 1e-30)


def places_of(dip, first, last, step):
    """The places of samples, a column for each range: from the lowest up, and closer around dips."""
    below, above = spaced(-first.min(), step), spaced(last.max(), step)
    places = np.concatenate([first * below[:0:-1, None], last * above[:, None]])
    if dip is None:
        return places
    return np.sort(np.concatenate([places, np.clip(dip + AROUND[:, None], first, last)]), axis=0)


def tip_fall_each(eta, piece, change, rise, drop):
    """V(tip) − V(tip + change), for a tip that is told from the low and the high end of its range."""
    from_hill, depth = piece.low_offset + rise, piece.high_depth + drop
    upper = from_hill < depth
    return fall_each(
        eta, pick_rest_each(upper, piece.basin.hill, piece.basin.well), each_pick(upper, from_hill, -depth), change
    )


def reach_either_each(eta, hill, well, by_hill, amount, most):
    """``reach`` down from the hill, or up from the well, whichever is asked for."""
    rest = hill._replace(
        stiffness=each_pick(by_hill, hill.stiffness, well.stiffness),
        double_cosine=each_pick(by_hill, hill.double_cosine, well.double_cosine),
        double_sine=each_pick(by_hill, hill.double_sine, well.double_sine),
    )
    return reach_each(eta, rest, amount, most, each_pick(by_hill, -1, 1))


def further_each(eta, rest, start, amount, rough, far, moment=0):
    """How far beyond ``start`` V has risen by ``amount``: ``onward`` where the rough value is not told well enough."""
    better = onward_each(eta, rest, start, -amount, rough, far == 0, moment)
    # Newton's method leaves a place where V is nearly level for one far away.
    return each_pick(far | (np.abs(better - rough) > 0.01), rough, better)


def beyond_clamp_each(eta, piece, rise, drop, rough):
    """How far the motion goes beyond the clamp, when the tip is ``drop`` below the one that turns there.

    V falls by the same amount on both sides. The rough value is as good as its difference to the clamp's distance
    from a hill or a well allows.
    """
    far = rough > 0.25 * np.abs(piece.clamp_offset)
    amount = tip_fall_each(eta, piece, drop, rise, drop)
    return further_each(eta, piece.clamp_rest, piece.clamp_offset, amount, rough, far)


def least_moment_each(basin):
    """What rounding leaves at least of a moment, by the distance from the direction that tells it: where a hill and a
    well all but meet, and are not among the directions that are told, it would leave nothing, or less."""
    return (2.0**-52) ** 2 if basin.passes or not basin.whole else 4 * 2.0**-52


def far_side_each(eta, piece, rise, drop, depth, height):
    """Half the width of the motion, how far it goes on beyond the clamp, the moment where it turns, how far that is
    from the far hill, and what a shoulder tells."""
    basin = piece.basin
    hill, well, far, far_well = basin.hill, basin.well, basin.far, basin.far_well
    down = turn_to_each(far_well, far)
    if piece.low_kind == "level":
        below = -tip_fall_each(eta, piece, -rise, rise, drop)
    else:
        below = basin.far_rise + fall_each(eta, hill, 0, piece.low_offset + rise)
    if basin.passes:
        # Above the ridge by its height, and the ridge above the well behind it.
        above = height + fall_each(eta, basin.axis, 0, turn_to_each(basin.axis, far_well))
    else:
        above = -fall_each(eta, well, 0, -depth)
    by_hill = below < above
    distance = reach_either_each(eta, far, far_well, by_hill, each_pick(by_hill, below, above), down)
    turn = each_pick(by_hill, down - distance, distance)  # far turning point − far_well
    left = each_pick(by_hill, piece.far_gap - distance, distance - piece.beyond_well)
    if piece.high_kind == "turn":
        left = np.maximum(beyond_clamp_each(eta, piece, rise, drop, left), 0)
    if basin.passes:
        half_width = (turn + depth + turn_to_each(well, far_well)) / 2
    else:
        half_width = (turn + depth) / 2
    far_moment = each_pick(by_hill, slope_each(eta, far, -distance), slope_each(eta, far_well, distance)) * -1
    far_moment = np.maximum(far_moment, least_moment_each(basin) * distance)
    return half_width, left, far_moment, each_pick(by_hill, distance, down - distance), None


def halfway_each(hill, far, axis):
    """The angle from an axis to the middle of two hills, in which whole turns between them are no rounding."""
    quarters = hill.quarters + far.quarters - 2 * axis.quarters
    return quarters * (pi / 4) + ((hill.extra - axis.extra) + (far.extra - axis.extra)) / 2


def unevenness_each(eta, axis, centre, sine, near, far):
    """√far − √near: by the roots where they are apart, else by far − near = 2η sin 2(middle − α) sin(half_width).

    centre: from the axis to the middle.
    """
    double = axis.double_sine * each_cos(2 * centre) + axis.double_cosine * each_sin(2 * centre)
    by_turns = 2 * eta * double * sine / (np.sqrt(near) + np.sqrt(far))
    apart = (8 * near < far) | (8 * far < near) | (near + far < 2 * eta * sine)
    return each_pick(apart, np.sqrt(far) - np.sqrt(near), by_turns)


def wrapped_each(angle):
    """The angle less whole turns, between −π and π."""
    return angle - 2 * pi * np.floor(angle / (2 * pi) + 0.5)


def above_field_each(eta, basin, offset, turn, height):
    """``mean`` less η where they are near each other: 2(V(tip) − V)/(cos(θ − middle) − cos(half_width)) at the θ at
    which it is least, which lies then near the ridge or the well, at an offset from it.

    turn: half of what it is divided by. height: V(tip) less that of the ridge or the well.
    """
    # As near the ridge as rounding it is nearer still: it is there to the second order in the height.
    offset = each_pick(np.abs(offset) < 32 * each_spacing(offset), 0, offset)
    return (height + fall_each(eta, basin.axis, 0, offset)) / each_pick(turn == 0, 1, turn)


def mean_less_field_each(eta, basin, centre, half_width, near, far, height, mean):
    """``mean`` − η: as it stands, or by the end of the motion or the ridge or well that is near where V is nearest to
    level."""
    apart = mean - eta
    close = apart <= 0.3 * eta
    if each_any_of(close):
        # 2(axis − α), and 2(middle − α).
        axis = np.arctan2(basin.axis.double_sine, basin.axis.double_cosine)
        double = wrapped_each(axis + 2 * centre)
        ahead, behind = each_sin((half_width + double) / 2), each_sin((half_width - double) / 2)
        by_far, by_near = far - 2 * eta * ahead * ahead, near - 2 * eta * behind * behind
        known = each_pick(2 * by_far > far, by_far, by_near)
        far_off = close & (2 * by_far <= far) & (2 * by_near <= near)
        if each_any_of(far_off):
            # Not from a well that is far from where V is nearly level: there V tells least.
            told, turn = each_pick(near < far, by_near, by_far), ahead * behind
            above = above_field_each(eta, basin, wrapped_each(-axis - centre), turn, height)
            known = each_pick(
                far_off, each_pick(height <= np.abs(turn) * eta * (np.abs(ahead) + np.abs(behind)), above, told), known
            )
        apart = each_pick(close, known, apart)
    # Over a ridge V(tip) − V is nowhere less than there; elsewhere only rounding makes it smaller than this.
    least = np.maximum(height, (2.0**-52) ** 19) if basin.passes else 2.0**-52 * each_pick(near < far, near, far) / 4
    return np.maximum(apart, least)


def rates_each(beta, eta, basin, centre, half_width, sine, near, far, height):
    """dχ/dσ at the ends and in the middle of the motion. centre: from the slowest direction to the middle; beside:
    the end that is beside a shoulder, if one is."""
    middle, cosine = basin.axis.angle + centre, each_cos(half_width)
    cos_middle, cos_double = each_cos(middle), each_cos(2 * (middle - 0.5 * pi))
    product = np.sqrt(near) * np.sqrt(far)
    excess = -(2 * beta * cos_middle * cosine + eta * cos_double * (1 + cosine * cosine))
    split, rate = excess < 0, np.sqrt(product + np.maximum(excess, 0))
    if each_any_of(split):
        mean = -(2 * beta * cos_middle + eta * cosine * cos_double)
        apart = mean_less_field_each(eta, basin, centre, half_width, near, far, height, mean)
        rate = each_pick(split, sine * np.sqrt(apart * (mean + eta) / each_pick(split, product - excess, 1)), rate)
    return np.sqrt(product / 2), rate / 2


def motion_at_each(beta, eta, piece: Piece, place):
    """The motion of the tip at a place of a piece: −∞ is its low end, +∞ its high end."""
    basin = piece.basin
    rise, drop = piece.width / (1 + np.exp(-place)), piece.width / (1 + np.exp(place))
    from_hill, depth = piece.low_offset + rise, piece.high_depth + drop
    upper = from_hill < depth
    hill, well = basin.hill, basin.well
    offset = each_pick(upper, from_hill, -depth)
    stiffness = each_pick(upper, hill.stiffness, well.stiffness)
    double_cosine = each_pick(upper, hill.double_cosine, well.double_cosine)
    double_sine = each_pick(upper, hill.double_sine, well.double_sine)
    tip = each_pick(upper, hill.angle, well.angle) + offset
    near_moment = moment_from_rest_each(eta, stiffness, double_cosine, double_sine, offset)
    # How far V falls from the tip to the well, or to the level of a ridge that the motion passes.
    change = (drop + piece.level_gap if basin.passes else depth) / 2
    height = fall_from_rest_each(eta, stiffness, double_cosine, double_sine, offset + change, change)
    # Near the high end the clamp is told from there, else as the tip is: the clamp's own distances are exact.
    done, apart = piece.clamp_gap + drop, each_pick(upper, piece.past_hill - from_hill, piece.past_well + depth)
    done = each_pick(done < 0.5 * each_pick(upper, from_hill, np.abs(piece.past_well)), done, apart)
    depth = each_pick(upper, turn_to_each(hill, well) - from_hill, depth)
    beside = None
    if basin.even:
        half_width = each_pick(
            upper, turn_to_each(hill, basin.axis) - from_hill, depth + turn_to_each(well, basin.axis)
        )
        left = 2 * half_width - done if piece.high_kind != "turn" else drop
        far_moment, far_distance = near_moment, from_hill
    else:
        side = far_side_each(eta, piece, rise, drop, depth, height)
        half_width, left, far_moment, far_distance, beside = side
        if basin.shoulder is not None:
            near_moment, beside = beside_shoulder(eta, basin, from_hill, offset, near_moment, beside)
        near_moment = np.maximum(near_moment, least_moment_each(basin) * np.abs(offset))
    # Where the motion is nearly a whole turn, what it lacks is told by the distances from the hills.
    lack = (from_hill + far_distance) / 2 if basin.whole else pi - half_width
    sine = each_sin(each_pick(lack < half_width, lack, half_width))
    near, far = 2 * near_moment / sine, 2 * far_moment / sine
    # done/2 + left/2 = half_width: near half a turn one follows from the other.
    done_sine = each_sin(each_pick(done > pi, lack + left / 2, done / 2))
    left_sine = each_sin(each_pick(left > pi, lack + done / 2, left / 2))
    half_cosine = each_sin(lack / 2)
    centre = halfway_each(hill, basin.far, basin.axis) + (from_hill - far_distance) / 2
    uneven = 0 if basin.even else unevenness_each(eta, basin.axis, centre, sine, near, far)
    end, middle = rates_each(beta, eta, basin, centre, half_width, sine, near, far, height)
    return Motion(
        (
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
    )


def phase_of_each(motion):
    """The phase of the clamp: χ by the half-angle sines, and ψ by χ."""
    near, far, end = np.sqrt(motion.near), np.sqrt(motion.far), motion.end
    done, left = motion.done_sine, motion.left_sine
    whole = phase_sum_each(near, far, done, left)
    gap = each_sin((motion.left - motion.done) / 4)
    behind, ahead = far * done / whole, near * left / whole
    lead = phase_lead_each(near, motion.half_cosine, motion.uneven, done, gap) / whole
    # Of two sums for the same that which has the smaller terms rounds less.
    cosine = each_pick(near * np.abs(left - done) + np.abs(motion.uneven) * done < whole, lead, ahead - behind)
    # Not zero: at the tip itself the motion has no point by ℘.
    square = np.maximum(chi_square_each(behind, ahead), (2.0**-52) ** 19)
    size, first = np.abs(cosine), cosine >= 0
    delta = each_hypot(end * cosine, motion.middle * np.sqrt(square))
    half = each_pick(first, half_square_each(end, square, size, delta), half_square_beyond_each(end, size, delta))
    rest = each_pick(
        first, half_rest_each(end, size, delta), half_rest_beyond_each(end, motion.middle, square, size, delta)
    )
    return Phase((half, rest, whole, delta))


def rough_times(rods, piece, place):
    """Half-swing and first arrival, to the square of a thousandth or the rounding of the numbers given."""
    motion = motion_at_each(rods.beta, rods.eta, piece, place)
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


class Brackets(Record):
    """Crossings to be found: the range, by its number in the group, the branch, places on either side, and there the
    length of the branch less the rod's. All are of one precision but the first three."""

    __slots__ = ()

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


def extrema(group, sign, places, swings, arrivals, counts):
    """Brackets beside the extrema that reach beyond a whole number, and the ranges where that is not sure."""
    grows = counts[1:] > counts[:-1]
    row, which = np.nonzero(grows[1:] != grows[:-1])
    before, here, after = (counts[row + k, which] for k in range(3))
    left, middle, right = (places[row + k, which] for k in range(3))
    top = here > before
    share = np.maximum(right - middle, 1e-30) / np.maximum(middle - left, 1e-30)
    reach = np.maximum(np.abs(before - here) * share, np.abs(after - here) / share)
    goal = np.where(top, np.ceil(here), np.floor(here))
    near = np.where(top, goal - here, here - goal)
    close = np.flatnonzero(((before - here) * (after - here) > 0) & (near <= reach) & (goal >= 0))
    which, goal, top, left, right = which[close], goal[close], top[close], left[close], right[close]
    if not close.size:
        return Brackets((which, goal, np.full(which.shape, sign), left, right, left, right)), which
    some = rows(group, which)
    length = some.rods.length
    finer = left + (right - left) * FINER.astype(left.dtype)[:, None]
    swings, arrivals = rough_times(some.rods, some.piece, finer)
    short = np.where(top, 1, -1).astype(left.dtype) * (goal - (length - sign * arrivals) / (2 * swings))
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
    found = Brackets((which[sure], goal[sure], np.full(sure.shape, sign), left[sure], middle, value[0], center))
    other = found._replace(left=middle, right=right[sure], value_left=center, value_right=value[-1])
    return joined([found, other]), which[hard]


def crossed(group, sign, places, swings, arrivals, capped, most):
    """Brackets of the whole numbers that the count of one branch crosses, and the ranges that are doubtful."""
    length, end = group.rods.length, end_arrival(group.piece, swings[-1])
    counts = (length - sign * arrivals) / (2 * swings)
    doubt = ~np.isfinite(counts.sum(axis=0)) | capped[0] & (counts[0] >= 1)
    beside, hard = extrema(group, sign, places, swings, arrivals, counts)
    if end is None:
        doubt |= capped[1] & (counts[-1] >= 1)
    else:
        # What lies deeper than the samples, towards the end itself.
        beyond = (length - sign * end) / (2 * swings[-1])
        doubt |= np.isfinite(beyond) & (np.ceil(np.maximum(beyond, 0)) != np.ceil(np.maximum(counts[-1], 0)))
        turn = np.isfinite(beyond) & ((counts[-1] > counts[-2]) != (beyond > counts[-1]))
        doubt |= turn & (np.abs(counts[-1] - np.floor(counts[-1] + 0.5)) < 2 * np.abs(beyond - counts[-2]))
    levels = np.maximum(np.ceil(counts), 0)
    row, which = np.nonzero(np.abs(levels[1:] - levels[:-1]) > 0)
    one, other = levels[row, which], levels[row + 1, which]
    number = np.abs(other - one).astype(int)
    lowest, row, which = np.repeat(np.minimum(one, other), number), np.repeat(row, number), np.repeat(which, number)
    turns = lowest + np.arange(number.sum(), dtype=lowest.dtype) - np.repeat(number.cumsum() - number, number)
    turns = turns.astype(lowest.dtype)
    ahead = [surplus(swings[k, which], arrivals[k, which], turns, sign, length[which]) for k in (row, row + 1)]
    near, far = places[row, which], places[row + 1, which]
    found = joined([Brackets((which, turns, np.full(which.shape, sign), near, far, ahead[0], ahead[1])), beside])
    wanted = (found.turns > 0) | (sign > 0)
    wanted &= 2 * found.turns - (sign < 0) <= most
    return found if wanted.all() else rows(found, wanted), np.concatenate([np.flatnonzero(doubt), hard])


def bracketed(group, kind, step, most):
    """Brackets of all crossings of a group, and the ranges that are doubtful."""
    rounded = rounded_to(group, kind)
    first, last = ends(rounded.rods, rounded.piece)
    deepest = ROUGH_DEPTH if kind is np.float32 else 600.0
    capped = first < -deepest, last > deepest
    first, last = np.maximum(first, -deepest), np.minimum(last, deepest)
    parts, doubts = [], []
    for start in range(0, first.size, RANGES):
        here = slice(start, start + RANGES)
        some, low, high, *deep = rows((rounded, first, last, *capped), here)
        places = places_of(some.dip, low, high, step).astype(kind)
        swings, arrivals = rough_times(some.rods, some.piece, places)
        for sign in (1, -1) if some.rods.slow.max() >= pi else (1,):
            found, doubt = crossed(some, sign, places, swings, arrivals, deep, most)
            parts.append(found._replace(range=found.range + start))
            doubts.append(doubt + start)
    return joined(parts), np.concatenate(doubts)


def rough_surplus(given, place):
    """The surplus of branches of a group at places."""
    some, turns, sign = given
    swing, arrival = rough_times(some.rods, some.piece, place)
    return surplus(swing, arrival, turns, sign, some.rods.length)


def roughly_at(group, brackets, kind):
    """Rough crossings of a group with a row for each: places, and the slope of the branch there."""
    given = rounded_to(group, kind), brackets.turns.astype(kind), brackets.sign.astype(kind)
    ends = brackets.left, brackets.right, brackets.value_left, brackets.value_right
    place, slope = approached(rough_surplus, given, *ends, STEPS, SPREAD)
    return place.astype(float), slope.astype(float)


class Times(Record):
    """A motion with its phase at the clamp, half-swing and first arrival."""

    __slots__ = ()

    motion: Any
    phase: Any
    swing: Any
    arrival: Any


def lengths_each(a, b, square, rest):
    """The complete and the incomplete integral of 1/√(a² cos²ψ + b² sin²ψ), by sin²ψ and cos²ψ.

    Gauss's transformation makes a and b equal (DLMF 19.8(i), 19.8(iii)); it is written in sums of positive terms only.
    """
    limit, more = 2 * (2.0**-52) ** 0.5, each_any_of(a > 0)
    while more:
        more = each_any_of(np.abs(a - b) > limit * a)
        delta = phase_rate_each(a, b, square, rest)
        total, below = a + b, a + delta
        square, rest = gauss_square_each(square, total, below), gauss_rest_each(a, b, square, rest, delta, below)
        a, b = total / 2, np.sqrt(a * b)
    mean = (a + b) / 2
    return pi / (2 * mean), np.arctan2(np.sqrt(square), np.sqrt(rest)) / mean


def times_at(group, place):
    """The motions of tips at places of a group, one on each range, and their times."""
    motion = motion_at_each(group.rods.beta, group.rods.eta, group.piece, place)
    motion = motion._replace(uneven=motion.uneven + 0 * place)  # of an even basin it is a number
    phase = phase_of_each(motion)
    return Times((motion, phase, *lengths_each(motion.end / 2, motion.middle / 2, phase.square, phase.rest)))


def put_rows(record, which, other):
    """The record with other values for some of the rods, in its own arrays."""
    for part, values in zip(record, other, strict=True):
        if isinstance(part, np.ndarray):
            part[which] = values
        elif isinstance(part, tuple):
            put_rows(part, which, values)
    return record


def secant_slope(at, before, value, value_before, slope):
    """The slope of a branch by two places, or the one known where they are too near each other."""
    change = at - before
    told = np.abs(change) > TOLD * (1 + np.abs(at))
    return np.where(told, (value - value_before) / np.where(told, change, 1), slope)


class Found(Record):
    """Tips: the range, place and branch, whether it grows with the tip, the motion with its phase and its times."""

    __slots__ = ()

    range: Any
    place: Any
    turns: Any
    sign: Any
    rising: Any
    motion: Any
    phase: Any
    swing: Any
    arrival: Any


def lost_ranges(wanted, found):
    """The ranges of which not every crossing has been found: as often as they are wanted."""
    number = np.bincount(wanted)
    return np.flatnonzero(number != np.bincount(found, minlength=number.size))


def polished(some, brackets, place, slope):
    """The crossings to rounding, by secants from rough ones, and the ranges in which one is not found so.

    some: the group with a row for each.
    """
    wanted, crossed = brackets.range, (brackets.value_left > 0) != (brackets.value_right > 0)
    some, brackets, place, slope = rows((some, brackets, place, slope), crossed)
    least, most = np.minimum(brackets.left, brackets.right) - 0.01, np.maximum(brackets.left, brackets.right) + 0.01
    value, before, todo = np.full(place.shape, np.nan), place.copy(), np.arange(place.size)
    settled, found = np.zeros(place.shape, dtype=bool), Times((None, None, None, None))
    for turn in range(8):
        here, branch = (some, brackets) if todo.size == place.size else rows((some, brackets), todo)
        at, times = place[todo], times_at(here, place[todo])
        found = put_rows(found, todo, times) if turn else times
        now = surplus(times.swing, times.arrival, branch.turns, branch.sign, here.rods.length)
        slope[todo] = steep = secant_slope(at, before[todo], now, value[todo], slope[todo])
        value[todo], before[todo], step = now, at, now / steep
        if turn >= SECANTS:
            blur = 2.0**-52 * 2 ** min(turn - SECANTS, EASE)
            settled[todo] = close = (np.abs(step) <= blur * (1 + np.abs(at))) | (np.abs(now) <= blur * here.rods.length)
            # What is left time and again is rounding of the times themselves; half way leaves less of it.
            step = np.where(np.abs(now) <= NOISE * 2.0**-52 * here.rods.length, step / 2, step)
            todo, at, step = todo[~close], at[~close], step[~close]
        place[todo] = at = at - step
        todo = todo[(at >= least[todo]) & (at <= most[todo])]
        if not todo.size:
            break
    rising = (brackets.value_right > brackets.value_left) == (brackets.right > brackets.left)
    tips = rows(Found((brackets.range, place, brackets.turns, brackets.sign, rising, *found)), settled)
    return tips, lost_ranges(wanted, tips.range)


def searched(group, which, kind, step, most):
    """The tips of some ranges, and the ranges of which there may be more or fewer."""
    part = moved(rows(group, which) if which.size < group.rods.case.size else group)
    brackets, doubts = bracketed(part, kind, step, most)
    if not brackets.range.size:
        return [], which[doubts]
    some = rows(part, brackets.range)
    place, slope = roughly_at(some, brackets, brackets.left.dtype)
    sure, lost = polished(some, brackets, place, slope)
    doubtful = np.concatenate([doubts, lost])
    if doubtful.size:
        sure = rows(sure, ~np.isin(sure.range, doubtful))
    return [sure._replace(range=which[sure.range])], which[doubtful]


def tips(group, most):
    """The tips of a group, a list of Found, and the ranges left to the scalar solver."""
    rough = group.rods.slow < ROUGH_SLOW
    found, again = [], [np.zeros(0, dtype=int)]
    for mask, kind in ((rough, np.float32), (~rough, float)):
        which = np.flatnonzero(mask)
        if which.size:
            sure, doubtful = searched(group, which, kind, WIDE, most)
            found += sure
            again.append(doubtful)
    left = np.unique(np.concatenate(again))
    if left.size:
        sure, left = searched(group, left, float, CLOSER, most)
        found += sure
    return found, left


class Tips(Record):
    """Tips that have been found: their rods, ranks of ranges, whole turns of the clamp, and motions."""

    __slots__ = ()

    rods: Any
    rank: Any
    turns: Any
    found: Any


def beside_shoulders(group, found):
    """The cases that have a tip from which the motion nearly rests beside a shoulder: arrays know no shoulders."""
    if has_no_shoulder(group.piece):
        return np.zeros(0, dtype=int)
    rods, motion = rows(group.rods, found.range), found.motion
    most, (_, cusp) = RESTING * (rods.beta + rods.eta), missing_ridge(rods)
    tip, far = motion.tip - cusp, motion.tip + 2 * motion.half_width - cusp
    rests = (np.abs(tip) < ASIDE) & (motion.near_moment < most) | (np.abs(far) < ASIDE) & (motion.far_moment < most)
    return rods.case[rests]


def straight_rods(straight, most):
    """The rods that stay straight."""
    rods, rest, length = straight.rods, straight.rest, straight.rods.length
    cosine, sine = np.cos(rest.extra) + 0 * length, np.sin(rest.extra) + 0 * length
    for _ in range(rest.quarters % 4):
        cosine, sine = -sine, cosine
    aligned = np.cos(rest.angle - 0.5 * pi)
    soft = -rest.stiffness
    index = np.where(soft > 0, np.floor(length * np.sqrt(np.abs(soft)) / pi + 0.5), 0).astype(int)
    energy = -(rods.beta * cosine + rods.eta * aligned * aligned / 2) * length
    here = rods.scale
    extent = np.ldexp(length, -here)
    gamma = np.ldexp(2 * rods.beta * cosine + rods.eta * aligned * aligned, 2 * here)
    found = Columns(
        (
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
    )
    return rows(found, index <= most)


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
    return Point((b, point_pole_each(b, done, each_cos(motion.done / 2)), one, product, root_sum))


def rj_pair_each(x, product, root_sum, p, lift, less, twist):
    """R_J(x, y, z, p) by duplication, for x ≥ 0, complex p, and y and z by √y√z and √y + √z.

    lift, less, twist: p + √y√z, p − x and (p − x)(p − y)(p − z), which the rod gives without cancellation. Sums of
    positive terms only in x, y, z. Where √p and −√y are near each other, their sum follows from their difference.
    """
    pair = root_sum * root_sum - 2 * product
    fivefold = x + pair + (p + p)
    start = fivefold / 5
    one, two = start - x, 2 * start - pair
    both = start * start - start * pair + product * product
    reach = 5 * (np.abs(one) + np.abs(start - p) + np.sqrt(np.abs(both)))
    # Twice that of the largest departure from the mean, for these are added up.
    target = 2 * (2.0**-52 / 4) ** 0.125
    scale, total = 1, 0
    while each_any_of(reach > target * scale * np.abs(fivefold)):
        root, root_p = np.sqrt(x), each_complex_sqrt(p)
        side, across = root_p * root_sum, root * root_sum
        plus = lift + side
        if scale == 1:
            minus = lift - side
            cancels = np.abs(plus) < np.abs(minus)
            plus = each_pick(cancels, twist / (less * each_pick(cancels, minus, 1)), plus)
        share = 1 / ((root_p + root) * plus)  # one quotient of complex numbers, which take longer than products
        raised, lifted = (lift + across, np.sqrt(x + product + across))
        end = (root_p + root_p) * raised * share
        total = total + each_arctan_share(twist * share * share, end) * share / scale
        pair = root_sum * (root_sum + 2 * root) / 4
        x, p = (x + product + across) / 4, raised * 0.25
        product, root_sum = root_sum * lifted / 4, np.sqrt(root_sum * (root_sum + 2 * root + 2 * lifted)) / 2
        lift, fivefold, twist = p + product, x + pair + (p + p), twist * 0.015625
        scale *= 4
    mean = fivefold / 5
    size = scale * mean
    a, b, c = one / size, two / size, both / (size * size)
    d = -(a + b) / 2
    e2 = a * b + c - 3 * d * d
    e3 = a * c + 2 * e2 * d + 4 * d * d * d
    e4 = (2 * a * c + e2 * d + 3 * d * d * d) * d
    e5 = a * c * d * d
    bent = e2 * (9 / 88 - e2 * (1 / 16) + e3 * (45 / 272)) - e3 * (9 / 52) + e4 * (3 / 20) - e5 * (9 / 68) - 3 / 14
    series = 1 + e2 * bent + e3 * (1 / 6 + e3 * (3 / 40) - e4 * (9 / 68)) - e4 * (3 / 22) + e5 * (3 / 26)
    return series / (scale * mean * each_complex_sqrt(mean)) + 6 * total


def shift_each(eta, heading, motion, point, root, square, rest):
    """W as real and imaginary part: ∫e^{iθ} from the tip is e^{iφ}(σ + W)."""
    b, near, far = point.strength, np.sqrt(motion.near), np.sqrt(motion.far)
    twist = each_complex_of(
        rj_delta_real_each(eta, b, heading.double_cosine), rj_delta_imag_each(eta, b, heading.double_sine)
    )
    lift = pair_lift_each(near, far, motion.uneven, motion.half_cosine, square, rest)
    pole, lifted, less = each_complex_of(point.pole, -b), each_complex_of(lift, -b), each_complex_of(root, -b)
    third = rj_pair_each(point.one, point.product, point.root_sum, pole, lifted, less, twist)
    return w_real_each(b, third.imag), w_imag_each(b, third.real)


def kink_at_each(motion, first, second, point, root, q, m, square, rest):
    """The part of η∫cos²(θ − α) without integral; towards the tip its terms are large and cancel in the first form."""
    b, x, product = point.strength, point.pole, point.product
    delta = np.maximum(phase_rate_each(first, second, square, rest), second * np.sqrt(square))
    across, others = np.sqrt(square * rest), others_sum_each(q, root)
    both = others_product_each(b, m, root, others)
    lift = pair_lift_each(np.sqrt(motion.near), np.sqrt(motion.far), motion.uneven, motion.half_cosine, square, rest)
    far = arc_kink_each(first, square, delta, across, b, x, root, np.sqrt(point.one), product)
    # Beyond the middle the lift may be as good as nothing to divide by, and the square of the pole, too.
    towards_tip = lift > 0.15
    lift, there = each_pick(towards_tip, lift, 1), each_pick(towards_tip, x, 1)
    return each_pick(towards_tip, arc_kink_tip_each(first, delta, across, b, there, root, others, both, lift), far)


def second_kind_each(a, b, square, rest, arrival):
    """∫sin²ψ over the same range as ``arrival``, the length, and by how much that exceeds sin ψ cos ψ/Δ.

    By the same transformation (DLMF 19.8.19). Both are small as the cube of a short length, without a difference.
    """
    limit, more, gap = (2.0**-52) ** 0.5, each_any_of(a > 0), a - b
    delta, weight, weights, integral, excess = phase_rate_each(a, b, square, rest), 0.5, 0.0, 0, 0
    while more:
        more = each_any_of(np.abs(gap) > limit * a)
        total, below = a + b, a + delta
        square, rest = gauss_square_each(square, total, below), gauss_rest_each(a, b, square, rest, delta, below)
        share, first, second = gap / total, 2 * a / total, 2 * b / total
        a, b = total / 2, np.sqrt(a * b)
        delta = phase_rate_each(a, b, square, rest)
        bend = phase_bend_each(share, first, square, rest, np.sqrt(square * rest), delta)
        step = lag_step_each(bend, share, second, square, rest)
        integral = integral + weight * first * bend + weights * step
        weights, weight, excess = weights + weight, weight * share / 2, excess + step
        gap = gauss_gap_each(gap, a + b)  # a difference would lose what the weight brings out
    last = each_arc_excess((a + b) * arrival) / (a + b)
    return integral + (weights + weight) * last, excess + last


def arc_to_each(beta, eta, heading, motion, point, square, rest, extent):
    """The arc from the tip to a point, at ψ, of the given length."""
    root = far_root_each(motion.near, each_cos(motion.half_width))
    w_re, w_im = shift_each(eta, heading, motion, point, root, square, rest)
    y, z = arc_y_each(heading.sine, heading.cosine, w_re, w_im), arc_z_each(heading.sine, heading.cosine, w_re, w_im)
    first, second = motion.end / 2, motion.middle / 2
    q = rest_stiffness_each(beta, eta, heading.cosine, heading.double_cosine)
    m = tip_cubic_each(beta, eta, heading.sine, heading.double_sine)
    kink = kink_at_each(motion, first, second, point, root, q, m, square, rest)
    turned, lag = second_kind_each(first, second, square, rest, extent)
    return Arc((y, z, arc_square_each(beta, first, second, root, y, kink, turned, lag)))


def first_stretches(rods, heading, found):
    """The arcs from the tip, or from where the motion is as there, to the clamp."""
    motion, phase = found.motion, found.phase
    point = clamp_point_each(motion, phase)
    return arc_to_each(rods.beta, rods.eta, heading, motion, point, phase.square, phase.rest, found.arrival)


def sent_back_each(motion):
    """The motion from its far turning point back to the tip, as the mirror at the y axis shows it.

    A clamp at the turning point itself, where the motion has no point by ℘, is a little before it.
    """
    return motion._replace(
        tip=-(motion.tip + 2 * motion.half_width),
        done=motion.left,
        left=motion.done,
        near_moment=motion.far_moment,
        far_moment=motion.near_moment,
        near=motion.far,
        far=motion.near,
        uneven=-motion.uneven,
        done_sine=np.maximum(motion.left_sine, (2.0**-52) ** 6),
        left_sine=motion.done_sine,
    )


def heading_at(field_angle, motion):
    """``heading_of`` by NumPy's own sine and cosine: a rounding of them is one of the tip's place."""
    double = 2 * (motion.tip - field_angle)
    return Heading((np.cos(motion.tip), np.sin(motion.tip), np.cos(double), np.sin(double)))


def arc_from_far_each(eta, heading, there, arc, extent):
    """The arc of a motion turned back, whose heading is ``there``, as what departs from the tip's direction."""
    y, z = arc.y + extent * (there.cosine - heading.cosine), arc.z + extent * (there.sine + heading.sine)
    return Arc((y, -z, arc.square + extent * eta * (there.double_cosine - heading.double_cosine) / 2))


def last_stretches(rods, heading, found):
    """The arcs from the last turning point to the clamp, of rods that end on their way back."""
    back, extent = sent_back_each(found.motion), found.swing - found.arrival
    there, phase = heading_at(-0.5 * pi, back), phase_of_each(back)
    point = clamp_point_each(back, phase)
    arc = arc_to_each(rods.beta, rods.eta, there, back, point, phase.square, phase.rest, extent)
    return arc_from_far_each(rods.eta, heading, there, arc, extent)


def far_point_each(motion):
    """The far turning point."""
    b = strength_each(motion.near_moment)
    pole = point_pole_each(b, motion.sine, each_cos(motion.half_width))
    return Point((b, pole, 0, far_pair_root_each(motion.end), motion.middle))


def departures(rods, heading, found, stretch):
    """The arcs of the rods, less those of straight ones: of whole half-swings, and of the last stretch."""
    columns = stretch(rods, heading, found)
    motion, swing, through = found.motion, found.swing, 2 * found.turns - (found.sign < 0)
    swung = np.flatnonzero(found.turns > 0)
    if swung.size:
        some, there, motion, swing, times = rows((rods, heading, motion, swing, through), swung)
        one, none = np.full(swung.shape, 1.0), np.zeros(swung.size)
        whole = arc_to_each(some.beta, some.eta, there, motion, far_point_each(motion), one, none, swing)
        for column, change in zip(columns, whole, strict=True):
            column[swung] += times * change
    return columns


def bent(some, stretch):
    """The equilibria of tips, given with their indices, from which the clamp is reached by stretches of one kind."""
    tips, index = some
    rods, found = tips.rods, tips.found
    motion, phase = found.motion, found.phase
    beta, eta, length = rods.beta, rods.eta, rods.length
    heading = heading_at(0.5 * pi, motion)
    y, z, square = departures(rods, heading, found, stretch)
    speed = phase.delta * phase.whole / (motion.end * motion.sine) * np.sqrt(2 * motion.done_sine * motion.left_sine)
    gamma = 2 * beta * heading.cosine + eta * (1 + heading.double_cosine) / 2
    energy = -gamma * length / 2 - 2 * beta * y - square
    unit, side = np.ldexp(1.0, rods.scale), rods.side
    return Columns(
        (
            rods.case,
            side * (tips.rank - LAST),
            side * found.place,
            side * (motion.tip + 2 * pi * tips.turns),
            -side * found.sign * speed * unit,
            gamma * unit * unit,
            (length * heading.cosine + y) / unit,
            side * (length * heading.sine + z) / unit,
            energy * unit,
            index,
        )
    )


def bent_rods(known, most):
    """The equilibria of tips on their branches, a list of Columns: those of short lists together."""
    few = [tips for tips in known if 2 * tips.rank.size < AT_ONCE]
    many = [tips for tips in known if 2 * tips.rank.size >= AT_ONCE]
    parts = []
    for tips in [*many, joined(few)] if few else many:
        index = index_each(tips.found)
        some = rows((tips, index), index <= most)
        for stretch, sign in ((first_stretches, 1), (last_stretches, -1)):
            there = rows(some, some[0].found.sign == sign)
            for start in range(0, there[1].size, AT_ONCE):
                parts.append(bent(rows(there, slice(start, start + AT_ONCE)), stretch))
    return parts


def on_arrays(rods, most):
    """The equilibria of rods with tips below the clamp angle, the straight ones, and the cases left to the scalar
    solver."""
    found, straight, doubtful = groups(rods)
    known, left = [], [doubtful]
    for group in found:
        tip, lost = tips(group, most)
        left.append(group.rods.case[lost])
        for some in tip:
            rod, rank, turns = rows((group.rods, group.rank, group.turns), some.range)
            known.append(Tips((rod, rank, turns, some)))
            left.append(beside_shoulders(group, some))
    parts = [no_columns(), *(straight_rods(some, most) for some in straight), *bent_rods(known, most)]
    return joined(parts), np.concatenate(left)


def both_sides_each(rods):
    """The rods and after them their mirror images, for the tips above the clamp angle."""
    number = rods.case.size
    side, both = np.repeat(np.array([1, -1]), number), np.concatenate([np.arange(number), np.arange(number)])
    twice = rows(rods, both)
    return Rods(
        (twice.case, side, twice.scale, twice.beta, twice.eta, twice.length, side * twice.clamp_angle, twice.slow)
    )


def incomplete(found, size, most):
    """The rods of which an equilibrium is missing: those of even and of odd index differ by one in number (the degree
    of the equation is that of the rod without load), and the least energy has index 0.
    """
    if most < np.inf:
        return np.bincount(found.case, minlength=size) == 0
    return np.bincount(found.case, weights=1 - 2 * (found.index % 2), minlength=size) != 1


def at_once(beta, eta, length, clamp_angle, size, most):
    """The equilibria on arrays, and the rods that are left to the scalar solver."""
    scale = np.full(size, np.frexp(beta + eta)[1] // 2)
    force, magnet, extent = np.ldexp(beta, -2 * scale), np.ldexp(eta, -2 * scale), np.ldexp(length, scale)
    slow = extent * np.sqrt(force + magnet)
    clamp = np.full(size, clamp_angle)
    good = (slow < SLOWEST) & (slow > 2.0**-52)
    rods = rows(Rods((np.arange(size), 1, scale, force, magnet, extent, clamp, slow)), good)
    short, rods = short_and_others(rods, most)
    found, doubtful = on_arrays(both_sides_each(rods), most)
    found = joined([short, found])
    return (
        found,
        np.unique(np.concatenate([np.flatnonzero(~good), doubtful, np.flatnonzero(incomplete(found, size, most))])),
    )


def one_by_one(beta, eta, length, clamp_angle, max_index):
    """The equilibria of one rod by the scalar solver."""
    found = all_equilibria(beta, eta, length, clamp_angle, max_index)
    return Columns(
        (
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
    )


def in_order_each(found):
    """``in_order`` on arrays: tips that are nearer than rounding as equal, where rounding would exchange them."""
    tip, alike = found.tip_angle, found.case[1:] == found.case[:-1]
    wrong = alike & (tip[1:] < tip[:-1])
    while wrong.any():
        tip = np.concatenate([tip[:1], np.where(wrong, tip[:-1], tip[1:])])
        wrong = alike & (tip[1:] < tip[:-1])
    return found._replace(tip_angle=tip)


def block(beta, eta, length, clamp_angle, size, max_index):
    """The equilibria of one block: on arrays, and those of few rods, or where arrays leave a doubt, one by one."""
    most = np.inf if max_index is None else max_index
    found, lost = no_columns(), np.arange(size)
    if size >= FEWEST:
        with np.errstate(all="ignore"):
            found, lost = at_once(beta, eta, length, clamp_angle, size, most)
    if lost.size:
        parts = [rows(found, ~np.isin(found.case, lost))]
        for case in lost.tolist():
            one = one_by_one(
                element(case, beta), element(case, eta), element(case, length), element(case, clamp_angle), max_index
            )
            parts.append(one._replace(case=one.case + case))
        found = joined(parts)
    return in_order_each(rows(found, np.lexsort((found.place, found.rank, found.case))))


def sweep_arrays(beta, eta, length, clamp_angle, grid, max_index):
    """Every equilibrium of every rod, sorted by rod and then by tip angle; all arguments broadcast to ``grid``.

    max_index: the largest index wanted, or None for all. The memory needed besides the result is that of one block, or
    of one column. Without ranks and places, which only put the tips of a block in order.
    """
    number, none = prod(grid), no_columns()
    columns = [[column] for column in none]
    for start in range(0, number, BLOCK):
        which = slice(start, min(start + BLOCK, number))
        found = block(
            slab(grid, which, beta),
            slab(grid, which, eta),
            slab(grid, which, length),
            slab(grid, which, clamp_angle),
            which.stop - start,
            max_index,
        )
        found = found._replace(case=found.case + start, rank=none.rank, place=none.place)
        for parts, column in zip(columns, found, strict=True):
            parts.append(column)
    whole = []
    while columns:
        whole.append(np.concatenate(columns.pop(0)))
    return Columns(whole)


def span(name, ends):
    """(low, high) with 0 ≤ low < high, or an error that names the argument."""
    if isinstance(ends, (str, bytes)) or not isinstance(ends, Iterable) or getattr(ends, "ndim", 1) != 1:
        raise TypeError(f"{name} must be a pair (low, high), got {in_a_line(ends)}")
    pair = list(ends)
    if len(pair) != 2:
        raise ValueError(f"{name} must be a pair (low, high), got {in_a_line(ends)}")
    low, high = (real(f"{name}[{place}]", end) for place, end in enumerate(pair))
    if not 0 <= low < high:
        raise ValueError(f"{name} must be a range (low, high) with 0 ≤ low < high, got ({low}, {high})")
    return low, high


def must_be_searchable(beta, eta, length, slowest):
    """ValueError where β + η at the high ends of their ranges is more than is searched."""
    must_be_finite(beta, eta, length)
    slow = length * sqrt(beta + eta)
    if slow > slowest:
        raise refused(
            Loads((beta, eta, length)),
            f"ℓ√(β + η) = {briefly(slow)} at the high end; the limit is {slowest}; choose a lower end or a shorter rod",
        )


def steps(beta, soonest, length, low, high):
    """The η to look at first, from where ``soonest``, the largest force, lets equilibria meet; beta: the least one.

    As long as ℓ²(β + η) < (π/2)² nothing meets: ∂θ(0)/∂θ(ℓ) has no zero yet (Sturm).
    """
    first = pi / 2 / length
    start, offset = max(low, first * first - soonest), max(beta, first * first)
    if start >= high:
        return []
    ratio = (offset + high) / (offset + start)
    count = ceil(20 * log(ratio)) + 2
    inner = [(offset + start) * ratio ** (k / count) - offset for k in range(1, count)]
    return [start, *(eta for eta in inner if start < eta < high), high]


class Mark(Record):
    """An extremum of a branch's length over the tip angle.

    key: side, piece, branch, and whether it is a maximum. group: what of it stays when it goes over to another piece.
    spot: what tells it from the others of its key, the place. height: the length there over the rod's, less 1. slope:
    the derivative of that by η.
    """

    __slots__ = ()

    key: tuple
    group: tuple
    spot: float
    place: float
    height: float
    slope: float
    rod: Rod
    turns: int
    piece: Piece


class Probe(Record):
    """Half-swing, first arrival, and their derivatives by the place."""

    __slots__ = ()

    place: float
    swing: float
    arrival: float
    swing_rate: float
    arrival_rate: float


def moment_rate(beta, eta, angle, d_angle, change):
    """The derivative of θ″ at an angle that changes too."""
    lean = angle - 0.5 * pi
    stiffness = beta * cos(angle) + eta * cos(2 * lean)
    return stiffness * d_angle + sin(angle) * change.beta + sin(2 * lean) / 2 * change.eta


def change_of_ratio(beta, eta, motion, change, d_turn):
    """The derivative of log(far/near); d_turn: of the far turning point by the loads alone.

    What the tip does to it is put by the condition of turning pairs, by which far − near is 2η sin 2(middle − α) times
    sin(half_width): where the motion is nearly a whole turn both logarithms change much and alike.
    """
    tip, near, far = motion.tip, motion.near, motion.far
    turn = tip + 2 * motion.half_width
    stiffness = beta * cos(tip) + eta * cos(2 * (tip - 0.5 * pi))
    by_tip = 6 * cos(motion.half_width) * near * near + 4 * stiffness * (near + far)
    by_near = moment_rate(beta, eta, tip, 0, change) / motion.near_moment
    by_far = moment_rate(beta, eta, turn, d_turn, change) / motion.far_moment
    skew = motion.uneven * (sqrt(near) + sqrt(far)) / (2 * motion.sine)
    return -by_tip * skew / (near * far * far) * change.tip - by_far - by_near


class Numbers(Record):
    """Derivatives of the numbers of the Legendre form: of the logarithms of far/near, end and middle, and of the far
    turning point itself."""

    __slots__ = ()

    ratio: float
    end: float
    middle: float
    turn: float


def changes_of_numbers(beta, eta, motion, change):
    """Derivatives of the turning pair (V stays equal at its ends) and of the numbers made from it."""
    tip, half, sine = motion.tip, motion.half_width, motion.sine
    cosine, middle, turn = cos(half), tip + half, tip + 2 * half
    cos_middle, sin_middle = cos(middle), sin(middle)
    double_cos, double_sin = cos(2 * (middle - 0.5 * pi)), sin(2 * (middle - 0.5 * pi))
    loads = sine * (cosine * double_sin * change.eta + 2 * sin_middle * change.beta)
    d_turn = (loads - motion.near_moment * change.tip) / motion.far_moment
    d_half, d_middle = (d_turn - change.tip) / 2, (d_turn + change.tip) / 2
    cot = cosine / sine * d_half
    near = moment_rate(beta, eta, tip, change.tip, change) / motion.near_moment - cot
    far = -moment_rate(beta, eta, turn, d_turn, change) / motion.far_moment - cot
    ratio = change_of_ratio(beta, eta, motion, change, loads / motion.far_moment)
    product = sqrt(motion.near) * sqrt(motion.far)
    d_product = product * (near + far) / 2
    wide = 1 + cosine * cosine
    excess = -(2 * beta * cos_middle * cosine + eta * double_cos * wide)
    d_excess = 2 * (beta * cos_middle + eta * double_cos * cosine) * sine * d_half
    d_excess = d_excess + 2 * (beta * sin_middle * cosine + eta * double_sin * wide) * d_middle
    d_excess = d_excess - 2 * cos_middle * cosine * change.beta - double_cos * wide * change.eta
    square = 4 * motion.middle * motion.middle
    if excess >= 0:
        return Numbers((ratio, (near + far) / 4, (d_product + d_excess) / (2 * square), d_turn))
    mean = -(2 * beta * cos_middle + eta * cosine * double_cos)
    d_mean = 2 * (beta * sin_middle + eta * cosine * double_sin) * d_middle + eta * sine * double_cos * d_half
    d_mean = d_mean - 2 * cos_middle * change.beta - cosine * double_cos * change.eta
    below = product - excess
    # 4·middle² = sin²D (mean − η)(mean + η)/below, in which mean − η is told by the rest.
    apart = square * below / (sine * sine * (mean + eta))
    logarithm = 2 * cot + (d_mean - change.eta) / apart + (d_mean + change.eta) / (mean + eta)
    logarithm = logarithm - (d_product - d_excess) / below
    return Numbers((ratio, (near + far) / 4, logarithm / 2, d_turn))


def sine_part(a, b, square, rest, arrival):
    """∫sin²ψ/√(a² cos²ψ + b² sin²ψ) over the same range as ``arrival``, the integral without sin²ψ.

    ``second_kind`` over b² − a², which is taken out of each of its terms: aₖ₊₁² − bₖ₊₁² = (aₖ − bₖ)²/4.
    """
    limit, more, weight, total = 2 * (2.0**-52) ** 0.5, True, 1, 0
    while more:
        more = abs(a - b) > limit * a
        delta = sqrt(a * a * rest + b * b * square)
        total = total + weight * (arrival / 2 - sqrt(square * rest) / (a + delta))
        sum_, below = a + b, a + delta
        inner = a + (a * a + b * b * square) / (delta + b * square)
        scale = below * below
        weight = weight * (a - b) / (2 * sum_)
        square, rest = sum_ * sum_ * square / scale, 2 * a * rest * inner / scale
        a, b = sum_ / 2, sqrt(a * b)
    return total


def rates_of_times(beta, eta, motion, phase, swing, arrival, change):
    """Derivatives of half-swing and first arrival along a change of tip angle and loads; the clamp angle stays.

    phase, swing, arrival: of the motion.

    dI = −(S + X) dlog a − (C − X) dlog b + dψ/Δ for I = ∫dψ/Δ, Δ² = a² cos²ψ + b² sin²ψ, with S = ∫sin²ψ/Δ,
    C = ∫cos²ψ/Δ and X = sin ψ cos ψ/Δ (DLMF 19.4(i), there for E, F and k).
    """
    numbers = changes_of_numbers(beta, eta, motion, change)
    a, b = motion.end, motion.middle
    square, rest = phase.square, phase.rest
    all_sine, sine = sine_part(a / 2, b / 2, 1, 0, swing), sine_part(a / 2, b / 2, square, rest, arrival)
    speed = sqrt(a * a * rest + b * b * square) / 2
    across = sqrt(square * rest)
    # ψ moves against χ: sin²ψ = a(1 − cos χ)/(a + Δ_χ). Δ_χ − a cos χ without cancellation:
    forth = (a + phase.delta) * rest
    done, left = sqrt(motion.far) * motion.done_sine, sqrt(motion.near) * motion.left_sine
    sine_chi = 2 * sqrt(done * left) / phase.whole
    first = forth >= phase.delta
    behind = b * sine_chi * (b * sine_chi) / (forth if first else 1) if first else 2 * phase.delta - forth
    moved = across * behind * (numbers.end - numbers.middle) / (2 * phase.delta * speed)
    near_cot = cos(motion.done / 2) / motion.done_sine * change.tip
    far_cot = cos(motion.left / 2) / motion.left_sine * numbers.turn
    clamped = sine_chi * (numbers.ratio - near_cot - far_cot) / (4 * phase.delta)
    edge = across / speed
    swing_rate = -all_sine * numbers.end - (swing - all_sine) * numbers.middle
    arrival_rate = -(sine + edge) * numbers.end - (arrival - sine - edge) * numbers.middle + moved + clamped
    return swing_rate, arrival_rate


def rates_of_sample(rod, item, change):
    """The derivatives of half-swing and first arrival of a sample, but for the lengths for which it stays anywhere."""
    swing, arrival = item.regular
    motion = item.stay.motion
    return rates_of_times(rod.beta, rod.eta, motion, item.phase, swing, arrival, change)


class Change(Record):
    """The change of the tip angle and of the loads, along which a derivative is taken."""

    __slots__ = ()

    tip: float
    beta: float
    eta: float


def probe(rod, piece, ends, place):
    """The times at a place and their derivatives; in the deep, these are the delays."""
    item = sample_at(rod.beta, rod.eta, piece, ends, place)
    delay = ends[place >= 0]
    if abs(place) >= delay.deepest:
        side = -1 if place < 0 else 1
        rates = side * (delay.tip + delay.middle + delay.far), side * delay.arrival
        return Probe((place, item.swing, item.arrival, *rates))
    share = piece.width / ((1 + exp(place)) * (1 + exp(-place)))
    rates = rates_of_sample(rod, item, Change((share, 0, 0)))
    return Probe((place, item.swing, item.arrival, *rates))


def dense(sample, samples, length):
    """More samples where the trapezoidal rule for the derivatives misses the difference of the lengths."""
    done, todo = [samples[0]], samples[:0:-1]
    while todo:
        before, after = done[-1], todo[-1]
        width = after.place - before.place
        swing = after.swing - before.swing - width * (after.swing_rate + before.swing_rate) / 2
        arrival = after.arrival - before.arrival - width * (after.arrival_rate + before.arrival_rate) / 2
        least = min(before.swing, after.swing)
        miss = abs(arrival) + (length / least * abs(swing) if length > least else 0)
        out_of_reach = min(before.arrival, after.arrival) - abs(arrival) > (1 + WINDOW) * length
        if width > FINEST and miss > ROUGH * length and not out_of_reach:
            todo.append(sample((before.place + after.place) / 2))
        else:
            done.append(todo.pop())
    return done


def branches_near(samples, length):
    """(sign, swings) of every branch that is somewhere about as long as the rod."""
    shortest = min(item.swing for item in samples)
    last = ceil((1 + WINDOW) * length / (2 * shortest)) + 1
    return [(sign, swings) for sign in (1, -1) for swings in range(0 if sign > 0 else 1, last + 1)]


def rate(item, sign, swings):
    """The derivative of the length of a branch by the place; 0 where it is within rounding of it."""
    value = (2 * swings * item.swing_rate if swings else 0) + sign * item.arrival_rate
    return value if abs(value) > 64 * 2.0**-52 * (2 * swings * item.swing + item.arrival) else 0


def branch_length(item, sign, swings):
    """The length of a branch."""
    return (2 * swings * item.swing if swings else 0) + sign * item.arrival


def near(before, after, sign, swings, length):
    """Whether one of two neighbours is about as long as the rod."""
    return any(abs(branch_length(item, sign, swings) / length - 1) < WINDOW for item in (before, after))


def twice(sample, triple, values, sign, swings):
    """The two sign changes beside the middle one of three samples, where the derivative may go beyond zero."""
    before, here, after = (abs(value) for value in values)
    facing = values[1] > 0
    if (values[2] > 0) != facing or not (here < before and here < after) or here > max(before - here, after - here):
        return []

    def short(item):
        value = rate(item, sign, swings)
        return value if facing else -value

    best = dip(sample, short, *triple)
    return [(triple[0], best), (best, triple[2])] if short(best) < 0 else []


def brackets_of(sample, samples, sign, swings, length):
    """Pairs of samples between which the derivative changes sign, in the order of places."""
    seen = [item for item in samples if rate(item, sign, swings) != 0]
    values = [rate(item, sign, swings) for item in seen]
    found = []
    for k in range(1, len(seen)):
        if (values[k] > 0) != (values[k - 1] > 0):
            found.append((seen[k - 1], seen[k]))
        elif k + 1 < len(seen) and near(seen[k], seen[k], sign, swings, length):
            found += twice(sample, seen[k - 1 : k + 2], values[k - 1 : k + 2], sign, swings)
    return found


def slope_at(rod, piece, place, sign, swings, change):
    """The derivative of the length of a branch by the loads, over the rod's length."""
    item = sample_at(rod.beta, rod.eta, piece, delays(piece), place)
    swing, arrival = rates_of_sample(rod, item, change)
    return ((2 * swings * swing if swings else 0) + sign * arrival) / rod.length


def mark_at(rod, turns, piece, sample, key, sign, swings, before, after):
    """The extremum between two samples, to rounding of the place."""

    def function(place):
        item = sample(place)
        return (2 * swings * item.swing_rate if swings else 0) + sign * item.arrival_rate

    ends = before.place, after.place
    place = bracketed_root(function, ends, [function(end) for end in ends], 0)
    height = branch_length(sample(place), sign, swings) / rod.length - 1
    slope = slope_at(rod, piece, place, sign, swings, Change((0, 0, 1)))
    return Mark((key, (rod.side, sign, swings, key[-1]), place, place, height, slope, rod, turns, piece))


def marks_on(rod, turns, piece, where, wanted):
    """The extrema of the branches on a piece."""
    ends = delays(piece)

    def sample(place):
        return probe(rod, piece, ends, place)

    def too_low(place):
        return least_arrival(rod.beta, rod.eta, piece, *about(piece, place)) > (1 + WINDOW) * rod.length

    if too_low(inf):
        return
    places = grid(rod.beta, rod.eta, rod.length, piece)
    while len(places) > 2 and too_low(places[1]):
        places = places[1:]
    samples = dense(sample, [sample(place) for place in places], rod.length)
    branches = branches_near(samples, rod.length) if wanted is None else [wanted[len(where) : len(where) + 2]]
    for sign, swings in branches:
        for before, after in brackets_of(sample, samples, sign, swings, rod.length):
            top = rate(before, sign, swings) > 0
            key = (*where, sign, swings, top)
            if (wanted is None or key == wanted) and near(before, after, sign, swings, rod.length):
                yield mark_at(rod, turns, piece, sample, key, sign, swings, before, after)


def marks(sides, wanted=None):
    """The extrema of all branches of a rod, given from both sides, by key; or only those of the key wanted."""

    found: dict[tuple, list[Mark]] = {}
    for rod in sides:
        stiff = rod.length * rod.length * (rod.beta + rod.eta) < 2  # nothing meets below (π/2)²
        if stiff or (wanted is not None and wanted[0] != rod.side):
            continue
        scene = landscape(rod.beta, rod.eta)
        clamp = clamp_in(scene.rests, rod.clamp_angle)
        ground = ground_of(rod.eta, scene, clamp, ridge_of(rod.beta, rod.eta, scene))
        for number, piece in enumerate(pieces(ground)):
            where = (rod.side, number, piece.low_kind, piece.high_kind, piece.basin.passes)
            if wanted is None or wanted[: len(where)] == where:
                for mark in marks_on(rod, clamp.turns, piece, where, wanted):
                    found.setdefault(mark.key, []).append(mark)
    return found


def both_sides(beta, eta, length, clamp_angle, scale):
    """The rod, and its mirror image."""
    return Rod((beta, eta, length, clamp_angle, 1, scale)), Rod((beta, eta, length, -clamp_angle, -1, scale))


class Row(Record):
    """What is at a place of the parameter: by key, lists of records in the order of their spots.

    A record has a spot, by which it is told from others of its key, a group, which it keeps if it goes over to
    another key, and a height.
    """

    __slots__ = ()

    place: float
    values: dict


def share(low, high, origin):
    """The width of an interval, as a share of the parameter."""
    return (high.place - low.place) / (high.place - origin)


def matched(low, high):
    """(key, record, record) for what is on both sides: the nearest spots of a key, in their order."""
    found = []
    for key, here in low.values.items():
        there, first = high.values.get(key, []), 0
        turned = len(here) > len(there)
        few, many = (there, here) if turned else (here, there)
        for k, record in enumerate(few):
            last = len(many) - (len(few) - k) + 1
            best = min(range(first, last), key=lambda j: abs(many[j].spot - record.spot))
            first = best + 1
            if abs(many[best].spot - record.spot) < FURTHEST:
                found.append((key, many[best], record) if turned else (key, record, many[best]))
    return found


def lonely(low, high):
    """The records that are in the first row only, and in the second one only."""
    pairs = matched(low, high)
    kept = {id(record) for _, before, after in pairs for record in (before, after)}
    return [[item for items in row.values.values() for item in items if id(item) not in kept] for row in (low, high)]


def follow(values_at, places, origin, least):
    """Rows so dense that the same records are on both sides, or the interval is negligible."""
    rows = [Row((places[0], values_at(places[0], None)))]
    todo = [Row((place, values_at(place, None))) for place in places[:0:-1]]
    while todo:
        low, high = rows[-1], todo[-1]
        wide = share(low, high, origin)
        alone = [record for records in lonely(low, high) for record in records]
        if wide > least and any(abs(record.height) < 2 * sqrt(wide) for record in alone):
            middle = (low.place + high.place) / 2
            todo.append(Row((middle, values_at(middle, None))))
        else:
            rows.append(todo.pop())
    return rows


class Bracket(Record):
    """Places between which the height of a record changes sign, and the record on either side."""

    __slots__ = ()

    key: tuple
    low: float
    high: float
    before: Any
    after: Any


def changes(low, high):
    """The changes of sign between two rows."""
    return [
        Bracket((key, low.place, high.place, before, after))
        for key, before, after in matched(low, high)
        if before.height != 0 and (before.height < 0) != (after.height < 0)
    ]


def leaps(low, high):
    """The changes of sign of what goes over from one key to another within a negligible interval."""
    found = []
    first, second = lonely(low, high)
    for item in first:
        for other in second:
            small = abs(item.height) < LEAP and abs(other.height) < LEAP
            if small and item.group == other.group and item.height != 0 and (item.height < 0) != (other.height < 0):
                found.append(item if abs(item.height) < abs(other.height) else other)
    return found


def nearest(values, key, spot):
    """The record of a key that is nearest to a spot; None if there is none."""
    return min(values.get(key, []), key=lambda record: abs(record.spot - spot), default=None)


def lowest(values_at, triple, key, spot, side):
    """Where side·height is least, or first found below zero, and the record there."""

    def sample(place):
        return Row((place, values_at(place, key)))

    def short(row):
        record = nearest(row.values, key, spot)
        return inf if record is None else side * record.height

    best = dip(sample, short, *triple)
    return best.place, nearest(best.values, key, spot)


def touched(values_at, triple):
    """The changes of sign beside an extremum in the parameter that goes beyond zero between three rows."""
    low, middle, high = triple
    found = []
    later = {id(record): after for _, record, after in matched(middle, high)}
    for key, before, record in matched(low, middle):
        after = later.get(id(record))
        if after is None:
            continue
        side = 1 if record.height > 0 else -1
        left, here, right = side * before.height, side * record.height, side * after.height
        if not (0 < here < left and here < right) or here > max(left - here, right - here):
            continue
        place, best = lowest(values_at, triple, key, record.spot, side)
        if best is not None and side * best.height < 0:
            found.append(Bracket((key, low.place, place, before, best)))
            found.append(Bracket((key, place, high.place, best, after)))
    return found


def root(values_at, bracket):
    """The record where its height vanishes; None if it does not, for the record is not there all the way."""
    key, low, high, before, after = bracket

    def record_at(place):
        spot = before.spot + (place - low) / (high - low) * (after.spot - before.spot)
        return nearest(values_at(place, key), key, spot)

    def function(place):
        record = record_at(place)
        return before.height if record is None else record.height

    record = record_at(bracketed_root(function, (low, high), (before.height, after.height), 0))
    return record if record is not None and abs(record.height) < LEAP else None


def zeros(values_at, places, origin, least):
    """The records, each at the place of the parameter where its height vanishes.

    values_at(place, key): the records by key, at least those of this key unless it is None. origin: the place from
    which widths are measured.
    """
    rows = follow(values_at, places, origin, least)
    found, crossed = [], []
    for low, high in pairwise(rows):
        crossed += changes(low, high)
        if share(low, high, origin) <= least:
            found += leaps(low, high)
    for triple in zip(rows, rows[1:], rows[2:], strict=False):
        crossed += touched(values_at, triple)
    found += [record for record in (root(values_at, bracket) for bracket in crossed) if record is not None]
    return found


def rod_of(mark):
    """The equilibrium of an extremum."""
    _, sign, swings, _ = mark.group
    index = 2 * swings - (1 if sign < 0 else 0)
    rod, piece = mark.rod, mark.piece
    sample = sample_at(rod.beta, rod.eta, piece, delays(piece), mark.place)
    return bent_rod(rod, mark.turns, piece, Crossing((sample, swings, sign, True)), index)


def fold_of(mark):
    """The fold of an extremum whose length is the rod's."""
    rod, top = mark.rod, mark.group[-1]
    found = rod_of(mark)
    change = 2 if (mark.slope > 0) == top else -2
    eta = ldexp(rod.eta, 2 * rod.scale)
    return Fold((eta, found.tip_angle, found.clamp_curvature, found.y, found.z, found.index, change, "fold"))


def sharpened(at, mark):
    """The extremum where its length is the rod's, by Newton's method: η then has no error of its own.

    A step squares the error, so after one below the root of rounding there is none left; but not the first, for the
    extremum may have been found in few digits.
    """
    mark = nearest(at(mark.rod.eta, mark.key), mark.key, mark.spot) or mark
    step, least = inf, sqrt(2.0**-52) * (mark.rod.beta + mark.rod.eta)
    while abs(step) > least:
        last, step = step, mark.height / mark.slope
        if 2 * abs(step) > abs(last):  # beside an exchange there is no slope to tell more
            return mark
        mark = nearest(at(mark.rod.eta - step, mark.key), mark.key, mark.spot) or mark
    return mark


def straight_at(beta, eta, clamp_angle):
    """The direction without moment that is the clamp angle; None if there is none."""
    rests = landscape(beta, eta).rests
    offsets = clamp_in(rests, clamp_angle).offsets
    return next((rest for rest, offset in zip(rests, offsets, strict=True) if offset == 0), None)


def pitchforks(beta, length, clamp_angle, scale, places):
    """Where the rod that stays straight buckles: ℓ√(−dθ″/dθ) is an odd number of quarter turns.

    The clamp angle is without moment for every η only where the rod is symmetric about it, and then the bent rods
    come in pairs. Near it u″ = (B + C)u − (B + 4C)u³/6 + (B + 16C)u⁵/120 with B = β cos θ₀, C = η cos 2(θ₀ − α): the
    signs say whether the half-swing grows with the amplitude.
    """
    some = places[0], places[len(places) // 2], places[-1]
    rests = [straight_at(beta, eta, clamp_angle) for eta in some]
    if any(rest is None for rest in rests):
        return []
    cosine, sine = direction(rests[-1])
    force, facing = beta * cosine, 1 if rests[-1].double_cosine > 0 else -1
    found, index = [], 0
    while index <= length * sqrt(beta + places[-1]) / pi:
        wave = (index + 0.5) * pi / length
        eta = -facing * (wave * wave + force)
        if places[0] <= eta <= places[-1]:
            cubic = force + 4 * facing * eta
            softening = cubic < 0 if cubic != 0 else force + 16 * facing * eta > 0
            change = 2 if softening == (facing < 0) else -2
            extent = ldexp(length, -scale)
            at = (clamp_angle, 0 * extent, cosine * extent, sine * extent)
            found.append(Fold((ldexp(eta, 2 * scale), *at, index, change, "pitchfork")))
        index += 1
    return found


def all_folds(beta, length, clamp_angle, low, high):
    """Every fold with η in [low, high], sorted by η and tip angle."""
    scale = frexp(beta + high)[1] // 2
    beta, length = ldexp(beta, -2 * scale), ldexp(length, scale)
    places = steps(beta, beta, length, ldexp(low, -2 * scale), ldexp(high, -2 * scale))
    if not places:
        return []

    def at(eta, key):
        return marks(both_sides(beta, eta, length, clamp_angle, scale), key)

    rough = roughly(lambda: zeros(at, places, -beta, LEAST))
    found = [fold_of(sharpened(at, mark)) for mark in rough]
    found += pitchforks(beta, length, clamp_angle, scale, places)
    return sorted(found, key=lambda item: (item.eta, item.tip_angle))


def level_point(at, name, low, high, before, after):
    """The extremum between two rows at which the length is stationary in η; None if it is not there all the way."""

    def mark_at(eta):
        spot = before.spot + (eta - low) / (high - low) * (after.spot - before.spot)
        return nearest(at(eta, name), name, spot)

    def function(eta):
        mark = mark_at(eta)
        return before.slope if mark is None else mark.slope

    return mark_at(bracketed_root(function, (low, high), (before.slope, after.slope), 0))


def stationary(at, places, origin, key):
    """The extrema of branches whose length is stationary in η too, by key; or only those of the key wanted."""

    def near(eta, _):
        return at(eta, None if key is None else key[:-1])

    rows = follow(near, places, origin, CLOSE)
    found: dict[tuple, list[Mark]] = {}
    for low, high in pairwise(rows):
        for name, before, after in matched(low, high):
            top = before.slope > 0
            if top != (after.slope > 0) and (key is None or key[-1] == top):
                best = level_point(at, name, low.place, high.place, before, after)
                if best is not None:
                    found.setdefault((*name, top), []).append(
                        best._replace(key=(*name, top), group=(*best.group, top), spot=best.rod.eta)
                    )
    return found


def forces(low, high, length, field):
    """The β to look at first, each larger than the last by the same share of β and the largest field.

    As long as ℓ²(β + η) < (π/2)² nothing meets.
    """
    first = pi / 2 / length
    start = max(low, first * first - field)
    ratio = (high + field) / (start + field)
    count = ceil(FORCES * log(ratio)) + 3
    inner = [(start + field) * ratio ** (k / count) - field for k in range(1, count)]
    return [start, *(beta for beta in inner if start < beta < high), high]


def exchange_of(at, mark):
    """The exchange of a doubly stationary length that is the rod's; a step of Newton's method sharpens β."""
    _, sign, swings, top, over = mark.group
    slope = slope_at(mark.rod, mark.piece, mark.place, sign, swings, Change((0, 1, 0)))
    mark = nearest(at(mark.rod.beta - mark.height / slope, mark.key), mark.key, mark.spot) or mark
    rod, found = mark.rod, rod_of(mark._replace(group=mark.group[:-1]))
    loads = ldexp(rod.beta, 2 * rod.scale), ldexp(rod.eta, 2 * rod.scale)
    kind = "isolated" if top == over else "exchange"
    return Exchange((*loads, found.tip_angle, found.clamp_curvature, found.y, found.z, found.index, kind))


def all_exchanges(length, clamp_angle, low_beta, high_beta, low, high):
    """Every point with β and η in these ranges at which two folds meet, sorted by β and η."""
    scale = frexp(high_beta + high)[1] // 2
    low_beta, high_beta, low, high = (ldexp(load, -2 * scale) for load in (low_beta, high_beta, low, high))
    length = ldexp(length, scale)
    places = steps(low_beta, high_beta, length, low, high)
    if not places:
        return []

    def at(beta, key):
        def extrema(eta, kept):
            return marks(both_sides(beta, eta, length, clamp_angle, scale), kept)

        return stationary(extrema, places, -beta, key)

    loads = forces(low_beta, high_beta, length, high)
    found = [exchange_of(at, mark) for mark in zeros(at, loads, -high, CLOSE)]
    return sorted(found, key=lambda item: (item.beta, item.eta))


# Interface


class Equilibrium(Record):
    """One equilibrium of a rod.

    tip_angle: θ(ℓ), continuous from θ(0) = clamp_angle, not wrapped. clamp_curvature: θ′(0). gamma: constant of
    the first integral. y, z: position of the tip. energy: ∫(½θ′² − ½η(d₃·e)²)ds − β·y, in units of EI. index:
    number of negative directions of the second variation; 0 means stable.
    rod: the rod it is an equilibrium of.
    swing: its half-swing, None if it is straight.
    """

    __slots__ = ()

    tip_angle: float
    clamp_curvature: float
    gamma: float
    y: float
    z: float
    energy: float
    index: int  # type: ignore[assignment]  # in the place of tuple.index
    rod: Rod
    swing: Swing | None


def equilibria(beta, eta, length, clamp_angle, *, max_index=None) -> list[Equilibrium]:
    """All equilibria of one rod, sorted by tip angle.

    beta: terminal force over bending stiffness, F/(EI) ≥ 0.
    eta: magnetic modulus over bending stiffness, η̃/(EI) ≥ 0.
    length: length of the rod, > 0.
    clamp_angle: θ(0), the angle from the y axis to the tangent at the clamp, in radians.
    max_index: the largest index that is wanted, 0 for stable equilibria only; None for all.

    All in one unit of length. Raises TypeError or ValueError, naming the argument, before any work.
    """
    beta, eta, length = not_negative("beta", beta), not_negative("eta", eta), positive("length", length)
    clamp_angle = within_turns("clamp_angle", clamp_angle)
    limit = index_limit(max_index)
    must_have_answer(beta, eta, length, limit)
    return all_equilibria(beta, eta, length, clamp_angle, limit)


class Shape(Record):
    """A rod at the arc lengths asked for: theta (from y to the tangent), curvature θ′, and the position y, z."""

    __slots__ = ()

    theta: Any
    curvature: Any
    y: Any
    z: Any


def on_rod(equilibrium, s):
    """The arc lengths as doubles; TypeError or ValueError if the first is no equilibrium, or an s not on its rod."""
    if not isinstance(equilibrium, Equilibrium):
        raise TypeError(f"equilibrium must be one that equilibria gives, got {equilibrium!r}")
    places, length = all_real("s", s), length_of(equilibrium.rod)
    # Two numbers tell of all: arrays of truth values cost as much as some of the work.
    if places.size and not 0 <= np.min(places) <= np.max(places) <= length:
        refuse("s", places, (places < 0) | (places > length), f"must lie in [0, {length!r}], the rod")
    return places


def shape(equilibrium: Equilibrium, s, *, position=True) -> Shape:
    """The shape of an equilibrium at arc lengths s from the clamp, a number or an array within [0, length].

    position: whether y and z are wanted; without them they are None, and θ takes a fraction of the time.

    theta, curvature, y and z have the shape of s. Raises TypeError or ValueError where an s is not on the rod.
    """
    found = shape_at(equilibrium, on_rod(equilibrium, s), position)
    return Shape(part if part is None else part[()] for part in found)


class Sweep(Record):
    """The equilibria of many rods, flat: case[k] is the index of the rod (in the order of the broadcast arrays)."""

    __slots__ = ()

    case: Any
    tip_angle: Any
    clamp_curvature: Any
    gamma: Any
    y: Any
    z: Any
    energy: Any
    index: Any


def sweep(beta, eta, length, clamp_angle, *, max_index=None) -> Sweep:
    """All equilibria of many rods: the arguments are numbers or arrays, broadcast against one another.

    max_index: the largest index that is wanted, 0 for stable equilibria only; None for all.

    Raises TypeError or ValueError, naming the argument and the flat index of a bad value, before any work.
    """
    beta, eta, length = all_not_negative("beta", beta), all_not_negative("eta", eta), all_positive("length", length)
    clamp_angle = all_within_turns("clamp_angle", clamp_angle)
    grid, limit = common_shape(Given((beta, eta, length, clamp_angle))), index_limit(max_index)
    all_must_have_answers(beta, eta, length, grid, limit)
    found = sweep_arrays(beta, eta, length, clamp_angle, grid, limit)
    return Sweep(
        (found.case, found.tip_angle, found.clamp_curvature, found.gamma, found.y, found.z, found.energy, found.index)
    )


class Fold(Record):
    """Two equilibria meet, at this η, and vanish on one side of it.

    tip_angle, clamp_curvature, y, z: of the rod there. index: the lower of the two indices that meet; the other one is
    index + 1. change: the number of equilibria just above this η less that just below: 2 or −2. kind: 'fold', or
    'pitchfork' where the two that vanish meet a third one, the straight rod.
    """

    __slots__ = ()

    eta: float
    tip_angle: float
    clamp_curvature: float
    y: float
    z: float
    index: int  # type: ignore[assignment]  # in the place of tuple.index
    change: int
    kind: str


def folds(beta, length, clamp_angle, *, eta) -> list[Fold]:
    """Where equilibria of a rod meet and vanish as the field grows: every fold with η in a range, sorted by η.

    beta: terminal force over bending stiffness, F/(EI) ≥ 0.
    length: length of the rod, > 0.
    clamp_angle: θ(0), the angle from the y axis to the tangent at the clamp, in radians.
    ``eta``: the range (low, high) of the magnetic modulus over bending stiffness, 0 ≤ low < high.

    All in one unit of length. Raises TypeError or ValueError, naming the argument, before any work.
    """
    beta, length = not_negative("beta", beta), positive("length", length)
    clamp_angle = within_turns("clamp_angle", clamp_angle)
    low, high = span("eta", eta)
    must_be_searchable(beta, high, length, FOLDS_SLOWEST)
    return all_folds(beta, length, clamp_angle, low, high)


class Exchange(Record):
    """At this β and η the two folds of a diagram over η meet: it changes its aspect as β goes by.

    With F = θ(0) − clamp angle as a function of the tip angle φ and of η: F = ∂F/∂φ = ∂F/∂η = 0. kind: 'exchange',
    where two branches cross (F has a saddle) and their halves are joined otherwise on either side of β; 'isolated',
    where a closed branch shrinks to a point and vanishes (F has an extremum). tip_angle, clamp_curvature, y, z: of
    the rod there. index: the lower of the two indices that meet.
    """

    __slots__ = ()

    beta: float
    eta: float
    tip_angle: float
    clamp_curvature: float
    y: float
    z: float
    index: int  # type: ignore[assignment]  # in the place of tuple.index
    kind: str


def exchanges(length, clamp_angle, *, beta, eta) -> list[Exchange]:
    """Where two folds meet as the force grows: the diagram over η changes there. Those in a range, sorted by β and η.

    length: length of the rod, > 0.
    clamp_angle: θ(0), the angle from the y axis to the tangent at the clamp, in radians.
    ``beta``, ``eta``: the ranges (low, high) of terminal force and magnetic modulus over bending stiffness,
    0 ≤ low < high.

    All in one unit of length. Raises TypeError or ValueError, naming the argument, before any work.
    """
    length = positive("length", length)
    clamp_angle = within_turns("clamp_angle", clamp_angle)
    (low_beta, high_beta), (low, high) = span("beta", beta), span("eta", eta)
    must_be_searchable(high_beta, high, length, EXCHANGES_SLOWEST)
    return all_exchanges(length, clamp_angle, low_beta, high_beta, low, high)
