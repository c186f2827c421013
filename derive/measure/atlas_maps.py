"""What the atlas maps: rods over two inputs at a time, from the harmless to the extreme.

A map is a grid of rods of one load case. Nothing is measured here; folds are found and refined for the map of them.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from math import pi, sqrt

import numpy as np
from mpmath import mp

from derive.emit.kernels.folds import all_folds
from derive.measure.folds import NoFoldError, fold
from derive.measure.reference import Rod
from derive.measure.rests import rests
from derive.measure.segments import Load
from derive.measure.suites import with_tip
from derive.measure.worst_rods import GENERIC

CLAMP = 3 * pi / 4
SCALED = 6.0  # ℓ√(β + η) of the map over the two angles, where a rod has several equilibria
LEAST = 1e-300  # a load that is next to none
LONGEST = 100.0  # the greatest ℓ√β and ℓ√η
STIFFEST = 1e4
CLOSED = ("ellipj", "invariants")
# Distances to a fold as shares of its η, and of tips from a direction of rest: powers of ten.
NEAREST = -14.0


@dataclass(frozen=True)
class Map:
    """A grid: rods[row][column] at ys[row], xs[column], of a load case, and which solvers are measured beside ours.

    stable: only equilibria of index 0 are asked for. whole: whether a peer is to find all equilibria.
    """

    name: str
    title: str
    case: str
    x_label: str
    y_label: str
    xs: tuple[str, ...]
    ys: tuple[str, ...]
    rods: tuple[tuple[Rod, ...], ...]
    peers: tuple[str, ...]
    stable: bool = False
    whole: bool = True


def loads(size: int, case: str = "parallel", longest: float = LONGEST) -> Map:
    """Over ℓ√β and ℓ√η, with no load at all and next to none."""
    scaled = (0.0, sqrt(LEAST), *np.logspace(-6, np.log10(longest), max(2, size - 2)).tolist())
    angle = GENERIC if case == "oblique" else 0.0
    rods = tuple(tuple(Rod(b * b, e * e, 1.0, CLAMP, angle) for b in scaled) for e in scaled)
    names = tuple(f"{value:.2g}" for value in scaled)
    title = "weak to strong loads" + (f", field at {GENERIC:g}" if angle else ", field along the force")
    peers = ("invariants",) if angle else ("literal", *CLOSED)
    return Map(f"loads_{case}", title, case, "ℓ√β", "ℓ√η", names, names, rods, peers)


def angles(size: int) -> Map:
    """Over the clamp angle and the field angle, with the quarter turns themselves where the size is odd."""
    stiffness = SCALED**2
    clamps, fields = np.linspace(-pi, pi, size).tolist(), np.linspace(-pi / 2, pi / 2, size).tolist()
    rods = tuple(tuple(Rod(0.4 * stiffness, 0.6 * stiffness, 1.0, c, f) for c in clamps) for f in fields)
    return Map(
        "angles",
        f"directions of clamp and field, ℓ√(β + η) = {SCALED:g}",
        "oblique",
        "clamp angle",
        "field angle",
        tuple(f"{c:.3g}" for c in clamps),
        tuple(f"{f:.3g}" for f in fields),
        rods,
        ("invariants",),
    )


def powers(size: int, first: float) -> list[float]:
    """Signed distances from −10^first over ±10^NEAREST to 10^first."""
    half = np.logspace(first, NEAREST, max(2, size // 2)).tolist()
    return [-value for value in half] + half[::-1]


def fold_distances(size: int) -> Map:
    """Beside folds of η, on both sides."""
    found = []
    for length, clamp, angle in ((3.0, CLAMP, 0.0), (5.5, 2.9, 0.0), (7.0, 2.0, GENERIC), (7.5, -1.2, pi / 2)):
        bare = Rod(0.35, 0.0, length, clamp, angle)
        for rough in all_folds(bare.beta, length, clamp, angle, 0.0, 1.1):
            if rough.kind == "fold":
                found.append((bare, rough))
    rows, names, steps = [], [], powers(size, -1)
    for bare, rough in found[:: -(-len(found) // size) or 1]:
        try:
            exact = fold(bare, "eta", rough.eta, rough.tip_angle)
        except NoFoldError:
            continue
        # Towards the equilibria on the right.
        rows.append(tuple(exact.beside(step * exact.opens) for step in steps))
        names.append(f"η = {rough.eta:.3g}, α = {bare.field_angle:.2g}")
    xs = tuple(f"{step:.0e}" for step in steps)
    title = "distance to a fold: two more equilibria on the right"
    return Map("folds", title, "oblique", "(η − fold)/fold", "fold", xs, tuple(names), tuple(rows), ("invariants",))


def gamma_ends(size: int) -> Map:
    """Tips beside directions of rest, where γ is at an end of its range and two roots of f meet."""
    rows, names, steps = [], [], powers(size, -1)
    bases = [Rod(b, e, SCALED, CLAMP) for b, e in ((0.35, 0.52), (0.8, 0.2), (0.0, 0.6), (0.6, 0.0))]
    for base in bases:
        with mp.workdps(30):
            known = [float(rest.angle) for rest in rests(Load.of(base), -1e-3, pi + 1e-3)]
        for rest in known:
            rows.append(tuple(with_tip(base, rest + step) for step in steps))
            names.append(f"β, η = {base.beta:g}, {base.eta:g}; {rest:.3g}")
    chosen = slice(None, None, max(1, -(-len(rows) // size)))
    xs = tuple(f"{step:.0e}" for step in steps)
    return Map(
        "gamma",
        "tips beside a direction of rest: γ at the ends of its range",
        "parallel",
        "tip angle − direction of rest",
        "loads; direction",
        xs,
        tuple(names[chosen]),
        tuple(rows[chosen]),
        ("literal", *CLOSED),
    )


def stiff(size: int, stiffest: float = STIFFEST) -> Map:
    """Ever longer rods in a field alone; one stable equilibrium, that which ends along the field."""
    scaled = np.logspace(0, np.log10(stiffest), size).tolist()
    rods = (tuple(Rod(0.0, s * s, 1.0, 1.0) for s in scaled),)
    xs = tuple(f"{s:.3g}" for s in scaled)
    title = "stiffness: the stable rod that ends along the field"
    peers = ("ellipj", "invariants", "solve_bvp", "Radau")
    return Map("stiff", title, "parallel", "ℓ√η", "", xs, ("",), rods, peers, stable=True, whole=False)


MAPS: dict[str, Callable[[int], Map]] = {
    "loads_parallel": loads,
    "loads_oblique": lambda size: loads(size, "oblique"),
    "angles": angles,
    "folds": fold_distances,
    "gamma": gamma_ends,
    "stiff": stiff,
}


def rod_at(chart: Map, row: int, column: int) -> Rod:
    """A rod of a map, with numbers of Python's own."""
    rod = chart.rods[row][column]
    return replace(rod, **{name: float(value) for name, value in vars(rod).items()})
