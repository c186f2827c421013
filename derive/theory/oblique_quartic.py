"""The half-angle quartic at the tip, for any angle of the field.

With t = tan((θ − θ(ℓ))/2) and σ = ℓ − s, (dt/dσ)² = n t⁴ + m t³ + q t² + p t. The tip is its root t = 0; the other
three are the directions at which the rod would turn back.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from sympy import Add, Expr, Integer, Matrix, Poly, Symbol, atan, cancel, cos, diff, oo, pi, sin, symbols

from .claims import Domain, Equal, Notebook
from .load_case import linear_root
from .plane import Plane
from .symbols import alpha, beta, gamma, theta, xi

theta_tip = Symbol("theta_tip", real=True)  # θ(ℓ)
t = Symbol("t", real=True)  # tan((θ − θ(ℓ))/2)
p, q, m, n = COEFFICIENTS = symbols("p q m n", real=True)  # of t, t², t³, t⁴
QUARTIC = sum((letter * t**k for k, letter in enumerate(COEFFICIENTS, start=1)), start=Integer(0))


@dataclass(frozen=True)
class HalfAngle:
    """The quartic of a rod. coefficients: p, q, m, n in θ(ℓ) and α. gamma: of the tip. levels: θ′² in θ with this γ."""

    coefficients: Mapping[Symbol, Expr]
    gamma: Expr
    levels: Expr
    domain: Domain


def derive(plane: Plane, book: Notebook) -> HalfAngle:
    """The quartic from the first integral of a rod without moment at its free end."""
    book.say("Any angle of the field. The half-angle quartic at the tip")
    along = plane.curvature_squared.subs({xi: cos(theta), plane.alignment: cos(theta - alpha)})
    tip_gamma = book.show("γ(θ(ℓ))", linear_root(along.subs(theta, theta_tip), gamma))
    # The cosines of θ and θ − α, by t: an angle of 2 arctan t is added to those at the tip.
    at_t = {xi: turned_cosine(theta_tip), plane.alignment: turned_cosine(theta_tip - alpha)}
    levels_at_t = plane.curvature_squared.subs(at_t).subs(gamma, tip_gamma)
    speed = Poly(cancel(levels_at_t * (1 + t**2) ** 2 / 4), t)
    coefficients = {letter: speed.coeff_monomial(t**k) for k, letter in enumerate(COEFFICIENTS, start=1)}
    for letter, value in coefficients.items():
        book.show(letter.name, value)
    positive: dict[Symbol, tuple[Expr, Expr]] = dict.fromkeys((beta, *plane.parameters), (Integer(0), oo))
    domain = Domain({theta_tip: (-pi, pi), alpha: (-pi, pi), **positive})
    half = HalfAngle(coefficients, tip_gamma, along.subs(gamma, tip_gamma), domain)
    _claim_quartic(half, book)
    _claim_coefficients(half, plane.angular_acceleration, book)
    _claim_balance(half, plane.angular_acceleration, book)
    return half


def turned_cosine(angle: Expr) -> Expr:
    """cos(angle + 2 arctan t)."""
    return (cos(angle) * (1 - t**2) - 2 * t * sin(angle)) / (1 + t**2)


def _claim_quartic(half: HalfAngle, book: Notebook) -> None:
    """The quartic against θ′² at θ = θ(ℓ) + 2 arctan t, where dt/dσ is ½(1 + t²) dθ/dσ."""
    free = Equal(half.levels.subs(theta, theta_tip), 0)
    title, steps = "no moment at the free end", ("equilibrium.constitutive", "plane.first_integral")
    book.claim("oblique.free_end", title, free, domain=half.domain, steps=steps, source="exsl23")
    angle = theta_tip + 2 * atan(t)
    speed = Equal(QUARTIC.subs(half.coefficients), half.levels.subs(theta, angle) / diff(angle, t) ** 2)
    title, where = "(dt/dσ)² is a quartic in t", half.domain.with_range(t)
    book.claim("oblique.quartic", title, speed, domain=where, steps=("plane.energy", "oblique.free_end"))


def _claim_coefficients(half: HalfAngle, acceleration: Expr, book: Notebook) -> None:
    """The coefficients by θ″ and dθ″/dθ at the tip, and by the same at the opposite direction, where t is infinite."""
    opposite = Add(theta_tip, pi)  # θ(ℓ) − π is the same direction
    expected = (
        acceleration.subs(theta, theta_tip),
        diff(acceleration, theta).subs(theta, theta_tip),
        -acceleration.subs(theta, opposite),
        half.levels.subs(theta, opposite) / 4,
    )
    same = Equal(Matrix([half.coefficients[letter] for letter in COEFFICIENTS]), Matrix(expected))
    title, steps = "p, q, m, n by θ″ at the tip and opposite to it", ("oblique.quartic", "plane.moment")
    book.claim("oblique.coefficients", title, same, domain=half.domain, steps=steps)


def _claim_balance(half: HalfAngle, acceleration: Expr, book: Notebook) -> None:
    """θ = θ(ℓ) + 2 arctan t is in equilibrium: θ″ from t″ = ½ d(quartic)/dt (the sign of dσ = −ds drops out)."""
    quartic = QUARTIC.subs(half.coefficients)
    angle = theta_tip + 2 * atan(t)
    second = diff(angle, t) * diff(quartic, t) / 2 + diff(angle, t, 2) * quartic
    balance, where = Equal(second, acceleration.subs(theta, angle)), half.domain.with_range(t)
    title, steps = "the moments balance along the rod", ("oblique.quartic", "plane.moment")
    book.claim("oblique.balance", title, balance, domain=where, steps=steps, source="exsl6")
