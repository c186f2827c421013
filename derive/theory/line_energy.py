"""Section 2.2, kth25 to kth28: the magnetostatic energy of a rod per unit length, and the moduli that it leaves.

Run ``python -m derive.theory.line_energy`` to print this part.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from sympy import Expr, Matrix, Poly, Rational, Symbol, cos, integrate, simplify, sin, sqrt

from derive.theory import energy as energy_script
from derive.theory import frame, kinematics, particle, placement
from derive.theory.claims import Equal, Notebook, Order, print_notebook
from derive.theory.energy import Energy
from derive.theory.kinematics import Kinematics
from derive.theory.letters import (
    SI,
    X1,
    X2,
    A,
    angle,
    current,
    e1,
    e3,
    eps,
    eta_tilde,
    field,
    first_order,
    length,
    mass,
    tau_tilde,
    time,
    unit,
    vector,
    w,
)
from derive.theory.placement import POINT

FIELD = vector("h")  # the applied field, A/m; in this script and the next in the frame d
MODULI = {1: tau_tilde, 2: eta_tilde}  # letters for the terms −(letter) wⁿ/n of the energy


@dataclass(frozen=True)
class LineEnergy:
    """The magnetostatic energy of a rod per unit length.

    density: A · (energy per unit volume) on the axis, for FIELD in the frame d, J/m. psi_m: the same by the alignment
    w = d₃·e alone, less its value at w = 0, J/m. named: psi_m with its moduli as letters. moduli: letter → value, N.
    """

    energy: Energy
    rod: Kinematics
    density: Expr
    psi_m: Expr
    named: Expr
    moduli: Mapping[Symbol, Expr]


def over_section(expr: Expr) -> Expr:
    """The integral over a section: its area is A, and its first moments vanish (kth26). Of first degree in X₁, X₂."""
    polynomial = Poly(expr, X1, X2)
    if polynomial.total_degree() > 1:
        raise ValueError("only terms of first order in the section coordinates have a known integral")
    return A * polynomial.coeff_monomial(1)


def over_triangle(expr: Expr) -> Expr:
    """The same for one section, a triangle of area 9/2 with its centroid at the origin, by integration."""
    return integrate(integrate(expr.expand(), (X2, -1, 1 - X1)), (X1, -1, 2))


def of_alignment(energy: Energy) -> Expr:
    """A · (energy per unit volume) by w = d₃·e alone, less its value at w = 0."""
    azimuth = angle("azimuth")
    # The field at the alignment w, on any side of the rod.
    across = sqrt(1 - w**2)
    e = Matrix([across * cos(azimuth), across * sin(azimuth), w])
    density = simplify(A * energy.density(field * e, e3)).expand()
    if density.has(azimuth):
        raise ValueError(f"the energy of {energy.name} depends on the side from which the field comes")
    return (density - density.subs(w, 0)).expand()


def name_moduli(psi_m: Expr) -> tuple[Expr, dict[Symbol, Expr]]:
    """psi_m as −τ̃ w − ½ η̃ w² with the values of τ̃ and η̃, where it is a quadratic; else as it stands."""
    if not psi_m.is_polynomial(w) or Poly(psi_m, w).degree() > 2:
        return psi_m, {}
    present = {degree: letter for degree, letter in MODULI.items() if psi_m.coeff(w, degree) != 0}
    named = sum((-letter * w**degree / degree for degree, letter in present.items()), Rational(0))
    return named, {letter: -degree * psi_m.coeff(w, degree) for degree, letter in present.items()}


def derive(energy: Energy, rod: Kinematics, book: Notebook) -> LineEnergy:
    """The energy per unit length and its moduli, with their claims."""
    exact = energy.density(FIELD, rod.fibre) * rod.jacobian
    small = first_order(exact).expand()
    density = over_section(small).expand()
    psi_m = of_alignment(energy)
    named, moduli = name_moduli(psi_m)
    book.say("The magnetic energy per unit length: the first order has no part, since first moments vanish.")
    book.show("psi_m", psi_m)
    for letter, value in moduli.items():
        book.show(letter.name, value)
    line = LineEnergy(energy, rod, density, psi_m, named, moduli)
    claim_expansion(line, exact, small, book)
    claim_alignment(line, book)
    if moduli:
        claim_moduli(line, book)
    if energy.units is not None:
        claim_units(line, energy.units, book)
    return line


def claim_expansion(line: LineEnergy, exact: Expr, small: Expr, book: Notebook) -> None:
    """The energy of a cross section to first order, and its integral."""
    energy, rod = line.energy, line.rod
    on_axis, slope = energy.density(FIELD, e3), energy.slope(FIELD, e3)
    turn, turn_u = rod.frame.kappa.cross(POINT), rod.kappa_u.cross(POINT)
    # The chain rule: the particles turn by the part of the fibre's turn across d₃, and the volume changes.
    book.claim(
        "line_energy.expansion",
        "to first order the energy changes with the turn of the particles and the volume",
        Equal(small, on_axis * (1 + e3.dot(turn_u)) + slope.dot(turn - e3 * e3.dot(turn))),
        steps=["energy.invariance", "kinematics.orientation", "kinematics.jacobian"],
        source="kth25",
    )
    book.claim(
        "line_energy.remainder",
        "what the first order leaves out is of second order",
        Order(exact - small, eps, 2),
        steps=["line_energy.expansion"],
        source="kth25",
    )
    book.claim(
        "line_energy.section",
        "over a section the first order has no part: a triangle, integrated, agrees",
        Equal(over_triangle(small), line.density.subs(A, Rational(9, 2))),
        steps=["line_energy.expansion"],
        source="kth26",
    )
    book.claim(
        "line_energy.axis",
        "the energy per unit length is the area times the density on the axis",
        Equal(line.density, A * on_axis),
        steps=["line_energy.expansion", "line_energy.section"],
        source="kth27",
    )


def claim_alignment(line: LineEnergy, book: Notebook) -> None:
    """psi_m depends on the angle between rod and field alone."""
    d, e = unit(angle("p"), angle("q")), unit(angle("r"), angle("t"))
    density = line.energy.density
    book.claim(
        "line_energy.alignment",
        "less a constant, the energy per unit length depends on the alignment of rod and field alone",
        Equal(line.psi_m.subs(w, e.dot(d)), A * (density(field * e, d) - density(field * e1, e3))),
        steps=["line_energy.axis"],
        source="kth27",
    )
    book.claim(
        "line_energy.named",
        "the energy by its moduli, where it has them",
        Equal(line.named.subs(line.moduli), line.psi_m),
        steps=["line_energy.alignment"],
        source="kth27",
    )


def claim_moduli(line: LineEnergy, book: Notebook) -> None:
    """The moduli from the energies of two rods, along the field and across it."""
    ahead, across = (A * line.energy.density(field * e, e3) for e in (e3, e1))
    book.claim(
        "line_energy.moduli",
        "the moduli make the difference of the energies of rods across and along the field",
        Equal(
            sum((line.moduli.get(letter, Rational(0)) / degree for degree, letter in MODULI.items()), Rational(0)),
            across - ahead,
        ),
        steps=["line_energy.alignment"],
        source="kth28",
    )


def claim_units(line: LineEnergy, own: Mapping[Symbol, Expr], book: Notebook) -> None:
    """What a change of units does to the energy and to its moduli."""
    # Express each letter in other units of mass, length, time and current: the factors tell the dimension.
    units = {letter: letter * size for letter, size in {**SI, **own}.items()}
    force = mass * length / time**2
    book.claim(
        "line_energy.dimension",
        "the energy per unit length, and each of its moduli, is a force",
        Equal(
            Matrix([x.subs(units, simultaneous=True) for x in (line.psi_m, *line.moduli.values())]),
            force * Matrix([line.psi_m, *line.moduli.values()]),
        ),
        steps=["line_energy.alignment"],
        source="kth28",
    )
    if eta_tilde in line.moduli:
        per_field = line.moduli[eta_tilde] / field**2
        book.claim(
            "line_energy.dimension_per_field",
            "what is a force times a length squared over a current squared is the modulus over the square of the field",
            Equal(per_field.subs(units, simultaneous=True), force * (length / current) ** 2 * per_field),
            steps=["line_energy.dimension"],
            source="kth28",
        )


def chain(book: Notebook, energy: Energy | None = None) -> LineEnergy:
    """The derivation up to here, from an energy (paramagnetic particles if none is given)."""
    # An energy that is given is where the derivation begins.
    made_of = () if energy else ("particle.energy",)
    energy = energy_script.derive(energy or particle.derive(book).energy, book, made_of)
    before = frame.derive(book)
    placement.derive(before, book)
    return derive(energy, kinematics.derive(before, book), book)


def main() -> None:
    """Print the derivation so far, for paramagnetic particles."""
    print_notebook(chain)


if __name__ == "__main__":
    main()
