"""Writing emitted modules: all or nothing a file, and only what changed; or comparing, with a diff on drift."""

from __future__ import annotations

import contextlib
import os
import tempfile
from collections.abc import Iterable, Mapping
from difflib import unified_diff
from pathlib import Path

from derive.emit.errors import EmitError
from derive.emit.module import EmittedModule

MARK = "Emitted by `derive emit`"  # in the header of every emitted file
_HEADER_LINES = 6


def write_modules(
    modules: Iterable[EmittedModule], out_dir: Path, *, check: bool = False, complete: bool = False
) -> list[str]:
    """Write modules into a folder; with ``check`` write nothing and return the differences as unified diffs.

    ``complete`` says that ``modules`` is all that the folder should hold: with ``check``, emitted files that no scene
    stands for are reported too.
    """
    texts = {module.path: module.text for module in modules}
    stale = stale_modules(out_dir, texts) if complete and check else []
    return write_texts(texts, out_dir, check=check) + stale


def write_texts(texts: Mapping[str, str], out_dir: Path, *, check: bool = False) -> list[str]:
    """The same for texts by file name."""
    out_dir = Path(out_dir)
    if check:
        pairs = ((name, _read(out_dir / name), text) for name, text in texts.items())
        return [difference(name, old, new) for name, old, new in pairs if old != new]
    temporary: dict[Path, Path] = {}
    try:
        out_dir.mkdir(parents=True, exist_ok=True)
        for name, text in texts.items():
            if _read(out_dir / name) != text:
                temporary[_temporary(out_dir, text)] = out_dir / name
        for source, target in temporary.items():
            os.replace(source, target)
    except OSError as error:
        place = error.filename or out_dir
        raise EmitError(
            f"cannot write {place}: {error.strerror}; give another folder with --out, or make it writable"
        ) from error
    finally:
        for source in temporary:
            with contextlib.suppress(OSError):
                source.unlink(missing_ok=True)
    return []


def _temporary(folder: Path, text: str) -> Path:
    """A file in ``folder`` that holds ``text``, on disk before it takes its name."""
    handle, name = tempfile.mkstemp(prefix=".emit-", suffix=".tmp", dir=folder)
    try:
        with os.fdopen(handle, "w", encoding="utf-8", newline="\n") as file:
            file.write(text)
            file.flush()
            os.fsync(file.fileno())
        os.chmod(name, 0o644)
    except BaseException:
        Path(name).unlink(missing_ok=True)
        raise
    return Path(name)


def _read(path: Path) -> str | None:
    """The text of a file, None if there is none."""
    try:
        return path.read_bytes().decode("utf-8")
    except FileNotFoundError:
        return None
    except OSError as error:
        raise EmitError(f"cannot read {path}: {error.strerror}; mend its permissions or remove it") from error
    except UnicodeDecodeError:
        return ""


def difference(name: str, old: str | None, new: str | None) -> str:
    """A unified diff from the file as it is to the file as it should be."""
    before, after = (old or "").splitlines(keepends=True), (new or "").splitlines(keepends=True)
    lines = unified_diff(
        before, after, name if old is not None else "(missing)", name if new is not None else "(stale)"
    )
    return "".join(line if line.endswith("\n") else line + "\n" for line in lines)


def stale_modules(out_dir: Path, expected: Iterable[str]) -> list[str]:
    """Diffs that remove emitted modules for which no scene stands."""
    wanted = set(expected)
    found = []
    for path in sorted(Path(out_dir).glob("*.py")):
        text = _read(path) or ""
        if path.name not in wanted and MARK in "\n".join(text.splitlines()[:_HEADER_LINES]):
            found.append(difference(path.name, text, None))
    return found
