"""The derivation as the page shows it: chapters of prose and claims, and the formulas that solvers evaluate."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from typing import Any

from markupsafe import Markup

from derive.report.page.entries import MARKS, WORDS, rests
from derive.report.page.mathml import mathml
from derive.report.page.modules import Named, formula_anchor
from derive.report.page.words import anchor

Record = Mapping[str, Any]
# The scripts of the derivation, in words.
CHAPTERS = {
    "particle": "A paramagnetic particle", "energy": "Its magnetostatic energy", "frame": "The moving frame",
    "placement": "Where the points of the rod are", "kinematics": "Deformation of the rod",
    "line_energy": "Magnetic energy of the rod", "couple": "The magnetic couple",
    "constraint": "The constraint on the axis", "variation": "Equilibrium from the energy", "loads": "Any other load",
    "equilibrium": "The straight rod", "plane": "The plane problem", "quartic": "The quartic f and its roots",
    "weierstrass": "Weierstrass functions", "shape": "The shape of the rod", "tip": "The solution from the tip",
    "article": "The article's formulas as they are evaluated", "oblique": "Any angle of the field",
    "swing": "Motion between turning points",
}  # fmt: skip


def chapters(lines: Sequence[Record], verdicts: Mapping[str, Record], labels: Collection[str]) -> list[dict[str, Any]]:
    """The notebook in its order, a chapter for each script; labels: the printed formulas that can be linked."""
    known = {line["id"] for line in lines if "id" in line}
    found: dict[str, list[dict[str, Any]]] = {}
    waiting: list[dict[str, Any]] = []  # what is said before the first claim of a script
    for line in lines:
        if "id" not in line:
            waiting.append(remark(line))
            continue
        chapter = found.setdefault(line["id"].split(".")[0], [])
        chapter += [*waiting, claim(line, verdicts[line["id"]], known, labels)]
        waiting = []
    return [
        {
            "title": CHAPTERS.get(name, name),
            "anchor": anchor("chapter", name),
            "lines": chapter,
            "number": sum(one["kind"] == "claim" for one in chapter),
        }
        for name, chapter in found.items()
    ]


def remark(line: Record) -> dict[str, Any]:
    """Prose, or a named expression."""
    if line["expression"] is None:
        return {"kind": "prose", "text": WORDS.prose(line["text"])}
    return {"kind": "shown", "text": WORDS.prose(line["text"]), "formula": formula(line["expression"])}


def formula(given: Record) -> Markup:
    """A formula, or, where it is too long to be read, its text."""
    if given["latex"]:
        return mathml(given["latex"], block=True)
    return Markup('<code class="long">{}</code>').format(given["text"])


def claim(line: Record, verdict: Record, known: Collection[str], labels: Collection[str]) -> dict[str, Any]:
    """One claim with its verdict and its steps."""
    return {
        "kind": "claim",
        "id": line["id"],
        "anchor": anchor("claim", line["id"]),
        "title": WORDS.prose(line["title"]),
        "verdict": verdict["verdict"],
        "mark": MARKS[verdict["verdict"]],
        "method": verdict["method"],
        "reason": verdict["reason"],
        "formula": formula(line["statement"]),
        "where": [mathml(one) for one in line["where"]],
        "given": [mathml(one["latex"]) if one["latex"] else one["text"] for one in line["given"]],
        "steps": rests(line["steps"], known),
        "source": source(line["source"], labels),
        "search": f"{line['id']} {line['title']} {line['source']} {verdict['method']}".lower(),
    }


def source(name: str, labels: Collection[str]) -> dict[str, str]:
    """What a claim or a formula says of where it is written, with the id of a printed formula."""
    return {"name": name, "anchor": anchor(name) if name in labels else ""}


def evaluated(
    formulas: Sequence[Record], places: Mapping[str, Any], known: Collection[str], labels: Collection[str]
) -> list[dict[str, Any]]:
    """The formulas that solvers evaluate, by load case; places: where in the modules."""
    cases: dict[str, list[dict[str, Any]]] = {}
    for one in formulas:
        at = formula_anchor(Named(one["name"], one["case"]))
        entry = {
            "name": one["name"],
            "anchor": at,
            "arguments": ", ".join(one["arguments"]),
            "doc": WORDS.prose(one["doc"]),
            "formula": formula(one["expression"]),
            "rests": rests([one["claim"]], known),
            "source": source(one["source"], labels),
            "places": places.get(at, []),
            "search": f"{one['name']} {one['case']} {one['doc']} {one['source']}".lower(),
        }
        cases.setdefault(one["case"], []).append(entry)
    titles = {name: name.replace("_", " ").capitalize() or "Any load case" for name in cases}
    return [{"title": titles[name], "anchor": anchor("case", name), "formulas": cases[name]} for name in cases]
