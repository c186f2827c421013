"""Section 2.1, kthr4 to kthr6: the orthonormal frame of a rod, its curvature vector, derivatives along the rod.

The frame (d₁, d₂, d₃), with d₃ the unit tangent, is a rotation R(s) of fixed axes. Later scripts write vectors by their
components in it, and differentiate them with ``along``. Run ``python -m derive.theory.frame`` to print this part.
"""

from __future__ import annotations

from dataclasses import dataclass

from sympy import Expr, Function, Matrix, Rational, cos, expand, sin, sqrt, zeros

from derive.theory.claims import Equal, Notebook, print_notebook
from derive.theory.letters import e1, e2, e3, rotation, vector_of
from derive.theory.symbols import s


@dataclass(frozen=True)
class Frame:
    """A frame of a rod, twice.

    kappa: the curvature vector κ₁, κ₂, κ₃ in the moving frame, as unknown functions of s, 1/m. angles: three angles,
    functions of s, that make any rotation. R: the same frame, its vectors as columns, by those angles in fixed axes,
    3 × 3. kappa_of_angles: κ in the moving frame by those angles.
    """

    kappa: Matrix
    angles: Matrix
    R: Matrix
    kappa_of_angles: Matrix


@dataclass(frozen=True)
class Axis:
    """The curve of a rod's axis, by the curvature vector κ of the rod's frame, in that frame.

    curvature: the geometric curvature k, 1/m. normal, binormal: principal normal and binormal, unit vectors. torsion:
    1/m. turn: φ′, the rate of the angle φ from the principal normal to d₁, 1/m.
    """

    curvature: Expr
    normal: Matrix
    binormal: Matrix
    torsion: Expr
    turn: Expr


def along(v: Matrix, kappa: Matrix) -> Matrix:
    """The derivative along the rod of a vector of moving components v: v_s + κ × v, in moving components."""
    return v.diff(s) + kappa.cross(v)


def triple(a: Matrix, b: Matrix, c: Matrix) -> Expr:
    """The triple product a × b · c."""
    return a.cross(b).dot(c)


def curvature(R: Matrix, angles: Matrix) -> Matrix:
    """The vector κ, in moving components, for which d_i′ = κ × d_i."""
    # RᵀR′ is skew, since RᵀR = I; κ is its axial vector.
    spin = R.T * R.diff(s)
    kappa = Matrix([spin[2, 1], spin[0, 2], spin[1, 0]]).applyfunc(expand)
    for turn in angles:
        kappa = kappa.subs(sin(turn) ** 2, 1 - cos(turn) ** 2).applyfunc(expand)
    return kappa


def axis(kappa: Matrix) -> Axis:
    """The curve whose tangent is d₃, where it is curved."""
    slope = along(e3, kappa)
    k = sqrt(slope.dot(slope))
    normal, binormal = slope / k, e3.cross(slope) / k
    # d₁ = cos φ n + sin φ b.
    cosine, sine = normal.dot(e1), binormal.dot(e1)
    turn = cosine * sine.diff(s) - sine * cosine.diff(s)
    return Axis(k, normal, binormal, triple(e3, slope, along(slope, kappa)) / k**2, turn)


def derive(book: Notebook) -> Frame:
    """The moving frame, its curvature vector and the derivative of moving components, with their claims."""
    angles = Matrix([Function(f"phi_{i}", real=True)(s) for i in (1, 2, 3)])
    # Turn about the third axis, the new first axis, the new third axis: any frame.
    R = rotation(e3, angles[0]) * rotation(e1, angles[1]) * rotation(e3, angles[2])
    frame = Frame(vector_of("kappa"), angles, R, curvature(R, angles))
    book.say("The frame of the rod, turned from fixed axes by three angles, and its curvature vector.")
    book.show("kappa, in the frame itself", frame.kappa_of_angles)

    kappa = R * frame.kappa_of_angles
    d = [R[:, i] for i in range(3)]
    book.claim(
        "frame.curvature",
        "the vectors of the frame turn with the curvature vector",
        Equal(R.diff(s), Matrix.hstack(*(kappa.cross(d_i) for d_i in d))),
        source="kthr4",
    )
    # A vector Σ v_i d_i: differentiate it in fixed axes, or by its moving components.
    v = vector_of("v")
    book.claim(
        "frame.derivative",
        "derivatives by moving components are those in fixed axes",
        Equal((R * v).diff(s), R * along(v, frame.kappa_of_angles)),
        steps=["frame.curvature"],
    )
    claim_curvature(frame, book)
    claim_torsion(book)
    claim_axis(axis(frame.kappa), frame.kappa, book)
    return frame


def claim_curvature(frame: Frame, book: Notebook) -> None:
    """κ from the frame and its derivatives; the part of κ across the rod and the curvature of the axis."""
    kappa, basis = frame.kappa, (e1, e2, e3)
    book.claim(
        "frame.formula",
        "half the sum of the products of the frame's vectors and their derivatives is the curvature vector",
        Equal(Rational(1, 2) * sum((d.cross(along(d, kappa)) for d in basis), zeros(3, 1)), kappa),
        steps=["frame.derivative"],
        source="kthr4",
    )
    tangent_slope = along(e3, kappa)
    book.claim(
        "frame.binormal",
        "the part of the curvature vector across the rod is d3 x d3'",
        Equal(e3.cross(tangent_slope), kappa[0] * e1 + kappa[1] * e2),
        steps=["frame.derivative"],
        source="kthr5",
    )
    book.claim(
        "frame.geometric",
        "the geometric curvature, the modulus of d3', comes from the two components of curvature",
        Equal(sqrt(tangent_slope.dot(tangent_slope)), sqrt(kappa[0] ** 2 + kappa[1] ** 2)),
        steps=["frame.binormal"],
        source="kthr5",
    )


def frenet() -> tuple[Expr, Expr, Matrix]:
    """Curvature k(s), torsion, and the vector with which (n, b, t) turns, in components on n, b, t."""
    k, torsion = Function("k", positive=True)(s), Function("torsion", real=True)(s)
    # t′ = k n and b′ = −torsion n: the Serret-Frenet formulas are t′ = Ω × t with Ω = k b + torsion t.
    return k, torsion, Matrix([0, k, torsion])


def claim_torsion(book: Notebook) -> None:
    """Twist, torsion and the angle from the principal normal to d₁ (kthr6), in the Serret-Frenet frame (n, b, t)."""
    k, torsion, turning = frenet()
    phi = Function("phi", real=True)(s)
    d1 = Matrix([cos(phi), sin(phi), 0])
    d2 = e3.cross(d1)
    book.claim(
        "frame.frenet",
        "the principal normal is the direction of d3', and the torsion turns the binormal away from it",
        Equal(Matrix.hstack(along(e3, turning), along(e2, turning)), Matrix.hstack(k * e1, -torsion * e1)),
    )
    book.claim(
        "frame.twist",
        "the twist density is the torsion and the rate of the angle from the principal normal",
        Equal(along(d1, turning).dot(d2), torsion + phi.diff(s)),
        steps=["frame.derivative", "frame.frenet"],
        source="kthr6",
    )


def claim_axis(curve: Axis, kappa: Matrix, book: Notebook) -> None:
    """The same of any rod: the axis by the frame's curvature vector."""
    book.claim(
        "frame.serret_frenet",
        "the binormal turns about the tangent with the torsion",
        Equal(along(curve.binormal, kappa), -curve.torsion * curve.normal),
        steps=["frame.derivative", "frame.frenet"],
        source="kthr6",
    )
    book.claim(
        "frame.torsion",
        "the twist density is the torsion and the rate of the angle, by the components of the curvature vector",
        Equal(kappa[2], curve.torsion + curve.turn),
        steps=["frame.serret_frenet", "frame.binormal"],
        source="kthr6",
    )
    book.claim(
        "frame.curved",
        "the curvature times the binormal is the part of the curvature vector across the rod",
        Equal(curve.curvature * curve.binormal, kappa[0] * e1 + kappa[1] * e2),
        steps=["frame.binormal", "frame.geometric"],
        source="kthr5",
    )


def main() -> None:
    """Print the derivation so far."""
    print_notebook(derive)


if __name__ == "__main__":
    main()
