"""What the article's symbols mean in the theory, section by section.

A *reading* is one way in which a printed formula must hold: a load case, a sense of bending, a root a. A formula
holds if it holds in all its readings; each is judged by itself. Three kinds:

- along the rod: ξ = cos θ, κ_x = θ′ = ±k, and the constant (γ or γ̄) is what the first integral makes it;
- elliptic: ξ and ϰ are the theory's functions of u, with u = u_o + s on the rod;
- at rest: ξ is any number in (−1, 1), the constant any number in its range, or what the free end makes it.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

from sympy import Abs, Expr, Matrix, MatrixBase, Symbol, cos, diff, sin, sqrt, zeros

from derive.paper import tree as t
from derive.paper.symbolic import NONE, Indices, to_sympy
from derive.theory import functions as fn
from derive.theory.claims import Domain
from derive.theory.symbols import theta, xi

k = Symbol("k", positive=True)  # geometric curvature, |θ′|
pm = Symbol("pm")  # ±: one of two signs
u = Symbol("u", real=True)
u_o = Symbol("u_o", real=True)
s, ell = Symbol("s", positive=True), Symbol("ell", positive=True)
varsigma = Symbol("varsigma", positive=True)  # the arc length of brackets; without one, some other point of the rod
ARCS = {s, ell, varsigma}
varkappa = Symbol("varkappa", real=True)  # ϰ while it is differentiated by
E_X, E_Y, E_Z = (Matrix([int(i == j) for i in range(3)]) for j in range(3))


class MeaningError(ValueError):
    """A printed symbol or relation to which this reading gives no meaning; the message says which."""


class Components:
    """A meaning in components: vectors are 3 × 1, tensors 3 × 3 matrices, both in one frame.

    What a section does not use has no meaning in it: MeaningError. title: in words. domain: where the formula must
    hold. hypotheses: substitutions that hold there, as in ``Claim.given``. small: the parameter of orders of magnitude.
    within: its power that is dropped, where the text drops one. constant: what tends to one of its ends, in limits.
    """

    title: str
    domain: Domain
    hypotheses: tuple[tuple[Expr, Expr], ...] = ()
    small: Symbol | None = None
    within: int | None = None
    constant: Symbol | None = None
    ends: tuple[Expr, Expr] | None = None

    def of(self, node: t.Node, indices: Indices = NONE) -> Any:
        """The value of a printed tree; MeaningError if it has none here."""
        return to_sympy(node, self, indices)

    def reads(self, left: t.Node, right: t.Node) -> bool:
        """Is a relation between these sides read here? A reading may be of laws only, or of identities only."""
        return True

    def spread(self, node: t.Node) -> tuple[Any, t.Node] | None:
        """A factor and a tree whose values make that of the node, for those that compute in numbers; None if none."""
        return None

    def absent(self, what: object) -> MeaningError:
        """The error for what has no meaning here."""
        return MeaningError(f"{what} has no meaning where the formula is read ({self.title})")

    def name(self, name: str) -> Any:
        """None here."""
        raise self.absent(f"'{name}'")

    def call(self, name: str, primes: int, args: Sequence[Any]) -> Any:
        """None here."""
        raise self.absent(f"'{name}' at an argument")

    def rate(self, of: Any, order: int) -> Any:
        """None here."""
        raise self.absent("a prime")

    def dot(self, left: Any, right: Any) -> Any:
        """In components."""
        return left.dot(right)

    def cross(self, left: Any, right: Any) -> Any:
        """In components."""
        return left.cross(right)

    def outer(self, left: Any, right: Any) -> Any:
        """In components."""
        return left * right.T

    def apply(self, tensor: Any, other: Any) -> Any:
        """In components."""
        return tensor * other

    def transpose(self, of: Any) -> Any:
        """In components."""
        return of.T

    def inverse(self, of: Any) -> Any:
        """In components."""
        return of.inv()

    def accumulates(self, *sides: Any) -> bool:
        """Does a side hold a quantity that grows along the rod, so that its rate and its start say it all?"""
        return False

    def at_clamp(self, value: Any) -> Any:
        """The value at the clamp; None if a constant is left open in it."""
        return value

    def frontier(self, value: Any, end: Any) -> Any:
        """What vanishes where the end is one of the range of a value."""
        raise self.absent("an interval")

    def sign_note(self, sign: str, title: str) -> str:
        """What is to be said of ± where only one sign will do."""
        return ""

    def condition(self, sides: Sequence[t.Node]) -> str:
        """Under what condition, that is not printed, a relation of these sides holds that is proved here."""
        return ""

    def norm(self, of: Any) -> Any:
        """The root of the square."""
        return sqrt(of.dot(of)) if isinstance(of, MatrixBase) else Abs(of)

    def sign(self, sign: str) -> Any:
        """± is one of two signs, ∓ the other."""
        return pm if sign == r"\pm" else -pm

    def _none(self, node: Any, indices: Indices) -> Any:
        raise self.absent(f"a {type(node).__name__.lower()}")

    ratio = varied = order = integral = between = at = limit = maximum = _none


@dataclass(frozen=True)
class Reading(Components):
    """One meaning of the printed symbols.

    title, domain, constant, ends: as in Components. values: of names. rates: derivatives along the rod of the symbols
    in the values. polynomials: f and f̂ in ξ. invariants: g₂, g₃. solution: ξ as a function of the value of
    ℘. at_tip: ξ(ℓ). The constant is γ or γ̄, if it is free, and the ends those of its range.
    """

    title: str
    values: Mapping[str, Any]
    domain: Domain
    rates: Mapping[Symbol, Expr] = field(default_factory=dict)
    polynomials: Mapping[str, Expr] = field(default_factory=dict)
    invariants: tuple[Expr, Expr] | None = None
    solution: Callable[[Expr], Expr] | None = None
    at_tip: Expr | None = None
    constant: Symbol | None = None
    ends: tuple[Expr, Expr] | None = None

    def name(self, name: str) -> Any:
        """A symbol."""
        if name not in self.values:
            raise MeaningError(f"'{name}' has no meaning where the formula is read ({self.title})")
        return self.values[name]

    def call(self, name: str, primes: int, args: Sequence[Any]) -> Any:
        """A function at its arguments."""
        if name in self.polynomials and len(args) == 1:
            return diff(self.polynomials[name], xi, primes).subs(xi, args[0])
        if name == "cos" and not primes:
            return cos(args[0])
        if name == "wp" and self.invariants is not None:
            variable = Symbol("t")
            point, *invariants = args
            value = diff(fn.wp(variable, *(invariants or self.invariants)), variable, primes)
            return value.subs(variable, point)
        if name in ("xi", "varkappa") and not primes:
            return self._on_rod(name, args[0])
        raise MeaningError(f"'{name}' at an argument has no meaning where the formula is read ({self.title})")

    def _on_rod(self, name: str, point: Expr) -> Expr:
        """ξ or ϰ at a point: an arc length s gives u = u_o + s, anything else is u itself."""
        if name == "xi" and point == self.values.get("ell") and self.at_tip is not None:
            return self.at_tip
        if self.solution is None or self.invariants is None:
            if name == "xi" and point == self.values.get("s"):
                return self.name("xi")
            if name == "xi" and point.free_symbols <= ARCS:
                return Symbol(f"xi_at_{point}", real=True)  # elsewhere on the rod
            raise MeaningError(f"'{name}' at {point} has no meaning where the formula is read ({self.title})")
        value = fn.wp(u_o + point if point.free_symbols <= ARCS else point, *self.invariants)
        return self.solution(value) if name == "xi" else value

    def rate(self, of: Any, order: int) -> Any:
        """The derivative along the rod, by the chain rule."""
        for _ in range(order):
            of = self._rate(of)
        return of

    def _rate(self, of: Any) -> Any:
        free = of.free_symbols
        unmoved = free & {theta, u, xi, Symbol("y"), Symbol("z")} - set(self.rates)
        if unmoved or not self.rates:
            raise MeaningError(f"the derivative of {of} has no meaning where the formula is read ({self.title})")
        start = zeros(*of.shape) if isinstance(of, MatrixBase) else 0 * k
        return sum((diff(of, q) * self.rates[q] for q in sorted(free & set(self.rates), key=str)), start=start)

    def ratio(self, node: t.Derivative, indices: Indices) -> Any:
        """The printed derivative d of / d by: by ϰ, by u, or along the rod."""
        of, by = node.of, node.by
        if not isinstance(by, t.Name) or not isinstance(of, t.Name):
            raise MeaningError("only derivatives of symbols by symbols have a meaning")
        if by.name == "varkappa" and of.name == "xi" and self.solution is not None:
            return diff(self.solution(varkappa), varkappa).subs(varkappa, self.name("varkappa"))
        if by.name == "s":
            return self.rate(self.name(of.name), 1)
        if by.name == "u" and of.name in ("xi", "varkappa") and self.solution is not None:
            here = self.name("u")
            return diff(self.name(of.name).subs(here, u), u).subs(u, here)
        raise MeaningError(f"d {of.name}/d {by.name} has no meaning where the formula is read ({self.title})")


def along_rod(bent: int, angle_of_field: Expr) -> dict[str, Any]:
    """The values of the moving names where the rod bends with κ_x = ±k; ``bent`` is the sign."""
    tangent = Matrix([0, cos(theta), sin(theta)])
    return {
        "xi": cos(theta), "theta": theta, "k": k, "kappa_x": bent * k, "binormal": bent * E_X, "d_3": tangent,
        "y": Symbol("y"), "z": Symbol("z"), "e": Matrix([0, cos(angle_of_field), sin(angle_of_field)]), **BASES,
    }  # fmt: skip


def rates_along_rod(bent: int, acceleration: Expr) -> dict[Symbol, Expr]:
    """Derivatives along the rod: θ′ = ±k, k′ = ±θ″, y′ = cos θ, z′ = sin θ."""
    return {theta: bent * k, k: bent * acceleration, Symbol("y"): cos(theta), Symbol("z"): sin(theta)}


BASES = {"e_x": E_X, "e_y": E_Y, "e_z": E_Z}
