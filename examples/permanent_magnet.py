"""A rod of permanently magnetized particles: from its energy to its equilibria. Half a minute; seconds when repeated.

    python examples/permanent_magnet.py [FOLDER]

writes permanent_magnet_numpy.py and permanent_magnet_mpmath.py to the folder, if one is given.
"""

import sys
from math import pi, radians

from sympy import Symbol

from derive.own_energy import solver
from derive.theory.energy import Energy
from derive.theory.letters import EI, A, V, current, field, length, mu0, nu

# The energy of ν particles per unit volume, each of volume V and magnetized by M₀ along its axis a, in the field h.
M0 = Symbol("M_0", positive=True)
magnets = Energy("permanently magnetized particles", lambda h, a: -mu0 * nu * V * M0 * h.dot(a), {M0: current / length})


def main(folder: str | None = None) -> None:
    """Derive, prove, emit; then solve a rod that the field, all but opposed to it, bends to either side."""
    magnet = solver(magnets, names={"tau": "mu"}, name="permanent_magnet", out=folder)
    print(magnet.report())

    # A silicone rod of 20 mm and 1 mm diameter, 10 % magnets of 0.6 MA/m, 20 mT at 170° to the rod, no force; SI units.
    area, stiffness = pi * 0.5e-3**2, 1e6 * pi * 1e-3**4 / 64
    si = {A: area, EI: stiffness, mu0: 4e-7 * pi, nu: 0.1, V: 1, M0: 6e5, field: 0.02 / (4e-7 * pi)}
    mu = float(magnet.moduli["mu"].subs(si))
    print(f"\nmu = {mu:.6g} 1/m²")
    for one in magnet.numpy.equilibria(beta=0, mu=mu, length=0.02, clamp_angle=0, field_angle=radians(170)):
        kind = "stable" if one.index == 0 else "unstable"
        print(f"tip at {1e3 * one.y:8.4f} mm, {1e3 * one.z:8.4f} mm, {one.tip_angle:8.5f} rad: {kind}")


if __name__ == "__main__":
    main(*sys.argv[1:2])
