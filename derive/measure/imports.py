"""What importing a module costs beyond its package: measured in fresh interpreters, modules taking turns."""

from __future__ import annotations

import subprocess
import sys
import tempfile
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path
from statistics import median

REPEATS = 7
# The package is loaded first, so that what is timed is the module, and what it needs of the standard library besides.
_CODE = """
import sys, time
sys.path.insert(0, sys.argv[1])
__import__(sys.argv[2])
start = time.perf_counter()
__import__(sys.argv[3])
print(time.perf_counter() - start)
"""


@dataclass(frozen=True)
class ImportTime:
    """Milliseconds for one import: the median of some, the least and the most. Differences within these say nothing."""

    median: float
    least: float
    most: float


def import_times(
    texts: Mapping[str, tuple[str, str]], repeats: int = REPEATS, progress: Callable[[int, int], None] | None = None
) -> dict[str, ImportTime]:
    """How long each module takes to import in some fresh interpreters.

    texts: for each module, the package it stands on and its text. All are imported once before, so that compiling them
    is not counted, and then in turn, so that what slows the machine for a while slows them all.
    """
    found: dict[str, list[float]] = {name: [] for name in texts}
    with tempfile.TemporaryDirectory() as folder:
        for place, (_, text) in enumerate(texts.values()):
            Path(folder, f"module_{place}.py").write_text(text, encoding="utf-8")
        for turn in range(repeats + 1):
            for place, (name, (package, _)) in enumerate(texts.items()):
                seconds = _import_once(folder, package, f"module_{place}")
                if turn:
                    found[name].append(1000 * seconds)
            if progress:
                progress(turn + 1, repeats + 1)
    return {name: ImportTime(median(times), min(times), max(times)) for name, times in found.items()}


def _import_once(folder: str, package: str, module: str) -> float:
    """Seconds for one import in an interpreter of its own."""
    command = [sys.executable, "-I", "-c", _CODE, folder, package, module]
    run = subprocess.run(command, capture_output=True, text=True, check=False)
    if run.returncode:
        raise ImportError(f"a module cannot be imported: {run.stderr.strip().splitlines()[-1]}")
    return float(run.stdout)
