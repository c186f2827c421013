"""What is measured: a method, with a setting, on a problem."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import asdict, dataclass, field
from typing import Any

from derive.measure.bench.families import Plan, Record
from derive.measure.bench.judged import Errors
from derive.measure.bench.timing import Times, interleaved

OURS, ARTICLE, VARIANT, PEER = "ours", "article", "variant", "peer"
Call = Callable[[], Any]


@dataclass(frozen=True)
class Problem:
    """What a method is given, and how its answers are judged. units: rods, points or folds; times are for each.

    brief: too much for every setting of every method; each takes the settings of a quick run.
    """

    id: str
    task: str
    title: str
    unit: str
    units: int
    inputs: Any
    judge: Callable[[Any], Errors]
    brief: bool = False


@dataclass(frozen=True)
class Cell:
    """prepare: makes the call that is timed. answers: from what it gives to what is judged, outside the time.

    limit: the worst error that is no fault. share: of the problem's units that the call does; above 1 where each is
    solved at once with many others: the time is for one, and is on no front of calls for one. whole: it does all that
    the task asks; what does a part is shown, and is on no front. all_found: it must find all there is.
    """

    setting: str
    prepare: Callable[[], Call]
    limit: float
    answers: Callable[[Any], Any] = field(default=lambda found: found)
    share: float = 1.0
    whole: bool = True
    all_found: bool = False


@dataclass(frozen=True)
class Method:
    """A way to do tasks: ``cells`` gives its settings on a problem, none if the task is not for it.

    needs: packages by the names they are imported by, without which it is left out.
    """

    name: str
    group: str
    cells: Callable[[Problem, Plan], Iterator[Cell]]
    needs: tuple[str, ...] = ()


def key_of(problem: Problem, method: Method, cell: Cell) -> str:
    """The name of a record."""
    return f"tasks/{problem.id}/{method.name}/{cell.setting}"


def measure(problem: Problem, method: Method, cell: Cell, base: Cell, budget: float) -> Record:
    """The record: errors of the first call, times of later ones beside those of the base in turn."""
    call, beside = cell.prepare(), base.prepare()
    try:
        answers, own, other = interleaved(call, beside, budget)
    finally:
        if close := getattr(call, "close", None):
            close()
    errors = problem.judge(cell.answers(answers))
    each = [seconds / (cell.share * problem.units) for seconds in own]
    base_each = [seconds / (base.share * problem.units) for seconds in other]
    return {
        "problem": problem.id,
        "task": problem.task,
        "title": problem.title,
        "unit": problem.unit,
        "units": problem.units,
        "method": method.name,
        "group": method.group,
        "setting": cell.setting,
        "share": cell.share,
        "whole": cell.whole,
        "all_found": cell.all_found,
        "limit": cell.limit,
        "errors": asdict(errors),
        "seconds": asdict(Times.of(each)),
        "base_seconds": asdict(Times.of(base_each)),
        "ratio": asdict(Times.of([a / b for a, b in zip(each, base_each, strict=True)])),
    }
