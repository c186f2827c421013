"""The record of a load case: (ξ′)² = f(ξ) = f̂(ξ)(1 − ξ²), with f̂ = Γ − 2Bξ − Hξ² and Γ = γ or −γ̄ up to a constant."""

from __future__ import annotations

from dataclasses import dataclass

from sympy import Expr, Integer, Symbol, cancel, diff, oo

from .claims import Domain
from .sources import source
from .symbols import gamma, gamma_bar, theta, xi

xi_tip = Symbol("xi_tip", real=True)  # ξ(ℓ) = cos θ(ℓ)
COSINES = (Integer(-1), Integer(1))  # between them ξ lies
FREE = (gamma, gamma_bar, theta, xi_tip, xi)  # what ranges may be given for, in this order


class NotElliptic(ValueError):  # noqa: N818 - a verdict on the energy
    """The energy does not lead to (ξ′)² = f(ξ) with f a polynomial of at most fourth degree."""


@dataclass(frozen=True)
class LoadCase:
    """One load case.

    name: ``parallel``, ``orthogonal``, ``field_only`` or ``force_only``. parameters: β, η as far as they occur.
    angular_acceleration: θ″ in θ. field_work: −2ψ as a polynomial in ξ. tip_force: β, or 0. constant: γ or γ̄, and
    gamma: γ in it. f, f_hat: polynomials in ξ (exsl12). force, stiffness: B and H of f̂. roots: those of f̂, ascending.
    tip_constant: the constant in ξ(ℓ) (exsl23). other_root: the root of f̂ that is not ξ(ℓ), if there are two. ends: of
    the range of the constant.
    """

    name: str
    parameters: tuple[Symbol, ...]
    angular_acceleration: Expr
    field_work: Expr
    tip_force: Expr
    constant: Symbol
    gamma: Expr
    f: Expr
    f_hat: Expr
    force: Expr
    stiffness: Expr
    roots: tuple[Expr, ...]
    tip_constant: Expr
    other_root: Expr | None
    ends: tuple[Expr, Expr]

    @property
    def bends(self) -> int:
        """The sign of the stiffness H: 1 where the field bends the rod towards it, −1 where it straightens it."""
        return sign_of(self.stiffness)

    @property
    def letters(self) -> str:
        """The article's letters of the roots of f̂, ascending."""
        return "ab" if self.bends else "2"

    @property
    def sense(self) -> int:
        """1 if the range of the constant runs from the double root of f̂ to a straight rod, −1 if it runs back."""
        return (self.bends or 1) * int(diff(self.f_hat, self.constant))

    @property
    def vertex(self) -> Expr:
        """−B/H, where f̂ has its extremum."""
        return -self.force / self.stiffness

    @property
    def at_tip(self) -> Expr:
        """f̂ with the constant that makes ξ(ℓ) its root."""
        return self.f_hat.subs(self.constant, self.tip_constant)

    def source(self, what: str) -> str:
        """The article's equation, by what it says (a key of ``SOURCES``)."""
        return source(self.name, what)

    def ids(self, *keys: str) -> tuple[str, ...]:
        """Ids of claims about this load case: ``quartic.levels`` is ``quartic.<name>.levels``."""
        return tuple(key.replace(".", f".{self.name}.", 1) for key in keys)

    def domain(self, **ranges: tuple[Expr, Expr]) -> Domain:
        """Positive parameters; further ranges by the name of the symbol, after them."""
        positive = dict.fromkeys(self.parameters, (0, oo))
        return Domain({**positive, **{symbol: ranges[symbol.name] for symbol in FREE if symbol.name in ranges}})

    def steep(self, **ranges: tuple[Expr, Expr]) -> Domain:
        """The same where the vertex −B/H is the cosine of an angle, |H| > B, as a range of a field parameter."""
        domain = self.domain(**ranges)
        fields = [p for p in self.parameters if self.stiffness.has(p)]
        if not fields or self.force == 0:
            return domain
        least = linear_root(self.bends * self.stiffness - self.force, fields[0])
        first = {p: (0, oo) for p in self.parameters if p != fields[0]}
        return Domain({**first, fields[0]: (least, oo), **{s: r for s, r in domain.ranges.items() if s in FREE}})


def sign_of(stiffness: Expr) -> int:
    """The sign of a stiffness, an expression in positive parameters that is of one sign."""
    if stiffness == 0:
        return 0
    return 1 if stiffness.is_nonnegative else -1


def linear_root(expression: Expr, symbol: Symbol) -> Expr:
    """The zero of an expression that is linear in the symbol."""
    return cancel(-expression.subs(symbol, 0) / diff(expression, symbol))
