"""A measuring run: every cell that has no record yet is measured and kept."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field
from typing import Any

from derive.cache import Cache
from derive.measure.work import cells, growth
from derive.measure.work.cells import Cell
from derive.measure.work.ours import Modules, own_cells
from derive.measure.work.problems import TASKS, problems
from derive.measure.work.solvers import absent, peer_cells
from derive.measure.work.store import Store

BUDGET, QUICK_BUDGET = 2.5, 0.05  # seconds for the times of one cell, where they allow it
Progress = Callable[[int, int, str], None]
NAMES = (*TASKS, growth.GOES)


@dataclass
class Found:
    """All records of a run. failed: cells that broke, with the reason; left_out: peers that are not installed."""

    about: dict[str, Any]
    records: list[dict[str, Any]] = field(default_factory=list)
    growth: list[dict[str, Any]] = field(default_factory=list)
    failed: dict[str, str] = field(default_factory=dict)
    left_out: list[str] = field(default_factory=list)

    def to_json(self) -> dict[str, Any]:
        """Plain data."""
        exponents = growth.exponents(self.growth)
        return {**vars(self), "exponents": exponents}


def all_cells(cache: Cache, modules: Modules, only: Sequence[str], *, quick: bool) -> list[tuple[Cell, Cell]]:
    """Every cell with its base."""
    found = []
    for problem in problems(cache, [name for name in only if name in TASKS], quick=quick):
        here = [*own_cells(problem, modules, quick=quick)]
        if problem.task != "T5":
            here += peer_cells(problem, quick=quick)
        base = next(cell for cell in here if cell.base)
        found += [(cell, base) for cell in here]
    return found


def run(store: Store, cache: Cache, modules: Modules, only: Sequence[str], *, quick: bool, progress: Progress) -> Found:
    """Measure what has no record; what breaks is named, and measured again by the next run."""
    found = Found(store.about, left_out=[reason for reason in (absent(),) if reason])
    budget = QUICK_BUDGET if quick else BUDGET
    jobs: list[tuple[str, str, Callable[[], dict[str, Any]]]] = []
    progress(0, 0, "references")
    if set(only) != {growth.GOES}:
        jobs += cell_jobs(all_cells(cache, modules, only, quick=quick), budget)
    if not only or growth.GOES in only:
        jobs += growth_jobs(budget, quick=quick)
    for number, (key, kind, work) in enumerate(jobs):
        progress(number, len(jobs), key)
        record = store.get(key)
        if record is None:
            try:
                record = {"key": key, **work()}
            except Exception as error:  # whatever a method raises is a finding about it
                found.failed[key] = f"{type(error).__name__}: {error}"
                continue
            store.put(key, record)
        (found.records if kind == "cell" else found.growth).append(record)
    progress(len(jobs), len(jobs), "done")
    return found


def cell_jobs(pairs: Sequence[tuple[Cell, Cell]], budget: float) -> Iterator[tuple[str, str, Any]]:
    """Of errors and times."""
    for cell, base in pairs:
        yield cell.key, "cell", lambda cell=cell, base=base: cells.measure(cell, base, budget)


def growth_jobs(budget: float, *, quick: bool) -> Iterator[tuple[str, str, Any]]:
    """Of growing work."""
    for step in growth.steps(quick=quick):
        yield step.key, "growth", lambda step=step: growth.measure(step, budget)
