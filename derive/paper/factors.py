"""One factor of a row: a symbol, number, bracket, fraction or root, with what is written on it."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Any

from lark import Token, Tree

from . import tree as t
from .conventions import Declared
from .errors import ReadError
from .scripts import Scripts, read_scripts
from .spelling import is_label, spelling

if TYPE_CHECKING:
    from .resolve import Resolver

Syntax = Any  # Tree[Token] | Token


@dataclass(frozen=True)
class Factor:
    """What stands there before the row is resolved.

    declared: the symbol, if it is one; core: the node without scripts, unless it is a bracket of several parts;
    arguments: the parts of a bracket.
    """

    span: t.Span
    declared: Declared | None = None
    core: t.Node | None = None
    arguments: tuple[t.Node, ...] | None = None
    scripts: Scripts = field(default_factory=Scripts)

    def node(self, resolver: Resolver) -> t.Node:
        """The factor by itself; ReadError for primes on a constant, a list, a power of a vector but 2."""
        if self.core is None:
            raise resolver.error(self.span[0], "a list in brackets is only read as arguments")
        node = self.core
        if self.declared is not None and self.declared.kind in ("function", "order"):
            raise resolver.error(self.span[1], f"the function {self.declared.latex} needs an argument in brackets")
        if self.scripts.primes:
            if self.declared is not None and not self.declared.callable:
                raise resolver.error(self.span[0], f"{self.declared.latex} is a constant; it has no derivative")
            if isinstance(node, t.Number) or node.type in (t.REGION, t.LIST):
                raise resolver.error(self.span[0], f"a {type(node).__name__.lower()} has no derivative")
            node = t.Primed(node, self.scripts.primes, span=self.span)
        return self.scripts.around(node, self.span, resolver)

    def call(self, resolver: Resolver, bracket: Factor) -> t.Node:
        """This symbol applied to a bracket; the power may stand on either."""
        declared = self.declared
        assert declared is not None
        span = (self.span[0], bracket.span[1])
        for argument in bracket.arguments or ():
            if argument.type != t.SCALAR and not declared.argument:
                raise resolver.error(argument.span[0], f"the argument of {declared.latex} must be a scalar")
        if bracket.scripts.primes or self.scripts.bounded or (self.scripts.raised and bracket.scripts.raised):
            message = "primes, values or a second power between a symbol and its argument or after it; write brackets"
            raise resolver.error(bracket.span[0], message)
        if declared.kind == "order":
            if not self.scripts.plain:
                raise resolver.error(self.span[0], f"nothing is written on {declared.latex} but its argument")
            return bracket.scripts.around(t.BigO((bracket.arguments or ())[0], span=span), span, resolver)
        power, primes = self.scripts.power, self.scripts.primes
        if power is not None and declared.kind == "function" and isinstance(power, t.Signed):
            raise resolver.error(power.span[0], "inverse function or reciprocal? write which")
        node = t.Call(declared.name, bracket.arguments or (), primes, declared.type, declared.index, span=span)
        scripts = bracket.scripts
        if self.scripts.raised:
            scripts = replace(scripts, power=power, transposed=self.scripts.transposed)
        return scripts.around(node, span, resolver)

    def as_argument(self, resolver: Resolver) -> Factor:
        """This factor as the argument of a function written without brackets."""
        return Factor(self.span, arguments=(self.node(resolver),))


def read_factor(tree: Syntax, resolver: Resolver) -> Factor:
    """The factor of a syntax tree; ReadError if a symbol is undeclared or its scripts are out of order."""
    base, *written = tree.children
    span = (tree.meta.start_pos, tree.meta.end_pos)
    if isinstance(base, Token | Tree) and _is_symbol(base):
        return _symbol(tree, resolver)
    first: Any = base.children[0] if isinstance(base, Tree) else None
    square = isinstance(base, Tree) and base.data == "group" and first.type == "LBRACKET"
    scripts = read_scripts(written, square, resolver)
    if isinstance(base, Token):
        if base.type != "NUMBER":
            raise resolver.error(span[0], f"'{base}' stands here without what belongs to it")
        if scripts.named:
            raise resolver.error(span[0], "a number has no index")
        return Factor(span, None, t.Number(int(base), span=_token_span(base)), None, scripts)
    if scripts.named:
        raise resolver.error(span[0], "an index on a bracket or fraction is not read")
    core, arguments = _compound(base, resolver)
    return Factor(span, None, core, arguments, scripts)


def _is_symbol(base: Syntax) -> bool:
    return base.type in ("LETTER", "COMMAND") if isinstance(base, Token) else base.data in ("accent", "braces")


def _symbol(tree: Syntax, resolver: Resolver) -> Factor:
    span = (tree.meta.start_pos, tree.meta.end_pos)
    base, *written = tree.children
    spelled = spelling(tree, resolver.error)
    whole = _whole(tree, resolver)
    declared = whole or resolver.scope.by_spelling.get(spelled)
    if declared is None:
        known = f"not declared in scope '{resolver.scope.name}'"
        raise resolver.error(span[0], f"'{spelled}' is {known}; declare it in conventions.toml or mend the spelling")
    kept = [script for script in written if whole is None or script.data not in ("subscript", "superscript")]
    core = t.Name(declared.name, declared.type, declared.index, span=(span[0], _name_end(base, written, whole)))
    return Factor(span, declared, core, None, read_scripts(kept, False, resolver))


def _whole(tree: Syntax, resolver: Resolver) -> Declared | None:
    """The symbol, if all superscripts belong to its name."""
    try:
        return resolver.scope.by_spelling.get(spelling(tree, resolver.error, powers=True))
    except ReadError:  # an exponent that cannot be part of a name
        return None


def _name_end(base: Syntax, written: list[Syntax], whole: Declared | None) -> int:
    """Where a symbol ends and its primes and power begin."""
    ends = [
        script.meta.end_pos for script in written
        if script.data == "subscript"
        or (script.data == "superscript" and (whole is not None or is_label(script.children[0])))
    ]  # fmt: skip
    return max([*ends, base.end_pos if isinstance(base, Token) else base.meta.end_pos])


def _compound(base: Tree[Token], resolver: Resolver) -> tuple[t.Node | None, tuple[t.Node, ...] | None]:
    """A fraction, a root, bars, a stack, cases, or a bracket with its parts."""
    span = (base.meta.start_pos, base.meta.end_pos)
    children: list[Any] = base.children
    if base.data == "fraction":
        return resolver.fraction(base, span), None
    if base.data == "root":
        return _root(base, resolver, span), None
    if base.data == "norm":
        return resolver.norm(resolver.sum(children[1]), span), None
    if base.data in ("stack", "cases"):
        return resolver.rows_of(base, span), None
    return _bracket(children, span, resolver)


def _bracket(children: list[Any], span: t.Span, resolver: Resolver) -> tuple[t.Node | None, tuple[t.Node, ...] | None]:
    """A bracket: of one part, an interval or two arguments, more arguments, or a set."""
    opening, parts, closing = children
    arguments = tuple(resolver.sum(part) for part in parts.children if isinstance(part, Tree))
    commas = all(part == "," for part in parts.children if isinstance(part, Token))
    if opening.type == "LSET":
        if not commas or len({argument.type for argument in arguments}) > 1:
            raise resolver.error(span[0], "a list holds quantities of one type between commas")
        return t.Listing(arguments, span=span), None
    if len(arguments) == 1:
        if "[" in closing or "]" in opening:
            raise resolver.error(span[0], "an interval has two ends")
        return replace(arguments[0], span=span), arguments
    if len(arguments) == 2 and commas and all(argument.type == t.SCALAR for argument in arguments):
        left, right = opening[-1] in "(]", closing[-1] in ")["
        return t.Interval(*arguments, left, right, span=span), arguments
    return None, arguments


def _root(base: Any, resolver: Resolver, span: t.Span) -> t.Node:
    degree = resolver.sum(base.children[2]) if len(base.children) > 2 else t.Number(2)
    of = resolver.argument(base.children[-1])
    if not isinstance(degree, t.Number) or of.type != t.SCALAR or degree.value < 2:
        raise resolver.error(span[0], "a root needs a scalar, and a number of 2 or more as its degree")
    return t.Root(of, degree.value, span=span)


def _token_span(token: Token) -> t.Span:
    return token.start_pos or 0, token.end_pos or 0
