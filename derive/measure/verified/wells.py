"""Wells of V, and where motions of an energy turn in them; in balls."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

from flint import arb, ctx

from derive.measure.verified.means import Series, UndecidedError
from derive.measure.verified.potential import Potential, Rest

ROUNDS = 200  # of Newton's method with halvings


@dataclass(frozen=True)
class Path:
    """A family of motions by a place y. at(low, high): E and κ with two derivatives, for all places between.

    turns: whether E is least or greatest at y = 0. up: the arrival asked for is that at the upper turning point.
    """

    at: Callable[[float, float], tuple[Series, Series]]
    turns: bool
    up: bool


@dataclass
class Well:
    """Where motions swing: the hills on either side, the last wells before them, and V."""

    potential: Potential
    hills: tuple[arb, arb]
    wells: tuple[arb, arb]
    seen: dict[tuple[Any, ...], arb] = field(default_factory=dict)

    def turning(self, path: Path, place: float, side: int) -> arb:
        """The turning point below (side 0) or above (1) of the motion at a place."""
        key = (path, place, side)
        if key not in self.seen:
            self.seen[key] = self.found(path.at(place, place)[0][0], side)
        return self.seen[key]

    def found(self, energy: arb, side: int) -> arb:
        """The turning point of an energy: Newton's method for the root of the fall from the hill, and a check."""
        sign, hill = (-1, 1)[side], self.hills[side]
        inner = self.wells[side] if sign * self.wells[side] > 0 else arb(0)
        top, low, high = self.potential.value(hill), arb(0), abs(hill - inner).mid()
        goal, whole = (top - energy).mid(), (top - self.potential.value(inner)).mid()
        if not goal > 0:
            raise UndecidedError("an energy is as high as the hill")
        offset = high if goal >= whole else (high * (goal / whole).sqrt()).mid()
        fine = arb(2) ** (-(ctx.prec * 6 // 10))
        for _ in range(ROUNDS):
            angle = hill - sign * offset
            fall, slope = (top - self.potential.value(angle)).mid(), (sign * self.potential.slope(angle)).mid()
            low, high = (offset, high) if fall < goal else (low, offset)
            newton = (offset - 2 * (fall - (fall * goal).sqrt()) / slope).mid() if fall > 0 and slope > 0 else low
            # The last steps may lead out of the bracket by rounding.
            if abs(newton - offset) <= fine * offset:
                break
            offset = newton if low < newton < high else ((low + high) / 2).mid()
        return self.checked(energy, side, offset)

    def checked(self, energy: arb, side: int, offset: arb) -> arb:
        """The ball about an offset from the hill at whose ends V is on either side of the energy."""
        slack = offset * arb(2) ** (-(ctx.prec // 2))
        for _ in range(8):
            ends = [self.hills[side] - (-1, 1)[side] * (offset + part) for part in (-slack, slack)]
            if self.potential.value(ends[0]) > energy and self.potential.value(ends[1]) < energy:
                return ends[0].union(ends[1])
            slack = 64 * slack
        raise UndecidedError("a turning point is not told")


def well_between(potential: Potential, around: list[Rest], top: arb | None) -> Well:
    """The well about the clamp between the nearest hills, or between those as high as the top."""
    hills = [rest.angle for rest in around if rest.hill and not (top and potential.value(rest.angle) < top)]
    low = max((angle for angle in hills if angle < 0), key=float)
    high = min((angle for angle in hills if angle > 0), key=float)
    inner = [rest.angle for rest in around if not rest.hill and low < rest.angle < high]
    return Well(potential, (low, high), (inner[0], inner[-1]))
