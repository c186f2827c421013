"""Which tips make a rod in equilibrium: the angle that it reaches at the clamp, less the clamp's, enclosed.

Tips of a rod whose field lies along the force are in (0, 2π) if its clamp is. For U = β cos θ + (η/4) cos 2θ, the sum
½θ′² + U is constant, and U is greatest at the multiples of 2π: a rod whose tip lies between two of them stays there.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction

from derive.check import balls
from derive.check.balls import Array, Ball, rational
from derive.check.rod_flow import integrate


@dataclass(frozen=True)
class Rod:
    """A rod without its field. clamp: θ(0) over π. across: the field is across the force, else along it."""

    length: Fraction
    clamp: Fraction
    beta: Fraction
    across: bool = False

    @property
    def force(self) -> Ball:
        """B = βℓ²."""
        return rational(self.beta * self.length**2)

    @property
    def clamp_angle(self) -> Ball:
        """θ(0)."""
        return balls.pi() * rational(self.clamp)

    def field(self, eta: Fraction) -> Fraction:
        """H = ±ηℓ², as in ``rod_flow``."""
        return (-1 if self.across else 1) * eta * self.length**2

    def fields(self, low: Fraction, high: Fraction) -> Ball:
        """H for all η from low to high, also if that is one number."""
        ends = [rational(self.field(eta)) for eta in (low, high)]
        return balls.between(min(end.lower() for end in ends), max(end.upper() for end in ends))


@dataclass(frozen=True)
class Shot:
    """What tips and fields in boxes arrive at. gap: angle at the clamp less the clamp's. sag: displacement of the tip.

    The sag is over ℓ, along the normal of the straight rod on the side of the force: y sin θ(0) − z cos θ(0).
    by_tip and by_field (H) are the derivatives.
    """

    gap: Ball
    gap_by_tip: Ball
    gap_by_field: Ball
    sag: Ball
    sag_by_tip: Ball
    sag_by_field: Ball


@balls.unbounded
def shoot(rod: Rod, tips: Ball, fields: Ball) -> Shot:
    """Enclosures over boxes, by the mean value theorem: the middle, and the derivatives over the box."""
    wide = integrate(tips, rod.force, fields)
    middle = integrate(balls.exactly(tips.mid), rod.force, balls.exactly(fields.mid), derivatives=False)
    sine, cosine = balls.sine_cosine(rod.clamp_angle)
    by_tip, by_field = _sag(wide.by_tip, sine, cosine), _sag(wide.by_field, sine, cosine)
    angle, sag = middle.angle - rod.clamp_angle, _sag({"y": middle.y, "z": middle.z}, sine, cosine)
    aside, field = Ball(0 * tips.mid, tips.rad), Ball(0 * fields.mid, fields.rad)
    return Shot(
        angle + wide.by_tip["angle"] * aside + wide.by_field["angle"] * field,
        wide.by_tip["angle"],
        wide.by_field["angle"],
        sag + by_tip * aside + by_field * field,
        by_tip,
        by_field,
    )


def _sag(of: dict[str, Ball], sine: Ball, cosine: Ball) -> Ball:
    return of["y"] * sine - of["z"] * cosine


def gaps(rod: Rod, tips: Array, fields: Ball) -> Ball:
    """The gap at single tips; the field may be a box."""
    return integrate(balls.exactly(tips), rod.force, fields, derivatives=False).angle - rod.clamp_angle
