"""Records of the verdicts on printed formulas, and how the parts decide the whole: the worst decides."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from derive.check.verdicts import (
    AGREED,
    CERTIFIED,
    DEFINITION,
    PROVED,
    REFUTED,
    UNKNOWN,
    UNREAD,
    VERDICTS,
    Verdict,
)
from derive.paper.ledger import Record

# From best to worst.
ORDER = (PROVED, DEFINITION, CERTIFIED, AGREED, UNKNOWN, UNREAD, REFUTED)


def worst(verdicts: Sequence[VERDICTS]) -> VERDICTS:
    """The verdict that decides; UNKNOWN if there is none."""
    return max(verdicts, key=ORDER.index, default=UNKNOWN)


@dataclass(frozen=True)
class RelationVerdict:
    """One relation of a statement in one reading. note: how it had to be read, where that is not plain."""

    relation: str
    verdict: Verdict
    note: str = ""

    def to_json(self) -> dict[str, Any]:
        """Plain values, for JSON."""
        said = self.verdict.to_json()
        return {"relation": self.relation, **{key: said[key] for key in ("verdict", "method", "reason")}}


@dataclass(frozen=True)
class StatementVerdict:
    """One statement: printed is its LaTeX; relations are all that was judged for it; repair as in ``repair``."""

    printed: str
    verdict: VERDICTS
    method: str
    relations: tuple[RelationVerdict, ...]
    counterexample: dict[str, str] | None = None
    reason: str = ""
    seconds: float = 0.0
    repair: dict[str, Any] | None = None

    def to_json(self) -> dict[str, Any]:
        """Plain values, for JSON."""
        relations = [relation.to_json() for relation in self.relations]
        names = ("printed", "verdict", "method", "counterexample", "repair", "reason", "seconds")
        return _plain(self, *names, relations=relations)


@dataclass(frozen=True)
class FormulaVerdict:
    """One display. id: its label. repair: a proved mend, where one was sought. reason: with the place, if unread."""

    id: str
    line: int
    verdict: VERDICTS
    printed: str
    method: str
    statements: tuple[StatementVerdict, ...]
    counterexample: dict[str, str] | None = None
    repair: dict[str, Any] | None = None
    reason: str = ""
    seconds: float = 0.0

    def to_json(self) -> dict[str, Any]:
        """Plain values, for JSON."""
        said = _plain(self, "id", "line", "verdict", "printed", "method")
        statements = [statement.to_json() for statement in self.statements]
        return {**said, **_plain(self, "counterexample", "repair", "reason", "seconds", statements=statements)}


def _plain(record: Any, *names: str, **more: Any) -> dict[str, Any]:
    values = {name: getattr(record, name) for name in names}
    if "verdict" in values:
        values["verdict"] = str(values["verdict"])
    return {**values, **more}


def statement_verdict(
    printed: str, relations: Sequence[RelationVerdict], seconds: float, passed_as: VERDICTS | None
) -> StatementVerdict:
    """The worst relation decides; ``passed_as`` is the verdict if all are proved, where it is not PROVED."""
    decides = max(relations, key=lambda relation: ORDER.index(relation.verdict.verdict))
    verdict = passed_as or decides.verdict.verdict
    notes = dict.fromkeys(relation.note for relation in relations if relation.note)
    reason = "; ".join([part for part in (_where(decides), *notes) if part])
    method = "; ".join(dict.fromkeys(relation.verdict.method for relation in relations))
    if verdict not in (PROVED, DEFINITION):
        method = decides.verdict.method
    counterexample = decides.verdict.counterexample
    return StatementVerdict(printed, verdict, method, tuple(relations), counterexample, reason, seconds)


def _where(decides: RelationVerdict) -> str:
    said = decides.verdict
    if said.verdict in (PROVED, DEFINITION):
        return ""
    return f"relation {decides.relation}" + (f": {said.reason}" if said.reason else "")


def formula_verdict(record: Record, statements: Sequence[StatementVerdict], seconds: float) -> FormulaVerdict:
    """The worst statement decides."""
    decides = max(statements, key=lambda statement: ORDER.index(statement.verdict))
    method = "; ".join(dict.fromkeys(statement.method for statement in statements))
    if decides.verdict not in (PROVED, DEFINITION):
        method = decides.method
    reason = "; ".join(dict.fromkeys(statement.reason for statement in statements if statement.reason))
    return FormulaVerdict(
        record.id,
        record.line,
        decides.verdict,
        record.latex,
        method,
        tuple(statements),
        decides.counterexample,
        decides.repair,
        reason,
        seconds,
    )
