"""The phase ψ of the motion, by which its lengths are computed.

χ runs through half a turn in a half-swing, ψ through a quarter: with a and b half of the rates h and g,
dσ = dψ/√(a² cos²ψ + b² sin²ψ). Gauss's step replaces a and b by their arithmetic and geometric mean and keeps the
integral. All terms are positive, in the step and where it is undone; angles enter by S = sin² and C = cos².
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import partial

from sympy import Expr, Symbol, diff, oo, sin, sqrt, symbols

from .claims import Domain, Equal
from .swing_names import (
    Writer,
    done,
    done_sine,
    far,
    half_cosine,
    half_width,
    halves,
    left_sine,
    near,
    root_far,
    root_near,
    uneven,
)
from .swing_rates import tangent

first, second = symbols("first second", real=True)  # the rates at the beginning and at the end: a and b
end, middle_rate = symbols("end middle", real=True)  # h and g
square, rest = symbols("square rest", real=True)  # sin² and cos² of the phase
delta = Symbol("delta", real=True)  # √(a² cos² + b² sin²) there
behind, ahead = symbols("behind ahead", real=True)  # √P′ sin(δ/2), √P sin(D − δ/2)
gap_sine = Symbol("gap_sine", real=True)  # sin of a quarter of what is left less what is done
tilt = Symbol("tilt", real=True)  # |cos χ|
total = Symbol("total", real=True)  # a + b
below = Symbol("below", real=True)  # a + Δ; where the step is undone 2a(a + b)/(a + Δ)
step_gap = Symbol("gap", real=True)  # a − b
across = Symbol("across", real=True)  # sin ψ cos ψ
whole = Symbol("whole", real=True)  # √P′ sin(δ/2) + √P sin(D − δ/2)
PHASE = Domain({first: (0, oo), second: (0, oo), square: (0, 1)})
MOTION = Domain({near: (0, oo), far: (0, oo), half_width: (0, 3), done: (0, 2 * half_width)})


def rate(a: Expr, b: Expr, at: Expr) -> Expr:
    """√(a² cos² + b² sin²) by sin²."""
    return sqrt(a**2 * (1 - at) + b**2 * at)


@dataclass(frozen=True)
class Phase:
    """By S, C, a and b. rate: Δ. square, rest: sin² and cos² after Gauss's step."""

    rate: Expr
    square: Expr
    rest: Expr


def write_phase(writer: Writer) -> Phase:
    """χ of a point, ψ from it, and Gauss's step forth and back."""
    _write_chi(writer)
    _write_half(writer)
    step = _write_gauss(writer)
    _write_back(step, writer)
    return step


def _write_chi(writer: Writer) -> None:
    """sin²χ and cos χ by the half-angle sines: tan²(χ/2) is behind/ahead."""
    added = writer.add(
        "phase_sum",
        (root_near, root_far, done_sine, left_sine),
        root_far * done_sine + root_near * left_sine,
        "√P′ sin(δ/2) + √P sin(D − δ/2)",
        lambda value: Equal(value * tangent / (1 + tangent), root_far * done_sine),
        Domain(dict.fromkeys((root_near, root_far, done_sine, left_sine), (0, oo))),
        given=((tangent, root_far * done_sine / (root_near * left_sine)),),
        steps=("phase_tangent_squared",),
    )
    # The difference of the same, without the cancellation of P and P′ or of δ and 2D − δ.
    names = {
        **{root_near: sqrt(near), root_far: sqrt(far), uneven: sqrt(far) - sqrt(near)},
        **{done_sine: sin(done / 2), gap_sine: sin((half_width - done) / 2), left_sine: sin(half_width - done / 2)},
        half_cosine: halves(half_width)[half_cosine],
    }
    forward = 2 * root_near * half_cosine * gap_sine
    writer.add(
        "phase_lead",
        (root_near, half_cosine, uneven, done_sine, gap_sine),
        forward - uneven * done_sine,
        "√P sin(D − δ/2) − √P′ sin(δ/2), with gap_sine = sin((D − δ)/2) and uneven = √P′ − √P",
        lambda value: Equal((value + 2 * root_far * done_sine).subs(names), added.subs(names)),
        MOTION,
        steps=("phase_sum",),
    )
    shares = {behind: behind / (behind + ahead), ahead: ahead / (behind + ahead)}
    parts = Domain({behind: (0, oo), ahead: (0, oo)})
    quotient = Equal((ahead - behind) / (ahead + behind), (1 - tangent) / (1 + tangent))
    title, steps = "cos χ is the lead over the sum", ("phase_tangent_squared", "phase_sum", "phase_lead")
    writer.claim("phase_cosine", title, quotient, parts, given=((tangent, behind / ahead),), steps=steps)
    writer.add(
        "chi_square",
        (behind, ahead),
        4 * behind * ahead,
        "sin²χ, by the two parts of the phase's sum as shares of it",
        lambda value: Equal(value.subs(shares, simultaneous=True), 4 * tangent / (1 + tangent) ** 2),
        parts,
        given=((tangent, behind / ahead),),
        steps=("phase_tangent_squared", "phase_sum"),
        source="DLMF 4.21(iii)",
    )


def _write_half(writer: Writer) -> None:
    """ψ from χ: sin²ψ and cos²ψ before and beyond the middle of the motion."""
    # cos χ is ``tilt`` before the middle, and −tilt beyond it.
    root = sqrt(end**2 * tilt**2 + middle_rate**2 * (1 - tilt**2))
    where, source = Domain({end: (0, oo), middle_rate: (0, oo), tilt: (0, 1)}), "DLMF 22.6(iii)"
    given = ((square, 1 - tilt**2), (delta, root))

    def moves(value: Expr, side: int) -> Equal:
        # (dψ/d cos χ)²·(dχ/dσ)² sin²χ is a² cos²ψ + b² sin²ψ; with S = sin²ψ, dψ = dS/(2 sin ψ cos ψ).
        at = value.subs(delta, root).subs(square, 1 - tilt**2)
        speed = diff(at, tilt) ** 2 / (4 * at * (1 - at)) * (1 - tilt**2) * root**2
        return Equal(4 * speed, rate(end, middle_rate, at) ** 2)

    def whole(value: Expr, other: Expr) -> Equal:
        return Equal(value + other, 1)

    over = end + delta
    by_end = writer.add(
        "half_square",
        (end, square, tilt, delta),
        end * square / ((1 + tilt) * over),
        "sin²ψ by sin²χ = square and cos χ = tilt ≥ 0: χ runs to π, ψ to π/2, with half the rates",
        lambda value: moves(value, 1),
        where,
        steps=("phase_tangent_squared", "legendre"),
        source=source,
    )
    writer.add(
        "half_rest",
        (end, tilt, delta),
        (delta + end * tilt) / over,
        "cos²ψ by cos χ = tilt ≥ 0",
        lambda value: whole(value, by_end),
        where,
        given=given,
        steps=("half_square",),
        source=source,
    )
    by_end = writer.add(
        "half_square_beyond",
        (end, tilt, delta),
        end * (1 + tilt) / over,
        "sin²ψ by cos χ = −tilt ≤ 0",
        lambda value: moves(value, -1),
        where,
        steps=("half_square",),
        source=source,
    )
    writer.add(
        "half_rest_beyond",
        (end, middle_rate, square, tilt, delta),
        middle_rate**2 * square / ((delta + end * tilt) * over),
        "cos²ψ by sin²χ = square and cos χ = −tilt ≤ 0",
        lambda value: whole(value, by_end),
        where,
        given=given,
        steps=("half_square_beyond",),
        source=source,
    )


def _write_gauss(writer: Writer) -> Phase:
    """∫dψ/√(a² cos²ψ + b² sin²ψ) = ∫dψ′/√(a′² cos²ψ′ + b′² sin²ψ′), a′ = (a + b)/2 and b′ = √(ab)."""
    a, b, source = first, second, "DLMF 19.8(iii)"
    root = rate(a, b, square)
    delta_there = writer.add(
        "phase_rate",
        (first, second, square, rest),
        sqrt(a**2 * rest + b**2 * square),
        "Δ = √(a² cos²ψ + b² sin²ψ), dψ/dσ",
        lambda value: Equal(value.subs(rest, 1 - square), root),
        PHASE,
        steps=("half_square",),
        source="DLMF 19.2.4",
    )

    def squared(at: Expr, one: Expr, other: Expr) -> Expr:
        # (dψ/dS)²/(a² cos²ψ + b² sin²ψ) with S = sin²ψ.
        return 1 / (4 * at * (1 - at) * (one**2 * (1 - at) + other**2 * at))

    def keeps(value: Expr, one: Expr, other: Expr) -> Equal:
        at = value.subs(sums).subs({delta: root, rest: 1 - square})
        speed = diff(at, square) ** 2 * squared(at, one, other)
        return Equal(speed, squared(square, a, b))

    sums = {total: a + b, below: a + delta}
    new_square = writer.add(
        "gauss_square",
        (square, total, below),
        total**2 * square / below**2,
        "sin²ψ′ of Gauss's step, which keeps the integral: a′ = (a + b)/2, b′ = √(ab); total = a + b, below = a + Δ",
        lambda value: keeps(value, (a + b) / 2, sqrt(a * b)),
        PHASE,
        steps=("phase_rate",),
        source=source,
    )
    inner = a + (a**2 + b**2 * square) / (delta + b * square)
    new_rest = writer.add(
        "gauss_rest",
        (first, second, square, rest, delta, below),
        2 * a * rest * inner / below**2,
        "cos²ψ′ of Gauss's step, without a difference; below = a + Δ",
        lambda value: Equal((value + new_square).subs(sums).subs({delta: root, rest: 1 - square}), 1),
        PHASE,
        steps=("gauss_square",),
        source=source,
    )
    far_sine = writer.add(
        "far_sine",
        (first, rest, delta),
        a * sqrt(rest) / delta,
        "sin ψ of the same point by the length from the far turning point",
        lambda value: keeps(value**2, a, b),
        PHASE,
        steps=("phase_rate",),
        source="DLMF 22.4(iii)",
    )
    writer.add(
        "far_cosine",
        (second, square, delta),
        b * sqrt(square) / delta,
        "cos ψ of the same point by the length from the far turning point",
        lambda value: Equal((value**2 + far_sine**2).subs({delta: root, rest: 1 - square}), 1),
        PHASE,
        steps=("far_sine",),
        source="DLMF 22.4(iii)",
    )
    return Phase(delta_there, new_square.subs(sums), new_rest.subs(sums))


def _write_back(step: Phase, writer: Writer) -> None:
    """Gauss's step undone: ``square`` is that after it."""
    a, b, root = first, second, rate(first, second, square)
    before = 2 * a * (a + b) / (a + delta)

    def undone(value: Expr, known: Expr) -> Equal:
        found = value.subs(below, before).subs(square, step.square)
        return Equal(found.subs(delta, root), known.subs(delta, root))

    for name, arguments, expression, doc, known, steps in (
        ("back_below", (a, b, square), a + b + (a - b) * square, "2a(a + b)/(a + Δ) by sin²ψ′", before, ()),
        ("back_square", (a, square, below), 4 * a**2 * square / below**2, "sin²ψ by sin²ψ′", square, ("back_below",)),
    ):
        writer.add(
            name,
            arguments,
            expression,
            f"{doc}: Gauss's step undone",
            partial(undone, known=known),
            PHASE,
            steps=("gauss_square", *steps),
            source="DLMF 19.8(iii)",
            emitted=False,
        )
