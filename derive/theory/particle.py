"""Section 2.2, campi to magnha: a linear, anisotropic, prolate particle, its magnetization and its energy.

The field inside is the applied field plus the demagnetizing field that the magnetization itself makes; material and
shape are symmetric about the long axis a. Run ``python -m derive.theory.particle`` to print this part.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from sympy import Expr, Matrix, Symbol, expand, factor, integrate, oo

from derive.theory import fields as fields_script
from derive.theory.claims import Domain, Equal, Notebook, Positive, print_notebook
from derive.theory.energy import DIRECTION, Energy, H
from derive.theory.fields import Fields, symmetric
from derive.theory.letters import (
    N_par,
    N_perp,
    V,
    angle,
    chi,
    chi_par,
    chi_perp,
    chi_tilde,
    current,
    e1,
    e3,
    gradient,
    length,
    mu0,
    nu,
    rotation,
    unit,
)


@dataclass(frozen=True)
class Particle:
    """A paramagnetic particle.

    susceptibilities: χ and χ̃ in the susceptibilities χ∥, χ⊥ of the material and the demagnetizing factors N∥, N⊥.
    magnetization: m(H, DIRECTION) in χ, χ̃, A/m, shape 3 × 1. energy: the energy of ν such particles per unit volume.
    fields: what the particle's laws give in its own axes.
    """

    susceptibilities: Mapping[Symbol, Expr]
    magnetization: Matrix
    energy: Energy
    fields: Fields


def susceptibilities(found: Fields) -> dict[Symbol, Expr]:
    """χ and χ̃, by the magnetization along the particle and across it."""
    along, across = (found.magnetization[i].diff(H[i]) for i in (2, 0))
    # m = along · (part of h along a) + across · (the rest), sorted by a and h.
    return {chi: along - across, chi_tilde: across}


def energy_of(name: str, magnetization: Matrix, units: Mapping[Symbol, Expr] | None = None) -> Energy:
    """The energy stored by the reversible work on the particles while the field grows from 0 to h.

    magnetization: A/m, 3 × 1, for the field H and the orientation DIRECTION. units: those of its own letters.
    """
    t = Symbol("t", nonnegative=True)
    # m at the field t·h, through which the field grows by h dt.
    growing = magnetization.xreplace({component: t * component for component in H})
    density = -mu0 * nu * V * integrate(expand(growing.dot(H)), (t, 0, 1))
    pairs = [*H, *DIRECTION]
    return Energy(name, lambda h, a: density.xreplace(dict(zip(pairs, [*h, *a], strict=True))), units or {})


def permanent_energy() -> Energy:
    """Particles of a constant magnetization M₀ (A/m) along a, whatever the field: another input of the derivation."""
    M0 = Symbol("M_0", positive=True)
    return energy_of("permanently magnetized particles", M0 * DIRECTION, {M0: current / length})


def derive(book: Notebook) -> Particle:
    """Magnetization and energy of paramagnetic particles, with their claims."""
    found = fields_script.solved()
    values = susceptibilities(found)
    book.say("Susceptibilities of a prolate particle to the applied field, from the fields in its own axes.")
    book.show("chi", factor(values[chi]))
    book.show("chi_tilde", factor(values[chi_tilde]))
    magnetization = chi * H.dot(DIRECTION) * DIRECTION + chi_tilde * H
    claim_magnetization(magnetization.xreplace(values), book)
    fields_script.claim(found, magnetization.xreplace(values), book)
    # A long particle, N⊥ − N∥ > 0, of a material that is not easier to magnetize across, χ∥ − χ⊥ > 0.
    longer, easier = Symbol("N_excess", positive=True), Symbol("chi_excess", positive=True)
    book.claim(
        "particle.positive",
        "a long particle of a material that is easiest to magnetize along it has positive chi",
        Positive(factor(values[chi].xreplace({N_perp: N_par + longer, chi_par: chi_perp + easier}))),
        domain=Domain(dict.fromkeys((N_par, longer, chi_perp, easier), (0, oo))),
        steps=["particle.magnetization"],
    )

    # The energy is the work that the field does; its slope gives the magnetization back.
    energy = energy_of("paramagnetic particles", magnetization)
    book.show("energy density", energy.density(H, DIRECTION))
    a = unit(angle("p"), angle("q"))
    at_a = dict(zip(DIRECTION, a, strict=True))
    book.claim(
        "particle.energy",
        "minus the slope of the energy in the field is the magnetization times its constants",
        Equal(
            -gradient(energy.density(H, a), H).xreplace(values),
            mu0 * nu * V * magnetization.xreplace(values).xreplace(at_a),
        ),
        steps=["particle.magnetization"],
        source="kth20b",
    )
    # Turn about the third axis and then about the first: with these two every rotation is reached.
    turn = rotation(e3, angle("r")) * rotation(e1, angle("t"))
    book.claim(
        "particle.invariance",
        "the energy does not change when field and particle are rotated together",
        Equal(energy.density(turn * H, turn * a), energy.density(H, a)),
        steps=["particle.energy"],
    )
    return Particle(values, magnetization, energy, found)


def claim_magnetization(m: Matrix, book: Notebook) -> None:
    """Hold the solution against the laws from which it came, with the particle in any direction."""
    a = unit(angle("p"), angle("q"))
    m = m.xreplace(dict(zip(DIRECTION, a, strict=True)))
    book.claim(
        "particle.response",
        "the magnetization satisfies the material's law in the field that it makes itself",
        Equal(m, symmetric(chi_par, chi_perp, a) * (H - symmetric(N_par, N_perp, a) * m)),
        source="eqazm",
    )
    book.claim(
        "particle.magnetization",
        "the magnetization is the inverse of the sum of reciprocal susceptibility and demagnetizing tensor",
        Equal(symmetric(1 / chi_par + N_par, 1 / chi_perp + N_perp, a) * m, H),
        steps=["particle.response"],
        source="magnha",
    )


def main() -> None:
    """Print the derivation so far."""
    print_notebook(derive)


if __name__ == "__main__":
    main()
