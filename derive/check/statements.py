"""Printed statements as claims for ``judge``, in each of their readings.

What a plain statement asserts in a reading is in ``asserted``. Of several cases each is judged where its condition
holds; where none of them holds, the statement is refuted.

A formula that holds along every rod, but with a sign or a branch that is not printed, is PROVED, and the condition
that was found is in the verdict's reason: ± that changes its sense along a rod, a logarithm whose principal value
jumps. What the printed signs cannot mend, at any point of any rod, is REFUTED there.

A single equality that holds is a DEFINITION if it introduces a name, as the conventions say of the name: alone on the
first side, under no hypothesis. A chain says more than that. Everything else that is proved is PROVED. Nothing is
looked up: verdicts are computed.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from typing import Any

from derive.check.asserted import claims_of
from derive.check.branches import Branch, branches, index_values
from derive.check.meaning import Components, MeaningError
from derive.check.readings import readings
from derive.check.report import RelationVerdict, StatementVerdict, statement_verdict
from derive.check.verdicts import DEFINITION, PROVED, REFUTED, UNKNOWN, Verdict
from derive.paper import tree as t
from derive.paper.conventions import scope as conventions_of
from derive.paper.indices import overfull
from derive.paper.ledger import Record
from derive.theory.claims import Claim

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
    """Is it one equality, whose first side is a name that this display introduces, alone or at variables?"""
    first = statement.sides[0]
    alone = isinstance(first, t.Name) or (
        isinstance(first, t.Call) and not first.primes and all(isinstance(arg, t.Name) for arg in first.args)
    )
    if not alone or statement.operators != ("=",):
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
