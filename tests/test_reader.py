"""The reader of printed formulas: scalars, symbols and sections; what it refuses; sources and their displays."""

from __future__ import annotations

import contextlib
import time

import pytest
from sympy import Function, Symbol, cos

from derive.paper import tree as t
from derive.paper.brackets import MAX_DEPTH
from derive.paper.conventions import canonical, scope, scope_of
from derive.paper.displays import read_displays, read_source
from derive.paper.errors import ReadError
from derive.paper.printer import to_latex
from derive.paper.reader import parse
from derive.paper.symbolic import Dot, Rate, to_sympy

xi, s, ell, a = t.Name("xi"), t.Name("s"), t.Name("ell"), t.Name("a")
beta, gamma, eta = t.Name("beta"), t.Name("gamma"), t.Name("eta")


def one(latex: str, where: str = "parallel") -> t.Statement:
    (statement,) = parse(latex, where)
    return statement


def value(latex: str, where: str = "parallel") -> t.Node:
    return one(f"{latex} = 0", where).sides[0]


# What is read.


@pytest.mark.parametrize(
    ("latex", "tree"),
    [
        (r"\xi(\ell)", t.Call("xi", (ell,))),
        (r"\xi^2 (\ell)", t.Power(t.Call("xi", (ell,)), t.Number(2))),
        (r"\xi(\ell)^2", t.Power(t.Call("xi", (ell,)), t.Number(2))),
        (r"\xi (1 - \xi)", t.Product((xi, t.Sum((t.Number(1), t.Signed("-", xi)))))),
        (r"\beta (s)", t.Product((beta, s))),
        (r"f^{\prime\prime} (a)", t.Call("f", (a,), 2)),
        (r"f''(a)", t.Call("f", (a,), 2)),
        (r"\hat{f} (\xi) \big( 1 \big)", t.Product((t.Call("f_hat", (xi,)), t.Number(1)))),
        (r"\wp u", t.Call("wp", (t.Name("u"),))),
        (r"\wp (u; g_2, g_3)", t.Call("wp", (t.Name("u"), t.Name("g_2"), t.Name("g_3")))),
        (r"2 \wp v", t.Product((t.Number(2), t.Call("wp", (t.Name("v"),))))),
        (r"\frac{d \xi}{ds}", t.Derivative(xi, s)),
        (r"\gamma/(2\beta)", t.Quotient(gamma, t.Product((t.Number(2), beta)))),
        (r"\frac\beta2", t.Quotient(beta, t.Number(2))),
        (r"u_{\mathrm{o}} + s", t.Sum((t.Name("u_o"), s))),
        (r"(y^\prime)^2", t.Power(t.Primed(t.Name("y"), 1), t.Number(2))),
    ],
)
def test_trees(latex, tree):
    assert value(latex) == tree


def test_cross_binds_before_dot_and_scalars_stay_outside():
    d3, e_x = t.Name("d_3", "vector"), t.Name("e_x", "vector")
    tree = value(r"k \boldsymbol{d}_3 \times \boldsymbol{d}_3^{\, \prime} \cdot \boldsymbol{e}_x", "plane")
    assert tree == t.Product((t.Name("k"), t.Dot(t.Cross(d3, t.Primed(d3, 1)), e_x)))


def test_statements_relations_and_arrows():
    first, second = parse(r"\xi_b \to \xi_b = 1 + \frac{2 \beta}{\eta} \,, \qquad b \to 2 \beta > 0 \,.", "orthogonal")
    assert first.operators == ("->", "=")
    assert first.sides[0] == first.sides[1] == t.Name("xi_b")
    assert second.operators == ("->", ">")


def test_letters_change_their_meaning_by_section():
    assert scope_of("exsl9a") == "plane"
    assert scope_of("exhpf13bis") == "orthogonal"
    assert scope_of("kth16") == "kirchhoff"
    assert scope_of("campi") == "magnetization"
    assert scope_of("exslrm3") == "planarity"
    assert scope_of("exsl19a") == "parallel"
    assert scope_of("exsl12b") is None
    assert canonical(r"\boldsymbol d_3") == canonical(r"\boldsymbol{d}_{3}")
    assert scope("orthogonal").by_spelling[r"\bar{\gamma}"].name == "gamma_bar"
    with pytest.raises(ReadError, match=r"'\\overline\{\\gamma\}' is not declared in scope 'parallel'"):
        parse(r"\overline{\gamma} = 0", "parallel")


def test_sympy_values_are_in_the_printed_symbols():
    real = Symbol("xi", real=True)
    assert to_sympy(value(r"f(\xi) - \cos\xi"), "parallel") == Function("f")(real) - cos(real)
    squared = to_sympy(value(r"(\boldsymbol{d}_3 \cdot \boldsymbol{e})^2"), "parallel")
    assert squared == Dot(Symbol("d_3"), Symbol("e")) ** 2
    assert to_sympy(value(r"y^{\prime\prime}"), "parallel") == Rate(Symbol("y", real=True), 2)
    assert to_sympy(value(r"\wp u"), "parallel") == Function("wp")(Symbol("u"))


# What is refused, and where.


@pytest.mark.parametrize(
    ("latex", "column", "message"),
    [
        (r"\gamma = \foo", 10, "not declared"),
        (r"\gamma + = 1", 10, "a relation cannot stand here"),
        (r"\gamma", 1, "needs a relation"),
        (r"\gamma = (1 + \beta", 10, "never closed"),
        (r"\gamma = 1)", 11, "closes nothing"),
        (r"\gamma = \left( 1 )", 19, "do not belong together"),
        (r"\gamma = \boldsymbol{e}", 10, "check the types"),
        (r"\gamma = \xi (\beta - s)", 14, "argument of"),
        (r"\gamma = \xi (2)", 14, "argument of"),
        (r"\gamma = f", 11, "needs an argument"),
        (r"\gamma = f(a, s)", 11, "takes 1 arguments, not 2"),
        (r"\gamma = \wp u v", 16, "where does the argument"),
        (r"\gamma = 1/2 \beta", 14, "where does the denominator"),
        (r"\gamma = \beta^\prime", 10, "is a constant"),
        (r"\gamma = \xi^12", 14, "first digit"),
        (r"\gamma = \beta \cdot \eta", 10, "no vector"),
        (r"\boldsymbol{e} = \boldsymbol{e} \times \boldsymbol{e}_x \times \boldsymbol{e}_y", 57, "two"),
        (r"\gamma = 1 ,, \gamma = 2", 13, "follows no statement"),
        (r"\gamma = \frac{d \xi}{\beta}", 22, "d stands above"),
        (r"\gamma = 1 # 2", 12, "unexpected character"),
        (r"\gamma = \int 1", 10, "needs a differential"),
        (r"\gamma = " + r"\hat" * 3000 + "f", 26, "accents"),
        (r"\gamma = " + "9" * 5000, 10, "5000 digits"),
        (r"\begin{split} \gamma = 1", 25, "never ended"),
        (r"\gamma = 1 \end{split}", 12, "ends nothing"),
        ("", 1, "no formula"),
        ("\x00\x01", 1, "unexpected character"),
        (r"\gamma = " + "(" * (MAX_DEPTH + 1), 10 + MAX_DEPTH, "nest deeper"),
        (r"\gamma = 1" + " + 1" * 10_000, 1, "the limit is"),
    ],
)
def test_unread_text_is_an_error_with_its_place(latex, column, message):
    with pytest.raises(ReadError, match=message) as caught:
        parse(latex, "parallel")
    assert (caught.value.line, caught.value.column) == (1, column)


def test_places_count_from_the_source():
    with pytest.raises(ReadError, match="not declared") as caught:
        parse("\n\\gamma =\n  \\foo", "parallel", start=(40, 17))
    assert (caught.value.line, caught.value.column) == (42, 3)
    assert caught.value.snippet.splitlines()[-1].index("^") == caught.value.snippet.splitlines()[0].index("\\foo")


def test_deepest_nesting_is_read():
    nested = "(" * MAX_DEPTH + r"\beta" + ")" * MAX_DEPTH
    assert value(nested) == beta
    fractions = r"\frac{1}{" * MAX_DEPTH + "2" + "}" * MAX_DEPTH
    assert parse(to_latex(one(f"{fractions} = 0"), "parallel"), "parallel")


@pytest.mark.parametrize(
    ("source", "message"),
    [
        ("", "no 'equation' environment"),
        ("\x00", "control character"),
        (r"\begin{equation}\label{x} a = b", "never closed"),
        (r"\begin{equation} a = b \end{equation}", "needs one"),
        (r"\begin{equation}\label{x} a \end{equation} \begin{equation}\label{x} b \end{equation}", "already used"),
        (r"\end{equation}", "do not pair"),
    ],
)
def test_sources_that_cannot_be_split(source, message):
    with pytest.raises(ReadError, match=message):
        read_displays(source)


def test_binary_files_are_refused(tmp_path):
    path = tmp_path / "paper.tex"
    path.write_bytes(b"first\n\xff\xfe\x00")
    with pytest.raises(ReadError, match="no UTF-8 text") as caught:
        read_source(path)
    assert (caught.value.line, caught.value.column) == (2, 1)


def test_comments_hide_displays():
    text = "% \\begin{equation}\n\\begin{equation}\\label{x} a = b % \\label{y}\n\\end{equation}"
    (display,) = read_displays(text)
    assert (display.label, display.line) == ("x", 2)


def _nest(before: str, after: str, inside: str, depth: int = MAX_DEPTH) -> str:
    return before * depth + inside + after * depth + " = 1"


@pytest.mark.parametrize(
    ("latex", "where"),
    [
        (_nest(r"\xi (\beta + ", ")", r"\beta"), "parallel"),
        (_nest(r"\beta (", ")", r"\boldsymbol{e}"), "plane"),
        (_nest(r"\lim_{\xi \to 0} \frac{1}{", "}", r"\xi"), "parallel"),
        (_nest(r"\lim_{\xi \to 0} \xi|_{\xi = ", "}", "0"), "parallel"),
        (_nest(r"\delta \left[ \frac{1}{", r"} \right]_0^\ell", "s", MAX_DEPTH // 2), "variation"),
        (_nest(r"\int_{", r"}^1 \xi d \xi", "0"), "parallel"),
        (_nest(r"\xi^\mathrm{", "}", "u"), "parallel"),
        (_nest(r"\boldsymbol Q (", ")", r"\boldsymbol \mu"), "kirchhoff"),
        (_nest(r"\left\{ \begin{matrix}", r"\mathrm{if} 1 < 2 \end{matrix} \right.", "1", 15), "parallel"),
        (r"\beta " * 3000 + "= 1", "parallel"),
        (r"\int " * 5000, "parallel"),
        (r"\boldsymbol Q " * 1000 + r"\boldsymbol \mu = \boldsymbol 0", "kirchhoff"),
        ("{" * 10_000, "parallel"),
        ("1 = " * 4000 + "1", "parallel"),
        ("|" * 10_000, "parallel"),
    ],
)  # fmt: skip
def test_hostile_formulas_end_in_time(latex, where):
    """Read or refused, in seconds, and without exhausting the stack (which would be another exception)."""
    start = time.process_time()
    with contextlib.suppress(ReadError):
        parse(latex, where)
    assert time.process_time() - start < 10
