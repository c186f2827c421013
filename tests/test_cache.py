"""The cache: an entry belongs to the bytes it was computed from, and a broken one is no entry."""

from __future__ import annotations

from pathlib import Path

import pytest

from derive.cache import Cache, digest, folder, reading_once, write_atomically


@pytest.fixture
def sources(tmp_path: Path) -> Path:
    (tmp_path / "part" / "deeper").mkdir(parents=True)
    (tmp_path / "part" / "one.py").write_text("a = 1\n")
    (tmp_path / "part" / "deeper" / "scene.toml").write_text("x = 1\n")
    return tmp_path / "part"


def through(cache, key, compute):
    """What the runner does: the entry, computed and kept if it is absent."""
    found = cache.get(key)
    if found is None:
        found = compute()
        cache.put(key, found)
    return found


def test_an_entry_is_computed_once(tmp_path: Path) -> None:
    cache, calls = Cache(place=tmp_path), []

    def compute() -> dict[str, int]:
        calls.append(1)
        return {"answer": 42}

    assert through(cache, "ab" * 32, compute) == through(cache, "ab" * 32, compute) == {"answer": 42}
    assert len(calls) == 1


def test_without_the_cache_nothing_is_written(tmp_path: Path) -> None:
    cache = Cache(enabled=False, place=tmp_path)
    assert through(cache, "ab" * 32, lambda: 1) == 1
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize("damage", ["", "{", "[]", '{"key": "other", "result": 7}', "\x00"])
def test_a_damaged_entry_is_computed_again(tmp_path: Path, damage: str) -> None:
    cache = Cache(place=tmp_path)
    cache.put("cd" * 32, 1)
    (entry,) = tmp_path.rglob("*.json")
    entry.write_text(damage)
    assert through(cache, "cd" * 32, lambda: 2) == 2
    assert cache.get("cd" * 32) == 2


@pytest.mark.parametrize("change", ["byte", "name", "new file", "stage", "input"])
def test_every_dependency_is_in_the_name(sources: Path, change: str) -> None:
    before, stage, inputs = digest("stage", [sources], {"n": 1}), "stage", {"n": 1}
    match change:
        case "byte":
            (sources / "deeper" / "scene.toml").write_text("x = 2\n")
        case "name":
            (sources / "one.py").rename(sources / "two.py")
        case "new file":
            (sources / "three.py").write_text("")
        case "stage":
            stage = "other"
        case "input":
            inputs = {"n": 2}
    assert digest(stage, [sources], inputs) != before


def test_the_place_of_the_checkout_is_not_in_the_name(sources: Path) -> None:
    before = digest("stage", [sources, sources / "one.py"])
    moved = sources.rename(sources.with_name("elsewhere"))
    assert digest("stage", [moved, moved / "one.py"]) == before


def test_compiled_files_do_not_count(sources: Path) -> None:
    before = digest("stage", [sources])
    (sources / "__pycache__").mkdir()
    (sources / "__pycache__" / "one.py").write_text("")
    assert digest("stage", [sources]) == before


def test_sources_are_read_once_where_that_is_said(sources: Path) -> None:
    before = digest("stage", [sources], 1)
    with reading_once():
        assert digest("stage", [sources], 1) == before
        (sources / "one.py").write_text("x = 3\n")
        assert digest("stage", [sources], 1) == before  # of the moment when they were read
        assert digest("stage", [sources], 2) != before
    assert digest("stage", [sources], 1) != before
    with reading_once():
        assert digest("stage", [sources], 1) != before


def test_the_folder_follows_the_environment(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setenv("DERIVE_CACHE", str(tmp_path / "here"))
    assert folder() == tmp_path / "here"
    monkeypatch.delenv("DERIVE_CACHE")
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    assert folder() == tmp_path / "magnetic-rods"


def test_a_failed_write_leaves_the_old_file(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = tmp_path / "result.json"
    write_atomically(path, "old")
    monkeypatch.setattr("os.replace", lambda *_: (_ for _ in ()).throw(OSError("disk full")))
    with pytest.raises(OSError, match="disk full"):
        write_atomically(path, "new")
    assert path.read_text() == "old"
    assert list(tmp_path.iterdir()) == [path]


def test_a_cache_that_cannot_be_written_only_costs_time(tmp_path: Path) -> None:
    blocked = tmp_path / "file"
    blocked.write_text("")
    assert through(Cache(place=blocked / "below"), "ef" * 32, lambda: 3) == 3
