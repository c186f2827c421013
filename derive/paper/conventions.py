"""The meaning of the printed letters, by section: the records of ``conventions.toml``."""

from __future__ import annotations

import re
import tomllib
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache
from importlib.resources import files
from typing import Any

from .spelling import spelling
from .syntax import syntax_tree
from .tokens import Tokeniser

_ALLOWED = {
    "latex", "also", "name", "meaning", "kind", "argument", "sort", "arity", "prefix", "assume", "scopes",
}  # fmt: skip


@dataclass(frozen=True)
class Declared:
    """One symbol: see the head of ``conventions.toml`` for the fields."""

    name: str
    latex: str
    meaning: str
    kind: str
    argument: str = ""
    sort: str = ""
    arity: tuple[int, ...] = ()
    prefix: bool = False
    assume: tuple[str, ...] = ()

    @property
    def callable(self) -> bool:
        """May it carry arguments?"""
        return self.kind == "function" or bool(self.argument)


@dataclass(frozen=True)
class Scope:
    """The symbols of one section: by canonical spelling, and by name."""

    name: str
    by_spelling: Mapping[str, Declared]
    by_name: Mapping[str, Declared]


def canonical(latex: str) -> str:
    """The canonical spelling of a printed symbol, say ``\\boldsymbol{d}_{3}`` for ``\\boldsymbol d_3``.

    A ReadError says why if the text is no symbol.
    """
    source = Tokeniser(latex)
    tree = syntax_tree(source.run(), source.error)
    return spelling(tree.children[0], source.error)


@cache
def _data() -> dict[str, Any]:
    return tomllib.loads(files(__package__).joinpath("conventions.toml").read_text(encoding="utf-8"))


def _record(data: dict[str, Any]) -> Declared:
    unknown = set(data) - _ALLOWED
    if unknown or data["kind"] not in ("scalar", "vector", "function"):
        raise ValueError(f"conventions.toml: symbol {data.get('name')}: unknown fields {sorted(unknown)} or kind")
    own = {key: data[key] for key in ("name", "meaning", "kind", "argument", "sort", "prefix") if key in data}
    return Declared(
        latex=canonical(data["latex"]), arity=tuple(data.get("arity", ())), assume=tuple(data.get("assume", ())), **own
    )


@cache
def scope(name: str) -> Scope:
    """The symbols of a section. ValueError for an unknown section or a symbol declared twice in it."""
    if name not in _data()["scopes"]:
        raise ValueError(f"there is no scope '{name}'; the scopes are {', '.join(_data()['scopes'])}")
    by_spelling: dict[str, Declared] = {}
    by_name: dict[str, Declared] = {}
    for data in _data()["symbol"]:
        if name not in data.get("scopes", [name]):
            continue
        record = _record(data)
        for spelled in (record.latex, *(canonical(other) for other in data.get("also", ()))):
            if spelled in by_spelling:
                raise ValueError(f"conventions.toml: '{spelled}' is declared twice in scope '{name}'")
            by_spelling[spelled] = record
        if record.name in by_name:
            raise ValueError(f"conventions.toml: the name '{record.name}' is declared twice in scope '{name}'")
        by_name[record.name] = record
    return Scope(name, by_spelling, by_name)


def scope_of(label: str) -> str | None:
    """The section to which a label belongs, or None if the reader has no conventions for it."""
    place = _order(label)
    for name, (first, last) in _data()["scopes"].items():
        if place and _order(first) <= place <= _order(last) and place[0] == _order(first)[0]:
            return str(name)
    return None


def _order(label: str) -> tuple[str, int, str]:
    """Labels in the order of the article: letters, number, letters."""
    match = re.fullmatch(r"([A-Za-z]+)(\d+)([A-Za-z]*)", label)
    return (match[1], int(match[2]), match[3]) if match else (label, 0, "")
