"""What is made of a theory once, and asked for again and again."""

from __future__ import annotations

from collections.abc import Callable
from functools import wraps
from typing import Any, TypeVar

T = TypeVar("T")


def remembered(make: Callable[[Any], T]) -> Callable[[Any], T]:
    """The function, its last value kept as long as it is asked for the same object."""
    last: list[tuple[Any, T]] = []

    @wraps(make)
    def again(source: Any) -> T:
        if not last or last[0][0] is not source:
            last[:] = [(source, make(source))]
        return last[0][1]

    return again
