"""What stands side by side in a row: symbols take the arguments that fit, prefixes take what follows them.

A symbol is applied to the bracket after it only if it is declared to take arguments and the bracket's sorts fit; what
may be an argument as well as a factor is a ReadError. Integrals and limits take the rest of their row.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from lark import Token, Tree

from . import differentials as d
from . import tree as t
from .conventions import Declared
from .factors import Factor, read_factor

if TYPE_CHECKING:
    from .resolve import Resolver

Syntax = Any  # Tree[Token] | Token
Elements = list[Any]  # t.Node | Token


def read_elements(items: Sequence[Syntax], resolver: Resolver) -> Elements:
    """The nodes of a row and the operators between them."""
    row = _Row(items, resolver)
    found: Elements = []
    while row.rest:
        found.append(row.rest.pop(0) if isinstance(row.rest[0], Token) else row.element())
    return found


class _Row:
    """A row that is being read; ``rest`` is what is left of it."""

    def __init__(self, items: Sequence[Syntax], resolver: Resolver) -> None:
        self.rest, self.resolver = list(items), resolver
        self._read: dict[int, Factor] = {}  # by item, so that nothing is read twice

    def element(self) -> t.Node:
        """The next node."""
        item = self.rest[0]
        base = item.children[0]
        kind = base.type if isinstance(base, Token) else ""
        if kind in ("INT", "LIM"):
            rest, self.rest = self.rest, []
            return (d.integral if kind == "INT" else d.limit)(rest, self.resolver)
        del self.rest[0]
        if kind in ("MAX", "VARIED") and (not self.rest or isinstance(self.rest[0], Token)):
            raise self.resolver.error(item.meta.end_pos, f"'{base}' stands before what it is said of")
        if kind == "MAX":
            return d.maximum(item, self.rest.pop(0), self.resolver)
        if kind == "VARIED":
            return self._varied(item)
        head = self._factor(item)
        if head.declared is not None and head.declared.callable:
            return self._called(head, head.declared)
        node = head.node(self.resolver)
        return self._evaluated(node) if isinstance(node, t.Derivative) else node

    def _factor(self, item: Syntax) -> Factor:
        if id(item) not in self._read:
            self._read[id(item)] = read_factor(item, self.resolver)
        return self._read[id(item)]

    def _bracket(self) -> Factor | None:
        """The bracket that comes next in the row, if one does."""
        item = self.rest[0] if self.rest else None
        if not isinstance(item, Tree) or not isinstance(item.children[0], Tree) or item.children[0].data != "group":
            return None
        bracket = self._factor(item)
        return bracket if bracket.arguments is not None and bracket.scripts.upto is None else None

    def _varied(self, sign: Syntax) -> t.Node:
        if len(sign.children) > 1:
            raise self.resolver.error(sign.meta.start_pos, "δ carries no scripts; write brackets")
        of = self.element()
        if of.type not in (t.SCALAR, t.VECTOR, t.TENSOR):
            raise self.resolver.error(of.span[0], f"a {of.type} does not vary")
        return t.Varied(of, span=(sign.meta.start_pos, of.span[1]))

    def _called(self, head: Factor, declared: Declared) -> t.Node:
        bracket = self._bracket()
        if bracket is not None and self._fits(declared, bracket):
            del self.rest[0]
            return head.call(self.resolver, bracket)
        if declared.kind not in ("function", "order"):
            return head.node(self.resolver)
        if not declared.prefix or not self.rest or isinstance(self.rest[0], Token):
            raise self.resolver.error(head.span[1], f"the function {declared.latex} needs an argument in brackets")
        bare = self._factor(self.rest.pop(0))
        if bare.declared is not None and bare.declared.kind == "function":
            raise self.resolver.error(bare.span[0], f"write brackets around the argument of {declared.latex}")
        if self.rest and not isinstance(self.rest[0], Token):
            after = self._factor(self.rest[0])
            if after.declared is None or after.declared.kind != "function":
                message = f"where does the argument of {declared.latex} end? write brackets"
                raise self.resolver.error(after.span[0], message)
        return head.call(self.resolver, bare.as_argument(self.resolver))

    def _evaluated(self, node: t.Derivative) -> t.Node:
        """A derivative at a place: a bracket after it whose sort is that of its variable."""
        bracket = self._bracket()
        by = self.resolver.scope.declared(node.by.name, node.by.index) if isinstance(node.by, t.Name) else None
        if bracket is None or by is None or not by.sort or not self._sorted((by.sort,), "the derivative", bracket):
            return node
        del self.rest[0]
        assert bracket.arguments is not None
        if not bracket.scripts.plain:
            raise self.resolver.error(bracket.span[0], "scripts after a derivative's argument; write brackets")
        return t.At(node, bracket.arguments[0], span=(node.span[0], bracket.span[1]))

    def _fits(self, declared: Declared, bracket: Factor) -> bool:
        """Is the bracket an argument of the symbol? ReadError if it may be one as well as a factor."""
        arguments = bracket.arguments or ()
        if declared.kind in ("function", "order"):
            if len(arguments) not in declared.arity:
                allowed = " or ".join(map(str, declared.arity))
                message = f"{declared.latex} takes {allowed} arguments, not {len(arguments)}"
                raise self.resolver.error(bracket.span[0], message)
            return True
        return self._sorted((declared.argument, *declared.alternatives), declared.latex, bracket)

    def _sorted(self, allowed: tuple[str, ...], who: str, bracket: Factor) -> bool:
        """Do the arguments have one of the allowed rows of sorts? 0 is of any sort."""
        arguments = bracket.arguments or ()
        sorts = [_sorts(argument, self.resolver) for argument in arguments]
        for wanted in (choice.split() for choice in allowed):
            if len(wanted) == len(sorts) and all(map(self._of_sort, wanted, sorts, arguments)):
                return True
        every = {word for choice in allowed for word in choice.split()}
        if len(arguments) == 1 and arguments[0].type == t.SCALAR and (not sorts[0] or sorts[0] & every):
            message = f"is this bracket the argument of {who} or a factor? write the product in brackets"
            raise self.resolver.error(bracket.span[0], message)
        return False

    def _of_sort(self, want: str, found: set[str], argument: t.Node) -> bool:
        zero = argument == t.Number(0)
        return zero or (found == {want} and argument.type == self.resolver.scope.types[want])


def _sorts(node: t.Node, resolver: Resolver) -> set[str]:
    """The sorts of the symbols in a bracket; of an applied symbol its own."""
    if isinstance(node, t.Name | t.Call):
        return {resolver.scope.declared(node.name, node.index).sort}
    return {sort for part in node.parts() for sort in _sorts(part, resolver)}
