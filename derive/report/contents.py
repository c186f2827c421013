"""What a report says of printed formulas, from plain records of verdicts and derived forms, in any language."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from derive.report import text as tex
from derive.report.errata import errata, place
from derive.report.words import Words

Record = Mapping[str, Any]
Derived = Mapping[str, Sequence[Record]]  # the derived forms of the statements of each formula
# Verdicts in the order of trust, with a colour of the template and their meaning.
VERDICTS = {
    "PROVED": ("good", "by computer algebra, in every reading of the formula"),
    "CERTIFIED": ("good", "by arithmetic with guaranteed bounds"),
    "AGREED": ("plain", "numerically, to the digits given"),
    "DEFINITION": ("plain", "introduces a name; agrees with the theory's own"),
    "REFUTED": ("bad", "fails as printed, at the point given"),
    "UNKNOWN": ("bad", "neither proved nor refuted"),
    "UNREAD": ("bad", "not read"),
}
# Sections of the conventions, as the article names its parts.
TITLES = {
    "kirchhoff": "Kirchhoff's theory of rods",
    "magnetization": "Energy and magnetization of the particles",
    "line_energy": "Magnetic energy of a rod",
    "variation": "Equilibrium from the energy",
    "couple": "Equilibrium from the couple on the magnetization",
    "cantilever": "The cantilever, and its units",
    "plane": "The plane problem",
    "planarity": "Why the rod stays in a plane",
    "parallel": "Field along the force",
    "field_only": "Field alone",
    "force_only": "Force alone",
    "orthogonal": "Field across the force",
}
TEXT = "text."  # ids of claims of the running text begin so


def contents(
    formulas: Sequence[Record], derived: Derived, records: Mapping[str, Record], words: Words
) -> dict[str, Any]:
    """Counts, errata, and every formula by section; arguments as of ``document.document``."""
    counted = [str(one["verdict"]) for one in formulas]
    known = {one["id"]: records.get(one["id"], one) for one in formulas}
    entries = [(title_of(known[one["id"]], words), entry(one, derived, known[one["id"]], words)) for one in formulas]
    titles = dict.fromkeys(title for title, _ in entries)
    return {
        "counts": [
            {"verdict": name, "number": counted.count(name), "colour": colour, "meaning": meaning}
            for name, (colour, meaning) in VERDICTS.items()
            if name in counted
        ],
        "errata": [one for formula in formulas for one in errata(formula, derived, known[formula["id"]], words)],
        "sections": [
            {"title": title, "entries": [one for other, one in entries if other == title]} for title in titles
        ],
    }


def title_of(record: Record, words: Words) -> str:
    """The part of the article in which a formula stands."""
    if record["id"].startswith(TEXT):
        return "Claims of the running text"
    scope = str(record.get("scope") or "")
    return TITLES.get(scope, words.text(scope.replace("_", " ").capitalize() or "Other formulas"))


def row(formula: Record, words: Words) -> dict[str, Any]:
    """A line of the last table."""
    verdict = str(formula["verdict"])
    method = "; ".join(dict.fromkeys(formula["method"].split("; ")))
    return {
        "id": formula["id"],
        "label": words.text(formula["id"]),
        "statements": len(formula["statements"]) or 1,
        "verdict": verdict,
        "colour": VERDICTS[verdict][0],
        "method": words.text(method),
    }


def entry(formula: Record, derived: Derived, record: Record, words: Words) -> dict[str, Any]:
    """One formula in the order of the article."""
    verdict, read = str(formula["verdict"]), formula["verdict"] != "UNREAD"
    forms, statements = derived.get(formula["id"], ()), formula["statements"]
    paired = zip(statements, forms, strict=True) if forms else ((one, {"forms": [], "kind": ""}) for one in statements)
    return {
        **row(formula, words),
        "place": place(record),
        "formula": words.block(tex.printed(formula["printed"])) if read else "",
        "said": words.text(formula["printed"]),
        "conditions": conditions(record, words),
        "statements": merged(
            [
                statement(judged, form, n if len(statements) > 1 else 0, words)
                for n, (judged, form) in enumerate(paired, 1)
            ]
        ),
        "reason": words.prose(formula["reason"]) if verdict != "REFUTED" else "",
    }


def statement(judged: Record, form: Record, number: int, words: Words) -> dict[str, Any]:
    """What is derived for one statement."""
    repair = judged.get("repair")
    shown = [(one["latex"], one["where"]) for one in form["forms"]]
    common = shared([where for _, one in shown for where in one])
    return {
        "name": f"derived ({number})" if number else "derived",
        "forms": [
            {"latex": words.block(latex), "where": words.prose(where_of(one, common)) if len(shown) > 1 else ""}
            for latex, one in shown
        ],
        "kind": words.prose(form["kind"]),
        "repair": words.block(repair["latex"]) if repair else "",
    }


def merged(statements: list[dict[str, Any]]) -> list[dict[str, Any]]:
    """The same, said once, if nothing but one and the same reason is said of all."""
    plain = all(one["kind"] and not one["repair"] for one in statements)
    if plain and len({one["kind"] for one in statements}) == 1:
        return [{**statements[0], "name": "derived"}]
    return statements


def shared(titles: Sequence[str]) -> set[str]:
    """The parts that all titles of readings have."""
    parts = [set(title.split(", ")) for title in titles]
    return set.intersection(*parts) if parts else set()


def where_of(titles: Sequence[str], common: set[str]) -> str:
    """The readings of one form, without what those of all forms share."""
    short = (", ".join(part for part in title.split(", ") if part not in common) for title in titles)
    return "; ".join(dict.fromkeys(part for part in short if part))


def conditions(record: Record, words: Words) -> str:
    """What the text around the formula assumes."""
    said = words.prose(record.get("domain") or "")
    given = words.join(", ", (words.inline(tex.printed(one)) for one in record.get("given", ())))
    return words.join("; ", (part for part in (said, given) if part))
