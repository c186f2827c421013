"""Shared by all tests: results are cached in a folder of the test run, never in the user's own."""

from __future__ import annotations

import os

import pytest
from hypothesis import settings

from derive import stages
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
