"""One thing that is measured: a method with a setting on a problem, its base, and its record."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import asdict, dataclass
from typing import Any

from derive.measure.work.problems import Problem
from derive.measure.work.timing import Times, interleaved

OURS, ARTICLE, PEER = "ours", "article", "peer"


@dataclass(frozen=True)
class Cell:
    """prepare: makes the call that is timed. answers: from what it gives to what is judged, outside the time.

    units: how many rods, points or folds the call does, where these are not the problem's. whole: it does all that the
    task asks; what does a part is shown, and is on no front.
    """

    problem: Problem
    method: str
    setting: str
    group: str
    prepare: Callable[[], Callable[[], Any]]
    answers: Callable[[Any], Any] = lambda found: found
    units: int = 0
    base: bool = False
    whole: bool = True

    @property
    def key(self) -> str:
        """Its name among the records."""
        return f"{self.problem.id}/{self.method}/{self.setting}"

    @property
    def size(self) -> int:
        """Units that one call does."""
        return self.units or self.problem.units


def measure(cell: Cell, base: Cell, budget: float) -> dict[str, Any]:
    """The record: errors of the first call, times of later ones, beside those of the base in turn."""
    call = cell.prepare()
    try:
        errors = cell.problem.judge(cell.answers(call()))
        other = base.prepare()
        other()
        own, beside = interleaved([call, other], budget)
    finally:
        if close := getattr(call, "close", None):
            close()
    each, base_each = [t / cell.size for t in own], [t / base.size for t in beside]
    ratios = [a / b for a, b in zip(each, base_each, strict=True)]
    return {
        **names(cell),
        "errors": errors.to_json(),
        "seconds": asdict(Times.of(each)),
        "base": {"method": base.method, "setting": base.setting, "seconds": asdict(Times.of(base_each))},
        "ratio": asdict(Times.of(ratios)),
    }


def names(cell: Cell) -> dict[str, Any]:
    """What says which cell a record is of."""
    problem = cell.problem
    return {
        "problem": problem.id,
        "task": problem.task,
        "title": problem.title,
        "method": cell.method,
        "setting": cell.setting,
        "group": cell.group,
        "unit": problem.unit,
        "units": cell.size,
        "whole": cell.whole,
    }
