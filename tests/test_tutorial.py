"""What docs/tutorial.md says is what happens."""

from __future__ import annotations

from pathlib import Path

import pytest
from pages import ROOT, Reader, blocks

PAGES = [ROOT / "docs" / "tutorial.md"]


@pytest.fixture
def reader(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Reader:
    """A reader in a folder that is like a checkout as far as pages need it."""
    (tmp_path / "examples").symlink_to(ROOT / "examples")
    monkeypatch.syspath_prepend(str(tmp_path))
    return Reader(tmp_path)


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.stem)
def test_the_page_says_what_happens(page: Path, reader: Reader) -> None:
    assert reader.read(page, long=False) >= 10


@pytest.mark.long
@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.stem)
def test_the_whole_page_says_what_happens(page: Path, reader: Reader) -> None:
    assert reader.read(page, long=True) > len([block for block in blocks(page) if not block.long])
