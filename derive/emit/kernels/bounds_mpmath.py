"""What the mpmath twin refuses: what differs from ``bounds``."""

from __future__ import annotations

from mpmath import inf, nstr

__all__ = ["LARGEST", "MANY", "briefly"]

LARGEST = inf  # its numbers have no largest one
MANY = 10_000  # equilibria of one rod: a minute or two in few digits


def briefly(number):
    """A number in a few digits."""
    return nstr(number, 3)
