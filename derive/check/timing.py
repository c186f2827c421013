"""A time limit on work in this process, by an alarm; without one where the system or the thread has no alarms."""

from __future__ import annotations

import signal
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any


class TimeLimit(BaseException):
    """The time is up. Not an Exception, so that nothing on the way swallows it."""


@contextmanager
def limited(seconds: float | None) -> Iterator[None]:
    """Raise TimeLimit in the body after so many seconds."""
    usable = hasattr(signal, "setitimer") and threading.current_thread() is threading.main_thread()
    if seconds is None or not usable:
        yield
        return

    def ring(signum: int, frame: Any) -> None:
        raise TimeLimit(f"no proof in {seconds:g} s")

    before = signal.signal(signal.SIGALRM, ring)
    signal.setitimer(signal.ITIMER_REAL, seconds)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)
