"""What the forms share: their record, the quantities of a load case by name, and single verdicts."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass
from typing import Any

from sympy import Expr, Integer, Rational, sympify

from derive.check.evaluate import evaluate
from derive.check.report import RelationVerdict
from derive.check.sample import Sampler
from derive.check.verdicts import PROVED, REFUTED, VERDICTS, Verdict
from derive.paper.text_claims import TextClaim
from derive.theory.claims import Claim, Domain, Equal, Positive
from derive.theory.load_case import LoadCase
from derive.theory.symbols import beta, eta, gamma, gamma_bar, xi

Judge = Callable[[Claim], Verdict]
Variants = Iterator[tuple[str, TextClaim]]
DIGITS = 30
POINTS = 60
RELATIONS = {"<": ">", ">": "<"}


@dataclass(frozen=True)
class Form:
    """How claims of one form are judged, and made wrong.

    judge(theory, claim, decide): the verdicts on its parts. variants(claim): the kind of each change, and the claim
    with it; all of them must be false where the claim is true.
    """

    judge: Callable[[Any, TextClaim, Judge], list[RelationVerdict]]
    variants: Callable[[TextClaim], Variants]


def proved(title: str, method: str) -> RelationVerdict:
    """A part that holds by a finite computation."""
    return RelationVerdict(title, Verdict(title, PROVED, method))


def refuted(title: str, method: str, counterexample: Mapping[str, Any]) -> RelationVerdict:
    """A part that fails, with what shows it."""
    shown = {name: str(value) for name, value in counterexample.items()}
    return RelationVerdict(title, Verdict(title, REFUTED, method, shown))


def open_verdict(title: str, verdict: VERDICTS, method: str, reason: str) -> RelationVerdict:
    """A part with any other verdict."""
    return RelationVerdict(title, Verdict(title, verdict, method, None, reason))


def decided(decide: Judge, title: str, relation: Equal | Positive, domain: Domain) -> RelationVerdict:
    """A part that is a relation on a domain."""
    return RelationVerdict(title, decide(Claim("text", title, relation, domain)))


def exactly(title: str, holds: bool, method: str, counterexample: Mapping[str, Any]) -> RelationVerdict:
    """A part that a finite computation decides."""
    return proved(title, method) if holds else refuted(title, method, counterexample)


def case_of(theory: Any, claim: TextClaim) -> LoadCase:
    """The load case of the section where a claim stands."""
    return theory.cases[claim.scope]  # type: ignore[no-any-return]  # the theory is Any here


def where(case: LoadCase) -> Domain:
    """Any parameters, and any constant in its range."""
    return case.domain(**{case.constant.name: case.ends})


def quantities(theory: Any, claim: TextClaim) -> dict[str, Expr]:
    """The quantities that claims on a load case name."""
    case, functions = case_of(theory, claim), theory.weierstrass[claim.scope]
    values: dict[str, Any] = {"1": Integer(1), "-1": Integer(-1), "0": Integer(0), "beta": beta, "eta": eta}
    values |= {f"xi_{letter}": root for letter, root in zip(case.letters, case.roots, strict=True)}
    values |= {"b": functions.at_one.b, "c": functions.at_one.c, "g_2": functions.g2, "g_3": functions.g3}
    values |= {"f": case.f, "f_hat": case.f_hat, "gamma_at_tip": case.gamma.subs(case.constant, case.tip_constant)}
    return values


def roots(theory: Any, claim: TextClaim) -> dict[str, Expr]:
    """The roots of f by name."""
    names = ("1", "-1", *(f"xi_{letter}" for letter in case_of(theory, claim).letters))
    return {name: quantities(theory, claim)[name] for name in names}


def monomial(parts: Mapping[str, Any]) -> Expr:
    """A number times powers of letters, given as data."""
    letters = {"beta": beta, "eta": eta, "gamma": gamma, "gamma_bar": gamma_bar}
    product: Expr = Rational(parts.get("times", "1"))
    for name, power in parts.items():
        if name != "times":
            product = product * letters[name] ** Rational(power)
    return product


def samples(
    expressions: Iterable[Expr], domain: Domain, points: int = POINTS
) -> Iterator[tuple[dict[Any, Any], list[Any]]]:
    """Random points of a domain, and the real values of expressions there."""
    expressions = [sympify(one, strict=True) for one in expressions]
    for point in Sampler(expressions, domain).points(points):
        yield point, [evaluate(one, point, DIGITS).real for one in expressions]


def with_xi(domain: Domain, low: Expr, high: Expr) -> Domain:
    """A domain in which ξ runs from one value to another."""
    return domain.with_range(xi, low, high)
