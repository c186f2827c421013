"""`derive measure`: error against run time, and how the cost grows."""

from __future__ import annotations

import argparse
import json
import re
import sys
import tempfile
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import ExitStack, contextmanager
from difflib import get_close_matches
from pathlib import Path
from types import ModuleType

from rich.markup import escape
from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeElapsedColumn
from rich.table import Table

from derive import show, stages
from derive.cache import Cache, write_atomically
from derive.commands import running, save
from derive.measure.loading import load
from derive.measure.work import tables
from derive.measure.work.bounds import violations
from derive.measure.work.fronts import front, wins
from derive.measure.work.run import NAMES, Found, run
from derive.measure.work.store import Store, StoreError
from derive.numbers import MistakeError
from derive.stages import Task

FOLDER = Path("measurements")
LITERAL = '[scene]\nname = "literal"\ncase = "parallel"\noutputs = ["equilibria", "literal"]'
NEED_LITERAL = {"T1", "T3", "T5"}
MARKERS = r"(<!-- measure -->\n).*?(<!-- end measure -->)"
INTERRUPTED = 130


def run_measure(options: argparse.Namespace) -> int:
    """Measure what has no record yet; then tables and pictures. 1 if a bound is missed or a method breaks."""
    must_be_known(options.only)
    readme = options.readme and read_readme(options.readme)
    console = show.console()
    with ExitStack() as stack:
        keeps = bool(options.out) or not options.quick
        folder = options.out or (FOLDER if keeps else Path(stack.enter_context(tempfile.TemporaryDirectory())))
        try:
            store = Store(folder, "quick" if options.quick else "full")
            modules = literal_modules(options)
            with progress() as advance:
                cache = Cache(enabled=not options.no_cache)
                found = run(store, cache, modules, options.only, quick=options.quick, progress=advance)
        except StoreError as error:
            raise MistakeError(str(error)) from error
        except KeyboardInterrupt:
            kept = f"what was measured is in {folder}; the same command goes on from there" if keeps else "nothing kept"
            print(f"derive measure: interrupted; {kept}", file=sys.stderr)
            return INTERRUPTED
        save(options.json, found.to_json())
        if keeps:
            write(folder, found)
    if readme:
        write_readme(options.readme, readme, found)
    show_found(found)
    wrong = [*violations(found.records, peers=options.quick), *(f"{k}: {why}" for k, why in found.failed.items())]
    for line in wrong:
        print(f"derive measure: {line}", file=sys.stderr)
    if keeps:
        console.print(f"tables and pictures: {folder}", highlight=False)
    return 1 if wrong else 0


def must_be_known(only: Sequence[str]) -> None:
    """MistakeError for a task that there is not."""
    for name in only:
        if name not in NAMES:
            close = get_close_matches(name.upper(), NAMES, n=1)
            hint = f"did you mean '{close[0]}'? " if close else ""
            raise MistakeError(f"--only {name}: no such task; {hint}there are {', '.join(NAMES)}")


def literal_modules(options: argparse.Namespace) -> Mapping[str, ModuleType]:
    """The article's own formulas as modules: no shipped scene asks for them, so they are emitted now, and kept."""
    if options.only and not NEED_LITERAL & set(options.only):
        return {}
    paths = stages.emission_paths()
    backends = ("numpy",) if options.quick else ("numpy", "mpmath")
    tasks = [Task("emit", f"literal_{name}", stages.emit, (LITERAL, "literal", name), paths) for name in backends]
    with running(options) as runner:
        emitted = runner.results(tasks, stages.derived)
    for one in emitted:
        if one["failure"]:
            raise MistakeError(f"the article's formulas cannot be emitted: {one['failure']}; run `derive check`")
    return {one["name"]: load(one["text"], one["name"]) for one in emitted}


@contextmanager
def progress() -> Iterator[Callable[[int, int, str], None]]:
    """A bar, if the terminal is one."""
    console = show.console(stderr=True)
    columns = (BarColumn(), MofNCompleteColumn(), TimeElapsedColumn(), TextColumn("{task.description}"))
    with Progress(*columns, console=console, transient=True, disable=not console.is_terminal) as bar:
        line = bar.add_task("", total=None)
        yield lambda done, total, name: bar.update(line, completed=done, total=total or None, description=escape(name))


def write(folder: Path, found: Found) -> None:
    """All records as one file, the tables, and a picture for each problem."""
    from derive.diagrams.front_picture import draw

    try:
        text = json.dumps(found.to_json(), indent=1, ensure_ascii=False)
        write_atomically(folder / "measure.json", text + "\n")
        write_atomically(folder / "tables.md", tables.document(found))
    except OSError as error:
        raise MistakeError(f"{folder}: cannot be written ({error.strerror}); choose another --out") from error
    for problem in dict.fromkeys(record["problem"] for record in found.records):
        rows = [record for record in found.records if record["problem"] == problem]
        draw(rows, [folder / f"{problem}.svg", folder / f"{problem}.png"])


def read_readme(path: Path) -> str:
    """The text, which must have the markers."""
    try:
        text = path.read_text(encoding="utf-8")
    except (OSError, UnicodeDecodeError) as error:
        raise MistakeError(f"--readme {path}: cannot be read; name a Markdown file") from error
    if not re.search(MARKERS, text, flags=re.DOTALL):
        raise MistakeError(f"--readme {path}: has no lines <!-- measure --> and <!-- end measure --> for the table")
    return text


def write_readme(path: Path, text: str, found: Found) -> None:
    """Put the table between the markers."""
    lines, missing = tables.readme_rows(found.records)
    if missing:
        raise MistakeError(
            f"--readme: no record of {', '.join(missing)}; run without --only and --quick, all peers there"
        )
    inner = "\n".join(lines) + "\n"
    changed = re.sub(MARKERS, lambda match: match[1] + inner + match[2], text, flags=re.DOTALL)
    try:
        write_atomically(path, changed)
    except OSError as error:
        raise MistakeError(f"--readme {path}: cannot be written ({error.strerror})") from error


def show_found(found: Found) -> None:
    """For each problem ours and what is on the front, and what others do better."""
    console = show.console()
    for problem in dict.fromkeys(record["problem"] for record in found.records):
        rows = [record for record in found.records if record["problem"] == problem]
        best = [record["key"] for record in front(rows)]
        table = Table(title=f"{problem}: {rows[0]['title']}", title_justify="left", show_edge=False)
        for heading in ("method", "setting", "worst error", "found", f"time a {rows[0]['unit']}", "over ours"):
            table.add_column(heading, justify="left" if heading in ("method", "setting") else "right")
        for record in rows:
            mark = "[bold]" if record["key"] in best else ""
            time = tables.seconds(record["seconds"]["median"])
            cells = (record["setting"], tables.error(record["errors"]["worst"]), tables.found(record), time)
            table.add_row(mark + record["method"], *cells, f"{record['ratio']['median']:.3g}")
        console.print(table)
        for line in wins(rows):
            console.print(f"  {line}", highlight=False, soft_wrap=True)
    for row in found.to_json()["exponents"]:
        what = row["variable"]
        line = f"{row['series']}: time as {what}^{row['time']:.2f}, memory as {what}^{row['memory']:.2f}"
        console.print(line, highlight=False)
    for reason in found.left_out:
        console.print(f"left out: {reason}", highlight=False)
