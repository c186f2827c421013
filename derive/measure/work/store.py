"""Records on disk, one file each, so that a run that was broken off goes on where it was; and what they hold for.

A folder belongs to one state of the project and one machine: errors and times of different ones are not mixed.
"""

from __future__ import annotations

import hashlib
import json
import os
import platform
import subprocess
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path
from typing import Any

from derive.cache import digest, write_atomically

PACKAGE = Path(__file__).resolve().parents[2]
PACKAGES = ("numpy", "mpmath", "scipy", "python-flint", "pyweierstrass", "elliptic-functions")
SOURCES = (PACKAGE / "emit", PACKAGE / "measure", PACKAGE.parent / "generated")


class StoreError(Exception):
    """The folder cannot be used; the message says why and what mends it."""


def environment() -> dict[str, Any]:
    """The machine, the versions and the state of the project."""
    packages = {}
    for name in PACKAGES:
        try:
            packages[name] = version(name)
        except PackageNotFoundError:
            packages[name] = "absent"
    machine = {"processor": processor(), "cores": os.cpu_count(), "system": f"{platform.system()} {platform.machine()}"}
    versions = {"python": platform.python_version(), **packages}
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
    """The records of a folder."""

    def __init__(self, folder: Path, mode: str) -> None:
        self.folder, self.about = folder, {"mode": mode, **environment()}
        head = folder / "run.json"
        try:
            if head.exists():
                self._must_be_same(json.loads(head.read_text(encoding="utf-8")))
            else:
                write_atomically(head, json.dumps(self.about, indent=1, ensure_ascii=False) + "\n")
        except OSError as error:
            raise StoreError(
                f"{folder}: cannot be used ({error.strerror}); choose another folder with --out"
            ) from error
        except (ValueError, AttributeError) as error:
            raise StoreError(f"{head}: is no head of a run; choose another folder with --out") from error

    def _must_be_same(self, there: dict[str, Any]) -> None:
        for name in ("mode", "sources", "machine", "versions"):
            if there.get(name) != self.about[name]:
                was, now = there.get(name), self.about[name]
                shown = f" ({was} there, {now} now)" if isinstance(was, str) else ""
                raise StoreError(
                    f"{self.folder}: holds a run with another {name}{shown}; choose another folder with --out, "
                    "or remove it"
                )

    def get(self, key: str) -> dict[str, Any] | None:
        """A record that is there and can be read."""
        try:
            record = json.loads(self._path(key).read_text(encoding="utf-8"))
        except (OSError, ValueError):
            return None
        return record if isinstance(record, dict) and record.get("key") == key else None

    def put(self, key: str, record: dict[str, Any]) -> None:
        """Keep a record, whole or not at all."""
        try:
            text = json.dumps({"key": key, **record}, indent=1, ensure_ascii=False)
            write_atomically(self._path(key), text + "\n")
        except OSError as error:
            raise StoreError(
                f"{error.filename or self.folder}: cannot be written ({error.strerror}); "
                "choose another folder with --out"
            ) from error

    def _path(self, key: str) -> Path:
        plain = "".join(c if c.isascii() and (c.isalnum() or c in ".-") else "_" for c in key)
        return self.folder / "cells" / f"{plain}-{hashlib.sha256(key.encode()).hexdigest()[:8]}.json"
