"""All readings of a printed statement, from the theory; see ``meaning``."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import Any

from sympy import Expr, Integer, Rational, cos, oo, pi, sqrt

from derive.check import meaning as m
from derive.check.meaning import Components, Reading
from derive.check.sections import BY_SCOPE, plane_shape
from derive.paper import tree as t
from derive.theory.claims import Domain
from derive.theory.load_case import LoadCase, linear_root, xi_tip
from derive.theory.symbols import alpha, beta, eta, gamma, gamma_bar, theta, xi
from derive.theory.weierstrass import Expansion, Weierstrass, expansion

ELLIPTIC = {"varkappa", "wp", "u", "u_o"}
MOVING = {"kappa_x", "k", "d_3", "binormal", "theta", "y", "z"}
SECTIONS = ("parallel", "orthogonal", "field_only", "force_only")


def names_in(*nodes: t.Node) -> set[str]:
    """The names in printed trees; primes count as ``'`` and ξ(ℓ) as ``tip``."""
    found = set()
    for node in (below for top in nodes for below in top.walk()):
        if isinstance(node, t.Name | t.Call):
            found.add(node.name)
        if isinstance(node, t.Primed):
            found.add("'")
        if isinstance(node, t.Call) and node.name == "xi" and node.args == (t.Name("ell"),):
            found.add("tip")
    return found


def readings(
    theory: Any, scope: str, sides: tuple[t.Node, ...], given: tuple[t.Statement, ...]
) -> Iterator[Components]:
    """Every reading of a plain statement with these sides, under the hypotheses that the text gives."""
    if scope in BY_SCOPE:
        yield from BY_SCOPE[scope](theory, sides, given)
        return
    if scope not in ("plane", *SECTIONS):
        raise m.MeaningError(f"nothing says what the letters of the section '{scope}' mean in the theory")
    names = names_in(*sides, *(side for statement in given for side in statement.sides))
    if scope == "plane" and not names & {"f", "f_hat"}:
        yield from _any_field(theory)
        return
    assumed = {(statement.sides[0], statement.sides[-1]) for statement in given}
    at_one = (t.Name("a"), t.Number(1)) in assumed
    if scope in SECTIONS and (found := plane_shape.readings(theory, scope, sides, names, at_one)) is not None:
        yield from found
        return
    for name in SECTIONS[:2] if scope == "plane" else [scope]:
        case, functions = theory.cases[name], theory.weierstrass[name]
        for title, at, to_tip in _roots(case, functions, names, at_one):
            for reading in _of_case(case, functions, names, at, to_tip):
                yield replace(reading, title=f"{name}, {reading.title}{title}")


def _any_field(theory: Any) -> Iterator[Reading]:
    """Along the rod, with the field in any direction of the plane."""
    plane = theory.plane
    squared = plane.curvature_squared.subs({xi: cos(theta), plane.alignment: cos(theta - alpha)})
    constant = linear_root(squared - m.k**2, gamma)
    for bent in (1, -1):
        values = {**m.along_rod(bent, alpha), "beta": beta, "eta": eta, "gamma": constant}
        rates = m.rates_along_rod(bent, plane.angular_acceleration)
        ranges = {beta: (0, oo), eta: (0, oo), alpha: (0, pi), theta: (0, pi), m.k: (0, oo)}
        yield Reading(f"any field, curvature {'+-'[bent < 0]}k", values, Domain(ranges), rates)


def _roots(
    case: LoadCase, functions: Weierstrass, names: set[str], at_one: bool
) -> Iterator[tuple[str, Expansion, bool]]:
    """The expansions to read a, b, c at: at 1 if the text says so or does not need them, else at every root of f."""
    yield (", a = 1" if names & {"a", "b", "c"} else ""), functions.at_one, False
    if names & {"a", "b", "c"} and not at_one:
        yield ", a = -1", expansion(case.f, Integer(-1)), False
        yield ", a a root of f_hat", functions.at_tip, True


def _of_case(case: LoadCase, functions: Weierstrass, names: set[str], at: Expansion, to_tip: bool) -> Iterator[Reading]:
    """The readings of one load case at one root a."""
    tip = to_tip or "tip" in names
    fixed = {case.constant: case.tip_constant} if tip else {}
    values = {**_letters(case), "a": at.a, "b": at.b, "c": at.c}
    values |= {"g_2": functions.g2, "g_3": functions.g3, "e": m.E_Z if case.name == "orthogonal" else m.E_Y, **m.BASES}
    ranges = {"xi_tip": (-1, 1)} if tip else {case.constant.name: case.ends}
    base = Reading(
        "any point",
        values | {"xi": xi},
        case.domain(**ranges, xi=(-1, 1)),
        polynomials={"f": case.f, "f_hat": case.f_hat},
        at_tip=xi_tip if tip else None,
        constant=None if tip else case.constant,
        ends=case.ends,
    )
    if names & ELLIPTIC:
        yield _fixed(_elliptic(base, case, functions, names, at, ranges), fixed)
    elif names & (MOVING | {"'"}):
        yield from _moving(base, case, tip)
    else:
        yield _fixed(base, fixed)


def _letters(case: LoadCase) -> dict[str, Any]:
    """β, η (0 where the section has none), the constant and its range, the roots of f̂, arc lengths."""
    bar = "_bar" if case.constant == gamma_bar else ""
    values: dict[str, Any] = {"beta": 0 * beta, "eta": 0 * eta, **{p.name: p for p in case.parameters}}
    values |= {"gamma": case.gamma, "s": m.s, "ell": m.ell, "varsigma": m.varsigma, "u_o": m.u_o, "u": m.u}
    values |= {"theta": theta}
    values |= {f"gamma{bar}": case.constant, f"gamma{bar}_1": case.ends[0], f"gamma{bar}_2": case.ends[1]}
    return values | (dict(zip(("xi_a", "xi_b"), case.roots, strict=True)) if len(case.roots) == 2 else {})


def _fixed(reading: Reading, fixed: dict[Any, Expr]) -> Reading:
    """The reading with the constant replaced by what the free end makes it."""
    if not fixed:
        return reading

    def put(value: Any) -> Any:
        return value.subs(fixed)

    solution = reading.solution

    def solved(value: Expr) -> Expr:
        return put(solution(value)) if solution else value

    return replace(
        reading,
        values={name: put(value) for name, value in reading.values.items()},
        polynomials={name: put(value) for name, value in reading.polynomials.items()},
        invariants=reading.invariants and (put(reading.invariants[0]), put(reading.invariants[1])),
        solution=solved if solution else None,
        rates={symbol: put(value) for symbol, value in reading.rates.items()},
    )


def _elliptic(
    base: Reading, case: LoadCase, functions: Weierstrass, names: set[str], at: Expansion, ranges: dict[str, Any]
) -> Reading:
    """ξ and ϰ as functions of u; u is u_o + s where arc lengths occur, else free."""
    solution = at.xi_at
    if functions.linear is not None and not names & {"a", "b", "c"}:
        start, slope = functions.linear
        solution = _line(start, slope)
    here = m.u_o + m.s if names & {"s", "u_o", "'"} else m.u
    value = m.fn.wp(here, functions.g2, functions.g3)
    near = (Rational(1, 10), Rational(2, 10))
    domain = case.domain(**ranges)
    for symbol in (m.u, m.u_o, m.s, m.ell, m.varsigma):
        domain = domain.with_range(symbol, *near)
    return replace(
        base,
        title="as functions of u",
        values={**base.values, "u": here, "varkappa": value, "xi": solution(value)},
        domain=domain,
        rates={m.s: Integer(1)},
        invariants=(functions.g2, functions.g3),
        solution=solution,
        at_tip=None,
    )


def _line(start: Expr, slope: Expr) -> Any:
    return lambda value: start + slope * value


def _moving(base: Reading, case: LoadCase, tip: bool) -> Iterator[Reading]:
    """Along the rod in one load case: the curvature fixes the constant, or the free end fixes both."""
    squared = case.f_hat.subs(xi, cos(theta))
    angle = pi / 2 if case.name == "orthogonal" else Integer(0)
    for bent in (1, -1):
        values = {**base.values, **m.along_rod(bent, angle)}
        rates = m.rates_along_rod(bent, case.angular_acceleration)
        domain = Domain({**case.domain().ranges, theta: (0, pi), m.k: (0, oo)})
        here = replace(base, title=f"curvature {'+-'[bent < 0]}k", values=values, rates=rates, domain=domain)
        if not tip:
            yield replace(_fixed(here, {case.constant: linear_root(squared - m.k**2, case.constant)}), constant=None)
            continue
        bending = squared.subs(case.constant, case.tip_constant)
        ends = Domain({**case.domain(xi_tip=(-1, 1)).ranges, theta: (0, pi)}, (bending,))
        yield _fixed(replace(here, domain=ends), {case.constant: case.tip_constant, m.k: sqrt(bending)})
