"""Section 2.3, elmr3, elmr8 and elmr11 to elmr15: the magnetic couple on a rod per unit length, by two routes.

One varies the energy per unit length; the other integrates magnetization × induction over the cross section. They share
the energy and the deformation, no step. Run ``python -m derive.theory.couple`` to print this part.
"""

from __future__ import annotations

from dataclasses import dataclass

from sympy import Expr, Matrix, Rational, Symbol

from derive.theory import line_energy
from derive.theory.claims import Equal, Notebook, Order, print_notebook
from derive.theory.energy import Energy
from derive.theory.letters import A, angle, e1, e2, e3, eps, field, first_order, gradient, rotation, unit, vector, w
from derive.theory.line_energy import FIELD, LineEnergy, over_section, over_triangle
from derive.theory.placement import POINT

TANGENT = vector("d_3")  # d₃ where it is varied, in the frame d before the variation


@dataclass(frozen=True)
class Couple:
    """The magnetic couple per unit length, N.

    by_variation, by_induction: the two routes, for FIELD, in the frame d, 3 × 1. modulus: the couple is
    modulus · d₃ × e, by the alignment w = d₃·e.
    """

    line: LineEnergy
    by_variation: Matrix
    by_induction: Matrix
    modulus: Expr


def by_variation(line: LineEnergy, h: Matrix, d3: Matrix) -> Matrix:
    """l with δψ_m = −l·δq when the rod is turned by δq: δd₃ = δq × d₃, hence l = −d₃ × ∂ψ_m/∂d₃ (elmr8)."""
    slope = gradient(A * line.energy.density(h, TANGENT), TANGENT)
    return -d3.cross(slope.xreplace(dict(zip(TANGENT, d3, strict=True))))


def by_rotation(line: LineEnergy, h: Matrix, d3: Matrix) -> Matrix:
    """The same by turning d₃ about each axis through a finite angle: minus the slope of the energy at the start."""
    turn = Symbol("turn", real=True)
    energies = [A * line.energy.density(h, rotation(axis, turn) * d3) for axis in (e1, e2, e3)]
    return Matrix([-energy.diff(turn).subs(turn, 0) for energy in energies])


def derive(line: LineEnergy, book: Notebook) -> Couple:
    """The couple by both routes, with their claims."""
    varied = by_variation(line, FIELD, e3)
    # Magnetization × induction: (M) × (μ₀ h) = (μ₀ M) × h per unit volume, and J dX₁ dX₂ ds of volume (elmr12, elmr14).
    exact = line.energy.moment(FIELD, line.rod.fibre).cross(FIELD) * line.rod.jacobian
    small = first_order(exact).expand()
    induced = small.applyfunc(over_section).expand()
    couple = Couple(line, varied, induced, -line.psi_m.diff(w))
    book.say("The magnetic couple per unit length: by turning the rod, and by magnetization × induction.")
    book.show("l, for a field in the frame of the rod", varied)
    book.show("l / (d_3 x e)", couple.modulus)
    claim_induction(line, exact, small, book)
    claim_couple(couple, book)
    return couple


def claim_induction(line: LineEnergy, exact: Matrix, small: Matrix, book: Notebook) -> None:
    """The couple per unit volume, to first order."""
    # Chain rule: the couple changes with the direction of the particles, the volume with the curvature.
    turn, turn_u = line.rod.frame.kappa.cross(POINT), line.rod.kappa_u.cross(POINT)
    a = vector("a")
    couple = line.energy.moment(FIELD, a).cross(FIELD)
    change = couple.jacobian(a) * (turn - e3 * e3.dot(turn))
    expected = couple * (1 + e3.dot(turn_u)) + change
    book.claim(
        "couple.turning",
        "magnetization x induction does the work that the energy gives up when the particle turns",
        Equal(couple, -a.cross(line.energy.slope(FIELD, a))),
        steps=["energy.invariance"],
        source="elmr12",
    )
    book.claim(
        "couple.expansion",
        "to first order the couple on a volume changes with the turn of the particles and with the volume",
        Equal(small, expected.xreplace(dict(zip(a, e3, strict=True)))),
        steps=["energy.invariance", "kinematics.orientation", "kinematics.jacobian"],
        source="elmr13",
    )
    book.claim(
        "couple.remainder",
        "what the first order leaves out is of second order",
        Order(exact - small, eps, 2),
        steps=["couple.expansion"],
        source="elmr13",
    )
    book.claim(
        "couple.section",
        "over a section the first order of the couple has no part: a triangle, integrated, agrees",
        Equal(small.applyfunc(over_triangle), small.applyfunc(over_section).subs(A, Rational(9, 2))),
        steps=["couple.expansion"],
        source="elmr14",
    )


def claim_couple(couple: Couple, book: Notebook) -> None:
    """The routes agree; the couple is along d₃ × e."""
    line = couple.line
    book.claim(
        "couple.variation",
        "the variation of the energy is its slope under rotations of the rod",
        Equal(couple.by_variation, by_rotation(line, FIELD, e3)),
        steps=["line_energy.axis"],
        source="elmr8",
    )
    book.claim(
        "couple.induction",
        "the couple of the energy is the couple of the induction on the magnetization",
        Equal(couple.by_variation, couple.by_induction),
        steps=["couple.variation", "couple.turning", "couple.section"],
        source="elmr15",
    )
    d, e = unit(angle("p"), angle("q")), unit(angle("r"), angle("t"))
    book.claim(
        "couple.alignment",
        "the couple is along d3 x e, and minus the slope of the energy in the alignment is its modulus",
        Equal(by_variation(line, field * e, d), couple.modulus.subs(w, e.dot(d)) * d.cross(e)),
        steps=["couple.variation", "line_energy.alignment"],
        source="elmr8",
    )


def chain(book: Notebook, energy: Energy | None = None) -> Couple:
    """The derivation up to here, from an energy (paramagnetic particles if none is given)."""
    return derive(line_energy.chain(book, energy), book)


def main() -> None:
    """Print the derivation so far, for paramagnetic particles."""
    print_notebook(chain)


if __name__ == "__main__":
    main()
