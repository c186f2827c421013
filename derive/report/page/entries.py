"""Printed formulas as the page shows them: printed beside derived, what was found, and on what they rest."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from typing import Any

from derive.report import contents as said
from derive.report.contents import Derived, Record
from derive.report.errata import errata
from derive.report.page.words import Html, anchor

WORDS = Html()
# Each verdict has a mark of its own, so that none is told by colour alone.
MARKS = {
    "PROVED": "✓", "CERTIFIED": "◎", "AGREED": "≈", "DEFINITION": "≔", "REFUTED": "✗", "UNKNOWN": "?", "UNREAD": "∅",
}  # fmt: skip


def verdicts(counts: Sequence[Record]) -> list[dict[str, Any]]:
    """The verdicts that occur, with their marks."""
    return [{**one, "mark": MARKS[one["verdict"]]} for one in counts]


def entries(
    formulas: Sequence[Record],
    derived: Derived,
    records: Mapping[str, Record],
    grounds: Mapping[str, Sequence[str]],
    claims: Collection[str],
) -> dict[str, Any]:
    """Counts, errata and sections of printed formulas; grounds: the claims behind each label; claims: all there are."""
    found = said.contents(formulas, derived, records, WORDS)
    known = {one["id"]: (one, records.get(one["id"], one)) for one in formulas}
    for part in found["sections"]:
        shown = [entry(one, *known[one["id"]], derived) for one in part["entries"]]
        part["entries"] = [{**one, "rests": rests(grounds.get(one["id"], ()), claims)} for one in shown]
        part["anchor"] = anchor("section", part["title"])
    places = dict.fromkeys(one["id"] for one in found["errata"])
    return {
        **found,
        "counts": verdicts(found["counts"]),
        "errata": [{**one, "anchor": anchor(one["id"])} for one in found["errata"]],
        "refuted": [{"id": name, "anchor": anchor(name)} for name in places],
    }


def entry(shown: Record, formula: Record, record: Record, derived: Derived) -> dict[str, Any]:
    """One formula with its counterexamples, for a template."""
    return {
        **shown,
        "anchor": anchor(formula["id"]),
        "mark": MARKS[shown["verdict"]],
        "source": " ".join(str(formula["printed"]).split()),
        "failures": list(errata(formula, derived, record, WORDS)),
        "search": " ".join((formula["id"], shown["method"], str(formula["printed"]))).lower(),
    }


def rests(names: Sequence[str], claims: Collection[str]) -> list[dict[str, str]]:
    """Links to claims."""
    return [{"id": name, "anchor": anchor("claim", name)} for name in names if name in claims]
