"""Where equilibria meet and vanish as the field grows."""

from __future__ import annotations

from typing import NamedTuple

from derive.emit.kernels.arithmetic import ceil, epsilon, frexp, inf, ldexp, log, pi, roughly, sqrt
from derive.emit.kernels.bent_rods import bent_rod
from derive.emit.kernels.extrema import marks
from derive.emit.kernels.ground import clamp_in
from derive.emit.kernels.landscape import landscape
from derive.emit.kernels.rods import Rod
from derive.emit.kernels.search import Crossing
from derive.emit.kernels.sides import principal, reflected
from derive.emit.kernels.straight_rods import direction
from derive.emit.kernels.time_map import delays, sample_at
from derive.emit.kernels.tracking import LEAST, nearest, zeros


class Fold(NamedTuple):
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
    index: int  # type: ignore[assignment]  # in the place of tuple.index
    change: int
    kind: str


def all_folds(beta, length, clamp_angle, field_angle, low, high):
    """Every fold with η in [low, high], sorted by η and tip angle."""
    scale = frexp(beta + high)[1] // 2
    field = principal(field_angle)
    beta, length = ldexp(beta, -2 * scale), ldexp(length, scale)
    places = steps(beta, beta, length, ldexp(low, -2 * scale), ldexp(high, -2 * scale))
    if not places:
        return []

    def at(eta, key):
        return marks(both_sides(beta, eta, length, clamp_angle, field, scale), key)

    rough = roughly(lambda: zeros(at, places, -beta, LEAST))
    found = [fold_of(sharpened(at, mark)) for mark in rough]
    found += pitchforks(beta, length, clamp_angle, field, scale, places)
    return sorted(found, key=lambda item: (item.eta, item.tip_angle))


def both_sides(beta, eta, length, clamp_angle, field_angle, scale):
    """The rod, and its mirror image."""
    return (
        Rod(beta, eta, length, clamp_angle, field_angle, 1, scale),
        Rod(beta, eta, length, -clamp_angle, reflected(field_angle), -1, scale),
    )


def steps(beta, soonest, length, low, high):
    """The η to look at first, from where ``soonest``, the largest force, lets equilibria meet; beta: the least one.

    As long as ℓ²(β + η) < (π/2)² nothing meets: ∂θ(0)/∂θ(ℓ) has no zero yet (Sturm).
    """
    first = pi / 2 / length
    start, offset = max(low, first * first - soonest), max(beta, first * first)
    if start >= high:
        return []
    ratio = (offset + high) / (offset + start)
    count = ceil(20 * log(ratio)) + 2
    inner = [(offset + start) * ratio ** (k / count) - offset for k in range(1, count)]
    return [start, *(eta for eta in inner if start < eta < high), high]


def sharpened(at, mark):
    """The extremum where its length is the rod's, by Newton's method: η then has no error of its own.

    A step squares the error, so after one below the root of rounding there is none left; but not the first, for the
    extremum may have been found in few digits.
    """
    mark = nearest(at(mark.rod.eta, mark.key), mark.key, mark.spot) or mark
    step, least = inf, sqrt(epsilon()) * (mark.rod.beta + mark.rod.eta)
    while abs(step) > least:
        last, step = step, mark.height / mark.slope
        if 2 * abs(step) > abs(last):  # beside an exchange there is no slope to tell more
            return mark
        mark = nearest(at(mark.rod.eta - step, mark.key), mark.key, mark.spot) or mark
    return mark


def fold_of(mark):
    """The fold of an extremum whose length is the rod's."""
    rod, top = mark.rod, mark.group[-1]
    found = rod_of(mark)
    change = 2 if (mark.slope > 0) == top else -2
    eta = ldexp(rod.eta, 2 * rod.scale)
    return Fold(eta, found.tip_angle, found.clamp_curvature, found.y, found.z, found.index, change, "fold")


def rod_of(mark):
    """The equilibrium of an extremum."""
    _, sign, swings, _ = mark.group
    index = 2 * swings - (1 if sign < 0 else 0)
    rod, piece = mark.rod, mark.piece
    sample = sample_at(rod.beta, rod.eta, rod.field_angle, piece, delays(piece), mark.place)
    return bent_rod(rod, mark.turns, piece, Crossing(sample, swings, sign, True), index)


def pitchforks(beta, length, clamp_angle, field_angle, scale, places):
    """Where the rod that stays straight buckles: ℓ√(−dθ″/dθ) is an odd number of quarter turns.

    The clamp angle is without moment for every η only where the rod is symmetric about it, and then the bent rods
    come in pairs. Near it u″ = (B + C)u − (B + 4C)u³/6 + (B + 16C)u⁵/120 with B = β cos θ₀, C = η cos 2(θ₀ − α): the
    signs say whether the half-swing grows with the amplitude.
    """
    some = places[0], places[len(places) // 2], places[-1]
    rests = [straight_at(beta, eta, clamp_angle, field_angle) for eta in some]
    if any(rest is None for rest in rests):
        return []
    cosine, sine = direction(rests[-1])
    force, facing = beta * cosine, 1 if rests[-1].double_cosine > 0 else -1
    found, index = [], 0
    while index <= length * sqrt(beta + places[-1]) / pi:
        wave = (index + 0.5) * pi / length
        eta = -facing * (wave * wave + force)
        if places[0] <= eta <= places[-1]:
            cubic = force + 4 * facing * eta
            softening = cubic < 0 if cubic != 0 else force + 16 * facing * eta > 0
            change = 2 if softening == (facing < 0) else -2
            extent = ldexp(length, -scale)
            at = (clamp_angle, 0 * extent, cosine * extent, sine * extent)
            found.append(Fold(ldexp(eta, 2 * scale), *at, index, change, "pitchfork"))
        index += 1
    return found


def straight_at(beta, eta, clamp_angle, field_angle):
    """The direction without moment that is the clamp angle; None if there is none."""
    rests = landscape(beta, eta, field_angle).rests
    offsets = clamp_in(rests, clamp_angle).offsets
    return next((rest for rest, offset in zip(rests, offsets, strict=True) if offset == 0), None)
