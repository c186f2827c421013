"""∫η cos²(θ − α)dσ from the tip by the phase ψ, by what does not grow along a rod that is nearly straight.

As in ``swing_square`` the derivative of x_σ/(x − ib) leaves ∫X₁ besides y. By the phase that is
−Δ cot ψ − (b² − a²)∫sin²ψ − a²σ, up to what makes it finite at the tip. So the form holds up to the far turning
point. The length is τ = sin ψ cos ψ/Δ and what it exceeds that by. Near the tip Δ cot ψ and √X₁ are large and cancel,
and what they leave cancels τ; there a second form takes all of it by τ/x, so that every part is small as σ³.
"""

from __future__ import annotations

from sympy import Expr, Integer, Symbol, cos, diff, oo, sqrt

from .claims import Domain, Equal, Limit
from .oblique_quartic import HalfAngle, m, n, p, q
from .oblique_shape import b
from .swing_along import COSINE, SINE
from .swing_arcs import w_imag, w_real
from .swing_names import Writer, anywhere, field_angle, tip
from .swing_phase import PHASE, across, delta, first, rate, second, square
from .swing_place import SPREAD, Place, pair_root
from .swing_points import e_1 as root
from .swing_points import place as pole
from .swing_points import x
from .swing_square import BY_LETTERS, TWICE, in_rod
from .symbols import beta, eta
from .tip_names import arc

near_root = Symbol("near_root", real=True)  # √X₁
lift = Symbol("lift", real=True)  # x + √X₂√X₃
others_sum, others_product = Symbol("others_sum", real=True), Symbol("others_product", real=True)  # ê₂ + ê₃, ê₂ê₃
y_apart = Symbol("y_apart", real=True)  # ∫(cos θ − cos φ)dσ
kink = Symbol("kink", real=True)  # the part without integral
turned = Symbol("turned", real=True)  # ∫sin²ψ dσ
lag = Symbol("lag", real=True)  # σ − sin ψ cos ψ/Δ
ROOTS = Domain({**PHASE.ranges, root: (-oo, oo), b: (0, oo)})
# ê₂ + ê₃ and ê₂ê₃ by ê₁ and the rates.
SUM = 2 * root - SPREAD
PRODUCT = first**4 - root**2 + root * SUM
LETTERS = {q: -4 * (root + SUM), m: 4 * (root * SUM + PRODUCT) / b, n: -4 * root * PRODUCT / b**2}


def kept(part: Expr, swelling: Expr, run: Expr) -> Expr:
    """What the letters q, m, n leave of the integral: of whole quantities, or of their derivatives along the rod."""
    return -2 * (part + 4 * swelling + 2 * (first**2 - root) * run)


def write_energy(place: Place, y: Expr, rod: HalfAngle, writer: Writer) -> None:
    """The part without integral in two forms, and the whole."""
    here = {
        near_root: first**2 * sqrt(1 - square) / (sqrt(square) * rate(first, second, square)),
        pair_root: place.pair,
        pole: root + place.near,
        delta: rate(first, second, square),
        across: sqrt(square) * sqrt(1 - square),
    }
    _write_others(writer)
    _write_kink(here, writer)
    rest = kept(kink, (second - first) * (second + first) * turned, lag)
    meant = kept(kink, (second**2 - first**2) * turned, lag)  # as ``arc_kink`` has it
    writer.add(
        "arc_square",
        (beta, first, second, root, y_apart, kink, turned, lag),
        -beta * y_apart + rest,
        "η∫cos²(θ − α)dσ from the tip to the point less what it is along the tip's direction, by the same of y",
        lambda value: Equal(
            in_rod(value.subs(y_apart, y - cos(tip) * arc) + eta * cos(tip - field_angle) ** 2 * arc, rod),
            in_rod(BY_LETTERS + meant, rod),
        ),
        anywhere(tip),
        given=((b, in_rod(p, rod) / 4),),
        steps=("arc_y", "oblique.coefficients", "strength", "arc_kink", "arc_kink_start"),
        source="DLMF 19.29(ii)",
    )


def _write_others(writer: Writer) -> None:
    """The other two roots by q, m and ê₁."""
    writer.add(
        "others_sum",
        (q, root),
        -q / 4 - root,
        "ê₂ + ê₃ by ê₁",
        lambda value: Equal(value.subs(LETTERS), SUM),
        ROOTS,
        steps=("cubic_root", "excess_root"),
    )
    writer.add(
        "others_product",
        (b, m, root, others_sum),
        b * m / 4 - root * others_sum,
        "ê₂ê₃ by ê₁ and ê₂ + ê₃",
        lambda value: Equal(value.subs(others_sum, SUM).subs(LETTERS), PRODUCT),
        ROOTS,
        steps=("cubic_root", "far_slope", "others_sum"),
    )


def _write_kink(here: dict[Symbol, Expr], writer: Writer) -> None:
    """The part without integral by its derivative along the rod, and its value at the tip."""
    below = pole**2 + b**2

    def slopes(value: Expr) -> Equal:
        # dS/dσ = 2 sin ψ cos ψ Δ; W grows by e^{iδ} − 1.
        along, behind = (
            diff(part.subs(here), square) * 2 * here[across] * here[delta] for part in (value, across / delta)
        )
        rest = kept(along, (second**2 - first**2) * square, 1 - behind)
        turns = {arc: Integer(1), w_real: COSINE - 1, w_imag: SINE}
        moved = (BY_LETTERS.subs(turns) - (eta + TWICE) / 2).subs(LETTERS).subs(x, here[pole])
        return Equal(moved + rest, 0)

    far = writer.add(
        "arc_kink",
        (first, square, delta, across, b, pole, root, near_root, pair_root),
        4 * delta * across / square
        - 2 * near_root * (1 + pole * pair_root / below)
        + 2 * (first**2 - root) * across / delta,
        "the part of ∫η cos²(θ − α)dσ without integral",
        slopes,
        ROOTS.with_range(eta, 0, oo),
        steps=("near_by_phase", "pair_by_phase", "w_real", "w_imag", "field_real", "field_imag", "fall"),
        source="DLMF 19.29(ii)",
    )
    start = Limit(far.subs(here), square, Integer(0), Integer(0), "+")
    writer.claim("arc_kink_start", "it is zero at the tip", start, ROOTS, steps=("arc_kink",))
    level = first**2 - root
    by_lift = (b**2 * (lift - others_sum + level) - pole * others_product) + pole * level * (
        others_sum * pole - others_product
    ) / lift
    writer.add(
        "arc_kink_tip",
        (first, delta, across, b, pole, root, others_sum, others_product, lift),
        across * by_lift / (delta * below),
        "the same towards the tip, with lift = x + √X₂√X₃: it is small as σ³, and so are its terms",
        lambda value: Equal(
            value.subs({lift: pole + pair_root, others_sum: SUM, others_product: PRODUCT}).subs(here), far.subs(here)
        ),
        ROOTS,
        steps=("arc_kink", "others_sum", "others_product", "pair_by_phase"),
    )
