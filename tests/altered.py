"""Answers of modules with other values, whatever kind of record a module makes."""

from __future__ import annotations

from dataclasses import replace
from typing import Any


def altered(record: Any, **values: Any) -> Any:
    """The record with some values changed."""
    return record._replace(**values) if hasattr(record, "_replace") else replace(record, **values)
