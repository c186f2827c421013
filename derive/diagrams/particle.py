"""From material, shape and field to the dimensional constants β and η, by the formulas of the derivation."""

from __future__ import annotations

import math
from collections.abc import Mapping
from functools import cache

import mpmath
from sympy import Expr, Symbol, lambdify

from derive.theory import letters
from derive.theory.equilibrium import derive_section2
from derive.theory.fields import solved
from derive.theory.particle import susceptibilities
from derive.theory.symbols import eta

MU0 = 1.25663706127e-6  # N/A², CODATA 2022


def demagnetizing(aspect: float) -> tuple[float, float]:
    """N∥ and N⊥ of a spheroid whose axis of symmetry is ``aspect`` times the other ones.

    For half-axes a, b, c the factor along a is (abc/3)·R_D(b², c², a²), one Carlson integral for any aspect.
    """
    with mpmath.workdps(30):
        m = mpmath.mpf(aspect)
        along = m / 3 * mpmath.elliprd(1, 1, m**2)
        across = m / 3 * mpmath.elliprd(1, m**2, 1)
    return float(along), float(across)


@cache
def formula_of_eta() -> Expr:
    """η in the letters of the particles, the field and the rod: derived anew, from the energy."""
    found: Expr = derive_section2().moduli[eta]
    return found


def evaluate(expression: Expr, values: Mapping[Symbol, float]) -> float:
    """The value of an expression of the theory."""
    names = sorted(expression.free_symbols, key=str)
    return float(lambdify(names, expression, "math")(*(values[name] for name in names)))


def excess(along: float, across: float, aspect: float) -> float:
    """χ: the susceptibility of a particle along its axis in excess of that across it, to the applied field."""
    n_along, n_across = demagnetizing(aspect)
    values = {letters.chi_par: along, letters.chi_perp: across, letters.N_par: n_along, letters.N_perp: n_across}
    return evaluate(susceptibilities(solved())[letters.chi], values)


def stiffness(young: float, diameter: float) -> float:
    """EI of a circular section, N m² for Pa and m."""
    return young * math.pi * diameter**4 / 64


def eta_of(chi: float, fraction: float, diameter: float, bending: float, field: float) -> float:
    """η, 1/m², for a field in A/m; ``fraction``: the volume of the particles in that of the rod."""
    values = {
        letters.A: math.pi * diameter**2 / 4,
        letters.mu0: MU0,
        # Volume of a particle times their number in a volume: only the product enters.
        letters.nu: fraction,
        letters.V: 1.0,
        letters.chi: chi,
        letters.field: field,
        letters.EI: bending,
    }
    return evaluate(formula_of_eta(), values)
