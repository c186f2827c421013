"""What people use today, as solvers beside ours: each says which tips it finds, and what its rod is like.

Set-up of the two closed forms, as one who knows them would: tips are looked for within one turn of the clamp angle at
4,000 equal steps, and from every direction of rest in steps of a fifth of a power of ten down to 1e-7 (m, or the
discriminant, goes with the square of that distance, and is noise below), on both sides; every change of sign is settled
by `scipy.optimize.brentq` to a rounding. y and z are Gauss–Legendre sums of cos θ and sin θ, 16 points a panel and a
panel for each unit of ℓ√(β + η). The article's literal formulas take our tip and γ.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from math import ceil, pi, sqrt
from typing import Any

import numpy as np
from mpmath import mp

from derive.emit.kernels.literal import angle_and_position_literally
from derive.measure.atlas_forms import Array, by_ellipj, by_invariants
from derive.measure.reference import FRACTIONS, Rod
from derive.measure.rests import rests
from derive.measure.segments import Load

STEPS = 4000
NODES = 16
LONGEST = 2e4  # ℓ√(β + η) up to which quadrature is tried

Form = Callable[[Rod, Array, Any], Array]


class PeerError(ValueError):
    """The peer has no answer for the rod; the message says why."""


@dataclass(frozen=True)
class Peer:
    """A solver: name, what it is, its tips (None if it takes ours), and the values of the rod of one of them.

    needs: packages by the names they are imported by, without which it is left out.
    """

    name: str
    title: str
    tips: Callable[[Rod], list[float]] | None
    values: Callable[[Rod, Any], Mapping[str, float]]
    needs: tuple[str, ...] = ()


def candidates(rod: Rod) -> Array:
    """Tips at which a closed form is tried."""
    low, high = rod.clamp_angle - 2 * pi, rod.clamp_angle + 2 * pi
    parts = [np.linspace(low, high, STEPS + 1), np.array([rod.clamp_angle])]
    near = np.logspace(-7, 0, 36)
    if rod.beta + rod.eta > 0 and rod.length * sqrt(rod.beta + rod.eta) > 1e-3:
        with mp.workdps(20):
            found = [float(rest.angle) for rest in rests(Load.of(_short(rod)), low, high)]
        for angle in found:
            parts += [angle + near, angle - near, np.array([angle])]
    every = np.unique(np.concatenate(parts))
    return every[(every > low) & (every < high)]


def _short(rod: Rod) -> Rod:
    """The same loads on a rod of length 1: directions of rest need no digits of e^{−ℓ}."""
    scale = rod.beta + rod.eta
    return Rod(rod.beta / scale, rod.eta / scale, 1.0, rod.clamp_angle, rod.field_angle)


def tips_by(form: Form) -> Callable[[Rod], list[float]]:
    """All tips that a closed form finds, ascending."""

    def found(rod: Rod) -> list[float]:
        def miss(tip: Any) -> Any:
            return form(rod, np.atleast_1d(np.asarray(tip, dtype=float)), rod.length) - rod.clamp_angle

        with np.errstate(all="ignore"):
            places = candidates(rod)
            values = miss(places)
            known = np.isfinite(values)
            if not known.any():
                raise PeerError("nan at every tip")
            places, values = places[known], values[known]
            exact = places[values == 0].tolist()
            change = np.flatnonzero(values[1:] * values[:-1] < 0)
            settled = [settle(miss, places[k], places[k + 1]) for k in change]
        return sorted([*exact, *(tip for tip in settled if tip is not None)])

    return found


def settle(miss: Callable[[Any], Any], low: float, high: float) -> float | None:
    """A change of sign to a rounding; None where the function has no value on the way."""
    from scipy.optimize import brentq

    try:
        return float(brentq(lambda tip: float(miss(tip)[0]), low, high, xtol=1e-300, rtol=1e-15, maxiter=500))
    except (ValueError, RuntimeError):
        return None


def values_by(form: Form) -> Callable[[Rod, Any], Mapping[str, float]]:
    """θ, y and z of the rod of a tip."""

    def values(rod: Rod, tip: Any) -> Mapping[str, float]:
        scaled = rod.length * sqrt(rod.beta + rod.eta)
        if scaled > LONGEST:
            raise PeerError(f"quadrature over {scaled:.0f} characteristic lengths is not tried")
        panels = 4 * ceil(scaled / 4 + 1)
        nodes, weights = np.polynomial.legendre.leggauss(NODES)
        step = rod.length / panels
        s = (np.arange(panels)[:, None] + (nodes + 1) / 2) * step
        with np.errstate(all="ignore"):
            theta = form(rod, np.full(s.shape, float(tip)), rod.length - s)
            y = np.cumsum(np.cos(theta) @ weights * step / 2)
            z = np.cumsum(np.sin(theta) @ weights * step / 2)
            stops = np.array(FRACTIONS) * rod.length
            along = form(rod, np.full(len(FRACTIONS), float(tip)), rod.length - stops)
        found = {"tip_angle": float(tip), "y": float(y[-1]), "z": float(z[-1])}
        for fraction, angle in zip(FRACTIONS, along, strict=True):
            at = round(fraction * panels) - 1
            found |= {f"theta({fraction}ℓ)": float(angle), f"y({fraction}ℓ)": float(y[at])}
            found |= {f"z({fraction}ℓ)": float(z[at])}
        return found

    return values


def literal_values(rod: Rod, equilibrium: Any) -> Mapping[str, float]:
    """The article's own formulas, of our equilibrium."""
    places = np.array([*FRACTIONS, 1.0]) * rod.length
    with np.errstate(all="ignore"):
        theta, _, y, z = angle_and_position_literally(equilibrium, places)
    return named(theta, y, z)


def named(theta: Any, y: Any, z: Any) -> dict[str, float]:
    """Values at FRACTIONS and then at the tip, by name."""
    found = {"tip_angle": float(theta[-1]), "y": float(y[-1]), "z": float(z[-1])}
    for k, fraction in enumerate(FRACTIONS):
        found |= {f"theta({fraction}ℓ)": float(theta[k]), f"y({fraction}ℓ)": float(y[k])}
        found |= {f"z({fraction}ℓ)": float(z[k])}
    return found


PEERS = {
    peer.name: peer
    for peer in (
        Peer("literal", "the article's literal formulas", None, literal_values),
        Peer("ellipj", "scipy.special.ellipj", tips_by(by_ellipj), values_by(by_ellipj), ("scipy",)),
        Peer("invariants", "℘ by g₂ and g₃", tips_by(by_invariants), values_by(by_invariants), ("scipy",)),
    )
}
