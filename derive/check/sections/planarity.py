"""Section 3, exslrm1 to exslrm6: what its symbols mean in a cantilever whose field is along the force.

The rod is straight before it is loaded. What is said to vanish does so in equilibrium, without twist, and where all
else holds that the text assumes, M · e = 0 above all. The other relations of a chain hold without that, and are read
so: in any rod, or as far as the text says without twist or in equilibrium.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from sympy import Expr, ImmutableMatrix, Integer, Symbol, solve, sqrt, zeros

from derive.check.meaning import Components, ell
from derive.check.sections.cantilever import first_with, holds, in_equilibrium
from derive.check.sections.framed import HIGHEST, Framed, State
from derive.check.sections.remembered import remembered
from derive.check.sections.variation import MODULI, SIZES
from derive.paper import tree as t
from derive.theory.claims import Domain
from derive.theory.equilibrium import Equilibrium
from derive.theory.letters import e3, eta_tilde
from derive.theory.symbols import s
from derive.theory.variation import DIRECTION

PULL = Symbol("F", positive=True)  # the force, along e, N


def readings(theory: Any, sides: tuple[t.Node, ...], given: tuple[t.Statement, ...]) -> Iterator[Components]:
    """One reading for what vanishes, by what the text assumes, and one for the rest."""
    identities, laws = _all(theory)
    fitting = [statement for statement in given if any(holds(statement, reading) for reading in identities)]
    yield first_with(fitting, identities)
    yield first_with(given, laws)


@remembered
def _all(theory: Any) -> tuple[list[Framed], list[Framed]]:
    state: Equilibrium = theory.section2
    kappa = state.balance.couple.line.rod.frame.kappa
    law = in_equilibrium(state, PULL * DIRECTION, DIRECTION)
    untwisted: dict[Expr, Expr] = {kappa[2].diff(s, order): Integer(0) for order in range(HIGHEST + 1)}
    moment = _values(state)["M"].xreplace(untwisted)
    across = solve([moment.dot(DIRECTION)], [kappa[0]], dict=True)[0]
    return (
        [
            _reading(state, "any straight rod", [], laws=False),
            _reading(state, "no twist", [untwisted], laws=False),
            _reading(state, "in equilibrium, no twist", [law, untwisted], laws=False),
        ],
        [
            _reading(state, "in equilibrium, no twist", [law, untwisted], laws=True),
            _reading(state, "in equilibrium, no twist, no moment along e", [law, untwisted, across], laws=True),
        ],
    )


def _reading(state: Equilibrium, title: str, here: State, *, laws: bool) -> Framed:
    kappa = ImmutableMatrix(state.balance.couple.line.rod.frame.kappa)
    rates = dict(zip(DIRECTION.diff(s), -kappa.cross(DIRECTION), strict=True))
    return Framed(title, Domain(), _values(state), kappa, rates, state=here, units=[DIRECTION], laws=laws)


def _values(state: Equilibrium) -> dict[str, Any]:
    """The values of the printed names in the frame d."""
    balance = state.balance
    line = balance.couple.line
    kappa = line.rod.frame.kappa
    straight = dict.fromkeys(line.rod.kappa_u, 0)
    # kthr6: τ = κ₃ − φ′, with φ the angle from the principal normal to d₁, whose sine is κ₁/k and cosine κ₂/k.
    squared = kappa[0] ** 2 + kappa[1] ** 2
    turning = (kappa[0].diff(s) * kappa[1] - kappa[0] * kappa[1].diff(s)) / squared
    found = {
        "s": s, "ell": ell, "M": balance.resultant.subs(straight), "force": PULL * DIRECTION, "kappa": kappa,
        "kappa_3": kappa[2], "zero": zeros(3, 1), "e": DIRECTION, "eta_tilde": line.moduli[eta_tilde], "d_3": e3,
        "k": sqrt(squared), "tau": kappa[2] - turning, **SIZES,
    }  # fmt: skip
    return {name: value.xreplace(MODULI) for name, value in found.items()}
