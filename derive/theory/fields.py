"""Section 2.2, campi to demten: the laws of a particle's material and shape, solved in the particle's own axes.

The third axis lies along the particle. ``particle`` takes its magnetization from here.
"""

from __future__ import annotations

from dataclasses import dataclass

from sympy import Expr, Matrix, diag, eye, solve

from derive.theory.claims import Equal, Notebook
from derive.theory.energy import DIRECTION, H
from derive.theory.letters import N_par, N_perp, chi_par, chi_perp, e3, vector


@dataclass(frozen=True)
class Fields:
    """What the laws give for the applied field H, in the particle's own axes, the third along a.

    material, shape: tensors of susceptibility and demagnetization, 3 × 3. inside, demagnetizing, magnetization: the
    field in the particle, the one that its magnetization makes, and this magnetization, A/m, 3 × 1.
    """

    material: Matrix
    shape: Matrix
    inside: Matrix
    demagnetizing: Matrix
    magnetization: Matrix


def symmetric(along: Expr, across: Expr, a: Matrix) -> Matrix:
    """The tensor with one value along the unit vector a and another across it (suscet, demten), 3 × 3."""
    return along * a * a.T + across * (eye(3) - a * a.T)


def solved() -> Fields:
    """The fields in the particle's own axes, from its laws."""
    material, shape = diag(chi_perp, chi_perp, chi_par), diag(N_perp, N_perp, N_par)
    inside, demagnetizing, m = vector("inside"), vector("demagnetizing"), vector("m")
    # The total field, the material's law and the demagnetizing field: nine linear equations (campi, eqazm, magnetiz).
    equations = [inside - (H + demagnetizing), m - material * inside, demagnetizing + shape * m]
    solution = solve([x for equation in equations for x in equation], [*inside, *demagnetizing, *m], dict=True)[0]
    return Fields(material, shape, *(unknown.subs(solution) for unknown in (inside, demagnetizing, m)))


def claim(found: Fields, m: Matrix, book: Notebook) -> None:
    """The fields and tensors in the particle's axes are those for any direction, with a along the third axis."""
    own = dict(zip(DIRECTION, e3, strict=True))
    m = m.xreplace(own)
    book.claim(
        "particle.axes",
        "along the particle and across it, the magnetization is that of any direction",
        Equal(found.magnetization, m),
        steps=["particle.response"],
        source="elmr11",
    )
    # Along its axis and across it: what is made of the vectors of the axes.
    for name, label, tensor, along, across in (
        ("material", "suscet", found.material, chi_par, chi_perp),
        ("shape", "demten", found.shape, N_par, N_perp),
    ):
        book.claim(
            f"particle.{name}",
            f"the tensor of the {name} has one value along the particle and one across it",
            Equal(tensor, symmetric(along, across, Matrix(e3))),
            steps=["particle.response"],
            source=label,
        )
    book.claim(
        "particle.inside",
        "the field inside is the applied one and the one that the magnetization makes",
        Equal(found.inside, H + found.demagnetizing),
        steps=["particle.axes"],
        source="campi",
    )
    book.claim(
        "particle.demagnetizing",
        "the magnetization makes a field against itself, by the factors of the particle's shape",
        Equal(found.demagnetizing, -symmetric(N_par, N_perp, Matrix(e3)) * m),
        steps=["particle.axes", "particle.shape"],
        source="magnetiz",
    )
