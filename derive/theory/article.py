"""The article's own formulas as they are evaluated: ξ(s), y(s), z(ξ) and their constants, in the four load cases.

They are what ``quartic``, ``weierstrass`` and ``shape`` have derived, with the constant γ or γ̄ as one argument and the
logarithms of σ-quotients as differences of ln σ, continued along the rod. Each has a claim of its own, which rests on
that of the derivation.
"""

from __future__ import annotations

from collections.abc import Mapping

from sympy import Expr, Rational, Symbol, diff, sqrt

from .article_constants import Collector, c, constant, write_constants, write_invariants
from .claims import Domain, Equal, Formula, Notebook
from .functions import wlog_sigma, wp, wp_prime, wsigma, wzeta
from .load_case import LoadCase
from .shape import WHERE, Shape, b, g2, g3, u_o
from .symbols import beta, eta, s, u, v, xi
from .weierstrass import Weierstrass

logarithm = Symbol("logarithm")  # what ln σ(u + v)/σ(u − v) has grown by since the clamp


def derive(
    cases: Mapping[str, LoadCase], functions: Mapping[str, Weierstrass], shapes: Mapping[str, Shape], book: Notebook
) -> tuple[Formula, ...]:
    """The article's formulas of all load cases."""
    book.say("Section 3. The article's formulas as they are evaluated")
    _claim_logarithm(book)
    found: list[Formula] = []
    for name, case in cases.items():
        collector = Collector(case, book)
        write_constants(collector)
        write_invariants(collector, functions[name])
        if functions[name].linear is None:
            _shape(collector, functions[name])
        else:
            _linear_shape(collector, functions[name], shapes[name])
        _height(collector, shapes[name])
        found += collector.found
    return tuple(found)


def _solves(case: LoadCase, value: Expr, functions: Weierstrass) -> tuple[Equal, Domain]:
    """(ξ′)² = f(ξ) for ξ = value, with b, c, g₂, g₃ by the constant; and where."""
    at = functions.at_one
    whole = value.subs({b: at.b, c: at.c, g2: functions.g2, g3: functions.g3})
    where = case.domain(**{case.constant.name: (1, 2)}).with_range(u, Rational(1, 10), Rational(3, 10))
    return Equal(diff(whole, u) ** 2, case.f.subs(xi, whole)), where


def _shape(collector: Collector, functions: Weierstrass) -> None:
    """ξ = 1 + b/(℘ − c), and y by ζ(v) and the logarithm, continued (exsl22, exsl36, exhpf15)."""
    case, add = collector.case, collector.add
    value = 1 + b / (wp(u, g2, g3) - c)
    solved, where = _solves(case, value, functions)
    rests: tuple[str, ...] = ("weierstrass.solution",)
    add("xi", (b, c, u, g2, g3), value, "cos θ at u = u_o + s", solved, where, steps=rests, source="solution")
    title = "by how much ln σ(u + v)/σ(u − v) grows from the clamp to s, continued along the rod"
    rests = ("article.logarithm", "weierstrass.solution")
    add("logarithm", (v, u_o, s, g2, g3), LOGARITHM, title, _slope_of_logarithm(), WHERE, steps=rests, source="y")
    bending = case.bends == 1
    rate = -1 / sqrt(case.stiffness) if bending else b / wp_prime(v, g2, g3)
    y = (1 + 2 * rate * wzeta(v, g2, g3)) * s - rate * logarithm
    where = Domain({**WHERE.ranges, **case.domain(**{case.constant.name: case.ends}).ranges})
    whole = y.subs(logarithm, LOGARITHM)
    slope = Equal(diff(whole, s), 1 + b / (wp(u_o + s, g2, g3) - wp(v, g2, g3)))
    given = ((b, -wp_prime(v, g2, g3) / sqrt(case.stiffness)),) if bending else ()
    rests = ("shape.xi", *case.ids("article.logarithm", "shape.slope" if bending else "weierstrass.slope"))
    title = "y at s, with ln σ continued along the rod"
    add("y", (eta, b, v, s, logarithm, g2, g3), y, title, slope, where, steps=rests, source="y", given=given)
    _claim_start(collector, whole, "y", where)


def _claim_start(collector: Collector, y: Expr, name: str, where: Domain) -> None:
    """y vanishes at the clamp."""
    key, start = f"article.{collector.case.name}.{name}", Equal(y.subs(s, 0), 0)
    source = collector.case.source("y")
    collector.book.claim(f"{key}_start", "y(0) = 0", start, domain=where, steps=(key,), source=source)


def _quotient(at: Expr) -> Expr:
    """ln σ(u + v) − ln σ(u − v), the logarithm of the article's quotient."""
    return wlog_sigma(at + v, g2, g3) - wlog_sigma(at - v, g2, g3)


LOGARITHM = _quotient(u_o + s) - _quotient(u_o)


def _slope_of_logarithm() -> Equal:
    """The differences of ln σ grow as the logarithm of the quotient does."""
    quotient = wsigma(u_o + s + v, g2, g3) / wsigma(u_o + s - v, g2, g3)
    return Equal(diff(LOGARITHM, s), diff(quotient, s) / quotient)


def _claim_logarithm(book: Notebook) -> None:
    """ln σ has the derivative σ′/σ, that of any logarithm of σ."""
    same = Equal(diff(wlog_sigma(u, g2, g3), u), diff(wsigma(u, g2, g3), u) / wsigma(u, g2, g3))
    title = "(ln σ)′ = σ′/σ, wherever ln σ is continued to"
    book.claim("article.logarithm", title, same, domain=WHERE, source="DLMF 23.2.8")


def _linear_shape(collector: Collector, functions: Weierstrass, shape: Shape) -> None:
    """ξ linear in ℘, y by a difference of ζ (slch11, slch12)."""
    assert functions.linear is not None
    case, add, rod = collector.case, collector.add, (beta, constant)
    start, rate = functions.linear
    value = start + rate * wp(u, g2, g3)
    solved, where = _solves(case, value, functions)
    title, rests = "cos θ at u = u_o + s, linear in ℘", case.ids("weierstrass.linear")
    add("xi_linear", (*rod, u, g2, g3), value, title, solved, where, steps=rests, source="linear")
    slope = Equal(diff(shape.y, s), value.subs(u, u_o + s))
    where = Domain({**WHERE.ranges, **case.domain(**{case.constant.name: (1, 2)}).ranges})
    title, rests = "y at s, by a difference of ζ", case.ids("shape.y")
    add("y_linear", (*rod, u_o, s, g2, g3), shape.y, title, slope, where, steps=rests, source="y")
    _claim_start(collector, shape.y, "y_linear", where)


def _height(collector: Collector, shape: Shape) -> None:
    """z as a function of ξ while the curvature is positive (exsl41, exhpf19, slch14)."""
    case = collector.case
    for side, z in shape.z.items():
        suffix = f"_{side}" if side else "" if case.bends else "_linear"
        key = f"shape.{case.name}.z_{side}".rstrip("_")
        doc, slope = "z as a function of ξ, up to a constant, where θ grows", Equal(diff(z, xi) ** 2 * case.f_hat, 1)
        where, rests = collector.book.claims[key].domain, (f"{key}_sign",)
        collector.add(f"z{suffix}", (beta, eta, constant, xi), z, doc, slope, where, steps=rests, source="z")


def main() -> None:
    """Print the derivation up to here."""
    from .chain import print_up_to

    print_up_to("article")


if __name__ == "__main__":
    main()
