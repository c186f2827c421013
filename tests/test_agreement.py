"""The comparison with the references: a true module passes, and every kind of wrong one is seen."""

from __future__ import annotations

from dataclasses import dataclass, replace
from math import sqrt
from types import SimpleNamespace
from typing import Any

import pytest

from derive.measure.agreement import ROUNDINGS, agreement
from derive.measure.reference import FRACTIONS, Reference, Rod
from derive.measure.rods import PAPER, references, rods
from derive.measure.scan import STIFFEST


@dataclass(frozen=True)
class Answer:
    """What an emitted module gives, here rounded from the reference."""

    tip_angle: float
    clamp_curvature: float
    y: float
    z: float
    energy: float
    index: int
    known: Reference


@pytest.fixture(scope="module")
def known() -> list[tuple[Rod, list[Reference]]]:
    return [(PAPER, references(PAPER))]


def module(known: list[tuple[Rod, list[Reference]]], change: Any = lambda answers: answers) -> Any:
    """A module that knows the answers for one rod, and what is changed in them."""
    names = ("tip_angle", "clamp_curvature", "y", "z", "energy")

    def equilibria(beta: float, eta: float, length: float, clamp_angle: float) -> list[Answer]:
        assert (beta, eta, length, clamp_angle) == (PAPER.beta, PAPER.eta, PAPER.length, PAPER.clamp_angle)
        (_, found), *_ = known
        return change([Answer(*(float(r.values[name]) for name in names), r.index, r) for r in found])

    def shape(equilibrium: Answer, s: float) -> SimpleNamespace:
        fraction = next(f for f in FRACTIONS if f * PAPER.length == s)
        parts = ("theta", "curvature", "y", "z")
        return SimpleNamespace(**{p: float(equilibrium.known.values[f"{p}({fraction}ℓ)"]) for p in parts})

    return SimpleNamespace(equilibria=equilibria, shape=shape)


def test_rounded_answers_agree_to_a_rounding(known: Any) -> None:
    found = agreement(module(known), known)
    assert found.holds
    assert found.equilibria == 3
    assert len(found.rows) == 9
    assert max(row.roundings for row in found.rows.values()) <= 1


@pytest.mark.parametrize(
    ("change", "words"),
    [
        (lambda a: a[:2], "2 equilibria instead of 3"),
        (lambda a: [*a, a[-1]], "4 equilibria instead of 3"),
        (lambda a: [replace(a[0], index=1), *a[1:]], "index 1 instead of 0"),
        (lambda a: [replace(a[0], y=-a[0].y), *a[1:]], "y is off by"),
        (lambda a: [*a[:2], replace(a[2], energy=a[2].energy * (1 + 1e-10))], "energy is off by"),
        (lambda a: [a[0] / 0], "it fails with TypeError"),
        (lambda a: [replace(a[0], tip_angle=float("nan")), *a[1:]], "tip_angle is nan"),
    ],
)
def test_wrong_answers_are_seen(known: Any, change: Any, words: str) -> None:
    found = agreement(module(known, change), known)
    assert not found.holds
    assert words in " ".join(found.reasons())


def test_no_comparison_is_no_agreement(known: Any) -> None:
    assert not agreement(module(known), []).holds
    assert ROUNDINGS < 1e5


def test_rods_follow_the_case_and_the_scene() -> None:
    assert rods("parallel")[0] == PAPER
    assert all(rod.eta == 0 for rod in rods("force_only"))
    assert all(rod.beta == 0 and rod.eta > 0 for rod in rods("field_only"))
    assert {rod.length for rod in rods("parallel", {"length": 80.0})} == {80.0}
    assert [rod.eta for rod in rods("parallel", {"eta": 50.0})] == [50.0] * 8  # all but the article's are shortened
    assert all(rod.length * sqrt(rod.beta + rod.eta) <= STIFFEST for rod in rods("parallel", {"length": 500.0}))
