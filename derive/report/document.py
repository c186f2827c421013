"""The report as LaTeX, from plain records of verdicts and derived forms. The same records give the same bytes."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from derive.report import text as tex
from derive.report.contents import Derived, Record, contents, row
from derive.report.render import render
from derive.report.words import Latex


def document(formulas: Sequence[Record], derived: Derived, records: Mapping[str, Record], mutants: str = "") -> str:
    """The whole report.

    formulas: verdicts, as of ``derive check --json``, in the article's order. derived: the derived forms of the
    statements of each. records: of the ledger, or of the source that was judged; claims of the running text have none.
    mutants: a line on wrong variants.
    """
    words = Latex()
    context = {
        **contents(formulas, derived, records, words),
        "mutants": tex.text(mutants),
        "rows": [row(one, words) for one in formulas],
    }
    return render("paper_checks.tex.jinja", context)
