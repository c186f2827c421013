"""Typed trees → SymPy, in the article's own symbols or in another meaning.

A *meaning* says what names, applied functions, primes, vectors and signs stand for. ``Printed`` takes them as they
are printed; ``check`` gives them the theory's expressions.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import partial, reduce
from operator import add, mul
from typing import Any, Protocol

from sympy import Add, Expr, Function, Integer, Mul, Rational, Symbol, cos, root

from . import tree as t
from .conventions import scope as conventions_of

MAX_EXPONENT = 100  # numbers in exponents; the article needs 4
MAX_BITS = 4000  # of a number that a power would form


Indices = Mapping[str, int]  # the values of the index letters
NONE: Indices = {}


class SizeError(ValueError):
    """A printed power that would take forever to form."""


class SideError(ValueError):
    """A region, a list, a stack or cases where a quantity must stand."""


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
    """What the parts of a printed formula stand for.

    Values are SymPy expressions; of vectors 3 × 1, of tensors 3 × 3 matrices, or in ``Printed`` names for them. What a
    meaning needs as it is printed (what is integrated, by what) it gets as trees, with the values of the indices in
    them; ``to_sympy(tree, meaning, indices)`` gives their values.
    """

    def name(self, name: str) -> Any:
        """A symbol; a member of a family by its number, ``d_3``."""

    def call(self, name: str, primes: int, args: Sequence[Any]) -> Any:
        """A function at its arguments."""

    def rate(self, of: Any, order: int) -> Any:
        """Primes."""

    def ratio(self, node: t.Derivative, indices: Indices) -> Any:
        """The fraction d of / d by, or with ∂."""

    def dot(self, left: Any, right: Any) -> Any:
        """Scalar product."""

    def cross(self, left: Any, right: Any) -> Any:
        """Vector product."""

    def outer(self, left: Any, right: Any) -> Any:
        """Tensor product."""

    def apply(self, tensor: Any, other: Any) -> Any:
        """A tensor applied to a vector, or composed with a tensor."""

    def transpose(self, of: Any) -> Any:
        """Of a tensor."""

    def inverse(self, of: Any) -> Any:
        """Of a tensor."""

    def norm(self, of: Any) -> Any:
        """|of|."""

    def sign(self, sign: str) -> Any:
        """The value of ± (``\\pm``) or ∓ (``\\mp``)."""

    def varied(self, node: t.Varied, indices: Indices) -> Any:
        """δ of."""

    def order(self, node: t.BigO, indices: Indices) -> Any:
        """O(of): some quantity of that order, as general as can be."""

    def integral(self, node: t.Integral, indices: Indices) -> Any:
        """An integral."""

    def between(self, node: t.Between, indices: Indices) -> Any:
        """[of] from lower to upper."""

    def at(self, node: t.At, indices: Indices) -> Any:
        """of where variable = value."""

    def limit(self, node: t.Limit, indices: Indices) -> Any:
        """lim of."""

    def maximum(self, node: t.Maximum, indices: Indices) -> Any:
        """The greatest of some quantities."""


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

    def ratio(self, node: t.Derivative, indices: Indices) -> Any:
        """A name for the derivative."""
        return Ratio(to_sympy(node.of, self, indices), to_sympy(node.by, self, indices))

    def dot(self, left: Any, right: Any) -> Any:
        """A name for the product."""
        return Dot(left, right)

    def cross(self, left: Any, right: Any) -> Any:
        """A name for the product."""
        return Cross(left, right)

    def sign(self, sign: str) -> Any:
        """± is the symbol ``pm`` of square one, ∓ its negative."""
        return Symbol("pm", real=True) * (1 if sign == r"\pm" else -1)

    def __getattr__(self, name: str) -> Any:
        """Other operations are names, too: ``outer``, ``integral`` and so on become undefined functions."""
        if name not in _OPERATIONS:
            raise AttributeError(name)
        return partial(_named, self, name.capitalize())


_OPERATIONS = {
    "outer", "apply", "transpose", "inverse", "norm", "varied", "order", "integral", "between", "at", "limit",
    "maximum",
}  # fmt: skip


def _named(meaning: Printed, name: str, *operands: Any) -> Any:
    """An operation as an undefined function of the values of its operands."""
    if isinstance(operands[0], t.Node):
        node, indices = operands
        operands = tuple(to_sympy(part, meaning, indices) for part in node.parts())
    return Function(name)(*operands)


def to_sympy(node: t.Node, meaning: Meaning | str, indices: Indices = NONE) -> Any:
    """The value of a tree in a meaning; a scope's name stands for its printed symbols.

    indices: values of the index letters that are free in the tree.
    """
    if isinstance(meaning, str):
        meaning = Printed(meaning)
    match node:
        case t.Number():
            return Integer(node.value)
        case t.Name():
            return meaning.name(member(node.name, node.index, indices))
        case t.Call():
            arguments = [to_sympy(arg, meaning, indices) for arg in node.args]
            return meaning.call(member(node.name, node.index, indices), node.primes, arguments)
        case t.Primed():
            return meaning.rate(to_sympy(node.of, meaning, indices), node.order)
        case t.Signed(sign="-"):
            return -to_sympy(node.of, meaning, indices)
        case t.Signed(sign="+"):
            return to_sympy(node.of, meaning, indices)
        case t.Signed():
            return meaning.sign(node.sign) * to_sympy(node.of, meaning, indices)
        case t.Contraction():
            values = ({**indices, node.index: value} for value in t.values_of(node.index))
            return reduce(add, (to_sympy(node.of, meaning, value) for value in values))
        case t.Power() if node.base.type == t.VECTOR:
            value = to_sympy(node.base, meaning, indices)
            return meaning.dot(value, value)
    operation = _BY_TREE.get(type(node))
    if operation is not None:
        return getattr(meaning, operation)(node, indices)
    return _combined(node, [to_sympy(part, meaning, indices) for part in node.parts()], meaning)


def member(name: str, letter: str, indices: Indices) -> str:
    """The name of a member of a family: d and i = 3 give ``d_3``; a plain name stays."""
    return f"{name}_{indices[letter]}" if letter else name


_BY_TREE: dict[type[t.Node], str] = {
    t.Derivative: "ratio", t.Varied: "varied", t.BigO: "order", t.Integral: "integral", t.Between: "between",
    t.At: "at", t.Limit: "limit", t.Maximum: "maximum",
}  # fmt: skip
_BY_VALUE: dict[type[t.Node], str] = {
    t.Dot: "dot", t.Cross: "cross", t.Outer: "outer", t.Apply: "apply", t.Compose: "apply",
    t.Transpose: "transpose", t.Norm: "norm",
}  # fmt: skip


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
            return _power(value, parts[1]) if node.base.type == t.SCALAR else meaning.inverse(value)
        case t.Root():
            return root(value, node.degree)
    if type(node) in _BY_VALUE:
        return getattr(meaning, _BY_VALUE[type(node)])(*parts)
    raise SideError(f"a {type(node).__name__.lower()} stands only as a whole side of a statement")


def _power(base: Any, exponent: Any) -> Any:
    """base**exponent; SizeError for powers that only a hostile formula prints."""
    powers = [abs(number) for number in exponent.atoms(Rational)]
    if any(number > MAX_EXPONENT for number in powers):
        raise SizeError(f"an exponent beyond {MAX_EXPONENT}")
    bits = max((number.p.bit_length() + number.q.bit_length() for number in base.atoms(Rational)), default=0)
    if bits * max(powers, default=0) > MAX_BITS:
        raise SizeError(f"a power with numbers of more than {MAX_BITS} bits")
    return base**exponent
