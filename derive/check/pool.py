"""A map over processes that falls back to this one: for few tasks, and where processes cannot be had."""

from __future__ import annotations

import multiprocessing
import pickle
import threading
from collections.abc import Callable, Sequence
from concurrent.futures import ProcessPoolExecutor, as_completed
from concurrent.futures.process import BrokenProcessPool
from contextlib import suppress
from typing import Any


def mapped(
    function: Callable[..., Any],
    tasks: Sequence[tuple[Any, ...]],
    jobs: int,
    progress: Callable[[Any], Any] | None = None,
) -> list[Any]:
    """[function(*task) for task in tasks], in order; progress(result) is called as results come."""
    done: dict[int, Any] = {}
    if jobs > 1 and len(tasks) > 3:
        with suppress(OSError, BrokenProcessPool, pickle.PicklingError, AttributeError, ImportError):
            _in_processes(function, tasks, jobs, progress, done)  # what is missing after it is done here
    for k, task in enumerate(tasks):
        if k not in done:
            done[k] = function(*task)
            if progress:
                progress(done[k])
    return [done[k] for k in range(len(tasks))]


def _in_processes(
    function: Callable[..., Any],
    tasks: Sequence[tuple[Any, ...]],
    jobs: int,
    progress: Callable[[Any], Any] | None,
    done: dict[int, Any],
) -> None:
    # A fork is cheap but must not happen beside other threads.
    methods = multiprocessing.get_all_start_methods()
    forkable = "fork" in methods and threading.active_count() == 1
    context = multiprocessing.get_context("fork" if forkable else "spawn")
    with ProcessPoolExecutor(jobs, mp_context=context) as executor:
        futures = {executor.submit(function, *task): k for k, task in enumerate(tasks)}
        for future in as_completed(futures):
            done[futures[future]] = future.result()
            if progress:
                progress(done[futures[future]])
