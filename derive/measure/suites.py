"""Hard rods, as data: each with its name and why it is hard. No answers are written here; references find them.

A suite is a function of a load case: it keeps the field angle and the loads that the case has. Rods that must have a
certain tip are made from it: integrated to 40 digits, and the clamp angle is what arrives, rounded to a double.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from itertools import pairwise
from math import cos, nextafter, pi, sqrt

from mpmath import mp

from derive.measure.folds import fold_between
from derive.measure.reference import Rod
from derive.measure.rests import Rest, rests
from derive.measure.rods import PAPER
from derive.measure.segments import Load
from derive.measure.taylor import integrate
from derive.measure.worst_rods import ATLAS, GENERIC, SEARCHED

TINY = (1e-300, 1e-200, 1e-100, 1e-30, 1e-17, 1e-12, 1e-8)
APART = (0.0, 1e-15, 1e-12, 1e-8)
# Relative distances to a fold.
FOLD_DISTANCES = (1e-13, 1e-11, 1e-8)
LENGTHS = (1e-6, 1e-4, 1e-2, 1.0, 5.0, 10.0, 20.0, 50.0, 100.0, 1e3, 1e4)
# Which loads a case has (β, η), and its field angles.
LOADS = {"field_only": (0.0, 1.0), "force_only": (1.0, 0.0)}
FIELD_ANGLES = {"orthogonal": (pi / 2,), "oblique": (0.0, GENERIC, 1.2, pi / 2)}


@dataclass(frozen=True)
class Case:
    """A rod, and why it is hard."""

    name: str
    why: str
    rod: Rod


def bases(case: str) -> list[Rod]:
    """Moderate rods of a load case around which hard ones are built: force, field or neither the stronger."""
    beta, eta = LOADS.get(case, (1.0, 1.0))
    ratios = [(0.35, 0.52), (0.8, 0.2), (0.15, 0.85)] if beta and eta else [(0.6, 0.6)]
    angles = FIELD_ANGLES.get(case, (0.0,))
    return [Rod(b * beta, e * eta, 6.0, 3 * pi / 4, angle) for b, e in ratios for angle in angles]


def weak(case: str) -> Iterator[Case]:
    """Loads that vanish: one of them, or both."""
    beta, eta = LOADS.get(case, (1.0, 1.0))
    for angle in FIELD_ANGLES.get(case, (0.0,)):
        for small in (0.0, *TINY):
            paper = replace(PAPER, field_angle=angle)
            if beta and eta:
                yield Case(f"η = {small:g}", "the field vanishes beside the force", replace(paper, eta=small))
                yield Case(f"β = {small:g}", "the force vanishes beside the field", replace(paper, beta=small))
            both = replace(paper, beta=small * beta, eta=small * eta)
            yield Case(f"loads {small:g}", "a rod that is all but straight", both)


def clamps(case: str) -> Iterator[Case]:
    """Clamps at, or next to, straight and critical directions."""
    for base in bases(case):
        special = [("0", 0.0), ("π/2", pi / 2), ("π", pi), ("-π", -pi)]
        special += [(f"rest {angle:.3g}", angle) for angle in (float(rest.angle) for rest in _rests(base))]
        for name, angle in special:
            for apart in (part * sign for part in APART for sign in ((1, -1) if part else (1,))):
                rod = replace(base, clamp_angle=angle + apart)
                yield Case(f"clamp {name} {apart:+g}", "the clamp at a critical direction", rod)
            for there in (nextafter(angle, 9), nextafter(angle, -9)):
                yield Case(f"clamp {name}, next double", "one rounding off it", replace(base, clamp_angle=there))


def field_angles(case: str) -> Iterator[Case]:
    """Fields all but along or across the force; of the case oblique alone."""
    if case != "oblique":
        return
    for base in (bases("parallel")[0], replace(PAPER, beta=PAPER.eta, eta=PAPER.eta)):
        for at in (0.0, pi / 2, pi):
            for apart in (0.0, 1e-300, 1e-15, -1e-15, 1e-12, -1e-12, 1e-8):
                yield Case(
                    f"α = {at:.3g} {apart:+g}", "formulas of a symmetric field", replace(base, field_angle=at + apart)
                )
    # Stoner and Wohlfarth's astroid: β/η at which two directions of rest merge.
    edge = (cos(GENERIC) ** (2 / 3) + sqrt(1 - cos(GENERIC) ** 2) ** (2 / 3)) ** -1.5
    for apart in (0.0, 1e-13, -1e-13, 1e-8, -1e-8):
        rod = Rod(edge * (1 + apart), 1.0, 6.0, 3.0, GENERIC)
        yield Case(f"β/η at the astroid {apart:+g}", "two directions of rest merge", rod)


def lengths(case: str) -> Iterator[Case]:
    """From all but straight to ten thousand characteristic lengths."""
    for base in bases(case)[:4]:
        for scaled in LENGTHS:
            rod = replace(base, length=scaled / sqrt(base.eta or base.beta))
            yield Case(f"ℓ√η = {scaled:g}", "short: differences vanish; long: tips next to a direction of rest", rod)


def folds(case: str) -> Iterator[Case]:
    """On both sides of a fold, of each input in turn."""
    for base in bases(case)[:4]:
        for parameter, low, high in (("length", 1.0, 7.9), ("clamp_angle", 0.4, 3.0), ("field_angle", 0.0, 1.5)):
            if parameter == "field_angle" and case != "oblique":
                continue
            at = fold_between(base, parameter, low, high)
            if at is None:
                continue
            why = "two equilibria about to merge, or just gone"
            for distance in (part * sign for part in FOLD_DISTANCES for sign in (1, -1)):
                yield Case(f"fold of {parameter} {distance:+g}", why, at.beside(distance))


def discriminants(case: str) -> Iterator[Case]:
    """Tips all but at the level of an unstable direction: the discriminant of ℘ is near 0, from both sides."""
    for base in bases(case):
        for rest in _rests(base):
            for tip in _level(base, float(rest.height)) if rest.stiffness > 0 else []:
                for apart in (part * sign for part in (1e-3, 1e-6, 1e-9, 1e-12) for sign in (1, -1)):
                    name = f"tip {tip:.3g} {apart:+g} at the level of {float(rest.angle):.3g}"
                    yield Case(name, "nearly a double root of the quartic", with_tip(base, tip + apart))


def gammas(case: str) -> Iterator[Case]:
    """Tips all but at rest: γ at the ends of its range."""
    for base in bases(case):
        for rest in _rests(base):
            for apart in (part * sign for part in (1e-2, 1e-5, 1e-8, 1e-12, 1e-15) for sign in (1, -1)):
                name = f"tip at rest {float(rest.angle):.3g} {apart:+g}"
                yield Case(name, "γ at an end of its range", with_tip(base, float(rest.angle) + apart))


def atlas(case: str) -> Iterator[Case]:
    """The worst points of the atlas of extremes; those of a symmetric field in the case parallel, too."""
    for *numbers, why in ATLAS if case in ("parallel", "oblique") else ():
        rod = Rod(*(float(number) for number in numbers))
        if case == "oblique" or not rod.field_angle:
            yield Case(f"atlas {rod}", why, rod)


def searched(case: str) -> Iterator[Case]:
    """The worst of random rods; those of a case of their own in that case, too."""
    for *numbers, why in SEARCHED:
        rod = Rod(*(float(number) for number in numbers))
        if case in ("oblique", case_of(rod)):
            yield Case(f"searched {rod}", why, rod)


def case_of(rod: Rod) -> str:
    """The most special load case that a rod belongs to."""
    if not rod.eta:
        return "force_only"
    if not rod.field_angle:
        return "parallel" if rod.beta else "field_only"
    return "orthogonal" if rod.field_angle == pi / 2 else "oblique"


SUITES: dict[str, Callable[[str], Iterator[Case]]] = {
    "weak": weak,
    "clamps": clamps,
    "field angles": field_angles,
    "lengths": lengths,
    "folds": folds,
    "discriminants": discriminants,
    "gammas": gammas,
    "atlas": atlas,
    "searched": searched,
}


def suite(name: str, case: str) -> list[Case]:
    """The rods of one suite for a load case, which may be none."""
    if name not in SUITES:
        raise ValueError(f"no suite {name!r}; there are {', '.join(SUITES)}")
    return list(SUITES[name](case))


def with_tip(base: Rod, tip: float) -> Rod:
    """The rod of the same loads and length that has an equilibrium with this tip angle, to a rounding of its clamp."""
    path = integrate(tip, base.beta, base.eta, base.field_angle, base.length)
    return replace(base, clamp_angle=float(path.clamp.theta))


def _rests(base: Rod) -> list[Rest]:
    """The directions of rest of a rod within a turn; heights are scaled, as in `Load`."""
    with mp.workdps(30):
        return rests(Load.of(base), -pi / 2 + 1e-3, 3 * pi / 2 + 1e-3)


def _level(base: Rod, height: float) -> list[float]:
    """Tip angles within a turn at which the potential has a height, but for its own extrema."""
    with mp.workdps(30):
        load = Load.of(base)

        def over(angle: float) -> float:
            force = float(load.beta) * cos(angle)
            return force + float(load.eta) / 2 * cos(angle - base.field_angle) ** 2 - height

        grid = [-pi / 2 + 0.0137 + k * 2 * pi / 400 for k in range(401)]
        pairs = [(a, b) for a, b in pairwise(grid) if over(a) * over(b) < 0]
        return [float(mp.findroot(over, pair, solver="anderson", tol=1e-25, verify=False)) for pair in pairs]
