"""A second small theory and kernels: formulas for any field angle, and a kernel file that is wanted on arrays, too."""

from __future__ import annotations

from types import SimpleNamespace

from sympy import Rational, Symbol, cos, sin, sqrt, symbols

from derive.theory.claims import Formula
from derive.theory.symbols import beta, eta

field_angle = Symbol("field_angle", real=True)
angle, middle, half = symbols("angle middle half", real=True)
width = Symbol("width", positive=True)


def _formula(name, arguments, expression, case="oblique"):
    return Formula(name, tuple(arguments), expression, f"swing.{name}", f"Stand-in for {name}", case, "wel12")


MOMENT = beta * sin(angle) + Rational(1, 2) * eta * sin(2 * (angle - field_angle))
FORMULAS = (
    _formula("moment", (beta, eta, field_angle, angle), MOMENT),
    _formula(
        "strength",
        (beta, eta, field_angle, middle, half),
        2 * beta * cos(middle) + eta * cos(half) * cos(2 * (middle - field_angle)) + Rational(1, 3) * eta,
    ),
    _formula("slope", (width, angle), sqrt(width + sin(angle) ** 2)),
    _formula("opposite", (beta, eta), -beta / eta),
    # One load case has a form of its own.
    _formula("slope", (width, angle), sqrt(width + 1 - cos(angle) ** 2), "orthogonal"),
)
THEORY = SimpleNamespace(formulas=FORMULAS)
INSTANCES = {"motion": "motion_each", "waves": "waves_each"}

KERNELS = {
    "arithmetic": '''
"""Scalars."""
from math import cos, floor, inf, pi, sin, sqrt

def epsilon():
    """Spacing."""
    return 2.0**-52

def where(condition, yes, no):
    """A choice."""
    return yes if condition else no
''',
    "arguments_mpmath": '''
"""Arguments."""
from mpmath import mp

def digits(dps):
    """Digits to work with."""
    return mp.dps if dps is None else dps
''',
    "arithmetic_mpmath": '''
"""Scalars."""
from mpmath import cos, eps, mpf, pi, sin, sqrt

def epsilon():
    """Spacing."""
    return +eps

def where(condition, yes, no):
    """A choice."""
    return yes if condition else no
''',
    "array_arithmetic": '''
"""Arrays."""
from numpy import abs as each_abs
from numpy import cos as each_cos
from numpy import maximum as each_max
from numpy import sin as each_sin
from numpy import sqrt as each_sqrt
from numpy import where as each_where
''',
    "array_arithmetic_mpmath": '"""Arrays."""\nfrom mpmath import sin as each_sin\n',
    "waves": '''
"""Waves."""
from typing import NamedTuple

from derive.emit.kernels.arithmetic import epsilon, pi, sin, where

STEPS = 3


class Wave(NamedTuple):
    """A wave."""

    height: float
    length: float


def wave(place, wave):
    """Its height at a place: zero within rounding of the origin."""
    # A comment that stays.
    value = wave.height * sin(2 * pi * place / wave.length)
    for _ in range(STEPS):
        value = value / 2
    return where(abs(place) < epsilon(), 0 * place, value)
''',
    "motion": '''
"""Motion."""
from derive.emit.kernels.arithmetic import cos, sqrt
from derive.emit.kernels.formulas import moment, slope, strength
from derive.emit.kernels.waves import Wave, wave


def motion(beta, eta, field_angle, angle):
    """Something of everything."""
    swell = wave(angle, Wave(strength(beta, eta, field_angle, angle, cos(angle)), 2))
    return moment(beta, eta, field_angle, angle) + max(swell, 0) * slope(sqrt(1 + beta), angle)
''',
    "api": '''
"""The interface."""
from dataclasses import dataclass
from typing import Any

from derive.emit.kernels.formulas import opposite
from derive.emit.kernels.motion import motion
from derive.emit.kernels.motion_each import motion_each


@dataclass(frozen=True, slots=True)
class Equilibrium:
    """One result.

    tip_angle: what is asked for.
    kept: what a shape needs.
    """

    tip_angle: float
    kept: Any


def equilibria(beta, eta, length, clamp_angle, field_angle):
    """All results.

    field_angle: of the field.
    """
    bottom = opposite(beta, eta) if eta > 0 else 0
    return [Equilibrium(motion(beta, eta, field_angle, clamp_angle) / length, (beta, eta, field_angle, bottom))]


def shape(equilibrium, s):
    """A shape."""
    beta, eta, field_angle, _ = equilibrium.kept
    return motion_each(beta, eta, field_angle, s)


def folds(beta, length, clamp_angle, field_angle):
    """Where results come and go."""
    return [motion(beta, 1, field_angle, clamp_angle) / length]


def exchanges(length, clamp_angle, field_angle):
    """Where they do otherwise."""
    return folds(1, length, clamp_angle, field_angle)


def literal(equilibrium, s):
    """The same in other words."""
    return equilibrium.tip_angle + s
''',
}
