"""∫sin²ψ dσ, and by how much the length exceeds τ = sin ψ cos ψ/Δ, by the same after Gauss's step.

They are what ``swing_energy`` takes of the second kind. Both are small as σ³ near the tip, and so are the parts that a
step adds to them: nothing cancels.
"""

from __future__ import annotations

from sympy import Expr, Symbol, diff, sqrt, symbols

from .claims import Equal
from .swing_names import Writer
from .swing_phase import PHASE, across, delta, first, rate, rest, second, square, step_gap, total

share = Symbol("share", real=True)  # k = (a − b)/(a + b)
first_share, second_share = symbols("first_share second_share", real=True)  # 1 + k and 1 − k
bend = Symbol("bend", real=True)  # what a step makes of τ


def write_second_kind(writer: Writer) -> None:
    """The parts of a step, and what they add up to; ``square``, ``rest``, ``across``, ``delta`` are those after it."""
    a, b = first, second
    mean, geometric = (a + b) / 2, sqrt(a * b)
    root, crossed = rate(mean, geometric, square), sqrt(square) * sqrt(1 - square)
    here = {share: (a - b) / (a + b), first_share: 2 * a / (a + b), second_share: 2 * b / (a + b), rest: 1 - square}
    here |= {across: crossed, delta: root}
    # The step undone: sin²ψ before it, and a + Δ.
    over = a + b + (a - b) * square
    before, total_there = 4 * a**2 * square / over**2, 2 * a * (a + b) / over
    added = writer.add(
        "phase_bend",
        (share, first_share, square, rest, across, delta),
        share * square * across / (delta * (first_share * square + rest)),
        "kS′τ′/(1 + kS′) after Gauss's step, by k = (a − b)/(a + b) and 1 + k; τ = sin ψ cos ψ/Δ",
        # 2 sin ψ cos ψ/(a + Δ) is τ′ less 1 + k of them.
        lambda value: Equal(
            ((across / delta - first_share * value).subs(here)) ** 2, 4 * before * (1 - before) / total_there**2
        ),
        PHASE,
        steps=("back_below", "back_square"),
        source="DLMF 19.8(iii)",
    )
    writer.add(
        "lag_step",
        (bend, share, second_share, square, rest),
        bend * share * rest / (second_share * square + rest),
        "τ′ − τ for τ = sin ψ cos ψ/Δ, τ′ the same after Gauss's step, by ``phase_bend``, k and 1 − k",
        lambda value: Equal(
            (across / delta - value.subs(bend, added)).subs(here) ** 2,
            before * (1 - before) / (total_there - a) ** 2,
        ),
        PHASE,
        steps=("phase_bend",),
        source="DLMF 19.8(iii)",
    )

    def along(value: Expr) -> Expr:
        # dS′/dσ = 2 sin ψ′ cos ψ′ Δ′.
        return diff(value, square) * 2 * crossed * root

    lost = (first_share * added - across / delta).subs(here)
    falls = Equal(2 * before, here[share] * square + 1 + along(lost))
    title = "2∫sin²ψ is k∫sin²ψ′, σ − τ′ and (1 + k)kS′τ′/(1 + kS′)"
    steps = ("gauss_square", "gauss_rest", "phase_bend", "back_square")
    writer.claim("second_kind_step", title, falls, PHASE, steps=steps, source="DLMF 19.8.19")
    start = Equal(added.subs({square: 0}), 0)
    writer.claim("second_kind_tip", "the terms are zero at the tip", start, PHASE, steps=("second_kind_step",))
    even = (crossed / a).subs(b, a)
    equal = Equal(2 * square, 1 - diff(even, square) * 2 * crossed * a)
    title = "where a = b, 2∫sin²ψ is σ − τ, and 2aσ − sin 2aσ is 2a times that"
    writer.claim("second_kind_end", title, equal, PHASE, steps=("phase_rate",), source="DLMF 19.2.4")
    writer.add(
        "gauss_gap",
        (step_gap, total),
        step_gap**2 / (4 * total),
        "a′ − b′ after Gauss's step, by gap = a − b and total = a′ + b′",
        lambda value: Equal(value.subs({step_gap: a - b, total: mean + geometric}), mean - geometric),
        PHASE,
        steps=("gauss_square",),
        source="DLMF 19.8(i)",
    )
