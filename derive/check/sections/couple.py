"""Section 2.3, elmr12 to elmr15: what its symbols mean in the couple of the induction on the magnetization.

Three readings. In any particle the orientation a is any vector. In the rod, where orders of magnitude are compared or
the couple is integrated, a is the theory's orientation of the fibres, exact in ε, and the couple on the part from 0 to
s is represented by its density along the rod (see ``functionals``). To first order, the couple per unit length is what
is left of that density when ε tends to 0.

The integral over a section of area A whose first moments vanish is A times the integrand without its part of first
order: two integrands have one integral on all such sections if and only if they differ by a linear form in X₁, X₂.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import count
from typing import Any

from sympy import ImmutableMatrix, Matrix, Symbol, zeros

from derive.check.meaning import Components, MeaningError, ell
from derive.check.sections.functionals import ARCS, PART, OnRod
from derive.check.sections.remembered import remembered
from derive.check.sections.variation import OTHER
from derive.paper import tree as t
from derive.paper.symbolic import NONE, Indices, to_sympy
from derive.theory.claims import Domain
from derive.theory.couple import Couple
from derive.theory.letters import X1, X2, A, V, chi, e1, e2, e3, eps, eta_tilde, field, mu0, nu, vector
from derive.theory.line_energy import FIELD
from derive.theory.symbols import s
from derive.theory.variation import DIRECTION

ANY = ImmutableMatrix(vector("a"))  # the orientation of any particle
SECTION = {"X_1", "X_2"}


@dataclass(frozen=True)
class InRod(OnRod):
    """A meaning in the moving frame with orders of magnitude and integrals over sections of the rod."""

    small: Symbol | None = eps
    volume: Any = None

    def of(self, node: t.Node, indices: Indices = NONE) -> Any:
        """The value of a printed tree; what is only known by its order is numbered anew in each."""
        self.known["unknowns"] = count(1)
        return super().of(node, indices)

    def call(self, name: str, primes: int, args: Sequence[Any]) -> Any:
        """A symbol at a place; a quantity that is collected from 0 to s, from 0 to that place."""
        if name != "L_couple" or primes:
            return super().call(name, primes, args)
        return self.name(name).subs(PART, self.before(args[0]))

    def order(self, node: t.BigO, indices: Indices) -> Any:
        """Something of the order of a power of ε: that power times what is unknown."""
        number = next(self.known["unknowns"])
        unknown = vector(f"O_{number}") if node.kind == t.VECTOR else Symbol(f"O_{number}", real=True)
        return to_sympy(node.of, self, indices) * unknown

    def integral(self, node: t.Integral, indices: Indices) -> Any:
        """Along the rod, over a section, or over a part of the rod, as a density along the rod."""
        if node.region is None:
            return super().integral(node, indices)
        value = to_sympy(node.of, self, indices)
        by = {variable.name for variable in node.by if isinstance(variable, t.Name)}
        match node.region:
            case t.Name(name="Sigma") if by == SECTION:
                return over_section(value)
            case t.Call(name="C_u", args=(end,)) if by == {"volume"}:
                return self.part(t.Number(0), end) * over_section(value * self.volume)
            case t.RegionProduct(left=t.Name(name="Sigma"), right=t.Interval(lower=lower, upper=upper)):
                if len(by & {arc.name for arc in ARCS}) == 1 and len(node.by) == 1 + len(SECTION):
                    return self.part(lower, upper) * over_section(value)
        raise MeaningError(f"an integral by {', '.join(sorted(by))} over such a region has no meaning ({self.title})")

    def rate(self, of: Any, order: int) -> Any:
        """The derivative along the rod; of what is collected from 0 to s, its density at s."""
        if order and of.has(PART):
            of, order = of.diff(PART), order - 1
        return super().rate(of, order)

    def ratio(self, node: t.Derivative, indices: Indices) -> Any:
        """The derivative along the rod."""
        if node.by != t.Name("s"):
            raise self.absent("a derivative but along the rod")
        return self.rate(to_sympy(node.of, self, indices), 1)


def over_section(value: Any) -> Any:
    """A times the value without its part of first order in X₁, X₂, which is linear in them."""
    slope = value.diff(eps).subs(eps, 0)
    flat = slope.subs({X1: 0, X2: 0}) - slope
    return A * (value + eps * flat)


def readings(theory: Any, sides: tuple[t.Node, ...], given: tuple[t.Statement, ...]) -> Iterator[Components]:
    """The reading of a statement: with orders of magnitude, of a couple per unit length, or of any particle."""
    particle, in_rod, first_order = _all(theory)
    nodes = [node for side in sides for node in side.walk()]
    if any(isinstance(node, t.BigO | t.Integral) for node in nodes):
        yield in_rod
    elif any(isinstance(node, t.Name | t.Call) and node.name in ("L_couple", "l_line") for node in nodes):
        yield first_order
    else:
        yield particle


@remembered
def _all(theory: Any) -> tuple[InRod, InRod, InRod]:
    couple: Couple = theory.section2.balance.couple
    rod = couple.line.rod
    known = dict(zip(FIELD, field * DIRECTION, strict=True))
    exact = _values(couple, rod.fibre)
    density = PART * over_section(exact["l_hat"] * rod.jacobian)
    return (
        _reading(couple, "any particle", _values(couple, ANY) | {"L_couple": density}),
        _reading(couple, "fibres of the rod", exact | {"L_couple": density}),
        _reading(couple, "to first order", exact | {"L_couple": PART * couple.by_induction.xreplace(known)}),
    )


def _reading(couple: Couple, title: str, values: Mapping[str, Any]) -> InRod:
    rod = couple.line.rod
    kappa = ImmutableMatrix(rod.frame.kappa)
    rates = dict(OTHER.rates(OTHER.matrix * rod.kappa_u - kappa))
    rates |= dict(zip(DIRECTION.diff(s), -kappa.cross(DIRECTION), strict=True))
    return InRod(title, Domain(), values, kappa, rates, units=[DIRECTION], volume=rod.jacobian)


def _values(couple: Couple, a: Matrix) -> dict[str, Any]:
    """The values of the printed names, in the frame d, for particles of orientation a."""
    line, rod = couple.line, couple.line.rod
    h, before = field * DIRECTION, OTHER.matrix
    known = dict(zip(FIELD, h, strict=True))
    energy, moment = line.energy, line.energy.moment(h, a)
    g = before * rod.tangents_u
    found = {
        **{f"d_{i + 1}": e for i, e in enumerate((e1, e2, e3))},
        **{f"d_u_{i + 1}": before * e for i, e in enumerate((e1, e2, e3))},
        **{f"g_{i + 1}": g[:, i] for i in range(3)},
        "kappa": rod.frame.kappa, "F_tensor": rod.gradient * before.T, "J_map": rod.jacobian, "X_1": eps * X1,
        "X_2": eps * X2, "epsilon": eps, "e": DIRECTION, "h_a": h, "mu_0": mu0, "nu": nu, "V_Pi": V, "chi": chi, "A": A,
        "a_fibre": a, "a_u": before * rod.tangents_u[:, 2], "magnetization": moment / (mu0 * nu * V),
        "M_magnetization": moment / mu0, "b_induction": mu0 * h,
        # The couple that turns a particle, from the slope of its energy: its work is −δψ for δa = δq × a.
        "l_hat": -a.cross(energy.slope(h, a)), "l_line": couple.by_variation.xreplace(known),
        "m_line": couple.by_variation.xreplace(known), "eta_tilde": line.moduli[eta_tilde], "zero": zeros(3, 1),
        "s": s, "varsigma": Symbol("varsigma", real=True), "ell": ell,
    }  # fmt: skip
    return found
