"""Records on disk, a line for each as it is made, so that a run that was broken off goes on; and what they hold for.

A folder belongs to one state of the project and one machine: errors and times of different ones are not mixed. The
first line of its file says which; a last line that was not finished is cut off.
"""

from __future__ import annotations

import json
import os
import platform
import subprocess
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path
from typing import Any

from derive.cache import digest

PACKAGE = Path(__file__).resolve().parents[2]
PACKAGES = ("numpy", "mpmath", "gmpy2", "scipy", "python-flint", "pyweierstrass", "elliptic-functions")
SOURCES = (*(PACKAGE / name for name in ("theory", "check", "emit", "measure")), PACKAGE.parent / "generated")
FILE = "records.jsonl"


class StoreError(Exception):
    """The folder cannot be used; the message says why and what mends it."""


def environment() -> dict[str, Any]:
    """The machine, the versions and the state of the project."""
    versions = {"python": platform.python_version()}
    for name in PACKAGES:
        try:
            versions[name] = version(name)
        except PackageNotFoundError:
            versions[name] = "absent"
    machine = {"processor": processor(), "cores": os.cpu_count(), "system": f"{platform.system()} {platform.machine()}"}
    return {"machine": machine, "versions": versions, "commit": commit(), "sources": digest("measured", SOURCES)[:16]}


def processor() -> str:
    """Its name, where the system tells."""
    try:
        lines = Path("/proc/cpuinfo").read_text(encoding="utf-8").splitlines()
        return next(line.split(":", 1)[1].strip() for line in lines if line.startswith("model name"))
    except (OSError, StopIteration):
        return platform.processor() or "unknown"


def commit() -> str:
    """The commit of the checkout, with a plus if files differ from it; "none" outside of one."""
    git = ["git", "-C", str(PACKAGE.parent)]
    try:
        name = subprocess.run([*git, "rev-parse", "--short=12", "HEAD"], capture_output=True, text=True, check=True)
        changed = subprocess.run([*git, "status", "--porcelain"], capture_output=True, text=True, check=True)
    except (OSError, subprocess.CalledProcessError):
        return "none"
    return name.stdout.strip() + ("+" if changed.stdout.strip() else "")


class Store:
    """The records of a folder; without a folder they are kept in memory alone."""

    def __init__(self, folder: Path | None, mode: str) -> None:
        self.about = {"mode": mode, **environment()}
        self.records: dict[str, dict[str, Any]] = {}
        self.path = folder / FILE if folder else None
        if self.path:
            try:
                self._open(self.path)
            except OSError as error:
                raise self._unusable(error) from error

    def _open(self, path: Path) -> None:
        path.parent.mkdir(parents=True, exist_ok=True)
        lines = path.read_text(encoding="utf-8").splitlines(keepends=True) if path.exists() else []
        whole = [line for line in lines if line.endswith("\n")]
        if not whole:
            path.write_text(_line(self.about), encoding="utf-8")
            return
        try:
            head, *rest = (json.loads(line) for line in whole)
            self.records = {record["key"]: record for record in rest}
            self._must_be_same(head)
        except (ValueError, KeyError, TypeError, AttributeError) as error:
            raise StoreError(f"{path}: holds no records of a run; choose another folder with --out") from error
        if len(whole) < len(lines):
            os.truncate(path, sum(len(line.encode()) for line in whole))

    def _must_be_same(self, there: dict[str, Any]) -> None:
        for name in ("mode", "sources", "machine", "versions"):
            was, now = there.get(name), self.about[name]
            if was != now:
                shown = f" ({was} there, {now} now)" if isinstance(was, str) else ""
                raise StoreError(
                    f"{self.path}: belongs to a run with another {name}{shown}; choose another folder with --out, "
                    "or remove this one"
                )

    def _unusable(self, error: OSError) -> StoreError:
        return StoreError(f"{self.path}: cannot be used ({error.strerror}); choose another folder with --out")

    def get(self, key: str) -> dict[str, Any] | None:
        """A record that is there."""
        return self.records.get(key)

    def put(self, record: dict[str, Any]) -> None:
        """Keep a record."""
        line = _line(record)
        self.records[record["key"]] = record
        if self.path:
            try:
                with self.path.open("a", encoding="utf-8") as stream:
                    stream.write(line)
            except OSError as error:
                raise self._unusable(error) from error


def _line(data: dict[str, Any]) -> str:
    return json.dumps(data, ensure_ascii=False) + "\n"
