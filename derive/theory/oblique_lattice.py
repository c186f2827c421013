"""℘ of the half-angle quartic: t = b/(℘(σ) − c), the invariants by three routes, and both signs of the discriminant.

Everything is real on the rod, whatever the sign of the discriminant g₂³ − 27g₃²: the invariants are real, and ℘ falls
from infinity at the tip to the largest real half-period value, where the rod would turn back.

- Positive: e₁, e₂, e₃ are real; with the tip there are four directions at which the rod would turn back.
- Negative: one of them is real, the others are conjugate; there are two such directions.
- Zero: two of them coincide. Either p = 0 and the rod is straight, or it would take an infinite length to the next
  turning back, and ℘ is elementary.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

from sympy import (
    Derivative,
    Expr,
    I,
    Integer,
    Poly,
    Rational,
    Symbol,
    cancel,
    diff,
    discriminant,
    expand,
    oo,
    sqrt,
    symbols,
)

from .claims import Domain, Equal, Limit, Notebook, Positive
from .functions import RF, wp
from .oblique_quartic import COEFFICIENTS, QUARTIC, m, n, p, q, t
from .symbols import sigma
from .weierstrass import Expansion, expansion, invariants, kappa, resolvent

t_1, t_2, t_3 = TURNS = symbols("t_1:4")  # t where the rod would turn back, other than at the tip
d_1, d_2 = symbols("d_1 d_2", positive=True)  # e₁ − e₂ and e₂ − e₃
x, y = Symbol("x", real=True), Symbol("y", positive=True)  # e₂, e₃ = x ± iy
# e₁ + e₂ + e₃ = 0 (DLMF 23.3.5), for either sign of the discriminant.
THREE = ((2 * d_1 + d_2) / 3, (d_2 - d_1) / 3, -(d_1 + 2 * d_2) / 3)
PAIR = (-2 * x, x + I * y, x - I * y)
KINDS = (
    ("three", THREE, Domain({d_1: (0, oo), d_2: (0, oo)}), 1),
    ("pair", PAIR, Domain({x: (-oo, oo), y: (0, oo)}), -1),
)
above = Symbol("above", positive=True)  # ℘ less the largest real half-period value
near = Symbol("near", positive=True)  # its inverse


@dataclass(frozen=True)
class HalfAngleLattice:
    """at: the expansion t = b/(℘ − c). g2, g3: the invariants; all in p, q, m, n."""

    at: Expansion
    g2: Expr
    g3: Expr


def derive(book: Notebook) -> HalfAngleLattice:
    """The solution of (dt/dσ)² = n t⁴ + m t³ + q t² + p t by ℘."""
    book.say("Any angle of the field. The Weierstrass function of the half angle")
    g2, g3 = book.show("g₂, g₃", invariants(QUARTIC, t))
    at = expansion(QUARTIC, Integer(0), t)
    book.show("b, c", (at.b, at.c))
    lattice = HalfAngleLattice(at, g2, g3)
    _claim_solution(lattice, book)
    _claim_turns(lattice, book)
    _claim_signs(book)
    _claim_length(book)
    return lattice


def cubic(g2: Expr, g3: Expr, value: Expr = kappa) -> Expr:
    """4ϰ³ − g₂ϰ − g₃ (DLMF 23.3.10)."""
    return 4 * value**3 - g2 * value - g3


def of_roots(roots: Iterable[Expr]) -> Expr:
    """4(ϰ − e₁)(ϰ − e₂)(ϰ − e₃)."""
    product = Integer(4)
    for root in roots:
        product = product * (kappa - root)
    return product


def _claim_solution(lattice: HalfAngleLattice, book: Notebook) -> None:
    """The invariants by the coefficients against the resolvent at t = 0, and the differential equation of t."""
    where = Domain(dict.fromkeys((*COEFFICIENTS, kappa), (0, 1)))
    same = Equal(resolvent(QUARTIC, lattice.at, t), cubic(lattice.g2, lattice.g3))
    title, steps = "the resolvent at the tip", ("weierstrass.resolvent", "weierstrass.depressed")
    book.claim("oblique.resolvent", title, same, domain=where, steps=steps, source="exsl19")
    t_of_sigma = lattice.at.xi_at(wp(sigma, lattice.g2, lattice.g3))
    solved = Equal(diff(t_of_sigma, sigma) ** 2, QUARTIC.subs(t, t_of_sigma))
    title, where = "t = b/(℘(σ) − c) solves the quartic", where.with_range(sigma, Rational(1, 5), 1)
    book.claim("oblique.solution", title, solved, domain=where, steps=("oblique.resolvent",), source="exsl22")
    start = Limit(lattice.at.xi_at(1 / kappa), kappa, Integer(0), Integer(0), "+-")
    title = "t is 0 at the tip, where ℘ is infinite"
    book.claim("oblique.tip", title, start, domain=where, steps=("oblique.solution",))


def _claim_turns(lattice: HalfAngleLattice, book: Notebook) -> None:
    """The half-period values by the roots t₁, t₂, t₃ of the quartic, real or conjugate; the discriminant by them."""
    # Vieta: the coefficients by the roots.
    rest = Poly(n * (t - t_1) * (t - t_2) * (t - t_3), t)
    by_turns = {letter: rest.coeff_monomial(t**power) for power, letter in enumerate((p, q, m))}
    values = [lattice.at.value_at(turn).subs(by_turns) for turn in TURNS]
    where = Domain({n: (0, oo), kappa: (0, 1)})
    product = Equal(of_roots(values), cubic(lattice.g2, lattice.g3).subs(by_turns))
    title, source = "e₁, e₂, e₃ from the directions of turning back", "DLMF 23.3.11"
    book.claim("oblique.roots", title, product, domain=where, steps=("oblique.resolvent",), source=source)
    difference = lattice.g2**3 - 27 * lattice.g3**2
    squares = Integer(16)
    for one, two in ((0, 1), (1, 2), (2, 0)):
        squares = squares * (values[one] - values[two]) ** 2
    title, source, where = "the discriminant by e₁, e₂, e₃", "DLMF 23.3.4", Domain({n: (0, oo)})
    same = Equal(cancel(difference.subs(by_turns)), squares)
    book.claim("oblique.discriminant_roots", title, same, domain=where, steps=("oblique.roots",), source=source)
    # By elimination, without the roots: that of the cubic that is left, and its value at the root 0.
    same = Equal(256 * difference, p**2 * discriminant(cancel(QUARTIC / t), t))
    title, where = "the discriminant by elimination", Domain(dict.fromkeys(COEFFICIENTS, (0, 1)))
    book.claim("oblique.discriminant", title, same, domain=where, steps=("oblique.resolvent",), source=source)


def _claim_signs(book: Notebook) -> None:
    """The sign of the discriminant, and that of ℘′² above the largest real half-period value."""
    for name, roots, where, sign in KINDS:
        equation = Poly(of_roots(roots), kappa)
        g2, g3 = -equation.coeff_monomial(kappa), -equation.coeff_monomial(1)
        what = "three real half-period values" if sign == 1 else "one real half-period value"
        same = Equal(equation.as_expr(), cubic(g2, g3))
        title, along, source = f"{what}, with the sum 0", where.with_range(kappa, 0, 1), "DLMF 23.3.11"
        book.claim(f"oblique.{name}", title, same, domain=along, steps=("oblique.roots",), source=source)
        signed, steps = Positive(sign * (g2**3 - 27 * g3**2)), (f"oblique.{name}", "oblique.discriminant_roots")
        title = f"{what}: the sign of the discriminant"
        book.claim(f"oblique.{name}_sign", title, signed, domain=where, steps=steps, source="DLMF 23.3.4")
        falling = Positive(equation.as_expr().subs(kappa, roots[0] + above))
        title, along = f"{what}: ℘ is real down to the largest", where.with_range(above, 0, oo)
        steps, source = (f"oblique.{name}", "oblique.solution"), "DLMF 23.3.10"
        book.claim(f"oblique.{name}_real", title, falling, domain=along, steps=steps, source=source)


def _claim_length(book: Notebook) -> None:
    """σ = R_F(℘ − e₁, ℘ − e₂, ℘ − e₃) up to the first turning back: dσ/d℘ = −1/√(4(℘ − e₁)(℘ − e₂)(℘ − e₃))."""
    for name, roots, where, _ in KINDS:
        gaps = [above + roots[0] - root for root in roots]
        length = RF(*gaps)
        speed = Equal(Derivative(length, above) ** 2 * of_roots(roots).subs(kappa, roots[0] + above), 1)
        where = where.with_range(above, 0, oo)
        title, steps = "the length from the tip by ℘", (f"oblique.{name}_real", "oblique.solution")
        book.claim(f"oblique.{name}_length", title, speed, domain=where, steps=steps, source="DLMF 19.25.35")
        # ℘ = ∞ at the tip; R_F is homogeneous of degree −½.
        scaled = (expand(near * gap.subs(above, 1 / near)) for gap in gaps)
        start = Limit(sqrt(near) * RF(*scaled), near, Integer(0), Integer(0), "+")
        title, where, source = "the length is 0 at the tip", where.with_range(near, 0, 1), "DLMF 19.16(ii)"
        steps = (f"oblique.{name}_length", "oblique.tip")
        book.claim(f"oblique.{name}_length_tip", title, start, domain=where, steps=steps, source=source)
