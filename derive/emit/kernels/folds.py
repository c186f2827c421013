"""Where equilibria meet and vanish as the field grows, and where two branches of a diagram exchange."""

from __future__ import annotations

from dataclasses import dataclass

from derive.emit.kernels.arithmetic import ceil, frexp, ldexp, log, pi, sqrt
from derive.emit.kernels.equilibria import Rod, bent_rod, principal, reflected
from derive.emit.kernels.extrema import marks
from derive.emit.kernels.search import Crossing
from derive.emit.kernels.tracking import zeros


@dataclass(frozen=True, slots=True)
class Fold:
    """Two equilibria meet, at this η, and vanish on one side of it.

    tip_angle, clamp_curvature, y, z: of the rod there. index: the lower of the two indices that meet; the other one is
    index + 1. change: the number of equilibria just above this η less that just below: 2 or −2. kind: 'fold', or
    'pitchfork' where the two that vanish meet a third one, the straight rod.
    """

    eta: float
    tip_angle: float
    clamp_curvature: float
    y: float
    z: float
    index: int
    change: int
    kind: str


def all_folds(beta, length, clamp_angle, field_angle, low, high):
    """Every fold with η in [low, high], sorted by η and tip angle."""
    scale = frexp(beta + high)[1] // 2
    field = principal(field_angle)
    beta, length = ldexp(beta, -2 * scale), ldexp(length, scale)

    def at(eta, key=None):
        return marks(both_sides(beta, eta, length, clamp_angle, field, scale), key)

    places = steps(beta, length, ldexp(low, -2 * scale), ldexp(high, -2 * scale))
    if not places:
        return []
    found = [fold_at(at, key, eta) for key, eta in zeros(at, places, -beta)]
    return sorted(found, key=lambda item: (item.eta, item.tip_angle))


def both_sides(beta, eta, length, clamp_angle, field, scale):
    """The rod, and its mirror image."""
    return (
        Rod(beta, eta, length, clamp_angle, field, 1, scale),
        Rod(beta, eta, length, -clamp_angle, reflected(field), -1, scale),
    )


def steps(beta, length, low, high):
    """Where to look first. Below (π/2)² = ℓ²(β + η) nothing meets: ∂θ(0)/∂θ(ℓ) cannot vanish so soon (Sturm)."""
    first = pi / 2 / length
    start = max(low, first * first - beta)
    if start >= high:
        return []
    count = ceil(20 * log((beta + high) / (beta + start))) + 2
    ratio = (beta + high) / (beta + start)
    inner = [(beta + start) * ratio ** (k / count) - beta for k in range(1, count)]
    return [start, *(eta for eta in inner if start < eta < high), high]


def fold_at(at, key, eta):
    """The fold of an extremum whose length is the rod's; a step of Newton's method sharpens η."""
    mark = at(eta, key)[key]
    mark = at(eta - mark.height / mark.slope, key)[key]
    rod, sign, swings, top = mark.rod, *key[5:8]
    index = 2 * swings - (sign < 0)
    found = bent_rod(rod, mark.turns, mark.piece, Crossing(mark.place, swings, sign, True), index)
    change = 2 if (mark.slope > 0) == top else -2
    eta = ldexp(rod.eta, 2 * rod.scale)
    return Fold(eta, found.tip_angle, found.clamp_curvature, found.y, found.z, index, change, "fold")
