"""Where to start: the constant of the motion of an approximate shape, also where doubles do not show it.

A rod that lingers at an unstable direction of rest is a sum of e^{κσ} and e^{−κσ} there, κ² = dθ″/dθ. What grows,
p = δ′ + κδ, is seen where it leaves, what decays, q = δ′ − κδ, where it arrives; and E = ½ p q at one place is the
product of the two with e^{−κ·time}, however small that is.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import groupby
from typing import Any

import numpy as np
from mpmath import mp, mpf
from numpy.typing import NDArray

from derive.measure.rests import Rest

Array = NDArray[np.float64]
NEAR = 1e-5  # so near to a direction of rest the equation is linear to about 1e-5, and doubles see p and q to 1e-11
STRAIGHT = 1e-11  # and so near to it all along, a rod has no other shape than that of the linear equation


@dataclass(frozen=True)
class Guessed:
    """E over the direction of rest number `level`; the tip's own one, its δ, and the sign of θ″ there."""

    level: int
    energy: Any
    tip: int
    delta: float
    side: int


@dataclass(frozen=True)
class Stay:
    """Nodes first … last are near the unstable direction number base."""

    base: int
    first: int
    last: int


def guessed(bases: Sequence[Rest], theta: Array, rates: Array, length: float, clamp_angle: float) -> Guessed:
    """From angles and scaled rates at equal distances, from the tip on."""
    places = np.array([float(rest.angle) for rest in bases])
    nearest = np.argmin(np.abs(theta[:, None] - places), axis=1)
    delta = theta - places[nearest]
    tip, clamp = int(nearest[0]), int(nearest[-1])
    offset = mpf(clamp_angle) - bases[clamp].angle
    side = _sign(float(bases[tip].rise_and_moment(mpf(float(delta[0])))[1]))
    size = np.maximum(np.abs(delta), np.abs(rates))
    if np.all(size < STRAIGHT) and np.all(nearest == tip):
        return _straight(bases[tip], tip, offset, length)
    stays = _stays(bases, nearest, size)
    if stays and stays[0].first == 0:  # δ at the tip may be below all doubles; what grows from it is not
        side = _sign(_grown(bases[stays[0].base], delta, rates, stays[0].last))
    if not stays:
        level, energy = _plain(bases, nearest, delta, rates)
        return Guessed(level, energy, tip, float(delta[0]), side)
    stay = max(stays, key=lambda one: one.last - one.first)
    rest, step = bases[stay.base], length / (len(theta) - 1)
    kappa = mp.sqrt(rest.stiffness)
    p = _grown(rest, delta, rates, stay.last)
    q = mpf(float(rates[stay.first])) - kappa * mpf(float(delta[stay.first]))
    fade = mp.exp(-kappa * step * (stay.last - stay.first))
    if stay.first == 0:
        q = -p * fade
    elif stay.last == len(theta) - 1:
        p = 2 * kappa * offset + q * fade
    return Guessed(stay.base, p * q * fade / 2, tip, float(delta[0]), side)


def _grown(rest: Rest, delta: Array, rates: Array, at: int) -> Any:
    """p at a node."""
    return mpf(float(rates[at])) + mp.sqrt(rest.stiffness) * mpf(float(delta[at]))


def _straight(rest: Rest, tip: int, offset: Any, length: float) -> Guessed:
    """The linear equation along the whole rod."""
    kappa = mp.sqrt(abs(rest.stiffness))
    delta = offset / (mp.cosh if rest.stiffness > 0 else mp.cos)(kappa * length)
    return Guessed(tip, -rest.stiffness * delta**2 / 2, tip, float(delta), _sign(rest.stiffness * delta))


def _stays(bases: Sequence[Rest], nearest: NDArray[np.intp], size: Array) -> list[Stay]:
    """All the stretches near an unstable direction."""
    labels = [
        int(base) if at < NEAR and bases[base].stiffness > 0 else -1 for base, at in zip(nearest, size, strict=True)
    ]
    found, first = [], 0
    for base, group in groupby(labels):
        number = len(list(group))
        if base >= 0:
            found.append(Stay(base, first, first + number - 1))
        first += number
    return found


def _plain(bases: Sequence[Rest], nearest: NDArray[np.intp], delta: Array, rates: Array) -> tuple[int, Any]:
    """E where doubles show it: over the direction where it is smallest, the median of what its own nodes say."""
    found = []
    for base in np.unique(nearest):
        rest, own = bases[base], nearest == base
        sine, versine = np.sin(delta[own]), 2 * np.sin(delta[own] / 2) ** 2
        versines, squares, mixed = float(rest.versine), float(rest.square), float(rest.mixed)
        energies = rates[own] ** 2 / 2 - versines * versine - squares * sine**2 + mixed * sine * versine
        found.append((float(np.median(energies)), int(base)))
    energy, level = min(found, key=lambda one: abs(one[0]))
    return level, mpf(energy)


def _sign(value: Any) -> int:
    return 1 if value > 0 else -1
