"""Runs what a page of the documentation shows, and compares what that prints with what the page says.

Blocks of a page are run in their order, in one folder and with the same Python names:

    ```python            Python; a block without a language right below it is what it prints
    ```console           lines that begin with "$ " are commands, those below what they print

Lines that begin with "derive" in blocks without a language are commands too, of which only the exit code is looked at.
A line ``<!-- file rod.toml -->`` above a block, in any language, says that it is a file of that name, which is written
into the folder; ``<!-- long -->`` or ``<!-- hours -->``, that it is for tests with such a mark. In what is printed "…"
stands for anything.
"""

from __future__ import annotations

import contextlib
import doctest
import io
import os
import re
import shlex
import subprocess
import sys
from collections.abc import Iterator
from dataclasses import dataclass, field, replace
from pathlib import Path

import pytest

from derive.cli import main

ROOT = Path(__file__).resolve().parent.parent
PROGRAMS = {"python": sys.executable, "git": "git"}
FENCE = re.compile(r"^(?:<!-- (?:(long|hours)|file ([\w.]+)) -->\n)?```(\w*)\n(.*?)^```$", re.MULTILINE | re.DOTALL)


@dataclass(frozen=True)
class Block:
    """A fenced block: the file and line of its text, its language, the file that it is, what it prints, its mark."""

    place: str
    language: str
    name: str
    text: str
    printed: str
    mark: str

    @property
    def runs(self) -> bool:
        """Whether there is anything to do."""
        return bool(self.name) or self.language in ("python", "console")


def blocks(page: Path) -> list[Block]:
    """The blocks of a page that are run, with what they print."""
    text = page.read_text(encoding="utf-8")
    found: list[Block] = []
    end = 0
    for match in FENCE.finditer(text):
        mark, name, language, body = match.groups(default="")
        if not language and found and found[-1].language == "python" and not text[end : match.start()].strip():
            found[-1] = replace(found[-1], printed=body)
        else:
            line = text.count("\n", 0, match.start(4)) + 1
            found.append(Block(f"{page.name}:{line}", language, name, body, "", mark))
        end = match.end()
    return [block for block in found if block.runs]


def calls(page: Path) -> list[list[str]]:
    """The arguments of the commands in blocks without a language; the main job and patterns are none."""
    found = []
    for match in FENCE.finditer(page.read_text(encoding="utf-8")):
        if not match[3]:
            found += re.findall(r"^(?:\.venv/bin/)?derive (.+)$", match[4], re.MULTILINE)
    return [shlex.split(line, comments=True) for line in found if "…" not in line]


@dataclass
class Reader:
    """Someone who does what a page says, in a folder."""

    folder: Path
    names: dict[str, object] = field(default_factory=lambda: {"__name__": "__main__"})
    code: int = 0

    def read(self, page: Path, *marks: str) -> int:
        """Run the blocks without a mark, and those with one of some. How many there were."""
        wanted = [block for block in blocks(page) if block.mark in ("", *marks)]
        with contextlib.chdir(self.folder):
            for block in wanted:
                self.follow(block)
        return len(wanted)

    def follow(self, block: Block) -> None:
        """Do what one block says."""
        if block.name:
            Path(block.name).write_text(block.text, encoding="utf-8")
        elif block.language == "python":
            with printing() as printed:
                exec(compile("\n" * lines_before(block) + block.text, block.place, "exec"), self.names)
            compare(block.printed, printed.getvalue(), block.place)
        else:
            for command, expected in commands(block.text):
                compare(expected, self.run(command, block.place), f"{block.place} ({command})")
            assert self.code == 0, f"{block.place}: exit code {self.code}; a page that means it says `echo $?`"

    def run(self, command: str, place: str) -> str:
        """What a command prints."""
        program, *arguments = shlex.split(command, comments=True)
        if command == "echo $?":
            code, self.code = self.code, 0
            return f"{code}\n"
        assert self.code == 0, f"{place}: exit code {self.code} before `{command}`"
        if program == "derive":
            with printing() as printed:
                self.code = main(arguments)
            return printed.getvalue()
        if program not in PROGRAMS:
            raise ValueError(f"{place}: a page may run derive and {', '.join(PROGRAMS)}, not '{program}'")
        here = os.pathsep.join([str(self.folder), str(ROOT)])
        done = subprocess.run(
            [PROGRAMS[program], *arguments], capture_output=True, text=True, env={**os.environ, "PYTHONPATH": here}
        )
        self.code = done.returncode
        return done.stdout + done.stderr


def lines_before(block: Block) -> int:
    """The lines of the page above a block, so that a traceback names the line in the page."""
    return int(block.place.rpartition(":")[2]) - 1


@contextlib.contextmanager
def printing() -> Iterator[io.StringIO]:
    """What is printed, errors with the rest."""
    out = io.StringIO()
    with contextlib.redirect_stdout(out), contextlib.redirect_stderr(out):
        yield out


def commands(text: str) -> list[tuple[str, str]]:
    """The commands of a block, and what each prints."""
    parts = re.split(r"^\$ (.*)\n", text, flags=re.MULTILINE)
    assert not parts[0].strip(), f"what is printed stands below a command: {parts[0]}"
    return list(zip(parts[1::2], parts[2::2], strict=True))


def compare(expected: str, printed: str, place: str) -> None:
    """Fail if a page says something else than what is printed; how spaces and lines are set does not count."""
    options = doctest.ELLIPSIS | doctest.NORMALIZE_WHITESPACE | doctest.REPORT_NDIFF
    checker = doctest.OutputChecker()
    expected = expected.replace("…", "...")
    if not checker.check_output(expected, printed, options):
        example = doctest.Example("", expected)
        pytest.fail(f"{place}:\n{checker.output_difference(example, printed, options)}", pytrace=False)
