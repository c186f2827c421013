"""End of Section 2 and start of Section 3, exsl2 to exsl6: the equilibrium of a straight rod.

The rod is prismatic and free of twist before it is loaded, so κ^u = 0. Here the balance of moments becomes an equation
for d₃ in fixed axes; the twist is uniform; with the field along the force the axis stays in a plane.
Run ``python -m derive.theory.equilibrium`` to print all of Section 2.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass

from sympy import Expr, Matrix, Rational, Symbol

from derive.theory import loads, planarity
from derive.theory.claims import Equal, Notebook, print_notebook
from derive.theory.constraint import FORCE
from derive.theory.energy import Energy
from derive.theory.frame import along
from derive.theory.letters import EI, GJ, e3, eta_tilde, tau, tau_tilde, vector, w
from derive.theory.planarity import Straight, tangent
from derive.theory.symbols import eta, s
from derive.theory.variation import DIRECTION, Balance, euler


@dataclass(frozen=True)
class Equilibrium:
    """The equilibrium of a rod in a uniform field, over its bending stiffness.

    alignment: the symbol w = d₃·e. energy_density: ψ_m/(EI), 1/m², by w. residual(d3, force, e): left side of the
    equation of moments over EI, 1/m², 3 × 1; d3 a function of s in fixed axes, force F/(EI) in 1/m², e a unit vector.
    moduli: η and τ by the letters of Section 2. balance: the equations of Section 2, from which all earlier records
    can be reached (``balance.couple.line.rod.frame``).
    """

    alignment: Symbol
    energy_density: Expr
    residual: Callable[[Matrix, Matrix, Matrix], Matrix]
    moduli: Mapping[Symbol, Expr]
    balance: Balance


def derive(balance: Balance, book: Notebook) -> Equilibrium:
    """The equation of moments of a straight rod in fixed axes, with what follows from it before it is solved."""
    line = balance.couple.line
    # Divide by EI; the moduli become η and τ (exsl5).
    reduced = {eta_tilde: EI * eta, tau_tilde: EI * tau}
    energy_density = (line.named.xreplace(reduced) / EI).expand()
    moduli = {{eta_tilde: eta, tau_tilde: tau}[letter]: value / EI for letter, value in line.moduli.items()}
    modulus = -energy_density.diff(w)

    def residual(d3: Matrix, force: Matrix, e: Matrix) -> Matrix:
        """(d₃ × d₃′)′ + d₃ × F/(EI) + l/(EI), with the couple l along d₃ × e (exsl6)."""
        bending = d3.cross(d3.diff(s)).diff(s)
        return bending + d3.cross(force) + modulus.subs(w, d3.dot(e)) * d3.cross(e)

    state = Equilibrium(w, energy_density, residual, moduli, balance)
    book.say("A straight rod: divide the balance of moments by the bending stiffness.")
    book.show("psi_m / (EI)", energy_density)
    book.claim(
        "equilibrium.energy",
        "the reduced energy is the magnetic energy over the bending stiffness",
        Equal(EI * energy_density.subs(moduli), line.psi_m),
        steps=["line_energy.named"],
        source="exsl5",
    )
    claim_straight(state, book)
    claim_residual(state, book)
    claim_sphere(state, book)
    planarity.derive(Straight(residual, lambda aligned: modulus.subs(w, aligned)), balance, book)
    return state


def claim_straight(state: Equilibrium, book: Notebook) -> None:
    """The constitutive law without initial curvature, and the uniform twist."""
    balance = state.balance
    rod = balance.couple.line.rod
    kappa = rod.frame.kappa
    straight = dict.fromkeys(rod.kappa_u, 0)
    M, moment = (x.subs(straight).doit() for x in (balance.resultant, balance.moment))
    book.claim(
        "equilibrium.constitutive",
        "the moment bends in proportion to d3 x d3' and twists in proportion to the twist",
        Equal(M, EI * e3.cross(along(e3, kappa)) + GJ * kappa[2] * e3),
        steps=["frame.binormal"],
        source="exsl2",
    )
    book.claim(
        "equilibrium.axial",
        "the derivative of the moment along d3 is the derivative of its part along d3",
        Equal(along(M, kappa).dot(e3), M.dot(e3).diff(s)),
        steps=["equilibrium.constitutive"],
    )
    # Dot the balance of moments with d₃: force and couple drop out.
    book.claim(
        "equilibrium.twist",
        "along d3 the balance of moments leaves the derivative of the twist alone",
        Equal(moment.dot(e3), GJ * kappa[2].diff(s)),
        steps=["equilibrium.axial", "variation.moments"],
        source="exsl2",
    )


def claim_residual(state: Equilibrium, book: Notebook) -> None:
    """The residual in fixed axes is the balance of moments in the moving frame."""
    rod = state.balance.couple.line.rod
    R, kappa = rod.frame.R, rod.frame.kappa_of_angles
    force, e = vector("F"), vector("e")
    there = dict(zip([*rod.frame.kappa, *FORCE, *DIRECTION], [*kappa, *(R.T * force), *(R.T * e)], strict=True))
    there |= dict.fromkeys(rod.kappa_u, 0)
    twisting = GJ * (kappa[2] * R * e3).diff(s)
    book.claim(
        "equilibrium.residual",
        "the balance of moments is the residual and the derivative of the twisting moment",
        Equal(
            R * state.balance.moment.subs(there).doit(),
            EI * state.residual(R * e3, force / EI, e).subs(state.moduli) + twisting,
        ),
        steps=["equilibrium.constitutive", "variation.moments", "equilibrium.energy"],
        source="exsl6",
    )


def claim_sphere(state: Equilibrium, book: Notebook) -> None:
    """The residual by a second route: d₃ on the sphere, its two angles varied, no frame."""
    d3, angles = tangent()
    force, e = vector("F"), vector("e")
    residual = state.residual(d3, force, e)
    energy = Rational(1, 2) * d3.diff(s).dot(d3.diff(s)) + state.energy_density.subs(w, d3.dot(e)) - force.dot(d3)
    # An angle moves d₃ by ∂d₃/∂angle, that is it turns d₃ about d₃ × ∂d₃/∂angle.
    axes = [d3.cross(d3.diff(angle)) for angle in angles]
    book.claim(
        "equilibrium.sphere",
        "the Euler-Lagrange equations of d3 on the sphere are the residual about their axes",
        Equal(euler(energy, angles), -Matrix([residual.dot(axis) for axis in axes])),
        steps=["equilibrium.residual", "equilibrium.energy"],
        source="exsl6",
    )
    book.claim(
        "equilibrium.tangential",
        "the residual has no part along d3",
        Equal(residual.dot(d3), Rational(0)),
        steps=["equilibrium.residual", "equilibrium.twist"],
    )


def derive_section2(energy: Energy | None = None, book: Notebook | None = None) -> Equilibrium:
    """All of Section 2, from an energy (paramagnetic particles if none is given) to the equation of equilibrium."""
    book = Notebook() if book is None else book
    return derive(loads.chain(book, energy), book)


def main() -> None:
    """Print all of Section 2, for paramagnetic particles."""
    print_notebook(lambda book: derive_section2(book=book))


if __name__ == "__main__":
    main()
