"""V about the clamp, and the directions without moment, in balls.

V = c₁ cos θ + s₁ sin θ + c₂ cos 2θ + s₂ sin 2θ, angles measured from the clamp, in units in which β + η = 1.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import pi
from typing import Any

from flint import arb

from derive.measure.reference import Rod
from derive.measure.verified.means import UndecidedError

TURNS = 4  # that are looked at, two before the clamp
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
        sine, cosine = angle.sin_cos()
        double_sine, double_cosine = (2 * angle).sin_cos()
        return (
            self.cosine * cosine + self.sine * sine,
            self.double_cosine * double_cosine + self.double_sine * double_sine,
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
    turns = [Rest(rest.angle + 2 * turn * arb.pi(), rest.hill) for turn in range(-2, TURNS - 2) for rest in found]
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
