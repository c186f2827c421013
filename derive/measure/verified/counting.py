"""How many equilibria a rod has, proved by ball arithmetic, for any field angle and length.

A rod starts at the clamp angle with a curvature κ, at the energy E = ½κ² + V. The first turning point ahead is reached
after τ(κ), and others follow every half-swing H(E): rods whose tip is one of them are the equilibria. So these are the
κ at which (ℓ − τ)/H is a whole number, on a few lines of motions (`lines`), along each of which it is smooth.
In cells of the place in which it is no whole number there is none; in those where its derivative keeps its sign the
ends tell how many there are; others are cut. Beyond the first and the last cell a motion rests near a hill for longer
than the rod: before the turning point ahead, or, where that is reached before the rod's end, or after it, at all
energies there, before the next one. So nothing is there.

All numbers are enclosed in balls (python-flint): the count is proved, but for faults of the programs.
"""

from __future__ import annotations

from itertools import pairwise
from math import ceil, sqrt

from flint import arb, ctx

from derive.measure.reference import Rod
from derive.measure.verified.lines import Line, lines
from derive.measure.verified.means import UndecidedError
from derive.measure.verified.motion import ORDER, times
from derive.measure.verified.potential import scaled

WIDEST = 0.5  # cells at first
NARROWEST = 1e-9  # cells that are cut no more
CUT = 0.4871  # not half, so that no special place is met
BITS, BITS_FOR_LENGTH = 96, 12  # of the numbers; places near a hill need more


def count(rod: Rod) -> int | None:
    """The number of equilibria; None if the balls do not tell, as of a rod at a fold."""
    before = ctx.prec, ctx.cap
    ctx.prec, ctx.cap = BITS + int(BITS_FOR_LENGTH * rod.length * sqrt(rod.beta + rod.eta)), ORDER
    try:
        return _count(rod)
    except UndecidedError:
        return None
    finally:
        ctx.prec, ctx.cap = before


def _count(rod: Rod) -> int:
    potential, length, level = scaled(rod)
    moment = potential.slope(arb(0))
    if moment < 0:
        potential = potential.mirrored
    elif not (moment > 0 or potential.even):
        raise UndecidedError("whether the clamp is a direction without moment is not told")
    straight = 1 if potential.even else 0
    return straight + sum(line.sides * crossed(line, length) for line in lines(potential, length, level=level))


def crossed(line: Line, length: arb) -> int:
    """How often the number of half-swings is whole on a line."""
    floors: dict[float, int] = {}

    def floor(place: float) -> int:
        if place not in floors:
            whole = at_place(line, length, place).floor().unique_fmpz()
            if whole is None:
                raise UndecidedError("whether a number of half-swings is whole is not told")
            floors[place] = int(whole)
        return floors[place]

    number, edge = 0, ceil((line.high - line.low) / WIDEST)
    cuts = [line.low + (line.high - line.low) * k / edge for k in range(edge + 1)]
    todo = list(pairwise(cuts))
    while todo:
        low, high = todo.pop()
        kind = judged(line, length, low, high)
        if kind == "monotone":
            number += abs(floor(high) - floor(low))
        elif kind == "open":
            if high - low < NARROWEST:
                raise UndecidedError("two equilibria all but meet")
            middle = low + CUT * (high - low)
            todo += [(low, middle), (middle, high)]
    return number


def judged(line: Line, length: arb, low: float, high: float) -> str:
    """Of a cell: whether the number of half-swings is nowhere whole there, or monotone, or neither is told."""
    try:
        arrival, swing = times(line.well, line.path, low, high)
    except UndecidedError:
        return "open"
    number = (length - arrival[0]) / swing[0]
    if not number.contains_integer():
        return "empty"
    slope = arrival[1] + number * swing[1]
    if slope > 0 or slope < 0:
        return "monotone"
    # Beside a fold the number hardly changes, though both lengths do.
    middle = (low + high) / 2
    aside = arb(low).union(arb(high)) - middle
    near = at_place(line, length, middle) - slope / swing[0] * aside
    return "open" if near.contains_integer() else "empty"


def at_place(line: Line, length: arb, place: float) -> arb:
    """The number of half-swings at one place."""
    arrival, swing = times(line.well, line.path, place, place)
    return (length - arrival[0]) / swing[0]
