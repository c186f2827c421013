"""The atlas of extremes: maps of error, condition number and formula used, ours beside what people use today.

python -m derive.measure.atlas [MAP]… [--size N] [--most N] [--processes N] [--store FILE] [--pictures FOLDER]

Records are kept in the store as they come; a run that is broken off goes on where it stopped, and a rod that a map no
longer has is measured anew. The last lines name every rod on which our module is beyond its bound.
"""

from __future__ import annotations

import argparse
import json
import sys
from collections.abc import Callable, Iterable, Iterator, Sequence
from concurrent.futures import ProcessPoolExecutor
from dataclasses import asdict
from pathlib import Path
from typing import Any

from derive.cache import write_atomically
from derive.measure.atlas_maps import MAPS, Map, maps, rod_at
from derive.measure.atlas_points import OURS, measure_point
from derive.measure.hard import exact
from derive.measure.reference import Rod

Records = list[dict[str, Any]]
Progress = Callable[[str, int, int], None]
SIZE, MOST = 8, 3
FORMAT = 1


def atlas(
    names: Sequence[str] = tuple(MAPS),
    size: int = SIZE,
    *,
    most: int = MOST,
    store: Path | None = None,
    processes: int = 1,
    progress: Progress | None = None,
) -> dict[str, Any]:
    """The atlas as plain data: {"format", "most", "maps": [axes], "records": […]}; kept in the store as it grows."""
    charts = maps(names, size)
    before = stored(store, most)
    kept = {key: records for key, records in before.items() if _belongs(key, records, charts)}
    wanted = [(chart, row, column) for chart in charts for row, column in places(chart)]
    left = [(chart, row, column) for chart, row, column in wanted if (chart.name, row, column) not in kept]
    done = len(wanted) - len(left)
    for (chart, row, column), records in _measured(left, most, processes):
        kept[chart.name, row, column] = records
        done += 1
        if store is not None:
            write_atomically(store, json.dumps(_data(charts, kept, most), ensure_ascii=False))
        if progress is not None:
            progress(chart.name, done, len(wanted))
    return _data(charts, kept, most)


def places(chart: Map) -> Iterator[tuple[int, int]]:
    """All rows and columns of a map."""
    return ((row, column) for row in range(len(chart.rods)) for column in range(len(chart.rods[row])))


def _measured(left: Sequence[tuple[Map, int, int]], most: int, processes: int) -> Iterator[tuple[Any, Records]]:
    if processes == 1:
        for place in left:
            yield place, measure_point(*place, most)
        return
    with ProcessPoolExecutor(processes) as pool:
        yield from zip(left, pool.map(measure_point, *zip(*left, strict=True), [most] * len(left)), strict=True)


def stored(store: Path | None, most: int) -> dict[tuple[str, int, int], Records]:
    """What a store holds, by place; nothing if it is of another kind or asked for other numbers."""
    if store is None or not store.exists():
        return {}
    try:
        data = json.loads(store.read_text(encoding="utf-8"))
        records = data["records"] if (data["format"], data["most"]) == (FORMAT, most) else []
        found: dict[tuple[str, int, int], Records] = {}
        for record in records:
            found.setdefault((record["map"], record["row"], record["column"]), []).append(record)
    except (ValueError, KeyError, TypeError) as error:
        raise ValueError(f"{store}: is no store of the atlas; name another file, or remove this one") from error
    return found


def _belongs(key: tuple[str, int, int], records: Records, charts: Sequence[Map]) -> bool:
    """Whether kept records are of the rod that the map has there, and of all its solvers."""
    name, row, column = key
    for chart in charts:
        if chart.name == name and row < len(chart.rods) and column < len(chart.rods[row]):
            solvers = [record["solver"] for record in records]
            return records[0]["rod"] == asdict(rod_at(chart, row, column)) and solvers == [OURS, *chart.peers]
    return False


def _data(charts: Sequence[Map], kept: dict[tuple[str, int, int], Records], most: int) -> dict[str, Any]:
    axes = [{key: value for key, value in asdict(chart).items() if key != "rods"} for chart in charts]
    records = [record for chart in charts for place in places(chart) for record in kept.get((chart.name, *place), [])]
    return {"format": FORMAT, "most": most, "maps": axes, "records": records}


def beyond(records: Iterable[dict[str, Any]]) -> Records:
    """Of our module: records beyond the bound or with a failure, worst first."""
    bad = [one for one in records if one["solver"] == OURS and (one["failures"] or (one["bounds"] or 0) > 1)]
    return sorted(bad, key=lambda one: (-len(one["failures"]), -(one["bounds"] or 0)))


def summary(data: dict[str, Any]) -> list[str]:
    """Rows of a table: map, solver, median and worst error, and its failures by kind."""
    lines = ["| map | solver | rods | median, bounds | worst, bounds | worst, ulps | failures |", "|---|" + "---|" * 6]
    for chart in data["maps"]:
        for solver in (OURS, *chart["peers"]):
            of = [one for one in data["records"] if (one["map"], one["solver"]) == (chart["name"], solver)]
            bounds = sorted(one["bounds"] for one in of if one["bounds"] is not None)
            ulps = max((one["ulps"] for one in of if one["ulps"] is not None), default=None)
            kinds = [kind for one in of for kind in {failure.split(":")[0] for failure in one["failures"]}]
            named = ", ".join(f"{kind} {kinds.count(kind)}" for kind in sorted(set(kinds))) or "none"
            shown = [f"{value:.2g}" for value in (bounds[len(bounds) // 2], bounds[-1])] if bounds else ["–", "–"]
            lines.append(
                f"| {chart['name']} | {solver} | {len(of)} | {' | '.join(shown)} | {ulps or 0:.2g} | {named} |"
            )
    return lines


def main(argv: Sequence[str] | None = None) -> int:
    """The command; 1 if our module is beyond its bound anywhere."""
    parser = argparse.ArgumentParser(prog="python -m derive.measure.atlas", description="Maps of error at extremes.")
    parser.add_argument("maps", nargs="*", metavar="MAP", help=f"which maps: {', '.join(MAPS)} (all)")
    parser.add_argument("--size", type=int, default=SIZE, help=f"rods a side ({SIZE})")
    parser.add_argument("--most", type=int, default=MOST, help=f"equilibria of a rod that are refined ({MOST})")
    parser.add_argument("--processes", type=int, default=1, help="rods measured at a time (1)")
    parser.add_argument("--store", type=Path, help="JSON file in which records are kept, to go on from")
    parser.add_argument("--pictures", type=Path, help="folder for heat maps, SVG and PNG")
    options = parser.parse_args(argv)

    def progress(name: str, done: int, total: int) -> None:
        end = "\n" if done == total or not sys.stderr.isatty() else "\r"
        if end == "\r" or done == total or done % 25 == 0:
            print(f"{done}/{total} {name}", end=end, file=sys.stderr, flush=True)

    try:
        data = atlas(
            options.maps or tuple(MAPS),
            options.size,
            most=options.most,
            store=options.store,
            processes=options.processes,
            progress=progress,
        )
        print("\n".join(summary(data)))
        if options.pictures is not None:
            from derive.measure.atlas_pictures import draw_atlas

            for path in draw_atlas(data, options.pictures):
                print(path)
    except (ValueError, ImportError, OSError) as error:
        print(f"derive.measure.atlas: {error}", file=sys.stderr)
        return 2
    bad = beyond(data["records"])
    for one in bad:
        worst = f"{one['bounds']:.2g} bounds of {one['quantity']}" if one["bounds"] is not None else "no value"
        print(f"{one['map']}: {worst} {one['failures'] or ''} at {exact(Rod(**one['rod']))}")
    return 1 if bad else 0


if __name__ == "__main__":
    raise SystemExit(main())
