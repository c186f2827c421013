"""Where two folds of a moderate rod meet as the force grows, found by counting equilibria; to 40 digits.

With F = θ(0) − clamp angle as a function of the tip angle φ, of η and of β, a fold is F = ∂F/∂φ = 0. The β at which
it lies, as a function of η, has the derivative −∂F/∂η/∂F/∂β; where it is greatest or least two folds of a diagram over
η meet. Folds over β are found by counting equilibria (`counts`) for a row of values of η; where the derivative changes
its sign from one row to the next, `exchanges` does the rest. No formula is shared with the
solvers. Two exchanges of one branch between neighbouring rows are not seen: `refined` confirms what a solver finds.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import asdict, dataclass, replace
from itertools import pairwise
from typing import Any, NamedTuple

from mpmath import mp, mpf

from derive.measure.counts import count
from derive.measure.exchanges import NEAR, ExchangeReference, refined
from derive.measure.fold_references import as_texts, brackets, from_texts, path_of
from derive.measure.reference import Rod

# β and η grow until ℓ²β and ℓ²η are these.
FORCES, FIELDS = 8.0, 6.0
ROWS = 12  # of η
SAMPLES = 96  # of β in a row
PARTS, ZOOMS = 12, 2  # by which a fold is narrowed down
ROUGHLY = 16  # digits of the derivatives at it


class Level(NamedTuple):
    """A fold over β at one η: where, by how many the number of equilibria changes, and dβ/dη along its branch."""

    beta: float
    tip_angle: float
    change: int
    slope: float


@dataclass(frozen=True)
class ExchangeList:
    """All of a rod, with β and η between 0 and what is told here; the rod's own loads say nothing."""

    rod: Rod
    beta: float
    eta: float
    exchanges: tuple[ExchangeReference, ...]

    def to_json(self) -> dict[str, Any]:
        """Plain data; numbers of 40 digits as text."""
        return {"rod": asdict(self.rod), "beta": self.beta, "eta": self.eta, "exchanges": as_texts(self.exchanges)}

    @classmethod
    def from_json(cls, data: Mapping[str, Any]) -> ExchangeList:
        """The inverse of `to_json`."""
        found = tuple(ExchangeReference(**row) for row in from_texts(data["exchanges"]))
        return cls(Rod(**data["rod"]), data["beta"], data["eta"], found)


def exchange_references(rod: Rod, exact: Mapping[str, Any] | None = None) -> ExchangeList:
    """All of a rod; exact: values that stand for its doubles."""
    forces, fields = FORCES / rod.length**2, FIELDS / rod.length**2
    rows = [(eta, levels(replace(rod, eta=eta), forces)) for eta in (fields * (k + 0.5) / ROWS for k in range(ROWS))]
    found = []
    for (low, before), (high, after) in pairwise(rows):
        for one, other in matched(before, after):
            if one.slope * other.slope < 0:
                share = one.slope / (one.slope - other.slope)
                beta, tip = (old + share * (new - old) for old, new in zip(one[:2], other[:2], strict=True))
                found.append(refined(rod, beta, low + share * (high - low), tip, exact))
    return ExchangeList(rod, forces, fields, tuple(sorted(found, key=lambda one: float(one.values["beta"]))))


def levels(rod: Rod, forces: float) -> list[Level]:
    """The folds of a rod as its force grows, by the force."""
    found = []
    for low, high, change in brackets(rod, "beta", forces, SAMPLES):
        for _ in range(ZOOMS):
            places = [low + (high - low) * k / PARTS for k in range(PARTS + 1)]
            rows = [row for row in count([replace(rod, beta=beta) for beta in places]) if row.tips is not None]
            low, high = next(
                (one.rod.beta, other.rod.beta) for one, other in pairwise(rows) if one.number != other.number
            )
        tips = max((row.tips or () for row in rows if row.rod.beta in (low, high)), key=len)
        _, tip = min((after - before, (after + before) / 2) for before, after in pairwise(tips))
        beta = (low + high) / 2
        found.append(Level(beta, tip, change, slope(rod, beta, tip)))
    return found


def slope(rod: Rod, beta: Any, tip_angle: Any) -> float:
    """dβ/dη along the branch of a fold over β."""
    inputs = {name: mpf(number) for name, number in vars(rod).items()} | {"beta": mpf(beta)}
    delta = mpf(10) ** -10
    with mp.workdps(2 * ROUGHLY):
        here = path_of(inputs, tip_angle).clamp.theta
        by_beta, by_eta = (
            path_of(inputs | {name: inputs[name] * (1 + delta)}, tip_angle).clamp.theta - here
            for name in ("beta", "eta")
        )
        return float(-(by_eta / inputs["eta"]) / (by_beta / inputs["beta"]))


def matched(before: Sequence[Level], after: Sequence[Level]) -> Iterator[tuple[Level, Level]]:
    """The folds of neighbouring rows that are of one branch: of one kind, and nearest by the tip angle."""
    for one in before:
        alike = [other for other in after if other.change == one.change]
        other = min(alike, key=lambda item: abs(item.tip_angle - one.tip_angle), default=None)
        if other is not None and abs(other.tip_angle - one.tip_angle) < NEAR:
            yield one, other
