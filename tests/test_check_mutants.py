"""The checker fails on wrong variants of every claim of the derivation."""

from __future__ import annotations

from collections import Counter
from itertools import takewhile

import pytest

from derive.check.mutate import mutants, mutate_all
from derive.check.survival import kind_of

SAMPLE = 40  # claims
EACH = 3  # mutants of each of them


def fates(claims, limit=None):
    outcomes = mutate_all(claims, jobs=2) if limit is None else mutate_all(claims, jobs=1, limit=limit)
    assert [(one.id, one.change, one.verdict.reason) for one in outcomes if one.fate == "failed"] == []
    return outcomes


def test_no_mutant_of_a_sample_survives(theory):
    """Claims up to the map to ℘."""
    every = list(takewhile(lambda claim: not claim.id.startswith("shape."), theory.book.claims.values()))
    claims = [every[k * len(every) // SAMPLE] for k in range(SAMPLE)]
    assert len({claim.id for claim in claims}) == SAMPLE
    found = Counter(one.fate for one in fates(claims, EACH))
    assert found["killed"] > 0.8 * found.total()


@pytest.mark.long
def test_no_mutant_of_any_claim_survives_unproved(theory):
    outcomes = fates(theory.book.claims.values())
    killed = {one.id for one in outcomes if one.fate == "killed"}
    made = {name for name, claim in theory.book.claims.items() if mutants(claim)}
    assert made == set(theory.book.claims)
    assert killed == made
    kinds = Counter(kind_of(one.change) for one in outcomes if one.fate == "killed")
    assert {"sign", "number", "term dropped", "factor dropped", "exponent", "symbols exchanged", "range"} <= set(kinds)
