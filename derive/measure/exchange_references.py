"""Where two folds of a moderate rod meet as the force grows, found by counting equilibria; to 40 digits.

With F = θ(0) − clamp angle as a function of the tip angle φ, of η and of β, a fold is F = ∂F/∂φ = 0. The β at which
it lies, as a function of η, has the derivative −∂F/∂η/∂F/∂β; where it is greatest or least two folds of a diagram over
η meet. Folds over β are found by counting equilibria (`counts`) for a row of values of η; where the derivative changes
its sign from one row to the next, Newton's method on Taylor integration does the rest. No formula is shared with the
solvers. Two exchanges of one branch between neighbouring rows are not seen: `refined` confirms what a solver finds.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import asdict, dataclass, replace
from itertools import pairwise
from typing import Any, NamedTuple

from mpmath import mp, mpf

from derive.measure.counts import count
from derive.measure.fold_references import BESIDE, brackets, path_of
from derive.measure.folds import NoFoldError
from derive.measure.reference import DIGITS, MOST_ROUNDS, Rod

# β and η grow until ℓ²β and ℓ²η are these.
FORCES, FIELDS = 8.0, 6.0
ROWS = 12  # of η
SAMPLES = 96  # of β in a row
PARTS, ZOOMS = 12, 2  # by which a fold is narrowed down
ROUGHLY = 16  # digits of the derivatives at it
FURTHEST = 0.1  # by which β and η may leave a first guess, as a share of their sum
NEAR = 0.5  # two folds of neighbouring rows whose tip angles differ by more are not of one branch
UNKNOWNS = ("beta", "eta", "tip_angle")
QUANTITIES = (*UNKNOWNS, "clamp_curvature", "y", "z")
STEP = mpf(10) ** -20  # of differences: their square is beyond DIGITS
CARRIED = DIGITS + 25


class Level(NamedTuple):
    """A fold over β at one η: where, by how many the number of equilibria changes, and dβ/dη along its branch."""

    beta: float
    tip_angle: float
    change: int
    slope: float


@dataclass(frozen=True)
class ExchangeReference:
    """Where two folds meet: β, η and the rod there to 40 digits, and Σ|p ∂quantity/∂p| over the inputs p.

    index: the lower one of those that meet. kind: 'exchange' where F has a saddle, 'isolated' where an extremum.
    """

    values: Mapping[str, Any]
    sensitivity: Mapping[str, float]
    index: int
    kind: str


@dataclass(frozen=True)
class ExchangeList:
    """All of a rod, with β and η between 0 and what is told here; the rod's own loads say nothing."""

    rod: Rod
    beta: float
    eta: float
    exchanges: tuple[ExchangeReference, ...]

    def to_json(self) -> dict[str, Any]:
        """Plain data; numbers of 40 digits as text."""
        rows = [asdict(one) for one in self.exchanges]
        for row in rows:
            row["values"] = {key: mp.nstr(number, DIGITS + 5) for key, number in row["values"].items()}
        return {"rod": asdict(self.rod), "beta": self.beta, "eta": self.eta, "exchanges": rows}

    @classmethod
    def from_json(cls, data: Mapping[str, Any]) -> ExchangeList:
        """The inverse of `to_json`."""
        with mp.workdps(DIGITS + 8):
            rows = [row | {"values": {k: mpf(text) for k, text in row["values"].items()}} for row in data["exchanges"]]
        found = tuple(ExchangeReference(**row) for row in rows)
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


def refined(
    rod: Rod, beta: float, eta: float, tip_angle: float, exact: Mapping[str, Any] | None = None
) -> ExchangeReference:
    """The one near these loads and this tip angle, to 40 digits; NoFoldError if there is none."""
    inputs = {name: mpf(number) for name, number in vars(rod).items()} | dict(exact or {})
    start = unknowns = [mpf(beta), mpf(eta), mpf(tip_angle)]
    with mp.workdps(CARRIED):
        for _ in range(MOST_ROUNDS):
            rows = equations(inputs, unknowns)
            matrix = mp.matrix([derivative(inputs, unknowns, rows, name) for name in UNKNOWNS]).T
            try:
                step = mp.lu_solve(matrix, mp.matrix(rows))
            except ZeroDivisionError as error:
                raise NoFoldError(f"no two folds meet simply near β = {beta:g}, η = {eta:g} for {rod}") from error
            unknowns = [old - change for old, change in zip(unknowns, step, strict=True)]
            away = max(abs(new - old) for new, old in zip(unknowns[:2], start[:2], strict=True))
            if away > FURTHEST * (start[0] + start[1]) or abs(unknowns[2] - start[2]) > NEAR:
                raise NoFoldError(f"no two folds meet near β = {beta:g}, η = {eta:g} for {rod}")
            if max(abs(change) for change in step) < mpf(10) ** -(DIGITS // 2 + 4):
                break
        else:
            raise NoFoldError(f"Newton's method does not settle near β = {beta:g}, η = {eta:g} for {rod}")
        return described(inputs, unknowns, matrix)


def equations(inputs: Mapping[str, Any], unknowns: Sequence[Any]) -> list[Any]:
    """F, ∂F/∂φ and ∂F/∂η."""
    beta, eta, tip = unknowns
    at = dict(inputs) | {"beta": beta}
    low, here, high = (path_of(at | {"eta": eta + side * STEP * eta}, tip, CARRIED).clamp for side in (-1, 0, 1))
    return [here.theta - inputs["clamp_angle"], here.h, (high.theta - low.theta) / (2 * STEP * eta)]


def derivative(inputs: Mapping[str, Any], unknowns: Sequence[Any], rows: Sequence[Any], name: str) -> list[Any]:
    """Of the equations, by an unknown or an input."""
    delta = mpf(10) ** -14
    moved, there = list(unknowns), dict(inputs)
    if name in UNKNOWNS:
        moved[UNKNOWNS.index(name)] += delta
    else:
        there[name] += delta
    return [(new - old) / delta for new, old in zip(equations(there, moved), rows, strict=True)]


def described(inputs: Mapping[str, Any], unknowns: Sequence[Any], matrix: Any) -> ExchangeReference:
    """What is told of it. matrix: the equations' derivatives, a column for each unknown."""
    beta, eta, tip = unknowns
    at = dict(inputs) | {"beta": beta, "eta": eta}
    index = min(path_of(at, tip + side * BESIDE).index for side in (-1, 1))
    saddle = matrix[1, 2] * matrix[2, 1] - matrix[1, 1] * matrix[2, 2] < 0
    values = quantities(inputs, unknowns)
    total = dict.fromkeys(QUANTITIES, 0.0)
    delta, rows = mpf(10) ** -14, equations(inputs, unknowns)
    for name in (name for name in ("length", "clamp_angle", "field_angle") if inputs[name]):
        rate = derivative(inputs, unknowns, rows, name)
        follow = mp.lu_solve(matrix, mp.matrix([-part for part in rate]))
        there = [old + delta * change for old, change in zip(unknowns, follow, strict=True)]
        moved = quantities(dict(inputs) | {name: inputs[name] + delta}, there)
        for key in QUANTITIES:
            total[key] += float(abs(inputs[name] * (moved[key] - values[key]) / delta))
    return ExchangeReference(values, total, index, "exchange" if saddle else "isolated")


def quantities(inputs: Mapping[str, Any], unknowns: Sequence[Any]) -> dict[str, Any]:
    """The loads, and the rod at them."""
    beta, eta, tip = unknowns
    clamp = path_of(dict(inputs) | {"beta": beta, "eta": eta}, tip, CARRIED).clamp
    return dict(zip(QUANTITIES, (beta, eta, tip, clamp.curvature, clamp.y, clamp.z), strict=True))
