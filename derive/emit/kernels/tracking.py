"""Zeros of heights that are followed along a parameter, where some of them appear and disappear on the way."""

from __future__ import annotations

from itertools import pairwise
from typing import Any, NamedTuple

from derive.emit.kernels.arithmetic import inf, sqrt
from derive.emit.kernels.roots import bracketed_root, dip

# An interval of the parameter is halved down to this share of it to find where a height appears or disappears.
LEAST = 1e-12
# Where one disappears and another one of its group appears, within the least interval, their heights differ by less.
LEAP = 1e-5
# A spot moves by less than this from row to row, or it is not the same one's.
FURTHEST = 3


class Row(NamedTuple):
    """What is at a place of the parameter: by key, lists of records in the order of their spots.

    A record has a spot, by which it is told from others of its key, a group, which it keeps if it goes over to
    another key, and a height.
    """

    place: float
    values: dict


class Bracket(NamedTuple):
    """Places between which the height of a record changes sign, and the record on either side."""

    key: tuple
    low: float
    high: float
    before: Any
    after: Any


def zeros(values_at, places, origin, least):
    """The records, each at the place of the parameter where its height vanishes.

    values_at(place, key): the records by key, at least those of this key unless it is None. origin: the place from
    which widths are measured.
    """
    rows = follow(values_at, places, origin, least)
    found, crossed = [], []
    for low, high in pairwise(rows):
        crossed += changes(low, high)
        if share(low, high, origin) <= least:
            found += leaps(low, high)
    for triple in zip(rows, rows[1:], rows[2:], strict=False):
        crossed += touched(values_at, triple)
    found += [record for record in (root(values_at, bracket) for bracket in crossed) if record is not None]
    return found


def share(low, high, origin):
    """The width of an interval, as a share of the parameter."""
    return (high.place - low.place) / (high.place - origin)


def follow(values_at, places, origin, least):
    """Rows so dense that the same records are on both sides, or the interval is negligible."""
    rows = [Row(places[0], values_at(places[0], None))]
    todo = [Row(place, values_at(place, None)) for place in places[:0:-1]]
    while todo:
        low, high = rows[-1], todo[-1]
        wide = share(low, high, origin)
        alone = [record for records in lonely(low, high) for record in records]
        if wide > least and any(abs(record.height) < 2 * sqrt(wide) for record in alone):
            middle = (low.place + high.place) / 2
            todo.append(Row(middle, values_at(middle, None)))
        else:
            rows.append(todo.pop())
    return rows


def matched(low, high):
    """(key, record, record) for what is on both sides: the nearest spots of a key, in their order."""
    found = []
    for key, here in low.values.items():
        there, first = high.values.get(key, []), 0
        turned = len(here) > len(there)
        few, many = (there, here) if turned else (here, there)
        for k, record in enumerate(few):
            last = len(many) - (len(few) - k) + 1
            best = min(range(first, last), key=lambda j: abs(many[j].spot - record.spot))
            first = best + 1
            if abs(many[best].spot - record.spot) < FURTHEST:
                found.append((key, many[best], record) if turned else (key, record, many[best]))
    return found


def lonely(low, high):
    """The records that are in the first row only, and in the second one only."""
    pairs = matched(low, high)
    kept = {id(record) for _, before, after in pairs for record in (before, after)}
    return [[item for items in row.values.values() for item in items if id(item) not in kept] for row in (low, high)]


def changes(low, high):
    """The changes of sign between two rows."""
    return [
        Bracket(key, low.place, high.place, before, after)
        for key, before, after in matched(low, high)
        if before.height != 0 and (before.height < 0) != (after.height < 0)
    ]


def leaps(low, high):
    """The changes of sign of what goes over from one key to another within a negligible interval."""
    found = []
    first, second = lonely(low, high)
    for item in first:
        for other in second:
            small = abs(item.height) < LEAP and abs(other.height) < LEAP
            if small and item.group == other.group and item.height != 0 and (item.height < 0) != (other.height < 0):
                found.append(item if abs(item.height) < abs(other.height) else other)
    return found


def touched(values_at, triple):
    """The changes of sign beside an extremum in the parameter that goes beyond zero between three rows."""
    low, middle, high = triple
    found = []
    later = {id(record): after for _, record, after in matched(middle, high)}
    for key, before, record in matched(low, middle):
        after = later.get(id(record))
        if after is None:
            continue
        side = 1 if record.height > 0 else -1
        left, here, right = side * before.height, side * record.height, side * after.height
        if not (0 < here < left and here < right) or here > max(left - here, right - here):
            continue
        place, best = lowest(values_at, triple, key, record.spot, side)
        if best is not None and side * best.height < 0:
            found.append(Bracket(key, low.place, place, before, best))
            found.append(Bracket(key, place, high.place, best, after))
    return found


def lowest(values_at, triple, key, spot, side):
    """Where side·height is least, or first found below zero, and the record there."""

    def sample(place):
        return Row(place, values_at(place, key))

    def short(row):
        record = nearest(row.values, key, spot)
        return inf if record is None else side * record.height

    best = dip(sample, short, *triple)
    return best.place, nearest(best.values, key, spot)


def nearest(values, key, spot):
    """The record of a key that is nearest to a spot; None if there is none."""
    return min(values.get(key, []), key=lambda record: abs(record.spot - spot), default=None)


def root(values_at, bracket):
    """The record where its height vanishes; None if it does not, for the record is not there all the way."""
    key, low, high, before, after = bracket

    def record_at(place):
        spot = before.spot + (place - low) / (high - low) * (after.spot - before.spot)
        return nearest(values_at(place, key), key, spot)

    def function(place):
        record = record_at(place)
        return before.height if record is None else record.height

    record = record_at(bracketed_root(function, (low, high), (before.height, after.height), 0))
    return record if record is not None and abs(record.height) < LEAP else None
