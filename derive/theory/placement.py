"""Section 2.1, kthr1 to kthr3, kthr7 to kthr9, kth14, kth15: where the points of a rod are, and what is small in it.

Positions are relative to the axis, before the deformation in the frame d^u, after it in d. All orders of magnitude
come from one parameter ε: section coordinates are ε X_α, the small displacement is ε² w(X₁, X₂, s), and curvatures are
of order 1. Run ``python -m derive.theory.placement`` to print this part.
"""

from __future__ import annotations

from sympy import Expr, Matrix, Max, Symbol, sqrt

from derive.theory import frame as frame_script
from derive.theory.claims import Equal, Notebook, Order, print_notebook
from derive.theory.frame import Frame, along
from derive.theory.letters import X1, X2, e1, e2, e3, eps, vector_of
from derive.theory.letters import angle as letter
from derive.theory.symbols import s

POINT = eps * (X1 * e1 + X2 * e2)  # a point of a cross section, from its centroid
DISPLACEMENT = eps**2 * vector_of("w", X1, X2, s)  # what deforms the sections, of the order that kthr9 allows
DEFORMED = POINT + DISPLACEMENT
KAPPA_U = vector_of("kappa_u")  # curvature of the undistorted rod, in its own frame, 1/m
LENGTH = Symbol("ell", positive=True)  # of the axis, m


def tangents(place: Matrix, kappa: Matrix) -> Matrix:
    """Derivatives of axis + place by the section coordinates ε X₁, ε X₂ and by s, as columns (kthr10)."""
    # The axis is inextensible: its own derivative is d₃.
    return Matrix.hstack(place.diff(X1) / eps, place.diff(X2) / eps, e3 + along(place, kappa)).expand()


def thickness(kappa_u: Matrix, kappa: Matrix, length: Expr) -> Expr:
    """h, m: ε times the least of the lengths at hand, the radii 1/|κ^u|, 1/|κ| and ℓ."""
    return eps / Max(sqrt(kappa_u.dot(kappa_u)), sqrt(kappa.dot(kappa)), 1 / length)


def derive(frame: Frame, book: Notebook) -> None:
    """Positions, small quantities and the rotation of the frame, with their claims."""
    book.say("Points of the rod: section coordinates of order epsilon, a displacement of order epsilon squared.")
    book.show("point of a section, from the axis", POINT)
    book.show("displacement", DISPLACEMENT)
    claim_points(frame, book)
    claim_small(frame, book)
    claim_rotation(frame, book)


def claim_points(frame: Frame, book: Notebook) -> None:
    """Sections lie across the axis; the tangent of the axis is the third vector of the frame, of length 1."""
    book.claim(
        "placement.section",
        "a section lies across the axis, and its coordinates are lengths along the frame",
        Equal(Matrix([POINT.dot(e) for e in (e1, e2, e3)]), Matrix([eps * X1, eps * X2, 0])),
        source="kthr1",
    )
    book.claim(
        "placement.axis",
        "along the rod a point moves as the axis does, by the third vector of the frame, and turns about it",
        Equal(tangents(POINT, KAPPA_U)[:, 2], e3 + KAPPA_U.cross(POINT)),
        steps=["frame.derivative", "placement.section"],
        source="kthr2",
    )
    tangent = frame.R * e3
    book.claim(
        "placement.inextensible",
        "the axis keeps its length: its tangent by arc length has length 1",
        Equal(tangent.dot(tangent), 1),
        steps=["placement.axis"],
        source="kthr3",
    )
    book.claim(
        "placement.deformed",
        "after the deformation a point is where the turned section has it, but for the small displacement",
        Order(DEFORMED - POINT, eps, 2),
        steps=["placement.section"],
        source="kthr8",
    )


def claim_small(frame: Frame, book: Notebook) -> None:
    """What is of order ε, and what is of order ε²; squared, since a length has a root."""
    h = thickness(KAPPA_U, frame.kappa, LENGTH)
    book.claim(
        "placement.thin",
        "the thickness is small beside both radii of curvature and beside the length",
        Order(h**2 * Matrix([KAPPA_U.dot(KAPPA_U), frame.kappa.dot(frame.kappa), LENGTH**-2]), eps, 2),
        steps=["placement.section"],
        source="kthr7",
    )
    slopes = [DISPLACEMENT.diff(X) / eps for X in (X1, X2)]
    book.claim(
        "placement.displacement",
        "over the thickness the small displacement is of first order, and so is its slope in the section",
        Order(Matrix([(u.dot(u)).expand() for u in (DISPLACEMENT / h, *slopes)]), eps, 2),
        steps=["placement.thin", "placement.deformed"],
        source="kthr9",
    )
    rate = along(DISPLACEMENT, frame.kappa)
    book.claim(
        "placement.rate",
        "along the rod the small displacement changes in second order",
        Order(rate, eps, 2),
        steps=["placement.deformed"],
        source="kthr9",
    )


def claim_rotation(frame: Frame, book: Notebook) -> None:
    """Q takes the frame before the deformation to the one after it, and turns along the rod with μ."""
    basis = (e1, e2, e3)
    # The undistorted frame by angles of its own.
    before = frame.R.subs({angle: letter(f"{angle.func.__name__}_u") for angle in frame.angles})
    Q = sum((frame.R[:, i] * before[:, i].T for i in range(3)), Matrix.zeros(3, 3))
    book.claim(
        "placement.rotation",
        "the sum of the products of the two frames takes one to the other",
        Equal(Q * before, frame.R),
        source="kth14",
    )
    mu = frame.kappa - KAPPA_U
    # Of Q d_i^u = d_i: Q′ d_i^u = d_i′ − Q d_i^u′, and Q keeps components.
    slope = Matrix.hstack(*(along(e, frame.kappa) - along(e, KAPPA_U) for e in basis))
    book.claim(
        "placement.measure",
        "along the rod the rotation from one frame to the other turns with the measure of deformation",
        Equal(slope, Matrix.hstack(*(mu.cross(e) for e in basis))),
        steps=["placement.rotation", "frame.derivative"],
        source="kth15",
    )


def main() -> None:
    """Print the derivation so far."""
    print_notebook(lambda book: derive(frame_script.derive(book), book))


if __name__ == "__main__":
    main()
