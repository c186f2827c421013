"""The plane problem: from the vector equation of equilibrium to θ″, the first integral and (y″)² (exsl1-exsl12a).

The rod lies in the plane (y, z); the force has the direction of y, the field makes the angle α with y, and θ is the
angle from y to the tangent d₃.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from sympy import (
    Expr,
    Function,
    Integer,
    Matrix,
    Symbol,
    cancel,
    cos,
    diff,
    expand,
    integrate,
    oo,
    pi,
    sin,
    sqrt,
    symbols,
    trigsimp,
    zeros,
)

from .claims import Domain, Equal, Notebook
from .symbols import alpha, beta, eta, gamma, s, theta, xi

theta_s = Symbol("theta_s", real=True)  # θ′, the curvature κ_x
theta_ss = Symbol("theta_ss", real=True)  # θ″

# Area and second moment of area of the section, Young's modulus, permeability of vacuum.
A, inertia, E, mu_0 = symbols("A I E mu_0", positive=True)
F, h_a, k, susceptibility = symbols("F h_a k nu_V_chi", positive=True)  # force, field, curvature, ν V_Π χ


@dataclass(frozen=True)
class Plane:
    """The plane problem.

    alignment: w = d₃·e. energy_density: ψ(w) − ψ(0), magnetic energy per unit length over EI. parameters: its letters.
    angular_acceleration: θ″ in θ, α. curvature_squared: κ_x² in γ, ξ = y′ and w. square: (y″)² in the same. barred:
    the dimensionless variables.
    """

    alignment: Symbol
    energy_density: Expr
    parameters: tuple[Symbol, ...]
    angular_acceleration: Expr
    curvature_squared: Expr
    square: Expr
    barred: Mapping[Symbol, Expr]


def derive(equilibrium: Any, book: Notebook) -> Plane:
    """Project the vector equation on the plane, integrate it once, and square y″."""
    book.say("Section 3. The plane problem")
    w, density = equilibrium.alignment, equilibrium.energy_density
    parameters = tuple(sorted(density.free_symbols - {w}, key=lambda symbol: symbol.name))
    domain = Domain({theta: (0, pi), alpha: (0, pi), beta: (0, oo), **dict.fromkeys(parameters, (0, oo))})
    acceleration = _project(equilibrium, domain, book)
    # Only differences of energy matter: ψ counts from w = 0.
    energy = integrate(diff(density, w), (w, 0, w))
    curvature_squared = _first_integral(acceleration, w, energy, domain, book)
    square = _square(acceleration, curvature_squared, w, domain, book)
    barred = _units(acceleration, parameters, domain, book)
    return Plane(w, energy, parameters, acceleration, curvature_squared, square, barred)


def _project(equilibrium: Any, domain: Domain, book: Notebook) -> Expr:
    """θ″ from the component of the moment equation normal to the plane (exsl6, exsl9)."""
    # exsl3: the tangent, the force and the field in the plane; exsl4 holds by construction.
    angle = Function("theta", real=True)(s)
    d3 = Matrix([0, cos(angle), sin(angle)])
    force = Matrix([0, beta, 0])
    e = Matrix([0, cos(alpha), sin(alpha)])
    book.claim("plane.inextensible", "d₃ is a unit vector", Equal(_at(d3.dot(d3)), 1), domain=domain, source="exsl4")
    # exsl9: the curvature vector d₃ × d₃′ has only one component, θ′.
    bent = domain.with_range(theta_s, 0, 1).with_range(theta_ss, 0, 1)
    kappa = _at(d3.cross(d3.diff(s)))
    only_x = Equal(kappa, Matrix([theta_s, 0, 0]))
    rests: tuple[str, ...] = ("frame.binormal", "plane.inextensible")
    book.claim("plane.curvature", "d₃ × d₃′ = θ′ e_x", only_x, domain=bent, steps=rests, source="exsl9")
    # exsl9a, exsl10: y″ = −κ_x z′, and its square by inextensibility.
    y_ss, z_s = _at(d3[1].diff(s)), _at(d3[2])
    bending = Equal(y_ss, -kappa[0] * z_s)
    book.claim("plane.bending", "y″ = −κ_x z′", bending, domain=bent, steps=("plane.curvature",), source="exsl9a")
    squared = Equal(y_ss**2, kappa[0] ** 2 * (1 - _at(d3[1]) ** 2))
    rests = ("plane.bending", "plane.inextensible")
    title = "(y″)² = κ_x²(1 − y′²)"
    book.claim("plane.bending_squared", title, squared, domain=bent, steps=rests, source="exsl10")
    # exsl6 in components: the one along x is linear in θ″, the others vanish.
    moment = _at(equilibrium.residual(d3, force, e).doit()).expand()
    factor = trigsimp(diff(moment[0], theta_ss))
    acceleration = book.show("θ″", cancel(-moment[0].subs(theta_ss, 0) / factor))
    balance = Equal(moment.subs(theta_ss, acceleration), zeros(3, 1))
    rests = ("equilibrium.residual", "equilibrium.twist", "plane.curvature")
    title = "with this θ″ the moments balance"
    book.claim("plane.moment", title, balance, domain=bent, steps=rests, source="exsl6")
    # The same by varying ½θ′² + ψ(w) − β cos θ, with w the cosine of the angle from the field to d₃.
    energy = equilibrium.energy_density.subs(equilibrium.alignment, cos(theta - alpha))
    varied = diff(energy - beta * cos(theta), theta)
    rests = ("equilibrium.energy", "plane.moment")
    title = "θ″ makes the energy stationary"
    book.claim("plane.variation", title, Equal(acceleration, varied), domain=domain, steps=rests)
    return acceleration


def _at(expression: Any) -> Any:
    """The expression with θ(s), θ′(s), θ″(s) as plain symbols."""
    angle = Function("theta", real=True)(s)
    values = [(angle.diff(s, 2), theta_ss), (angle.diff(s), theta_s), (angle, theta)]
    return expression.subs(values).expand() if isinstance(expression, Expr) else expression.subs(values)


def _first_integral(acceleration: Expr, w: Symbol, energy: Expr, domain: Domain, book: Notebook) -> Expr:
    """κ_x² = γ + 2∫θ″ dθ, the field counted from w = 0 (exsl8)."""
    # Dot exsl6 with d₃ × d₃′: (κ_x²)′ = 2θ″θ′. The force does work through ξ, the field through w: with α = 0 both
    # are cos θ, and dξ = dw = −sin θ dθ.
    field = acceleration.subs(beta, 0)
    pull = cancel((acceleration - field) / -sin(theta)).subs(cos(theta), xi)
    turn = cancel(field.subs(alpha, 0) / -sin(theta)).subs(cos(theta), w)
    potential = integrate(pull, (xi, 0, xi)) + integrate(turn, (w, 0, w))
    curvature_squared = book.show("κ_x²", expand(gamma + 2 * potential))
    along = curvature_squared.subs({xi: cos(theta), w: cos(theta - alpha)})
    domain = domain.with_range(gamma, 0, 1)
    back = Equal(diff(along, theta), 2 * acceleration)
    title, rests = "κ_x² differentiates back to 2θ″", ("plane.curvature", "plane.moment")
    book.claim("plane.first_integral", title, back, domain=domain, steps=rests, source="exsl8")
    levels = gamma - 2 * beta * xi + 2 * energy
    domain = domain.with_range(xi, 0, 1).with_range(w, 0, 1)
    conserved = Equal(curvature_squared, levels)
    title, rests = "κ_x² by conservation of energy", ("plane.first_integral", "plane.variation")
    book.claim("plane.energy", title, conserved, domain=domain, steps=rests, source="exsl8")
    return curvature_squared


def _square(acceleration: Expr, curvature_squared: Expr, w: Symbol, domain: Domain, book: Notebook) -> Expr:
    """(y″)² = κ_x²(1 − ξ²), with ξ = y′ = cos θ (exsl11, exsl12)."""
    square = book.show("(y″)²", curvature_squared * (1 - xi**2))
    # Differentiated, 2y″y‴ = ((y″)²)′, it must give y‴ = −cos θ θ′² − sin θ θ″.
    along = {xi: cos(theta), w: cos(theta - alpha)}
    third = -cos(theta) * curvature_squared.subs(along) - sin(theta) * acceleration
    slope = diff(square.subs(along), theta) / diff(cos(theta), theta)
    relation = Equal(slope / 2, third)
    book.claim(
        "plane.square",
        "half the derivative of (y″)² along y′ is y‴",
        relation,
        domain=domain.with_range(gamma, 0, 1),
        steps=("plane.first_integral", "plane.bending_squared", "plane.moment"),
        source="exsl11",
    )
    return square


def _units(acceleration: Expr, parameters: tuple[Symbol, ...], domain: Domain, book: Notebook) -> dict[Symbol, Expr]:
    """Dimensionless variables: each quantity over its unit, by exponents of length, force and current (exsl7)."""
    length, force, current = sqrt(inertia / A), E * A, sqrt(E * A / mu_0)
    # Exponents of (length, force, current): β and η are a force and a couple modulus over EI.
    exponents = {s: (1, 0, 0), k: (-1, 0, 0), F: (0, 1, 0), h_a: (-1, 0, 1), beta: (-2, 0, 0)}
    exponents |= {A: (2, 0, 0), inertia: (4, 0, 0), E: (-2, 1, 0), mu_0: (0, 1, -2)}
    exponents |= dict.fromkeys((eta, *parameters), (-2, 0, 0))
    barred = {q: q / (length**m * force**n * current**i) for q, (m, n, i) in exponents.items()}
    positive = Domain(dict.fromkeys((A, inertia, E, mu_0, F, h_a, k, s, susceptibility), (0, oo)))

    def claim(name: str, title: str, left: Expr, right: Expr, *rests: str, where: Domain = positive) -> None:
        book.claim(f"plane.units_{name}", title, Equal(left, right), domain=where, steps=rests, source="exsl7")

    claim("curvature", "an angle, curvature times length, has no unit", barred[k] * barred[s], k * s)
    claim("stiffness", "the bending stiffness becomes 1", barred[E] * barred[inertia], Integer(1))
    claim("permeability", "the permeability of vacuum becomes 1", barred[mu_0], Integer(1))
    # exsl5, exsl6: β and η are the force and the couple modulus over EI.
    claim(
        "force",
        "β of the bars is the force of the bars",
        barred[beta].subs(beta, F / (E * inertia)),
        barred[F],
        "plane.units_stiffness",
        "equilibrium.residual",
    )
    couple = A * mu_0 * susceptibility * h_a**2 / (E * inertia)
    claim(
        "field",
        "η is made of the bars as it was",
        barred[eta].subs(eta, couple),
        couple.subs(barred, simultaneous=True),
        "plane.units_stiffness",
        "plane.units_permeability",
        "equilibrium.energy",
    )
    # θ″ carries the unit 1/length², as β and η do: the equation keeps its form.
    scale = {q: barred[q] for q in (beta, *parameters)}
    lengths = Domain({**domain.ranges, A: (0, oo), inertia: (0, oo)})
    same = acceleration.subs(scale, simultaneous=True)
    claim(
        "equation",
        "the equation keeps its form",
        same,
        acceleration * (s / barred[s]) ** 2,
        "plane.moment",
        "plane.units_force",
        "plane.units_field",
        where=lengths.with_range(s, 0, oo),
    )
    return barred


def main() -> None:
    """Print the derivation up to here."""
    from .chain import print_up_to

    print_up_to("plane")


if __name__ == "__main__":
    main()
