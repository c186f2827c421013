"""Section 3, exsl1 to exsl7: what its symbols mean in a straight cantilever under a force at its free end.

The rod is prismatic and untwisted before it is loaded, so κ^u = 0, and in equilibrium: κ′ is what the theory's balance
of moments makes it, for any force of the direction of y and any direction of the field. At the clamp the axis is at the
origin; at the free end κ is such that the moment vanishes, as nothing else does work when that end turns. Three
readings, from the general to the special; a statement is read in the first in which what the text assumes holds.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from sympy import Expr, Function, ImmutableMatrix, Integer, Matrix, MatrixBase, Symbol, cancel, oo, solve, sqrt, zeros

from derive.check.meaning import Components, MeaningError, ell
from derive.check.sections.framed import HIGHEST, Framed, State
from derive.check.sections.remembered import remembered
from derive.check.sections.turning import rotation
from derive.check.sections.variation import MODULI, SIZES, balanced
from derive.paper import tree as t
from derive.theory import plane
from derive.theory.claims import Domain
from derive.theory.constraint import FORCE
from derive.theory.elastic import STIFFNESS
from derive.theory.equilibrium import Equilibrium
from derive.theory.letters import EI, chi, e1, e2, e3, eta_tilde, field
from derive.theory.symbols import beta, eta, s
from derive.theory.variation import DIRECTION

TURN = rotation("g")
AXES = TURN.matrix  # the fixed axes x, y, z, in the frame d
PLACE = ImmutableMatrix([Function(name, real=True)(s) for name in ("x", "y", "z")])  # a point of the axis, by them
P, Q = (Symbol(f"e_{name}", real=True) for name in "xz")  # of the direction of the field: two ratios
FIELD = ImmutableMatrix([2 * P, 1 - P**2 - Q**2, 2 * Q]) / (1 + P**2 + Q**2)  # a unit vector, by the fixed axes


def readings(theory: Any, sides: tuple[t.Node, ...], given: tuple[t.Statement, ...]) -> Iterator[Components]:
    """The most general reading in which what the text assumes holds, for both senses of the field."""
    for sense in _all(theory):
        yield first_with(given, sense)


def first_with(given: Sequence[t.Statement], candidates: Sequence[Framed]) -> Framed:
    """The first reading in which equalities hold identically; MeaningError if there is none."""
    for reading in candidates:
        if all(holds(statement, reading) for statement in given):
            return reading
    raise MeaningError("what the text assumes holds in no reading of this section")


def holds(statement: t.Statement, reading: Framed) -> bool:
    """Do the sides of an equality have one value?"""
    if set(statement.operators) != {"="}:
        raise MeaningError("only equalities can be assumed in this section")
    values = [reading.of(side) for side in statement.sides]
    return all(cancel(part) == 0 for value in values[1:] for part in _parts(values[0] - value))


def _parts(value: Any) -> list[Expr]:
    return list(value) if isinstance(value, MatrixBase) else [value]


@remembered
def _all(theory: Any) -> list[list[Framed]]:
    state: Equilibrium = theory.section2
    kappa = state.balance.couple.line.rod.frame.kappa
    law = in_equilibrium(state, EI * beta * (AXES * e2), AXES * FIELD)
    untwisted = {kappa[2]: Integer(0)}
    # The rod bends about x, which is d₁; its frame is turned about x alone.
    flat = untwisted | {kappa[1]: Integer(0), P: Integer(0), **dict.fromkeys(TURN.parameters[1:], Integer(0))}
    kinds: dict[str, State] = {"": [law], ", no twist": [law, untwisted], ", in the plane": [law, flat]}
    return [
        [_reading(theory, f"cantilever{title}, field {said} e", sense, kind) for title, kind in kinds.items()]
        for said, sense in (("along", 1), ("against", -1))
    ]


def in_equilibrium(state: Equilibrium, force: Matrix, e: Matrix) -> dict[Expr, Expr]:
    """The derivatives of κ of a straight rod in equilibrium under a force and a direction of the field."""
    balance = state.balance
    rod = balance.couple.line.rod
    put: dict[Expr, Expr] = dict(zip([*FORCE, *DIRECTION], [*force.xreplace(MODULI), *e], strict=True))
    for component in rod.kappa_u:
        put |= {component: Integer(0)} | {component.diff(s, n): Integer(0) for n in range(1, HIGHEST + 1)}
    return {slope: rate.xreplace(put) for slope, rate in balanced(balance, {}).items() if slope.expr in rod.frame.kappa}


def _reading(theory: Any, title: str, sense: int, state: State) -> Framed:
    kappa = ImmutableMatrix(theory.section2.balance.couple.line.rod.frame.kappa)
    rates = {**TURN.rates(-kappa), **dict(zip(PLACE.diff(s), AXES.T * e3, strict=True))}
    domain = Domain(dict.fromkeys((beta, chi, field, *SIZES.values()), (0, oo)))
    values = _values(theory, sense)
    free = solve(values["M"], list(kappa), dict=True)[0]  # no moment
    at_ends = {Integer(0): dict.fromkeys(PLACE, Integer(0)), ell: free}
    units = [AXES * unit for unit in (FIELD, e2)]
    return Framed(title, domain, values, kappa, rates, state=state, units=units, at_ends=at_ends)


def _values(theory: Any, sense: int) -> dict[str, Any]:
    """The values of the printed names in the frame d; the field is along e, or against it."""
    state: Equilibrium = theory.section2
    balance = state.balance
    line = balance.couple.line
    kappa = line.rod.frame.kappa
    straight = dict.fromkeys(line.rod.kappa_u, 0)
    e, h = AXES * FIELD, sense * field * (AXES * FIELD)
    values = {
        "x": AXES * PLACE, "y": PLACE[1], "z": PLACE[2], "s": s, "ell": ell, "zero": zeros(3, 1), "d_3": e3,
        **{f"e_{name}": AXES * axis for name, axis in zip("xyz", (e1, e2, e3), strict=True)},
        "kappa": kappa, "kappa_u": zeros(3, 1), "kappa_3": kappa[2], "k": sqrt(kappa[0] ** 2 + kappa[1] ** 2),
        "mu": line.rod.mu.subs(straight), "C": STIFFNESS, "M": balance.resultant.subs(straight),
        "force": EI * beta * (AXES * e2), "F": EI * beta, "e": e, "h_a": h, "chi": chi, "beta": beta,
        "eta_tilde": line.moduli[eta_tilde], "eta": state.moduli[eta], **SIZES,
    }  # fmt: skip
    values = {name: value.xreplace(MODULI) for name, value in values.items()}
    return values | _barred(theory.plane.barred, values)


def _barred(barred: Mapping[Symbol, Expr], values: Mapping[str, Any]) -> dict[str, Any]:
    """The dimensionless variables: each quantity over the unit that the theory gives to one of its kind."""
    kinds = {
        "s": plane.s, "y": plane.s, "z": plane.s, "k": plane.k, "F": plane.F, "beta": beta, "eta": eta,
        "h_a": plane.h_a,
    }  # fmt: skip
    return {f"{name}_bar": values[name] * (barred[kind] / kind) for name, kind in kinds.items()}
