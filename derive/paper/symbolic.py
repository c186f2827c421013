"""Typed trees → SymPy, in the article's own symbols or in another meaning.

A *meaning* says what names, applied functions, primes, vectors and signs stand for. ``Printed`` takes them as they
are printed; ``check`` gives them the theory's expressions.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import reduce
from operator import add, mul
from typing import Any, Protocol

from sympy import Add, Expr, Function, Integer, Mul, Rational, Symbol, cos, root

from . import tree as t
from .conventions import scope as conventions_of

MAX_EXPONENT = 100  # numbers in exponents; the article needs 4
MAX_BITS = 4000  # of a number that a power would form


class SizeError(ValueError):
    """A printed power that would take forever to form."""


class Dot(Function):
    """Scalar product of two vectors, as a name; symmetric."""

    nargs = 2

    @classmethod
    def eval(cls, left: Any, right: Any) -> Expr | None:
        """Order the operands."""
        return cls(right, left) if left.sort_key() > right.sort_key() else None


class Cross(Function):
    """Vector product of two vectors, as a name."""

    nargs = 2


class Rate(Function):
    """Rate(x, n): the n-th derivative of a printed quantity with respect to arc length."""

    nargs = 2


class Ratio(Function):
    """Ratio(x, y): the printed derivative dx/dy."""

    nargs = 2


class Meaning(Protocol):
    """What the parts of a printed formula stand for."""

    def name(self, name: str) -> Any:
        """A symbol."""

    def call(self, name: str, primes: int, args: Sequence[Any]) -> Any:
        """A function at its arguments."""

    def rate(self, of: Any, order: int) -> Any:
        """Primes."""

    def ratio(self, of: t.Node, by: t.Node) -> Any:
        """The fraction d of / d by."""

    def dot(self, left: Any, right: Any) -> Any:
        """Scalar product."""

    def cross(self, left: Any, right: Any) -> Any:
        """Vector product."""

    def sign(self, sign: str) -> Any:
        """The value of ± (``\\pm``) or ∓ (``\\mp``)."""


class Printed:
    """The article's symbols as they are printed: plain symbols and undefined functions of normalised names."""

    def __init__(self, scope: str) -> None:
        self.scope = conventions_of(scope)

    def name(self, name: str) -> Any:
        """A symbol with the declared assumptions."""
        return Symbol(name, **dict.fromkeys(self.scope.by_name[name].assume, True))

    def call(self, name: str, primes: int, args: Sequence[Any]) -> Any:
        """cos is SymPy's; others are undefined functions, primes in their names (``f_prime``, ``f_prime2``)."""
        if name == "cos" and not primes:
            return cos(*args)
        suffix = "" if not primes else "_prime" + (str(primes) if primes > 1 else "")
        return Function(name + suffix)(*args)

    def rate(self, of: Any, order: int) -> Any:
        """A name for the derivative."""
        return Rate(of, order)

    def ratio(self, of: t.Node, by: t.Node) -> Any:
        """A name for the derivative."""
        return Ratio(to_sympy(of, self), to_sympy(by, self))

    def dot(self, left: Any, right: Any) -> Any:
        """A name for the product."""
        return Dot(left, right)

    def cross(self, left: Any, right: Any) -> Any:
        """A name for the product."""
        return Cross(left, right)

    def sign(self, sign: str) -> Any:
        """± is the symbol ``pm`` of square one, ∓ its negative."""
        return Symbol("pm", real=True) * (1 if sign == r"\pm" else -1)


def to_sympy(node: t.Node, meaning: Meaning | str) -> Any:
    """The value of a tree in a meaning; a scope's name stands for its printed symbols."""
    if isinstance(meaning, str):
        meaning = Printed(meaning)
    match node:
        case t.Number():
            return Integer(node.value)
        case t.Name():
            return meaning.name(node.name)
        case t.Call():
            return meaning.call(node.name, node.primes, [to_sympy(arg, meaning) for arg in node.args])
        case t.Primed():
            return meaning.rate(to_sympy(node.of, meaning), node.order)
        case t.Derivative():
            return meaning.ratio(node.of, node.by)
        case t.Signed(sign="-"):
            return -to_sympy(node.of, meaning)
        case t.Signed(sign="+"):
            return to_sympy(node.of, meaning)
        case t.Signed():
            return meaning.sign(node.sign) * to_sympy(node.of, meaning)
        case t.Power() if node.base.type == t.VECTOR:
            value = to_sympy(node.base, meaning)
            return meaning.dot(value, value)
    return _combined(node, [to_sympy(part, meaning) for part in node.parts()], meaning)


def _combined(node: t.Node, parts: list[Any], meaning: Meaning) -> Any:
    value = parts[0]
    match node:
        case t.Sum():
            return Add(*parts) if node.type == t.SCALAR else reduce(add, parts)
        case t.Product():
            return Mul(*parts) if node.type == t.SCALAR else reduce(mul, parts)
        case t.Quotient():
            return value * parts[1] ** -1
        case t.Power():
            return _power(value, parts[1])
        case t.Root():
            return root(value, node.degree)
        case t.Dot():
            return meaning.dot(*parts)
        case t.Cross():
            return meaning.cross(*parts)
    raise TypeError(f"a tree has no {type(node).__name__}")


def _power(base: Any, exponent: Any) -> Any:
    """base**exponent; SizeError for powers that only a hostile formula prints."""
    powers = [abs(number) for number in exponent.atoms(Rational)]
    if any(number > MAX_EXPONENT for number in powers):
        raise SizeError(f"an exponent beyond {MAX_EXPONENT}")
    bits = max((number.p.bit_length() + number.q.bit_length() for number in base.atoms(Rational)), default=0)
    if bits * max(powers, default=0) > MAX_BITS:
        raise SizeError(f"a power with numbers of more than {MAX_BITS} bits")
    return base**exponent
