"""Families of records, and how one is added.

A family is a module with

    PARTS               what --only calls its parts, with their titles
    jobs(plan)          all its jobs for the parts that are wanted, in order; what it computes is kept in plan.cache
    document(records)   its section of the tables, as lines of Markdown
    wrong(records)      a line for each record that is out of bounds, beginning with its key

and a line in FAMILIES, which is all that adds it. A job's key begins with the name of its family and a slash; its work
gives a record: plain data for JSON, the same to the digit whenever it is run, but for times. Each record is kept when
it is made, and a run that is broken off goes on after the last one. Pictures are drawn by the module that
`derive.commands_measure.PICTURES` has for the family: pictures(records, kind) gives names and bytes of files.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field
from importlib import import_module
from types import ModuleType
from typing import Any, Protocol, cast

from derive.cache import Cache

Record = dict[str, Any]
FAMILIES = {
    "tasks": "derive.measure.bench.precision",
    "growth": "derive.measure.bench.growth",
    "atlas": "derive.measure.bench.atlas",
    "stability": "derive.measure.bench.stability",
}
BUDGET, QUICK_BUDGET = 2.0, 0.02  # seconds for the times of one job, where they allow it


@dataclass(frozen=True)
class Plan:
    """What a run is asked for. only: parts, all if empty. emitted: modules that no shipped scene gives, by name."""

    cache: Cache
    quick: bool = False
    only: tuple[str, ...] = ()
    emitted: Callable[[str], ModuleType] | None = None
    say: Callable[[str], None] = field(default=lambda _: None)

    def wants(self, part: str) -> bool:
        """Whether a part is asked for."""
        return not self.only or part in self.only

    @property
    def budget(self) -> float:
        """Seconds for the times of a job."""
        return QUICK_BUDGET if self.quick else BUDGET


@dataclass(frozen=True)
class Job:
    """One record to be made."""

    key: str
    work: Callable[[], Record]


class Family(Protocol):
    """What a family's module has."""

    PARTS: Mapping[str, str]

    def jobs(self, plan: Plan) -> Iterator[Job]:
        """All that is to be done."""

    def document(self, records: list[Record]) -> list[str]:
        """Lines of Markdown."""

    def wrong(self, records: list[Record]) -> Iterator[str]:
        """Records out of bounds."""


def families() -> dict[str, Family]:
    """All families by name."""
    return {name: cast(Family, import_module(place)) for name, place in FAMILIES.items()}


def parts() -> dict[str, str]:
    """All that --only may name, with titles."""
    return {part: title for family in families().values() for part, title in family.PARTS.items()}
