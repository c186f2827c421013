"""Packages that only peers need: a peer whose package is not installed is left out, and that is said."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from importlib.util import find_spec
from typing import Protocol


class Needing(Protocol):
    """A method or a solver with the packages that it needs, by the names they are imported by."""

    @property
    def name(self) -> str:
        """What it is called in tables."""

    @property
    def needs(self) -> tuple[str, ...]:
        """Packages without which it is left out."""


def absent(one: Needing) -> list[str]:
    """Packages that it needs and that are not there; they are looked for, not imported."""
    return [name for name in one.needs if find_spec(name) is None]


def left_out(those: Iterable[Needing]) -> list[str]:
    """A line for each set of packages that are not there: who is left out for them."""
    missing: dict[Sequence[str], list[str]] = {}
    for one in those:
        if packages := tuple(absent(one)):
            missing.setdefault(packages, []).append(one.name)
    return [
        f"left out, for {' and '.join(packages)} cannot be imported: {', '.join(names)}"
        for packages, names in missing.items()
    ]
