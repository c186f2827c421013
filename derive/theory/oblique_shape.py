"""θ, the position and ∫e^{2iθ} from a point of the rod to the tip, for any angle of the field.

All of them follow from t = b/(℘(σ) − c) with real b and c. The tangent, as a complex number y′ + iz′ = e^{iθ}, is
e^{iθ(ℓ)} times (1 + it)/(1 − it), so that it is rational in ℘ with a pole where ℘(v) = c + ib, off the real axis.

The logarithm of σ_W(v − σ)/σ_W(v + σ) is 0 at the tip and is continued along the rod: its argument meets neither 0
nor ∞ there, for ℘ is real on the rod and ℘(±v) is not, but it may wind around 0, and then the principal value is not
the one that is meant. The claims say which is: the derivative along the rod, and the value at the tip. The same holds
of arctan t, which grows or falls by π where t goes through infinity.
"""

from __future__ import annotations

from dataclasses import dataclass

from sympy import Expr, I, Integer, Poly, Rational, atan, diff, exp, log, oo, pi, symbols

from .claims import Domain, Equal, Notebook
from .functions import wp, wp_prime, wsigma, wzeta
from .oblique_lattice import of_roots
from .oblique_quartic import t, theta_tip
from .symbols import sigma, v
from .weierstrass import kappa

b, c, g2, g3 = symbols("b c g2 g3", real=True)  # of the expansion t = b/(℘ − c), and the invariants
AT_V = (v, g2, g3)
POLE = c + I * b  # ℘(v): e^{iθ} is infinite there, t = −i
GIVEN = ((wp(*AT_V), POLE),)
WHERE = Domain(
    {
        g2: (3, 4),
        g3: (Rational(1, 4), Rational(1, 2)),
        b: (1, 2),
        c: (0, 1),
        theta_tip: (-3, 3),
        sigma: (Rational(1, 5), Rational(2, 5)),
    }
)


@dataclass(frozen=True)
class HalfAngleShape:
    """In σ, θ(ℓ), b, c, g₂, g₃ and v, where ℘(v) = c + ib.

    t: the half-angle tangent. theta: by the arctangent continued from the tip. logarithm: ℘′(v) times the integral of
    1/(℘ − ℘(v)). position: y + iz from σ to the tip, ∫e^{iθ}dσ. square: ∫e^{2iθ}dσ. without_field: the position
    where ℘′(v) = 0, which is a rod without field.
    """

    t: Expr
    theta: Expr
    logarithm: Expr
    position: Expr
    square: Expr
    without_field: Expr


def derive(book: Notebook) -> HalfAngleShape:
    """The shape by ζ and σ_W."""
    book.say("Any angle of the field. The shape of the rod")
    theta, direction = theta_tip + 2 * atan(t), exp(I * theta_tip)
    half, tangent = (x.subs(kappa, wp(sigma, g2, g3)) for x in _tangent(theta, direction, book))
    logarithm, simple, double = _integrals()
    position = book.show("y + iz", direction * (sigma + 2 * I * b * simple))
    square = book.show("∫e^{2iθ}", direction**2 * (sigma + 4 * I * b * simple - 4 * b**2 * double))
    for name, what, integral, power in (
        ("position", "y + iz", position, 1),
        ("square", "∫e^{2iθ}", square, 2),
    ):
        _claim_integral(name, what, integral, tangent**power, book)
    without_field = _without_field(direction, tangent, book)
    return HalfAngleShape(half, theta.subs(t, half), logarithm, position, square, without_field)


def _tangent(theta: Expr, direction: Expr, book: Notebook) -> tuple[Expr, Expr]:
    """t by ℘ = ϰ; and e^{iθ} by t, and by ϰ with its pole at ℘(v)."""
    by_t = (1 + I * t) / (1 - I * t)
    same, where = Equal(exp(I * theta), direction * by_t), Domain({theta_tip: (-pi, pi), t: (-oo, oo)})
    title, source = "e^{iθ} by the half-angle tangent", "DLMF 4.23(iv)"
    book.claim("oblique.tangent", title, same, domain=where, steps=("oblique.quartic",), source=source)
    half, by_value = b / (kappa - c), 1 + 2 * I * b / (kappa - POLE)
    same, where = Equal(by_t.subs(t, half), by_value), WHERE.with_range(kappa, 2, 3)
    title, steps = "e^{iθ} by ℘", ("oblique.tangent", "oblique.solution")
    book.claim("oblique.tangent_pole", title, same, domain=where, steps=steps)
    return half, direction * book.show("e^{i(θ − θ(ℓ))}", by_value)


def _integrals() -> tuple[Expr, Expr, Expr]:
    """The logarithm that is continued from 0 at the tip, and by it ∫₀^σ of 1/(℘ − ℘(v)) and of its square."""
    # The logarithmic form of the addition theorem for ζ: 1/(℘u − ℘v) = −(ζ(u+v) − ζ(u−v) − 2ζv)/℘′v.
    logarithm = 2 * sigma * wzeta(*AT_V) + log(wsigma(v - sigma, g2, g3) / wsigma(v + sigma, g2, g3))
    simple = logarithm / wp_prime(*AT_V)
    # ℘(u+v) + ℘(u−v) − 2℘v = ℘″v/(℘u − ℘v) + ℘′v²/(℘u − ℘v)².
    zetas = wzeta(v - sigma, g2, g3) - wzeta(v + sigma, g2, g3) - 2 * sigma * wp(*AT_V)
    double = (zetas - diff(wp_prime(*AT_V), v) * simple) / wp_prime(*AT_V) ** 2
    return logarithm, simple, double


def _claim_integral(name: str, what: str, integral: Expr, integrand: Expr, book: Notebook) -> None:
    """The integral by its derivative along the rod and its value at the tip, which fix the branch."""
    slope = Equal(diff(integral, sigma), integrand)
    title, steps = f"{what}: the derivative along the rod", ("shape.addition", "oblique.tangent_pole")
    book.claim(f"oblique.{name}", title, slope, domain=WHERE, given=GIVEN, steps=steps)
    start = Equal(integral.subs(sigma, 0), 0)
    title = f"{what}: the value at the tip"
    book.claim(f"oblique.{name}_tip", title, start, domain=WHERE, given=GIVEN, steps=(f"oblique.{name}",))


def _without_field(direction: Expr, tangent: Expr, book: Notebook) -> Expr:
    """Where ℘′(v) = 0 the pole of e^{iθ} is double, and y + iz has ζ but no σ_W: (℘(u+v) − ℘v)(℘u − ℘v) is ½℘″v."""
    zetas = wzeta(v, g2, g3) - wzeta(v + sigma, g2, g3) - sigma * wp(*AT_V)
    strength = diff(wp_prime(*AT_V), v) / 2
    position = book.show("y + iz without field", direction * (sigma + 2 * I * b * zetas / strength))
    # v is a half-period: c ± ib and −2c are e₁, e₂, e₃, and ℘′v = 0.
    equation = Poly(of_roots((POLE, c - I * b, -2 * c)), kappa)
    values = {g2: -equation.coeff_monomial(kappa), g3: -equation.coeff_monomial(1)}
    at_v = tuple(x.subs(values) for x in AT_V)
    given = (*values.items(), (wp(*at_v), POLE), (wp_prime(*at_v), Integer(0)))
    slope, start = Equal(diff(position, sigma), tangent), Equal(position.subs(sigma, 0), 0)
    title, steps = "y + iz without field: the derivative along the rod", ("oblique.tangent_pole", "shape.addition")
    book.claim("oblique.without_field", title, slope, domain=WHERE, given=given, steps=steps)
    title, name = "y + iz without field: the value at the tip", "oblique.without_field"
    book.claim(f"{name}_tip", title, start, domain=WHERE, given=given, steps=(name,))
    return position
