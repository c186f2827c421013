"""Whether the first integral of an energy is elliptic: the genus of the curve on which the rod's motion lies.

With t = tan(θ/2), and cos θ, sin θ and dθ = 2 dt/(1 + t²) rational in it, an energy of degree N in w = d₃·e gives
(dt/ds)² = P(t)/(4(1 + t²)^(N − 2)) with P of degree 2N. The length of the rod is an integral on the curve
v² = P(t)(1 + t²)^N: of genus 1 at most it is elliptic, above that hyperelliptic.
"""

from __future__ import annotations

from dataclasses import dataclass

from sympy import Expr, Poly, Rational, Symbol, cancel, cos, sin

from derive.theory.plane import Plane
from derive.theory.symbols import alpha, beta, gamma, xi

t = Symbol("t", real=True)  # tan(θ/2)
_SEED = (Rational(3, 7), Rational(17, 5))  # tan(α/2) and the first parameter: any numbers without a relation


@dataclass(frozen=True)
class Curve:
    """The motion by t. degree: of the energy in w. numerator: P(t). genus: of v² = P(t)(1 + t²)^N for general loads."""

    degree: int
    numerator: Poly
    genus: int


def curve_of(plane: Plane) -> Curve:
    """The curve of a rod in the plane under a force and a field at any angle, of an energy polynomial in w."""
    w = plane.alignment
    degree = int(Poly(plane.energy_density, w).degree())
    under = 1 + t**2
    cosine, sine = (1 - t**2) / under, 2 * t / under
    along = {xi: cosine, w: cosine * cos(alpha) + sine * sin(alpha)}
    levels = plane.curvature_squared.subs(along) * under ** max(degree, 1)
    numerator = Poly(cancel(levels.expand()), t)
    return Curve(degree, numerator, _genus(numerator.as_expr(), degree, plane.parameters))


def _genus(numerator: Expr, degree: int, parameters: tuple[Symbol, ...]) -> int:
    """The genus at one rational point of the loads; it is that of general loads, or less at an unlucky point."""
    half, value = _SEED
    angle = {cos(alpha): (1 - half**2) / (1 + half**2), sin(alpha): 2 * half / (1 + half**2)}
    numbers = {name: value + Rational(k * k, 3) for k, name in enumerate((beta, gamma, *parameters))}
    radicand = Poly(numerator.subs(angle).subs(numbers) * (1 + t**2) ** (degree % 2), t)
    return max(0, (int(radicand.sqf_part().degree()) - 1) // 2)
