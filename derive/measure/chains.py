"""A rod of any length cut into pieces, and shot from its tip along the first integral.

Plain shooting loses ℓ√(β + η)/ln 10 digits, and so does multiple shooting: where a long rod lingers at two directions
of rest, the place of its bend between them is held only by forces of e^{−2d}, with d the lengths of lingering. What is
held fast is the constant of the motion E. So the unknown is E over that direction of rest where it is smallest, as a
number of any exponent; each piece (scaled length ≤ 1, `segments`) starts from its own nearest direction of rest; after
each piece the state is put back on its level ½θ_σ² + W(δ) = E, and g = ∂θ/∂E on θ_σ g_σ − θ″ g = 1. These corrections
are at the last digit carried: that they are is checked, so the pieces solve the equation of equilibrium by themselves.

Rods with ℓ√(β + η) ≤ 1 start from the clamp angle instead, with the tip's deflection as the unknown, however weak the
load; and straight ones from their direction, with δ at the tip, which is 0.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from itertools import pairwise
from math import ceil, log, pi, sqrt
from typing import Any

import numpy as np
from mpmath import mp, mpf

from derive.measure.guesses import guessed
from derive.measure.reference import NoEquilibriumError, Rod
from derive.measure.rests import Rest, rests
from derive.measure.segments import Base, Load

# Below this square of δ the tip is found from the square alone, and by some more of Newton's steps.
SMALL = 1e-6
MOST_TURNS = 40

# θ and θ′ at arc lengths from the clamp, as the `shape` of an emitted module gives them.
Guess = Callable[[Any], tuple[Any, Any]]


@dataclass(frozen=True)
class Node:
    """A point of the rod: its base direction, and (δ, dδ/dσ) from there, scaled."""

    base: int
    delta: Any
    rate: Any


@dataclass(frozen=True)
class Shot:
    """A rod from its tip: nodes from there on, ∂θ(0)/∂unknown, zeros of it on the way, integrals of the pieces.

    response: the greatest ∂(state)/∂unknown over the size of the state. correction: the greatest one that brought a
    state back to its level, over its size.
    """

    nodes: list[Node]
    slope: Any
    index: int
    places: list[tuple[Any, Any, Any]]
    response: Any
    correction: float


@dataclass(frozen=True)
class Chain:
    """A rod cut into pieces, with its unknown.

    rests: the base directions, the clamp angle alone if the rod is weak. level: which of them E is measured from.
    unknown: E there, or δ at the tip if the rod is weak or straight (direct). tip: the tip's base direction. near:
    about δ there. side: the sign of θ″ there.
    """

    rod: Rod
    load: Load
    count: int
    rests: list[Rest]
    weak: bool
    direct: bool
    level: int
    unknown: Any
    tip: int
    near: float
    side: int

    @classmethod
    def of(cls, rod: Rod, guess: Guess) -> Chain:
        """From an approximate shape."""
        load = Load.of(rod)
        count = 4 * max(1, ceil(float(load.length) / 4))
        fractions = np.arange(count, -1, -1) / count
        theta, curvature = (np.asarray(part, dtype=float) for part in guess(fractions * rod.length))
        rates = curvature / -float(load.scale)
        if rod.length * sqrt(rod.beta + rod.eta) <= 1:
            deflection = mpf(float(theta[0])) - mpf(rod.clamp_angle)
            return cls(rod, load, count, [clamped(rod)], True, True, 0, deflection, 0, 0.0, 1)
        bases = rests(load, theta.min() - pi, theta.max() + pi)
        found = guessed(bases, theta, rates, float(load.length), rod.clamp_angle)
        return cls(rod, load, count, bases, False, not found.energy, *vars(found).values())

    def moved(self, step: Any) -> Chain:
        """With the unknown moved: E by a factor, the deflection by a sum."""
        return replace(self, unknown=self.unknown + step if self.direct else self.unknown * mp.exp(step))

    def loaded(self, rod: Rod) -> Chain:
        """Another rod, whose directions of rest are near by, with the same unknown."""
        load = Load.of(rod)
        if self.weak:
            return replace(self, rod=rod, load=load, rests=[clamped(rod)])
        low, high = (float(self.rests[k].angle) for k in (0, -1))
        bases = rests(load, low - 1e-3, high + 1e-3)
        return replace(self, rod=rod, load=load, rests=bases)

    def energy(self, base: int) -> Any:
        """E over a base direction."""
        if base == self.level:
            return self.unknown
        return self.unknown + (self.rests[self.level].height - self.rests[base].height)

    def start(self) -> Node:
        """The tip: at rest, on its level."""
        if self.direct:
            return Node(self.tip, self.unknown, mpf(0))
        return Node(self.tip, turning_point(self.rests[self.tip], self.energy(self.tip), self.near, self.side), mpf(0))

    def shoot(self, digits: int, more_terms: int = 0) -> Shot:
        """From the tip to the clamp; integrals and states with so many digits."""
        bases: dict[int, Base] = {}
        node = self.start()
        g = (mpf(1) if self.direct else -1 / self.moment(node), mpf(0))
        nodes, places, index, worst = [node], [], 0, 0.0
        response = _share(g[0], node)
        for length in self.lengths(digits):
            if node.base not in bases:
                bases[node.base] = Base(self.load, +self.rests[node.base].angle, not self.weak, digits, more_terms)
            piece = bases[node.base].piece((node.delta, node.rate), length)
            a, b, c, d = piece.matrix
            before, g = g, (a * g[0] + b * g[1], c * g[0] + d * g[1])
            node = Node(node.base, *piece.end)
            if not self.direct:
                node, g, correction = on_level(self.rests[node.base], self.energy(node.base), node, g)
                worst = max(worst, correction)
                node = self.nearest(node)
            index += bool(g[0]) and (g[0] > 0) != (before[0] > 0)
            nodes.append(node)
            places.append((piece.y, piece.z, piece.energy))
            response = max(response, _share(g[0], node))
        return Shot(nodes, g[0], index, places, response, worst)

    def moment(self, node: Node) -> Any:
        """θ″ there, scaled."""
        return self.rests[node.base].rise_and_moment(node.delta)[1]

    def lengths(self, digits: int) -> list[int]:
        """Of the pieces, in units of the last bit of `Base`; they add up to the rod."""
        whole = int(mp.nint(mp.ldexp(self.load.length, ceil(digits * log(10, 2)))))
        ends = [whole * j // self.count for j in range(self.count + 1)]
        return [after - before for before, after in pairwise(ends)]

    def nearest(self, node: Node) -> Node:
        """The same state, from the direction of rest nearest to it."""
        best = node.base
        for other in (node.base - 1, node.base + 1):
            if 0 <= other < len(self.rests):
                gap = self.rests[node.base].angle - self.rests[other].angle
                if abs(node.delta + gap) < abs(node.delta):
                    best = other
        if best == node.base:
            return node
        return Node(best, node.delta + self.rests[node.base].angle - self.rests[best].angle, node.rate)

    def step(self, shot: Shot) -> tuple[Any, float]:
        """What Newton's method changes the unknown by, and the greatest change of a state by it, over its size."""
        last = shot.nodes[-1]
        miss = last.delta - (mpf(self.rod.clamp_angle) - self.rests[last.base].angle)
        if not miss:
            return mpf(0), 0.0
        if not shot.slope:
            raise NoEquilibriumError(f"the rod is at a fold to the last digit: {self.rod}")
        step = -miss / shot.slope
        return step if self.direct else step / self.unknown, float(abs(step) * shot.response)


def _share(g: Any, node: Node) -> Any:
    """|g| over the size of a state, which is 0 on a straight rod alone."""
    size = max(abs(node.delta), abs(node.rate))
    return abs(g) / size if size else mpf(0)


def clamped(rod: Rod) -> Rest:
    """The clamp angle as a base direction; it is not at rest, and no level is measured from it."""
    return Rest(mpf(rod.clamp_angle), mpf(1), mpf(0), mpf(0), mpf(0), mpf(0))


def turning_point(rest: Rest, energy: Any, near: float, side: int) -> Any:
    """The δ where W is E and θ″ has the sign `side`: near the one given or, if E is small, by the square in W."""
    small = 2 * energy / -rest.stiffness
    if abs(small) < SMALL:
        if small < 0:
            raise NoEquilibriumError(f"no turning point at E = {mp.nstr(energy, 5)} near {mp.nstr(rest.angle, 5)}")
        delta = (side if rest.stiffness > 0 else -side) * mp.sqrt(small)
    else:
        delta = mpf(near)
    for _ in range(MOST_TURNS):
        rise, moment = rest.rise_and_moment(delta)
        if not moment:
            break
        step = (rise - energy) / moment
        delta += step
        if abs(step) <= abs(delta) * mpf(10) ** (-mp.dps // 2 - 3):
            return delta
    raise NoEquilibriumError(f"no turning point at E = {mp.nstr(energy, 5)} near {mp.nstr(rest.angle + near, 12)}")


def on_level(rest: Rest, energy: Any, node: Node, g: tuple[Any, Any]) -> tuple[Node, tuple[Any, Any], float]:
    """The nearest state with ½rate² + W(δ) = E, and (g, g′) with rate·g′ − θ″ g = 1; how far the state was from there.

    One step of Newton's method each: it squares what is off by the last digit carried.
    """
    rise, moment = rest.rise_and_moment(node.delta)
    steepness = moment**2 + node.rate**2
    if not steepness:
        return node, g, 0.0
    excess = (node.rate**2 / 2 + rise - energy) / steepness
    step = (excess * moment, -excess * node.rate)
    flux = (node.rate * g[1] - moment * g[0] - 1) / steepness
    change = max(abs(step[0]), abs(step[1])) / max(abs(node.delta), abs(node.rate))
    moved = Node(node.base, node.delta + step[0], node.rate + step[1])
    return moved, (g[0] + flux * moment, g[1] - flux * node.rate), float(change)
