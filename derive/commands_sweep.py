"""`derive sweep`: complete branches over one parameter, with folds, stability and jumps."""

from __future__ import annotations

import argparse
import os
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import BrokenExecutor, CancelledError, Executor, ProcessPoolExecutor
from contextlib import contextmanager
from itertools import product
from types import ModuleType
from typing import Any

from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeRemainingColumn
from rich.table import Table

from derive import show
from derive.commands import running, save, scene_path, solver, write_file
from derive.diagrams import files
from derive.diagrams.blocks import Rows, Store, blocks, solved
from derive.diagrams.branches import Diagram, beside_folds, diagram
from derive.diagrams.diagram_picture import drawn
from derive.diagrams.jumps import jumps
from derive.diagrams.plotting import LETTERS, format_of, library
from derive.diagrams.refused import must_be_traceable
from derive.diagrams.request import LOADS, Request, request
from derive.diagrams.states import rows
from derive.emit.scene import load_scene
from derive.measure.loading import text_of
from derive.numbers import MistakeError

MANY = 16  # blocks from which processes are worth their start


def run_sweep(options: argparse.Namespace) -> int:
    """A diagram, or a family of them."""
    if options.plot:
        format_of(options.plot)
        library()
    scene = load_scene(scene_path(options.scene))
    asked = request(options.scene, scene.parameters, {name: getattr(options, name) for name in LOADS})
    with running(options) as runner:
        module = solver(runner, options.scene)
    if not hasattr(module, "sweep"):
        raise MistakeError(f"scene '{options.scene}' has no output 'sweep'; add it to its outputs")
    folded = {name: float(value) for name, value in scene.folded.items()}
    for fixed, end in product(asked.curves, (asked.values[0], asked.values[-1])):
        must_be_traceable({**folded, **fixed, asked.parameter: end})
    found = curves(options, module, asked, folded)
    for number, one in enumerate(found, 1):
        show_diagram(number if len(found) > 1 else 0, one)
    write(options, found)
    return 0


def curves(options: argparse.Namespace, module: ModuleType, asked: Request, folded: dict[str, float]) -> list[Diagram]:
    """All diagrams: the blocks of all curves first, by whatever computes them, and then the events."""
    shipped = module.__name__.startswith("generated.")
    name, text = (module.__name__, "") if shipped else ("", text_of(module))
    lines = [sorted({*asked.values, *known_events(asked, {**folded, **fixed})}) for fixed in asked.curves]
    parts = [
        list(blocks(name, text, asked.parameter, line, fixed)) for line, fixed in zip(lines, asked.curves, strict=True)
    ]
    todo = [block for part in parts for block in part]
    try:
        with executor(options, len(todo)) as pool, progress() as advance:
            done = solved(todo, Store(options.store), pool, advance)
    except OSError as error:
        raise MistakeError(f"{error.filename or options.store}: cannot be written ({error.strerror})") from error
    except (BrokenExecutor, CancelledError) as error:
        kept = "what was done is kept: run the same again" if options.store else "with --store DIR nothing done is lost"
        raise MistakeError(f"a process that computed was lost ({error or type(error).__name__}); {kept}") from error
    found = []
    for line, part, fixed in zip(lines, parts, asked.curves, strict=True):
        known = dict(zip(line, (row for block in part for row in done[block]), strict=True))
        found.append(diagram(asked.parameter, line, solving(module, asked.parameter, fixed, known), fixed))
    return found


def solving(
    module: ModuleType, parameter: str, fixed: dict[str, float], known: dict[float, Any]
) -> Callable[[Sequence[float]], Rows]:
    """The equilibria at values that are known, or by the module."""

    def solve(values: Sequence[float]) -> Rows:
        if all(value in known for value in values):
            return [known[value] for value in values]
        return rows(module, parameter, values, fixed)

    return solve


def known_events(asked: Request, rod: dict[str, float]) -> list[float]:
    """Values on both sides of events that are known beforehand: over η the folds."""
    if asked.parameter != "eta":
        return []
    return beside_folds(rod, rod["field_angle"], asked.values[0], asked.values[-1])


@contextmanager
def executor(options: argparse.Namespace, number: int) -> Iterator[Executor | None]:
    """Where blocks are computed: a Dask cluster, processes, or here."""
    if options.dask:
        with cluster(options.dask) as pool:
            yield pool
    elif (workers := options.jobs or os.cpu_count() or 1) > 1 and number >= (2 if options.jobs else MANY):
        with ProcessPoolExecutor(workers) as pool:
            yield pool
    else:
        yield None


@contextmanager
def cluster(address: str) -> Iterator[Executor]:
    """The executor of a Dask cluster; a block whose worker is lost runs again on another."""
    try:
        from distributed import Client
    except ModuleNotFoundError as error:
        raise MistakeError("--dask needs Dask's scheduler: pip install 'magnetic-rods[cluster]'") from error
    try:
        client = Client(address, timeout=5)
    except (OSError, ValueError) as error:
        raise MistakeError(f"--dask {address}: no scheduler answers there ({error or type(error).__name__})") from error
    with client:
        yield client.get_executor(retries=3)


@contextmanager
def progress() -> Iterator[Callable[[int, int], None]]:
    """A bar with the time left, if the terminal is one."""
    console = show.console(stderr=True)
    columns = (TextColumn("blocks"), BarColumn(), MofNCompleteColumn(), TimeRemainingColumn())
    with Progress(*columns, console=console, transient=True, disable=not console.is_terminal) as bar:
        line = bar.add_task("", total=None)
        yield lambda done, total: bar.update(line, completed=done, total=total)


def write(options: argparse.Namespace, found: list[Diagram]) -> None:
    """The files that were asked for."""
    save(options.json, files.data(found))
    if options.csv:
        write_file(options.csv, files.csv_text(found).encode())
    if options.npz:
        write_file(options.npz, files.npz_bytes(found))
    if options.plot:
        write_file(options.plot, drawn(found, options.show, format_of(options.plot)))


def show_diagram(number: int, one: Diagram) -> None:
    """Branches, events and jumps of a diagram, as tables."""
    letter, console = LETTERS[one.parameter], show.console()
    fixed = ", ".join(f"{LETTERS[name]} = {value:.6g}" for name, value in one.fixed.items())
    curve = f"curve {number}: " if number else ""
    table = Table(title=f"{curve}{len(one.branches)} branches over {letter}; {fixed}", title_justify="left")
    for heading in ("branch", "index", "from", "to", "θ(ℓ) from", "to"):
        table.add_column(heading, justify="right")
    for branch in one.branches:
        ends = (f"{branch.values[0]:.15g} ({branch.starts})", f"{branch.values[-1]:.15g} ({branch.ends})")
        tips = (f"{branch.states[0].tip_angle:.10f}", f"{branch.states[-1].tip_angle:.10f}")
        table.add_row(str(branch.number), str(branch.index), *ends, *tips)
    console.print(table)
    for jump in jumps(one):
        reaches = " or ".join(map(str, jump.reaches)) or "none that is stable"
        ways = f"from branch {jump.leaves} to {reaches}"
        console.print(f"loading {jump.direction}: {ways} at {letter} = {jump.value:.15g}")
