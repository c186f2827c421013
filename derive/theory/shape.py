"""The shape of the rod: y(s) by ζ and σ, z(s) elementary (exsl33-exsl41, exhpf14-exhpf19, slch12-slch14)."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from sympy import Expr, Rational, Symbol, diff, log, sqrt, symbols

from .claims import Domain, Equal, Notebook
from .functions import wp, wp_prime, wsigma, wzeta
from .height import height
from .load_case import LoadCase
from .symbols import s, u, v
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
    return Shape(xi_of_s, y, height(case, book))


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


def main() -> None:
    """Print the derivation up to here."""
    from .chain import print_up_to

    print_up_to("shape")


if __name__ == "__main__":
    main()
