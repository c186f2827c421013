"""Pareto fronts: the ways that no other one beats in both error and time; and where others beat ours."""

from __future__ import annotations

from collections.abc import Sequence

from derive.measure.bench.cells import OURS
from derive.measure.bench.families import Record


def comparable(record: Record) -> bool:
    """Whether it does the whole task by itself, and finds all there is and nothing else."""
    return bool(record["whole"] and complete(record) and not at_once(record))


def complete(record: Record) -> bool:
    """Whether it finds all there is of what it does, and nothing else."""
    errors = record["errors"]
    return errors["worst"] is not None and errors["found"] == errors["of"] and not errors["spurious"]


def at_once(record: Record) -> bool:
    """Whether its time is a share of that of many problems which are solved at once."""
    return bool(record["share"] > 1)


def point(record: Record) -> tuple[float, float]:
    """Seconds for a unit, and the worst error."""
    return float(record["seconds"]["median"]), float(record["errors"]["worst"])


def front(records: Sequence[Record]) -> list[Record]:
    """From the fastest to the most accurate."""
    best: list[Record] = []
    for record in sorted(filter(comparable, records), key=point):
        if not best or point(record)[1] < point(best[-1])[1]:
            best.append(record)
    return best


def wins(records: Sequence[Record]) -> list[str]:
    """What is faster, or more accurate, than our first way: a line for each method of others, with its best setting."""
    base = next((r for r in records if r["group"] == OURS and comparable(r)), None)
    if base is None:
        return []
    seconds, error = point(base)
    lines = []
    others = [r for r in records if r["group"] != OURS and comparable(r)]
    for method in dict.fromkeys(r["method"] for r in others):
        rows = [r for r in others if r["method"] == method]
        faster = [r for r in rows if point(r)[0] < seconds]
        better = [r for r in rows if point(r)[1] < error and r not in faster]
        if faster:
            best = min(faster, key=lambda r: point(r)[1])
            lines.append(
                f"{named(best)} is {seconds / point(best)[0]:.1f}× faster, with an error of {point(best)[1]:.0e}"
            )
        if better:
            best = min(better, key=lambda r: point(r)[0])
            errors = f"{point(best)[1]:.0e} instead of {error:.0e}"
            lines.append(f"{named(best)} errs by {errors}, and is {point(best)[0] / seconds:.1f}× slower")
    return lines


def named(record: Record) -> str:
    """A method with its setting."""
    return f"{record['method']} ({record['setting']})"
