"""Section 2.2, kth21 to kth28: the magnetic energy of a rod with particles along its fibres (scope ``line_energy``).

How integrals are compared. Over a section Σ, of which only its area A and its centroid at the origin are known: two
integrals of f and g are equal for all sections if and only if f − g is a linear form in X₁ and X₂, without a constant
term. So A (f − its linear part at the axis) stands for the integral. Along the rod: two integrals from the beginning
to every s are equal if and only if what they integrate is equal. So ``extent(s)`` times the density at s stands for
the integral; it is zero at the beginning, and its derivative is the density. A volume is J dX₁ dX₂ dς.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from sympy import Expr, Integer, Matrix, MatrixBase, Symbol, sqrt, zeros
from sympy.core.function import AppliedUndef, Derivative

from derive.check.meaning import Components
from derive.check.sections.moving import extent
from derive.check.sections.remembered import remembered
from derive.check.sections.rod import Rod
from derive.check.sections.turning import elsewhere
from derive.paper import tree as t
from derive.paper.symbolic import Indices, to_sympy
from derive.theory import letters
from derive.theory.letters import X1, X2, A, e3, eta_tilde, vector_of
from derive.theory.symbols import s
from derive.theory.variation import Balance

FIELD = vector_of("h_a")  # the applied field in the frame d; it does not vary in space
SECTION = (t.Name("X_1"), t.Name("X_2"))
ARC = (t.Name("varsigma"), t.Name("s"))  # variables of integration along the rod


class MagneticRod(Rod):
    """The reading of any rod, with particles along its fibres, in a uniform field."""

    title = "any rod with particles along its fibres"

    def __init__(self, balance: Balance) -> None:
        super().__init__(balance)
        self._integrals: dict[Any, Any] = {}

    @property
    def uniform(self) -> dict[Matrix, Matrix]:
        """The field does not vary along the rod."""
        return {FIELD: zeros(3, 1)}

    def integral(self, node: t.Integral, indices: Indices) -> Any:
        """Over a section, along the rod, or over a part of the rod; each is computed once."""
        key = (node, tuple(sorted(indices.items())))
        if key not in self._integrals:
            self._integrals[key] = self._integral(node, indices)
        return self._integrals[key]

    def _integral(self, node: t.Integral, indices: Indices) -> Any:
        of = to_sympy(node.of, self, indices)
        match node.region:
            case t.Name(name="Sigma") if node.by == SECTION:
                return over_section(of)
            case t.Call(name="C_u", args=(end,)) if node.by == (t.Name("volume"),):
                inside = over_section(of * self.name("J_map"))
                return self._along(inside, t.Number(0), end, indices)
            case t.RegionProduct(left=t.Name(name="Sigma"), right=t.Interval(lower=lower, upper=upper)):
                if node.by[:2] == SECTION and node.by[2:] in {(arc,) for arc in ARC}:
                    return self._along(over_section(of), lower, upper, indices)
            case None if node.lower and node.upper and len(node.by) == 1 and node.by[0] in ARC:
                return self._along(of, node.lower, node.upper, indices)
        # By other variables, or over another region, it is another quantity.
        return of * Symbol("other_integral", positive=True)

    def _along(self, density: Any, lower: t.Node, upper: t.Node, indices: Indices) -> Any:
        ends = [to_sympy(end, self, indices) for end in (upper, lower)]
        first, last = (elsewhere(density, end) * extent(end) for end in ends)
        return first - last


def over_section(integrand: Any) -> Any:
    """What stands for the integral over a section; see the head."""
    if isinstance(integrand, MatrixBase):
        return integrand.applyfunc(over_section)
    # What the small displacement is at the axis may be anything, zero too.
    varying = (x for x in integrand.atoms(AppliedUndef, Derivative) if x.has(X1, X2))
    plain = integrand.xreplace(dict.fromkeys(varying, Integer(0)))
    axis = dict.fromkeys((X1, X2), Integer(0))
    return A * (integrand - sum(X * plain.diff(X).xreplace(axis) for X in (X1, X2)))


def of_length(expr: Expr) -> Expr:
    """An expression in the theory's modulus of the field and alignment, by the vectors."""
    size = sqrt(FIELD.dot(FIELD))
    return expr.subs({letters.w: FIELD.dot(e3) / size, letters.field: size}, simultaneous=True)


def of_volume(reading: MagneticRod) -> Expr:
    """ψ̂_m without the part that does not depend on the orientation, which the text drops."""
    density = reading.balance.couple.line.energy.density
    return density(FIELD, reading.rod.fibre) - density(FIELD, zeros(3, 1))


def modulus(reading: MagneticRod) -> Expr:
    """η̃, if the energy has it."""
    found = reading.balance.couple.line.moduli
    if eta_tilde not in found:
        raise reading.absent("'eta_tilde'")
    return of_length(found[eta_tilde])


MagneticRod.values = {
    **Rod.values,
    "h_a": lambda r: FIELD,
    "e": lambda r: FIELD / sqrt(FIELD.dot(FIELD)),
    "a_fibre": lambda r: r.rod.fibre,
    "a_u": lambda r: r.from_u(r.rod.fibre_u),
    "J_map": lambda r: r.rod.jacobian,
    "psi_m_hat": of_volume,
    "Psi_m": lambda r: extent(s) * over_section(of_volume(r) * r.rod.jacobian),
    "psi_m": lambda r: of_length(r.balance.couple.line.psi_m),
    "eta_tilde": modulus,
    "mu_0": lambda r: letters.mu0,
    "nu": lambda r: letters.nu,
    "V_Pi": lambda r: letters.V,
    "chi": lambda r: letters.chi,
    "A": lambda r: A,
    "varsigma": lambda r: Symbol("varsigma", real=True),
    "volume": lambda r: Symbol("V", positive=True),
}


@remembered
def rod_of(theory: Any) -> MagneticRod:
    """The reading; its values are computed once."""
    return MagneticRod(theory.section2.balance)


def readings(theory: Any, sides: tuple[t.Node, ...], given: tuple[t.Statement, ...]) -> Iterator[Components]:
    """One: any rod with particles along its fibres."""
    yield rod_of(theory).to_order(given)
