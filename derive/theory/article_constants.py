"""The article's constants as they are evaluated: the sense of the field, γ or γ̄, f̂ and its roots, b, c, g₂, g₃."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field

from sympy import Expr, Integer, Symbol, diff, sqrt

from .claims import Domain, Equal, Formula, Notebook
from .load_case import COSINES, LoadCase
from .symbols import beta, eta, gamma, gamma_bar, xi
from .weierstrass import Weierstrass

constant = Symbol("constant", real=True)  # γ, or γ̄ in an orthogonal field
c = Symbol("c", real=True)  # ℘(v)


@dataclass
class Collector:
    """The formulas of one load case, with γ or γ̄ under one name."""

    case: LoadCase
    book: Notebook
    found: list[Formula] = field(default_factory=list)

    def add(
        self,
        name: str,
        arguments: tuple[Symbol, ...],
        value: Expr,
        doc: str,
        relation: Equal,
        domain: Domain,
        *,
        steps: Iterable[str],
        source: str,
        given: Iterable[tuple[Expr, Expr]] = (),
    ) -> None:
        """Record a formula and claim the relation that says what it is.

        Parameters that the case lacks are no arguments; others that it has come last. steps: ids of claims, or their
        keys ``section.key`` in this load case.
        """
        kept = tuple(a for a in arguments if a not in (beta, eta) or a in self.case.parameters)
        value = value.subs(self.case.constant, constant) if constant in arguments else value
        others = sorted(value.free_symbols & set(self.case.parameters) - set(kept), key=lambda p: p.name)
        strange = value.free_symbols - {*kept, *others}
        if strange:
            raise ValueError(f"{self.case.name}: the formula {name} holds {strange}, which are not among its arguments")
        label, rests = self.case.source(source), [s if s in self.book.claims else self.case.ids(s)[0] for s in steps]
        (key,) = self.case.ids(f"article.{name}")
        self.book.claim(key, doc, relation, domain=domain, given=given, steps=rests, source=label)
        formula = Formula(f"article_{name}", (*kept, *others), value, key, doc, self.case.name, label, "article")
        self.found.append(formula)


def write_constants(collector: Collector) -> None:
    """The sense of the field, γ or γ̄, f̂ and its roots."""
    case, add = collector.case, collector.add
    rod, where = (beta, eta, constant), case.domain(gamma=(0, 1), xi=COSINES)
    # H = (sense)|H|: which of the article's cases are possible.
    sense = Equal(case.stiffness, case.bends * sqrt(case.stiffness**2))
    title = "the sense of the field: 1 if it bends the rod, −1 if it straightens it, 0 without a field"
    add("sense", (), Integer(case.bends), title, sense, where, steps=("quartic.levels",), source="quartic")
    # γ̄ = η − γ, else γ: f̂ with it is γ − 2βξ + 2ψ.
    meant = case.field_work.subs(xi, 0) - gamma if case.constant == gamma_bar else gamma
    levels = Equal(case.f_hat.subs(case.constant, meant), gamma - 2 * case.tip_force * xi - case.field_work)
    title = f"the constant of f̂: {'γ̄ = η − γ' if case.constant == gamma_bar else 'γ'}"
    add("constant", (eta, gamma), meant, title, levels, where, steps=("quartic.gamma",), source="first integral")
    where = case.domain(xi=COSINES, **{case.constant.name: case.ends})
    square = Equal(case.f_hat, case.gamma - 2 * case.tip_force * xi - case.field_work)
    title = "f̂(ξ), the square of the curvature"
    add("levels", (*rod, xi), case.f_hat, title, square, where, steps=("quartic.gamma",), source="quartic")
    for letter, root in zip(case.letters, case.roots, strict=True):
        zero, title = Equal(case.f_hat.subs(xi, root), 0), f"ξ_{letter}, a root of f̂"
        add(f"root_{letter}", rod, root, title, zero, where, steps=(f"quartic.root_{letter}",), source="roots")


def write_invariants(collector: Collector, functions: Weierstrass) -> None:
    """b and c at a = 1, g₂ and g₃ in the article's grouping."""
    case, add = collector.case, collector.add
    rod, where = (beta, eta, constant), case.domain(**{case.constant.name: (0, 1)})
    if functions.linear is None:
        at, rests = functions.at_one, ("weierstrass.constants",)
        height, slope = (diff(case.f_hat, xi, n).subs(xi, 1) for n in (0, 1))
        add("b", rod, at.b, "b = f′(a)/4 at a = 1", Equal(at.b, -height / 2), where, steps=rests, source="at one")
        third = Equal(at.c, -(height + 2 * slope) / 12)
        add("c", rod, at.c, "c = f″(a)/24 = ℘(v) at a = 1", third, where, steps=rests, source="at one")
    # exsl21: with D = B² + ΓH and m = (Γ + H)/6, g₂ = D + 3m² and g₃ = −m(D − m²).
    level = case.f_hat.subs(xi, 0)
    spread, mean = case.force**2 + level * case.stiffness, (level + case.stiffness) / 6
    pairs = (spread + 3 * mean**2, functions.g2), (-mean * (spread - mean**2), functions.g3)
    for name, letter, (printed, derived) in zip(("g2", "g3"), "₂₃", pairs, strict=True):
        same, title = Equal(printed, derived), f"the invariant g{letter} of ℘"
        add(name, rod, printed, title, same, where, steps=("weierstrass.at_one",), source="invariants")
