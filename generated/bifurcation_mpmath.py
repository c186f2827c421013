"""Bifurcations of a rod of length 80, clamped at 3π/4 to the force: mpmath, any precision.

Emitted by `derive emit` from the scene 'bifurcation': do not edit, change the scene, the theory or the kernels.

Gives: equilibria, sweep, folds, exchanges.
Load case: parallel. Valid for beta >= 0, eta >= 0.
Constants folded: length = 80, clamp_angle = 3*pi/4.
Formulas, each proved equal to its derivation:
    arc_kink (DLMF 19.29(ii)), arc_kink_tip, arc_square (DLMF 19.29(ii)), arc_y (exsl36), arc_z (exsl41),
    chi_square (DLMF 4.21(iii)), far_pair_root, far_root, gauss_gap (DLMF 19.8(i)), gauss_less (DLMF 19.8(iii)),
    gauss_rest (DLMF 19.8(iii)), gauss_square (DLMF 19.8(iii)), half_rest (DLMF 22.6(iii)),
    half_rest_beyond (DLMF 22.6(iii)), half_square (DLMF 22.6(iii)), half_square_beyond (DLMF 22.6(iii)),
    lag_step (DLMF 19.8(iii)), landen_less (DLMF 19.8(ii)), landen_root (DLMF 19.2.4),
    landen_tangent (DLMF 19.8(ii)), others_product, others_sum, pair_lift, pair_root,
    pair_root_sum (DLMF 19.26(iii)), phase_bend (DLMF 19.8(iii)), phase_lead, phase_rate (DLMF 19.2.4), phase_sum,
    point_near, point_pole (exsl22), rest_fall, rest_moment, rest_stiffness, rj_delta_imag (DLMF 19.26(iii)),
    rj_delta_real (DLMF 19.26(iii)), shot_bend, stiffness_beside, strength (exsl17),
    tangent_exchanged (DLMF 22.17(i)), tip_cubic, turn_speed (exsl8), w_imag (DLMF 19.29(ii)),
    w_real (DLMF 19.29(ii))
Digest of the inputs: sha256 a7c4892110b61f3743679b19032b8a1dada9e1995bfc3081999af78f8ede2cd3
"""

from __future__ import annotations

from collections import namedtuple
from collections.abc import Iterable
from itertools import pairwise
from operator import index
from typing import Any

from mpmath import (
    asin,
    asinh,
    atan,
    atan2,
    cos,
    eps,
    exp,
    frexp,
    hypot,
    inf,
    isfinite,
    ldexp,
    log,
    mp,
    mpc,
    mpf,
    nstr,
    pi,
    sin,
    sqrt,
    workdps,
)
from mpmath import ceil as mpf_ceil
from mpmath import floor as mpf_floor

__all__ = ["Equilibrium", "Exchange", "Fold", "Sweep", "equilibria", "exchanges", "folds", "sweep"]

# Constants

FEWEST = 15  # decimal digits
MOST = 1000
LARGEST = inf  # its numbers have no largest one
MANY = 10_000  # equilibria of one rod: a minute or two in few digits
DEEP = 30  # places beyond which tips are told by other means
WITHIN = 2  # spacings of the length to which time maps are right
TRIES = 24
NEAR = 0.5  # how far a tip may be from where it was aimed, as a difference of places
FOLDS_SLOWEST = 1000  # ℓ√(β + η) to which folds are searched for: hundreds of them, in minutes
WINDOW = 0.5
ROUGH_DIGITS = 20  # with which folds are found; Newton's method doubles them
FURTHEST = 3
EXCHANGES_SLOWEST = 100  # the same for exchanges, a search for folds at each of many forces
FORCES = 20  # forces in a range by whose ends loads differ by a factor e


# Special functions


def in_a_line(value):
    """The text of a value for an error, which is one line."""
    return " ".join(repr(value).split())


def real(name, value):
    """A finite real number as an mpf, from a number or its decimal text; TypeError or ValueError names the argument."""
    numeric = getattr(getattr(value, "dtype", None), "kind", "f") in "fiu" and not getattr(value, "ndim", 0)
    try:
        # A pair would be a mantissa with its exponent; NumPy's numbers are Python's by ``item``.
        if isinstance(value, (bool, bytes, complex, tuple)) or not numeric or hasattr(value, "mask"):
            raise TypeError(name)
        number = mpf(value.item() if hasattr(value, "dtype") else value)
    except (TypeError, ValueError, ZeroDivisionError):
        raise TypeError(f"{name} must be a real number, got {in_a_line(value)}") from None
    if not isfinite(number):
        raise ValueError(f"{name} must be finite, got {value!r}")
    return number


def epsilon():
    """The spacing of numbers just above 1."""
    return +eps


def floor(x):
    """The greatest integer that is not above x."""
    return int(mpf_floor(x))


def less_quarters(angle, quarters):
    """angle − quarters·π/2."""
    return angle - quarters * (pi / 2)


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
    return +eps


def deepest(width):
    """How far down, in the logarithm of the share of a width, the square of an offset is still a number: no limit."""
    return inf


def ceil(x):
    """The least integer that is not below x."""
    return int(mpf_ceil(x))


def arctan_share(z, end):
    """R_C(1, end) for complex end = 1 + z: arctan(√z)/√z (DLMF 19.2.18).

    By its series where z is small: there mpmath's complex arctangent is a difference of logarithms near 0.
    """
    if abs(z) < mpf("0.001"):
        total, power, n = 1, -z, 3
        while abs(power) > eps:
            total, power, n = total + power / n, -power * z, n + 2
        return total
    if abs(z) < 0.5:
        root = sqrt(z)
        return atan(root) / root
    root = sqrt(-z)
    return log((1 + root) * (1 + root) / end) / (2 * root)


def arc_excess(x):
    """x − sin x, by its series where x is small."""
    if x > 1:
        return x - sin(x)
    total, power, n = 0, x * x * x / 6, 3
    while abs(power) > eps * total:
        total, power, n = total + power, -power * x * x / ((n + 1) * (n + 2)), n + 2
    return total


def plus_quarters(angle, quarters):
    """angle + quarters·π/2."""
    return angle + quarters * (pi / 2)


def roughly(work):
    """What some work gives, where a few digits of it will do."""
    with workdps(min(ROUGH_DIGITS, mp.dps)):
        return work()


# Formulas, as derived


def shot_bend(beta, eta, growth):
    """a bound of |∂²θ(0)/∂θ(ℓ)²| for every tip, by cosh(ℓ√(β + η)) − 1: it solves G″ = (β + η)G + (β + 2η)cosh².

    Proved as swing.shot_bend.
    """
    return growth * (beta + 2 * eta) * (3 + growth) / (3 * beta + 3 * eta)


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

    beta: mpf
    eta: mpf
    length: mpf
    clamp_angle: mpf
    side: int
    scale: int


class Motion(Record):
    """A motion from rest at the tip through the clamp angle to rest at the far turning point, and back.

    With χ from 0 at the tip to π at the far turning point, dσ = dχ/√(end² cos²χ + middle² sin²χ).
    """

    __slots__ = ()

    tip: mpf  # the tip angle, in the turn of the landscape
    half_width: mpf
    done: mpf  # clamp − tip
    left: mpf  # far turning point − clamp
    near_moment: mpf  # θ″ at the tip
    far_moment: mpf  # −θ″ at the far turning point
    near: mpf  # 2θ″/sin(half_width) at the tip
    far: mpf  # the same at the far turning point
    end: mpf
    middle: mpf
    sine: mpf  # sin(half_width)
    half_cosine: mpf  # cos(half_width/2)
    uneven: mpf  # √far − √near
    done_sine: mpf  # sin(done/2)
    left_sine: mpf  # sin(left/2)


class Stay(Record):
    """A motion, and the lengths for which it stays near its tip, its middle, and its far turning point besides."""

    __slots__ = ()

    motion: Motion
    tip: mpf
    middle: mpf
    far: mpf
    arrival: mpf


class Heading(Record):
    """The tip's direction: cos and sin of φ, and of 2(φ − α)."""

    __slots__ = ()

    cosine: mpf
    sine: mpf
    double_cosine: mpf
    double_sine: mpf


class Arc(Record):
    """A stretch of rod from the tip, less what it would be if it were straight along the tip's direction.

    ∫cos θ, ∫sin θ and η∫cos²(θ − α), with cos θ − cos φ for cos θ and likewise.
    """

    __slots__ = ()

    y: mpf
    z: mpf
    square: mpf


class Swing(Record):
    """A half-swing of a bent rod, for its shape: how it was found, its length, and its arc. turns: of the clamp.

    heading: the tip's direction. total: the arc of the whole rod.

    The clamp lies on the half-swing after ``whole`` of them, at the length ``arrival`` from where the motion is as at
    the tip, of which ``regular`` is not straight, and at the phase ψ with sin²ψ = square and cos²ψ = rest.
    """

    __slots__ = ()

    stay: Stay
    turns: int
    length: mpf
    heading: Heading
    arc: Arc
    total: Arc
    middle_angle: mpf
    far_angle: mpf
    whole: int
    arrival: mpf
    regular: mpf
    square: mpf
    rest: mpf


def not_negative(name: str, value: object) -> mpf:
    """A real number ≥ 0, or an error that names the argument."""
    number = real(name, value)
    if number < 0:
        raise ValueError(f"{name} must not be negative, got {value!r}")
    return abs(number)  # no negative zero


def index_limit(max_index):
    """The largest index of equilibria that are wanted: None for no limit, or an integer ≥ 0."""
    if max_index is None:
        return None
    limit = integer("max_index", max_index)
    if limit < 0:
        raise ValueError(f"max_index must not be negative, got {max_index!r}")
    return min(limit, 2**53)


def too_large(beta, eta):
    """Whether γ, the energy or a place is too large: of numbers or of arrays."""
    load = beta + eta
    return (load > LARGEST) | (load * mpf(80) > LARGEST) | (mpf(80) / LARGEST > 1)


def briefly(number):
    """A number in a few digits."""
    return nstr(number, 3)


def refused(loads, why):
    """The error of a rod that is refused."""
    given = ", ".join(f"{name} = {briefly(value)}" for name, value in zip(loads._fields, loads, strict=True))
    return ValueError(f"{given}: {why}")


class Loads(Record):
    """What tells how long a rod is for its stiffness."""

    __slots__ = ()

    beta: Any
    eta: Any


def must_be_finite(beta, eta):
    """ValueError where γ, the energy or a place would be too large for a number."""
    if too_large(beta, eta):
        why = "γ, the energy or a place is too large for a double; choose another unit of length"
        raise refused(Loads((beta, eta)), why)


def too_many(beta, eta, most):
    """Whether more equilibria are wanted than are found at once: of numbers or of arrays.

    No index is more than ℓ√(β + η)/π by more than one (Sturm), and about two equilibria have the same.
    """
    half, least = MANY / 2, pi * MANY / 2
    return ((beta + eta) * mpf(80) * mpf(80) > least * least) & (most is None or most >= half)


def must_have_answer(beta, eta, most):
    """ValueError where numbers of the answer would be too large, or there are too many equilibria to find them all.

    most: the largest index that is wanted, or None for all.
    """
    must_be_finite(beta, eta)
    if too_many(beta, eta, most):
        slow = mpf(80) * sqrt(beta + eta)
        why = f"ℓ√(β + η) = {briefly(slow)}, so some {briefly(2 * slow / pi)} equilibria have indices up to half that"
        raise ValueError(f"max_index must be given here, and be less than {MANY // 2}: {why}")


def weak_rod(beta, eta):
    """The rod that is all but straight: θ″ is that of the clamp angle, to the square of rounding."""
    rod = Rod((beta, eta, mpf(80), 0.75 * pi, 1, 0))
    # Loads that are hardly numbers are numbers times the length.
    force, magnet = beta * mpf(80), eta * mpf(80)
    bend = force * sin(0.75 * pi) + magnet * sin(0.75 * pi) * cos(0.75 * pi)
    energy = -(force * cos(0.75 * pi) + magnet * cos(0.75 * pi) * cos(0.75 * pi) / 2)
    gamma = 2 * beta * cos(0.75 * pi) + eta * cos(0.75 * pi) * cos(0.75 * pi)
    y, z = mpf(80) * cos(0.75 * pi), mpf(80) * sin(0.75 * pi)
    return Equilibrium((0.75 * pi - bend * mpf(80) / 2, -bend, gamma, y, z, energy, 0, rod, None))


class Rest(Record):
    """A direction without moment: angle = quarters·π/2 + extra.

    stiffness: dθ″/dθ there, positive on a hill. double_cosine, double_sine: of 2(angle − α).
    """

    __slots__ = ()

    quarters: int
    extra: mpf
    angle: mpf
    stiffness: mpf
    double_cosine: mpf
    double_sine: mpf


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
    moment: mpf


def along(beta, quarters, sign):
    """A direction along or against the force, no field: what it is about the field is not asked."""
    return Rest((quarters, 0, quarters * (pi / 2), sign * beta, 1, 0))


def no_field(beta):
    """The force alone."""
    return Landscape(((along(beta, 0, 1), along(beta, 2, -1), along(beta, 4, 1)), False, True, None, 0.0))


def parallel_alone(eta):
    """The field without force: hills along and against it, wells across."""
    top, side, again = (Rest((quarters, 0, quarters * (pi / 2), eta, 1, 0)) for quarters in (0, 2, 4))
    first, second = (Rest((quarters, 0, quarters * (pi / 2), -eta, -1, 0)) for quarters in (1, 3))
    return Landscape(((top, first, side, second, again), True, True, None, 0.0))


def parallel_double(beta, eta):
    """The field along a weaker force: hills at 0 and, lower, at π."""
    top, again = (Rest((quarters, 0, quarters * (pi / 2), eta + beta, 1, 0)) for quarters in (0, 4))
    side = Rest((2, 0, pi, eta - beta, 1, 0))
    lean = atan2(beta, sqrt((eta - beta) * (eta + beta)))
    softness = (eta - beta) * (eta + beta) / eta
    cosine = 2 * (beta / eta) * (beta / eta) - 1
    sine = -2 * (beta / eta) * sqrt((eta - beta) * (eta + beta)) / eta
    first = Rest((1, lean, pi / 2 + lean, -softness, cosine, sine))
    second = Rest((3, -lean, 3 * (pi / 2) - lean, -softness, cosine, -sine))
    return Landscape(((top, first, side, second, again), False, True, None, 0.0))


def parallel_single(beta, eta):
    """The field along a force that is not weaker: one hill, at 0."""
    top, again = (Rest((quarters, 0, quarters * (pi / 2), eta + beta, 1, 0)) for quarters in (0, 4))
    return Landscape(((top, Rest((2, 0, pi, eta - beta, 1, 0)), again), False, True, None, 0.0))


def landscape(beta, eta):
    """Hills and wells for a field angle in (−π/2, π/2]."""
    if eta == 0:
        return no_field(beta)
    if beta == 0:
        return parallel_alone(eta)
    return parallel_double(beta, eta) if eta > beta else parallel_single(beta, eta)


def landscapes(beta, eta):
    """The landscape of a rod, and that of its mirror image."""
    scene = landscape(beta, eta)
    return scene, scene


def offset_from(rest, angle, turns):
    """angle − (rest + turns·2π), without cancellation; 0 where no angle within rounding of this tells them apart."""
    offset = less_quarters(angle, 4 * turns + rest.quarters) - rest.extra
    blur = epsilon() * (abs(angle) + abs(rest.extra))
    return pick((abs(offset) <= blur) | (abs(offset) < epsilon() ** 9), 0, offset)


def turn_to(start, end):
    """The angle from one direction without moment to another, however near they are to each other."""
    return (end.quarters - start.quarters) * (pi / 2) + (end.extra - start.extra)


class Clamp(Record):
    """The clamp angle in a landscape: whole turns, and its offset from each direction without moment."""

    __slots__ = ()

    turns: int
    offsets: tuple[mpf, ...]


def clamp_in(rests, angle):
    """Whole turns such that the clamp lies from the first hill up to, but not at, its like a turn on."""
    turns = floor((angle - rests[0].angle) / (2 * pi))
    for _ in range(3):
        offsets = tuple(offset_from(rest, angle, turns) for rest in rests)
        shift = pick(offsets[0] < 0, -1, pick(offsets[-1] >= 0, 1, 0))
        if not any_of(shift != 0):
            break
        turns = turns + shift
    # One that counts as a direction without moment is as far from the others as that is.
    for there, met in zip(rests, offsets, strict=True):
        if any_of(met == 0):
            apart = zip(rests, offsets, strict=True)
            offsets = tuple(pick(met == 0, turn_to(rest, there), offset) for rest, offset in apart)
    return Clamp((turns, offsets))


def mirrored_clamp(scene, other, clamp, mirrored):
    """The clamp seen from the other side of the y axis, in the landscape there; mirrored: the clamp angle there."""
    if clamp.offsets[0] > 0 and other.rests[0].angle == -scene.rests[0].angle:  # number by number the same
        return Clamp((-1 - clamp.turns, tuple([-offset for offset in clamp.offsets[::-1]])))
    return clamp_in(other.rests, mirrored)


def ridge_fall(beta, eta, hill, ridge):
    """V(hill) − V(ridge): the sine of half their distance times the slope of V between, as if it were a circle."""
    half, middle = (ridge.extra - hill.extra) / 2, pi / 2 + (hill.extra + ridge.extra) / 2
    return cos(half) * (2 * beta * sin(middle) - eta * sin(half) * sin(2 * middle))


class Ridge(Record):
    """A ridge that is lower than the hill; all are 0 where none is.

    drop: V(hill) − V(ridge). level: from the hill to the level of the ridge, depth: from there to the well; by_hill:
    level is told by the hill, depth by the well if not.
    """

    __slots__ = ()

    drop: mpf
    level: mpf
    depth: mpf
    by_hill: bool


def ridge_along(beta, eta, drop):
    """The ridge for a field along the force: with cos θ = 1 − 2β/η at its level, and −β/η at the well."""
    more, less, root = sqrt(eta + beta), eta - beta, sqrt(beta)
    level = 2 * atan2(root, sqrt(less))
    # tan of half the difference of the two.
    depth = 2 * atan2(eta * sqrt(less), (more + root) * (less + root * more))
    return Ridge((drop, level, depth, level < depth))


def ridge_at(beta, eta, drop):
    """The ridge that is lower by ``drop`` than the hill."""
    return ridge_along(beta, eta, drop)


def ridge_of(beta, eta, scene):
    """The ridge of a landscape, seen from its first hill."""
    drop = 0
    if len(scene.rests) != 3 and not scene.level:
        drop = ridge_fall(beta, eta, scene.rests[0], scene.rests[2])
    # A ridge lower by less than this would be passed only from within its square root of the hill.
    if drop <= epsilon() ** 17 * (beta + eta):
        return Ridge((0, 0, 0, True))
    return ridge_at(beta, eta, drop)


def miss_of(beta, eta, clamp_angle, slow):
    """The angle at arc length 0 of a motion from a tip, less the clamp angle: a function of the tip's offset from it.

    The rod's length is 1; slow: √(β + η).
    """
    # ℘ by its series on a part of the rod, and by as many doublings as make that the whole.
    doublings, share = 0, 1.0
    while slow * share > mpf("0.6"):
        doublings, share = doublings + 1, share / 2
    force, field, steps = beta * share * share, eta * share * share, range(doublings)

    def missed(offset):
        tip = clamp_angle + offset
        double = 2 * tip
        across, half = force * sin(tip), field / 2 * sin(double)
        along, p, quarter = force * cos(tip), across + half, (across - half) * (across + half) / 4
        c = (along + field * cos(double)) / 12
        square = c * c
        g2, g3 = 12 * square - quarter, (quarter - 8 * square) * c - along * p * p / 16
        a, b, fourth, twice = g2 / 20, g3 / 28, g2 / 4, 2 * g3
        value = (
            1
            + a * (1 + a * (mpf(1) / 3 + a * (mpf(2) / 39)) + b * (mpf(3) / 11 + a * (mpf(2) / 33)))
            + b * (1 + b / 13)
        )
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
    before, start, bound = -reach, function(-reach), (1 + mpf("0.02")) * sag
    places, values, todo = [before], [start], [(reach, function(reach)), (0, function(0))]
    while todo:
        place, value = todo[-1]
        width, both = place - before, value * start
        apart = abs(value - start) if both < 0 else abs(value + start) + 2 * sqrt(both)
        if apart > bound * width * width:
            places.append(place)
            values.append(value)
            before, start = todo.pop()
        elif width < 2.0 ** (-26) * reach:
            return None
        else:
            middle = place - width / 2
            todo.append((middle, function(middle)))
    return None if min(abs(value) for value in values) < mpf("1e-10") * reach else (places, values)


class Shot(Record):
    """A tip, by its offset from the clamp angle; rate: ∂θ(0)/∂θ(ℓ)."""

    __slots__ = ()

    offset: mpf
    rate: mpf


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
    if slow > mpf("1.4") * pi:
        return None
    beta, eta = beta * square, eta * square
    clamp = less_quarters(clamp_angle, 4 * floor(clamp_angle / (2 * pi) + 0.5))
    if abs(beta * sin(clamp) + eta / 2 * sin(2 * clamp)) < mpf("1e-09"):
        return None
    missed = miss_of(beta, eta, clamp, slow)
    # θ″ is nowhere more than β + η/2, and no motion is wider than a turn.
    reach = (1 + mpf("0.001")) * min((beta + eta / 2) / 2, 2 * pi)
    sag = shot_bend(beta, eta, (exp(slow / 2) - exp(-slow / 2)) ** 2 / 2) / 2
    samples = samples_apart(missed, reach, sag)
    return None if samples is None else zeros_between(missed, samples[0], samples[1], sag, mpf("4e-16") * reach)


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


class Ground(Record):
    """What the ranges of a rod are told by: its landscape, the clamp's offsets from its directions, and the ridge.

    drop, level, depth, by_hill: see ``Ridge``; height: V(ridge) − V(clamp), or 0 where no ridge is lower than the hill.
    """

    __slots__ = ()

    eta: mpf
    scene: Landscape
    at: tuple[mpf, ...]
    drop: mpf
    level: mpf
    depth: mpf
    by_hill: bool
    height: mpf


def ridge_ground(eta, scene, at, ridge):
    """The ground with a lower ridge."""
    rests = scene.rests
    # Near the far hill V says which is higher only by the distance from that hill.
    height = pick(at[2] < -at[4], fall(eta, rests[2], 0, at[2]), fall(eta, rests[4], 0, at[4]) - ridge.drop)
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

    square: mpf  # sin²ψ
    rest: mpf  # cos²ψ
    whole: mpf
    delta: mpf


def phase_of(motion):
    """The phase of the clamp: χ by the half-angle sines, and ψ by χ."""
    near, far, end = sqrt(motion.near), sqrt(motion.far), motion.end
    done, left = motion.done_sine, motion.left_sine
    whole = phase_sum(near, far, done, left)
    gap = sin((motion.left - motion.done) / 4)
    behind, ahead = far * done / whole, near * left / whole
    lead = phase_lead(near, motion.half_cosine, motion.uneven, done, gap) / whole
    # Of two sums for the same that which has the smaller terms rounds less.
    cosine = pick(near * abs(left - done) + abs(motion.uneven) * done < whole, lead, ahead - behind)
    # Not zero: at the tip itself the motion has no point by ℘.
    square = larger(chi_square(behind, ahead), epsilon() ** 19)
    size, first = abs(cosine), cosine >= 0
    delta = hypot(end * cosine, motion.middle * sqrt(square))
    half = pick(first, half_square(end, square, size, delta), half_square_beyond(end, size, delta))
    rest = pick(first, half_rest(end, size, delta), half_rest_beyond(end, motion.middle, square, size, delta))
    return Phase((half, rest, whole, delta))


def small_steps(a, b):
    """What each step takes from the larger one of two numbers to their mean, twice, as shares of it; and the mean.

    The two are a and b for Gauss's steps, a and √(a² − b²) for Landen's, which go on until nothing is left of b.
    """
    ratio = b / a
    if ratio > mpf("0.7"):
        gap, least = a - b, epsilon() / 8
    else:
        gap, least = b * (b / (a + sqrt((a - b) * (a + b)))), epsilon() * ratio * ratio / 8
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
    tangent = sqrt(square / (rest if rest > 0 else epsilon() ** 19))
    if a < b:
        a, b, tangent = b, a, tangent_exchanged(a, b, tangent)
    shares, mean = small_steps(a, b)
    ratio = b / a
    if ratio > mpf("0.7"):
        # Beyond this ψ is a right angle to rounding, and cubes of the tangent may overflow.
        tangent = min(tangent, epsilon() ** -2)
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

    place: mpf
    swing: mpf
    arrival: mpf
    stay: Stay
    phase: Phase
    regular: tuple[mpf, mpf]


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
    far_rise: mpf
    passes: bool
    even: bool
    whole: bool
    shoulder: Rest | None
    moment: mpf
    lean: mpf


class Piece(Record):
    """Tip angles from low to low + width in a basin; angles as differences, told without loss.

    low_kind: 'hill', or 'level', where V is that of the ridge. high_kind: 'clamp', the clamp angle itself; 'turn', the
    angle from which the rod turns back at the clamp angle; 'level'.
    """

    __slots__ = ()

    basin: Basin
    low_kind: str
    high_kind: str
    low_offset: mpf  # low − hill
    width: mpf
    high_depth: mpf  # well − high
    clamp_gap: mpf  # clamp − high
    level_gap: mpf  # the angle at the level of the ridge − high, of a motion that passes it
    clamp_rest: Rest  # the direction next to the clamp
    clamp_offset: mpf  # clamp − that direction
    far_gap: mpf  # far − clamp
    beyond_well: mpf  # clamp − far_well
    past_hill: mpf  # clamp − hill
    past_well: mpf  # clamp − well


def moment_from_rest(eta, stiffness, double_cosine, double_sine, offset):
    """θ″ = −V′ at an offset from a direction without moment."""
    return rest_moment(eta, stiffness, double_cosine, double_sine, sin(offset / 2), cos(offset / 2))


def within(sine):
    """A sine that rounding may have brought beyond 1."""
    return pick(sine < 1, sine, 1)


def parallel_side(beta, eta, piece, rise, drop, from_hill, depth):
    """``far_side`` within a well for a field along the force: the cosines of the turning points add up to −2β/η."""
    basin = piece.basin
    if piece.low_kind == "level":
        low, high = sin(rise / 2) * sin(piece.low_offset + rise / 2), beta / eta + cos(from_hill / 2) ** 2
    else:
        low = sin(rise / 2) ** 2
        low, high = beta / eta + low, (eta - beta) / eta - low
    # sin² and cos² of half the distance from the far turning point to the far hill.
    low, high = sqrt(larger(low, 0)), sqrt(larger(high, 0))
    distance = 2 * atan2(low, high)
    down = turn_to(basin.far_well, basin.far)
    dip = sin(from_hill + depth / 2) * sin(depth / 2)
    up = 2 * asin(within(dip / sin((down + distance) / 2)))
    if piece.high_kind == "turn":
        share = sin(from_hill + drop / 2) * sin(drop / 2) / sin((piece.far_gap + distance) / 2)
        # The clamp's own distance from the hill is exact, the range's width is not.
        rough = piece.far_gap - distance
        left = pick(rough > 0.25 * piece.far_gap, rough, 2 * asin(within(share)))
    else:
        left = up + piece.high_depth
    return (up + depth) / 2, left, 4 * eta * dip * low * high, distance


def pick_rest(condition, yes, no):
    """One or the other direction, number by number."""
    return Rest(pick(condition, *pair) for pair in zip(yes, no, strict=True))


def tip_fall(eta, piece, change, rise, drop):
    """V(tip) − V(tip + change), for a tip that is told from the low and the high end of its range."""
    from_hill, depth = piece.low_offset + rise, piece.high_depth + drop
    upper = from_hill < depth
    return fall(eta, pick_rest(upper, piece.basin.hill, piece.basin.well), pick(upper, from_hill, -depth), change)


def step_to(eta, rest, offset, goal):
    """Newton's step to where the square root of the change of V from a direction without moment is ``goal``, and by
    how much its slope changes half way there, as a share of it."""
    small, large = sin(offset / 4), cos(offset / 4)
    sine, cosine = 2 * small * large, 1 - 2 * small * small
    level = rest_fall(eta, rest.stiffness, rest.double_cosine, rest.double_sine, small, large, small, large)
    force = abs(rest_moment(eta, rest.stiffness, rest.double_cosine, rest.double_sine, sine, cosine))
    here, force = sqrt(abs(level)), larger(force, epsilon() ** 20)
    whole_sine, whole_cosine = 2 * sine * cosine, 1 - 2 * sine * sine
    # dθ″/dθ, by β and α as the direction has them.
    turned = rest.double_cosine * (2 * whole_cosine * whole_cosine - 1 - whole_cosine)
    turned = turned - rest.double_sine * whole_sine * (2 * whole_cosine - 0.5)
    bend = (rest.stiffness * whole_cosine + eta * turned) * (here / force) * (here / force)
    share = (here - goal) / larger(here, epsilon() ** 20)
    return 2 * here * (here - goal) / force, share * (pick(level < 0, -bend, bend) - 0.5)


def reach(eta, rest, amount, most, side):
    """The distance from a hill (or a well) at which V is lower (or higher) by ``amount``, to one side.

    most: the distance of the next well (or hill). Halley's method for the square root of the difference, which is
    nearly linear, from the pendulum's value.
    """
    amount = larger(amount, 0)  # of a hill and a well that nearly meet, rounding may give less
    share = amount / larger(abs(fall(eta, rest, 0, side * most)), epsilon() ** 20)
    near = most * asin(sqrt(pick(share < 1, share, 1))) * (2 / pi)
    goal = sqrt(amount)
    for _ in range(40):
        step, bent = step_to(eta, rest, side * near, goal)
        safe = abs(bent) < 0.5
        trial = near - step / pick(safe, 1 - bent, 1)
        trial = pick(trial > most, (near + most) / 2, pick(trial < 0, near / 2, trial))
        # The method cubes the error, and Newton's squares it: after steps this small the next would change nothing.
        small = pick(safe, spacing(trial) ** mpf("0.45"), spacing(trial) ** mpf("0.6"))
        moving, near = abs(trial - near) > small * near, trial
        if not any_of(moving):
            break
    return near


def reach_either(eta, hill, well, by_hill, amount, most):
    """``reach`` down from the hill, or up from the well, whichever is asked for."""
    rest = hill._replace(
        stiffness=pick(by_hill, hill.stiffness, well.stiffness),
        double_cosine=pick(by_hill, hill.double_cosine, well.double_cosine),
        double_sine=pick(by_hill, hill.double_sine, well.double_sine),
    )
    return reach(eta, rest, amount, most, pick(by_hill, -1, 1))


def slope(eta, rest, offset):
    """θ″ at an offset from a direction without moment."""
    return moment_from_rest(eta, rest.stiffness, rest.double_cosine, rest.double_sine, offset)


def onward(eta, rest, start, amount, rough, wanted, moment=0):
    """How far beyond ``start``, an offset from a direction of that moment, V has fallen by ``amount``.

    The rough value is good to rounding of the angles; where little of it is left, the slope of V at the start gives a
    better one. Newton's method does the rest, until all that are wanted are found.
    """
    steep = slope(eta, rest, start) + moment * cos(start)
    told = (abs(rough) > mpf("0.001") * abs(start)) | (steep == 0)
    distance = pick(told, rough, amount / pick(told, 1, steep))
    for _ in range(40):
        force = slope(eta, rest, start + distance) + moment * cos(start + distance)
        fallen = fall(eta, rest, start, distance) + 2 * moment * cos(start + distance / 2) * sin(distance / 2)
        step = (fallen - amount) / pick(force == 0, 1, force)
        away = abs(distance - step) > pi
        stuck = away & (distance == rough)
        distance = pick(away, rough, distance - step)
        if not any_of(wanted & (stuck == 0) & (abs(step) > spacing(distance) ** mpf("0.6") * abs(distance))):
            break
    return distance


def further(eta, rest, start, amount, rough, far, moment=0):
    """How far beyond ``start`` V has risen by ``amount``: ``onward`` where the rough value is not told well enough."""
    better = onward(eta, rest, start, -amount, rough, far == 0, moment)
    # Newton's method leaves a place where V is nearly level for one far away.
    return pick(far | (abs(better - rough) > mpf("0.01")), rough, better)


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
    return epsilon() ** 2 if basin.passes or not basin.whole else 4 * epsilon()


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
    distance = reach_either(eta, far, far_well, by_hill, pick(by_hill, below, above), down)
    turn = pick(by_hill, down - distance, distance)  # far turning point − far_well
    left = pick(by_hill, piece.far_gap - distance, distance - piece.beyond_well)
    if piece.high_kind == "turn":
        left = larger(beyond_clamp(eta, piece, rise, drop, left), 0)
    if basin.passes:
        half_width = (turn + depth + turn_to(well, far_well)) / 2
    else:
        half_width = (turn + depth) / 2
    far_moment = pick(by_hill, slope(eta, far, -distance), slope(eta, far_well, distance)) * -1
    far_moment = larger(far_moment, least_moment(basin) * distance)
    return half_width, left, far_moment, pick(by_hill, distance, down - distance), None


def shoulder_moment(eta, basin, offset):
    """θ″ at an offset from the shoulder."""
    return basin.moment * cos(offset) + slope(eta, basin.shoulder, offset)


class End(Record):
    """An end of a motion beside a shoulder: the far turning point or the tip, and dθ″/dθ there."""

    __slots__ = ()

    is_far: bool
    stiffness: mpf


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
    return pick(apart, sqrt(far) - sqrt(near), by_turns)


def wrapped(angle):
    """The angle less whole turns, between −π and π."""
    return angle - 2 * pi * floor(angle / (2 * pi) + 0.5)


def above_field(eta, basin, offset, turn, height):
    """``mean`` less η where they are near each other: 2(V(tip) − V)/(cos(θ − middle) − cos(half_width)) at the θ at
    which it is least, which lies then near the ridge or the well, at an offset from it.

    turn: half of what it is divided by. height: V(tip) less that of the ridge or the well.
    """
    # As near the ridge as rounding it is nearer still: it is there to the second order in the height.
    offset = pick(abs(offset) < 32 * spacing(offset), 0, offset)
    return (height + fall(eta, basin.axis, 0, offset)) / pick(turn == 0, 1, turn)


def mean_less_field(eta, basin, centre, half_width, near, far, height, mean):
    """``mean`` − η: as it stands, or by the end of the motion or the ridge or well that is near where V is nearest to
    level."""
    apart = mean - eta
    close = apart <= mpf("0.3") * eta
    if any_of(close):
        # 2(axis − α), and 2(middle − α).
        axis = atan2(basin.axis.double_sine, basin.axis.double_cosine)
        double = wrapped(axis + 2 * centre)
        ahead, behind = sin((half_width + double) / 2), sin((half_width - double) / 2)
        by_far, by_near = far - 2 * eta * ahead * ahead, near - 2 * eta * behind * behind
        known = pick(2 * by_far > far, by_far, by_near)
        far_off = close & (2 * by_far <= far) & (2 * by_near <= near)
        if any_of(far_off):
            # Not from a well that is far from where V is nearly level: there V tells least.
            told, turn = pick(near < far, by_near, by_far), ahead * behind
            above = above_field(eta, basin, wrapped(-axis - centre), turn, height)
            known = pick(far_off, pick(height <= abs(turn) * eta * (abs(ahead) + abs(behind)), above, told), known)
        apart = pick(close, known, apart)
    # Over a ridge V(tip) − V is nowhere less than there; elsewhere only rounding makes it smaller than this.
    least = larger(height, epsilon() ** 19) if basin.passes else epsilon() * pick(near < far, near, far) / 4
    return larger(apart, least)


def rates(beta, eta, basin, centre, half_width, sine, near, far, height, beside):
    """dχ/dσ at the ends and in the middle of the motion. centre: from the slowest direction to the middle; beside:
    the end that is beside a shoulder, if one is."""
    middle, cosine = basin.axis.angle + centre, cos(half_width)
    cos_middle, cos_double = cos(middle), cos(2 * middle)
    product = sqrt(near) * sqrt(far)
    excess = -(2 * beta * cos_middle * cosine + eta * cos_double * (1 + cosine * cosine))
    split, rate = excess < 0, sqrt(product + larger(excess, 0))
    if any_of(split):
        mean = -(2 * beta * cos_middle + eta * cosine * cos_double)
        apart = mean_less_field(eta, basin, centre, half_width, near, far, height, mean)
        rate = pick(split, sine * sqrt(apart * (mean + eta) / pick(split, product - excess, 1)), rate)
    return sqrt(product / 2), rate / 2


def motion_at(beta, eta, piece: Piece, place):
    """The motion of the tip at a place of a piece: −∞ is its low end, +∞ its high end."""
    basin = piece.basin
    rise, drop = piece.width / (1 + exp(-place)), piece.width / (1 + exp(place))
    from_hill, depth = piece.low_offset + rise, piece.high_depth + drop
    upper = from_hill < depth
    hill, well = basin.hill, basin.well
    offset = pick(upper, from_hill, -depth)
    stiffness = pick(upper, hill.stiffness, well.stiffness)
    double_cosine = pick(upper, hill.double_cosine, well.double_cosine)
    double_sine = pick(upper, hill.double_sine, well.double_sine)
    tip = pick(upper, hill.angle, well.angle) + offset
    near_moment = moment_from_rest(eta, stiffness, double_cosine, double_sine, offset)
    # How far V falls from the tip to the well, or to the level of a ridge that the motion passes.
    change = (drop + piece.level_gap if basin.passes else depth) / 2
    height = fall_from_rest(eta, stiffness, double_cosine, double_sine, offset + change, change)
    # Near the high end the clamp is told from there, else as the tip is: the clamp's own distances are exact.
    done, apart = piece.clamp_gap + drop, pick(upper, piece.past_hill - from_hill, piece.past_well + depth)
    done = pick(done < 0.5 * pick(upper, from_hill, abs(piece.past_well)), done, apart)
    depth = pick(upper, turn_to(hill, well) - from_hill, depth)
    beside = None
    if basin.even:
        half_width = pick(upper, turn_to(hill, basin.axis) - from_hill, depth + turn_to(well, basin.axis))
        left = 2 * half_width - done if piece.high_kind != "turn" else drop
        far_moment, far_distance = near_moment, from_hill
    elif not basin.passes:
        half_width, left, far_moment, far_distance = parallel_side(beta, eta, piece, rise, drop, from_hill, depth)
        half_width = (done + left) / 2 if piece.high_kind == "turn" else half_width
    else:
        side = far_side(eta, piece, rise, drop, depth, height)
        half_width, left, far_moment, far_distance, beside = side
        if basin.shoulder is not None:
            near_moment, beside = beside_shoulder(eta, basin, from_hill, offset, near_moment, beside)
        near_moment = larger(near_moment, least_moment(basin) * abs(offset))
    # Where the motion is nearly a whole turn, what it lacks is told by the distances from the hills.
    lack = (from_hill + far_distance) / 2 if basin.whole else pi - half_width
    sine = sin(pick(lack < half_width, lack, half_width))
    near, far = 2 * near_moment / sine, 2 * far_moment / sine
    # done/2 + left/2 = half_width: near half a turn one follows from the other.
    done_sine = sin(pick(done > pi, lack + left / 2, done / 2))
    left_sine = sin(pick(left > pi, lack + done / 2, left / 2))
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
    rising, blur = slope > 0, WITHIN * epsilon() * length
    for _ in range(TRIES):
        step = value / slope
        if abs(value) <= blur or (abs(step) < epsilon() * (1 + abs(place)) and abs(value) < 8 * blur):
            return Crossing((item, turns, sign, rising))
        trial = place - step
        if not abs(trial - start) < NEAR:
            return None
        new = sample(trial)
        missed = excess(new, turns, sign, length)
        if 2 * abs(missed) > abs(value) and abs(value) < 8 * blur:  # what is left is rounding
            return Crossing((new if abs(missed) < abs(value) else item, turns, sign, rising))
        if abs(step) > epsilon() ** 0.75 * (1 + abs(place)):
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
        if any_of(closer):
            rest, offset = pick_rest(closer, other, rest), pick(closer, distance, offset)
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
        from_top = reach(eta, basin.hill, larger(below, 0), down, 1)
        from_well = reach(eta, basin.well, above, down, -1)
        depth = pick(below < above, down - from_top, from_well)
        width = pick(below < above, from_top, down - from_well)
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
    gap = pick(ground.by_hill, at[0] - level, at[1] + depth)
    return piece_of(over_ridge(ground), "hill", "level", 0, level, depth, gap, 0, at)


def pass_turn(ground):
    """From the highest hill to where the rod turns back at a clamp above the level of the ridge, beyond it."""
    eta, over, level, at = ground.eta, over_ridge(ground), ground.level, ground.at
    down, below = turn_to(over.hill, over.well), fall(eta, over.far, 0, at[4])
    # V of the clamp above the first well: above the ridge, and the ridge above the well.
    above = fall(eta, over.axis, 0, turn_to(over.axis, over.well)) - ground.height
    by_hill = below < above
    rest, amount = pick_rest(by_hill, over.hill, over.well), pick(by_hill, below, above)
    distance = reach(eta, rest, amount, down, pick(by_hill, 1, -1))
    width, depth = pick(by_hill, distance, down - distance), pick(by_hill, down - distance, distance)
    if over.even:
        width = -at[4]
    # Towards the hill V is flat and tells little, but there the angles tell all.
    near, apart = width >= level / 2, pick(by_hill, level - width, depth - ground.depth)
    start = pick(ground.by_hill, level, -ground.depth)
    rest = pick_rest(ground.by_hill, over.hill, over.well)
    gap = pick(near, -onward(eta, rest, start, ground.height, -apart, near), apart)
    return piece_of(over, "hill", "turn", 0, width, depth, pick(by_hill, at[0] - width, at[1] + depth), gap, at)


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
    width, depth = pick(by_level, near, ground.depth - from_well), pick(by_level, ground.depth - near, from_well)
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

    deepest: mpf
    tip: mpf
    middle: mpf
    far: mpf
    arrival: mpf


def ridge_offset(piece):
    """Clamp less ridge, for a motion that passes the ridge."""
    ridge, rest = piece.basin.axis, piece.clamp_rest
    return piece.clamp_offset if rest.angle == ridge.angle else turn_to(ridge, rest)


def delays(piece):
    """The delays at both ends, beyond the depth at which squares of offsets would underflow."""
    basin, depth = piece.basin, deepest(piece.width)
    if basin.hill.stiffness < epsilon() ** 8:  # so flat that the moment is as the cube of the offset
        depth = 2 * depth / 3
    # With next to no moment at the clamp a rod is straight but for an offset whose square would underflow.
    straight = piece.high_kind == "clamp" and abs(piece.clamp_offset) < epsilon() ** 5
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
    steep, most = pick(hill.double_cosine == 1, hill.stiffness, beta + eta), beta + eta / 2
    clamp = piece.low_offset + piece.width + piece.clamp_gap
    rest = min(left, max(clamp - min(clamp, most / steep), 0))
    # Up to the offset from which on the other bound is the lesser: by the share that is left of the way there.
    share = (left - rest) / max(offset, mpf("1e-300"))
    away, steepness = sqrt(share) * sqrt(2 + share), sqrt(steep)
    growth = share + away
    # Neither is more than ln(1 + x).
    logarithm = pick(growth < mpf("0.001"), 2 * growth / (2 + growth), log(1 + growth))
    speed = steepness * away * offset
    return logarithm / steepness + 2 * rest / (speed + sqrt(speed * speed + 2 * most * rest) + mpf("1e-300"))


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
    moment = larger(abs(basin.moment), epsilon() ** 2)
    bend = abs(basin.moment + 1.5 * eta * basin.shoulder.double_sine)
    steep = larger(abs(slope(eta, basin.hill, level)), epsilon() ** 2)
    flat = larger(log(steep * piece.width * sqrt(bend) / moment) - log(moment) / 2, 0)
    found = [flat * k / (ceil(flat / 3) + 1) for k in range(1, ceil(flat / 3) + 2)] if flat > 0 else []
    last = max([*found, flat])
    # At the last place the level is the shoulder's in all digits, and the next range begins with the same length.
    return [*found, last + 1.25, last + 2.5, last + 5, last + 10, last - log(epsilon()), last - 3 * log(epsilon())]


def grid(beta, eta, length, piece):
    """Places to begin with: near enough where the branches bend, and to where none of them is as short as the rod."""
    rounding = -log(epsilon())
    slow = (1 + 16 * epsilon()) * length * sqrt(beta + eta)  # of a very long rod rounding is more than the 6 below
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
        moment = abs(slope(eta, piece.clamp_rest, piece.clamp_offset)) + epsilon() ** 20
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


def twist(eta, x):
    """The couple of the field on a rod turned by x from it."""
    return eta * sin(x) * cos(x)


def ridge_couple(eta):
    """The couple on a rod that points along α + π + x."""
    return twist(eta, mpf(0))


def places(beta, eta, length, piece):
    """Places to begin with, closer around the level at which the motion meets a ridge that is not quite there."""
    found, basin = grid(beta, eta, length, piece), piece.basin
    divided = "shoulder" in (piece.low_kind, piece.high_kind)
    if basin.even or basin.passes or piece.low_kind == "level" or not basin.whole or divided:
        return found
    cusp = pi
    # How far η is below the value at which the ridge would appear.
    missing = max(-ridge_couple(eta) / (beta + eta), epsilon())
    cusp = 2 * pi - cusp
    down = turn_to(basin.hill, basin.well)
    rise = reach(eta, basin.hill, fall(eta, basin.hill, 0, cusp - basin.hill.angle), down, 1)
    if missing > mpf("0.3") or not 0 < rise < piece.width:
        return found
    middle = log(rise / (piece.width - rise))
    # The range of tips that it slows down shrinks with the power 3/2.
    steps = [0.25**k for k in range(ceil(mpf("1.1") * log(1 / missing)) + 3)]
    around = [middle, *(middle - step for step in steps), *(middle + step for step in steps)]
    return sorted([*found, *(place for place in around if found[0] < place < found[-1])])


def arrives_convexly(piece):
    """Whether the first arrival is a convex function of the energy V(tip): see docs/solver.md."""
    basin = piece.basin
    known = basin.even or basin.far_rise == 0
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
    best, bound = None, (1 + mpf("1e-09")) * length
    for gap in (least, least + 1):
        low, high = ends_of(found, places, gap)
        if high - low > 2 * sqrt(epsilon()) * (1 + abs(found[least].place)):
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
        apart = after.place - before.place > max(mpf("0.3"), 8 * epsilon() * abs(before.place))
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
        return least_arrival(beta, eta, piece, *about(piece, place)) > (1 + mpf("1e-09")) * length

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
    soon = (1 - mpf("1e-09")) * min(quarter, length) if short and piece.high_kind == "clamp" else 0
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

    nodes: list[mpf] = []
    parts: list[mpf] = []
    for k in range(len(places) - 1, -1, -1):
        nodes, parts = with_node(nodes, parts, places[k], values[k])
    (a, b, *_), (value_a, value_b, *_) = places, values
    halve = False
    while True:
        if abs(value_b) < abs(value_a):
            a, b, value_a, value_b = b, a, value_b, value_a
        least, width = 2 * epsilon() * (1 + abs(a)), abs(b - a)
        if 2 * least > width or abs(value_a) <= blur:
            return a
        share = 0.5 if halve else (zero_near(nodes, parts) - a) / (b - a)
        if 2 * abs(share) * width < least and abs(value_a) < 16 * blur:
            return a
        if -mpf("0.05") < share < 0:  # rounding of the values puts the zero on the wrong side
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
    place = bracketed_root(function, [item.place for item in known], values, epsilon() * length)
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


def heading_of(motion):
    """The direction of a motion's tip."""
    double = 2 * motion.tip
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
    target = 2 * (epsilon() / 4) ** 0.125
    scale, total = 1, 0
    while any_of(reach > target * scale * abs(fivefold)):
        root, root_p = sqrt(x), sqrt(p)
        side, across = root_p * root_sum, root * root_sum
        plus = lift + side
        if scale == 1:
            minus = lift - side
            cancels = abs(plus) < abs(minus)
            plus = pick(cancels, twist / (less * pick(cancels, minus, 1)), plus)
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
    bent = (
        e2 * (mpf(9) / 88 - e2 * (mpf(1) / 16) + e3 * (mpf(45) / 272))
        - e3 * (mpf(9) / 52)
        + e4 * (mpf(3) / 20)
        - e5 * (mpf(9) / 68)
        - mpf(3) / 14
    )
    series = (
        1
        + e2 * bent
        + e3 * (mpf(1) / 6 + e3 * (mpf(3) / 40) - e4 * (mpf(9) / 68))
        - e4 * (mpf(3) / 22)
        + e5 * (mpf(3) / 26)
    )
    return series / (scale * mean * sqrt(mean)) + 6 * total


def shift(eta, heading, motion, point, root, square, rest):
    """W as real and imaginary part: ∫e^{iθ} from the tip is e^{iφ}(σ + W)."""
    b, near, far = point.strength, sqrt(motion.near), sqrt(motion.far)
    twist = mpc(rj_delta_real(eta, b, heading.double_cosine), rj_delta_imag(eta, b, heading.double_sine))
    lift = pair_lift(near, far, motion.uneven, motion.half_cosine, square, rest)
    pole, lifted, less = mpc(point.pole, -b), mpc(lift, -b), mpc(root, -b)
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
    towards_tip = lift > mpf("0.15")
    lift, there = pick(towards_tip, lift, 1), pick(towards_tip, x, 1)
    return pick(towards_tip, arc_kink_tip(first, delta, across, b, there, root, others, both, lift), far)


def second_kind(a, b, square, rest, arrival):
    """∫sin²ψ over the same range as ``arrival``, the length, and by how much that exceeds sin ψ cos ψ/Δ.

    By the same transformation (DLMF 19.8.19). Both are small as the cube of a short length, without a difference.
    """
    limit, more, gap = epsilon() ** 0.5, any_of(a > 0), a - b
    delta, weight, weights, integral, excess = phase_rate(a, b, square, rest), 0.5, 0.0, 0, 0
    while more:
        more = any_of(abs(gap) > limit * a)
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

    strength: mpf  # b
    pole: mpf  # x
    one: mpf
    product: mpf
    root_sum: mpf


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
        turned = rod.eta * (cos(2 * angle) - heading.double_cosine) / 2
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
        done_sine=larger(motion.left_sine, epsilon() ** 6),
        left_sine=motion.done_sine,
    )


def arc_from_far(eta, heading, there, arc, extent):
    """The arc of a motion turned back, whose heading is ``there``, as what departs from the tip's direction."""
    y, z = arc.y + extent * (there.cosine - heading.cosine), arc.z + extent * (there.sine + heading.sine)
    return Arc((y, -z, arc.square + extent * eta * (there.double_cosine - heading.double_cosine) / 2))


def last_stretch(rod, heading, motion, extent):
    """The arc from the last turning point to the clamp, of a rod that ends on its way back; extent: its length."""
    back = sent_back(motion)
    there, phase = heading_of(back), phase_of(back)
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
    return whole, Arc(mpf(through * a + b) for a, b in zip(whole, part, strict=True))


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
    heading = heading_of(motion)
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
    along = cos(rest.angle)
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


def all_equilibria(beta, eta, max_index):
    """Every equilibrium, sorted by tip angle: from the tips below the clamp angle, above it, and the straight rod."""
    if mpf(80) * sqrt(beta + eta) <= epsilon():
        return [weak_rod(beta, eta)]
    most = inf if max_index is None else max_index
    scale = frexp(beta + eta)[1] // 2
    rod = Rod((ldexp(beta, -2 * scale), ldexp(eta, -2 * scale), ldexp(mpf(80), scale), 0.75 * pi, 1, scale))
    mirrored = Rod((rod.beta, rod.eta, rod.length, -0.75 * pi, -1, scale))
    scene, other = landscapes(rod.beta, rod.eta)
    clamp = clamp_in(scene.rests, rod.clamp_angle)
    beyond = mirrored_clamp(scene, other, clamp, mirrored.clamp_angle)
    ridge = ridge_of(rod.beta, rod.eta, scene) if other is scene else None
    shots = tip_shots(rod.beta, rod.eta, rod.length, rod.clamp_angle)
    lower = below(rod, scene, clamp, ridge, most, shots)
    upper = below(mirrored, other, beyond, ridge, most, None if shots is None else mirror_shots(shots))
    return in_order([*lower, *straight(rod, scene, clamp, most), *upper[::-1]])


def each_of(convert, name, values):
    """A number or a list, each converted under its own name."""
    if isinstance(values, (str, bytes)) or not isinstance(values, Iterable):
        return convert(name, values)
    return [convert(f"{name}[{place}]", value) for place, value in enumerate(values)]


def all_not_negative(name, values):
    """Real numbers ≥ 0, or an error that names the argument and the index of the first that is none."""
    return each_of(not_negative, name, values)


def of_one_length(given):
    """The rods, a tuple of parameters for each; numbers are repeated. ValueError where sequences differ in length."""
    lengths = {len(part) for part in given if isinstance(part, list)}
    if len(lengths - {1}) > 1:
        sizes = [
            f"{name} {len(part)}" for name, part in zip(given._fields, given, strict=True) if isinstance(part, list)
        ]
        raise ValueError(f"sequences must have one length: their lengths are {', '.join(sizes)}")
    rows = 1 if not lengths or lengths == {1} else max(lengths - {1})
    columns = [part if isinstance(part, list) else [part] for part in given]
    return list(zip(*(column * rows if len(column) == 1 else column for column in columns), strict=True))


class Given(Record):
    """The parameters of many rods: numbers or arrays."""

    __slots__ = ()

    beta: Any
    eta: Any


def element(case, values):
    """A parameter of one rod, of a number or a list; what is folded stays as it is."""
    if not isinstance(values, list):
        return values
    return values[case % len(values)]


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


def must_be_searchable(beta, eta, slowest):
    """ValueError where β + η at the high ends of their ranges is more than is searched."""
    must_be_finite(beta, eta)
    slow = mpf(80) * sqrt(beta + eta)
    if slow > slowest:
        raise refused(
            Loads((beta, eta)),
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
    spot: mpf
    place: mpf
    height: mpf
    slope: mpf
    rod: Rod
    turns: int
    piece: Piece


class Probe(Record):
    """Half-swing, first arrival, and their derivatives by the place."""

    __slots__ = ()

    place: mpf
    swing: mpf
    arrival: mpf
    swing_rate: mpf
    arrival_rate: mpf


def moment_rate(beta, eta, angle, d_angle, change):
    """The derivative of θ″ at an angle that changes too."""
    lean = angle
    stiffness = beta * cos(angle) + eta * cos(2 * lean)
    return stiffness * d_angle + sin(angle) * change.beta + sin(2 * lean) / 2 * change.eta


def change_of_ratio(beta, eta, motion, change, d_turn):
    """The derivative of log(far/near); d_turn: of the far turning point by the loads alone.

    What the tip does to it is put by the condition of turning pairs, by which far − near is 2η sin 2(middle − α) times
    sin(half_width): where the motion is nearly a whole turn both logarithms change much and alike.
    """
    tip, near, far = motion.tip, motion.near, motion.far
    turn = tip + 2 * motion.half_width
    stiffness = beta * cos(tip) + eta * cos(2 * tip)
    by_tip = 6 * cos(motion.half_width) * near * near + 4 * stiffness * (near + far)
    by_near = moment_rate(beta, eta, tip, 0, change) / motion.near_moment
    by_far = moment_rate(beta, eta, turn, d_turn, change) / motion.far_moment
    skew = motion.uneven * (sqrt(near) + sqrt(far)) / (2 * motion.sine)
    return -by_tip * skew / (near * far * far) * change.tip - by_far - by_near


class Numbers(Record):
    """Derivatives of the numbers of the Legendre form: of the logarithms of far/near, end and middle, and of the far
    turning point itself."""

    __slots__ = ()

    ratio: mpf
    end: mpf
    middle: mpf
    turn: mpf


def changes_of_numbers(beta, eta, motion, change):
    """Derivatives of the turning pair (V stays equal at its ends) and of the numbers made from it."""
    tip, half, sine = motion.tip, motion.half_width, motion.sine
    cosine, middle, turn = cos(half), tip + half, tip + 2 * half
    cos_middle, sin_middle = cos(middle), sin(middle)
    double_cos, double_sin = cos(2 * middle), sin(2 * middle)
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
    limit, more, weight, total = 2 * epsilon() ** 0.5, True, 1, 0
    while more:
        more = any_of(abs(a - b) > limit * a)
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
    behind = pick(first, (b * sine_chi) * (b * sine_chi) / pick(first, forth, 1), 2 * phase.delta - forth)
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

    tip: mpf
    beta: mpf
    eta: mpf


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
        if width > mpf("0.4") and miss > mpf("0.02") * length and (not out_of_reach):
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
    return value if abs(value) > 64 * epsilon() * (2 * swings * item.swing + item.arrival) else 0


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


def both_sides(beta, eta, length, scale):
    """The rod, and its mirror image."""
    return Rod((beta, eta, length, 0.75 * pi, 1, scale)), Rod((beta, eta, length, -0.75 * pi, -1, scale))


class Row(Record):
    """What is at a place of the parameter: by key, lists of records in the order of their spots.

    A record has a spot, by which it is told from others of its key, a group, which it keeps if it goes over to
    another key, and a height.
    """

    __slots__ = ()

    place: mpf
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
    low: mpf
    high: mpf
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
            small = abs(item.height) < mpf("1e-05") and abs(other.height) < mpf("1e-05")
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
    return record if record is not None and abs(record.height) < mpf("1e-05") else None


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
    step, least = inf, sqrt(epsilon()) * (mark.rod.beta + mark.rod.eta)
    while abs(step) > least:
        last, step = step, mark.height / mark.slope
        if 2 * abs(step) > abs(last):  # beside an exchange there is no slope to tell more
            return mark
        mark = nearest(at(mark.rod.eta - step, mark.key), mark.key, mark.spot) or mark
    return mark


def straight_at(beta, eta):
    """The direction without moment that is the clamp angle; None if there is none."""
    rests = landscape(beta, eta).rests
    offsets = clamp_in(rests, 0.75 * pi).offsets
    return next((rest for rest, offset in zip(rests, offsets, strict=True) if offset == 0), None)


def pitchforks(beta, length, scale, places):
    """Where the rod that stays straight buckles: ℓ√(−dθ″/dθ) is an odd number of quarter turns.

    The clamp angle is without moment for every η only where the rod is symmetric about it, and then the bent rods
    come in pairs. Near it u″ = (B + C)u − (B + 4C)u³/6 + (B + 16C)u⁵/120 with B = β cos θ₀, C = η cos 2(θ₀ − α): the
    signs say whether the half-swing grows with the amplitude.
    """
    some = places[0], places[len(places) // 2], places[-1]
    rests = [straight_at(beta, eta) for eta in some]
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
            at = 0.75 * pi, 0 * extent, cosine * extent, sine * extent
            found.append(Fold((ldexp(eta, 2 * scale), *at, index, change, "pitchfork")))
        index += 1
    return found


def all_folds(beta, length, low, high):
    """Every fold with η in [low, high], sorted by η and tip angle."""
    scale = frexp(beta + high)[1] // 2
    beta, length = ldexp(beta, -2 * scale), ldexp(length, scale)
    places = steps(beta, beta, length, ldexp(low, -2 * scale), ldexp(high, -2 * scale))
    if not places:
        return []

    def at(eta, key):
        return marks(both_sides(beta, eta, length, scale), key)

    rough = roughly(lambda: zeros(at, places, -beta, mpf("1e-12")))
    found = [fold_of(sharpened(at, mark)) for mark in rough]
    found += pitchforks(beta, length, scale, places)
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

    rows = follow(near, places, origin, mpf("0.001"))
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


def all_exchanges(length, low_beta, high_beta, low, high):
    """Every point with β and η in these ranges at which two folds meet, sorted by β and η."""
    scale = frexp(high_beta + high)[1] // 2
    low_beta, high_beta, low, high = (ldexp(load, -2 * scale) for load in (low_beta, high_beta, low, high))
    length = ldexp(length, scale)
    places = steps(low_beta, high_beta, length, low, high)
    if not places:
        return []

    def at(beta, key):
        def extrema(eta, kept):
            return marks(both_sides(beta, eta, length, scale), kept)

        return stationary(extrema, places, -beta, key)

    loads = forces(low_beta, high_beta, length, high)
    found = [exchange_of(at, mark) for mark in zeros(at, loads, -high, mpf("0.001"))]
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

    tip_angle: mpf
    clamp_curvature: mpf
    gamma: mpf
    y: mpf
    z: mpf
    energy: mpf
    index: int  # type: ignore[assignment]  # in the place of tuple.index
    rod: Rod
    swing: Swing | None


def equilibria(beta, eta, *, max_index=None, dps=None) -> list[Equilibrium]:
    """All equilibria of one rod, sorted by tip angle.

    beta: terminal force over bending stiffness, F/(EI) ≥ 0.
    eta: magnetic modulus over bending stiffness, η̃/(EI) ≥ 0.
    max_index: the largest index that is wanted, 0 for stable equilibria only; None for all.
    dps: decimal digits to work with, from 15 to 1000; None for those of the caller, mp.dps.

    All in one unit of length. Raises TypeError or ValueError, naming the argument, before any work.
    """
    with workdps(digits(dps)):
        beta, eta = not_negative("beta", beta), not_negative("eta", eta)
        limit = index_limit(max_index)
        must_have_answer(beta, eta, limit)
        return all_equilibria(beta, eta, limit)


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


def sweep(beta, eta, *, max_index=None, dps=None) -> Sweep:
    """All equilibria of many rods: the arguments are numbers, or sequences of one length.

    max_index: the largest index that is wanted, 0 for stable equilibria only; None for all.
    dps: decimal digits to work with, from 15 to 1000; None for those of the caller, mp.dps.

    Raises TypeError or ValueError, naming the argument and the index of a bad value, before any work.
    """
    with workdps(digits(dps)):
        beta, eta = all_not_negative("beta", beta), all_not_negative("eta", eta)
        rods, limit = of_one_length(Given((beta, eta))), index_limit(max_index)
        for case in range(len(rods)):
            must_have_answer(element(case, beta), element(case, eta), limit)
        found = [(case, item) for case, rod in enumerate(rods) for item in equilibria(*rod, max_index=limit)]
        return Sweep(
            (
                [case for case, _ in found],
                [item.tip_angle for _, item in found],
                [item.clamp_curvature for _, item in found],
                [item.gamma for _, item in found],
                [item.y for _, item in found],
                [item.z for _, item in found],
                [item.energy for _, item in found],
                [item.index for _, item in found],
            )
        )


class Fold(Record):
    """Two equilibria meet, at this η, and vanish on one side of it.

    tip_angle, clamp_curvature, y, z: of the rod there. index: the lower of the two indices that meet; the other one is
    index + 1. change: the number of equilibria just above this η less that just below: 2 or −2. kind: 'fold', or
    'pitchfork' where the two that vanish meet a third one, the straight rod.
    """

    __slots__ = ()

    eta: mpf
    tip_angle: mpf
    clamp_curvature: mpf
    y: mpf
    z: mpf
    index: int  # type: ignore[assignment]  # in the place of tuple.index
    change: int
    kind: str


def folds(beta, *, eta, dps=None) -> list[Fold]:
    """Where equilibria of a rod meet and vanish as the field grows: every fold with η in a range, sorted by η.

    beta: terminal force over bending stiffness, F/(EI) ≥ 0.
    ``eta``: the range (low, high) of the magnetic modulus over bending stiffness, 0 ≤ low < high.
    dps: decimal digits to work with, from 15 to 1000; None for those of the caller, mp.dps.

    All in one unit of length. Raises TypeError or ValueError, naming the argument, before any work.
    """
    with workdps(digits(dps)):
        beta = not_negative("beta", beta)
        low, high = span("eta", eta)
        must_be_searchable(beta, high, FOLDS_SLOWEST)
        return all_folds(beta, mpf(80), low, high)


class Exchange(Record):
    """At this β and η the two folds of a diagram over η meet: it changes its aspect as β goes by.

    With F = θ(0) − clamp angle as a function of the tip angle φ and of η: F = ∂F/∂φ = ∂F/∂η = 0. kind: 'exchange',
    where two branches cross (F has a saddle) and their halves are joined otherwise on either side of β; 'isolated',
    where a closed branch shrinks to a point and vanishes (F has an extremum). tip_angle, clamp_curvature, y, z: of
    the rod there. index: the lower of the two indices that meet.
    """

    __slots__ = ()

    beta: mpf
    eta: mpf
    tip_angle: mpf
    clamp_curvature: mpf
    y: mpf
    z: mpf
    index: int  # type: ignore[assignment]  # in the place of tuple.index
    kind: str


def exchanges(*, beta, eta, dps=None) -> list[Exchange]:
    """Where two folds meet as the force grows: the diagram over η changes there. Those in a range, sorted by β and η.

    ``beta``, ``eta``: the ranges (low, high) of terminal force and magnetic modulus over bending stiffness,
    0 ≤ low < high.
    dps: decimal digits to work with, from 15 to 1000; None for those of the caller, mp.dps.

    All in one unit of length. Raises TypeError or ValueError, naming the argument, before any work.
    """
    with workdps(digits(dps)):
        (low_beta, high_beta), (low, high) = span("beta", beta), span("eta", eta)
        must_be_searchable(high_beta, high, EXCHANGES_SLOWEST)
        return all_exchanges(mpf(80), low_beta, high_beta, low, high)
