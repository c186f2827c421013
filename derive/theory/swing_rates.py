"""The length of the motion as a Legendre integral.

tan²(χ/2) = √(P′/P)S₁/S₂, with the sines S₁ = sin(δ/2) and S₂ = sin(D − δ/2) of ``swing_turns``, makes
dσ = dχ/√(h² cos²χ + g² sin²χ).
"""

from __future__ import annotations

from sympy import Expr, Symbol, cos, diff, oo, pi, sin, sqrt

from .claims import Domain, Equal
from .swing_names import Writer, above, done, excess, far, half_width, left, mean, near, product, sine
from .symbols import eta

# P and P′ are positive, R has either sign.
FACTORS = Domain({near: (0, oo), far: (0, oo), excess: (-oo, oo), half_width: (0, pi), done: (0, 2 * half_width)})
tangent = Symbol("T", positive=True)  # tan²(χ/2)


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
        emitted=False,
    )
    writer.add(
        "factor_product",
        (near, far),
        sqrt(near) * sqrt(far),
        "√(PP′), the geometric mean of P and P′",
        lambda value: Equal(value**2, near * far),
        FACTORS,
        steps=("phase_tangent_squared",),
    )
    # The integrand's two rates, read off at χ = 0 and at χ = π/2.
    writer.add(
        "end_rate_squared",
        (product,),
        product / 2,
        "h²: (dχ/dσ)² at the turning points, by √(PP′)",
        lambda value: Equal(
            value.subs(product, sqrt(near * far)), legendre(rate, middle_rate, tangent).subs(tangent, 0)
        ),
        FACTORS,
        steps=("phase_tangent_squared", "factor_product"),
    )
    writer.add(
        "middle_rate_squared",
        (product, excess),
        (product + excess) / 4,
        "g²: (dχ/dσ)² at χ = π/2, for R of either sign",
        lambda value: Equal(
            value.subs(product, sqrt(near * far)), legendre(rate, middle_rate, tangent).subs(tangent, 1)
        ),
        FACTORS,
        steps=("phase_tangent_squared", "factor_product"),
    )
    # The same as a product, where R < 0 and √(PP′) + R would cancel.
    apart = sine**2 * above * (mean + eta)
    where = {product: (0, oo), eta: (0, oo), sine: (0, 1), mean: (eta, oo), excess: (-oo, 0)}
    writer.add(
        "middle_rate_squared_apart",
        (product, excess, eta, mean, above),
        above * (mean + eta) / (4 * (product - excess)),
        "g²/sin²D by the factors of PP′ − R², with above = a₀ − η, for R < 0",
        lambda value: Equal(sine**2 * value.subs(above, mean - eta), (product + excess) / 4),
        Domain(where),
        given=((product, sqrt(excess**2 + apart.subs(above, mean - eta))),),
        steps=("middle_rate_squared", "mean_factor"),
    )
