"""`derive emit`: write modules, compare them with what is there, or explain what they leave out."""

from __future__ import annotations

import argparse
import sys
from collections.abc import Mapping, Sequence
from dataclasses import asdict
from pathlib import Path
from typing import Any

from rich.console import Console
from rich.markup import escape
from rich.table import Table

from derive import output, pipeline, show
from derive.commands import emitted_files, failed, running, save, scene_path, shipped, write_modules
from derive.emit.backends import BACKENDS
from derive.measure.imports import import_times
from derive.numbers import MistakeError
from derive.runner import Runner


def run_emit(options: argparse.Namespace) -> int:
    """Write modules; with --check compare them with what is there, with --explain say what they leave out."""
    scenes = [scene_path(name) for name in options.scenes] or shipped()
    if options.explain and (options.check or options.out):
        raise MistakeError("--explain writes no module; leave --check and --out away")
    with running(options) as runner:
        if options.explain:
            return explain(options, runner, scenes)
        if options.check:
            return check(options, runner, scenes)
    return write_modules(options, scenes, paper=False)


def check(options: argparse.Namespace, runner: Runner, scenes: Sequence[Path]) -> int:
    """Compare the modules with what is there."""
    folder = options.out or output.default_folder()
    job = pipeline.Job()
    pipeline.emit_modules(runner, job, pipeline.read_scenes(runner, scenes))
    if not job.holds:
        return failed(job)
    files = emitted_files(runner, job, folder, kernels=not options.out)
    lines = output.drift(files, folder, complete=not options.scenes)
    sys.stdout.writelines(lines)
    save(options.json, {"drift": [line.rstrip("\n") for line in lines]})
    if lines:
        print(f"derive emit: {folder} differs from what the scenes give; run 'derive emit'", file=sys.stderr)
    return 1 if lines else 0


def explain(options: argparse.Namespace, runner: Runner, scenes: Sequence[Path]) -> int:
    """Say what the modules of scenes leave out and why, and how large and how fast to import they are."""
    found = pipeline.explain_scenes(runner, pipeline.read_scenes(runner, scenes))
    times = import_times(texts(found))
    for one in found:
        one["size"]["import_ms"] = asdict(times[f"{one['scene']}_{one['backend']}"])
        one["full_size"]["import_ms"] = asdict(times[f"full {one['backend']}"])
        del one["text"], one["full_text"]
    console = show.console()
    for one in found:
        show_left_out(console, one)
    show_sizes(console, found)
    save(options.json, {"modules": found})
    return 0


def texts(found: Sequence[dict[str, Any]]) -> dict[str, tuple[str, str]]:
    """The modules to import, and the full one of each backend once: the package they stand on, and text."""
    packages = {name: (*backend.packages, "math")[0] for name, backend in BACKENDS.items()}
    modules = {f"full {one['backend']}": (packages[one["backend"]], one["full_text"]) for one in found}
    return modules | {f"{one['scene']}_{one['backend']}": (packages[one["backend"]], one["text"]) for one in found}


def show_left_out(console: Console, module: Mapping[str, Any]) -> None:
    """What a module leaves out, by reason and kind."""
    console.print(f"[bold]{module['scene']}[/] on {module['backend']}: {', '.join(module['outputs'])}")
    for name, one in module["folded"].items():
        console.print(f"  {name} = {one['value']}, folded by {one['by']}")
    reasons: dict[str, dict[str, list[str]]] = {}
    for absent in module["absent"]:
        reasons.setdefault(absent["reason"], {}).setdefault(absent["kind"], []).append(absent["name"])
    for reason, kinds in reasons.items():
        console.print(f"  left out, {reason}:")
        for kind, names in kinds.items():
            plural = kind if len(names) == 1 else {"class": "classes"}.get(kind, f"{kind}s")
            console.print(f"    {len(names)} {plural}: {escape(', '.join(names))}", soft_wrap=True)
    console.print()


def show_sizes(console: Console, modules: Sequence[Mapping[str, Any]]) -> None:
    """How large modules are and how long they take to import, beside the full module of their backend."""
    table = Table(title="Against the full module: any field angle, all outputs", title_justify="left", show_edge=False)
    for heading in ("module", "functions", "lines", "bytes", "bytes of the full one", "import, ms", "from … to"):
        table.add_column(heading, justify="left" if heading == "module" else "right")
    full = {f"full, {one['backend']}": one["full_size"] for one in modules}
    sizes = [(f"{one['scene']}_{one['backend']}", one["size"], one["full_size"]) for one in modules]
    for name, size, whole in [*sizes, *((name, size, size) for name, size in full.items())]:
        columns = [str(size[key]) for key in ("functions", "lines", "bytes")]
        share = f"{100 * size['bytes'] / whole['bytes']:.0f} %"
        time = size["import_ms"]
        table.add_row(name, *columns, share, f"{time['median']:.1f}", f"{time['least']:.1f} … {time['most']:.1f}")
    console.print(table)
    console.print("Import: median, least and most of some fresh interpreters, beyond the import of NumPy or mpmath.")
