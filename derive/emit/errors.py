"""Errors of the emitter: each says the place, what is wrong, and what mends it."""

from __future__ import annotations

from collections.abc import Iterable
from difflib import get_close_matches


class EmitError(Exception):
    """A module cannot be emitted."""


class SceneError(EmitError):
    """A scene file says something that is not possible; ``place`` is ``file:line``."""

    def __init__(self, place: str, message: str) -> None:
        self.place = place
        super().__init__(f"{place}: {message}")


class DifferentValueError(EmitError):
    """Calls give parameters or fields with the name of a folded constant another value; ``pairs``: (callee, name)."""

    def __init__(self, message: str, pairs: Iterable[tuple[str, str]]) -> None:
        self.pairs = frozenset(pairs)
        super().__init__(message)


def choices(wrong: str, possible: Iterable[str]) -> str:
    """The end of an error message: a close match, if there is one, and all that is possible."""
    names = sorted(possible)
    close = get_close_matches(wrong, names, n=1)
    hint = f"; did you mean '{close[0]}'?" if close else ";"
    return f"{hint} possible: {', '.join(names) or 'nothing'}"
