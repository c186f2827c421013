"""Zeros of heights that are followed along a parameter, where some of them appear and disappear on the way."""

from __future__ import annotations

from typing import NamedTuple

from derive.emit.kernels.arithmetic import inf, sqrt
from derive.emit.kernels.search import bracketed_root, dip

# An interval of the parameter is halved down to this share of it to find where a height appears or disappears.
LEAST = 1e-12
# Where one disappears and another one of its group appears, within the least interval, their heights differ by less.
LEAP = 1e-5


class Row(NamedTuple):
    """What is at a place of the parameter: by key, records that have a key, a group and a height."""

    place: float
    values: dict


class Bracket(NamedTuple):
    """Places between which the height of a key changes sign."""

    key: tuple
    low: float
    high: float
    low_height: float
    high_height: float


def zeros(values_at, places, origin, least=LEAST):
    """(key, place) wherever a height that is followed vanishes; origin: the place from which widths are measured.

    values_at(place, key): the records by key, at least the one of this key unless it is None.
    """
    rows = follow(values_at, places, origin, least)
    found, crossed = [], []
    for low, high in zip(rows, rows[1:], strict=False):
        crossed += changes(low, high)
        if share(low, high, origin) <= least:
            found += leaps(low, high)
    for triple in zip(rows, rows[1:], rows[2:], strict=False):
        crossed += touched(values_at, triple)
    for bracket in crossed:
        place = root(values_at, bracket)
        if place is not None:
            found.append((bracket.key, place))
        elif (bracket.high - bracket.low) / (bracket.high - origin) > least:
            width = (bracket.high - bracket.low) / 8
            inner = [bracket.low, *(bracket.low + k * width for k in range(1, 8)), bracket.high]
            found += [item for item in zeros(values_at, inner, origin, least) if item[0] == bracket.key]
    return found


def share(low, high, origin):
    """The width of an interval, as a share of the parameter."""
    return (high.place - low.place) / (high.place - origin)


def follow(values_at, places, origin, least):
    """Rows so dense that the same keys are on both sides, or the interval is negligible."""
    rows = [Row(places[0], values_at(places[0], None))]
    todo = [Row(place, values_at(place, None)) for place in places[:0:-1]]
    while todo:
        low, high = rows[-1], todo[-1]
        wide = share(low, high, origin)
        if wide > least and any(abs(item.height) < 2 * sqrt(wide) for item in lonely(low, high) + lonely(high, low)):
            middle = (low.place + high.place) / 2
            todo.append(Row(middle, values_at(middle, None)))
        else:
            rows.append(todo.pop())
    return rows


def lonely(row, other):
    """What is in a row, and not in the other one."""
    return [item for key, item in row.values.items() if key not in other.values]


def changes(low, high):
    """The changes of sign between two rows."""
    found = []
    for key, item in low.values.items():
        if key in high.values:
            before, after = item.height, high.values[key].height
            if before != 0 and (before < 0) != (after < 0):
                found.append(Bracket(key, low.place, high.place, before, after))
    return found


def leaps(low, high):
    """The changes of sign of what goes over from one key to another within a negligible interval."""
    found = []
    for item in lonely(low, high):
        for other in lonely(high, low):
            small = abs(item.height) < LEAP and abs(other.height) < LEAP
            if small and item.group == other.group and item.height != 0 and (item.height < 0) != (other.height < 0):
                first = abs(item.height) < abs(other.height)
                found.append((item.key, low.place) if first else (other.key, high.place))
    return found


def touched(values_at, triple):
    """The changes of sign beside an extremum in the parameter that goes beyond zero between three rows."""
    found = []
    for key in triple[1].values:
        if not all(key in row.values for row in triple):
            continue
        heights = [row.values[key].height for row in triple]
        side = 1 if heights[1] > 0 else -1
        before, here, after = (side * height for height in heights)
        if not (0 < here < before and here < after) or here > max(before - here, after - here):
            continue
        best = lowest(values_at, triple, key, side)
        if key in best.values and side * best.values[key].height < 0:
            height = best.values[key].height
            found.append(Bracket(key, triple[0].place, best.place, heights[0], height))
            found.append(Bracket(key, best.place, triple[2].place, height, heights[2]))
    return found


def lowest(values_at, triple, key, side):
    """The row at which side·height is least, or the first one found below zero."""

    def sample(place):
        return Row(place, values_at(place, key))

    def short(row):
        return side * row.values[key].height if key in row.values else inf

    return dip(sample, short, *triple)


def root(values_at, bracket):
    """Where the height of a key vanishes; None if the key is not there all the way."""

    def function(place):
        return values_at(place, bracket.key)[bracket.key].height

    try:
        return bracketed_root(function, *bracket[1:], 0)
    except KeyError:
        return None
