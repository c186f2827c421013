"""Symbols that are taken for each other, found from how they are declared and spelled.

Of a symbol only those of its own type are look-alikes: same kind, same sort, both with or both without an argument.
Nearest are those of its own letter, with other accents and scripts, the fewer differences the nearer (κ and κᵘ, d₁ and
d₂, γ and γ̄); then come those declared next to it (β and η, y and z). Nothing else is known of them.
"""

from __future__ import annotations

import re
from functools import cache

from derive.paper.conventions import Declared
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
    return _type(one) == _type(other)


def _type(one: Declared) -> tuple[object, ...]:
    return one.kind, one.sort, one.argument, one.arity, one.dimension


@cache
def ranked(name: str, scope: str, index: str = "") -> tuple[Declared, ...]:
    """All symbols of a scope that have the type of this one, nearest first; of a member of a family, members alike."""
    letters = conventions_of(scope)
    mine = letters.declared(name, index)
    members = [one for (_, letter), one in letters.by_letter.items() if letter == index]
    return _ranked(mine, members if index else list(letters.by_name.values()))


def _ranked(mine: Declared, declared: list[Declared]) -> tuple[Declared, ...]:
    place = declared.index(mine)

    def distance(other: Declared) -> tuple[int, int]:
        apart = abs(declared.index(other) - place)
        if base(other.latex) != base(mine.latex):
            return len(declared), apart
        return len(_marks(other.latex) ^ _marks(mine.latex)), apart

    return tuple(sorted((one for one in declared if one != mine and same_type(one, mine)), key=distance))


def difference(mine: Declared, other: Declared) -> str:
    """How two symbols differ: ``index`` (another subscript), ``bar`` (another accent or superscript), or ``symbol``."""
    if base(mine.latex) != base(other.latex):
        return "symbol"
    return "index" if all(mark.startswith("_") for mark in _marks(mine.latex) ^ _marks(other.latex)) else "bar"
