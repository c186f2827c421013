"""What was measured, as tables and pictures: the data of `derive measure --json`, family by family.

Errors against run time have a picture for each problem, the extremes one for each map. A family that is not known here
is shown as a plain table of its numbers and words, so that nothing that was measured is left out.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from markupsafe import Markup

from derive.measure.bench import atlas as extremes
from derive.measure.bench import growth as growing
from derive.measure.bench import stability as searches
from derive.measure.bench import tables
from derive.measure.bench.cells import OURS
from derive.measure.bench.families import Record
from derive.report.page.chart import Point, chart
from derive.report.page.heat import heat

COLUMNS = ("method", "setting", "worst error", "found", "time", "from … to", "over ours")


def measured(given: Mapping[str, Any] | None) -> dict[str, Any] | None:
    """Where it was measured, tables, and what broke; KeyError or TypeError for other data."""
    if given is None:
        return None
    about, found = given["about"], list[dict[str, Any]]()
    for family, records in given["records"].items():
        way = WAYS.get(family)
        found += (way(records) if way else plain(family, records)) if records else []
    machine = ", ".join(f"{name} {value}" for name, value in about["machine"].items())
    versions = ", ".join(f"{name} {number}" for name, number in about["versions"].items())
    quick = about["mode"] == "quick"
    return {
        "about": f"{machine}; {versions}; commit {about['commit']}",
        "quick": quick,
        "tables": found,
        "failed": [f"{key}: {reason}" for key, reason in given["failed"].items()],
    }


def tasks(records: Sequence[Record]) -> list[dict[str, Any]]:
    """For each problem a picture and a table of error, what was found, and time."""
    found = []
    for problem in dict.fromkeys(one["problem"] for one in records):
        rows = [one for one in records if one["problem"] == problem]
        points = [p for one in rows if (p := point(one))]
        drawn = chart(points, f"seconds a {rows[0]['unit']}", "worst error")
        found.append(table(f"{problem}: {rows[0]['title']}", COLUMNS, [cells(one) for one in rows], drawn))
    return found


def point(record: Record) -> Point | None:
    """The place of a record in the picture, if it has an error that is not zero."""
    error, time = record["errors"]["worst"], record["seconds"]["median"]
    label = f"{record['method']}, {record['setting']}: error {tables.error(error)}, {tables.seconds(time)}"
    return Point(record["method"], time, error, label, record["group"] == OURS) if error else None


def cells(record: Record) -> list[str]:
    """One row."""
    return [
        record["method"],
        tables.shown_setting(record),
        tables.error(record["errors"]["worst"]),
        tables.found(record),
        tables.seconds(record["seconds"]["median"]),
        tables.spread(record),
        tables.ratio(record["ratio"]["median"]),
    ]


def growth(records: Sequence[Record]) -> list[dict[str, Any]]:
    """How time and memory grow, with the exponents that are seen."""
    return [table("How time and memory grow", growing.HEAD, growing.rows(records))]


def atlas(records: Sequence[Record]) -> list[dict[str, Any]]:
    """A picture for each map, with what each solver does on it."""
    found = []
    for name in dict.fromkeys(one["map"] for one in records):
        here = [one for one in records if one["map"] == name]
        found.append(table(f"Extremes: {here[0]['title']}", extremes.HEAD, extremes.rows(here), heat(here)))
    return found


def stability(records: Sequence[Record]) -> list[dict[str, Any]]:
    """What each formula loses at its worst input."""
    return [table("Stability of the formulas", searches.HEAD, searches.rows(records))]


def table(
    title: str, columns: Sequence[str], rows: Sequence[Sequence[str]], picture: Markup | str = ""
) -> dict[str, Any]:
    """What the template shows."""
    return {"title": title, "picture": picture, "columns": columns, "rows": rows}


def plain(family: str, records: Sequence[Record]) -> list[dict[str, Any]]:
    """Any other family: the numbers and words of its records, those of inner records beside their names."""
    flat = [flattened(one) for one in records]
    columns = list(dict.fromkeys(name for one in flat for name in one))
    return [table(family.capitalize(), columns, [[shown(one.get(name)) for name in columns] for one in flat])]


def flattened(record: Record) -> dict[str, Any]:
    """A record without inner records."""
    found: dict[str, Any] = {}
    for name, value in record.items():
        inner = value.items() if isinstance(value, Mapping) else [("", value)]
        found |= {f"{name} {key}".strip(): item for key, item in inner}
    return found


def shown(value: Any) -> str:
    """A number to four digits; words as they are."""
    return "–" if value is None else f"{value:.4g}" if isinstance(value, float) else str(value)


WAYS = {"tasks": tasks, "growth": growth, "atlas": atlas, "stability": stability}
