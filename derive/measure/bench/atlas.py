"""The family of records of the atlas of extremes: a record for each rod of each map."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import partial
from typing import Any

from derive.measure.atlas_maps import MAPS
from derive.measure.atlas_points import OURS, TITLES, measure_point, places
from derive.measure.atlas_stiff import ALL_PEERS
from derive.measure.bench.families import Job, Plan, Record
from derive.measure.bench.tables import markdown
from derive.measure.hard import exact
from derive.measure.packages import left_out
from derive.measure.reference import Rod

PARTS = {"atlas": "errors at the extremes, ours beside what people use today"}
SIZE, MOST = 11, 3  # rods a side of a map, and equilibria of a rod that are refined
# What a quick run takes: maps that are made at once, one equilibrium of each rod.
QUICK = {"loads_parallel": 3, "angles": 2}
LIMIT = 1.0  # in bounds
HEAD = ("map", "solver", "rods", "median, bounds", "worst, bounds", "worst, ulps", "failures")


def jobs(plan: Plan) -> Iterator[Job]:
    """A job for each rod."""
    for name in QUICK if plan.quick else MAPS:
        plan.say(f"the map {name}")
        chart = MAPS[name](QUICK[name] if plan.quick else SIZE)
        for row, column in places(chart):
            key = f"atlas/{name}/{row}/{column}"
            yield Job(key, partial(measure_point, chart, row, column, 1 if plan.quick else MOST))


def ours(records: Sequence[Record]) -> Iterator[tuple[Record, dict[str, Any]]]:
    """What our module does on each rod."""
    for record in records:
        yield record, next(one for one in record["solvers"] if one["solver"] == OURS)


def wrong(records: Sequence[Record]) -> Iterator[str]:
    """Rods on which our module fails, or is beyond its limit."""
    for record, one in ours(records):
        if one["failures"] or not (one["bounds"] or 0) <= LIMIT:
            yield f"{record['key']}: {shown(record, one)}"


def shown(record: Record, one: dict[str, Any]) -> str:
    """The worst of our module on a rod, with the rod to be typed in again."""
    worst = f"{one['quantity']} errs by {one['bounds']:.2g} bounds" if one["bounds"] is not None else "no value"
    return f"{worst}{''.join(f'; {failure}' for failure in one['failures'])} at {exact(Rod(**record['rod']))}"


def document(records: Sequence[Record]) -> list[str]:
    """What each solver does on each map, every rod on which we err by more than the bound, and who is missing."""
    named = [f"- {record['map']}: {shown(record, one)}" for record, one in beyond(records)]
    return [
        "## Extremes",
        "",
        *markdown(HEAD, rows(records)),
        "",
        summary(records),
        "",
        *named,
        *(f"- {one}" for one in missing()),
    ]


def beyond(records: Sequence[Record]) -> list[tuple[Record, dict[str, Any]]]:
    """Rods on which we err by more than one bound, the worst first."""
    far = [(record, one) for record, one in ours(records) if (one["bounds"] or 0) > 1]
    return sorted(far, key=lambda pair: -float(pair[1]["bounds"]))


def summary(records: Sequence[Record]) -> str:
    """In one line."""
    return f"We err by more than the bound on {len(beyond(records))} of {len(records)} rods."


def missing() -> list[str]:
    """Solvers that are not there, and what would bring them."""
    return left_out(ALL_PEERS.values())


def rows(records: Sequence[Record]) -> list[list[str]]:
    """The cells of HEAD for each map and solver."""
    found = []
    for name in dict.fromkeys(record["map"] for record in records):
        here = [record for record in records if record["map"] == name]
        for solver in dict.fromkeys(one["solver"] for record in here for one in record["solvers"]):
            found.append(row(name, solver, [o for r in here for o in r["solvers"] if o["solver"] == solver]))
    return found


def row(name: str, solver: str, of: Sequence[dict[str, Any]]) -> list[str]:
    """What one solver does on a map."""
    bounds = sorted(one["bounds"] for one in of if one["bounds"] is not None)
    ulps = max((one["ulps"] for one in of if one["ulps"] is not None), default=None)
    kinds = [kind for one in of for kind in {failure.split(":")[0] for failure in one["failures"]}]
    failures = ", ".join(f"{kind} {kinds.count(kind)}" for kind in sorted(set(kinds))) or "none"
    numbers = [None, None, ulps] if not bounds else [bounds[len(bounds) // 2], bounds[-1], ulps]
    cells = ["–" if number is None else f"{number:.2g}" for number in numbers]
    return [name, TITLES[solver], str(len(of)), *cells, failures]
