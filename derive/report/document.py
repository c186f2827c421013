"""The report as LaTeX, from plain records of verdicts and derived forms. The same records give the same bytes."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from derive.report import text as tex
from derive.report.render import render

Record = Mapping[str, Any]
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
RELATION = re.compile(r"relation (\d+): [^\s(]+ \(([^()]*)\)")
SHOWN = 8  # values of a counterexample; check --json has all
UNNAMED = "rest_"  # begins the name of a quantity of which only the order is known
SIDES = {"lhs": "left side", "rhs": "right side"}


Derived = Mapping[str, Sequence[Record]]  # the derived forms of the statements of each formula


def document(
    formulas: Sequence[Record],
    derived: Mapping[str, Sequence[Record]],
    records: Mapping[str, Record],
    mutants: str = "",
) -> str:
    """The whole report.

    formulas: verdicts, as of ``derive check --json``, in the article's order. derived: the derived forms of the
    statements of each. records: of the ledger, or of the source that was judged; claims of the running text have none.
    mutants: a line on wrong variants.
    """
    counted = [str(one["verdict"]) for one in formulas]
    known = {one["id"]: records.get(one["id"], one) for one in formulas}
    entries = [(title_of(known[one["id"]]), entry(one, derived, known[one["id"]])) for one in formulas]
    titles = dict.fromkeys(title for title, _ in entries)
    context = {
        "counts": [
            {"verdict": name, "number": counted.count(name), "colour": colour, "meaning": meaning}
            for name, (colour, meaning) in VERDICTS.items()
            if name in counted
        ],
        "mutants": tex.text(mutants),
        "errata": [one for formula in formulas for one in errata(formula, derived, known[formula["id"]])],
        "sections": [
            {"title": title, "entries": [one for other, one in entries if other == title]} for title in titles
        ],
        "rows": [row(one) for one in formulas],
    }
    return render("paper_checks.tex.jinja", context)


def title_of(record: Record) -> str:
    """The part of the article in which a formula stands."""
    if record["id"].startswith(TEXT):
        return "Claims of the running text"
    scope = str(record.get("scope") or "")
    return TITLES.get(scope, tex.text(scope.replace("_", " ").capitalize() or "Other formulas"))


def row(formula: Record) -> dict[str, Any]:
    """A line of the last table."""
    verdict = str(formula["verdict"])
    method = "; ".join(dict.fromkeys(formula["method"].split("; ")))
    return {
        "label": tex.text(formula["id"]),
        "statements": len(formula["statements"]) or 1,
        "verdict": verdict,
        "colour": VERDICTS[verdict][0],
        "method": tex.text(method),
    }


def entry(formula: Record, derived: Derived, record: Record) -> dict[str, Any]:
    """One formula in the order of the article."""
    verdict, read = str(formula["verdict"]), formula["verdict"] != "UNREAD"
    forms, statements = derived.get(formula["id"], ()), formula["statements"]
    paired = zip(statements, forms, strict=True) if forms else ((one, {"forms": [], "kind": ""}) for one in statements)
    return {
        **row(formula),
        "place": place(record),
        "formula": tex.printed(formula["printed"]) if read else "",
        "said": tex.text(formula["printed"]),
        "conditions": conditions(record),
        "statements": merged(
            [statement(judged, form, n if len(statements) > 1 else 0) for n, (judged, form) in enumerate(paired, 1)]
        ),
        "reason": tex.prose(formula["reason"]) if verdict != "REFUTED" else "",
    }


def statement(judged: Record, form: Record, number: int) -> dict[str, Any]:
    """What is derived for one statement."""
    repair = judged.get("repair")
    shown = [(one["latex"], one["where"]) for one in form["forms"]]
    common = shared([where for _, one in shown for where in one])
    return {
        "name": f"derived ({number})" if number else "derived",
        "forms": [
            {"latex": latex, "where": tex.prose(where_of(one, common)) if len(shown) > 1 else ""}
            for latex, one in shown
        ],
        "kind": tex.prose(form["kind"]),
        "repair": repair["latex"] if repair else "",
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


def place(record: Record) -> str:
    """Where the formula stands in the source."""
    return f"line {record['line']}" if record.get("line") else ""


def conditions(record: Record) -> str:
    """What the text around the formula assumes."""
    said = tex.prose(record.get("domain") or "")
    given = ", ".join(f"${tex.printed(one)}$" for one in record.get("given", ()))
    return "; ".join(part for part in (said, given) if part)


def errata(formula: Record, derived: Derived, record: Record) -> Iterator[dict[str, Any]]:
    """The statements of a formula that do not hold as printed."""
    forms = derived.get(formula["id"], ())
    for number, judged in enumerate(formula["statements"]):
        if judged["verdict"] == "REFUTED":
            repair = judged.get("repair")
            yield {
                "label": tex.text(formula["id"]),
                "place": place(record),
                "printed": tex.printed(judged["printed"]),
                "counterexample": counterexample(judged["counterexample"] or {}),
                "reason": tex.prose(RELATION.sub(r"the sides of its relation \1; \2", judged["reason"])),
                "repair": repair and {"latex": repair["latex"], "how": how(repair), "changes": repair["changes"]},
                "forms": [{"latex": one["latex"]} for one in (forms[number]["forms"] if forms else ())],
            }


def how(repair: Record) -> str:
    """How a repair was found."""
    edits, tried = " and ".join(repair["edits"]), repair["tried"]
    return tex.text(f"{repair['verdict'].lower()}; changed: {edits}; {tried} candidate{'s' * (tried > 1)} tried")


def counterexample(point: Record) -> str:
    """A point, in short, and the values of both sides there."""
    names = [name for name in point if name not in SIDES and not name.startswith(UNNAMED)]
    at = [f"${tex.symbol(name)} = {tex.number(point[name])}$" for name in names[:SHOWN]]
    if len(names) > SHOWN:
        at.append(f"and {len(names) - SHOWN} more")
    sides = [f"{said} ${tex.number(point[name])}$" for name, said in SIDES.items() if name in point]
    return ", ".join(at) + (": " if at and sides else "") + ", ".join(sides)
