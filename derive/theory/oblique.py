"""The rod in a field at any angle: the exact solution, from the first integral, by one ℘ and one complex logarithm.

With t = tan((θ − θ(ℓ))/2), σ = ℓ − s: t = b/(℘(σ) − c), and the complex y + iz from a point of the rod to the tip has a
logarithm of σ_W whose strength is 2e^{iα}/√H, where H is the stiffness of the field. The scripts:
``oblique_quartic`` (the quartic that t obeys), ``oblique_lattice`` (its ℘, in both signs of the discriminant),
``oblique_degenerate`` (and between them), ``oblique_shape`` (the shape), ``oblique_cases`` (the article's load cases).
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from sympy import Expr, I, Poly, Symbol, cos, exp, pi, re, sqrt, tan

from . import oblique_cases, oblique_degenerate, oblique_lattice, oblique_quartic, oblique_shape
from .claims import Domain, Equal, Notebook
from .functions import wp_prime
from .load_case import LoadCase
from .oblique_cases import Special
from .oblique_degenerate import Degenerate
from .oblique_lattice import HalfAngleLattice, cubic
from .oblique_quartic import HalfAngle, theta_tip
from .oblique_shape import AT_V, POLE, WHERE, HalfAngleShape, b, c, g2, g3
from .plane import Plane
from .symbols import alpha, beta, ell, sigma, theta
from .weierstrass import Weierstrass

place, turns = Symbol("Y"), Symbol("Y_2")  # ∫e^{iθ} and ∫e^{2iθ} along the whole rod
clamp_angle = Symbol("clamp_angle", real=True)  # θ(0)


@dataclass(frozen=True)
class Oblique:
    """The solution at any angle of the field.

    half, lattice, shape, degenerate: from the scripts of these names. constants: b, c, g₂, g₃ of the shape in θ(ℓ) and
    α. pole, slope: ℘(v) and ℘′(v). position: y + iz of the shape with this slope. value_at_clamp: ℘(ℓ) in θ(0), the
    condition for θ(ℓ). energy: of the rod over EI, in ∫e^{iθ} and ∫e^{2iθ}. special: the load cases of the article.
    """

    half: HalfAngle
    lattice: HalfAngleLattice
    shape: HalfAngleShape
    degenerate: Degenerate
    constants: Mapping[Symbol, Expr]
    pole: Expr
    slope: Expr
    position: Expr
    value_at_clamp: Expr
    energy: Expr
    special: Mapping[str, Special]


def derive(
    plane: Plane, cases: Mapping[str, LoadCase], functions: Mapping[str, Weierstrass], book: Notebook
) -> Oblique:
    """The exact solution for a field at any in-plane angle."""
    half = oblique_quartic.derive(plane, book)
    lattice = oblique_lattice.derive(book)
    shape = oblique_shape.derive(book)
    degenerate = oblique_degenerate.derive(lattice, book)
    book.say("Any angle of the field. The constants of a rod")
    values = (lattice.at.b, lattice.at.c, lattice.g2, lattice.g3)
    constants = {x: value.subs(half.coefficients) for x, value in zip((b, c, g2, g3), values, strict=True)}
    stiffness = cases["parallel"].stiffness
    slope = _slope(stiffness, constants, half, book)
    return Oblique(
        half=half,
        lattice=lattice,
        shape=shape,
        degenerate=degenerate,
        constants=constants,
        pole=POLE.subs(constants),
        slope=slope,
        position=_position(shape, stiffness, slope, constants, half, book),
        value_at_clamp=_at_clamp(constants, half, book),
        energy=_energy(plane, half, book),
        special=oblique_cases.derive(half, lattice, cases, functions, book),
    )


def _slope(stiffness: Expr, constants: Mapping[Symbol, Expr], half: HalfAngle, book: Notebook) -> Expr:
    """℘′(v) = ib√H e^{i(θ(ℓ) − α)}: the sign chooses between v and −v."""
    slope = book.show("℘′(v)", I * constants[b] * sqrt(stiffness) * exp(I * (theta_tip - alpha)))
    squares = Equal(slope**2, cubic(constants[g2], constants[g3], POLE.subs(constants)))
    title, steps = "℘′(v) by the differential equation of ℘", ("oblique.coefficients", "oblique.resolvent")
    book.claim("oblique.slope", title, squares, domain=half.domain, steps=steps)
    return slope


def _position(
    shape: HalfAngleShape,
    stiffness: Expr,
    slope: Expr,
    constants: Mapping[Symbol, Expr],
    half: HalfAngle,
    book: Notebook,
) -> Expr:
    """y + iz with 2ib/℘′(v) = 2e^{−i(θ(ℓ) − α)}/√H: the strength of the logarithm is the same for every tip."""
    position = exp(I * theta_tip) * sigma + 2 * exp(I * alpha) / sqrt(stiffness) * shape.logarithm
    book.show("y + iz", position)
    given = ((wp_prime(*AT_V), slope), (b, constants[b]))
    where = Domain({**WHERE.ranges, **half.domain.ranges})
    title, steps = "y + iz with 2e^{iα}/√H", ("oblique.position", "oblique.slope")
    same = Equal(position, shape.position)
    book.claim("oblique.position_field", title, same, domain=where, given=given, steps=steps)
    return position


def _at_clamp(constants: Mapping[Symbol, Expr], half: HalfAngle, book: Notebook) -> Expr:
    """℘(ℓ) where the rod begins, against the curvature there: θ′ = −2(dt/dσ)/(1 + t²) and dt/dσ = −b℘′/(℘ − c)²."""
    b_tip, c_tip = constants[b], constants[c]
    t_clamp = tan((clamp_angle - theta_tip) / 2)
    value = book.show("℘(ℓ)", c_tip + b_tip / t_clamp)
    moment = 4 * b_tip**2 * cubic(constants[g2], constants[g3], value) / (value - c_tip) ** 4 / (1 + t_clamp**2) ** 2
    curvature = Equal(moment, half.levels.subs(theta, clamp_angle))
    title, where = "the clamp, by its curvature", half.domain.with_range(clamp_angle, -pi, pi)
    steps = ("oblique.solution", "oblique.quartic")
    book.claim("oblique.clamp", title, curvature, domain=where, steps=steps)
    return value


def _energy(plane: Plane, half: HalfAngle, book: Notebook) -> Expr:
    """∫(½θ′² + ψ − β cos θ)ds by ∫e^{iθ} and ∫e^{2iθ}, for ψ = ψ₂w² + ψ₁w with w = cos(θ − α)."""
    density = Poly(plane.energy_density, plane.alignment)
    linear, quadratic = (density.coeff_monomial(plane.alignment**power) for power in (1, 2))
    # exsl8: ½θ′² is ½γ − β cos θ + ψ; and w² = ½(1 + cos 2(θ − α)).
    constant, towards = half.gamma / 2 + quadratic, exp(-I * alpha)
    first, second = 2 * linear * towards - 2 * beta, quadratic * towards**2
    energy = book.show("energy", constant * ell + re(first * place + second * turns))
    # Per unit length.
    along = energy.subs({ell: 1, place: exp(I * theta), turns: exp(2 * I * theta)}).expand(complex=True)
    work = plane.energy_density.subs(plane.alignment, cos(theta - alpha)) - beta * cos(theta)
    title, where = "the energy along the rod by e^{iθ}", half.domain.with_range(theta, -pi, pi)
    same, steps = Equal(along, half.levels / 2 + work), ("plane.energy", "plane.variation", "oblique.free_end")
    book.claim("oblique.energy", title, same, domain=where, steps=steps)
    return energy


def main() -> None:
    """Print the derivation up to here."""
    from .chain import print_up_to

    print_up_to("oblique")


if __name__ == "__main__":
    main()
