"""A small theory and small kernels, typed in, for testing the emitter by itself."""

from __future__ import annotations

from types import SimpleNamespace

from sympy import Rational, Symbol, sqrt, symbols

from derive.theory.claims import Formula
from derive.theory.functions import RC, RD, RF, RJ
from derive.theory.symbols import beta, eta

plus, minus, drive, gap, xi_tip, xi, arc = symbols("plus minus drive gap xi_tip xi arc", real=True)
x_plus, x_minus, x_other = symbols("x_plus x_minus x_other", positive=True)
sin_tip = Symbol("sin_tip", real=True)
_POLE = x_other + eta * plus * minus / 4


def _formula(name, arguments, expression, case="oblique"):
    return Formula(name, tuple(arguments), expression, f"tip.{name}", f"Stand-in for {name}", case, "wel12")


FORMULAS = (
    _formula("tip_drive", (beta, eta, xi_tip), beta + eta * xi_tip),
    _formula("tip_gap", (beta, eta, minus), eta * minus - 2 * beta),
    _formula("root_other", (eta, plus, minus), eta * plus * minus / 4),
    _formula("arc_length", (x_plus, x_minus, x_other), RF(x_plus, x_minus, x_other)),
    _formula(
        "arc_y",
        (eta, plus, minus, drive, xi_tip, arc, x_plus, x_minus, x_other),
        xi_tip * arc - Rational(1, 6) * plus * minus * drive * RJ(x_plus, x_minus, x_other, _POLE),
    ),
    _formula("arc_z", (eta, plus, minus, sin_tip, x_other), sin_tip * RC(x_other, _POLE)),
    _formula("cos_bottom", (beta, eta), -beta / eta),
    _formula("tip_drive", (beta, xi_tip), beta, "force_only"),
    _formula("tip_gap", (beta,), -2 * beta, "force_only"),
    _formula("root_other", (), Rational(0), "force_only"),
    _formula("arc_length", (x_plus, x_minus, x_other), RF(x_plus, x_minus, x_other), "force_only"),
    _formula(
        "arc_y",
        (plus, minus, drive, xi_tip, arc, x_plus, x_minus, x_other),
        xi_tip * arc - Rational(1, 6) * plus * minus * drive * RD(x_plus, x_minus, x_other),
        "force_only",
    ),
    _formula("arc_z", (sin_tip, x_other), sin_tip / sqrt(x_other), "force_only"),
)
THEORY = SimpleNamespace(formulas=FORMULAS)

SAMPLE = {
    "arithmetic": '''
"""Scalars."""
from math import cos, pi, sin, sqrt

def epsilon():
    """Spacing."""
    return 2.0**-52

def real(name, value):
    """A real number."""
    return float(value)
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

def real(name, value):
    """A real number."""
    return mpf(value)
''',
    "array_arithmetic": '"""Arrays."""\nfrom numpy import sqrt as each_sqrt\nfrom numpy import sin as each_sin\n',
    "array_arithmetic_mpmath": """
from mpmath import sin as each_sin
from mpmath import sqrt as each_sqrt
""",
    "carlson": '''
"""Integrals."""
from derive.emit.kernels.arithmetic import epsilon, sqrt

def rf(x, y, z):
    """R_F by plain duplication."""
    while max(x, y, z) - min(x, y, z) > 64 * epsilon() * max(x, y, z):
        shift = sqrt(x * y) + sqrt(x * z) + sqrt(y * z)
        x, y, z = (x + shift) / 4, (y + shift) / 4, (z + shift) / 4
    return 1 / sqrt((x + y + z) / 3)
''',
    "search": '''
"""A kernel that folding has something to do in."""
from typing import NamedTuple

from derive.emit.kernels.arithmetic import cos, pi, sqrt
from derive.emit.kernels.carlson import rf
from derive.emit.kernels.formulas import arc_length, cos_bottom, root_other, tip_drive, tip_gap

TENTH = 0.1
WORDS = ("low", "high")


class Rod(NamedTuple):
    """A rod."""

    beta: float
    eta: float
    length: float


def solve(rod, clamp_angle):
    """Something that depends on everything."""
    beta, eta = rod.beta, rod.eta
    xi = cos(clamp_angle)  # at the clamp
    # The drive, and the gap that goes with it.
    drive = tip_drive(beta, eta, xi)
    extra = root_other(eta, 1 + xi, 1 - xi)
    if eta > beta + 1:
        return level(beta, eta) * cos_bottom(beta, eta)
    total = drive * drive + eta * xi + extra / 3

    def inner(x, eta=eta):
        return x + eta

    return inner(total + TENTH) + tip_gap(beta, eta, 1 - xi) / rod.length + arc_length(1 + beta, 2, 3)


def level(beta, eta):
    """Reached only with a field."""
    return sqrt(eta + beta) * pi


def unreached(x):
    """Nobody calls this."""
    return rf(x, x, x)
''',
    "api": '''
"""The interface."""
from dataclasses import dataclass

from derive.emit.kernels.arithmetic import real
from derive.emit.kernels.search import Rod, solve
from derive.emit.kernels.shapes import bend


@dataclass(frozen=True, slots=True)
class Equilibrium:
    """One result."""

    value: float
    rod: Rod


def equilibria(beta, eta, length, clamp_angle):
    """All results.

    beta: the force.
    eta: the field,
         in its units.
    length: > 0.

    Raises ValueError.
    """
    beta, eta = real("beta", beta), real("eta", eta)
    if beta < 0 or eta < 0:
        raise ValueError(f"beta and eta must not be negative, got {beta} and {eta}")
    rod = Rod(beta, eta, real("length", length))
    return [Equilibrium(solve(rod, real("clamp_angle", clamp_angle)), rod)]


def shape(equilibrium, s):
    """A shape."""
    return bend(equilibrium.rod.eta, equilibrium.value, s)
''',
    "shapes": '''
"""Arrays."""
from derive.emit.kernels.array_arithmetic import each_sin, each_sqrt

def bend(eta, value, s):
    """Bend."""
    return each_sin(s) * each_sqrt(s * s + eta * s) + value
''',
}
