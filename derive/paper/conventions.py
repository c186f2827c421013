"""The meaning of the printed letters, by section: the records of ``conventions*.toml``."""

from __future__ import annotations

import re
import tomllib
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, replace
from functools import cache
from importlib.resources import files
from typing import Any

from .order import labels
from .spelling import spelling
from .syntax import syntax_tree
from .tokens import Tokeniser
from .tree import SCALAR

_FILES = ("conventions.toml", "conventions_rod.toml", "conventions_plane.toml", "conventions_elliptic.toml")
_ALLOWED = {
    "latex", "also", "name", "meaning", "kind", "argument", "alternatives", "sort", "arity", "prefix", "assume",
    "scopes", "index", "dimension", "introduced",
}  # fmt: skip
KINDS = ("scalar", "vector", "tensor", "region", "function", "order")
LETTERS = {"i": "i", "j": "j", "k": "k", r"\alpha": "alpha", r"\beta": "beta"}  # of indices, as printed and named
_GREEK = (r"\alpha", r"\beta")


@dataclass(frozen=True)
class Declared:
    """One symbol: see the head of ``conventions.toml`` for the fields. index: the letter of a member of a family."""

    name: str
    latex: str
    meaning: str
    kind: str
    argument: str = ""
    alternatives: tuple[str, ...] = ()
    sort: str = ""
    arity: tuple[int, ...] = ()
    prefix: bool = False
    assume: tuple[str, ...] = ()
    index: str = ""
    dimension: int = 1
    introduced: str = ""

    @property
    def callable(self) -> bool:
        """May it carry arguments?"""
        return self.kind in ("function", "order") or bool(self.argument)

    @property
    def type(self) -> str:
        """Of the symbol, or of the values of the function."""
        return SCALAR if self.kind in ("function", "order") else self.kind


@dataclass(frozen=True)
class Scope:
    """The symbols of one section: by canonical spelling, and by name.

    Members of families stand in ``by_name`` by number, ``d_3``; by letter, d_i, they are in ``by_letter``.
    """

    name: str
    by_spelling: Mapping[str, Declared]
    by_name: Mapping[str, Declared]
    by_letter: Mapping[tuple[str, str], Declared]
    types: Mapping[str, str]  # of the symbols of a sort

    def declared(self, name: str, index: str = "") -> Declared:
        """The symbol of a Name or a Call; KeyError if there is none."""
        return self.by_letter[name, index] if index else self.by_name[name]


def canonical(latex: str) -> str:
    """The canonical spelling of a printed symbol, say ``\\boldsymbol{d}_{3}`` for ``\\boldsymbol d_3``.

    A ReadError says why if the text is no symbol.
    """
    source = Tokeniser(latex)
    tree = syntax_tree(source.run(), source.error)
    return spelling(tree.children[0], source.error, powers=True)


@cache
def _data() -> dict[str, Any]:
    read = [tomllib.loads(files(__package__).joinpath(name).read_text(encoding="utf-8")) for name in _FILES]
    return {**read[0], "symbol": [symbol for part in read for symbol in part.get("symbol", ())]}


def _record(data: dict[str, Any]) -> Declared:
    unknown = set(data) - _ALLOWED
    if unknown or data["kind"] not in KINDS or data.get("index", "latin") not in ("latin", "greek"):
        raise ValueError(f"conventions: symbol {data.get('name')}: unknown fields {sorted(unknown)}, kind or index")
    own = {key: data[key] for key in _ALLOWED - {"latex", "also", "scopes"} if key in data}
    own |= {key: tuple(own[key]) for key in ("arity", "assume", "alternatives") if key in own}
    return Declared(latex=canonical(data["latex"]), **own)


def _members(data: dict[str, Any]) -> Iterator[Declared]:
    """The symbol, or all members of the family: by number and by letter."""
    record = _record(data)
    if not record.index:
        yield record
        return
    greek = record.index == "greek"
    for number in range(1, 3 if greek else 4):
        yield replace(record, name=f"{record.name}_{number}", latex=_indexed(record.latex, str(number)), index="")
    for letter in _GREEK if greek else LETTERS:
        yield replace(record, latex=_indexed(record.latex, letter), index=LETTERS[letter])


def _indexed(latex: str, index: str) -> str:
    return re.sub(r"([_^])\{(?:i|\\alpha)\}", lambda match: f"{match[1]}{{{index}}}", latex, count=1)


@cache
def scope(name: str) -> Scope:
    """The symbols of a section. ValueError for an unknown section or a symbol declared twice in it."""
    if name not in _data()["scopes"]:
        raise ValueError(f"there is no scope '{name}'; the scopes are {', '.join(_data()['scopes'])}")
    by_spelling: dict[str, Declared] = {}
    by_name: dict[str, Declared] = {}
    by_letter: dict[tuple[str, str], Declared] = {}
    for data in _data()["symbol"]:
        if name not in _scopes(data):
            continue
        for record in _members(data):
            others = data.get("also", ()) if not record.index else ()
            for spelled in (record.latex, *(canonical(other) for other in others)):
                if spelled in by_spelling:
                    raise ValueError(f"conventions: '{spelled}' is declared twice in scope '{name}'")
                by_spelling[spelled] = record
            if record.index:
                by_letter[record.name, record.index] = record
            elif record.name in by_name:
                raise ValueError(f"conventions: the name '{record.name}' is declared twice in scope '{name}'")
            else:
                by_name[record.name] = record
    return Scope(name, by_spelling, by_name, by_letter, _types_of_sorts(name, by_spelling.values()))


def _types_of_sorts(name: str, records: Iterable[Declared]) -> dict[str, str]:
    types: dict[str, str] = {}
    records = list(records)
    for record in records:
        if record.sort and types.setdefault(record.sort, record.type) != record.type:
            raise ValueError(f"conventions: the sort '{record.sort}' has two types in scope '{name}'")
    for record in records:
        for word in " ".join((record.argument, *record.alternatives)).split():
            types.setdefault(word, SCALAR)
    return types


def _scopes(data: dict[str, Any]) -> list[str]:
    """The scopes of a symbol; the names of groups stand for all scopes in them."""
    groups = _data()["groups"]
    return [name for one in data.get("scopes", list(_data()["scopes"])) for name in groups.get(one, [one])]


def scope_of(label: str) -> str | None:
    """The section to which a label belongs, in the order of the article; None for a label that is not in it."""
    order = labels()
    if label not in order:
        return None
    for name, (first, last) in _data()["scopes"].items():
        if order.index(first) <= order.index(label) <= order.index(last):
            return str(name)
    return None
