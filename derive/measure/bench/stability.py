"""The family of records of numerical stability: a record for each emitted formula."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import partial

from derive.measure.bench.families import Job, Plan, Record
from derive.measure.stability import DEFECT, record_of, table, worst_input
from derive.measure.stability_formulas import known_formulas

PARTS = {"stability": "what emitted formulas lose beyond their condition numbers"}
RODS, QUICK_RODS, SEED = 60, 2, 1


def jobs(plan: Plan) -> Iterator[Job]:
    """A job for each formula."""
    rods = QUICK_RODS if plan.quick else RODS
    for name in known_formulas():
        yield Job(f"stability/{name}", partial(record_of, name, SEED, rods))


def wrong(records: Sequence[Record]) -> Iterator[str]:
    """Formulas that lose more than their condition numbers explain."""
    for record in records:
        if record["defect"]:
            yield f"{record['key']}: loses {record['called']['excess']} times what is explained; {worst_input(record)}"


def document(records: Sequence[Record]) -> list[str]:
    """The table, and the worst inputs with the commands that find them again."""
    text = f"“Excess” is the loss over operations × (1 + condition number); above {DEFECT:g} it is a defect."
    worst = sorted((record for record in records if record["rod"]), key=lambda one: -float(one["called"]["excess"]))
    return ["## Stability of the formulas", "", text, "", *table(records), "", *(f"- {worst_input(o)}" for o in worst)]
