"""Section 2.3, elmr4 and elmr5: how the strain energy of the rod varies when its frame turns.

Vectors are written in the frame d. ``variation`` calls this script, and its claims are among those of ``variation``.
"""

from __future__ import annotations

from sympy import Expr, Matrix, Rational, diag, zeros

from derive.theory.claims import Equal, Notebook
from derive.theory.frame import along
from derive.theory.kinematics import Kinematics
from derive.theory.letters import EI, GJ, e1, e2, e3, vector, vector_of
from derive.theory.symbols import s

STIFFNESS = diag(EI, EI, GJ)  # C in the frame d, for equal principal moments of inertia (kth18)
TURN = vector_of("delta_q")  # δq, the turn of the frame


def vary_elastic(kappa: Matrix, kappa_u: Matrix) -> tuple[Matrix, Matrix, Expr]:
    """δμ, δM and δψ_e when the frame turns by δq."""
    basis = (e1, e2, e3)
    # δd_i = δq × d_i (elmr3); then vary κ = ½ d_i × d_i′, where δ(d_i′) = (δd_i)′.
    moved = [TURN.cross(d) for d in basis]
    both = (delta.cross(along(d, kappa)) + d.cross(along(delta, kappa)) for d, delta in zip(basis, moved, strict=True))
    # Qκ^u turns with the frame: δ(Qκ^u) = δq × Qκ^u.
    delta_mu = Rational(1, 2) * sum(both, zeros(3, 1)) - TURN.cross(kappa_u)
    # M = Cμ, and C = Σ (stiffness) d_i ⊗ d_i turns with the frame too.
    delta_C = sum((STIFFNESS[i, i] * (moved[i] * basis[i].T + basis[i] * moved[i].T) for i in range(3)), zeros(3, 3))
    mu = kappa - kappa_u
    delta_M = delta_C * mu + STIFFNESS * delta_mu
    delta_psi = Rational(1, 2) * (delta_M.dot(mu) + (STIFFNESS * mu).dot(delta_mu))
    return delta_mu.expand(), delta_M.expand(), delta_psi.expand()


def claim(rod: Kinematics, strain_energy: Expr, varied: tuple[Matrix, Matrix, Expr], book: Notebook) -> None:
    """Variations of the measure of deformation, of the moment and of the strain energy."""
    delta_mu, delta_M, delta_psi = varied
    M = STIFFNESS * rod.mu
    turning = along(TURN, rod.frame.kappa)
    strains = vector("mu")
    energy = strain_energy.subs(dict(zip(rod.frame.kappa, strains + rod.kappa_u, strict=True)))
    book.claim(
        "variation.strain_energy",
        "the slope of the strain energy in the measure of deformation is the moment",
        Equal(Matrix([energy.expand()]).jacobian(strains).T, STIFFNESS * strains),
        source="kth19",
    )
    book.claim(
        "variation.measure",
        "the measure of deformation changes by the slope of the turn, and turns",
        Equal(delta_mu, turning + TURN.cross(rod.mu)),
        steps=["frame.formula"],
        source="elmr4",
    )
    book.claim(
        "variation.moment",
        "the moment changes by the stiffness times the slope of the turn, and turns",
        Equal(delta_M, STIFFNESS * turning + TURN.cross(M)),
        steps=["variation.measure"],
        source="elmr4",
    )
    book.claim(
        "variation.elastic",
        "the strain energy changes by the work of the moment, integrated by parts",
        Equal(delta_psi, M.dot(TURN).diff(s) - along(M, rod.frame.kappa).dot(TURN)),
        steps=["variation.strain_energy", "variation.moment"],
        source="elmr5",
    )
