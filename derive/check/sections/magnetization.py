"""Section 2.2, kth20b to magnha: a paramagnetic particle in any direction in any field (scope ``magnetization``).

The theory solves the particle's laws in the particle's own axes, the third along it. Here these axes are turned by any
rotation, so that the particle lies anywhere and no component of a field is special.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import Any

from sympy import Matrix, MatrixBase, Symbol, eye, zeros

from derive.check.meaning import Components
from derive.check.sections.moving import inverse, unknown
from derive.check.sections.remembered import remembered
from derive.check.sections.turning import Rotation
from derive.paper import tree as t
from derive.theory import letters, particle, symbols
from derive.theory.claims import Domain, Notebook
from derive.theory.energy import Energy, H
from derive.theory.letters import vector

APPLIED = vector("h_a")  # the applied field, in axes of which nothing is known, A/m


class Particle(Components):
    """The reading of any particle in any field, with the energy of the theory."""

    title = "any particle in any field"
    domain = Domain()
    values: Mapping[str, Callable[[Any], Any]] = {}

    def __init__(self, energy: Energy) -> None:
        self.energy = energy
        self.particle = particle.derive(Notebook())
        self.axes = Rotation(vector("r")).matrix
        self._known: dict[str, Any] = {}

    def name(self, name: str) -> Any:
        """From the table below."""
        if name not in self.values:
            raise self.absent(f"'{name}'")
        if name not in self._known:
            self._known[name] = self.values[name](self)
        return self._known[name]

    def call(self, name: str, primes: int, args: Sequence[Any]) -> Any:
        """Nothing is known of another particle."""
        return unknown(f"{name}_elsewhere", self.name(name))

    def inverse(self, of: Any) -> Any:
        """By the products of its rows."""
        return inverse(of)

    def turned(self, own: Matrix) -> Matrix:
        """A vector that the laws give for the field H in the particle's axes, or a tensor in them, in the others."""
        there = own.subs(dict(zip(H, self.axes.T * APPLIED, strict=True)), simultaneous=True)
        return self.axes * there if own.shape == (3, 1) else self.axes * own * self.axes.T


def susceptibility(symbol: Symbol) -> Callable[[Particle], Any]:
    """χ or χ̃ by the particle's material and shape."""
    return lambda reading: reading.particle.susceptibilities[symbol]


def energy(reading: Particle) -> Any:
    """ψ̂_m."""
    return reading.energy.density(APPLIED, reading.name("a_fibre")).subs(reading.particle.susceptibilities)


def before(reading: Particle) -> MatrixBase:
    """a^u, which the deformation takes to the direction of a."""
    from_a = inverse(reading.name("F_tensor")) * reading.name("a_fibre")
    return from_a / reading.norm(from_a)


Particle.values = {
    "h_a": lambda r: APPLIED,
    "a_fibre": lambda r: r.axes[:, 2],
    "h_field": lambda r: r.turned(r.particle.fields.inside),
    "h_d": lambda r: r.turned(r.particle.fields.demagnetizing),
    "magnetization": lambda r: r.turned(r.particle.fields.magnetization),
    "X_tensor": lambda r: r.turned(r.particle.fields.material),
    "N_tensor": lambda r: r.turned(r.particle.fields.shape),
    "chi": susceptibility(letters.chi),
    "chi_tilde": susceptibility(letters.chi_tilde),
    "psi_m_hat": energy,
    "chi_parallel": lambda r: letters.chi_par,
    "chi_perp": lambda r: letters.chi_perp,
    "N_parallel": lambda r: letters.N_par,
    "N_perp": lambda r: letters.N_perp,
    "mu_0": lambda r: letters.mu0,
    "nu": lambda r: letters.nu,
    "V_Pi": lambda r: letters.V,
    "F_tensor": lambda r: unknown("F", eye(3)),
    "a_u": before,
    "identity": lambda r: eye(3),
    "zero": lambda r: zeros(3, 1),
    "s": lambda r: symbols.s,
    "ell": lambda r: symbols.ell,
}


@remembered
def particle_of(theory: Any) -> Particle:
    """The reading; its values are computed once."""
    return Particle(theory.section2.balance.couple.line.energy)


def readings(theory: Any, sides: tuple[t.Node, ...], given: tuple[t.Statement, ...]) -> Iterator[Components]:
    """One: any particle in any field."""
    yield particle_of(theory)
