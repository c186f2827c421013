"""The load cases of the article as special cases of any field angle.

The field along the force, normal to it, alone, or absent: the mirror image of the rod obeys the same equation, so that
it would also turn back at −θ(ℓ), and e = ℘ there is a half-period value, ℘(ω). cos θ does not tell the two apart: it
has the further period ω, which is half a period of t. Its ℘ is ℘(σ) + ℘(σ + ω) − e, with the article's g₂ and g₃ as
invariants: the two lattices are related by a Landen transformation, they are not the same.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from sympy import Add, Expr, Integer, Matrix, Rational, Symbol, cos, diff, oo, pi, symbols, tan

from .claims import Domain, Equal, Limit, Notebook
from .functions import wp, wp_prime
from .load_case import LoadCase, xi_tip
from .oblique_lattice import HalfAngleLattice, cubic
from .oblique_quartic import QUARTIC, HalfAngle, t, theta_tip, turned_cosine
from .symbols import alpha, u, xi
from .weierstrass import Weierstrass, kappa

e, g2, g3 = symbols("e g2 g3", real=True)  # the half-period value at the mirror image, and the invariants
omega = Symbol("omega")  # ℘(ω) = e
# Where each load case lies: alone, the field has the direction of y, and without field its direction is nothing.
PLACES: dict[str, dict[Symbol, Expr]] = {
    "parallel": {alpha: Integer(0)},
    "orthogonal": {alpha: pi / 2},
    "field_only": {theta_tip: theta_tip + alpha},
    "force_only": {},
}


@dataclass(frozen=True)
class Special:
    """A load case in the half angle. at: what is put for α, θ(ℓ), β, η. mirror: e. All else in θ(ℓ)."""

    at: Mapping[Symbol, Expr]
    coefficients: Mapping[Symbol, Expr]
    mirror: Expr


def derive(
    half: HalfAngle,
    lattice: HalfAngleLattice,
    cases: Mapping[str, LoadCase],
    functions: Mapping[str, Weierstrass],
    book: Notebook,
) -> Mapping[str, Special]:
    """All load cases that there are."""
    book.say("Any angle of the field. The load cases of the article")
    _claim_transformation(book)
    return {name: _case(case, functions[name], half, lattice, book) for name, case in cases.items()}


def rate(e: Expr, g2: Expr) -> Expr:
    """½℘″(ω) = (e − e′)(e − e″), with e′, e″ the other half-period values."""
    return 3 * e**2 - g2 / 4


def doubled(value: Expr, e: Expr, g2: Expr) -> Expr:
    """℘(σ) + ℘(σ + ω) − e by the value of ℘(σ)."""
    return value + rate(e, g2) / (value - e)


def doubled_invariants(e: Expr, g2: Expr, g3: Expr) -> tuple[Expr, Expr]:
    """By ℘ = u⁻² + g₂u²/20 + g₃u⁴/28 + … (DLMF 23.9.2, 23.9.4): 1/(℘ − e) adds u² + eu⁴ + …"""
    return g2 + 20 * rate(e, g2), g3 + 28 * rate(e, g2) * e


def _claim_transformation(book: Notebook) -> None:
    """The transformation for any lattice and any of its half-periods."""
    # e is a root of 4ϰ³ − g₂ϰ − g₃, and ℘′(ω) = 0.
    root = {g3: 4 * e**3 - g2 * e}
    at_omega = tuple(function(omega, g2, g3).subs(root) for function in (wp, wp_prime))
    given = (*root.items(), *zip(at_omega, (e, Integer(0)), strict=True))
    where, source = Domain({g2: (3, 4), e: (1, 2)}), "DLMF 23.10.1"
    value = wp(u, g2, g3)
    # u − ω would do as well: 2ω is a period.
    turned = Equal(value + value.subs(u, Add(u, omega)) - e, doubled(value, e, g2))
    title, steps, along = "℘ and ℘ half a period on", ("shape.addition",), where.with_range(u, Rational(1, 5), 1)
    book.claim("oblique.half_period", title, turned, domain=along, given=given, steps=steps, source=source)
    # It obeys the differential equation of a ℘, and it is that ℘: no other solution has its pole at u = 0.
    new = doubled(kappa, e, g2)
    speed = diff(new, kappa) ** 2 * cubic(g2, g3)
    same, given = Equal(speed, cubic(*doubled_invariants(e, g2, g3), new)), tuple(root.items())
    title, steps, along = "their sum is a ℘", ("oblique.half_period",), where.with_range(kappa, 2, 3)
    book.claim("oblique.doubled", title, same, domain=along, given=given, steps=steps, source="DLMF 23.3.10")
    gap = Limit(new.subs(kappa, 1 / kappa) - 1 / kappa, kappa, Integer(0), Integer(0), "+-")
    title, steps, along = "both are infinite at u = 0 alike", ("oblique.doubled",), where.with_range(kappa, 0, 1)
    book.claim("oblique.doubled_pole", title, gap, domain=along, steps=steps, source="DLMF 23.9.2")


def _case(
    case: LoadCase, functions: Weierstrass, half: HalfAngle, lattice: HalfAngleLattice, book: Notebook
) -> Special:
    """One load case: its f by the half-angle quartic, and the turning back at −θ(ℓ)."""
    parameters = [x for x in half.domain.ranges if x not in (theta_tip, alpha)]
    at = {**dict.fromkeys((x for x in parameters if x not in case.parameters), Integer(0)), **PLACES[case.name]}
    coefficients = {letter: value.subs(at) for letter, value in half.coefficients.items()}
    quartic, name = QUARTIC.subs(coefficients), f"oblique.{case.name}"
    where = Domain({theta_tip: (-pi, pi), alpha: (-pi, pi), **case.domain().ranges})
    xi_of_t = turned_cosine(theta_tip)
    f = (case.at_tip * (1 - xi**2)).subs({xi_tip: cos(theta_tip), xi: xi_of_t})
    same, running = Equal(diff(xi_of_t, t) ** 2 * quartic, f), where.with_range(t, -oo, oo)
    title, steps = "f by the half-angle quartic", ("oblique.quartic", *case.ids("quartic.free_end"))
    book.claim(f"{name}.quartic", title, same, domain=running, steps=steps, source=case.source("quartic"))
    back = -tan(theta_tip)
    turn = Equal(quartic.subs(t, back), 0)
    title, steps = "the rod would turn back at −θ(ℓ)", (f"{name}.quartic",)
    book.claim(f"{name}.mirror", title, turn, domain=where, steps=steps, source=case.source("quartic"))
    mirror = book.show(f"e in the load case {case.name}", lattice.at.value_at(back).subs(coefficients))
    special = Special(at, coefficients, mirror)
    _claim_lattice(case, functions, special, lattice, where, book)
    return special


def _claim_lattice(
    case: LoadCase, functions: Weierstrass, special: Special, lattice: HalfAngleLattice, where: Domain, book: Notebook
) -> None:
    """The invariants of the load case, and ξ as it is expanded at the tip."""
    name, e = f"oblique.{case.name}", special.mirror
    g2, g3 = (x.subs(special.coefficients) for x in (lattice.g2, lattice.g3))
    expected = Matrix([functions.g2, functions.g3]).subs(case.constant, case.tip_constant)
    same = Equal(Matrix(doubled_invariants(e, g2, g3)), expected.subs(xi_tip, cos(theta_tip)))
    title, steps = "g₂ and g₃ of the article", ("oblique.doubled", f"{name}.mirror", *case.ids("weierstrass.at_tip"))
    book.claim(f"{name}.invariants", title, same, domain=where, steps=steps, source=case.source("invariants"))
    by_half_angle = turned_cosine(theta_tip).subs(t, lattice.at.xi_at(kappa).subs(special.coefficients))
    by_tip = functions.at_tip.xi_at(doubled(kappa, e, g2)).subs(xi_tip, cos(theta_tip))
    same, running = Equal(by_half_angle, by_tip), where.with_range(kappa, 2, 3)
    title, steps = "ξ by ℘ at the tip", (f"{name}.invariants", "oblique.solution", "oblique.doubled_pole")
    book.claim(f"{name}.xi", title, same, domain=running, steps=steps, source=case.source("solution"))
