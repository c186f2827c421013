"""All folds of a moderate rod as the field grows, found by counting equilibria and refined by Taylor integration.

Where two field strengths have different numbers of equilibria there is a fold between them; it is narrowed down by
counting (`counts`) and refined to 40 digits (`folds`). Two folds between neighbouring samples that undo one another are
not seen: `refined` confirms those that a solver finds. No formula is shared with the solvers.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import asdict, dataclass, replace
from itertools import pairwise
from typing import Any

from mpmath import mp, mpf

from derive.measure.counts import count
from derive.measure.folds import HALVINGS, NoFoldError, fold, fold_between
from derive.measure.reference import DIGITS, Rod
from derive.measure.taylor import Path, integrate

SCALED = 8.0  # the field grows until ℓ√(β+η) is this, where counting is still sure
SAMPLES = 32
ROUGH = 30  # digits for derivatives and indices
STRAIGHT = 4e-16  # a clamp angle with less moment than this, in β + η, is a direction of equilibrium
BESIDE = 2.0**-40  # the share by which a fold is left for the two indices that meet there
QUANTITIES = ("eta", "tip_angle", "clamp_curvature", "y", "z")


@dataclass(frozen=True)
class FoldReference:
    """A fold: its η and the rod there to 40 digits, and Σ|p ∂quantity/∂p| over the inputs p.

    index: the lower one of those that meet. change: of the number of equilibria as η grows.
    """

    values: Mapping[str, Any]
    sensitivity: Mapping[str, float]
    index: int
    change: int
    kind: str


@dataclass(frozen=True)
class FoldList:
    """All folds of a rod with η between 0 and ``high``; the rod's own η says nothing."""

    rod: Rod
    high: float
    folds: tuple[FoldReference, ...]

    def to_json(self) -> dict[str, Any]:
        """Plain data; numbers of 40 digits as text."""
        return {"rod": asdict(self.rod), "high": self.high, "folds": as_texts(self.folds)}

    @classmethod
    def from_json(cls, data: Mapping[str, Any]) -> FoldList:
        """The inverse of `to_json`."""
        found = tuple(FoldReference(**row) for row in from_texts(data["folds"]))
        return cls(Rod(**data["rod"]), data["high"], found)


def as_texts(references: Iterable[Any]) -> list[dict[str, Any]]:
    """Records whose values have 40 digits as plain data, with these numbers as text."""
    rows = [asdict(one) for one in references]
    for row in rows:
        row["values"] = {key: mp.nstr(number, DIGITS + 5) for key, number in row["values"].items()}
    return rows


def from_texts(rows: Iterable[Mapping[str, Any]]) -> list[dict[str, Any]]:
    """The inverse of `as_texts`, but for the class of the records."""
    with mp.workdps(DIGITS + 8):
        return [{**row, "values": {key: mpf(text) for key, text in row["values"].items()}} for row in rows]


def fold_references(rod: Rod, exact: Mapping[str, Any] | None = None) -> FoldList | None:
    """All folds of a rod; None if its force alone makes it stiff. exact: values that stand for its doubles."""
    high = (SCALED / rod.length) ** 2 - rod.beta
    if high <= 0.1 * rod.beta:
        return None
    found = []
    for low, top, change in brackets(rod, "eta", high):
        if straight(replace(rod, eta=low)) and straight(replace(rod, eta=top)):
            found.append(pitchfork(rod, exact or {}, low, top, change))
        elif near := fold_between(rod, "eta", low, top):
            found.append(refined(rod, float(near.value), float(near.tip_angle), exact))
    return FoldList(rod, high, tuple(sorted(found, key=lambda one: float(one.values["eta"]))))


def brackets(rod: Rod, parameter: str, high: float, samples: int = SAMPLES) -> list[tuple[float, float, int]]:
    """Loads up to ``high`` between which the number of equilibria changes by one pair, and the change.

    parameter: which load, 'eta' or 'beta'.
    """

    def counted(loads: list[float]) -> list[tuple[float, int]]:
        rows = count([replace(rod, **{parameter: load}) for load in loads])
        return [(load, row.number) for load, row in zip(loads, rows, strict=True) if row.number is not None]

    todo = list(pairwise(counted([0.0, *(high * (k + 0.5) / samples for k in range(samples)), high])))
    found = []
    for _ in range(HALVINGS):
        split = [pair for pair in todo if abs(pair[1][1] - pair[0][1]) > 2]
        found += [(a, b, d - c) for (a, c), (b, d) in todo if abs(d - c) == 2]
        halves = [[low, *counted([(low[0] + top[0]) / 2]), top] for low, top in split]
        todo = [pair for places in halves for pair in pairwise(places)]
    if todo:
        raise NoFoldError(f"more than two equilibria meet at one load for {rod}")
    return found


def refined(rod: Rod, eta: float, tip_angle: float, exact: Mapping[str, Any] | None = None) -> FoldReference:
    """The fold near a field strength and a tip angle to 40 digits; NoFoldError if there is none."""
    near = fold(replace(rod, **exact or {}), "eta", eta, tip_angle)
    tip, known = near.tip_angle, {name: mpf(number) for name, number in vars(rod).items()} | dict(exact or {})
    inputs = known | {"eta": near.value}
    values = values_of(near.value, path_of(inputs, tip, DIGITS + 5))
    with mp.workdps(ROUGH):
        index = min(path_of(inputs, tip + side * BESIDE).index for side in (-1, 1))
        return FoldReference(values, sensitivity(inputs, tip), index, 2 * near.opens, "fold")


def sensitivity(inputs: Mapping[str, Any], tip: Any) -> dict[str, float]:
    """Σ|p ∂quantity/∂p| over the inputs but η, which moves with them as the tip angle does."""
    here, total = path_of(inputs, tip), dict.fromkeys(QUANTITIES, 0.0)
    by_tip, by_eta = moved(inputs, tip, here, "tip"), moved(inputs, tip, here, "eta")
    matrix = mp.matrix([[by_tip[key], by_eta[key]] for key in ("miss", "h")])
    for name in (name for name in ("beta", "length", "clamp_angle", "field_angle") if inputs[name]):
        rate = moved(inputs, tip, here, name)
        d_tip, d_eta = mp.lu_solve(matrix, mp.matrix([-rate[key] for key in ("miss", "h")]))
        change = {"eta": d_eta, "tip_angle": d_tip}
        change |= {key: rate[key] + by_tip[key] * d_tip + by_eta[key] * d_eta for key in QUANTITIES[2:]}
        total = {key: total[key] + float(abs(inputs[name] * change[key])) for key in QUANTITIES}
    return total


def path_of(inputs: Mapping[str, Any], tip: Any, digits: int = ROUGH) -> Path:
    """The rod integrated from its tip."""
    return integrate(tip, **{key: number for key, number in inputs.items() if key != "clamp_angle"}, digits=digits)


def values_of(eta: Any, path: Path) -> dict[str, Any]:
    """What is told of a fold."""
    clamp = path.clamp
    return dict(zip(QUANTITIES, (eta, path.tip_angle, clamp.curvature, clamp.y, clamp.z), strict=True))


def moved(inputs: Mapping[str, Any], tip: Any, here: Path, name: str) -> dict[str, Any]:
    """Derivatives of θ(0) − clamp angle, h(0), θ′(0), y and z by an input or the tip angle."""
    if name == "clamp_angle":
        return {"miss": mpf(-1), **dict.fromkeys(("h", *QUANTITIES[2:]), mpf(0))}
    delta = mpf(10) ** -(ROUGH // 2)
    changed = dict(inputs) if name == "tip" else {**inputs, name: inputs[name] + delta}
    there, old = path_of(changed, tip + delta if name == "tip" else tip).clamp, here.clamp
    pairs = {
        "miss": (there.theta, old.theta),
        "h": (there.h, old.h),
        "clamp_curvature": (there.curvature, old.curvature),
    }
    pairs |= {"y": (there.y, old.y), "z": (there.z, old.z)}
    return {key: (new - before) / delta for key, (new, before) in pairs.items()}


def straight(rod: Rod) -> bool:
    """Whether a straight rod at the clamp angle is in equilibrium, to rounding."""
    return bool(abs(moment(vars(rod), mpf(rod.clamp_angle))) <= STRAIGHT * (rod.beta + rod.eta))


def moment(inputs: Mapping[str, Any], angle: Any) -> Any:
    """The couple on a tangent in a direction, θ″."""
    lean = 2 * (angle - inputs["field_angle"])
    return inputs["beta"] * mp.sin(angle) + inputs["eta"] * mp.sin(lean) / 2


def pitchfork(rod: Rod, exact: Mapping[str, Any], low: float, high: float, change: int) -> FoldReference:
    """Where the straight rod's linearised equation has a solution between two field strengths, by the secant method."""
    with mp.workdps(DIGITS + 10):
        inputs = {name: mpf(number) for name, number in vars(rod).items()} | dict(exact)
        tip = mp.findroot(lambda angle: moment(inputs | {"eta": mpf(high)}, angle), inputs["clamp_angle"])

        def h(eta: Any) -> Any:
            return path_of(inputs | {"eta": eta}, tip, DIGITS + 5).clamp.h

        eta = mp.findroot(h, (mpf(low), mpf(high)), solver="anderson", tol=mpf(10) ** -(2 * DIGITS), maxsteps=60)
        # η moves with β by a share of it at most, and by twice its own share with the length.
        moves = dict.fromkeys(QUANTITIES, 0.0) | {"eta": float(3 * (eta + inputs["beta"]))}
        moves |= {"y": float(inputs["length"]), "z": float(inputs["length"])}
        ends = [path_of(inputs | {"eta": eta * (1 + side * BESIDE)}, tip) for side in (-1, 1)]
        values = values_of(eta, path_of(inputs | {"eta": eta}, tip))
        return FoldReference(values, moves, min(path.index for path in ends), change, "pitchfork")
