"""Where two folds of a rod meet, near a guess: β, η and the tip angle to 40 digits, by Newton's method.

The equations are F = ∂F/∂φ = ∂F/∂η = 0, with F = θ(0) − clamp angle by Taylor integration from the tip.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from mpmath import mp, mpf

from derive.measure.fold_references import BESIDE, path_of
from derive.measure.folds import NoFoldError
from derive.measure.reference import DIGITS, MOST_ROUNDS, Rod

FURTHEST = 0.1  # by which β and η may leave a first guess, as a share of their sum
NEAR = 0.5  # folds whose tip angles differ by more are not of one branch, nor is one so far from a guess
UNKNOWNS = ("beta", "eta", "tip_angle")
QUANTITIES = (*UNKNOWNS, "clamp_curvature", "y", "z")
STEP = mpf(10) ** -20  # of differences: their square is beyond DIGITS
CARRIED = DIGITS + 25


@dataclass(frozen=True)
class ExchangeReference:
    """Where two folds meet: β, η and the rod there to 40 digits, and Σ|p ∂quantity/∂p| over the inputs p.

    index: the lower one of those that meet. kind: 'exchange' where F has a saddle, 'isolated' where an extremum.
    """

    values: Mapping[str, Any]
    sensitivity: Mapping[str, float]
    index: int
    kind: str


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
