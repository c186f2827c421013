"""The scalar arithmetic of the kernels on Python floats. The mpmath twin replaces this file, name by name."""

from __future__ import annotations

from math import acos, asin, asinh, atan, atan2, ceil, cos, exp, floor, inf, isfinite, log, pi, sin, sqrt

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


def epsilon() -> float:
    """The spacing of numbers just above 1."""
    return 2.0**-52


def where(condition, yes, no):
    """``yes`` if the condition holds, else ``no``; on arrays one for each element."""
    return yes if condition else no


def largest(x):
    """The largest element: of a number, itself."""
    return x


def real(name: str, value: object) -> float:
    """A finite real number as a float; TypeError or ValueError names the argument that is none."""
    numeric = getattr(getattr(value, "dtype", None), "kind", "f") in "fiu" and not getattr(value, "ndim", 0)
    if isinstance(value, (str, bytes, bool, complex)) or not numeric or not hasattr(value, "__float__"):
        raise TypeError(f"{name} must be a real number, got {value!r}")
    try:
        number = float(value)
    except (TypeError, ValueError):
        raise TypeError(f"{name} must be a real number, got {value!r}") from None
    except OverflowError:
        raise ValueError(f"{name} must be finite, got a number too large for a double") from None
    if not isfinite(number):
        raise ValueError(f"{name} must be finite, got {value!r}")
    return number
