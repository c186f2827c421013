"""A measuring run: every job that has no record yet is done, and its record kept."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

from derive.measure.bench.families import Plan, Record, families
from derive.measure.bench.store import Store

Progress = Callable[[int, int, str], None]


@dataclass
class Found:
    """All records of a run by family. failed: jobs that broke, with the reason."""

    about: dict[str, Any]
    records: dict[str, list[Record]] = field(default_factory=dict)
    failed: dict[str, str] = field(default_factory=dict)

    def wrong(self) -> list[str]:
        """A line for all that is out of bounds or broke."""
        all_families = families()
        lines = [line for name, records in self.records.items() for line in all_families[name].wrong(records)]
        return [*lines, *(f"{key}: {reason}" for key, reason in self.failed.items())]

    def document(self) -> str:
        """All tables as Markdown."""
        about, all_families = self.about, families()
        versions = ", ".join(f"{name} {number}" for name, number in about["versions"].items())
        machine = about["machine"]
        lines = [
            "# Error against run time",
            "",
            f"{machine['processor']}, {machine['cores']} cores, {machine['system']}; {versions}; commit "
            f"{about['commit']}; {'a quick run: times say little' if about['mode'] == 'quick' else 'a full run'}.",
        ]
        for name, records in self.records.items():
            if records:
                lines += ["", *all_families[name].document(records)]
        failed = [f"- {key} broke: {reason}" for key, reason in self.failed.items()]
        return "\n".join([*lines, *(["", *failed] if failed else []), ""])

    def to_json(self) -> dict[str, Any]:
        """Plain data."""
        return dict(vars(self))


def run(store: Store, plan: Plan, progress: Progress) -> Found:
    """Do what has no record; what breaks is named, and tried again by the next run."""
    found = Found(store.about)
    todo = []
    for name, family in families().items():
        if any(plan.wants(part) for part in family.PARTS):
            found.records[name] = []
            todo += [(name, job) for job in family.jobs(plan)]
    for number, (name, job) in enumerate(todo):
        progress(number, len(todo), job.key)
        record = store.get(job.key)
        if record is None:
            try:
                record = {"key": job.key, **job.work()}
            except Exception as error:  # whatever a method raises is a finding about it
                found.failed[job.key] = f"{type(error).__name__}: {error}"
                continue
            store.put(record)
        found.records[name].append(record)
    progress(len(todo), len(todo), "done")
    return found
