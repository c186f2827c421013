"""The printed formulas judged, from their LaTeX; what is refuted is repaired where one small edit mends it."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterable, Mapping
from typing import Any

from derive.check.judge import judge
from derive.check.repair import repaired
from derive.check.report import FormulaVerdict, formula_verdict
from derive.check.statements import Judge, judge_statement
from derive.check.verdicts import UNREAD
from derive.paper.errors import ReadError
from derive.paper.ledger import Record
from derive.paper.reader import parse

SECONDS = 60.0  # for one claim; the slowest takes a few, but verdicts must not depend on how busy a machine is


def judge_formulas(
    theory: Any,
    records: Mapping[str, Record],
    only: Iterable[str] | None = None,
    progress: Callable[[FormulaVerdict], Any] | None = None,
    seconds: float = SECONDS,
    mend: bool = True,
) -> list[FormulaVerdict]:
    """The verdict on every record, or on those named; KeyError for a name that is no record.

    theory: what ``derive_all`` gives. records: by label, as ``load_ledger`` or ``from_source`` gives them. only: the
    labels wanted. progress: called with each verdict. seconds: the time limit of a statement. mend: look for repairs.
    """
    chosen = list(records.values()) if only is None else [records[label] for label in only]
    verdicts = []
    for record in chosen:
        verdicts.append(judge_formula(theory, record, lambda claim: judge(claim, seconds), mend=mend))
        if progress is not None:
            progress(verdicts[-1])
    return verdicts


def judge_formula(theory: Any, record: Record, decide: Judge = judge, *, mend: bool = False) -> FormulaVerdict:
    """The verdict on one formula: the worst of its statements'.

    theory: what ``derive_all`` gives. record: the formula. decide: what judges a claim. mend: look for repairs of
    statements that are refuted.
    """
    start = time.perf_counter()
    try:
        if record.scope is None:
            raise ReadError(record.line, record.column, "no section of conventions.toml covers this label; add one")
        given = tuple(statement for latex in record.given for statement in parse(latex, record.scope))
        statements = parse(record.latex, record.scope, (max(record.line, 1), record.column))
    except ReadError as error:
        return FormulaVerdict(record.id, record.line, UNREAD, record.latex, "reader", (), None, None, str(error))
    judged = [judge_statement(theory, record, n, statement, given, decide) for n, statement in enumerate(statements)]
    if mend:
        judged = repaired(theory, record, judged, statements, given)
    return formula_verdict(record, judged, time.perf_counter() - start)
