"""Emitted files on disk: what differs from what is there, and writing all of them or none."""

from __future__ import annotations

import difflib
import os
import tempfile
from collections.abc import Mapping
from pathlib import Path

MARK = "Emitted by `derive emit`"  # in the header of every emitted module
CHECKOUT = Path(__file__).resolve().parent.parent
PACKAGE_DOC = '"""Solver modules emitted from scenes, such as ``parallel_numpy``. Do not edit them."""\n'


class OutputError(Exception):
    """The files cannot be written; the message says where and what mends it."""


def in_checkout() -> bool:
    """Whether the package runs from a checkout of the project."""
    return (CHECKOUT / "pyproject.toml").is_file()


def default_folder() -> Path:
    """`generated` beside the package in a checkout, else in the working folder."""
    return (CHECKOUT if in_checkout() else Path.cwd()) / "generated"


def must_be_usable(folder: Path) -> None:
    """OutputError if the folder plainly cannot be written, said before the long work and not after it."""
    there = next(place for place in (folder, *folder.absolute().parents) if place.exists())
    if not there.is_dir() or not os.access(there, os.W_OK | os.X_OK):
        reason = "may not be written" if there.is_dir() else "is no folder"
        raise OutputError(f"{there}: {reason}; choose another folder with --out")


def drift(files: Mapping[Path, str], folder: Path, *, complete: bool) -> list[str]:
    """Lines of a diff from what lies on disk to what is emitted; complete means that no other module may lie there."""
    lines: list[str] = []
    for path, text in sorted(files.items()):
        there = read(path)
        if there != text:
            old, new = (there or "").splitlines(keepends=True), text.splitlines(keepends=True)
            name = path.name if path.parent == folder else f"{path.parent.name}/{path.name}"
            lines += difflib.unified_diff(old, new, f"on disk: {name}", f"emitted: {name}")
    if complete and folder.is_dir():
        for path in sorted(set(folder.glob("*.py")) - set(files)):
            if MARK not in (read(path) or ""):
                continue
            lines.append(f"{path.name}: no scene emits this module; remove it or name its scene\n")
    return lines


def read(path: Path) -> str | None:
    """The text of a file, or None; bytes that are no text count as a difference."""
    try:
        with open(path, encoding="utf-8", errors="replace", newline="") as stream:
            return stream.read()
    except FileNotFoundError:
        return None
    except OSError as error:
        raise OutputError(f"{path}: cannot be read ({error.strerror})") from error


def write_all(files: Mapping[Path, str]) -> list[Path]:
    """Write the files that differ: all are written beside their places first, then moved there."""
    waiting: dict[Path, str] = {}
    try:
        for path, text in files.items():
            if read(path) != text:
                path.parent.mkdir(parents=True, exist_ok=True)
                handle, name = tempfile.mkstemp(dir=path.parent, prefix=f".{path.name}.")
                waiting[path] = name
                with os.fdopen(handle, "w", encoding="utf-8", newline="\n") as stream:
                    stream.write(text)
                os.chmod(name, 0o644)
        for path, name in waiting.items():
            os.replace(name, path)
    except OSError as error:
        place = error.filename or next(iter(files)).parent
        raise OutputError(f"{place}: cannot be written ({error.strerror}); choose another folder with --out") from error
    finally:
        for name in waiting.values():
            Path(name).unlink(missing_ok=True)
    return list(waiting)
