"""What becomes of the mutants: killed by a counterexample, proved to say what the original says, or surviving.

A printed statement that is refuted is mended first: its mutants would show nothing.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import replace
from typing import Any

from derive.check import misprints, mutate
from derive.check.printed import judge_formula
from derive.check.report import FormulaVerdict
from derive.check.verdicts import DEFINITION, PROVED, REFUTED
from derive.paper.ledger import Record
from derive.theory.claims import Claim

FATES = ("killed", "equivalent", "surviving")


def of_claim(claim: Claim) -> list[dict[str, Any]]:
    """The fates of the mutants of a claim, as plain data."""
    return [_of_outcome(outcome) for outcome in mutate.tried(claim)]


def _of_outcome(outcome: mutate.Outcome) -> dict[str, Any]:
    fate = "surviving" if outcome.fate == "failed" else outcome.fate
    said = outcome.verdict
    return _fate(outcome.id, kind_of(outcome.change), fate, f"{said.id}: {outcome.change}", said.verdict, said.reason)


def kind_of(change: str) -> str:
    """The kind of a change, without its place."""
    last = change.rsplit(": ", 1)[-1]
    if last.endswith("exchanged"):
        return "symbols exchanged"
    return "range" if last.startswith("range of") else last


def of_formula(theory: Any, record: Record) -> list[dict[str, Any]]:
    """The fates of the mutants of a printed formula, as plain data."""
    sound = mended(record, judge_formula(theory, record, mend=True))
    if sound is None:
        return [_fate(record.id, "none", "surviving", record.latex, "", "it is neither proved nor can it be mended")]
    return [_of_mutant(theory, sound, mutant) for mutant in misprints.mutants(sound)]


def mended(record: Record, verdict: FormulaVerdict) -> Record | None:
    """The formula, with repairs in the place of what is refuted; None if a statement cannot be proved."""
    parts = [s.repair["latex"] if s.repair else s.printed for s in verdict.statements]
    proved = [s.repair or s.verdict in (PROVED, DEFINITION) for s in verdict.statements]
    if not parts or not all(proved):
        return None
    return replace(record, latex=r" \,, \qquad ".join(parts))


def _of_mutant(theory: Any, record: Record, mutant: misprints.Mutant) -> dict[str, Any]:
    verdict = misprints.judge_mutant(theory, record, mutant)
    fate = "killed" if verdict.verdict == REFUTED else "surviving"
    if verdict.verdict in (PROVED, DEFINITION) and misprints.same_meaning(theory, record, mutant):
        fate = "equivalent"
    return _fate(record.id, mutant.change, fate, mutant.latex, verdict.verdict, verdict.reason)


def _fate(of: str, kind: str, fate: str, mutant: str, verdict: str, reason: str) -> dict[str, Any]:
    """One mutant; what it was is kept of survivors only."""
    found = {"id": of, "kind": kind, "fate": fate}
    return found if fate != "surviving" else {**found, "mutant": mutant, "verdict": str(verdict), "reason": reason}


def score(fates: Iterable[Mapping[str, Any]], by: Callable[[Mapping[str, Any]], str]) -> dict[str, dict[str, int]]:
    """How many mutants met each fate, by kind or by formula, in alphabetic order."""
    found: dict[str, dict[str, int]] = {}
    for one in fates:
        found.setdefault(by(one), dict.fromkeys(FATES, 0))[one["fate"]] += 1
    return dict(sorted(found.items()))
