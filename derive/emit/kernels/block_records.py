"""Records of arrays: named tuples, in one another, of arrays over the same rods and of what all of them share."""

from __future__ import annotations

from numpy import broadcast_to, concatenate, flatnonzero, ndarray

AT_ONCE = 2048  # rows at once where there are many arrays: they stay in the cache, and in memory that is there already


def slab(grid, which, values):
    """Some of a parameter's values, by a slice of their flat numbers in the grid; what is folded stays as it is."""
    return broadcast_to(values, grid).flat[which]


def element(case, values):
    """A parameter of one rod as a number; what is folded stays as it is."""
    return float(values[case])


def each_array(record, change, done=None):
    """The record with ``change`` made to every array in it, once to each: directions stand in it more than once."""
    done = {} if done is None else done
    parts = []
    for part in record:
        if isinstance(part, (ndarray, tuple)):
            key = id(part)
            changed = done.get(key)
            if changed is None:
                done[key] = changed = change(part) if isinstance(part, ndarray) else each_array(part, change, done)
            part = changed
        parts.append(part)
    return tuple.__new__(type(record), parts)


def rows(record, which):
    """The record of some of the rods, by their numbers, a mask or a slice: the record itself for a mask of all."""
    if isinstance(which, slice):
        return each_array(record, lambda array: array[which])
    if which.dtype == bool:
        size, which = which.size, flatnonzero(which)
        if which.size == size:
            return record
    return each_array(record, lambda array: array.take(which))


def put_rows(record, which, other):
    """The record with other values for some of the rods, in its own arrays."""
    for part, values in zip(record, other, strict=True):
        if isinstance(part, ndarray):
            part[which] = values
        elif isinstance(part, tuple):
            put_rows(part, which, values)
    return record


def rounded_to(record, kind):
    """The record with its arrays in another precision; numbers that all rods share take that of what they meet."""
    return each_array(record, lambda array: array.astype(kind, copy=False))


def joined(records):
    """Records of arrays, one after another; what all rods share is taken from the first."""
    first = records[0]
    if len(records) == 1:
        return first
    if isinstance(first, ndarray):
        return concatenate(records)
    if isinstance(first, tuple):
        parts = [joined(list(column)) for column in zip(*records, strict=True)]
        return type(first)(*parts) if hasattr(first, "_fields") else tuple(parts)
    return first
