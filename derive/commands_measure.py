"""`derive measure`: error against run time, and how time and memory grow."""

from __future__ import annotations

import argparse
import json
import sys
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from difflib import get_close_matches
from functools import cache
from importlib import import_module
from pathlib import Path
from types import ModuleType

from rich.markup import escape
from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeElapsedColumn
from rich.table import Table

from derive import output, show, stages
from derive.cache import Cache
from derive.commands import running, save, write_file
from derive.diagrams.plotting import library
from derive.measure.bench import atlas, precision, stability, tables
from derive.measure.bench.families import Plan, Record, parts
from derive.measure.bench.fronts import front, wins
from derive.measure.bench.growth import exponents
from derive.measure.bench.run import Found, run
from derive.measure.bench.store import Store, StoreError
from derive.measure.loading import load
from derive.numbers import MistakeError
from derive.stages import Task

FOLDER = Path("measurements")
KINDS = ("svg", "png")
# What draws the records of a family: pictures(records, kind) gives names and bytes of files.
PICTURES = {
    "tasks": "derive.diagrams.front_picture",
    "growth": "derive.diagrams.growth_picture",
    "atlas": "derive.diagrams.atlas_picture",
}
LITERAL = '[scene]\nname = "literal"\ncase = "parallel"\noutputs = ["equilibria", "literal"]'
INTERRUPTED = 130


def run_measure(options: argparse.Namespace) -> int:
    """Measure what has no record yet; then tables and pictures. 1 if a limit is missed or a method breaks."""
    must_be_known(options.only)
    folder = options.out or (None if options.quick else FOLDER)
    if folder:
        output.must_be_usable(folder)
    try:
        store = Store(folder, "quick" if options.quick else "full")
        with progress() as advance:
            plan = Plan(
                Cache(enabled=not options.no_cache),
                options.quick,
                tuple(options.only),
                literal_modules(options),
                lambda what: advance(0, 0, what),
            )
            found = run(store, plan, advance)
    except StoreError as error:
        raise MistakeError(str(error)) from error
    except KeyboardInterrupt:
        kept = (
            f"what was measured is in {folder}; the same command goes on from there" if folder else "nothing was kept"
        )
        print(f"derive measure: interrupted; {kept}", file=sys.stderr)
        return INTERRUPTED
    save(options.json, found.to_json())
    show_found(found)
    if folder:
        write(folder, found)
    wrong = found.wrong()
    for line in wrong:
        print(f"derive measure: {line}", file=sys.stderr)
    return 1 if wrong else 0


def must_be_known(only: Sequence[str]) -> None:
    """MistakeError for a part that there is not."""
    known = parts()
    for name in only:
        if name not in known:
            close = get_close_matches(name.lower(), known, n=1) or get_close_matches(name.upper(), known, n=1)
            hint = f"did you mean '{close[0]}'? " if close else ""
            raise MistakeError(f"--only {name}: no such part; {hint}there are {', '.join(known)}")


def literal_modules(options: argparse.Namespace) -> Callable[[str], ModuleType]:
    """The article's own formulas as modules: no shipped scene asks for them, so they are emitted when wanted."""

    @cache
    def module(name: str) -> ModuleType:
        with running(options) as runner:
            task = Task("emit", name, stages.emit, (LITERAL, *name.split("_")), stages.emission_paths())
            (emitted,) = runner.results([task], stages.derived)
        if emitted["failure"]:
            raise RuntimeError(f"cannot be emitted: {emitted['failure']}")
        return load(emitted["text"], name)

    return module


@contextmanager
def progress() -> Iterator[Callable[[int, int, str], None]]:
    """A bar, if the terminal is one."""
    console = show.console(stderr=True)
    columns = (BarColumn(), MofNCompleteColumn(), TimeElapsedColumn(), TextColumn("{task.description}"))
    with Progress(*columns, console=console, transient=True, disable=not console.is_terminal) as bar:
        line = bar.add_task("", total=None)
        yield lambda done, total, name: bar.update(line, completed=done, total=total or None, description=escape(name))


def write(folder: Path, found: Found) -> None:
    """All records as one file, the tables, and the pictures."""
    text = json.dumps(found.to_json(), indent=1, ensure_ascii=False) + "\n"
    write_file(folder / "measure.json", text.encode())
    write_file(folder / "measure.md", found.document().encode())
    show.console().print(f"{folder}: measure.json, measure.md, {draw(folder, found)}", highlight=False)


def draw(folder: Path, found: Found) -> str:
    """All pictures, and how many there are, or why there are none."""
    count = 0
    try:
        library()
    except MistakeError as error:
        return f"no pictures ({error})"
    for family, place in PICTURES.items():
        if records := found.records.get(family):
            for kind in KINDS:
                for name, content in import_module(place).pictures(records, kind):
                    write_file(folder / f"{name}.{kind}", content)
                    count += 1
    return f"{count} pictures"


def show_found(found: Found) -> None:
    """For each problem a table, and what others do better; growth, and the other families in a line each."""
    console = show.console()
    records = found.records.get("tasks", [])
    for problem in dict.fromkeys(record["problem"] for record in records):
        rows = [record for record in records if record["problem"] == problem]
        console.print(problem_table(rows))
        for line in wins(rows):
            console.print(f"  {line}", highlight=False, soft_wrap=True)
    for row in exponents(found.records.get("growth", [])):
        time, memory = (f"{row.variable}^{power:.2f}" for power in (row.time, row.memory))
        console.print(f"{row.series}: time as {time}, memory as {memory}", highlight=False)
    for line in words(found):
        console.print(line, highlight=False, soft_wrap=True)


def words(found: Found) -> Iterator[str]:
    """What came out of maps and searches, in a line each, and who is missing."""
    for name, family in (("atlas", atlas), ("stability", stability)):
        if records := found.records.get(name):
            yield f"{name}: {family.summary(records)}"
    if found.records.get("tasks"):
        yield from precision.missing()
    if found.records.get("atlas"):
        yield from atlas.missing()


def problem_table(rows: Sequence[Record]) -> Table:
    """All methods on one problem; bold is on the front."""
    best = [record["key"] for record in front(rows)]
    table = Table(title=f"{rows[0]['problem']}: {rows[0]['title']}", title_justify="left", show_edge=False)
    for heading in ("method", "setting", "worst error", "found", f"time a {rows[0]['unit']}", "over ours"):
        table.add_column(heading, justify="left" if heading in ("method", "setting") else "right")
    for record in rows:
        mark = "[bold]" if record["key"] in best else ""
        time = tables.seconds(record["seconds"]["median"])
        cells = (
            escape(tables.shown_setting(record)),
            tables.error(record["errors"]["worst"]),
            tables.found(record),
            time,
        )
        table.add_row(mark + record["method"], *cells, tables.ratio(record["ratio"]["median"]))
    return table
