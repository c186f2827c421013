"""Letters of a motion between two turning points, and the writer of its formulas.

Seen from the tip the rod moves from rest at φ = θ(ℓ) to the far turning point φ₂ = φ + 2D and back. A motion that
falls is the mirror image of one that rises: θ → −θ and α → −α. M = φ + D is the middle. All formulas hold for any angle
of the field; a load case is what is left when a parameter is put in.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass, field

from sympy import Expr, Integer, Symbol, cos, oo, pi, sin

from .claims import Domain, Formula, Notebook, Relation
from .symbols import beta, eta, theta

CASE = "oblique"
field_angle = Symbol("field_angle", real=True)  # α, from y to the field
tip = Symbol("tip", real=True)  # φ = θ(ℓ)
rest = Symbol("rest", real=True)  # a direction of equilibrium, θ″ = 0
offset = Symbol("offset", real=True)  # θ less such a direction
middle = Symbol("middle", real=True)  # M, halfway between two angles
half = Symbol("half", real=True)  # half the distance of any two angles
half_width = Symbol("half_width", real=True)  # D, half the distance of the turning points
moment_there = Symbol("moment_there", real=True)  # θ″ at a turning point, towards the other one
near, far = Symbol("near", real=True), Symbol("far", real=True)  # P and P′: Q at the tip and at the far turning point
root_near, root_far = Symbol("root_near", real=True), Symbol("root_far", real=True)  # √P and √P′
product = Symbol("product", real=True)  # √(PP′)
lean = Symbol("skew", real=True)  # (P′ − P)/(2 sin D)
uneven = Symbol("uneven", real=True)  # √P′ − √P
sine, cosine = Symbol("sine", real=True), Symbol("cosine", real=True)  # of an angle, in most places of D
half_sine, half_cosine = Symbol("half_sine", real=True), Symbol("half_cosine", real=True)  # of half of it
double_sine, double_cosine = Symbol("double_sine", real=True), Symbol("double_cosine", real=True)  # of 2(θ − α)
done_sine, left_sine = Symbol("done_sine", real=True), Symbol("left_sine", real=True)  # sin(δ/2), sin(D − δ/2)
excess = Symbol("excess", real=True)  # R
mean = Symbol("mean", real=True)  # a₀, the mean of Q over all θ
above = Symbol("above", real=True)  # a₀ − η
done, left = Symbol("done", real=True), Symbol("left", real=True)  # δ = θ − φ, and 2D − δ
drop = Symbol("drop", real=True)  # V(φ) − V(θ)

ANGLES = (-pi, pi)
PARAMETERS: dict[Symbol, tuple[Expr, Expr]] = {beta: (Integer(0), oo), eta: (Integer(0), oo), field_angle: ANGLES}
# M and D are free: that V is the same at both turning points is said in the claims.
PAIR = Domain({**PARAMETERS, middle: ANGLES, half_width: (0, pi)})


def anywhere(*angles: Symbol) -> Domain:
    """Any force, field and direction of the field, and any value of the angles."""
    return Domain({**PARAMETERS, **dict.fromkeys(angles, ANGLES)})


@dataclass
class Writer:
    """Collects the formulas of the motion, each with the claim that stands for it.

    formulas: those that solvers evaluate. steps: those that others rest on.
    """

    book: Notebook
    formulas: list[Formula] = field(default_factory=list)
    steps: list[Formula] = field(default_factory=list)

    def claim(
        self,
        key: str,
        title: str,
        relation: Relation,
        domain: Domain,
        *,
        given: Iterable[tuple[Expr, Expr]] = (),
        steps: Iterable[str],
        source: str = "",
    ) -> str:
        """Assert a relation; a step without a dot is the key of another claim of the motion."""
        name = f"swing.{key}"
        rests = tuple(step if "." in step else f"swing.{step}" for step in steps)
        self.book.claim(name, title, relation, domain=domain, given=given, steps=rests, source=source)
        return name

    def add(
        self,
        name: str,
        arguments: tuple[Symbol, ...],
        expression: Expr,
        doc: str,
        property: Callable[[Expr], Relation],
        domain: Domain,
        *,
        given: Iterable[tuple[Expr, Expr]] = (),
        steps: Iterable[str],
        source: str = "",
        emitted: bool = True,
    ) -> Expr:
        """Record a formula and claim the property that defines it; the expression is given back."""
        strange = expression.free_symbols - set(arguments)
        if strange:
            raise ValueError(f"{CASE}: the formula {name} holds {strange}, which are not among its arguments")
        claim = self.claim(name, doc, property(expression), domain, given=given, steps=steps, source=source)
        kept = self.formulas if emitted else self.steps
        kept.append(Formula(name, arguments, expression, claim, doc, CASE, source))
        return self.book.show(f"{name}({', '.join(a.name for a in arguments)})", expression)


def halves(angle: Expr, at: tuple[Symbol, Symbol] = (half_sine, half_cosine)) -> dict[Symbol, Expr]:
    """What the names of the sine and the cosine of half an angle stand for."""
    return {at[0]: sin(angle / 2), at[1]: cos(angle / 2)}


def turned(value: Expr, angle: Expr) -> Expr:
    """A value in θ at another angle."""
    return value.subs(theta, angle)
