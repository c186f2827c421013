"""Two runs of `derive measure` beside each other: errors must be the same to the digit, times within their spreads.

python -m derive.measure.bench.again FOLDER OTHER

Everything in a record but times and memory is compared, and the exit code is 1 if something differs. Of times, which
depend on what else the machine does, it is told how many medians of the second run lie within the spread (the least to
the most) of the first, how many spreads overlap, and which median changed most.
"""

from __future__ import annotations

import json
import sys
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

from derive.measure.bench.families import Record
from derive.measure.bench.store import FILE, StoreError

# What a clock or a counter of memory says; a method's number of runs is the clock's too.
MEASURED = {"seconds", "base_seconds", "ratio", "bytes"}


def records_of(folder: Path) -> dict[str, Record]:
    """The records of a run by their keys; StoreError if the folder has none."""
    path = folder / FILE
    try:
        _, *lines = path.read_text(encoding="utf-8").splitlines()
        records = [json.loads(line) for line in lines]
        return {record["key"]: record for record in records}
    except (OSError, ValueError, KeyError, TypeError) as error:
        raise StoreError(f"{path}: holds no records of a run; give the folders of two") from error


def fixed(data: Any) -> Any:
    """A record without what is measured by a clock."""
    if isinstance(data, Mapping):
        return {name: fixed(value) for name, value in data.items() if name not in MEASURED}
    return [fixed(value) for value in data] if isinstance(data, list) else data


def changed(first: Mapping[str, Record], second: Mapping[str, Record]) -> list[str]:
    """Records of both runs that differ in more than times, with what differs."""
    lines = []
    for key in first:
        if key in second and (was := fixed(first[key])) != (now := fixed(second[key])):
            names = [name for name in was | now if was.get(name) != now.get(name)]
            lines.append(f"{key}: {', '.join(f'{name} was {was.get(name)}, is {now.get(name)}' for name in names)}")
    return lines


def spreads(first: Mapping[str, Record], second: Mapping[str, Record]) -> Iterator[tuple[str, Any, Any]]:
    """Times of both runs, of all that ran more than once in both."""
    for key in first:
        pair = [records[key].get("seconds") for records in (first, second) if key in records]
        if len(pair) == 2 and all(isinstance(one, Mapping) and one["runs"] > 1 for one in pair):
            yield key, pair[0], pair[1]


def about_times(first: Mapping[str, Record], second: Mapping[str, Record]) -> str:
    """How many agree, and the greatest change."""
    rows = list(spreads(first, second))
    if not rows:
        return "no time was measured more than once in both"
    within = sum(a["low"] <= b["median"] <= a["high"] for _, a, b in rows)
    overlap = sum(a["low"] <= b["high"] and b["low"] <= a["high"] for _, a, b in rows)
    by, key = max((max(b["median"] / a["median"], a["median"] / b["median"]), key) for key, a, b in rows)
    return (
        f"of {len(rows)} times {within} are within the spread of the first run, {overlap} spreads overlap; "
        f"the greatest change of a median is {by:.2f}× ({key})"
    )


def main(argv: Sequence[str] | None = None) -> int:
    """0 if nothing but times differs, 1 if something does, 2 for a mistake."""
    given = list(sys.argv[1:] if argv is None else argv)
    if len(given) != 2 or given[0].startswith("-"):
        print("usage: python -m derive.measure.bench.again FOLDER OTHER", file=sys.stderr)
        return 2
    try:
        first, second = (records_of(Path(folder)) for folder in given)
    except StoreError as error:
        print(f"derive.measure.bench.again: {error}", file=sys.stderr)
        return 2
    shared, lines = first.keys() & second.keys(), changed(first, second)
    alone = len(first.keys() ^ second.keys())
    print(f"{len(shared)} records in both, {alone} in one alone; {len(lines)} differ in more than times")
    print(about_times(first, second))
    for line in lines:
        print(line, file=sys.stderr)
    return 0 if shared and not lines else 1


if __name__ == "__main__":
    raise SystemExit(main())
