"""R and a₀ − η by one end of the motion.

That V is the same at both ends lets β and α go: what is left are D, P (or P′) and dθ″/dθ at that end. Where V is nearly
level about the end both are small, and so are R and a₀ − η. The sine of D + 2(M − α) is then small too, zero where
the far turning point is one with two more of the four directions in which V is that of the tip.
"""

from __future__ import annotations

from sympy import Add, Expr, Matrix, Rational, Symbol, cos, diff, oo, sin

from .claims import Equal
from .swing_levels import Levels, stiffness
from .swing_names import PAIR, Writer, cosine, field_angle, half_width, middle, sine, turned
from .swing_turns import Turns
from .symbols import eta, theta

rate = Symbol("rate", real=True)  # P, or P′
twist_sine = Symbol("twist_sine", real=True)  # sin(D + 2(M − α)), or sin(D − 2(M − α)) at the tip
twist_cosine = Symbol("twist_cosine", real=True)  # the cosine of the same


def write_ends(levels: Levels, turns: Turns, writer: Writer) -> None:
    """The formulas, each for the tip and for the far turning point."""
    stiff, balance = diff(levels.moment, theta), turns.balance

    def at(value: Expr, side: int) -> Expr:
        # The tip is side −1, the far turning point side 1.
        twist = half_width + side * 2 * (middle - field_angle)
        names = {
            rate: turns.at(side),
            stiffness: turned(stiff, Add(middle, side * half_width)),
            sine: sin(half_width),
            cosine: cos(half_width),
            twist_sine: sin(twist),
            twist_cosine: cos(twist),
        }
        return value.subs(names)

    def both(value: Expr, left: Expr) -> Matrix:
        # left: what is there of the balance where the two angles are no pair.
        return Matrix([at(value, 1) + left, at(value, -1) - left])

    writer.add(
        "end_excess",
        (rate, stiffness, cosine),
        stiffness + Rational(3, 2) * rate * cosine,
        "R by one end of the motion: by P (or P′) and dθ″/dθ there, and cos D",
        lambda value: Equal(both(value, sin(half_width) * balance / 2), Matrix([turns.excess, turns.excess])),
        PAIR,
        steps=("middle_excess", "factor_at", "rest_stiffness"),
    )
    writer.add(
        "end_twist",
        (eta, rate, stiffness, sine, cosine),
        -(stiffness + rate * cosine / 2) / (eta * sine),
        "sin(D + 2(M − α)) by the far turning point, or sin(D − 2(M − α)) by the tip",
        lambda value: Equal(
            eta * both(value, -balance / (2 * eta)), eta * Matrix([at(twist_sine, 1), at(twist_sine, -1)])
        ),
        PAIR.with_range(eta, 0, oo),
        steps=("factor_at", "rest_stiffness"),
    )
    writer.add(
        "end_above",
        (eta, rate, twist_sine, twist_cosine),
        rate - eta * twist_sine**2 / (1 + twist_cosine),
        "a₀ − η by P (or P′), and by the sine and cosine of D ± 2(M − α)",
        lambda value: Equal(
            Matrix([at(value * (1 + twist_cosine), side) for side in (1, -1)]),
            Matrix([at((turns.mean - eta) * (1 + twist_cosine), side) for side in (1, -1)]),
        ),
        PAIR,
        steps=("mean_factor", "factor_at", "end_twist"),
    )
