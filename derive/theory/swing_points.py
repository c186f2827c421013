"""Points of the motion by ℘ at the tip: x = ℘ − c, and x less each of the half-period values.

t = tan(δ/2) = b/x, b = θ″(φ)/4, and x_σ² = C(x) = 4x³ + qx² + bmx + b²n = 4X₁X₂X₃ with X_i = x − ê_i. One of the
roots is known: ê₁ = b cot D at the far turning point. The other two are real or conjugate, by the sign of the
discriminant; they enter by their sum and their product only.
"""

from __future__ import annotations

from dataclasses import dataclass

from sympy import Expr, Poly, Symbol, cos, diff, oo, pi, sin, sqrt, tan

from .claims import Domain, Equal, Limit
from .oblique_quartic import COEFFICIENTS, QUARTIC, HalfAngle, m, n, p, q, t, theta_tip
from .oblique_shape import b
from .swing_levels import Levels
from .swing_names import (
    PAIR,
    Writer,
    anywhere,
    cosine,
    done,
    done_sine,
    field_angle,
    half_width,
    halves,
    left_sine,
    middle,
    moment_there,
    near,
    sine,
    tip,
    turned,
)
from .swing_turns import Turns
from .symbols import alpha

x = Symbol("x", real=True)  # ℘ − c
factor_tip, factor_there = Symbol("factor_tip", real=True), Symbol("factor_there", real=True)  # P, and Q at the point
factor_far = Symbol("factor_far", real=True)  # P′
x_near, x_pair = Symbol("x_near", real=True), Symbol("x_pair", real=True)  # X₁ and X₂X₃
WHERE = Domain({b: (0, oo), half_width: (0, pi), done: (0, 2 * half_width)})


@dataclass(frozen=True)
class Points:
    """cubic: C in x. far_root: ê₁ in b and D. others: (x − ê₂)(x − ê₃) in x and ê₁, the quotient of C/4 by x − ê₁."""

    cubic: Expr
    far_root: Expr
    others: Expr


e_1, place = Symbol("root", real=True), Symbol("pole", real=True)  # ê₁, and x where it is given


def write_points(levels: Levels, turns: Turns, rod: HalfAngle, writer: Writer) -> Points:
    """The formulas of b, x and the X at a point."""
    cubic = (b**2 * (QUARTIC.subs(p, 4 * b) / t**4)).subs(t, b / x).expand()
    coefficients = Domain({**dict.fromkeys(COEFFICIENTS, (-oo, oo)), b: (0, oo), t: (-oo, oo)})
    squared = diff(b / t, t) ** 2 * QUARTIC.subs(p, 4 * b)
    same, steps = Equal(cubic.subs(x, b / t), squared), ("oblique.quartic",)
    writer.claim("cubic", "x_σ² = C(x) for x = b/t", same, coefficients, steps=steps, source="exsl19")
    others, rest = (part.as_expr() for part in Poly(cubic, x).div(Poly(4 * (x - e_1), x)))
    same = Equal(rest, cubic.subs(x, e_1))
    where = Domain({**dict.fromkeys(COEFFICIENTS, (-oo, oo)), b: (0, oo), e_1: (-oo, oo), x: (-oo, oo)})
    writer.claim("cubic_root", "C(x) = 4X₁X₂X₃ + C(ê₁)", same, where, steps=("cubic",))
    _write_strength(levels, rod, writer)
    points = Points(cubic, _write_near(cubic, levels, turns, rod, writer), others)
    _write_pair(points, writer)
    return points


def _write_strength(levels: Levels, rod: HalfAngle, writer: Writer) -> None:
    """b, by θ″ at the tip."""
    writer.add(
        "strength",
        (moment_there,),
        moment_there / 4,
        "b of the expansion t = b/(℘ − c), by θ″ at the tip",
        lambda value: Equal(
            4 * value.subs(moment_there, turned(levels.moment, tip)),
            rod.coefficients[p].subs({theta_tip: tip, alpha: field_angle}),
        ),
        anywhere(tip),
        steps=("oblique.solution", "oblique.coefficients", "moment"),
        source="exsl17",
    )


def _write_near(cubic: Expr, levels: Levels, turns: Turns, rod: HalfAngle, writer: Writer) -> Expr:
    """x, ê₁ and X₁."""
    names = halves(done, (sine, cosine))
    pole = writer.add(
        "point_pole",
        (b, sine, cosine),
        b * cosine / sine,
        "x = ℘ − c by the sine and cosine of δ/2, or any two numbers in their ratio",
        lambda value: Equal(b / value.subs(names), tan(done / 2)),
        WHERE,
        steps=("cubic", "strength"),
        source="exsl22",
    )
    pole = pole.subs(names)
    infinite, steps = Limit(1 / pole, done, pole * 0, pole * 0, "+"), ("point_pole",)
    writer.claim("point_pole_tip", "x is infinite at the tip", infinite, WHERE, steps=steps, source="exsl22")
    far_root = pole.subs(done, 2 * half_width)
    # b = P sin D/8: without the quotient by a sine that is small for a small swing and for a whole turn.
    writer.add(
        "far_root",
        (near, cosine),
        near * cosine / 8,
        "ê₁, the value of x at the far turning point, by P and cos D",
        lambda value: Equal(value.subs({near: 8 * b / sin(half_width), cosine: cos(half_width)}), far_root),
        WHERE,
        steps=("point_pole", "turn_factor"),
    )
    # Where the two angles are no pair, C(ê₁) is a multiple of the balance.
    at = {theta_tip: middle - half_width, alpha: field_angle}
    strength = turned(levels.moment, middle - half_width) / 4
    values = {letter: value.subs(at) for letter, value in rod.coefficients.items()}
    there = cubic.subs(x, far_root).subs(values).subs(b, strength)
    excess = turns.excess + sin(half_width) * turns.balance / 2
    by_tip = values[q] + 3 * turns.at(-1) * cos(half_width) / 2
    rests: tuple[str, ...] = ("far_root", "middle_excess", "tip_stiffness")
    writer.claim("excess_root", "R = q + 12ê₁ for two turning points", Equal(excess, by_tip), PAIR, steps=rests)
    turn = Equal(there, strength**2 * turns.balance / (2 * sin(half_width) ** 3))
    rests = ("far_root", "strength", "pair", "cubic")
    writer.claim("far_root_turn", "C(ê₁) = 0 for two turning points", turn, PAIR, steps=rests)
    sines = {sine: sin(half_width), done_sine: sin(done / 2), left_sine: sin(half_width - done / 2)}
    writer.add(
        "point_near",
        (b, sine, done_sine, left_sine),
        b * left_sine / (done_sine * sine),
        "X₁ = x − ê₁ at a point, zero at the far turning point, by sin D, sin(δ/2) and sin(D − δ/2)",
        lambda value: Equal(value.subs(sines) + far_root, pole),
        WHERE,
        steps=("point_pole", "far_root"),
    )
    return far_root


def _write_pair(points: Points, writer: Writer) -> None:
    """X₂ + X₃ and X₂X₃."""
    pole = b * cos(done / 2) / sin(done / 2)
    free = dict.fromkeys((q, m, n), (-oo, oo))
    total = writer.add(
        "pair_sum",
        (b, q, done, half_width),
        2 * pole + q / 4 + points.far_root,
        "X₂ + X₃ at a point",
        lambda value: Equal(value, diff(points.others, x).subs({x: pole, e_1: points.far_root})),
        Domain({**free, **WHERE.ranges}),
        steps=("cubic_root", "point_pole", "far_root"),
        emitted=False,
    )
    writer.add(
        "pair_sum_by_root",
        (place, q, e_1),
        2 * place + q / 4 + e_1,
        "X₂ + X₃ at a point, by x and ê₁",
        lambda value: Equal(value.subs({place: pole, e_1: points.far_root}), total),
        Domain({**free, **WHERE.ranges}),
        steps=("pair_sum",),
        emitted=False,
    )
    # x_σ = x_δ δ_σ with δ_σ² = (cos u − cos D)Q, X₁ = x − ê₁, and b by P.
    behind, ahead = sin(done / 2), sin(half_width - done / 2)
    close = pole - points.far_root
    moved = diff(pole, done) ** 2 * 2 * behind * ahead * factor_there
    where = Domain({factor_tip: (0, oo), factor_there: (0, oo), half_width: (0, pi), done: (0, 2 * half_width)})
    product = writer.add(
        "pair_product",
        (factor_tip, factor_there, half_width, done),
        sin(half_width) ** 2 * factor_tip * factor_there / (64 * sin(done / 2) ** 2),
        "X₂X₃ at a point, by Q at the tip and there",
        lambda value: Equal(4 * close * value, moved),
        where,
        given=((b, factor_tip * sin(half_width) / 8),),
        steps=("cubic_root", "point_pole", "far_root", "turn_factor", "factor_at", "sines"),
        emitted=False,
    )
    writer.add(
        "point_rate",
        (x_near, x_pair),
        sqrt(x_near * x_pair),
        "√(X₁X₂X₃) = |x_σ|/2 at a point",
        lambda value: Equal((4 * value**2).subs({x_near: close, x_pair: product}), moved),
        where,
        given=((b, factor_tip * sin(half_width) / 8),),
        steps=("pair_product",),
        emitted=False,
    )
    # The same at the far turning point, where Q is P′.
    at_far = product.subs({done: 2 * half_width, factor_there: factor_far})
    slope, ends = Equal(at_far, factor_tip * factor_far / 64), Domain({half_width: (0, pi)})
    writer.claim("far_slope", "(ê₁ − ê₂)(ê₁ − ê₃) = PP′/64", slope, ends, steps=("pair_product", "far_root"))
