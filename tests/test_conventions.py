"""The letters of each section: declared without contradiction, introduced where the article introduces them."""

from __future__ import annotations

from itertools import chain

import pytest

from derive.paper.conventions import _data, canonical, scope, scope_of
from derive.paper.ledger import load_ledger
from derive.paper.order import labels
from derive.paper.reader import parse

SCOPES = list(_data()["scopes"])
LEDGER = load_ledger()


def test_sections_cover_the_article_once():
    order = labels()
    ends = [(order.index(first), order.index(last)) for first, last in _data()["scopes"].values()]
    covered = list(chain.from_iterable(range(first, last + 1) for first, last in ends))
    assert sorted(covered) == list(range(len(order)))
    assert [scope_of(label) for label in ("campi", "kth21", "elmr11", "elmr12", "exsl12a", "exslrm1", "exsl13")] == [
        "magnetization", "line_energy", "magnetization", "couple", "plane", "planarity", "parallel",
    ]  # fmt: skip
    assert scope_of("exsl99") is None


@pytest.mark.parametrize("where", SCOPES)
def test_symbols_are_spelled_and_named_once(where):
    letters = scope(where)
    for spelled, declared in letters.by_spelling.items():
        assert canonical(spelled) == spelled
        assert letters.declared(declared.name, declared.index) == declared
    words = {word for one in letters.by_name.values() for word in one.argument.split()}
    assert words <= set(letters.types)


@pytest.mark.parametrize("where", SCOPES)
def test_what_a_display_introduces_is_written_in_it(where):
    introduced = {(one.introduced, one.name) for one in scope(where).by_name.values() if one.introduced}
    for label, name in introduced:
        record = LEDGER[label]
        read = parse(record.latex, record.scope)
        nodes = (node for statement in read for side in statement.sides for node in side.walk())
        assert name in {getattr(node, "name", None) for node in nodes}


def test_a_letter_has_one_meaning_in_a_section():
    assert scope("kirchhoff").by_spelling["J"].name == "J_torsion"
    assert scope("line_energy").by_spelling["J"].name == "J_map"
    assert scope("plane").by_spelling["k"].name == "k"
    assert scope("orthogonal").by_spelling["i"].name == "i_unit"
    assert scope("variation").by_spelling[r"\boldsymbol{u}"].name == "u_axis"
    assert scope("cantilever").by_spelling[r"\overline{\beta}"].introduced == "exsl7"
    assert scope("parallel").by_name["varkappa"].introduced == "exsl16"
    assert scope("force_only").by_name["varkappa"].introduced == "slch7"
