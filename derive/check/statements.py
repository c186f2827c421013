"""Printed statements as claims for ``judge``, in each of their readings.

Relations are read as ``relations`` says, ± as ``either`` does: one sign for the whole statement. Further:

- ``A → B``: a limit, for the limit that the text assumes (its hypothesis ``γ → γ_1``). The target of an arrow does
  not vary, so whatever stands right of an arrow is taken *at* the limit: ``ξ_b → ξ_b = 1 + 2β/η`` says that ξ_b tends
  to its value at the limit, and that this value is 1 + 2β/η. The verdict's reason says where this was needed.
- ``A = B`` where the text drops what is O(εⁿ): the difference is of that order.
- Cases: each is judged where its condition holds; where none of them holds, the statement is refuted.

A formula that holds along every rod, but with a sign or a branch that is not printed, is PROVED, and the condition
that was found is in the verdict's reason: ± that changes its sense along a rod, a logarithm whose principal value
jumps. What the printed signs cannot mend, at any point of any rod, is REFUTED there.

An equality that holds is a DEFINITION if it introduces a name, as the conventions say of the name: alone on the first
side, under no hypothesis. Everything else that is proved is PROVED. Nothing is looked up: verdicts are computed.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, replace
from typing import Any

from sympy import Symbol, nan, oo, zoo

from derive.check import either, relations
from derive.check.branches import Branch, branches, index_values
from derive.check.meaning import Components, MeaningError
from derive.check.readings import readings
from derive.check.report import RelationVerdict, StatementVerdict, statement_verdict
from derive.check.verdicts import DEFINITION, PROVED, REFUTED, UNKNOWN, Verdict
from derive.paper import tree as t
from derive.paper.conventions import scope as conventions_of
from derive.paper.indices import overfull
from derive.paper.ledger import Record
from derive.paper.symbolic import NONE, Indices
from derive.theory.claims import Claim, Domain, Limit

Judge = Callable[[Claim], Verdict]


def judge_statement(
    theory: Any, record: Record, number: int, statement: t.Statement, given: tuple[t.Statement, ...], decide: Judge
) -> StatementVerdict:
    """The verdict on one statement: the worst of its relations', in all readings."""
    start = time.perf_counter()
    found: list[RelationVerdict] = []
    cases = Cases({}, set())
    try:
        for branch in branches(statement):
            found += _of_branch(theory, record, f"{record.id}.{number + 1}", branch, given, decide, cases)
        found += [RelationVerdict(f"no case ({title})", verdict) for title, verdict in cases.open()]
    except ValueError as reason:  # MeaningError, or an expression that SymPy cannot form
        found.append(RelationVerdict("meaning", Verdict(record.id, UNKNOWN, "none", None, str(reason))))
    if not found:
        found.append(RelationVerdict("meaning", Verdict(record.id, UNKNOWN, "none", None, "no reading reads it")))
    found[-1] = replace(found[-1], note="; ".join(filter(None, (found[-1].note, *_flaws(statement)))))
    defines = not given and _introduces(statement, record)
    passed = bool(found) and all(relation.verdict.verdict == PROVED for relation in found)
    latex = record.latex[statement.span[0] : statement.span[1]] if statement.span[1] else ""
    return statement_verdict(latex, found, time.perf_counter() - start, DEFINITION if defines and passed else None)


def _flaws(statement: t.Statement) -> Iterator[str]:
    """What is amiss with the way in which a statement is written, whatever it says."""
    for letter in dict.fromkeys(letter for letter, _ in overfull(statement.sides)):
        yield f"the index {letter} is written more than twice in one product, which is summed over it all the same"


@dataclass(frozen=True)
class Cases:
    """The readings in which a case does not apply, with the refutation of its condition, and those where one does."""

    left: dict[str, Verdict]
    met: set[str]

    def open(self) -> list[tuple[str, Verdict]]:
        """The readings in which no case applies."""
        return [(title, verdict) for title, verdict in self.left.items() if title not in self.met]


def _of_branch(
    theory: Any,
    record: Record,
    stem: str,
    branch: Branch,
    given: tuple[t.Statement, ...],
    decide: Judge,
    cases: Cases,
) -> Iterator[RelationVerdict]:
    """The verdicts on a plain statement, in all readings and for all values of its indices."""
    whole = (*given, *branch.given)
    for reading in readings(theory, record.scope or "", said_of(branch.statement), whole):
        _check_given(reading, given, decide)
        refuted = _check_given(reading, branch.given, decide, may_fail=True)
        if refuted:
            cases.left[reading.title] = refuted
            continue
        cases.met.add(reading.title)
        for indices in index_values(branch.statement):
            parts = [branch.title, reading.title, *(f"{letter} = {value}" for letter, value in indices.items())]
            where = ", ".join(part for part in parts if part)
            made = [
                RelationVerdict(f"{title} ({where})", decide(claim), note)
                for title, claim, note in claims_of(branch.statement, reading, whole, stem, indices)
            ]
            if made and all(one.verdict.verdict == PROVED for one in made):
                condition = reading.condition(branch.statement.sides)
                made[-1] = replace(made[-1], note="; ".join(filter(None, (made[-1].note, condition))))
            yield from made


def said_of(statement: t.Statement) -> tuple[t.Node, ...]:
    """All sides of a statement, and of what is said after it of its letters."""
    return (*statement.sides, *(side for said in statement.where for side in said.sides))


def _introduces(statement: t.Statement, record: Record) -> bool:
    """Is the first side a name that this display introduces, alone or at variables, and every relation an equality?"""
    first = statement.sides[0]
    alone = isinstance(first, t.Name) or (
        isinstance(first, t.Call) and not first.primes and all(isinstance(arg, t.Name) for arg in first.args)
    )
    if not alone or set(statement.operators) != {"="}:
        return False
    assert isinstance(first, t.Name | t.Call)
    return conventions_of(str(record.scope)).declared(first.name, first.index).introduced == record.id


def _check_given(
    reading: Components, given: tuple[t.Statement, ...], decide: Judge, *, may_fail: bool = False
) -> Verdict | None:
    """What is assumed must hold in the reading; MeaningError if the theory says otherwise.

    may_fail: then a refutation is given back.
    """
    for statement in given:
        if "->" in statement.operators:
            continue
        for title, claim, _ in claims_of(statement, reading, (), "given"):
            verdict = decide(claim)
            if may_fail and verdict.verdict == REFUTED:
                return verdict
            if verdict.verdict != PROVED:
                raise MeaningError(f"the hypothesis '{title}' does not hold in the theory ({reading.title})")
    return None


def claims_of(
    statement: t.Statement, reading: Components, given: tuple[t.Statement, ...], stem: str, indices: Indices = NONE
) -> Iterator[tuple[str, Claim, str]]:
    """The claims that a plain statement makes in a reading, for given values of its free indices.

    Of each: what it says, the claim, and how it had to be read.
    """
    found = list(_unsigned(statement, reading, given, stem, indices))
    claims, sign = either.resolved([claim for _, claim, _ in found])
    for (title, _, note), claim, before in zip(found, claims, (claim for _, claim, _ in found), strict=True):
        if sign and claim is not before:
            note = "; ".join(part for part in (note, reading.sign_note(either.NAMES[sign], title)) if part)
        yield title, claim, note


def _unsigned(
    statement: t.Statement, reading: Components, given: tuple[t.Statement, ...], stem: str, indices: Indices
) -> Iterator[tuple[str, Claim, str]]:
    """The same with ± as it is printed."""
    values = [_value(side, reading, indices) for side in statement.sides]
    limit: tuple[Symbol, Any, str] | None = None
    note = ""
    for n, operator in enumerate(statement.operators):
        left, right, sides = values[n], values[n + 1], statement.sides[n : n + 2]
        if not reading.reads(*sides):
            continue
        domain = reading.domain if limit is None else _without(reading.domain, limit[0])
        if operator == "->":
            limit = limit or limit_of(reading, given)
            variable, point, side = limit
            at_limit = _at(right, limit)
            if at_limit != right:
                note = f"right of the arrow, what depends on {variable} is taken at the limit {variable} = {point}"
            said: Iterable[relations.Said] = [("", Limit(left, variable, point, at_limit, side))]
            domain = reading.domain
            values[n + 1 :] = [_at(value, limit) for value in values[n + 1 :]]
        elif operator == "=" and (orders := relations.orders(sides, reading, indices)):
            said, domain = [("", relations.order(left, right, reading, min(orders), sides[1]))], reading.domain
        elif isinstance(sides[1], t.Interval):
            said = relations.membership(operator, left, right, sides[1], reading)
        else:
            said = relations.said(operator, left, right, reading)
        for part, relation in said:
            claim = Claim(f"{stem}.{n + 1}", "as printed", relation, domain, reading.hypotheses, source=stem)
            yield ", ".join(filter(None, (f"{n + 1}: {operator}", part))), claim, note


def _value(side: t.Node, reading: Components, indices: Indices) -> Any:
    """The value of a side; of an interval, the values of its ends."""
    if isinstance(side, t.Interval):
        return tuple(_finite(reading.of(end, indices), reading) for end in side.parts())
    return _finite(reading.of(side, indices), reading)


def _finite(value: Any, reading: Components) -> Any:
    known = value
    for old, new in reading.hypotheses:
        known = known.subs(old, new)
    if known.has(oo, -oo, zoo, nan):
        raise MeaningError("a side is infinite or undefined, say by a division by 0")
    return value


def limit_of(reading: Components, given: tuple[t.Statement, ...]) -> tuple[Symbol, Any, str]:
    """Variable, point and side of the limit that the text assumes; MeaningError if there is none, or two."""
    arrows = [statement for statement in given if statement.operators == ("->",)]
    if len(arrows) != 1 or reading.constant is None or reading.ends is None:
        raise MeaningError("an arrow needs one limit among the hypotheses of the text")
    variable, point = (reading.of(side) for side in arrows[0].sides)
    if variable != reading.constant or point not in reading.ends:
        raise MeaningError(f"the limit {variable} → {point} is not at an end of the range of {reading.constant}")
    return variable, point, "+" if point == reading.ends[0] else "-"


def _at(value: Any, limit: tuple[Symbol, Any, str]) -> Any:
    return value.subs(limit[0], limit[1])


def _without(domain: Domain, variable: Symbol) -> Domain:
    return Domain({s: r for s, r in domain.ranges.items() if s != variable}, domain.conditions)
