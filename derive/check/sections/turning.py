"""Turns: of one frame from another, and of the frame on which components are taken, from place to place.

Vectors and tensors are in components on the frame d of the deformed rod. What varies is a function of s, so that
derivatives are SymPy's; functions that obey a law have their derivatives replaced at once.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from sympy import Expr, Function, ImmutableMatrix, MatrixBase, eye

from derive.theory.letters import e1, e2, e3
from derive.theory.symbols import s

Rates = Mapping[Expr, Expr]  # Derivative(function, s) → what it is


def skew(v: Any) -> ImmutableMatrix:
    """The tensor v × of a vector."""
    return ImmutableMatrix.hstack(*(v.cross(e) for e in (e1, e2, e3)))


@dataclass(frozen=True)
class Rotation:
    """A rotation by three parameters g that vary along the rod: the vector along its axis with length tan(angle/2)."""

    parameters: ImmutableMatrix

    @property
    def matrix(self) -> ImmutableMatrix:
        """Its matrix, rational in the parameters."""
        turn = skew(self.parameters)
        return ImmutableMatrix(eye(3) + 2 * (turn + turn * turn) / (1 + self.parameters.dot(self.parameters)))

    def turned(self, spin: Any) -> dict[Expr, Expr]:
        """The change of each parameter when the rotation R changes by spin × R."""
        g = self.parameters
        return dict(zip(g, (spin + spin.cross(g) + g * g.dot(spin)) / 2, strict=True))

    def rates(self, spin: Any) -> Rates:
        """The derivatives of the parameters when R′ = spin × R in components."""
        return {g.diff(s): rate for g, rate in self.turned(spin).items()}


def rotation(name: str) -> Rotation:
    """Any rotation but half-turns, by three functions of s."""
    return Rotation(ImmutableMatrix([Function(f"{name}_{i}", real=True)(s) for i in (1, 2, 3)]))


def turned(spin: Any, of: Any) -> Any:
    """What a turn of the frame adds to the change of the components of a vector or a tensor."""
    turn = skew(spin)
    return turn * of if of.shape == (3, 1) else turn * of - of * turn


def along(value: Any, kappa: Any, rates: Rates) -> Any:
    """The derivative along the rod of a scalar, or of a vector or tensor of moving components."""
    slope = value.diff(s).xreplace(rates)
    return slope + turned(kappa, value) if isinstance(value, MatrixBase) else slope


def elsewhere(value: Any, place: Expr) -> Any:
    """A quantity at another point of the rod, in the frame of this one: there the frame is turned, nobody says how."""
    if place == s:
        return value
    there = value.subs(s, place)
    if not isinstance(value, MatrixBase):
        return there
    turn = rotation("turn").matrix.subs(s, place)
    return turn * there if value.shape == (3, 1) else turn * there * turn.T
