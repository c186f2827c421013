"""The input of the derivation: magnetostatic energy of the particles, per unit reference volume.

Everything downstream is computed from the ``Energy`` that is passed: its value on a bent rod, the magnetization, the
couple, the equations. It must not change when field and particle turn together, for space has no direction of its own.

Run ``python -m derive.theory.energy`` to print this part.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass

from sympy import Expr, Function, Matrix, Symbol, simplify, zeros

from derive.theory.claims import Equal, Notebook, print_notebook
from derive.theory.letters import gradient, vector

H, DIRECTION = vector("h"), vector("a")  # a field (A/m) and an orientation in any fixed frame


@dataclass(frozen=True)
class Energy:
    """A magnetostatic energy.

    name: what is magnetized. density(h, a): J/m³, for the components of the applied field h (A/m) and of the unit
    orientation a of the particles, in one frame. units: SI units of letters that are the energy's own; None if it does
    not say, and then nothing is claimed about dimensions.
    """

    name: str
    density: Callable[[Matrix, Matrix], Expr]
    units: Mapping[Symbol, Expr] | None = None

    def moment(self, h: Matrix, a: Matrix) -> Matrix:
        """μ₀ times the magnetic moment per unit reference volume, −∂(density)/∂h, T, shape 3 × 1."""
        return self._at(-gradient(self.density(H, DIRECTION), H), h, a)

    def slope(self, h: Matrix, a: Matrix) -> Matrix:
        """∂(density)/∂a, J/m³, shape 3 × 1; only its part orthogonal to a has a meaning."""
        return self._at(gradient(self.density(H, DIRECTION), DIRECTION), h, a)

    def turning(self, h: Matrix, a: Matrix) -> Matrix:
        """Derivative of the density when h and a turn together, about each axis."""
        return h.cross(-self.moment(h, a)) + a.cross(self.slope(h, a))

    def _at(self, expr: Matrix, h: Matrix, a: Matrix) -> Matrix:
        return expr.xreplace(dict(zip([*H, *DIRECTION], [*h, *a], strict=True)))


def derive(energy: Energy, book: Notebook, steps: Iterable[str] = ()) -> Energy:
    """Assert what the energy must satisfy, and give it back; ValueError if it depends on more than h·a.

    book: the notebook to write in. steps: the claims from which the energy comes, if it was derived.
    """
    turning = energy.turning(H, DIRECTION)
    if turning.expand() != zeros(3, 1) and simplify(turning) != zeros(3, 1):
        raise ValueError(
            f"the energy of {energy.name} changes when field and particles turn together; "
            "it must depend on the orientation through its product with the field only"
        )
    book.say(f"The magnetostatic energy of {energy.name}, per unit reference volume.")
    book.show("density", energy.density(H, DIRECTION))
    book.claim(
        "energy.invariance",
        "the energy stays the same when field and particles turn together",
        Equal(turning, zeros(3, 1)),
        steps=steps,
    )
    return energy


def main() -> None:
    """Print what is asked of an energy, for one that is any function of the field along the particles."""
    print_notebook(lambda book: derive(Energy("particles of any kind", lambda h, a: Function("psi")(h.dot(a))), book))


if __name__ == "__main__":
    main()
