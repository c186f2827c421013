"""The claims of the running text: their ledger, their verdicts, and that wrong variants of them fail."""

from __future__ import annotations

import json
from itertools import islice

import pytest

from derive.check.text import examples
from derive.check.text.judge import FORMS, judge_text, mended, variants
from derive.check.text.survival import of_text
from derive.check.verdicts import CERTIFIED, PROVED, REFUTED, UNREAD
from derive.cli import main
from derive.paper.text_claims import FORMULA, TextClaim, claims_of, from_json, load_claims

CLAIMS = load_claims()
NUMERICAL = ("count", "kinds", "transition", "effect", "bifurcations", "shrinks")
EXACT = [claim for claim in CLAIMS.values() if claim.form not in NUMERICAL]
SAMPLE = 1  # variants of each claim that are judged by default


@pytest.fixture(scope="session")
def verdicts(judged):
    return {claim.id: judged(claim.id) for claim in EXACT}


def printed_source(**changed: str) -> str:
    """A text with the labels of the claims, and behind each what is printed there."""
    places: dict[str, list[str]] = {}
    for claim in CLAIMS.values():
        own = [changed[claim.id]] if claim.id in changed else claim.fragments
        places.setdefault(claim.after, []).extend(f"${one}$" for one in own)
    return "\n".join(f"\\label{{{label}}} {' and '.join(inline)}" for label, inline in places.items())


def test_every_form_has_a_judge_and_every_judge_a_claim():
    assert {claim.form for claim in CLAIMS.values()} == {*FORMS, FORMULA}


def test_a_claim_survives_the_way_through_json():
    for claim in CLAIMS.values():
        assert from_json(json.loads(json.dumps(claim.to_json()))) == claim


def test_a_source_that_prints_the_same_does_not_differ():
    found, differences = claims_of(printed_source())
    assert differences == []
    assert found == CLAIMS


def test_a_changed_inline_formula_is_taken_as_printed(theory):
    wrong = CLAIMS["text.e_z"].latex.replace("1-", "1+")
    found, differences = claims_of(printed_source(**{"text.e_z": wrong}))
    assert [(one.id, one.kind, one.source) for one in differences] == [("text.e_z", "differs", wrong)]
    assert found["text.e_z"].latex == wrong
    said = judge_text(theory, found["text.e_z"])
    assert said.verdict == REFUTED
    assert said.repair is not None


def test_a_changed_fragment_leaves_its_claim_out():
    name = "text.uo.force_only"
    found, differences = claims_of(printed_source(**{name: r"u_\mathrm{o} = \omega_3 - \ell"}))
    assert [one.id for one in differences] == [name]
    assert name not in found


def test_a_source_without_the_place_has_no_claim():
    found, differences = claims_of(r"\label{elsewhere} $\xi$")
    assert found == {}
    assert {one.kind for one in differences} == {"absent from the source"}


def test_exact_claims_are_proved_or_refuted(verdicts):
    undecided = {name: said.reason for name, said in verdicts.items() if said.verdict not in (PROVED, REFUTED)}
    assert undecided == {}


def test_what_is_refuted_has_a_counterexample_and_a_proved_repair(verdicts):
    wrong = {name: said for name, said in verdicts.items() if said.verdict == REFUTED}
    assert set(wrong) == {"text.eta_tilde.dimension", "text.half_periods"}
    assert all(said.counterexample for said in wrong.values())
    mends = {name: said.repair["latex"] for name, said in wrong.items()}
    assert mends["text.eta_tilde.dimension"].endswith(r"\text{force}^{1}")
    assert mends["text.half_periods"].endswith(r"\wp^\prime")
    assert all(said.repair["verdict"] == PROVED for said in wrong.values())


@pytest.mark.parametrize("claim", EXACT, ids=lambda claim: claim.id)
def test_wrong_variants_of_a_claim_are_refuted(theory, claim: TextClaim):
    if claim.form == FORMULA:
        return
    sound = mended(theory, claim)
    assert sound is not None
    for kind, variant in islice(variants(sound), SAMPLE):
        assert judge_text(theory, variant, mend=False).verdict == REFUTED, (kind, variant.data)


@pytest.mark.long
@pytest.mark.parametrize("claim", CLAIMS.values(), ids=lambda claim: claim.id)
def test_no_variant_of_a_claim_survives(theory, claim: TextClaim):
    fates = of_text(theory, claim)
    assert fates
    assert [one for one in fates if one["fate"] == "surviving"] == []


def test_three_equilibria_and_not_another_number(theory):
    claim = CLAIMS["text.examples.three"]
    assert judge_text(theory, claim).verdict == CERTIFIED
    said = judge_text(theory, claim.but(number=2), mend=False)
    assert (said.verdict, said.counterexample) == (REFUTED, {"said": "2", "found": "3"})


def test_the_transition_lies_in_its_interval_and_not_in_another(theory):
    claim = CLAIMS["text.examples.transition"]
    assert judge_text(theory, claim).verdict == CERTIFIED
    said = judge_text(theory, claim.but(between=["0.00035", "0.0004"]), mend=False)
    assert (said.verdict, said.counterexample) == (REFUTED, {"said": "through", "found": "past"})


def test_what_balls_do_not_decide_is_not_decided(theory, monkeypatch):
    monkeypatch.setattr(examples, "kind", lambda rod: "")
    said = judge_text(theory, CLAIMS["text.examples.transition"], mend=False)
    assert (said.verdict, "do not decide" in said.reason) == ("UNKNOWN", True)


@pytest.mark.long
@pytest.mark.parametrize(
    "claim", [claim for claim in CLAIMS.values() if claim.form in NUMERICAL], ids=lambda claim: claim.id
)
def test_the_numerical_statements_are_certified(judged, claim: TextClaim):
    assert judged(claim.id).verdict == CERTIFIED


def test_the_command_judges_a_claim_by_its_name(tmp_path):
    file = tmp_path / "found.json"
    assert main(["check", "--only", "text.e_y", "--jobs", "1", "--json", str(file)]) == 0
    (said,) = json.loads(file.read_text())["formulas"]
    assert (said["id"], said["verdict"], said["line"]) == ("text.e_y", "PROVED", CLAIMS["text.e_y"].line)
    assert set(said) == {
        "id", "line", "verdict", "printed", "method", "statements", "counterexample", "repair", "reason", "seconds",
    }  # fmt: skip


def test_an_unreadable_formula_is_unread(theory):
    claim = CLAIMS["text.e_y"]
    said = judge_text(theory, from_json({**claim.to_json(), "latex": r"\unheard"}))
    assert said.verdict == UNREAD
