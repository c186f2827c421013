"""What becomes of the mutants, as plain data, and the score.

A printed statement that is refuted is mended first: its mutants would show nothing.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import replace
from typing import Any

from derive.check import mutate
from derive.check.printed import judge_formula
from derive.check.report import FormulaVerdict
from derive.check.trial import EQUIVALENT, ILL_TYPED, KILLED, MEANINGLESS, SURVIVING, Fate, Trial
from derive.check.verdicts import AGREED, CERTIFIED, DEFINITION, PROVED
from derive.paper.ledger import Record
from derive.paper.printer import to_latex
from derive.paper.reader import parse
from derive.theory.claims import Claim

FATES = (KILLED, ILL_TYPED, EQUIVALENT, SURVIVING, MEANINGLESS)
HOLD = (PROVED, DEFINITION, CERTIFIED, AGREED)


def of_claim(claim: Claim) -> list[dict[str, Any]]:
    """The fates of the mutants of a claim, as plain data."""
    return [_of_outcome(outcome) for outcome in mutate.tried(claim)]


def _of_outcome(outcome: mutate.Outcome) -> dict[str, Any]:
    fate = SURVIVING if outcome.fate == "failed" else outcome.fate
    said = outcome.verdict
    return _fate(outcome.id, kind_of(outcome.change), fate, f"{said.id}: {outcome.change}", said.verdict, said.reason)


def kind_of(change: str) -> str:
    """The kind of a change, without its place."""
    last = change.rsplit(": ", 1)[-1]
    if last.endswith("exchanged"):
        return "symbols exchanged"
    return "range" if last.startswith("range of") else last


def of_formula(theory: Any, record: Record) -> list[dict[str, Any]]:
    """The fates of the mutants of a printed formula, as plain data; what has no sound form survives itself."""
    verdict = judge_formula(theory, record, mend=True)
    sound, unsound = mended(record, verdict)
    found = [_fate(record.id, "none", SURVIVING, latex, "", "neither holds nor can be mended") for latex in unsound]
    if sound is None:
        return found
    numbers = {n for n, one in enumerate(verdict.statements) if one.repair or one.verdict in HOLD}
    return found + [_of_mutant(record.id, fate) for fate in Trial(theory, sound, numbers).fates()]


def mended(record: Record, verdict: FormulaVerdict) -> tuple[Record | None, list[str]]:
    """The formula with repairs for what is refuted (None if it was not read), and what has no sound form."""
    if not verdict.statements:
        return None, [record.latex]
    printed = [to_latex(statement, str(record.scope)) for statement in parse(record.latex, str(record.scope))]
    parts = [s.repair["latex"] if s.repair else latex for s, latex in zip(verdict.statements, printed, strict=True)]
    unsound = [s.printed for s in verdict.statements if not s.repair and s.verdict not in HOLD]
    return replace(record, latex=r" \,, \qquad ".join(parts)), unsound


def _of_mutant(label: str, fate: Fate) -> dict[str, Any]:
    return _fate(label, fate.mutant.change, fate.fate, fate.mutant.latex, fate.verdict, fate.reason)


def _fate(of: str, kind: str, fate: str, mutant: str, verdict: str, reason: str) -> dict[str, Any]:
    """One mutant; what it was is kept of those that need a look."""
    found = {"id": of, "kind": kind, "fate": fate}
    return found if fate == KILLED else {**found, "mutant": mutant, "verdict": str(verdict), "reason": reason}


def score(fates: Iterable[Mapping[str, Any]], by: Callable[[Mapping[str, Any]], str]) -> dict[str, dict[str, int]]:
    """How many mutants met each fate, by kind or by formula, in alphabetic order."""
    found: dict[str, dict[str, int]] = {}
    for one in fates:
        found.setdefault(by(one), dict.fromkeys(FATES, 0))[one["fate"]] += 1
    return dict(sorted(found.items()))
