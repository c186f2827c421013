"""The scalar arithmetic of the mpmath twin: the names of ``arithmetic``, at the working precision."""

from __future__ import annotations

from mpmath import acos, asin, asinh, atan, atan2, cos, eps, exp, inf, isfinite, log, mpf, pi, sin, sqrt
from mpmath import ceil as mpf_ceil
from mpmath import floor as mpf_floor

__all__ = [
    "acos",
    "asin",
    "asinh",
    "atan",
    "atan2",
    "ceil",
    "cos",
    "epsilon",
    "exp",
    "floor",
    "inf",
    "isfinite",
    "largest",
    "log",
    "pi",
    "real",
    "sin",
    "sqrt",
    "where",
]


def epsilon():
    """The spacing of numbers just above 1."""
    return +eps


def ceil(x):
    """The least integer that is not below x."""
    return int(mpf_ceil(x))


def floor(x):
    """The greatest integer that is not above x."""
    return int(mpf_floor(x))


def where(condition, yes, no):
    """``yes`` if the condition holds, else ``no``."""
    return yes if condition else no


def largest(x):
    """The largest element: of a number, itself."""
    return x


def real(name, value):
    """A finite real number as an mpf, from a number or its decimal text; TypeError or ValueError names the argument."""
    numeric = getattr(getattr(value, "dtype", None), "kind", "f") in "fiu" and not getattr(value, "ndim", 0)
    try:
        if isinstance(value, (bool, bytes, complex)) or not numeric:
            raise TypeError(name)
        number = mpf(value)
    except (TypeError, ValueError, ZeroDivisionError):
        raise TypeError(f"{name} must be a real number, got {value!r}") from None
    if not isfinite(number):
        raise ValueError(f"{name} must be finite, got {value!r}")
    return number
