"""Numerical stability: for each emitted formula the input at which it loses more than its condition number explains.

python -m derive.measure.stability [NAME]… [--seed S] [--rods N] [--json FILE]

Two searches, each random first and then climbing in the exponents. "called": over rods, with the arguments that the
kernels hand to the formula there. "apart": over the arguments by themselves, each within the signs and exponents that
were heard, as if nothing tied them together; what is lost there alone is lost outside the formula's hypotheses.
A formula whose excess is above 1 where it is called is a defect, and the exit code is then 1.
"""

from __future__ import annotations

import argparse
import json
import sys
from collections.abc import Callable, Sequence
from dataclasses import asdict
from math import isfinite
from pathlib import Path
from typing import Any

from derive.cache import write_atomically
from derive.measure.hard import exact
from derive.measure.reference import Rod
from derive.measure.stability_formulas import Examined, Finding, known_formulas
from derive.measure.stability_search import Found, searched

RODS, SEED = 120, 1
DEFECT = 1.0

Progress = Callable[[str, int, int], None]


def stability(
    names: Sequence[str] = (), *, seed: int = SEED, rods: int = RODS, progress: Progress | None = None
) -> list[dict[str, Any]]:
    """Records of all formulas, or of those named; ValueError names a strange one."""
    formulas = known_formulas()
    strange = [name for name in names if name not in formulas]
    if strange:
        raise ValueError(f"no kernel has a formula '{strange[0]}'; there are {', '.join(formulas)}")
    if rods < 2:
        raise ValueError(f"--rods must be at least 2, half of them at random (got {rods})")
    chosen, found = [formulas[name] for name in names or formulas], []
    for k, formula in enumerate(chosen):
        found.append(record(formula, searched(formula, seed, rods), seed, rods))
        if progress is not None:
            progress(formula.name, k + 1, len(chosen))
    return found


def record(formula: Examined, found: Found, seed: int, rods: int) -> dict[str, Any]:
    """Plain data; what is no finite number is text. command: what finds it again."""
    return {
        "name": formula.name,
        "letters": list(formula.arguments),
        "operations": formula.operations,
        "heard": found.heard,
        "called": plain(found.called),
        "rod": asdict(found.rod) if found.rod else None,
        "apart": plain(found.apart),
        "defect": not found.called.excess <= DEFECT,
        "command": f"python -m derive.measure.stability {formula.name} --seed {seed} --rods {rods}",
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
    return f"{one['name']}({arguments})\n  on {exact(Rod(**one['rod']))}\n  again: {one['command']}"


def main(argv: Sequence[str] | None = None) -> int:
    """The command; 1 if there is a defect."""
    parser = argparse.ArgumentParser(prog="python -m derive.measure.stability", description="Stability of formulas.")
    parser.add_argument("names", nargs="*", metavar="NAME", help="which formulas (all)")
    parser.add_argument("--seed", type=int, default=SEED, help=f"of the search ({SEED})")
    parser.add_argument("--rods", type=int, default=RODS, help=f"rods tried for each formula ({RODS})")
    parser.add_argument("--json", type=Path, metavar="FILE", help="write the records")
    options = parser.parse_args(argv)

    def progress(name: str, done: int, total: int) -> None:
        if total > 1:
            print(f"{done}/{total} {name}", file=sys.stderr, flush=True)

    try:
        records = stability(options.names, seed=options.seed, rods=options.rods, progress=progress)
        if options.json is not None:
            write_atomically(options.json, json.dumps(records, ensure_ascii=False, indent=1))
    except (ValueError, OSError) as error:
        print(f"derive.measure.stability: {error}", file=sys.stderr)
        return 2
    print("\n".join(table(records)))
    for one in records:
        if one["defect"] or (one["rod"] and len(records) == 1):
            print(worst_input(one))
    return 1 if any(one["defect"] for one in records) else 0


if __name__ == "__main__":
    raise SystemExit(main())
