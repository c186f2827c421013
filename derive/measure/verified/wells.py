"""V, its hills and wells, and where motions of an energy turn; in balls.

V = c₁ cos θ + s₁ sin θ + c₂ cos 2θ + s₂ sin 2θ, angles measured from the clamp, in units in which β + η = 1.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from math import pi
from typing import Any

from flint import arb, ctx

from derive.measure.reference import Rod
from derive.measure.verified.means import Series, UndecidedError

ROUNDS = 200  # of Newton's method with halvings
START = 0.1234  # where a turn begins that is looked through for directions without moment
NARROWEST = 1e-9  # parts of it that are cut no more
CUT = 0.4871  # not half, so that no special angle is met


@dataclass(frozen=True)
class Rest:
    """A direction without moment. hill: V is greatest there."""

    angle: arb
    hill: bool


@dataclass(frozen=True)
class Potential:
    """V, by the coefficients of its two harmonics."""

    cosine: arb
    sine: arb
    double_cosine: arb
    double_sine: arb

    def harmonics(self, angle: Any) -> tuple[Any, Any]:
        """The two parts of V."""
        double = 2 * angle
        return (
            self.cosine * angle.cos() + self.sine * angle.sin(),
            self.double_cosine * double.cos() + self.double_sine * double.sin(),
        )

    def value(self, angle: Any) -> Any:
        """V."""
        one, two = self.harmonics(angle)
        return one + two

    def slope(self, angle: Any) -> Any:
        """V′."""
        one, two = self.turned.harmonics(angle)
        return one + 2 * two

    def curve(self, angle: Any) -> Any:
        """V″."""
        one, two = self.harmonics(angle)
        return -one - 4 * two

    @property
    def turned(self) -> Potential:
        """The harmonics of V′, the second one halved."""
        return Potential(self.sine, -self.cosine, self.double_sine, -self.double_cosine)

    @property
    def even(self) -> bool:
        """Whether V is even about the clamp, which then is a direction without moment."""
        return bool(self.sine == 0 and self.double_sine == 0)

    @property
    def mirrored(self) -> Potential:
        """V with angles counted the other way."""
        return Potential(self.cosine, -self.sine, self.double_cosine, -self.double_sine)


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
            before, offset = offset, ((low + high) / 2).mid()
            if fall > 0 and slope > 0:
                newton = (before - 2 * (fall - (fall * goal).sqrt()) / slope).mid()
                offset = newton if low <= newton <= high else offset
            if abs(offset - before) <= fine * offset:
                break
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


def scaled(rod: Rod) -> tuple[Potential, arb, bool]:
    """V about the clamp angle in units in which β + η = 1, the length, and whether all hills are as high.

    Angles that are whole quarter turns but for rounding are meant to be those.
    """
    softness = arb(rod.beta) + arb(rod.eta)
    clamp, field = half_turns(rod.clamp_angle), half_turns(rod.field_angle)
    lean = arb(0) if rod.clamp_angle == rod.field_angle else 2 * (clamp - field)
    force, quarter = arb(rod.beta) / softness, arb(rod.eta) / (4 * softness)
    potential = Potential(
        force * clamp.cos_pi(), -force * clamp.sin_pi(), quarter * lean.cos_pi(), -quarter * lean.sin_pi()
    )
    return potential, arb(rod.length) * softness.sqrt(), bool(rod.beta == 0 or (2 * field).cos_pi() == -1)


def half_turns(angle: float) -> arb:
    """An angle over π."""
    quarters = round(angle / (pi / 2))
    return arb(quarters) / 2 if quarters * (pi / 2) == angle else arb(angle) / arb.pi()


def rests(potential: Potential) -> list[Rest]:
    """Directions without moment, ascending, over two turns either way."""
    found, parts = [], [(arb(START), arb(START) + 2 * arb.pi())]
    while parts:
        low, high = parts.pop()
        ball, middle = low.union(high), (low + CUT * (high - low)).mid()
        curve = potential.curve(ball)
        slope = potential.slope(middle) + curve * (ball - middle)
        if slope > 0 or slope < 0:
            continue
        if curve > 0 or curve < 0:
            first, last = (potential.slope(end) for end in (low, high))
            if not all(end > 0 or end < 0 for end in (first, last)):
                raise UndecidedError("a direction without moment is not told")
            if (first > 0) != (last > 0):
                found.append(Rest(settled(potential, ball), bool(curve < 0)))
            continue
        if ball.rad() < NARROWEST:
            raise UndecidedError("two directions without moment all but meet")
        parts += [(low, middle), (middle, high)]
    turns = [Rest(rest.angle + 2 * turn * arb.pi(), rest.hill) for turn in (-2, -1, 0, 1) for rest in found]
    return sorted(turns, key=lambda rest: float(rest.angle))


def settled(potential: Potential, ball: arb) -> arb:
    """The one zero of V′ in a ball, by Newton's method of intervals."""
    for _ in range(200):
        middle = ball.mid()
        closer = (middle - potential.slope(middle) / potential.curve(ball)).intersection(ball)
        if not closer.rad() < 0.9 * ball.rad():
            return closer
        ball = closer
    return ball


def well_between(potential: Potential, around: list[Rest], top: arb | None) -> Well:
    """The well about the clamp between the nearest hills, or between those as high as the top."""
    hills = [rest.angle for rest in around if rest.hill and not (top and potential.value(rest.angle) < top)]
    low = max((angle for angle in hills if angle < 0), key=float)
    high = min((angle for angle in hills if angle > 0), key=float)
    inner = [rest.angle for rest in around if not rest.hill and low < rest.angle < high]
    return Well(potential, (low, high), (inner[0], inner[-1]))
