"""What is printed of the elliptic solution: verdicts, the conditions that are found, repairs, and wrong variants."""

from __future__ import annotations

from dataclasses import replace

import pytest
from mpmath import mp

from derive.check import elliptic, rectangle
from derive.check.either import resolved
from derive.check.evaluate import evaluate
from derive.check.judge import judge
from derive.check.meaning import pm
from derive.check.prepare import prepared
from derive.check.printed import judge_formula
from derive.check.refute import refute
from derive.check.trial import MEANINGLESS, SURVIVING, Trial
from derive.check.verdicts import DEFINITION, PROVED, REFUTED, Verdict
from derive.paper.ledger import load_ledger
from derive.theory.claims import Claim, Domain, Equal, NonNegative
from derive.theory.symbols import beta, gamma, xi

LEDGER = load_ledger()
HOLD = [
    "exsl15", "exsl16", "exsl19a", "exsl20", "exsl23", "exsl29", "exsl30", "exsl31", "exsl33", "exsl34", "exsl36",
    "exsl37", "exsl38", "exsl39", "exsl40", "exsl41", "slch13", "slch14", "exhpf1", "exhpf3", "exhpf4", "exhpf11",
    "exhpf12", "exhpf13bis", "exhpf14", "exhpf15", "exhpf16", "exhpf17", "exhpf18",
]  # fmt: skip
MENDED = {  # a piece of what is printed wrong, and of what is right
    "exsl14": (r"\beta \mp \sqrt", r"\beta \pm \sqrt"),
    "exsl35": (r"a - \frac{1}{\sqrt{\eta}}", r"a + \frac{1}{\sqrt{\eta}}"),
    "slch12": (r"u_\mathrm{o} + s", r"u_\mathrm{o} + \varsigma"),
    "exhpf19": (r"+ \gamma \eta", r"+ \overline{\gamma} \eta"),
}
WRONG = [
    ("exsl15", r"[ \xi_a, \xi_b ]", r"] \xi_a, \xi_b ["),  # the free end is at a root
    ("exsl15", r"[ \xi_a, \xi_b ]", r"[ \xi_b, \xi_a ]"),
    ("exsl15", r"[ -1, 1 ]", r"[ -1, 2 ]"),
    ("exhpf4", r"] \xi_a, \xi_b [", r"[ \xi_a, \xi_b ]"),
    ("exhpf4", r"\notin", r"\in"),
    ("exsl30", r"u_\mathrm{o}+\ell", r"u_\mathrm{o}+s"),
    ("exsl31", r"\bar{\omega} - \ell", r"\bar{\omega} + \ell"),
    ("exsl34", r"2 \zeta u", r"\zeta u"),
    ("exsl36", r"a - \frac{2 \zeta v}", r"a + \frac{2 \zeta v}"),
    ("exsl36", r"\varsigma=0", r"\varsigma=1"),
    ("exsl36", r"u_\mathrm{o} + \varsigma - v", r"u_\mathrm{o} - \varsigma - v"),
    ("exsl40", r"\pm \frac{1}{\sqrt{\eta}}", r"\mp \frac{1}{\sqrt{\eta}}"),
    ("exsl41", r"\beta^2 + \gamma \eta", r"\beta^2 - \gamma \eta"),
    ("slch14", r"{-\beta}", r"{-2 \beta}"),
    ("exhpf13bis", r"- i \sqrt", r"+ i \sqrt"),
    ("exhpf13bis", r"\wp \omega_2", r"\wp \omega_1"),  # then no case is left for some rods
    ("exhpf15", r"2 b \zeta v", r"b \zeta v"),
    ("exhpf16", r"2 \beta \xi", r"\beta \xi"),
    ("exhpf18", r"- \overline{\gamma}", r"- \gamma"),
]


@pytest.fixture(scope="module")
def verdicts(judged):
    return {label: judged(label) for label in HOLD}


def at_once(claim: Claim):
    """The judge, with no time for proofs."""
    tried = refute(prepared(claim))
    word = REFUTED if tried.counterexample else PROVED
    return Verdict(claim.id, word, "points", tried.counterexample)


def changed(label: str, old: str, new: str):
    record = LEDGER[label]
    assert old in record.latex
    return replace(record, latex=record.latex.replace(old, new, 1))


@pytest.mark.parametrize("label", HOLD)
def test_what_is_printed_holds(verdicts, label):
    verdict = verdicts[label]
    assert verdict.verdict in (PROVED, DEFINITION), verdict.reason


@pytest.mark.parametrize("label", MENDED)
def test_what_is_misprinted_is_refuted_and_mended(theory, judged, label):
    verdict = judged(label)
    assert verdict.verdict == REFUTED
    assert verdict.counterexample
    assert verdict.repair["verdict"] == PROVED
    assert len(verdict.repair["edits"]) == 1
    assert judge_formula(theory, changed(label, *MENDED[label])).verdict == PROVED


@pytest.mark.parametrize(("label", "old", "new"), WRONG)
def test_a_wrong_copy_is_refuted(theory, label, old, new):
    verdict = judge_formula(theory, changed(label, old, new), at_once)
    assert verdict.verdict == REFUTED
    assert verdict.counterexample


def test_the_sign_of_z_changes_with_the_curvature(theory, verdicts):
    """One sign serves a stretch of the rod only; below the roots cosh⁻¹ of a negative argument runs backwards."""
    between = verdicts["exsl41"].reason
    assert between == "± is − as long as κ_x > 0; ± is + as long as κ_x < 0"
    outside = judge_formula(theory, changed("exhpf19", *MENDED["exhpf19"])).reason
    assert "± is − as long as κ_x > 0 and ξ > ξ_b" in outside
    assert "± is + as long as κ_x > 0 and ξ < ξ_a" in outside


def test_the_logarithm_must_be_continued_across_the_force_only(verdicts):
    assert "principal value of ln serves" in verdicts["exsl36"].reason
    reason = verdicts["exhpf15"].reason
    assert "ln must be continued along the rod" in reason
    assert "ell = " in reason


def test_each_label_leads_back_to_the_energy(theory):
    sources = {claim.source for claim in theory.book.claims.values()}
    assert not {*HOLD, *MENDED} - sources


def test_the_rectangle_of_half_periods():
    g2, g3 = mp.mpf(3), mp.mpf("0.4")
    e1, e2, e3 = rectangle.half_values(g2, g3)
    w1, w2, w3 = (rectangle.half_period(n, g2, g3) for n in (1, 2, 3))
    assert mp.almosteq(w2, w1 + w3)
    for corner, value in ((w1, e1), (w2, e2), (w3, e3)):
        assert mp.almosteq(elliptic.wp(corner, g2, g3), value)
    # The phase of ℘′ on the four sides.
    for value, phase in ((e1 + 1, -1), ((e1 + e2) / 2, 1j), ((e2 + e3) / 2, 1), (e3 - 1, -1j)):
        point = rectangle.perimeter_point(value, g2, g3)
        assert mp.almosteq(elliptic.wp(point, g2, g3), value)
        slope = elliptic.wp_prime(point, g2, g3)
        assert mp.almosteq(slope, phase * abs(slope))
    with pytest.raises(elliptic.DegenerateError):
        rectangle.half_period(1, mp.mpf(1), mp.mpf(1))


def test_nonnegative_may_vanish_and_no_more():
    where = Domain({beta: (0, 1), xi: (0, 1)})
    assert judge(Claim("zero", "", NonNegative(0 * xi), where)).verdict == PROVED
    assert judge(Claim("square", "", NonNegative((xi - beta) ** 2), where)).verdict != REFUTED
    assert judge(Claim("sum", "", NonNegative(xi + beta), where)).verdict == PROVED
    assert judge(Claim("wrong", "", NonNegative(xi - beta), where)).verdict == REFUTED


def test_one_sign_serves_all_relations_of_a_statement():
    where = Domain({gamma: (1, 2)})
    first, second = (Claim("c", "", Equal(side, pm * gamma), where) for side in (-gamma, gamma))
    claims, sign = resolved([first, first])
    assert sign == -1
    assert all(judge(claim).verdict == PROVED for claim in claims)
    claims, sign = resolved([first, second])
    assert sign is None
    assert REFUTED in {judge(claim).verdict for claim in claims}
    assert evaluate(claims[0].relation.rhs, {gamma: gamma * 0 + 1}) == 1


@pytest.mark.long
@pytest.mark.parametrize("label", [*HOLD, *MENDED])
def test_no_wrong_variant_survives(theory, label):
    record = changed(label, *MENDED[label]) if label in MENDED else LEDGER[label]
    fates = [fate for fate in Trial(theory, record).fates() if fate.fate in (SURVIVING, MEANINGLESS)]
    assert not [fate.mutant.latex for fate in fates if fate.fate == SURVIVING]
    assert len(fates) <= 1  # a side that is infinite
