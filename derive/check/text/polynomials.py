"""The polynomials f and f̂ of a load case: signs between points, coefficients, roots, growth, and the constant's range.

sign          of, is, between = [low, high]: f or f̂ has this sign for ξ between these values
coefficient   of, power, is: the sign of a coefficient
roots         of, values: its roots, as monomials
growth        of, at = {plus, minus}: the sign to which f is infinite for ξ → +∞ and ξ → −∞
discriminant  values: a quarter of the discriminant of f̂, as a sum of monomials, and it is positive
range         ends: of the range of the constant, as monomials
degree        along, degrees: with the field along e_y or e_z, f = (y″)² and f̂ are polynomials in y′ of these degrees
"""

from __future__ import annotations

from typing import Any

from sympy import Expr, Integer, Poly, PolynomialError, Symbol, cancel, cos, degree, expand, oo, pi, prod, sin, sqrt

from derive.check.report import RelationVerdict
from derive.check.text.forms import (
    Judge,
    Variants,
    case_of,
    decided,
    exactly,
    monomial,
    quantities,
    refuted,
    where,
    with_xi,
)
from derive.paper.text_claims import TextClaim
from derive.theory.claims import Domain, Equal, Positive
from derive.theory.symbols import alpha, eta, xi

SIGNS = {"positive": 1, "negative": -1}
DIRECTIONS = {"e_y": pi * 0, "e_z": pi / 2, "halfway": pi / 4}  # angles from the y axis


def judge_sign(theory: Any, claim: TextClaim, decide: Judge) -> list[RelationVerdict]:
    """One sign, for all ξ between the two values."""
    values = quantities(theory, claim)
    low, high = (values[name] for name in claim.data["between"])
    gap = SIGNS[claim.data["is"]] * values[claim.data["of"]]
    title = f"{claim.data['of']} is {claim.data['is']} from {' to '.join(claim.data['between'])}"
    return [decided(decide, title, Positive(gap), with_xi(where(case_of(theory, claim)), low, high))]


def vary_sign(claim: TextClaim) -> Variants:
    """The other sign; the whole of (−1, 1)."""
    yield "sign", claim.but(**{"is": _other(claim.data["is"])})
    yield "interval", claim.but(between=["-1", "1"])


def _other(sign: str) -> str:
    return "negative" if sign == "positive" else "positive"


def judge_coefficient(theory: Any, claim: TextClaim, decide: Judge) -> list[RelationVerdict]:
    """The sign of a coefficient, everywhere."""
    of, power = claim.data["of"], claim.data["power"]
    value = SIGNS[claim.data["is"]] * expand(quantities(theory, claim)[of]).coeff(xi, power)
    title = f"the coefficient of xi^{power} in {of} is {claim.data['is']}"
    return [decided(decide, title, Positive(value), where(case_of(theory, claim)))]


def vary_coefficient(claim: TextClaim) -> Variants:
    """The other sign; the constant term, which has none."""
    yield "sign", claim.but(**{"is": _other(claim.data["is"])})
    yield "power", claim.but(power=claim.data["power"] - 2)


def judge_roots(theory: Any, claim: TextClaim, decide: Judge) -> list[RelationVerdict]:
    """The polynomial is its leading coefficient times ξ less each value."""
    polynomial = quantities(theory, claim)[claim.data["of"]]
    values = [monomial(one) for one in claim.data["values"]]
    product = Poly(polynomial, xi).LC() * prod(xi - value for value in values)
    domain = with_xi(where(case_of(theory, claim)), -oo, oo)
    return [decided(decide, f"the roots of {claim.data['of']}", Equal(polynomial, product), domain)]


def judge_discriminant(theory: Any, claim: TextClaim, decide: Judge) -> list[RelationVerdict]:
    """The sum against the discriminant that SymPy finds, and its sign."""
    case, said = case_of(theory, claim), sum((monomial(one) for one in claim.data["values"]), Integer(0))
    found = Poly(case.f_hat, xi).discriminant() / 4
    return [
        decided(decide, "a quarter of the discriminant of f_hat", Equal(said, found), where(case)),
        decided(decide, "it is positive", Positive(said), where(case)),
    ]


def judge_range(theory: Any, claim: TextClaim, decide: Judge) -> list[RelationVerdict]:
    """The ends against those of the theory."""
    case = case_of(theory, claim)
    return [
        decided(decide, f"the {name} end", Equal(monomial(said), end), case.domain())
        for name, said, end in zip(("lower", "upper"), claim.data["ends"], case.ends, strict=True)
    ]


def vary_monomials(claim: TextClaim) -> Variants:
    """Another sign, another factor, another power, one value at a time."""
    name = "values" if "values" in claim.data else "ends"
    parts = claim.data[name]
    for n, one in enumerate(parts):
        changes = [("sign", {"times": f"-{one['times']}".replace("--", "")}), ("number", {"times": "3"})]
        changes += [("power", {letter: power + 1}) for letter, power in one.items() if letter != "times"]
        for kind, change in changes:
            yield kind, claim.but(**{name: [*parts[:n], {**one, **change}, *parts[n + 1 :]]})
    if name == "ends":
        yield "order", claim.but(ends=parts[::-1])


def judge_growth(theory: Any, claim: TextClaim, decide: Judge) -> list[RelationVerdict]:
    """The leading term decides, on both sides."""
    case, polynomial = case_of(theory, claim), Poly(quantities(theory, claim)[claim.data["of"]], xi)
    found = []
    for side, sign in (("plus", 1), ("minus", -1)):
        said = 1 if claim.data["at"][side] == "+" else -1
        leading = polynomial.LC() * sign ** degree(polynomial)
        found.append(
            decided(decide, f"{claim.data['of']} for xi to {side} infinity", Positive(said * leading), where(case))
        )
    return found


def vary_growth(claim: TextClaim) -> Variants:
    """The other sign on one side."""
    for side, sign in claim.data["at"].items():
        yield "sign", claim.but(at={**claim.data["at"], side: "-" if sign == "+" else "+"})


def judge_degree(theory: Any, claim: TextClaim, decide: Judge) -> list[RelationVerdict]:
    """Polynomials in ξ with the claimed degrees; and that no direction between gives a polynomial."""
    plane, angle = theory.plane, DIRECTIONS[claim.data["along"]]
    square = expand(plane.square.subs(plane.alignment, cos(angle) * xi + sin(angle) * sqrt(1 - xi**2)))
    said = {"f": square, "f_hat": cancel(square / (1 - xi**2))}
    found = [_degree(name, said[name], number) for name, number in claim.data["degrees"].items()]
    root = Symbol("root")  # √(1 − ξ²)
    between = expand(plane.curvature_squared.subs(plane.alignment, cos(alpha) * xi + sin(alpha) * root))
    odd = -between.coeff(root, 1).coeff(xi, 1)
    domain = Domain({alpha: (0, pi / 2), eta: (0, oo)})
    title = "in a direction between e_y and e_z a term with the root of 1 - xi^2 remains"
    return [*found, decided(decide, title, Positive(odd), domain)]


def _degree(name: str, expression: Expr, number: int) -> RelationVerdict:
    title = f"{name} is a polynomial of degree {number} in xi"
    try:
        found = Poly(expression, xi).degree()
    except PolynomialError:
        return refuted(title, "it is no polynomial", {name: expression})
    return exactly(title, found == number, "degree", {"degree": found})


def vary_degree(claim: TextClaim) -> Variants:
    """A field halfway between the axes; other degrees."""
    yield "direction", claim.but(along="halfway")
    for name, number in claim.data["degrees"].items():
        for other in (number - 1, number + 1):
            yield "number", claim.but(degrees={**claim.data["degrees"], name: other})
