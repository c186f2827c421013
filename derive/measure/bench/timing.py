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
LONG, LEAST_LONG = 1.5, 0.1  # budgets, and seconds: what takes longer is run once more, or not at all
COLD = 1.0  # seconds above which a first call counts: what it imports is little beside that


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
    """Whether a call takes so long that one run must do."""
    return seconds > max(LONG * budget, LEAST_LONG)


def warmed(call: Callable[[], Any]) -> tuple[Any, float]:
    """What the first call gives, and the seconds of a warm one."""
    start = time.perf_counter()
    found = call()
    seconds = time.perf_counter() - start
    return found, seconds if seconds > COLD else once(call)


def interleaved(
    call: Callable[[], Any], beside: Callable[[], Any], budget: float
) -> tuple[Any, list[float], list[float]]:
    """What the first call gives; times of later ones, and of the other call in turn, until the budget is spent."""
    with quiet():
        found, seconds = warmed(call)
        pairs = (call, seconds), (beside, warmed(beside)[1])
        if any(is_long(size, budget) for _, size in pairs):
            own, other = ([size] if is_long(size, budget) else [once(one, repeats_for(size))] for one, size in pairs)
            return found, own, other
        times: tuple[list[float], list[float]] = ([], [])
        start = time.perf_counter()
        while len(times[0]) < FEWEST or (len(times[0]) < MOST and time.perf_counter() - start < budget):
            for (one, size), row in zip(pairs, times, strict=True):
                row.append(once(one, repeats_for(size)))
    return found, *times


def alone(call: Callable[[], Any], budget: float) -> tuple[Any, list[float]]:
    """The same for one call."""
    found, times, _ = interleaved(call, lambda: None, budget)
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
