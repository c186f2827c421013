"""Times of a call, in turn with those of the base method, so that both meet the same machine."""

from __future__ import annotations

import gc
import time
import tracemalloc
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from statistics import median
from typing import Any

SHORTEST = 2e-3  # seconds: what is faster is run several times in a row
FEWEST, MOST = 3, 15  # runs of a call
LONG, LEAST_LONG = 1.5, 0.1  # budgets, and seconds: what takes longer is run once, and that run is timed


@dataclass(frozen=True)
class Times:
    """Median and spread over runs."""

    median: float
    low: float
    high: float
    runs: int

    @classmethod
    def of(cls, numbers: Sequence[float]) -> Times:
        """From single runs."""
        return cls(median(numbers), min(numbers), max(numbers), len(numbers))


@contextmanager
def quiet() -> Iterator[None]:
    """No garbage is collected while the clock runs."""
    on = gc.isenabled()
    gc.collect()
    gc.disable()
    try:
        yield
    finally:
        if on:
            gc.enable()


def once(call: Callable[[], Any], repeats: int = 1) -> float:
    """Seconds for one call, over some in a row."""
    start = time.perf_counter()
    for _ in range(repeats):
        call()
    return (time.perf_counter() - start) / repeats


def repeats_for(seconds: float) -> int:
    """How many calls in a row a clock tells well."""
    return max(1, min(1000, round(SHORTEST / max(seconds, 1e-9))))


def is_long(seconds: float, budget: float) -> bool:
    """Whether a call takes so long that it is not run again."""
    return seconds > max(LONG * budget, LEAST_LONG)


def first_of(call: Callable[[], Any]) -> tuple[Any, float]:
    """What a call gives, and its seconds."""
    start = time.perf_counter()
    found = call()
    return found, time.perf_counter() - start


def interleaved(
    call: Callable[[], Any], beside: Callable[[], Any], budget: float
) -> tuple[Any, list[float], list[float]]:
    """What the first call gives; times of later ones, and of the other call in turn, until the budget is spent.

    The first calls warm both up; but what takes longer than the budget by far is not run again.
    """
    with quiet():
        found, seconds = first_of(call)
        other = first_of(beside)[1]
        if is_long(max(seconds, other), budget):
            ran = ((call, seconds), (beside, other))
            return found, *([time] if is_long(time, budget) else [once(one, repeats_for(time))] for one, time in ran)
        # Warm, to see how many in a row.
        repeats = [repeats_for(once(one)) for one in (call, beside)]
        start = time.perf_counter()
        times: tuple[list[float], list[float]] = ([], [])
        while len(times[0]) < FEWEST or (len(times[0]) < MOST and time.perf_counter() - start < budget):
            for one, number, row in zip((call, beside), repeats, times, strict=True):
                row.append(once(one, number))
    return found, *times


def alone(call: Callable[[], Any], budget: float) -> tuple[Any, list[float]]:
    """The same for one call."""
    with quiet():
        found, seconds = first_of(call)
        if is_long(seconds, budget):
            return found, [seconds]
        repeats, start, times = repeats_for(once(call)), time.perf_counter(), list[float]()
        while len(times) < FEWEST or (len(times) < MOST and time.perf_counter() - start < budget):
            times.append(once(call, repeats))
    return found, times


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
