"""Section 2.1, kth16 to kth18: the constitutive law, and the balance of a rod under any loads per unit length.

The equations come from the work of the loads when the frame turns and the axis moves, and once more from the balance
of a part of the rod as a rigid body. Run ``python -m derive.theory.loads`` to print this part.
"""

from __future__ import annotations

from dataclasses import dataclass

from sympy import Matrix

from derive.theory import variation
from derive.theory.claims import Equal, Notebook, print_notebook
from derive.theory.constraint import FORCE
from derive.theory.elastic import STIFFNESS, TURN, vary_elastic
from derive.theory.energy import Energy
from derive.theory.frame import along
from derive.theory.kinematics import Kinematics
from derive.theory.letters import EI, GJ, angle, e1, e2, e3, rotation, vector_of, w
from derive.theory.symbols import s
from derive.theory.variation import DIRECTION, SHIFT, Balance, euler

FORCES, COUPLES = vector_of("f"), vector_of("m")  # f and m, applied per unit length, N/m and N, in the frame d
PLACE = vector_of("x")  # x, a point of the axis from a fixed point, m, in the frame d


@dataclass(frozen=True)
class Loaded:
    """Left sides of the balance of forces, N/m, and of moments, N, under FORCES and COUPLES, in the frame d."""

    force: Matrix
    moment: Matrix


def loaded(rod: Kinematics) -> Loaded:
    """What multiplies δu and δq when the strain energy less the work of the loads varies under the constraint."""
    kappa = rod.frame.kappa
    elastic = vary_elastic(kappa, rod.kappa_u)[2]
    constraint = FORCE.dot(along(SHIFT, kappa) - TURN.cross(e3))
    varied = elastic + constraint - FORCES.dot(SHIFT) - COUPLES.dot(TURN)
    return Loaded(-euler(varied, SHIFT).expand(), -euler(varied, TURN).expand())


def derive(balance: Balance, book: Notebook) -> Loaded:
    """The balance under loads and the constitutive law, with their claims."""
    found = loaded(balance.couple.line.rod)
    book.say("The same with any force and couple per unit length in the place of the magnetic couple.")
    book.show("balance of forces", found.force)
    book.show("balance of moments", found.moment)
    claim_law(balance, book)
    claim_loaded(found, balance, book)
    return found


def claim_law(balance: Balance, book: Notebook) -> None:
    """The stiffness is that of a rod which bends alike in all directions."""
    turn = rotation(e3, angle("r"))
    book.claim(
        "loads.isotropy",
        "the rod bends alike about all directions across it",
        Equal(turn * STIFFNESS * turn.T, EI * (e1 * e1.T + e2 * e2.T) + GJ * e3 * e3.T),
        steps=["variation.strain_energy"],
        source="kth18",
    )
    mu = balance.couple.line.rod.mu
    book.claim(
        "loads.law",
        "bending moments are in proportion to the bending, the twisting moment to the twist",
        Equal(balance.resultant, EI * (e3.cross(mu)).cross(e3) + GJ * mu.dot(e3) * e3),
        steps=["variation.strain_energy", "loads.isotropy"],
        source="kth17",
    )


def claim_loaded(found: Loaded, balance: Balance, book: Notebook) -> None:
    """The equations by the balance of a part of the rod, and those of the magnetic couple among them."""
    kappa, M = balance.couple.line.rod.frame.kappa, balance.resultant
    book.claim(
        "loads.force",
        "the forces on a part of the rod, at its ends and along it, are in balance",
        Equal(found.force, along(FORCE, kappa) + FORCES),
        steps=["variation.constraint"],
        source="kth16",
    )
    # About a fixed point, where x′ = d₃: the couples, and the moments of the forces.
    arm = {x.diff(s): rate for x, rate in zip(PLACE, e3 - kappa.cross(PLACE), strict=True)}
    about = along(M + PLACE.cross(FORCE), kappa).subs(arm) + PLACE.cross(FORCES) + COUPLES
    book.claim(
        "loads.moment",
        "the moments on a part of the rod about a fixed point are in balance",
        Equal(found.moment + PLACE.cross(found.force), about),
        steps=["loads.force", "variation.elastic", "placement.axis"],
        source="kth16",
    )
    torque = balance.couple.modulus.subs(w, DIRECTION.dot(e3)) * e3.cross(DIRECTION)
    magnetic = {**dict.fromkeys(FORCES, 0), **dict(zip(COUPLES, torque, strict=True))}
    book.claim(
        "loads.magnetic",
        "with the magnetic couple and no force along the rod they are the equations of the magnetic rod",
        Equal(Matrix.vstack(found.force, found.moment).subs(magnetic), Matrix.vstack(balance.force, balance.moment)),
        steps=["loads.moment", "variation.moments", "variation.forces"],
        source="elmr10",
    )


def chain(book: Notebook, energy: Energy | None = None) -> Balance:
    """The derivation up to here, from an energy (paramagnetic particles if none is given)."""
    balance = variation.chain(book, energy)
    derive(balance, book)
    return balance


def main() -> None:
    """Print the derivation so far, for paramagnetic particles."""
    print_notebook(chain)


if __name__ == "__main__":
    main()
