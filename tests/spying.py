"""What a function of a kernel is called with, while it does its work as before."""

from __future__ import annotations

from typing import Any

import pytest


def calls_of(monkeypatch: pytest.MonkeyPatch, module: Any, name: str) -> list[tuple[Any, ...]]:
    """A list to which every later call of the module's function adds its arguments."""
    heard: list[tuple[Any, ...]] = []
    function = getattr(module, name)

    def called(*given: Any) -> Any:
        heard.append(given)
        return function(*given)

    monkeypatch.setattr(module, name, called)
    return heard
