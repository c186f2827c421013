"""The length of the motion as a Legendre integral, and the step by which it is computed.

tan²(χ/2) = √(P′/P)S₁/S₂, with the sines S₁ = sin(δ/2) and S₂ = sin(D − δ/2) of ``swing_turns``, makes
dσ = dχ/√(h² cos²χ + g² sin²χ). Gauss's step replaces the rates by their arithmetic and geometric mean and keeps the
integral; all its terms are positive.
"""

from __future__ import annotations

from sympy import Expr, Symbol, cos, diff, oo, pi, sin, sqrt, symbols

from .claims import Domain, Equal
from .swing_names import Writer, above, done, excess, far, half_width, left, mean, near
from .symbols import eta

# P and P′ are positive, R has either sign.
FACTORS = Domain({near: (0, oo), far: (0, oo), excess: (-oo, oo), half_width: (0, pi), done: (0, 2 * half_width)})
tangent = Symbol("T", positive=True)  # tan²(χ/2)
rate_0, rate_1 = symbols("rate_0 rate_1", positive=True)  # the rates at χ = 0 and χ = π/2
sine = Symbol("S", positive=True)  # sin²χ


def legendre(rate: Expr, middle_rate: Expr, square: Expr) -> Expr:
    """h² cos²χ + g² sin²χ by tan²(χ/2)."""
    return (rate * (1 - square) ** 2 + 4 * middle_rate * square) / (1 + square) ** 2


def write_rates(writer: Writer) -> None:
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
        source="DLMF 19.14(ii)",
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
    _claim_gauss(writer)


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


def _claim_gauss(writer: Writer) -> None:
    """∫dχ/√(a² cos²χ + b² sin²χ) = ∫dχ′/√(a′² cos²χ′ + b′² sin²χ′), a′ = (a + b)/2 and b′ = √(ab)."""
    a, b, cosine = rate_0, rate_1, 1 - sine
    root = sqrt(a**2 * cosine + b**2 * sine)
    new_sine = (a + b) ** 2 * sine / (a + root) ** 2
    new_cosine = 2 * a * cosine * (a + (a**2 + b**2 * sine) / (root + b * sine)) / (a + root) ** 2
    where, source = Domain({rate_0: (0, oo), rate_1: (0, oo), sine: (0, 1)}), "DLMF 19.8(iii)"
    whole = Equal(new_sine + new_cosine, 1)
    writer.claim("gauss_cosine", "cos²χ′ without a difference", whole, where, steps=("legendre",), source=source)

    def squared(at: Expr, first: Expr, second: Expr) -> Expr:
        # (dχ/dS)²/(a² cos²χ + b² sin²χ) with S = sin²χ and dχ = dS/(2 sin χ cos χ).
        return 1 / (4 * at * (1 - at) * (first**2 * (1 - at) + second**2 * at))

    speed = diff(new_sine, sine) ** 2 * squared(new_sine, (a + b) / 2, sqrt(a * b))
    same, steps = Equal(speed, squared(sine, a, b)), ("gauss_cosine",)
    writer.claim("gauss", "Gauss's step keeps the integral", same, where, steps=steps, source=source)
