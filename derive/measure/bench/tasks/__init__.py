"""The tasks, a file for each: TITLE, NOTE (who is given what), and problems(plan): inputs, and references to judge by.

A guess is what a user knows: the tip angle to one decimal, η at a fold to two digits. Methods that need none are given
none. References are kept in the cache, for they cost most.
"""

from __future__ import annotations

from collections.abc import Iterator
from importlib import import_module
from types import ModuleType

from derive.measure.bench.cells import Problem
from derive.measure.bench.families import Plan

TASKS = {
    "T1": "one",
    "T2": "every",
    "T3": "shapes",
    "T4": "diagram",
    "T5": "functions",
    "T6": "fold",
    "V": "forms",
}
SEED = 5
# T1's and T5's references have more digits than the twin is asked for.
MOST_DIGITS = 210


def module_of(task: str) -> ModuleType:
    """The module of a task."""
    return import_module(f"derive.measure.bench.tasks.{TASKS[task]}")


def problems(plan: Plan) -> Iterator[Problem]:
    """All problems of the tasks that are wanted."""
    for task in TASKS:
        if plan.wants(task):
            plan.say(f"references of {task}")
            yield from module_of(task).problems(plan)
