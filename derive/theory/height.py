"""The height z(ξ), elementary, from dz/dξ = z′/ξ′ = −1/κ_x (exsl37-exsl41, exhpf16-exhpf19, slch13, slch14)."""

from __future__ import annotations

from collections.abc import Mapping

from sympy import Expr, acosh, asin, cos, diff, oo, pi, sin, sqrt

from .claims import Equal, Notebook, Positive
from .load_case import COSINES, LoadCase
from .symbols import theta, xi


def height(case: LoadCase, book: Notebook) -> Mapping[str, Expr]:
    """Antiderivatives z(ξ) for κ_x = √f̂, one for each side of the roots of f̂ on which f̂ > 0."""
    _claim_slope(case, book)
    if not case.bends:
        # slch13: the radicand is linear.
        found = {"": 2 * sqrt(case.f_hat) / -diff(case.f_hat, xi)}
        places = {"": (COSINES[0], case.roots[0])}
    else:
        # exsl39, exhpf17: f̂ = (Δ/H)(1 − t²), t = (Hξ + B)/√Δ.
        discriminant = case.force**2 + case.f_hat.subs(xi, 0) * case.stiffness
        t = (case.stiffness * xi + case.force) / sqrt(discriminant)
        where = case.domain(xi=COSINES, **{case.constant.name: case.ends})
        squares = Equal(discriminant / case.stiffness * (1 - t**2), case.f_hat)
        name, source, steps = f"shape.{case.name}.square", case.source("square completed"), case.ids("quartic.levels")
        book.claim(name, "f̂ as a square completed", squares, domain=where, steps=steps, source=source)
        integrand = Equal(1 / case.f_hat, diff(t, xi) ** 2 / (case.stiffness * (1 - t**2)))
        name, source, steps = f"shape.{case.name}.integrand", case.source("integrand"), (name,)
        book.claim(name, "dξ²/f̂ by t", integrand, domain=where, steps=steps, source=source)
        if case.bends == 1:
            found, places = {"": -asin(t) / sqrt(case.stiffness)}, {"": case.roots}
        else:
            # −t > 1 above the roots, t > 1 below them: two branches of the inverse hyperbolic cosine.
            unit = sqrt(-case.stiffness)
            above, below = -t, t
            found = {"above": -acosh(above) / unit, "below": acosh(below) / unit}
            places = {"above": (case.roots[1], oo), "below": (-oo, case.roots[0])}
            for side, argument in (("above", above), ("below", below)):
                where = case.domain(**{case.constant.name: case.ends, "xi": places[side]})
                name = f"shape.{case.name}.branch_{side}"
                title, steps = "the inverse hyperbolic cosine takes a positive argument", case.ids("shape.square")
                source = case.source("inverse cosine")
                book.claim(name, title, Positive(argument), domain=where, steps=steps, source=source)
    source = case.source("z")
    rests = ("plane.bending", *case.ids("shape.square" if case.bends else "quartic.levels"))
    for side, z in found.items():
        where = case.domain(**{case.constant.name: case.ends, "xi": places[side]})
        key = f"shape.{case.name}.z_{side}".rstrip("_")
        book.show(f"z(ξ) {side}".rstrip(), z)
        slope = diff(z, xi)
        # Of κ_x = ±√f̂ this is the branch +: z falls as ξ grows.
        square, steps = Equal(slope**2 * case.f_hat, 1), rests
        if case.bends == -1:
            steps += case.ids(f"shape.branch_{side}")
        book.claim(key, "(dz/dξ)² = 1/κ_x²", square, domain=where, steps=steps, source=source)
        title = "dz/dξ < 0 with κ_x > 0"
        book.claim(f"{key}_sign", title, Positive(-slope), domain=where, steps=(key,), source=source)
        # z′² = 1 − ξ² with (ξ′)² = f(ξ): the rod does not stretch.
        length = Equal(slope**2 * case.f, 1 - xi**2)
        steps, label = (key, "plane.inextensible"), case.source("inextensible")
        book.claim(f"{key}_length", "z′² = 1 − y′²", length, domain=where, steps=steps, source=label)
    return found


def _claim_slope(case: LoadCase, book: Notebook) -> None:
    """ξ′ = −κ_x z′ with κ_x² = f̂, so that (ξ′)² = z′²f̂ and (dz/dξ)² = 1/f̂."""
    where = case.domain(theta=(0, pi), **{case.constant.name: case.ends})
    levels, quartic = (polynomial.subs(xi, cos(theta)) for polynomial in (case.f_hat, case.f))
    name, rests = f"shape.{case.name}", ("plane.bending", *case.ids("quartic.levels"))
    bending = Equal(quartic, sin(theta) ** 2 * levels)
    book.claim(f"{name}.bending", "(ξ′)² = z′²f̂", bending, domain=where, steps=rests, source=case.source("bending"))
    slope, rests = Equal(sin(theta) ** 2 / quartic, 1 / levels), case.ids("shape.bending", "quartic.motion")
    title, source = "(dz/dξ)² = z′²/(ξ′)² = 1/f̂", case.source("slope of z")
    book.claim(f"{name}.slope_of_z", title, slope, domain=where, steps=rests, source=source)
