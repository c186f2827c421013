"""From a formula, a claim or a line of an emitted module back to the energy, along the steps of the claims."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator, Mapping
from difflib import get_close_matches
from pathlib import Path
from typing import Any

from derive import stages
from derive.emit.line_formulas import LineFormulas, load_case, stood_for
from derive.grounds import GROUNDS
from derive.paper.text_claims import load_claims

ENERGY = ("particle", "energy")  # the scripts whose claims are about the energy itself
LISTED = 5  # near matches in an error


class NothingToExplainError(Exception):
    """The name or the line belongs to nothing that was derived."""


def explain(what: str, folder: Path) -> dict[str, Any]:
    """The chain for a claim's id, a formula's name, an equation's label, or MODULE:LINE (looked up in the folder)."""
    theory = stages.theory()
    claims: Mapping[str, Any] = theory.book.claims
    place = re.fullmatch(r"(.+):(-?\d+)", what)
    if place:
        names, case = formulas_at(Path(place[1]), int(place[2]), folder, {f.name for f in theory.formulas})
        formulas = stood_for(theory.formulas, names, case)
        starts = [f.claim for f in formulas]
    else:
        starts = [f.claim for f in theory.formulas if what == f.name]
        starts = starts or beginnings(what, claims)
        formulas = [f for f in theory.formulas if f.claim in starts]
    if not starts:
        known = {
            *claims,
            *GROUNDS,
            *load_claims(),
            *(f.name for f in theory.formulas),
            *(c.source for c in claims.values() if c.source),
        }
        raise NothingToExplainError(f"'{what}' is no formula, claim or equation of the derivation{near(what, known)}")
    far = distances(claims)
    return {
        "what": what,
        "starts": starts,
        "formulas": [{"name": f.name, "case": f.case, "doc": f.doc, "expression": str(f.expression)} for f in formulas],
        "claims": [
            {"id": c.id, "title": c.title, "steps": list(c.steps), "source": c.source, "to_energy": far[c.id]}
            for c in (claims[one] for one in ordered(starts, claims))
        ],
    }


def beginnings(what: str, claims: Mapping[str, Any]) -> list[str]:
    """The claims of an id or of a printed label; of a claim of the running text, those of the display before it."""
    if what in load_claims():
        what = load_claims()[what].after
    return [c.id for c in claims.values() if what in (c.id, c.source)] or list(GROUNDS.get(what, ()))


def near(name: str, known: Collection[str]) -> str:
    """A hint with the known names that are spelled alike, or that hold the name as one of their parts."""
    holding = sorted(one for one in known if name.lower() in one.lower().split("."))
    close = [*get_close_matches(name, sorted(known), n=LISTED), *holding][:LISTED]
    return f"; did you mean {' or '.join(dict.fromkeys(close))}?" if close else "; 'derive check' lists what there is"


def distances(claims: Mapping[str, Any]) -> dict[str, int | None]:
    """The least number of steps from each claim to one about the energy; None if it does not rest on the energy."""
    far: dict[str, int | None] = {}
    for one, claim in claims.items():  # a claim comes after those on which it rests
        below = [n for n in (far[step] for step in claim.steps) if n is not None]
        far[one] = 0 if one.split(".")[0] in ENERGY else min(below) + 1 if below else None
    return far


def ordered(starts: list[str], claims: Mapping[str, Any]) -> list[str]:
    """The claims that some rest on, those first on which the others rest."""
    wanted, waiting = set(), list(starts)
    while waiting:
        one = waiting.pop()
        if one not in wanted:
            wanted.add(one)
            waiting.extend(claims[one].steps)
    return [one for one in claims if one in wanted]


def formulas_at(path: Path, line: int, folder: Path, known: Collection[str]) -> tuple[set[str], str]:
    """The formulas that stand behind a line of an emitted module, and the load case that its header names."""
    if not path.suffix:
        path = path.with_suffix(".py")
    found = path if path.is_file() else folder / path.name
    try:
        text = found.read_text(encoding="utf-8")
        module = LineFormulas(text, known)
    except (OSError, UnicodeDecodeError, SyntaxError) as error:
        reason = getattr(error, "strerror", None) or error
        raise NothingToExplainError(f"{path}: cannot be read as a module ({reason})") from error
    here = module.function(line)
    if here is None:
        length = len(text.splitlines())
        raise NothingToExplainError(f"{path}:{line} stands in no function (the file has {length} lines)")
    names = module.at(line)
    if not names:
        raise NothingToExplainError(f"{path}:{line} stands in the function '{here.name}', which calls no formula")
    return names, load_case(text)


def lines(chain: Mapping[str, Any]) -> Iterator[str]:
    """The chain as text: what is printed, the formulas, then each claim with those on which it rests below it, once."""
    for formula in chain.get("printed", ()):
        yield f"printed: {' '.join(formula['printed'].split())}"
        yield f"    {formula['verdict']} ({formula['method']})"
        for statement in formula["statements"]:
            if statement.get("repair"):
                yield f"    holds: {statement['repair']['latex']}"
    for formula in chain["formulas"]:
        case = f" [{formula['case']}]" if formula["case"] else ""
        yield f"{formula['name']}{case} = {formula['expression']}"
        yield f"    {formula['doc']}"
    claims = {claim["id"]: claim for claim in chain["claims"]}
    shown: set[str] = set()
    for start in chain["starts"]:
        if start not in shown:
            yield ""
            yield from branch(start, claims, shown, 0)


def branch(one: str, claims: Mapping[str, Any], shown: set[str], depth: int) -> Iterator[str]:
    """A claim and, indented, what it rests on; claims that were shown before are only named."""
    claim, indent = claims[one], "  " * depth
    shown.add(one)
    notes = "; ".join(note for note in (claim["source"], to_energy(claim)) if note)
    yield f"{indent}{one} ({notes}): {claim['title']}"
    before = []
    for step in claim["steps"]:
        if step in shown:
            before.append(step)
        else:
            yield from branch(step, claims, shown, depth + 1)
    if before:
        yield f"{indent}  see above: {', '.join(before)}"


def to_energy(claim: Mapping[str, Any]) -> str:
    """How far a claim is from the energy, in words."""
    far = claim["to_energy"]
    if far is None:
        return "for any energy"
    return "about the energy" if far == 0 else f"{far} step{'s' * (far > 1)} to the energy"
