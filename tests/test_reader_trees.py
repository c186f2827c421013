"""Printing any tree and reading it gives the tree, in the letters of every section; noise is read or refused."""

from __future__ import annotations

import random

import pytest
from hypothesis import HealthCheck, assume, given, settings
from hypothesis import strategies as st

from derive.paper import tree as t
from derive.paper.conventions import Declared, _data, scope
from derive.paper.errors import ReadError
from derive.paper.indices import contracted, one_set_of_free
from derive.paper.ledger import load_ledger
from derive.paper.printer import to_latex
from derive.paper.reader import parse
from derive.paper.tokens import tokenise

LEDGER = load_ledger()
SCOPES = list(_data()["scopes"])
Trees = st.SearchStrategy[t.Node]
QUANTITIES = (t.SCALAR, t.VECTOR, t.TENSOR)
SIGNS = st.sampled_from(["-", r"\pm", r"\mp"])


class Letters:
    """Strategies for the trees of a section, by type."""

    def __init__(self, where: str) -> None:
        self.scope = scope(where)
        self.declared = [*self.scope.by_name.values(), *self.scope.by_letter.values()]
        plain = [one for one in self.declared if one.kind not in ("function", "order")]
        self.names = {kind: [name_of(one) for one in plain if one.kind == kind] for kind in (*QUANTITIES, t.REGION)}
        self.built: dict[tuple[str, int], Trees] = {}
        self.arcs = [name_of(one) for one in plain if one.sort == "arc"]

    def leaf(self, kind: str) -> Trees:
        numbers = [st.integers(0, 99).map(t.Number)] if kind == t.SCALAR else []
        calls = [self.call(one) for one in self.declared if one.argument == "arc" and one.kind == kind]
        return st.one_of(st.sampled_from(self.names[kind]), *numbers, *calls[:3])

    def call(self, one: Declared) -> Trees:
        arcs = st.sampled_from([*self.arcs, t.Number(0), t.Sum((self.arcs[0], self.arcs[-1]))])
        return arcs.map(lambda arc: t.Call(one.name, (arc,), 0, one.type, one.index))

    def tree(self, kind: str, depth: int) -> Trees:
        """Built once."""
        if (kind, depth) not in self.built:
            self.built[kind, depth] = self._tree(kind, depth)
        return self.built[kind, depth]

    def _tree(self, kind: str, depth: int) -> Trees:
        if depth == 0 or not self.names[kind]:
            return self.leaf(kind)
        own = {t.SCALAR: self.scalar, t.VECTOR: self.vector, t.TENSOR: self.tensor}[kind](depth - 1)
        return st.one_of(self.leaf(kind), *own, *self.any_type(kind, depth - 1))

    def any_type(self, kind: str, depth: int) -> list[Trees]:
        inner, scalar = self.tree(kind, depth), self.tree(t.SCALAR, depth)
        moving = [name_of(one) for one in self.declared if one.callable and one.kind == kind]
        found = [
            st.lists(st.one_of(inner, st.builds(t.Signed, SIGNS, inner)), min_size=2, max_size=3).map(sum_of),
            st.builds(t.Signed, st.sampled_from(["-", "+", r"\pm", r"\mp"]), inner),
            st.builds(lambda one, two, of: product([one, of, two]), scalar, scalar, inner),
            st.builds(t.Quotient, inner, scalar),
            st.builds(t.Varied, inner),
            st.builds(t.Integral, inner, st.sampled_from(self.arcs).map(lambda by: (by,)), scalar, scalar),
            st.builds(lambda of, by: t.Integral(of, (by,)), inner, scalar.filter(lambda by: by != t.Name("volume"))),
            st.builds(t.Derivative, st.sampled_from(self.names[kind]), st.sampled_from(self.arcs), st.booleans()),
            st.builds(lambda of, by, at: t.At(t.Derivative(of, by), at), inner, *[st.sampled_from(self.arcs)] * 2),
            st.builds(t.At, inner, scalar, st.sampled_from(self.names[t.SCALAR])),
            st.builds(t.Between, inner, scalar, scalar, st.one_of(st.none(), st.sampled_from(self.arcs))),
            st.builds(t.Limit, inner, st.sampled_from(self.names[t.SCALAR]), scalar),
            st.builds(lambda one, two: t.Stack((one, two)), inner, inner),
            st.builds(lambda of, side: t.Cases((of,), (t.Condition((side, side), ("<",)),)), inner, scalar),
        ]
        return found + [st.builds(t.Primed, st.sampled_from(moving), st.integers(1, 3))] * bool(moving)

    def scalar(self, depth: int) -> list[Trees]:
        inner = self.tree(t.SCALAR, depth)
        functions = [one for one in self.declared if one.kind == "function"]
        found = [
            st.builds(t.Power, inner.filter(lambda node: not isinstance(node, t.Number)), inner),
            st.builds(t.Root, inner, st.integers(2, 4)),
            st.builds(t.Norm, inner),
            st.builds(lambda one, two: t.Maximum((one, two)), inner, inner),
            st.builds(
                lambda of, by, low, high: t.Maximum((of,), by, t.Interval(low, high, True, False)),
                inner, st.sampled_from(self.arcs), inner, inner,
            ),
        ]  # fmt: skip
        if functions:
            made = st.builds(
                lambda one, of, primes: t.Call(one.name, (of,), primes),
                st.sampled_from(functions),
                inner,
                st.integers(0, 2),
            )
            found += [made, made.map(lambda call: t.Power(call, t.Number(3)))]
        if "O" in self.scope.by_name:
            found.append(inner.map(t.BigO))
        if self.names[t.VECTOR]:
            vector = self.tree(t.VECTOR, depth)
            found += [st.builds(t.Dot, vector, vector), vector.map(t.Norm), vector.map(square)]
        if "Sigma" in self.scope.by_name:
            over = st.builds(lambda a, b: t.RegionProduct(t.Name("Sigma", t.REGION), t.Interval(a, b)), inner, inner)
            three = (t.Name("X_1"), t.Name("X_2"), t.Name("s"))
            found.append(st.builds(lambda of, region: t.Integral(of, three, region=region), inner, over))
        return found

    def vector(self, depth: int) -> list[Trees]:
        vector = self.tree(t.VECTOR, depth)
        found = [st.builds(t.Cross, vector, vector)]
        return found + [st.builds(t.Apply, self.tree(t.TENSOR, depth), vector)] * bool(self.names[t.TENSOR])

    def tensor(self, depth: int) -> list[Trees]:
        vector, tensor = self.tree(t.VECTOR, depth), self.tree(t.TENSOR, depth)
        return [
            st.builds(t.Outer, vector, vector),
            st.builds(t.Compose, tensor, tensor),
            tensor.map(t.Transpose),
            tensor.map(lambda of: t.Power(of, t.Signed("-", t.Number(1)))),
        ]


def name_of(one: Declared) -> t.Name:
    return t.Name(one.name, one.type, one.index)


def square(of: t.Node) -> t.Node:
    return t.Power(of, t.Number(2))


def product(factors: list[t.Node]) -> t.Node:
    """Numbers do not stand side by side."""
    kept = [one for n, one in enumerate(factors) if not (n and isinstance(one, t.Number))]
    return kept[0] if len(kept) == 1 else t.Product(tuple(kept))


def sum_of(terms: list[t.Node]) -> t.Node:
    """O(…) takes the type of the terms beside it."""
    kind = next((one.type for one in terms if not isinstance(one, t.BigO)), t.SCALAR)
    return t.Sum(tuple(t.BigO(one.of, kind) if isinstance(one, t.BigO) else one for one in terms))


def refuse(place: int, message: str) -> ReadError:
    return ReadError(1, place, message)


@pytest.mark.parametrize("where", SCOPES)
@pytest.mark.parametrize("kind", QUANTITIES)
def test_reading_what_is_printed_gives_the_tree(where, kind):
    letters = Letters(where)
    if not letters.names[kind]:
        pytest.skip("the section has none")

    @settings(max_examples=50, deadline=None, suppress_health_check=list(HealthCheck), derandomize=True)
    @given(letters.tree(kind, 2))
    def check(tree):
        try:
            tree = contracted(tree, refuse)
            one_set_of_free([tree], refuse)
        except ReadError:
            assume(False)
        side = t.Statement((tree, tree), ("=",))
        assert parse(to_latex(side, where), where) == [side]

    check()


@settings(max_examples=300, deadline=None)
@given(st.text(alphabet="\\{}()[]^_'&%,;.=<>+-/| \n0123456789abdfksuvxyz", max_size=60))
def test_noise_is_read_or_refused(text):
    try:
        parse(text, "parallel")
    except ReadError as error:
        found = error
    else:
        return
    assert found.line >= 1
    assert found.column >= 1


@pytest.mark.parametrize("where", SCOPES)
def test_shuffled_tokens_are_refused_or_read_and_printed_back(where):
    """Pieces of displays in any order: an error with a place, or statements that print and read back."""
    chance = random.Random(where)
    tokens = [list(map(str, tokenise(record.latex))) for record in LEDGER.values() if record.scope == where]
    read = 0
    for _ in range(400):
        row = list(chance.choice(tokens))
        for _ in range(chance.randint(1, 3)):
            other, place = chance.choice(tokens), chance.randrange(len(row) + 1)
            start = chance.randrange(len(other))
            row[place : place + chance.randint(0, 3)] = other[start : start + chance.randint(1, 4)]
        text = " ".join(row)
        try:
            statements = parse(text, where)
        except ReadError:
            continue
        read += 1
        for statement in statements:
            assert parse(to_latex(statement, where), where) == [statement], text
    assert read > 0
