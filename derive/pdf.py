"""A LaTeX file as PDF, by pdflatex if it is installed."""

from __future__ import annotations

import os
import shutil
import subprocess
import tempfile
from pathlib import Path

from derive import output

RUNS = 4  # until widths and references have settled
SECONDS = 120  # for one run
ARGUMENTS = ("-interaction=nonstopmode", "-halt-on-error", "-no-shell-escape")


class TypesettingError(Exception):
    """pdflatex does not accept the file; the message is its own."""


def found() -> bool:
    """Is pdflatex installed?"""
    return shutil.which("pdflatex") is not None


def compiled(path: Path) -> Path:
    """The PDF beside a LaTeX file, whole or not at all."""
    with tempfile.TemporaryDirectory() as place:
        shutil.copyfile(path, Path(place) / path.name)
        for _ in range(RUNS):
            said = run(path.name, Path(place))
            if "Rerun" not in said:
                break
        made = (Path(place) / path.with_suffix(".pdf").name).read_bytes()
    target = path.with_suffix(".pdf")
    try:
        output.move_all({target: output.beside(target, made)})
    except OSError as error:
        raise output.OutputError(f"{target}: cannot be written ({error.strerror})") from error
    return target


def run(name: str, place: Path) -> str:
    """What pdflatex says of a file in a folder; TypesettingError with its first error if it fails."""
    command = ["pdflatex", *ARGUMENTS, name]
    environment = {**os.environ, "openin_any": "p", "openout_any": "p", "max_print_line": "1000"}
    done = subprocess.run(
        command, cwd=place, env=environment, capture_output=True, timeout=SECONDS, stdin=subprocess.DEVNULL
    )
    said = done.stdout.decode("utf-8", errors="replace")
    if done.returncode:
        lines = said.splitlines()
        first = next((n for n, line in enumerate(lines) if line.startswith("!")), 0)
        raise TypesettingError(f"{name}: pdflatex: {' '.join(lines[first : first + 3])}")
    return said
