"""∫η cos²(θ − α)dσ from the tip, by y and an integral of the second kind.

e^{2iδ} has a double pole at x = ib. The derivative of x_σ/(x − ib) along the rod takes it to R_J, and that of x_σ/X₁
takes the rest to R_D. What is left of R_J is β times y, for β cos φ = n and β sin φ = (p + m)/2. At the far turning
point R_D(X₂, X₃, X₁) and the term beside it are both infinite; the other two R_D are not, and the sum of all three is
3/√(X₁X₂X₃): that gives a second form, for points where X₁ is the least of the three. Elsewhere the first is the better.
"""

from __future__ import annotations

from sympy import Expr, Symbol, cos, oo, symbols

from .claims import Equal
from .functions import RD, RF
from .oblique_quartic import HalfAngle, m, n, p, q, theta_tip
from .oblique_shape import b
from .swing_along import COSINE, KINDS, SINE, THIRD_KIND, Kind, claim_integral
from .swing_arcs import w_imag, w_real
from .swing_levels import FIELD
from .swing_names import Writer, anywhere, far, field_angle, near, tip
from .swing_points import e_1 as root
from .swing_points import place as pole
from .swing_points import x, x_near, x_pair
from .symbols import alpha, beta, eta
from .tip_names import arc, y_tip

rate = Symbol("rate", real=True)  # √(X₁X₂X₃)
second, seconds = symbols("second seconds", real=True)  # R_D(X₂, X₃, X₁); R_D(X₁, X₂, X₃) + R_D(X₁, X₃, X₂)
# Re(η e^{2i(φ − α)}e^{2iδ}) by the coefficients of the quartic.
TWICE = (q - n) * (2 * COSINE**2 - 1) - (4 * b - m) * 2 * SINE * COSINE
# By the same: ∫η cos²(θ − α)dσ less the integrals of the second kind.
BY_LETTERS = (eta + q - n) / 2 * arc - n * w_real + (2 * b + m / 2) * w_imag


def write_square(y: Expr, rod: HalfAngle, writer: Writer) -> None:
    """Both forms: the one for points near the tip, and the one for points near the far turning point."""
    edge = rate * (pole * root + b**2) / ((pole**2 + b**2) * x_near)
    towards_tip = 4 * root * arc + near * far * second / 48 - 4 * edge
    arguments = (root, pole, x_near, rate, near, far, arc, y_tip, second)
    _write_form("square_before", "before the far turning point", towards_tip, arguments, y, rod, writer)
    # With second = 3/rate − seconds the terms that are infinite at X₁ = 0 cancel.
    over = root * pole**2 + (b**2 - b * m / 4 - root * q / 4 - root**2) * pole + b**2 * (q / 4 + 2 * root)
    towards_far = 4 * root * arc - near * far * seconds / 48 - 4 * rate / x_pair * over / (pole**2 + b**2)
    others = (q, m, root, pole, x_pair, rate, near, far, arc, y_tip, seconds)
    _write_form("square_beyond", "also at the far turning point", towards_far, others, y, rod, writer)


def _write_form(
    name: str, where: str, kept: Expr, arguments: tuple[Symbol, ...], y: Expr, rod: HalfAngle, writer: Writer
) -> None:
    """One form, by y. kept: its terms of the second kind."""
    _claim_second_kind(name, kept, writer)
    writer.add(
        name,
        (*FIELD, tip, b, *arguments),
        (beta * cos(tip) + eta * cos(tip - field_angle) ** 2) * arc - beta * y_tip + kept,
        f"η∫cos²(θ − α)dσ from the tip to the point, {where}",
        lambda value: Equal(in_rod(value.subs(y_tip, y), rod), in_rod(BY_LETTERS + kept, rod)),
        anywhere(tip),
        given=((b, in_rod(p, rod) / 4),),
        steps=("arc_y", "oblique.coefficients", "strength", *(f"{name}_{kind.name}" for kind in KINDS)),
        source="DLMF 19.29(ii)",
        emitted=False,
    )


def in_rod(value: Expr, rod: HalfAngle) -> Expr:
    """The letters of the quartic at the tip in β, η, α and φ."""
    at = {theta_tip: tip, alpha: field_angle}
    return value.subs({letter: coefficient.subs(at) for letter, coefficient in rod.coefficients.items()})


def _claim_second_kind(name: str, kept: Expr, writer: Writer) -> None:
    """The form along the motion, with q, m, n by the roots: η cos²(θ − α) = ½η + ½Re(η e^{2i(φ − α)}e^{2iδ})."""

    def integral(kind: Kind) -> Expr:
        first, other, last = kind.gaps
        real, imag = THIRD_KIND
        values = {
            arc: RF(*kind.gaps),
            w_real: -2 * b * imag / 3,
            w_imag: 2 * b * real / 3,
            second: RD(other, last, first),
            seconds: RD(first, other, last) + RD(first, last, other),
            near: 64 * (first - other) * (first - last) / far,
            pole: x,
            root: kind.roots[0],
            x_near: first,
            x_pair: other * last,
            rate: kind.speed,
        }
        return (BY_LETTERS + kept).subs(kind.letters).subs(values)

    claim_integral(
        writer,
        name,
        "η∫cos²(θ − α)dσ",
        integral,
        lambda kind: (eta + TWICE.subs(kind.letters)) / 2,
        more={eta: (0, oo)},
        steps=("w_real", "w_imag", "far_slope", "cubic_root", "field_real", "field_imag", "fall"),
        source="DLMF 19.29(ii)",
    )
