"""The ledger: the formulas that the article prints, as data, and its comparison with a source."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from functools import cache

from .conventions import scope_of
from .displays import Display, read_displays
from .errors import ReadError
from .order import entries
from .tokens import PUNCTUATION, tokenise

_SIZED = ("LPAR", "RPAR", "LBRACKET", "RBRACKET", "LSET", "RSET", "LBAR", "RBAR")  # brackets of any size


@dataclass(frozen=True)
class Record:
    """One display.

    id: its label. latex: as printed. scope: the section whose conventions hold; None if the reader has none. given:
    what the text around it assumes, as formulas. domain: the same in short words. line, column: in the source,
    where it is known.
    """

    id: str
    latex: str
    scope: str | None
    given: tuple[str, ...] = ()
    domain: str = ""
    line: int = 0
    column: int = 1


@dataclass(frozen=True)
class Difference:
    """A display that differs between ledger and source: missing on one side, or with other tokens.

    id: its label. line: in the source. kind: what differs. ledger, source: its LaTeX on either side.
    """

    id: str
    line: int
    kind: str  # "absent from the source", "absent from the ledger", "differs"
    ledger: str = ""
    source: str = ""


@cache
def load_ledger() -> dict[str, Record]:
    """All records by id, in the order of the article. ValueError for a record with unknown or missing fields."""
    records: dict[str, Record] = {}
    for entry in entries():
        unknown = set(entry) - {"id", "line", "latex", "given", "domain"}
        if unknown or entry["id"] in records:
            raise ValueError(f"ledger.toml: '{entry['id']}' is there twice or has unknown fields {sorted(unknown)}")
        latex = entry["latex"].strip()
        given, domain = tuple(entry.get("given", ())), entry.get("domain", "")
        records[entry["id"]] = Record(
            entry["id"], latex, scope_of(entry["id"]), given, domain, entry.get("line", 0)
        )  # fmt: skip
    return records


def from_source(text: str, only: Iterable[str] | None = None) -> dict[str, Record]:
    """The records of a LaTeX source: formulas from the source; hypotheses, which stand in its prose, from the ledger.

    text: the source. only: the ids wanted. ReadError if the source cannot be split into displays.
    """
    wanted = None if only is None else set(only)
    ledger = load_ledger()
    found = {}
    for display in read_displays(text):
        if wanted is None or display.label in wanted:
            found[display.label] = _merged(display, ledger.get(display.label))
    return found


def _merged(display: Display, known: Record | None) -> Record:
    given, domain = (known.given, known.domain) if known else ((), "")
    scope = scope_of(display.label)
    return Record(display.label, display.latex, scope, given, domain, display.line, display.column)


def compare(ledger: dict[str, Record], source_text: str) -> list[Difference]:
    """Where the ledger and source_text differ, token by token.

    Spaces, brackets' sizes and closing punctuation do not count.
    """
    source = {display.label: display for display in read_displays(source_text)}
    differences = []
    for label, record in ledger.items():
        if label not in source:
            differences.append(Difference(label, 0, "absent from the source", record.latex))
        elif _tokens(record.latex) != _tokens(source[label].latex):
            display = source[label]
            differences.append(Difference(label, display.line, "differs", record.latex, display.latex))
    for label, display in source.items():
        if label not in ledger:
            differences.append(Difference(label, display.line, "absent from the ledger", "", display.latex))
    return differences


def _tokens(latex: str) -> list[str]:
    try:
        tokens = tokenise(latex)
    except ReadError:  # not yet readable: compare the characters
        return latex.split()
    while tokens and tokens[-1].type in PUNCTUATION:
        tokens.pop()
    return [token[-1] if token.type in _SIZED else str(token) for token in tokens]
