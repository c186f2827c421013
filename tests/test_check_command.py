"""`derive check`: what it says of a source, when it fails, and that it ends on anything."""

from __future__ import annotations

import json
import os
import time
from pathlib import Path

import pytest

from derive.cli import main
from derive.paper.ledger import Record, load_ledger
from derive.paper.text_claims import load_claims

LEDGER = load_ledger()
CLAIMS = load_claims()
OTHER = r"\begin{equation} \label{einstein} E = m c^2 \end{equation}"


def shown(record: Record, latex: str = "") -> str:
    return f"\\begin{{equation}} \\label{{{record.id}}}\n{latex or record.latex}\n\\end{{equation}}\n"


def inline(label: str) -> str:
    """What the claims of the running text print behind a label."""
    fragments = [fragment for claim in CLAIMS.values() if claim.after == label for fragment in claim.fragments]
    return "".join(f"${fragment}$\n" for fragment in fragments)


def source(tmp_path: Path, **changed: str | None) -> Path:
    """The ledger as a LaTeX text, with other text (None: nothing) for some labels, and one display more."""
    kept = [record for record in LEDGER.values() if changed.get(record.id, "") is not None]
    path = tmp_path / "paper.tex"
    text = "".join(shown(one, changed.get(one.id) or "") + inline(one.id) for one in kept)
    elsewhere = dict.fromkeys(claim.after for claim in CLAIMS.values() if claim.after not in LEDGER)
    figures = "".join(f"\\label{{{label}}}\n{inline(label)}" for label in elsewhere)
    path.write_text(f"Text.\n{text}{OTHER}\n{figures}")
    return path


def found(tmp_path: Path, *arguments: str) -> tuple[int, dict]:
    file = tmp_path / "found.json"
    code = main(["check", *arguments, "--jobs", "1", "--json", str(file)])
    return code, json.loads(file.read_text())


def article() -> Path | None:
    named = os.environ.get("DERIVE_PAPER")
    beside = Path(__file__).resolve().parents[2] / "shared" / "paper"
    return Path(named) if named else next(iter(sorted(beside.glob("*.txt"))), None)


def test_one_formula_with_and_without_a_source(tmp_path, capsys):
    code, ledger = found(tmp_path, "--only", "exsl21")
    assert (code, ledger["source"], ledger["counts"]) == (0, "ledger", {"PROVED": 1})
    code, said = found(tmp_path, "--only", "exsl21", "--paper", str(source(tmp_path)))
    assert (code, said["counts"], said["differences"], said["not_judged"]) == (0, {"PROVED": 1}, [], [])
    assert said["formulas"][0]["line"] > 1
    assert "not judged" not in capsys.readouterr().out


def test_a_changed_formula_is_refuted_as_the_source_prints_it(tmp_path, capsys):
    changed = LEDGER["exsl21"].latex.replace("g_3 = -", "g_3 =")
    path = source(tmp_path, exsl21=changed)
    code, said = found(tmp_path, "--only", "exsl21", "--paper", str(path))
    assert code == 0  # a finding about the source, not a failure
    (formula,) = said["formulas"]
    assert formula["verdict"] == "REFUTED"
    assert changed[:20] in formula["printed"]
    assert formula["counterexample"]
    assert "g_{3} = -" in formula["repair"]["latex"]
    assert formula["repair"]["verdict"] == "PROVED"
    assert [(one["id"], one["kind"]) for one in said["differences"]] == [("exsl21", "differs")]
    out = capsys.readouterr().out
    for words in (f"line {formula['line']}", "printed: g_3 =", "counterexample:", "repair (PROVED; sign;", "differs"):
        assert words in out


@pytest.mark.parametrize(
    ("name", "words"),
    [
        ("exsl12x", "did you mean 'exsl12'"),
        ("exls21", "'exsl21'"),
        ("einstein", "not judged yet"),
        ("slch3", "not in this source"),
    ],
)
def test_a_label_that_cannot_be_judged(tmp_path, capsys, name, words):
    path = source(tmp_path, slch3=None)
    assert main(["check", "--only", name, "--paper", str(path)]) == 2
    assert words in capsys.readouterr().err


DEEP = "{" * 10_000 + "}" * 10_000


@pytest.mark.parametrize(
    ("content", "words"),
    [
        (b"", "no 'equation' environment"),
        (b"\x00\x01\x02", "control character"),
        (b"\xff\xfe\x00\x00", "no UTF-8 text"),
        (OTHER.encode(), "none of its 1 displayed equations"),
        (DEEP.encode(), "no 'equation' environment"),
        (b"\\begin{equation} E = mc^2 \\end{equation}", "needs one \\label"),
        (OTHER.replace("E =", DEEP).encode(), "none of its 1 displayed equations"),
    ],
)
def test_what_is_no_source_of_the_article(tmp_path, capsys, content, words):
    path, start = tmp_path / "paper.tex", time.monotonic()
    path.write_bytes(content)
    assert main(["check", "--paper", str(path)]) == 2
    err = capsys.readouterr().err
    assert words in err
    assert err.startswith("derive check: ")
    assert time.monotonic() - start < 20


def test_a_formula_nested_too_deeply_is_unread(tmp_path, capsys):
    path = source(tmp_path, exsl21=DEEP)
    code, said = found(tmp_path, "--only", "exsl21", "--paper", str(path))
    assert (code, said["counts"]) == (1, {"UNREAD": 1})
    assert "the limit is" in capsys.readouterr().err


def test_help_says_the_exit_codes(capsys):
    with pytest.raises(SystemExit):
        main(["check", "--help"])
    out = capsys.readouterr().out
    assert "Exit code 0:" in out
    assert "--mutants" in out


def test_mutants_of_one_formula(tmp_path, capsys):
    code, said = found(tmp_path, "--mutants", "--only", "slch10")
    assert code == 0
    assert said["survivors"] == []
    assert said["counts"]["killed"] > 10
    assert said["ids"]["slch10"] == said["counts"]
    assert "kind of mutation" in capsys.readouterr().out


ERRATA = [
    "kth20b", "kth23", "elmr7", "elmr9", "exsl14", "exsl35", "slch5", "slch12", "exhpf19",
    "text.eta_tilde.dimension", "text.half_periods",
]  # fmt: skip


@pytest.mark.long
def test_the_article(tmp_path, capsys):
    path = article()
    if path is None:
        pytest.skip("the article's source is not here; set DERIVE_PAPER")
    code, said = found(tmp_path, "--paper", str(path))
    assert code == 0
    assert len(said["formulas"]) == len(LEDGER) + len(CLAIMS)
    assert len(LEDGER) == 130
    assert said["not_judged"] == said["differences"] == []
    refuted = [one for one in said["formulas"] if one["verdict"] == "REFUTED"]
    assert [one["id"] for one in refuted] == ERRATA
    assert all(one["repair"] for one in refuted)
    assert {one["verdict"] for one in said["formulas"]} == {"PROVED", "CERTIFIED", "DEFINITION", "REFUTED"}
    assert "11 REFUTED" in capsys.readouterr().out


@pytest.mark.long
def test_a_source_without_one_formula(tmp_path):
    code, said = found(tmp_path, "--paper", str(source(tmp_path, slch3=None)))
    assert code == 1
    unread = [one["id"] for one in said["formulas"] if one["verdict"] == "UNREAD"]
    assert unread[0] == "slch3"
    assert all(CLAIMS[name].after == "slch3" for name in unread[1:])  # without the display their place is not there
    assert said["not_judged"] == ["einstein"]
