"""Zeros of values that are followed along a parameter, where some of them appear and disappear on the way."""

from __future__ import annotations

from typing import NamedTuple

from derive.emit.kernels.arithmetic import inf, sqrt
from derive.emit.kernels.search import bracketed_root, dip

# An interval of the parameter is halved down to this share of it to find where a value appears or disappears.
LEAST = 1e-12


class Row(NamedTuple):
    """The values at a place of the parameter: by key, records that have a height."""

    place: float
    values: dict


def zeros(values_at, places, origin, least=LEAST):
    """(key, place) wherever a followed height vanishes; origin: the place from which widths are measured.

    values_at(place, key): the records by key, at least the one of this key unless it is None.
    """
    rows = follow(values_at, places, origin, least)
    found = []
    for k in range(1, len(rows)):
        low, high = rows[k - 1], rows[k]
        for key, before, after in pairs(low, high, origin):
            if before.height != 0 and (before.height < 0) != (after.height < 0):
                found.append((key, low.place, high.place, before.height, after.height))
    for k in range(1, len(rows) - 1):
        found += touched(values_at, rows[k - 1 : k + 2])
    return [(key, root(values_at, key, *ends)) for key, *ends in found]


def follow(values_at, places, origin, least):
    """Rows so dense that the same keys are on both sides, or the interval is negligible."""
    rows = [Row(places[0], values_at(places[0], None))]
    todo = [Row(place, values_at(place, None)) for place in places[:0:-1]]
    while todo:
        low, high = rows[-1], todo[-1]
        wide = (high.place - low.place) / (high.place - origin)
        if wide > least and lonely(low, high, wide):
            middle = (low.place + high.place) / 2
            todo.append(Row(middle, values_at(middle, None)))
        else:
            rows.append(todo.pop())
    return rows


def lonely(low, high, wide):
    """Whether a value near enough to zero to reach it on the way is only on one side."""
    near = 2 * sqrt(wide)
    return any(
        abs(item.height) < near
        for one, other in ((low, high), (high, low))
        for key, item in one.values.items()
        if key not in other.values
    )


def pairs(low, high, origin):
    """(key, value, value) of what is the same on both sides."""
    both = [(key, low.values[key], high.values[key]) for key in low.values if key in high.values]
    return both


def touched(values_at, triple):
    """The intervals beside an extremum in the parameter that goes beyond zero between three rows."""
    found = []
    for key in triple[1].values:
        if not all(key in row.values for row in triple):
            continue
        before, here, after = (row.values[key].height for row in triple)
        side = 1 if here > 0 else -1
        before, here, after = side * before, side * here, side * after
        if not (0 < here < before and here < after) or here > max(before - here, after - here):
            continue

        def sample(place, key=key):
            return Row(place, values_at(place, key))

        def short(row, key=key, side=side):
            return side * row.values[key].height if key in row.values else inf

        best = dip(sample, short, *triple)
        if short(best) < 0:
            height = best.values[key].height
            found.append((key, triple[0].place, best.place, side * before, height))
            found.append((key, best.place, triple[2].place, height, side * after))
    return found


def root(values_at, key, low, high, at_low, at_high):
    """Where the height of a key vanishes."""

    def function(place):
        return values_at(place, key)[key].height

    return bracketed_root(function, low, high, at_low, at_high)
