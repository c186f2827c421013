"""Shared by all tests: results are cached in a folder of the test run, never in the user's own."""

from __future__ import annotations

import os
from collections.abc import Callable
from dataclasses import asdict
from types import SimpleNamespace
from typing import Any

import pytest
from hypothesis import settings

from derive import pipeline, stages
from derive.check.verdicts import PROVED
from derive.paper.ledger import load_ledger
from derive.runner import Runner
from derive.stages import Task
from derive.theory.chain import Theory

settings.register_profile("steady", deadline=None, derandomize=True, max_examples=40)
settings.load_profile("steady")


@pytest.fixture(scope="session", autouse=True)
def own_cache(tmp_path_factory: pytest.TempPathFactory) -> None:
    """Point DERIVE_CACHE to a folder of this run of the tests, for all its processes and those they start.

    Entries are named by what they depend on and written whole, so that processes can share them. The folder is empty at
    first; DERIVE_TEST_CACHE names another one, in which a job just before may have left its entries.
    """
    if given := os.environ.get("DERIVE_TEST_CACHE"):
        os.environ["DERIVE_CACHE"] = given
        return
    base = tmp_path_factory.getbasetemp()
    folder = (base.parent if "PYTEST_XDIST_WORKER" in os.environ else base) / "cache"
    folder.mkdir(exist_ok=True)
    os.environ["DERIVE_CACHE"] = str(folder)


@pytest.fixture(scope="session")
def theory() -> Theory:
    """The whole derivation, once in each process. A test that changes it makes its own."""
    return stages.theory()


@pytest.hookimpl(trylast=True)
def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Long tests come first, so that no process is left alone with one of them at the end.

    Each process is handed the next part of the list, and takes over from the end of another's when its own is done: so
    the long tests are dealt out, and every part begins with its share of them.
    """
    hands = int(os.environ.get("PYTEST_XDIST_WORKER_COUNT", "1"))
    long = [item for item in items if item.get_closest_marker("long")]
    short = [item for item in items if not item.get_closest_marker("long")]
    ordered: list[pytest.Item] = []
    for hand in range(hands):
        share, size = long[hand::hands], (len(items) - len(ordered)) // (hands - hand)
        ordered += share + [short.pop(0) for _ in range(min(len(short), size - len(share)))]
    items[:] = ordered + short


@pytest.fixture(scope="session")
def judged(own_cache: None) -> Callable[[str], Any]:
    """The main job's verdict on a printed formula, or a claim of the running text; what is refuted is mended.

    It comes from the cache of this run of the tests, which all processes share and which nothing stale is taken from.
    """
    claims = {claim["id"]: claim for claim in stages.list_text()}

    def verdict(name: str) -> SimpleNamespace:
        job, record = pipeline.Job(), load_ledger().get(name)
        asked = ([], [claims[name]]) if record is None else ([asdict(record)], [])
        pipeline.judge_paper(Runner(jobs=1), job, *asked)
        return said(job.printed[0])

    return verdict


@pytest.fixture(scope="session")
def unproved(own_cache: None) -> Callable[[str], list[str]]:
    """The claims of a section of the derivation that the main job does not prove; from the same cache."""

    def found(section: str) -> list[str]:
        names = [name for name in stages.derived()[1].claims if name.startswith(section)]
        assert len(names) > 30
        tasks = [Task("check", name, stages.judge_claim, (name,), stages.CHECK) for name in names]
        verdicts = Runner(jobs=1).results(tasks)
        return [name for name, one in zip(names, verdicts, strict=True) if one["verdict"] != PROVED]

    return found


def said(verdict: dict[str, Any]) -> SimpleNamespace:
    """A verdict from its plain data, with the names of `FormulaVerdict` and `StatementVerdict`."""
    statements = [SimpleNamespace(**one) for one in verdict.get("statements", ())]
    return SimpleNamespace(**{**verdict, "statements": statements})
