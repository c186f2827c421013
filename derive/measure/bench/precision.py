"""The family of records of error against run time: every method on every problem."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import partial

from derive.measure.bench import ratios, tables
from derive.measure.bench.cells import OURS, Cell, Method, Problem, key_of, measure
from derive.measure.bench.families import Job, Plan, Record
from derive.measure.bench.methods import methods
from derive.measure.bench.tasks import TASKS, module_of, problems
from derive.measure.packages import absent, left_out

PARTS = {task: module_of(task).TITLE for task in TASKS}


def jobs(plan: Plan) -> Iterator[Job]:
    """A job for each setting of each method that is there, on each problem."""
    there = [method for method in methods() if not absent(method)]
    for problem in problems(plan):
        cells = [(method, cell) for method in there for cell in method.cells(problem, plan)]
        base = next(cell for method, cell in cells if method.group == OURS)
        for method, cell in cells:
            yield job(problem, method, cell, base, plan.budget)


def job(problem: Problem, method: Method, cell: Cell, base: Cell, budget: float) -> Job:
    """That of a cell."""
    return Job(key_of(problem, method, cell), partial(measure, problem, method, cell, base, budget))


def document(records: Sequence[Record]) -> list[str]:
    """A table for each problem, with what others do better; ratios to those that are asked for; and who is missing."""
    lines = [tables.PREFACE, ""]
    for problem in dict.fromkeys(record["problem"] for record in records):
        rows = [record for record in records if record["problem"] == problem]
        lines += [*tables.section(rows, module_of(rows[0]["task"]).NOTE), ""]
    compared = [*ratios.section(records), ""]
    return [*lines, *compared, *(f"- {line}" for line in missing())]


def missing() -> list[str]:
    """Methods that are not there, and what would bring them."""
    return left_out(methods())


def idle(records: Sequence[Record]) -> Iterator[str]:
    """Methods that find nothing in a problem, with any setting."""
    by_method: dict[tuple[str, str], int] = {}
    for record in records:
        if record["whole"]:
            key = record["problem"], record["method"]
            by_method[key] = by_method.get(key, 0) + record["errors"]["found"]
    yield from (
        f"tasks/{problem}/{method}: nothing was found" for (problem, method), found in by_method.items() if not found
    )


def wrong(records: Sequence[Record]) -> Iterator[str]:
    """Records whose error is beyond its limit, or that miss what they must find; and methods that find nothing."""
    yield from idle(records)
    for record in records:
        errors = record["errors"]
        if record["all_found"] and (errors["found"] < errors["of"] or errors["spurious"]):
            yield f"{record['key']}: found {errors['found']} of {errors['of']}, and {errors['spurious']} that are none"
        elif errors["worst"] is not None and not errors["worst"] <= record["limit"]:
            yield f"{record['key']}: error {errors['worst']:.1e} is beyond its limit {record['limit']:.0e}"
