"""From the quartic to ℘: ξ = a + b/(℘(u) − c), the invariants, ℘′(v), and every case of u_o (exsl16-exsl31).

An *expansion* is the substitution at one root a of f. The article takes a = 1; ``tip`` takes a = ξ(ℓ).
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from sympy import Expr, Integer, Matrix, Poly, Rational, Symbol, cancel, diff, expand, factor, oo, symbols

from .claims import Domain, Equal, Limit, Notebook
from .functions import wp, wp_prime
from .load_case import COSINES, LoadCase, xi_tip
from .perimeter import claim_sides
from .quartic_range import kinds
from .symbols import u, xi
from .uo_cases import UoCase, uo_cases

kappa = Symbol("varkappa", real=True)  # ϰ, the value of ℘


@dataclass(frozen=True)
class Expansion:
    """ξ = a + b/(℘ − c) at a root a of f (exsl16, exsl17)."""

    a: Expr
    b: Expr
    c: Expr

    def xi_at(self, value: Expr) -> Expr:
        """ξ where ℘ has the value."""
        return self.a + self.b / (value - self.c)

    def value_at(self, root: Expr) -> Expr:
        """The value of ℘ where ξ is another root of f: a half-period value e."""
        return self.c + self.b / (root - self.a)


@dataclass(frozen=True)
class Weierstrass:
    """The solution of one load case by ℘(u; g₂, g₃), u = u_o + s.

    at_one, at_tip: the expansions at a = 1 and a = ξ(ℓ). linear: for a cubic f, (ξ at ℘ = 0, dξ/d℘) of the linear map
    (slch7), else None. slope_squared: ℘′(v)² at ℘(v) = c, a = 1 (exsl29). uo_cases: where the rod begins.
    """

    g2: Expr
    g3: Expr
    at_one: Expansion
    at_tip: Expansion
    linear: tuple[Expr, Expr] | None
    slope_squared: Expr
    uo_cases: tuple[UoCase, ...]


def derive(cases: Mapping[str, LoadCase], book: Notebook) -> Mapping[str, Weierstrass]:
    """The elliptic functions of all load cases."""
    book.say("Section 3. The substitution that leads to the Weierstrass function")
    _claim_derivatives(book)
    _claim_substitution(book)
    claim_sides(book)
    return {name: _case(case, book) for name, case in cases.items()}


def expansion(f: Expr, a: Expr, x: Symbol = xi) -> Expansion:
    """b = f′(a)/4 and c = f″(a)/24 at a root a of f(x) (exsl17)."""
    b, c = diff(f, x).subs(x, a) / 4, diff(f, x, 2).subs(x, a) / 24
    return Expansion(a, expand(b), expand(c))


def resolvent(f: Expr, at: Expansion, x: Symbol = xi) -> Expr:
    """f(a + b/(ϰ − c))(ϰ − c)⁴/b² = 4ϰ³ − g₂ϰ − g₃, by Taylor's formula at the root a of f(x) (exsl19)."""
    shift = kappa - at.c
    cubic, quartic = (diff(f, x, n).subs(x, at.a) for n in (3, 4))
    return 4 * shift**3 + 12 * at.c * shift**2 + cubic / 6 * at.b * shift + quartic / 24 * at.b**2


def _claim_derivatives(book: Notebook) -> None:
    """℘″ = 6℘² − g₂/2 against the derivative of ℘′² = 4℘³ − g₂℘ − g₃, for any invariants."""
    g2, g3 = symbols("g2 g3", real=True)
    value = wp(u, g2, g3)
    # g₃ is constant and leaves no trace in the derivative.
    squares = Equal(diff(wp_prime(u, g2, g3) ** 2, u), diff(4 * value**3 - g2 * value, u))
    where = Domain({g2: (3, 4), g3: (Rational(1, 4), Rational(1, 2)), u: (Rational(1, 5), Rational(2, 5))})
    title = "℘″ is the one that the differential equation of ℘ gives"
    book.claim("weierstrass.second_derivative", title, squares, domain=where, source="DLMF 23.3.12")


def _claim_substitution(book: Notebook) -> None:
    """The substitution for any quartic and any of its roots: no square is left in the resolvent."""
    a, *q = symbols("a q1:5", positive=True)
    f = sum((q[n - 1] * (xi**n - a**n) for n in range(1, 5)), start=Integer(0))
    at = expansion(f, a)
    where = Domain({**dict.fromkeys((a, *q), (0, oo)), kappa: (0, 1)})
    form = resolvent(f, at)
    direct = f.subs(xi, at.xi_at(kappa)) * (kappa - at.c) ** 4 / at.b**2
    title = "f at ξ = a + b/(ϰ − c) is a cubic in ϰ"
    book.claim("weierstrass.resolvent", title, Equal(form, direct), domain=where, source="exsl19")
    depressed = Equal(Poly(expand(form), kappa).coeff_monomial(kappa**2), 0)
    title, steps = "without a square of ϰ", ("weierstrass.resolvent",)
    book.claim("weierstrass.depressed", title, depressed, domain=where, steps=steps, source="exsl17")


def invariants(f: Expr, x: Symbol = xi) -> tuple[Expr, Expr]:
    """g₂ and g₃ of f = a₀x⁴ + 4a₁x³ + 6a₂x² + 4a₃x + a₄ by its coefficients (exsl21; DLMF 23.20(ii), 22.18)."""
    a0, a1, a2, a3, a4 = (f.coeff(x, 4 - n) / binomial for n, binomial in enumerate((1, 4, 6, 4, 1)))
    g2 = a0 * a4 - 4 * a1 * a3 + 3 * a2**2
    g3 = a0 * a2 * a4 + 2 * a1 * a2 * a3 - a2**3 - a0 * a3**2 - a1**2 * a4
    return expand(g2), expand(g3)


def _case(case: LoadCase, book: Notebook) -> Weierstrass:
    """One load case: the expansions, the invariants by three routes, ℘′(v) and the u_o."""
    book.say(f"Section 3, load case {case.name}: the Weierstrass function")
    g2, g3 = invariants(case.f)
    at_one, at_tip = expansion(case.f, Integer(1)), expansion(_tip_quartic(case), xi_tip)
    book.show("b, c at a = 1", (at_one.b, at_one.c))
    book.show("g₂, g₃", (g2, g3))
    any_constant = case.domain(**{case.constant.name: (1, 2)})
    _claim_constants(case, at_one, any_constant, book)
    _claim_invariants(case, at_one, g2, g3, any_constant, book)
    # exsl29: the square of ℘′ where ξ is infinite.
    slope_squared = book.show("℘′(v)²", factor(expand(4 * at_one.c**3 - g2 * at_one.c - g3)))
    slope, name = Equal(slope_squared, case.stiffness * at_one.b**2), f"weierstrass.{case.name}.slope"
    source, steps = case.source("slope at pole"), case.ids("weierstrass.at_one", "quartic.levels")
    book.claim(name, "℘′(v)² = Hb²", slope, domain=any_constant, steps=steps, source=source)
    _claim_limits(case, at_one, book)
    linear = _linear(case, g2, g3, book) if case.bends == 0 else None

    def cubic(value: Expr) -> Expr:
        return 4 * value**3 - g2 * value - g3

    if linear is None:
        starts = uo_cases(case, at_one.value_at, (at_one.c, at_one.b), cubic, book)
    else:
        starts = uo_cases(case, lambda root: (root - linear[0]) / linear[1], None, cubic, book)
    return Weierstrass(g2, g3, at_one, at_tip, linear, slope_squared, starts)


def _tip_quartic(case: LoadCase) -> Expr:
    """f with the constant in ξ(ℓ)."""
    return expand(case.f.subs(case.constant, case.tip_constant))


def _claim_constants(case: LoadCase, at: Expansion, where: Domain, book: Notebook) -> None:
    """b and c at a = 1 by the derivatives of f̂ alone, from f = f̂(1 − ξ²)."""
    height, slope = (diff(case.f_hat, xi, n).subs(xi, 1) for n in (0, 1))
    found, expected = Matrix([at.b, at.c]), Matrix([-height / 2, -(height + 2 * slope) / 12])
    title, name = "b and c at a = 1 by f̂", f"weierstrass.{case.name}.constants"
    steps = ("weierstrass.resolvent", *case.ids("quartic.motion"))
    book.claim(name, title, Equal(found, expected), domain=where, steps=steps, source=case.source("at one"))


def _claim_invariants(case: LoadCase, at: Expansion, g2: Expr, g3: Expr, where: Domain, book: Notebook) -> None:
    """g₂, g₃ from the coefficients against the resolvents at 1 and ξ(ℓ), the roots, and the differential equation."""
    name, source = f"weierstrass.{case.name}", case.source("invariants")
    cubic = 4 * kappa**3 - g2 * kappa - g3
    where = where.with_range(kappa, 0, 1)
    same = Equal(resolvent(case.f, at), cubic)
    steps = ("weierstrass.resolvent", "weierstrass.depressed", *case.ids("quartic.motion"))
    book.claim(f"{name}.at_one", "the resolvent at a = 1", same, domain=where, steps=steps, source=source)
    f, tip = _tip_quartic(case), case.domain(xi_tip=COSINES).with_range(kappa, 0, 1)
    to_tip = (case.constant, case.tip_constant)
    same = Equal(resolvent(f, expansion(f, xi_tip)), cubic.subs(*to_tip))
    steps += case.ids("quartic.free_end")
    book.claim(f"{name}.at_tip", "the resolvent at a = ξ(ℓ)", same, domain=tip, steps=steps, source=source)
    # The three other roots are the half-period values: 4ϰ³ − g₂ϰ − g₃ = 4(ϰ − e₁)(ϰ − e₂)(ϰ − e₃).
    if case.other_root is not None:
        product = Integer(4)
        for root in (Integer(-1), xi_tip, case.other_root):
            product = product * (kappa - at.value_at(root).subs(*to_tip))
        roots = Equal(product, cubic.subs(*to_tip))
        title, steps = "e₁, e₂, e₃ from the roots of f", case.ids("weierstrass.at_one", "quartic.factors")
        book.claim(f"{name}.roots", title, roots, domain=tip, steps=steps, source=source)
    # exsl12 and exsl22: the function solves the equation, for any u_o.
    xi_of_u = at.xi_at(wp(u, g2, g3))
    solved = Equal(diff(xi_of_u, u) ** 2, case.f.subs(xi, xi_of_u))
    running = Domain({**where.ranges, u: (Rational(1, 10), Rational(3, 10))})
    # ϰ = c + b/(ξ − a) has (ϰ′)² = (dϰ/dξ)² f(ξ), the equation of ℘; and so on u = u_o + s.
    unknown = Equal(diff(at.value_at(xi), xi) ** 2 * case.f, cubic.subs(kappa, at.value_at(xi)))
    anywhere, steps = where.with_range(xi, *COSINES), case.ids("weierstrass.at_one")
    source = case.source("unknown")
    book.claim(f"{name}.unknown", "(ϰ′)² = 4ϰ³ − g₂ϰ − g₃", unknown, domain=anywhere, steps=steps, source=source)
    start, run = symbols("u_o s", real=True)
    moving = wp(start + run, g2, g3)
    along = Domain({**where.ranges, **dict.fromkeys((start, run), (Rational(1, 10), Rational(2, 10)))})
    shifted = Equal(diff(moving, run) ** 2, cubic.subs(kappa, moving))
    source, steps = case.source("along the rod"), (f"{name}.unknown",)
    book.claim(f"{name}.along", "the same on u = u_o + s", shifted, domain=along, steps=steps, source=source)
    source, steps = case.source("solution"), (f"{name}.unknown",)
    book.claim(f"{name}.solution", "(ξ′)² = f(ξ)", solved, domain=running, steps=steps, source=source)


def _linear(case: LoadCase, g2: Expr, g3: Expr, book: Notebook) -> tuple[Expr, Expr]:
    """For a cubic f = p₃ξ³ + p₂ξ² + … the map ξ = (4/p₃)(℘ − p₂/12) (slch7)."""
    p3, p2 = case.f.coeff(xi, 3), case.f.coeff(xi, 2)
    start, rate = book.show("ξ at ℘ = 0, dξ/d℘", (cancel(-p2 / (3 * p3)), cancel(4 / p3)))
    where = case.domain(**{case.constant.name: (1, 2)}).with_range(u, Rational(1, 10), Rational(3, 10))
    xi_of_u = start + rate * wp(u, g2, g3)
    solved = Equal(diff(xi_of_u, u) ** 2, case.f.subs(xi, xi_of_u))
    title, steps = "(ξ′)² = f(ξ) by the linear map", case.ids("quartic.motion", "weierstrass.at_one")
    name = f"weierstrass.{case.name}.linear"
    book.claim(name, title, solved, domain=where, steps=steps, source=case.source("linear"))
    return start, rate


def _claim_limits(case: LoadCase, at: Expansion, book: Notebook) -> None:
    """b at the ends of the range of the constant (exsl26, exsl27, exhpf9, exhpf10)."""
    # At a = 1, b = f′(1)/4 = −f̂(1)/2, and f̂ there is −H(1 − ξ_a)(1 − ξ_b).
    gap = case.stiffness * (1 - case.vertex) ** 2 / 2 if case.bends else None
    straight = {1: Integer(0), -1: 2 * case.force}.get(case.bends)
    if gap is None or straight is None:
        return
    values = (gap, straight)[:: case.sense]
    for end, point, side, value in zip(("lower", "upper"), case.ends, "+-", values, strict=True):
        limit = Limit(at.b, case.constant, point, value, side)
        where = case.domain(**{case.constant.name: case.ends})
        title, name = f"b at the {end} end of the range", f"weierstrass.{case.name}.b_{end}"
        steps = case.ids("weierstrass.constants", "quartic.levels", f"quartic.end_{end}")
        source = case.source(f"at {kinds(case)[end]}")
        book.claim(name, title, limit, domain=where, steps=steps, source=source)


def main() -> None:
    """Print the derivation up to here."""
    from .chain import print_up_to

    print_up_to("weierstrass")


if __name__ == "__main__":
    main()
