"""The shape of the rod: y(s) by ζ and σ, z(s) elementary (exsl33-exsl41, exhpf14-exhpf19, slch12-slch14)."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from sympy import Expr, Rational, Symbol, acosh, asin, diff, log, oo, sqrt, symbols

from .claims import Domain, Equal, Notebook, Positive
from .functions import wp, wp_prime, wsigma, wzeta
from .load_case import COSINES, LoadCase
from .symbols import s, u, v, xi
from .weierstrass import Weierstrass

u_o = Symbol("u_o")  # u at the fixed end
a, b, g2, g3 = symbols("a b g2 g3", real=True)  # constants of an expansion
WHERE = Domain(
    {
        g2: (3, 4),
        g3: (Rational(1, 4), Rational(1, 2)),
        a: (1, 2),
        b: (1, 2),
        v: (Rational(1, 2), Rational(7, 10)),
        u_o: (Rational(1, 5), Rational(3, 10)),
        u: (Rational(1, 5), Rational(2, 5)),
        s: (0, Rational(1, 10)),
    }
)


@dataclass(frozen=True)
class Shape:
    """The shape in one load case.

    xi, y: functions of s, with u_o, ℘(v) = c and ℘′(v) as wp and wp_prime of v, and the constants a, b, g₂, g₃ of the
    expansion as symbols; or, for a cubic f, of u_o and the linear map. z: antiderivatives −∫dξ/κ_x for κ_x > 0, one
    for each side of the roots of f̂ on which f̂ > 0.
    """

    xi: Expr
    y: Expr
    z: Mapping[str, Expr]


def derive(cases: Mapping[str, LoadCase], functions: Mapping[str, Weierstrass], book: Notebook) -> Mapping[str, Shape]:
    """The shapes of all load cases."""
    book.say("Section 3. The shape of the rod")
    general = _general(book)
    return {name: _case(case, functions[name], general, book) for name, case in cases.items()}


def _general(book: Notebook) -> tuple[Expr, Expr, Expr]:
    """ξ, y and the sum of ζ for ξ = a + b/(℘(u) − ℘(v)), whatever the constants."""
    at_v = (v, g2, g3)
    rational = a + b / (wp(u, g2, g3) - wp(*at_v))
    # exsl34 with u and v exchanged: 1/(℘u − ℘v) = −(ζ(u+v) − ζ(u−v) − 2ζv)/℘′v.
    zetas = wzeta(u + v, g2, g3) - wzeta(u - v, g2, g3) - 2 * wzeta(*at_v)
    by_zeta = book.show("ξ", a - b / wp_prime(*at_v) * zetas)
    addition = Equal(zetas, wp_prime(*at_v) / (wp(*at_v) - wp(u, g2, g3)))
    book.claim("shape.addition", "the addition formula for ζ", addition, domain=WHERE, source="exsl34")
    book.claim(
        "shape.xi", "ξ by ζ", Equal(by_zeta, rational), domain=WHERE, steps=("shape.addition",), source="exhpf14"
    )
    # ζ = (ln σ)′, so that ξ = y′ integrates term by term, and y(0) = 0.
    sigmas = log(wsigma(u + v, g2, g3) / wsigma(u - v, g2, g3))
    integral = (a + 2 * b * wzeta(*at_v) / wp_prime(*at_v)) * u - b / wp_prime(*at_v) * sigmas
    y = book.show("y", integral.subs(u, u_o + s) - integral.subs(u, u_o))
    xi_of_s = rational.subs(u, u_o + s)
    slope = Equal(diff(y, s), xi_of_s)
    book.claim("shape.y", "y′ = ξ", slope, domain=WHERE, steps=("shape.xi",), source="exhpf15")
    start = Equal(y.subs(s, 0), 0)
    book.claim("shape.y_start", "y(0) = 0", start, domain=WHERE, steps=("shape.y",), source="exhpf15")
    return xi_of_s, y, zetas


def _case(case: LoadCase, functions: Weierstrass, general: tuple[Expr, Expr, Expr], book: Notebook) -> Shape:
    """The shape of one load case."""
    book.say(f"Section 3, load case {case.name}: the shape")
    xi_of_s, y, zetas = general
    if functions.linear is not None:
        xi_of_s, y = _linear_shape(case, functions.linear, book)
    elif case.bends == 1:
        _claim_real_slope(case, functions, zetas, book)
    return Shape(xi_of_s, y, _height(case, book))


def _claim_real_slope(case: LoadCase, functions: Weierstrass, zetas: Expr, book: Notebook) -> None:
    """With H > 0 and v in (0, ω₁), ℘′(v) = −b√H, so that b/℘′(v) is −1/√H (exsl33, exsl35, exsl36)."""
    slope = wp_prime(v, g2, g3)
    value = -functions.at_one.b * sqrt(case.stiffness)
    where = Domain({**WHERE.ranges, **case.domain(**{case.constant.name: case.ends}).ranges})
    squares = Equal(value**2, functions.slope_squared)
    name = f"shape.{case.name}"
    steps, source = case.ids("weierstrass.slope"), case.source("real slope")
    book.claim(f"{name}.slope", "(b√H)² = ℘′(v)²", squares, domain=where, steps=steps, source=source)
    short = Equal(a - b / slope * zetas, a + zetas / sqrt(case.stiffness))
    given = ((b, functions.at_one.b), (slope, value))
    steps, source = ("shape.xi", *case.ids("shape.slope", "weierstrass.solution")), case.source("xi by zeta")
    book.claim(f"{name}.xi", "ξ by ζ with 1/√H", short, domain=where, given=given, steps=steps, source=source)


def _linear_shape(case: LoadCase, linear: tuple[Expr, Expr], book: Notebook) -> tuple[Expr, Expr]:
    """ξ linear in ℘ integrates to ζ (slch11, slch12)."""
    start, rate = linear
    xi_of_s = start + rate * wp(u_o + s, g2, g3)
    y = book.show("y", start * s - rate * (wzeta(u_o + s, g2, g3) - wzeta(u_o, g2, g3)))
    where = Domain({**WHERE.ranges, **case.domain(**{case.constant.name: (1, 2)}).ranges})
    name, source, steps = f"shape.{case.name}", case.source("y"), case.ids("weierstrass.linear")
    slope, at_clamp = Equal(diff(y, s), xi_of_s), Equal(y.subs(s, 0), 0)
    book.claim(f"{name}.y", "y′ = ξ", slope, domain=where, steps=steps, source=source)
    book.claim(f"{name}.y_start", "y(0) = 0", at_clamp, domain=where, steps=(f"{name}.y",), source=source)
    return xi_of_s, y


def _height(case: LoadCase, book: Notebook) -> Mapping[str, Expr]:
    """z from dz/dξ = z′/y″ = −1/κ_x with κ_x = √f̂ (exsl9a, exsl38)."""
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


def main() -> None:
    """Print the derivation up to here."""
    from .chain import print_up_to

    print_up_to("shape")


if __name__ == "__main__":
    main()
