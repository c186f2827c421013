"""Ranges of a load, checked before any work."""

from __future__ import annotations

from collections.abc import Iterable

from derive.emit.kernels.arithmetic import in_a_line, real


def span(name, ends):
    """(low, high) with 0 ≤ low < high, or an error that names the argument."""
    if isinstance(ends, (str, bytes)) or not isinstance(ends, Iterable) or getattr(ends, "ndim", 1) != 1:
        raise TypeError(f"{name} must be a pair (low, high), got {in_a_line(ends)}")
    pair = list(ends)
    if len(pair) != 2:
        raise ValueError(f"{name} must be a pair (low, high), got {in_a_line(ends)}")
    low, high = (real(f"{name}[{place}]", end) for place, end in enumerate(pair))
    if not 0 <= low < high:
        raise ValueError(f"{name} must be a range (low, high) with 0 ≤ low < high, got ({low}, {high})")
    return low, high
