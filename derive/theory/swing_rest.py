"""Directions of equilibrium for a field at 0 < α < π/2: where they lie, and that there are no others.

θ″ is β sin θ + ½η sin 2(θ − α). Between force and field V has one maximum, the hill, and between the normal of the
field and the opposite of the force one minimum, the well: a ratio of sines that falls from infinity to zero meets any
value once. On the quarter from α + π to α + 3π/2 a second pair is found if η/β is above the least value of a convex
sum, which is that of the Stoner–Wohlfarth astroid. Everywhere else both terms of θ″ have one sign.
"""

from __future__ import annotations

from functools import partial
from typing import Any

from sympy import Add, Expr, Integer, Matrix, Rational, Symbol, atan, atan2, cos, diff, oo, pi, sin, sqrt, symbols, tan

from .claims import Domain, Equal
from .swing_levels import FIELD, Levels
from .swing_merging import write_merging
from .swing_names import Writer, cosine, field_angle, sine, turned
from .symbols import beta, eta, theta

before = Symbol("before", real=True)  # y: θ = α − y
past = Symbol("past", real=True)  # w: θ = α + π/2 + w
beyond = Symbol("beyond", real=True)  # x: θ = α + π + x
root_cos, root_sin = symbols("c s", positive=True)  # the cube roots of cos α and sin α
QUARTER = {beta: (0, oo), eta: (0, oo), field_angle: (0, pi / 2)}


def write_rest(levels: Levels, writer: Writer) -> None:
    """θ″ by the offset from the field, from across it, and from opposite to it."""
    _write_hill(levels.moment, writer)
    _write_well(levels.moment, writer)
    _write_pair(levels.moment, writer)
    _claim_astroid(writer)
    write_merging(levels, writer)
    _claim_none(levels.moment, writer)
    _write_tilted(levels, writer)


def _write_hill(moment: Expr, writer: Writer) -> None:
    """From the field towards the force: sin(α − y)/sin 2y falls from infinity to zero."""
    where = Domain({**QUARTER, before: (0, field_angle)})
    force, field = sin(field_angle - before), sin(2 * before)
    writer.add(
        "hill_balance",
        (*FIELD, before),
        eta * field / 2 - beta * force,
        "−θ″ at α − y, between force and field: zero at a maximum of V",
        lambda value: Equal(-value, turned(moment, field_angle - before)),
        where,
        steps=("moment",),
        source="exsl6",
    )
    fall = 2 * cos(field_angle) * sin(before) + 2 * cos(before) ** 2 * force
    same = Equal(-diff(force / field, before) * field**2, fall)
    writer.claim("one_hill", "the ratio of its terms falls", same, where, steps=("hill_balance",))


def _write_well(moment: Expr, writer: Writer) -> None:
    """From across the field to opposite to the force: cos(α + w)/sin 2w falls from infinity to zero."""
    where = Domain({**QUARTER, past: (0, pi / 2 - field_angle)})
    force, field = cos(field_angle + past), sin(2 * past)
    writer.add(
        "well_balance",
        (*FIELD, past),
        eta * field / 2 - beta * force,
        "−θ″ at α + π/2 + w, between the normal of the field and the opposite of the force: zero at a minimum of V",
        lambda value: Equal(-value, turned(moment, field_angle + pi / 2 + past)),
        where,
        steps=("moment",),
        source="exsl6",
    )
    fall = 2 * sin(field_angle) * sin(past) + 2 * cos(past) ** 2 * force
    same = Equal(-diff(force / field, past) * field**2, fall)
    writer.claim("one_well", "the ratio of its terms falls", same, where, steps=("well_balance",))


def _write_pair(moment: Expr, writer: Writer) -> None:
    """From opposite to the field on: two directions, one or none, by a convex sum."""
    where = Domain({**QUARTER, beyond: (0, pi / 2)})
    height = _height(sin(field_angle), cos(field_angle))
    writer.add(
        "pair_balance",
        (*FIELD, beyond),
        eta * sin(2 * beyond) / 2 - beta * sin(field_angle + beyond),
        "θ″ at α + π + x: zero at the second maximum and the second minimum of V",
        lambda value: Equal(value, turned(moment, Add(field_angle, pi, beyond))),
        where,
        steps=("moment",),
        source="exsl6",
    )
    writer.add(
        "pair_height",
        (field_angle, beyond),
        height,
        "sin α/sin x + cos α/cos x: where it is η/β, the direction α + π + x is one of equilibrium",
        lambda value: Equal(
            sin(beyond) * cos(beyond) * (eta - beta * value), turned(moment, Add(field_angle, pi, beyond))
        ),
        where,
        steps=("moment",),
        source="exsl6",
        emitted=False,
    )
    curved = sin(field_angle) * (1 + cos(beyond) ** 2) / sin(beyond) ** 3
    curved += cos(field_angle) * (1 + sin(beyond) ** 2) / cos(beyond) ** 3
    convex = Equal(diff(height, beyond, 2), curved)
    writer.claim("pair_convex", "the height is convex in x", convex, where, steps=("pair_height",))


def _height(sine: Expr, cosine: Expr) -> Expr:
    return sine / sin(beyond) + cosine / cos(beyond)


def _at_both(value: Expr, side: int, there: Any) -> Equal:
    """A value at one well, and the same or the negative at the other."""
    return Equal(Matrix([value, side * value]), Matrix(there))


def _claim_astroid(writer: Writer) -> None:
    """The least height, at tan³x = tan α, is (cos^{2/3}α + sin^{2/3}α)^{3/2}."""
    length = sqrt(root_cos**2 + root_sin**2)
    least = {sin(beyond): root_sin / length, cos(beyond): root_cos / length}
    height, where = _height(root_sin**3, root_cos**3), Domain({root_cos: (0, oo), root_sin: (0, oo)})
    level = Equal(diff(height, beyond).subs(least), 0)
    title, steps = "the height is least at tan³x = tan α", ("pair_convex",)
    writer.claim("astroid_place", title, level, where, steps=steps)
    writer.add(
        "astroid_angle",
        (sine, cosine),
        atan((sine / cosine) ** Rational(1, 3)),
        "x at which sin α/sin x + cos α/cos x is least, by sin α and cos α: tan³x = tan α",
        lambda value: Equal(tan(value) ** 3, sine / cosine),
        Domain({sine: (0, 1), cosine: (0, 1)}),
        steps=("astroid_place",),
    )
    value = Equal(height.subs(least), length**3)
    writer.claim("astroid", "the least height", value, where, steps=("astroid_place",))


def _claim_none(moment: Expr, writer: Writer) -> None:
    """On the other arcs force and field turn the rod the same way: both terms are of the sign that is claimed."""
    quarter = Domain({**QUARTER, beyond: (0, pi / 2)})
    facing = Domain({**QUARTER, before: (0, field_angle)})
    across = Domain({**QUARTER, past: (0, pi / 2 - field_angle)})
    for key, sign, angle, by_force, by_field, where in (
        ("past_field", 1, field_angle + beyond, sin(field_angle + beyond), sin(2 * beyond), quarter),
        ("past_force", -1, field_angle + pi - before, sin(field_angle - before), sin(2 * before), facing),
        ("before_force", -1, field_angle - pi / 2 + past, cos(field_angle + past), sin(2 * past), across),
    ):
        same = Equal(turned(moment, angle), sign * (beta * by_force + eta * by_field / 2))
        title = f"θ″ {'>' if sign > 0 else '<'} 0 there"
        writer.claim(f"none_{key}", title, same, where, steps=("moment",), source="exsl6")


def _write_tilted(levels: Levels, writer: Writer) -> None:
    """η > β and the field across the force: a hill on each side of it, at cos θ = β/η.

    With the field along the force a well lies a quarter turn less that angle on: there dθ″/dθ and cos 2(θ − α) have
    the other sign, sin 2(θ − α) has the same.
    """
    root, where = sqrt((eta - beta) * (eta + beta)), Domain({beta: (0, oo), eta: (beta, oo)})
    steps, stiff = ("moment", "rest_stiffness"), diff(levels.moment, theta)
    angle = writer.add(
        "tilt",
        (beta, eta),
        atan2(root, beta),
        "θ > 0 where force and field balance, the field across the force",
        lambda value: Equal(levels.moment.subs(field_angle, pi / 2).subs(theta, value), 0),
        where,
        steps=steps,
    )
    writer.add(
        "tilt_from_side",
        (beta, eta),
        atan2(beta, root),
        "θ − π/2 where force and field balance, the field along the force",
        lambda value: Equal(levels.moment.subs(field_angle, 0).subs(theta, value + pi / 2), 0),
        where,
        steps=steps,
    )
    places, turn = ((pi / 2, angle), (Integer(0), pi - angle)), theta - field_angle
    for name, expression, doc, meaning, side in (
        ("tilt_stiffness", (eta - beta) * (eta + beta) / eta, "dθ″/dθ", stiff, -1),
        ("tilt_cosine", 1 - 2 * (beta / eta) ** 2, "cos 2(θ − α)", 2 * cos(turn) ** 2 - 1, -1),
        ("tilt_sine", -2 * beta / eta * root / eta, "sin 2(θ − α)", 2 * sin(turn) * cos(turn), 1),
    ):
        there = [meaning.subs(field_angle, alpha).subs(theta, place) for alpha, place in places]
        writer.add(
            name,
            (beta, eta),
            expression,
            f"{doc} at that angle; {'the negative' if side < 0 else 'the same'} at the well, the field along the force",
            partial(_at_both, side=side, there=there),
            where,
            steps=(*steps, "tilt"),
        )
