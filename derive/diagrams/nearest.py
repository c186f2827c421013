"""Where a smooth curve, known from samples, comes nearest to zero without a change of sign between them."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence

GOLDEN = (3 - math.sqrt(5)) / 2


def extrema(miss: Callable[[float], float], places: Sequence[tuple[float, float]]) -> list[tuple[float, float]]:
    """Extrema near the goal, between samples that are all on one side of it, by golden sections."""
    found = []
    for (left, one), (middle, two), (right, three) in zip(places, places[1:], places[2:], strict=False):
        # All on one side, the middle nearest to the goal, and nearer than its neighbours' bend may carry it.
        if one * two > 0 and two * three > 0 and abs(two) <= min(abs(one), abs(three)):
            reach = max(abs(one), abs(three)) - abs(two)
            if abs(two) <= reach:
                found.append(nearest(miss, left, middle, right, two))
    return found


def nearest(
    miss: Callable[[float], float], left: float, middle: float, right: float, value: float
) -> tuple[float, float]:
    """Where the curve comes nearest to the goal, or the first place beyond it."""
    side = math.copysign(1.0, value)
    while right - left > 1e-8:
        wide = right - middle > middle - left
        trial = middle + GOLDEN * ((right if wide else left) - middle)
        new = miss(trial)
        if new * side <= 0:
            return trial, new
        if new * side < value * side:
            left, right = (middle, right) if wide else (left, middle)
            middle, value = trial, new
        elif wide:
            right = trial
        else:
            left = trial
    return middle, value
