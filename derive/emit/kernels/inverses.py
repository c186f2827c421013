"""Inverse functions at the ends of their domains: what rounding has put beyond the end counts as the end."""

from __future__ import annotations

from derive.emit.kernels.array_arithmetic import each_acos, each_acosh, each_asin, each_max, each_min


def near_acos(x):
    """arccos x for −1 ≤ x ≤ 1."""
    return each_acos(each_max(each_min(x, 1), -1))


def near_asin(x):
    """arcsin x for −1 ≤ x ≤ 1."""
    return each_asin(each_max(each_min(x, 1), -1))


def near_acosh(x):
    """The positive inverse of cosh for x ≥ 1."""
    return each_acosh(each_max(x, 1))
