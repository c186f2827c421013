"""How fast the angle at the clamp changes with the tip's, on a rod of a given length: bounds for every tip.

Of the motion from rest at the tip φ, h = ∂θ/∂φ obeys h″ = (dθ″/dθ)h, from 1 and 0, and g = ∂²θ/∂φ² obeys
g″ = (dθ″/dθ)g + (d²θ″/dθ²)h², from 0 and 0. With k² = β + η, |dθ″/dθ| ≤ k² and |d²θ″/dθ²| ≤ β + 2η: what the sides
differ by are sums of squares. g and h are double integrals of what they obey, whose kernel σ − τ is not negative: so
|h| ≤ cosh kσ, and |g| is no more than the solution of G″ = k²G + (β + 2η) cosh²kσ from 0 and 0.
"""

from __future__ import annotations

from sympy import Expr, Matrix, Symbol, cos, cosh, diff, oo, sin, sqrt

from .claims import Domain, Equal
from .swing_levels import Levels
from .swing_names import Writer, anywhere, field_angle
from .symbols import beta, eta, sigma, theta

growth = Symbol("growth", positive=True)  # cosh kℓ − 1


def write_shots(levels: Levels, writer: Writer) -> None:
    """The bounds of dθ″/dθ and of d²θ″/dθ², and that of |∂²θ/∂φ²| which follows."""
    slope, lean = diff(levels.moment, theta), theta - field_angle
    softness, most = beta + eta, beta + 2 * eta
    gaps = Matrix([softness + slope, softness - slope])
    squares = Matrix([2 * beta * f(theta / 2) ** 2 + 2 * eta * f(lean) ** 2 for f in (cos, sin)])
    title, where = "|dθ″/dθ| ≤ β + η: the gaps as squares", anywhere(theta)
    writer.claim("shot_slope", title, Equal(gaps, squares), where, steps=("moment",))
    curve = diff(slope, theta)
    gaps = Matrix([most + curve, most - curve])
    squares = Matrix([beta * sides(theta / 2, sign) ** 2 + 2 * eta * sides(lean, sign) ** 2 for sign in (-1, 1)])
    title = "|d²θ″/dθ²| ≤ β + 2η: the gaps as squares"
    writer.claim("shot_curve", title, Equal(gaps, squares), where, steps=("moment",))
    _write_bend(softness, most, writer)


def sides(angle: Expr, sign: int) -> Expr:
    """The sine of an angle and its cosine, or less its cosine."""
    return sin(angle) + sign * cos(angle)


def _write_bend(softness: Expr, most: Expr, writer: Writer) -> None:
    """The solution G, by cosh kσ."""
    slope = cosh(sqrt(softness) * sigma)

    def solves(value: Expr) -> Equal:
        along = value.subs(growth, slope - 1)
        driven = diff(along, sigma, 2) - softness * along
        return Equal(
            Matrix([driven, along.subs(sigma, 0), diff(along, sigma).subs(sigma, 0)]),
            Matrix([most * slope**2, 0, 0]),
        )

    writer.add(
        "shot_bend",
        (beta, eta, growth),
        most * growth * (growth + 3) / (3 * softness),
        "a bound of |∂²θ(0)/∂θ(ℓ)²| for every tip, by cosh(ℓ√(β + η)) − 1: it solves G″ = (β + η)G + (β + 2η)cosh²",
        solves,
        Domain({beta: (0, oo), eta: (0, oo), sigma: (0, 4)}),
        steps=("shot_slope", "shot_curve"),
    )
