"""Repairs: a proved formula is misprinted in one place, refuted, and mended to what it said."""

from __future__ import annotations

from dataclasses import replace

import pytest

from derive.check.edits import KINDS, edits
from derive.check.printed import judge_formula
from derive.check.repair import repair
from derive.check.verdicts import PROVED, REFUTED, UNKNOWN
from derive.paper import tree as t
from derive.paper.ledger import Record, load_ledger
from derive.paper.reader import parse

LEDGER = load_ledger()


MISPRINTS = [
    ("exsl9", r"\pm k", "k"),
    ("exsl11", "- 2 \\beta", "+ 2 \\beta"),
    ("exsl12", r"(\xi^\prime )^2", r"(\xi )^2"),
    ("exsl13", r"2 \beta \xi^3", r"2 \beta \xi^2"),
    ("exsl17", r"f^\prime(a)", "f(a)"),
    ("exsl18", r"\frac{\eta - \gamma}{2}", r"\frac{\eta - \gamma}{3}"),
    ("exsl18", r"\frac{\beta + \eta}{2}", r"\frac{\beta - \eta}{2}"),
    ("exsl19", r"\left( \frac{-b}", r"\left( \frac{-c}"),
    ("exsl21", "g_3 = -", "g_3 ="),
    ("exsl21", r"+ 3 \Big(", r"+ \Big("),
    ("exsl24", r"\gamma >", r"\gamma <"),
    ("exsl26", "> 0", "< 0"),
    ("slch10", r"\frac{\gamma^3}{216}", r"\frac{\gamma^2}{216}"),
    ("exhpf2", r"(\overline{\gamma} + \eta)", r"(\gamma + \eta)"),
    ("exhpf6", r"\frac{\overline{\gamma} - \eta}{2}", r"\frac{\gamma - \eta}{2}"),
    ("exhpf6", r"\frac{\beta - \eta}{2} +", r"\frac{\beta - \eta}{2} -"),
]


@pytest.mark.parametrize(("label", "old", "new"), MISPRINTS)
def test_a_misprint_is_refuted_and_mended(theory, label, old, new):
    record = LEDGER[label]
    assert old in record.latex
    printed = replace(record, latex=record.latex.replace(old, new, 1))
    verdict = judge_formula(theory, printed, mend=True)
    assert verdict.verdict == REFUTED
    originals = parse(record.latex, record.scope)
    wrong = [n for n, one in enumerate(parse(printed.latex, record.scope)) if one != originals[n]]
    assert [n for n, one in enumerate(verdict.statements) if one.verdict == REFUTED] == wrong
    (number,) = wrong
    statement = verdict.statements[number]
    assert statement.counterexample
    assert statement.repair["verdict"] in ("PROVED", "DEFINITION")
    assert 0 < statement.repair["tried"] < 1000
    assert len(statement.repair["edits"]) == 1
    assert parse(statement.repair["latex"], record.scope) == [originals[number]]
    assert verdict.repair == statement.repair


def test_the_curvature_is_mended_to_its_value_along_the_rod(judged):
    verdict = judged("slch5")
    assert verdict.repair["latex"] in (
        r"\kappa_{x}^{2} = \gamma - 2 \beta \xi",
        r"\kappa_{x}^{2} = \gamma - 2 \beta \xi \left( s \right)",
    )
    assert verdict.repair["edits"] == ["argument"]


def test_two_misprints_take_two_edits(theory):
    latex = r"b = - \beta + \frac{\eta - \gamma}{3} \,."
    (statement,) = parse(latex, "parallel")
    found = repair(theory, replace(LEDGER["exsl18"], latex=latex), 0, statement, parse("a = 1", "parallel"))
    assert parse(found.latex, "parallel") == parse(LEDGER["exsl18"].latex, "parallel")[:1]
    assert sorted(found.edits) == ["number", "sign"]


def test_what_no_small_edit_mends_has_no_repair(theory):
    latex = r"b = \beta^4 \eta^7 - \gamma^5 + \frac{\eta^3 - \gamma}{7}"
    record = Record("exsl18", latex, "parallel", ("a = 1",))
    (statement,) = parse(latex, "parallel")
    given = tuple(parse("a = 1", "parallel"))
    assert repair(theory, record, 0, statement, given, seconds=2) is None
    assert repair(theory, record, 0, statement, given, seconds=0) is None


def test_only_what_is_refuted_is_mended(theory):
    verdict = judge_formula(theory, LEDGER["exsl18"], mend=True)
    assert verdict.verdict == PROVED
    assert verdict.repair is None
    unknown = judge_formula(theory, replace(LEDGER["exsl18"], latex=r"\xi_a = \frac{1}{0}"), mend=True)
    assert (unknown.verdict, unknown.repair) == (UNKNOWN, None)


@pytest.mark.parametrize("label", ["exsl9", "exsl19", "exsl21", "exsl26", "slch5", "exhpf10"])
def test_edits_are_distinct_readable_and_say_something(label):
    record = LEDGER[label]
    for statement in parse(record.latex, record.scope):
        made = edits(statement, record.scope)
        edited = [edit.of(statement) for edit in made]
        assert len(set(edited)) == len(made) > 20
        assert statement not in edited
        named = isinstance(statement.sides[0], t.Name | t.Call | t.Primed)
        ranks = [(named and edit.side == 0, KINDS.index(edit.kind)) for edit in made]
        assert ranks == sorted(ranks)
        assert not any(one.operators == ("=",) and one.sides[0] == one.sides[1] for one in edited)
