"""Results kept under a hash of what they depend on, so that an old one is never taken for a new one.

An entry is a JSON file named by the SHA-256 of the stage's name, the bytes of the files and packages it depends on,
the versions of the libraries, and its inputs. A changed byte gives another name: nothing is ever out of date, only
unused. An entry that cannot be read counts as absent.
"""

from __future__ import annotations

import hashlib
import json
import os
import sys
import tempfile
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from dataclasses import dataclass, field
from functools import cache
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path
from typing import Any

LIBRARIES = ("sympy", "mpmath", "numpy", "lark", "jinja2", "python-flint")
_SOURCES = (".py", ".toml", ".jinja", ".lark", ".json", ".tex", ".txt")


def folder() -> Path:
    """Where entries lie: $DERIVE_CACHE, else the user's cache folder."""
    if chosen := os.environ.get("DERIVE_CACHE"):
        return Path(chosen)
    base = os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache"
    return Path(base) / "magnetic-rods"


@cache
def versions() -> str:
    """The interpreter and the libraries whose behaviour results depend on."""
    lines = [f"python {sys.version_info.major}.{sys.version_info.minor}.{sys.version_info.micro}"]
    for name in LIBRARIES:
        try:
            lines.append(f"{name} {version(name)}")
        except PackageNotFoundError:
            lines.append(f"{name} absent")
    return "\n".join(lines)


def files_under(paths: Iterable[Path]) -> list[Path]:
    """All source files among the paths and in the folders among them, in a fixed order."""
    found: set[Path] = set()
    for path in paths:
        if path.is_dir():
            found.update(p for p in path.rglob("*") if p.suffix in _SOURCES and "__pycache__" not in p.parts)
        elif path.is_file():
            found.add(path)
    return sorted(found)


def digest(stage: str, paths: Iterable[Path], inputs: Any = None) -> str:
    """The name of an entry. Files enter with their bytes and their names, not with the place of the checkout."""
    parts = (stage, versions(), json.dumps(inputs, sort_keys=True))
    total = hashlib.sha256(b"".join(_framed(part.encode()) for part in parts))
    known, roots = _READ.get(), tuple(paths)
    if known is None:
        known = {}
    if roots not in known:
        known[roots] = b"".join(map(_sources, roots))
    total.update(known[roots])
    return total.hexdigest()


_READ: ContextVar[dict[tuple[Path, ...], bytes] | None] = ContextVar("_READ", default=None)


@contextmanager
def reading_once() -> Iterator[None]:
    """Within it, sources are read once for all digests: a thousand of them take a second instead of five."""
    before = _READ.set({})
    try:
        yield
    finally:
        _READ.reset(before)


def _sources(root: Path) -> bytes:
    """The names and bytes of the source files of a folder, or of a file."""
    files = [(path.relative_to(root) if path != root else path.name, path) for path in files_under([root])]
    return b"".join(_framed(str(name).encode()) + _framed(path.read_bytes()) for name, path in files)


def _framed(data: bytes) -> bytes:
    """Bytes after their number, so that no two rows of parts look alike."""
    return len(data).to_bytes(8, "big") + data


@dataclass
class Cache:
    """Entries on disk; with enabled=False nothing is read or written."""

    enabled: bool = True
    place: Path = field(default_factory=folder)

    def get(self, key: str) -> Any:
        """The entry, or None if there is none that can be read."""
        if not self.enabled:
            return None
        try:
            data = json.loads(self._path(key).read_text(encoding="utf-8"))
            return data["result"] if data["key"] == key else None
        except (OSError, ValueError, KeyError, TypeError):
            return None

    def put(self, key: str, result: Any) -> None:
        """Keep an entry. A cache that cannot be written only costs time."""
        if not self.enabled:
            return
        try:
            write_atomically(self._path(key), json.dumps({"key": key, "result": result}))
        except OSError:
            self.enabled = False

    def _path(self, key: str) -> Path:
        return self.place / key[:2] / f"{key[2:]}.json"


def write_atomically(path: Path, text: str) -> None:
    """Write a file so that readers see the old one or the new one, never a part; OSError if that is not possible."""
    path.parent.mkdir(parents=True, exist_ok=True)
    handle, name = tempfile.mkstemp(dir=path.parent, prefix=f".{path.name}.")
    try:
        with os.fdopen(handle, "w", encoding="utf-8", newline="\n") as stream:
            stream.write(text)
        os.chmod(name, 0o644)
        os.replace(name, path)
    except BaseException:
        Path(name).unlink(missing_ok=True)
        raise
