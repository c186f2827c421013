"""Elementwise arithmetic of the mpmath twin, where an element is all there is: the names of ``array_arithmetic``."""

from __future__ import annotations

from mpmath import acos as each_acos
from mpmath import asin as each_asin
from mpmath import asinh as each_asinh
from mpmath import atan as each_atan
from mpmath import atan2 as each_atan2
from mpmath import ceil as each_ceil
from mpmath import cos as each_cos
from mpmath import exp as each_exp
from mpmath import floor as each_floor
from mpmath import isfinite as each_isfinite
from mpmath import log as each_log
from mpmath import sin as each_sin
from mpmath import sqrt as each_sqrt

__all__ = [
    "each_abs",
    "each_acos",
    "each_asin",
    "each_asinh",
    "each_atan",
    "each_atan2",
    "each_ceil",
    "each_cos",
    "each_exp",
    "each_floor",
    "each_isfinite",
    "each_log",
    "each_max",
    "each_min",
    "each_sin",
    "each_sqrt",
    "each_where",
    "largest",
]


def each_abs(x):
    """The absolute value."""
    return abs(x)


def each_max(x, y):
    """The larger one."""
    return max(x, y)


def each_min(x, y):
    """The smaller one."""
    return min(x, y)


def each_where(condition, yes, no):
    """``yes`` where the condition holds, else ``no``."""
    return yes if condition else no


def largest(x):
    """The largest element: the element."""
    return x
