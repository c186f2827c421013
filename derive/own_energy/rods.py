"""The rods on which the module of an energy is run: loads of all signs, absent ones, some that nearly cancel."""

from __future__ import annotations

from math import pi

from derive.own_energy.references import OwnRod

# Scaled length ℓ√(sum of loads), share of the force in it, signs of linear and quadratic part, clamp and field angle,
# length.
_KINDS: tuple[tuple[float, float, tuple[int, int], float, float, float], ...] = (
    (1.3, 0.3, (1, 1), 0.4, 0.7, 80.0),
    (4.0, 0.4, (1, -1), -0.7, -1.2, 3.0),
    (3.0, 0.2, (-1, 1), pi / 2, 2.5, 1.0),
    (5.5, 0.0, (1, 1), 2.9, 0.2, 5.0),  # no force
    (2.5, 0.0, (-1, -1), 8.0, -8.5, 20.0),  # angles beyond a whole turn
    (5.0, 0.5, (1, -1), 2.8, pi - 1e-3, 80.0),  # a linear part that nearly balances the force
)


def own_rods(names: tuple[str, ...], present: tuple[str, ...]) -> list[OwnRod]:
    """Moderate rods. names: of the loads, the force first. present: which of "tau", "eta" the others are."""
    found = []
    for scaled, share, (linear, quadratic), clamp, field, length in _KINDS:
        stiffness = (scaled / length) ** 2
        signs = {"tau": linear, "eta": quadratic}
        each = stiffness * (1 - share) / len(present)
        balanced = share == 1 / 2 and "tau" in present
        loads = [
            stiffness * share,
            *(signs[one] * (stiffness / 2 if balanced and one == "tau" else each) for one in present),
        ]
        found.append(OwnRod(names, tuple(loads), length, clamp, field))
    return found
