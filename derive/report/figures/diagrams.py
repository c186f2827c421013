"""The curves of a diagram over η: every branch whole from fold to fold."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from itertools import pairwise
from typing import Any

import numpy as np

# Samples come as near to a fold as this share of the range between two: its bend shows, and no gap.
CLOSE = 1e-9
SAMPLES = 81


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
    """The branches over a range without folds inside; samples are closer at its ends, where branches may bend."""
    share = CLOSE + (1 - 2 * CLOSE) * (1 - np.cos(np.linspace(0, np.pi, SAMPLES))) / 2
    etas = left + (right - left) * share
    found = sweep(beta, etas)
    count, rest = divmod(len(found.case), len(etas))
    if rest or (np.bincount(found.case, minlength=len(etas)) != count).any():
        raise ArithmeticError(f"the number of equilibria changes for β = {beta:g} between η = {left:g} and {right:g}")
    columns = [np.reshape(part, (len(etas), count)).T for part in (found.y, found.z, found.index)]
    return [Piece(etas, y, z, int(index[len(etas) // 2])) for y, z, index in zip(*columns, strict=True)]
