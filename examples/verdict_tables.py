"""The tables of verdicts, errata and wrong variants in README.md and docs/checks.md, from the results of a run.

derive report --check --json found.json && python examples/verdict_tables.py found.json
says whether verdicts and errata there are those of the run.
"""

from __future__ import annotations

import json
import re
import sys
from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parent.parent
# On which page each table stands, between the markers <!-- NAME --> and <!-- end NAME -->.
PAGES = {
    "verdicts": ROOT / "README.md",
    "measure": ROOT / "README.md",
    "errata": ROOT / "docs" / "checks.md",
    "mutants": ROOT / "docs" / "checks.md",
    "suites": ROOT / "README.md",
    "hard": ROOT / "docs" / "hard_rods.md",
    "scenes": ROOT / "docs" / "solver.md",
    "speeds": ROOT / "docs" / "measure.md",
    "shapes": ROOT / "docs" / "measure.md",
}
Found = Mapping[str, Any]
ORDER = ("PROVED", "CERTIFIED", "AGREED", "DEFINITION", "REFUTED", "UNKNOWN", "UNREAD")  # in the order of trust
WIDEST = 240  # characters of a formula in a table
OFTEN = 100  # variants of a kind that has a row of its own
TEXT = "text."  # ids of claims of the running text begin so


def verdict_table(result: Found) -> list[str]:
    """How many claims, displays, statements and claims of the text have each verdict."""
    displays = [one for one in result["formulas"] if not one["id"].startswith(TEXT)]
    text = [one for one in result["formulas"] if one["id"].startswith(TEXT)]
    claims = result["claims"]
    rows = {
        "claims of the derivation": Counter(claims) if isinstance(claims, Mapping) else counted(claims),
        "printed displays": counted(displays),
        "their statements": counted(statement for display in displays for statement in display["statements"]),
        "claims of the running text": counted(text),
    }
    rows = {name: counts for name, counts in rows.items() if counts}
    kinds = [kind for kind in ORDER if any(kind in counts for counts in rows.values())]
    lines = [f"| | all | {' | '.join(kinds)} |", "|---" * (len(kinds) + 2) + "|"]
    for name, counts in rows.items():
        lines.append(f"| {name} | {sum(counts.values())} | {' | '.join(str(counts[kind]) for kind in kinds)} |")
    return lines


def counted(records: Iterable[Found]) -> Counter[str]:
    """How many records have each verdict."""
    return Counter(str(one["verdict"]) for one in records)


def errata_table(result: Found) -> list[str]:
    """Every statement that is refuted as printed, and the parts that the smallest proved repair changes in it."""
    lines = ["| label | line | printed | holds | candidates tried |", "|---|---|---|---|---|"]
    for formula in result["formulas"]:
        for statement in formula["statements"] or [formula]:
            if statement["verdict"] == "REFUTED":
                place = f"| {formula['id']} | {formula['line']} "
                repair = statement.get("repair")
                if not repair:
                    lines.append(f"{place}| {cell(statement['printed'])} | no small change was found | |")
                    continue
                before, after = (", ".join(cell(pair[n]) for pair in repair["changes"]) for n in (0, 1))
                lines.append(f"{place}| {before} | {after} | {repair['tried']} |")
    return lines


def cell(latex: str) -> str:
    """A formula in a table, in one line; of a very long one the beginning."""
    line = " ".join(latex.split()).rstrip("\\,. ")
    line = line if len(line) <= WIDEST else f"{line[:WIDEST].rsplit(' ', 1)[0]} …"
    return f"`{line}`".replace("|", r"\|")


def mutant_table(mutants: Found) -> list[str]:
    """What became of the wrong variants, by kind of change and in all; rare kinds share a row."""
    fates = [fate for fate, number in mutants["counts"].items() if number or fate == "surviving"]
    often = {kind: met for kind, met in mutants["kinds"].items() if sum(met.values()) >= OFTEN}
    rare = [met for kind, met in mutants["kinds"].items() if kind not in often]
    others = {fate: sum(met.get(fate, 0) for met in rare) for fate in fates}
    rows: Sequence[tuple[str, Found]] = [
        *often.items(),
        (f"{len(rare)} rarer kinds", others),
        ("**all**", mutants["counts"]),
    ]
    lines = [f"| change | {' | '.join(fates)} |", "|---" * (len(fates) + 1) + "|"]
    return lines + [f"| {kind} | {' | '.join(str(met.get(fate, 0)) for fate in fates)} |" for kind, met in rows]


def table(name: str) -> str:
    """A table as it stands on its page; ValueError if the page has no markers for it."""
    found = re.search(
        rf"<!-- {name} -->\n(.*?)\n?<!-- end {name} -->", PAGES[name].read_text(encoding="utf-8"), re.DOTALL
    )
    if found is None:
        raise ValueError(
            f"{PAGES[name]} has no markers <!-- {name} --> and <!-- end {name} --> to put the table between"
        )
    return found[1]


def replace(text: str, name: str, lines: Sequence[str]) -> str:
    """The text with new lines between the markers of a table."""
    pattern = rf"(<!-- {name} -->\n).*?(<!-- end {name} -->)"
    return re.sub(pattern, lambda match: match[1] + "\n".join([*lines, match[2]]), text, flags=re.DOTALL)


def put(name: str, lines: Sequence[str]) -> None:
    """Write a table on its page; ValueError if the page has no markers for it."""
    table(name)
    PAGES[name].write_text(replace(PAGES[name].read_text(encoding="utf-8"), name, lines), encoding="utf-8")


def differing(result: Found, written: Mapping[str, str]) -> list[str]:
    """Those of the tables of verdicts and errata that are not written as a run gives them."""
    tables = {"verdicts": verdict_table(result), "errata": errata_table(result)}
    return [name for name, lines in tables.items() if "\n".join(lines) != written[name]]


if __name__ == "__main__":
    result = json.loads(Path(sys.argv[1]).read_text(encoding="utf-8"))
    names = differing(result, {name: table(name) for name in ("verdicts", "errata")})
    sys.exit(f"the tables of {' and '.join(names)} differ from the run; run examples/readme_tables.py" if names else 0)
