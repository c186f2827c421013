"""The family of records of numerical stability: a record for each emitted formula."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import partial

from derive.measure.bench.families import Job, Plan, Record
from derive.measure.hard import exact
from derive.measure.reference import Rod
from derive.measure.stability import DEFECT, record_of, table, worst_input
from derive.measure.stability_formulas import known_formulas

PARTS = {"stability": "what emitted formulas lose beyond their condition numbers"}
RODS, QUICK_RODS, SEED = 60, 2, 1
HEAD = ("formula", "operations", "loss, roundings", "condition", "excess", "rod")


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
    inputs = [f"- {worst_input(one)}" for one in by_excess(records)]
    return ["## Stability of the formulas", "", text, "", *table(records), "", *inputs]


def by_excess(records: Sequence[Record]) -> list[Record]:
    """Formulas that were called on some rod, the worst first."""
    return sorted((record for record in records if record["rod"]), key=lambda one: -float(one["called"]["excess"]))


def rows(records: Sequence[Record]) -> list[list[str]]:
    """The cells of HEAD for each formula, the worst first."""
    found = []
    for one in by_excess(records):
        numbers = [f"{float(one['called'][key]):.2g}" for key in ("loss", "condition", "excess")]
        found.append([one["name"], str(one["operations"]), *numbers, exact(Rod(**one["rod"]))])
    return found


def summary(records: Sequence[Record]) -> str:
    """In one line."""
    (worst, *_), condition = by_excess(records), max(float(one["called"]["condition"]) for one in records)
    return (
        f"{len(records)} formulas: the worst excess is {float(worst['called']['excess']):.2g} ({worst['name']}), "
        f"the greatest condition number {condition:.2g}"
    )
