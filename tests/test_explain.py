"""Every printed label, and every claim of the running text, leads back to the energy or to a declared root."""

from __future__ import annotations

from pathlib import Path

import pytest
from sympy import Integer
from test_theory_steps import ROOTS

from derive import explain, stages
from derive.cli import main
from derive.grounds import GROUNDS
from derive.paper.ledger import load_ledger
from derive.paper.text_claims import load_claims
from derive.theory.claims import Formula

CASES = (("a", "oblique"), ("b", "oblique"), ("a", "orthogonal"), ("b", "parallel"))
# Sections that hold for a rod of any energy, and the properties of elliptic functions.
ANY_ENERGY = {"kirchhoff", "line_energy", "variation", "plane", "planarity"}
ELLIPTIC = {"exsl28", "exsl34", "exhpf14"}


@pytest.mark.parametrize("label", [*load_ledger(), *load_claims()])
def test_a_label_leads_back_to_a_root(label: str) -> None:
    chain = explain.explain(label, Path())
    assert chain["starts"]
    ends = {claim["id"] for claim in chain["claims"] if not claim["steps"]}
    assert ends
    assert ends <= set(ROOTS)


def test_what_rests_on_no_energy_is_kinematics_or_a_property_of_functions() -> None:
    far = explain.distances(stages.theory().book.claims)
    for label, record in load_ledger().items():
        if all(far[one] is None for one in explain.beginnings(label, stages.theory().book.claims)):
            assert record.scope in ANY_ENERGY or label in ELLIPTIC, label


def test_grounds_are_for_labels_without_claims_of_their_own() -> None:
    claims = stages.theory().book.claims
    assert set(GROUNDS) <= {*load_ledger(), *(claim.after for claim in load_claims().values())}
    assert not set(GROUNDS) & {claim.source for claim in claims.values()}
    assert all(one in claims for grounds in GROUNDS.values() for one in grounds)


def test_the_printed_form_and_its_verdict_come_first(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["explain", "slch5"]) == 0
    printed, verdict, repair = capsys.readouterr().out.splitlines()[:3]
    assert printed.startswith("printed: \\kappa_x^2 = \\gamma - 2\\beta \\xi(\\ell)")
    assert verdict.strip().startswith("REFUTED (counterexample")
    assert repair.strip().startswith("holds: ")
    assert main(["explain", "weierstrass.resolvent"]) == 0
    assert "printed:" not in capsys.readouterr().out


def test_a_line_of_a_formula_leads_back_to_its_claim() -> None:
    lines = Path("generated/parallel_numpy.py").read_text(encoding="utf-8").splitlines()
    place = next(k for k, line in enumerate(lines, 1) if line.startswith("def gauss_square("))
    assert explain.explain(f"parallel_numpy:{place}", Path("generated"))["starts"] == ["swing.gauss_square"]


def test_a_module_has_formulas_of_its_load_case_or_those_for_any_field_angle() -> None:
    made = [Formula(name, (), Integer(1), f"{case}.{name}", "", case) for name, case in CASES]
    found = explain.stood_for(made, {"a", "b"}, "orthogonal")
    assert [one.claim for one in found] == ["oblique.b", "orthogonal.a"]
    assert explain.stood_for(made, {"a", "b"}, "") == made
