"""All displays of the article: read, printed back, no token dropped, every symbol in its place; the ledger."""

from __future__ import annotations

import os
import time
from pathlib import Path

import pytest

from derive.paper import tree as t
from derive.paper.displays import read_displays, read_source
from derive.paper.errors import ReadError
from derive.paper.ledger import compare, from_source, load_ledger
from derive.paper.printer import to_latex
from derive.paper.reader import parse
from derive.paper.tokens import PUNCTUATION, tokenise

LEDGER = load_ledger()
BREAKS = ("elmr9", "elmr13")  # a relation is repeated where the line is broken: one of the two may go
HEADS = (t.Call, t.Derivative, t.BigO, t.Integral, t.At, t.Between)


def article() -> Path | None:
    """The article's source, if it is at hand."""
    named = os.environ.get("DERIVE_PAPER")
    beside = Path(__file__).resolve().parents[2] / "shared" / "paper"
    return Path(named) if named else next(iter(sorted(beside.glob("*.txt"))), None)


@pytest.mark.parametrize("record", LEDGER.values(), ids=LEDGER.keys())
def test_every_record_is_read_and_printed_back(record):
    for statement in parse(record.latex, record.scope):
        assert parse(to_latex(statement, record.scope), record.scope) == [statement]
    for hypothesis in record.given:
        assert len(parse(hypothesis, record.scope)) == 1


def test_all_displays_are_read_in_a_second():
    start = time.process_time()
    read = {record.id: parse(record.latex, record.scope) for record in LEDGER.values()}
    assert time.process_time() - start < 5  # a second on an idle machine
    statements = [statement for each in read.values() for statement in each]
    assert len(read) == 130
    assert len(statements) + sum(len(statement.where) for statement in statements) == 173
    assert sum(len(statement.operators) for statement in statements) == 230
    vectorial = [label for label, each in read.items() if any(_has_vectors(statement) for statement in each)]
    assert len(vectorial) == 61


def _has_vectors(statement):
    nodes = (node for side in statement.sides for node in side.walk() if not isinstance(node, t.Condition))
    return any(node.type in (t.VECTOR, t.TENSOR) for node in nodes)


def _closing(tokens, place):
    """Does this punctuation end the display, or a row of a matrix?"""
    rest = {token.type for token in tokens[place:] if token.type not in PUNCTUATION}
    after = next((token.type for token in tokens[place:] if token.type not in PUNCTUATION), "")
    return tokens[place].type in PUNCTUATION and (not rest or after in ("ROW", "ENDMATRIX", "IF"))


@pytest.mark.parametrize("double", [False, pytest.param(True, marks=pytest.mark.long)], ids=["without", "twice"])
@pytest.mark.parametrize("record", LEDGER.values(), ids=LEDGER.keys())
def test_every_token_matters(record, double):
    """Any token left out or written twice, but closing punctuation, gives another reading or an error."""
    read = parse(record.latex, record.scope)
    tokens = tokenise(record.latex)
    for place, token in enumerate(tokens):
        if _closing(tokens, place) or (record.id in BREAKS and token == "=" and not double):
            continue
        changed = f"{record.latex[: token.start_pos]} {token} {token if double else ''} {record.latex[token.end_pos :]}"
        if not double:
            changed = f"{record.latex[: token.start_pos]} {record.latex[token.end_pos :]}"
        try:
            assert parse(changed, record.scope) != read, token
        except ReadError:
            continue


@pytest.mark.parametrize("record", LEDGER.values(), ids=LEDGER.keys())
def test_every_symbol_lies_in_one_leaf(record):
    leaves, heads = [], []
    for statement in parse(record.latex, record.scope):
        for said in (statement, *statement.where):
            for side in said.sides:
                assert side.span[0] >= said.span[0]
                assert side.span[1] <= said.span[1]
                leaves += [node.span for node in side.walk() if isinstance(node, t.Name | t.Number)]
                heads += [node.span for node in side.walk() if isinstance(node, HEADS)]
    for token in tokenise(record.latex):
        if token.type in ("NUMBER", "LETTER", "COMMAND"):
            inside = sum(start <= token.start_pos < stop for start, stop in leaves)
            assert inside == 1 or (inside == 0 and any(a <= token.start_pos < b for a, b in heads)), token


# The ledger against the article.


def test_ledger_and_its_own_print_agree():
    source = "\n".join(
        f"\\begin{{equation}} \\label{{{r.id}}} \\nonumber\n{r.latex}\n\\end{{equation}}" for r in LEDGER.values()
    )
    assert compare(LEDGER, source) == []
    changed = source.replace(r"\frac{f^\prime(a)}{4}", r"\frac{f^\prime(a)}{2}")
    assert [(d.id, d.kind) for d in compare(LEDGER, changed)] == [("exsl17", "differs")]
    assert from_source(source, ["exsl18"])["exsl18"].given == ("a = 1",)


def test_every_record_has_a_section_and_a_domain():
    assert all(record.scope for record in LEDGER.values())
    lines = [record.line for record in LEDGER.values()]
    assert lines == sorted(lines)
    assert [record.id for record in LEDGER.values() if not record.domain] == []


def test_ledger_says_what_the_article_prints():
    path = article()
    if path is None:
        pytest.skip("the article's source is not here; set DERIVE_PAPER")
    text = read_source(path)
    assert compare(LEDGER, text) == []
    lines = {display.label: display.line for display in read_displays(text)}
    assert {record.id: record.line for record in LEDGER.values()} == lines
    for record in from_source(text).values():
        read = parse(record.latex, record.scope, (record.line, record.column))
        assert read == parse(LEDGER[record.id].latex, record.scope)
