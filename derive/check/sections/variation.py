"""Section 2.3, elmr1 to elmr10: what its symbols mean while the rod varies, and in equilibrium.

Three readings. As the rod is: inextensible, its frame and the undistorted one turned by any rotation. With the
constraint not yet met: where functionals are compared, the axis moves freely and the multiplier holds it. In
equilibrium: what is said to vanish does so where the theory's balances of moments and forces hold, and where the
variation of a functional is said to vanish, the ends are held. There the axis is inextensible, too.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

from sympy import Expr, ImmutableMatrix, Matrix, Symbol, eye, solve, zeros

from derive.check.meaning import Components, ell
from derive.check.sections.framed import State, derivatives
from derive.check.sections.functionals import OnRod
from derive.check.sections.remembered import remembered
from derive.check.sections.turning import Rates, Rotation, rotation
from derive.paper import tree as t
from derive.theory import constraint
from derive.theory.claims import Domain
from derive.theory.constraint import FORCE, POSITION
from derive.theory.elastic import STIFFNESS, TURN
from derive.theory.frame import along
from derive.theory.letters import EI, GJ, A, V, chi, chi_tilde, e1, e2, e3, eta_tilde, field, mu0, nu, vector_of, w
from derive.theory.symbols import s
from derive.theory.variation import DIRECTION, SHIFT, Balance

E, G, inertia, torsion = (Symbol(name, positive=True) for name in ("E", "G", "I", "J"))
MODULI = {EI: E * inertia, GJ: G * torsion}  # the theory's stiffnesses by the printed letters
SIZES = {"E": E, "G": G, "I_area": inertia, "J_torsion": torsion, "A": A, "mu_0": mu0, "nu": nu, "V_Pi": V}
OTHER = rotation("g")  # from d to the frame of the undistorted rod
BEFORE = vector_of("x_u")  # a point of the undistorted axis
TURNED = vector_of("q")  # q, whose variation is δq
FUNCTIONALS = {"L_constraint", "E_energy"}


def readings(theory: Any, sides: tuple[t.Node, ...], given: tuple[t.Statement, ...]) -> Iterator[Components]:
    """The readings of a statement: of functionals, or of a rod as it is; each also in equilibrium."""
    rod, functional, equilibrium, stationary = _all(theory)
    yield from (functional, stationary) if _of_functionals(sides) else (rod, equilibrium)


def _of_functionals(sides: tuple[t.Node, ...]) -> bool:
    nodes = [node for side in sides for node in side.walk()]
    return any(
        isinstance(node, t.Integral | t.Between) or (isinstance(node, t.Name) and node.name in FUNCTIONALS)
        for node in nodes
    )


@remembered
def _all(theory: Any) -> tuple[OnRod, OnRod, OnRod, OnRod]:
    balance: Balance = theory.section2.balance
    kappa = balance.couple.line.rod.frame.kappa
    slope = dict(zip(POSITION, e3 - kappa.cross(POSITION), strict=True))
    equilibrium = [balanced(balance, slope)]
    return (
        _reading(balance, "inextensible rod", [derivatives(slope, {})], laws=False),
        _reading(balance, "all fields on the rod", [], laws=False),
        _reading(balance, "in equilibrium", equilibrium, laws=True),
        _reading(balance, "in equilibrium, ends held", equilibrium, laws=True, held=True),
    )


def _reading(balance: Balance, title: str, state: State, *, laws: bool, held: bool = False) -> OnRod:
    rod = balance.couple.line.rod
    rates, variations = _changes(rod.frame.kappa, rod.kappa_u, OTHER)
    return OnRod(
        title,
        Domain(),
        values(balance, OTHER),
        ImmutableMatrix(rod.frame.kappa),
        rates,
        variations,
        TURN,
        state,
        units=[DIRECTION],
        turns=list(OTHER.parameters),
        laws=laws,
        held=held,
    )


def _changes(kappa: Matrix, kappa_u: Matrix, other: Rotation) -> tuple[Rates, dict[Expr, Expr]]:
    """The rates and the variations of components: what is fixed turns back where the frame turns."""
    slope = other.matrix * e3 - kappa.cross(BEFORE)
    fixed = dict(zip([*BEFORE.diff(s), *DIRECTION.diff(s)], [*slope, *-kappa.cross(DIRECTION)], strict=True))
    # δκ = δq′ + δq × κ, so that its components change by those of δq′.
    changes = {
        kappa: along(TURN, kappa), POSITION: SHIFT - TURN.cross(POSITION), TURNED: TURN - TURN.cross(TURNED),
                **{vector: -TURN.cross(vector) for vector in (DIRECTION, FORCE, BEFORE)},
    }  # fmt: skip
    varied = {x: change for vector, by in changes.items() for x, change in zip(vector, by, strict=True)}
    return {**other.rates(other.matrix * kappa_u - kappa), **fixed}, {**varied, **other.turned(-TURN)}


def values(balance: Balance, other: Rotation) -> Mapping[str, Any]:
    """The values of the printed names, in the frame d."""
    line = balance.couple.line
    frame, mu = line.rod.frame, line.rod.mu
    psi_m = line.psi_m.subs(w, DIRECTION.dot(e3))
    couple = balance.couple.modulus.subs(w, DIRECTION.dot(e3)) * e3.cross(DIRECTION)
    found = {
        **{f"d_{i + 1}": e for i, e in enumerate((e1, e2, e3))},
        **{f"d_u_{i + 1}": other.matrix * e for i, e in enumerate((e1, e2, e3))},
        **{f"kappa_{i + 1}": frame.kappa[i] for i in range(3)},
        "Q": other.matrix.T, "identity": ImmutableMatrix(eye(3)), "kappa": frame.kappa,
        "kappa_u": other.matrix * line.rod.kappa_u, "mu": mu, "C": STIFFNESS, "M": balance.resultant,
        "x": POSITION, "x_u": BEFORE, "u_axis": POSITION - BEFORE, "q": TURNED, "Phi": FORCE, "force": FORCE,
        "psi_e": balance.strain_energy, "psi_m": psi_m, "E_energy": balance.strain_energy + psi_m,
        "L_constraint": constraint.density(frame.kappa), "eta_tilde": line.moduli[eta_tilde],
        "m_line": couple, "l_line": couple, "f_line": zeros(3, 1), "zero": zeros(3, 1),
        "e": DIRECTION, "h_a": field * DIRECTION, "chi": chi, "chi_tilde": chi_tilde, "s": s, "ell": ell, **SIZES,
    }  # fmt: skip
    return {name: value.xreplace(MODULI) for name, value in found.items()}


def balanced(balance: Balance, slope: Mapping[Expr, Expr]) -> dict[Expr, Expr]:
    """The derivatives of the components of κ, Φ and the axis in equilibrium, by the theory's equations."""
    kappa = balance.couple.line.rod.frame.kappa
    unknowns = [*kappa, *FORCE]
    slopes = [function.diff(s) for function in unknowns]
    solved = solve([*balance.moment, *balance.force], slopes, dict=True)[0]
    law = {function: solved[rate].xreplace(MODULI) for function, rate in zip(unknowns, slopes, strict=True)}
    return derivatives({**law, **slope}, dict(zip(DIRECTION.diff(s), -kappa.cross(DIRECTION), strict=True)))
