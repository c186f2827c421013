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
share = Symbol("share", real=True)  # (b/a)²
ratio, by_ratio = symbols("ratio by_ratio", real=True)  # Δ/a at both lengths
over = Symbol("over", real=True)
fall = Symbol("fall", real=True)  # by how much sin²ψ is greater than at the length taken off
PHASES = Domain({first: (0, oo), second: (0, oo), square: (0, 1), by_square: (0, 1)})
SOURCE = "DLMF 22.8(i)"


def write_before(writer: Writer) -> None:
    """sin ψ and cos ψ at the difference of two lengths from the tip."""
    a, steps = first, ("phase_rate",)
    below = rest + square * by_ratio**2
    inner = a**2 + (second**2 - a**2) * square * by_square
    writer.add(
        "phase_ratio",
        (share, square, rest),
        sqrt(rest + share * square),
        "Δ/a by share = (b/a)²",
        lambda value: Equal(known(value.subs(share, second**2 / a**2)) ** 2, known(delta**2) / a**2),
        PHASES,
        steps=steps,
        source="DLMF 19.2.4",
    )
    writer.add(
        "before_over",
        (square, rest, by_ratio),
        below,
        "what the cosine of a difference of lengths is divided by; by_ratio is Δ/a at the length taken off",
        lambda value: Equal(known(value) * a**2, inner),
        PHASES,
        steps=("phase_ratio",),
        source=SOURCE,
    )
    cosine = writer.add(
        "before_cosine",
        (square, rest, ratio, by_square, by_rest, by_ratio, over),
        (sqrt(rest * by_rest) + sqrt(square * by_square) * ratio * by_ratio) / over,
        "cos ψ at the difference of two lengths from the tip",
        lambda value: of_the_difference(value.subs(over, below)),
        PHASES,
        steps=("phase_ratio", "before_over"),
        source=SOURCE,
    )
    cosine = cosine.subs(over, below)
    start = Equal(known(cosine).subs(by_square, 0), sqrt(1 - square))
    writer.claim("before_nothing", "the phase itself, less nothing", start, PHASES, steps=("before_cosine",))
    writer.add(
        "before_sine",
        (square, rest, ratio, by_square, by_rest, by_ratio, fall),
        fall / (sqrt(square * by_rest) * by_ratio + sqrt(by_square * rest) * ratio),
        "sin ψ at the difference of two lengths from the tip, by the difference of their sin²ψ",
        lambda value: Equal(known(value.subs(fall, square - by_square) ** 2 + cosine**2), 1),
        PHASES,
        steps=("phase_ratio", "before_cosine"),
        source=SOURCE,
    )


def known(value: Expr) -> Expr:
    """A value by sin²ψ at both lengths alone."""
    here, there = rate(first, second, square), rate(first, second, by_square)
    at = {delta: here, ratio: here / first, by_delta: there, by_ratio: there / first}
    return value.subs({rest: 1 - square, by_rest: 1 - by_square, **at}, simultaneous=True)


def of_the_difference(value: Expr) -> Equal:
    """It depends on the difference alone: its slopes along both lengths are opposite. dS/dσ = 2 sin ψ cos ψ Δ."""
    at = known(value)
    along = diff(at, square) * known(sqrt(square * rest) * delta)
    return Equal(along, -diff(at, by_square) * known(sqrt(by_square * by_rest) * by_delta))
