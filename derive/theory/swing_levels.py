"""θ″ and V(θ) = β cos θ + ½η cos²(θ − α), from directions of equilibrium and between two angles.

The motion from the tip is that of a particle in the potential V: θ_σ² = 2(V(φ) − V(θ)), θ″ = −V′. Near a direction of
equilibrium both θ″ and the difference of V are small; the formulas from there hold the small factor as a sine.
"""

from __future__ import annotations

from dataclasses import dataclass

from sympy import Add, Expr, Integer, cos, diff, oo, sin

from .claims import Domain, Equal
from .oblique_quartic import HalfAngle, m, q, theta_tip
from .plane import Plane
from .swing_names import (
    PARAMETERS,
    Writer,
    anywhere,
    drop,
    field_angle,
    half,
    middle,
    offset,
    rest,
    tip,
    turned,
)
from .symbols import alpha, beta, eta, gamma, theta
from .tip_names import length, square, y_tip

FIELD = (beta, eta, field_angle)


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
    )
    # sin(x + o) − sin x = 2 sin(o/2) cos(x + o/2), for the force and, with twice the angle, for the field.
    turn = cos(offset / 2) * cos(2 * (rest - field_angle) + offset)
    writer.add(
        "moment_from_rest",
        (*FIELD, rest, offset),
        2 * sin(offset / 2) * (beta * cos(rest + offset / 2) + eta * turn),
        "θ″ at an offset from a direction where it is zero",
        lambda value: Equal(turned(moment, rest) + value, turned(moment, Add(rest, offset))),
        anywhere(rest, offset),
        steps=("moment",),
    )
    writer.add(
        "rest_stiffness",
        (*FIELD, rest),
        beta * cos(rest) + eta * cos(2 * (rest - field_angle)),
        "dθ″/dθ at an angle: small rotations h from a direction of equilibrium obey h″ = (dθ″/dθ)h; at the tip it is q",
        lambda value: Equal(value, -turned(diff(levels.potential, theta, 2), rest)),
        anywhere(rest),
        steps=("potential",),
    )


def _write_drops(levels: Levels, writer: Writer) -> None:
    """V(θ₁) − V(θ₂) as a product with a small factor."""
    potential = levels.potential
    writer.add(
        "level_drop",
        (*FIELD, middle, half),
        sin(half) * (2 * beta * sin(middle) + eta * cos(half) * sin(2 * (middle - field_angle))),
        "V(middle − half) − V(middle + half), zero where these are the two turning points of a motion",
        lambda value: Equal(value, turned(potential, middle - half) - turned(potential, middle + half)),
        anywhere(middle, half),
        steps=("potential",),
    )
    turn = 2 * (rest - field_angle)
    field = eta * cos(turn) * cos(offset / 2) ** 2 - eta * sin(turn) * sin(offset) / 2
    lost = sin(offset) * turned(levels.moment, rest)
    writer.add(
        "drop_from_rest",
        (*FIELD, rest, offset),
        2 * sin(offset / 2) ** 2 * (beta * cos(rest) + field),
        "V(rest) − V(rest + offset), from a direction of equilibrium",
        lambda value: Equal(value + lost, turned(potential, rest) - turned(potential, Add(rest, offset))),
        anywhere(rest, offset),
        steps=("potential",),
    )
    writer.add(
        "curvature_squared",
        (drop,),
        2 * drop,
        "θ′², the square of the curvature, by what V falls from the tip to the point",
        lambda value: Equal(value.subs(drop, turned(potential, tip) - potential), levels.squared),
        anywhere(tip, theta),
        steps=("fall",),
        source="exsl8",
    )


def _write_tip(levels: Levels, rod: HalfAngle, writer: Writer) -> None:
    """γ, and the coefficients at the tip of the half-angle quartic that are not θ″ and dθ″/dθ."""
    at = {theta_tip: tip, alpha: field_angle}
    writer.add(
        "gamma",
        (*FIELD, tip),
        2 * turned(levels.potential, tip),
        "γ of the first integral, such that the curvature vanishes at the tip",
        lambda value: Equal(value, rod.gamma.subs(at)),
        anywhere(tip),
        steps=("oblique.free_end", "fall"),
        source="exsl8",
    )
    writer.add(
        "tip_cubic",
        (*FIELD, tip),
        beta * sin(tip) - eta * sin(2 * (tip - field_angle)) / 2,
        "m, the coefficient of t³ in the half-angle quartic at the tip",
        lambda value: Equal(value, rod.coefficients[m].subs(at)),
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
