"""Statements that do not hold as printed: where they were seen to fail, and what mends them."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from derive.report import text as tex
from derive.report.words import Words

Record = Mapping[str, Any]
RELATION = re.compile(r"relation (\d+): [^\s(]+ \(([^()]*)\)")
SHOWN = 8  # values of a counterexample; check --json has all
UNNAMED = "rest_"  # begins the name of a quantity of which only the order is known
SIDES = {"lhs": "left side", "rhs": "right side"}


def place(record: Record) -> str:
    """Where the formula stands in the source."""
    return f"line {record['line']}" if record.get("line") else ""


def errata(
    formula: Record, derived: Mapping[str, Sequence[Record]], record: Record, words: Words
) -> Iterator[dict[str, Any]]:
    """The statements of a formula that do not hold as printed."""
    forms = derived.get(formula["id"], ())
    for number, judged in enumerate(formula["statements"]):
        if judged["verdict"] == "REFUTED":
            repair = judged.get("repair")
            yield {
                "id": formula["id"],
                "label": words.text(formula["id"]),
                "place": place(record),
                "printed": words.block(tex.printed(judged["printed"])),
                "counterexample": counterexample(judged["counterexample"] or {}, words),
                "reason": words.prose(RELATION.sub(r"the sides of its relation \1; \2", judged["reason"])),
                "repair": repair and mending(repair, words),
                "forms": [{"latex": words.block(one["latex"])} for one in (forms[number]["forms"] if forms else ())],
            }


def mending(repair: Record, words: Words) -> dict[str, Any]:
    """The smallest change that makes a statement hold."""
    changes = [tuple(words.part(side) for side in change) for change in repair["changes"]]
    return {"latex": words.block(repair["latex"]), "how": how(repair, words), "changes": changes}


def how(repair: Record, words: Words) -> str:
    """How a repair was found."""
    edits, tried = " and ".join(repair["edits"]), repair["tried"]
    return words.text(f"{repair['verdict'].lower()}; changed: {edits}; {tried} candidate{'s' * (tried > 1)} tried")


def counterexample(point: Record, words: Words) -> str:
    """A point, in short, and the values of both sides there."""
    names = [name for name in point if name not in SIDES and not name.startswith(UNNAMED)]
    at = [words.inline(f"{tex.symbol(name)} = {tex.number(point[name])}") for name in names[:SHOWN]]
    if len(names) > SHOWN:
        at.append(words.text(f"and {len(names) - SHOWN} more"))
    sides = [
        words.join(" ", (words.text(said), words.inline(tex.number(point[name]))))
        for name, said in SIDES.items()
        if name in point
    ]
    return words.join(": ", (words.join(", ", part) for part in (at, sides) if part))
