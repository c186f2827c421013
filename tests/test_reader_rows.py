"""Rows of vectors and tensors, indices, and what has a form of its own: how they are read, and what is refused."""

from __future__ import annotations

import pytest

from derive.paper import tree as t
from derive.paper.conventions import LETTERS, scope
from derive.paper.errors import ReadError
from derive.paper.indices import contracted, overfull, plain
from derive.paper.ledger import load_ledger
from derive.paper.reader import parse

LEDGER = load_ledger()


def vector(name: str, index: str = "") -> t.Name:
    return t.Name(name, t.VECTOR, index)


def tensor(name: str) -> t.Name:
    return t.Name(name, t.TENSOR)


def value(latex: str, where: str) -> t.Node:
    """The tree of an expression: the left side of a statement with 0."""
    (statement,) = parse(f"{latex} = 0", where)
    return statement.sides[0]


s, ell = t.Name("s"), t.Name("ell")
d3, h, e, kappa, mu = vector("d_3"), vector("h_a"), vector("e"), vector("kappa"), vector("mu")
C, Q = tensor("C"), tensor("Q")
X, d_alpha = t.Name("X", index="alpha"), vector("d", "alpha")
turned = t.Cross(kappa, d_alpha)


@pytest.mark.parametrize(
    ("where", "latex", "tree"),
    [
        (
            "line_energy",
            r"X_\alpha \mathbbm{h}_\mathrm{a} \cdot \boldsymbol{\kappa} \times \boldsymbol{d}_\alpha"
            r" (\boldsymbol{d}_3 \times \mathbbm{h}_\mathrm{a})",
            t.Contraction("alpha", t.Product((X, t.Dot(h, turned), t.Cross(d3, h)))),
        ),
        (
            "couple",
            r"(\boldsymbol{d}_3 \cdot \mathbbm{h}_\mathrm{a}) (\boldsymbol{d}_3 \times \mathbbm{h}_\mathrm{a})"
            r" \boldsymbol{d}_3 \cdot \boldsymbol{\kappa} \times \boldsymbol{d}_1",
            t.Product((t.Dot(d3, h), t.Cross(d3, h), t.Dot(d3, t.Cross(kappa, vector("d_1"))))),
        ),
        (
            "variation",
            r"(\boldsymbol d_3 \cdot \boldsymbol e) \, \boldsymbol d_3 \times \boldsymbol e \cdot \delta \boldsymbol q",
            t.Product((t.Dot(d3, e), t.Dot(t.Cross(d3, e), t.Varied(vector("q"))))),
        ),
        (
            "line_energy",
            r"\boldsymbol{\kappa}^\mathrm{u} \times X_\alpha \boldsymbol{d}^{\rm u}_\alpha",
            t.Cross(vector("kappa_u"), t.Contraction("alpha", t.Product((X, vector("d_u", "alpha"))))),
        ),
        (
            "kirchhoff",
            r"\boldsymbol d_3 \otimes \boldsymbol d_1 (X_1 \boldsymbol \kappa \times \boldsymbol d_2)",
            t.Apply(t.Outer(d3, vector("d_1")), t.Product((t.Name("X_1"), t.Cross(kappa, vector("d_2"))))),
        ),
        ("kirchhoff", r"\boldsymbol C \boldsymbol \mu \cdot \boldsymbol \mu", t.Dot(t.Apply(C, mu), mu)),
        ("kirchhoff", r"\boldsymbol \mu \times \boldsymbol C \boldsymbol \mu", t.Cross(mu, t.Apply(C, mu))),
        (
            "variation",
            r"(\delta \boldsymbol{Q}) \boldsymbol{Q}^\mathsf{T} \boldsymbol{d}_1",
            t.Apply(t.Compose(t.Varied(Q), t.Transpose(Q)), vector("d_1")),
        ),
        (
            "variation",
            r"(\boldsymbol{Q} (s) - \boldsymbol{I}) \boldsymbol{d}_3 (s)",
            t.Apply(
                t.Sum((t.Call("Q", (s,), 0, t.TENSOR), t.Signed("-", tensor("identity")))),
                t.Call("d_3", (s,), 0, t.VECTOR),
            ),
        ),
        (
            "kirchhoff",
            r"EI \boldsymbol{d}_\alpha \otimes \boldsymbol{d}_\alpha",
            t.Product((t.Name("E"), t.Name("I_area"), t.Contraction("alpha", t.Outer(d_alpha, d_alpha)))),
        ),
        ("variation", r"\delta \boldsymbol{q}^\prime", t.Varied(t.Primed(vector("q"), 1))),
        ("kirchhoff", r"{\boldsymbol x^{\mathrm u}}'(s)", t.Call("x_u", (s,), 1, t.VECTOR)),
        ("kirchhoff", r"\frac{d \boldsymbol{x}}{{d}s} (s)", t.At(t.Derivative(vector("x"), s), s)),
        (
            "kirchhoff",
            r"\frac{\partial \bar{\boldsymbol{u}}}{\partial X_\alpha} \otimes \boldsymbol{g}^\alpha",
            t.Contraction("alpha", t.Outer(t.Derivative(vector("u_bar"), X, True), vector("g_dual", "alpha"))),
        ),
        ("kirchhoff", r"\left| \boldsymbol \mu \right|", t.Norm(mu)),
        ("kirchhoff", r"| \boldsymbol \mu | |\boldsymbol \kappa|", t.Product((t.Norm(mu), t.Norm(kappa)))),
        ("kirchhoff", r"|1 - |\boldsymbol \mu||", t.Norm(t.Sum((t.Number(1), t.Signed("-", t.Norm(mu)))))),
        ("kirchhoff", r"\psi_e (\boldsymbol{\mu})", t.Call("psi_e", (mu,))),
    ],
)  # fmt: skip
def test_types_decide(where, latex, tree):
    assert value(latex, where) == tree


xi, varsigma = t.Name("xi"), t.Name("varsigma")


@pytest.mark.parametrize(
    ("latex", "tree"),
    [
        (r"\int \limits \frac{d \xi}{\beta}", t.Integral(t.Quotient(t.Number(1), t.Name("beta")), (xi,))),
        (r"\int \frac{2 d \xi}{\beta}", t.Integral(t.Quotient(t.Number(2), t.Name("beta")), (xi,))),
        (r"\int \frac{d \xi}{d s} \, ds", t.Integral(t.Derivative(xi, s), (s,))),
        (r"\int d (2 \xi)", t.Integral(t.Number(1), (t.Product((t.Number(2), xi)),))),
        (r"\beta \int_0^\ell \xi \, ds", t.Product((t.Name("beta"), t.Integral(xi, (s,), t.Number(0), ell)))),
        (r"\xi(s)_{s=\ell}", t.At(t.Call("xi", (s,)), ell, s)),
        (r"\xi(s; \gamma)|_{s=0}", t.At(t.Call("xi", (s, t.Name("gamma"))), t.Number(0), s)),
        (r"[ \varsigma ]_{\varsigma=0}^{\varsigma=s}", t.Between(varsigma, t.Number(0), s, varsigma)),
        (r"\xi \left[ s \right]_0^\ell", t.Product((xi, t.Between(s, t.Number(0), ell)))),
        (r"\lim_{\xi \to \pm \infty} f(\xi)", t.Limit(t.Call("f", (xi,)), xi, t.Signed(r"\pm", t.Name("infinity")))),
        (r"\sin^{-1} \xi", t.Call("asin", (xi,))),
        (r"\wp^{-1} c", t.Call("wp_inverse", (t.Name("c"),))),
        (r"\ln \frac{\sigma(u)}{2}", t.Call("ln", (t.Quotient(t.Call("wsigma", (t.Name("u"),)), t.Number(2)),))),
        (r"\max_{s \in [0, \ell]} \{ \xi, 2 \}", t.Maximum((xi, t.Number(2)), s, t.Interval(t.Number(0), ell))),
        (r"z(\xi)", t.Call("z", (xi,))),
    ],
)  # fmt: skip
def test_forms(latex, tree):
    assert value(latex, "parallel") == tree


@pytest.mark.parametrize(
    ("latex", "left_open", "right_open"),
    [
        ("[a, b]", False, False),
        ("]a, b[", True, True),
        ("(a, b)", True, True),
        ("]a, b]", True, False),
        ("[a, b[", False, True),
    ],
)  # fmt: skip
def test_intervals(latex, left_open, right_open):
    (statement,) = parse(rf"\xi \in {latex}", "parallel")
    assert statement.operators == ("in",)
    assert statement.sides[1] == t.Interval(t.Name("a"), t.Name("b"), left_open, right_open)


def test_what_is_said_of_letters_belongs_to_the_statement_before():
    first, second = parse(LEDGER["kthr4"].latex, "kirchhoff")
    letter, values = first.where[0].sides
    assert (letter, values.items) == (t.Name("i", t.INDEX), tuple(map(t.Number, (1, 2, 3))))
    assert second.where == ()
    (on_the_rod,) = parse(LEDGER["exsl20"].latex, "parallel")
    assert on_the_rod.where[0].sides[1] == t.Interval(t.Number(0), ell, True, True)
    admissible = parse(LEDGER["exsl15"].latex, "parallel")
    assert [statement.where for statement in admissible] == [(), ()]


def test_stacks_and_cases():
    stack = parse(LEDGER["exsl14"].latex, "parallel")[0].sides[0]
    assert stack == t.Stack((t.Name("xi_a"), t.Name("xi_b")))
    cases = parse(LEDGER["exhpf13bis"].latex, "orthogonal")[0].sides[1]
    assert [condition.operators for condition in cases.conditions] == [("=", "<"), ("=", ">")]
    assert [case.sign for case in cases.values] == ["-", "+"]


def test_a_relation_repeated_at_a_line_break_is_one():
    assert len(parse(LEDGER["elmr9"].latex, "variation")[0].sides) == 4
    with pytest.raises(ReadError, match="a relation cannot stand here"):
        parse(r"\begin{split} a = = b \end{split}", "parallel")


def test_orders_take_the_type_of_what_stands_beside_them():
    kinds = {
        label: {n.kind for statement in parse(LEDGER[label].latex, LEDGER[label].scope) for side in statement.sides
                for n in side.walk() if isinstance(n, t.BigO)}
        for label in ("kthr9", "kthr11", "kthr13", "elmr14")
    }  # fmt: skip
    assert kinds == {"kthr9": {t.SCALAR}, "kthr11": {t.VECTOR}, "kthr13": {t.TENSOR}, "elmr14": {t.VECTOR}}


# Indices.


def test_families_are_declared_once():
    letters = scope("kirchhoff")
    assert letters.declared("d", "i").latex == r"\boldsymbol{d}_{i}"
    assert letters.declared("d_u_3").latex == r"\boldsymbol{d}_{3}^{\mathrm{u}}"
    assert letters.declared("g_dual", "alpha").latex == r"\boldsymbol{g}^{\alpha}"
    assert letters.declared("kappa_c", "k").assume == ("real",)
    assert ("X", "i") not in letters.by_letter
    assert "d_4" not in letters.by_name
    assert set(LETTERS.values()) == {"i", "j", "k", "alpha", "beta"}


def test_sums_stand_at_the_smallest_node():
    tree = value(r"\boldsymbol{d}_i \cdot \boldsymbol{d}_k \boldsymbol{d}_i \cdot \boldsymbol{d}_k", "kirchhoff")
    assert isinstance(tree, t.Contraction)
    assert isinstance(tree.of, t.Contraction)
    assert (tree.index, tree.of.index) == ("i", "k")
    assert contracted(plain(tree), lambda place, message: ReadError(1, place, message)) == tree
    assert tree.free_indices() == set()


def test_an_index_written_too_often_is_found():
    """Two displays of the article sum over an index that is written three times: they are read, and shown up."""
    found = {
        record.id for record in LEDGER.values() for statement in parse(record.latex, record.scope)
        if overfull(statement.sides)
    }  # fmt: skip
    assert found == {"kth23", "kth25"}
    index, (start, stop) = overfull(parse(LEDGER["kth23"].latex, "line_energy")[0].sides)[0]
    assert index == "alpha"
    assert LEDGER["kth23"].latex[start:stop].count(r"\alpha") == 3


@pytest.mark.parametrize(
    ("where", "latex", "message"),
    [
        ("kirchhoff", r"\boldsymbol d_i = \boldsymbol d_k", "the index i, k is free"),
        ("kirchhoff", r"\boldsymbol d_i + \boldsymbol d_1 = \boldsymbol 0", "the index i is free"),
        ("kirchhoff", r"\boldsymbol d_i \cdot \boldsymbol d_i \boldsymbol d_i = \boldsymbol 0", "summed in one factor"),
        ("kirchhoff", r"\boldsymbol d_i \cdot \boldsymbol d_i (\boldsymbol d_i \cdot \boldsymbol d_i) = 9", "summed"),
        ("kirchhoff", r"\kappa_i^2 = 1", "write the product"),
        ("kirchhoff", r"\boldsymbol d_i = \boldsymbol d_i \,, i = 1, 2", "takes the values 1, 2, 3"),
        ("kirchhoff", r"\boldsymbol d_1 = \boldsymbol d_1 \,, i = 1, 2, 3", "not declared"),
        ("kirchhoff", r"X_3 = 0", "not declared"),
        ("kirchhoff", r"\boldsymbol C \boldsymbol \mu \times \boldsymbol d_1 = \boldsymbol 0", "before or after"),
        ("kirchhoff", r"\boldsymbol d_1 \boldsymbol d_2 = \boldsymbol 0", "two vectors side by side"),
        ("kirchhoff", r"\boldsymbol d_1 \boldsymbol C = \boldsymbol 0", "a vector and a tensor side by side"),
        ("kirchhoff", r"\boldsymbol d_1 \cdot \boldsymbol d_2 \cdot \boldsymbol d_3 = 0", "no vector|two"),
        ("kirchhoff", r"\boldsymbol C \otimes \boldsymbol d_1 = \boldsymbol 0", "no vector"),
        ("kirchhoff", r"\boldsymbol d_1 \otimes \boldsymbol d_2 \otimes \boldsymbol d_3 = 0", "two"),
        ("kirchhoff", r"\boldsymbol d_1^{\mathsf T} = 0", "only a tensor has a transpose"),
        ("kirchhoff", r"\boldsymbol C^2 = 0", "a tensor an inverse"),
        ("kirchhoff", r"\boldsymbol Q^{-1}^{\mathsf T} = 0", "two powers"),
        ("kirchhoff", r"\boldsymbol Q^{\mathsf T} (s)^{-1} = 0", "a second power"),
        ("kirchhoff", r"h = O^2 (\varepsilon)", "nothing is written on O"),
        ("parallel", r"\gamma = \xi^{s=1} (s)", "between a symbol and its argument"),
        ("parallel", r"\gamma = \int \xi \, d \xi \, \partial s", "where does the integral end"),
        ("parallel", r"\gamma = \xi^\hat{f}", "needs an argument"),
        ("kirchhoff", r"\boldsymbol C + \boldsymbol d_1 = 0", "check the types"),
        ("kirchhoff", r"| \boldsymbol C | = 0", "between bars"),
        ("kirchhoff", r"\boldsymbol d_1 = O(\varepsilon) + h", "check the types"),
        ("kirchhoff", r"\frac{\partial \boldsymbol x}{d s} = 0", "a derivative needs both"),
        ("kirchhoff", r"\frac{\boldsymbol x}{\boldsymbol x} = 0", "is divided by"),
        ("kirchhoff", r"h = \max_{s \in \ell} \{ h \}", "lies in a region"),
        ("kirchhoff", r"h = \max \{ \boldsymbol x \}", "a maximum is taken of scalars"),
        ("kirchhoff", r"h = \psi_e (\boldsymbol{\mu} \cdot \boldsymbol{\mu})", "the argument of"),
        ("parallel", r"\gamma = \int \xi", "needs a differential"),
        ("parallel", r"\gamma = \int \xi \, d \xi \beta", "where does the integral end"),
        ("parallel", r"\gamma = \int_0^1 \int \xi \, d \xi", "do not fit"),
        ("line_energy", r"\int_\Sigma X_1 \, dX_1 = 0", "do not fit"),
        ("parallel", r"\gamma = \int_0 \xi d \xi", "over a region or between two values"),
        ("parallel", r"\gamma = \lim_{\xi = 0} \xi", "a limit is written"),
        ("parallel", r"\gamma = [0, 1]", "a region cannot stand here"),
        ("parallel", r"\gamma \in 2", "a scalar cannot stand here"),
        ("parallel", r"\gamma \in [0, 1] = a", "at the end"),
        ("parallel", r"\gamma \in 2 [0, 1]", "a region is no factor"),
        ("parallel", r"\gamma = [ \xi ]_{s=0}^{u=1}", "of one variable"),
        ("parallel", r"\gamma = {y^\prime}", "no part of a name"),
        ("parallel", r"\gamma = | \xi", "never closed"),
        ("parallel", r"\gamma = \left. \xi \right\}", "cannot stand here"),
        ("parallel", r"\gamma = \begin{matrix} 1 \end{matrix}", "cannot stand here"),
        ("parallel", r"\gamma = " + r"\delta " * 50 + r"\xi", "more than 40 integrals"),
        ("variation", "(" + r"\boldsymbol Q " * 50 + r") = 0", "more than 40 tensors"),
    ],
)  # fmt: skip
def test_what_fits_no_reading_or_two_is_refused(where, latex, message):
    with pytest.raises(ReadError, match=message) as caught:
        parse(latex, where)
    assert caught.value.line == 1
    assert caught.value.snippet.endswith("^")


def test_running_text_is_read():
    texts = {
        "parallel": [
            r"\gamma \in ]\gamma_1, \gamma_2[", r"\xi(s; \gamma)|_{s=0} = \cos \vartheta_\mathrm{o}",
            r"u_\mathrm{o} = \omega_3 - \ell", r"\Delta = \beta^2 + \gamma \eta>0", r"v = \wp^{-1}c",
            r"\vartheta_\mathrm{o} = 3 \pi/4",
        ],
        "field_only": [r"-1<\xi_a<\xi_b<1"],
        "force_only": [r"\lim_{\xi \to \pm \infty} f(\xi) = \pm \infty", r"\xi_1 > \xi_2 > \xi_3"],
        "orthogonal": [r"\xi(u)|_{u=\bar{u}} = -1", r"\overline{\gamma} = \eta - \gamma"],
        "magnetization": [
            r"\chi = \big(\chi_{\|}^{-1} + N_{\|}\big)^{-1} - \big(\chi_{\perp}^{-1} + N_{\perp} \big)^{-1}",
            r"\boldsymbol a = \boldsymbol{\mathsf F} \boldsymbol a^{\rm u}"
            r" / |\boldsymbol{\mathsf F} \boldsymbol a^{\rm u}|",
        ],
        "kirchhoff": [
            r"\boldsymbol{\kappa} = \boldsymbol{\kappa}(s) = \kappa_i (s) \boldsymbol{d}_i (s)",
            r"\bar{\boldsymbol{u}} (0,0,s) = \boldsymbol{0}",
        ],
    }  # fmt: skip
    for where, formulas in texts.items():
        for latex in formulas:
            assert len(parse(latex, where)) == 1
