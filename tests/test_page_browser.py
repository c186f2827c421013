"""The page in headless Chromium: formulas have a size, the filter and links work, nothing is wider than a phone."""

from __future__ import annotations

import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from chromium import Chromium, found
from page_standin import bare, findings, whole

from derive.report.page.words import anchor

pytestmark = pytest.mark.skipif(not found(), reason="Chromium is not installed (Debian: apt-get install chromium)")
WIDE, NARROW = (1280, 900), (390, 800)
FOLDED = "details:not([open])"
# What is seen and reaches beyond the window, but for what scrolls inside itself.
TOO_WIDE = f"""
[...document.querySelectorAll("main h1, main h2, main h3, main h4, main p, main li, main dd, main .item, main .scroll")]
  .filter((one) => !one.closest("{FOLDED}") && one.getBoundingClientRect().right > innerWidth + 1)
  .map((one) => one.tagName + " " + one.textContent.trim().slice(0, 60))
"""


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    place = tmp_path_factory.mktemp("page")
    (place / "whole.html").write_text(whole(), encoding="utf-8")
    (place / "bare.html").write_text(bare(), encoding="utf-8")
    return place


@pytest.fixture(scope="module")
def browser(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Chromium]:
    with Chromium(tmp_path_factory.mktemp("profile")) as one:
        yield one


@pytest.fixture
def page(folder: Path, browser: Chromium) -> Iterator[Chromium]:
    browser.open("about:blank", *WIDE)
    browser.complaints.clear()
    browser.requests.clear()
    browser.open((folder / "whole.html").as_uri(), *WIDE)
    yield browser
    assert browser.complaints == []
    assert {one.split(":")[0] for one in browser.requests} <= {"file", "about"}


def choose(page: Chromium, text: str = "", verdict: str = "", part: str = "") -> tuple[int, int]:
    """Filter; how many items are not hidden, and how many do not match although they are not."""
    given: dict[str, str] = {"text": text, "verdict": verdict, "part": part}
    lines = [f'document.getElementById("filter-{name}").value = {value!r};' for name, value in given.items()]
    page.script("".join(lines) + 'document.getElementById("filter").dispatchEvent(new Event("input"))')
    shown = 'document.querySelectorAll(".item:not([hidden])")'
    wrong = f"[...{shown}].filter((one) => {verdict!r} && one.dataset.verdict !== {verdict!r}).length"
    return int(page.script(f"{shown}.length")), int(page.script(wrong))


def test_formulas_are_laid_out(page: Chromium) -> None:
    sizes: list[list[float]] = page.script(
        '[...document.querySelectorAll("details:not(.module)")].forEach((one) => { one.open = true; });'
        '[...document.querySelectorAll("math")].map((one) => one.getBoundingClientRect())'
        ".map((one) => [one.width, one.height])"
    )
    assert len(sizes) == whole().count("<math")
    assert all(width > 3 and height > 3 for width, height in sizes)
    # A fraction has its parts one above the other, so the browser does set MathML.
    tall = 'const box = document.querySelector("mfrac").getBoundingClientRect(); box.height > 20 && box.height < 80'
    assert page.script(tall) is True


def test_the_filter_shows_what_is_asked_for(page: Chromium) -> None:
    everything, _ = choose(page)
    some, wrong = choose(page, verdict="CERTIFIED")
    assert 0 < some < everything
    assert wrong == 0
    assert page.script('document.getElementById("filter-count").textContent') == f"{some} of {everything}"
    refuted = sum(one["verdict"] == "REFUTED" for one in findings().formulas)
    assert choose(page, verdict="REFUTED") == (2 * refuted, 0)  # among the errata, and in its place
    assert choose(page, text="exsl21")[0] >= 1
    assert page.script('document.getElementById("exsl21").hidden') is False
    assert choose(page, text="no such words")[0] == 0
    claims = sum(one.get("id", "").startswith("plane.") for one in findings().lines)
    assert choose(page, part="chapter.plane") == (claims, 0)
    assert page.script('document.getElementById("chapter.plane").open') is True
    assert choose(page)[0] == everything


def follow(page: Chromium, link: str) -> Any:
    """Click the first link that is given by a selector; the id where it leads, once that is seen."""
    page.script(f"document.querySelector({link!r}).click()")
    seen = f"""(() => {{
        const at = document.getElementById(decodeURIComponent(location.hash.slice(1)));
        if (!at || at.offsetHeight === 0 || at.parentElement.closest("{FOLDED}")) return null;
        const box = at.getBoundingClientRect();
        return box.top < innerHeight && box.bottom > 0 ? at.id : null;
    }})()"""
    to = str(page.script(f"document.querySelector({link!r}).hash.slice(1)"))
    until = time.monotonic() + 20
    while page.script(seen) != to and time.monotonic() < until:
        time.sleep(0.05)
    return page.script(seen)


def test_links_lead_from_a_line_to_its_formula_to_its_step_to_what_is_printed(page: Chromium) -> None:
    formula = follow(page, ".run .by > a")
    assert str(formula).startswith("formula.")
    step = follow(page, f'[id="{formula}"] .steps a')
    assert str(step).startswith("claim.")
    assert page.script(f'document.getElementById("{step}").open') is True
    choose(page, verdict="UNREAD")  # what a link leads to is shown, whatever is filtered
    assert follow(page, f'[id="{anchor("exsl13")}"] .steps a')
    assert page.script('document.getElementById("filter-verdict").value') == ""


def test_nothing_hostile_has_run(page: Chromium) -> None:
    assert page.script("document.scripts.length") == 1
    assert page.script("document.images.length") == 0


def test_a_phone_shows_it_all(page: Chromium, folder: Path) -> None:
    page.open((folder / "whole.html").as_uri() + "#exsl21", *NARROW)
    assert page.script("[document.documentElement.scrollWidth, innerWidth]") == [390, 390]
    assert page.script(TOO_WIDE) == []


def test_without_its_script_the_page_shows_everything(browser: Chromium, folder: Path) -> None:
    browser.open("about:blank", *WIDE)
    browser.ask("Emulation.setScriptExecutionDisabled", value=True)
    try:
        browser.open((folder / "bare.html").as_uri(), *WIDE)
    finally:
        browser.ask("Emulation.setScriptExecutionDisabled", value=False)
    assert browser.script('document.querySelectorAll(".item").length') == bare().count('class="item ')
    assert browser.script('document.querySelectorAll("[hidden]:not(#filter)").length') == 0
    assert browser.script('getComputedStyle(document.getElementById("filter")).display') == "none"
