"""The numerical statements of the two examples, certified by ball arithmetic.

count          beta, eta, number: so many equilibria
kinds          through, past: of these rods the equilibrium at η = 0 leads through the straight rod, or past it
transition     between: at the first β it leads through, at the second past
effect         betas, effect: a growing field makes the displacement fall to 0 and on, or makes it grow
bifurcations   inside, outside: there is an η below which the first have got `pairs` pairs of new equilibria, and the
               second no others than the one that they have at η = 0
shrinks        betas, share: the displacement falls with the field, to this share of what it was

A rod is straight, θ = θ(0), in the field η = −β/cos θ(0), for then θ″ = sin θ (β + η cos θ) = 0; no other field leaves
a tip at θ(0). There the displacement is 0. If up to a field beyond this one there is one equilibrium only, the curve of
equilibria leads through the straight rod. If there is a tip between those of the rod at η = 0 and of the straight rod
that is no equilibrium in any of these fields, it leads past it.
"""

from __future__ import annotations

from fractions import Fraction
from functools import cache

import numpy as np

from derive.check import balls
from derive.check.balls import Ball
from derive.check.counting import alone, barrier, count
from derive.check.shooting import Rod, gaps, shoot

BEYOND = Fraction(51, 50)  # of the field in which the rod is straight
SHORT = Fraction(3, 4)  # of that field: as far as an increment is looked for
FIELDS = [Fraction(k, 10_000) for k in range(4, 16)]  # ends of regions that are tried
QUARTER = (0.0, np.pi / 2)  # between these the tip of the first example stays
CUTS = 64


@cache
def straight_field(rod: Rod) -> Fraction:
    """A field a little greater than the one in which the rod is straight."""
    cosine = balls.sine_cosine(rod.clamp_angle)[1]
    return Fraction(float((balls.rational(rod.beta) / -cosine).upper())) * BEYOND


@cache
def kind(rod: Rod) -> str:
    """How the equilibrium at η = 0 goes on: through the straight rod, past it, or undecided."""
    if rod.beta == 0:
        return "through" if count(rod, Fraction(0)) == 1 else ""  # it is the straight rod
    if alone(rod, Fraction(0), straight_field(rod)):
        return "through"
    start = tip(rod, Fraction(0), (0.0, float(rod.clamp) * np.pi))
    if count(rod, Fraction(0)) == 1 and start is not None:
        wall = barrier(rod, straight_field(rod), (float(start.upper()[0]), float(rod.clamp_angle.lower())))
        return "past" if wall is not None else ""
    return ""


@cache
def effect(rod: Rod) -> str:
    """What a growing field does to the displacement, or undecided: up to the field of the straight rod, or near it."""
    if alone(rod, Fraction(0), straight_field(rod), sense=-1):
        return "reduction, then inversion"
    start = tip(rod, Fraction(0), (0.0, float(rod.clamp) * np.pi))
    bent = start is not None and bool(np.all(shoot(rod, start, rod.fields(Fraction(0), Fraction(0))).sag.sign() == 1))
    if bent and alone(rod, Fraction(0), straight_field(rod) * SHORT, sense=1):
        return "increment"
    return ""


def tip(rod: Rod, eta: Fraction, tips: tuple[float, float]) -> Ball | None:
    """The tip between two angles where the gap changes its sign, narrowly enclosed."""
    low, high = tips
    field = rod.fields(eta, eta)
    for _ in range(3):
        angles = np.linspace(low, high, CUTS + 1)
        signs = gaps(rod, angles, Ball(field.mid + 0 * angles, field.rad + 0 * angles)).sign()
        below, above = np.nonzero(signs < 0)[0], np.nonzero(signs > 0)[0]
        if not below.size or not above.size or below.max() > above.min():
            return None
        low, high = float(angles[below.max()]), float(angles[above.min()])
    return balls.between(np.array([low]), np.array([high]))


@cache
def share_left(rod: Rod, eta: Fraction) -> float | None:
    """An upper bound of the displacement over its value without a field; None if they are not enclosed."""
    found = [tip(rod, one, QUARTER) for one in (Fraction(0), eta)]
    if found[0] is None or found[1] is None:
        return None
    first, last = (shoot(rod, t, rod.fields(e, e)).sag for t, e in zip(found, (Fraction(0), eta), strict=True) if t)
    return float((last / first).upper()[0])


def region(inside: tuple[Rod, ...], outside: tuple[Rod, ...], number: int) -> Fraction | None:
    """An end of the region of fields that makes the claim on bifurcations true."""
    for eta in FIELDS:
        if all(count(rod, eta) == number for rod in inside):
            return eta if all(alone(rod, Fraction(0), eta) for rod in outside) else None
    return None


def exchanged(inside: tuple[Rod, ...], outside: tuple[Rod, ...]) -> Fraction | None:
    """A field up to which one of the first has no new equilibria, while one of the second has: no region will do."""
    for eta in FIELDS:
        if any((count(rod, eta) or 1) > 1 for rod in outside):
            return eta if any(alone(rod, Fraction(0), eta) for rod in inside) else None
    return None
