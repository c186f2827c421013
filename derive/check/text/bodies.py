"""Claims on the rod as a body: dimensions, units, invariance, conservation, and when its axis is plane.

dimension    of, exponents = {force, length, time, current}
units        length, force, current: the units, each by powers of E, I, A, mu_0
immaterial   reversed = field or force: the equation of equilibrium does not change when it is
conserved    quantity = kappa_1, kappa_2 or kappa_3: equilibrium makes it uniform along a straight rod
planar       field = along the force, across it, or in any direction: rods with a free end are plane curves
sides        sides: on which sides of the straight rod a field and a force, parallel and one at a time, bend it
"""

from __future__ import annotations

from fractions import Fraction
from typing import Any

from sympy import Expr, Symbol, pi

from derive.check.report import RelationVerdict
from derive.check.text.forms import Judge, Variants, decided, exactly, samples
from derive.paper.text_claims import TextClaim
from derive.theory.claims import Domain, Equal
from derive.theory.equilibrium import tangent
from derive.theory.frame import triple
from derive.theory.letters import EI, GJ, SI, current, e1, e2, e3, eta_tilde, length, mass, time, vector
from derive.theory.symbols import alpha, beta, eta, s, theta

ANYWHERE = Domain()
# Exponents of length, force and current of what units are made of.
LETTERS = {"E": (-2, 1, 0), "I": (4, 0, 0), "A": (2, 0, 0), "mu_0": (0, 1, -2)}
BASES = ("length", "force", "current")
FIELDS = ("along the force", "across the force", "in any direction")
SIDES = {"coinciding": 1, "opposite": -1}


def judge_dimension(theory: Any, claim: TextClaim, decide: Judge) -> list[RelationVerdict]:
    """Letters in other units of mass, length, time and current: the factor that comes out is the dimension."""
    line = theory.section2.balance.couple.line
    modulus = {"eta_tilde": line.moduli[eta_tilde]}[claim.data["of"]]
    units = {letter: letter * size for letter, size in {**SI, **line.energy.units}.items()}
    bases = {"force": mass * length / time**2, "length": length, "time": time, "current": current}
    factor: Expr = modulus
    for base, power in claim.data["exponents"].items():
        factor = factor * bases[base] ** power
    title = "in other units it changes by the powers that are claimed"
    return [decided(decide, title, Equal(modulus.subs(units, simultaneous=True), factor), ANYWHERE)]


def vary_dimension(claim: TextClaim) -> Variants:
    """One exponent changed by up to two."""
    exponents = claim.data["exponents"]
    for base, power in exponents.items():
        for other in range(power - 2, power + 3):
            if other != power:
                yield "exponent", claim.but(exponents={**exponents, base: other})


def judge_units(theory: Any, claim: TextClaim, decide: Judge) -> list[RelationVerdict]:
    """Each unit has its dimension; in them bending stiffness and permeability are 1, so that the equations stay."""
    found = []
    for n, base in enumerate(BASES):
        there = tuple(
            sum((Fraction(p) * LETTERS[q][k] for q, p in claim.data[base].items()), Fraction(0)) for k in range(3)
        )
        own = tuple(Fraction(int(k == n)) for k in range(3))
        found.append(
            exactly(f"the unit of {base} is one", there == own, "powers", dict(zip(BASES, there, strict=True)))
        )
    for title, powers, what in (("stiffness", (2, 1, 0), {"E": 1, "I": 1}), ("permeability", (0, 1, -2), {"mu_0": 1})):
        left = {letter: Fraction(what.get(letter, 0)) for letter in LETTERS}
        for base, power in zip(BASES, powers, strict=True):
            for letter, share in claim.data[base].items():
                left[letter] -= power * Fraction(share)
        found.append(exactly(f"the {title} becomes 1", not any(left.values()), "powers", left))
    return found


def vary_units(claim: TextClaim) -> Variants:
    """One power changed by a half; two units exchanged."""
    for base in BASES:
        for letter, power in claim.data[base].items():
            for step in (Fraction(1, 2), Fraction(-1, 2)):
                yield "exponent", claim.but(**{base: {**claim.data[base], letter: str(Fraction(power) + step)}})
    for one, other in ((0, 1), (0, 2), (1, 2)):
        yield (
            "units exchanged",
            claim.but(**{BASES[one]: claim.data[BASES[other]], BASES[other]: claim.data[BASES[one]]}),
        )


def judge_immaterial(theory: Any, claim: TextClaim, decide: Judge) -> list[RelationVerdict]:
    """The left side of the moment equation with the field, or the force, reversed."""
    residual, d3 = theory.section2.residual, tangent()[0]
    force, e = vector("F"), vector("e")
    turned = {"field": (force, -e), "force": (-force, e)}[claim.data["reversed"]]
    relation = Equal(residual(d3, *turned), residual(d3, force, e))
    return [decided(decide, "the equation of moments is the same", relation, ANYWHERE)]


def vary_immaterial(claim: TextClaim) -> Variants:
    """The other one reversed."""
    yield "reversed", claim.but(reversed="force" if claim.data["reversed"] == "field" else "field")


def judge_conserved(theory: Any, claim: TextClaim, decide: Judge) -> list[RelationVerdict]:
    """Along its own axis the balance of moments is the stiffness times the quantity's derivative, and nothing else."""
    balance = theory.section2.balance
    rod = balance.couple.line.rod
    axis, number, stiffness = {
        "kappa_1": (e1, 0, EI),
        "kappa_2": (e2, 1, EI),
        "kappa_3": (e3, 2, GJ),
    }[claim.data["quantity"]]
    moment = balance.moment.subs(dict.fromkeys(rod.kappa_u, 0)).doit()
    relation = Equal(moment.dot(axis), stiffness * rod.frame.kappa[number].diff(s))
    return [decided(decide, f"{claim.data['quantity']}' = 0", relation, ANYWHERE)]


def vary_conserved(claim: TextClaim) -> Variants:
    """The other components of the curvature vector."""
    for other in ("kappa_1", "kappa_2", "kappa_3"):
        if other != claim.data["quantity"]:
            yield "quantity", claim.but(quantity=other)


def judge_planar(theory: Any, claim: TextClaim, decide: Judge) -> list[RelationVerdict]:
    """M·e is uniform, and so 0 from the free end on; then the triple product τk² = d₃ × d₃′·d₃″ is a multiple of it."""
    state = theory.section2
    d3 = tangent()[0]
    slope, e, pull = d3.diff(s), vector("e"), Symbol("F_e", real=True)
    force = {
        "along the force": e,
        "across the force": e.cross(vector("a")),
        "in any direction": vector("f"),
    }[claim.data["field"]]
    residual, moment = state.residual(d3, pull * force, e), triple(d3, slope, e)
    across = pull - state.energy_density.diff(state.alignment).subs(state.alignment, d3.dot(e))
    return [
        decided(decide, "the moment along the field is uniform", Equal(residual.dot(e), moment.diff(s)), ANYWHERE),
        decided(
            decide,
            "torsion times curvature squared is a multiple of it",
            Equal(triple(d3, slope, slope.diff(s)) + residual.dot(slope), -across * moment),
            ANYWHERE,
        ),
    ]


def vary_planar(claim: TextClaim) -> Variants:
    """The field in other directions."""
    for other in FIELDS:
        if other != claim.data["field"]:
            yield "direction", claim.but(field=other)


def judge_sides(theory: Any, claim: TextClaim, decide: Judge) -> list[RelationVerdict]:
    """The couples of a field alone and of a force alone: whether they turn alike, for clamps from 0 to π."""
    couple = theory.plane.angular_acceleration.subs(alpha, 0)
    product = couple.subs(eta, 0) * couple.subs(beta, 0)
    domain = Domain({theta: (0, pi), beta: (0, 1), eta: (0, 1)})
    seen = {int(value > 0) - int(value < 0): point for point, (value,) in samples([product], domain)}
    found = []
    for side, sign in SIDES.items():
        said, there = side in claim.data["sides"], sign in seen
        shown = {"clamp angle": seen.get(sign, {}).get(theta, "none")}
        found.append(exactly(f"{side} sides occur: {said}", said == there, "an example", shown))
    return found


def vary_sides(claim: TextClaim) -> Variants:
    """Only one of the possibilities."""
    yield from (("possibility", claim.but(sides=[side])) for side in claim.data["sides"])
