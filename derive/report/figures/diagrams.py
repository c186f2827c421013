"""The curves of a diagram over η: every branch whole from fold to fold."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from itertools import pairwise
from typing import Any

import numpy as np

# Samples come as near to a fold as this share of the range between two: its bend shows, and no gap.
CLOSE = 1e-9
SAMPLES = 61
# The tip moves no more than this from one sample to the next: a hundredth of the article's rods, or a bend shows.
STEP, ROUNDS = 0.8, 12


@dataclass(frozen=True)
class Piece:
    """A branch between two values of η at which the number of equilibria changes; its index is the same throughout."""

    eta: Any
    y: Any
    z: Any
    index: int


def pieces(sweep: Callable[..., Any], beta: float, folds: list[float], low: float, high: float) -> list[Piece]:
    """All branches over [low, high]. Between folds tip angles never meet, so the k-th of each rod make one curve."""
    ends = [low, *(eta for eta in folds if low < eta < high), high]
    return [one for left, right in pairwise(ends) for one in between(sweep, beta, left, right)]


def between(sweep: Callable[..., Any], beta: float, left: float, right: float) -> list[Piece]:
    """The branches over a range without folds inside; samples are closer at its ends, and where tips move fast."""
    share = CLOSE + (1 - 2 * CLOSE) * (1 - np.cos(np.linspace(0, np.pi, SAMPLES))) / 2
    etas = left + (right - left) * share
    values = branches(sweep, beta, etas)
    for _ in range(ROUNDS):
        moved = np.hypot(*np.diff(values[:2], axis=1)).max(axis=1)
        middles = ((etas[:-1] + etas[1:]) / 2)[moved > STEP]
        if not len(middles):
            break
        order = np.argsort(np.concatenate([etas, middles]))
        values = np.concatenate([values, branches(sweep, beta, middles)], axis=1)[:, order]
        etas = np.concatenate([etas, middles])[order]
    y, z, index = values
    return [Piece(etas, y[:, k], z[:, k], int(index[0, k])) for k in range(y.shape[1])]


def branches(sweep: Callable[..., Any], beta: float, etas: Any) -> Any:
    """y, z and index, each as an array over η and branch."""
    found = sweep(beta, etas)
    count = len(found.case) // len(etas)
    if (np.bincount(found.case, minlength=len(etas)) != count).any():
        raise ArithmeticError(f"the number of equilibria changes for β = {beta:g} between η = {etas[0]} and {etas[-1]}")
    return np.array([np.reshape(part, (len(etas), count)) for part in (found.y, found.z, found.index)])
