"""Symbols that are taken for each other, found from how they are declared and spelled.

Of a symbol only those of its own type are look-alikes: same kind, same sort, both with or both without an argument.
Nearest are those of its own letter, with other accents and scripts, the fewer differences the nearer (κ and κᵘ, d₁ and
d₂, γ and γ̄); then come those declared next to it (β and η, y and z). Nothing else is known of them.
"""

from __future__ import annotations

import re
from functools import cache

from derive.paper.conventions import Declared, Scope
from derive.paper.conventions import scope as conventions_of

_TOKEN = re.compile(r"\\[A-Za-z]+|[A-Za-z0-9]|[_^]")
_ACCENTS = {
    r"\hat", r"\overline", r"\bar", r"\tilde", r"\boldsymbol", r"\mathrm", r"\mathsf", r"\mathbbm", r"\mathscr",
    r"\mathcal", r"\mathfrak",
}  # fmt: skip


def base(latex: str) -> str:
    """The letter of a symbol, without accents, fonts and scripts."""
    return next((token for token in _TOKEN.findall(latex) if token not in _ACCENTS), latex)


def _marks(latex: str) -> set[str]:
    """The accents of a symbol, and each script with its place."""
    letter, script = base(latex), ""
    found = set()
    for token in _TOKEN.findall(latex):
        if token in "_^":
            script = token
        elif script or token != letter:
            found.add(script + token)
    return found


def same_type(one: Declared, other: Declared) -> bool:
    """May one stand wherever the other stands?"""
    return (one.kind, one.sort, one.argument, one.arity) == (other.kind, other.sort, other.argument, other.arity)


@cache
def ranked(name: str, scope: str) -> tuple[Declared, ...]:
    """All symbols of a scope that have the type of this one, nearest first."""
    return _ranked(conventions_of(scope).by_name[name], conventions_of(scope))


def _ranked(mine: Declared, letters: Scope) -> tuple[Declared, ...]:
    declared = list(letters.by_name.values())
    place = declared.index(mine)

    def distance(other: Declared) -> tuple[int, int]:
        apart = abs(declared.index(other) - place)
        if base(other.latex) != base(mine.latex):
            return len(declared), apart
        return len(_marks(other.latex) ^ _marks(mine.latex)), apart

    return tuple(sorted((one for one in declared if one != mine and same_type(one, mine)), key=distance))


def difference(name: str, other: Declared, scope: str) -> str:
    """How two symbols differ: ``index`` (another subscript), ``bar`` (another accent or superscript), or ``symbol``."""
    mine = conventions_of(scope).by_name[name]
    if base(mine.latex) != base(other.latex):
        return "symbol"
    return "index" if all(mark.startswith("_") for mark in _marks(mine.latex) ^ _marks(other.latex)) else "bar"
