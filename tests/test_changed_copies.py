"""A source in which one formula was changed by hand: exactly that is refuted, and its repair is what was printed."""

from __future__ import annotations

import json
import os
import random
import tempfile
from dataclasses import replace
from functools import cache
from pathlib import Path
from typing import Any

import pytest

from derive.check.misprints import Mutants
from derive.check.printed import judge_formula
from derive.check.repair import repair
from derive.check.same import same_meaning
from derive.check.trial import KILLED, Trial
from derive.check.verdicts import DEFINITION, PROVED, REFUTED
from derive.cli import main
from derive.paper.ledger import Record, compare, from_source, load_ledger
from derive.paper.reader import parse

LEDGER = load_ledger()
CHANGES = [
    ("exsl21", "g_3 = -", "g_3 =", "sign"),
    ("exhpf15", r"2 b \zeta v", r"b \zeta v", "coefficient"),
    ("elmr8", r"\boldsymbol{d}_3 \times \boldsymbol{e}", r"\boldsymbol{e} \times \boldsymbol{d}_3", "order of factors"),
    ("exhpf2", r"(\overline{\gamma} + \eta)", r"(\gamma + \eta)", "bar"),
    ("exhpf15", r"^{\varsigma =s}", r"^{\varsigma =\ell}", "bounds"),
    ("exsl41", r"_{\varsigma=0}", r"_{\varsigma=1}", "bounds"),
    ("elmr6", r"\int_0^\ell", r"\int_0^s", "bounds"),
]
# Formulas that do not hold as they are printed: what is changed to make them hold.
MISPRINTS = [
    ("slch5", ["argument"]),
    ("elmr7", ["sign"]),
    ("kth20b", ["sign"]),
    ("exsl35", ["sign"]),
    ("slch12", ["symbol"]),
    ("exhpf19", ["bar"]),
]
RANDOM = 24  # changes of the sweep


def shown(record: Record, latex: str = "") -> str:
    return f"\\begin{{equation}} \\label{{{record.id}}}\n{latex or record.latex}\n\\end{{equation}}\n"


def source(**changed: str) -> str:
    """All displays of the ledger as a LaTeX text, some of them changed."""
    return "Text.\n" + "".join(shown(record, changed.get(record.id, "")) for record in LEDGER.values())


def changed_copy(label: str, old: str, new: str) -> str:
    assert LEDGER[label].latex.count(old) >= 1
    return LEDGER[label].latex.replace(old, new, 1)


def beside(label: str) -> list[str]:
    """The displays before and after it."""
    labels = list(LEDGER)
    place = labels.index(label)
    return [labels[place - 1], labels[place + 1]]


@pytest.mark.parametrize(
    ("label", "old", "new", "edit"),
    [pytest.param(*one, marks=pytest.mark.long if one[0] == "exhpf15" else []) for one in CHANGES],
)
def test_a_change_by_hand_is_refuted_and_undone(theory, judged, label, old, new, edit):
    text = source(**{label: changed_copy(label, old, new)})
    there = from_source(text)
    assert [difference.id for difference in compare(LEDGER, text)] == [label]
    for name in beside(label):
        assert judge_formula(theory, there[name]).verdict == judged(name).verdict
    verdict = judge_formula(theory, there[label], mend=True)
    assert verdict.verdict == REFUTED
    assert verdict.counterexample
    assert verdict.repair["edits"] == [edit]
    assert verdict.repair["tried"] > 0
    (number,) = (n for n, one in enumerate(verdict.statements) if one.verdict == REFUTED)
    assert parse(verdict.repair["latex"], there[label].scope) == [
        parse(LEDGER[label].latex, there[label].scope)[number]
    ]


@pytest.mark.parametrize(("label", "edits"), MISPRINTS)
def test_a_misprint_of_the_article_is_found_and_mended(judged, label, edits):
    verdict = judged(label)
    assert verdict.verdict == REFUTED
    assert verdict.counterexample
    assert verdict.repair["edits"] == edits


@pytest.mark.long  # two edits are looked for longer than one
def test_a_missing_factor_and_exchanged_operands_are_mended_together(judged):
    verdict = judged("elmr9")
    assert verdict.verdict == REFUTED
    assert len(verdict.repair["edits"]) == 2
    assert "missing factor" in verdict.repair["edits"]
    assert r"\tilde{\eta}" in verdict.repair["latex"]


def holding(theory) -> list[Record]:
    """Formulas that hold, of all sections, in random order."""
    labels = sorted(LEDGER)
    random.Random(3).shuffle(labels)
    return [LEDGER[label] for label in labels]


@pytest.mark.long
def test_random_changes_are_refuted_and_undone(theory):
    draw, done, undone = random.Random(7), 0, 0
    for record in holding(theory):
        original = judge_formula(theory, record)
        numbers = {n for n, one in enumerate(original.statements) if one.verdict in (PROVED, DEFINITION)}
        made = [one for one in Mutants(record).changed() if one.number in numbers]
        trial = Trial(theory, record, numbers)
        if not made or trial.fate(mutant := draw.choice(made)).fate != KILLED:
            continue
        scope, printed = str(record.scope), parse(record.latex, str(record.scope))
        found = repair(theory, replace(record, latex=mutant.latex), mutant.number, mutant.statement, trial.given)
        if found is not None:
            (mended,) = parse(found.latex, scope)
            same = mended == printed[mutant.number]
            undone += same or same_meaning(theory, scope, printed[mutant.number], mended, trial.given)
        done += 1
        if done == RANDOM:
            break
    assert done == RANDOM
    # A dropped δ or denominator is no edit that is tried, and a formula may have another small mend that holds.
    assert undone >= RANDOM * 2 // 3


def article() -> Path | None:
    named = os.environ.get("DERIVE_PAPER")
    folder = Path(__file__).resolve().parents[2] / "shared" / "paper"
    return Path(named) if named else next(iter(sorted(folder.glob("*.txt"))), None)


def texts() -> list[str]:
    """The ledger as a source, and the article's own where it lies beside the repository."""
    path = article()
    return [source(), *([path.read_text(encoding="utf-8")] if path else [])]


@cache
def checked(text: str) -> dict[str, Any]:
    """What `derive check` says on each formula of a source."""
    with tempfile.TemporaryDirectory() as folder:
        path, result = Path(folder, "copy.tex"), Path(folder, "found.json")
        path.write_text(text, encoding="utf-8")
        main(["check", "--paper", str(path), "--json", str(result)])
        return {one["id"]: one for one in json.loads(result.read_text())["formulas"]}


def refuted(text: str) -> set[str]:
    return {name for name, one in checked(text).items() if one["verdict"] == "REFUTED"}


@pytest.mark.long
@pytest.mark.parametrize(("label", "old", "new", "edit"), CHANGES)
def test_the_whole_copy(label, old, new, edit):
    for text in texts():
        printed = from_source(text)[label].latex
        assert printed.count(old) >= 1
        copy = text.replace(printed, printed.replace(old, new, 1))
        assert refuted(copy) - refuted(text) == {label}
        assert refuted(text) <= refuted(copy)
        formulas = checked(copy)
        assert formulas[label]["counterexample"]
        assert formulas[label]["repair"]["edits"] == [edit]
