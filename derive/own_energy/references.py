"""All equilibria of a rod by its own law, to 40 digits: what an emitted module is held against.

As in ``measure.reference`` and ``measure.scan``, every tip angle is tried in double precision, and what is found is
refined by Newton's method on the integration. The sensitivities count an angle as 1 at least: a solver that works in
turned axes rounds every angle by that, and no rod can be asked for more.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from types import SimpleNamespace
from typing import Any

from mpmath import mp, mpf

from derive.measure.reference import (
    DIGITS,
    FRACTIONS,
    MOST_ROUNDS,
    NoEquilibriumError,
    Reference,
    Rod,
    along,
    inner_values,
)
from derive.measure.taylor import Path, working_digits
from derive.own_energy.integration import integrate
from derive.own_energy.law import at_loads, evaluate
from derive.own_energy.scan import brute_force

FURTHEST = 1e-3  # from a tip angle of the scan
CARRIED = 24  # digits for sensitivities


@dataclass(frozen=True)
class OwnRod:
    """A rod under the loads of a law, in its order. The numbers are floats, exact as inputs."""

    names: tuple[str, ...]
    loads: tuple[Any, ...]
    length: Any
    clamp_angle: Any
    field_angle: Any

    @property
    def arguments(self) -> SimpleNamespace:
        """What a module takes, by the names of its parameters."""
        angles = {"clamp_angle": self.clamp_angle, "field_angle": self.field_angle}
        return SimpleNamespace(**dict(zip(self.names, self.loads, strict=True)), length=self.length, **angles)

    def moved(self, place: int, share: Any) -> OwnRod:
        """The rod with one input changed by a share of its size, an angle by one of its size or 1."""
        if place < len(self.loads):
            loads = [load * (1 + share) if k == place else mpf(load) for k, load in enumerate(self.loads)]
            return replace(self, loads=tuple(loads))
        name = ("length", "clamp_angle", "field_angle")[place - len(self.loads)]
        value = mpf(getattr(self, name))
        size = value if name == "length" else max(abs(value), mpf(1))
        return replace(self, **{name: value + share * size})


@dataclass(frozen=True)
class Measured(Rod):
    """What ``measure.agreement`` asks of a rod: all its loads together as one size, and how it is written."""

    text: str = ""

    def __str__(self) -> str:
        """One line for errors."""
        return self.text


def references(law: dict[str, Any], rod: OwnRod) -> list[dict[str, Any]]:
    """All equilibria of a rod by ascending tip angles, as plain data."""
    return [to_json(law, rod, refine(law, rod, tip)) for tip in brute_force(law, rod)]


def refine(law: dict[str, Any], rod: OwnRod, start: float) -> Any:
    """The tip angle at which θ(0) is the clamp angle; ∂θ(0)/∂θ(ℓ) is h(0)."""
    with mp.workdps(_working(rod, DIGITS)):
        tip = mpf(start)
        for carried in (DIGITS // 2, DIGITS):
            for _ in range(MOST_ROUNDS):
                clamp = integrate(law, rod, tip, carried).clamp
                step = (clamp.theta - rod.clamp_angle) / clamp.h if clamp.h else mp.inf
                tip -= step
                if abs(tip - start) > FURTHEST:
                    raise NoEquilibriumError(f"no equilibrium near the tip angle {start:.12g} for {written(rod)}")
                if step**2 < mpf(10) ** -(carried + 4):
                    break
            else:
                raise NoEquilibriumError(f"Newton's method does not settle near {start:.12g} for {written(rod)}")
        return tip


def to_json(law: dict[str, Any], rod: OwnRod, tip: Any) -> dict[str, Any]:
    """One equilibrium: its quantities, once more by a higher order of integration, its index and sensitivities."""
    with mp.workdps(_working(rod, DIGITS)):
        path = _walk(law, rod, tip, DIGITS)
        values = quantities(law, rod, path)
        again = quantities(law, rod, _walk(law, rod, tip, DIGITS, more_terms=9))
        worst = max(abs(values[name] - again[name]) for name in values)
        if worst > (1 + rod.length) * mpf(10) ** -DIGITS:
            raise ArithmeticError(f"two orders of integration differ by {mp.nstr(worst, 3)} for {written(rod)}")
        texts = {name: mp.nstr(value, DIGITS + 5, strip_zeros=False) for name, value in values.items()}
    return {"index": path.index, "values": texts, "sensitivity": sensitivity(law, rod, tip)}


def from_json(rod: OwnRod, data: Mapping[str, Any]) -> Reference:
    """The record that ``measure.agreement`` compares with."""
    with mp.workdps(DIGITS + 8):
        values = {name: mpf(text) for name, text in data["values"].items()}
    stiffness = sum(abs(load) for load in rod.loads)
    measured = Measured(stiffness, 0.0, rod.length, rod.clamp_angle, rod.field_angle, written(rod))
    return Reference(measured, data["index"], values, data["sensitivity"])


def quantities(law: dict[str, Any], rod: OwnRod, path: Path) -> dict[str, Any]:
    """All that a solver is asked for, by name; at interior points measured from the clamp."""
    clamp = path.clamp
    density = at_loads(law["density"], list(map(mpf, rod.loads)), *_axis(rod), mpf)
    values = {
        "tip_angle": path.tip_angle,
        "clamp_curvature": clamp.curvature,
        # What the first integral is, from the state at the clamp; a solver has it from the tip.
        "gamma": clamp.curvature**2 - 2 * evaluate(density, mp.cos(clamp.theta), mp.sin(clamp.theta)),
        "y": clamp.y,
        "z": clamp.z,
        "energy": clamp.energy,
    }
    return values | inner_values(path)


def sensitivity(law: dict[str, Any], rod: OwnRod, tip: Any) -> dict[str, float]:
    """How far the quantities move with the inputs, by differences; the tip moves along so that θ(0) stays.

    The arc length of a point is an input by itself, as in ``measure.reference``.
    """
    share = mpf(10) ** -(CARRIED // 2)
    with mp.workdps(_working(rod, CARRIED)):
        base = _walk(law, rod, tip, CARRIED)
        at = quantities(law, rod, base)
        couple = at_loads(law["couple"], list(map(mpf, rod.loads)), *_axis(rod), mpf)
        own = along(at, rod.length, lambda theta: evaluate(couple, mp.cos(theta), mp.sin(theta)))
        totals = {name: float(abs(part)) for name, part in own.items()}
        for place in range(len(rod.loads) + 3):
            moved = rod.moved(place, share)
            clamp = integrate(law, moved, tip, CARRIED).clamp
            other = tip - (clamp.theta - base.clamp.theta - moved.clamp_angle + rod.clamp_angle) / clamp.h
            there = quantities(law, moved, _walk(law, moved, other, CARRIED))
            for name in totals:
                # The points move along with the end, as they are fractions of the length.
                carried = own[name] if place == len(rod.loads) else 0
                totals[name] += float(abs((there[name] - at[name]) / share - carried))
    return totals


def _axis(rod: OwnRod) -> tuple[Any, Any]:
    """Cosine and sine of the field angle."""
    return mp.cos(mpf(rod.field_angle)), mp.sin(mpf(rod.field_angle))


def written(rod: OwnRod) -> str:
    """One line for errors."""
    return ", ".join(f"{name} = {value:.6g}" for name, value in vars(rod.arguments).items())


def _walk(law: dict[str, Any], rod: OwnRod, tip: Any, digits: int, more_terms: int = 0) -> Path:
    stops = [fraction * mpf(rod.length) for fraction in FRACTIONS]
    return integrate(law, rod, tip, digits, stops=stops, more_terms=more_terms)


def _working(rod: OwnRod, digits: int) -> int:
    return working_digits(sum(abs(float(load)) for load in rod.loads), 0, rod.length, digits)
