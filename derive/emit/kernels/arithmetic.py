"""The scalar arithmetic of the kernels on Python floats. The mpmath twin replaces this file, name by name."""

from __future__ import annotations

from cmath import atanh as complex_atanh
from cmath import log as complex_log
from cmath import sqrt as complex_sqrt
from math import (
    acos,
    asin,
    asinh,
    atan,
    atan2,
    ceil,
    cos,
    exp,
    floor,
    frexp,
    hypot,
    inf,
    isfinite,
    ldexp,
    log,
    pi,
    sin,
    sinh,
    sqrt,
    tan,
)

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


def epsilon() -> float:
    """The spacing of numbers just above 1."""
    return 2.0**-52


def spacing(x):
    """The spacing of numbers just above 1, in the precision of x."""
    return 2.0**-52


def in_a_line(value):
    """The text of a value for an error, which is one line."""
    return " ".join(repr(value).split())


def real(name: str, value: object) -> float:
    """A finite real number as a float; TypeError or ValueError names the argument that is none."""
    numeric = getattr(getattr(value, "dtype", None), "kind", "f") in "fiu" and not getattr(value, "ndim", 0)
    masked = hasattr(value, "mask")
    if masked or isinstance(value, (str, bytes, bool, complex)) or not numeric or not hasattr(value, "__float__"):
        raise TypeError(f"{name} must be a real number, got {in_a_line(value)}")
    try:
        number = float(value)
    except (TypeError, ValueError):
        raise TypeError(f"{name} must be a real number, got {in_a_line(value)}") from None
    except OverflowError:
        raise ValueError(f"{name} must be finite, got a number too large for a double") from None
    if not isfinite(number):
        raise ValueError(f"{name} must be finite, got {value!r}")
    return number


def less_quarters(angle, quarters):
    """angle − quarters·π/2, with π/2 in two parts of which the first has 33 bits, so that nothing is lost."""
    return (angle - quarters * 1.5707963267341256) - quarters * 6.077100506506192e-11


def plus_quarters(angle, quarters):
    """angle + quarters·π/2, rounded once where the sum is large."""
    return (angle + quarters * 6.077100506506192e-11) + quarters * 1.5707963267341256


def apart_by_quarters(angle, quarters):
    """Two numbers that add up to angle + quarters·π/2, of which only the sum is rounded at its size."""
    return quarters * 1.5707963267341256, angle + quarters * 6.077100506506192e-11


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
    """How far down, in the logarithm of the share of a width, the square of an offset is still a number."""
    return max(40.0, 300 + log(width))


def roughly(work):
    """What some work gives, where a few digits of it will do: doubles have no fewer."""
    return work()


def complex_of(real, imaginary):
    """The complex number of a real and an imaginary part."""
    return complex(real, imaginary)


def arc_excess(x):
    """x − sin x, by its series where x is small."""
    if x > 1:
        return x - sin(x)
    square, share = x * x, 1.0
    for number in (272, 210, 156, 110, 72, 42, 20):
        share = 1 - square / number * share
    return x * square / 6 * share


def arctan_share(z, end):
    """R_C(1, end) for complex end = 1 + z: arctan(√z)/√z (DLMF 19.2.18), by its series where z is small.

    The logarithm is of a number near 1 unless z is large, and then its last digits are few.
    """
    size = abs(z)
    if size < 1e-3:
        return 1 - z * (1 / 3 - z * (1 / 5 - z * (1 / 7 - z * (1 / 9 - z / 11))))
    root = complex_sqrt(-z)
    if size < 0.5:
        return complex_atanh(root) / root
    return complex_log((1 + root) * (1 + root) / end) / (2 * root)
