"""Exchanges of modules against references by counting and Taylor integration; wrong ones are seen."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from types import SimpleNamespace
from typing import Any

import pytest

from derive.emit.kernels.exchanges import Exchange, all_exchanges
from derive.measure.agreement import ROUNDINGS, Agreement
from derive.measure.exchange_agreement import enter_exchanges
from derive.measure.exchange_references import FORCES, ExchangeList, exchange_references, levels, matched
from derive.measure.exchanges import QUANTITIES, refined
from derive.measure.folds import NoFoldError
from derive.measure.rods import PAPER, rods
from generated import bifurcation_numpy

SIZE = PAPER.length**2
RANGES = (2.5 / SIZE, 3.5 / SIZE)  # of β and η, from zero


@pytest.fixture(scope="module")
def known() -> ExchangeList:
    point = refined(PAPER, 1.963 / SIZE, 2.76 / SIZE, 1.355)
    return ExchangeList(PAPER, *RANGES, (point,))


def exchanges_of(known: ExchangeList) -> list[Exchange]:
    """The references, rounded."""
    return [
        Exchange(**{name: float(one.values[name]) for name in QUANTITIES}, index=one.index, kind=one.kind)
        for one in known.exchanges
    ]


def reasons(known: ExchangeList, change: Callable[[list[Exchange]], Any]) -> list[str]:
    """What is said against a module that knows the references, and what is changed in them."""

    def exchanges(length: float, clamp_angle: float, *, beta: Any, eta: Any) -> list[Exchange]:
        assert (length, clamp_angle) == (known.rod.length, known.rod.clamp_angle)
        assert (beta, eta) == ((0.0, known.beta), (0.0, known.eta))
        found: list[Exchange] = change(exchanges_of(known))
        return found

    result = Agreement(folds=1)
    enter_exchanges(result, SimpleNamespace(exchanges=exchanges), [known])  # type: ignore[arg-type]  # all it looks at
    return result.reasons()


def test_references_survive_the_cache(known: ExchangeList) -> None:
    assert ExchangeList.from_json(known.to_json()).to_json() == known.to_json()
    (point,) = known.exchanges
    assert point.kind == "exchange"
    assert point.index == 0


def test_rounded_references_agree(known: ExchangeList) -> None:
    assert reasons(known, lambda points: points) == []


@pytest.mark.parametrize(
    ("change", "says"),
    [
        (lambda p: [], "no exchange at β = "),
        (lambda p: [*p, p[0]._replace(beta=p[0].beta / 2)], "an exchange that is none"),
        (lambda p: [p[0]._replace(index=1)], "index 1 instead of 0"),
        (lambda p: [p[0]._replace(kind="isolated")], "kind isolated instead of exchange"),
        (lambda p: [p[0]._replace(beta=p[0].beta * (1 + 1e-12))], "exchange beta is off by"),
        (lambda p: [p[0]._replace(eta=p[0].eta * (1 - 1e-12))], "exchange eta is off by"),
        (lambda p: [p[0]._replace(tip_angle=p[0].tip_angle + 1e-9)], "exchange tip_angle is off by"),
        (lambda p: [p[0]._replace(z=-p[0].z)], "exchange z is off by"),
        (lambda p: [p[0]._replace(y=float("nan"))], "y is nan at exchange"),
        (lambda p: p[0] / 0, "exchanges fail with TypeError"),
    ],
)
def test_wrong_exchanges_are_seen(known: ExchangeList, change: Any, says: str) -> None:
    assert any(says in line for line in reasons(known, change))


def test_an_exchange_that_no_reference_has_is_refined(known: ExchangeList) -> None:
    assert reasons(replace(known, exchanges=()), lambda _: exchanges_of(known)) == []


def test_the_exchange_of_the_second_example_is_within_the_bound(known: ExchangeList) -> None:
    around = tuple((float(known.exchanges[0].values[name]) * side) for name in ("beta", "eta") for side in (0.9, 1.1))
    found = bifurcation_numpy.exchanges(beta=around[:2], eta=around[2:])
    result, wide = Agreement(folds=1), SimpleNamespace(exchanges=lambda length, clamp_angle, beta, eta: found)
    enter_exchanges(result, wide, [known])  # type: ignore[arg-type]  # all that is looked at
    assert result.reasons() == []
    assert 0 < max(row.roundings for row in result.rows.values()) < ROUNDINGS


def test_folds_over_the_force_turn_back_at_an_exchange(known: ExchangeList) -> None:
    """β(η) is greatest there: its derivative, by Taylor integration, has the other sign on either side."""
    eta = float(known.exchanges[0].values["eta"])
    before, after = (levels(replace(PAPER, eta=eta * (1 + side * 0.004)), FORCES / SIZE) for side in (-1, 1))
    pairs = list(matched(before, after))
    assert len(pairs) == 3
    assert [one.slope > 0 > other.slope for one, other in pairs].count(True) == 1


def test_where_no_folds_meet_there_is_no_exchange() -> None:
    with pytest.raises(NoFoldError, match="folds meet"):
        refined(PAPER, 1.0 / SIZE, 5.0 / SIZE, 1.3)


@pytest.mark.long
@pytest.mark.parametrize(("case", "number"), [("parallel", 2), ("oblique", 1), ("orthogonal", 0)])
def test_counting_finds_the_exchanges_of_the_kernels(case: str, number: int) -> None:
    known = exchange_references(rods(case)[0])
    rod = known.rod
    found = all_exchanges(rod.length, rod.clamp_angle, rod.field_angle, 0.0, known.beta, 0.0, known.eta)
    assert len(found) == len(known.exchanges) == number
    for one, other in zip(found, known.exchanges, strict=True):
        assert float(other.values["beta"]) == pytest.approx(one.beta, rel=1e-13)
        assert float(other.values["eta"]) == pytest.approx(one.eta, rel=1e-13)
        assert other.kind == one.kind
