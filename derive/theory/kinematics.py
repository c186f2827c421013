"""Sections 2.1 and 2.2, kthr10 to kth24: the deformation of a rod and the orientation of the particles in it.

Vectors of the undistorted rod are written in its own frame d^u, those of the deformed rod in d, so that
Q = d_i ⊗ d_i^u has the components of the identity. Run ``python -m derive.theory.kinematics``.
"""

from __future__ import annotations

from dataclasses import dataclass

from sympy import Expr, Matrix, cancel, eye, sqrt

from derive.theory import frame as frame_script
from derive.theory import placement
from derive.theory.claims import Equal, Notebook, Order
from derive.theory.frame import Frame
from derive.theory.letters import X1, X2, e1, e2, e3, eps, vector
from derive.theory.placement import DEFORMED, DISPLACEMENT, KAPPA_U, POINT, tangents


@dataclass(frozen=True)
class Kinematics:
    """The deformed rod, its small quantities of order ε kept in full.

    kappa_u: curvature of the undistorted rod, 1/m. mu: measure of deformation κ − Qκ^u, 1/m. tangents_u, dual_u: g_k
    and g^k as columns. tangents: ∂x̂/∂X_α and ∂x̂/∂s as columns. gradient: F, 3 × 3, in d ⊗ d^u. fibre_u, fibre: the
    orientations a^u and a of the particles, in d^u and in d. jacobian: J.
    """

    frame: Frame
    kappa_u: Matrix
    mu: Matrix
    tangents_u: Matrix
    dual_u: Matrix
    tangents: Matrix
    gradient: Matrix
    fibre_u: Matrix
    fibre: Matrix
    jacobian: Expr


def derive(frame: Frame, book: Notebook) -> Kinematics:
    """Bases, deformation gradient, orientation of the particles, with their claims."""
    kappa_u = KAPPA_U
    # The undistorted rod and the deformed one, which is bent by κ and displaced by a little more (kthr1, kthr8).
    tangents_u = tangents(POINT, kappa_u)
    deformed = tangents(DEFORMED, frame.kappa)
    dual_u = tangents_u.inv().T.applyfunc(cancel)
    gradient = deformed * dual_u.T
    jacobian = tangents_u.det()
    fibre_u = tangents_u[:, 2] / sqrt(tangents_u[:, 2].dot(tangents_u[:, 2]))
    # a = F a^u / |F a^u|, where a^u is along g₃: F takes g₃ to the tangent of the deformed fibre.
    fibre = deformed[:, 2] / sqrt(deformed[:, 2].dot(deformed[:, 2]))

    # κ − Qκ^u, where Qκ^u has on d the components that κ^u has on d^u.
    mu = frame.kappa - kappa_u
    rod = Kinematics(frame, kappa_u, mu, tangents_u, dual_u, deformed, gradient, fibre_u, fibre, jacobian)
    book.say("The rod before and after, and the gradient of its deformation.")
    book.show("g_3, in the undistorted frame", tangents_u[:, 2])
    book.show("J", jacobian)
    claim_bases(rod, book)
    claim_gradient(rod, book)
    claim_fibre(rod, book)
    return rod


def claim_bases(rod: Kinematics, book: Notebook) -> None:
    """The bases by their definitions, and the contravariant one to first order."""
    g1, g2, g3 = (rod.tangents_u[:, k] for k in range(3))
    twist = rod.kappa_u.cross(POINT)
    book.claim(
        "kinematics.covariant",
        "the covariant basis is the frame, its last vector turned by the curvature",
        Equal(rod.tangents_u, Matrix.hstack(e1, e2, e3 + twist)),
        steps=["frame.derivative", "placement.section"],
        source="kthr10",
    )
    book.claim(
        "kinematics.jacobian",
        "the Jacobian is the triple product of the basis, one and a part of first order",
        Equal(Matrix([rod.jacobian, g1.cross(g2).dot(g3)]), Matrix([1, 1]) * (1 + e3.dot(twist))),
        steps=["kinematics.covariant"],
        source="kth24",
    )
    book.claim(
        "kinematics.dual",
        "the contravariant vectors are the products of the covariant ones over the Jacobian",
        Equal(rod.dual_u, Matrix.hstack(g2.cross(g3), g3.cross(g1), g1.cross(g2)) / rod.jacobian),
        steps=["kinematics.jacobian"],
    )
    book.claim(
        "kinematics.contravariant",
        "to first order the contravariant vectors lose the components of the turn along d3",
        Order(rod.dual_u - (eye(3) - e3 * twist.T), eps, 2),
        steps=["kinematics.dual"],
        source="kthr11",
    )


def claim_gradient(rod: Kinematics, book: Notebook) -> None:
    """F by what a gradient does, and to first order."""
    book.claim(
        "kinematics.pushes",
        "the deformation gradient takes the basis before the deformation to the one after it",
        Equal(rod.gradient * rod.tangents_u, rod.tangents),
        steps=["kinematics.dual", "placement.deformed"],
        source="kthr12",
    )
    slopes = [DISPLACEMENT.diff(X) / eps for X in (X1, X2)]
    small = rod.mu.cross(POINT) * e3.T + slopes[0] * e1.T + slopes[1] * e2.T
    book.claim(
        "kinematics.gradient",
        "to first order the deformation gradient is the rotation, the bending and the small displacement's slope",
        Order(rod.gradient - (eye(3) + small), eps, 2),
        steps=["kinematics.pushes", "placement.displacement", "placement.rotation", "placement.measure"],
        source="kthr13",
    )


def claim_fibre(rod: Kinematics, book: Notebook) -> None:
    """The orientation of the particles by its definition, and to first order."""
    g3, moved = rod.tangents_u[:, 2], rod.tangents[:, 2]
    book.claim(
        "kinematics.fibre",
        "particles along the fibres before the deformation lie along them after it",
        Equal(rod.gradient * rod.fibre_u * sqrt(g3.dot(g3)), rod.fibre * sqrt(moved.dot(moved))),
        steps=["kinematics.pushes"],
    )
    # A fibre turns with the section, but its length does not count: drop the part along d₃.
    turn = rod.frame.kappa.cross(POINT)
    book.claim(
        "kinematics.orientation",
        "to first order the particles turn as the fibres do",
        Order(rod.fibre - (e3 + turn - e3 * e3.dot(turn)), eps, 2),
        steps=["kinematics.fibre"],
        source="kth23",
    )
    stretch = rod.gradient * g3
    book.claim(
        "kinematics.stretch",
        "to first order the square of a fibre's stretch grows by twice its slope along d3",
        Order(stretch.dot(stretch) - (1 + 2 * e3.dot(turn)), eps, 2),
        steps=["kinematics.fibre"],
        source="kth21",
    )
    h = vector("h")
    book.claim(
        "kinematics.reach",
        "to first order the part of a field along a fibre grows by the fibre's turn towards the field",
        Order(h.dot(stretch) ** 2 - (h[2] ** 2 + 2 * h.dot(turn) * h[2]), eps, 2),
        steps=["kinematics.fibre"],
        source="kth22",
    )


def main() -> None:
    """Print the derivation so far."""
    book = Notebook()
    frame = frame_script.derive(book)
    placement.derive(frame, book)
    derive(frame, book)
    print(*book.text(), sep="\n")


if __name__ == "__main__":
    main()
