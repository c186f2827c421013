"""The methods, a file for each or for a few of a kind: METHODS, and at the head of the file how they are set up.

The first that does a task is the base of its ratios. None is imported unless something is measured, and none of what
others made is imported by a file that can do without it.
"""

from __future__ import annotations

from collections.abc import Iterator
from importlib import import_module

from derive.measure.bench.cells import Method

FILES = (
    "emitted",
    "at_once",
    "article",
    "function_forms",
    "quartic_forms",
    "bvp",
    "shooting",
    "chebyshev",
    "discrete",
    "special",
    "arb",
    "outside",
)


def methods() -> Iterator[Method]:
    """All methods, in the order of the tables."""
    for name in FILES:
        yield from import_module(f"derive.measure.bench.methods.{name}").METHODS
