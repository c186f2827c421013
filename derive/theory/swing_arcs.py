"""Position and ∫η cos²(θ − α) from the tip, by Carlson's integrals of X₁, X₂, X₃ with a complex fourth argument.

e^{iδ} = 1 + 2ib/(x − ib), and dσ = −dx/(2√X₁√X₂√X₃) from σ = 0 at x = ∞: ∫e^{iθ}dσ = e^{iφ}(σ + W) with
W = (2ib/3)R_J(X₁, X₂, X₃, x − ib). x is real and b is not zero, so that the fourth argument meets no cut: W holds as it
stands up to the far turning point. The claims are made for both signs of the discriminant, the formulas hold X₂ and
X₃ by values that are real in either case.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable

from sympy import Expr, I, Rational, Symbol, cos, oo, sin, symbols

from .claims import Domain, Equal
from .oblique_quartic import HalfAngle, m, n, p, q, theta_tip
from .oblique_shape import b
from .swing_along import COSINE, KINDS, SINE, THIRD_KIND, claim_integral
from .swing_names import Writer, anywhere, cosine, done, double_cosine, double_sine, field_angle, sine, tip
from .swing_points import Points, x
from .symbols import alpha, eta
from .tip_names import arc

rj_real, rj_imag = symbols("rj_re rj_im", real=True)  # of R_J(X₁, X₂, X₃, x − ib)
w_real, w_imag = symbols("w_re w_im", real=True)  # of W
AT_TIP = {sine: sin(tip), cosine: cos(tip)}
PARTS = {"real": "real", "imag": "imaginary"}


def write_arcs(points: Points, rod: HalfAngle, writer: Writer) -> Expr:
    """W, and what the position departs by from the straight line along the tip's direction; all of y is given back."""
    turned, where = COSINE.subs(x, b * cos(done / 2) / sin(done / 2)), Domain({b: (0, oo), done: (0, 6)})
    same, source = Equal(turned, cos(done)), "DLMF 4.21(iii)"
    writer.claim("cosine", "cos δ by x", same, where, steps=("point_pole",), source=source)
    at = {theta_tip: tip, alpha: field_angle}
    letters = {letter: value.subs(at) for letter, value in rod.coefficients.items()}
    # q − n and p − m of the quartic are what the field does.
    _write_field(writer, "real", cos, letters[q] - letters[n])
    _write_field(writer, "imag", sin, letters[p] - letters[m])
    # ∏(p − X_i) for the fourth argument p = x − ib of R_J: the same at every point, −C(ib)/4.
    ahead, behind = (-points.cubic.subs(x, side * I * b).expand() / 4 for side in (1, -1))
    given = (*letters.items(), (b, letters[p] / 4))
    _write_shift(writer, "real", letters[q] - letters[n], (ahead + behind) / 2, given)
    _write_shift(writer, "imag", letters[p] - letters[m], (ahead - behind) / (2 * I), given)
    # The integral of e^{iδ} − 1 is (2ib/3)R_J.
    real, imag = (2 * I * b / 3 * (rj_real + I * rj_imag)).as_real_imag()
    _write_third_kind(writer, "real", rj_imag, real, COSINE - 1)
    _write_third_kind(writer, "imag", rj_real, imag, SINE)
    # ∫e^{iθ} = e^{iφ}(σ + W); without σ it is what the rod departs by from the straight line along its tip.
    y = _write_departure(writer, "y", cos, cosine * w_real - sine * w_imag)
    _write_departure(writer, "z", sin, sine * w_real + cosine * w_imag)
    return (cosine * arc + y).subs(AT_TIP)


def _write_field(writer: Writer, part: str, function: Callable[..., Expr], value: Expr) -> None:
    """η e^{2i(φ − α)}, the strength of the field as it is turned to the tip."""
    writer.add(
        f"field_{part}",
        (eta, field_angle, tip),
        eta * function(2 * (tip - field_angle)),
        f"the {PARTS[part]} part of η e^{{2i(φ − α)}}",
        lambda found: Equal(found, value),
        anywhere(tip),
        steps=("oblique.coefficients",),
        emitted=False,
    )


def _write_shift(writer: Writer, part: str, field: Expr, value: Expr, given: Iterable[tuple[Expr, Expr]]) -> None:
    """What the duplication of R_J divides by, b²η e^{2i(φ − α)}/4."""
    symbol = {"real": double_cosine, "imag": double_sine}[part]
    writer.add(
        f"rj_delta_{part}",
        (eta, b, symbol),
        eta * b**2 * symbol / 4,
        f"the {PARTS[part]} part of (p − X₁)(p − X₂)(p − X₃), p = x − ib, for the duplication of R_J, "
        f"by {'cos' if part == 'real' else 'sin'} 2(φ − α)",
        lambda found: Equal(found.subs(symbol, field / eta), value),
        anywhere(tip),
        given=given,
        steps=("cubic_root", "strength", f"field_{part}"),
        source="DLMF 19.26(iii)",
    )


def _write_third_kind(writer: Writer, part: str, symbol: Symbol, value: Expr, integrand: Expr) -> None:
    """W by R_J."""
    along = value.subs(dict(zip((rj_real, rj_imag), THIRD_KIND, strict=True)))
    key, title, source = f"third_kind_{part}", f"∫(e^{{iδ}} − 1)dσ, the {PARTS[part]} part", "DLMF 19.29(ii)"
    steps = ("oblique.tangent_pole", "cubic_root", "fall")
    claim_integral(writer, key, title, lambda _: along, lambda _: integrand, steps=steps, source=source)
    factor = {"real": Rational(-2, 3), "imag": Rational(2, 3)}[part]
    writer.add(
        f"w_{part}",
        (b, symbol),
        factor * b * symbol,
        f"the {PARTS[part]} part of W = (2ib/3)R_J(X₁, X₂, X₃, x − ib): ∫e^{{iθ}}dσ = e^{{iφ}}(σ + W)",
        lambda found: Equal(found, value),
        Domain({b: (0, oo), rj_real: (-oo, oo), rj_imag: (-oo, oo)}),
        steps=tuple(f"{key}_{kind.name}" for kind in KINDS),
        source=source,
    )


def _write_departure(writer: Writer, name: str, function: Callable[..., Expr], value: Expr) -> Expr:
    """Of y or z: along the rod it is cos θ − cos φ or sin θ − sin φ, with e^{iδ} − 1 for what W is the integral of."""
    here = {w_real: cos(done) - 1, w_imag: sin(done)}
    return writer.add(
        f"arc_{name}",
        (sine, cosine, w_real, w_imag),
        value,
        f"∫{name}′ dσ from the tip to the point less what it is along the tip's direction, by sin φ and cos φ",
        lambda found: Equal(found.subs(here).subs(AT_TIP), function(tip + done) - function(tip)),
        anywhere(tip, done),
        steps=("w_real", "w_imag", "cosine"),
        source={"y": "exsl36", "z": "exsl41"}[name],
    )
