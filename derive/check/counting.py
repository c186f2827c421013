"""How many equilibria a rod has, for one field or for every field of an interval, proved by enclosures.

The tips are cut into boxes. A box where the gap has one sign holds no equilibrium; where its derivative by the tip has
one sign it holds at most one. A row of neighbouring boxes of the second kind holds one if the gap changes its sign from
end to end, none if it does not. What is undecided is cut again.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from functools import cache
from itertools import groupby, pairwise

import numpy as np
from numpy.typing import NDArray

from derive.check import balls
from derive.check.balls import Array, Ball
from derive.check.shooting import Rod, gaps, shoot

BOXES = 128  # at first
CUTS = 16  # of a box
FIELDS = 8  # intervals of fields at first
SLABS = 64  # intervals of fields for single tips
BARRIERS = 48  # tips tried as barriers
MOST = 20_000  # boxes at a time
LAST = 2 * np.pi * (1 + 1e-12)  # a little beyond 2π, which is no double


@dataclass(frozen=True)
class _Row:
    """Neighbouring boxes in which the gap is monotone, for one interval of fields."""

    low: float
    high: float


@cache
def count(rod: Rod, eta: Fraction) -> int | None:
    """The number of equilibria in one field; None if it is not decided."""
    if rod.across or not 0 < rod.clamp < 2 or rod.beta < 0 or eta < 0:
        raise ValueError("equilibria are counted for fields along the force and clamps between 0 and 2π")
    return _count(rod, rod.fields(eta, eta))


@cache
@balls.unbounded
def alone(rod: Rod, low: Fraction, high: Fraction, *, sense: int = 0, tips: tuple[float, float] = (0.0, LAST)) -> bool:
    """Is it proved that for every η from low to high there is one equilibrium with its tip between two angles?

    sense: 1 or −1 if it must be proved too that the displacement of its tip rises, or falls, with η.

    Boxes of tips and fields are cut until in each the gap or its derivative by the tip has one sign. The gap must be
    negative at the first tip, positive at the last, and rise with the tip wherever it may vanish: then it vanishes
    once, and the equilibria make one curve over η. Without other limits the first is 0 and the last 2π, where a rod is
    straight.
    """
    fields = rod.fields(low, high)
    for end, sign in zip(tips, (-1, 1), strict=True):
        if not np.all(gaps(rod, np.full(SLABS, end), _slabs(fields, SLABS)).sign() == sign):
            return False
    boxes = _boxes(fields, tips)
    for _ in range(CUTS):
        shot = shoot(rod, balls.between(boxes[0], boxes[1]), balls.between(boxes[2], boxes[3]))
        slopes, maybe = shot.gap_by_tip.sign(), shot.gap.sign() == 0
        # Along the curve the displacement changes by H as this over the slope; H falls with η if the field is across.
        change = shot.sag_by_field * shot.gap_by_tip - shot.sag_by_tip * shot.gap_by_field
        senses = change.sign() * (-1 if rod.across else 1)
        if np.any(maybe & ((slopes < 0) | ((slopes > 0) & (senses * sense < 0)))):
            return False
        open_boxes = maybe & ((slopes == 0) | ((sense != 0) & (senses == 0)))
        by_tip = shot.gap_by_tip.size() * (boxes[1] - boxes[0]) > shot.gap_by_field.size() * (boxes[3] - boxes[2])
        boxes = _halved(boxes[:, open_boxes], by_tip[open_boxes])
        if not boxes.size:
            return True
        if boxes.shape[1] > MOST:
            return False
    return False


def _slabs(fields: Ball, number: int) -> Ball:
    """An interval of fields in parts."""
    edges = np.linspace(float(fields.lower()), float(fields.upper()), number + 1)
    return balls.between(edges[:-1], edges[1:])


def _boxes(fields: Ball, tips: tuple[float, float]) -> Array:
    """The first boxes: four rows, the ends of the tips and of the fields."""
    by_tip = np.linspace(*tips, BOXES // 2 + 1)
    by_field = np.linspace(float(fields.lower()), float(fields.upper()), FIELDS + 1)
    return np.array([(a, b, c, d) for a, b in pairwise(by_tip) for c, d in pairwise(by_field)]).T


@cache
def barrier(rod: Rod, high: Fraction, tips: tuple[float, float]) -> float | None:
    """A tip angle between two at which the gap is positive for every η from 0 to high; None if none is found.

    No curve of equilibria over these fields goes from one side of it to the other.
    """
    fields = _slabs(rod.fields(Fraction(0), high), SLABS)
    for tip in np.linspace(*tips, BARRIERS + 2)[1:-1]:
        if np.all(gaps(rod, np.full(SLABS, tip), fields).sign() == 1):
            return float(tip)
    return None


def _halved(boxes: Array, by_tip: NDArray[np.bool_]) -> Array:
    """Boxes cut in two, across the side along which the gap changes more."""
    parts = []
    for rows, chosen in (((0, 1), by_tip), ((2, 3), ~by_tip)):
        some = boxes[:, chosen]
        middle = (some[rows[0]] + some[rows[1]]) / 2
        first, second = some.copy(), some.copy()
        first[rows[1]] = middle
        second[rows[0]] = middle
        parts += [first, second]
    return np.concatenate(parts, axis=1)


def _count(rod: Rod, field: Ball) -> int | None:
    rows = _rows(rod, field)
    if rows is None:
        return None
    if not rows:
        return 0
    signs = gaps(rod, np.array([end for row in rows for end in (row.low, row.high)]), field).sign().reshape(-1, 2)
    if np.any(signs == 0):
        return None
    return int(np.sum(signs[:, 0] != signs[:, 1]))


def _rows(rod: Rod, field: Ball) -> list[_Row] | None:
    """All rows; None if a box stays undecided."""
    ends = np.linspace(0.0, LAST, BOXES + 1)
    low, high = ends[:-1], ends[1:]
    kept: list[tuple[float, float, int]] = []
    for _ in range(CUTS):
        shot = shoot(rod, balls.between(low, high), Ball(field.mid + 0 * low, field.rad + 0 * low))
        open_boxes = shot.gap.sign() == 0
        slopes = shot.gap_by_tip.sign()
        done = open_boxes & (slopes != 0)
        kept += zip(low[done].tolist(), high[done].tolist(), slopes[done].tolist(), strict=True)
        low, high = _cut(low[open_boxes & ~done], high[open_boxes & ~done])
        if not low.size:
            return _joined(kept)
    return None


def _cut(low: Array, high: Array) -> tuple[Array, Array]:
    middle = (low + high) / 2
    return np.concatenate([low, middle]), np.concatenate([middle, high])


def _joined(boxes: list[tuple[float, float, int]]) -> list[_Row]:
    """Neighbours of one sense as rows."""
    boxes = sorted(boxes)
    starts = [n for n, box in enumerate(boxes) if n == 0 or boxes[n - 1][1] != box[0] or boxes[n - 1][2] != box[2]]
    number = {n: k for k, n in enumerate(starts)}
    labels, label = [], -1
    for n in range(len(boxes)):
        label = number.get(n, label)
        labels.append(label)
    rows = []
    for _, group in groupby(zip(labels, boxes, strict=True), key=lambda one: one[0]):
        members = [box for _, box in group]
        rows.append(_Row(members[0][0], members[-1][1]))
    return rows
