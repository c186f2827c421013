"""Section 2.3, elmr2 to elmr10: the equations of equilibrium, from the variation of elastic and magnetic energy.

The axis cannot be extended: a multiplier Φ keeps u′ = (Q − I) d₃^u, and turns out to be the resultant force. Vectors
are written in the frame d. Run ``python -m derive.theory.variation`` to print this part.
"""

from __future__ import annotations

from dataclasses import dataclass

from sympy import Expr, Matrix, Rational

from derive.theory import constraint, couple, elastic
from derive.theory.claims import Equal, Notebook, print_notebook
from derive.theory.constraint import FORCE
from derive.theory.couple import Couple
from derive.theory.elastic import STIFFNESS, TURN, vary_elastic
from derive.theory.energy import Energy
from derive.theory.frame import along
from derive.theory.letters import e1, e2, e3, vector, vector_of, w
from derive.theory.symbols import s

SHIFT = vector_of("delta_u")  # δu, the displacement of the axis, m
DIRECTION = vector_of("e")  # the direction of the field


@dataclass(frozen=True)
class Balance:
    """The equations of equilibrium, each zero, in the frame d.

    moment: of moments, N, for the curvature ``kappa`` of the frame, FORCE and DIRECTION. force: of forces, N/m.
    resultant: M = Cμ, N m. strain_energy: ψ_e, N.
    """

    couple: Couple
    moment: Matrix
    force: Matrix
    resultant: Matrix
    strain_energy: Expr


def euler(density: Expr, unknowns: Matrix) -> Matrix:
    """The coefficients of the unknowns after integration by parts; for a Lagrangian, its Euler-Lagrange expressions."""
    return Matrix([density.diff(x) - density.diff(x.diff(s)).diff(s) for x in unknowns])


def derive(magnetic: Couple, book: Notebook) -> Balance:
    """The variation of the energy under the constraint, and the equations that it gives."""
    rod = magnetic.line.rod
    kappa, mu = rod.frame.kappa, rod.mu
    resultant = STIFFNESS * mu
    delta_mu, delta_M, delta_elastic = vary_elastic(kappa, rod.kappa_u)
    # δψ_m by the chain rule through w = d₃·e, with δd₃ = δq × d₃.
    aligned = DIRECTION.dot(e3)
    delta_magnetic = magnetic.line.psi_m.diff(w).subs(w, aligned) * DIRECTION.dot(TURN.cross(e3))
    # Φ · δ(u′ − (Q − I) d₃^u): the displacement, and d₃ = Q d₃^u, vary (elmr6, elmr7).
    constraint.derive(rod.frame, book)
    delta_constraint = FORCE.dot(along(SHIFT, kappa) - TURN.cross(e3))

    # Integrate by parts; what multiplies δq and δu must vanish (elmr9).
    variation = delta_elastic + delta_magnetic + delta_constraint
    balance = Balance(
        magnetic,
        -euler(variation, TURN).expand(),
        -euler(variation, SHIFT).expand(),
        resultant,
        Rational(1, 2) * resultant.dot(mu),
    )
    book.say("Turn the frame and move the axis; the energy under the constraint must not change to first order.")
    book.show("balance of moments, in the frame", balance.moment)
    book.show("balance of forces, in the frame", balance.force)
    elastic.claim(rod, balance.strain_energy, (delta_mu, delta_M, delta_elastic), book)
    torque = magnetic.modulus.subs(w, aligned) * e3.cross(DIRECTION)
    claim_rest(kappa, torque, delta_magnetic, delta_constraint, book)
    claim_balance(balance, variation, torque, book)
    claim_lagrange(balance, book)
    return balance


def claim_rest(kappa: Matrix, torque: Matrix, delta_magnetic: Expr, delta_constraint: Expr, book: Notebook) -> None:
    """Variations of the magnetic energy and of the constraint."""
    book.claim(
        "variation.magnetic",
        "the magnetic energy changes by minus the work of the couple",
        Equal(delta_magnetic, -torque.dot(TURN)),
        steps=["couple.alignment"],
        source="elmr8",
    )
    at_ends = FORCE.dot(SHIFT).diff(s)
    book.claim(
        "variation.constraint",
        "the constraint's variation, integrated by parts: both terms inside carry the same sign",
        Equal(delta_constraint, at_ends - (along(FORCE, kappa).dot(SHIFT) + e3.cross(FORCE).dot(TURN))),
        steps=["constraint.density"],
        source="elmr7",
    )


def claim_balance(balance: Balance, variation: Expr, torque: Matrix, book: Notebook) -> None:
    """The equations, and the variation by them and by the terms at the ends."""
    kappa = balance.couple.line.rod.frame.kappa
    book.claim(
        "variation.moments",
        "the moment, the force at the axis and the magnetic couple are in balance",
        Equal(balance.moment, along(balance.resultant, kappa) + e3.cross(FORCE) + torque),
        steps=["variation.elastic", "variation.magnetic", "variation.constraint"],
        source="elmr10",
    )
    book.claim(
        "variation.forces",
        "the resultant force does not change along the rod",
        Equal(balance.force, along(FORCE, kappa)),
        steps=["variation.constraint"],
        source="elmr10",
    )
    at_ends = (balance.resultant.dot(TURN) + FORCE.dot(SHIFT)).diff(s)
    book.claim(
        "variation.total",
        "the variation is the work of the terms at the ends less that of the two balances",
        Equal(variation, at_ends - balance.moment.dot(TURN) - balance.force.dot(SHIFT)),
        steps=["variation.moments", "variation.forces"],
        source="elmr9",
    )

    book.claim(
        "variation.ends",
        "at an end that is free to turn the moment alone does work, and so it must vanish there",
        Equal(Matrix([variation.diff(x.diff(s)) for x in TURN]), balance.resultant),
        steps=["variation.total"],
        source="exsl1",
    )


def claim_lagrange(balance: Balance, book: Notebook) -> None:
    """The same equation of moments from the frame's three angles, in fixed axes, with no variation of vectors."""
    rod, psi_m = balance.couple.line.rod, balance.couple.line.psi_m
    angles, R, kappa = rod.frame.angles, rod.frame.R, rod.frame.kappa_of_angles
    # Each angle turns the frame about an axis, which is what multiplies the angle's derivative in κ.
    axes = kappa.jacobian(angles.diff(s))
    book.claim(
        "variation.axes",
        "when an angle varies, the vectors of the frame vary by their products with its axis",
        Equal(
            Matrix.vstack(*(R.diff(angle) for angle in angles)),
            Matrix.vstack(*(R * Matrix.hstack(*(axes[:, i].cross(d) for d in (e1, e2, e3))) for i in range(3))),
        ),
        steps=["frame.curvature"],
        source="elmr3",
    )
    force, e = vector("F"), vector("e")
    strain = kappa - rod.kappa_u
    d3 = R * e3
    energy = Rational(1, 2) * strain.dot(STIFFNESS * strain) + psi_m.subs(w, e.dot(d3)) - force.dot(d3)
    there = dict(zip([*rod.frame.kappa, *FORCE, *DIRECTION], [*kappa, *(R.T * force), *(R.T * e)], strict=True))
    book.claim(
        "variation.lagrange",
        "the Euler-Lagrange equations of the frame's angles are the balance of moments about their axes",
        Equal(euler(energy, angles), -axes.T * balance.moment.subs(there).doit()),
        steps=["variation.axes", "variation.moments"],
        source="elmr10",
    )


def chain(book: Notebook, energy: Energy | None = None) -> Balance:
    """The derivation up to here, from an energy (paramagnetic particles if none is given)."""
    return derive(couple.chain(book, energy), book)


def main() -> None:
    """Print the derivation so far, for paramagnetic particles."""
    print_notebook(chain)


if __name__ == "__main__":
    main()
