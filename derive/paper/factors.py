"""One factor of a row: a symbol, number, bracket, fraction or root, with its primes and its power."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

from lark import Token, Tree

from . import tree as t
from .conventions import Declared
from .spelling import is_label, spelling

if TYPE_CHECKING:
    from .resolve import Resolver

Syntax = Any  # Tree[Token] | Token


@dataclass(frozen=True)
class Factor:
    """What stands there before the row is resolved.

    declared: the symbol, if it is one; core: the node without primes and power, unless it is a bracket of several
    parts; arguments: the parts of a bracket; primes; power.
    """

    span: t.Span
    declared: Declared | None = None
    core: t.Node | None = None
    arguments: tuple[t.Node, ...] | None = None
    primes: int = 0
    power: t.Node | None = None

    def node(self, resolver: Resolver) -> t.Node:
        """The factor by itself; ReadError for primes on a constant, a list, a power of a vector but 2."""
        if self.core is None:
            raise resolver.error(self.span[0], "a list in brackets is only read as arguments")
        node = self.core
        if self.primes:
            if self.declared is not None and not self.declared.callable:
                raise resolver.error(self.span[0], f"{self.declared.latex} is a constant; it has no derivative")
            if isinstance(node, t.Number):
                raise resolver.error(self.span[0], "a number has no derivative")
            node = t.Primed(node, self.primes, span=self.span)
        return self._raised(resolver, node)

    def call(self, resolver: Resolver, bracket: Factor) -> t.Node:
        """This symbol applied to a bracket; the power may stand on either."""
        assert self.declared is not None
        span = (self.span[0], bracket.span[1])
        for argument in bracket.arguments or ():
            if argument.type != t.SCALAR:
                raise resolver.error(argument.span[0], f"the argument of {self.declared.latex} must be a scalar")
        if bracket.primes or (self.power is not None and bracket.power is not None):
            raise resolver.error(bracket.span[0], "primes or a second power after the argument; write brackets")
        kind = t.VECTOR if self.declared.kind == "vector" else t.SCALAR
        node = t.Call(self.declared.name, bracket.arguments or (), self.primes, kind, span=span)
        if self.power is not None and self.declared.kind == "function" and isinstance(self.power, t.Signed):
            raise resolver.error(self.power.span[0], "inverse function or reciprocal? write which")
        return replace(self, span=span, power=self.power or bracket.power)._raised(resolver, node)

    def as_argument(self, resolver: Resolver) -> Factor:
        """This factor as the argument of a function written without brackets."""
        return Factor(self.span, arguments=(self.node(resolver),))

    def _raised(self, resolver: Resolver, node: t.Node) -> t.Node:
        if self.power is None:
            return node
        if self.power.type != t.SCALAR or (node.type == t.VECTOR and self.power != t.Number(2)):
            raise resolver.error(self.power.span[0], "a vector has a square only, and no exponent is a vector")
        return t.Power(node, self.power, span=self.span)


def read_factor(tree: Syntax, resolver: Resolver) -> Factor:
    """The factor of a syntax tree; ReadError if a symbol is undeclared or its scripts are out of order."""
    base, *scripts = tree.children
    primes, power, subscripts = 0, None, False
    for script in scripts:
        at = script.meta.start_pos
        if script.data == "prime":
            primes += len(script.children)
        elif script.data == "subscript" or is_label(script.children[0]):
            subscripts = True
        elif power is not None:
            raise resolver.error(at, "two powers on one symbol; write brackets")
        else:
            power = _argument(script.children[0], resolver)
        if script.data == "prime" and power is not None:
            raise resolver.error(at, "a prime after a power; write brackets")
    span = (tree.meta.start_pos, tree.meta.end_pos)
    if isinstance(base, Tree) and base.data not in ("accent", "braces"):
        if subscripts:
            raise resolver.error(span[0], "an index on a bracket or fraction is not read")
        core, arguments = _compound(base, resolver)
        return Factor(span, None, core, arguments, primes, power)
    if isinstance(base, Token) and base.type == "NUMBER":
        if subscripts:
            raise resolver.error(span[0], "a number has no index")
        return Factor(span, None, t.Number(int(base), span=_token_span(base)), None, primes, power)
    return _symbol(tree, resolver, primes, power)


def _symbol(tree: Syntax, resolver: Resolver, primes: int, power: t.Node | None) -> Factor:
    span = (tree.meta.start_pos, tree.meta.end_pos)
    spelled = spelling(tree, resolver.error)
    declared = resolver.scope.by_spelling.get(spelled)
    if declared is None:
        known = f"not declared in scope '{resolver.scope.name}'"
        raise resolver.error(span[0], f"'{spelled}' is {known}; declare it in conventions.toml or mend the spelling")
    kind = t.VECTOR if declared.kind == "vector" else t.SCALAR
    return Factor(span, declared, t.Name(declared.name, kind, span=(span[0], _name_end(tree))), None, primes, power)


def _name_end(tree: Syntax) -> int:
    """Where a symbol ends and its primes and power begin."""
    base, *scripts = tree.children
    ends = [script.meta.end_pos for script in scripts if script.data == "subscript" or is_label(script.children[0])]
    return max([*ends, base.end_pos if isinstance(base, Token) else base.meta.end_pos])


def _compound(base: Tree[Token], resolver: Resolver) -> tuple[t.Node | None, tuple[t.Node, ...] | None]:
    """A fraction, a root, or a bracket with its parts."""
    span = (base.meta.start_pos, base.meta.end_pos)
    if base.data == "fraction":
        return _fraction(base, resolver, span), None
    if base.data == "root":
        return _root(base, resolver, span), None
    parts: Any = base.children[0]
    arguments = tuple(resolver.sum(part) for part in parts.children if isinstance(part, Tree))
    return (replace(arguments[0], span=span) if len(arguments) == 1 else None), arguments


def _fraction(base: Any, resolver: Resolver, span: t.Span) -> t.Node:
    above, below = base.children[1:]
    if _differential(above) and "d" not in resolver.scope.by_spelling:
        if not _differential(below):
            raise resolver.error(below.meta.start_pos, "d stands above but not below; a derivative needs both")
        of, by = (resolver.chain(_row(part)[1:]) for part in (above, below))
        if not isinstance(by, t.Name):
            raise resolver.error(by.span[0], "a derivative is taken with respect to a symbol")
        return t.Derivative(of, by, span=span)
    return replace(resolver.quotient(_argument(above, resolver), _argument(below, resolver)), span=span)


def _root(base: Any, resolver: Resolver, span: t.Span) -> t.Node:
    degree = _argument(base.children[1], resolver) if len(base.children) > 2 else t.Number(2)
    of = _argument(base.children[-1], resolver)
    if not isinstance(degree, t.Number) or of.type != t.SCALAR or degree.value < 2:
        raise resolver.error(span[0], "a root needs a scalar, and a number of 2 or more as its degree")
    return t.Root(of, degree.value, span=span)


def _row(argument: Any) -> list[Syntax]:
    """The factors of a braced argument that is one unsigned row, else nothing."""
    inner = argument.children[0]
    if isinstance(inner, Tree) and inner.data == "sum" and len(inner.children) == 1:
        return list(inner.children[0].children)
    return []


def _differential(argument: Any) -> bool:
    row = _row(argument)
    return len(row) > 1 and isinstance(row[0], Tree) and row[0].children == ["d"]


def _argument(tree: Any, resolver: Resolver) -> t.Node:
    """The argument of a script, a fraction or a root: one token, or a formula in braces."""
    if tree.data == "sum":
        return resolver.sum(tree)
    inner = tree.children[0]
    if isinstance(inner, Tree) and inner.data == "sum":
        return resolver.sum(inner)
    factor = Tree("factor", [inner], tree.meta)
    return read_factor(factor, resolver).node(resolver)


def _token_span(token: Token) -> t.Span:
    return token.start_pos or 0, token.end_pos or 0
