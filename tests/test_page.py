"""The HTML page: what is in it, where its links lead, and that nothing of a paper gets out of its place."""

from __future__ import annotations

import html
import re
from collections import Counter
from html.parser import HTMLParser

import pytest
from jinja2 import UndefinedError
from page_standin import HOSTILE, MODULE, ROOT, bare, findings, measured, whole

from derive import page_job, pipeline
from derive.cache import Cache
from derive.emit.line_formulas import LineFormulas
from derive.paper.ledger import load_ledger
from derive.paper.text_claims import load_claims
from derive.report.page import chart, document, modules
from derive.report.page import measured as tables
from derive.report.page.elements import CORE, element
from derive.report.page.heat import colour
from derive.report.page.words import anchor
from derive.resources import shipped_scenes
from derive.runner import Runner

VOID = {"meta", "input", "link", "img", "br"}
KNOWN = {
    *(
        "html",
        "head",
        "meta",
        "title",
        "style",
        "body",
        "main",
        "header",
        "nav",
        "section",
        "article",
        "div",
        "span",
        "p",
    ),
    *("h1", "h2", "h3", "h4", "h5", "ul", "li", "dl", "dt", "dd", "a", "b", "del", "ins", "pre", "code", "figure"),
    *("p", "table", "thead", "tbody", "tr", "th", "td", "details", "summary", "script"),
    *("form", "label", "input", "select", "option", "output", "svg", "g", "path", "rect", "line", "polyline", "text"),
}


class Page(HTMLParser):
    """Elements with their attributes, those within formulas, the text of printed formulas, and of code."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.elements: list[tuple[str, dict[str, str]]] = []
        self.open: list[str] = []
        self.set: set[str] = set()
        self.unset: list[str] = []
        self.texts: dict[str, list[str]] = {}
        self.code: list[str] = []
        self.article = ""
        self.feed(text)
        self.close()

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        given = {name: value or "" for name, value in attrs}
        self.elements.append((tag, given))
        if tag == "math" or "math" in self.open:
            self.set.add(tag)
        if tag == "article":
            self.article = given.get("id", "")
        if tag not in VOID:
            self.open.append(given.get("class", "") if tag in ("code", "pre") and "class" in given else tag)

    def handle_endtag(self, tag: str) -> None:
        assert self.open, f"</{tag}> closes nothing"
        last = self.open.pop()
        assert last in (tag, "tex", "long", "n", "code"), f"</{tag}> where </{last}> must stand"

    def handle_data(self, data: str) -> None:
        self.texts.setdefault(self.article, []).append(data)
        if self.open and self.open[-1] == "tex":
            self.unset.append(data)
        if self.open and self.open[-1] == "code" and "pre" not in self.open:
            self.code.append(data)


@pytest.fixture(scope="module")
def page() -> Page:
    return Page(whole())


def test_every_id_is_unique_and_every_link_lands(page: Page) -> None:
    ids = Counter(given["id"] for _, given in page.elements if "id" in given)
    assert max(ids.values()) == 1
    links = [given["href"] for tag, given in page.elements if tag == "a"]
    assert len(links) > 1000
    assert not [link for link in links if not link.startswith("#") or link[1:] not in ids]
    assert not page.open


def test_the_page_asks_for_nothing_from_elsewhere(page: Page) -> None:
    for _, given in page.elements:
        assert not {"src", "srcset", "action", "data", "poster", "background"} & given.keys()
        assert not [name for name in given if name.startswith("on")]
        assert given.get("href", "#").startswith("#")
    style = "".join(re.findall(r"<style>(.*?)</style>", whole(), re.DOTALL))
    assert not re.search(r"url\(|@import", style)
    assert not re.search(r"fetch|XMLHttpRequest|import\(|eval\(", whole().rsplit("<script>", 1)[1])


def test_every_label_is_there_with_its_verdict(page: Page) -> None:
    shown = {given["id"]: given for tag, given in page.elements if tag == "article" and "formula" in given["class"]}
    assert set(load_ledger()) <= set(shown)
    for one in findings().formulas:
        at = anchor(one["id"])
        assert shown[at]["data-verdict"] == one["verdict"]
        assert one["method"] in (said := " ".join(page.texts[at]))
        assert one["verdict"] in said


def test_errata_come_first_with_counterexample_and_repair() -> None:
    errata = whole().split('id="errata"')[1].split('id="formulas"')[0]
    for words in ("fails at", "left side", "holds", "2 candidates tried"):
        assert errata.count(words) >= sum(one["verdict"] == "REFUTED" for one in findings().formulas)


def test_formulas_are_core_mathml_only(page: Page) -> None:
    assert page.set <= set(CORE)
    assert page.unset
    assert not [text for text in page.unset if "alert" not in text]  # what is hostile, and nothing else


def test_no_element_is_strange(page: Page) -> None:
    assert {tag for tag, _ in page.elements} <= KNOWN | set(CORE)
    assert sum(tag == "script" for tag, _ in page.elements) == 1
    assert "alert(" in whole()  # shown as text
    assert HOSTILE not in whole()


def within(text: str, name: str, end: str) -> str:
    """What stands from an id to an end."""
    start = text.index(f'id="{name}"')
    return text[start : text.index(end, start)]


def test_every_formula_links_to_its_step_and_every_claim_to_those_below(page: Page) -> None:
    text = whole()
    for one in findings().evaluated:
        part = within(text, anchor("formula", one["case"], one["name"]), "</article>")
        assert f'href="#{anchor("claim", one["claim"])}"' in part
    for one in findings().lines:
        if "id" in one:
            part = within(text, anchor("claim", one["id"]), "</details>")
            assert all(f'href="#{anchor("claim", step)}"' in part for step in one["steps"])


def test_printed_formulas_link_to_claims() -> None:
    grounds = findings().grounds
    assert all(grounds.get(name) for name in load_ledger())
    for name in (*load_ledger(), *load_claims()):
        part = within(whole(), anchor(name), "</article>")
        assert all(f'href="#{anchor("claim", one)}"' in part for one in grounds.get(name, ()))


def test_every_line_of_a_module_stands_beside_its_formulas() -> None:
    text = (ROOT / "generated" / f"{MODULE}.py").read_text(encoding="utf-8")
    lines, at = text.splitlines(), 1
    formulas = {one["name"] for one in findings().evaluated}
    behind = LineFormulas(text, formulas)
    for first, number, named in findings().runs[MODULE]:
        assert first == at
        for line in range(first, first + number):
            assert {name for name, _ in named} == behind.at(line)
        at += number
    assert at == len(lines) + 1
    shown = re.findall(r'<pre class="code">\n(.*?)</pre>', whole(), re.DOTALL)
    assert html.unescape("\n".join(shown)).splitlines() == lines


def test_what_is_left_out_and_folded_is_said() -> None:
    part = whole().split(f'id="{anchor("module", MODULE)}"')[1]
    assert "not wanted: output folds" in part
    assert "length = 80 (the scene)" in part


def test_parts_without_data_are_absent() -> None:
    ids = set(re.findall(r'<section id="(\w+)"', bare()))
    assert not {"mutants", "modules", "measured"} & ids
    assert {"errata", "formulas", "derivation", "evaluated"} <= ids


def test_the_same_findings_give_the_same_page() -> None:
    assert document.page(findings()) == whole()
    assert not re.search(r"/tmp|/home", whole())


def test_a_missing_value_is_an_error() -> None:
    with pytest.raises(UndefinedError):
        document.render("mutants.html.jinja", {})


def test_runs_name_the_formulas_of_the_load_case() -> None:
    text = (
        '"""A rod.\n\nLoad case: parallel.\n"""\n\n\ndef near(x):\n    return x\n\n\ndef far(x):\n    return near(x)\n'
    )
    named = [modules.Named("near", "parallel"), modules.Named("near", "oblique"), modules.Named("other", "parallel")]
    found = modules.runs(text, named)
    assert [(one.first, one.formulas) for one in found] == [(1, ()), (7, (named[0],)), (9, ()), (11, (named[0],))]
    assert "\n".join(one.text for one in found) + "\n" == text


def test_measurements_are_tables_and_pictures() -> None:
    shown = tables.measured(measured())
    assert shown is not None
    titles = [one["title"] for one in shown["tables"]]
    maps = f"Extremes: {HOSTILE}"
    assert titles == [f"T1: {HOSTILE}", "How time and memory grow", maps, "Stability of the formulas", "Extremes"]
    first, grown, atlas, searches, last = shown["tables"]
    assert grown["rows"] == [
        ["a shape", "points", "100 … 200", "2 ms … 8 ms", "points^2.00", "1 MB … 2 MB", "points^1.00"]
    ]
    assert atlas["rows"][0] == ["loads", "ours", "1", "0.5", "0.5", "2", "none"]
    assert atlas["picture"].count("<rect") == 2
    assert atlas["picture"].count('class="cross"') == 1  # the one that failed
    assert searches["rows"][0][:5] == [HOSTILE, "5", "2", "3", "0.5"]
    assert [row[2:5] for row in first["rows"]] == [
        ["1e-15", "3 of 3", "2 ms"], ["3e-07", "3 of 3, 1 more", "2 ms"], ["–", "–", "2 ms"],
    ]  # fmt: skip
    assert first["picture"].count("<title>") == 4  # two points, and two names below
    assert last == {"title": "Extremes", "picture": "", "columns": ["rod", "errors y"], "rows": [[HOSTILE, "1e-09"]]}
    assert "A quick run" in whole()


def test_colours_of_a_map_end_where_no_digit_is_right() -> None:
    assert [colour(bounds) for bounds in (1e-9, 0.1, 1e16, 1e300)] == ["#00224e", "#00224e", "#fee838", "#fee838"]
    assert colour(10**7.5) == "#7c7b78"
    assert colour(None) == "#ffffff"


def test_axes_span_whole_decades() -> None:
    at = chart.axis([2e-5, 3e-2], 0.0, 400.0)
    assert [at(10.0**power) for power in range(-5, 0)] == [0.0, 100.0, 200.0, 300.0, 400.0]
    assert chart.axis([1.0], 0.0, 10.0)(10.0) == 10.0
    assert chart.chart([], "x", "y") == ""


def test_elements_have_their_parts() -> None:
    assert element("msup", element("mi", "<x>"), element("mn", "2")) == "<msup><mi>&lt;x&gt;</mi><mn>2</mn></msup>"
    with pytest.raises(ValueError, match="<mfrac> has 2 parts, not 1"):
        element("mfrac", "x")
    with pytest.raises(KeyError):
        element("script", "x")


@pytest.mark.long
def test_all_that_the_page_shows_is_gathered_by_the_job() -> None:
    job, runner = pipeline.Job(), Runner(Cache(), 1)
    gathered = page_job.gather(runner, job, [shipped_scenes()["remote_control"]])
    job.claims = list(findings().claims)
    made = page_job.page_text(job, gathered)
    for name in ("remote_control_numpy", "remote_control_mpmath"):
        part = made.split(f'id="{anchor("module", name)}"')[1]
        assert "decided by" in part
        text = (ROOT / "generated" / f"{name}.py").read_text(encoding="utf-8")
        assert part.count("\n") > len(text.splitlines())
