"""The commands: each takes parsed options, shows its result and gives the exit code."""

from __future__ import annotations

import argparse
import importlib
import json
import math
import sys
import time
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from types import ModuleType
from typing import Any

from rich.console import Console
from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn

from derive import output, pipeline, show, stages
from derive.cache import Cache
from derive.measure.loading import load
from derive.numbers import MistakeError
from derive.resources import kernels_folder, shipped_scenes
from derive.runner import Runner
from derive.stages import Task

REPORT = "paper_checks.tex"
PAPERS_ROD = {"beta": 0.00035, "eta": 0.00052, "length": 80.0, "clamp_angle": 3 * math.pi / 4}


def kind_of(error: Exception) -> str | None:
    """Whether an error is a "mistake" of the user, a "failure" of a check, or (None) one of this program."""
    from derive.emit.errors import EmitError, SceneError
    from derive.paper.errors import ReadError
    from derive.pdf import TypesettingError

    mistakes = (MistakeError, output.OutputError, pipeline.UnknownFormulaError, SceneError, ReadError)
    if isinstance(error, mistakes):
        return "mistake"
    return "failure" if isinstance(error, stages.DerivationError | EmitError | TypesettingError) else None


@contextmanager
def running(options: argparse.Namespace) -> Iterator[Runner]:
    """A runner with a progress bar, if the terminal is one."""
    if options.jobs < 0:
        raise MistakeError(f"--jobs must be at least 1 (got {options.jobs}); leave it out for one per core")
    console = Console(stderr=True)
    columns = (TextColumn("{task.description}"), BarColumn(), MofNCompleteColumn())
    bar = Progress(*columns, console=console, transient=True, auto_refresh=False, disable=not console.is_terminal)
    with bar:
        line = bar.add_task("", total=None)

        def progress(done: int, total: int, label: str) -> None:
            bar.update(line, completed=done, total=total, description=label, refresh=True)

        yield Runner(Cache(enabled=not options.no_cache), options.jobs, progress)


def run_all(options: argparse.Namespace) -> int:
    """The main job."""
    return write_modules(options, shipped(), paper=True)


def write_modules(options: argparse.Namespace, scenes: list[Path], *, paper: bool) -> int:
    """Derive, judge, emit, prove, run; then write, and show what was found."""
    start, console = time.perf_counter(), show.console()
    folder = options.out or output.default_folder()
    output.must_be_usable(folder)
    with running(options) as runner:
        job = pipeline.main_job(runner, scenes, paper=paper)
        files = emitted_files(runner, job, folder, kernels=not options.out) if job.holds else {}
    if paper and job.holds:
        files[folder / REPORT] = pipeline.report_text(job)
    save(options.json, summary(job))
    if not job.holds:
        return failed(job)
    written = output.write_all(files)
    show.show_job(console, job, written, time.perf_counter() - start)
    text = files.get(folder / "parallel_numpy.py")
    if paper and text:
        equilibria = load(text).equilibria(**PAPERS_ROD)
        show.show_equilibria(console, equilibria, "β = 0.00035, η = 0.00052, ℓ = 80, clamp angle 3π/4")
    return 0


def failed(job: pipeline.Job) -> int:
    """Say what does not hold."""
    show.show_failures(show.console(stderr=True), job)
    print("derive: not everything holds; no module was written", file=sys.stderr)
    return 1


def emitted_files(runner: Runner, job: pipeline.Job, folder: Path, *, kernels: bool) -> dict[Path, str]:
    """Path and text of all that is written: the modules, their package, in a checkout emitted kernel files."""
    files = {folder / f"{module['name']}.py": module["text"] for module in job.modules}
    files[folder / "__init__.py"] = output.PACKAGE_DOC
    if kernels and folder == output.default_folder() and output.in_checkout():
        task = Task("emit", "kernels", stages.emit_kernels, (), stages.emission_paths())
        (texts,) = runner.results([task], stages.derived)
        files |= {kernels_folder() / f"{stem}.py": text for stem, text in texts.items()}
    return files


def solver(runner: Runner, name: str) -> ModuleType:
    """The NumPy module of a scene: the shipped one, or emitted and proved now."""
    path = scene_path(name)
    if path in shipped_scenes().values():
        try:
            return importlib.import_module(f"generated.{path.stem}_numpy")
        except ModuleNotFoundError:
            pass
    job = pipeline.Job()
    pipeline.emit_modules(runner, job, pipeline.read_scenes(runner, [path]))
    if not job.holds:
        raise MistakeError("; ".join(f"{module}: {reason}" for module, reason in job.failed_modules()))
    texts = {module["backend"]: module["text"] for module in job.modules}
    if "numpy" not in texts:
        raise MistakeError(f'{path}: the scene has no NumPy backend; add "numpy" to its backends')
    return load(texts["numpy"], path.stem)


def shipped() -> list[Path]:
    """All shipped scenes."""
    return list(shipped_scenes().values())


def scene_path(name: str) -> Path:
    """A scene file, or a shipped scene by its name."""
    known, path = shipped_scenes(), Path(name)
    if name in known:
        return known[name]
    if path.suffix == ".toml" or path.exists():
        return path
    from derive.emit.errors import choices

    raise MistakeError(f"no scene '{name}'{choices(name, known)}, or a scene file")


def latex(path: Path) -> str:
    """The text of a LaTeX source."""
    from derive.paper.displays import read_source

    try:
        return read_source(path)
    except OSError as error:
        raise MistakeError(f"{path}: cannot be read ({error.strerror}); give a LaTeX source with --paper") from error


def save(path: Path | None, data: Mapping[str, Any]) -> None:
    """Write a result as JSON, if it was asked for."""
    if path:
        write_file(path, (json.dumps(data, indent=2, ensure_ascii=False, default=str) + "\n").encode())


def write_file(path: Path, content: bytes) -> None:
    """Write a file whole or not at all; a device is written as it is, not replaced."""
    try:
        if path.exists() and not path.is_file() and not path.is_dir():
            path.write_bytes(content)
        else:
            path.parent.mkdir(parents=True, exist_ok=True)
            output.move_all({path: output.beside(path, content)})
    except OSError as error:
        raise MistakeError(f"{path}: cannot be written ({error.strerror}); choose another file") from error


def summary(job: pipeline.Job) -> dict[str, Any]:
    """The main job's findings as data; module texts are left out."""
    modules = [{key: value for key, value in module.items() if key != "text"} for module in job.modules]
    found = {"claims": job.claims, "formulas": job.printed, "modules": modules, "agreement": job.agreements}
    return {"holds": job.holds, "broken": job.broken, "counts": show.counts(job.printed), **found}
