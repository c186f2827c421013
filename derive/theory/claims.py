"""Records of the derivation: relations, claims, formulas, and the notebook in which the scripts write them.

A *claim* is a relation that the derivation asserts and that ``check`` must prove; nothing here proves anything.
A *formula* is a derived expression that the emitted solvers evaluate; it names the claim that stands for it.
A *notebook* keeps, in order, the prose, the expressions and the claims of a derivation, so that a script can be
read, printed and checked from one run.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from typing import Any

from sympy import Expr, Symbol, oo


@dataclass(frozen=True)
class Equal:
    """lhs = rhs; both scalars, or both matrices of one shape (compared entry by entry)."""

    lhs: Any
    rhs: Any


@dataclass(frozen=True)
class Positive:
    """expr > 0 everywhere in the domain."""

    expr: Expr


@dataclass(frozen=True)
class NonNegative:
    """expr ≥ 0 everywhere in the domain."""

    expr: Expr


@dataclass(frozen=True)
class Limit:
    """expr → value as variable → point, through the domain; side is '+', '-' or '+-' (both)."""

    expr: Expr
    variable: Symbol
    point: Expr
    value: Expr
    side: str = "+-"


@dataclass(frozen=True)
class Order:
    """expr = O(variable**power) as variable → 0; a matrix means every entry."""

    expr: Any
    variable: Symbol
    power: int


Relation = Equal | Positive | NonNegative | Limit | Order


@dataclass(frozen=True)
class Domain:
    """Where a claim is asserted.

    ranges: symbol → (lower, upper), an open interval whose ends may be expressions in symbols declared before it.
    conditions: expressions that are > 0 in the domain.
    """

    ranges: Mapping[Symbol, tuple[Any, Any]] = field(default_factory=dict)
    conditions: tuple[Expr, ...] = ()

    def with_range(self, symbol: Symbol, lower: Any = -oo, upper: Any = oo) -> Domain:
        """The same domain with one more (or another) range."""
        return Domain({**self.ranges, symbol: (lower, upper)}, self.conditions)


@dataclass(frozen=True)
class Claim:
    """A relation that the derivation asserts.

    id: ``section.name`` in lower case, unique. title: what it says, in plain words. relation: what it asserts.
    domain: where. given: substitutions (symbol or expression, replacement) that hold under the claim's hypotheses,
    applied in order before proving.
    steps: ids of the claims it rests on. source: equation of the article or of DLMF, where it has one.
    """

    id: str
    title: str
    relation: Relation
    domain: Domain = Domain()
    given: tuple[tuple[Expr, Expr], ...] = ()
    steps: tuple[str, ...] = ()
    source: str = ""


@dataclass(frozen=True)
class Formula:
    """A derived expression that emitted solvers evaluate.

    name: the function's name in emitted code. arguments: its parameters in order. expression: in those symbols
    only. claim: id of the claim that proves it. doc: its meaning, with units where it has any. case: the load
    case to which it belongs. source: equation of the article it stands for. family: 'solver', or 'article' if it is
    kept in the article's own form, to be compared with the solver.
    """

    name: str
    arguments: tuple[Symbol, ...]
    expression: Expr
    claim: str
    doc: str
    case: str = ""
    source: str = ""
    family: str = "solver"


@dataclass(frozen=True)
class Remark:
    """One line of a derivation: prose, or a named expression. text: the prose or the name."""

    text: str
    expression: Any = None


class Notebook:
    """What a derivation says, in order: remarks and claims. Claim ids are unique in a notebook."""

    def __init__(self) -> None:
        self.lines: list[Remark | Claim] = []
        self._claims: dict[str, Claim] = {}

    def say(self, text: str) -> None:
        """Write a line of prose."""
        self.lines.append(Remark(text))

    def show(self, name: str, expression: Any) -> Any:
        """Write ``name = expression`` and give the expression back."""
        self.lines.append(Remark(name, expression))
        return expression

    def claim(
        self,
        id: str,
        title: str,
        relation: Relation,
        *,
        domain: Domain | None = None,
        given: Iterable[tuple[Expr, Expr]] = (),
        steps: Iterable[str] = (),
        source: str = "",
    ) -> Claim:
        """Assert a relation; every step it names must have been claimed before."""
        if id in self._claims:
            raise ValueError(f"claim '{id}' is asserted twice; give the second one another id")
        steps = tuple(steps)
        missing = [step for step in steps if step not in self._claims]
        if missing:
            raise ValueError(f"claim '{id}' rests on unknown steps {missing}; assert those first")
        record = Claim(id, title, relation, domain or Domain(), tuple(given), steps, source)
        self._claims[id] = record
        self.lines.append(record)
        return record

    @property
    def claims(self) -> Mapping[str, Claim]:
        """All claims by id, in the order in which they were asserted."""
        return self._claims

    def text(self) -> Iterator[str]:
        """The derivation as lines of text, for printing by a script."""
        for line in self.lines:
            if isinstance(line, Claim):
                yield f"  [{line.id}] {line.title}"
            elif line.expression is None:
                yield line.text
            else:
                yield f"    {line.text} = {line.expression}"


def print_notebook(write: Callable[[Notebook], Any]) -> None:
    """Print what a derivation writes; write: the function that writes it into a notebook."""
    book = Notebook()
    write(book)
    print(*book.text(), sep="\n")
