"""θ from the phase ψ: cos χ by the duplication of an elliptic argument, and δ/2 and D − δ/2 by it.

Everything is a sum of positives but for what vanishes at the far turning point: with v = 1 − cos χ and w = 1 + cos χ,
√P v sin(D − δ/2) = √P′ w sin(δ/2).
"""

from __future__ import annotations

from sympy import Expr, Symbol, cos, oo, sin, sqrt

from .claims import Domain, Equal
from .swing_names import Writer, far, half_cosine, half_sine, half_width, halves, near, root_far, root_near, uneven
from .swing_phase import rest, square

flat = Symbol("flat", real=True)  # (b/a)² sin²ψ
scale = Symbol("scale", real=True)  # what cos χ is divided by
chi = Symbol("cosine", real=True)  # cos χ
versine, coversine = Symbol("versine", real=True), Symbol("coversine", real=True)  # 1 − cos χ and 1 + cos χ
level, tilt = Symbol("level", real=True), Symbol("tilt", real=True)  # √P v + √P′ w and √P′ w − √P v
root, part = Symbol("root", real=True), Symbol("part", real=True)  # √P and v, or √P′ and w
over, under = Symbol("over", real=True), Symbol("under", real=True)  # in the ratio of a tangent
WHERE = Domain({square: (0, 1), flat: (0, oo)})
TURNS = Domain({near: (0, oo), far: (0, oo), half_width: (0, 3), chi: (-1, 1)})


def write_angle(writer: Writer) -> None:
    """cos χ, and the angles to both turning points."""
    _write_chi(writer)
    _write_sides(writer)


def _write_chi(writer: Writer) -> None:
    """By S = sin²ψ, C = cos²ψ and flat = (b/a)²S."""
    below, source = rest * (1 + square) + flat * square, "DLMF 22.6(iii)"
    cosine, rate = (rest**2 - flat * square) / scale, (rest**2 + flat * (1 + rest)) / scale

    def here(value: Expr) -> Expr:
        return value.subs(scale, below).subs(rest, 1 - square)

    # sin²ψ = (1 − cos χ)/(1 + rate): ψ from χ, with the rate of χ over that at the turning points.
    writer.add(
        "chi_rate",
        (square, rest, flat, scale),
        rate,
        "the rate of χ over that at the turning points, by the phase",
        lambda value: Equal(here(value) ** 2, here(cosine**2 + flat / square * (1 - cosine**2))),
        WHERE,
        steps=("half_square", "phase_rate"),
        source=source,
    )
    writer.add(
        "chi_cosine",
        (square, rest, flat, scale),
        cosine,
        "cos χ by the phase: it doubles the elliptic argument",
        lambda value: Equal(square * (1 + here(rate)), 1 - here(value)),
        WHERE,
        steps=("half_square", "half_square_beyond", "chi_rate"),
        source=source,
    )
    writer.add(
        "chi_versine",
        (square, rest, flat, scale),
        2 * square * (rest + flat) / scale,
        "1 − cos χ by the phase",
        lambda value: Equal(here(value), 1 - here(cosine)),
        WHERE,
        steps=("chi_cosine",),
        source=source,
    )
    writer.add(
        "chi_coversine",
        (rest, scale),
        2 * rest / scale,
        "1 + cos χ by the phase",
        lambda value: Equal(here(value), 1 + here(cosine)),
        WHERE,
        steps=("chi_cosine",),
        source=source,
    )
    writer.add(
        "chi_scale",
        (square, rest, flat),
        below,
        "what cos χ, 1 ± cos χ and the rate of χ are divided by, with flat = (b/a)² sin²ψ",
        lambda value: Equal(value, scale * (cosine + 2 * square * (rest + flat) / scale)),
        WHERE,
        given=((rest, 1 - square),),
        steps=("chi_cosine", "chi_versine"),
        source=source,
    )


def _write_sides(writer: Writer) -> None:
    """tan(δ/2) and tan(D − δ/2), each as a quotient."""
    names = {root_near: sqrt(near), root_far: sqrt(far), **halves(half_width)}
    names |= {uneven: sqrt(far) - sqrt(near), versine: 1 - chi, coversine: 1 + chi}
    behind, ahead = sqrt(near) * (1 - chi), sqrt(far) * (1 + chi)
    high = writer.add(
        "turn_level",
        (root_near, root_far, versine, coversine),
        root_near * versine + root_far * coversine,
        "√P(1 − cos χ) + √P′(1 + cos χ)",
        lambda value: Equal(value.subs(names), behind + ahead),
        TURNS,
        steps=("phase_tangent_squared",),
    )
    slant = writer.add(
        "turn_tilt",
        (root_near, root_far, uneven, chi),
        uneven + chi * (root_near + root_far),
        "√P′(1 + cos χ) − √P(1 − cos χ), with uneven = √P′ − √P",
        lambda value: Equal(value.subs(names), ahead - behind),
        TURNS,
        steps=("phase_tangent_squared",),
    )
    writer.add(
        "turn_tilt_apart",
        (root_near, root_far, versine, coversine),
        root_far * coversine - root_near * versine,
        "√P′(1 + cos χ) − √P(1 − cos χ) where P and P′ are far apart",
        lambda value: Equal(value.subs(names), ahead - behind),
        TURNS,
        steps=("phase_tangent_squared",),
    )
    above = writer.add(
        "turn_over",
        (root, half_sine, half_cosine, part),
        2 * half_sine * half_cosine * root * part,
        "sin D times √P(1 − cos χ), or √P′(1 + cos χ)",
        lambda value: Equal(value.subs(names), sin(half_width) * root * part),
        TURNS.with_range(root, 0, oo).with_range(part, 0, 2),
        steps=("phase_tangent_squared",),
        source="DLMF 4.21(iii)",
    )

    def meets(value: Expr, side: int) -> Equal:
        """sin(D − δ/2) = sin D cos(δ/2) − cos D sin(δ/2), and the same from the far turning point."""
        own, other = (behind, ahead) if side > 0 else (ahead, behind)
        first = above.subs({root: 1, part: own}).subs(names)
        second = value.subs({level: high, tilt: side * slant}).subs(names)
        return Equal(other * first, own * (sin(half_width) * second - cos(half_width) * first))

    doc = "by which turn_over is divided for tan(δ/2); with −tilt for tan(D − δ/2)"
    below = writer.add(
        "turn_under",
        (half_sine, half_cosine, level, tilt),
        half_cosine**2 * level + half_sine**2 * tilt,
        doc,
        lambda value: meets(value, 1),
        TURNS,
        steps=("turn_over", "turn_level", "turn_tilt", "phase_tangent_squared"),
    )
    mirrored, steps = meets(below, -1), ("turn_under",)
    writer.claim("turn_under_far", "the same from the far turning point", mirrored, TURNS, steps=steps)
    writer.add(
        "unit_sine",
        (over, under),
        over / sqrt(over**2 + under**2),
        "sine of the angle in (0, π) whose tangent is over/under",
        lambda value: Equal(value**2 / (1 - value**2), (over / under) ** 2),
        Domain({over: (0, oo), under: (-oo, oo)}),
        steps=("turn_over", "turn_under"),
        source="DLMF 4.14.7",
    )
