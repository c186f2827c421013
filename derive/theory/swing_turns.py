"""The motion between its turning points: V(φ) − V(θ) as a product.

With u = θ − M, 2(V(φ) − V(θ)) = (cos u − cos D)Q, Q = a₀ − η cos(θ + M − 2α). Two sines of half the distances to the
turning points make the first factor, S₁ = sin(δ/2) and S₂ = sin(D − δ/2): cos u − cos D = 2S₁S₂. And by the same sines
sin²D·Q = P S₂² + P′S₁² + 2R S₁S₂.
"""

from __future__ import annotations

from dataclasses import dataclass

from sympy import Expr, Symbol, cos, oo, pi, sin, sqrt

from .claims import Domain, Equal
from .swing_levels import FIELD, Levels
from .swing_names import (
    PAIR,
    Writer,
    cosine,
    done,
    double_cosine,
    drop,
    far,
    field_angle,
    half_width,
    lean,
    middle,
    moment_there,
    near,
    root_far,
    root_near,
    sine,
    turned,
)
from .symbols import beta, eta, theta

TURNS = (*FIELD, middle, half_width)
middle_cosine = Symbol("middle_cosine", real=True)  # cos M
outer_sine, inner_sine = Symbol("outer_sine", real=True), Symbol("inner_sine", real=True)  # sin(D/2), sin(u/2)


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
    _write_sines(levels, turns, writer)
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
        emitted=False,
    )
    # The slope of 2(V(φ) − V(θ)) is 2θ″.

    def doubled(value: Expr, side: int) -> Equal:
        there = -side * turned(levels.moment, middle + side * half_width)
        lost = side * cos(half_width) / sin(half_width) * turns.balance
        return Equal(value.subs({moment_there: there, sine: sin(half_width)}), turns.at(side) - lost)

    by_moment = writer.add(
        "turn_factor",
        (moment_there, sine),
        2 * moment_there / sine,
        "P, or P′: Q at a turning point, by θ″ there towards the other one and sin D",
        lambda value: doubled(value, -1),
        PAIR,
        steps=("factor_at", "moment"),
    )
    writer.claim(
        "turn_factor_far", "P′ by θ″", doubled(by_moment, 1), PAIR, steps=("factor_at", "moment", "turn_factor")
    )


def _write_sines(levels: Levels, turns: Turns, writer: Writer) -> None:
    """Q by P, P′ and R; a₀, and what parts √(PP′) from R."""
    first, last, gap = turns.at(-1), turns.at(1), done - half_width
    ahead, behind = sin(half_width - done / 2), sin(done / 2)
    half_angles = Equal(cos(gap) - cos(half_width), 2 * behind * ahead)
    where = Domain({half_width: (0, pi), done: (0, 2 * half_width)})
    writer.claim("sines", "cos u − cos D by half angles", half_angles, where, steps=(), source="DLMF 4.21(i)")
    there = turned(turns.factor, middle + gap)
    fall = 2 * (turned(levels.potential, middle - half_width) - levels.potential)
    names = {
        middle_cosine: cos(middle),
        double_cosine: cos(2 * (middle - field_angle)),
        cosine: cos(half_width),
    }
    writer.add(
        "middle_excess",
        (beta, eta, *names),
        -(2 * beta * middle_cosine * cosine + eta * double_cosine * (1 + cosine**2)),
        "R: the part of sin²D·Q that goes with both half-angle sines, by cos M, cos 2(M − α) and cos D",
        lambda value: Equal(
            sin(half_width) ** 2 * there, first * ahead**2 + last * behind**2 + 2 * value.subs(names) * ahead * behind
        ),
        PAIR.with_range(done, 0, 2 * half_width),
        steps=("factor_at", "turn_factor", "turn_factor_far"),
    )
    writer.add(
        "mean_factor",
        (beta, eta, *names),
        -(2 * beta * middle_cosine + eta * double_cosine * cosine),
        "a₀, the mean of Q over all directions: PP′ − R² = sin²D(a₀² − η²)",
        lambda value: Equal(first * last - turns.excess**2, sin(half_width) ** 2 * (value.subs(names) ** 2 - eta**2)),
        PAIR,
        steps=("factor_at", "middle_excess"),
    )
    writer.add(
        "skew",
        (eta, field_angle, middle),
        eta * sin(2 * (middle - field_angle)),
        "(P′ − P)/(2 sin D), zero for a motion that is symmetric about its middle",
        lambda value: Equal(last - first, 2 * sin(half_width) * value),
        PAIR,
        steps=("factor_at", "turn_factor", "turn_factor_far"),
    )
    by_skew = {root_near: sqrt(near), root_far: sqrt(far), lean: (far - near) / (2 * sine)}
    writer.add(
        "root_skew",
        (root_near, root_far, lean, sine),
        2 * lean * sine / (root_near + root_far),
        "√P′ − √P by sin D and skew",
        lambda value: Equal(value.subs(by_skew), sqrt(far) - sqrt(near)),
        Domain({near: (0, oo), far: (0, oo), sine: (0, 1)}),
        steps=("skew",),
    )
    # Where cos(θ + M − 2α) is 1, Q is a₀ − η; cos u − cos D = 2(sin²(D/2) − sin²(u/2)).
    shift, lowest = 2 * (field_angle - middle), 2 * field_angle - middle
    outside = (sin(half_width) + sin(shift)) * turns.balance
    edges = {outer_sine: sin(half_width / 2), inner_sine: sin(shift / 2)}
    writer.add(
        "mean_above",
        (drop, outer_sine, inner_sine),
        drop / ((outer_sine - inner_sine) * (outer_sine + inner_sine)),
        "a₀ − η by what V falls from the tip to the direction 2α − M, sin(D/2) and sin(α − M)",
        lambda value: Equal(
            value.subs(drop, drop - outside / 2).subs(edges).subs(drop, turned(fall, lowest) / 2), turns.mean - eta
        ),
        PAIR,
        steps=("mean_factor", "factor_at"),
    )
