"""The displays of Sections 2.1 and 2.2 against the derivation: verdicts, and that changed copies are refuted."""

from __future__ import annotations

from dataclasses import replace

import pytest
from sympy import Matrix, Rational, simplify

from derive import explain
from derive.check.printed import judge_formula
from derive.check.sections import line_energy, rod
from derive.check.sections.moving import Turned
from derive.check.sections.rod_letters import TURN
from derive.check.sections.turning import rotation, skew
from derive.check.survival import of_formula
from derive.check.verdicts import DEFINITION, PROVED, REFUTED
from derive.paper.ledger import Record, load_ledger
from derive.theory.letters import X1, X2, A, vector_of
from derive.theory.symbols import s

LEDGER = load_ledger()
SCOPES = ("kirchhoff", "magnetization", "line_energy")
LABELS = [label for label, record in LEDGER.items() if record.scope in SCOPES]
WRONG = {"kth20b", "kth23"}
NAMING = {"kthr7", "kthr12", "kth14", "kth15", "kth18", "kth28"}


def changed(theory, label: str, old: str, new: str):
    """The verdict on a record with one piece of its LaTeX changed."""
    record = LEDGER[label]
    assert old in record.latex
    return judge_formula(theory, replace(record, latex=record.latex.replace(old, new, 1)))


@pytest.mark.parametrize("label", [label for label in LABELS if label not in WRONG])
def test_what_the_article_prints_holds(judged, label):
    verdict = judged(label)
    assert verdict.verdict in (PROVED, DEFINITION), verdict.reason
    assert (verdict.verdict == DEFINITION) == (label in NAMING)


def test_there_are_all_displays():
    assert len(LABELS) == 35


@pytest.mark.parametrize("label", LABELS)
def test_every_display_has_a_chain_back_to_its_roots(theory, label):
    claims = theory.book.claims
    starts = [claim.id for claim in claims.values() if claim.source == label]
    assert starts
    assert not any(claims[explain.ordered([start], claims)[0]].steps for start in starts)


def test_energy_of_a_particle_has_a_wrong_sign_and_is_mended(judged):
    verdict = judged("kth20b")
    assert verdict.verdict == REFUTED
    assert {"chi_par", "N_perp", "lhs", "rhs"} <= set(verdict.counterexample)
    assert verdict.repair["edits"] == ["sign"]
    assert r"+ \tilde{\chi}" in verdict.repair["latex"]


def test_last_line_of_the_square_along_the_particle_is_wrong(theory, judged):
    """The part of first order that the twist makes is 2 X_α (κ·d_α × d_β)(h·d₃)(h·d_β)."""
    verdict = judged("kth23")
    assert verdict.repair["verdict"] == "PROVED"
    assert len(verdict.repair["edits"]) == 2
    relations = [one["verdict"] for one in verdict.statements[0].relations]
    assert relations == [PROVED, PROVED, PROVED, REFUTED]
    record = LEDGER["kth23"]
    first, second = r"-2 X_\alpha (\boldsymbol{\kappa}", r") (\mathbbm{h}_\mathrm{a} \cdot\boldsymbol{d}_\alpha)"
    latex = record.latex.replace(first, "+" + first[1:]).replace(second, second.replace(r"d}_\alpha", "d}_3"))
    assert judge_formula(theory, replace(record, latex=latex)).verdict == PROVED


CHANGED = [
    ("kthr1", r"X_{1} \boldsymbol d_{1}", r"X_{2} \boldsymbol d_{1}"),
    ("kthr1", r"d_{1}^{\mathrm{u}}", r"d_{1}"),
    ("kthr2", r"\boldsymbol d^{\mathrm u}_3", r"\boldsymbol d_3"),
    ("kthr3", r"= 1", r"= 2"),
    ("kthr4", r"= \boldsymbol{\kappa} (s) \times", r"= \boldsymbol{\kappa}^\mathrm{u} (s) \times"),
    ("kthr4", r"\frac{1}{2}", r"\frac{1}{3}"),
    ("kthr5", r"\kappa_1^2 + \kappa_2^2", r"\kappa_1^2 - \kappa_2^2"),
    ("kthr5", r"\boldsymbol{d}_3^{\, \prime}", r"\boldsymbol{d}_1^{\, \prime}"),
    ("kthr6", r"\tau + ", r"\tau - "),
    ("kthr7", r"h/\ell", r"h^2/\ell"),
    ("kthr7", r"| \boldsymbol{\kappa}^\mathrm{u}(s) | h, \, ", ""),
    ("kthr7", r"(0,\ell)", r"(0,h)"),
    ("kthr8", r"+ \bar{\boldsymbol{u}}", r"- \bar{\boldsymbol{u}}"),
    ("kthr9", "|}{h}", "|}{h^2}"),
    ("kthr9", r"O (\varepsilon^2)", r"O (\varepsilon^3)"),
    ("kthr10", r"\boldsymbol{\kappa}^\mathrm{u} \times", r"\boldsymbol{\kappa} \times"),
    ("kthr11", r"- \boldsymbol{d}^\mathrm{u}_3", r"- \boldsymbol{d}_3"),
    ("kthr11", r"+ O (\varepsilon^2)", ""),
    ("kthr12", r"\boldsymbol{g}^3", r"\boldsymbol{g}_3"),
    ("kthr13", r"\otimes \boldsymbol{d}^\mathrm{u}_3", r"\otimes \boldsymbol{d}_3"),
    ("kthr13", r"\boldsymbol{\mu} \times", r"\boldsymbol{\kappa} \times"),
    ("kth14", r"\boldsymbol d_i\otimes", r"\boldsymbol d^{\mathrm u}_i\otimes"),
    ("kth15", r"- \boldsymbol{Q}", r"+ \boldsymbol{Q}"),
    ("kth16", r"+ \boldsymbol{f}", r"- \boldsymbol{f}"),
    ("kth16", r"\boldsymbol{d}_3 \times \boldsymbol{F}", r"\boldsymbol{F} \times \boldsymbol{d}_3"),
    ("kth16", r"+ \boldsymbol{m}", r"- \boldsymbol{m}"),
    ("kth17", r"\boldsymbol{\mu}", r"\boldsymbol{\kappa}"),
    ("kth18", "EI", "GI"),
    ("kth19", r"\frac{1}{2} \boldsymbol{M}", r"\frac{1}{3} \boldsymbol{M}"),
    ("kth19", r"\boldsymbol{C} \boldsymbol{\mu} \cdot", r"\boldsymbol{C} \boldsymbol{\kappa} \cdot"),
    ("elmr11", r"\tilde{\chi}", r"\chi"),
    ("campi", "+", "-"),
    ("eqazm", r"\mathbbm{h}", r"\mathbbm{h}_{\rm a}"),
    ("suscet", r"\chi_\perp", r"\chi_\parallel"),
    ("magnetiz", "= -", "="),
    ("demten", r"N_\perp (\boldsymbol I -", r"N_\perp (\boldsymbol I +"),
    ("magnha", r"\boldsymbol{\mathcal X}^{-1}", r"\boldsymbol{\mathcal X}"),
    ("kth21", "1 + 2", "1 - 2"),
    ("kth21", r"+ O(\varepsilon^2)", ""),
    ("kth22", r"\cdot\boldsymbol d_3)^2", r"\cdot\boldsymbol d^{\mathrm u}_3)^2"),
    ("kth24", r"1 + ", r"1 - "),
    ("kth25", r"\, J \,", ""),
    ("kth25", r"\int_0^s", r"\int_0^\ell"),
    ("kth26", r"X_\alpha dX", r"X_\alpha X_1 dX"),
    ("kth26", "= 0", r"= X_\alpha"),
    ("kth27", r"\tilde{\eta}", r"\tilde{\eta}^2"),
    ("kth28", "|^2", "|"),
]  # fmt: skip


@pytest.mark.parametrize(("label", "old", "new"), CHANGED, ids=[f"{one[0]} {one[2]}" for one in CHANGED])
def test_changed_copies_are_refuted(theory, label, old, new):
    verdict = changed(theory, label, old, new)
    assert verdict.verdict == REFUTED, verdict.reason
    assert verdict.counterexample


def test_energy_is_per_length_only_to_first_order(theory):
    """Without the hypothesis that O(ε²) is dropped, the derivative of Ψ_m is not the printed one."""
    record = LEDGER["kth27"]
    assert record.given == (r"O(\varepsilon^2) = 0",)
    assert judge_formula(theory, replace(record, given=())).verdict == REFUTED


def test_integrals_over_sections_and_along_the_rod(theory):
    def holds(latex: str) -> bool:
        return judge_formula(theory, Record("new", latex, "line_energy")).verdict == PROVED

    assert holds(r"\int_\Sigma dX_1 dX_2 = A") or holds(r"\int_\Sigma A dX_1 dX_2 = A^2")
    assert not holds(r"\int_\Sigma X_1 X_2 dX_1 dX_2 = 0")
    assert holds(r"\int_0^s A d\varsigma = \int_0^\ell A d\varsigma - \int_s^\ell A d\varsigma")
    assert not holds(r"\int_0^s A d\varsigma = \int_0^\ell A d\varsigma")


def test_values_in_the_reading(theory):
    """The second frame is a rotation that turns with κ^u; the axis has the tangent d₃, and no place is another."""
    reading = rod.rod_of(theory)
    slope = reading.turned.diff(s).xreplace(reading.rates) + skew(reading.kappa) * reading.turned
    by_law = skew(reading.name("kappa_u")) * reading.turned
    numbers = {g: Rational(n, 7) for n, g in enumerate([*TURN.parameters, *reading.kappa, *reading.rod.kappa_u], 2)}
    assert slope.xreplace(numbers) == by_law.xreplace(numbers)
    assert reading.rate(reading.name("x"), 1).expand() == reading.name("d_3")
    assert reading.call("kappa", 0, [reading.name("ell")]) != reading.name("kappa")


def test_turned_vectors_keep_their_products():
    turn = rotation("g").matrix
    one, two = Turned.of(turn, vector_of("a")), Turned.of(turn, vector_of("b"))
    assert one.dot(two) == vector_of("a").dot(vector_of("b"))
    assert simplify(Matrix(one).dot(Matrix(two)) - one.dot(two)) == 0
    tensor = Turned.product(turn, Matrix.diag(1, 2, 3), Matrix.diag(1, 1, 2))
    assert tensor * one == Matrix.diag(1, 2, 6) * vector_of("a")
    assert (Matrix(tensor) * Matrix(one) - tensor * one).applyfunc(simplify).is_zero_matrix


def test_first_moments_vanish_and_nothing_else():
    assert line_energy.over_section(3 + X1 - 2 * X2) == 3 * A
    assert line_energy.over_section(X1 * X2) == A * X1 * X2
    assert line_energy.over_section(1 / (1 + X1)) != A


@pytest.mark.long
@pytest.mark.parametrize("label", LABELS)
def test_no_mutant_survives(theory, label):
    fates = of_formula(theory, LEDGER[label])
    assert [one for one in fates if one["fate"] in ("surviving", "meaningless")] == []
