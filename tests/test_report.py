"""Derived forms in the article's letters, and the report in LaTeX."""

from __future__ import annotations

import json
import re
from pathlib import Path
from typing import Any

import pytest
import sympy as sp
from page_standin import measured

from derive import commands_check, commands_report, pdf, pipeline, stages
from derive.cli import main
from derive.paper.ledger import load_ledger
from derive.paper.printer import to_latex
from derive.paper.reader import parse
from derive.paper.symbolic import to_sympy
from derive.report import contents, derived, lines, text, tidy
from derive.report.spell import Speller
from derive.report.tidy import SpellError
from derive.report.writer import Writer

ROOT = Path(__file__).resolve().parent.parent
LEDGER = load_ledger()
# Of every kind one: a polynomial, a refuted formula, elliptic functions, a stack, a limit, an inequality, vectors,
# a tensor, a law.
SAMPLE = ("kthr4", "kth16", "kth17", "kth18", "exsl8", "exsl13", "exsl14", "exsl22", "exsl25", "exsl27", "slch5")


@pytest.fixture(scope="module")
def forms() -> dict[str, list[derived.Derived]]:
    return {name: derived.derived_forms(stages.theory(), LEDGER[name]) for name in SAMPLE}


def shown(found: list[derived.Derived]) -> list[str]:
    return [form.latex for one in found for form in one.forms]


# Expressions as trees.


@pytest.mark.parametrize(
    "printed",
    [
        r"b = \frac{a - 1}{2} + a c^{2}",
        r"b = - \frac{\sqrt{a^{2} + c}}{3 a}",
        r"b = \left( a + c \right) \left( a - c \right)^{2}",
        r"b = a^{\frac{3}{2}} - \frac{1}{c}",
        r"b = 2 \left( \wp \left( u \right) - c \right)",
    ],
)
def test_an_expression_is_written_and_read_again(printed: str) -> None:
    (statement,) = parse(printed, "parallel")
    value = to_sympy(statement.sides[1], "parallel")
    known = {symbol: node for node in statement.sides[1].walk() if (symbol := to_sympy(node, "parallel")).is_Symbol}
    known |= {call: node for node in statement.sides[1].walk() if (call := to_sympy(node, "parallel")).is_Function}
    written = to_latex(Speller(known).of(value), "parallel")
    (again,) = parse(f"b = {written}", "parallel")
    assert sp.simplify(to_sympy(again.sides[1], "parallel") - value) == 0


def test_what_has_no_letter_is_no_guess() -> None:
    with pytest.raises(SpellError, match="no letter for q"):
        Speller({}).of(sp.Symbol("q") + 1)
    with pytest.raises(SpellError, match="no letter for the function tan"):
        Speller({sp.Symbol("q"): parse("a = 1", "parallel")[0].sides[0]}).of(sp.tan(sp.Symbol("q")))


def test_tidying_changes_the_form_only() -> None:
    x, y = sp.symbols("x y", positive=True)
    for expr in (sp.sqrt(x**2 + 2 * x * y + y**2) / y, (1 - x**2) * (y - x), sp.sin(x) ** 2 * y, 1 / (x - 1) + 1 / x):
        at = {x: sp.Rational(2, 7), y: sp.Rational(11, 3)}
        assert all(abs(sp.N((one - expr).subs(at), 30)) < 1e-25 for one in tidy.ways(expr))
    assert x / y + 1 in tidy.ways(sp.sqrt(x**2 + 2 * x * y + y**2) / y)


# Derived forms.


def test_derived_forms_are_what_the_theory_gives(forms: dict[str, list[derived.Derived]]) -> None:
    assert shown(forms["exsl25"]) == [r"\gamma < 2 \beta + \eta"]
    assert shown(forms["exsl27"])[1:] == [r"\xi_{b} \to 1", r"b \to 0"]
    assert len(shown(forms["kthr4"])) == 4  # three members of a family, and the vector itself
    assert all(one.forms for found in forms.values() for one in found)


def test_the_derived_form_of_a_refuted_formula_is_true(forms: dict[str, list[derived.Derived]]) -> None:
    (right,) = shown(forms["slch5"])
    assert not re.search(r"\\ell", right)
    first, second = shown(forms["exsl14"])
    assert first.startswith(r"\xi_{a} = - \frac")
    assert second.startswith(r"\xi_{b} =")


def test_derived_forms_read_back(forms: dict[str, list[derived.Derived]]) -> None:
    for name, found in forms.items():
        for latex in shown(found):
            (statement,) = parse(latex, str(LEDGER[name].scope))
            assert parse(to_latex(statement, str(LEDGER[name].scope)), str(LEDGER[name].scope)) == [statement]


def test_the_forms_do_not_depend_on_what_was_done_before(forms: dict[str, list[derived.Derived]]) -> None:
    for name in ("exsl22", "exsl8"):
        numbered = [sp.Dummy() for _ in range(2000)]  # SymPy numbers them through, and orders terms by names
        assert numbered
        assert derived.derived_forms(stages.theory(), LEDGER[name]) == forms[name]


def test_a_wrong_derived_form_is_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    right = Writer.of
    monkeypatch.setattr(Writer, "of", lambda self, value, powers=None: right(self, value + 1, powers))
    with pytest.raises(derived.ReadBackError, match=r"exsl18: the derived form is not proved .*REFUTED"):
        derived.derived_forms(stages.theory(), LEDGER["exsl18"])


def test_a_form_that_reads_as_another_is_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(derived, "in_lines", lambda statement, scope: to_latex(statement, scope).replace("2", "3"))
    with pytest.raises(derived.ReadBackError, match="exsl25: the derived form does not read back"):
        derived.derived_forms(stages.theory(), LEDGER["exsl25"])
    assert "exsl25" in stages.derive_forms(stages.plain(LEDGER["exsl25"]))["failure"]


def test_what_has_no_derived_form_says_why() -> None:
    for name, said in {"exsl15": "a range", "kthr13": "an order of magnitude", "exsl39": "an identity"}.items():
        found = derived.derived_forms(stages.theory(), LEDGER[name])
        assert all(one.kind.startswith(said) and not one.forms for one in found), name


@pytest.mark.parametrize("name", ["exsl21", "exhpf15", "kth23", "exsl36", "elmr13"])
def test_long_formulas_are_broken_and_read_the_same(name: str) -> None:
    scope = str(LEDGER[name].scope)
    for statement in parse(LEDGER[name].latex, scope):
        latex = lines.in_lines(statement, scope)
        assert parse(latex, scope) == [statement]
        long = sum(map(lines.width, statement.sides)) > lines.LINE
        assert latex.startswith(r"\begin{aligned}") == long


# Text for LaTeX.


def test_text_is_escaped_whatever_it_holds() -> None:
    assert text.text(r"a_b \input{x} 50% $#&~^") == (
        r"a\_b \textbackslash{}input\{x\} 50\% \$\#\&\textasciitilde{}\textasciicircum{}"
    )
    assert text.text("ξ′ ≤ γ₁") == (
        r"\ensuremath{\xi}\ensuremath{'} \ensuremath{\le} \ensuremath{\gamma}\ensuremath{_1}"
    )
    assert text.text("✓\x00") == r"\texttt{U+2713}\texttt{U+0000}"


def test_names_and_numbers_are_set_as_formulas() -> None:
    assert text.symbol("gamma_bar_1") == r"\overline{\gamma}_{1}"
    assert text.symbol("delta_q_1(s)") == r"\delta q_{1}(s)"
    assert text.symbol("V_Pi") == r"V_{\Pi}"
    assert text.symbol("xi_tip") == r"\xi_{\mathrm{tip}}"
    assert text.symbol(r"\input{x}") == r"\text{\textbackslash{}input\{x\}}"
    assert text.prose("force_only, a = -1, at xi_tip") == r"force only, a = $-1$, at $\xi_{\mathrm{tip}}$"
    assert text.prose("as long as κ_x > 0") == r"as long as $\kappa_{x}$ $>$ 0"
    assert text.number("9243/100000") == "0.09243"
    assert text.number("-1/3") == "-1/3"
    assert text.number("1/100000000000000000000") == "10^{-20}"
    assert text.number("1.2345678901234e-12") == r"1.2345679 \cdot 10^{-12}"
    assert text.number(r"\x") == r"\text{\textbackslash{}x}"


def test_a_printed_formula_loses_what_is_no_formula() -> None:
    assert text.printed("x = 1 % why\n\\label{a} \\nonumber \\, ,") == "x = 1"
    assert text.printed(r"\left\{ a \right.") == r"\left\{ a \right."
    assert text.printed(r"a & = b \\ & = c") == r"\begin{aligned} a & = b \\ & = c \end{aligned}"
    assert text.printed(r"\begin{split} a \end{split} \,.") == r"\begin{aligned} a \end{aligned}"


def test_every_section_has_a_title() -> None:
    assert set(contents.TITLES) == {str(record.scope) for record in LEDGER.values()}


# The document.


@pytest.fixture(scope="module")
def job() -> pipeline.Job:
    records = [stages.plain(LEDGER[name]) for name in ("exsl13", "exsl18", "slch5")]
    done = pipeline.Job(printed=[stages.judge_printed(one) for one in records])
    done.records = {one["id"]: one for one in records}
    done.derived = {one["id"]: stages.derive_forms(one) for one in records}
    return done


def test_the_document_says_what_was_found(job: pipeline.Job) -> None:
    made = pipeline.report_text(job, "7 killed")
    assert made == pipeline.report_text(job, "7 killed")
    errata, body = made.split(r"\clearpage")[:2]
    assert "slch5" in errata
    assert "exsl13" not in errata
    assert "candidates tried" in errata
    assert "left side" in errata
    assert [body.index(f"\\entry{{{name}}}") for name in job.records] == sorted(
        body.index(f"\\entry{{{name}}}") for name in job.records
    )
    assert "7 killed" in made
    assert made.count("{") - made.count(r"\{") == made.count("}") - made.count(r"\}")
    assert not re.search(r"\\today|/tmp|seconds", made)


def test_an_unread_formula_is_shown_as_text(job: pipeline.Job) -> None:
    record = {**job.records["exsl18"], "latex": r"\input{/etc/passwd} = 1"}
    strange = pipeline.Job(records={"exsl18": record}, derived={"exsl18": stages.derive_forms(record)})
    strange.printed = [stages.judge_printed(record)]
    assert strange.printed[0]["verdict"] == "UNREAD"
    strange.printed.append(commands_check.unread("exsl8"))  # what a source does not have
    made = pipeline.report_text(strange)
    assert r"\entry{exsl8}" in made
    assert r"\input{" not in made
    assert r"\textbackslash{}input" in made


@pytest.mark.skipif(not pdf.found(), reason="pdflatex is not installed")
def test_the_document_compiles_without_warnings(job: pipeline.Job, tmp_path: Path) -> None:
    path = tmp_path / "report.tex"
    path.write_text(pipeline.report_text(job), encoding="utf-8")
    assert pdf.compiled(path).read_bytes().startswith(b"%PDF")
    said = pdf.run(path.name, tmp_path)
    assert not re.findall(r"Overfull|undefined|LaTeX Warning: (?!.*Rerun)", said)
    path.write_text(path.read_text().replace(r"\begin{document}", r"\begin{document}\nonsense"))
    with pytest.raises(pdf.TypesettingError, match="nonsense"):
        pdf.compiled(path)


# The command.


@pytest.fixture
def quick(job: pipeline.Job, monkeypatch: pytest.MonkeyPatch) -> None:
    """Three formulas in the place of all, and no modules."""
    monkeypatch.setattr(commands_report, "judged", lambda options: job)
    nothing: dict[str, Any] = {"lines": [], "evaluated": [], "grounds": {}}
    monkeypatch.setattr(commands_report, "gather", lambda options, job: nothing)
    monkeypatch.setattr(pdf, "found", lambda: False)


def test_the_report_is_written_and_compared(
    quick: None, job: pipeline.Job, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    place, data = tmp_path / "report", tmp_path / "found.json"
    assert main(["report", "--out", str(place), "--check"]) == 1
    assert not place.exists()
    assert main(["report", "--out", str(place), "--json", str(data)]) == 0
    assert sorted(path.name for path in place.iterdir()) == ["paper_checks.tex", "report.html"]
    assert "no PDF: pdflatex is not installed" in capsys.readouterr().out
    found: dict[str, Any] = json.loads(data.read_text())
    assert found["formulas"][0]["derived"][0]["forms"][0]["latex"].startswith("f ")
    assert main(["report", "--out", str(place), "--check"]) == 0
    page = (place / "report.html").read_text(encoding="utf-8")
    assert page.count('<article class="item formula"') == len(job.printed)
    (place / "report.html").unlink()  # what is not committed is not compared
    assert main(["report", "--out", str(place), "--check"]) == 0
    file = place / "paper_checks.tex"
    file.write_text(file.read_text().replace("REFUTED", "PROVED"))
    capsys.readouterr()
    assert main(["report", "--out", str(place), "--check"]) == 1
    said = capsys.readouterr()
    assert re.search(r"^-.*PROVED", said.out, re.MULTILINE)
    assert "run 'derive report'" in said.err


def test_the_page_can_be_left_out(quick: None, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delattr(commands_report, "gather")  # nothing is asked of the modules
    assert main(["report", "--out", str(tmp_path), "--no-page"]) == 0
    assert [path.name for path in tmp_path.iterdir()] == ["paper_checks.tex"]


def test_score_and_measurements_get_into_the_report(quick: None, tmp_path: Path) -> None:
    fates = {"killed": 7, "surviving": 0}
    data = {"score": {"counts": fates, "kinds": {"sign": fates}, "survivors": []}, "times": measured()}
    for name, one in data.items():
        (tmp_path / f"{name}.json").write_text(json.dumps(one))
    given = ["--mutants", str(tmp_path / "score.json"), "--measured", str(tmp_path / "times.json")]
    assert main(["report", "--out", str(tmp_path), *given]) == 0
    assert "7 killed, 0 surviving" in (tmp_path / "paper_checks.tex").read_text(encoding="utf-8")
    page = (tmp_path / "report.html").read_text(encoding="utf-8")
    assert '<section id="mutants">' in page
    assert '<section id="measured">' in page


@pytest.mark.parametrize("data", ["[]", "{}", '{"about": {}, "records": {"tasks": [{}]}, "failed": {}}', "{"])
def test_what_is_no_measurement_is_a_mistake(
    quick: None, data: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "times.json").write_text(data)
    assert main(["report", "--out", str(tmp_path / "report"), "--measured", str(tmp_path / "times.json")]) == 2
    assert "no result of 'derive measure --json times.json'" in capsys.readouterr().err
    assert not (tmp_path / "report").exists()


def test_a_module_that_fails_writes_nothing(
    quick: None, job: pipeline.Job, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(job, "modules", [{"name": "some", "failure": "does not read back"}])
    assert main(["report", "--out", str(tmp_path / "report")]) == 1
    assert not (tmp_path / "report").exists()
    assert "does not read back" in capsys.readouterr().err


def test_a_wrong_derived_form_writes_nothing(
    quick: None, job: pipeline.Job, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setitem(job.derived["exsl18"], "failure", "exsl18: the derived form is not proved")
    assert main(["report", "--out", str(tmp_path / "report")]) == 1
    assert not (tmp_path / "report").exists()
    assert "exsl18: the derived form is not proved" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (["--paper", "some.tex"], "say with --out where"),
        (["--pdf"], "--pdf needs pdflatex"),
        (["--mutants", "nowhere.json"], "no result of 'derive check --mutants"),
        (["--measured", "nowhere.json"], "no result of 'derive measure --json nowhere.json'"),
        (["--measured", str(ROOT / "pyproject.toml")], "no result of 'derive measure"),
        (["--out", str(ROOT / "pyproject.toml")], "is no folder"),
    ],
)
def test_mistakes_of_the_report(
    quick: None, arguments: list[str], words: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["report", *arguments]) == 2
    assert words in capsys.readouterr().err


def test_the_report_in_the_folder_has_all_formulas() -> None:
    made = (ROOT / "generated" / commands_report.REPORT).read_text(encoding="utf-8")
    labels = re.findall(r"^\\entry\{([^}]*)\}", made.split(r"\clearpage", 1)[1], re.MULTILINE)
    assert [label for label in labels if not label.startswith("text.")] == list(LEDGER)
