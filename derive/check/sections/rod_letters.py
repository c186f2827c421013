"""What the letters of Section 2.1 stand for in the reading of any rod (``rod.Rod``), from the theory."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from sympy import Expr, Function, Matrix, Symbol, eye, zeros

from derive.check.sections.moving import Turned
from derive.check.sections.turning import rotation
from derive.theory import frame, loads, placement
from derive.theory.constraint import FORCE
from derive.theory.elastic import STIFFNESS
from derive.theory.letters import EI, GJ, X1, X2, e1, e2, e3, eps, vector_of
from derive.theory.symbols import s

BASIS = (e1, e2, e3)
TURN = rotation("r")  # of the undistorted frame from the other
E, G, I_AREA, J_TORSION = (Symbol(name, positive=True) for name in ("E", "G", "I", "J"))
MADE_OF = {EI: E * I_AREA, GJ: G * J_TORSION}
PHI = Function("phi", real=True)(s)


def solved(equations: Matrix, unknowns: Matrix) -> Matrix:
    """The unknowns of equations that are zero and linear in them."""
    coefficients = equations.jacobian(unknowns)
    return unknowns - coefficients.inv() * equations


def strain_energy(reading: Any, strain: Matrix) -> Expr:
    """ψ_e of a strain, which is κ less what it is before the deformation."""
    there = dict(zip(reading.kappa, strain + reading.rod.kappa_u, strict=True))
    return reading.balance.strain_energy.subs(there, simultaneous=True).subs(MADE_OF)


def couple_of(reading: Any) -> Matrix:
    """The couple per unit length under which the rod is in equilibrium."""
    return solved(reading.loaded.moment, loads.COUPLES).subs(MADE_OF)


VALUES: dict[str, Callable[[Any], Any]] = {
    "kappa": lambda r: r.kappa,
    "kappa_u": lambda r: r.from_u(r.rod.kappa_u),
    "x": lambda r: vector_of("x"),
    "x_u": lambda r: vector_of("x_u"),
    "x_hat": lambda r: vector_of("x") + placement.DEFORMED,
    "x_hat_u": lambda r: vector_of("x_u") + r.turned * placement.POINT,
    "u_bar": lambda r: placement.DISPLACEMENT,
    "k": lambda r: frame.axis(r.kappa).curvature,
    "binormal": lambda r: frame.axis(r.kappa).binormal,
    "tau": lambda r: frame.axis(r.kappa).torsion,
    "phi": lambda r: PHI,
    "epsilon": lambda r: eps,
    "h": lambda r: placement.thickness(r.rod.kappa_u, r.kappa, placement.LENGTH),
    "ell": lambda r: placement.LENGTH,
    "s": lambda r: s,
    "F_tensor": lambda r: Turned.product(r.turned, r.rod.tangents, r.rod.dual_u),
    "Q": lambda r: r.from_u(eye(3)),
    "mu": lambda r: r.rod.mu,
    "force": lambda r: FORCE,
    "f_line": lambda r: loads.FORCES,
    "m_line": couple_of,
    "M": lambda r: r.balance.resultant.subs(MADE_OF),
    "C": lambda r: STIFFNESS.subs(MADE_OF),
    "E": lambda r: E,
    "G": lambda r: G,
    "I_area": lambda r: I_AREA,
    "J_torsion": lambda r: J_TORSION,
    "psi_e": lambda r: r.balance.strain_energy.subs(MADE_OF),
    "identity": lambda r: eye(3),
    "zero": lambda r: zeros(3, 1),
}
FAMILIES: dict[str, Callable[[Any, int], Any]] = {
    "d": lambda r, i: BASIS[i - 1],
    "d_u": lambda r, i: r.from_u(BASIS[i - 1]),
    "kappa_c": lambda r, i: r.kappa[i - 1],
    "kappa_u_c": lambda r, i: r.rod.kappa_u[i - 1],
    "g": lambda r, i: r.from_u(r.rod.tangents_u[:, i - 1]),
    "g_dual": lambda r, i: r.from_u(r.rod.dual_u[:, i - 1]),
    "X": lambda r, i: eps * (X1, X2)[i - 1],
}
