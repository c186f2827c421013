"""Section 3, exsl3 and exslrm1 to exslrm6: when a straight rod in equilibrium stays in a plane.

With force and field in one plane, the balance of moments keeps the rod in it. With the field along the force nobody has
to ask for that: the moment about their direction vanishes at the free end, so everywhere, and with it the torsion.
``equilibrium`` calls this script, and its claims are among those of ``equilibrium``.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from sympy import Expr, Function, Matrix, Symbol, cos, sin

from derive.theory.claims import Equal, Notebook
from derive.theory.frame import along, frenet, triple
from derive.theory.letters import EI, angle, e1, e2, e3, unit, vector
from derive.theory.symbols import s
from derive.theory.variation import Balance

PULL = Symbol("F_e", real=True)  # the force over EI where it is along e


@dataclass(frozen=True)
class Straight:
    """A straight rod: the left side of its balance of moments by d₃, force and e, and the couple's modulus by d₃·e."""

    residual: Callable[[Matrix, Matrix, Matrix], Matrix]
    modulus: Callable[[Expr], Expr]

    def across(self, d3: Matrix, e: Matrix) -> Expr:
        """What d₃ × e is multiplied by in the balance of moments where the force is PULL · e."""
        return PULL + self.modulus(d3.dot(e))


def tangent() -> tuple[Matrix, Matrix]:
    """d₃ as a point that moves on the unit sphere, and its two angles as functions of s."""
    angles = Matrix([Function(name, real=True)(s) for name in ("theta", "phi")])
    return unit(*angles), angles


def derive(rod: Straight, balance: Balance, book: Notebook) -> None:
    """The claims on rods in a plane."""
    claim_plane(rod, book)
    claim_along(rod, balance, book)
    claim_planar(rod, book)


def claim_plane(rod: Straight, book: Notebook) -> None:
    """Nothing turns a rod out of the plane of y and z, if force and field lie in it."""
    y, z = (Function(name, real=True)(s).diff(s) for name in "yz")
    alpha, force = angle("alpha"), vector("F")[1]
    d3, e = y * e2 + z * e3, cos(alpha) * e2 + sin(alpha) * e3
    couple = rod.modulus(y * cos(alpha) + z * sin(alpha)) * (y * sin(alpha) - z * cos(alpha))
    balance = y * z.diff(s, 2) - z * y.diff(s, 2) - force * z + couple
    book.claim(
        "equilibrium.plane",
        "in the plane of force and field the moments balance but about the direction across it",
        Equal(rod.residual(d3, force * e2, e), balance * e1),
        steps=["equilibrium.residual"],
        source="exsl3",
    )


def claim_along(rod: Straight, balance: Balance, book: Notebook) -> None:
    """With the field along the force: the balance of moments, and the moment along e where there is no twist."""
    d3, _ = tangent()
    e = vector("e")
    book.claim(
        "equilibrium.along",
        "with the field along the force, force and couple together are a multiple of d3 x e",
        Equal(rod.residual(d3, PULL * e, e), d3.cross(d3.diff(s)).diff(s) + rod.across(d3, e) * d3.cross(e)),
        steps=["equilibrium.residual"],
        source="exslrm1",
    )
    kappa, kappa_u = balance.couple.line.rod.frame.kappa, balance.couple.line.rod.kappa_u
    moment = balance.resultant.subs({**dict.fromkeys(kappa_u, 0), kappa[2]: 0})
    book.claim(
        "equilibrium.moment_along",
        "without twist the moment along e is the bending stiffness times the triple product of d3, d3' and e",
        Equal(moment.dot(e), EI * triple(e3, along(e3, kappa), e)),
        steps=["equilibrium.constitutive", "equilibrium.twist"],
        source="exslrm4",
    )


def claim_planar(rod: Straight, book: Notebook) -> None:
    """With the field along the force and a free end, the torsion vanishes where the curvature does not."""
    d3, _ = tangent()
    slope, e = d3.diff(s), vector("e")
    residual = rod.residual(d3, PULL * e, e)
    moment = triple(d3, slope, e)  # M·e over EI, when there is no twist
    book.claim(
        "equilibrium.projection",
        "along the common direction of field and force the moment does not change",
        Equal(residual.dot(e), moment.diff(s)),
        steps=["equilibrium.along"],
        source="exslrm3",
    )
    book.claim(
        "equilibrium.triple",
        "the triple product of d3 and its derivatives is minus the derivative of d3 x d3' along d3'",
        Equal(triple(d3, slope, slope.diff(s)), -d3.cross(slope).diff(s).dot(slope)),
        source="exslrm6",
    )
    # In the Serret-Frenet frame, where the tangent is the third vector.
    k, torsion, turning = frenet()
    first = along(e3, turning)
    book.claim(
        "equilibrium.torsion",
        "the triple product of d3 and its derivatives is the torsion times the square of the curvature",
        Equal(triple(e3, first, along(first, turning)), torsion * k**2),
        steps=["frame.frenet"],
        source="exslrm6",
    )
    book.claim(
        "equilibrium.planar",
        "in equilibrium the triple product is a multiple of the moment along e, which is zero at the free end",
        Equal(triple(d3, slope, slope.diff(s)) + residual.dot(slope), -rod.across(d3, e) * moment),
        steps=["equilibrium.projection", "equilibrium.moment_along", "equilibrium.triple", "equilibrium.torsion"],
        source="exslrm5",
    )
