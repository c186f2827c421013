"""The scalar arithmetic of the mpmath twin: the names of ``arithmetic``, at the working precision."""

from __future__ import annotations

from mpmath import (
    acos,
    asin,
    asinh,
    atan,
    atan2,
    cos,
    eps,
    exp,
    frexp,
    hypot,
    inf,
    isfinite,
    ldexp,
    log,
    mp,
    mpf,
    pi,
    sin,
    sinh,
    sqrt,
    tan,
    workdps,
)
from mpmath import ceil as mpf_ceil
from mpmath import floor as mpf_floor
from mpmath import mpc as complex_of
from mpmath import sqrt as complex_sqrt

__all__ = [
    "acos",
    "any_of",
    "apart_by_quarters",
    "arc_excess",
    "arctan_share",
    "asin",
    "asinh",
    "atan",
    "atan2",
    "ceil",
    "complex_of",
    "complex_sqrt",
    "cos",
    "deepest",
    "epsilon",
    "exp",
    "floor",
    "frexp",
    "hypot",
    "in_a_line",
    "inf",
    "isfinite",
    "larger",
    "ldexp",
    "less_quarters",
    "log",
    "pi",
    "pick",
    "plus_quarters",
    "real",
    "roughly",
    "sin",
    "sinh",
    "spacing",
    "sqrt",
    "tan",
]


ROUGH_DIGITS = 20  # with which folds are found; Newton's method doubles them


def epsilon():
    """The spacing of numbers just above 1."""
    return +eps


def ceil(x):
    """The least integer that is not below x."""
    return int(mpf_ceil(x))


def floor(x):
    """The greatest integer that is not above x."""
    return int(mpf_floor(x))


def spacing(x):
    """The spacing of numbers just above 1, in the precision of x."""
    return +eps


def in_a_line(value):
    """The text of a value for an error, which is one line."""
    return " ".join(repr(value).split())


def real(name, value):
    """A finite real number as an mpf, from a number or its decimal text; TypeError or ValueError names the argument."""
    numeric = getattr(getattr(value, "dtype", None), "kind", "f") in "fiu" and not getattr(value, "ndim", 0)
    try:
        # A pair would be a mantissa with its exponent; NumPy's numbers are Python's by ``item``.
        if isinstance(value, (bool, bytes, complex, tuple)) or not numeric or hasattr(value, "mask"):
            raise TypeError(name)
        number = mpf(value.item() if hasattr(value, "dtype") else value)
    except (TypeError, ValueError, ZeroDivisionError):
        raise TypeError(f"{name} must be a real number, got {in_a_line(value)}") from None
    if not isfinite(number):
        raise ValueError(f"{name} must be finite, got {value!r}")
    return number


def less_quarters(angle, quarters):
    """angle − quarters·π/2."""
    return angle - quarters * (pi / 2)


def plus_quarters(angle, quarters):
    """angle + quarters·π/2."""
    return angle + quarters * (pi / 2)


def apart_by_quarters(angle, quarters):
    """Two numbers that add up to angle + quarters·π/2."""
    return quarters * (pi / 2), angle


def pick(condition, yes, no):
    """``yes`` where the condition holds, else ``no``."""
    return yes if condition else no


def larger(x, y):
    """The larger one."""
    return x if x > y else y


def any_of(condition):
    """Whether the condition holds anywhere."""
    return condition


def deepest(width):
    """How far down, in the logarithm of the share of a width, the square of an offset is still a number: no limit."""
    return inf


def roughly(work):
    """What some work gives, where a few digits of it will do."""
    with workdps(min(ROUGH_DIGITS, mp.dps)):
        return work()


def arc_excess(x):
    """x − sin x, by its series where x is small."""
    if x > 1:
        return x - sin(x)
    total, power, n = 0, x * x * x / 6, 3
    while abs(power) > eps * total:
        total, power, n = total + power, -power * x * x / ((n + 1) * (n + 2)), n + 2
    return total


def arctan_share(z, end):
    """R_C(1, end) for complex end = 1 + z: arctan(√z)/√z (DLMF 19.2.18).

    By its series where z is small: there mpmath's complex arctangent is a difference of logarithms near 0.
    """
    if abs(z) < 1e-3:
        total, power, n = 1, -z, 3
        while abs(power) > eps:
            total, power, n = total + power / n, -power * z, n + 2
        return total
    if abs(z) < 0.5:
        root = complex_sqrt(z)
        return atan(root) / root
    root = complex_sqrt(-z)
    return log((1 + root) * (1 + root) / end) / (2 * root)
