"""The phase a length before a known one, by Jacobi's addition theorem.

A phase that is computed from a long length is as good as that length's rounding. Beside the clamp, whose phase the
angles give, it is told by the short length to the clamp. All sums are of positive terms; the one difference is of the
squares themselves.
"""

from __future__ import annotations

from sympy import Expr, Symbol, diff, oo, sqrt, symbols

from .claims import Domain, Equal
from .swing_names import Writer
from .swing_phase import delta, first, rate, rest, second, square

by_square, by_rest = symbols("by_square by_rest", real=True)  # sin² and cos² of the phase at the length taken off
by_delta = Symbol("by_delta", real=True)  # Δ there
over = Symbol("over", real=True)
fall = Symbol("fall", real=True)  # by how much sin²ψ is greater than at the length taken off
PHASES = Domain({first: (0, oo), second: (0, oo), square: (0, 1), by_square: (0, 1)})
SOURCE = "DLMF 22.8(i)"


def write_before(writer: Writer) -> None:
    """sin ψ and cos ψ at the difference of two lengths from the tip."""
    a, steps = first, ("phase_rate",)
    below = a / by_delta * rest + by_delta / a * square
    inner = a**2 + (second**2 - a**2) * square * by_square
    writer.add(
        "before_over",
        (first, square, rest, by_delta),
        below,
        "what the cosine of a difference of lengths is divided by; by_delta is Δ at the length taken off",
        lambda value: Equal(known(value * a * by_delta), inner),
        PHASES,
        steps=steps,
        source=SOURCE,
    )
    cosine = writer.add(
        "before_cosine",
        (first, square, rest, delta, by_square, by_rest, by_delta, over),
        (a / by_delta * sqrt(rest * by_rest) + sqrt(square * by_square) * delta / a) / over,
        "cos ψ at the difference of two lengths from the tip",
        lambda value: of_the_difference(value.subs(over, below)),
        PHASES,
        steps=(*steps, "before_over"),
        source=SOURCE,
    )
    cosine = cosine.subs(over, below)
    start = Equal(known(cosine).subs(by_square, 0), sqrt(1 - square))
    writer.claim("before_nothing", "the phase itself, less nothing", start, PHASES, steps=("before_cosine",))
    writer.add(
        "before_sine",
        (first, square, rest, delta, by_square, by_rest, by_delta, fall),
        a / by_delta * fall / (sqrt(square * by_rest) + sqrt(by_square * rest) * (delta / by_delta)),
        "sin ψ at the difference of two lengths from the tip, by the difference of their sin²ψ",
        lambda value: Equal(known(value.subs(fall, square - by_square) ** 2 + cosine**2), 1),
        PHASES,
        steps=(*steps, "before_cosine"),
        source=SOURCE,
    )


def known(value: Expr) -> Expr:
    """A value by sin²ψ at both lengths alone."""
    there = {by_rest: 1 - by_square, by_delta: rate(first, second, by_square)}
    return value.subs({rest: 1 - square, delta: rate(first, second, square), **there}, simultaneous=True)


def of_the_difference(value: Expr) -> Equal:
    """It depends on the difference alone: its slopes along both lengths are opposite. dS/dσ = 2 sin ψ cos ψ Δ."""
    at = known(value)
    along = diff(at, square) * known(sqrt(square * rest) * delta)
    return Equal(along, -diff(at, by_square) * known(sqrt(by_square * by_rest) * by_delta))
