"""Section 2.3, elmr1, elmr2 and elmr6: the displacement of the axis, and the constraint that keeps it inextensible.

The slope of the axis is the tangent d₃, so that the displacement's slope is (Q − I) d₃^u. A multiplier Φ, per unit
length, holds the constraint; it turns out to be the resultant force. Run ``python -m derive.theory.constraint``.
"""

from __future__ import annotations

from sympy import Expr, Function, Matrix, eye

from derive.theory import frame as frame_script
from derive.theory.claims import Equal, Notebook, print_notebook
from derive.theory.frame import Frame, along
from derive.theory.letters import e3, vector_of
from derive.theory.symbols import s

POSITION = vector_of("x")  # a point of the axis, in the frame d, m
FORCE = vector_of("Phi")  # the multiplier Φ, in the frame d, N


def density(kappa: Matrix) -> Expr:
    """Φ · (x′ − d₃), whose integral is the constraint."""
    return FORCE.dot(along(POSITION, kappa) - e3)


def derive(frame: Frame, book: Notebook) -> Expr:
    """The density of the constraint, with the claims on the displacement."""
    # The undistorted rod has a frame of its own, by other angles.
    other = Matrix([Function(f"phi_u_{i}", real=True)(s) for i in (1, 2, 3)])
    there = dict(zip(frame.angles, other, strict=True))
    R, R_u = frame.R, frame.R.subs(there)
    kappa, kappa_u = frame.kappa_of_angles, frame.kappa_of_angles.subs(there).doit()
    before = vector_of("x_u")
    book.claim(
        "constraint.displacement",
        "the slope of the displacement, the position after less that before, is the difference of the slopes",
        Equal((R * POSITION - R_u * before).diff(s), R * along(POSITION, kappa) - R_u * along(before, kappa_u)),
        steps=["frame.derivative"],
        source="elmr1",
    )
    turned = R * R_u.T - eye(3)
    book.claim(
        "constraint.slope",
        "where the slopes are the tangents, their difference is that of the rotation and the identity on d3^u",
        Equal(R * e3 - R_u * e3, turned * R_u * e3),
        steps=["constraint.displacement"],
        source="elmr2",
    )
    slope = R * along(POSITION, kappa)
    book.claim(
        "constraint.density",
        "the multiplier works on what the slope of the axis has beyond the tangent",
        Equal((R * FORCE).dot(slope - R_u * e3 - turned * R_u * e3), density(kappa)),
        steps=["constraint.slope"],
        source="elmr6",
    )
    return book.show("density of the constraint, in the frame", density(frame.kappa))


def main() -> None:
    """Print the derivation so far."""
    print_notebook(lambda book: derive(frame_script.derive(book), book))


if __name__ == "__main__":
    main()
