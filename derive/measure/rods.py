"""The rods on which every emitted module is run against the references: the article's own, and others around it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from math import isclose, pi, sqrt
from typing import Any

from derive.measure.reference import Reference, Rod, solve
from derive.measure.scan import STIFFEST, brute_force

PAPER = Rod(beta=0.00035, eta=0.00052, length=80.0, clamp_angle=3 * pi / 4)

# Scaled length ℓ√(β+η), share β/(β+η), clamp angle; the length itself varies to catch a forgotten scale.
_KINDS: tuple[tuple[float, float, float, float], ...] = (
    (0.05, 0.5, 1.0, 1.0),  # almost straight
    (1.3, 0.3, -0.7, 80.0),  # negative clamp angle
    (2.5, 0.9, 0.4, 3.0),  # mostly force
    (4.0, 1 / 3, pi / 2, 80.0),  # clamp orthogonal to force and field; β/η = 1/2
    (5.0, 0.1, 3.0, 1.0),  # mostly field, against it
    (6.0, 0.6, 8.0, 20.0),  # a clamp angle beyond a whole turn
    (9.0, 0.02, 2.2, 80.0),  # long, almost no force
    (12.0, 0.75, 2.8, 5.0),  # long
)
# Fixed by a load case alone; a scene's own constants come on top.
_SHARE = {"field_only": 0.0, "force_only": 1.0}
_FIELD_ANGLE = {"orthogonal": pi / 2}
# For a field at any angle: one for each rod, on both sides of the force, near it and near a quarter turn, beyond that.
_FIELD_ANGLES = (0.7, -0.4, 1.2, 2.5, 0.9, 1e-3, -1.5, 0.7, -2.0)


def rods(case: str, folded: Mapping[str, float] | None = None) -> list[Rod]:
    """A fixed list of moderate rods of a load case, the article's first; folded constants replace their values.

    Where a folded force or field would make a rod stiff, its length makes up for it, unless that is folded too.
    """
    constants = {} if case == "oblique" else {"field_angle": _FIELD_ANGLE.get(case, 0.0)}
    constants |= folded or {}
    paper = {"field_only": replace(PAPER, beta=0.0), "force_only": replace(PAPER, eta=0.0)}.get(case, PAPER)
    chosen = [replace(paper, **{"field_angle": _FIELD_ANGLES[0]} | constants)]
    for (scaled, share, clamp, length), field_angle in zip(_KINDS, _FIELD_ANGLES[1:], strict=True):
        length, share = constants.get("length", length), _SHARE.get(case, share)
        stiffness = (scaled / length) ** 2
        rod = replace(Rod(stiffness * share, stiffness * (1 - share), length, clamp, field_angle), **constants)
        if "length" not in constants and not isclose(rod.beta + rod.eta, stiffness):
            rod = replace(rod, length=scaled / sqrt(rod.beta + rod.eta))
        chosen.append(rod)
    return [rod for rod in chosen if rod.length * sqrt(rod.beta + rod.eta) <= STIFFEST]


def references(rod: Rod, exact: Mapping[str, Any] | None = None) -> list[Reference]:
    """All equilibria of a moderate rod, found by brute force and refined to 40 digits.

    exact: values that stand for those of the rod, which are their doubles: a module has a folded π/2 as such.
    """
    precise = replace(rod, **exact or {})
    return [replace(solve(precise, tip), rod=rod) for tip in brute_force(rod)]
