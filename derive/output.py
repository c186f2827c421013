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
    """Lines of a diff from what lies on disk to what is emitted.

    complete: no other emitted file may lie in the folders of those that are emitted.
    """
    lines: list[str] = []
    for path, text in sorted(files.items()):
        there = read(path)
        if there != text:
            name = path.name if path.parent == folder else f"{path.parent.name}/{path.name}"
            lines += difference(f"on disk: {name}", there or "", f"emitted: {name}", text)
    if complete:
        folders = {folder, *(path.parent for path in files)}
        for path in sorted({one for place in folders for one in place.glob("*.py")} - set(files)):
            there = read(path) or ""
            if MARK in there:
                lines += difference(f"on disk: {path.name}", there, "emitted by no scene: remove it", "")
    return lines


def difference(old_name: str, old: str, new_name: str, new: str) -> list[str]:
    """A unified diff, every line with its end."""
    found = difflib.unified_diff(old.splitlines(keepends=True), new.splitlines(keepends=True), old_name, new_name)
    return [line if line.endswith("\n") else f"{line}\n\\ No newline at end of file\n" for line in found]


def read(path: Path) -> str | None:
    """The text of a file, or None; bytes that are no text count as a difference."""
    try:
        with open(path, encoding="utf-8", errors="replace", newline="") as stream:
            return stream.read()
    except FileNotFoundError:
        return None
    except OSError as error:
        raise OutputError(f"{path}: cannot be read ({error.strerror}); choose another folder with --out") from error


def write_all(files: Mapping[Path, str | bytes]) -> list[Path]:
    """Write the files that differ: all are written beside their places first, then moved there, all of them or none."""
    waiting: dict[Path, Path] = {}
    try:
        for path, given in files.items():
            content = given.encode() if isinstance(given, str) else given
            if not path.is_file() or path.read_bytes() != content:
                path.parent.mkdir(parents=True, exist_ok=True)
                waiting[path] = beside(path, content)
        move_all(waiting)
    except OSError as error:
        place = error.filename or next(iter(files)).parent
        raise OutputError(f"{place}: cannot be written ({error.strerror}); choose another folder with --out") from error
    finally:
        for name in waiting.values():
            name.unlink(missing_ok=True)
    return list(waiting)


def beside(path: Path, content: bytes) -> Path:
    """A file in the folder of ``path`` that holds its content to be, on disk before it takes its name."""
    handle, name = tempfile.mkstemp(dir=path.parent, prefix=f".{path.name}.")
    try:
        with os.fdopen(handle, "wb") as stream:
            stream.write(content)
            stream.flush()
            os.fsync(stream.fileno())
        os.chmod(name, 0o644)
    except BaseException:
        Path(name).unlink(missing_ok=True)
        raise
    return Path(name)


def move_all(waiting: Mapping[Path, Path]) -> None:
    """Move files to their places; if one cannot be moved, those before it get their former content back."""
    former = {path: path.read_bytes() if path.exists() else None for path in waiting}
    moved: list[Path] = []
    try:
        for path, name in waiting.items():
            moved.append(path)
            os.replace(name, path)
    except BaseException:
        for path in moved:
            restore(path, former[path])
        raise


def restore(path: Path, content: bytes | None) -> None:
    """Give a file its former content, or remove it if it was not there."""
    if content is None:
        path.unlink(missing_ok=True)
    elif path.read_bytes() != content:
        os.replace(beside(path, content), path)
