"""From a formula, a claim or a line of an emitted module back to the energy, along the steps of the claims."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator, Mapping
from difflib import get_close_matches
from pathlib import Path
from typing import Any

from derive import stages


class NothingToExplainError(Exception):
    """The name or the line belongs to nothing that was derived."""


def explain(what: str, folder: Path) -> dict[str, Any]:
    """The chain for a claim's id, a formula's name, an equation's label, or MODULE:LINE (looked up in the folder)."""
    theory = stages.theory()
    claims: Mapping[str, Any] = theory.book.claims
    place = re.fullmatch(r"(.+):(\d+)", what)
    name, case = function_at(Path(place[1]), int(place[2]), folder) if place else (what, "")
    formulas = [f for f in theory.formulas if name in (f.name, f.source) and case in ("", f.case)]
    starts = [f.claim for f in formulas] or [c.id for c in claims.values() if name in (c.id, c.source)]
    if not starts:
        known = sorted({*claims, *(f.name for f in theory.formulas)})
        close = get_close_matches(name, known, n=3)
        hint = f"; did you mean {' or '.join(close)}?" if close else "; 'derive check' lists what there is"
        raise NothingToExplainError(f"'{name}' is no formula and no claim of the derivation{hint}")
    chain = [claims[one] for one in ordered(starts, claims)]
    return {
        "what": what,
        "formulas": [{"name": f.name, "case": f.case, "doc": f.doc, "expression": str(f.expression)} for f in formulas],
        "claims": [{"id": c.id, "title": c.title, "steps": list(c.steps), "source": c.source} for c in chain],
    }


def ordered(starts: list[str], claims: Mapping[str, Any]) -> list[str]:
    """The claims that some rest on, those first on which the others rest."""
    wanted, waiting = set(), list(starts)
    while waiting:
        one = waiting.pop()
        if one in claims and one not in wanted:
            wanted.add(one)
            waiting.extend(claims[one].steps)
    return [one for one in claims if one in wanted]


def function_at(path: Path, line: int, folder: Path) -> tuple[str, str]:
    """The function of an emitted module in which a line stands, and the load case that its header names."""
    if not path.suffix:
        path = path.with_suffix(".py")
    found = path if path.is_file() else folder / path.name
    try:
        text = found.read_text(encoding="utf-8")
        tree = ast.parse(text)
    except (OSError, UnicodeDecodeError, SyntaxError) as error:
        raise NothingToExplainError(f"{path}: cannot be read as a module ({error})") from error
    case = re.search(r"^Load case: ([\w ]+)\.", text, re.MULTILINE)
    for node in tree.body:
        if isinstance(node, ast.FunctionDef) and node.lineno <= line <= (node.end_lineno or line):
            return node.name, case[1].replace(" ", "_") if case else ""
    raise NothingToExplainError(f"{found}:{line} stands in no function (the file has {len(text.splitlines())} lines)")


def lines(chain: Mapping[str, Any]) -> Iterator[str]:
    """The chain as text, from the energy to what was asked for."""
    for claim in chain["claims"]:
        source = f" ({claim['source']})" if claim["source"] else ""
        yield f"{claim['id']}{source}: {claim['title']}"
        if claim["steps"]:
            yield f"    rests on {', '.join(claim['steps'])}"
    for formula in chain["formulas"]:
        case = f" [{formula['case']}]" if formula["case"] else ""
        yield f"{formula['name']}{case} = {formula['expression']}"
        yield f"    {formula['doc']}"
