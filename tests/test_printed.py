"""The printed formulas against the derivation: verdicts, how they are reached, and that wrong variants fail."""

from __future__ import annotations

import json
import random
from dataclasses import replace
from functools import cache

import pytest

from derive.check import repair
from derive.check.judge import judge
from derive.check.misprints import mutants
from derive.check.printed import judge_formula
from derive.check.report import worst
from derive.check.same import same_meaning
from derive.check.statements import judge_statement
from derive.check.survival import mended, of_formula, score
from derive.check.trial import KILLED, SURVIVING, Trial
from derive.check.verdicts import AGREED, DEFINITION, PROVED, REFUTED, UNKNOWN, UNREAD
from derive.paper import tree as t
from derive.paper.ledger import Record, load_ledger
from derive.paper.reader import parse

ALGEBRA = (
    "exsl8", "exsl9", "exsl9a", "exsl10", "exsl11", "exsl12", "exsl12a", "exsl13", "exsl17", "exsl18", "exsl19",
    "exsl22", "exsl21", "exsl24", "exsl25", "exsl26", "exsl27", "exsl28", "slch1", "slch2", "slch3", "slch4", "slch5",
    "slch6", "slch7", "slch8", "slch9", "slch10", "slch11", "exhpf2", "exhpf5", "exhpf6", "exhpf7", "exhpf8", "exhpf9",
    "exhpf10",
)  # fmt: skip
# The displays of Section 3 up to the solution; those of other sections have tests of their own.
LEDGER = {label: load_ledger()[label] for label in ALGEBRA}
SAMPLE = 3  # mutants of each formula that are judged by default


@pytest.fixture(scope="session")
def verdicts(judged):
    return {label: judged(label) for label in LEDGER}


def printed(theory, label: str, old: str, new: str):
    """The verdict on a record with one piece of its LaTeX changed."""
    record = LEDGER[label]
    assert old in record.latex
    return judge_formula(theory, replace(record, latex=record.latex.replace(old, new)))


@pytest.mark.parametrize("label", sorted(set(LEDGER) - {"slch5"}))
def test_what_the_article_prints_holds(verdicts, label):
    verdict = verdicts[label]
    assert verdict.verdict in (PROVED, DEFINITION), verdict.reason
    assert verdict.counterexample is None


def test_names_are_introduced_once(verdicts):
    defined = {label for label, verdict in verdicts.items() if any(s.verdict == DEFINITION for s in verdict.statements)}
    assert defined == {"exsl17"}


def test_curvature_at_every_point_is_not_the_one_with_the_tip(theory, verdicts):
    """κ_x² = γ − 2βξ(s), not γ − 2βξ(ℓ), which vanishes at the free end."""
    verdict = verdicts["slch5"]
    assert verdict.verdict == REFUTED
    assert {"beta", "theta", "xi_tip", "lhs", "rhs"} <= set(verdict.counterexample)
    assert float(verdict.counterexample["rhs"]) == 0 != float(verdict.counterexample["lhs"])
    assert printed(theory, "slch5", r"\xi(\ell)", r"\xi(s)").verdict == PROVED


def test_right_of_an_arrow_values_are_taken_at_the_limit(theory, verdicts):
    verdict = verdicts["exhpf10"]
    assert "right of the arrow" in verdict.reason
    middle = verdict.statements[1]
    assert [relation["relation"][:4] for relation in middle.relations] == ["1: -", "2: ="]
    # The same equality by itself, without the arrow, is an identity in γ̄: and it is wrong.
    assert printed(theory, "exhpf10", r"\xi_b \to \xi_b =", r"\xi_b =").verdict == REFUTED
    assert printed(theory, "exhpf10", r"1 + \frac{2 \beta}", r"1 + \frac{\beta}").verdict == REFUTED


@pytest.mark.parametrize(
    ("label", "old", "new"),
    [
        ("exsl13", r"2 \beta \xi^3", r"2 \beta \xi^2"),
        ("exsl18", r"\frac{\eta - \gamma}{2}", r"\frac{\eta - \gamma}{3}"),
        ("exsl21", r"g_3 = -", r"g_3 ="),
        ("exsl24", r"\gamma >", r"\gamma <"),
        ("exsl26", "> 0", "< 0"),
        ("exsl27", r"\xi_b \to 1", r"\xi_b \to -1"),
        ("exsl9", r"\pm k", "k"),
        ("exhpf2", r"(\overline{\gamma} + \eta)", r"(\gamma + \eta)"),
        ("exsl12", r"\xi^\prime", r"\xi"),
    ],
)
def test_wrong_prints_are_refuted(theory, label, old, new):
    verdict = printed(theory, label, old, new)
    assert verdict.verdict == REFUTED
    assert verdict.counterexample


def test_what_cannot_be_read_or_judged_says_why(theory):
    unread = judge_formula(theory, Record("exsl18", "b = \n  \\foo", "parallel", (), "", 600, 20))
    assert unread.verdict == UNREAD
    assert "line 601, column 3" in unread.reason
    nowhere = judge_formula(theory, Record("new1", "a = a", None, (), "", 7))
    assert nowhere.verdict == UNREAD
    tower = "(" * 9 + "9" + ")^{99}" * 9
    for latex in (
        rf"{tower} = 1",
        r"\beta^{9^{9^{9}}} = 1",
        r"\xi_a = \frac{1}{0}",
        r"\xi_a \to 1",
        r"k(\ell) = 0",
    ):
        verdict = judge_formula(theory, Record("exsl18", latex, "parallel"))
        assert verdict.verdict == UNKNOWN
        assert verdict.reason
    wrong = judge_formula(theory, replace(LEDGER["exsl13"], given=(r"\boldsymbol{e} = \boldsymbol{e}_z",)))
    assert wrong.verdict == UNKNOWN
    assert "does not hold" in wrong.reason


def test_the_worst_part_decides_and_json_is_plain(theory):
    assert worst([PROVED, AGREED, DEFINITION]) == AGREED
    assert worst([PROVED, REFUTED, UNREAD]) == REFUTED
    record = json.loads(json.dumps(judge_formula(theory, LEDGER["exsl18"]).to_json()))
    keys = ["id", "line", "verdict", "printed", "method", "counterexample", "repair", "reason", "seconds", "statements"]
    assert list(record) == keys
    assert [statement["verdict"] for statement in record["statements"]] == ["PROVED", "PROVED"]
    assert record["statements"][0]["printed"] == r"b = \beta + \frac{\eta - \gamma}{2}"


# Wrong variants.


@cache
def made_of(label: str):
    return mutants(LEDGER[label])


@pytest.mark.parametrize("label", sorted(set(LEDGER) - {"slch5"}))
def test_mutants_fail(theory, label):
    made = made_of(label)
    assert made
    trial = Trial(theory, LEDGER[label])
    fates = [trial.fate(mutant) for mutant in random.Random(label).sample(made, min(SAMPLE, len(made)))]
    assert [fate for fate in fates if fate.fate == SURVIVING] == []


@pytest.mark.parametrize("label", ["exsl9", "exsl12", "exsl13", "exsl19", "exsl22", "slch8", "exhpf5"])
def test_the_bench_says_what_the_judge_says(theory, label):
    """A counterexample found by the values of parts is one of the whole claim."""
    trial = Trial(theory, LEDGER[label])
    chosen = random.Random(label).sample(made_of(label), 8)
    killed = [mutant for mutant in chosen if trial.fate(mutant).fate == KILLED]
    assert killed
    for mutant in killed:
        judged = judge_statement(theory, LEDGER[label], mutant.number, mutant.statement, trial.given, judge)
        assert judged.verdict == REFUTED, mutant.latex


def test_what_says_the_same_is_proved_to_do_so(theory):
    def same(label, one, other, **given):
        scope = LEDGER[label].scope
        return same_meaning(theory, scope, *parse(one, scope), *parse(other, scope), **given)

    limit = {"given": tuple(parse(r"\gamma \to \gamma_2", "parallel"))}
    assert same("exsl18", r"\xi_a = (-b)^2", r"\xi_a = b^2")
    assert not same("exsl18", r"\xi_a = (-b)^3", r"\xi_a = b^3")
    assert not same("exsl18", r"\xi_a = b", r"\xi_a < b")
    assert same("exsl9", r"\kappa_x = \pm k", r"\kappa_x = \pm \kappa_x")
    assert not same("exsl9", r"\kappa_x = \pm k", r"\kappa_x = k")
    assert same("exsl27", r"\xi_b \to 1", r"\xi_b^2 \to 1", **limit)
    assert not same("exsl27", r"\xi_b \to 1", r"\xi_a \to 1", **limit)
    assert not same("exsl18", r"\xi_a = b", r"\xi_a = \frac{1}{0}")


@pytest.mark.long
def test_no_mutant_survives_unproved(theory):
    """Those of the formula that is refuted as printed are made from its repair."""
    fates = [fate for record in LEDGER.values() for fate in of_formula(theory, record)]
    assert [fate for fate in fates if fate["fate"] == "surviving"] == []
    assert {fate["id"] for fate in fates if fate["fate"] == "killed"} == set(LEDGER)
    assert sum(fate["fate"] == "killed" for fate in fates) > 0.97 * len(fates)


def test_the_fates_of_mutants_are_counted(theory, monkeypatch):
    fates = of_formula(theory, LEDGER["slch5"])
    assert {fate["fate"] for fate in fates} == {"killed"}
    kinds = score(fates, lambda fate: fate["kind"])
    assert sum(sum(count.values()) for count in kinds.values()) == len(fates)
    assert list(kinds) == sorted(kinds)
    monkeypatch.setattr(repair, "CANDIDATES", 200)  # none mends what follows
    hopeless = replace(LEDGER["slch5"], latex=r"\kappa_x^2 = \beta^5 \gamma^3 + 7 \beta \xi^3 (\ell)")
    verdict = judge_formula(theory, hopeless)
    assert verdict.verdict == REFUTED
    assert mended(hopeless, verdict)[1] == [verdict.statements[0].printed]
    (alone,) = of_formula(theory, hopeless)
    assert (alone["fate"], alone["reason"]) == ("surviving", "neither holds nor can be mended")


def test_a_letter_that_a_section_does_not_have_is_not_read(theory):
    verdict = printed(theory, "slch10", r"\beta^2 +", r"\eta^2 +")
    assert verdict.verdict == UNREAD
    assert "not declared" in verdict.reason


def test_mutants_are_printed_as_they_are_judged():
    for label, record in LEDGER.items():
        printed_there = parse(record.latex, record.scope)
        for mutant in made_of(label):
            if mutant.statement is not None:
                assert parse(mutant.latex, record.scope) == [mutant.statement]
                assert mutant.statement not in printed_there
            else:
                assert mutant.reason


def test_mutants_cover_the_kinds_of_mistakes():
    made = [mutant for label in LEDGER for mutant in made_of(label)]
    assert {m.change for m in made} == {
        "sign", "symbol", "bar", "index", "term", "factor", "number", "power", "prime", "relation", "root", "argument",
        "operands",
    }  # fmt: skip
    names = {
        node.name
        for m in made
        if m.statement
        for side in m.statement.sides
        for node in side.walk()
        if isinstance(node, t.Name)
    }
    assert {"gamma", "gamma_bar"} <= names
