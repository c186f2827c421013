"""Elementwise arithmetic of the kernels on NumPy arrays. The mpmath twin replaces this file, name by name."""

from __future__ import annotations

from numpy import abs as each_abs
from numpy import arccos as each_acos
from numpy import arcsin as each_asin
from numpy import arcsinh as each_asinh
from numpy import arctan as each_atan
from numpy import arctan2 as each_atan2
from numpy import ceil as each_ceil
from numpy import cos as each_cos
from numpy import exp as each_exp
from numpy import floor as each_floor
from numpy import isfinite as each_isfinite
from numpy import log as each_log
from numpy import max as largest
from numpy import maximum as each_max
from numpy import minimum as each_min
from numpy import sin as each_sin
from numpy import sqrt as each_sqrt
from numpy import where as each_where

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
