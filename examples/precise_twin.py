"""How far double precision is off: each module has a twin that works in as many digits as you like.

python examples/precise_twin.py [DIGITS]

A rod of paramagnetic particles under force and field, ever longer; DIGITS: of the twin, 40 unless told. Errors are in
units of 2⁻⁵², relative to 1 for the angle and to the length for the place. Both work from the same doubles.
"""

from __future__ import annotations

import sys
from math import pi

from mpmath import nstr

from generated import parallel_mpmath, parallel_numpy

ROD = {"beta": 0.00035, "eta": 0.00052, "clamp_angle": 3 * pi / 4}
LENGTHS = (20.0, 80.0, 200.0)


def main(digits: int = 40) -> None:
    """Print both answers for the first equilibrium of each rod, and how far the double is off."""
    for length in LENGTHS:
        found = parallel_numpy.equilibria(length=length, **ROD)
        precise = parallel_mpmath.equilibria(length=length, dps=digits, **ROD)
        print(f"length {length:g}: {len(found)} equilibria by one, {len(precise)} by the other")
        one, same = found[0], precise[0]
        print(f"    θ(ℓ) = {one.tip_angle!r}")
        print(f"           {nstr(same.tip_angle, digits)}")
        angle, place = (one.tip_angle - same.tip_angle) * 2**52, (one.y - same.y) / length * 2**52
        print(f"    off by {float(angle):.1f}, and y by {float(place):.1f}")


if __name__ == "__main__":
    main(int(sys.argv[1]) if len(sys.argv) > 1 else 40)
