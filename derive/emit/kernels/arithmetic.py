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
    "log",
    "pi",
    "real",
    "sin",
    "sqrt",
]


def epsilon() -> float:
    """The spacing of numbers just above 1."""
    return 2.0**-52


def real(name: str, value: object) -> float:
    """A finite real number as a float; TypeError or ValueError names the argument that is none."""
    if isinstance(value, (str, bytes, bool, complex)) or not hasattr(value, "__float__"):
        raise TypeError(f"{name} must be a real number, got {value!r}")
    number = float(value)
    if not isfinite(number):
        raise ValueError(f"{name} must be finite, got {value!r}")
    return number
