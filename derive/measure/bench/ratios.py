"""How many times faster than the others ours is, and by how many digits more accurate: the others that are asked for.

Every method runs in turn with the base alone, so a ratio of two others is the quotient of their ratios to the base.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from math import inf, log10

from derive.measure.bench import tables
from derive.measure.bench.cells import OURS
from derive.measure.bench.families import Record
from derive.measure.bench.fronts import at_once, comparable, complete

# Method and setting, None for the one with the least error.
OTHERS = (
    ("solve_bvp", "tol 1e-8"),
    ("solve_bvp", "tol 1e-10"),
    ("Chebyshev", None),
    ("SciPy R_F, R_J, ellipj", None),
    ("SciPy ellipj", None),
    ("article, NumPy", None),
)
HEAD = ("ours", "other", "times faster", "worst errors", "digits more", "median errors", "digits more", "found")


def section(records: Sequence[Record]) -> list[str]:
    """The table with its heading; nothing if there is none of these others."""
    rows = table(records)
    text = "Below 1, the other is faster. A time of many rods at once is set against calls for one, which is said."
    return ["## Ours against others", "", text, "", *rows] if len(rows) > 2 else []


def table(records: Sequence[Record]) -> list[str]:
    """All problems that one of these others does, as lines of Markdown."""
    lines = [f"| task | {' | '.join(HEAD)} |", "|---" * (len(HEAD) + 1) + "|"]
    for problem in dict.fromkeys(record["problem"] for record in records):
        rows = [record for record in records if record["problem"] == problem]
        pairs = ((ours, other) for ours in our_ways(rows) for other in others(rows))
        lines += [f"| {problem} | {' | '.join(row(*pair))} |" for pair in pairs]
    return lines


def our_ways(records: Sequence[Record]) -> Iterator[Record]:
    """The first that does a problem by itself, and the first that does many at once."""
    for wanted in (comparable, at_once):
        yield from [r for r in records if r["group"] == OURS and complete(r) and wanted(r)][:1]


def others(records: Sequence[Record]) -> Iterator[Record]:
    """Those that are asked for and there."""
    for method, setting in OTHERS:
        rows = [r for r in records if r["method"] == method and setting in (None, r["setting"])]
        if rows:
            yield min(rows, key=lambda r: r["errors"]["worst"] if comparable(r) else inf)


def faster(ours: Record, other: Record) -> float:
    """How many times."""
    return float(other["ratio"]["median"] / ours["ratio"]["median"])


def digits(ours: Record, other: Record, which: str) -> float | None:
    """How many more; None where there is nothing to compare. An error of 0 counts as a rounding."""
    errors = [one["errors"][which] for one in (ours, other)]
    if None in errors:
        return None
    own, theirs = (max(error, 2.0**-53) for error in errors)
    return log10(theirs / own)


def row(ours: Record, other: Record) -> list[str]:
    """Cells of the table."""
    cells = [f"{one['method']}, {tables.shown_setting(one)}" for one in (ours, other)]
    cells.append(tables.ratio(faster(ours, other)))
    for which in ("worst", "median"):
        cells.append(" and ".join(tables.error(one["errors"][which]) for one in (ours, other)))
        more = digits(ours, other, which)
        cells.append("–" if more is None else f"{more:.1f}")
    return [*cells, f"{tables.found(ours)} and {tables.found(other)}"]
