"""The labels of the article in their order: those of the ledger."""

from __future__ import annotations

import tomllib
from functools import cache
from importlib.resources import files
from typing import Any


@cache
def entries() -> tuple[dict[str, Any], ...]:
    """The ledger as it is written."""
    return tuple(tomllib.loads(files(__package__).joinpath("ledger.toml").read_text(encoding="utf-8"))["formula"])


@cache
def labels() -> tuple[str, ...]:
    """All labels in the order of the article."""
    return tuple(entry["id"] for entry in entries())
