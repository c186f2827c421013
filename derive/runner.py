"""Runs tasks through the cache, and those that are missing on all cores.

The theory is derived once, before the processes fork.
"""

from __future__ import annotations

import multiprocessing
import os
import signal
import sys
from collections.abc import Callable, Iterable, Sequence
from concurrent.futures import ProcessPoolExecutor, as_completed
from dataclasses import dataclass, field
from typing import Any

from derive.cache import Cache, reading_once
from derive.stages import Task

Progress = Callable[[int, int, str], None]


def silent(done: int, total: int, label: str) -> None:
    """Show nothing."""


@dataclass
class Runner:
    """Runs tasks through the cache, on several processes if that pays."""

    cache: Cache = field(default_factory=Cache)
    jobs: int = 0
    progress: Progress = silent

    def results(self, tasks: Sequence[Task], prepare: Callable[[], Any] | None = None) -> list[Any]:
        """The results of all tasks, in their order. prepare runs once before the first process starts."""
        with reading_once():
            keys = [task.key for task in tasks]
        found: dict[str, Any] = {key: self.cache.get(key) for key in keys}
        missing = {key: task for key, task in zip(keys, tasks, strict=True) if found[key] is None}
        if missing:
            if prepare:
                self.progress(0, len(missing), "derivation")
                prepare()
            for count, (key, result) in enumerate(self._compute(missing), start=1):
                found[key] = result
                if not timed_out(result):
                    self.cache.put(key, result)
                self.progress(count, len(missing), missing[key].label)
        return [found[key] for key in keys]

    def result(self, task: Task) -> Any:
        """The result of one task."""
        return self.results([task])[0]

    def _compute(self, tasks: dict[str, Task]) -> Iterable[tuple[str, Any]]:
        jobs = min(self.jobs or os.cpu_count() or 1, len(tasks))
        if jobs == 1:
            yield from ((key, task.run(*task.inputs)) for key, task in tasks.items())
            return
        method = "fork" if sys.platform == "linux" else "spawn"
        context = multiprocessing.get_context(method)
        with ProcessPoolExecutor(jobs, mp_context=context, initializer=die_when_interrupted) as pool:
            futures = {pool.submit(task.run, *task.inputs): key for key, task in tasks.items()}
            try:
                for future in as_completed(futures):
                    yield futures[future], future.result()
            except BaseException:
                pool.shutdown(wait=False, cancel_futures=True)
                for child in multiprocessing.active_children():
                    child.terminate()
                raise


def timed_out(result: Any) -> bool:
    """Whether a verdict only says that the time was up; on another day the same machine may do better."""
    return isinstance(result, dict) and str(result.get("reason", "")).startswith("no proof in ")


def die_when_interrupted() -> None:
    """In a worker: end at once, and without a word, when the user interrupts."""
    signal.signal(signal.SIGINT, signal.SIG_DFL)
