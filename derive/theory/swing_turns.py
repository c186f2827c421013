"""The motion between its turning points: V(φ) − V(θ) as a product, and the length as a Legendre integral.

With u = θ − M, 2(V(φ) − V(θ)) = (cos u − cos D)Q, Q = a₀ − η cos(θ + M − 2α). Two sines of half the distances to the
turning points make the first factor, S₁ = sin(δ/2) and S₂ = sin(D − δ/2): cos u − cos D = 2S₁S₂. And by the same sines
sin²D·Q = P S₂² + P′S₁² + 2R S₁S₂. Then tan²(χ/2) = √(P′/P)S₁/S₂ makes dσ = dχ/√(h² cos²χ + g² sin²χ).
"""

from __future__ import annotations

from dataclasses import dataclass

from sympy import Expr, Symbol, cos, diff, oo, pi, sin, sqrt

from .claims import Domain, Equal
from .swing_levels import FIELD, Levels
from .swing_names import (
    PAIR,
    Writer,
    above,
    done,
    excess,
    far,
    field_angle,
    half_width,
    left,
    mean,
    middle,
    moment_there,
    near,
    turned,
)
from .symbols import beta, eta, theta

TURNS = (*FIELD, middle, half_width)
# P and P′ are positive, R has either sign.
FACTORS = Domain({near: (0, oo), far: (0, oo), excess: (-oo, oo), half_width: (0, pi), done: (0, 2 * half_width)})
tangent = Symbol("T", positive=True)  # tan²(χ/2)


@dataclass(frozen=True)
class Turns:
    """In β, η, α, M, D and θ. factor: Q. balance: zero for a pair of turning points. excess: R. mean: a₀."""

    factor: Expr
    balance: Expr
    excess: Expr
    mean: Expr

    def at(self, side: int) -> Expr:
        """P for −1, P′ for 1."""
        return turned(self.factor, middle + side * half_width)


def write_turns(levels: Levels, writer: Writer) -> Turns:
    """The formulas of the motion between two turning points."""
    phase = theta + middle - 2 * field_angle
    average = -2 * beta * cos(middle) - eta * cos(half_width) * cos(2 * (middle - field_angle))
    factor = average - eta * cos(phase)
    # That V is the same at M − D and M + D, over 2 sin D.
    balance = 2 * beta * sin(middle) + eta * cos(half_width) * sin(2 * (middle - field_angle))
    force, field = beta * cos(middle), eta * cos(2 * (middle - field_angle))
    turns = Turns(factor, balance, -2 * force * cos(half_width) - field * (1 + cos(half_width) ** 2), average)
    _write_factor(levels, turns, writer)
    _write_sines(turns, writer)
    _write_rates(writer)
    return turns


def _write_factor(levels: Levels, turns: Turns, writer: Writer) -> None:
    """Q, P and P′; what is left where the two angles are no pair is a multiple of the balance."""
    first, last = middle - half_width, middle + half_width
    fall = 2 * (turned(levels.potential, first) - levels.potential)
    ahead = cos(theta - middle) - cos(half_width)
    rest = (sin(half_width) + sin(theta - middle)) * turns.balance
    pair = Equal(sin(half_width) * turns.balance, turned(levels.potential, first) - turned(levels.potential, last))
    writer.claim("pair", "the balance of two turning points", pair, PAIR, steps=("level_drop",))
    writer.add(
        "factor_at",
        (*TURNS, theta),
        turns.factor,
        "Q at an angle: 2(V(φ) − V(θ)) = (cos(θ − M) − cos D)Q between turning points",
        lambda value: Equal(ahead * value + rest, fall),
        PAIR.with_range(theta, -pi, pi),
        steps=("pair", "fall"),
    )
    # The slope of 2(V(φ) − V(θ)) is 2θ″.

    def doubled(value: Expr, side: int) -> Equal:
        there = -side * turned(levels.moment, middle + side * half_width)
        lost = side * cos(half_width) / sin(half_width) * turns.balance
        return Equal(value.subs(moment_there, there), turns.at(side) - lost)

    by_moment = writer.add(
        "turn_factor",
        (moment_there, half_width),
        2 * moment_there / sin(half_width),
        "P, or P′: Q at a turning point, by θ″ there towards the other one",
        lambda value: doubled(value, -1),
        PAIR,
        steps=("factor_at", "moment"),
    )
    writer.claim(
        "turn_factor_far", "P′ by θ″", doubled(by_moment, 1), PAIR, steps=("factor_at", "moment", "turn_factor")
    )


def _write_sines(turns: Turns, writer: Writer) -> None:
    """Q by P, P′ and R; a₀, and what parts √(PP′) from R."""
    first, last, gap = turns.at(-1), turns.at(1), done - half_width
    ahead, behind = sin(half_width - done / 2), sin(done / 2)
    half_angles = Equal(cos(gap) - cos(half_width), 2 * behind * ahead)
    where = Domain({half_width: (0, pi), done: (0, 2 * half_width)})
    writer.claim("sines", "cos u − cos D by half angles", half_angles, where, steps=(), source="DLMF 4.21(i)")
    there = turned(turns.factor, middle + gap)
    writer.add(
        "middle_excess",
        TURNS,
        turns.excess,
        "R: the part of sin²D·Q that goes with both half-angle sines",
        lambda value: Equal(
            sin(half_width) ** 2 * there, first * ahead**2 + last * behind**2 + 2 * value * ahead * behind
        ),
        PAIR.with_range(done, 0, 2 * half_width),
        steps=("factor_at", "turn_factor", "turn_factor_far"),
    )
    writer.add(
        "mean_factor",
        TURNS,
        turns.mean,
        "a₀, the mean of Q over all directions: PP′ − R² = sin²D(a₀² − η²)",
        lambda value: Equal(first * last - turns.excess**2, sin(half_width) ** 2 * (value**2 - eta**2)),
        PAIR,
        steps=("factor_at", "middle_excess"),
    )


def legendre(rate: Expr, middle_rate: Expr, square: Expr) -> Expr:
    """h² cos²χ + g² sin²χ by tan²(χ/2)."""
    return (rate * (1 - square) ** 2 + 4 * middle_rate * square) / (1 + square) ** 2


def _write_rates(writer: Writer) -> None:
    """tan²(χ/2), and the two rates h and g of χ along the rod: at the turning points and where χ = π/2."""
    ratio = sqrt(far / near) * sin(done / 2) / sin(left / 2)
    rate, middle_rate = sqrt(near * far) / 2, (sqrt(near * far) + excess) / 4
    chi = Symbol("chi", real=True)
    by_half = legendre(near, far, sin(chi / 2) ** 2 / cos(chi / 2) ** 2)
    angle, whole = Domain({near: (0, oo), far: (0, oo), chi: (0, pi)}), near * cos(chi) ** 2 + far * sin(chi) ** 2
    writer.claim("legendre", "the form by tan²(χ/2)", Equal(by_half, whole), angle, steps=(), source="DLMF 19.2.4")
    behind, ahead = sin(done / 2), sin(half_width - done / 2)
    squared = 2 * behind * ahead * (near * ahead**2 + far * behind**2 + 2 * excess * ahead * behind)

    def moves(value: Expr) -> Equal:
        # dχ = dT/(√T(1 + T)) with T = tan²(χ/2).
        square = value.subs(left, 2 * half_width - done)
        speed = diff(square, done) ** 2 / (square * (1 + square) ** 2) * squared / sin(half_width) ** 2
        return Equal(speed, legendre(rate, middle_rate, square))

    writer.add(
        "phase_tangent_squared",
        (near, far, done, left),
        ratio,
        "tan²(χ/2): χ runs from 0 at the tip to π at the far turning point, dσ = dχ/√(h² cos²χ + g² sin²χ)",
        moves,
        FACTORS,
        steps=("legendre", "sines", "factor_at", "middle_excess", "fall"),
        source="DLMF 19.29(i)",
    )
    # The integrand's two rates, read off at χ = 0 and at χ = π/2.
    writer.add(
        "end_rate_squared",
        (near, far),
        rate,
        "h²: (dχ/dσ)² at the turning points",
        lambda value: Equal(value, legendre(rate, middle_rate, tangent).subs(tangent, 0)),
        FACTORS,
        steps=("phase_tangent_squared",),
    )
    writer.add(
        "middle_rate_squared",
        (near, far, excess),
        middle_rate,
        "g²: (dχ/dσ)² at χ = π/2, for R of either sign",
        lambda value: Equal(value, legendre(rate, middle_rate, tangent).subs(tangent, 1)),
        FACTORS,
        steps=("phase_tangent_squared",),
    )
    _write_apart(middle_rate, writer)


def _write_apart(middle_rate: Expr, writer: Writer) -> None:
    """g² as a product, where R < 0 and √(PP′) + R would cancel."""
    product = sin(half_width) ** 2 * above * (mean + eta)
    where = {near: (0, oo), eta: (0, oo), half_width: (0, pi), mean: (eta, oo), excess: (-oo, 0)}
    writer.add(
        "middle_rate_squared_apart",
        (near, far, excess, eta, half_width, mean, above),
        product / (4 * (sqrt(near * far) - excess)),
        "g² by the factors of PP′ − R², with above = a₀ − η, for R < 0",
        lambda value: Equal(value, middle_rate),
        Domain(where),
        given=((far, (excess**2 + product) / near), (above, mean - eta)),
        steps=("middle_rate_squared", "mean_factor"),
    )
