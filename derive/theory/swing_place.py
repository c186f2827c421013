"""Points of the motion by the phase ψ, whether X₂ and X₃ are real or conjugate.

X₁ = a⁴ cos²ψ/(sin²ψ Δ²), with a, b and Δ of ``swing_phase``: (ê₁ − ê₂)(ê₁ − ê₃) = PP′/64 = a⁴, and the sum of the two
differences is R/4 = 4b² − 2a². So √X₂√X₃ and √X₂ + √X₃ are real whatever the sign of the discriminant.
"""

from __future__ import annotations

from dataclasses import dataclass

from sympy import Expr, Integer, Symbol, cos, diff, oo, sin, sqrt

from .claims import Domain, Equal, Limit
from .oblique_shape import b
from .swing_names import (
    Writer,
    done,
    done_sine,
    excess,
    far,
    half_cosine,
    half_width,
    left_sine,
    near,
    root_far,
    root_near,
    sine,
    uneven,
)
from .swing_phase import MOTION, PHASE, delta, end, first, rate, rest, second, square, whole
from .swing_points import x_near
from .swing_rates import legendre

bend = Symbol("bend", real=True)  # a²/Δ
chi_rate = Symbol("rate", real=True)  # (dχ/dσ)/h
pair_root = Symbol("pair_root", real=True)  # √X₂√X₃
SPREAD = 4 * second**2 - 2 * first**2  # 2ê₁ − ê₂ − ê₃
SINES = Domain(
    {**dict.fromkeys((near, far, done_sine, left_sine, sine), (Integer(0), oo)), excess: (-sqrt(near * far), oo)}
)


@dataclass(frozen=True)
class Place:
    """In a, b and S = sin²ψ. near: X₁. pair: √X₂√X₃."""

    near: Expr
    pair: Expr


def write_place(writer: Writer) -> Place:
    """The formulas of X₁, √X₂√X₃, √X₂ + √X₃, x + √X₂√X₃ and θ_σ."""
    place = _write_near(writer)
    _write_root_sum(place, writer)
    _write_far(writer)
    _write_lift(place, writer)
    _write_by_sines(writer)
    return place


def _write_near(writer: Writer) -> Place:
    """X₁ by its derivative, X₁σ² = 4X₁X₂X₃, and its value at the tip."""
    root = rate(first, second, square)

    def moves(value: Expr) -> Equal:
        at = value.subs({bend: first**2 / root, rest: 1 - square})
        speed = diff(at, square) * 2 * sqrt(square * (1 - square)) * root
        return Equal(speed**2, 4 * at * (at**2 + SPREAD * at + first**4))

    by_phase = writer.add(
        "near_by_phase",
        (square, rest, bend),
        bend**2 * rest / square,
        "X₁ by sin²ψ, cos²ψ and bend = a²/Δ",
        moves,
        PHASE,
        steps=("phase_rate", "cubic_root", "far_slope", "excess_root", "middle_rate_squared", "end_rate_squared"),
        source="DLMF 19.25.35",
    )
    here = by_phase.subs({bend: first**2 / root, rest: 1 - square})
    zero = Limit(1 / here, square, Integer(0), Integer(0), "+")
    writer.claim("near_by_phase_tip", "X₁ is infinite at the tip", zero, PHASE, steps=("near_by_phase",))
    pair = first**2 * (first**2 * (1 - square) ** 2 + second**2 * square * (2 - square)) / (square * root**2)
    squared = Equal(pair**2, here**2 + SPREAD * here + first**4)
    writer.claim("pair_by_phase", "√X₂√X₃ by the phase", squared, PHASE, steps=("near_by_phase",))
    return Place(here, pair)


def _write_root_sum(place: Place, writer: Writer) -> None:
    """√X₂ + √X₃, and at the far turning point, where it is 2b."""
    root = rate(first, second, square)
    writer.add(
        "pair_root_sum",
        (square, delta),
        2 * delta / sqrt(square),
        "√X₂ + √X₃ by sin²ψ and Δ",
        lambda value: Equal(value.subs(delta, root) ** 2, 2 * place.near + SPREAD + 2 * place.pair),
        PHASE,
        steps=("near_by_phase", "pair_by_phase"),
        source="DLMF 19.26(iii)",
    )


def _write_far(writer: Writer) -> None:
    """√X₂√X₃ at the far turning point."""
    writer.add(
        "far_pair_root",
        (end,),
        end**2 / 4,
        "√X₂√X₃ at the far turning point, by the rate of χ there",
        lambda value: Equal(value**2, near * far / 64),
        Domain({near: (0, oo), far: (0, oo)}),
        given=((end, sqrt(sqrt(near * far) / 2)),),
        steps=("far_slope", "end_rate_squared"),
    )


def _write_lift(place: Place, writer: Writer) -> None:
    """x + √X₂√X₃ = ê₁ + X₁ + √X₂√X₃: √P√P′ + P cos D is small where the motion is nearly a whole turn."""
    turn = uneven + 2 * root_near * half_cosine**2
    names = {
        **{root_near: sqrt(near), root_far: sqrt(far), half_cosine: cos(half_width / 2)},
        **{uneven: sqrt(far) - sqrt(near), rest: 1 - square},
    }
    where = Domain({**MOTION.ranges, first: (0, oo), second: (0, oo), square: (0, 1)})
    writer.add(
        "pair_lift",
        (root_near, root_far, uneven, half_cosine, square, rest),
        root_near * (turn + 2 * root_far * rest / square) / 8,
        "x + √X₂√X₃ by the phase, with uneven = √P′ − √P",
        lambda value: Equal(value.subs(names), near * cos(half_width) / 8 + place.near + place.pair),
        where,
        given=((first, sqrt(sqrt(near) * sqrt(far) / 8)),),
        steps=("near_by_phase", "pair_by_phase", "far_root", "end_rate_squared"),
    )


def _write_by_sines(writer: Writer) -> None:
    """√X₂√X₃ and θ_σ by the half-angle sines and the rate of χ: sin²D·Q is its square times that of the sum."""
    tangent = sqrt(far) * done_sine / (sqrt(near) * left_sine)
    at_turns, middle = sqrt(near * far) / 2, (sqrt(near * far) + excess) / 4
    names = {
        root_near: sqrt(near),
        chi_rate: sqrt(legendre(at_turns, middle, tangent) / at_turns),
        whole: sqrt(far) * done_sine + sqrt(near) * left_sine,
    }
    factor = near * left_sine**2 + far * done_sine**2 + 2 * excess * done_sine * left_sine  # sin²D·Q
    steps = ("middle_excess", "phase_sum", "phase_tangent_squared", "middle_rate_squared", "end_rate_squared")
    writer.add(
        "pair_root",
        (root_near, done_sine, whole, chi_rate),
        root_near * chi_rate * whole / (8 * done_sine),
        "√X₂√X₃ by the phase's sum and the rate of χ over that at the turning points",
        lambda value: Equal(value.subs(names) ** 2, near * factor / (64 * done_sine**2)),
        SINES,
        steps=(*steps, "pair_product"),
    )
    writer.add(
        "turn_speed",
        (sine, done_sine, left_sine, whole, chi_rate),
        chi_rate * whole * sqrt(2 * done_sine * left_sine) / sine,
        "|θ_σ| by the phase's sum and the rate of χ over that at the turning points",
        lambda value: Equal(value.subs(names) ** 2, 2 * done_sine * left_sine * factor / sine**2),
        SINES,
        steps=(*steps, "sines", "factor_at"),
        source="exsl8",
    )
    pole = b * cos(done / 2) / sin(done / 2)
    writer.add(
        "point_speed",
        (b, done_sine, x_near, pair_root),
        4 * sqrt(x_near) * pair_root * done_sine**2 / b,
        "|θ_σ| by X₁ and √X₂√X₃",
        lambda value: Equal((diff(pole, done) * value.subs(done_sine, sin(done / 2))) ** 2, 4 * x_near * pair_root**2),
        Domain({b: (0, oo), done: (0, 6), x_near: (0, oo), pair_root: (0, oo)}),
        steps=("point_pole", "cubic_root"),
        source="exsl8",
        emitted=False,
    )
