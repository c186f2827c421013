"""LaTeX as MathML: what is set, what is shown as text, and that no text gets out of it."""

from __future__ import annotations

import re
import xml.etree.ElementTree as ET

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from derive.paper.ledger import load_ledger
from derive.paper.text_claims import load_claims
from derive.report import text as tex
from derive.report.page.elements import CORE
from derive.report.page.mathml import DEEPEST, Setter, mathml
from derive.report.page.tokens import UnsetError

PIECES = st.sampled_from(
    [
        *(
            "x",
            "12",
            "{",
            "}",
            "_",
            "^",
            "'",
            " ",
            "&",
            "<",
            ">",
            '"',
            "(",
            ")",
            "]",
            "|",
            "</math>",
            "<script>",
            "\x00",
        ),
        *(r"\\", r"\frac", r"\sqrt", r"\left(", r"\right)", r"\left.", r"\right|", r"\Big(", r"\Big)", r"\mathrm"),
        *(r"\begin{matrix}", r"\end{matrix}", r"\text{", r"\xi", r"\int", r"\limits", r"\boldsymbol", r"\mathbbm"),
        *(r"\rm", r"\overline", r"\script", "<script>", "\x00"),
    ]
)


def inner(latex: str) -> str:
    return str(Setter(latex).whole())


@pytest.mark.parametrize(
    ("latex", "made"),
    [
        ("x^23", "<mrow><msup><mi>x</mi><mn>2</mn></msup><mn>3</mn></mrow>"),
        (r"\frac12", "<mfrac><mn>1</mn><mn>2</mn></mfrac>"),
        (r"x'_{a}", "<msubsup><mi>x</mi><mi>a</mi><mo>′</mo></msubsup>"),
        (r"\xi_{\mathrm{tip}}", "<msub><mi>ξ</mi><mi>tip</mi></msub>"),
        (r"{\rm if} x", "<mrow><mi>if</mi><mi>x</mi></mrow>"),
        (r"\mathrm{d}", '<mi mathvariant="normal">d</mi>'),
        (r"\boldsymbol{\kappa}", '<mi mathvariant="normal" class="b">κ</mi>'),
        (r"\mathbbm{h}", '<mi mathvariant="normal">𝕙</mi>'),
        (r"\mathscr B", '<mi mathvariant="normal">ℬ</mi>'),
        (r"\overline{\gamma}", '<mover><mi>γ</mi><mo stretchy="true">¯</mo></mover>'),
        (r"\sqrt[3]{]x}", '<mroot><mrow><mo stretchy="false">]</mo><mi>x</mi></mrow><mn>3</mn></mroot>'),
        (r"a < b", "<mrow><mi>a</mi><mo>&lt;</mo><mi>b</mi></mrow>"),
    ],
)  # fmt: skip
def test_formulas_are_set(latex: str, made: str) -> None:
    assert inner(latex) == made


def test_brackets_of_a_size_are_pairs_where_they_close() -> None:
    assert inner(r"\Big(\frac{a}{b}\Big)^2").startswith("<msup><mrow><mo")
    assert inner(r"\big[ \big( x \big) \big]").count("<mrow>") == 2
    broken = inner(r"\begin{split} \Big( a \\ + b \Big) \end{split}")
    assert broken.count('minsize="1.6em"') == 2


@pytest.mark.parametrize(
    "latex", ["", "{", "}", r"\script", r"\left(x", r"\frac{a}", "a & b", r"\end{matrix}", r"\mathbb{AB}", "x" * 7000]
)
def test_what_cannot_be_set_is_shown_as_text(latex: str) -> None:
    with pytest.raises(UnsetError):
        Setter(latex).whole()
    assert mathml(latex).startswith('<code class="tex">')


def test_depth_is_limited() -> None:
    assert inner("{" * (DEEPEST - 1) + "x" + "}" * (DEEPEST - 1))
    with pytest.raises(UnsetError, match="too deep"):
        inner("{" * 900 + "x" + "}" * 900)
    with pytest.raises(UnsetError, match="too deep"):
        inner(r"\sqrt" * 900 + "x")


def test_all_that_the_article_prints_is_set() -> None:
    for record in load_ledger().values():
        for latex in (record.latex, *record.given):
            assert mathml(tex.printed(latex)).startswith("<math"), record.id
    for claim in load_claims().values():
        assert mathml(tex.printed(claim.printed)).startswith("<math"), claim.id


@settings(max_examples=300, deadline=None)
@given(st.lists(PIECES, max_size=12).map("".join))
def test_any_text_gives_whole_elements(latex: str) -> None:
    made = mathml(latex)
    root = ET.fromstring(re.sub(r"[\x00-\x08]", "", made))
    assert {one.tag for one in root.iter()} <= (set(CORE) if root.tag == "math" else {"code"})
