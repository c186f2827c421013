"""Where two printed statements differ: the smallest parts that are not the same, in pairs.

A part that is one letter is shown with what it stands in.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import fields

from derive.paper import tree as t
from derive.paper.printer import to_latex

Pair = tuple[t.Node, t.Node]


def differences(old: t.Statement, new: t.Statement, scope: str) -> list[tuple[str, str]]:
    """Each part of the old statement that is another in the new one, with that part, in LaTeX; empty if only relations
    differ."""
    pairs = [pair for sides in zip(old.sides, new.sides, strict=False) for pair in _below(*sides)]
    return [(to_latex(before, scope), to_latex(after, scope)) for before, after in dict.fromkeys(pairs)]


def _below(old: t.Node, new: t.Node) -> Iterator[Pair]:
    if old == new:
        return
    alike = type(old) is type(new) and len(old.parts()) == len(new.parts()) and _own(old) == _own(new)
    if not alike or not old.parts() or _exchanged(old, new):
        yield old, new
        return
    for before, after in zip(old.parts(), new.parts(), strict=True):
        if before != after and not (before.parts() and after.parts()):
            yield old, new
            return
    for pair in zip(old.parts(), new.parts(), strict=True):
        yield from _below(*pair)


def _own(node: t.Node) -> list[object]:
    """What a node says itself, beside its parts."""
    values = (getattr(node, one.name) for one in fields(node) if one.compare)
    return [value for value in values if not isinstance(value, t.Node | tuple)]


def _exchanged(old: t.Node, new: t.Node) -> bool:
    """Do the two hold the same parts in another order?"""
    return len(old.parts()) > 1 and set(old.parts()) == set(new.parts())
