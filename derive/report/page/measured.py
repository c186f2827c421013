"""What was measured, as tables and pictures: the data of `derive measure --json`, family by family.

Errors against run time have a picture for each problem. A family that is not known here is shown as a plain table of
its numbers and words, so that nothing that was measured is left out.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from derive.report.page.chart import Point, chart

Record = Mapping[str, Any]
UNITS = ((1.0, "s"), (1e-3, "ms"), (1e-6, "µs"), (1e-9, "ns"))
COLUMNS = ("method", "setting", "worst error", "found", "time", "from … to", "over ours")
OURS = "ours"  # the group of our own solvers


def measured(given: Record | None) -> dict[str, Any] | None:
    """Where it was measured, tables, and what broke; KeyError or TypeError for other data."""
    if given is None:
        return None
    about, found = given["about"], list[dict[str, Any]]()
    for family, records in given["records"].items():
        ways = {"tasks": tasks, "growth": growth}
        found += ways[family](records) if family in ways else [plain(family, records)] if records else []
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
        found.append(
            {
                "title": f"{problem}: {rows[0]['title']}",
                "picture": chart(
                    [p for one in rows if (p := point(one))], f"seconds a {rows[0]['unit']}", "worst error"
                ),
                "columns": COLUMNS,
                "rows": [cells(one) for one in rows],
            }
        )
    return found


def point(record: Record) -> Point | None:
    """The place of a record in the picture, if it has an error that is not zero."""
    error, time = record["errors"]["worst"], record["seconds"]["median"]
    label = f"{record['method']}, {record['setting']}: error {number(error)}, {seconds(time)}"
    return Point(record["method"], time, error, label, record["group"] == OURS) if error else None


def cells(record: Record) -> list[str]:
    """One row."""
    errors, time = record["errors"], record["seconds"]
    more = f", {errors['spurious']} more" if errors["spurious"] else ""
    spread = f"{seconds(time['low'])} … {seconds(time['high'])}" if time["runs"] > 1 else "one run"
    return [
        record["method"],
        record["setting"] + ("" if record["whole"] else " (in part)"),
        number(errors["worst"]),
        f"{errors['found']} of {errors['of']}{more}",
        seconds(time["median"]),
        spread,
        f"{record['ratio']['median']:.2g}",
    ]


def growth(records: Sequence[Record]) -> list[dict[str, Any]]:
    """How time and memory grow."""
    rows = [
        [
            one["series"],
            f"{one['value']} {one['variable']}",
            seconds(one["seconds"]["median"]),
            "–" if one["bytes"] is None else f"{one['bytes'] / 1e6:.3g} MB",
        ]
        for one in records
    ]
    table = {"title": "How time and memory grow", "picture": "", "columns": ("what", "size", "time", "memory")}
    return [{**table, "rows": rows}] if rows else []


def plain(family: str, records: Sequence[Record]) -> dict[str, Any]:
    """Any other family: the numbers and words of its records, those of inner records beside their names."""
    flat = [flattened(one) for one in records]
    columns = list(dict.fromkeys(name for one in flat for name in one))
    rows = [[shown(one.get(name)) for name in columns] for one in flat]
    return {"title": family.capitalize(), "picture": "", "columns": columns, "rows": rows}


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


def number(value: float | None) -> str:
    """An error to one digit."""
    return "–" if value is None else f"{value:.0e}"


def seconds(value: float) -> str:
    """A time with its unit, to three digits."""
    size, name = next(((size, name) for size, name in UNITS if value >= size), UNITS[-1])
    return f"{value / size:.3g} {name}"
