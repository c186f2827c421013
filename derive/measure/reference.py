"""Equilibria to 40 digits by Newton's method on Taylor integration; shares no formula with the solvers.

A `Rod` is what a user asks about. `solve` refines one tip angle, and gives with the answer how far each quantity
moves when the inputs do: no solver in double precision can do better than that times one rounding.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import asdict, dataclass, replace
from typing import Any

from mpmath import mp, mpf

from derive.measure.taylor import Path, integrate, working_digits

DIGITS = 40
# Interior points at which the shape is compared, as fractions of the length.
FRACTIONS = (0.25, 0.5, 0.75)
# Newton's method roughly doubles the digits, from 6 at least; more rounds mean that the guess belongs to no solution.
MOST_ROUNDS = 12


class NoEquilibriumError(ValueError):
    """Newton's method does not settle near the tip angle it was given."""


@dataclass(frozen=True)
class Rod:
    """One rod. Floats are exact inputs; all in one unit of length.

    beta: force over bending stiffness. eta: magnetic modulus over it. length: of the rod. clamp_angle, field_angle: of
    its first direction and of the field, in radians from the direction of the force.
    """

    beta: float
    eta: float
    length: float
    clamp_angle: float
    field_angle: float = 0.0

    def __str__(self) -> str:
        """One line for tables and errors."""
        field = f", α = {self.field_angle:.6g}" if self.field_angle else ""
        return f"β = {self.beta:.6g}, η = {self.eta:.6g}, ℓ = {self.length:.6g}, clamp {self.clamp_angle:.6g}{field}"


@dataclass(frozen=True)
class Reference:
    """One equilibrium of a rod.

    index: number of negative directions of the second variation. values: its quantities by name, as mpmath numbers.
    sensitivity: Σ|p ∂quantity/∂p| over the inputs p, by name.
    """

    rod: Rod
    index: int
    values: Mapping[str, Any]
    sensitivity: Mapping[str, float]

    def to_json(self) -> dict[str, Any]:
        """Plain data; numbers of 40 digits as text."""
        values = {name: mp.nstr(value, DIGITS + 5, strip_zeros=False) for name, value in self.values.items()}
        rod = asdict(self.rod)
        return {"rod": rod, "index": self.index, "values": values, "sensitivity": dict(self.sensitivity)}

    @classmethod
    def from_json(cls, data: Mapping[str, Any]) -> Reference:
        """The inverse of `to_json`."""
        with mp.workdps(DIGITS + 8):
            values = {name: mpf(text) for name, text in data["values"].items()}
        return cls(Rod(**data["rod"]), data["index"], values, dict(data["sensitivity"]))


def solve(rod: Rod, tip_angle: Any, digits: int = DIGITS, *, furthest: float = 1e-3) -> Reference:
    """The equilibrium of a rod whose tip_angle is within `furthest` of the one given, to `digits` digits.

    Long rods have tips exponentially near a direction of equilibrium: give then a tip angle of that precision.
    NoEquilibriumError if there is none near, ArithmeticError if two orders of integration do not agree.
    """
    tip = refine(rod, tip_angle, digits, furthest)
    with mp.workdps(working_digits(rod.beta, rod.eta, rod.length, digits)):
        path, check = walk(rod, tip, digits), walk(rod, tip, digits, more_terms=9)
        values = quantities(rod, path)
        again = quantities(rod, check)
        # θ(0) amplifies everything, so it may differ by more than the rest; all must hold to the digits asked for.
        size = 1 + rod.length
        worst = max(abs(values[name] - again[name]) for name in values)
        if worst > size * mpf(10) ** -digits or path.index != check.index:
            raise ArithmeticError(f"two orders of integration differ by {mp.nstr(worst, 3)} for {rod}")
        if abs(path.clamp.theta - mpf(rod.clamp_angle)) > abs(path.clamp.h) * mpf(10) ** -digits:
            raise NoEquilibriumError(f"Newton's method stopped short of {digits} digits for {rod}")
        return Reference(rod, path.index, values, sensitivity(rod, tip))


def refine(rod: Rod, tip_angle: Any, digits: int, furthest: float) -> Any:
    """The tip angle, within `furthest` of tip_angle, at which θ(0) is the clamp angle of the rod, to `digits` digits.

    By Newton's method, few digits first, then all: ∂θ(0)/∂θ(ℓ) is h(0). NoEquilibriumError if it does not settle.
    """
    with mp.workdps(working_digits(rod.beta, rod.eta, rod.length, digits)):
        start = tip = mpf(tip_angle)
        for carried in (digits // 2, digits):
            for _ in range(MOST_ROUNDS):
                clamp = walk(rod, tip, carried, interior=False).clamp
                step = (clamp.theta - mpf(rod.clamp_angle)) / clamp.h if clamp.h else mp.inf
                tip -= step
                if abs(tip - start) > furthest:
                    raise NoEquilibriumError(
                        f"no equilibrium within {furthest:g} of the tip angle {mp.nstr(start, 12)} for {rod}"
                    )
                if step**2 < mpf(10) ** -(carried + 4):
                    break
            else:
                raise NoEquilibriumError(f"Newton's method does not settle near {mp.nstr(start, 12)} for {rod}")
        return tip


def walk(rod: Rod, tip: Any, digits: int, *, interior: bool = True, more_terms: int = 0) -> Path:
    """Integrate a rod from a given tip angle, with its interior points or without.

    digits: to which the Taylor series are carried. more_terms: of higher order than these need, for a second route.
    """
    stops = [fraction * mpf(rod.length) for fraction in FRACTIONS] if interior else []
    return integrate(tip, rod.beta, rod.eta, rod.field_angle, rod.length, digits, stops=stops, more_terms=more_terms)


def quantities(rod: Rod, path: Path) -> dict[str, Any]:
    """All that a solver is asked for, by name, from the path of a rod; at interior points measured from the clamp."""
    clamp = path.clamp
    beta, eta, field_angle = mpf(rod.beta), mpf(rod.eta), mpf(rod.field_angle)
    values = {
        "tip_angle": path.tip_angle,
        "clamp_curvature": clamp.curvature,
        # What the first integral is, from the state at the clamp; a solver has it from the tip.
        "gamma": clamp.curvature**2 + 2 * beta * mp.cos(clamp.theta) + eta * mp.cos(clamp.theta - field_angle) ** 2,
        "y": clamp.y,
        "z": clamp.z,
        "energy": clamp.energy - beta * clamp.y,
    }
    return values | inner_values(path)


def inner_values(path: Any) -> dict[str, Any]:
    """θ, θ′ and the place from the clamp at FRACTIONS of the length, by name; the path runs from the tip."""
    found = {}
    for point, fraction in zip(path.points, reversed(FRACTIONS), strict=False):
        found[f"theta({fraction}ℓ)"] = point.theta
        found[f"curvature({fraction}ℓ)"] = point.curvature
        found[f"y({fraction}ℓ)"] = path.clamp.y - point.y
        found[f"z({fraction}ℓ)"] = path.clamp.z - point.z
    return found


def along(values: Mapping[str, Any], length: Any, couple: Callable[[Any], Any]) -> dict[str, Any]:
    """s ∂quantity/∂s at s = fraction·ℓ of each of the ``values`` that belongs to such a point; 0 of the others.

    length: ℓ. couple: θ″ at an angle, by the equation of equilibrium.
    """
    parts = dict.fromkeys(values, mpf(0))
    for fraction in FRACTIONS:
        s, theta = fraction * mpf(length), values[f"theta({fraction}ℓ)"]
        slopes = {
            "theta": values[f"curvature({fraction}ℓ)"],
            "curvature": couple(theta),
            "y": mp.cos(theta),
            "z": mp.sin(theta),
        }
        parts |= {f"{name}({fraction}ℓ)": s * slope for name, slope in slopes.items()}
    return parts


def couple_of(rod: Rod) -> Callable[[Any], Any]:
    """θ″ of a rod at an angle."""
    beta, eta, field_angle = mpf(rod.beta), mpf(rod.eta), mpf(rod.field_angle)
    return lambda theta: beta * mp.sin(theta) + eta / 2 * mp.sin(2 * (theta - field_angle))


def sensitivity(rod: Rod, tip: Any, digits: int = 24) -> dict[str, float]:
    """Σ|p ∂quantity/∂p| over the inputs of a rod, by differences of half the digits.

    The tip is moved along so that θ(0) stays at the clamp. The arc length s of a point is an input by itself: it is
    rounded apart from ℓ, and ℓ∂_ℓ is at fixed s.
    """
    delta = mpf(10) ** -(digits // 2)
    with mp.workdps(working_digits(rod.beta, rod.eta, rod.length, digits)):
        base = walk(rod, tip, digits)
        at = quantities(rod, base)
        own = along(at, rod.length, couple_of(rod))
        totals = {key: float(abs(part)) for key, part in own.items()}
        for name in ("beta", "eta", "length", "clamp_angle", "field_angle"):
            value = mpf(getattr(rod, name))
            if not value:
                continue
            moved: Rod = replace(rod, **{name: value * (1 + delta)})
            clamp = walk(moved, tip, digits, interior=False).clamp
            moved_tip = tip - (clamp.theta - base.clamp.theta - moved.clamp_angle + mpf(rod.clamp_angle)) / clamp.h
            there = quantities(moved, walk(moved, moved_tip, digits))
            for key in totals:
                # The points move along with the end, as they are fractions of the length.
                carried = own[key] if name == "length" else 0
                totals[key] += float(abs((there[key] - at[key]) / delta - carried))
    return totals
