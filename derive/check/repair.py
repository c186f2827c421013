"""The smallest edits of a refuted statement that make it one that is proved.

One edit comes before two, likelier ones first (``edits`` says in which order); in a chain only sides are edited that
disagree with the most. Each candidate is refuted at a point if it can be, which takes about a millisecond; only what
withstands that is proved. Nothing is known of the misprints of this article.
"""

from __future__ import annotations

import time
from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import Any

from derive.check.bench import Bench
from derive.check.differences import differences
from derive.check.edits import edits
from derive.check.judge import judge
from derive.check.pairs import NONSENSE, pairs
from derive.check.report import StatementVerdict
from derive.check.statements import judge_statement
from derive.check.suspects import suspects
from derive.check.timing import TimeLimit, limited
from derive.check.verdicts import DEFINITION, PROVED, REFUTED, Verdict
from derive.paper import tree as t
from derive.paper.errors import ReadError
from derive.paper.ledger import Record
from derive.paper.printer import to_latex
from derive.paper.reader import parse
from derive.theory.claims import Claim

SECONDS = 30.0  # of the processor, for one statement
CLAIM_SECONDS = 5.0  # for one claim of one candidate
CANDIDATES = 20_000  # of one statement
SLOW = 40  # candidates that withstood the bench and were not proved
FEW = 60  # likeliest edits of which all pairs are tried


class _UnprovedError(Exception):
    """One claim of a candidate fails; the others need no look."""


@dataclass(frozen=True)
class Repair:
    """latex: the mended statement. edits: what was changed, in words. tried: candidates up to this one.

    changes: the parts that are changed, and what they are changed to, in LaTeX.
    """

    latex: str
    verdict: str
    edits: tuple[str, ...]
    tried: int
    changes: tuple[tuple[str, str], ...] = ()

    def to_json(self) -> dict[str, Any]:
        """Plain values, for JSON."""
        changes = [list(pair) for pair in self.changes]
        said = {"latex": self.latex, "verdict": self.verdict, "edits": list(self.edits), "tried": self.tried}
        return {**said, "changes": changes}


def repaired(
    theory: Any,
    record: Record,
    judged: list[StatementVerdict],
    statements: list[t.Statement],
    given: tuple[t.Statement, ...],
    seconds: float = SECONDS,
) -> list[StatementVerdict]:
    """The same verdicts; with a repair, where one is found, on those that are refuted."""
    result = []
    for number, (verdict, statement) in enumerate(zip(judged, statements, strict=True)):
        if verdict.verdict == REFUTED:
            found = repair(theory, record, number, statement, given, seconds)
            verdict = replace(verdict, repair=found.to_json() if found else None)
        result.append(verdict)
    return result


def repair(
    theory: Any,
    record: Record,
    number: int,
    statement: t.Statement,
    given: tuple[t.Statement, ...] = (),
    seconds: float = SECONDS,
) -> Repair | None:
    """The first candidate that is proved, or None if there is none or the time is up."""
    end, scope = time.process_time() + seconds, str(record.scope)
    bench, slow = Bench(theory, scope, given), 0
    for tried, (names, candidate) in enumerate(_candidates(bench, statement, scope), start=1):
        if time.process_time() > end or tried > CANDIDATES or slow > SLOW:
            return None
        if _fails(bench, candidate):
            continue
        readable = _readable(candidate, scope)
        found = readable and _proved(theory, record, number, readable[1], given)
        if readable and found:
            changes = differences(statement, readable[1], scope)
            return Repair(readable[0], found, names, tried, tuple(changes))
        slow += 1
    return None


def _candidates(bench: Bench, statement: t.Statement, scope: str) -> Iterator[tuple[tuple[str, ...], t.Statement]]:
    """With one edit, with two whose amounts fit, and with any two of the likeliest."""
    once = edits(statement, scope, _suspects(bench, statement))
    seen = {statement}
    for edit in once:
        seen.add(edit.of(statement))
        yield (edit.kind,), edit.of(statement)
    for one, other in (*pairs(bench, statement, once),):
        candidate = other.of(one.of(statement))
        if candidate not in seen:
            seen.add(candidate)
            yield (one.kind, other.kind), candidate
    for one in once[:FEW]:
        for other in edits(one.of(statement), scope, {one.side})[:FEW]:
            candidate = other.of(one.of(statement))
            if candidate not in seen:
                seen.add(candidate)
                yield (one.kind, other.kind), candidate


def _suspects(bench: Bench, statement: t.Statement) -> set[int]:
    try:
        return suspects(bench, statement)
    except NONSENSE:
        return set(range(len(statement.sides)))


def _fails(bench: Bench, candidate: t.Statement) -> bool:
    """Does it fail at a point, or make nonsense?"""
    try:
        with limited(CLAIM_SECONDS):
            return bench.counterexample(candidate) is not None
    except (*NONSENSE, TimeLimit):
        return True


def _proved(
    theory: Any, record: Record, number: int, candidate: t.Statement, given: tuple[t.Statement, ...]
) -> str | None:
    """PROVED or DEFINITION, or None. The first claim that fails ends it."""

    def decide(claim: Claim) -> Verdict:
        verdict = judge(claim, CLAIM_SECONDS)
        if verdict.verdict != PROVED:
            raise _UnprovedError
        return verdict

    try:
        verdict = judge_statement(theory, record, number, candidate, given, decide).verdict
    except (_UnprovedError, ArithmeticError, LookupError, TypeError, NotImplementedError):  # of a bad edit
        return None
    return str(verdict) if verdict in (PROVED, DEFINITION) else None


def _readable(candidate: t.Statement, scope: str) -> tuple[str, t.Statement] | None:
    """The candidate as it is printed and read; None if it has no LaTeX that the reader takes."""
    try:
        latex = to_latex(candidate, scope)
        read = parse(latex, scope)
    except (ReadError, KeyError, ValueError):
        return None
    return (latex, read[0]) if len(read) == 1 else None
