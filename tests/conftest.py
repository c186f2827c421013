"""Shared by all tests: results are cached in a folder of the test run, never in the user's own."""

from __future__ import annotations

import os

import pytest
from hypothesis import settings

settings.register_profile("steady", deadline=None, derandomize=True, max_examples=40)
settings.load_profile("steady")


@pytest.fixture(scope="session", autouse=True)
def own_cache(tmp_path_factory: pytest.TempPathFactory) -> None:
    """Point DERIVE_CACHE to an empty folder, for this process and those it starts."""
    os.environ["DERIVE_CACHE"] = str(tmp_path_factory.mktemp("cache"))
