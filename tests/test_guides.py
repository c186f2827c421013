"""What README.md and the guides say is what happens."""

from __future__ import annotations

import shutil
from collections.abc import Iterator
from itertools import pairwise
from pathlib import Path

import pytest
from pages import ROOT, Reader, blocks, calls

from derive.cli import main
from derive.emit.backends import BACKENDS
from derive.options import parser

PAGES = [ROOT / "README.md", *(ROOT / "docs" / f"{name}.md" for name in ("sweep", "extending", "tutorial"))]


@pytest.fixture
def reader(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Reader]:
    """A reader in a copy of the checkout, as far as pages need it."""
    without = shutil.ignore_patterns("__pycache__")
    for part in ("derive", "templates", "examples"):
        shutil.copytree(ROOT / part, tmp_path / part, ignore=without)
    monkeypatch.syspath_prepend(str(tmp_path))
    kept = dict(BACKENDS)
    yield Reader(tmp_path)
    BACKENDS.clear()
    BACKENDS.update(kept)


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.stem)
def test_the_page_says_what_happens(page: Path, reader: Reader) -> None:
    assert reader.read(page) > 0


@pytest.mark.long
@pytest.mark.parametrize("page", PAGES[2:], ids=lambda page: page.stem)
def test_the_whole_page_says_what_happens(page: Path, reader: Reader) -> None:
    assert reader.read(page, "long") > len([block for block in blocks(page) if not block.mark])


@pytest.mark.hours
def test_the_tutorial_to_its_end(reader: Reader) -> None:
    assert reader.read(PAGES[-1], "long", "hours") == len(blocks(PAGES[-1]))


CALLS = [(page, call) for page in (ROOT / "README.md", *sorted((ROOT / "docs").glob("*.md"))) for call in calls(page)]


@pytest.mark.long
@pytest.mark.parametrize(("page", "call"), CALLS, ids=lambda value: "" if isinstance(value, list) else value.stem)
def test_a_command_that_a_page_names_runs(
    page: Path, call: list[str], reader: Reader, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(reader.folder)
    if call[0] == "measure":  # takes many minutes; the quick run has a test of its own
        assert parser().parse_args(call).command == "measure"
        return
    assert main(call) == 0
    for option, file in pairwise(call):
        assert option not in ("--plot", "--csv", "--npz") or Path(file).stat().st_size > 100


def test_pages_name_commands() -> None:
    assert {page.stem for page, _ in CALLS} >= {"README", "solve", "sweep"}


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("```python\nprint(1)\n```\n\n```\n2\n```\n", "page.md:2"),
        ("```python\nprint(1)\n```\n", "page.md:2"),
        ("```console\n$ derive solve paralel\nderive solve: no scene …\n```\n", "exit code 2"),
        ("```console\n$ derive solve paralel\nno such words\n$ echo $?\n2\n```\n", "did you mean 'parallel'"),
        ("```console\n$ rm -r derive\n```\n", "a page may run derive and python, git, not 'rm'"),
    ],
)
def test_a_page_that_says_something_else_is_seen(text: str, words: str, reader: Reader, tmp_path: Path) -> None:
    page = tmp_path / "page.md"
    page.write_text(text, encoding="utf-8")
    with pytest.raises((pytest.fail.Exception, AssertionError, ValueError)) as error:
        reader.read(page)
    assert words in str(error.value)


def test_what_a_page_leaves_out_is_anything(reader: Reader, tmp_path: Path) -> None:
    page = tmp_path / "page.md"
    page.write_text(
        "<!-- file one.py -->\n```python\nprint('a', 1, 'b')\n```\n\n```console\n$ python one.py\na … b\n```\n\n"
        "<!-- long -->\n```python\nraise SystemExit\n```\n",
        encoding="utf-8",
    )
    assert reader.read(page) == 2
