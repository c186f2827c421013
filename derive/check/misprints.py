"""Wrong variants of printed formulas: one small change of the printed tree at a time.

A checker must be seen to fail. A mutant that is still proved is no failure only if it says the same as the original,
side by side, which is itself proved (``(-b)²`` for ``b²``).
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, replace
from typing import Any

from derive.check.judge import judge
from derive.check.readings import readings
from derive.check.report import StatementVerdict
from derive.check.statements import judge_statement
from derive.check.verdicts import PROVED
from derive.paper import tree as t
from derive.paper.conventions import scope as conventions_of
from derive.paper.ledger import Record
from derive.paper.printer import to_latex
from derive.paper.reader import parse
from derive.theory.claims import Claim, Equal

# Letters that are taken for each other. Not γ for η: in γ > … that makes another true inequality.
SWAPS = {
    "beta": ("eta",), "eta": ("beta",), "gamma_bar": ("gamma",), "xi_a": ("xi_b",), "xi_b": ("xi_a",),
    "g_2": ("g_3",), "g_3": ("g_2",), "b": ("c",), "c": ("b",), "y": ("z",), "z": ("y",),
    "ell": ("s",), "e_x": ("e_y",),
}  # fmt: skip

Own = Callable[[t.Node], Iterable[tuple[str, t.Node]]]


@dataclass(frozen=True)
class Mutant:
    """A changed statement of a formula: which change, the statement's number, the tree, and its LaTeX."""

    change: str
    number: int
    statement: t.Statement
    latex: str


def mutants(record: Record) -> list[Mutant]:
    """All mutants of a formula, in its order; without repetition, and none that the formula prints itself."""
    scope = str(record.scope)
    printed = parse(record.latex, scope)
    names = set(conventions_of(scope).by_name)
    found: dict[tuple[int, t.Statement], Mutant] = {}
    for number, statement in enumerate(printed):
        for change, mutant in variants(statement, lambda node: own_changes(node, names)):
            if mutant not in printed and (number, mutant) not in found:
                found[number, mutant] = Mutant(change, number, mutant, to_latex(mutant, scope))
    return list(found.values())


def variants(statement: t.Statement, own: Own) -> Iterator[tuple[str, t.Statement]]:
    """A statement with one change: of a node, as ``own`` gives them, of a side's sign, or of a relation."""
    for n, side in enumerate(statement.sides):
        changed = list(_of_node(side, own))
        tends = n == 0 and statement.operators[0] == "->"  # −b → 0 says what b → 0 says
        if side != t.Number(0) and not isinstance(side, t.Signed) and not tends:
            changed.append(("sign", t.Signed("-", side)))
        for change, mutant in changed:
            yield change, replace(statement, sides=(*statement.sides[:n], mutant, *statement.sides[n + 1 :]))
    for n, operator in enumerate(statement.operators):
        if operator in "<>":
            turned = (*statement.operators[:n], "<" if operator == ">" else ">", *statement.operators[n + 1 :])
            yield "relation", replace(statement, operators=turned)


def _of_node(node: t.Node, own: Own) -> Iterator[tuple[str, t.Node]]:
    """The changes of a node itself, then those of its parts."""
    yield from own(node)
    parts = node.parts()
    for n, part in enumerate(parts):
        for change, mutant in _of_node(part, own):
            yield change, node.with_parts((*parts[:n], mutant, *parts[n + 1 :]))


def own_changes(node: t.Node, names: set[str]) -> Iterator[tuple[str, t.Node]]:
    """The changes of a node itself; its parts stay."""
    match node:
        case t.Number(value=value):
            yield "number", replace(node, value=value + 1)
        case t.Name(name=name):
            yield from (("symbol", replace(node, name=new)) for new in SWAPS.get(name, ()) if new in names)
        case t.Sum(terms=terms):
            for n, term in enumerate(terms):
                yield "sign", t.Sum((*terms[:n], turned(term), *terms[n + 1 :]))
                rest = (*terms[:n], *terms[n + 1 :])
                yield "term", rest[0] if len(rest) == 1 else t.Sum(rest)
        case t.Product(factors=factors):
            for n in range(len(factors)):
                rest = (*factors[:n], *factors[n + 1 :])
                if factors[n].type == t.SCALAR:
                    yield "factor", rest[0] if len(rest) == 1 else t.Product(rest)
        case t.Primed(order=order, of=of):
            yield "prime", of if order == 1 else replace(node, order=order - 1)
        case t.Call(primes=primes) if primes:
            yield "prime", replace(node, primes=primes - 1)
        case t.Power(base=base) if base.type == t.SCALAR:
            yield "power", base
        case t.Signed(of=of):
            yield "sign", of
        case t.Root(of=of):
            yield "root", of


def turned(term: t.Node) -> t.Node:
    """A term with the other sign."""
    return term.of if isinstance(term, t.Signed) else t.Signed("-", term)


def judge_mutant(theory: Any, record: Record, mutant: Mutant) -> StatementVerdict:
    """The verdict on a mutant, under the hypotheses of the formula."""
    given = tuple(statement for latex in record.given for statement in parse(latex, str(record.scope)))
    return judge_statement(theory, record, mutant.number, mutant.statement, given, judge)


def same_meaning(theory: Any, record: Record, mutant: Mutant) -> bool:
    """Is the mutant, side by side, proved equal to the original in every reading?"""
    scope = str(record.scope)
    original = parse(record.latex, scope)[mutant.number]
    given = tuple(statement for latex in record.given for statement in parse(latex, scope))
    if original.operators != mutant.statement.operators:
        return False
    sides = original.sides + mutant.statement.sides
    for reading in readings(theory, scope, sides, given):
        for one, other in zip(original.sides, mutant.statement.sides, strict=True):
            left, right = reading.of(one), reading.of(other)
            if judge(Claim("same", "equal sides", Equal(left, right), reading.domain)).verdict != PROVED:
                return False
    return True
