"""Emitted modules as the page shows them: their lines with the formulas behind them, and what each does without."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple

from derive.emit.line_formulas import LineFormulas, load_case, stood_for
from derive.report.page.words import anchor

Record = Mapping[str, Any]


class Named(NamedTuple):
    """A formula of the derivation by its name and load case."""

    name: str
    case: str


class Run(NamedTuple):
    """Lines of a module, one after the other, behind which the same formulas stand."""

    first: int
    text: str
    formulas: tuple[Named, ...]


def runs(text: str, formulas: Sequence[Named]) -> list[Run]:
    """A module in runs; all its lines are in one of them."""
    module, case = LineFormulas(text, {one.name for one in formulas}), load_case(text)
    stood: dict[frozenset[str], tuple[Named, ...]] = {}
    found: list[tuple[int, list[str], tuple[Named, ...]]] = []
    for number, line in enumerate(text.splitlines(), 1):
        names = frozenset(module.at(number))
        if names not in stood:
            stood[names] = tuple(stood_for(formulas, names, case))
        if not found or found[-1][2] != stood[names]:
            found.append((number, [], stood[names]))
        found[-1][1].append(line)
    return [Run(first, "\n".join(lines), behind) for first, lines, behind in found]


def as_data(parts: Sequence[Run]) -> list[list[Any]]:
    """Runs as plain data: first line, number of lines, and name and case of each formula."""
    return [[one.first, one.text.count("\n") + 1, [list(formula) for formula in one.formulas]] for one in parts]


def module(emitted: Record, explained: Record, parts: Sequence[Any]) -> dict[str, Any]:
    """One module: what is proved of it, what it leaves out, and its lines; parts: its runs, as of `as_data`."""
    lines = emitted["text"].splitlines()
    size, whole = explained["size"]["bytes"], explained["full_size"]["bytes"]
    return {
        "name": emitted["name"],
        "anchor": anchor("module", emitted["name"]),
        "case": emitted["case"].replace("_", " "),
        "outputs": ", ".join(explained["outputs"]),
        "proved": len(emitted["proof"]),
        "lines": len(lines),
        "behind": sum(number for _, number, formulas in parts if formulas),
        "share": round(100 * size / whole),
        "folded": [f"{name} = {one['value']} ({one['by']})" for name, one in explained["folded"].items()],
        "left_out": left_out(explained["absent"]),
        "runs": [shown(emitted["name"], lines, *part) for part in parts],
    }


def left_out(absent: Sequence[Record]) -> list[dict[str, Any]]:
    """What a module does without, by reason and kind."""
    reasons: dict[str, dict[str, list[str]]] = {}
    for one in absent:
        reasons.setdefault(one["reason"], {}).setdefault(one["kind"], []).append(one["name"])
    return [
        {
            "reason": reason,
            "number": sum(map(len, kinds.values())),
            "kinds": [{"kind": kind, "names": ", ".join(names)} for kind, names in kinds.items()],
        }
        for reason, kinds in reasons.items()
    ]


def shown(module: str, lines: Sequence[str], first: int, number: int, formulas: Sequence[Any]) -> dict[str, Any]:
    """A run with its line numbers and links."""
    return {
        "anchor": anchor(module, f"L{first}"),
        "numbers": "\n".join(map(str, range(first, first + number))),
        "text": "\n".join(lines[first - 1 : first - 1 + number]),
        "links": [{"name": name, "anchor": formula_anchor(Named(name, case))} for name, case in formulas],
    }


def formula_anchor(formula: Named) -> str:
    """The id of a formula on the page."""
    return anchor("formula", formula.case, formula.name)


def places(modules: Sequence[Record]) -> dict[str, list[dict[str, str]]]:
    """Where each formula, by its id, is evaluated: the first run of each module behind which it stands alone."""
    found: dict[str, dict[str, str]] = {}
    for one in modules:
        for run in one["runs"]:
            if len(run["links"]) == 1:
                found.setdefault(run["links"][0]["anchor"], {}).setdefault(one["name"], run["anchor"])
    return {name: [{"name": module, "anchor": at} for module, at in there.items()] for name, there in found.items()}
