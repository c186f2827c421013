"""A second frame beside the one in which vectors are written, and what varies along a rod.

All vectors are in components on the frame d of the deformed rod. What varies is a function of s, of X₁ and X₂ too
where it is a field, so that derivatives are SymPy's. Functions that obey a law have their rates replaced at once:
``Rates`` maps Derivative(function, s) to what it is.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any, TypeVar

from sympy import Derivative, Expr, Function, Matrix, MatrixBase, Symbol, eye

from derive.theory.letters import e1, e2, e3, vector_of
from derive.theory.symbols import s

Rates = Mapping[Derivative, Expr]
Of = TypeVar("Of")
Made = TypeVar("Made")


def skew(axis: Matrix) -> Matrix:
    """The tensor that takes v to axis × v."""
    return Matrix.hstack(*(axis.cross(e) for e in (e1, e2, e3)))


def rotation_by(parameters: Matrix) -> Matrix:
    """Any rotation but half-turns, rational in three parameters (Rodrigues): tan of half the angle along the axis."""
    turn = skew(parameters)
    return eye(3) + 2 * (turn + turn * turn) / (1 + parameters.dot(parameters))


def rates_of(parameters: Matrix, spin: Matrix) -> Rates:
    """The rates of a rotation's parameters for which each of its columns c has c_s = spin × c."""
    slope = (spin + spin.cross(parameters) + parameters.dot(spin) * parameters) / 2
    return dict(zip(parameters.diff(s), slope, strict=True))


def inverse(tensor: Matrix) -> Matrix:
    """By the products of its rows; nothing is multiplied out."""
    rows = [tensor[i, :].T for i in range(3)]
    columns = [rows[(i + 1) % 3].cross(rows[(i + 2) % 3]) for i in range(3)]
    return Matrix.hstack(*columns) / rows[0].dot(columns[0])


def along(value: Any, kappa: Matrix, rates: Rates) -> Any:
    """The derivative along the rod of a scalar, or of a vector or tensor of moving components."""
    slope = value.diff(s)
    slope = slope.xreplace(dict(rates))
    if not isinstance(value, MatrixBase):
        return slope
    turned = skew(kappa) * value
    return slope + turned if value.shape == (3, 1) else slope + turned - value * skew(kappa)


def elsewhere(value: Any, place: Expr) -> Any:
    """A quantity at another point of the rod, in the frame of this one: there the frame is turned, nobody says how."""
    if place == s:
        return value
    there = value.subs(s, place)
    if not isinstance(value, MatrixBase):
        return there
    turn = rotation_by(Matrix([q.subs(s, place) for q in vector_of("turn")]))
    return turn * there if value.shape == (3, 1) else turn * there * turn.T


def unknown(name: str, like: Any) -> Any:
    """A quantity of which nothing is known, of the shape of another."""
    if isinstance(like, MatrixBase):
        rows, columns = like.shape
        return Matrix(rows, columns, lambda i, j: Symbol(f"{name}_{i + 1}{j + 1}", real=True))
    return Symbol(name, real=True)


def extent(place: Expr) -> Expr:
    """Stands for the integral of 1 along the rod up to a place; it is 0 at the beginning."""
    return Function("extent", positive=True)(place) if place != 0 else place


def kept(make: Callable[[Of], Made]) -> Callable[[Of], Made]:
    """A function that remembers what it made of the last thing it was given: a theory is too large to compare."""
    last: list[tuple[Of, Made]] = []

    def made(of: Of) -> Made:
        if not last or last[0][0] is not of:
            last[:] = [(of, make(of))]
        return last[0][1]

    return made
