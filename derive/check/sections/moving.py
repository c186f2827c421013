"""Values for readings of a rod: on a second frame, of what is not known, and of integrals along the rod.

All vectors are in components on the frame d of the deformed rod.
"""

from __future__ import annotations

from typing import Any

from sympy import Expr, Function, ImmutableDenseMatrix, Matrix, MatrixBase, Symbol, cancel


class Turned(ImmutableDenseMatrix):  # type: ignore[misc]  # SymPy has no types
    """A vector, or a tensor on d ⊗ d^u, whose components on d^u are known too: products need no multiplying out.

    A turn leaves products of two vectors as they are, and a tensor on d ⊗ d^u takes components on d^u to those on d.
    """

    own: Any
    factors: tuple[Any, Any] | None = None

    @staticmethod
    def of(turn: Matrix, own: Any) -> Turned:
        """A vector with the components ``own`` on the frame that a rotation makes of d, or a tensor with them."""
        entries = turn * own if own.shape == (3, 1) else own * turn.T
        made = Turned(*entries.shape, list(entries))
        made.own = own
        return made

    @staticmethod
    def product(turn: Matrix, left: Any, right: Any) -> Turned:
        """The tensor with the components left · rightᵀ; applied to a vector it is rightᵀ first."""
        made = Turned.of(turn, left * right.T)
        made.factors = left, right
        return made

    def dot(self, other: Any, *options: Any) -> Any:
        """In components."""
        pair = _own(self, other)
        return pair[0].dot(pair[1]) if pair else Matrix(self).dot(other, *options)

    def __mul__(self, other: Any) -> Any:
        """In components."""
        pair = _own(self, other)
        if pair is None:
            return Matrix(self) * other
        if self.factors is None:
            return pair[0] * pair[1]
        left, right = self.factors
        return left * (right.T * pair[1]).applyfunc(cancel)


def _own(one: Any, other: Any) -> tuple[Any, Any] | None:
    """Both by their components on d^u, if they are known."""
    found = getattr(one, "own", None), getattr(other, "own", None)
    return None if any(own is None for own in found) or other.shape != (3, 1) else found


def inverse(tensor: Matrix) -> Matrix:
    """By the products of its rows; nothing is multiplied out."""
    rows = [tensor[i, :].T for i in range(3)]
    columns = [rows[(i + 1) % 3].cross(rows[(i + 2) % 3]) for i in range(3)]
    return Matrix.hstack(*columns) / rows[0].dot(columns[0])


def unknown(name: str, like: Any) -> Any:
    """A quantity of which nothing is known, of the shape of another."""
    if isinstance(like, MatrixBase):
        rows, columns = like.shape
        return Matrix(rows, columns, lambda i, j: Symbol(f"{name}_{i + 1}{j + 1}", real=True))
    return Symbol(name, real=True)


def extent(place: Expr) -> Expr:
    """Stands for the integral of 1 along the rod up to a place; it is 0 at the beginning."""
    return Function("extent", positive=True)(place) if place != 0 else place
