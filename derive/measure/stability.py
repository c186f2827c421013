"""Numerical stability: for an emitted formula the input at which it loses more than its condition number explains.

python -m derive.measure.stability NAME [--seed S] [--rods N]; `derive measure --only stability` does all of them.

Two searches, each random first and then climbing in the exponents. "called": over rods, with the arguments that the
kernels hand to the formula there. "apart": over the arguments by themselves, each within the signs and exponents that
were heard, as if nothing tied them together; what is lost there alone is lost outside the formula's hypotheses.
A formula whose excess is above 1 where it is called is a defect, and the exit code is then 1.
"""

from __future__ import annotations

import argparse
import sys
from collections.abc import Sequence
from dataclasses import asdict
from math import isfinite
from typing import Any

from derive.measure.hard import exact
from derive.measure.reference import Rod
from derive.measure.stability_formulas import Finding, known_formulas
from derive.measure.stability_search import searched

DEFECT = 1.0


def record_of(name: str, seed: int, rods: int) -> dict[str, Any]:
    """The record of a formula; command: what finds it again. ValueError names a strange one."""
    formulas = known_formulas()
    if name not in formulas:
        raise ValueError(f"no kernel has a formula '{name}'; there are {', '.join(formulas)}")
    if rods < 2:
        raise ValueError(f"--rods must be at least 2, half of them at random (got {rods})")
    formula = formulas[name]
    found = searched(formula, seed, rods)
    return {
        "name": name,
        "letters": list(formula.arguments),
        "operations": formula.operations,
        "heard": found.heard,
        "called": plain(found.called),
        "rod": asdict(found.rod) if found.rod else None,
        "apart": plain(found.apart),
        "defect": not found.called.excess <= DEFECT,
        "command": f"python -m derive.measure.stability {name} --seed {seed} --rods {rods}",
    }


def plain(finding: Finding) -> dict[str, Any]:
    """As JSON has it."""
    numbers = {name: getattr(finding, name) for name in ("excess", "loss", "condition")}
    shown = {name: value if isfinite(value) else str(value) for name, value in numbers.items()}
    return {**shown, "arguments": list(finding.arguments)}


def table(records: Sequence[dict[str, Any]]) -> list[str]:
    """Rows, worst first: formula, the worst where it is called, and that of its arguments by themselves."""
    head = ("formula", "operations", "inputs", "loss, roundings", "condition", "excess")
    lines = [f"| {' | '.join((*head, 'apart: loss', 'condition', 'excess'))} |", "|---|" + "---|" * 8]
    for one in sorted(records, key=lambda one: -float(one["called"]["excess"])):
        parts = [one[of][key] for of in ("called", "apart") for key in ("loss", "condition", "excess")]
        shown = " | ".join(f"{float(part):.2g}" for part in parts)
        lines.append(f"| {one['name']} | {one['operations']} | {one['heard']} | {shown} |")
    return lines


def worst_input(one: dict[str, Any]) -> str:
    """Where a formula is at its worst, to be typed in again."""
    named = zip(one["letters"], one["called"]["arguments"], strict=True)
    arguments = ", ".join(f"{letter}={value!r}" for letter, value in named)
    return f"{one['name']}({arguments}) on {exact(Rod(**one['rod']))}; again: `{one['command']}`"


def main(argv: Sequence[str] | None = None) -> int:
    """One formula's search, again; 1 if it is a defect."""
    parser = argparse.ArgumentParser(prog="python -m derive.measure.stability", description="Stability of a formula.")
    parser.add_argument("name", metavar="NAME", help="which formula")
    parser.add_argument("--seed", type=int, default=1, help="of the search (1)")
    parser.add_argument("--rods", type=int, default=60, help="rods that are tried (60)")
    options = parser.parse_args(argv)
    try:
        found = record_of(options.name, options.seed, options.rods)
    except ValueError as error:
        print(f"derive.measure.stability: {error}", file=sys.stderr)
        return 2
    print("\n".join(table([found])))
    if found["rod"]:
        print(worst_input(found))
    return 1 if found["defect"] else 0


if __name__ == "__main__":
    raise SystemExit(main())
