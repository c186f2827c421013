"""Records of arrays: named tuples, in one another, of arrays over the same rods and of what all of them share."""

from __future__ import annotations

from numpy import broadcast_to, concatenate, ndarray


def slab(grid, which, values):
    """Some of a parameter's values, by a slice of their flat numbers in the grid; what is folded stays as it is."""
    return broadcast_to(values, grid).flat[which]


def element(case, values):
    """A parameter of one rod as a number; what is folded stays as it is."""
    return float(values[case])


def each_array(record, change):
    """The record with ``change`` made to every array in it."""
    if isinstance(record, ndarray):
        return change(record)
    if isinstance(record, tuple):
        parts = [each_array(part, change) for part in record]
        return type(record)(*parts) if hasattr(record, "_fields") else tuple(parts)
    return record


def rows(record, which):
    """The record of some of the rods, by their numbers, a mask or a slice."""
    return each_array(record, lambda array: array[which])


def rounded_to(record, kind):
    """The record with its numbers in another precision, those that all rods share as well."""
    if isinstance(record, ndarray):
        return record.astype(kind)
    if isinstance(record, float):
        return kind(record)
    if isinstance(record, tuple):
        parts = [rounded_to(part, kind) for part in record]
        return type(record)(*parts) if hasattr(record, "_fields") else tuple(parts)
    return record


def joined(records):
    """Records of arrays, one after another; what all rods share is taken from the first."""
    first = records[0]
    if isinstance(first, ndarray):
        return concatenate(records)
    if isinstance(first, tuple):
        parts = [joined(list(column)) for column in zip(*records, strict=True)]
        return type(first)(*parts) if hasattr(first, "_fields") else tuple(parts)
    return first
