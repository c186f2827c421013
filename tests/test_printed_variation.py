"""The displays of Section 2.3, of the straight cantilever and of its planarity: verdicts, and that wrong ones fail."""

from __future__ import annotations

import random
from collections import Counter
from dataclasses import replace

import pytest
from sympy import Function, ImmutableMatrix, Rational, Symbol, cancel, eye, zeros

from derive.check.judge import judge
from derive.check.meaning import ell
from derive.check.misprints import mutants
from derive.check.printed import judge_formula
from derive.check.sections import cantilever, couple, planarity, variation
from derive.check.sections.framed import HIGHEST
from derive.check.sections.functionals import PART
from derive.check.sections.turning import rotation, skew
from derive.check.trial import KILLED, MEANINGLESS, SURVIVING, Trial
from derive.check.verdicts import DEFINITION, PROVED, REFUTED, UNKNOWN
from derive.paper import tree as t
from derive.paper.ledger import load_ledger
from derive.paper.reader import parse
from derive.theory.claims import Claim, Equal
from derive.theory.letters import X1, X2, A, e1, e2, e3, eps, vector_of
from derive.theory.symbols import s

LEDGER = load_ledger()
SCOPES = ("variation", "couple", "cantilever", "planarity")
LABELS = [label for label, record in LEDGER.items() if record.scope in SCOPES]
DEFINED = {"elmr1", "elmr6", "exsl7"}  # the names that they introduce are theirs by convention
WRONG = {"elmr7", "elmr9"}
MENDED = {
    "elmr7": [(r"\delta \boldsymbol{u} - \boldsymbol{d}_3", r"\delta \boldsymbol{u} + \boldsymbol{d}_3")],
    "elmr9": [
        (r"\, \boldsymbol{e} \times \boldsymbol{d}_3", r"\, \boldsymbol{d}_3 \times \boldsymbol{e}"),
        (r"(\boldsymbol{e} \cdot \boldsymbol{d}_3) \,", r"\tilde{\eta} (\boldsymbol{e} \cdot \boldsymbol{d}_3) \,"),
    ],
}
SAMPLE = 6  # mutants of each formula that are tried by default


def record(label: str, *changes: tuple[str, str]):
    """A record with pieces of its LaTeX changed."""
    latex = LEDGER[label].latex
    for old, new in changes:
        assert old in latex
        latex = latex.replace(old, new)
    return replace(LEDGER[label], latex=latex)


def sound(label: str):
    """The record, mended if it is refuted as printed."""
    return record(label, *MENDED.get(label, []))


# Verdicts


# Two edits are looked for longer than one; the main job does so too.
@pytest.mark.parametrize("label", [pytest.param(x, marks=pytest.mark.long) if x == "elmr9" else x for x in LABELS])
def test_verdicts(theory, judged, label):
    verdict = judged(label)
    if label in WRONG:
        assert verdict.verdict == REFUTED
        assert verdict.counterexample
        assert judge_formula(theory, sound(label)).verdict == PROVED
    else:
        assert verdict.verdict == (DEFINITION if label in DEFINED else PROVED), verdict.reason


def test_the_displays_are_all_there():
    assert len(LABELS) == 26
    assert {"elmr1", "elmr10", "elmr12", "elmr15", "exsl1", "exsl7", "exslrm1", "exslrm6"} <= set(LABELS)


@pytest.mark.parametrize(
    ("label", "old", "new"),
    [
        ("elmr1", "- ", "+ "),
        ("elmr2", r"\boldsymbol{I}) ", r"\boldsymbol{I})^\mathsf{T} "),
        ("elmr3", r"\delta \boldsymbol{q} \times \boldsymbol{d}_i", r"\boldsymbol{d}_i \times \delta \boldsymbol{q}"),
        ("elmr4", r"\delta \boldsymbol{q}^\prime + \delta", r"\delta \boldsymbol{q} + \delta"),
        ("elmr5", r"^\prime - \boldsymbol{M}", r"^\prime + \boldsymbol{M}"),
        ("elmr6", r"\int_0^\ell", r"\int_0^s"),
        ("elmr8", r"\boldsymbol{d}_3 \times \boldsymbol{e}", r"\boldsymbol{e} \times \boldsymbol{d}_3"),
        ("elmr8", r"\frac{1}{2}", r"\frac{1}{3}"),
        ("elmr10", r"\tilde{\eta} \,", ""),
        ("elmr10", r"\boldsymbol{F}^\prime", r"\boldsymbol{F}"),
        ("elmr12", r"\boldsymbol{a} \times", r"\boldsymbol{e} \times"),
        ("elmr13", "- 2", "-"),
        ("elmr13", r"O(\varepsilon^2) \,.", r"O(\varepsilon^3) \,."),
        ("elmr14", r"\, J \,", ""),
        ("elmr14", r"=A ", "="),
        ("elmr15", r"\tilde{\eta}", r"\chi"),
        ("exsl1", r"(\ell)", "(0)"),
        ("exsl1", "(0)", r"(\ell)"),
        ("exsl2", r"GJ \kappa_3", r"EI \kappa_3"),
        ("exsl3", r"z^\prime", r"y^\prime"),
        ("exsl3", r"\pm |", "|"),
        ("exsl4", "= 1", "= 2"),
        ("exsl5", "> 0", "< 0"),
        ("exsl6", r"+ \beta", r"- \beta"),
        ("exsl7", r"{E A^2}", r"{E A}"),
        ("exsl7", r"\eta \frac{I}{A}", r"\eta \frac{A}{I}"),
        ("exsl7", r"k \sqrt{\frac{I}{A}}", r"k \sqrt{\frac{A}{I}}"),
        ("exslrm1", r"| + \tilde", r"| - \tilde"),
        ("exslrm4", r"\frac{1}{EI} \,", ""),
        ("exslrm5", r"&= - \big(", r"&= \big("),
        ("exslrm6", "k^2", "k"),
    ],
)
def test_wrong_prints_are_refuted(theory, label, old, new):
    verdict = judge_formula(theory, record(label, (old, new)))
    assert verdict.verdict == REFUTED
    assert verdict.counterexample


def test_every_display_has_a_claim_that_goes_back_to_a_root(theory):
    claims = theory.book.claims
    assert not [label for label in LABELS if label not in {claim.source for claim in claims.values()}]


def test_the_new_claims_are_proved(theory):
    own = ("constraint.", "couple.turning", "couple.section", "variation.ends", "equilibrium.plane")
    own += ("equilibrium.along", "equilibrium.moment_along")
    found = [claim for one, claim in theory.book.claims.items() if one.startswith(own)]
    assert len(found) == 9
    assert {judge(claim).verdict for claim in found} == {PROVED}


# Which relation is read where


def relations(theory, label):
    """What was judged: for each relation its number and the reading."""
    statements = judge_formula(theory, sound(label)).statements
    return [[relation.relation for relation in statement.relations] for statement in statements]


def test_stationarity_is_judged_in_equilibrium_with_the_ends_held(theory):
    (found,) = relations(theory, "elmr9")
    assert [one[:4] for one in found] == ["1: =", "2: =", "3: ="]
    assert "all fields" in found[0]
    assert "all fields" in found[1]
    assert "in equilibrium, ends held" in found[2]


def test_laws_are_judged_in_equilibrium_and_identities_without(theory):
    assert relations(theory, "elmr10") == [["1: = (in equilibrium)"]] * 2
    assert relations(theory, "exslrm3") == [["1: = (any straight rod)", "2: = (in equilibrium, no twist)"]]
    (last,) = relations(theory, "exslrm5")
    assert last[-1] == "4: = (in equilibrium, no twist, no moment along e)"


def test_without_what_the_text_assumes_they_fail(theory):
    for label in ("exsl3", "exsl4", "exsl6", "exslrm4", "exslrm5"):
        assert judge_formula(theory, replace(LEDGER[label], given=())).verdict == REFUTED
    for given in (r"y = 0", r"\kappa_3 > 0"):
        verdict = judge_formula(theory, replace(LEDGER["exsl6"], given=(given,)))
        assert verdict.verdict == UNKNOWN
        assert "assumed" in verdict.reason or "assumes" in verdict.reason


def test_equilibrium_keeps_what_the_text_assumes(theory):
    """κ₃ = 0 and M · e = 0 hold all along a rod in equilibrium, if they hold at one point."""
    scope = "planarity"
    for latex in (r"\kappa_3^\prime = 0", r"(\boldsymbol{M} \cdot \boldsymbol{e})^\prime = 0"):
        (statement,) = parse(latex, scope)
        reading = list(planarity.readings(theory, statement.sides, ()))[-1]
        assert reading.title == "in equilibrium, no twist"
        assert cancel(reading.of(statement.sides[0])) == 0
    (statement,) = parse(r"\kappa_3^\prime = 0", "cantilever")
    for reading in cantilever.readings(theory, statement.sides, ()):
        assert cancel(reading.of(statement.sides[0])) == 0


# The moving frame


def test_rotations_turn_with_their_spin():
    turn, spin = rotation("g"), ImmutableMatrix(vector_of("w"))
    slope = turn.matrix.diff(s).xreplace(turn.rates(spin))
    assert (slope - skew(spin) * turn.matrix).applyfunc(cancel) == zeros(3, 3)
    assert (turn.matrix * turn.matrix.T).applyfunc(cancel) == eye(3)


def test_rates_and_variations_in_the_moving_frame(theory):
    reading, _ = variation.readings(theory, (t.Name("e", t.VECTOR),), ())
    kappa_u, e, C = reading.name("kappa_u"), reading.name("e"), reading.name("C")
    for i in (1, 2, 3):
        d, d_u = reading.name(f"d_{i}"), reading.name(f"d_u_{i}")
        assert reading.rate(d, 1) == reading.kappa.cross(d)
        assert (reading.rate(d_u, 1) - kappa_u.cross(d_u)).applyfunc(cancel) == zeros(3, 1)
        assert reading.vary(ImmutableMatrix(d)) == reading.turn.cross(d)
        assert reading.vary(ImmutableMatrix(d_u)).applyfunc(cancel) == zeros(3, 1)  # the undistorted rod stays
    assert reading.rate(e, 1) == reading.vary(e) == zeros(3, 1)
    # δ and the prime commute, on a scalar, a vector and a tensor.
    for value in (reading.name("psi_e"), reading.name("M"), C):
        gap = reading.vary(reading.rate(value, 1)) - reading.rate(reading.vary(value), 1)
        assert ImmutableMatrix([gap]).applyfunc(cancel).is_zero_matrix


def test_second_derivatives_in_equilibrium_follow_from_the_first(theory):
    _, reading = variation.readings(theory, (t.Name("e", t.VECTOR),), ())
    (law,) = reading.state
    kappa = reading.kappa[0]
    assert {kappa.diff(s, order) for order in range(1, HIGHEST + 1)} <= set(law)
    again = law[kappa.diff(s)].diff(s).xreplace(dict(reading.rates)).xreplace(law)
    assert judge(Claim("x", "x", Equal(law[kappa.diff(s, 2)], again))).verdict == PROVED


def test_a_quantity_elsewhere_is_another_one(theory):
    for reading in cantilever.readings(theory, (), ()):
        here, there = reading.name("M"), reading.call("M", 0, [ell])
        assert there == zeros(3, 1) != here
        assert reading.call("M", 0, [0 * s]) != here
        assert reading.call("x", 0, [0 * s]) == zeros(3, 1)
        assert reading.call("x", 0, [ell]) != zeros(3, 1)


# Functionals


def of(theory, latex: str, scope: str = "variation"):
    """The value of a formula in the first reading that the section has for it."""
    (statement,) = parse(f"{latex} = 0", scope)
    reading = next(iter(variation.readings(theory, statement.sides, ())))
    return reading.of(statement.sides[0])


def test_functionals_are_densities(theory):
    whole = of(theory, r"\int_0^\ell \psi_m ds", "variation")
    assert of(theory, r"\int_\ell^0 \psi_m ds", "variation") == -whole
    assert of(theory, r"\int_0^s \psi_m ds", "variation") == PART * whole
    split = of(theory, r"\int_0^s \psi_m ds + \int_s^\ell \psi_m ds", "variation")
    assert (split - whole).expand() == 0
    slope = of(theory, r"\int_0^\ell \psi_m^\prime ds - [\psi_m]_0^\ell", "variation")
    assert slope == 0
    assert of(theory, r"[\psi_m]_0^s", "variation").has(PART)


def test_integrals_over_sections_lose_their_first_moments():
    f = Function("f")(s)
    assert couple.over_section(f) == A * f
    assert couple.over_section(eps * X1 * f).expand() == couple.over_section(eps * (X1 - 3 * X2)).expand() == 0
    assert couple.over_section(eps * f).expand() == A * eps * f
    squared = eps**2 * X1 * X2
    assert (couple.over_section(1 + eps * X2 + squared) - A * (1 + squared)).expand() == 0
    assert (couple.over_section((1 + eps * X1) ** 2) - A * (1 + eps**2 * X1**2)).expand() == 0


def test_modulus_of_a_multiple_of_a_unit_vector(theory):
    (reading, _) = variation.readings(theory, (), ())
    size = Symbol("a", positive=True)
    assert reading.norm(-size * reading.name("e")) == size
    assert reading.norm(ImmutableMatrix(3 * e1 + 4 * e2)) == 5
    assert reading.norm(Rational(-2, 3)) == Rational(2, 3)
    assert reading.norm(ImmutableMatrix(e3)) == 1


# Wrong variants


@pytest.mark.parametrize("label", LABELS)
def test_mutants_fail(theory, label):
    trial = Trial(theory, sound(label))
    made = mutants(sound(label))
    assert made
    for mutant in random.Random(label).sample(made, min(SAMPLE, len(made))):
        fate = trial.fate(mutant)
        assert fate.fate != SURVIVING, f"{mutant.change}: {mutant.latex}"


@pytest.mark.long
@pytest.mark.parametrize("label", LABELS)
def test_no_mutant_survives_unproved(theory, label):
    fates = Counter(fate.fate for fate in Trial(theory, sound(label)).fates())
    assert fates[SURVIVING] == 0
    assert fates[MEANINGLESS] == 0
    assert fates[KILLED] > 0.6 * sum(fates.values())


def test_the_wrong_sign_in_the_constraint_is_mended(judged):
    (statement,) = judged("elmr7").statements
    assert statement.repair is not None
    assert statement.repair["edits"] == ["sign"]
    assert parse(statement.repair["latex"], "variation") == parse(sound("elmr7").latex, "variation")


@pytest.mark.long
def test_the_couple_in_the_stationary_energy_takes_two_edits(judged):
    (statement,) = judged("elmr9").statements
    assert statement.repair is not None
    assert len(statement.repair["edits"]) == 2
    (mended,) = parse(statement.repair["latex"], "variation")
    changed = [
        new != old for new, old in zip(mended.sides, parse(sound("elmr9").latex, "variation")[0].sides, strict=True)
    ]
    assert changed == [False] * 4
