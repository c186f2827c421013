"""The smallest edits of a refuted statement that make it one that is proved.

Candidates with one edit come before those with two, likelier edits first. Each is refuted at a point if it can be,
which takes milliseconds; only what withstands that is proved. Nothing is known of the misprints of this article.
"""

from __future__ import annotations

import time
from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import Any

from derive.check.edits import edits
from derive.check.judge import judge
from derive.check.report import StatementVerdict
from derive.check.statements import judge_statement
from derive.check.verdicts import DEFINITION, PROVED, REFUTED, Verdict
from derive.paper import tree as t
from derive.paper.errors import ReadError
from derive.paper.ledger import Record
from derive.paper.printer import to_latex
from derive.paper.reader import parse
from derive.theory.claims import Claim

SECONDS = 30.0  # for one statement
CLAIM_SECONDS = 5.0  # for one claim of one candidate
CANDIDATES = 4000  # of one statement
SECOND = ("sign", "argument", "prime", "number")  # kinds of edit that may come second


class _UnprovedError(Exception):
    """One claim of a candidate fails; the others need no look."""


@dataclass(frozen=True)
class Repair:
    """latex: the mended statement. edits: what was changed, in words. tried: candidates up to this one."""

    latex: str
    verdict: str
    edits: tuple[str, ...]
    tried: int

    def to_json(self) -> dict[str, Any]:
        """Plain values, for JSON."""
        return {"latex": self.latex, "verdict": self.verdict, "edits": list(self.edits), "tried": self.tried}


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
    end, scope = time.monotonic() + seconds, str(record.scope)
    for tried, (names, candidate) in enumerate(_candidates(statement, scope), start=1):
        if time.monotonic() > end or tried > CANDIDATES:
            return None
        found = _proved(theory, record, number, candidate, given)
        if found and (latex := _readable(candidate, scope)):
            return Repair(latex, str(found), names, tried)
    return None


def _candidates(statement: t.Statement, scope: str) -> Iterator[tuple[tuple[str, ...], t.Statement]]:
    once = edits(statement, scope)
    seen = {statement} | {candidate for _, candidate in once}
    yield from (((kind,), candidate) for kind, candidate in once)
    for first, candidate in once:
        if first not in SECOND:
            continue
        for second, twice in edits(candidate, scope):
            if second in SECOND and twice not in seen:
                seen.add(twice)
                yield (first, second), twice


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
    except (_UnprovedError, ArithmeticError, TypeError, NotImplementedError):
        return None  # an edit may well make nonsense
    return str(verdict) if verdict in (PROVED, DEFINITION) else None


def _readable(candidate: t.Statement, scope: str) -> str:
    """LaTeX that reads back as the candidate; empty if it has none."""
    try:
        latex = to_latex(candidate, scope)
        return latex if parse(latex, scope) == [candidate] else ""
    except (ReadError, KeyError, ValueError):
        return ""
