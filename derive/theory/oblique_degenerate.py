"""The degenerate ℘ of the half angle: two half-period values coincide, the discriminant is zero.

Either p = 0, and the rod is straight; or a direction of turning back is a double root of the quartic, which a rod of
finite length does not reach. Then ℘ = e + k²/sinh²(kσ) with e = k²/3 the double value, real in both cases: k is real
where that direction comes first along the rod, and imaginary where the rod turns back before it.
"""

from __future__ import annotations

from dataclasses import dataclass

from sympy import Expr, I, Integer, Matrix, Rational, Symbol, atanh, diff, exp, sinh, sqrt, tanh

from .claims import Domain, Equal, Notebook
from .oblique_lattice import HalfAngleLattice, of_roots
from .oblique_quartic import m, n, p, q, theta_tip
from .oblique_shape import POLE, b, c
from .symbols import sigma
from .weierstrass import kappa

k = Symbol("k")  # real or imaginary
DOUBLE = k**2 / 3  # e₁ = e₂, so that e₃ = −2e₁


@dataclass(frozen=True)
class Degenerate:
    """value: ℘(σ) in k. position: y + iz from σ to the tip in k, b, c, θ(ℓ)."""

    value: Expr
    position: Expr


def derive(lattice: HalfAngleLattice, book: Notebook) -> Degenerate:
    """℘ and the position where the discriminant is zero."""
    book.say("Any angle of the field. A double half-period value")
    straight = {p: Integer(0)}
    none = Equal(lattice.g2.subs(straight) ** 3, 27 * lattice.g3.subs(straight) ** 2)
    title, where = "a straight rod is degenerate", Domain(dict.fromkeys((q, m, n), (0, 1)))
    book.claim("oblique.straight", title, none, domain=where, steps=("oblique.discriminant",))
    equation = of_roots((DOUBLE, DOUBLE, -2 * DOUBLE))
    g2, g3 = -diff(equation, kappa).subs(kappa, 0), -equation.subs(kappa, 0)
    where, values = Domain({sigma: (Rational(1, 5), 1)}), (g2, g3, g2**3 - 27 * g3**2)
    none = Equal(Matrix(values), Matrix([12 * DOUBLE**2, -8 * DOUBLE**3, 0]))
    title, steps = "a double half-period value: the discriminant is zero", ("oblique.discriminant_roots",)
    book.claim("oblique.double", title, none, domain=where, steps=steps, source="DLMF 23.3.7")
    value = book.show("℘", DOUBLE + k**2 / sinh(k * sigma) ** 2)
    elementary = Equal(diff(value, sigma) ** 2, equation.subs(kappa, value))
    title, rests = "the degenerate ℘ is elementary", ("oblique.double", "weierstrass.second_derivative")
    book.claim("oblique.degenerate", title, elementary, domain=where, steps=rests, source="DLMF 23.3.10")
    return Degenerate(value, _position(value, book))


def _position(value: Expr, book: Notebook) -> Expr:
    """∫dσ/(℘ − ℘v) = σ/(e − ℘v) − ∫(k²/(e − ℘v))dσ/(k² + (e − ℘v) sinh²kσ), an inverse hyperbolic tangent."""
    gap = DOUBLE - POLE
    root = sqrt(k**2 - gap)
    inner = (sigma - atanh(root * tanh(k * sigma) / k) / root) / gap
    direction = exp(I * theta_tip)
    position = book.show("y + iz", direction * (sigma + 2 * I * b * inner))
    where = Domain({b: (1, 2), c: (0, 1), theta_tip: (-3, 3), sigma: (Rational(1, 5), 1)})
    slope = Equal(diff(position, sigma), direction * (1 + 2 * I * b / (value - POLE)))
    title, rests = "y + iz of a degenerate rod", ("oblique.degenerate", "oblique.tangent_pole")
    book.claim("oblique.degenerate_position", title, slope, domain=where, steps=rests, source="DLMF 4.37.3")
    start = Equal(position.subs(sigma, 0), 0)
    title, name = "y + iz of a degenerate rod: the value at the tip", "oblique.degenerate_position"
    book.claim("oblique.degenerate_tip", title, start, domain=where, steps=(name,))
    return position
