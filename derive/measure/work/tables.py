"""The results as Markdown: a table for each problem, measured exponents, and the README's rows."""

from __future__ import annotations

from collections.abc import Sequence

from derive.measure.work.fronts import Record, front, wins
from derive.measure.work.run import Found

UNITS = ((1.0, "s"), (1e-3, "ms"), (1e-6, "µs"), (1e-9, "ns"))
HEAD = "| method | setting | worst error | median | found | time a {unit} | spread | over ours | front |"
# The README's rows, as problem, method, setting; "*" is the most accurate setting.
README_ROWS = (
    ("T1", "emitted, NumPy", "stable ones"),
    ("T1", "solve_bvp", "tol 1e-8"),
    ("T1", "solve_bvp", "tol 1e-10"),
    ("T1", "Chebyshev", "*"),
    ("T1", "SciPy R_F, R_J, ellipj", "*"),
    ("T1", "article's formulas", "*"),
    ("T2", "emitted, NumPy", "all"),
    ("T2", "solve_bvp", "tol 1e-8"),
    ("T2", "Chebyshev", "*"),
    ("T3-1e6", "emitted, NumPy", "θ, y, z"),
    ("T3-1e6", "Chebyshev", "*"),
    ("T3-1e6", "SciPy ellipj alone", "*"),
    ("T4", "kernels on arrays", "all 8,000"),
    ("T4", "solve_bvp", "tol 1e-8"),
    ("T6", "emitted, NumPy", "all in a range"),
    ("T6", "solve_bvp", "tol 1e-8"),
    ("T6", "Chebyshev", "*"),
)


def seconds(value: float) -> str:
    """A time with its unit, to three digits."""
    size, name = next(((size, name) for size, name in UNITS if value >= size), UNITS[-1])
    return f"{value / size:.3g} {name}"


def error(value: float | None) -> str:
    """An error to one digit."""
    return "–" if value is None else f"{value:.0e}"


def found(record: Record) -> str:
    """How much of what there is, and what is none."""
    errors = record["errors"]
    extra = f", {errors['spurious']} more" if errors["spurious"] else ""
    return "–" if errors["worst"] is None else f"{errors['found']} of {errors['of']}{extra}"


def problem_table(records: Sequence[Record]) -> list[str]:
    """All methods on one problem."""
    best = {record["key"] for record in front(records)}
    lines = [HEAD.format(unit=records[0]["unit"]), "|---" * 9 + "|"]
    for record in records:
        time, errors = record["seconds"], record["errors"]
        cells = (
            record["method"],
            record["setting"] if record["whole"] else f"{record['setting']} (in part)",
            error(errors["worst"]),
            error(errors["median"]),
            found(record),
            seconds(time["median"]),
            f"{seconds(time['low'])} … {seconds(time['high'])}",
            f"{record['ratio']['median']:.3g}",
            "•" if record["key"] in best else "",
        )
        lines.append("| " + " | ".join(cells) + " |")
    return lines


def document(result: Found) -> str:
    """All tables, with what peers do better."""
    about = result.about
    versions = ", ".join(f"{name} {number}" for name, number in about["versions"].items() if number != "absent")
    machine = about["machine"]
    lines = [
        "# Error against run time",
        "",
        f"{machine['processor']}, {machine['cores']} cores; {versions}; commit {about['commit']}.",
        "Errors are against references of 40 digits or more, in natural sizes; times are medians of warm runs, with "
        "the least and the most. “Over ours” is the ratio to the first row, run in turn with it. • is on the front.",
    ]
    for problem in dict.fromkeys(record["problem"] for record in result.records):
        rows = [record for record in result.records if record["problem"] == problem]
        lines += ["", f"## {problem}: {rows[0]['title']}", "", *problem_table(rows), ""]
        lines += [f"- {line}" for line in wins(rows)] or ["No other method is faster, or more accurate, than ours."]
    if result.growth:
        lines += ["", "## Cost as work grows", "", *growth_table(result)]
    return "\n".join([*lines, *(f"\n{key} failed: {reason}" for key, reason in result.failed.items()), ""])


def growth_table(result: Found) -> list[str]:
    """The measured exponents."""
    lines = ["| what | work | from … to | time | time grows as | memory | memory grows as |", "|---" * 7 + "|"]
    for row in result.to_json()["exponents"]:
        what, memory = row["variable"], [f"{number / 1e6:.3g} MB" for number in row["bytes"]]
        cells = (
            row["series"],
            what,
            f"{row['from']:g} … {row['to']:g}",
            " … ".join(seconds(value) for value in row["seconds"]),
            f"{what}^{row['time']:.2f}",
            " … ".join(memory),
            f"{what}^{row['memory']:.2f}",
        )
        lines.append("| " + " | ".join(cells) + " |")
    return [*lines, "", "Exponents by least squares on logarithms over the upper half of each series."]


def readme_rows(records: Sequence[Record]) -> tuple[list[str], list[str]]:
    """The README's table, and what has no record for it."""
    lines = ["| task | method | worst error | found | time | over ours |", "|---" * 6 + "|"]
    missing, task = [], ""
    for problem, method, setting in README_ROWS:
        rows = [
            r for r in records if (r["problem"], r["method"]) == (problem, method) and setting in ("*", r["setting"])
        ]
        if not rows:
            missing.append(f"{problem}/{method}")
            continue
        row = min(rows, key=lambda r: (r["errors"]["found"] < r["errors"]["of"], r["errors"]["worst"] or 1.0))
        name = row["method"] if row["setting"] in ("–", "all", "stable ones") else f"{row['method']}, {row['setting']}"
        time = f"{seconds(row['seconds']['median'])} a {row['unit']}"
        title = row["title"] if row["title"] != task else ""
        task = row["title"]
        cells = (title, name, error(row["errors"]["worst"]), found(row), time, f"{row['ratio']['median']:.3g}")
        lines.append("| " + " | ".join(cells) + " |")
    return lines, missing
