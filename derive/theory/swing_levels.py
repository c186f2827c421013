"""θ″ and V(θ) = β cos θ + ½η cos²(θ − α), from directions of equilibrium and between two angles.

The motion from the tip is that of a particle in the potential V: θ_σ² = 2(V(φ) − V(θ)), θ″ = −V′. Near a direction of
equilibrium both θ″ and the difference of V are small; the formulas from there hold the small factor as a sine.
"""

from __future__ import annotations

from dataclasses import dataclass

from sympy import Add, Expr, Integer, Symbol, cos, diff, oo, pi, sin

from .claims import Domain, Equal
from .oblique_quartic import HalfAngle, m, q, theta_tip
from .plane import Plane
from .swing_names import (
    PARAMETERS,
    Writer,
    anywhere,
    cosine,
    double_cosine,
    double_sine,
    drop,
    field_angle,
    half,
    half_cosine,
    half_sine,
    halves,
    middle,
    offset,
    rest,
    sine,
    tip,
    turned,
)
from .symbols import alpha, beta, eta, gamma, theta
from .tip_names import length, square, y_tip

FIELD = (beta, eta, field_angle)
stiffness = Symbol("stiffness", real=True)  # dθ″/dθ at a direction without moment
middle_sine, middle_cosine = Symbol("middle_sine", real=True), Symbol("middle_cosine", real=True)  # of middle/2
aligned = Symbol("aligned", real=True)  # cos(θ − α)
# What a direction without moment is known by, where small offsets and flat wells are to lose nothing.
REST = (eta, stiffness, double_cosine, double_sine)


@dataclass(frozen=True)
class Levels:
    """In β, η, α and θ. moment: θ″. potential: V. squared: θ_σ² of a rod with the tip angle φ."""

    moment: Expr
    potential: Expr
    squared: Expr


def write_levels(plane: Plane, rod: HalfAngle, writer: Writer) -> Levels:
    """The formulas of θ″, of V and of the constants of the tip."""
    moment = plane.angular_acceleration.subs(alpha, field_angle)
    # γ is twice the potential at the tip.
    potential = rod.gamma.subs({theta_tip: theta, alpha: field_angle}) / 2
    levels = Levels(moment, potential, rod.levels.subs({theta_tip: tip, alpha: field_angle}))
    _claim_motion(levels, writer)
    _write_moment(levels, writer)
    _write_drops(levels, writer)
    _write_tip(levels, rod, writer)
    _write_energy(levels, plane, writer)
    return levels


def _claim_motion(levels: Levels, writer: Writer) -> None:
    """θ_σ² is twice what V falls by, and θ″ is −V′."""
    fall = 2 * (turned(levels.potential, tip) - levels.potential)
    same, steps = Equal(levels.squared, fall), ("oblique.free_end",)
    writer.claim("fall", "θ_σ² = 2(V(φ) − V(θ))", same, anywhere(tip, theta), steps=steps, source="exsl8")
    slope, rests = Equal(-diff(levels.potential, theta), levels.moment), ("plane.moment", "plane.variation")
    writer.claim("potential", "θ″ = −V′(θ)", slope, anywhere(theta), steps=rests, source="exsl6")


def _write_moment(levels: Levels, writer: Writer) -> None:
    """θ″, from a direction of equilibrium too, and the stiffness there."""
    moment = levels.moment
    writer.add(
        "moment",
        (*FIELD, theta),
        beta * sin(theta) + eta * sin(2 * (theta - field_angle)) / 2,
        "θ″ at an angle",
        lambda value: Equal(diff(levels.squared, theta), 2 * value),
        anywhere(tip, theta),
        steps=("fall", "potential"),
        source="exsl6",
        emitted=False,
    )
    writer.add(
        "rest_stiffness",
        (beta, eta, cosine, double_cosine),
        beta * cosine + eta * double_cosine,
        "dθ″/dθ by cos θ and cos 2(θ − α), where small rotations h obey h″ = (dθ″/dθ)h; at the tip it is q",
        lambda value: Equal(_at_rest(value), -turned(diff(levels.potential, theta, 2), rest)),
        anywhere(rest),
        steps=("potential",),
    )
    # By half the offset: sin(o) = 2sc, sin(3o/2) = s(3 − 4s²).
    bent = cosine * (stiffness - 2 * eta * double_cosine * sine**2)
    writer.add(
        "rest_moment",
        (*REST, sine, cosine),
        2 * sine * (bent - eta * double_sine * sine * (3 - 4 * sine**2) / 2),
        "θ″ at an offset from a direction without moment, by the sine and cosine of half the offset",
        lambda value: Equal(
            _from_rest(value, levels) + turned(moment, rest) * cos(offset), turned(moment, Add(rest, offset))
        ),
        anywhere(rest, offset),
        steps=("moment", "rest_stiffness"),
    )
    # cos 2o − cos o = −2 sin(3o/2) sin(o/2), sin 2o − ½ sin o = sc(3 − 8s²).
    turned_double = 2 * double_cosine * sine * (3 - 4 * sine**2) + double_sine * cosine * (3 - 8 * sine**2)
    writer.add(
        "stiffness_beside",
        (*REST, sine, cosine),
        stiffness * (1 - 2 * sine**2) - eta * sine * turned_double,
        "dθ″/dθ at an offset from a direction without moment, by the sine and cosine of half the offset",
        lambda value: Equal(
            _from_rest(value, levels) - turned(moment, rest) * sin(offset),
            turned(diff(moment, theta), Add(rest, offset)),
        ),
        anywhere(rest, offset),
        steps=("moment", "rest_stiffness", "rest_moment"),
    )


def _at_rest(value: Expr) -> Expr:
    """The cosines of a direction by its angle."""
    turn = 2 * (rest - field_angle)
    return value.subs({cosine: cos(rest), double_cosine: cos(turn), double_sine: sin(turn)})


def _from_rest(value: Expr, levels: Levels) -> Expr:
    """The names of a direction without moment, and of half the offset from it, by the angles."""
    stiff = -turned(diff(levels.potential, theta, 2), rest)
    return _at_rest(value.subs(halves(offset, (sine, cosine)))).subs(stiffness, stiff)


def _write_drops(levels: Levels, writer: Writer) -> None:
    """V(θ₁) − V(θ₂) as a product with a small factor."""
    potential = levels.potential
    drop_between = writer.add(
        "level_drop",
        (*FIELD, middle, half),
        sin(half) * (2 * beta * sin(middle) + eta * cos(half) * sin(2 * (middle - field_angle))),
        "V(middle − half) − V(middle + half), zero where these are the two turning points of a motion",
        lambda value: Equal(value, turned(potential, middle - half) - turned(potential, middle + half)),
        anywhere(middle, half),
        steps=("potential",),
        emitted=False,
    )
    # The ends of an interval that is longer than half a turn by twice ``half``.
    writer.add(
        "opposite_drop",
        (*FIELD, middle, half),
        cos(half) * (2 * beta * sin(middle) - eta * sin(half) * sin(2 * (middle - field_angle))),
        "V(middle − π/2 − half) − V(middle + π/2 + half)",
        lambda value: Equal(value, drop_between.subs(half, Add(half, pi / 2))),
        anywhere(middle, half),
        steps=("level_drop",),
    )
    _write_fall(levels, writer)
    writer.add(
        "curvature_squared",
        (drop,),
        2 * drop,
        "θ′², the square of the curvature, by what V falls from the tip to the point",
        lambda value: Equal(value.subs(drop, turned(potential, tip) - potential), levels.squared),
        anywhere(tip, theta),
        steps=("fall",),
        source="exsl8",
        emitted=False,
    )


def _write_fall(levels: Levels, writer: Writer) -> None:
    """V(rest + m − h) − V(rest + m + h), by sines and cosines of m/2 and h/2: each term is small with m or h."""
    even = middle_sine**2 + (1 - 2 * middle_sine**2) * half_sine**2
    odd = middle_sine**2 * (3 - 4 * middle_sine**2) + (1 - 8 * middle_sine**2 * middle_cosine**2) * half_sine**2
    stiff = 2 * middle_sine * middle_cosine * (stiffness - 2 * eta * double_cosine * even)
    names = {**halves(middle, (middle_sine, middle_cosine)), **halves(half)}
    potential, first, last = levels.potential, Add(rest, middle, -half), Add(rest, middle, half)
    lost = 2 * turned(levels.moment, rest) * cos(middle) * sin(half)
    writer.add(
        "rest_fall",
        (*REST, middle_sine, middle_cosine, half_sine, half_cosine),
        4 * half_sine * half_cosine * (stiff - eta * double_sine * odd),
        "V(rest + middle − half) − V(rest + middle + half), from a direction without moment",
        lambda value: Equal(
            _from_rest(value.subs(names), levels) + lost, turned(potential, first) - turned(potential, last)
        ),
        anywhere(rest, middle, half),
        steps=("potential", "rest_stiffness"),
    )


def _write_tip(levels: Levels, rod: HalfAngle, writer: Writer) -> None:
    """γ, and the coefficients at the tip of the half-angle quartic that are not θ″ and dθ″/dθ."""
    at = {theta_tip: tip, alpha: field_angle}
    writer.add(
        "gamma",
        (beta, eta, cosine, aligned),
        2 * beta * cosine + eta * aligned**2,
        "γ of the first integral, such that the curvature vanishes at the tip, by cos φ and cos(φ − α)",
        lambda value: Equal(value.subs({cosine: cos(tip), aligned: cos(tip - field_angle)}), rod.gamma.subs(at)),
        anywhere(tip),
        steps=("oblique.free_end", "fall"),
        source="exsl8",
    )
    writer.add(
        "tip_cubic",
        (beta, eta, sine, double_sine),
        beta * sine - eta * double_sine / 2,
        "m, the coefficient of t³ in the half-angle quartic at the tip, by sin φ and sin 2(φ − α)",
        lambda value: Equal(
            value.subs({sine: sin(tip), double_sine: sin(2 * (tip - field_angle))}), rod.coefficients[m].subs(at)
        ),
        anywhere(tip),
        steps=("oblique.coefficients",),
    )
    stiffness = turned(diff(levels.moment, theta), tip)
    same, steps = Equal(stiffness, rod.coefficients[q].subs(at)), ("oblique.coefficients", "rest_stiffness")
    writer.claim("tip_stiffness", "q is dθ″/dθ at the tip", same, anywhere(tip), steps=steps)


def _write_energy(levels: Levels, plane: Plane, writer: Writer) -> None:
    """∫(½θ′² + ψ − β cos θ)ds by θ′² = γ − 2β cos θ + 2ψ and ∫η cos²(θ − α)."""
    work = -2 * plane.energy_density.subs(plane.alignment, cos(theta - field_angle))
    density = (gamma - 2 * beta * cos(theta) - work) / 2 - work / 2 - beta * cos(theta)
    local = {length: Integer(1), y_tip: cos(theta), square: work}
    where = Domain({**PARAMETERS, theta: (-3, 3), gamma: (-oo, oo)})
    writer.add(
        "rod_energy",
        (beta, gamma, length, y_tip, square),
        gamma * length / 2 - 2 * beta * y_tip - square,
        "energy of the rod over EI, bending, field and force, with square = η∫cos²(θ − α)ds",
        lambda value: Equal(value.subs(local), density),
        where,
        steps=("plane.energy", "oblique.energy"),
        source="exsl8",
    )
