"""Records of error against run time as Markdown, and the rows of the README."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from derive.measure.bench.families import Record
from derive.measure.bench.fronts import at_once, comparable, front, wins

PREFACE = (
    "Errors are against references of 40 digits or more, in natural sizes: angles in radians, places over the length, "
    "values and η relative to themselves. Times are medians of warm runs, with the least and the most; one alone where "
    "a run is long. “Over ours” is the ratio to the first row, run in turn with it; • is on the front of those that "
    "do the whole task and find all. What solves many rods at once has the time of one of them, and is on no front: it "
    "is for who has many."
)
UNITS = ((1.0, "s"), (1e-3, "ms"), (1e-6, "µs"), (1e-9, "ns"))
HEAD = "| method | setting | worst error | median | found | time a {unit} | spread | over ours | front |"
# The README's rows: problem, method and how its setting begins; "*" is the most accurate setting.
README_ROWS = (
    ("T1", "emitted, NumPy", "parallel, stable"),
    ("T1", "emitted, NumPy, in a sweep", "1,000 rods at once"),
    ("T1", "solve_bvp", "tol 1e-8"),
    ("T1", "solve_bvp", "tol 1e-10"),
    ("T1", "Chebyshev", "*"),
    ("T1", "SciPy R_F, R_J, ellipj", "*"),
    ("T2-parallel", "emitted, NumPy", "parallel"),
    ("T2-parallel", "solve_bvp", "tol 1e-8"),
    ("T3-1e6", "emitted, NumPy", "θ, y, z"),
    ("T3-1e6", "article, NumPy", "*"),
    ("T3-1e6", "SciPy ellipj", "*"),
    ("T4", "emitted, NumPy", "bifurcation"),
    ("T4", "solve_bvp", "tol 1e-8"),
    ("T6", "emitted, NumPy", "all in a range"),
    ("T6", "solve_bvp", "tol 1e-8"),
)


def markdown(head: Sequence[str], rows: Iterable[Sequence[str]]) -> list[str]:
    """A table as lines."""
    return [f"| {' | '.join(head)} |", "|---" * len(head) + "|", *(f"| {' | '.join(row)} |" for row in rows)]


def seconds(value: float) -> str:
    """A time with its unit, to three digits."""
    size, name = next(((size, name) for size, name in UNITS if value >= size), UNITS[-1])
    number = value / size
    return f"{number:,.0f} {name}" if number >= 999.5 else f"{number:.3g} {name}"


def error(value: float | None) -> str:
    """An error to one digit."""
    return "–" if value is None else f"{value:.0e}"


def ratio(value: float) -> str:
    """A ratio to two digits, or whole."""
    return f"{value:,.0f}" if value >= 99.5 else f"{value:.2g}"


def found(record: Record) -> str:
    """How much of what there is, and what is none."""
    errors = record["errors"]
    extra = f", {errors['spurious']} more" if errors["spurious"] else ""
    return "–" if errors["worst"] is None and not record["whole"] else f"{errors['found']} of {errors['of']}{extra}"


def spread(record: Record) -> str:
    """From the least time to the most."""
    time = record["seconds"]
    return f"{seconds(time['low'])} … {seconds(time['high'])}" if time["runs"] > 1 else "one run"


def shown_setting(record: Record) -> str:
    """With what is told of it besides."""
    part = "" if record["whole"] else " (in part)"
    scaled = "" if record["share"] >= 1 or record["unit"] == "point" else f" ({100 * record['share']:.2g} %, scaled)"
    return f"{record['setting']}{part}{scaled}"


def section(records: Sequence[Record], note: str) -> list[str]:
    """A problem: who is given what, all methods, and what others do better."""
    title = f"## {records[0]['problem']}: {records[0]['title']}"
    best = {record["key"] for record in front(records)}
    lines = [title, "", note, "", HEAD.format(unit=records[0]["unit"]), "|---" * 9 + "|"]
    for record in records:
        errors = record["errors"]
        cells = (
            record["method"],
            shown_setting(record),
            error(errors["worst"]),
            error(errors["median"]),
            found(record),
            seconds(record["seconds"]["median"]),
            spread(record),
            ratio(record["ratio"]["median"]),
            "•" if record["key"] in best else "",
        )
        lines.append("| " + " | ".join(cells) + " |")
    return [
        *lines,
        "",
        *([f"- {line}" for line in wins(records)] or ["No method of others is faster or more accurate."]),
    ]


def readme_rows(records: Sequence[Record]) -> tuple[list[str], list[str]]:
    """The README's table, and which of its rows have no record. “Over ours” is over the first row of the task."""
    lines = ["| task | method | worst error | found | time | over ours |", "|---" * 6 + "|"]
    missing, before, base = [], "", 1.0
    for problem, method, setting in README_ROWS:
        rows = [r for r in records if (r["problem"], r["method"]) == (problem, method)]
        rows = [r for r in rows if setting == "*" or r["setting"].startswith(setting)]
        if not rows:
            missing.append(f"{problem}/{method}/{setting}")
            continue
        row = min(rows, key=lambda r: (not (comparable(r) or at_once(r)), r["errors"]["worst"] or 1.0))
        title = "" if row["title"] == before else row["title"]
        base, before = row["ratio"]["median"] if title else base, row["title"]
        time = f"{seconds(row['seconds']['median'])} a {row['unit']}"
        cells = (title, f"{method}, {row['setting']}", error(row["errors"]["worst"]), found(row), time)
        lines.append("| " + " | ".join((*cells, ratio(row["ratio"]["median"] / base))) + " |")
    return lines, missing
