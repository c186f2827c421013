"""What becomes of the mutants of one printed formula, the cheap attempts first.

A mutant that the reader's types forbid is *ill-typed*. One with a counterexample, at the points of the bench or by the
judge, is *killed*. One that is proved, and proved to say what the original says, is *equivalent*. Anything else
*survives*. A change that leaves a formula without a meaning in the model shows nothing: it is *meaningless*, and
counted apart; of an exchanged symbol the next of its type is tried.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import partial
from typing import Any

from derive.check.bench import Bench
from derive.check.judge import judge
from derive.check.misprints import NEAREST, Mutant, Mutants
from derive.check.report import StatementVerdict
from derive.check.same import same_meaning
from derive.check.statements import judge_statement
from derive.check.timing import TimeLimit, limited
from derive.check.verdicts import DEFINITION, PROVED, REFUTED, UNKNOWN, Verdict
from derive.paper import tree as t
from derive.paper.ledger import Record
from derive.paper.reader import parse
from derive.theory.claims import Claim

SECONDS = 5.0  # for one claim of a mutant
ILL_TYPED, KILLED, EQUIVALENT, SURVIVING, MEANINGLESS = "ill-typed", "killed", "equivalent", "surviving", "meaningless"
NONSENSE = (ArithmeticError, LookupError, TypeError, NotImplementedError)  # SymPy's answers to what makes no sense


@dataclass(frozen=True)
class Fate:
    """What became of a mutant, and why."""

    mutant: Mutant
    fate: str
    verdict: str = ""
    reason: str = ""


class _RefutedError(Exception):
    """One claim of a mutant is refuted; the others need no look."""

    def __init__(self, verdict: Verdict) -> None:
        self.verdict = verdict


class Trial:
    """The mutants of one formula, tried. statements: those whose mutants show something; None for all."""

    def __init__(self, theory: Any, record: Record, statements: set[int] | None = None) -> None:
        self.theory, self.record, self.scope = theory, record, str(record.scope)
        self.given = tuple(one for latex in record.given for one in parse(latex, self.scope))
        self.bench = Bench(theory, self.scope, self.given)
        self.source = Mutants(record)
        every = set(range(len(self.source.printed)))
        self.wanted = every if statements is None else statements
        self.sound = {n for n in self.wanted if self._stands(self.source.printed[n])}

    def _stands(self, statement: t.Statement) -> bool:
        """Does the original pass the bench? If not, its mutants are judged without it."""
        try:
            with limited(SECONDS):
                return self.bench.counterexample(statement) is None
        except (ValueError, TimeLimit, *NONSENSE):
            return False

    def fates(self) -> Iterator[Fate]:
        """Of all mutants, and of the changes that made none."""
        for mutant in self.source.changed():
            if mutant.number in self.wanted:
                yield self.fate(mutant)
        for place in self.source.exchanged():
            tried = 0
            for mutant in place:
                if mutant.number not in self.wanted:
                    break
                fate = self.fate(mutant)
                if fate.fate != MEANINGLESS:
                    tried += 1
                    yield fate
                if tried == NEAREST:
                    break

    def fate(self, mutant: Mutant) -> Fate:
        """Of one mutant."""
        if mutant.statement is None:
            return Fate(mutant, ILL_TYPED, "", mutant.reason)
        if mutant.number in self.sound:
            try:
                with limited(SECONDS):
                    found = self.bench.counterexample(mutant.statement)
                if found:
                    return Fate(mutant, KILLED, REFUTED)
            except (ValueError, *NONSENSE) as reason:
                return Fate(mutant, MEANINGLESS, UNKNOWN, str(reason))
            except TimeLimit:
                pass  # the judge has limits of its own
        verdict = self._judged(mutant.number, mutant.statement)
        if verdict.verdict == REFUTED:
            return Fate(mutant, KILLED, REFUTED)
        if verdict.verdict in (PROVED, DEFINITION):
            original = self.source.printed[mutant.number]
            if same_meaning(self.theory, self.scope, original, mutant.statement, self.given):
                return Fate(mutant, EQUIVALENT, verdict.verdict)
        meaningless = verdict.verdict == UNKNOWN and any(one.relation == "meaning" for one in verdict.relations)
        return Fate(mutant, MEANINGLESS if meaningless else SURVIVING, verdict.verdict, verdict.reason)

    def _judged(self, number: int, statement: t.Statement) -> StatementVerdict:
        """The verdict on a mutant; the first claim that is refuted ends it."""
        judged = partial(judge_statement, self.theory, self.record, number, statement, self.given)
        try:
            return judged(_decide)
        except _RefutedError as found:
            return StatementVerdict("", REFUTED, found.verdict.method, (), found.verdict.counterexample)
        except NONSENSE as reason:
            return StatementVerdict("", UNKNOWN, "none", (), None, str(reason))


def _decide(claim: Claim) -> Verdict:
    verdict = judge(claim, SECONDS)
    if verdict.verdict == REFUTED:
        raise _RefutedError(verdict)
    return verdict
