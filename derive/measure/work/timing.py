"""Times of calls, interleaved with those of a base method, so that both meet the same machine."""

from __future__ import annotations

import gc
import time
import tracemalloc
from collections.abc import Callable, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from statistics import median
from typing import Any

SHORTEST = 2e-3  # seconds: what is faster is run several times in a row
FEWEST, MOST = 3, 15
LONG = 3.0  # budgets


@dataclass(frozen=True)
class Times:
    """Median and spread over runs, in seconds."""

    median: float
    low: float
    high: float
    runs: int

    @classmethod
    def of(cls, seconds: Sequence[float]) -> Times:
        """From single times."""
        return cls(median(seconds), min(seconds), max(seconds), len(seconds))


@contextmanager
def quiet() -> Any:
    """No garbage is collected while the clock runs."""
    on = gc.isenabled()
    gc.collect()
    gc.disable()
    try:
        yield
    finally:
        if on:
            gc.enable()


def once(call: Callable[[], Any], repeats: int) -> float:
    """Seconds for one call, over some in a row."""
    start = time.perf_counter()
    for _ in range(repeats):
        call()
    return (time.perf_counter() - start) / repeats


def repeats_for(seconds: float) -> int:
    """How many calls in a row a clock tells well."""
    return max(1, min(1000, round(SHORTEST / max(seconds, 1e-9))))


def interleaved(
    calls: Sequence[Callable[[], Any]], budget: float, fewest: int = FEWEST, most: int = MOST
) -> list[list[float]]:
    """Times of several calls in turn, until the budget of seconds is spent; each was called before, and is warm."""
    with quiet():
        start = time.perf_counter()
        first = [once(call, 1) for call in calls]
        repeats = [repeats_for(seconds) for seconds in first]
        slow = sum(first) > LONG * budget  # so slow that one run must do
        times: list[list[float]] = [[seconds] if slow else [] for seconds in first]
        while not slow and (len(times[0]) < fewest or (len(times[0]) < most and time.perf_counter() - start < budget)):
            for call, number, row in zip(calls, repeats, times, strict=True):
                row.append(once(call, number))
    return times


def peak_memory(call: Callable[[], Any]) -> int:
    """The most bytes that Python and NumPy hold at once during a call, beyond what they hold before."""
    running = tracemalloc.is_tracing()
    if not running:
        tracemalloc.start()
    try:
        tracemalloc.reset_peak()
        before = tracemalloc.get_traced_memory()[0]
        call()
        return max(0, tracemalloc.get_traced_memory()[1] - before)
    finally:
        if not running:
            tracemalloc.stop()
