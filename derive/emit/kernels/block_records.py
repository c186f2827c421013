"""Records of arrays: named tuples, in one another, of arrays over the same rods and of what all of them share."""

from __future__ import annotations

from numpy import ndarray


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
