"""Elementwise arithmetic of the kernels on NumPy arrays. The mpmath twin replaces this file, name by name."""

from __future__ import annotations

from numpy import abs as each_abs
from numpy import arccos as each_acos
from numpy import arccosh as each_acosh
from numpy import arcsin as each_asin
from numpy import arcsinh as each_asinh
from numpy import arctan as each_atan
from numpy import arctan2 as each_atan2
from numpy import copysign, cos, empty, finfo, float32, log1p, logical_or, ndarray, sin, tan
from numpy import exp as each_exp
from numpy import floor as each_floor
from numpy import imag as each_imag
from numpy import log as each_log
from numpy import max as largest
from numpy import maximum as each_max
from numpy import maximum as larger
from numpy import minimum as each_min
from numpy import real as each_real
from numpy import sqrt as each_sqrt
from numpy import where as each_where

__all__ = [
    "each_abs",
    "each_acos",
    "each_acosh",
    "each_any_of",
    "each_arc_excess",
    "each_arctan_share",
    "each_asin",
    "each_asinh",
    "each_atan",
    "each_atan2",
    "each_complex_atanh",
    "each_complex_of",
    "each_complex_sqrt",
    "each_cos",
    "each_exp",
    "each_floor",
    "each_hypot",
    "each_imag",
    "each_less_quarters",
    "each_log",
    "each_max",
    "each_min",
    "each_pick",
    "each_real",
    "each_sin",
    "each_spacing",
    "each_sqrt",
    "each_where",
    "larger",
    "largest",
]


def each_any_of(condition):
    """Whether it holds anywhere, in a fifth of the time of NumPy's function for that."""
    return logical_or.reduce(condition, axis=None)


def each_sin(x):
    """sin x. Of doubles by the tangent of x/2, which takes a fraction of the time of NumPy's sine, to 1.3 spacings."""
    if not in_doubles(x):
        return sin(x)
    tangent = tan(x / 2)
    below = tangent * tangent
    below += 1
    tangent += tangent
    tangent /= below
    return tangent


def each_cos(x):
    """cos x, likewise; to as much of 1."""
    if not in_doubles(x):
        return cos(x)
    tangent = tan(x / 2)
    below, above = tangent * tangent, 1 - tangent
    below += 1
    tangent += 1
    above *= tangent
    above /= below
    return above


def in_doubles(x):
    """Whether this is an array of doubles."""
    return isinstance(x, ndarray) and x.dtype.char == "d"


def each_hypot(x, y):
    """√(x² + y²) of numbers whose squares are none too small."""
    return each_sqrt(x * x + y * y)


def each_spacing(x):
    """The each_spacing of numbers just above 1, in the precision of the array."""
    return float(finfo(x.dtype).eps)


def each_less_quarters(angle, quarters):
    """angle − quarters·π/2, with π/2 in two parts of which the first has 33 bits, so that nothing is lost."""
    return (angle - quarters * 1.5707963267341256) - quarters * 6.077100506506192e-11


def each_pick(condition, yes, no):
    """``yes`` where the condition holds, else ``no``; whole numbers take the precision of what they meet."""
    chosen = each_where(condition, yes, no)
    return chosen.astype(float32) if chosen.dtype.kind in "ib" else chosen


def each_complex_of(real, imaginary):
    """The complex numbers of real and imaginary parts."""
    result = empty(each_max(real, imaginary).shape, dtype=complex)
    result.real, result.imag = real, imaginary
    return result


def each_complex_sqrt(z):
    """The principal √z by real roots, in a third of the time of NumPy's."""
    real, imaginary = z.real, z.imag
    larger_part = each_sqrt((each_abs(z) + each_abs(real)) / 2)
    smaller_part = imaginary / (2 * each_max(larger_part, 1e-300))
    right = real >= 0
    if right.all():
        return each_complex_of(larger_part, smaller_part)
    return each_complex_of(
        each_where(right, larger_part, each_abs(smaller_part)),
        each_where(right, smaller_part, copysign(larger_part, imaginary)),
    )


def each_complex_atanh(root, end):
    """artanh r for Re r ≥ 0 and end = 1 − r², by real functions: no digits are lost where r is small, or near 1."""
    x, y, left, below = root.real, root.imag, end.real, end.imag
    ahead, less, more, small = 1 + root, 1 - x, 1 + x, x < 0.5
    # 1/|1 − r|², and the argument of (1 + r)/(1 − r): by its tangent 2 Im r/(1 − |r|²), or of (1 + r)²/end.
    share = each_where(small, 1 / (less * less + y * y), (more * more + y * y) / (left * left + below * below))
    turned = ahead * ahead * end.conjugate()
    angle = each_atan2(each_where(small, 2 * y, turned.imag), each_where(small, left - 2 * y * y, turned.real))
    return each_complex_of(log1p(4 * x * share) / 4, angle / 2)


def each_arc_excess(x):
    """x − sin x, by its series where x is small."""
    square = x * x
    share = 1.0
    for number in (272, 210, 156, 110, 72, 42, 20):
        share = 1 - square / number * share
    return each_where(x > 1, x - each_sin(x), x * square / 6 * share)


def each_arctan_share(z, end):
    """R_C(1, end) for complex end = 1 + z: arctan(√z)/√z, by its series where z is small (DLMF 19.2.18)."""
    size = each_abs(z)
    far = size >= 1e-3
    if far.all():
        root = each_complex_sqrt(-z)
        return each_complex_atanh(root, end) / root
    if not each_any_of(size >= 3e-6):
        return 1 - z * (1 / 3 - z / 5)
    share = 1 - z * (1 / 3 - z * (1 / 5 - z * (1 / 7 - z * (1 / 9 - z / 11))))
    if each_any_of(far):
        share[far] = each_arctan_share(z[far], end[far])
    return share
