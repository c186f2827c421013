"""The checker fails on wrong variants of every claim of the derivation."""

from __future__ import annotations

from collections import Counter

import pytest

from derive.check.mutate import mutants, mutate_all
from derive.check.survival import kind_of
from derive.theory import equilibrium, plane, quartic, weierstrass
from derive.theory.chain import derive_all
from derive.theory.claims import Notebook

SAMPLE = 40  # claims
EACH = 3  # mutants of each of them


def fates(claims, limit=None):
    outcomes = mutate_all(claims, jobs=2) if limit is None else mutate_all(claims, jobs=1, limit=limit)
    assert [(one.id, one.change, one.verdict.reason) for one in outcomes if one.fate == "failed"] == []
    return outcomes


def test_no_mutant_of_a_sample_survives():
    book = Notebook()
    cases = quartic.derive(plane.derive(equilibrium.derive_section2(energy=None, book=book), book), book)
    weierstrass.derive(cases, book)
    every = list(book.claims.values())
    claims = [every[k * len(every) // SAMPLE] for k in range(SAMPLE)]
    assert len({claim.id for claim in claims}) == SAMPLE
    found = Counter(one.fate for one in fates(claims, EACH))
    assert found["killed"] > 0.8 * found.total()


@pytest.mark.long
def test_no_mutant_of_any_claim_survives_unproved():
    book = Notebook()
    derive_all(book=book)
    outcomes = fates(book.claims.values())
    killed = {one.id for one in outcomes if one.fate == "killed"}
    made = {name for name, claim in book.claims.items() if mutants(claim)}
    assert made == set(book.claims)
    assert killed == made
    kinds = Counter(kind_of(one.change) for one in outcomes if one.fate == "killed")
    assert {"sign", "number", "term dropped", "factor dropped", "exponent", "symbols exchanged", "range"} <= set(kinds)
