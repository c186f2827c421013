"""Directions of equilibrium for a field at 0 < α < π/2: where they lie, and that there are no others.

θ″ is β sin θ + ½η sin 2(θ − α). Between force and field V has one maximum, the hill, and between the normal of the
field and the opposite of the force one minimum, the well: a ratio of sines that falls from infinity to zero meets any
value once. On the quarter from α + π to α + 3π/2 a second pair is found if η/β is above the least value of a convex
sum, which is that of the Stoner–Wohlfarth astroid. Everywhere else both terms of θ″ have one sign.
"""

from __future__ import annotations

from sympy import Add, Expr, Symbol, cos, diff, oo, pi, sin, sqrt, symbols

from .claims import Domain, Equal
from .swing_levels import FIELD, Levels
from .swing_names import Writer, field_angle, turned
from .symbols import beta, eta

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
    _claim_none(levels.moment, writer)


def _write_hill(moment: Expr, writer: Writer) -> None:
    """From the field towards the force: sin(α − y)/sin 2y falls from infinity to zero."""
    where = Domain({**QUARTER, before: (0, field_angle)})
    force, field = sin(field_angle - before), sin(2 * before)
    writer.add(
        "moment_before_field",
        (*FIELD, before),
        beta * force - eta * field / 2,
        "θ″ at α − y, between force and field: zero at a maximum of V",
        lambda value: Equal(value, turned(moment, field_angle - before)),
        where,
        steps=("moment",),
        source="exsl6",
    )
    fall = 2 * cos(field_angle) * sin(before) + 2 * cos(before) ** 2 * force
    same = Equal(-diff(force / field, before) * field**2, fall)
    writer.claim("one_hill", "the ratio of its terms falls", same, where, steps=("moment_before_field",))


def _write_well(moment: Expr, writer: Writer) -> None:
    """From across the field to opposite to the force: cos(α + w)/sin 2w falls from infinity to zero."""
    where = Domain({**QUARTER, past: (0, pi / 2 - field_angle)})
    force, field = cos(field_angle + past), sin(2 * past)
    writer.add(
        "moment_past_normal",
        (*FIELD, past),
        beta * force - eta * field / 2,
        "θ″ at α + π/2 + w, between the normal of the field and the opposite of the force: zero at a minimum of V",
        lambda value: Equal(value, turned(moment, field_angle + pi / 2 + past)),
        where,
        steps=("moment",),
        source="exsl6",
    )
    fall = 2 * sin(field_angle) * sin(past) + 2 * cos(past) ** 2 * force
    same = Equal(-diff(force / field, past) * field**2, fall)
    writer.claim("one_well", "the ratio of its terms falls", same, where, steps=("moment_past_normal",))


def _write_pair(moment: Expr, writer: Writer) -> None:
    """From opposite to the field on: two directions, one or none, by a convex sum."""
    where = Domain({**QUARTER, beyond: (0, pi / 2)})
    height = _height(sin(field_angle), cos(field_angle))
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
    )
    curved = sin(field_angle) * (1 + cos(beyond) ** 2) / sin(beyond) ** 3
    curved += cos(field_angle) * (1 + sin(beyond) ** 2) / cos(beyond) ** 3
    convex = Equal(diff(height, beyond, 2), curved)
    writer.claim("pair_convex", "the height is convex in x", convex, where, steps=("pair_height",))


def _height(sine: Expr, cosine: Expr) -> Expr:
    return sine / sin(beyond) + cosine / cos(beyond)


def _claim_astroid(writer: Writer) -> None:
    """The least height, at tan³x = tan α, is (cos^{2/3}α + sin^{2/3}α)^{3/2}."""
    length = sqrt(root_cos**2 + root_sin**2)
    least = {sin(beyond): root_sin / length, cos(beyond): root_cos / length}
    height, where = _height(root_sin**3, root_cos**3), Domain({root_cos: (0, oo), root_sin: (0, oo)})
    level = Equal(diff(height, beyond).subs(least), 0)
    title, steps = "the height is least at tan³x = tan α", ("pair_convex",)
    writer.claim("astroid_place", title, level, where, steps=steps)
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
