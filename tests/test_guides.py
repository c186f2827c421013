"""What README.md and the guides say is what happens."""

from __future__ import annotations

import shutil
from collections.abc import Iterator
from pathlib import Path

import pytest
from pages import ROOT, Reader, blocks

from derive.emit.backends import BACKENDS

PAGES = [ROOT / "README.md", ROOT / "docs" / "tutorial.md", ROOT / "docs" / "extending.md"]


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
    assert reader.read(page, long=False) > 0


@pytest.mark.long
@pytest.mark.parametrize("page", PAGES[1:], ids=lambda page: page.stem)
def test_the_whole_page_says_what_happens(page: Path, reader: Reader) -> None:
    assert reader.read(page, long=True) > len([block for block in blocks(page) if not block.long])
