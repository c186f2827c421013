"""A time limit on work in this process: by an alarm in the main thread, in any other by an exception sent to it.

The alarm counts the processor's time, so that what is found does not depend on how busy a machine is; the other, for
want of a clock that rings, all time. Both come between two steps of the interpreter. One step that takes forever, in
compiled code, is not ended.
"""

from __future__ import annotations

import ctypes
import signal
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

AGAIN = 1.0  # seconds between alarms: one that rings inside a finalizer is swallowed there


class TimeLimit(BaseException):
    """The time is up. Not an Exception, so that nothing on the way swallows it."""


@contextmanager
def limited(seconds: float | None) -> Iterator[None]:
    """Raise TimeLimit in the body after so many seconds."""
    if seconds is None:
        yield
        return
    alarms = hasattr(signal, "setitimer") and threading.current_thread() is threading.main_thread()
    try:
        with _alarm(seconds) if alarms else _message(seconds):
            yield
    except TimeLimit:
        raise TimeLimit(f"no proof in {seconds:g} s") from None


@contextmanager
def _alarm(seconds: float) -> Iterator[None]:
    def ring(signum: int, frame: Any) -> None:
        raise TimeLimit

    before = signal.signal(signal.SIGPROF, ring)
    signal.setitimer(signal.ITIMER_PROF, seconds, AGAIN)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_PROF, 0)
        signal.signal(signal.SIGPROF, before)


@contextmanager
def _message(seconds: float) -> Iterator[None]:
    """A timer's thread sends TimeLimit to this one, unless this one is done."""
    thread, lock, done = ctypes.c_ulong(threading.get_ident()), threading.Lock(), False

    def ring() -> None:
        with lock:
            if not done:
                ctypes.pythonapi.PyThreadState_SetAsyncExc(thread, ctypes.py_object(TimeLimit))

    timer = threading.Timer(seconds, ring)
    timer.daemon = True
    timer.start()
    try:
        yield
    finally:
        with lock:
            done = True
            ctypes.pythonapi.PyThreadState_SetAsyncExc(thread, None)  # sent, but not yet arrived
        timer.cancel()
