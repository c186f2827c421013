"""The families of motions through a clamp angle, each along a line, and beyond which places none is an equilibrium.

Below the lower hill, or where hills are level, a motion swings in one well, κ = κ_top tanh y; between the heights of
the two it passes the lower one, the ridge, and E goes from one to the other by a logistic curve, for either sign of κ.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from flint import arb, arb_series

from derive.measure.verified.ends import above, first_below, logistic, within
from derive.measure.verified.means import UndecidedError
from derive.measure.verified.motion import ORDER
from derive.measure.verified.potential import TURNS, Potential, rests
from derive.measure.verified.wells import Path, Well, well_between


@dataclass(frozen=True)
class Line:
    """A family of motions in a well, and the places between which all equilibria of it lie.

    sides: how many families are as this one.
    """

    well: Well
    path: Path
    low: float
    high: float
    sides: int = 1


def swinging(start: arb, top: arb) -> Path:
    """Motions from the clamp's V to a hill's, of either sense: E = top − rise/cosh²y, κ = √(2 rise) tanh y."""
    rise = top - start
    most = (2 * rise).sqrt()

    def at(low: float, high: float) -> tuple[Any, Any]:
        tangent = arb(low).tanh().union(arb(high).tanh())
        square = (arb(low).sech() ** 2).union(arb(high).sech() ** 2)
        square = square.union(arb(1)) if low < 0 < high else square
        below = rise * square
        energy = [top - below, 2 * tangent * below, (square - 2 * tangent * tangent) * below]
        return arb_series(energy, ORDER), arb_series([most * tangent, most * square, -most * tangent * square], ORDER)

    return Path(at, True, True)


def passing(start: arb, ridge: arb, top: arb, *, up: bool) -> Path:
    """Motions of one sense between the heights of two hills: E = ridge + rise/(1 + e^(−y))."""
    rise = top - ridge

    def at(low: float, high: float) -> tuple[Any, Any]:
        share = logistic(low).union(logistic(high))
        rest = logistic(-low).union(logistic(-high))
        rate = rise * share * rest
        energy = arb_series([ridge + rise * share, rate, rate * (rest - share) / 2], ORDER)
        return energy, (2 * (energy - start)).sqrt()

    return Path(at, False, up)


def lines(potential: Potential, length: arb, *, level: bool) -> list[Line]:
    """All families of a rod; V rises from the clamp, or it is a well about which V is even, or a ridge.

    level: all hills are as high.
    """
    around, start = rests(potential), potential.value(arb(0))
    heights = [potential.value(rest.angle) for rest in around if rest.hill]
    top, ridge = max(heights, key=float), min(heights, key=float)
    any_well, balanced = well_between(potential, around, None), potential.even
    if level or len(heights) == TURNS:  # one hill in a turn
        return in_level_well(any_well, start, top, length)
    if not ridge < top:
        raise UndecidedError("which hill is higher is not told")
    if balanced and not start < top:
        return []
    high_well = well_between(potential, around, top)
    if start > ridge and not balanced:
        return [Line(high_well, swinging(start, top), *within(high_well, start, top, length))]
    found = []
    for up in (False, True):
        path = passing(start, ridge, top, up=up)
        found.append(Line(high_well, path, *above(high_well, path, start, (ridge, top), around, length)))
    if balanced:
        return found
    if not start < ridge:
        raise UndecidedError("whether the clamp is above the ridge is not told")
    return [*found, Line(any_well, swinging(start, ridge), *within(any_well, start, ridge, length))]


def in_level_well(well: Well, start: arb, top: arb, length: arb) -> list[Line]:
    """The families where all hills are as high as the top."""
    if not well.potential.even:
        return [Line(well, swinging(start, top), *within(well, start, top, length))]
    if well.potential.curve(arb(0)) < 0:
        return []  # nothing moves from the highest hill
    low, high = first_below(well, start, top, length), within(well, start, top, length)[1]
    return [Line(well, swinging(start, top), low, high, 2)]
