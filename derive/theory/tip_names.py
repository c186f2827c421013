"""Names in which the formulas at the tip are written, so that they can be evaluated without cancellation.

A value that was computed as a rational function of the parameters, ξ(ℓ) and ξ is factored over the names, which
are polynomials in the same: 1 ± ξ(ℓ), β + ηξ(ℓ), and so on.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field

from sympy import Expr, Integer, Poly, Symbol, cancel, div, expand, fraction

from .claims import Domain, Formula, Notebook, Relation
from .load_case import COSINES, LoadCase, xi_tip
from .symbols import beta, eta, xi

plus = Symbol("plus", positive=True)  # 1 + ξ(ℓ)
minus = Symbol("minus", positive=True)  # 1 − ξ(ℓ)
drive = Symbol("drive", real=True)  # β + ηξ(ℓ): θ″(ℓ)/sin θ(ℓ)
gap = Symbol("gap", real=True)  # η(1 − ξ(ℓ)) − 2β: less the level at ξ = −1
level = Symbol("level", real=True)  # 2β + η(ξ + ξ(ℓ)): f̂(ξ)/(ξ(ℓ) − ξ)
drop = Symbol("drop", real=True)  # ξ(ℓ) − ξ
one_plus = Symbol("one_plus", positive=True)  # 1 + ξ
one_minus = Symbol("one_minus", positive=True)  # 1 − ξ
x_plus = Symbol("x_plus", positive=True)  # ℘ − e₊
x_minus = Symbol("x_minus", positive=True)  # ℘ − e₋
x_other = Symbol("x_other", positive=True)  # ℘ − e_o
x_pole = Symbol("x_pole", positive=True)  # ℘ − c
arc = Symbol("arc", positive=True)  # σ, the length from the tip
sin_tip = Symbol("sin_tip", real=True)  # sin θ(ℓ)
length = Symbol("length", positive=True)  # ℓ
y_tip = Symbol("y", real=True)  # y(ℓ)
square = Symbol("square", real=True)  # −2∫ψ along the rod


def definitions(case: LoadCase) -> dict[Symbol, Expr]:
    """What the names stand for in a load case, from its f̂ with the root ξ(ℓ)."""
    # f̂(ξ) = (ξ(ℓ) − ξ)·level: the division leaves no remainder, or the tip is no root.
    height = cancel(case.at_tip / (xi_tip - xi))
    return {
        plus: 1 + xi_tip,
        minus: 1 - xi_tip,
        drive: expand(height.subs(xi, xi_tip) / 2),
        gap: expand(-height.subs(xi, -1)),
        level: expand(height),
        drop: xi_tip - xi,
        one_plus: 1 + xi,
        one_minus: 1 - xi,
    }


def in_names(value: Expr, names: Iterable[Symbol], meaning: Mapping[Symbol, Expr]) -> Expr:
    """The value as a product of powers of the names and of what is left; ξ(ℓ) in the rest goes into ``plus``."""
    # Names that hold parameters first: η(1 − ξ(ℓ)) is the gap before it is η times minus.
    names = tuple(sorted(names, key=lambda name: meaning[name].free_symbols <= {xi_tip, xi}))
    above, below = fraction(cancel(value))
    product: Expr = Integer(1)
    for name in names:
        above, upper = _extract(above, meaning[name])
        below, lower = _extract(below, meaning[name])
        product = product * name**upper / name**lower
    content, rest = _tidy(cancel(above / below), names).as_content_primitive()
    # The number goes to the names, so that the rest stays a factor.
    return product * content * rest


def _extract(expression: Expr, divisor: Expr) -> tuple[Expr, int]:
    """The polynomial divided by the divisor as often as it goes, and how often."""
    times = 0
    while expression != 0:
        generators = sorted(expression.free_symbols | divisor.free_symbols, key=lambda symbol: symbol.name)
        quotient, remainder = div(Poly(expression, *generators), Poly(divisor, *generators))
        if not remainder.is_zero:
            break
        expression, times = quotient.as_expr(), times + 1
    return expression, times


def _tidy(value: Expr, names: tuple[Symbol, ...]) -> Expr:
    """Write ξ(ℓ) where no name divides by ``plus`` or ``minus``, whichever is allowed."""
    for name, inverse in ((plus, plus - 1), (minus, 1 - minus)):
        if name in names and value.has(xi_tip):
            value = expand(value.subs(xi_tip, inverse))
    return value


@dataclass
class Writer:
    """Collects the formulas of one load case, each with the claim that stands for it.

    meaning: what the names stand for. proved: the claim that says so, for the names that have one.
    """

    case: LoadCase
    book: Notebook
    meaning: dict[Symbol, Expr]
    formulas: list[Formula] = field(default_factory=list)
    proved: dict[Symbol, str] = field(default_factory=dict)

    @property
    def domain(self) -> Domain:
        """Any tip and any point."""
        return self.case.domain(xi_tip=COSINES, xi=COSINES)

    def claim(
        self,
        key: str,
        title: str,
        relation: Relation,
        domain: Domain | None = None,
        *,
        steps: Iterable[str],
        source: str,
    ) -> str:
        """Assert a relation, with the names given their meaning.

        steps: ids of the claims it rests on, or their keys ``section.key`` in this load case. source: a key of
        ``SOURCES``.
        """
        (found,) = self.case.ids(f"tip.{key}")
        rests = dict.fromkeys(step if step in self.book.claims else self.case.ids(step)[0] for step in steps)
        self.book.claim(
            found,
            title,
            relation,
            domain=domain or self.domain,
            given=tuple(self.meaning.items()),
            steps=rests,
            source=self.case.source(source),
        )
        return found

    def add(
        self,
        name: str,
        arguments: tuple[Symbol, ...],
        expression: Expr,
        doc: str,
        property: Callable[[Expr], Relation],
        domain: Domain | None = None,
        *,
        steps: Iterable[str],
        source: str,
        gives: Symbol | None = None,
    ) -> Expr:
        """Record a formula and claim the property that defines it; parameters that the case lacks are no arguments.

        steps, source: as for ``claim``; the claims that stand for the names in the expression are added. gives: the
        name whose value this is.
        """
        kept = [a for a in arguments if a not in (beta, eta) or a in self.case.parameters]
        others = sorted(expression.free_symbols & set(self.case.parameters) - set(kept), key=lambda p: p.name)
        strange = expression.free_symbols - set(kept) - set(others)
        if strange:
            raise ValueError(f"{self.case.name}: the formula {name} holds {strange}, which are not among its arguments")
        named = (self.proved[a] for a in kept if a in self.proved and expression.has(a))
        claim = self.claim(name, doc, property(expression), domain, steps=(*steps, *named), source=source)
        if gives is not None:
            self.proved[gives] = claim
        label = self.case.source(source)
        formula = Formula(name, (*kept, *others), expression, claim, doc, self.case.name, label)
        self.formulas.append(formula)
        return self.book.show(f"{name}({', '.join(a.name for a in formula.arguments)})", expression)

    def named(self, value: Expr, *names: Symbol) -> Expr:
        """The value factored over the names."""
        return in_names(value, names, self.meaning)
